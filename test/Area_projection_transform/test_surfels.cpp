// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What goes in: meshes of any type and kernel with any of the named parameters, soups; and how they are
// sampled.

#include "shapes.h"

#include <CGAL/area_projection_transform.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Polyhedron_items_with_id_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <boost/property_map/property_map.hpp>

#include <gtest/gtest.h>

#include <type_traits>

namespace {

namespace AP = CGAL::Area_projection;
namespace P = CGAL::Area_projection::parameters;
using AP::Point_3;
using AP::Side;
using AP::Vector_3;
using shapes::pi;
using shapes::Soup;

using Epick = CGAL::Exact_predicates_inexact_constructions_kernel;
using Epeck = CGAL::Exact_predicates_exact_constructions_kernel;

// ---------------------------------------------------------------- meshes of any type

template <class Mesh>
struct Of_mesh_type : public ::testing::Test
{
  using Point = typename boost::property_traits<
      typename boost::property_map<Mesh, CGAL::vertex_point_t>::type>::value_type;
  using Geometry = typename CGAL::Kernel_traits<Point>::Kernel;
  using Vector = typename Geometry::Vector_3;
  using Vertex = typename boost::graph_traits<Mesh>::vertex_descriptor;
  using Face = typename boost::graph_traits<Mesh>::face_descriptor;

  /// what coordinates of the kernel are rounded to.
  static constexpr double precision =
      std::is_same_v<Geometry, CGAL::Simple_cartesian<float>> ? 1e-6 : 1e-14;

  /// the points of a mesh at twice their distance from the origin.
  struct Doubled_point_map
  {
    using key_type = Vertex;
    using value_type = Point;
    using reference = Point;
    using category = boost::readable_property_map_tag;
    const Mesh* mesh;
    friend Point get(const Doubled_point_map& map, Vertex v)
    {
      const Point& p = get(CGAL::vertex_point, *map.mesh, v);
      return Point(2 * p.x(), 2 * p.y(), 2 * p.z());
    }
  };

