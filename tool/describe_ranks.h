// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MAPT_DESCRIBE_RANKS_H
#define MAPT_DESCRIBE_RANKS_H

#include "describe_queue.h"

#include <cstddef>
#include <exception>
#include <string>
#include <vector>

namespace mapt {

/// the processes that share the work of `mapt describe`: those that mpirun started, or this one alone (also without
/// MPI). The first of them deals out the files and writes what is to be written; the others work for it, with
/// the arguments that they were started with, too.
///
/// If one dies, MPI ends them all; what was finished is in the journal of the first.
class Describe_ranks
{
public:
  Describe_ranks();
  /// dismisses those that have not been.
  ~Describe_ranks();
  Describe_ranks(const Describe_ranks&) = delete;
  Describe_ranks& operator=(const Describe_ranks&) = delete;

  std::size_t number() const { return m_number; }
  bool is_first() const { return m_rank == 0; }

  /// describes files for the first rank, until it is dismissed.
  /// \pre it is not the first
  void serve(const std::vector<std::string>& arguments) const;

  /// describes the files of a queue; returns when all that were dealt out are finished.
  /// \pre it is the first
  /// \throw Output_error if the journal cannot be written
  void describe_all(Describe_queue& queue, const Describe_options& options);

private:
  bool answer_one(Describe_queue& queue);

  bool m_is_running = false; // MPI
  std::size_t m_rank = 0, m_number = 1;
  std::size_t m_workers = 0;          // that are not dismissed
  std::vector<std::size_t> m_at_work; // the file that each rank has
  std::exception_ptr m_error;         // of the journal
};

} // namespace mapt

#endif // MAPT_DESCRIBE_RANKS_H
