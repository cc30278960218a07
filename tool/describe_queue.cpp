// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "describe_queue.h"

#include "text.h"

namespace mapt {

Describe_queue::Describe_queue(std::vector<std::string> files, Describe_journal* journal,
                               const Console& console)
    : m_files(std::move(files))
    , m_results(m_files.size())
    , m_is_resumed(m_files.size(), false)
    , m_states(m_files.size())
    , m_journal(journal)
    , m_console(console)
    , m_progress(console, "describe")
{
  if(journal)
    resume(journal->take_entries());
}

void Describe_queue::resume(Describe_journal::Entries entries)
{
  for(std::size_t i = 0; i < size() && !entries.empty(); ++i) {
    const auto known = entries.find(m_files[i]);
    if(known == entries.end() || !(known->second.state == state_of(m_files[i])))
      continue;
    m_results[i] = std::move(known->second.description);
    m_is_resumed[i] = true;
    ++m_resumed;
    entries.erase(known);
  }
  m_finished = m_resumed;
}

std::optional<std::size_t> Describe_queue::next()
{
  const std::lock_guard<std::mutex> lock(m_mutex);
  while(m_next < size() && m_is_resumed[m_next])
    ++m_next;
  if(m_next == size() || m_is_broken || Signal_watch::is_interrupted())
    return std::nullopt;
  m_states[m_next] = state_of(m_files[m_next]);
  return m_next++;
}

void Describe_queue::finish(std::size_t i, Description&& description)
{
  const std::lock_guard<std::mutex> lock(m_mutex);
  ++m_finished;
  if(!description.failure.empty()) {
    ++m_failed;
    m_progress.hide();
    m_console.complain(description.failure);
  } else if(m_journal) {
    m_is_broken = true; // unless it can be written
    m_journal->add(m_files[i], {m_states[i], description});
    m_is_broken = false;
  }
  if(!description.remark.empty() && m_console.is_verbose) {
    m_progress.hide();
    m_console.note(m_files[i] + ": " + description.remark);
  }
  m_results[i] = std::move(description);
  show_progress();
}

void Describe_queue::show_progress()
{
  const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - m_start;
  const double seconds_each = passed.count() / double(m_finished - m_resumed);
  m_progress.show(double(m_finished) / double(size()),
                  std::to_string(m_finished) + " of " + counted(size(), "mesh", "meshes") +
                      (m_failed > 0 ? ", " + std::to_string(m_failed) + " failed" : "") + ", " +
                      time_to_text(seconds_each * double(size() - m_finished)) + " left");
}

} // namespace mapt
