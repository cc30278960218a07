// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Area_projection_transform/IO/salient_points_CSV.h>
#include <CGAL/Area_projection_transform/IO/salient_points_PLY.h>

#include <gtest/gtest.h>

#include <cstring>
#include <map>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace AP = CGAL::Area_projection;
namespace IO = CGAL::Area_projection::IO;

namespace {

AP::Salient_point a_sphere()
{
  AP::Salient_point point;
  point.position = AP::Point_3(1. / 3, -1e-300, 12345678.9);
  point.radius = 0.1;
  point.scale = 0.1 * 2 / 3;
  point.intensity = 2.25;
  point.shape = AP::Salient_shape::SPHERE;
  point.voters = {0, 2};
  return point;
}

AP::Salient_point a_bent_tube()
{
  AP::Salient_point point;
  point.shape = AP::Salient_shape::TUBE;
  point.radius = 0.3;
  point.axis = AP::Vector_3(0, 0, 1);
  point.curvature = AP::Vector_3(0.125, 0, 0);
  point.is_seen_from_one_side = true;
  point.voters = {1, 2, 5};
  return point;
}

std::vector<std::map<std::string, std::string>> rows_of(const std::string& text)
{
  std::istringstream in(text);
  IO::CSV_reader reader(in, "table");
  std::vector<std::string> names, fields;
  reader.read(names);
  std::vector<std::map<std::string, std::string>> rows;
  while(reader.read(fields)) {
    EXPECT_EQ(fields.size(), names.size());
    rows.emplace_back();
    for(std::size_t c = 0; c < names.size(); ++c)
      rows.back()[names[c]] = fields[c];
  }
  return rows;
}

double number(const std::string& text)
{
  double value = 0;
  EXPECT_TRUE(IO::from_text(text, value)) << text;
  return value;
}

// Two triangles of the unit square, and a third in the air.
AP::Triangle_surface three_triangles()
{
  AP::Triangle_surface surface;
  surface.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 1. / 3}};
  surface.triangles = {{0, 1, 2}, {0, 2, 3}, {1, 2, 3}};
  surface.sources = {0, 1, 3}; // face 2 was left out
  return surface;
}

} // namespace

TEST(SalientPointsCSV, columns_are_a_promise)
{
  std::ostringstream out;
  IO::write_salient_points_CSV(out, std::vector<AP::Salient_point>());
  EXPECT_EQ(out.str(),
            "x,y,z,radius,scale,intensity,sphericity,blobness,flatness,vesselness,"
            "observed_fraction,type,axis_x,axis_y,axis_z,radius_low,radius_high,residual,voters,"
            "length,slope,curvature_x,curvature_y,curvature_z,one_sided,side\n");
}

TEST(SalientPointsCSV, numbers_read_back_as_the_same_ones)
{
  std::ostringstream out;
  IO::write_salient_points_CSV(out, std::vector<AP::Salient_point>{a_sphere(), a_bent_tube()},
                               AP::Side::OUTSIDE);
  const auto rows = rows_of(out.str());
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_EQ(number(rows[0].at("x")), 1. / 3);
  EXPECT_EQ(number(rows[0].at("y")), -1e-300);
  EXPECT_EQ(number(rows[0].at("z")), 12345678.9);
  EXPECT_EQ(number(rows[0].at("scale")), a_sphere().scale);
  EXPECT_EQ(rows[0].at("type"), "sphere");
  EXPECT_EQ(rows[0].at("voters"), "2");
  EXPECT_EQ(rows[1].at("type"), "tube");
  EXPECT_EQ(number(rows[1].at("axis_z")), 1);
  EXPECT_EQ(number(rows[1].at("curvature_x")), 0.125);
  EXPECT_EQ(rows[1].at("one_sided"), "1");
  EXPECT_EQ(rows[1].at("side"), "outside");
}

TEST(SalientPointsCSV, what_is_unknown_is_empty)
{
  std::ostringstream out;
  IO::write_salient_points_CSV(out,
                               std::vector<AP::Salient_point>{a_sphere(), AP::Salient_point()});
  const auto rows = rows_of(out.str());
  ASSERT_EQ(rows.size(), 2u);
  // A sphere has no axis, and so neither slope nor bend.
  for(const char* name : {"residual", "axis_x", "axis_z", "length", "slope", "curvature_y"})
    EXPECT_EQ(rows[0].at(name), "") << name;
  for(const char* name : {"radius", "scale", "intensity", "sphericity", "blobness", "radius_high"})
    EXPECT_EQ(rows[1].at(name), "") << name;
  EXPECT_EQ(rows[1].at("type"), "other");
  EXPECT_EQ(rows[1].at("voters"), "0");
  EXPECT_EQ(rows[1].at("one_sided"), "0");
}

