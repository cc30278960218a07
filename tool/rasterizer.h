// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MAPT_RASTERIZER_H
#define MAPT_RASTERIZER_H

#include <array>
#include <cstddef>
#include <limits>
#include <vector>

namespace mapt {

/// a point of the page: pixels to the right and downward, and how near it is to the viewer.
struct Page_point
{
  double x, y;
  double nearness = 0;
};

/// finds out which of many triangles and disks is seen at each pixel (a buffer of depths).
///
/// A pixel is covered if its centre is; what is nearer hides what is farther, and of two that are as near,
/// the first is seen. What lies off the page is cut away.
class Rasterizer
{
public:
  /// \param width,height the size of the page in pixels
  Rasterizer(int width, int height);

  int width() const { return m_width; }
  int height() const { return m_height; }

  /// a triangle, of either orientation.
  /// \param shade what the pixels get that show it
  void add_triangle(const std::array<Page_point, 3>& corners, float shade);

  /// a disk that faces the viewer.
  void add_disk(const Page_point& centre, double radius, float shade);

  bool is_covered(int x, int y) const
  {
    return x >= 0 && y >= 0 && x < m_width && y < m_height && m_nearness[index(x, y)] > nothing;
  }

  /// \pre the pixel is covered
  float shade(int x, int y) const { return m_shade[index(x, y)]; }
  float nearness(int x, int y) const { return m_nearness[index(x, y)]; }

private:
  static constexpr float nothing = -std::numeric_limits<float>::infinity();

  std::size_t index(int x, int y) const
  {
    return std::size_t(x) + std::size_t(m_width) * std::size_t(y);
  }

  void put(int x, int y, double nearness, float shade)
  {
    const std::size_t i = index(x, y);
    if(float(nearness) > m_nearness[i]) {
      m_nearness[i] = float(nearness);
      m_shade[i] = shade;
    }
  }

  int m_width;
  int m_height;
  std::vector<float> m_nearness;
  std::vector<float> m_shade;
};

} // namespace mapt

#endif // MAPT_RASTERIZER_H
