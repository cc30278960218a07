// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_SHAPE_DESCRIPTOR_H
#define CGAL_AREA_PROJECTION_TRANSFORM_SHAPE_DESCRIPTOR_H

#include <CGAL/Area_projection_transform/Side.h>
#include <CGAL/Area_projection_transform/Surfels.h>
#include <CGAL/Area_projection_transform/Triangle_surface.h>
#include <CGAL/Area_projection_transform/internal/Kept_maps.h>
#include <CGAL/Area_projection_transform/multiscale.h>
#include <CGAL/Area_projection_transform/projection/Paper_grid_projector.h>
#include <CGAL/Area_projection_transform/regions.h>
#include <CGAL/Area_projection_transform/scale_space/Averaged_normals.h>
#include <CGAL/Area_projection_transform/scale_space/Mean_curvature_flow.h>
#include <CGAL/Area_projection_transform/shape_descriptor/Histogram_sinks.h>
#include <CGAL/Area_projection_transform/shape_descriptor/Passed_normals.h>
#include <CGAL/Area_projection_transform/shape_descriptor/Sampled_scale_spaces.h>
#include <CGAL/Area_projection_transform/shape_descriptor/Shape_descriptor_options.h>
#include <CGAL/Area_projection_transform/shape_descriptor/Solid.h>
#include <CGAL/Area_projection_transform/shape_descriptor/loop_subdivision.h>
#include <CGAL/Area_projection_transform/surfels_from_mesh.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <utility>
#include <vector>

namespace CGAL {
namespace Area_projection {

/// \ingroup PkgAreaProjectionTransformDescriptors
/// \brief a shape as some numbers, which hardly change when it moves, bends or grows: the histograms of its maps at
/// some radii (HAPT; paper, section 6.3), and what they were computed with.
struct Shape_descriptor
{
  /// \brief the histograms, those of one radius after those of another; all sum to 1, each of them to the same.
  ///
  /// `block_size` of them belong together: the bins of a radius, or the cells of a pair of radii, row by row.
  std::vector<float> values;
  std::size_t block_size = 0;  ///< how many of `values` belong together
  double reference_length = 0; ///< `s`, in the units of the surface
  double volume = 0;           ///< of the shape, which determines `s`
  /// how much of the surface is seen from inside: 1 if it is closed. The maps were divided by it, if that was wanted.
  double coverage = 0;
  std::size_t number_of_voxels = 0; ///< inside
  std::vector<Scale> scales;        ///< in the units of the surface
};

/// \cond SKIP_IN_MANUAL
namespace internal {

/// appends a histogram, so scaled that it sums to `sum`.
inline void append_scaled(const std::vector<std::int64_t>& histogram, double sum,
                          std::vector<float>& values)
{
  std::int64_t total = 0;
  for(std::int64_t count : histogram)
    total += count;
  for(std::int64_t count : histogram)
    values.push_back(float(double(count) * sum / double(total)));
}

/// \brief computes histograms of a surface inside of a region.
template <class ConcurrencyTag>
class Histogram_maker
{
public:
  Histogram_maker(const Row_spans& region, const std::vector<Scale>& scales, double factor,
                  const Shape_descriptor_options& options)
      : m_region(region), m_scales(scales), m_factor(factor), m_options(options)
  {}

  template <class ScaleSpace>
  std::vector<float> operator()(const ScaleSpace& surface) const
  {
    return m_options.binning == Binning::PAIRS ? pairs(surface) : singles(surface);
  }

private:
  template <class ScaleSpace, class Sink>
  void project(const ScaleSpace& surface, const std::vector<Scale>& scales, Sink& sink) const
  {
    const auto make_projector = [](const Row_spans& part) { return Paper_grid_projector(part); };
    project_scales<ConcurrencyTag>(surface, m_region, scales, Side::INSIDE, make_projector, sink);
  }

  template <class ScaleSpace>
  std::vector<float> singles(const ScaleSpace& surface) const
  {
    Histogram_sink sink(m_scales.size(), Bins(m_options.bins, m_options.largest_value, m_factor),
                        m_options.binning == Binning::SOFT);
    project(surface, m_scales, sink);
    std::vector<float> values;
    for(const auto& histogram : sink.histograms())
      append_scaled(histogram, 1. / double(m_scales.size()), values);
    return values;
  }

