// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The shelf of tiny named meshes in data/, each with its documented answer.

#include "input.h"
#include "mesh_triangulation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace {

using mapt::Input;
using mapt::Input_error;
using mapt::Mesh_report;
using mapt::Point_3;
using mapt::Reading_options;
using mapt::Vector_3;

std::string shelf(const std::string& name)
{
  return MAPT_TEST_DATA "/" + name;
}

Input read(const std::string& name, bool orient = false, bool flip = false)
{
  Reading_options options;
  options.orient = orient;
  options.flip = flip;
  return mapt::read_input(shelf(name), options);
}

std::vector<std::string> warnings_of(const std::string& name, bool orient = false)
{
  return mapt::warnings(read(name, orient).report);
}

std::string error_of(const std::string& path)
{
  try {
    mapt::read_input(path);
  } catch(const Input_error& error) {
    return error.what();
  }
  return "no error";
}

Vector_3 area_vector(const Input& input, std::size_t t)
{
  const auto& v = input.triangles[t];
  const Point_3& a = input.points[v[0]];
  return CGAL::cross_product(input.points[v[1]] - a, input.points[v[2]] - a) / 2;
}

bool contains(const std::string& text, const std::string& part)
{
  return text.find(part) != std::string::npos;
}

// -- what cannot be used: one line with file, element and cause ---------------------------------

struct Bad_file
{
  const char* name;
  const char* element; // and cause
  const char* remedy;
};

class Unusable : public testing::TestWithParam<Bad_file>
{};

TEST_P(Unusable, is_refused_in_one_line_with_file_element_cause_and_remedy)
{
  const Bad_file& bad = GetParam();
  const std::string message = error_of(shelf(bad.name));
  EXPECT_EQ(message.find(shelf(bad.name) + ": "), 0u) << message;
  EXPECT_TRUE(contains(message, bad.element)) << message;
  EXPECT_TRUE(contains(message, bad.remedy)) << message;
  EXPECT_FALSE(contains(message, "\n")) << message;
}

INSTANTIATE_TEST_SUITE_P(
    Files, Unusable,
    testing::Values(Bad_file{"no_such_file.off", "there is no such file", "check its name"},
                    Bad_file{".", "is a directory", "give a file"},
                    Bad_file{"empty.off", "is empty", "export it again"},
                    Bad_file{"no_extension", "has no extension", "must be .off"},
                    Bad_file{"unknown_extension.step", "extension .step", "must be .off"},
                    Bad_file{"not_a_mesh.off", "is not an OFF file", "check its format"},
                    Bad_file{"not_a_mesh.obj", "is not an OBJ mesh", "check its format"},
                    Bad_file{"not_a_mesh.ply", "is not a PLY file", "check its format"},
                    Bad_file{"not_a_mesh.stl", "is not an STL file", "check its format"},
                    Bad_file{"not_a_mesh.vtp", "XML", ""},
                    Bad_file{"not_a_mesh.xyz", "line 1: point 0 has 2 numbers", "x y z nx ny nz"}));

INSTANTIATE_TEST_SUITE_P(
    Numbers, Unusable,
    testing::Values(
        Bad_file{"nan_vertex.off", "line 5: vertex 2 is not finite", "remove it"},
        Bad_file{"nan_vertex.vtp", "vertex 2 is not finite", "remove it"},
        Bad_file{"infinite_vertex.obj", "line 3: vertex 3 is not finite", "remove it"},
        Bad_file{"overflow_coordinates.obj", "line 3: vertex 3 is too far away", "rescale"},
        Bad_file{"unreadable_number.off", "line 5: vertex 2 has '1,5'", "export it again"},
        Bad_file{"nan_normal.ply", "point 1 has a normal that is not finite", "remove the point"},
        Bad_file{"negative_area.xyz", "point 1 has the area -0.5", "must be"}));

INSTANTIATE_TEST_SUITE_P(
    Indices, Unusable,
    testing::Values(
        Bad_file{"index_out_of_range.off", "line 9: face 2 uses vertex 4", "export it again"},
        Bad_file{"negative_index.off", "line 9: face 2 uses vertex -1", "export it again"},
        Bad_file{"index_out_of_range.obj", "line 5: face 2 uses vertex 4", "export it again"},
        Bad_file{"index_zero.obj", "line 4: face 1 uses vertex 0", "export it again"},
        Bad_file{"index_out_of_range.vtp", "4", ""}));

