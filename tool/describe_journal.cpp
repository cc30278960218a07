// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "describe_journal.h"

#include "errors.h"

#include <CGAL/Area_projection_transform/IO/Output_error.h>
#include <CGAL/Area_projection_transform/IO/number_text.h>
#include <CGAL/Area_projection_transform/internal/whole_file.h>

#include <cerrno>
#include <cstring>
#include <filesystem>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>
#include <zlib.h>

namespace mapt {

namespace {

constexpr std::string_view title = "mapt describe journal 1 ";

std::string header_of(const Describe_options& options)
{
  return std::string(title) + MAPT_VERSION " " + choices_of(options).dump();
}

std::string check_sum(std::string_view text)
{
  const auto sum = crc32(0, reinterpret_cast<const Bytef*>(text.data()), uInt(text.size()));
  char digits[9];
  std::snprintf(digits, sizeof digits, "%08lx", static_cast<unsigned long>(sum));
  return digits;
}

} // namespace

File_state state_of(const std::string& file)
{
  namespace fs = std::filesystem;
  std::error_code error;
  const std::uintmax_t size = fs::file_size(file, error);
  const fs::file_time_type time = fs::last_write_time(file, error);
  return error ? File_state() : File_state{size, std::int64_t(time.time_since_epoch().count())};
}

Describe_journal::Describe_journal(const std::string& name, const Describe_options& options)
    : m_name(name), m_file(open(name.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC, 0666))
{
  if(m_file < 0)
    throw AP::IO::Output_error(m_name + ": cannot be created: " + std::strerror(errno));
  try {
    lock();
    read(header_of(options), options.dimension());
  } catch(...) {
    close(m_file);
    throw;
  }
}

Describe_journal::~Describe_journal()
{
  close(m_file);
}

void Describe_journal::lock()
{
  // Some network file systems have no locks: those do without.
  if(flock(m_file, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK)
    throw Usage_error(m_name + ": another mapt describe is writing it: wait for its end, or choose "
                               "another --output");
}

void Describe_journal::read(const std::string& header, std::size_t dimension)
{
  const std::string text = AP::IO::internal::read_whole_file(m_name);
  std::string_view rest = text;
  const auto next_line = [&rest] {
    const std::size_t end = rest.find('\n');
    const std::string_view line = rest.substr(0, end);
    rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 1);
    return line;
  };
  const std::string_view first = next_line();
  if(first.size() == text.size() && first == std::string_view(header).substr(0, first.size())) {
    // empty, or killed within the first line
    if(ftruncate(m_file, 0) != 0)
      throw AP::IO::Output_error(m_name + ": cannot be written: " + std::strerror(errno));
    append(header + '\n');
    return;
  }
  if(first != header)
    throw Usage_error(
        m_name + (first.substr(0, title.size()) == title
                      ? ": was begun with other options or by another version: give those again, "
                        "or remove it to begin anew"
                      : ": is not the journal of mapt describe: choose another --output"));
  while(!rest.empty())
    read_line(next_line(), dimension);
  if(text.back() != '\n')
    append("\n"); // so that the line which was cut off stays alone
}

void Describe_journal::read_line(std::string_view line, std::size_t dimension)
{
  using AP::IO::internal::next_word;
  const std::string_view sum = next_word(line);
  if(line.empty() || check_sum(line) != sum)
    return;
  const std::string file = text_from(next_word(line));
  Entry entry;
  if(!AP::IO::from_text(next_word(line), entry.state.size) ||
     !AP::IO::from_text(next_word(line), entry.state.time))
    return;
  std::optional<Description> description = description_from(line);
  if(!description || description->values.size() != dimension)
    return;
  entry.description = std::move(*description);
  m_entries[file] = std::move(entry);
}

void Describe_journal::add(const std::string& file, const Entry& entry)
{
  const std::string text = ' ' + to_word(file) + ' ' + AP::IO::to_text(entry.state.size) + ' ' +
                           AP::IO::to_text(entry.state.time) + ' ' + to_line(entry.description);
  append(check_sum(text) + text + '\n');
}

void Describe_journal::append(const std::string& text)
{
  for(std::size_t written = 0; written < text.size();) {
    const ssize_t number = write(m_file, text.data() + written, text.size() - written);
    if(number < 0 && errno == EINTR)
      continue;
    if(number <= 0)
      throw AP::IO::Output_error(m_name + ": cannot be written: " + std::strerror(errno));
    written += std::size_t(number);
  }
}

void Describe_journal::remove()
{
  std::error_code ignored; // it would be used again, which does no harm
  std::filesystem::remove(m_name, ignored);
}

} // namespace mapt
