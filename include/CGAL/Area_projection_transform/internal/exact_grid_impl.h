// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// A kernel, included once for each instruction set; see exact_grid.h.
//
// Which voxels a triangle concerns is found for many rows side by side, then the areas for many voxels.
// All coordinates are in voxels, relative to a voxel near the triangle, but for those of disks: these
// are in units of the radius of the ball.

#include <CGAL/Area_projection_transform/internal/triangle_disk_impl.h>

namespace CGAL {
namespace Area_projection {
namespace internal {
namespace CGAL_AREA_PROJECTION_ISA {

/// \brief a box of voxels around the voxel `base`: `low`, …, `high - 1` on each axis, relative to it.
///
/// Near the middle of a tile floats resolve a millionth of a voxel, however large the triangle is.
struct Tile
{
  static constexpr int largest_size[3] = {32, 16, 16};
  static constexpr int most_rows = largest_size[1] * largest_size[2];
  static constexpr int most_voxels = largest_size[0] * most_rows;

  int base[3], low[3], high[3];
};

/// the coordinates of voxels relative to the base of a tile, 10 bits each, above -512.
template <class Integers>
struct Packed_coordinates
{
  Integers value;

  Integers x() const { return (value & 1023) - 512; }
  Integers y() const { return (value >> 10 & 1023) - 512; }
  Integers z() const { return (value >> 20) - 512; }

  /// of the voxel with `x == 0`.
  static std::int32_t row(int y, int z) { return 512 + ((y + 512) << 10) + ((z + 512) << 20); }
};

/// \brief rows of voxels; where arrays are written whole vectors at a time, there is room for one more.
///
/// The voxels `low`, …, `high - 1` belong to the hull of the row and to the tile, relative to its base.
/// The balls around the voxels `first`, …, `last - 1` may reach the triangle, those around `held_first`,
/// …, `held_last - 1` hold it.
struct Rows
{
  static constexpr int capacity = 1024 + Tile::most_rows + lanes;

  int size = 0;
  std::int32_t coordinates[capacity], places[capacity]; ///< of the voxel 0
  std::int32_t low[capacity], high[capacity];
  std::int32_t first[capacity], last[capacity], held_first[capacity], held_last[capacity];
};

/// voxels that are to be evaluated, and what they get.
struct Rim
{
  static constexpr int capacity = 2048 + Tile::most_voxels + lanes;

