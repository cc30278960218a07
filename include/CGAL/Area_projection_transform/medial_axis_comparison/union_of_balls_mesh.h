// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_MEDIAL_AXIS_COMPARISON_UNION_OF_BALLS_MESH_H
#define CGAL_AREA_PROJECTION_TRANSFORM_MEDIAL_AXIS_COMPARISON_UNION_OF_BALLS_MESH_H

#include <CGAL/Area_projection_transform/Triangle_surface.h>
#include <CGAL/Area_projection_transform/internal/parallel_workers.h>
#include <CGAL/Area_projection_transform/internal/to_text.h>
#include <CGAL/Area_projection_transform/medial_axis_comparison/Medial_representation.h>
#include <CGAL/Area_projection_transform/scales.h>
#include <CGAL/Area_projection_transform/surfels_from_mesh.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Area_projection {

/// \cond SKIP_IN_MANUAL
namespace internal {

/// \brief the boundary of a union of balls in the cells of a lattice: cubes that are cut into six tetrahedra each, all alike.
///
/// What is inside is decided at the nodes alone, so that triangles of neighbours fit together whatever is rounded.
class Ball_lattice
{
public:
  /// of nodes, or of cells by their lowest node.
  using Place = std::array<std::int32_t, 3>;

  struct Cube
  {
    Place low;
    std::int32_t size;                ///< in cells
    std::vector<std::uint32_t> balls; ///< that it meets
  };

  /// triangles whose corners are named by the edges of tetrahedra on which they lie.
  struct Triangles
  {
    std::vector<std::array<std::uint64_t, 3>> triangles;
    std::unordered_map<std::uint64_t, Point_3> corners;
  };

  /// the most cells along a side.
  static constexpr std::int32_t most_cells = 1024;

  Ball_lattice(const Medial_representation& balls, double cell) : m_balls(balls), m_cell(cell)
  {
    for(std::size_t i = 0; i < balls.size(); ++i)
      if(balls.radii[i] > 0)
        m_whole.balls.push_back(std::uint32_t(i));
    if(m_whole.balls.empty())
      return;
    const Bbox_3 box = bbox(balls);
    if(!(cell >= least_cell(balls)))
      throw std::invalid_argument("cell is " + to_text(cell) + ": must be at least " +
                                  to_text(least_cell(balls)) + ", 1/" +
                                  std::to_string(most_cells - 2) + " of the extent of the balls");
    while(m_whole.size < extent(balls) / cell + 2) // nodes on the border are outside
      m_whole.size *= 2;
    const double half = 0.5 * m_whole.size * cell;
    m_origin = {0.5 * (box.xmin() + box.xmax()) - half, 0.5 * (box.ymin() + box.ymax()) - half,
                0.5 * (box.zmin() + box.zmax()) - half};
  }

  /// the longest side of the box around the balls; 0 if there are none.
  static double extent(const Medial_representation& balls)
  {
    const Bbox_3 box = bbox(balls);
    return std::max({box.x_span(), box.y_span(), box.z_span(), 0.});
  }

  /// the least width of cells that there may be.
  static double least_cell(const Medial_representation& balls)
  {
    return extent(balls) / (most_cells - 2);
  }

  const Cube& whole() const { return m_whole; }

  /// calls `function(Cube)` for the cubes of a size within a larger one that may have boundary in them, in a fixed order.
  template <class Function>
  void for_each_cube(const Cube& cube, std::int32_t size, Function&& function) const
  {
    if(cube.size <= size) {
      function(cube);
      return;
    }
    for(int corner = 0; corner < 8; ++corner) {
      Cube child{cube.low, cube.size / 2, {}};
      for(std::size_t axis = 0; axis < 3; ++axis)
        child.low[axis] += (corner >> axis & 1) * child.size;
      if(keep_balls(cube.balls, child))
        for_each_cube(child, size, function);
    }
  }

