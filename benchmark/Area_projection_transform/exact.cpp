// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The exact transform by kernels of every instruction set against the scalar closed form: one evaluation,
// maps of the eight scales of the paper's descriptor, and queries at points. CPU times of one thread; only
// ratios within one run mean something.
//
//   benchmark_exact [mesh.off|.obj|.ply|.stl ...]      (default: the bundled hand)

#include <CGAL/Area_projection_transform/projection/Exact_evaluator.h>
#include <CGAL/Area_projection_transform/projection/Exact_grid_projector.h>
#include <CGAL/Area_projection_transform/projection/Grid_projector.h>
#include <CGAL/Area_projection_transform/regions.h>
#include <CGAL/Area_projection_transform/scale_space/Constant_scale_space.h>
#include <CGAL/Area_projection_transform/surfels_from_mesh.h>

#define CGAL_AREA_PROJECTION_KERNEL "exact_impl.h"
#include <CGAL/Area_projection_transform/internal/simd/for_each_instruction_set.h>

#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <cstdio>
#include <ctime>
#include <iostream>
#include <string>
#include <vector>

namespace AP = CGAL::Area_projection;

namespace {

using AP::Point_3;
using AP::Vector_3;
using AP::internal::Flat_triangle;
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
using Surface = AP::Constant_scale_space<AP::Triangle_surface>;

volatile double sink; // keeps what is measured from being left out

/// the least CPU time of a few runs, in seconds.
template <class Work>
double time_of(Work work, int runs = 3)
{
  double least = 1e9;
  for(int run = 0; run < runs; ++run) {
    const std::clock_t begin = std::clock();
    work();
    least = std::min(least, double(std::clock() - begin) / CLOCKS_PER_SEC);
  }
  return least;
}

void print_row(const std::string& name, double value, const char* unit, double scalar)
{
  std::printf("  %-32s %10.2f %-9s %6.1f x\n", name.c_str(), value, unit, scalar / value);
}

template <class Work>
void for_each_instruction_set(Work work)
{
  const auto sets = AP::internal::available_instruction_sets();
  for(const auto set : sets) {
    AP::internal::chosen_instruction_set() = set;
    work(std::string(AP::internal::name(set)));
  }
  AP::internal::chosen_instruction_set() = sets.back();
}

/// disks of radius 1 that cut a triangle, small as those of a mesh are.
void measure_kernel()
{
  const Flat_triangle triangle(Point_3(0, 0, 0), Vector_3(0.3, 0, 0), Vector_3(0.1, 0.25, 0));
  std::vector<double> x, y;
  while(x.size() < 1024) {
    const double angle = 2.4 * double(x.size()), distance = 0.8 + 0.03 * double(x.size() % 10);
    x.push_back(0.13 + distance * std::cos(angle));
    y.push_back(0.08 + distance * std::sin(angle));
  }
  const std::vector<float> float_x(x.begin(), x.end()), float_y(y.begin(), y.end());
  const int size = int(x.size()), repeats = 300;
  const auto nanoseconds = [&](auto sum) {
    return 1e9 / size / repeats * time_of([&] {
             for(int n = 0; n < repeats; ++n)
               sink = sum();
           });
  };
  const double scalar = nanoseconds([&] {
    double sum = 0;
    for(std::size_t i = 0; i < x.size(); ++i)
      sum += triangle.fraction_within(Point_3(x[i], y[i], 0), 1);
    return sum;
  });
  std::cout << "triangle within a disk, one evaluation\n";
  print_row("scalar closed form", scalar, "ns", scalar);
  for_each_instruction_set([&](const std::string& set) {
    const float *fx = float_x.data(), *fy = float_y.data();
    const double *dx = x.data(), *dy = y.data();
    print_row(set + ", floats, small triangles", nanoseconds([&] {
                return CGAL_AREA_PROJECTION_DISPATCHED(sum_along, triangle, fx, fy, size, 1.);
              }),
              "ns", scalar);
    print_row(set + ", floats, large triangles", nanoseconds([&] {
                return CGAL_AREA_PROJECTION_DISPATCHED(sum_between, triangle, fx, fy, size, 1.);
              }),
              "ns", scalar);
    print_row(set + ", doubles", nanoseconds([&] {
                return CGAL_AREA_PROJECTION_DISPATCHED(sum_between, triangle, dx, dy, size, 1.);
              }),
              "ns", scalar);
  });
}

/// \brief what is to be computed: the interior in voxels of 1/50 of the longest side, `R` of 2 to 9 voxels,
/// `σ` half of that.
struct Job
{
  Surface surface;
  AP::Row_spans region;
  std::vector<AP::Scale> scales;

  explicit Job(const Mesh& mesh)
      : surface(AP::surface_from_mesh(mesh))
      , region(AP::interior(surface.source(), AP::grid_around(surface.bbox(), voxel())).region)
      , scales(AP::proportional_scales(AP::uniform_radii(2 * voxel(), voxel(), 8)))
  {}

