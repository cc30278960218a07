// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_SHAPE_DESCRIPTOR_SAMPLED_SCALE_SPACES_H
#define CGAL_AREA_PROJECTION_TRANSFORM_SHAPE_DESCRIPTOR_SAMPLED_SCALE_SPACES_H

#include <CGAL/Area_projection_transform/Projected_surfels.h>
#include <CGAL/Area_projection_transform/Side.h>
#include <CGAL/Area_projection_transform/Surfels.h>
#include <CGAL/Area_projection_transform/Triangle_surface.h>
#include <CGAL/Area_projection_transform/shape_descriptor/Passed_normals.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Area_projection {

/// \cond SKIP_IN_MANUAL
namespace internal {

/// hands projected samples to a sink, batch by batch.
template <class BatchSink>
void project_samples(const Surfels& samples, double distance, BatchSink& sink)
{
  Batcher<Projected_surfels, BatchSink> batcher(sink);
  for(std::size_t i = 0; i < samples.size(); ++i)
    batcher.push_back(samples.positions[i] + distance * samples.normals[i], samples.areas[i]);
  batcher.flush();
}

/// \brief a surface that is sampled once, for all radii: what the paper does. For some radii of some voxels that is
/// less work than the hierarchy of `Constant_scale_space` takes to be built.
/// \cgalModels `SurfelScaleSpace`
class Sampled_scale_space
{
public:
  Sampled_scale_space(const Triangle_surface& surface, double spacing)
      : m_area(surface.total_area()), m_box(surface.bbox())
  {
    m_samples.reserve(surface.size());
    for(std::size_t t = 0; t < surface.size(); ++t)
      surface.for_each_surfel_of_triangle(
          t, spacing, [&](const Point_3& position, const Vector_3& normal, double area) {
            m_samples.push_back(position, normal, area, std::uint32_t(t));
          });
  }

  /// the samples, with the triangles that they lie on as their sources.
  const Surfels& samples() const { return m_samples; }

  double area(double /* radius */) const { return m_area; }
  Bbox_3 bbox() const { return m_box; }

  template <class BatchSink>
  void project(double radius, Side side, double /* spacing */, BatchSink&& sink) const
  {
    project_samples(m_samples, signed_distance(side, radius), sink);
  }

private:
  Surfels m_samples;
  double m_area;
  Bbox_3 m_box;
};

/// \brief a surface that is sampled once, with normals that were passed on for each of some radii.
/// \cgalModels `SurfelScaleSpace` for these radii, but that `area()` is a bound
class Sampled_averaging_scale_space
{
public:
  /// \param radii ascending
  /// \param ratio the deviation of the neighbourhood, in units of the radius
  Sampled_averaging_scale_space(const Triangle_surface& surface, const Passed_normals& normals,
                                std::vector<double> radii, double ratio, double spacing)
      : m_sampled(surface, spacing), m_radii(std::move(radii))
  {
    std::vector<double> deviations;
    for(double radius : m_radii)
      deviations.push_back(ratio * radius);
    m_seen = normals(deviations);
  }

  double area(double radius) const { return m_sampled.area(radius); }
  Bbox_3 bbox() const { return m_sampled.bbox(); }

  template <class BatchSink>
  void project(double radius, Side side, double /* spacing */, BatchSink&& sink) const
  {
    const auto place = std::find(m_radii.begin(), m_radii.end(), radius);
    const Passed_normals::Seen& seen = m_seen[std::size_t(place - m_radii.begin())];
    const Surfels& samples = m_sampled.samples();
    const double distance = signed_distance(side, radius);
    Batcher<Projected_surfels, BatchSink> batcher(sink);
    for(std::size_t i = 0; i < samples.size(); ++i) {
      const std::uint32_t t = samples.sources[i];
      batcher.push_back(samples.positions[i] + distance * seen.normals[t],
                        samples.areas[i] * double(seen.shares[t]));
    }
    batcher.flush();
  }

private:
  Sampled_scale_space m_sampled;
  std::vector<double> m_radii;
  std::vector<Passed_normals::Seen> m_seen;
};

/// \brief the surface that a smoother makes for each radius, sampled. It is made anew whenever it is asked for.
/// \tparam Smoother a model of `SurfaceSmoother` for triangles that lets no triangle vote with more than its area
/// \cgalModels `SurfelScaleSpace`, but that `area()` is a bound
template <class Smoother>
class Sampled_smoothing_scale_space
{
public:
  Sampled_smoothing_scale_space(Smoother smoother, double spacing)
      : m_smoother(std::move(smoother))
      , m_spacing(spacing)
      , m_area(m_smoother.source().total_area())
  {}

  double area(double /* radius */) const { return m_area; }
  Bbox_3 bbox() const { return m_smoother.source().bbox(); }

  template <class BatchSink>
  void project(double radius, Side side, double /* spacing */, BatchSink&& sink) const
  {
    project_samples(sample_surfels(m_smoother(radius), m_spacing), signed_distance(side, radius),
                    sink);
  }

private:
  Smoother m_smoother;
  double m_spacing, m_area;
};

} // namespace internal
/// \endcond

} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_SHAPE_DESCRIPTOR_SAMPLED_SCALE_SPACES_H