  /// adds the triangles in a cell.
  void add_cell(const Cube& cell, Triangles& result) const
  {
    std::array<Node, 8> nodes;
    for(std::size_t corner = 0; corner < 8; ++corner)
      nodes[corner] = node(cell, corner);
    if(std::all_of(nodes.begin(), nodes.end(),
                   [&](const Node& n) { return n.is_inside == nodes[0].is_inside; }))
      return;
    // From the lowest corner to the highest along the three axes, in each of six orders.
    static constexpr std::size_t orders[6][2] = {{1, 2}, {2, 4}, {4, 1}, {2, 1}, {4, 2}, {1, 4}};
    for(int i = 0; i < 6; ++i) {
      const std::size_t first = orders[i][0], second = first + orders[i][1];
      add_tetrahedron(cell, {&nodes[0], &nodes[first], &nodes[second], &nodes[7]}, i >= 3, result);
    }
  }

private:
  struct Node
  {
    Place place;
    std::size_t corner; ///< of the cell; one bit for each axis
    std::array<double, 3> point;
    bool is_inside;
  };

  static Bbox_3 bbox(const Medial_representation& balls)
  {
    Bbox_3 box;
    for(std::size_t i = 0; i < balls.size(); ++i)
      if(balls.radii[i] > 0)
        box += Kernel::Sphere_3(balls.centers[i], balls.radii[i] * balls.radii[i]).bbox();
    return box;
  }

  double coordinate(std::size_t axis, std::int32_t place) const
  {
    return m_origin[axis] + place * m_cell;
  }

  /// \brief fills in the balls that a cube meets and needs; returns whether it may have boundary in it.
  ///
  /// Rounding is monotonous: a ball that is left out has no node of the cube inside.
  bool keep_balls(const std::vector<std::uint32_t>& candidates, Cube& cube) const
  {
    for(const std::uint32_t i : candidates) {
      double nearest = 0, farthest = 0;
      for(std::size_t axis = 0; axis < 3; ++axis) {
        const double c = m_balls.centers[i][int(axis)];
        const double low = coordinate(axis, cube.low[axis]) - c,
                     high = coordinate(axis, cube.low[axis] + cube.size) - c;
        const double gap = std::max({low, -high, 0.}), reach = std::max(-low, high);
        nearest += gap * gap;
        farthest += reach * reach;
      }
      const double squared = m_balls.radii[i] * m_balls.radii[i];
      if(farthest < squared)
        return false;
      if(nearest < squared)
        cube.balls.push_back(i);
    }
    drop_surpassed(cube);
    return !cube.balls.empty();
  }

  /// \brief drops the balls of a cube that have nothing in it beside the one with the lowest power in its middle: where
  /// many are nearly the same, as in a sphere, hardly any are left.
  ///
  /// Powers differ by a linear function, by more than is ever rounded all over the cube.
  void drop_surpassed(Cube& cube) const
  {
    if(cube.balls.size() < 2)
      return;
    const double half = 0.5 * cube.size * m_cell;
    const Point_3 middle(coordinate(0, cube.low[0]) + half, coordinate(1, cube.low[1]) + half,
                         coordinate(2, cube.low[2]) + half);
    const auto power = [&](std::uint32_t i) {
      return squared_distance(m_balls.centers[i], middle) - m_balls.radii[i] * m_balls.radii[i];
    };
    std::uint32_t best = cube.balls.front();
    double least = power(best);
    for(const std::uint32_t i : cube.balls)
      if(const double p = power(i); p < least) {
        best = i;
        least = p;
      }
    const double extent = m_whole.size * m_cell, rounded = 1e-12 * extent * extent;
    const auto is_surpassed = [&](std::uint32_t i) {
      const Vector_3 apart = m_balls.centers[i] - m_balls.centers[best];
      const double change =
          2 * half * (std::abs(apart.x()) + std::abs(apart.y()) + std::abs(apart.z()));
      return power(i) - least > change + rounded;
    };
    cube.balls.erase(std::remove_if(cube.balls.begin(), cube.balls.end(), is_surpassed),
                     cube.balls.end());
  }

