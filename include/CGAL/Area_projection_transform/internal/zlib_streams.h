// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_ZLIB_STREAMS_H
#define CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_ZLIB_STREAMS_H

#include <zlib.h>

#include <algorithm>
#include <cstddef>
#include <new>
#include <ostream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

/// \cond SKIP_IN_MANUAL
namespace CGAL {
namespace Area_projection {
namespace IO {
namespace internal {

/// the largest piece that is handed to zlib at once, whose counters may have 32 bits only.
constexpr std::size_t zlib_step = std::size_t(1) << 20;

/// what zlib writes around the compressed bytes.
enum class Zlib_wrapper { ZLIB = 0, GZIP = 16 };

inline int zlib_window(Zlib_wrapper wrapper)
{
  return MAX_WBITS + int(wrapper);
}

inline Bytef* zlib_bytes(const char* bytes)
{
  return reinterpret_cast<Bytef*>(const_cast<char*>(bytes));
}

/// compresses bytes as they come and passes them on to `write(bytes, number)`.
class Deflater
{
public:
  /// \throw std::invalid_argument if `level` is not from 0 to 9.
  Deflater(int level, Zlib_wrapper wrapper) : m_output(zlib_step)
  {
    if(level < 0 || level > 9)
      throw std::invalid_argument("level is " + std::to_string(level) + ": must be from 0 to 9");
    if(deflateInit2(&m_stream, level, Z_DEFLATED, zlib_window(wrapper), 9, Z_DEFAULT_STRATEGY) !=
       Z_OK)
      throw std::bad_alloc();
  }
  Deflater(const Deflater&) = delete;
  Deflater& operator=(const Deflater&) = delete;
  ~Deflater() { deflateEnd(&m_stream); }

  template <class Write>
  void append(const char* bytes, std::size_t number, Write&& write)
  {
    for(std::size_t done = 0; done < number;) {
      const std::size_t step = std::min(zlib_step, number - done);
      run(bytes + done, step, Z_NO_FLUSH, write);
      done += step;
    }
  }

  /// ends the compressed bytes; the next `append()` begins anew.
  template <class Write>
  void finish(Write&& write)
  {
    run(nullptr, 0, Z_FINISH, write);
    deflateReset(&m_stream);
  }

private:
  template <class Write>
  void run(const char* bytes, std::size_t number, int flush, Write&& write)
  {
    m_stream.next_in = zlib_bytes(bytes);
    m_stream.avail_in = static_cast<uInt>(number);
    do {
      m_stream.next_out = zlib_bytes(m_output.data());
      m_stream.avail_out = static_cast<uInt>(m_output.size());
      deflate(&m_stream, flush);
      write(m_output.data(), m_output.size() - m_stream.avail_out);
    } while(m_stream.avail_out == 0);
  }

  z_stream m_stream{};
  std::vector<char> m_output;
};

/// \brief decompresses `input` into `expected` bytes.
///
/// The output grows by what has really been decompressed: `grow(n)` returns room for `n` more
/// bytes. A claim of an enormous size costs nothing.
/// \throw std::runtime_error if `input` is damaged or holds another number of bytes.
class Inflater
{
public:
  explicit Inflater(Zlib_wrapper wrapper)
  {
    if(inflateInit2(&m_stream, zlib_window(wrapper)) != Z_OK)
      throw std::bad_alloc();
  }
  Inflater(const Inflater&) = delete;
  Inflater& operator=(const Inflater&) = delete;
  ~Inflater() { inflateEnd(&m_stream); }

  template <class Grow>
  void run(std::string_view input, std::size_t expected, Grow&& grow)
  {
    inflateReset(&m_stream);
    m_stream.avail_in = 0;
    std::size_t produced = 0;
    while(produced < expected) {
      const std::size_t step = std::min(zlib_step, expected - produced);
      if(fill(input, grow(step), step) != step)
        throw std::runtime_error("the compressed data hold fewer bytes than announced");
      produced += step;
    }
    char excess;
    if(fill(input, &excess, 1) != 0)
      throw std::runtime_error("the compressed data hold more bytes than announced");
  }

private:
  /// decompresses up to `number` bytes; fewer only at the end of the compressed data.
  std::size_t fill(std::string_view& input, char* output, std::size_t number)
  {
    m_stream.next_out = zlib_bytes(output);
    m_stream.avail_out = static_cast<uInt>(number);
    while(m_stream.avail_out > 0) {
      if(m_stream.avail_in == 0) {
        const std::size_t step = std::min(zlib_step, input.size());
        m_stream.next_in = zlib_bytes(input.data());
        m_stream.avail_in = static_cast<uInt>(step);
        input.remove_prefix(step);
      }
      const int result = inflate(&m_stream, Z_NO_FLUSH);
      if(result == Z_STREAM_END)
        break;
      if(result == Z_MEM_ERROR)
        throw std::bad_alloc();
      if(result == Z_BUF_ERROR)
        throw std::runtime_error("the compressed data end early");
      if(result != Z_OK)
        throw std::runtime_error(std::string("the compressed data are damaged: ") +
                                 (m_stream.msg ? m_stream.msg : "unknown defect"));
    }
    return number - m_stream.avail_out;
  }

  z_stream m_stream{};
};

/// appends bytes to a vector of numbers.
template <class Scalar>
class Byte_appender
{
public:
  explicit Byte_appender(std::vector<Scalar>& values) : m_values(values) {}

  char* operator()(std::size_t number)
  {
    m_bytes += number;
    m_values.resize((m_bytes + sizeof(Scalar) - 1) / sizeof(Scalar));
    return reinterpret_cast<char*>(m_values.data()) + (m_bytes - number);
  }

  std::size_t number_of_bytes() const { return m_bytes; }

private:
  std::vector<Scalar>& m_values;
  std::size_t m_bytes = 0;
};

} // namespace internal
} // namespace IO
} // namespace Area_projection
} // namespace CGAL
/// \endcond

#endif // CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_ZLIB_STREAMS_H
