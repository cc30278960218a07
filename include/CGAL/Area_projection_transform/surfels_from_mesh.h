// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_SURFELS_FROM_MESH_H
#define CGAL_AREA_PROJECTION_TRANSFORM_SURFELS_FROM_MESH_H

#include <CGAL/Area_projection_transform/Triangle_surface.h>
#include <CGAL/Area_projection_transform/internal/to_text.h>
#include <CGAL/Area_projection_transform/lengths.h>
#include <CGAL/Area_projection_transform/parameters.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <unordered_map>
#include <vector>

namespace CGAL {
namespace Area_projection {

/// \cond SKIP_IN_MANUAL
namespace internal {

/// \brief sums the normals of the triangles at each point, weighted by the angle there
/// (Thürmer and Wüthrich: the result does not depend on how the surface is cut into triangles).
inline std::vector<Vector_3> angle_weighted_normals(const Triangle_surface& surface)
{
  std::vector<Vector_3> sums(surface.points.size(), Vector_3(0, 0, 0));
  for(std::size_t t = 0; t < surface.size(); ++t)
    for(int i = 0; i < 3; ++i) {
      const Vector_3 u = surface.corner(t, (i + 1) % 3) - surface.corner(t, i);
      const Vector_3 v = surface.corner(t, (i + 2) % 3) - surface.corner(t, i);
      const double angle = std::atan2(std::sqrt(cross_product(u, v).squared_length()), u * v);
      Vector_3& sum = sums[surface.triangles[t][i]];
      sum = sum + angle * surface.normals[t];
    }
  for(Vector_3& sum : sums)
    sum = normalized(sum);
  return sums;
}

/// \brief appends a triangle, or counts it as skipped if it has no extent or no normal.
///
/// A null `given_normal` and a negative `given_area` mean "from the geometry".
inline void append_triangle(Triangle_surface& surface, const Triangle_surface::Triangle& triangle,
                            std::size_t source, const Vector_3* given_normal, double given_area)
{
  const Point_3& a = surface.points[triangle[0]];
  const Vector_3 doubled =
      cross_product(surface.points[triangle[1]] - a, surface.points[triangle[2]] - a);
  const double length = std::sqrt(doubled.squared_length());
  const Vector_3 normal = normalized(given_normal ? *given_normal : doubled);
  const double area = given_area < 0 ? 0.5 * length : given_area;
  if(!(length > 0) || !(normal.squared_length() > 0)) {
    ++surface.number_of_skipped_faces;
    return;
  }
  surface.triangles.push_back(triangle);
  surface.normals.push_back(normal);
  surface.areas.push_back(area);
  surface.sources.push_back(std::uint32_t(source));
}

inline void check_number_of_elements(std::size_t number, const char* what)
{
  if(number > std::size_t(std::numeric_limits<std::int32_t>::max()))
    throw std::invalid_argument("the input has " + std::to_string(number) + " " + what +
                                ": at most 2^31 - 1 are supported");
}

/// the unit vector of a given normal, or the null vector, which skips the face or is no normal.
inline Vector_3 checked_normal(const Vector_3& normal, const char* what, std::size_t index)
{
  const double length = std::sqrt(normal.squared_length());
  if(!std::isfinite(length))
    throw std::invalid_argument("the normal of " + std::string(what) + " " + std::to_string(index) +
                                " is not finite");
  return length > 0 ? normal / length : normal;
}

/// the value of a map for a face, or `-1` if the user gave no map.
template <class FaceAreaMap, class Face>
double given_area(const FaceAreaMap& map, const Face& face, std::size_t index)
{
  if constexpr(std::is_same_v<FaceAreaMap, internal_np::Param_not_found>)
    return -1;
  else {
    const double area = CGAL::to_double(get(map, face));
    if(!(area >= 0) || !std::isfinite(area))
      throw std::invalid_argument("face_area_map has the value " + internal::to_text(area) +
                                  " for face " + std::to_string(index) +
                                  ": must be finite and not negative");
    return area;
  }
}

/// the three vertices of a face of a mesh, by their positions in it.
template <class TriangleMesh, class IndexOfVertex>
Triangle_surface::Triangle corners_of_face(
    const TriangleMesh& mesh, typename boost::graph_traits<TriangleMesh>::face_descriptor face,
    std::size_t position, const IndexOfVertex& index_of, const std::vector<Point_3>& points)
{
  Triangle_surface::Triangle triangle{};
  std::size_t degree = 0;
  for(const auto v : vertices_around_face(halfedge(face, mesh), mesh)) {
    const std::uint32_t index = index_of.at(v);
    check_coordinates(points[index], "vertex", index);
    if(degree < 3)
      triangle[degree] = index;
    ++degree;
  }
  if(degree != 3)
    throw std::invalid_argument("face " + std::to_string(position) + " has " +
                                std::to_string(degree) +
                                " vertices: must be a triangle (see "
                                "CGAL::Polygon_mesh_processing::triangulate_faces())");
  return triangle;
}

} // namespace internal
/// \endcond

/// \ingroup PkgAreaProjectionTransformInput
/// \brief reads a triangle mesh into its flat form.
///
/// Open, holed, self-intersecting meshes of any number of components are fine, closed or not;
/// faces without extent, or with a null normal, are skipped and counted. Sources are the positions of
/// the faces in `faces(mesh)`, which are not their indices if the mesh has removed elements. The mesh is only read, sequentially; its maps need not be thread safe.
///
/// \tparam TriangleMesh a model of `FaceListGraph`
/// \tparam NamedParameters a sequence of \cgal's named parameters
///
/// \param mesh the mesh, oriented so that the normals point outward
/// \param np optional named parameters among:
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{vertex_point_map}
///     \cgalParamDescription{the points of the vertices}
///     \cgalParamType{a model of `ReadablePropertyMap` with vertices as key and a point of a model
///                    of `AreaProjectionTraits_3` as value}
///     \cgalParamDefault{`get(CGAL::vertex_point, mesh)`}
///   \cgalParamNEnd
///   \cgalParamNBegin{face_normal_map}
///     \cgalParamDescription{the outward normals of the faces, of any length}
///     \cgalParamType{a model of `ReadablePropertyMap` with faces as key and vectors as value}
///     \cgalParamDefault{computed from the points}
///   \cgalParamNEnd
///   \cgalParamNBegin{face_area_map}
///     \cgalParamDescription{the area each face votes with, in squared units of the mesh}
///     \cgalParamType{a model of `ReadablePropertyMap` with faces as key and numbers as value}
///     \cgalParamDefault{computed from the points}
///     \cgalParamExtra{a parameter of `CGAL::Area_projection::parameters`}
///   \cgalParamNEnd
///   \cgalParamNBegin{vertex_normal_map}
///     \cgalParamDescription{the outward normals of the vertices, to be interpolated on the faces}
///     \cgalParamType{a model of `ReadablePropertyMap` with vertices as key and vectors as value}
///     \cgalParamDefault{none: the normal of a face is constant}
///   \cgalParamNEnd
///   \cgalParamNBegin{use_interpolated_normals}
///     \cgalParamDescription{whether vertex normals are computed (weighted by angle) and interpolated}
///     \cgalParamType{Boolean}
///     \cgalParamDefault{`false`}
///     \cgalParamExtra{a parameter of `CGAL::Area_projection::parameters`; without effect if
///                     `vertex_normal_map` is given}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \throw std::invalid_argument if a face is not a triangle, a vertex of a face or a given normal is
/// not finite, a vertex has a coordinate beyond `largest_coordinate`, or a given area is negative. The message names the first such element by its position in the mesh.
///
/// Complexity: linear in the number of vertices and faces.
template <class TriangleMesh, class NamedParameters = CGAL::parameters::Default_named_parameters>
Triangle_surface surface_from_mesh(const TriangleMesh& mesh,
                                   const NamedParameters& np = CGAL::parameters::default_values())
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  using Vertex = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;
  using Face = typename boost::graph_traits<TriangleMesh>::face_descriptor;
  namespace tags = parameters::tags;