  Node node(const Cube& cell, std::size_t corner) const
  {
    Node result{cell.low, corner, {}, false};
    for(std::size_t axis = 0; axis < 3; ++axis) {
      result.place[axis] += std::int32_t(corner >> axis & 1);
      result.point[axis] = coordinate(axis, result.place[axis]);
    }
    result.is_inside = std::any_of(cell.balls.begin(), cell.balls.end(), [&](std::uint32_t i) {
      double squared = 0;
      for(std::size_t axis = 0; axis < 3; ++axis) {
        const double d = result.point[axis] - m_balls.centers[i][int(axis)];
        squared += d * d;
      }
      return squared < m_balls.radii[i] * m_balls.radii[i];
    });
    return result;
  }

  /// \param is_mirrored whether the third edge of the tetrahedron is on the other side of the first two
  void add_tetrahedron(const Cube& cell, std::array<const Node*, 4> nodes, bool is_mirrored,
                       Triangles& result) const
  {
    // Those inside come first; each swap mirrors the tetrahedron.
    for(int pass = 0; pass < 3; ++pass)
      for(std::size_t i = 0; i < 3; ++i)
        if(!nodes[i]->is_inside && nodes[i + 1]->is_inside) {
          std::swap(nodes[i], nodes[i + 1]);
          is_mirrored = !is_mirrored;
        }
    const auto corner = [&](std::size_t inside, std::size_t outside) {
      return add_corner(cell, *nodes[inside], *nodes[outside], result);
    };
    const auto add = [&](std::uint64_t a, std::uint64_t b, std::uint64_t c) {
      if(is_mirrored)
        std::swap(b, c);
      result.triangles.push_back({a, b, c});
    };
    switch(std::count_if(nodes.begin(), nodes.end(), [](const Node* n) { return n->is_inside; })) {
    case 1:
      add(corner(0, 1), corner(0, 2), corner(0, 3));
      break;
    case 2:
      add(corner(0, 2), corner(0, 3), corner(1, 3));
      add(corner(0, 2), corner(1, 3), corner(1, 2));
      break;
    case 3:
      add(corner(0, 3), corner(1, 3), corner(2, 3));
      break;
    default:
      break;
    }
  }

  std::uint64_t add_corner(const Cube& cell, const Node& inside, const Node& outside,
                           Triangles& result) const
  {
    const Node& low = inside.corner < outside.corner ? inside : outside;
    std::uint64_t key = 0;
    for(const std::int32_t place : low.place)
      key = key * (most_cells + 1) + std::uint64_t(place);
    key = key * 8 + (inside.corner ^ outside.corner);
    const auto [entry, is_new] = result.corners.emplace(key, Point_3(0, 0, 0));
    if(is_new) {
      const double t = part_inside(cell, inside.point, outside.point);
      const auto between = [&](std::size_t axis) {
        return inside.point[axis] + t * (outside.point[axis] - inside.point[axis]);
      };
      entry->second = Point_3(between(0), between(1), between(2));
    }
    return key;
  }

  /// \brief the part of an edge until it leaves the balls.
  ///
  /// A hundredth of it is kept at both ends, so that no triangle vanishes.
  double part_inside(const Cube& cell, const std::array<double, 3>& from,
                     const std::array<double, 3>& to) const
  {
    double part = 0;
    for(bool is_farther = true; is_farther;) {
      is_farther = false;
      for(const std::uint32_t i : cell.balls) {
        double aa = 0, ab = 0, bb = -m_balls.radii[i] * m_balls.radii[i];
        for(std::size_t axis = 0; axis < 3; ++axis) {
          const double a = to[axis] - from[axis], b = m_balls.centers[i][int(axis)] - from[axis];
          aa += a * a;
          ab += a * b;
          bb += b * b;
        }
        const double root = ab * ab - aa * bb;
        if(!(root > 0))
          continue;
        const double enters = (ab - std::sqrt(root)) / aa, leaves = (ab + std::sqrt(root)) / aa;
        if(enters <= part && leaves > part) {
          part = leaves;
          is_farther = true;
        }
      }
    }
    return std::clamp(part, 0.01, 0.99);
  }

