// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MAPT_DESCRIBE_JOURNAL_H
#define MAPT_DESCRIBE_JOURNAL_H

#include "description.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <unordered_map>

namespace mapt {

/// by which a file is known again: one that was changed is described anew.
struct File_state
{
  std::uintmax_t size = 0; // in bytes; 0: there is no file
  std::int64_t time = 0;   // of its last change, in the ticks of the file system

  friend bool operator==(const File_state& a, const File_state& b)
  {
    return a.size == b.size && a.time == b.time;
  }
};

File_state state_of(const std::string& file);

/// the descriptions that are finished, in a file beside the output until all are: what was added is there even if
/// the program is killed, so that another run goes on from there.
///
/// Text. The first line tells the version and the choices; then each line has a check sum, the file and its state, and
/// the description. A line that was cut off is left out. Failures are not kept: such files are tried again.
class Describe_journal
{
public:
  struct Entry
  {
    File_state state;
    Description description;
  };
  using Entries = std::unordered_map<std::string, Entry>;

  /// opens a journal, or begins one.
  /// \param choices what the numbers depend on
  /// \throw Usage_error if it was begun with others, or is in use
  /// \throw Output_error if it cannot be written
  Describe_journal(const std::string& name, const Describe_options& options);
  ~Describe_journal();
  Describe_journal(const Describe_journal&) = delete;
  Describe_journal& operator=(const Describe_journal&) = delete;

  const std::string& name() const { return m_name; }

  /// gives away what other runs have finished.
  Entries take_entries() { return std::move(m_entries); }

  /// \throw Output_error if it cannot be written
  void add(const std::string& file, const Entry& entry);

  /// removes the file: all is done.
  void remove();

private:
  void lock();
  void read(const std::string& header, std::size_t dimension);
  void read_line(std::string_view line, std::size_t dimension);
  void append(const std::string& text);

  std::string m_name;
  int m_file;
  Entries m_entries;
};

} // namespace mapt

#endif // MAPT_DESCRIBE_JOURNAL_H
