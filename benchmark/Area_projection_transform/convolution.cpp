// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Sums over balls of voxels, for all voxels of a cube: by Fourier transforms, directly, by nested disks.

#include "baselines/direct_projectors.h"
#include "benchmark_projectors.h"
#ifdef AREA_PROJECTION_TRANSFORM_FFTW
#include "baselines/Fft_convolution.h"
#endif

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <memory>
#include <random>
#include <thread>
#include <vector>

namespace Benchmarks {

namespace {

using AP::internal::Ball_convolution;

/// integers for all voxels of a cube.
struct Cube
{
  AP::Grid_3 grid;
  AP::Row_spans region;
  std::vector<std::int32_t> votes;

  explicit Cube(int n) : grid(AP::Point_3(0, 0, 0), 1, {n, n, n}), region(grid)
  {
    std::mt19937 engine(1);
    votes.resize(grid.number_of_voxels());
    for(std::int32_t& vote : votes)
      vote = std::int32_t(engine() % 100);
  }

  int side() const { return grid.size()[0]; }
  std::size_t row_bytes() const { return sizeof(std::int32_t) * std::size_t(side()); }

  const std::int32_t* row(int j, int k) const
  {
    return votes.data() + grid.row(j, k) * std::size_t(side());
  }

  /// hands over rows as a Ball_convolution asks for them.
  template <class Row>
  void operator()(int layer, int first, int last, Row&& to) const
  {
    for(int j = first; j < last; ++j)
      std::memcpy(to(j), row(j, layer), row_bytes());
  }
};

/// the largest difference, relative to the largest sum.
double error_of(const std::vector<float>& sums, const std::vector<float>& expected)
{
  float difference = 0;
  for(std::size_t v = 0; v < sums.size(); ++v)
    difference = std::max(difference, std::abs(sums[v] - expected[v]));
  return double(difference) / *std::max_element(expected.begin(), expected.end());
}

/// the balls of one radius, and the sums over them.
struct Task
{
  const Cube& cube;
  double radius;
  int squared_radius;
  std::vector<float> expected;

  Task(const Cube& c, double r)
      : cube(c)
      , radius(r)
      , squared_radius(AP::internal::largest_squared_distance(r))
      , expected(c.votes.size())
  {
    fold(expected);
  }

  /// the sums by the library.
  void fold(std::vector<float>& sums) const
  {
    Ball_convolution convolve(cube.region, {{squared_radius, 1.f}});
    convolve(
        cube, [] { return false; }, sums.data());
    keep(sums.data());
  }