  const auto point_map = choose_parameter(get_parameter(np, internal_np::vertex_point),
                                          get_const_property_map(CGAL::vertex_point, mesh));
  const auto face_normals = get_parameter(np, internal_np::face_normal);
  const auto vertex_normals = get_parameter(np, internal_np::vertex_normal_map);
  const auto areas = get_parameter(np, tags::face_area);
  constexpr bool has_face_normals =
      !std::is_same_v<std::decay_t<decltype(face_normals)>, internal_np::Param_not_found>;
  constexpr bool has_vertex_normals =
      !std::is_same_v<std::decay_t<decltype(vertex_normals)>, internal_np::Param_not_found>;

  Triangle_surface surface;
  // A hash map, because a mesh need not have vertex indices (Polyhedron_3 without ids).
  std::unordered_map<Vertex, std::uint32_t> index_of;
  internal::check_number_of_elements(num_vertices(mesh), "vertices");
  internal::check_number_of_elements(num_faces(mesh), "faces");
  surface.points.reserve(num_vertices(mesh));
  index_of.reserve(num_vertices(mesh));
  for(Vertex v : vertices(mesh)) {
    index_of.emplace(v, std::uint32_t(surface.points.size()));
    surface.points.push_back(internal::to_point(get(point_map, v)));
    if constexpr(has_vertex_normals)
      surface.vertex_normals.push_back(internal::checked_normal(
          internal::to_vector(get(vertex_normals, v)), "vertex", surface.points.size() - 1));
  }