INSTANTIATE_TEST_SUITE_P(
    Sizes, Unusable,
    testing::Values(
        Bad_file{"no_vertices.off", "has no vertices", "export it again"},
        Bad_file{"no_faces.off", "no faces and no normals", "export the faces"},
        Bad_file{"points_without_normals.ply", "no faces and no normals", "--estimate-normals"},
        Bad_file{"points_without_normals.xyz", "no faces and no normals", "--estimate-normals"},
        Bad_file{"all_faces_degenerate.off", "2 faces, all degenerate", "export it again"},
        Bad_file{"zero_extent.off", "all vertices are within 1e-15 of (5, 5, 5)", "rescale"},
        Bad_file{"truncated.off", "line 9: face 2 has 1 of 3 vertices", "export it again"},
        Bad_file{"truncated.stl", "ends within facet 0", "export it again"},
        Bad_file{"truncated_binary.stl", "ends after 2 of 4 facets", "export it again"},
        Bad_file{"truncated_header.ply", "no end_header", "export it again"},
        Bad_file{"truncated_binary.ply", "face 0", "export it again"},
        Bad_file{"huge_claim.off", "ends after 1 of 1000000000 faces", "export it again"},
        Bad_file{"huge_face.off", "face 0 has 3 of 1000000000 vertices", "export it again"},
        Bad_file{"huge_list.ply", "line 13: face 0 has a list longer", "export it again"}));

// -- what works, and says what it found ----------------------------------------------------------

// Every format and oddity of a format holds the same tetrahedron.
class Tetrahedron : public testing::TestWithParam<const char*>
{};

TEST_P(Tetrahedron, is_read_whole_and_without_a_word)
{
  const Input input = read(GetParam());
  const Mesh_report& report = input.report;
  EXPECT_FALSE(input.is_point_set);
  EXPECT_EQ(report.vertices, 4u);
  EXPECT_EQ(report.faces, 4u);
  EXPECT_EQ(report.triangles, 4u);
  EXPECT_TRUE(report.is_closed);
  EXPECT_TRUE(report.is_consistently_oriented);
  EXPECT_EQ(report.components, 1u);
  EXPECT_EQ(report.genus, std::size_t(0));
  EXPECT_NEAR(report.area, 1.5 + std::sqrt(3.) / 2, 1e-12);
  EXPECT_NEAR(report.signed_volume.value(), 1. / 6, 1e-12);
  EXPECT_EQ(report.bounding_box, CGAL::Bbox_3(0, 0, 0, 1, 1, 1));
  EXPECT_EQ(input.source_faces, (std::vector<std::uint32_t>{0, 1, 2, 3}));
  EXPECT_TRUE(mapt::warnings(report).empty());
}

INSTANTIATE_TEST_SUITE_P(Formats, Tetrahedron,
                         testing::Values("tetrahedron.off", "header_without_blank.off",
                                         "colours.off", "relative_indices.obj", "integers.ply",
                                         "big_endian.ply", "tetrahedron.vtp"));

class Cube : public testing::TestWithParam<const char*>
{};

TEST_P(Cube, encloses_a_unit_outward)
{
  const Input input = read(GetParam());
  EXPECT_TRUE(input.report.is_closed);
  EXPECT_EQ(input.report.components, 1u);
  EXPECT_EQ(input.report.genus, std::size_t(0));
  EXPECT_NEAR(input.report.area, 6, 1e-12);
  EXPECT_NEAR(input.report.signed_volume.value(), 1, 1e-12);
}

INSTANTIATE_TEST_SUITE_P(Files, Cube,
                         testing::Values("cube.off", "inward_cube.off", "duplicate_vertices.off",
                                         "soup.stl", "solid_binary.stl", "degenerate_faces.off"));

TEST(Mesh, open_is_no_defect)
{
  const Mesh_report report = read("open_tetrahedron.off").report;
  EXPECT_FALSE(report.is_closed);
  EXPECT_EQ(report.boundary_edges, 3u);
  EXPECT_EQ(report.holes, 1u);
  EXPECT_FALSE(report.signed_volume.has_value());
  EXPECT_FALSE(report.genus.has_value());
  EXPECT_TRUE(mapt::warnings(report).empty());
}

TEST(Mesh, components_are_counted_without_a_word)
{
  const Mesh_report report = read("two_components.off").report;
  EXPECT_EQ(report.components, 2u);
  EXPECT_NEAR(report.signed_volume.value(), 2, 1e-12);
  EXPECT_TRUE(mapt::warnings(report).empty());
}

TEST(Mesh, elements_without_properties_take_no_time_whatever_their_number)
{
  EXPECT_EQ(read("endless_element.ply").report.triangles, 1u);
}

