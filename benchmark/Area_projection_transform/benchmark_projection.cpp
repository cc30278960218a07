// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The default grid projection against the paper's direct algorithm and the exact map: times of one run,
// errors against the exact map, and the ratios.
//
//   benchmark_library [mesh.off|.obj|.ply|.stl ...]      (default: the bundled hand)

#include <CGAL/Area_projection_transform/Joint_map.h>
#include <CGAL/Area_projection_transform/multiscale.h>
#include <CGAL/Area_projection_transform/projection/Exact_grid_projector.h>
#include <CGAL/Area_projection_transform/projection/Grid_projector.h>
#include <CGAL/Area_projection_transform/projection/Paper_grid_projector.h>
#include <CGAL/Area_projection_transform/regions.h>
#include <CGAL/Area_projection_transform/scale_space/Constant_scale_space.h>
#include <CGAL/Area_projection_transform/sinks.h>
#include <CGAL/Area_projection_transform/surfels_from_mesh.h>

#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/subdivision_method_3.h>
#include <CGAL/version.h>

#include <benchmark/benchmark.h>

#include <iomanip>
#include <iostream>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace AP = CGAL::Area_projection;

namespace {

using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
using Surface = AP::Constant_scale_space<AP::Triangle_surface>;

/// a mesh, a grid around it with a given number of voxels along its longest side, and the eight scales
/// of the paper's descriptor: R = 2 s, ..., 9 s with voxels of size s and sigma = R / 2.
struct Job
{
  Surface surface;
  AP::Row_spans region;
  AP::Row_spans box; // what the paper's algorithm covers
  std::vector<AP::Scale> scales;
  std::size_t vertices;

  Job(const Mesh& mesh, double voxels)
      : surface(AP::surface_from_mesh(mesh))
      , region(AP::interior(surface.source(), grid(surface, voxels)).region)
      , box(region.grid())
      , vertices(mesh.number_of_vertices())
  {
    const double s = region.grid().spacing();
    scales = AP::proportional_scales(AP::uniform_radii(2 * s, s, 8));
  }

  static AP::Grid_3 grid(const Surface& surface, double voxels)
  {
    const CGAL::Bbox_3 b = surface.bbox();
    return AP::grid_around(b, std::max({b.x_span(), b.y_span(), b.z_span()}) / voxels);
  }

  std::string name() const
  {
    const auto& size = region.grid().size();
    return std::to_string(vertices) + " vertices, " + std::to_string(size[0]) + " x " +
           std::to_string(size[1]) + " x " + std::to_string(size[2]) + " voxels";
  }
};

/// computes all scales into a joint map; the work of one iteration.
template <class ConcurrencyTag = CGAL::Sequential_tag, class MakeProjector>
void run(const Job& job, const AP::Row_spans& region, MakeProjector make_projector)
{
  const std::shared_ptr<const AP::Row_spans> shared(std::shared_ptr<void>(), &region);
  AP::Joint_map map(shared, job.scales);
  AP::project_scales<ConcurrencyTag>(job.surface, region, job.scales, AP::Side::INSIDE,
                                     make_projector, map);
  benchmark::DoNotOptimize(map.values().data());
}

template <class MakeProjector>
std::vector<std::vector<float>> maps(const Job& job, MakeProjector make_projector)
{
  AP::Scale_maps_sink sink(job.region, job.scales.size());
  AP::project_scales(job.surface, job.region, job.scales, AP::Side::INSIDE, make_projector, sink);
  return sink.maps();
}

using Maps = std::vector<std::vector<float>>;

/// the relative root mean square error of each scale, in percent: the mean and the largest.
std::pair<double, double> errors(const Maps& maps, const Maps& exact)
{
  double sum = 0, largest = 0;
  for(std::size_t k = 0; k < maps.size(); ++k) {
    double difference = 0, norm = 0;
    for(std::size_t v = 0; v < maps[k].size(); ++v) {
      difference += std::pow(double(maps[k][v]) - exact[k][v], 2);
      norm += std::pow(double(exact[k][v]), 2);
    }
    const double error = 100 * std::sqrt(difference / norm);
    sum += error / double(maps.size());
    largest = std::max(largest, error);
  }
  return {sum, largest};
}

struct Times
{
  double cpu = 0, wall = 0; // milliseconds
};

/// prints the times as they come and keeps them for the ratios.
class Reporter : public benchmark::ConsoleReporter
{
public:
  std::map<std::string, Times> times;

