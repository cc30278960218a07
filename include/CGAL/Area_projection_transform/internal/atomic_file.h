// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_ATOMIC_FILE_H
#define CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_ATOMIC_FILE_H

#include <CGAL/Area_projection_transform/IO/Output_error.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <ostream>
#include <random>
#include <string>
#include <system_error>

/// \cond SKIP_IN_MANUAL
namespace CGAL {
namespace Area_projection {
namespace IO {
namespace internal {

/// a file buffer that remembers the cause of the first write that failed, which the stream forgets.
class Recording_filebuf : public std::filebuf
{
public:
  int error() const { return m_error; }

  /// runs a file operation and records the cause if it did not succeed.
  template <class Operation>
  bool attempt(Operation operation)
  {
    errno = 0;
    const bool done = operation();
    if(!done && m_error == 0)
      m_error = errno;
    return done;
  }

protected:
  int_type overflow(int_type c) override
  {
    int_type result = traits_type::eof();
    attempt([&] { return (result = std::filebuf::overflow(c)) != traits_type::eof(); });
    return result;
  }

  std::streamsize xsputn(const char* bytes, std::streamsize number) override
  {
    std::streamsize written = 0;
    attempt([&] { return (written = std::filebuf::xsputn(bytes, number)) == number; });
    return written;
  }

  int sync() override
  {
    return attempt([&] { return std::filebuf::sync() == 0; }) ? 0 : -1;
  }

  pos_type seekpos(pos_type position, std::ios_base::openmode mode) override
  {
    pos_type result(off_type(-1));
    attempt([&] {
      result = std::filebuf::seekpos(position, mode);
      return result != pos_type(off_type(-1));
    });
    return result;
  }

private:
  int m_error = 0;
};

/// \brief an output file that appears whole or not at all.
///
/// The bytes go to a temporary file in the same folder; `commit()` moves it to its name. Without a
/// commit the destructor removes it. What is not a regular file (a pipe, a device) has no whole to
/// wait for and is written directly.
class Atomic_file
{
public:
  /// \throw Output_error if the file cannot be created.
  explicit Atomic_file(const std::string& name) : m_name(name), m_stream(&m_buffer)
  {
    namespace fs = std::filesystem;
    std::error_code error;
    const fs::file_status status = fs::status(name, error);
    if(fs::is_directory(status))
      fail("created", EISDIR);
    m_is_direct = fs::exists(status) && !fs::is_regular_file(status);
    // a link keeps pointing at the file: it is the file that is replaced
    const fs::path linked = fs::is_symlink(fs::symlink_status(name, error))
                                ? fs::weakly_canonical(name, error)
                                : fs::path(name);
    m_target = error ? fs::path(name) : linked;
    m_written = m_is_direct ? m_target : create_temporary();
    const auto mode = std::ios_base::out | std::ios_base::binary;
    if(!m_buffer.attempt([&] { return m_buffer.open(m_written, mode) != nullptr; })) {
      remove_temporary();
      fail("created", m_buffer.error());
    }
    // Who may read a file that is replaced may read the new one, and nobody else.
    if(!m_is_direct && fs::is_regular_file(status))
      fs::permissions(m_written, status.permissions(), error);
  }

  Atomic_file(const Atomic_file&) = delete;
  Atomic_file& operator=(const Atomic_file&) = delete;

  ~Atomic_file()
  {
    if(m_is_committed)
      return;
    m_buffer.close();
    remove_temporary();
  }

  std::ostream& stream() { return m_stream; }

  /// whether the file can be changed behind the place of writing.
  bool is_seekable() const { return !m_is_direct; }

  /// \brief completes the file and gives it its name.
  /// \throw Output_error if anything written so far failed.
  void commit()
  {
    m_stream.flush();
    const bool is_good = m_stream.good();
    const bool is_closed = m_buffer.attempt([&] { return m_buffer.close() != nullptr; });
    if(!is_good || !is_closed)
      fail("written", m_buffer.error());
    if(!m_is_direct) {
      std::error_code error;
      std::filesystem::rename(m_written, m_target, error);
      if(error)
        fail("written", error.value());
    }
    m_is_committed = true;
  }

private:
  std::filesystem::path create_temporary() const
  {
    std::random_device random;
    for(int attempts = 0; attempts < 100; ++attempts) {
      const std::string name = ".area_projection-" + std::to_string(random()) + ".tmp";
      const std::filesystem::path path = m_target.parent_path() / name;
      if(std::FILE* const file = std::fopen(path.string().c_str(), "wxb")) {
        std::fclose(file);
        return path;
      }
      if(errno != EEXIST)
        break;
    }
    fail("created", errno);
  }

  void remove_temporary() const
  {
    std::error_code ignored;
    if(!m_is_direct)
      std::filesystem::remove(m_written, ignored);
  }

  [[noreturn]] void fail(const char* done, int error) const
  {
    throw Output_error(m_name + ": cannot be " + done + ": " +
                       (error != 0 ? std::strerror(error) : "unknown cause"));
  }

  std::string m_name;
  std::filesystem::path m_target;
  std::filesystem::path m_written;
  bool m_is_direct = false;
  bool m_is_committed = false;
  Recording_filebuf m_buffer;
  std::ostream m_stream;
};

} // namespace internal
} // namespace IO
} // namespace Area_projection
} // namespace CGAL
/// \endcond

#endif // CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_ATOMIC_FILE_H
