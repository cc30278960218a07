// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Convolution with balls of voxels: directly, by nested disks, by FFTW; and whole maps by the algorithm of
// the paper. CPU times of one run (of all threads together where there are two), and their ratios.
//
//   benchmark_convolution                           dense grids of 64^3, 128^3 and 256^3 voxels
//   benchmark_convolution mesh.off|.obj|.ply|.stl   eight scales, at 50 voxels and, subdivided, at 256

#include "baselines/direct_projectors.h"
#ifdef AREA_PROJECTION_TRANSFORM_FFTW
#include "baselines/Fft_convolution.h"
#endif

#include <CGAL/Area_projection_transform/multiscale.h>
#include <CGAL/Area_projection_transform/regions.h>
#include <CGAL/Area_projection_transform/scale_space/Constant_scale_space.h>
#include <CGAL/Area_projection_transform/sinks.h>
#include <CGAL/Area_projection_transform/surfels_from_mesh.h>

#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/subdivision_method_3.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <iomanip>
#include <iostream>
#include <limits>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

namespace AP = CGAL::Area_projection;
using AP::internal::Ball_convolution;
using AP::internal::Instruction_set;

/// the CPU time of all threads that `work` takes, in milliseconds: the shortest of some times.
template <class Work>
double milliseconds(int times, Work work)
{
  double shortest = std::numeric_limits<double>::infinity();
  for(int i = 0; i < times; ++i) {
    const std::clock_t begin = std::clock();
    work();
    shortest = std::min(shortest, 1000. * double(std::clock() - begin) / CLOCKS_PER_SEC);
  }
  return shortest;
}

void print(double value)
{
  if(std::isnan(value))
    std::cout << std::setw(10) << '-';
  else
    std::cout << std::setw(10) << std::fixed << std::setprecision(value < 10 ? 2 : 1) << value;
}

const double none = std::numeric_limits<double>::quiet_NaN();

// ---------------------------------------------------------------- dense grids

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

  /// hands over rows as a `Ball_convolution` asks for them.
  template <class Row>
  void operator()(int layer, int first, int last, Row&& to) const
  {
    for(int j = first; j < last; ++j)
      std::memcpy(to(j), row(j, layer), row_bytes());
  }
};

void expect_equal(bool is_equal, const std::string& what)
{
  if(!is_equal)
    throw std::runtime_error(what + ": the results differ");
}

std::vector<float> fold(const Cube& cube, int squared_radius)
{
  std::vector<float> sums(cube.votes.size());
  Ball_convolution convolve(cube.region, {{squared_radius, 1.f}});
  convolve(
      cube, [] { return false; }, sums.data());
  return sums;
}

double time_of_fold(const Cube& cube, int squared_radius, Instruction_set set)
{
  AP::internal::chosen_instruction_set() = set;
  std::vector<float> sums(cube.votes.size());
  return milliseconds(5, [&] {
    Ball_convolution convolve(cube.region, {{squared_radius, 1.f}});
    convolve(
        cube, [] { return false; }, sums.data());
  });
}

/// the copy of the votes is part of the work, as it is for the others.
template <class Convolution>
double time_of_direct(const Cube& cube, int squared_radius, const std::vector<float>& expected)
{
  Convolution convolution(cube.grid, squared_radius);
  const double time = milliseconds(1, [&] {
    for(int k = 0; k < cube.side(); ++k)
      for(int j = 0; j < cube.side(); ++j)
        std::memcpy(convolution.row(j, k), cube.row(j, k), cube.row_bytes());
    convolution.convolve();
  });
  for(int k = 0; k < cube.side(); ++k)
    for(int j = 0; j < cube.side(); ++j)
      expect_equal(std::equal(convolution.sums(j, k), convolution.sums(j, k) + cube.side(),
                              expected.data() + cube.grid.row(j, k) * std::size_t(cube.side()),
                              [](std::int32_t a, float b) { return float(a) == b; }),
                   "direct convolution and nested disks");
  return time;
}

double time_of_fft(const Cube& cube, int squared_radius, int threads,
                   const std::vector<float>& expected)
{
#ifdef AREA_PROJECTION_TRANSFORM_FFTW
  const std::vector<float> votes(cube.votes.begin(), cube.votes.end());
  std::vector<float> sums(votes.size());
  baselines::Fft_convolution convolve(cube.grid, squared_radius, threads);
  const double time = milliseconds(3, [&] { convolve(votes.data(), sums.data()); });
  const float largest = *std::max_element(expected.begin(), expected.end());
  expect_equal(std::equal(sums.begin(), sums.end(), expected.begin(),
                          [&](float a, float b) { return std::abs(a - b) <= 1e-5f * largest; }),
               "FFTW and nested disks");
  return time;
#else
  static_cast<void>(cube), static_cast<void>(squared_radius), static_cast<void>(threads);
  static_cast<void>(expected);
  return none;
#endif
}

