// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "console.h"

#include "errors.h"
#include "text.h"

#include <iostream>

namespace mapt {

Console::Console() : m_table(&std::cout) {}

void Console::give_stdout_away()
{
  m_table = is_verbose ? &std::cerr : nullptr;
}

void Console::row(const std::string& name, const std::string& text)
{
  constexpr std::size_t width = 10;
  line(name + std::string(name.size() < width ? width - name.size() : 1, ' ') + text);
}

void Console::line(const std::string& text)
{
  if(m_table && !is_json && !is_quiet)
    *m_table << printable(text) << '\n';
}

void Console::warn(const std::string& text)
{
  report["warnings"].push_back(text);
  if(!is_quiet)
    std::cerr << "mapt: warning: " << printable(text) << '\n';
}

void Console::complain(const std::string& text) const
{
  std::cerr << "mapt: error: " << printable(text) << '\n';
}

void Console::note(const std::string& text) const
{
  if(is_verbose && !is_quiet)
    std::cerr << "mapt: " << printable(text) << '\n';
}

int Console::finish()
{
  report["exit_code"] = exit_code;
  return print_report();
}

int Console::fail(int code, const std::string& text)
{
  complain(text);
  report = {{"error", text}, {"exit_code", code}};
  exit_code = code;
  print_report();
  return code;
}

int Console::print_report()
{
  // File names need not be UTF-8; what is not becomes a replacement character.
  if(is_json)
    std::cout << report.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) << '\n';
  return flush();
}

int Console::flush() const
{
  if(std::cout.flush())
    return exit_code;
  std::cerr << "mapt: error: standard output: cannot be written\n";
  return OUTPUT_NOT_WRITTEN;
}

} // namespace mapt