  std::size_t source = 0;
  for(Face f : faces(mesh)) {
    const Triangle_surface::Triangle triangle =
        internal::corners_of_face(mesh, f, source, index_of, surface.points);
    const double area = internal::given_area(areas, f, source);
    if constexpr(has_face_normals) {
      const Vector_3 normal =
          internal::checked_normal(internal::to_vector(get(face_normals, f)), "face", source);
      internal::append_triangle(surface, triangle, source, &normal, area);
    } else
      internal::append_triangle(surface, triangle, source, nullptr, area);
    ++source;
  }

  if constexpr(!has_vertex_normals)
    if(choose_parameter(get_parameter(np, tags::use_interpolated_normals), false))
      surface.vertex_normals = internal::angle_weighted_normals(surface);
  return surface;
}

/// \ingroup PkgAreaProjectionTransformInput
/// \brief reads a triangle soup into its flat form.
///
/// \tparam PointRange a model of `RandomAccessContainer` with points of a model of
/// `AreaProjectionTraits_3`
/// \tparam TriangleRange a range of random access ranges of three indices into `points` each
///
/// Takes of the named parameters of `surface_from_mesh()` only `use_interpolated_normals`; normals
/// can be interpolated only between triangles that name the same point.
///
/// \throw std::invalid_argument if a polygon has not three corners, an index is out of range, or a
/// used point is not finite or has a coordinate beyond `largest_coordinate`.
template <class PointRange, class TriangleRange,
          class NamedParameters = CGAL::parameters::Default_named_parameters>
Triangle_surface
surface_from_triangle_soup(const PointRange& points, const TriangleRange& triangles,
                           const NamedParameters& np = CGAL::parameters::default_values())
{
  Triangle_surface surface;
  internal::check_number_of_elements(std::size(points), "points");
  internal::check_number_of_elements(std::size(triangles), "triangles");
  surface.points.reserve(std::size(points));
  for(const auto& p : points)
    surface.points.push_back(internal::to_point(p));

  std::size_t source = 0;
  for(const auto& corners : triangles) {
    if(std::size(corners) != 3)
      throw std::invalid_argument("triangle " + std::to_string(source) + " has " +
                                  std::to_string(std::size(corners)) + " corners: must have three");
    Triangle_surface::Triangle triangle;
    for(int i = 0; i < 3; ++i) {
      // A negative index becomes a huge one here, so one comparison finds both defects.
      if(std::size_t(corners[i]) >= surface.points.size())
        throw std::invalid_argument("triangle " + std::to_string(source) + " names point " +
                                    std::to_string(corners[i]) + " of " +
                                    std::to_string(surface.points.size()));
      triangle[i] = std::uint32_t(corners[i]);
      internal::check_coordinates(surface.points[triangle[i]], "vertex", triangle[i]);
    }
    internal::append_triangle(surface, triangle, source, nullptr, -1);
    ++source;
  }
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  if(choose_parameter(get_parameter(np, parameters::tags::use_interpolated_normals), false))
    surface.vertex_normals = internal::angle_weighted_normals(surface);
  return surface;
}

} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_SURFELS_FROM_MESH_H