TEST(Mesh, vertices_doubled_on_purpose_stay_two)
{
  const Mesh_report report = read("touching_at_a_doubled_vertex.off").report;
  EXPECT_EQ(report.duplicate_vertices, 1u);
  EXPECT_FALSE(report.are_duplicates_joined);
  EXPECT_TRUE(report.is_closed);
  EXPECT_EQ(report.genus, std::size_t(0));
  EXPECT_TRUE(mapt::warnings(report).empty());
}

struct Warned_file
{
  const char* name;
  const char* line;
};

class One_warning : public testing::TestWithParam<Warned_file>
{};

TEST_P(One_warning, counts_the_defect_and_names_the_remedy)
{
  const std::vector<std::string> lines = warnings_of(GetParam().name);
  EXPECT_EQ(std::count_if(lines.begin(), lines.end(),
                          [](const std::string& line) { return contains(line, GetParam().line); }),
            1)
      << (lines.empty() ? "no warning" : lines[0]);
  for(const std::string& line : lines)
    EXPECT_FALSE(contains(line, "\n"));
}

INSTANTIATE_TEST_SUITE_P(
    Files, One_warning,
    testing::Values(
        Warned_file{"polygons.off", "7 faces are polygons of more than 3 corners: cut"},
        Warned_file{"degenerate_faces.off", "3 faces have no area: left out"},
        Warned_file{"faces_of_two_vertices.off", "2 faces have no area: left out"},
        Warned_file{"loose_face_without_area.off", "1 face has no area: left out"},
        Warned_file{"unused_vertices.off", "2 vertices are on no face: ignored"},
        Warned_file{"duplicate_vertices.off", "28 vertices repeat the position"},
        Warned_file{"nonmanifold_edge.off", "1 edge has more than 2 faces"},
        Warned_file{"mixed_orientation.off", "4 edges lie between faces that disagree"},
        Warned_file{"mixed_orientation.off", "use --orient, or --side both"},
        Warned_file{"inward_cube.off", "the faces point inward: turned over"},
        Warned_file{"two_components_one_inward.off", "1 of 2 parts point inward: turned over"},
        Warned_file{"inward_open_box.off", "1 open part seems to have faces that point inward"},
        Warned_file{"point_without_normal.xyz", "1 point has a normal of length 0: left out"}));

TEST(Mesh, faces_without_area_leave_no_trace_in_the_triangles)
{
  for(const char* name : {"degenerate_faces.off", "loose_face_without_area.off"}) {
    const Input input = read(name);
    EXPECT_EQ(input.triangles.size(), input.source_faces.size());
    EXPECT_TRUE(input.report.is_closed) << name;
    for(std::size_t t = 0; t < input.triangles.size(); ++t)
      EXPECT_GT(area_vector(input, t).squared_length(), 0);
  }
}

// -- which way faces look ------------------------------------------------------------------------

TEST(Orientation, inward_cube_becomes_the_cube)
{
  EXPECT_TRUE(read("inward_cube.off").report.is_orientation_repaired);
  EXPECT_FALSE(read("cube.off").report.is_orientation_repaired);
}

TEST(Orientation, flip_wins_over_the_check)
{
  const Input inward = read("cube.off", false, true);
  EXPECT_TRUE(inward.report.was_flipped);
  EXPECT_NEAR(inward.report.signed_volume.value(), -1, 1e-12);
  const Input outward = read("inward_cube.off", false, true);
  EXPECT_NEAR(outward.report.signed_volume.value(), 1, 1e-12);
  EXPECT_TRUE(mapt::warnings(outward.report).empty());
}

TEST(Orientation, flip_turns_open_meshes)
{
  const Input as_read = read("inward_open_box.off");
  const Input flipped = read("inward_open_box.off", false, true);
  ASSERT_EQ(as_read.triangles.size(), flipped.triangles.size());
  for(std::size_t t = 0; t < flipped.triangles.size(); ++t)
    EXPECT_EQ(area_vector(flipped, t), -area_vector(as_read, t));
  EXPECT_TRUE(mapt::warnings(flipped.report).empty());
}

TEST(Orientation, one_inward_part_is_turned_alone_but_the_wall_of_a_cavity_stays)
{
  EXPECT_NEAR(read("two_components_one_inward.off").report.signed_volume.value(), 1.125, 1e-12);
  const Mesh_report cavity = read("cavity.off").report;
  EXPECT_NEAR(cavity.signed_volume.value(), 26, 1e-12);
  EXPECT_TRUE(mapt::warnings(cavity).empty());
}