  const Soup soup = shapes::blob(2, 61);
  const Mesh mesh = shapes::mesh_of<Mesh>(soup);
};

using Mesh_types = ::testing::Types<CGAL::Surface_mesh<Epick::Point_3>, CGAL::Polyhedron_3<Epick>,
                                    CGAL::Polyhedron_3<Epick, CGAL::Polyhedron_items_with_id_3>,
                                    CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>,
                                    CGAL::Surface_mesh<CGAL::Simple_cartesian<float>::Point_3>,
                                    CGAL::Surface_mesh<Epeck::Point_3>>;
TYPED_TEST_SUITE(Of_mesh_type, Mesh_types, );

TYPED_TEST(Of_mesh_type, the_surface_is_that_of_the_soup)
{
  const AP::Triangle_surface expected = shapes::surface_of(this->soup);
  const AP::Triangle_surface surface = AP::surface_from_mesh(this->mesh);
  ASSERT_EQ(surface.size(), expected.size());
  EXPECT_EQ(surface.number_of_skipped_faces, 0u);
  EXPECT_FALSE(surface.has_interpolated_normals());
  for(std::size_t t = 0; t < surface.size(); ++t) {
    EXPECT_EQ(surface.sources[t], t);
    EXPECT_NEAR(surface.areas[t], expected.areas[t], this->precision);
    EXPECT_NEAR(surface.normals[t] * expected.normals[t], 1, 10 * this->precision);
    for(int i = 0; i < 3; ++i)
      EXPECT_NEAR((surface.corner(t, i) - expected.corner(t, i)).squared_length(), 0,
                  this->precision * this->precision);
  }
}

TYPED_TEST(Of_mesh_type, the_facade_reads_the_same_as_the_soup)
{
  const AP::Exact_evaluator expected(shapes::scale_space_of(this->soup), 0.8, Side::INSIDE);
  for(const double x : {-0.2, 0., 0.3}) {
    const typename TestFixture::Point p(x, 0, 0);
    EXPECT_NEAR(AP::area_projection_transform(this->mesh, p, 0.8, 0.4),
                expected(Point_3(x, 0, 0), 0.4), 100 * this->precision);
  }
  const AP::Joint_map map = AP::joint_area_projection_transform(
      this->mesh, P::combine(P::voxel_size(0.2), P::radii({0.5, 0.8})));
  EXPECT_GT(*std::max_element(map.values().begin(), map.values().end()), 0.9);
}

TYPED_TEST(Of_mesh_type, takes_a_point_map)
{
  const typename TestFixture::Doubled_point_map doubled{&this->mesh};
  const AP::Triangle_surface surface =
      AP::surface_from_mesh(this->mesh, CGAL::parameters::vertex_point_map(doubled));
  EXPECT_NEAR(surface.total_area() / this->soup.area(), 4, 10 * this->precision);
}

TYPED_TEST(Of_mesh_type, takes_normals_and_areas_of_faces_in_any_order)
{
  using Number = typename TestFixture::Geometry::FT;
  const boost::static_property_map<typename TestFixture::Vector> up({0, 0, 3});
  const boost::static_property_map<Number> two(Number(2));
  const auto normals = CGAL::parameters::face_normal_map(up);
  const auto areas = P::face_area_map(two);
  const typename TestFixture::Doubled_point_map doubled{&this->mesh};
  const auto points = CGAL::parameters::vertex_point_map(doubled);

  const auto expect_all = [&](const auto& np) {
    const AP::Triangle_surface surface = AP::surface_from_mesh(this->mesh, np);
    for(std::size_t t = 0; t < surface.size(); ++t) {
      ASSERT_EQ(surface.normals[t], Vector_3(0, 0, 1));
      ASSERT_EQ(surface.areas[t], 2);
    }
    EXPECT_NEAR(surface.points[0].x(), 2 * this->soup.points[0].x(), 10 * this->precision);
  };
  expect_all(P::combine(normals, areas, points));
  expect_all(P::combine(points, normals, areas));
  expect_all(P::combine(areas, P::combine(points, normals)));
  expect_all(P::combine(CGAL::parameters::face_normal_map(up).vertex_point_map(doubled), areas));
  expect_all(P::combine(areas, CGAL::parameters::face_normal_map(up).vertex_point_map(doubled)));
  expect_all(P::face_area_map(two).face_normal_map(up).vertex_point_map(doubled));
}

TYPED_TEST(Of_mesh_type, takes_or_computes_normals_of_vertices)
{
  const boost::static_property_map<typename TestFixture::Vector> up({0, 0, 3});
  const AP::Triangle_surface given =
      AP::surface_from_mesh(this->mesh, CGAL::parameters::vertex_normal_map(up));
  ASSERT_EQ(given.vertex_normals.size(), this->soup.points.size());
  for(const Vector_3& n : given.vertex_normals)
    EXPECT_EQ(n, Vector_3(0, 0, 1));

  const AP::Triangle_surface computed =
      AP::surface_from_mesh(this->mesh, P::use_interpolated_normals(true));
  ASSERT_EQ(computed.vertex_normals.size(), this->soup.points.size());
  for(std::size_t v = 0; v < computed.vertex_normals.size(); ++v) { // the blob is nearly a sphere
    EXPECT_NEAR(computed.vertex_normals[v].squared_length(), 1, 1e-12);
    EXPECT_GT(computed.vertex_normals[v] * (computed.points[v] - CGAL::ORIGIN), 0.7);
  }
}

// ---------------------------------------------------------------- named parameters

TEST(Combine, gives_precedence_to_what_comes_later)
{
  const Soup plane = shapes::plane_patch(10, 0);
  using Mesh = CGAL::Surface_mesh<Epick::Point_3>;
  const Mesh mesh = shapes::mesh_of<Mesh>(plane);
  const Point_3 below(0, 0, -1);
  const auto at = [&](const auto& np) {
    return AP::area_projection_transform(mesh, below, 1, 0.5, np);
  };
  const auto inside = P::side(Side::INSIDE), outside = P::side(Side::OUTSIDE);
  EXPECT_NEAR(at(inside), pi / 4, 1e-12);
  EXPECT_EQ(at(outside), 0);
  EXPECT_EQ(at(P::combine(inside, outside)), 0);
  EXPECT_NEAR(at(P::combine(outside, inside)), pi / 4, 1e-12);
  EXPECT_NEAR(at(P::combine(outside, P::sigma_ratio(0.3), inside)), pi / 4, 1e-12);
  EXPECT_EQ(at(P::combine(inside, P::sigma_ratio(0.3), P::voxel_size(1), outside)), 0);
}

// The area of a face counts as given, but its shape stays: a patch with twice the area reads twice.
TEST(Face_area_map, multiplies_what_a_plane_reads)
{
  using Mesh = CGAL::Surface_mesh<Epick::Point_3>;
  const Mesh mesh = shapes::mesh_of<Mesh>(shapes::plane_patch(8, 0, 4)); // triangles of area 2
  const boost::static_property_map<double> areas(3.);
  EXPECT_NEAR(
      AP::area_projection_transform(mesh, Point_3(0, 0, -1), 1, 0.5, P::face_area_map(areas)),
      1.5 * pi / 4, 1e-12);
}

// Phong normals of the vertices of a sphere are radial. A point of a face, which lies up to
// 1 - cos(edge) inside, moves straight to the centre but for that; with flat normals a face lands as
// a whole, as wide as it is.
TEST(Interpolated_normals, bring_a_coarse_sphere_together_at_its_centre)
{
  const Soup sphere = shapes::icosphere(2);
  const auto mean_distance = [&](bool is_interpolated) {
    const AP::Triangle_surface surface = AP::surface_from_triangle_soup(
        sphere.points, sphere.triangles, P::use_interpolated_normals(is_interpolated));
    double sum = 0;
    const AP::Surfels surfels = AP::sample_surfels(surface, 0.02);
    for(std::size_t s = 0; s < surfels.size(); ++s)
      sum += surfels.areas[s] *
             std::sqrt((surfels.positions[s] - surfels.normals[s] - CGAL::ORIGIN).squared_length());
    return sum / surfels.total_area();
  };
  EXPECT_LT(mean_distance(true), 0.2 * mean_distance(false));
}

// ---------------------------------------------------------------- what is skipped and refused

TEST(Surface, skips_and_counts_faces_without_area)
{
  const Soup soup{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {2, 0, 0}},
                  {{0, 1, 3}, {0, 1, 2}, {1, 1, 2}, {1, 3, 2}}};
  const AP::Triangle_surface surface = shapes::surface_of(soup);
  EXPECT_EQ(surface.number_of_skipped_faces, 2u);
  EXPECT_EQ(surface.sources, (std::vector<std::uint32_t>{1, 3})); // faces keep their names
  EXPECT_EQ(surface.total_area(), 1);
}

