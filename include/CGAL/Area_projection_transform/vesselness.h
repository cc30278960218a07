// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_VESSELNESS_H
#define CGAL_AREA_PROJECTION_TRANSFORM_VESSELNESS_H

#include <CGAL/Area_projection_transform/Covariance_3.h>
#include <CGAL/Area_projection_transform/Joint_map.h>
#include <CGAL/Area_projection_transform/Kernel.h>
#include <CGAL/Area_projection_transform/Row_spans.h>
#include <CGAL/Area_projection_transform/internal/hessians.h>
#include <CGAL/Area_projection_transform/internal/symmetric_eigen.h>
#include <CGAL/Area_projection_transform/internal/to_text.h>
#include <CGAL/Area_projection_transform/scales.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Area_projection {

/// \ingroup PkgAreaProjectionTransformRidges
/// \brief the choices of `vesselness()`.
struct Vesselness_options
{
  /// how much a line must differ from a plate (Frangi's `α`): the smaller, the less it must.
  double plate_sensitivity = 0.5;
  /// how much a line must differ from a blob (Frangi's `β`).
  double blob_sensitivity = 0.5;
  /// \brief the norm of the Hessian, in units of the map, at which structure stands out from nothing (Frangi's
  /// `c`).
  ///
  /// Images have no scale of their values, so that half of the largest norm is common there. The map has: it is
  /// 1 in a sphere, whatever its size. With a fixed number the vesselness of one shape can be compared with that of
  /// another, and does not change in a leg when a head is added.
  double structure = 0.05;
  /// \brief how much of the surface is there, in (0, 1], such as `Interior::coverage`: the map is divided by that first.
  ///
  /// With half of the faces removed at random the map is half of what it was, and so is the norm of its Hessian.
  double coverage = 1;
  /// the standard deviation of the Gaussian at a voxel, in units of the radius that the joint map has there.
  double scale_ratio = 0.35;
  /// \brief standard deviations of Gaussians, in units of length; each voxel takes that of the largest vesselness,
  /// of equal ones the smallest. Their order does not matter. Empty: one for each voxel, by `scale_ratio`.
  std::vector<double> scales;
};

/// \ingroup PkgAreaProjectionTransformRidges
/// \brief how much a map looks like a line at each voxel, in which direction, and at which scale.
///
/// Stored as parallel arrays at the places that `Row_spans::index()` gives. 20 bytes for each voxel with
/// storage.
struct Vesselness_map
{
  /// a unit vector.
  using Direction = std::array<float, 3>;

  /// the voxels
  std::shared_ptr<const Row_spans> region;
  /// in [0, 1]
  std::vector<float> values;
  /// \brief unit vectors along the line, of either sign; zero where the value is.
  ///
  /// Where a ball begins (the end of a tube, a joint) there is no direction, and the vector is one of many.
  std::vector<Direction> directions;
  /// the standard deviations of the Gaussians, in units of length; zero where the value is
  std::vector<float> scales;
};

/// \ingroup PkgAreaProjectionTransformRidges
/// \brief returns the vesselness of Frangi et al. (MICCAI 1998) for bright lines, from the eigenvalues of a
/// normalised Hessian, by their magnitude, the smallest first; in [0, 1].
///
/// With `A = |l2 / l3|`, `B = |l1| / √|l2 l3|` and `S = √(l1² + l2² + l3²)` it is
/// `(1 - exp(-A² / 2α²)) exp(-B² / 2β²) (1 - exp(-S² / 2c²))` where `l2` and `l3` are negative, and 0 elsewhere.
/// The coverage divides `S`, as it would the map.
/// \param l the eigenvalues of the Hessian
/// \param options the choices
inline double frangi_vesselness(const std::array<double, 3>& l, const Vesselness_options& options)
{
  if(!(l[1] < 0 && l[2] < 0))
    return 0;
  const auto gaussian = [](double squared, double width) {
    return std::exp(-0.5 * squared / (width * width));
  };
  const double squared_a = (l[1] / l[2]) * (l[1] / l[2]);
  const double squared_b = (l[0] / l[1]) * (l[0] / l[2]);
  const double squared_s = l[0] * l[0] + l[1] * l[1] + l[2] * l[2];
  return (1 - gaussian(squared_a, options.plate_sensitivity)) *
         gaussian(squared_b, options.blob_sensitivity) *
         (1 - gaussian(squared_s, options.structure * options.coverage));
}