TEST(Orientation, orient_makes_neighbours_agree_and_look_outward)
{
  const Mesh_report report = read("mixed_orientation.off", true).report;
  EXPECT_EQ(report.inconsistent_edges, 0u);
  EXPECT_GT(report.faces_reoriented, 0u);
  EXPECT_NEAR(report.signed_volume.value(), 1, 1e-12);
  EXPECT_FALSE(read("mixed_orientation.off").report.is_consistently_oriented);
}

TEST(Orientation, of_a_moebius_strip_does_not_exist)
{
  const Mesh_report report = read("moebius_strip.off", true).report;
  EXPECT_GT(report.inconsistent_edges, 0u);
  bool is_remedy_named = false;
  for(const std::string& line : mapt::warnings(report))
    is_remedy_named = is_remedy_named || contains(line, "no two sides; use --side both");
  EXPECT_TRUE(is_remedy_named);
}

// -- polygons ------------------------------------------------------------------------------------

TEST(Polygons, cover_the_house_exactly)
{
  const Input house = read("polygons.off");
  EXPECT_EQ(house.report.triangles, 2u * 3 + 5 * 2);
  EXPECT_TRUE(house.report.is_closed);
  EXPECT_NEAR(house.report.signed_volume.value(), 4 * (4 + 1), 1e-12);
  EXPECT_NEAR(house.report.area, 2 * 5 + 8 + 2 * 8 + 2 * 4 * std::sqrt(2.), 1e-12);
}

TEST(Polygons, that_are_not_convex_are_covered_exactly_and_keep_their_side)
{
  const Input letters = read("concave_polygon.off");
  EXPECT_NEAR(letters.report.area, 3 + 7, 1e-12); // |area| of each triangle: none overlap
  for(std::size_t t = 0; t < letters.triangles.size(); ++t)
    EXPECT_GT(area_vector(letters, t).z(), 0);
  EXPECT_EQ(std::count(letters.source_faces.begin(), letters.source_faces.end(), 0u), 4);
  EXPECT_EQ(std::count(letters.source_faces.begin(), letters.source_faces.end(), 1u), 6);
}

TEST(Polygons, that_cross_themselves_or_are_not_planar_do_no_harm)
{
  const Input input = read("crossing_polygon.off");
  EXPECT_GT(input.report.triangles, 0u);
  EXPECT_LE(input.report.triangles, 3u + 2 + 2 + 2);
}

TEST(Polygons, comb_of_many_teeth_keeps_its_area)
{
  // a base of height 1 with n teeth of height 9: far from star-shaped
  constexpr int n = 500;
  std::vector<Point_3> points;
  mapt::Polygons comb;
  for(int i = 0; i < n; ++i) {
    points.emplace_back(2 * i, 10, i % 7); // not planar, seen from above it is
    points.emplace_back(2 * i + 1, 1, i % 5);
  }
  points.emplace_back(2 * n, 0, 0);
  points.emplace_back(0, 0, 0);
  for(std::uint32_t i = 0; i < points.size(); ++i)
    comb.vertices.push_back(std::uint32_t(points.size()) - 1 - i);
  comb.close_face();
  double shadow = 0, boundary = 0;
  for(std::size_t i = 0; i < comb.vertices.size(); ++i) {
    const Point_3& p = points[comb.vertices[i]];
    const Point_3& q = points[comb.vertices[(i + 1) % comb.vertices.size()]];
    boundary += (p.x() * q.y() - q.x() * p.y()) / 2;
  }
  for(const mapt::Triangle& t : mapt::triangulate(points, comb).triangles) {
    const Vector_3 a = points[t[1]] - points[t[0]], b = points[t[2]] - points[t[0]];
    shadow += std::abs(CGAL::cross_product(a, b).z()) / 2;
  }
  EXPECT_NEAR(shadow, std::abs(boundary), 1e-9 * shadow);
}

// -- points --------------------------------------------------------------------------------------

class Points : public testing::TestWithParam<const char*>
{};

TEST_P(Points, have_unit_normals)
{
  const Input input = read(GetParam());
  EXPECT_TRUE(input.is_point_set);
  ASSERT_EQ(input.points.size(), 6u);
  ASSERT_EQ(input.normals.size(), 6u);
  EXPECT_TRUE(input.triangles.empty());
  for(std::size_t i = 0; i < 6; ++i)
    EXPECT_EQ(input.normals[i], input.points[i] - CGAL::ORIGIN); // of an octahedron
  EXPECT_EQ(input.report.bounding_box, CGAL::Bbox_3(-1, -1, -1, 1, 1, 1));
  EXPECT_TRUE(mapt::warnings(input.report).empty());
}