  double additions() const { return size_of_ball(radius) * double(cube.votes.size()); }
};

void add_fold(Comparison& comparison, const Task& task, const Parameters& parameters = {},
              AP::internal::Instruction_set set = AP::internal::instruction_set())
{
  const auto sums = std::make_shared<std::vector<float>>(task.expected.size());
  const Comparison::Work work = with(set, [&task, sums] { task.fold(*sums); });
  work();
  Row& row = comparison.add("Ball_convolution", parameters, work);
  row.measures.emplace_back("error", error_of(*sums, task.expected));
}

/// the rows above use the best of the instruction sets, these the others.
void add_folds_of_instruction_sets(Comparison& comparison, const Task& task)
{
  for(auto set : AP::internal::available_instruction_sets())
    if(set != AP::internal::instruction_set())
      add_fold(comparison, task, {{"instructions", AP::internal::name(set)}}, set);
}

#ifdef AREA_PROJECTION_TRANSFORM_FFTW
/// The plans and the spectrum of the ball are made beforehand, to the advantage of FFTW.
void add_fft(Comparison& comparison, const Task& task, int threads,
             const Parameters& parameters = {})
{
  const auto convolve =
      std::make_shared<baselines::Fft_convolution>(task.cube.grid, task.squared_radius, threads);
  const auto votes =
      std::make_shared<const std::vector<float>>(task.cube.votes.begin(), task.cube.votes.end());
  const auto sums = std::make_shared<std::vector<float>>(votes->size());
  const auto work = [convolve, votes, sums] {
    (*convolve)(votes->data(), sums->data());
    keep(sums->data());
  };
  work();
  Row& row = comparison.add("FFTW", parameters, work);
  row.measures.emplace_back("error", error_of(*sums, task.expected));
}
#endif

/// The copy of the votes is part of the work, as it is for the others.
template <class Convolution>
void add_direct(Comparison& comparison, const std::string& name, const Task& task)
{
  const auto convolution = std::make_shared<Convolution>(task.cube.grid, task.squared_radius);
  const auto work = [convolution, &cube = task.cube] {
    for(int k = 0; k < cube.side(); ++k)
      for(int j = 0; j < cube.side(); ++j)
        std::memcpy(convolution->row(j, k), cube.row(j, k), cube.row_bytes());
    convolution->convolve();
    keep(convolution->sums(0, 0));
  };
  work();
  std::vector<float> sums;
  for(int k = 0; k < task.cube.side(); ++k)
    for(int j = 0; j < task.cube.side(); ++j)
      sums.insert(sums.end(), convolution->sums(j, k), convolution->sums(j, k) + task.cube.side());
  Row& row = comparison.add(name, work);
  row.measures.emplace_back("error", error_of(sums, task.expected));
}

/// The direct sums are left out where they take longer than some 15 seconds (full) or a quarter (quick).
void compare_on_dense_grid(Group& group, const Cube& cube, double radius)
{
  const Task task(cube, radius);
  const double most = group.pick(1e7, 5e8, 3e10);
  Comparison comparison =
      group.comparison("dense grid", {{"voxels", cube.side()}, {"radius", radius}});
#ifdef AREA_PROJECTION_TRANSFORM_FFTW
  add_fft(comparison, task, 1);
#endif
  if(task.additions() <= most)
    add_direct<baselines::Tuned_convolution>(comparison, "tuned direct sum", task);
  if(slowness_of_literal * task.additions() <= most)
    add_direct<baselines::Literal_convolution>(comparison, "literal direct sum", task);
  add_fold(comparison, task);
  add_folds_of_instruction_sets(comparison, task);
  comparison.run();
}

#ifdef AREA_PROJECTION_TRANSFORM_FFTW_THREADS
/// one radius only: the time of FFTW does not depend on it.
void compare_with_threads(Group& group, const Cube& cube)
{
  const Task task(cube, 6);
  const int all = std::max(1, int(std::thread::hardware_concurrency()));
  Comparison comparison =
      group.comparison("dense grid, threads", {{"voxels", cube.side()}, {"radius", task.radius}},
                       Comparison::Clock::WALL);
  add_fft(comparison, task, 1, {{"threads", 1}});
  add_fft(comparison, task, all, {{"threads", all}});
  add_fold(comparison, task, {{"threads", 1}});
  comparison.run();
}
#endif

void convolution(Group& group)
{
  const int most = group.pick(32, 128, 256);
  const std::vector<double> few = {2, 6}, some = {1, 3, 6, 12}, many = {1, 2, 3, 4.5, 6, 8, 12};
  const std::vector<double> radii = group.pick(few, some, many);
  for(int n = std::min(most, 64); n <= most; n *= 2) {
    const Cube cube(n);
    for(double radius : radii)
      compare_on_dense_grid(group, cube, radius);
  }
#ifdef AREA_PROJECTION_TRANSFORM_FFTW_THREADS
  compare_with_threads(group, Cube(most));
#endif
}

const Registered_group registered(
    "convolution",
    "Sums over balls of voxels, for all voxels of a cube without empty rows; radii are in "
    "voxels. Ball_convolution is what Paper_grid_projector uses. The direct sums are "
    "those of the paper, as one reads it and tuned; they are left out where they would "
    "take too long. For whole maps, see hapt. Errors are the largest differences from "
    "Ball_convolution, relative to the largest sum."
#ifdef AREA_PROJECTION_TRANSFORM_FFTW
    " The baseline is FFTW with floats; its plans and the spectrum of the ball are made beforehand."
#else
    " Built without FFTW: its rows are missing."
#endif
    ,
    convolution);

} // namespace

} // namespace Benchmarks