  void ReportRuns(const std::vector<Run>& runs) override
  {
    ConsoleReporter::ReportRuns(runs);
    for(const Run& run : runs)
      times[run.run_name.function_name] = {run.GetAdjustedCPUTime(), run.GetAdjustedRealTime()};
  }
};

template <class Work>
void add(const std::string& name, Work work)
{
  benchmark::RegisterBenchmark(name.c_str(),
                               [work](benchmark::State& state) {
                                 for(auto _ : state)
                                   work();
                               })
      ->Unit(benchmark::kMillisecond)
      ->UseRealTime()
      ->MinTime(0.5);
}

auto grid_projector(const AP::Row_spans& region, double sampling_ratio)
{
  return [&region, sampling_ratio] {
    return AP::Grid_projector(region, AP::Ball_kernel_3().nested_balls(), sampling_ratio);
  };
}

const std::vector<double>& sampling_ratios()
{
  static const std::vector<double> ratios{1., 0.6, AP::Grid_projector::default_sampling_ratio};
  return ratios;
}

std::string grid_name(const Job& job, double ratio)
{
  return job.name() + "/grid, sampling " + std::to_string(ratio).substr(0, 4);
}

void add_job(const Job& job)
{
  add(job.name() + "/paper",
      [&job] { run(job, job.box, [&job] { return AP::Paper_grid_projector(job.box); }); });
  for(double ratio : sampling_ratios())
    add(grid_name(job, ratio),
        [&job, ratio] { run(job, job.region, grid_projector(job.region, ratio)); });
#ifdef CGAL_LINKED_WITH_TBB
  add(job.name() + "/grid, all threads", [&job] {
    run<CGAL::Parallel_tag>(job, job.region,
                            grid_projector(job.region, AP::Grid_projector::default_sampling_ratio));
  });
#endif
  add(job.name() + "/exact",
      [&job] { run(job, job.region, [&job] { return AP::Exact_grid_projector(job.region); }); });
}

/// CPU times for what runs in one thread: other work on the machine disturbs them least.
void print_ratios(const Job& job, std::map<std::string, Times>& times)
{
  const Maps exact = maps(job, [&job] { return AP::Exact_grid_projector(job.region); });
  const double paper = times[job.name() + "/paper"].cpu;
  const auto row = [&](const std::string& name, const std::string& benchmark_name, const Maps& m) {
    const auto [mean, largest] = errors(m, exact);
    std::cout << "  " << std::left << std::setw(24) << name << std::right << std::fixed
              << std::setprecision(1) << std::setw(10) << times[benchmark_name].cpu << std::setw(12)
              << paper / times[benchmark_name].cpu << std::setprecision(2) << std::setw(12) << mean
              << std::setw(12) << largest << "\n";
  };
  std::cout << "\n"
            << job.name() << ", 8 scales, interior\n"
            << "  method                          ms  paper/this   error mean %       max %\n";
  row("paper", job.name() + "/paper",
      maps(job, [&job] { return AP::Paper_grid_projector(job.region); }));
  for(double ratio : sampling_ratios())
    row("grid, sampling " + std::to_string(ratio).substr(0, 4), grid_name(job, ratio),
        maps(job, grid_projector(job.region, ratio)));
  row("exact", job.name() + "/exact", exact);
  const double one = times[grid_name(job, AP::Grid_projector::default_sampling_ratio)].wall;
  if(const double all = times[job.name() + "/grid, all threads"].wall; all > 0)
    std::cout << "  wall time, one thread / all threads: " << one / all << "\n";
}

Mesh read_mesh(const std::string& file)
{
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(file, mesh) || mesh.is_empty())
    throw std::runtime_error(file + ": cannot be read as a mesh");
  return mesh;
}

} // namespace

int main(int argc, char** argv)
{
  benchmark::Initialize(&argc, argv);
  std::cout << "CGAL " << CGAL_VERSION_STR << ", compiler " << __VERSION__ << "\n";
  std::vector<std::string> files(argv + 1, argv + argc);
  if(files.empty())
    files.push_back(AREA_PROJECTION_TRANSFORM_DATA "/hand.obj");

  std::vector<std::unique_ptr<Job>> jobs;
  for(const std::string& file : files) {
    Mesh mesh = read_mesh(file);
    jobs.push_back(std::make_unique<Job>(mesh, 50));
    while(mesh.number_of_vertices() < 170000)
      CGAL::Subdivision_method_3::Loop_subdivision(mesh);
    jobs.push_back(std::make_unique<Job>(mesh, 256));
  }
  for(const auto& job : jobs)
    add_job(*job);
  Reporter reporter;
  benchmark::RunSpecifiedBenchmarks(&reporter);
  for(const auto& job : jobs)
    print_ratios(*job, reporter.times);
}
