// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef AREA_PROJECTION_BENCHMARK_PROJECTORS_H
#define AREA_PROJECTION_BENCHMARK_PROJECTORS_H

#include "benchmark_shapes.h"
#include "benchmark_suite.h"

#include <CGAL/Area_projection_transform/Joint_map.h>
#include <CGAL/Area_projection_transform/internal/simd/instruction_set.h>
#include <CGAL/Area_projection_transform/multiscale.h>
#include <CGAL/Area_projection_transform/projection/Exact_grid_projector.h>
#include <CGAL/Area_projection_transform/projection/Grid_projector.h>
#include <CGAL/Area_projection_transform/projection/Paper_grid_projector.h>

#include <cmath>
#include <memory>

namespace Benchmarks {

/// \name Functions that make projectors
/// The region must outlive what they return.
/// @{
inline auto grid_projector(const AP::Row_spans& region, double sampling_ratio)
{
  return [&region, sampling_ratio] {
    return AP::Grid_projector(region, AP::Ball_kernel_3().nested_balls(), sampling_ratio);
  };
}

inline auto grid_projector(const AP::Row_spans& region)
{
  return grid_projector(region, AP::Grid_projector::default_sampling_ratio);
}

inline auto exact_projector(const AP::Row_spans& region)
{
  return [&region] { return AP::Exact_grid_projector(region); };
}

inline auto paper_projector(const AP::Row_spans& region)
{
  return [&region] { return AP::Paper_grid_projector(region); };
}
/// @}

/// the number of voxels in a ball of a radius in voxels, about.
inline double size_of_ball(double radius)
{
  return 4.19 * std::pow(radius, 3);
}

/// \brief how many times as long direct sums over balls take as one reads the paper, at most, compared with
/// tuned ones.
constexpr double slowness_of_literal = 12;

/// computes all scales into a joint map of the region.
template <class ConcurrencyTag = CGAL::Sequential_tag, class ScaleSpace, class MakeProjector>
void compute_joint_map(const ScaleSpace& surface, const AP::Row_spans& region,
                       const std::vector<AP::Scale>& scales, MakeProjector make_projector)
{
  const std::shared_ptr<const AP::Row_spans> shared(std::shared_ptr<void>(), &region);
  AP::Joint_map map(shared, scales);
  AP::project_scales<ConcurrencyTag>(surface, region, scales, AP::Side::INSIDE, make_projector,
                                     map);
  keep(map.values().data());
}

/// the work of a row: what `compute_joint_map()` does for a job.
template <class MakeProjector>
Comparison::Work joint_map_of(const Job& job, MakeProjector make_projector)
{
  return [&job, make_projector] {
    compute_joint_map(job.surface, job.region, job.scales, make_projector);
  };
}

/// the same work with another instruction set.
inline Comparison::Work with(AP::internal::Instruction_set set, Comparison::Work work)
{
  return [set, work = std::move(work)] {
    const AP::internal::Instruction_set before =
        AP::internal::chosen_instruction_set().exchange(set);
    work();
    AP::internal::chosen_instruction_set() = before;
  };
}

} // namespace Benchmarks

#endif // AREA_PROJECTION_BENCHMARK_PROJECTORS_H