TEST(Surface, leaves_unused_points_out_of_the_box)
{
  const Soup soup{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {9, 9, 9}}, {{0, 1, 2}}};
  const CGAL::Bbox_3 box = shapes::surface_of(soup).bbox();
  EXPECT_EQ(box.xmax(), 1);
  EXPECT_EQ(box.zmax(), 0);
}

TEST(Surface, names_the_element_that_is_wrong)
{
  using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
  Mesh mesh = shapes::mesh_of<Mesh>(shapes::icosphere(1));
  const boost::static_property_map<double> negative(-1.);
  EXPECT_EQ(shapes::complaint([&] { AP::surface_from_mesh(mesh, P::face_area_map(negative)); }),
            "face_area_map has the value -1 for face 0: must be finite and not negative");
  mesh.point(Mesh::Vertex_index(7)) = CGAL::Simple_cartesian<double>::Point_3(0, NAN, 0);
  EXPECT_EQ(shapes::complaint([&] { AP::surface_from_mesh(mesh); }), "vertex 7 is not finite");
  mesh.point(Mesh::Vertex_index(7)) = CGAL::Simple_cartesian<double>::Point_3(0, -2e75, 0);
  EXPECT_EQ(shapes::complaint([&] { AP::surface_from_mesh(mesh); }),
            "vertex 7 has a coordinate beyond 1e75: rescale the shape");

  Mesh squares;
  const auto a = squares.add_vertex({0, 0, 0}), b = squares.add_vertex({1, 0, 0}),
             c = squares.add_vertex({1, 1, 0}), d = squares.add_vertex({0, 1, 0}),
             e = squares.add_vertex({0, 2, 0});
  squares.add_face(d, c, e);
  squares.add_face(a, b, c, d);
  EXPECT_EQ(shapes::complaint([&] { AP::surface_from_mesh(squares); }),
            "face 1 has 4 vertices: must be a triangle (see "
            "CGAL::Polygon_mesh_processing::triangulate_faces())");
}

TEST(Soup, names_the_element_that_is_wrong)
{
  const std::vector<Point_3> points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, INFINITY}};
  using Polygons = std::vector<std::vector<int>>;
  const auto of = [&](const Polygons& polygons) {
    return shapes::complaint([&] { AP::surface_from_triangle_soup(points, polygons); });
  };
  EXPECT_EQ(of({{0, 1, 2}}), "");
  EXPECT_EQ(of({{0, 1, 2}, {0, 1}}), "triangle 1 has 2 corners: must have three");
  EXPECT_EQ(of({{0, 1, 2, 3}}), "triangle 0 has 4 corners: must have three");
  EXPECT_EQ(of({{0, 1, 4}}), "triangle 0 names point 4 of 4");
  EXPECT_EQ(of({{0, 1, 2}, {0, -1, 2}}), "triangle 1 names point -1 of 4");
  EXPECT_EQ(of({{0, 1, 3}}), "vertex 3 is not finite");
}