/// \cond SKIP_IN_MANUAL
namespace internal {

/// the smallest and largest standard deviation of a Gaussian, in voxels: between voxels there is nothing to see,
/// and work grows with the size.
constexpr double smallest_vesselness_scale = 0.5, largest_vesselness_scale = 100;

inline void check(const Vesselness_options& options, double voxel_size)
{
  check_positive(options.plate_sensitivity, "plate_sensitivity");
  check_positive(options.blob_sensitivity, "blob_sensitivity");
  check_positive(options.structure, "structure");
  check_positive(options.scale_ratio, "scale_ratio");
  if(!(options.coverage > 0 && options.coverage <= 1))
    throw std::invalid_argument("coverage is " + internal::to_text(options.coverage) +
                                ": must be greater than 0 and at most 1");
  for(std::size_t k = 0; k < options.scales.size(); ++k) {
    const double s = options.scales[k] / voxel_size;
    if(!(s >= smallest_vesselness_scale * (1 - 1e-9) && s <= largest_vesselness_scale))
      throw std::invalid_argument("scales[" + std::to_string(k) + "] is " + internal::to_text(s) +
                                  " voxels: must be at least 0.5 and at most 100");
  }
}

/// a Gaussian, and the voxels that it is for.
struct Vesselness_level
{
  double s;                                // in voxels
  std::vector<std::uint8_t> scale_indices; // of the joint map; empty: all voxels
};

/// \brief the Gaussians, the smallest first. Where radii are less than voxels, or more than can be dealt with, they share
/// one.
inline std::vector<Vesselness_level> vesselness_levels(const Joint_map& map,
                                                       const Vesselness_options& options)
{
  const double voxel_size = map.grid().spacing();
  std::vector<Vesselness_level> levels;
  std::vector<double> scales = options.scales;
  std::sort(scales.begin(), scales.end());
  for(const double scale : scales)
    levels.push_back({scale / voxel_size, {}});
  if(!levels.empty())
    return levels;
  for(std::size_t k = 0; k < map.scales().size(); ++k) {
    const double s = std::clamp(options.scale_ratio * map.scales()[k].radius / voxel_size,
                                smallest_vesselness_scale, largest_vesselness_scale);
    if(levels.empty() || levels.back().s != s)
      levels.push_back({s, {}});
    levels.back().scale_indices.push_back(std::uint8_t(k));
  }
  return levels;
}

/// the voxels that a level is for.
inline Row_spans voxels_of(const Vesselness_level& level, const Joint_map& map)
{
  if(level.scale_indices.empty())
    return map.region();
  const std::uint8_t low = level.scale_indices.front(), high = level.scale_indices.back();
  return Row_spans(map.grid(), [&](std::size_t row, std::vector<Row_spans::Run>& runs) {
    const Row_spans::Hull& hull = map.region().hull(row);
    for(std::int32_t i = hull.first; i < hull.last; ++i) {
      const std::uint8_t index = map.scale_indices()[hull.offset + std::size_t(i - hull.first)];
      if(index < low || index > high)
        continue;
      if(!runs.empty() && runs.back().last == i)
        ++runs.back().last;
      else
        runs.push_back({i, i + 1});
    }
  });
}

/// no vesselness is larger, given the norm of the Hessian: most voxels can do without eigenvalues.
inline double largest_vesselness(const Covariance_3& h, const Vesselness_options& options)
{
  const double squared_norm =
      h.xx * h.xx + h.yy * h.yy + h.zz * h.zz + 2 * (h.xy * h.xy + h.xz * h.xz + h.yz * h.yz);
  const double c = options.structure * options.coverage;
  return 1 - std::exp(-0.5 * squared_norm / (c * c));
}

/// takes over the vesselness at a voxel if it is more than before.
inline void improve(Vesselness_map& result, std::size_t voxel, const Covariance_3& hessian,
                    double scale, const Vesselness_options& options)
{
  // At least two eigenvalues are to be negative, and larger than the other.
  if(!(hessian.trace() < 0 && largest_vesselness(hessian, options) > result.values[voxel]))
    return;
  const float value = float(frangi_vesselness(eigenvalues_by_magnitude(hessian), options));
  if(!(value > result.values[voxel]))
    return;
  const Vector_3 direction = direction_of_smallest(hessian);
  result.values[voxel] = value;
  result.directions[voxel] = {float(direction.x()), float(direction.y()), float(direction.z())};
  result.scales[voxel] = float(scale);
}

} // namespace internal
/// \endcond