  /// the first half of the radii with the second half, one pair at a time: no more than one map is kept.
  template <class ScaleSpace>
  std::vector<float> pairs(const ScaleSpace& surface) const
  {
    const std::size_t half = m_scales.size() / 2;
    const Bins bins(m_options.bins_of_pair, m_options.largest_value, m_factor);
    std::vector<float> map(m_region.storage_size()), values;
    for(std::size_t k = 0; k < half; ++k) {
      Copying_sink first({map.data()});
      project(surface, {m_scales[k]}, first);
      Pair_histogram_sink second(map, bins);
      project(surface, {m_scales[half + k]}, second);
      append_scaled(second.table(), 1. / double(half), values);
    }
    return values;
  }

  const Row_spans& m_region;
  const std::vector<Scale>& m_scales;
  double m_factor;
  const Shape_descriptor_options& m_options;
};

/// the surface with normals that are passed on, unless it is so fine that solving for them is faster.
template <class Use>
auto with_averaged_normals(Triangle_surface surface, const std::vector<Scale>& scales, double ratio,
                           double spacing, Use&& use)
{
  const Passed_normals normals(surface);
  if(normals.number_of_passes(0, ratio * scales.back().radius) > Passed_normals::most_passes)
    return use(Sampled_smoothing_scale_space(Averaged_normals(std::move(surface), ratio), spacing));
  std::vector<double> radii;
  for(const Scale& scale : scales)
    radii.push_back(scale.radius);
  return use(Sampled_averaging_scale_space(surface, normals, std::move(radii), ratio, spacing));
}

/// \brief calls `use(scale_space)` with the surface as the options want it seen at some scales, in samples of some spacing,
/// and returns what that returns.
template <class Use>
auto with_scale_space(Triangle_surface surface, const std::vector<Scale>& scales, double spacing,
                      const Shape_descriptor_options& options, Use&& use)
{
  switch(options.normals) {
  case Descriptor_normals::INTERPOLATED:
  case Descriptor_normals::SUBDIVIDED:
    surface.vertex_normals = angle_weighted_normals(surface);
    break;
  case Descriptor_normals::AVERAGED:
    return with_averaged_normals(
        std::move(surface), scales,
        options.smoothing_ratio.value_or(Averaged_normals<>::default_averaging_ratio), spacing,
        use);
  case Descriptor_normals::SMOOTHED: {
    const double ratio =
        options.smoothing_ratio.value_or(Mean_curvature_flow::default_smoothing_ratio);
    return use(
        Sampled_smoothing_scale_space(Mean_curvature_flow(std::move(surface), ratio), spacing));
  }
  case Descriptor_normals::FACE:
    break;
  }
  return use(Sampled_scale_space(surface, spacing));
}

/// the solid to describe: smoothed by subdivision, if that is wanted and the faces are large.
template <class ConcurrencyTag>
Solid solid_to_describe(const Triangle_surface& surface, const Shape_descriptor_options& options)
{
  Solid solid = make_solid<ConcurrencyTag>(surface);
  if(options.normals != Descriptor_normals::SUBDIVIDED)
    return solid;
  const double edge = 2 * std::cbrt(solid.volume) / options.scale_divisor;
  const double area_of_face = std::sqrt(3.) / 4 * edge * edge;
  if(surface.total_area() <= area_of_face * double(surface.size()))
    return solid;
  return make_solid<ConcurrencyTag>(Loop_subdivision(solid.surface)());
}

} // namespace internal
/// \endcond

/// \ingroup PkgAreaProjectionTransformDescriptors
/// \brief returns the histograms of the area projection transform inside of a shape at some radii (HAPT; paper,
/// section 6.3): by default 96 numbers that tell shapes apart whatever their place, size and articulation.
///
/// A reference length `s` follows from the volume. At the radii `2s`, `3s`, …, `9s` the values `APT / (4πR²)` of the
/// voxels inside, of the size `s`, are counted in 12 bins from 0 to 1. Where the paper leaves a choice open,
/// `Shape_descriptor_options` tells what is taken. What differs from the paper: normals are those of faces by default
/// (the paper smooths progressively: `Descriptor_normals::SMOOTHED`), maps of a surface of which parts are missing
/// are divided by its coverage, and the voxels lie along the principal axes of the surface, so that a turned shape has the
/// same descriptor unless two of its axes are alike. Maps are computed as the paper does (section 5,
/// `Paper_grid_projector`): histograms do not need more accuracy. They are counted as the maps come; no map is
/// kept, of pairs one.
///
/// Shapes are compared by the distances of `retrieval.h`.
///
/// \tparam ConcurrencyTag `CGAL::Sequential_tag`, `CGAL::Parallel_tag` or
/// `CGAL::Parallel_if_available_tag`; the result does not depend on it, to the last bit. Many shapes are better described
/// in parallel, each sequentially.
/// \param surface triangles, facing outward, that enclose a volume, though parts of them may be missing (see
/// `enclosed_volume()`). Where it has vertex normals, `Descriptor_normals::FACE` interpolates those.
/// \param options the choices
/// \throw std::invalid_argument if an option is out of range, or the surface encloses no volume.
///
/// Complexity: for each radius, linear in the number of voxels, of which `scale_divisor³` are inside, and in the area
/// of the surface in voxels, or, if there are more, in the number of faces. Memory: 200 bytes for each face, 60 for each
/// sample of the surface, 4 for each voxel and thread.
template <class ConcurrencyTag = CGAL::Sequential_tag>
Shape_descriptor shape_descriptor(const Triangle_surface& surface,
                                  const Shape_descriptor_options& options = {})
{
  internal::check(options);
  internal::Solid solid = internal::solid_to_describe<ConcurrencyTag>(surface, options);
  Shape_descriptor result;
  result.volume = solid.volume;
  result.reference_length = std::cbrt(solid.volume) / options.scale_divisor;
  std::vector<double> radii = internal::relative_radii(options);
  for(double& radius : radii)
    radius *= result.reference_length;
  result.scales = proportional_scales(radii, options.sigma_ratio);

  const double voxel_size = options.voxel_size * result.reference_length;
  const Interior inside = internal::interior_of<ConcurrencyTag>(solid, voxel_size);
  result.coverage = inside.coverage;
  result.number_of_voxels = inside.region.number_of_voxels();
  if(result.number_of_voxels == 0)
    throw std::invalid_argument("surface encloses no voxel: a voxel is too large for it");

  const internal::Histogram_maker<ConcurrencyTag> histograms(
      inside.region, result.scales, options.compensate ? 1 / inside.coverage : 1, options);
  result.values =
      internal::with_scale_space(std::move(solid.surface), result.scales,
                                 options.sample_spacing * voxel_size, options, histograms);
  result.block_size = options.binning == Binning::PAIRS
                          ? options.bins_of_pair * options.bins_of_pair
                          : options.bins;
  return result;
}

/// \ingroup PkgAreaProjectionTransformDescriptors
/// \brief the same for a mesh.
/// \tparam TriangleMesh a model of `FaceListGraph`
/// \param mesh the mesh, facing outward; in several parts, with holes, as it is
/// \param options the choices
/// \param np the named parameters of `surface_from_mesh()`
/// \throw std::invalid_argument also as `surface_from_mesh()` does
template <class ConcurrencyTag = CGAL::Sequential_tag, class TriangleMesh,
          class NamedParameters = CGAL::parameters::Default_named_parameters>
Shape_descriptor shape_descriptor(const TriangleMesh& mesh,
                                  const Shape_descriptor_options& options = {},
                                  const NamedParameters& np = CGAL::parameters::default_values())
{
  return shape_descriptor<ConcurrencyTag>(surface_from_mesh(mesh, np), options);
}

/// \ingroup PkgAreaProjectionTransformDescriptors
/// \brief refuses points: without faces there is no inside whose voxels could be counted, and no volume. Make a mesh of
/// them first.
/// \throw std::invalid_argument always
template <class ConcurrencyTag = CGAL::Sequential_tag>
Shape_descriptor shape_descriptor(const Surfels& /* points */,
                                  const Shape_descriptor_options& /* options */ = {})
{
  throw std::invalid_argument("points have no faces, and so no inside to be described: must be "
                              "made a mesh first");
}

} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_SHAPE_DESCRIPTOR_H