  int size = 0;
  std::int32_t coordinates[capacity], places[capacity], quanta[capacity];
};

/// a triangle, and what is to be done for it in one tile: some of the rows, some of the rim.
struct Task
{
  const Voting_triangle* triangle;
  Tile tile;
  int first_row, last_row;
  int first_voxel, last_voxel;
};

/// \brief finds the rows of a tile whose voxels a triangle may concern.
inline void find_rows(const Task& task, double radius, const Exact_target& target, Rows& rows)
{
  const Tile& tile = task.tile;
  const Flat_triangle& triangle = task.triangle->shape;
  const Point_3 center = triangle.centroid();
  const float y = float(center.y() - tile.base[1]), z = float(center.z() - tile.base[2]);
  // No corner is farther from the centroid.
  const float reach = float((radius + triangle.longest_edge() * 2 / 3) * (1 + 1e-6));
  int size = rows.size;
  for(int k = tile.low[2]; k < tile.high[2]; ++k)
    for(int j = tile.low[1]; j < tile.high[1]; j += lanes) {
      const int row = tile.base[1] + j + target.size[1] * (tile.base[2] + k);
      const Ints low = max(load(target.first + row) - tile.base[0], all(tile.low[0]));
      const Ints high = min(load(target.last + row) - tile.base[0], all(tile.high[0]));
      const Floats step = all(float(j)) + steps(), dy = step - y;
      const float dz = float(k) - z;
      const unsigned found =
          mask((low < high) & (step < float(tile.high[1])) & (dy * dy < reach * reach - dz * dz));
      store_selected(low, found, rows.low + size);
      store_selected(high, found, rows.high + size);
      store_selected(load(target.place + row) + tile.base[0], found, rows.places + size);
      store_selected(all(Packed_coordinates<Ints>::row(j, k)) + (int_steps() << 10), found,
                     rows.coordinates + size);
      size += number_of_bits(found);
    }
  rows.size = size;
}

/// \brief finds in each row the voxels whose balls hold or may reach a triangle.
///
/// A ball holds the triangle if it holds the corners. If it reaches it, a corner is within the root of
/// `radius² + length²/3`: no point of a triangle is farther than `length/√3` from all its corners, and
/// the nearest point is seen at a right angle, or is a corner, or is on an edge between two.
inline void find_ranges(const Task& task, double radius, Rows& rows)
{
  float x[3], y[3], z[3];
  for(std::size_t c = 0; c < 3; ++c) {
    const Point_3& corner = task.triangle->shape.corners[c];
    x[c] = float(corner.x() - task.tile.base[0]);
    y[c] = float(corner.y() - task.tile.base[1]);
    z[c] = float(corner.z() - task.tile.base[2]);
  }
  // Where rounding decides, the area is computed.
  const double length = task.triangle->shape.longest_edge();
  const float squared_hold = float(radius * radius * (1 - 2e-6));
  const float squared_reach = float((radius * radius + length * length / 3) * (1 + 2e-6));
  for(int row = task.first_row; row < task.last_row; row += lanes) {
    const Packed_coordinates<Ints> coordinates{load(rows.coordinates + row)};
    const Floats row_y = to_floats(coordinates.y()), row_z = to_floats(coordinates.z());
    const Floats none = all(1e9f);
    Floats first = none, last = -none, held_first = -none, held_last = none;
    for(int c = 0; c < 3; ++c) {
      const Floats dy = row_y - y[c], dz = row_z - z[c];
      const Floats squared = dy * dy + dz * dz;
      // The root of a negative number is not a number, and does not change a minimum.
      const Floats reach = sqrt(squared_reach - squared);
      first = min(x[c] - reach, first);
      last = max(x[c] + reach, last);
      const Floats hold = sqrt(max(squared_hold - squared, Floats{}));
      held_first = max(x[c] - hold, held_first);
      held_last = squared > squared_hold ? -none : min(x[c] + hold, held_last);
    }
    const Floats low = to_floats(load(rows.low + row)), high = to_floats(load(rows.high + row));
    // Truncation rounds positive numbers down; the shift makes all positive.
    const auto rounded_down = [&](Floats at) {
      return truncated(min(max(at, low), high) + 512.f) - 512;
    };
    const auto rounded_up = [&](Floats at) {
      return 512 - truncated(512.f - min(max(at, low), high));
    };
    const Ints begin = rounded_up(first), end = max(rounded_down(last + 1.f), begin);
    const Ints held_begin = rounded_up(held_first), held_end = rounded_down(held_last + 1.f);
    const Ints is_held = held_begin < held_end;
    store(begin, rows.first + row);
    store(end, rows.last + row);
    store(is_held ? held_begin : end, rows.held_first + row);
    store(is_held ? held_end : end, rows.held_last + row);
  }
}

/// \brief appends the voxels `first`, …, `last - 1` of a row to a rim that ends at `end`.
/// \return the new end. Vectors are written whole; what is too much is overwritten by the next.
inline int append(Rim& rim, int end, int first, int last, const Rows& rows, int row)
{
  do {
    store(all(rows.coordinates[row] + first) + int_steps(), rim.coordinates + end);
    store(all(rows.places[row] + first) + int_steps(), rim.places + end);
    end += last - first < lanes ? last - first : lanes;
    first += lanes;
  } while(first < last);
  return end;
}

/// \brief adds `quanta` to the voxels whose balls hold the triangle, and appends to the rim those whose
/// balls may reach it.
inline void add_rows(Task& task, const Rows& rows, std::uint32_t quanta, std::uint32_t* runs,
                     Rim& rim)
{
  int end = rim.size;
  for(int row = task.first_row; row < task.last_row; ++row) {
    const int held_first = rows.held_first[row], held_last = rows.held_last[row];
    // Empty ranges do no harm, and fewer branches are mispredicted without tests for them.
    runs[rows.places[row] + held_first] += quanta;
    runs[rows.places[row] + held_last] -= quanta;
    end = append(rim, end, rows.first[row], held_first, rows, row);
    end = append(rim, end, held_last, rows.last[row], rows, row);
  }
  store(Ints{}, rim.coordinates + end); // the last vector is evaluated whole
  task.first_voxel = rim.size;
  task.last_voxel = end;
  rim.size = end;
}

/// \brief a triangle as the disks see it in which balls around voxels meet its plane.
template <class Lanes>
class Disk_view
{
public:
  Disk_view(const Flat_triangle& triangle, double radius, const Tile& tile)
      : m_doubled_area(Number(triangle.doubled_area / (radius * radius)))
  {
    const double unit = 1 / radius;
    const Vector_3 corner = triangle.corners[0] - Point_3(tile.base[0], tile.base[1], tile.base[2]);
    const double x = corner * triangle.x_axis, y = corner * triangle.y_axis;
    m_height = Number(corner * triangle.normal * unit);
    for(int axis = 0; axis < 3; ++axis) {
      m_x[axis] = Number(-triangle.x_axis[axis] * unit);
      m_y[axis] = Number(-triangle.y_axis[axis] * unit);
      m_z[axis] = Number(-triangle.normal[axis] * unit);
    }
    for(std::size_t i = 0; i < 3; ++i) {
      const Flat_triangle::Seen_edge edge = triangle.seen_edge(i, x, y);
      m_start[i] = Number(edge.start * unit);
      m_end[i] = Number((edge.start + triangle.lengths[i]) * unit);
      m_edge_height[i] = Number(edge.height * unit);
      m_along[i] = Number(triangle.directions[i][0]);
      m_across[i] = Number(triangle.directions[i][1]);
      m_length[i] = Number(triangle.lengths[i] * unit);
      m_cosine[i] = Number(triangle.cosines[i]);
      m_sine[i] = Number(triangle.sines[i]);
    }
  }

