// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_MEDIAL_COMPLEX_DUAL_COMPLEX_H
#define CGAL_AREA_PROJECTION_TRANSFORM_MEDIAL_COMPLEX_DUAL_COMPLEX_H

#include <CGAL/Area_projection_transform/Kernel.h>
#include <CGAL/Area_projection_transform/internal/Disjoint_sets.h>
#include <CGAL/Area_projection_transform/medial_complex/Betti_numbers.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Fixed_alpha_shape_3.h>
#include <CGAL/Fixed_alpha_shape_cell_base_3.h>
#include <CGAL/Fixed_alpha_shape_vertex_base_3.h>
#include <CGAL/Regular_triangulation_3.h>
#include <CGAL/Triangulation_cell_base_with_info_3.h>
#include <CGAL/Triangulation_data_structure_3.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Area_projection {
namespace internal {

/// \brief which balls overlap in the surface of their union: a simplex for each set of two, three or four whose cells of the
/// power diagram meet within the union.
///
/// It has the homotopy type of the union (Edelsbrunner 1995): the alpha complex of the weighted points, for `α = 0`. All
/// decisions are exact.
class Dual_complex
{
public:
  using Edge = std::array<std::uint32_t, 2>;
  using Triangle = std::array<std::uint32_t, 3>;
  using Tetrahedron = std::array<std::uint32_t, 4>;

  std::vector<std::uint32_t> vertices; ///< balls that are not within the union of others, ascending
  std::vector<Edge> edges; ///< all simplices have ascending indices, and are in ascending order
  std::vector<Triangle> triangles;
  std::vector<Tetrahedron> tetrahedra;
  Betti_numbers topology;

  Dual_complex(const std::vector<Point_3>& centers, const std::vector<double>& radii)
  {
    const std::vector<std::uint32_t> balls = different_balls(centers, radii);
    if(balls.empty())
      return;
    Triangulation triangulation = triangulated(centers, radii, balls);
    const Shape shape(triangulation, 0);
    collect(shape);
    count(shape);
  }

private:
  using Exact = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Vertex_base = CGAL::Fixed_alpha_shape_vertex_base_3<
      Exact, CGAL::Triangulation_vertex_base_with_info_3<
                 std::uint32_t, Exact, CGAL::Regular_triangulation_vertex_base_3<Exact>>>;
  using Cell_base = CGAL::Fixed_alpha_shape_cell_base_3<
      Exact, CGAL::Triangulation_cell_base_with_info_3<
                 std::size_t, Exact, CGAL::Regular_triangulation_cell_base_3<Exact>>>;
  using Triangulation =
      CGAL::Regular_triangulation_3<Exact,
                                    CGAL::Triangulation_data_structure_3<Vertex_base, Cell_base>>;
  using Shape = CGAL::Fixed_alpha_shape_3<Triangulation>;

  static constexpr std::uint32_t no_ball = 0xffffffffu;

  /// those that have a radius, one of all that have the same centre: the largest.
  static std::vector<std::uint32_t> different_balls(const std::vector<Point_3>& centers,
                                                    const std::vector<double>& radii)
  {
    std::vector<std::uint32_t> balls;
    for(std::size_t i = 0; i < centers.size(); ++i)
      if(radii[i] > 0)
        balls.push_back(std::uint32_t(i));
    std::sort(balls.begin(), balls.end(), [&](std::uint32_t i, std::uint32_t j) {
      return std::tie(centers[i], radii[j], i) < std::tie(centers[j], radii[i], j);
    });
    balls.erase(
        std::unique(balls.begin(), balls.end(),
                    [&](std::uint32_t i, std::uint32_t j) { return centers[i] == centers[j]; }),
        balls.end());
    return balls;
  }

