// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Files of graphs made by hand; test_mapt_lines.py has them read by VTK.

#include <CGAL/Area_projection_transform/IO/centerlines_JSON.h>
#include <CGAL/Area_projection_transform/IO/centerlines_OBJ.h>
#include <CGAL/Area_projection_transform/IO/centerlines_PLY.h>
#include <CGAL/Area_projection_transform/IO/centerlines_SWC.h>
#include <CGAL/Area_projection_transform/IO/centerlines_VTP.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace AP = CGAL::Area_projection;
namespace IO = CGAL::Area_projection::IO;

namespace {

/// a graph of branches through vertices that lie on a parabola, so that no two are at the same place.
AP::Centerline_graph graph_of(std::size_t number,
                              const std::vector<std::vector<std::size_t>>& branches)
{
  AP::Centerline_graph graph(number);
  for(std::size_t v = 0; v < number; ++v) {
    graph[v].point = AP::Point_3(double(v), double(v * v), 1. / 3);
    graph[v].radius = double(v) + 0.5;
  }
  for(const std::vector<std::size_t>& vertices : branches) {
    AP::Centerline_branch branch;
    branch.vertices = vertices;
    for(std::size_t i = 0; i + 1 < vertices.size(); ++i)
      add_edge(vertices[i], vertices[i + 1], {graph[boost::graph_bundle].branches.size()}, graph);
    graph[boost::graph_bundle].branches.push_back(branch);
  }
  return graph;
}

AP::Centerline_graph letter_y()
{
  return graph_of(7, {{0, 1, 2}, {2, 3, 4}, {2, 5, 6}});
}

/// the contents of a file that `write(name)` makes.
template <class Write>
std::string written(const Write& write)
{
  const std::filesystem::path name =
      std::filesystem::temp_directory_path() /
      (std::string("centerlines_") + testing::UnitTest::GetInstance()->current_test_info()->name());
  write(name.string());
  std::ifstream in(name, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(in), {}};
  std::filesystem::remove(name);
  return text;
}

struct Sample
{
  long id, parent;
  double radius;
  AP::Point_3 point;
};

std::vector<Sample> samples_of(const AP::Centerline_graph& graph)
{
  std::istringstream in(
      written([&](const std::string& name) { IO::write_centerlines_SWC(name, graph); }));
  std::vector<Sample> samples;
  for(std::string line; std::getline(in, line);) {
    if(line[0] == '#')
      continue;
    std::istringstream words(line);
    Sample sample;
    int type;
    double x, y, z;
    words >> sample.id >> type >> x >> y >> z >> sample.radius >> sample.parent;
    EXPECT_TRUE(words);
    sample.point = AP::Point_3(x, y, z);
    samples.push_back(sample);
  }
  return samples;
}

using Edge = std::array<std::size_t, 2>;

/// the edges between samples and their parents, as vertices of the graph, whose x is their number.
std::vector<Edge> edges_of(const std::vector<Sample>& samples)
{
  const auto vertex = [](const Sample& sample) { return std::size_t(sample.point.x()); };
  std::vector<Edge> edges;
  for(const Sample& sample : samples)
    if(sample.parent > 0) {
      const Sample& parent = samples[std::size_t(sample.parent) - 1];
      edges.push_back(
          {std::min(vertex(sample), vertex(parent)), std::max(vertex(sample), vertex(parent))});
    }
  std::sort(edges.begin(), edges.end());
  return edges;
}

std::vector<Edge> edges_of(const AP::Centerline_graph& graph)
{
  std::vector<Edge> all;
  const auto [first, last] = edges(graph);
  for(auto e = first; e != last; ++e)
    all.push_back({std::min(source(*e, graph), target(*e, graph)),
                   std::max(source(*e, graph), target(*e, graph))});
  std::sort(all.begin(), all.end());
  return all;
}

/// samples count from 1, parents come first, and each edge of the graph is there once.
void expect_trees(const AP::Centerline_graph& graph, std::size_t number, std::ptrdiff_t roots)
{
  const std::vector<Sample> samples = samples_of(graph);
  EXPECT_EQ(samples.size(), number);
  for(std::size_t i = 0; i < samples.size(); ++i) {
    EXPECT_EQ(samples[i].id, long(i) + 1);
    EXPECT_LT(samples[i].parent, samples[i].id);
    EXPECT_EQ(samples[i].radius, samples[i].point.x() + 0.5);
  }
  EXPECT_EQ(std::count_if(samples.begin(), samples.end(),
                          [](const Sample& sample) { return sample.parent == -1; }),
            roots);
  EXPECT_EQ(edges_of(samples), edges_of(graph));
}

TEST(Centerlines_SWC, are_trees)
{
  expect_trees(letter_y(), 7, 1);
  expect_trees(graph_of(4, {{0, 1}, {2, 3}}), 4, 2);
  expect_trees(graph_of(0, {}), 0, 0);
}

// A graph with n vertices, e edges and p pieces has e - n + p independent cycles.
TEST(Centerlines_SWC, repeat_a_vertex_for_each_cycle)
{
  expect_trees(graph_of(4, {{0, 1, 2, 3, 0}}), 5, 1);
  expect_trees(graph_of(5, {{0, 1, 2}, {0, 3, 2}, {0, 4, 2}}), 5 + 2, 1);
  expect_trees(graph_of(2, {{0, 1}, {0, 1}}), 3, 1);
}

TEST(Centerlines_JSON, count_nodes_and_have_null_for_what_is_unknown)
{
  AP::Centerline_graph graph = letter_y();
  graph[1].radius = AP::Centerline_vertex::unknown;
  const std::string text =
      written([&](const std::string& name) { IO::write_centerlines_JSON(name, graph); });
  EXPECT_NE(text.find("\"radii\":[0.5,null,2.5]"), std::string::npos) << text;
  EXPECT_NE(text.find("{\"from\":1,\"to\":3,"), std::string::npos); // of the nodes 0, 2, 4, 6
  EXPECT_NE(text.find("\"nodes\":[[0,0,0.3333333333333333],[2,4,"), std::string::npos);
  EXPECT_EQ(text.find("nan"), std::string::npos);
}

TEST(Centerlines_OBJ, count_from_one)
{
  const std::string text =
      written([&](const std::string& name) { IO::write_centerlines_OBJ(name, letter_y()); });
  EXPECT_NE(text.find("\nl 1 2 3\n"), std::string::npos) << text;
  EXPECT_NE(text.find("\nl 3 6 7\n"), std::string::npos);
  EXPECT_EQ(std::count(text.begin(), text.end(), 'v'), 7);
}

TEST(Centerlines_VTP, name_the_pieces_of_the_file)
{
  const std::string text =
      written([&](const std::string& name) { IO::write_centerlines_VTP(name, letter_y()); });
  EXPECT_NE(text.find("NumberOfPoints=\"7\""), std::string::npos);
  EXPECT_NE(text.find("NumberOfLines=\"3\""), std::string::npos);
  EXPECT_NE(text.find("Name=\"radius\""), std::string::npos);
}

TEST(Centerlines_PLY, colour_faces_by_the_branch_that_they_surround)
{
  AP::Centerline_graph graph = letter_y();
  graph[boost::graph_bundle].branches[1].voters = {0, 2};
  AP::Triangle_surface surface;
  surface.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  surface.triangles = {{0, 1, 2}, {0, 1, 2}, {0, 1, 2}};
  surface.sources = {0, 1, 2};
  const auto elements = IO::centerlines_PLY(surface, graph);
  ASSERT_EQ(elements.size(), 2u);
  EXPECT_EQ(AP::branch_of_each(graph, surface.sources), (std::vector<std::int32_t>{1, -1, 1}));
  EXPECT_NE(IO::colour_of_branch(0), IO::colour_of_branch(1));
}

TEST(Centerlines, that_cannot_be_written_leave_nothing)
{
  EXPECT_THROW(IO::write_centerlines_SWC("no/such/folder/l.swc", letter_y()), IO::Output_error);
  EXPECT_THROW(IO::write_centerlines_VTP("no/such/folder/l.vtp", letter_y()), IO::Output_error);
}

} // namespace