/// \ingroup PkgAreaProjectionTransformRidges
/// \brief returns the vesselness of a joint map (paper, section 6.2): Frangi's measure of the Hessian of the map,
/// smoothed by a Gaussian.
///
/// The paper takes the largest over several scales. The joint map knows better: on the axis of a tube
/// its ridge is about as wide as `σ = cR`, and `R` is in the map; so each voxel has one scale by default, a
/// fixed part of its radius. `Vesselness_options::scales` brings the scan of the paper back.
///
/// Second derivatives are those of the Gaussian, not differences between voxels, and are multiplied by the
/// square of its standard deviation, without which the smallest scale would always win. Outside of the region the
/// map counts as zero.
///
/// \tparam ConcurrencyTag `CGAL::Sequential_tag`, `CGAL::Parallel_tag` or
/// `CGAL::Parallel_if_available_tag`; the result has the same bits for any number of threads
/// \param map the joint map
/// \param options the choices
/// \throw std::invalid_argument if an option is not positive, `coverage` is more than 1, or one of `scales` is less
/// than half a voxel or more than 100. Scales by the radii of the map are kept within these bounds.
///
/// Complexity: for each scale, linear in the number of its voxels times its standard deviation in voxels.
/// Memory: 20 bytes for each voxel with storage; for each thread `10s + 4` layers of the box.
template <class ConcurrencyTag = CGAL::Sequential_tag>
Vesselness_map vesselness(const Joint_map& map, const Vesselness_options& options = {})
{
  const double voxel_size = map.grid().spacing();
  internal::check(options, voxel_size);
  const std::size_t size = map.region().storage_size();
  Vesselness_map result{map.shared_region(), std::vector<float>(size, 0.f),
                        std::vector<Vesselness_map::Direction>(size),
                        std::vector<float>(size, 0.f)};
  for(const internal::Vesselness_level& level : internal::vesselness_levels(map, options)) {
    const Row_spans wanted = internal::voxels_of(level, map);
    internal::for_each_hessian_row<ConcurrencyTag>(
        map.region(), map.values(), wanted, level.s,
        [&](const internal::Derivative_row& row, float factor) {
          const auto [begin, end] = wanted.runs(wanted.grid().row(row.j, row.k));
          const std::size_t first = map.region().index(begin->first, row.j, row.k);
          for(auto run = begin; run != end; ++run)
            for(std::int32_t i = run->first; i < run->last; ++i) {
              const auto& d = row.derivatives;
              const std::size_t place = std::size_t(i - row.first);
              const Covariance_3 hessian{d[0][place], d[3][place], d[4][place],
                                         d[1][place], d[5][place], d[2][place]};
              internal::improve(result, first + place, factor * hessian, level.s * voxel_size,
                                options);
            }
        });
  }
  return result;
}

} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_VESSELNESS_H
