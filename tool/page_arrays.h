// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MAPT_PAGE_ARRAYS_H
#define MAPT_PAGE_ARRAYS_H

#include <CGAL/Area_projection_transform/Kernel.h>
#include <CGAL/Bbox_3.h>

#include <nlohmann/json.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace mapt {

/// \brief the arrays of a page, which become one block of compressed bytes.
///
/// Each function appends an array and returns what the page needs to know to read it again
/// (`viewer/src/payload.js`): its type, the place of its first byte and the number of its elements.
class Page_arrays
{
public:
  using Json = nlohmann::ordered_json;

  /// \param box coordinates are rounded to 65536 places along its longest side
  explicit Page_arrays(const CGAL::Bbox_3& box);

  /// exact to the last bit of a float.
  Json add_floats(const std::vector<float>& values);
  /// as differences to the element `stride` before, which are small where neighbours are alike.
  Json add_integers(const std::vector<std::uint32_t>& values, std::size_t stride);
  /// rounded; the coordinates of a point one after the other.
  Json add_points(const std::vector<CGAL::Area_projection::Point_3>& points);
  /// the voxels of a grid, as differences to their neighbours along x and y.
  Json add_voxels(std::vector<std::uint8_t> voxels, const std::array<int, 3>& size);

  /// the places that coordinates are rounded to, for the page.
  Json lattice() const;
  double step() const { return m_step; }

  /// all bytes, compressed (zlib) and as letters (base 64).
  std::string encoded() const;

private:
  Json begin(const char* type, std::size_t number) const;

  std::array<double, 3> m_origin;
  double m_step;
  std::string m_bytes;
};

} // namespace mapt

#endif // MAPT_PAGE_ARRAYS_H
