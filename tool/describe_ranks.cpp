// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "describe_ranks.h"

#include "threads.h"

#include <CGAL/Area_projection_transform/internal/parallel_workers.h>

#include <optional>

#ifdef MAPT_WITH_MPI
#define OMPI_SKIP_MPICXX 1
#define MPICH_SKIP_MPICXX 1
#include <mpi.h>

#include <chrono>
#include <cstdlib>
#include <thread>
#endif

namespace mapt {

namespace {

// Describes one mesh at a time, from reading to the journal.
void work_off(Describe_queue& queue, const Describe_options& options)
{
  while(const std::optional<std::size_t> i = queue.next())
    queue.finish(*i, describe_file(queue.file(*i), options));
}

void work_in_threads(Describe_queue& queue, const Describe_options& options)
{
  const Thread_limit limit(number_of_threads(options.common.threads));
  AP::internal::run_workers<CGAL::Parallel_if_available_tag>(
      queue.size(), [&](std::size_t, std::size_t) { work_off(queue, options); });
}

} // namespace

#ifdef MAPT_WITH_MPI

namespace {

// To a worker: the name of a file, or nothing: it is dismissed. From a worker: a description, or
// nothing: it has just begun.
constexpr int tag = 1;

void send(const std::string& text, std::size_t rank)
{
  MPI_Send(text.data(), int(text.size()), MPI_CHAR, int(rank), tag, MPI_COMM_WORLD);
}

bool has_come_from(int rank)
{
  int has_come = 0;
  MPI_Iprobe(rank, tag, MPI_COMM_WORLD, &has_come, MPI_STATUS_IGNORE);
  return has_come != 0;
}

// Waiting within MPI would keep a processor busy.
void wait_a_little()
{
  std::this_thread::sleep_for(std::chrono::microseconds(200));
}

std::string receive(int rank, std::size_t& sender)
{
  while(!has_come_from(rank))
    wait_a_little();
  MPI_Status status;
  int length = 0;
  MPI_Probe(rank, tag, MPI_COMM_WORLD, &status);
  MPI_Get_count(&status, MPI_CHAR, &length);
  std::string text(std::size_t(length), '\0');
  sender = std::size_t(status.MPI_SOURCE);
  MPI_Recv(&text[0], length, MPI_CHAR, status.MPI_SOURCE, tag, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
  return text;
}

// Without it MPI would begin a job of its own, which takes a while.
bool was_started_by_mpirun()
{
  for(const char* const variable : {"OMPI_COMM_WORLD_SIZE", "PMI_RANK", "PMIX_RANK"})
    if(std::getenv(variable))
      return true;
  return false;
}

} // namespace

Describe_ranks::Describe_ranks()
{
  if(!was_started_by_mpirun())
    return;
  int thread_support = 0, rank = 0, number = 1;
  MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &thread_support);
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Comm_size(MPI_COMM_WORLD, &number);
  m_is_running = true;
  m_rank = std::size_t(rank);
  m_number = std::size_t(number);
  m_at_work.resize(m_number);
  m_workers = is_first() ? m_number - 1 : 0;
}

Describe_ranks::~Describe_ranks()
{
  std::size_t worker = 0;
  for(; m_workers > 0; --m_workers) {
    receive(MPI_ANY_SOURCE, worker);
    send("", worker);
  }
  // A signal went to all: mpirun is ending them, and there is no one to take leave of.
  if(m_is_running && !Signal_watch::is_interrupted())
    MPI_Finalize();
}

void Describe_ranks::serve(const std::vector<std::string>& arguments) const
{
  std::optional<Describe_options> options; // good ones, if the first rank has a file to deal out
  std::size_t first = 0;
  send("", first);
  for(std::string file; !(file = receive(0, first)).empty();) {
    if(!options) {
      Console console;
      read_options(arguments, console, options.emplace());
    }
    send(to_line(describe_file(file, *options)), first);
  }
}

// Takes what a worker has to tell, if one has, and gives it another file; returns whether one had.
bool Describe_ranks::answer_one(Describe_queue& queue)
{
  if(!has_come_from(MPI_ANY_SOURCE))
    return false;
  std::size_t worker = 0;
  const std::string line = receive(MPI_ANY_SOURCE, worker);
  try {
    if(std::optional<Description> description = description_from(line))
      queue.finish(m_at_work[worker], std::move(*description));
  } catch(...) {
    m_error = std::current_exception(); // the queue deals out no more
  }
  const std::optional<std::size_t> next = queue.next();
  if(next)
    m_at_work[worker] = *next;
  else
    --m_workers;
  send(next ? queue.file(*next) : "", worker);
  return true;
}

void Describe_ranks::describe_all(Describe_queue& queue, const Describe_options& options)
{
  if(m_number == 1) {
    work_in_threads(queue, options);
    return;
  }
  std::exception_ptr error;
  std::thread own_work([&] {
    try {
      work_off(queue, options);
    } catch(...) {
      error = std::current_exception();
    }
  });
  while(m_workers > 0)
    if(!answer_one(queue))
      wait_a_little();
  own_work.join();
  for(const std::exception_ptr& e : {error, m_error})
    if(e)
      std::rethrow_exception(e);
}

#else

Describe_ranks::Describe_ranks() = default;

Describe_ranks::~Describe_ranks() = default;

void Describe_ranks::serve(const std::vector<std::string>&) const {}

void Describe_ranks::describe_all(Describe_queue& queue, const Describe_options& options)
{
  work_in_threads(queue, options);
}

#endif

} // namespace mapt
