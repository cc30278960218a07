// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "page_arrays.h"

#include "base64.h"

#include <CGAL/Area_projection_transform/internal/zlib_streams.h>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace mapt {

namespace {

constexpr double places = 65535;

// Small differences of either sign as small numbers: 0, -1, 1, -2, 2, … become 0, 1, 2, 3, 4, ….
std::uint32_t folded(std::uint32_t difference)
{
  return difference << 1 ^ (difference >> 31 ? ~0u : 0u);
}

} // namespace

Page_arrays::Page_arrays(const CGAL::Bbox_3& box)
    : m_origin{box.xmin(), box.ymin(), box.zmin()}
    , m_step(std::max({box.x_span(), box.y_span(), box.z_span()}) / places)
{
  if(!(m_step > 0))
    m_step = 1; // of a single place
}

Page_arrays::Json Page_arrays::begin(const char* type, std::size_t number) const
{
  return {{"type", type}, {"offset", m_bytes.size()}, {"number", number}};
}

Page_arrays::Json Page_arrays::add_floats(const std::vector<float>& values)
{
  const Json entry = begin("floats", values.size());
  for(const float value : values) {
    std::uint32_t bits;
    std::memcpy(&bits, &value, sizeof bits);
    for(int byte = 0; byte < 4; ++byte)
      m_bytes += char(bits >> (8 * byte) & 255);
  }
  return entry;
}

Page_arrays::Json Page_arrays::add_integers(const std::vector<std::uint32_t>& values,
                                            std::size_t stride)
{
  Json entry = begin("integers", values.size());
  entry["stride"] = stride;
  // The lowest bytes of all, then the next ones: the high ones are mostly zero.
  for(int byte = 0; byte < 4; ++byte)
    for(std::size_t i = 0; i < values.size(); ++i) {
      const std::uint32_t before = i < stride ? 0 : values[i - stride];
      m_bytes += char(folded(values[i] - before) >> (8 * byte) & 255);
    }
  return entry;
}

Page_arrays::Json Page_arrays::add_points(const std::vector<CGAL::Area_projection::Point_3>& points)
{
  std::vector<std::uint32_t> coordinates;
  coordinates.reserve(3 * points.size());
  for(const auto& point : points)
    for(int axis = 0; axis < 3; ++axis) {
      // Balls may lie outside of the box; the differences wrap around, as the page has it, too.
      const double place = std::round((point[axis] - m_origin[axis]) / m_step);
      coordinates.push_back(std::uint32_t(std::int32_t(std::clamp(place, -1e9, 1e9))));
    }
  Json entry = add_integers(coordinates, 3);
  entry["type"] = "points";
  return entry;
}

Page_arrays::Json Page_arrays::add_voxels(std::vector<std::uint8_t> voxels,
                                          const std::array<int, 3>& size)
{
  Json entry = begin("voxels", voxels.size());
  entry["size"] = size;
  const std::size_t row = std::size_t(size[0]), layer = row * std::size_t(size[1]);
  // From the last voxel on, so that the neighbours are still themselves.
  for(std::size_t i = voxels.size(); i-- > 0;)
    if(i % row > 0)
      voxels[i] = std::uint8_t(voxels[i] - voxels[i - 1]);
  for(std::size_t i = voxels.size(); i-- > 0;)
    if(i % layer >= row)
      voxels[i] = std::uint8_t(voxels[i] - voxels[i - row]);
  m_bytes.append(voxels.begin(), voxels.end());
  return entry;
}

Page_arrays::Json Page_arrays::lattice() const
{
  return {{"origin", m_origin}, {"step", m_step}};
}

std::string Page_arrays::encoded() const
{
  using namespace CGAL::Area_projection::IO::internal;
  std::string compressed;
  const auto append = [&](const char* bytes, std::size_t number) {
    compressed.append(bytes, number);
  };
  Deflater deflater(6, Zlib_wrapper::ZLIB);
  deflater.append(m_bytes.data(), m_bytes.size(), append);
  deflater.finish(append);
  return to_base64(compressed);
}

} // namespace mapt
