// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MAPT_PROGRESS_H
#define MAPT_PROGRESS_H

#include "console.h"

#include <chrono>
#include <string>

namespace mapt {

/// while it lives, SIGINT and SIGTERM do not end the program but are noticed.
class Signal_watch
{
public:
  Signal_watch();
  ~Signal_watch();
  Signal_watch(const Signal_watch&) = delete;
  Signal_watch& operator=(const Signal_watch&) = delete;

  static bool is_interrupted();
  /// \throw Interruption if a signal came.
  static void check();

private:
  using Handler = void (*)(int);
  Handler m_former_interrupt;
  Handler m_former_terminate;
};

/// a line on stderr that tells how far the work is, if stderr is a terminal.
class Progress_line
{
public:
  Progress_line(const Console& console, const std::string& task);
  ~Progress_line();
  Progress_line(const Progress_line&) = delete;
  Progress_line& operator=(const Progress_line&) = delete;

  void show(double fraction);
  /// shows more than a percentage, some times in a second.
  void show(double fraction, const std::string& detail);
  /// makes room for other lines, until it is shown again.
  void hide();

private:
  bool m_is_shown;
  std::string m_task;
  int m_percent = -1; // that is shown
  std::chrono::steady_clock::time_point m_shown_at;
};

} // namespace mapt

#endif // MAPT_PROGRESS_H
