// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MAPT_DESCRIBE_QUEUE_H
#define MAPT_DESCRIBE_QUEUE_H

#include "console.h"
#include "cost.h"
#include "describe_journal.h"
#include "description.h"
#include "progress.h"

#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace mapt {

/// the files to describe, dealt out one after the other to whoever asks, and what became of them. All functions
/// may be called concurrently, but for results().
class Describe_queue
{
public:
  /// \param journal may be null
  Describe_queue(std::vector<std::string> files, Describe_journal* journal, const Console& console);

  std::size_t size() const { return m_files.size(); }
  const std::string& file(std::size_t i) const { return m_files[i]; }
  /// whether a former run described it.
  bool is_resumed(std::size_t i) const { return m_is_resumed[i]; }
  /// how many were finished by former runs.
  std::size_t number_resumed() const { return m_resumed; }
  /// how many are finished, failures included.
  std::size_t number_finished() const { return m_finished; }

  /// the place of the next file; nothing if there is none, or a signal came, or the journal cannot be written.
  std::optional<std::size_t> next();

  /// takes what became of a file: into the journal, or to stderr.
  /// \throw Output_error if the journal cannot be written
  void finish(std::size_t i, Description&& description);

  /// what became of the files, in their order.
  const std::vector<Description>& results() const { return m_results; }

private:
  void resume(Describe_journal::Entries entries);
  void show_progress();

  std::vector<std::string> m_files;
  std::vector<Description> m_results;
  std::vector<bool> m_is_resumed;
  std::vector<File_state> m_states; // before they were read
  Describe_journal* m_journal;
  const Console& m_console;

  std::mutex m_mutex;
  std::size_t m_next = 0, m_resumed = 0, m_finished = 0, m_failed = 0;
  bool m_is_broken = false;
  std::chrono::steady_clock::time_point m_start = std::chrono::steady_clock::now();
  Progress_line m_progress;
};

} // namespace mapt

#endif // MAPT_DESCRIBE_QUEUE_H