INSTANTIATE_TEST_SUITE_P(Formats, Points,
                         testing::Values("points_with_normals.ply", "points_with_normals.xyz",
                                         "points_with_normals.obj", "points_with_normals.off",
                                         "points_with_normals.vtp"));

TEST(Point_set, has_the_areas_of_the_file)
{
  const Input input = read("points_with_normals.ply");
  EXPECT_EQ(input.areas, std::vector<double>(6, 0.5));
  EXPECT_DOUBLE_EQ(input.report.area, 3);
  EXPECT_TRUE(read("points_with_normals.xyz").areas.empty());
}

TEST(Point_set, flip_turns_normals)
{
  const Input input = read("points_with_normals.xyz", false, true);
  EXPECT_EQ(input.normals[0], Vector_3(-1, 0, 0));
}

TEST(Point_set, points_without_normal_are_left_out)
{
  const Input input = read("point_without_normal.xyz");
  EXPECT_EQ(input.points.size(), 2u);
  EXPECT_EQ(input.report.points_without_normal, 1u);
}

// -- size and garbage ----------------------------------------------------------------------------

class Scratch_file
{
public:
  explicit Scratch_file(const std::string& name)
      : m_path((std::filesystem::temp_directory_path() / ("mapt_test_input_" + name)).string())
  {}
  ~Scratch_file() { std::remove(m_path.c_str()); }
  Scratch_file(const Scratch_file&) = delete;
  Scratch_file& operator=(const Scratch_file&) = delete;

  const std::string& path() const { return m_path; }
  void write(const std::string& bytes) const { std::ofstream(m_path, std::ios::binary) << bytes; }

private:
  std::string m_path;
};

TEST(Reading, a_torus_of_200000_vertices_takes_about_a_second_at_most)
{
  constexpr std::size_t n = 450;
  std::string text = "OFF\n" + std::to_string(n * n) + " " + std::to_string(2 * n * n) + " 0\n";
  for(std::size_t i = 0; i < n; ++i)
    for(std::size_t j = 0; j < n; ++j) {
      const double u = 2 * CGAL_PI * double(i) / n, v = 2 * CGAL_PI * double(j) / n;
      char line[80];
      std::snprintf(line, sizeof(line), "%.9g %.9g %.9g\n", (2 + std::cos(v)) * std::cos(u),
                    (2 + std::cos(v)) * std::sin(u), std::sin(v));
      text += line;
    }
  for(std::size_t i = 0; i < n; ++i)
    for(std::size_t j = 0; j < n; ++j) {
      const std::size_t k = (i + 1) % n, l = (j + 1) % n;
      const auto face = [&text](std::size_t a, std::size_t b, std::size_t c) {
        text += "3 " + std::to_string(a) + " " + std::to_string(b) + " " + std::to_string(c) + "\n";
      };
      face(i * n + j, k * n + j, k * n + l);
      face(i * n + j, k * n + l, i * n + l);
    }
  const Scratch_file file("torus.off");
  file.write(text);
  const Input torus = mapt::read_input(file.path());
  EXPECT_EQ(torus.report.genus, std::size_t(1));
  EXPECT_NEAR(torus.report.signed_volume.value(), 4 * CGAL_PI * CGAL_PI, 0.01);
}

// Bytes overwritten, cut off and doubled: an answer or an Input_error, nothing else.
TEST(Reading, of_any_bytes_ends)
{
  std::vector<std::filesystem::path> files;
  for(const auto& entry : std::filesystem::directory_iterator(MAPT_TEST_DATA))
    if(entry.is_regular_file())
      files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  std::uint32_t state = 1;
  const auto random = [&state](std::size_t n) { // Numerical Recipes' generator
    state = 1664525u * state + 1013904223u;
    return std::size_t((std::uint64_t(state) * n) >> 32);
  };
  for(const std::filesystem::path& path : files) {
    std::ifstream stream(path, std::ios::binary);
    const std::string original{std::istreambuf_iterator<char>(stream), {}};
    const Scratch_file file("garbage" + path.extension().string());
    for(int round = 0; round < 20 && !original.empty(); ++round) {
      std::string bytes = original;
      bytes[random(bytes.size())] = char(random(256));
      bytes.insert(random(bytes.size()), bytes.substr(random(bytes.size()), random(40)));
      if(round % 2 == 0)
        bytes.resize(random(bytes.size()));
      file.write(bytes);
      try {
        const Input input = mapt::read_input(file.path());
        EXPECT_TRUE(input.is_point_set || !input.triangles.empty());
      } catch(const Input_error& error) {
        EXPECT_EQ(std::string(error.what()).find(file.path()), 0u) << error.what();
      }
    }
  }
}

} // namespace