  const Medial_representation& m_balls;
  double m_cell;
  std::array<double, 3> m_origin{};
  Cube m_whole{{0, 0, 0}, 4, {}};
};

/// the triangles of several parts as one soup, corners of the same name as one point.
inline Triangle_surface joined(const std::vector<Ball_lattice::Triangles>& parts)
{
  std::unordered_map<std::uint64_t, std::uint32_t> indices;
  std::vector<Point_3> points;
  std::vector<Triangle_surface::Triangle> triangles;
  for(const Ball_lattice::Triangles& part : parts)
    for(const std::array<std::uint64_t, 3>& corners : part.triangles) {
      Triangle_surface::Triangle& triangle = triangles.emplace_back();
      for(std::size_t i = 0; i < 3; ++i) {
        const auto [entry, is_new] = indices.emplace(corners[i], std::uint32_t(points.size()));
        if(is_new)
          points.push_back(part.corners.at(corners[i]));
        triangle[i] = entry->second;
      }
    }
  return surface_from_triangle_soup(points, triangles);
}

} // namespace internal
/// \endcond

/// \ingroup PkgAreaProjectionTransformMedialComparison
/// \brief returns the boundary of the union of the balls of a representation, as a closed mesh that faces outward.
///
/// Marching tetrahedra on a lattice, of which only the cells near the boundary are looked at. The mesh is a manifold
/// always. Its points lie where edges of the lattice leave the union, but for a hundredth of an edge, so that
///
/// - no point of the mesh is farther from the boundary of the union than a cell is wide (each triangle has corners on the
///   boundary and no edge longer than the diagonal of a cell, √3 of its width);
/// - where the boundary is that of one ball of radius `r`, it is within `cell² / 2r`, inside of the ball;
/// - what is thinner than a cell, spikes and cracks, may be missing: balls without a node of the lattice inside are.
///
/// `CGAL::Union_of_balls_3` gives each ball its own few triangles instead: a single ball has 48, and 22 % of its volume are
/// lost.
/// \tparam ConcurrencyTag `CGAL::Sequential_tag`, `CGAL::Parallel_tag` or `CGAL::Parallel_if_available_tag`; the
/// result does not depend on it, to the last bit
/// \param axis the balls; those without a positive radius have no part in it
/// \param cell the width of the cells of the lattice, in the units of the balls
/// \throw std::invalid_argument if `cell` is not positive and finite, or less than 1/1022 of the longest side of the bounding box
/// of the balls
///
/// Complexity: of the area of the boundary over `cell²`, and of the balls that meet a cell. The hand in 200 balls at a two
/// hundredth of its diagonal takes 0.1 s.
template <class ConcurrencyTag = CGAL::Sequential_tag>
Triangle_surface union_of_balls_mesh(const Medial_representation& axis, double cell)
{
  using Lattice = internal::Ball_lattice;
  internal::check_positive(cell, "cell");
  const Lattice lattice(axis, cell);
  std::vector<Lattice::Cube> cubes;
  lattice.for_each_cube(lattice.whole(), std::max(lattice.whole().size / 16, 1),
                        [&cubes](const Lattice::Cube& cube) { cubes.push_back(cube); });
  std::vector<Lattice::Triangles> parts(cubes.size());
  internal::for_each_index<ConcurrencyTag>(cubes.size(), [&](std::size_t i) {
    lattice.for_each_cube(cubes[i], 1,
                          [&](const Lattice::Cube& c) { lattice.add_cell(c, parts[i]); });
  });
  return internal::joined(parts);
}

} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_MEDIAL_AXIS_COMPARISON_UNION_OF_BALLS_MESH_H