// ---------------------------------------------------------------- sampling

AP::Triangle_surface one_triangle(const Point_3& a, const Point_3& b, const Point_3& c)
{
  return shapes::surface_of({{a, b, c}, {{0, 1, 2}}});
}

TEST(Sampling, keeps_the_area_and_the_centroid_of_each_triangle)
{
  shapes::Random random(62);
  const CGAL::Bbox_3 box(-1, -1, -1, 1, 1, 1);
  for(int n = 0; n < 300; ++n) {
    const Point_3 a = random.point_in(box), b = random.point_in(box);
    // One in three is a sliver.
    const Point_3 c = n % 3 ? random.point_in(box)
                            : CGAL::midpoint(a, b) + 1e-5 * (random.point_in(box) - CGAL::ORIGIN);
    const AP::Triangle_surface surface = one_triangle(a, b, c);
    for(const double spacing : {0.03, 0.2, 10.}) {
      const AP::Surfels surfels = AP::sample_surfels(surface, spacing);
      Vector_3 moment(0, 0, 0);
      for(std::size_t s = 0; s < surfels.size(); ++s) {
        moment = moment + surfels.areas[s] * (surfels.positions[s] - CGAL::ORIGIN);
        ASSERT_EQ(surfels.normals[s], surface.normals[0]);
        ASSERT_EQ(surfels.sources[s], 0u);
        ASSERT_GT(surfels.areas[s], 0);
      }
      ASSERT_NEAR(surfels.total_area() / surface.total_area(), 1, 1e-12);
      const Vector_3 shift =
          moment / surface.total_area() - (CGAL::centroid(a, b, c) - CGAL::ORIGIN);
      ASSERT_NEAR(std::sqrt(shift.squared_length()), 0, 1e-12);
    }
  }
}

// Pieces are about as wide and as high as the spacing: their number is bounded by the area, and in
// slivers by the length; and each place of the triangle has a sample near by.
TEST(Sampling, cuts_pieces_of_bounded_size_also_from_slivers)
{
  shapes::Random random(63);
  const double spacing = 0.05;
  for(const double height : {1., 0.1, 0.01, 1e-4, 1e-8}) {
    const Point_3 a(0, 0, 0), b(1, 0, 0), c(0.3, height, 0);
    const AP::Surfels surfels = AP::sample_surfels(one_triangle(a, b, c), spacing);
    // Halving leaves pieces of at least half the largest variance, so of 0.43 spacing² if they are
    // equilateral; the length counts where the height is less than the spacing.
    EXPECT_LE(double(surfels.size()), 0.5 * height / (0.43 * spacing * spacing) + 2 / spacing);
    for(int n = 0; n < 1000; ++n) {
      double u = random(), v = random();
      if(u + v > 1) {
        u = 1 - u;
        v = 1 - v;
      }
      const Point_3 p = a + u * (b - a) + v * (c - a);
      double nearest = 1;
      for(const Point_3& q : surfels.positions)
        nearest = std::min(nearest, CGAL::squared_distance(p, q));
      ASSERT_LT(std::sqrt(nearest), 1.1 * spacing) << height;
    }
  }
}

TEST(Sampling, does_not_depend_on_batches_or_on_other_triangles)
{
  const AP::Triangle_surface surface = shapes::surface_of(shapes::blob(3, 64));
  const AP::Surfels all = AP::sample_surfels(surface, 0.01);
  std::size_t number = 0, batches = 0;
  surface.for_each_batch(0.01, [&](const AP::Surfels& batch) {
    for(std::size_t s = 0; s < batch.size(); ++s)
      EXPECT_EQ(batch.positions[s], all.positions[number++]);
    ++batches;
  });
  EXPECT_EQ(number, all.size());
  EXPECT_GT(batches, 1u);
  std::size_t next = 0;
  for(std::size_t t = 0; t < surface.size(); ++t)
    surface.for_each_surfel_of_triangle(t, 0.01,
                                        [&](const Point_3& position, const Vector_3&, double area) {
                                          EXPECT_EQ(all.sources[next], t);
                                          EXPECT_EQ(all.areas[next], area);
                                          EXPECT_EQ(all.positions[next++], position);
                                        });
}

} // namespace