  double voxel() const
  {
    const CGAL::Bbox_3 box = surface.bbox();
    return std::max({box.x_span(), box.y_span(), box.z_span()}) / 50;
  }
};

/// one map after the other, each added up to check it against others.
template <class Projector>
double sum_of_maps(const Job& job)
{
  Projector projector(job.region);
  std::vector<float> row(std::size_t(job.region.grid().size()[0]));
  double sum = 0;
  for(const AP::Scale& scale : job.scales) {
    projector.project(job.surface, scale, AP::Side::INSIDE, [] { return false; });
    for(std::size_t r = 0; r < job.region.number_of_rows(); ++r) {
      projector.take_row(r, row.data());
      const auto& hull = job.region.hull(r);
      for(std::int32_t i = hull.first; i < hull.last; ++i)
        sum += double(row[std::size_t(i - hull.first)]);
    }
  }
  return sum;
}

/// the first and the last voxel of an axis that a ball around a triangle may concern.
std::pair<int, int> range(const Flat_triangle& t, int axis, double radius, int low, int high)
{
  const auto& c = t.corners;
  const double least = std::min({c[0][axis], c[1][axis], c[2][axis]}) - radius;
  const double most = std::max({c[0][axis], c[1][axis], c[2][axis]}) + radius;
  return {std::max(low, int(std::ceil(least))), std::min(high, int(std::floor(most)))};
}

/// adds up a map as simple code does it: in doubles, voxel by voxel, where balls may cut a triangle.
double sum_of_scalar_map(const Job& job, const AP::Scale& scale, std::vector<double>& map)
{
  const AP::Triangle_surface& surface = job.surface.source();
  const double radius = scale.sigma / job.region.grid().spacing();
  const auto& size = job.region.grid().size();
  map.assign(job.region.storage_size(), 0.);
  for(std::size_t t = 0; t < surface.size(); ++t) {
    const Flat_triangle triangle =
        AP::internal::projected_triangle(surface, t, -scale.radius, job.region.grid());
    const auto [first_k, last_k] = range(triangle, 2, radius, 0, size[2] - 1);
    const auto [first_j, last_j] = range(triangle, 1, radius, 0, size[1] - 1);
    for(int k = first_k; k <= last_k; ++k)
      for(int j = first_j; j <= last_j; ++j) {
        const auto& hull = job.region.hull(job.region.grid().row(j, k));
        const auto [first, last] = range(triangle, 0, radius, hull.first, hull.last - 1);
        for(int i = first; i <= last; ++i) {
          const Point_3 x(i, j, k);
          const auto distance = [&](std::size_t c) {
            return CGAL::squared_distance(x, triangle.corners[c]);
          };
          const bool is_held = std::max({distance(0), distance(1), distance(2)}) <= radius * radius;
          map[hull.offset + std::size_t(i - hull.first)] +=
              surface.areas[t] * (is_held ? 1 : triangle.fraction_within(x, radius));
        }
      }
  }
  double sum = 0;
  for(const double value : map)
    sum += value;
  return sum;
}

void measure_grid(const Job& job)
{
  std::vector<double> map;
  const double scalar = 1e3 * time_of(
                                  [&] {
                                    double sum = 0;
                                    for(const AP::Scale& scale : job.scales)
                                      sum += sum_of_scalar_map(job, scale, map);
                                    sink = sum;
                                  },
                                  1);
  const double expected = sink;
  std::cout << "maps of eight scales\n";
  print_row("scalar closed form", scalar, "ms", scalar);
  for_each_instruction_set([&](const std::string& set) {
    print_row(set, 1e3 * time_of([&] { sink = sum_of_maps<AP::Exact_grid_projector>(job); }), "ms",
              scalar);
    std::printf("  %-32s %10.1e\n", "  difference of the sums", sink / expected - 1);
  });
  print_row("grid projector, for comparison",
            1e3 * time_of([&] { sink = sum_of_maps<AP::Grid_projector>(job); }), "ms", scalar);
}

/// points in the middle of what is projected to them, at each of three scales.
void measure_points(const Job& job)
{
  const AP::Triangle_surface& surface = job.surface.source();
  for(const double voxels : {2., 5., 9.}) {
    const double radius = voxels * job.voxel(), sigma = 0.5 * radius;
    std::vector<Point_3> queries;
    for(std::size_t t = 0; t < surface.size(); t += surface.size() / 1000 + 1)
      queries.push_back(surface.corner(t, 0) - radius * surface.normals[t]);
    const auto microseconds = [&](auto evaluate, int runs) {
      return 1e6 / double(queries.size()) *
             time_of(
                 [&] {
                   double sum = 0;
                   for(const Point_3& x : queries)
                     sum += evaluate(x);
                   sink = sum;
                 },
                 runs);
    };
    std::vector<Flat_triangle> triangles;
    for(std::size_t t = 0; t < surface.size(); ++t)
      triangles.push_back(AP::internal::projected_triangle(surface, t, -radius));
    std::cout << "query at a point, R of " << voxels << " voxels\n";
    const double scalar = microseconds(
        [&](const Point_3& x) {
          double sum = 0;
          for(std::size_t t = 0; t < triangles.size(); ++t)
            sum += surface.areas[t] * triangles[t].fraction_within(x, sigma);
          return sum;
        },
        1);
    const double expected = sink;
    print_row("scalar, all triangles", scalar, "us", scalar);
    const AP::Exact_evaluator evaluator(job.surface, radius, AP::Side::INSIDE);
    for_each_instruction_set([&](const std::string& set) {
      print_row(set, microseconds([&](const Point_3& x) { return evaluator(x, sigma); }, 3), "us",
                scalar);
      std::printf("  %-32s %10.1e\n", "  difference of the sums", sink / expected - 1);
    });
  }
}

} // namespace

int main(int argc, char** argv)
{
  std::vector<std::string> files(argv + 1, argv + argc);
  if(files.empty())
    files.push_back(AREA_PROJECTION_TRANSFORM_DATA "/hand.obj");
  measure_kernel();
  for(const std::string& file : files) {
    Mesh mesh;
    if(!CGAL::IO::read_polygon_mesh(file, mesh) || mesh.is_empty()) {
      std::cerr << file << ": cannot be read as a mesh\n";
      return EXIT_FAILURE;
    }
    std::cout << "\n" << file << ", " << mesh.number_of_faces() << " faces\n";
    const Job job(mesh);
    measure_grid(job);
    measure_points(job);
  }
}