  /// \brief the regular triangulation of balls, and of four points far away from them, so that it has three
  /// dimensions.
  ///
  /// What is in the complex does not depend on these: their weight is negative, so that they are not in the complex, and a
  /// sphere that is orthogonal to balls with a common point has no positive squared radius to reach them.
  static Triangulation triangulated(const std::vector<Point_3>& centers,
                                    const std::vector<double>& radii,
                                    const std::vector<std::uint32_t>& balls)
  {
    using Weighted_point = Exact::Weighted_point_3;
    CGAL::Bbox_3 box;
    std::vector<std::pair<Weighted_point, std::uint32_t>> points;
    for(const std::uint32_t i : balls) {
      const Exact::Point_3 center(centers[i].x(), centers[i].y(), centers[i].z());
      points.emplace_back(Weighted_point(center, radii[i] * radii[i]), i);
      box += Exact::Sphere_3(center, radii[i] * radii[i]).bbox();
    }
    const double far =
        10 * std::max({box.xmax() - box.xmin(), box.ymax() - box.ymin(), box.zmax() - box.zmin()});
    const Exact::Point_3 middle((box.xmin() + box.xmax()) / 2, (box.ymin() + box.ymax()) / 2,
                                (box.zmin() + box.zmax()) / 2);
    for(const auto& [x, y, z] :
        {std::tuple(far, far, far), {far, -far, -far}, {-far, far, -far}, {-far, -far, far}})
      points.emplace_back(Weighted_point(middle + Exact::Vector_3(x, y, z), -far * far), no_ball);
    return Triangulation(points.begin(), points.end());
  }

  template <std::size_t size>
  static std::array<std::uint32_t, size> sorted(std::array<std::uint32_t, size> simplex)
  {
    std::sort(simplex.begin(), simplex.end());
    return simplex;
  }

  template <class Simplex>
  static bool is_inside(const Shape& shape, const Simplex& simplex)
  {
    return shape.classify(simplex) != Shape::EXTERIOR;
  }

  void collect(const Shape& shape)
  {
    for(auto v = shape.finite_vertices_begin(); v != shape.finite_vertices_end(); ++v)
      if(is_inside(shape, Shape::Vertex_handle(v)))
        vertices.push_back(v->info());
    for(auto e = shape.finite_edges_begin(); e != shape.finite_edges_end(); ++e)
      if(is_inside(shape, *e)) {
        const auto ball = [&e](int i) { return e->first->vertex(i)->info(); };
        edges.push_back(sorted(Edge{ball(e->second), ball(e->third)}));
      }
    for(auto f = shape.finite_facets_begin(); f != shape.finite_facets_end(); ++f)
      if(is_inside(shape, *f)) {
        const auto ball = [&f](int i) { return f->first->vertex((f->second + i) % 4)->info(); };
        triangles.push_back(sorted(Triangle{ball(1), ball(2), ball(3)}));
      }
    for(auto c = shape.finite_cells_begin(); c != shape.finite_cells_end(); ++c)
      if(is_inside(shape, Shape::Cell_handle(c))) {
        const auto ball = [&c](int i) { return c->vertex(i)->info(); };
        tetrahedra.push_back(sorted(Tetrahedron{ball(0), ball(1), ball(2), ball(3)}));
      }
    std::sort(vertices.begin(), vertices.end());
    std::sort(edges.begin(), edges.end());
    std::sort(triangles.begin(), triangles.end());
    std::sort(tetrahedra.begin(), tetrahedra.end());
  }

  void count(const Shape& shape)
  {
    const auto place = [this](std::uint32_t ball) {
      return std::size_t(std::lower_bound(vertices.begin(), vertices.end(), ball) -
                         vertices.begin());
    };
    Disjoint_sets pieces(vertices.size());
    for(const Edge& edge : edges)
      pieces.unite(place(edge[0]), place(edge[1]));
    topology.components = long(pieces.number());
    topology.cavities = long(number_of_outer_parts(shape)) - 1;
    const long euler_number = long(vertices.size()) - long(edges.size()) + long(triangles.size()) -
                              long(tetrahedra.size());
    topology.loops = topology.components + topology.cavities - euler_number;
  }

  /// the parts of what is not in the complex: cells that are neighbours across facets that are not, either.
  static std::size_t number_of_outer_parts(const Shape& shape)
  {
    std::size_t number = 0;
    const auto is_outside = [&](Shape::Cell_handle c) {
      return shape.is_infinite(c) || !is_inside(shape, c);
    };
    for(auto c = shape.all_cells_begin(); c != shape.all_cells_end(); ++c)
      if(is_outside(c))
        c->info() = number++;
    Disjoint_sets parts(number);
    for(auto f = shape.all_facets_begin(); f != shape.all_facets_end(); ++f) {
      const Shape::Cell_handle a = f->first, b = a->neighbor(f->second);
      if(is_outside(a) && is_outside(b) && (shape.is_infinite(*f) || !is_inside(shape, *f)))
        parts.unite(a->info(), b->info());
    }
    return parts.number();
  }
};

} // namespace internal
} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_MEDIAL_COMPLEX_DUAL_COMPLEX_H