  /// twice the area within the balls around voxels, in units of the squared radius.
  template <class Way>
  Lanes doubled_area(Lanes i, Lanes j, Lanes k) const
  {
    const Lanes x = i * all(m_x[0]) + j * all(m_x[1]) + k * all(m_x[2]);
    const Lanes y = i * all(m_y[0]) + j * all(m_y[1]) + k * all(m_y[2]);
    const Lanes height = i * all(m_z[0]) + j * all(m_z[1]) + k * all(m_z[2]) + all(m_height);
    Edges<Lanes> edges;
    Seen_edges<Lanes> seen;
    for(int e = 0; e < 3; ++e) {
      edges.length[e] = all(m_length[e]);
      edges.cosine[e] = all(m_cosine[e]);
      edges.sine[e] = all(m_sine[e]);
      // The first edge points along the axis.
      const Lanes along = e == 0 ? x : x * all(m_along[e]) + y * all(m_across[e]);
      const Lanes across = e == 0 ? -y : x * all(m_across[e]) - y * all(m_along[e]);
      seen.start[e] = along + all(m_start[e]);
      seen.end[e] = along + all(m_end[e]);
      seen.height[e] = across + all(m_edge_height[e]);
    }
    return min(doubled_area_within_disk<Way>(edges, seen, all(Number(1)) - height * height),
               all(m_doubled_area));
  }

private:
  using Number = typename Lanes_traits<Lanes>::Number;

  // Of the base of the tile, and how they change along the axes of the grid.
  Number m_start[3], m_end[3], m_edge_height[3], m_height;
  Number m_x[3], m_y[3], m_z[3];
  Number m_along[3], m_across[3];
  Number m_length[3], m_cosine[3], m_sine[3];
  Number m_doubled_area;
};

/// computes what the voxels of a task get. What is too much is overwritten by the next.
template <class Way, class Lanes>
inline void evaluate(const Task& task, const Weighted_ball& ball, Rim& rim)
{
  const Flat_triangle& triangle = task.triangle->shape;
  const Disk_view<Lanes> view(triangle, ball.radius, task.tile);
  const Lanes factor = all_of<Lanes>(task.triangle->quanta * ball.weight * ball.radius *
                                     ball.radius / triangle.doubled_area);
  const Lanes many = all_of<Lanes>(Fixed_point::many), half = all_of<Lanes>(0.5);
  const Lanes dither = all_of<Lanes>(task.triangle->dither);
  using Integers = typename Lanes_traits<Lanes>::Integers;
  for(int v = task.first_voxel; v < task.last_voxel; v += Lanes_traits<Lanes>::size) {
    const Packed_coordinates<Integers> at{load_integers<Lanes>(rim.coordinates + v)};
    const Lanes quanta = factor * view.template doubled_area<Way>(
                                      to_numbers(at.x()), to_numbers(at.y()), to_numbers(at.z()));
    store(truncated(quanta + (quanta > many ? half : dither)), rim.quanta + v);
  }
}

/// \brief adds the parts of triangles within the balls around voxels.
///
/// Step by step for several triangles: so what one step has computed is there when the next one
/// branches on it.
class Grid_adder
{
public:
  Grid_adder(const Weighted_ball& ball, const Exact_target& target) : m_ball(ball), m_target(target)
  {}

