// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_SURFELS_H
#define CGAL_AREA_PROJECTION_TRANSFORM_SURFELS_H

#include <CGAL/Area_projection_transform/Kernel.h>

#include <CGAL/Bbox_3.h>

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Area_projection {

/// \ingroup PkgAreaProjectionTransformInput
/// \brief oriented area elements: all that the sampled forms of the transform know of a surface.
///
/// Stored as parallel arrays. The source of a surfel is the index of the face or of the point of
/// the input that it stands for, in the order in which the input lists them.
/// \cgalModels `SurfelSource`
struct Surfels
{
  std::vector<Point_3> positions;     ///< the middles of the elements
  std::vector<Vector_3> normals;      ///< unit vectors that point outward
  std::vector<double> areas;          ///< not negative
  std::vector<std::uint32_t> sources; ///< the face or point of the input of each

  /// the number of surfels.
  std::size_t size() const { return positions.size(); }
  /// whether there are none.
  bool empty() const { return positions.empty(); }

  /// removes all surfels, and keeps the memory.
  void clear()
  {
    positions.clear();
    normals.clear();
    areas.clear();
    sources.clear();
  }

  /// takes the memory for some surfels.
  void reserve(std::size_t number)
  {
    positions.reserve(number);
    normals.reserve(number);
    areas.reserve(number);
    sources.reserve(number);
  }

  /// adds a surfel.
  void push_back(const Point_3& position, const Vector_3& normal, double area, std::uint32_t source)
  {
    positions.push_back(position);
    normals.push_back(normal);
    areas.push_back(area);
    sources.push_back(source);
  }

  /// adds all surfels of another set, with their sources as they are.
  void append(const Surfels& other)
  {
    positions.insert(positions.end(), other.positions.begin(), other.positions.end());
    normals.insert(normals.end(), other.normals.begin(), other.normals.end());
    areas.insert(areas.end(), other.areas.begin(), other.areas.end());
    sources.insert(sources.end(), other.sources.begin(), other.sources.end());
  }

  /// the sum of the areas.
  double total_area() const { return std::accumulate(areas.begin(), areas.end(), 0.); }

  /// the bounding box of the positions.
  Bbox_3 bbox() const
  {
    Bbox_3 box;
    for(const Point_3& p : positions)
      box += p.bbox();
    return box;
  }

  /// \brief hands all surfels to `sink(const Surfels&)` in one batch.
  ///
  /// The surfels are what they are: the spacing that is asked for has no effect.
  template <class BatchSink>
  void for_each_batch(double /* spacing */, BatchSink&& sink) const
  {
    sink(*this);
  }
};

} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_SURFELS_H