TEST(SalientPointsPLY, faces_show_what_they_support)
{
  std::ostringstream out;
  const std::vector<AP::Salient_point> points{a_sphere(), a_bent_tube()};
  IO::PLY_options options;
  options.is_ascii = true;
  options.comments = {"two lines", "of comment"};
  IO::write_PLY(out, IO::salient_points_PLY(three_triangles(), points), options);
  const auto grey = IO::internal::colour_of_no_label;
  const auto colour = [](AP::Salient_shape shape, std::size_t rank) {
    std::string text;
    for(const int channel : IO::colour_of_salient_point(shape, rank))
      text += ' ' + std::to_string(channel);
    return text;
  };
  // Faces 0 and 2 are the sphere's, 1 and 5 the tube's; of these the surface has 0, 1 and 3.
  EXPECT_EQ(out.str(), "ply\nformat ascii 1.0\ncomment two lines\ncomment of comment\n"
                       "element vertex 4\nproperty double x\nproperty double y\nproperty double z\n"
                       "element face 3\nproperty list uchar int vertex_indices\n"
                       "property uchar red\nproperty uchar green\nproperty uchar blue\n"
                       "property int salient_point\nend_header\n"
                       "0 0 0\n1 0 0\n1 1 0\n0 1 0.3333333333333333\n"
                       "3 0 1 2" +
                           colour(AP::Salient_shape::SPHERE, 0) +
                           " 0\n"
                           "3 0 2 3" +
                           colour(AP::Salient_shape::TUBE, 1) +
                           " 1\n"
                           "3 1 2 3 " +
                           std::to_string(grey[0]) + ' ' + std::to_string(grey[1]) + ' ' +
                           std::to_string(grey[2]) + " -1\n");
}

TEST(SalientPointsPLY, binary_has_the_same_values)
{
  std::ostringstream out;
  IO::write_PLY(out, {IO::PLY_element("vertex", 2)
                          .add("x", std::vector<double>{1. / 3, -2})
                          .add("flag", std::vector<std::uint8_t>{7, 255}),
                      IO::PLY_element("face", 1).add_list("vertex_indices", {{0, 1, 70000}})});
  const std::string text = out.str(), end = "end_header\n";
  EXPECT_NE(text.find("format binary_little_endian 1.0\n"), std::string::npos);
  const std::string body = text.substr(text.find(end) + end.size());
  ASSERT_EQ(body.size(), 2 * (8 + 1) + 1 + 3 * 4u);
  double x = 0;
  std::memcpy(&x, body.data(), 8);
  EXPECT_EQ(x, 1. / 3);
  std::memcpy(&x, body.data() + 9, 8);
  EXPECT_EQ(x, -2);
  EXPECT_EQ(std::uint8_t(body[8]), 7);
  EXPECT_EQ(std::uint8_t(body[17]), 255);
  EXPECT_EQ(body[18], 3);
  std::int32_t index = 0;
  std::memcpy(&index, body.data() + 27, 4);
  EXPECT_EQ(index, 70000);
}

TEST(SalientPointsPLY, points_show_what_they_support)
{
  AP::Surfels surfels;
  for(std::uint32_t i = 0; i < 3; ++i)
    surfels.push_back(AP::Point_3(i, 0, 0), AP::Vector_3(0, 0, 1), 1, i);
  const std::vector<AP::Salient_point> points{a_bent_tube(), a_sphere()};
  // Point 2 supports both: the first counts.
  EXPECT_EQ(IO::supported_points(surfels.sources, points), (std::vector<std::int32_t>{1, 0, 0}));
  const auto elements = IO::salient_points_PLY(surfels, points);
  ASSERT_EQ(elements.size(), 1u);
  EXPECT_EQ(elements[0].size(), 3u);
  EXPECT_EQ(elements[0].properties().back().name, "salient_point");
}

TEST(SalientPointsPLY, refuses_what_ply_cannot_hold)
{
  IO::PLY_element element("vertex", 2);
  EXPECT_THROW(element.add("x", std::vector<double>{1}), std::invalid_argument);
  EXPECT_THROW(element.add("x", std::vector<std::int64_t>{1, 2}), std::invalid_argument);
  EXPECT_THROW(element.add_list("x", {{0, 1, 2}}), std::invalid_argument);
}

TEST(SalientPointsPLY, colours_tell_shapes_and_neighbours_apart)
{
  std::set<IO::internal::Colour> colours;
  for(std::size_t rank = 0; rank < 100; ++rank) {
    const auto sphere = IO::colour_of_salient_point(AP::Salient_shape::SPHERE, rank);
    const auto tube = IO::colour_of_salient_point(AP::Salient_shape::TUBE, rank);
    EXPECT_GT(sphere[0], sphere[2]); // warm
    EXPECT_LT(tube[0], tube[2]);     // cool
    EXPECT_EQ(tube, IO::colour_of_salient_point(AP::Salient_shape::CONE, rank));
    colours.insert(sphere);
    colours.insert(tube);
  }
  EXPECT_EQ(colours.size(), 200u);
  // The primary colours are where they belong.
  EXPECT_EQ(IO::internal::colour_of_hue(0, 1, 1), (IO::internal::Colour{255, 0, 0}));
  EXPECT_EQ(IO::internal::colour_of_hue(480, 1, 1), (IO::internal::Colour{0, 255, 0}));
  EXPECT_EQ(IO::internal::colour_of_hue(240, 1, 1), (IO::internal::Colour{0, 0, 255}));
  EXPECT_EQ(IO::internal::colour_of_hue(60, 1, 1), (IO::internal::Colour{255, 255, 0}));
  EXPECT_EQ(IO::internal::colour_of_hue(17, 0, 0.2), (IO::internal::Colour{51, 51, 51}));
}
