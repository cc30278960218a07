// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_SHAPE_DESCRIPTOR_SHAPE_DESCRIPTOR_OPTIONS_H
#define CGAL_AREA_PROJECTION_TRANSFORM_SHAPE_DESCRIPTOR_SHAPE_DESCRIPTOR_OPTIONS_H

#include <CGAL/Area_projection_transform/internal/to_text.h>
#include <CGAL/Area_projection_transform/scales.h>

#include <cmath>
#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL {
namespace Area_projection {

/// \ingroup PkgAreaProjectionTransformDescriptors
/// \brief how the values of a map become a histogram.
enum class Binning {
  HARD, ///< a value counts for the bin that it falls into (the paper's)
  SOFT, ///< a value counts for the two bins whose middles are nearest, the more the nearer
  PAIRS ///< pairs of values, at the same voxel and two radii, in a table of soft bins
};

/// \ingroup PkgAreaProjectionTransformDescriptors
/// \brief the normals along which a surface is projected.
enum class Descriptor_normals {
  FACE,         ///< those of the faces: for clean meshes
  INTERPOLATED, ///< those of the vertices, weighted by angles, interpolated on the faces
  /// \brief the same of a surface that is smoothed by one step of the subdivision of Loop, where faces are larger than about
  /// `2s`: for coarse meshes that are noisy or have holes. Finer ones stay as they are.
  SUBDIVIDED,
  AVERAGED, ///< averaged the farther the larger the radius, as by `Averaged_normals`: for fine meshes with noise
  SMOOTHED ///< those of a surface that is smoothed the more the larger the radius: `Mean_curvature_flow`
};

/// \ingroup PkgAreaProjectionTransformDescriptors
/// \brief the choices of `shape_descriptor()`; by default those of the paper (section 6.3), and what it leaves
/// open as it was best for a labelled set of 300 meshes.
struct Shape_descriptor_options
{
  /// \brief how many reference lengths `s` the side of a cube of the volume of the shape has, positive: the paper
  /// says that `s` is proportional to the cube root of the volume, not by which factor.
  ///
  /// It matters more than all other choices, for what it does to the radii: 20 and 40 are worse.
  double scale_divisor = 30;
  /// the radii: `smallest_radius`, `smallest_radius + radius_step`, … up to `largest_radius`, in units of `s`,
  /// positive.
  double smallest_radius = 2;
  double largest_radius = 9; ///< \copydoc smallest_radius
  double radius_step = 1;    ///< \copydoc smallest_radius
  /// the ratio `σ/R`, in (0, 1).
  double sigma_ratio = 0.5;
  /// the size of a voxel in units of `s`, positive.
  double voxel_size = 1;
  /// what histograms count.
  Binning binning = Binning::HARD;
  /// the number of bins at each radius, and, of pairs, for each of the two values; at least 2. The paper's is
  /// 12; that of pairs, which it does not have, is 8.
  std::size_t bins = 12;
  std::size_t bins_of_pair = 8; ///< \copydoc bins
  /// the value at which the last bin ends, positive; larger values count for it as well. Not told in the paper.
  double largest_value = 1;
  /// along which normals the surface is projected.
  Descriptor_normals normals = Descriptor_normals::FACE;
  /// how far `AVERAGED` averages and `SMOOTHED` smooths, as a standard deviation in units of the radius, positive.
  /// Default: that of the scale space.
  std::optional<double> smoothing_ratio;
  /// whether the maps are divided by the coverage, the part of the surface that is seen from inside: 1 for a closed
  /// surface, less if parts of it are missing, which would make the values smaller.
  bool compensate = true;
  /// the spacing of the samples that are projected, in voxels, positive; each triangle has at least one.
  double sample_spacing = 1.5;
};

/// \cond SKIP_IN_MANUAL
namespace internal {

inline void check_bins(std::size_t bins, const char* name)
{
  constexpr std::size_t most = 4096;
  if(bins < 2 || bins > most)
    throw std::invalid_argument(std::string(name) + " is " + std::to_string(bins) +
                                ": must be at least 2 and at most 4096");
}

/// the radii in units of the reference length.
inline std::vector<double> relative_radii(const Shape_descriptor_options& options)
{
  check_positive(options.smallest_radius, "smallest_radius");
  check_positive(options.largest_radius, "largest_radius");
  check_positive(options.radius_step, "radius_step");
  const double steps =
      std::floor((options.largest_radius - options.smallest_radius) / options.radius_step + 1e-9);
  constexpr double most = 1024;
  if(!(steps >= 0 && steps < most))
    throw std::invalid_argument("largest_radius is " + internal::to_text(options.largest_radius) +
                                ": makes " + (steps < 0 ? "no radius" : "more than 1024 radii") +
                                " from smallest_radius " +
                                internal::to_text(options.smallest_radius) + " in steps of " +
                                internal::to_text(options.radius_step));
  return uniform_radii(options.smallest_radius, options.radius_step, std::size_t(steps) + 1);
}

inline void check(const Shape_descriptor_options& options)
{
  check_positive(options.scale_divisor, "scale_divisor");
  check_positive(options.voxel_size, "voxel_size");
  check_positive(options.largest_value, "largest_value");
  check_positive(options.sample_spacing, "sample_spacing");
  check_sigma_ratio(options.sigma_ratio);
  if(options.smoothing_ratio)
    check_positive(*options.smoothing_ratio, "smoothing_ratio");
  check_bins(options.bins, "bins");
  check_bins(options.bins_of_pair, "bins_of_pair");
  const std::size_t radii = relative_radii(options).size();
  if(options.binning == Binning::PAIRS && radii % 2 != 0)
    throw std::invalid_argument("binning is PAIRS for " + std::to_string(radii) +
                                " radii: their number must be even");
}

} // namespace internal
/// \endcond

} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_SHAPE_DESCRIPTOR_SHAPE_DESCRIPTOR_OPTIONS_H
