// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MAPT_CONSOLE_H
#define MAPT_CONSOLE_H

#include <nlohmann/json.hpp>

#include <iosfwd>
#include <string>

namespace mapt {

/// what the user gets to read: a table on stdout, or one JSON object in its place; warnings and
/// errors on stderr. Names may hold control characters: what is no JSON shows '?' for them.
class Console
{
public:
  Console();

  bool is_json = false;
  bool is_quiet = false;   // errors only
  bool is_verbose = false; // notes, too

  /// what finish() answers: not DONE if a part of the work could not be done.
  int exit_code = 0;

  /// what --json prints, filled by the commands.
  nlohmann::ordered_json report;

  /// leaves stdout to the results: the table goes to stderr, with --verbose only.
  void give_stdout_away();

  /// a line of the table.
  void row(const std::string& name, const std::string& text);
  /// a line that spans the table.
  void line(const std::string& text);
  /// "mapt: warning: text".
  void warn(const std::string& text);
  /// "mapt: error: text", of an error that does not end the work.
  void complain(const std::string& text) const;
  /// a line for the curious, on stderr.
  void note(const std::string& text) const;

  /// prints what is left to print, and returns the exit code.
  int finish();
  /// the exit code, or OUTPUT_NOT_WRITTEN if something could not be printed.
  int flush() const;
  /// says why there is no result, and returns the exit code.
  int fail(int code, const std::string& text);

private:
  int print_report();

  std::ostream* m_table;
};

} // namespace mapt

#endif // MAPT_CONSOLE_H
