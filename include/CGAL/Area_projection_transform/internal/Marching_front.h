// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_MARCHING_FRONT_H
#define CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_MARCHING_FRONT_H

#include <CGAL/Area_projection_transform/Row_spans.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL {
namespace Area_projection {
namespace internal {

/// \brief solves `Σ c (T - t)² = right` for the larger root `T`, over up to three axes.
///
/// For each axis a difference against the wind: `c (T - t)²`.
struct Upwind_equation
{
  void add(double c, double t)
  {
    // Times are counted from the first of them, or squares of late ones would leave no digits.
    if(number++ == 0)
      origin = t;
    a += c;
    b += c * (t - origin);
    d += c * (t - origin) * (t - origin);
  }

  /// the root; less than anything if there is none.
  double solve(double right) const
  {
    const double discriminant = b * b - a * (d - right);
    return discriminant >= 0 ? origin + (b + std::sqrt(discriminant)) / a
                             : -std::numeric_limits<double>::infinity();
  }

  int number = 0;
  double origin = 0, a = 0, b = 0, d = 0;
};

/// \brief the front of the fast marching method.
///
/// A heap of voxels next to those that are done, by time, of equal ones by their place in storage. A voxel that
/// got an earlier time is in the heap more than once, and its later times are skipped.
class Marching_front
{
public:
  using Voxel = std::array<int, 3>;

  Marching_front(const Row_spans& region, const std::vector<float>& speeds, bool is_second_order)
      : m_region(region)
      , m_speeds(speeds)
      , m_is_second_order(is_second_order)
      , m_times(region.storage_size(), never)
      , m_states(region.storage_size(), State::WALL)
  {
    for(std::size_t row = 0; row < region.number_of_rows(); ++row) {
      const Row_spans::Hull& hull = region.hull(row);
      const auto [begin, end] = region.runs(row);
      for(auto run = begin; run != end; ++run)
        for(std::int32_t i = run->first; i < run->last; ++i) {
          const std::size_t place = hull.offset + std::size_t(i - hull.first);
          if(speeds[place] > 0)
            m_states[place] = State::AHEAD;
        }
    }
  }

  /// the voxel keeps this time, the earliest of those that it is given.
  void start(const Voxel& voxel, double time)
  {
    m_states[place_of(voxel)] = State::SOURCE;
    offer(voxel, time);
  }

  /// marches until everything is reached, or the target is.
  void march(const std::optional<Voxel>& target)
  {
    while(!m_heap.empty()) {
      const Entry entry = m_heap.top();
      m_heap.pop();
      if(m_states[entry.place] == State::DONE)
        continue;
      m_states[entry.place] = State::DONE;
      if(target && entry.voxel == *target)
        break;
      for(std::size_t axis = 0; axis < 3; ++axis)
        for(const int step : {-1, 1}) {
          const Voxel next = neighbour(entry.voxel, axis, step);
          const std::size_t place = place_of(next);
          if(place < m_states.size() && m_states[place] == State::AHEAD)
            offer(next, time_from_neighbours(next, place));
        }
    }
  }

  /// the times, infinite for what the front did not reach.
  std::vector<double> take_times()
  {
    for(std::size_t place = 0; place < m_times.size(); ++place)
      if(m_states[place] != State::DONE)
        m_times[place] = never;
    return std::move(m_times);
  }

private:
  static constexpr double never = std::numeric_limits<double>::infinity();

  enum class State : std::uint8_t { WALL, SOURCE, AHEAD, DONE };

  struct Entry
  {
    double time;
    std::size_t place;
    Voxel voxel;

    /// the heap has the greatest at its top.
    friend bool operator<(const Entry& a, const Entry& b)
    {
      return a.time != b.time ? a.time > b.time : a.place > b.place;
    }
  };

  /// what is done along an axis, on the side from which the front comes.
  struct Wind
  {
    double near = never; ///< the time of the next voxel
    double far = never;  ///< that of the one behind it
  };

  static Voxel neighbour(Voxel voxel, std::size_t axis, int step)
  {
    voxel[axis] += step;
    return voxel;
  }

  std::size_t place_of(const Voxel& v) const { return m_region.index(v[0], v[1], v[2]); }

  double time_done(const Voxel& voxel) const
  {
    const std::size_t place = place_of(voxel);
    return place < m_states.size() && m_states[place] == State::DONE ? m_times[place] : never;
  }

  void offer(const Voxel& voxel, double time)
  {
    const std::size_t place = place_of(voxel);
    if(!(time < m_times[place]))
      return;
    m_times[place] = time;
    m_heap.push({time, place, voxel});
  }

  /// the axes along which something is done, the earliest first.
  struct Winds
  {
    std::array<Wind, 3> along;
    std::size_t number = 0;

    void insert(const Wind& wind)
    {
      std::size_t i = number++;
      for(; i > 0 && wind.near < along[i - 1].near; --i)
        along[i] = along[i - 1];
      along[i] = wind;
    }
  };

  Winds winds_at(const Voxel& voxel) const
  {
    Winds winds;
    for(std::size_t axis = 0; axis < 3; ++axis) {
      const double before = time_done(neighbour(voxel, axis, -1));
      const double after = time_done(neighbour(voxel, axis, 1));
      const double near = std::min(before, after);
      if(near < never)
        winds.insert({near, time_done(neighbour(voxel, axis, before <= after ? -2 : 2))});
    }
    return winds;
  }

  double time_from_neighbours(const Voxel& voxel, std::size_t place) const
  {
    const Winds winds = winds_at(voxel);
    const double step = m_region.grid().spacing() / double(m_speeds[place]);
    if(m_is_second_order) {
      const double time = second_order_time(winds, step * step);
      if(time >= winds.along[winds.number - 1].near)
        return time;
    }
    return first_order_time(winds, step * step);
  }

  /// the axes count that the front comes along: those with times before its own.
  static double first_order_time(const Winds& winds, double right)
  {
    Upwind_equation equation;
    double time = never;
    for(std::size_t i = 0; i < winds.number && winds.along[i].near < time; ++i) {
      equation.add(1, winds.along[i].near);
      time = equation.solve(right);
    }
    return time;
  }

  /// over all axes, with differences `(3T - 4 near + far) / 2` where times rise towards the voxel.
  static double second_order_time(const Winds& winds, double right)
  {
    Upwind_equation equation;
    for(std::size_t i = 0; i < winds.number; ++i) {
      const auto& [near, far] = winds.along[i];
      if(far <= near)
        equation.add(2.25, near + (near - far) / 3);
      else
        equation.add(1, near);
    }
    return equation.solve(right);
  }

  const Row_spans& m_region;
  const std::vector<float>& m_speeds;
  bool m_is_second_order;
  std::vector<double> m_times;
  std::vector<State> m_states;
  std::priority_queue<Entry> m_heap;
};

} // namespace internal
} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_MARCHING_FRONT_H