void compare_on_dense_grid(int n, const std::vector<Instruction_set>& sets)
{
  const Cube cube(n);
  for(const double radius : {1., 2., 3., 4.5, 6., 8., 12.}) {
    const int squared = AP::internal::largest_squared_distance(radius);
    const std::vector<float> expected = fold(cube, squared);
    std::vector<double> times;
    const double work = std::pow(double(n), 3) * std::pow(radius, 3);
    times.push_back(work > 1e8
                        ? none
                        : time_of_direct<baselines::Literal_convolution>(cube, squared, expected));
    times.push_back(
        work > 2e9 ? none : time_of_direct<baselines::Tuned_convolution>(cube, squared, expected));
    for(const Instruction_set set : sets)
      times.push_back(time_of_fold(cube, squared, set));
    const double best = times.back();
    times.push_back(time_of_fft(cube, squared, 1, expected));
    times.push_back(times.back() / best);
#ifdef AREA_PROJECTION_TRANSFORM_FFTW_THREADS
    times.push_back(time_of_fft(cube, squared, 2, expected));
#endif
    times.push_back(times[1] / best);
    std::cout << std::setw(5) << n << std::setw(6) << std::setprecision(1) << std::fixed << radius;
    for(const double time : times)
      print(time);
    std::cout << std::endl;
  }
}

void compare_on_dense_grids()
{
  const auto sets = AP::internal::available_instruction_sets();
  std::cout << "voxels     r   literal     tuned";
  for(const Instruction_set set : sets)
    std::cout << std::setw(10) << AP::internal::name(set);
  std::cout << "      FFTW FFTW/fold";
#ifdef AREA_PROJECTION_TRANSFORM_FFTW_THREADS
  std::cout << "  2 x FFTW";
#endif
  std::cout << " tuned/fold   (ms)\n";
#ifndef AREA_PROJECTION_TRANSFORM_FFTW
  std::cout << "(built without FFTW: its columns are empty)\n";
#endif
  for(const int n : {64, 128, 256})
    compare_on_dense_grid(n, sets);
}

// ---------------------------------------------------------------- maps

using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
using Surface = AP::Constant_scale_space<AP::Triangle_surface>;
using Maps = std::vector<std::vector<float>>;

/// the eight scales of the paper's descriptor over the interior of a mesh: R = 2, ..., 9 voxels.
struct Job
{
  Surface surface;
  AP::Row_spans region;
  std::vector<AP::Scale> scales;

  Job(const Mesh& mesh, double voxels)
      : surface(AP::surface_from_mesh(mesh))
      , region(AP::interior(surface.source(), grid(surface, voxels)).region)
  {
    const double s = region.grid().spacing();
    scales = AP::proportional_scales(AP::uniform_radii(2 * s, s, 8));
  }

  static AP::Grid_3 grid(const Surface& surface, double voxels)
  {
    const CGAL::Bbox_3 b = surface.bbox();
    return AP::grid_around(b, std::max({b.x_span(), b.y_span(), b.z_span()}) / voxels);
  }

  template <class Projector>
  Maps maps() const
  {
    AP::Scale_maps_sink sink(region, scales.size());
    AP::project_scales(
        surface, region, scales, AP::Side::INSIDE, [&] { return Projector(region); }, sink);
    return sink.maps();
  }

  /// what all methods have to do before they vote.
  void project_surface() const
  {
    std::size_t number = 0;
    for(const AP::Scale& scale : scales)
      surface.project(scale.radius, AP::Side::INSIDE, region.grid().spacing(),
                      [&](const AP::Projected_surfels& batch) { number += batch.size(); });
    if(number == 0)
      throw std::runtime_error("nothing is projected");
  }
};

void compare_on_mesh(const Mesh& mesh, double voxels, int times)
{
  const Job job(mesh, voxels);
  const auto& size = job.region.grid().size();
  std::cout << mesh.number_of_vertices() << " vertices, " << size[0] << " x " << size[1] << " x "
            << size[2] << " voxels, 8 scales, interior\n";
  Maps folded, other;
  const double projection = milliseconds(times, [&] { job.project_surface(); });
  const double fold = milliseconds(times, [&] { folded = job.maps<AP::Paper_grid_projector>(); });
  std::cout << std::left << "                        ms    /folded    the same without projection\n"
            << std::right;
  const auto row = [&](const std::string& name, double time) {
    std::cout << std::left << std::setw(16) << name << std::right;
    print(time);
    print(time / fold);
    print((time - projection) / (fold - projection));
    std::cout << std::endl;
  };
  std::cout << std::left << std::setw(16) << "projection" << std::right;
  print(projection);
  std::cout << '\n';
  row("folded", fold);
  using baselines::Direct_paper_projector;
  const double tuned = milliseconds(
      1, [&] { other = job.maps<Direct_paper_projector<baselines::Tuned_convolution>>(); });
  expect_equal(other == folded, "tuned direct maps and folded ones");
  row("tuned direct", tuned);
  const double literal = milliseconds(
      1, [&] { other = job.maps<Direct_paper_projector<baselines::Literal_convolution>>(); });
  expect_equal(other == folded, "literal direct maps and folded ones");
  row("literal direct", literal);
}

void compare_on_file(const std::string& file)
{
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(file, mesh) || mesh.is_empty())
    throw std::runtime_error(file + ": cannot be read as a mesh");
  compare_on_mesh(mesh, 50, 10);
  while(mesh.number_of_vertices() < 100000)
    CGAL::Subdivision_method_3::Loop_subdivision(mesh);
  compare_on_mesh(mesh, 256, 3);
}

} // namespace

int main(int argc, char** argv)
{
  try {
    if(argc == 1)
      compare_on_dense_grids();
    for(int i = 1; i < argc; ++i)
      compare_on_file(argv[i]);
  } catch(const std::exception& error) {
    std::cerr << error.what() << '\n';
    return EXIT_FAILURE;
  }
}