  /// cuts the voxels around a triangle into tiles, most often one.
  void add(const Voting_triangle& triangle)
  {
    int first[3], last[3], width[3];
    for(int axis = 0; axis < 3; ++axis) {
      const auto& c = triangle.shape.corners;
      const double low = std::min({c[0][axis], c[1][axis], c[2][axis]}) - m_ball.radius;
      const double high = std::max({c[0][axis], c[1][axis], c[2][axis]}) + m_ball.radius;
      const int limit = m_target.size[std::size_t(axis)];
      if(!(low < limit && high >= 0))
        return;
      first[axis] = low > 0 ? int(std::ceil(low)) : 0;
      last[axis] = high < limit ? int(high) + 1 : limit;
      if(first[axis] >= last[axis])
        return;
      const int tiles = (last[axis] - first[axis] - 1) / Tile::largest_size[axis] + 1;
      width[axis] = (last[axis] - first[axis] - 1) / tiles + 1;
    }
    int begin[3], end[3];
    const auto next = [&](int axis) {
      begin[axis] = end[axis];
      end[axis] = std::min(end[axis] + width[axis], last[axis]);
      return begin[axis] < end[axis];
    };
    for(end[2] = first[2]; next(2);)
      for(end[1] = first[1]; next(1);)
        for(end[0] = first[0]; next(0);)
          start_task(triangle, begin, end);
  }

  /// does what has been put off.
  void finish()
  {
    for(int t = 0; t < m_number_of_tasks; ++t)
      find_ranges(m_tasks[t], m_ball.radius, m_rows);
    int first = 0;
    for(int t = 0; t < m_number_of_tasks; ++t) {
      const Voting_triangle& triangle = *m_tasks[t].triangle;
      add_rows(m_tasks[t], m_rows,
               Fixed_point::rounded(triangle.quanta * m_ball.weight, triangle.dither),
               m_target.runs, m_rim);
      if(m_rim.size > Rim::capacity - Tile::most_voxels - lanes) {
        add_rim(first, t + 1);
        first = t + 1;
      }
    }
    add_rim(first, m_number_of_tasks);
    m_number_of_tasks = 0;
    m_rows.size = 0;
  }

private:
  static constexpr int most_tasks = 32;

  /// puts off what is to be done in the tile `first`, …, `last - 1`.
  void start_task(const Voting_triangle& triangle, const int* first, const int* last)
  {
    Task& task = m_tasks[m_number_of_tasks++];
    task.triangle = &triangle;
    for(int axis = 0; axis < 3; ++axis) {
      const int base = (first[axis] + last[axis]) / 2;
      task.tile.base[axis] = base;
      task.tile.low[axis] = first[axis] - base;
      task.tile.high[axis] = last[axis] - base;
    }
    task.first_row = m_rows.size;
    find_rows(task, m_ball.radius, m_target, m_rows);
    task.last_row = m_rows.size;
    if(m_number_of_tasks == most_tasks || m_rows.size > Rows::capacity - Tile::most_rows - lanes)
      finish();
  }

  void add_rim(int first_task, int last_task)
  {
    for(int t = first_task; t < last_task; ++t) {
      const Flat_triangle& triangle = m_tasks[t].triangle->shape;
      if(triangle.least_height() < m_ball.radius / 64)
        evaluate<Along_the_edges, Doubles>(m_tasks[t], m_ball, m_rim);
      else if(triangle.longest_edge() < 2 * m_ball.radius)
        evaluate<Along_the_edges, Floats>(m_tasks[t], m_ball, m_rim);
      else
        evaluate<Between_the_ends, Floats>(m_tasks[t], m_ball, m_rim);
    }
    for(int v = 0; v < m_rim.size; ++v)
      m_target.voxels[m_rim.places[v]] += std::uint32_t(m_rim.quanta[v]);
    m_rim.size = 0;
  }

  const Weighted_ball m_ball;
  const Exact_target m_target;
  int m_number_of_tasks = 0;
  Task m_tasks[most_tasks];
  Rows m_rows;
  Rim m_rim;
};

inline void add_triangles(const Voting_triangle* begin, const Voting_triangle* end,
                          const Weighted_ball& ball, const Exact_target& target)
{
  Grid_adder adder(ball, target);
  for(const Voting_triangle* t = begin; t != end; ++t)
    adder.add(*t);
  adder.finish();
}

} // namespace CGAL_AREA_PROJECTION_ISA
} // namespace internal
} // namespace Area_projection
} // namespace CGAL
