// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_BENCHMARK_DIRECT_PROJECTORS_H
#define CGAL_AREA_PROJECTION_TRANSFORM_BENCHMARK_DIRECT_PROJECTORS_H

#include <CGAL/Area_projection_transform/projection/Paper_grid_projector.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace baselines {

namespace AP = CGAL::Area_projection;

/// sums over balls as one reads the paper: for every voxel, a loop over the cube around the ball, with
/// a test of the distance.
class Literal_convolution
{
public:
  Literal_convolution(const AP::Grid_3& grid, int squared_radius)
      : m_grid(grid)
      , m_squared_radius(squared_radius)
      , m_votes(grid.number_of_voxels(), 0)
      , m_sums(grid.number_of_voxels(), 0)
  {}

  std::int32_t* row(int j, int k) { return m_votes.data() + place(j, k); }
  const std::int32_t* sums(int j, int k) const { return m_sums.data() + place(j, k); }

  void convolve()
  {
    const auto& size = m_grid.size();
    for(int k = 0; k < size[2]; ++k)
      for(int j = 0; j < size[1]; ++j)
        for(int i = 0; i < size[0]; ++i)
          m_sums[place(j, k) + std::size_t(i)] = sum_around(i, j, k);
  }

private:
  std::size_t place(int j, int k) const { return m_grid.row(j, k) * std::size_t(m_grid.size()[0]); }

  std::int32_t sum_around(int i, int j, int k) const
  {
    const auto& size = m_grid.size();
    const int r = AP::internal::floor_of_root(m_squared_radius);
    std::int32_t sum = 0;
    for(int z = -r; z <= r; ++z)
      for(int y = -r; y <= r; ++y)
        for(int x = -r; x <= r; ++x)
          if(x * x + y * y + z * z <= m_squared_radius && i + x >= 0 && i + x < size[0] &&
             j + y >= 0 && j + y < size[1] && k + z >= 0 && k + z < size[2])
            sum += m_votes[place(j + y, k + z) + std::size_t(i + x)];
    return sum;
  }

  AP::Grid_3 m_grid;
  int m_squared_radius;
  std::vector<std::int32_t> m_votes, m_sums;
};

/// the same with a margin of zeros around the grid and a list of the voxels of the ball: no test is left.
class Tuned_convolution
{
public:
  Tuned_convolution(const AP::Grid_3& grid, int squared_radius)
      : m_grid(grid)
      , m_margin(AP::internal::floor_of_root(squared_radius))
      , m_stride_y(std::size_t(grid.size()[0] + 2 * m_margin))
      , m_stride_z(m_stride_y * std::size_t(grid.size()[1] + 2 * m_margin))
      , m_votes(m_stride_z * std::size_t(grid.size()[2] + 2 * m_margin), 0)
      , m_sums(grid.number_of_voxels(), 0)
  {
    for(int k = -m_margin; k <= m_margin; ++k)
      for(int j = -m_margin; j <= m_margin; ++j)
        for(int i = -m_margin; i <= m_margin; ++i)
          if(i * i + j * j + k * k <= squared_radius)
            m_steps.push_back(i + std::ptrdiff_t(m_stride_y) * j + std::ptrdiff_t(m_stride_z) * k);
  }

  std::int32_t* row(int j, int k) { return m_votes.data() + padded_place(j, k); }
  const std::int32_t* sums(int j, int k) const { return m_sums.data() + place(j, k); }

  void convolve()
  {
    const auto& size = m_grid.size();
    for(int k = 0; k < size[2]; ++k)
      for(int j = 0; j < size[1]; ++j) {
        const std::int32_t* const votes = m_votes.data() + padded_place(j, k);
        std::int32_t* const sums = m_sums.data() + place(j, k);
        for(int i = 0; i < size[0]; ++i) {
          std::int32_t sum = 0;
          for(const std::ptrdiff_t step : m_steps)
            sum += votes[i + step];
          sums[i] = sum;
        }
      }
  }

private:
  std::size_t place(int j, int k) const { return m_grid.row(j, k) * std::size_t(m_grid.size()[0]); }

  std::size_t padded_place(int j, int k) const
  {
    return std::size_t(m_margin) + m_stride_y * std::size_t(j + m_margin) +
           m_stride_z * std::size_t(k + m_margin);
  }

  AP::Grid_3 m_grid;
  int m_margin;
  std::size_t m_stride_y, m_stride_z;
  std::vector<std::int32_t> m_votes, m_sums;
  std::vector<std::ptrdiff_t> m_steps;
};

/// \brief the paper's algorithm by one of these convolutions, of the whole grid, whatever the region.
///
/// Areas are integers as in `Paper_grid_projector`, so that answers can be compared bit by bit; sums of
/// integers take no longer than sums of floats.
/// \cgalModels `GridProjector`
template <class Convolution>
class Direct_paper_projector
{
public:
  explicit Direct_paper_projector(const AP::Row_spans& region) : m_region(region) {}

  template <class ScaleSpace, class Cancelled>
  double project(const ScaleSpace& surface, const AP::Scale& scale, AP::Side side, Cancelled&&)
  {
    const AP::Grid_3& grid = m_region.grid();
    const AP::internal::Fixed_point fixed(surface.area(scale.radius));
    m_quantum = fixed.quantum();
    m_convolution.emplace(grid,
                          AP::internal::largest_squared_distance(scale.sigma / grid.spacing()));
    double area_outside = 0;
    std::array<int, 3> voxel;
    surface.project(scale.radius, side, grid.spacing(), [&](const AP::Projected_surfels& batch) {
      for(std::size_t s = 0; s < batch.size(); ++s)
        if(AP::internal::find_nearest_voxel(grid, 1 / grid.spacing(), batch.positions[s], voxel))
          m_convolution->row(voxel[1], voxel[2])[voxel[0]] +=
              std::int32_t(fixed.dithered(batch.areas[s], batch.positions[s]));
        else
          area_outside += batch.areas[s];
    });
    m_convolution->convolve();
    return area_outside;
  }

  void take_row(std::size_t row, float* out) const
  {
    const std::size_t rows = std::size_t(m_region.grid().size()[1]);
    const AP::Row_spans::Hull& hull = m_region.hull(row);
    const std::int32_t* const sums = m_convolution->sums(int(row % rows), int(row / rows));
    for(int i = hull.first; i < hull.last; ++i)
      out[i - hull.first] = float(double(float(sums[i])) * m_quantum);
  }

private:
  const AP::Row_spans& m_region;
  std::optional<Convolution> m_convolution;
  double m_quantum = 0;
};

} // namespace baselines

#endif // CGAL_AREA_PROJECTION_TRANSFORM_BENCHMARK_DIRECT_PROJECTORS_H
