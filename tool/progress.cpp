// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "progress.h"

#include "errors.h"

#include <csignal>
#include <iostream>

#include <unistd.h>

namespace mapt {

namespace {

volatile std::sig_atomic_t has_signal_come = 0;

} // namespace

extern "C" void mapt_notice_signal(int)
{
  has_signal_come = 1;
}

Signal_watch::Signal_watch()
    : m_former_interrupt(std::signal(SIGINT, mapt_notice_signal))
    , m_former_terminate(std::signal(SIGTERM, mapt_notice_signal))
{}

Signal_watch::~Signal_watch()
{
  std::signal(SIGINT, m_former_interrupt);
  std::signal(SIGTERM, m_former_terminate);
}

bool Signal_watch::is_interrupted()
{
  return has_signal_come != 0;
}

void Signal_watch::check()
{
  if(is_interrupted())
    throw Interruption();
}

Progress_line::Progress_line(const Console& console, const std::string& task)
    : m_is_shown(!console.is_quiet && isatty(STDERR_FILENO)), m_task(task)
{}

Progress_line::~Progress_line()
{
  hide();
}

void Progress_line::hide()
{
  if(m_percent >= 0)
    std::cerr << "\r\033[K" << std::flush;
  m_percent = -1;
}

void Progress_line::show(double fraction)
{
  const int percent = int(100 * fraction);
  if(!m_is_shown || percent == m_percent)
    return;
  m_percent = percent;
  std::cerr << '\r' << m_task << "  " << percent << " %\033[K" << std::flush;
}

void Progress_line::show(double fraction, const std::string& detail)
{
  constexpr std::chrono::milliseconds pause(200);
  const auto now = std::chrono::steady_clock::now();
  if(!m_is_shown || (m_percent >= 0 && now - m_shown_at < pause))
    return;
  m_percent = int(100 * fraction);
  m_shown_at = now;
  std::cerr << '\r' << m_task << "  " << m_percent << " %, " << detail << "\033[K" << std::flush;
}

} // namespace mapt
