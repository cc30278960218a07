// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "input_text.h"

#include <charconv>
#include <cstdlib>

namespace mapt {

namespace {

bool is_blank(char c)
{
  return c == ' ' || c == '\t' || c == '\r' || c == '\f' || c == '\v';
}

} // namespace

bool Text_cursor::is_at_end_of_line() const
{
  return m_at == m_text.size() || m_text[m_at] == '\n' || m_text[m_at] == '#';
}

void Text_cursor::skip_blanks()
{
  while(m_at < m_text.size()) {
    if(is_blank(m_text[m_at])) {
      ++m_at;
    } else if(m_text[m_at] == '\\') {
      std::size_t next = m_at + 1;
      while(next < m_text.size() && m_text[next] == '\r')
        ++next;
      if(next == m_text.size() || m_text[next] != '\n')
        return;
      m_at = next + 1;
      ++m_line;
    } else {
      return;
    }
  }
}

void Text_cursor::skip_line()
{
  const std::size_t end = m_text.find('\n', m_at);
  if(end == std::string_view::npos) {
    m_at = m_text.size();
    return;
  }
  m_at = end + 1;
  ++m_line;
  m_is_at_start_of_line = true;
}

bool Text_cursor::next_line()
{
  if(!m_is_at_start_of_line)
    skip_line();
  for(skip_blanks(); is_at_end_of_line(); skip_blanks()) {
    if(m_at == m_text.size())
      return false;
    skip_line();
  }
  m_is_at_start_of_line = false;
  return true;
}

std::string_view Text_cursor::word()
{
  m_is_at_start_of_line = false;
  skip_blanks();
  const std::size_t begin = m_at;
  while(!is_at_end_of_line() && !is_blank(m_text[m_at]))
    ++m_at;
  return m_text.substr(begin, m_at - begin);
}

std::string_view Text_cursor::word_of_any_line()
{
  std::string_view found = word();
  while(found.empty() && next_line())
    found = word();
  return found;
}

bool parse(std::string_view word, double& value)
{
  if(!word.empty() && word.front() == '+')
    word.remove_prefix(1); // from_chars() knows no plus sign
  const auto result = std::from_chars(word.data(), word.data() + word.size(), value);
  if(result.ec == std::errc::result_out_of_range) // too large or too small: which of both?
    value = std::strtod(std::string(word).c_str(), nullptr);
  else if(result.ec != std::errc())
    return false;
  return result.ptr == word.data() + word.size();
}

bool parse(std::string_view word, long long& value)
{
  if(!word.empty() && word.front() == '+')
    word.remove_prefix(1);
  const auto result = std::from_chars(word.data(), word.data() + word.size(), value);
  return result.ec == std::errc() && result.ptr == word.data() + word.size();
}

std::string in_quotes(std::string_view word)
{
  constexpr std::size_t longest = 24;
  std::string text = "'";
  for(const char c : word.substr(0, longest))
    text += c >= ' ' && c <= '~' ? c : '?';
  return text + (word.size() > longest ? "...'" : "'");
}

} // namespace mapt
