// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "input.h"

#include "errors.h"
#include "mesh_orientation.h"
#include "mesh_topology.h"
#include "mesh_triangulation.h"

#include <CGAL/Area_projection_transform/IO/number_text.h>
#include <CGAL/Area_projection_transform/normals_from_points.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <new>
#include <numeric>
#include <sstream>
#include <utility>

namespace mapt {

namespace {

Input_file load(const std::string& name)
{
  namespace fs = std::filesystem;
  Input_file file{name, {}};
  std::error_code error;
  const fs::file_status status = fs::status(name, error);
  if(status.type() == fs::file_type::not_found)
    file.fail("there is no such file: check its name and folder");
  if(status.type() == fs::file_type::directory)
    file.fail("is a directory: give a file in it");
  if(status.type() != fs::file_type::regular)
    file.fail("is not a regular file: copy what it holds into one");
  std::ifstream stream(name, std::ios::binary);
  if(!stream)
    file.fail("cannot be opened: check its permissions");
  const std::uintmax_t size = fs::file_size(name, error);
  if(size == 0)
    file.fail("is empty (0 bytes): export it again");
  file.bytes.resize(std::size_t(size));
  stream.read(&file.bytes[0], std::streamsize(size));
  file.bytes.resize(std::size_t(stream.gcount()));
  return file;
}

using Reader = Raw_mesh (*)(const Input_file&);

Reader reader_of(const Input_file& file)
{
  static const std::pair<const char*, Reader> readers[] = {{".off", read_off}, {".obj", read_obj},
                                                           {".ply", read_ply}, {".stl", read_stl},
                                                           {".vtp", read_vtp}, {".xyz", read_xyz}};
  std::string extension = std::filesystem::path(file.name).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return char(std::tolower(c)); });
  for(const auto& [known, reader] : readers)
    if(extension == known)
      return reader;
  file.fail((extension.empty() ? "has no extension" : "has the extension " + extension) +
            ": must be .off, .obj, .ply, .stl, .vtp or .xyz");
}

// Doubled areas and squared lengths: rounding leaves about 1e-16 of a flat triangle.
bool has_area(const Point_3& a, const Point_3& b, const Point_3& c)
{
  const double doubled_area = std::sqrt(CGAL::cross_product(b - a, c - a).squared_length());
  const double longest = std::max(
      {CGAL::squared_distance(a, b), CGAL::squared_distance(b, c), CGAL::squared_distance(c, a)});
  return doubled_area > 1e-14 * longest;
}

// Keeps the triangles t for which `is_kept(t)` holds, with their source faces.
template <class Predicate>
void keep_if(std::vector<Triangle>& triangles, std::vector<std::uint32_t>& source_faces,
             const Predicate& is_kept)
{
  std::size_t kept = 0;
  for(std::size_t t = 0; t < triangles.size(); ++t)
    if(is_kept(t)) {
      triangles[kept] = triangles[t];
      source_faces[kept++] = source_faces[t];
    }
  triangles.resize(kept);
  source_faces.resize(kept);
}

bool has_area(const Input& input, const Triangle& t)
{
  return has_area(input.points[t[0]], input.points[t[1]], input.points[t[2]]);
}

// Vertices are those of the file, unless joining the ones at the same position closes gaps, as in a
// soup: a vertex doubled on purpose, where a shape touches itself, stays two.
std::vector<std::uint32_t> choose_vertices(const std::vector<std::uint32_t>& by_position,
                                           Input& input)
{
  Mesh_report& report = input.report;
  std::vector<std::uint32_t> as_in_file(by_position.size());
  std::iota(as_in_file.begin(), as_in_file.end(), 0u);
  for(std::uint32_t i = 0; i < by_position.size(); ++i)
    report.duplicate_vertices += by_position[i] != i ? 1 : 0;
  if(report.duplicate_vertices == 0)
    return as_in_file;
  const std::size_t gaps = analyse(input.points, as_in_file, input.triangles).boundary_edges;
  if(gaps == 0)
    return as_in_file;
  report.are_duplicates_joined =
      analyse(input.points, by_position, input.triangles).boundary_edges < gaps;
  return report.are_duplicates_joined ? by_position : as_in_file;
}

void drop_flat_triangles(Input& input)
{
  keep_if(input.triangles, input.source_faces,
          [&input](std::size_t t) { return has_area(input, input.triangles[t]); });
}

// Triangles without an area may be the bridge between their neighbours or a loose flap. They take
// part in how faces hang together unless there are fewer gaps without them.
void drop_flat_triangles_that_gape(const std::vector<std::uint32_t>& joined, Input& input)
{
  std::vector<Triangle> solid;
  std::copy_if(input.triangles.begin(), input.triangles.end(), std::back_inserter(solid),
               [&input](const Triangle& t) { return has_area(input, t); });
  if(solid.size() < input.triangles.size() &&
     analyse(input.points, joined, solid).boundary_edges <=
         analyse(input.points, joined, input.triangles).boundary_edges)
    drop_flat_triangles(input);
}

// Turns faces over as asked and as needed; returns the topology that they have then.
Mesh_topology orient(const std::vector<std::uint32_t>& joined, const Reading_options& options,
                     Input& input)
{
  Mesh_report& report = input.report;
  Mesh_topology topology = analyse(input.points, joined, input.triangles);
  if(options.orient && topology.inconsistent_edges > 0) {
    report.faces_reoriented = orient_consistently(input.points, joined, input.triangles);
    topology = analyse(input.points, joined, input.triangles);
  }
  if(options.flip) {
    flip(input.triangles);
    report.was_flipped = true;
    topology = analyse(input.points, joined, input.triangles);
  }
  const std::vector<bool> is_inward = find_inward_components(topology);
  report.components_found_inward =
      std::size_t(std::count(is_inward.begin(), is_inward.end(), true));
  if(report.components_found_inward > 0 && !options.flip) {
    flip_components(topology, is_inward, input.triangles);
    report.is_orientation_repaired = true;
    topology = analyse(input.points, joined, input.triangles);
  }
  if(!options.flip)
    report.open_components_inward = count_open_inward_components(topology);
  return topology;
}

void describe(const Mesh_topology& topology, Mesh_report& report)
{
  report.unused_vertices = topology.unused_vertices;
  report.boundary_edges = topology.boundary_edges;
  report.holes = topology.holes;
  report.nonmanifold_edges = topology.nonmanifold_edges;
  report.inconsistent_edges = topology.inconsistent_edges;
  report.components = topology.components.size();
  report.is_closed = report.is_consistently_oriented = true;
  double volume = 0;
  for(const Mesh_topology::Component& c : topology.components) {
    report.is_closed = report.is_closed && c.is_closed;
    report.is_consistently_oriented = report.is_consistently_oriented && c.is_consistently_oriented;
    report.area += c.area;
    report.bounding_box += c.box;
    volume += c.volume;
  }
  if(report.is_closed && report.is_consistently_oriented) {
    report.signed_volume = volume;
    const long long doubled_genus =
        2 * (long long)(report.components) - topology.euler_characteristic;
    if(report.nonmanifold_edges == 0 && doubled_genus >= 0 && doubled_genus % 2 == 0)
      report.genus = std::size_t(doubled_genus / 2); // else a vertex is pinched
  }
}

void check_size(const Input_file& file, const CGAL::Bbox_3& box, const char* elements)
{
  const double extent = std::max({box.x_span(), box.y_span(), box.z_span()});
  if(extent > 1 / largest_coordinate)
    return;
  std::ostringstream text;
  text << "all " << elements << " are within 1e-15 of (" << box.xmin() << ", " << box.ymin() << ", "
       << box.zmin() << "): the shape has no size; rescale it, or export it with more digits";
  file.fail(text.str());
}

void take_mesh(const Input_file& file, Raw_mesh&& raw, const Reading_options& options, Input& input)
{
  Mesh_report& report = input.report;
  report.faces = raw.polygons.size();
  check_size(file, CGAL::bbox_3(raw.points.begin(), raw.points.end()), "vertices");
  Triangulation triangulation = triangulate(raw.points, raw.polygons);
  input.points = std::move(raw.points);
  input.triangles = std::move(triangulation.triangles);
  input.source_faces = std::move(triangulation.source_faces);
  report.polygons_triangulated = triangulation.polygons;

  const std::vector<std::uint32_t> by_position = join_equal_points(input.points);
  keep_if(input.triangles, input.source_faces, [&](std::size_t t) {
    const Triangle& v = input.triangles[t];
    return by_position[v[0]] != by_position[v[1]] && by_position[v[1]] != by_position[v[2]] &&
           by_position[v[2]] != by_position[v[0]];
  });
  const std::vector<std::uint32_t> joined = choose_vertices(by_position, input);
  drop_flat_triangles_that_gape(joined, input);
  describe(orient(joined, options, input), report);
  drop_flat_triangles(input);
  if(input.triangles.empty())
    file.fail("has no face with an area (" + std::to_string(report.faces) +
              " faces, all degenerate): export it again with more digits");
  report.triangles = input.triangles.size();
  report.degenerate_faces = report.faces;
  for(std::size_t t = 0; t < input.source_faces.size(); ++t)
    if(t == 0 || input.source_faces[t] != input.source_faces[t - 1])
      --report.degenerate_faces;
}

// Those that could not be oriented are null, as normals of a file may be.
std::vector<Vector_3> estimate_normals(const Input_file& file, const std::vector<Point_3>& points,
                                       Mesh_report& report)
{
  using Tag = CGAL::Parallel_if_available_tag;
  try {
    auto estimated = CGAL::Area_projection::normals_from_points<Tag>(points);
    report.normal_neighbours = estimated.number_of_neighbours;
    report.points_unoriented = estimated.unoriented.size();
    report.components = estimated.number_of_parts;
    return std::move(estimated.normals);
  } catch(const std::invalid_argument& error) {
    file.fail("its normals cannot be estimated: " + std::string(error.what()) +
              "; give it more points, or normals");
  }
}

void take_normals(const Input_file& file, const Reading_options& options, Raw_mesh& raw,
                  Mesh_report& report)
{
  if(options.estimate_normals && !raw.normals.empty())
    throw Usage_error("--estimate-normals: " + file.name + " has normals: leave it out");
  if(options.estimate_normals)
    raw.normals = estimate_normals(file, raw.points, report);
  if(raw.normals.empty())
    file.fail(
        "has " + std::to_string(raw.points.size()) +
        " points, but no faces and no normals: use --estimate-normals, give the points outward "
        "normals (nx ny nz), or export the faces");
}

void take_points(const Input_file& file, Raw_mesh&& raw, const Reading_options& options,
                 Input& input)
{
  Mesh_report& report = input.report;
  take_normals(file, options, raw, report);
  input.is_point_set = true;
  for(std::size_t i = 0; i < raw.points.size(); ++i) {
    const Vector_3& n = raw.normals[i];
    const auto fail = [&](const std::string& what) {
      file.fail("point " + std::to_string(i) + what);
    };
    if(!is_usable(n.x(), n.y(), n.z()))
      fail(" has a normal that is not finite or longer than 1e15: correct it, or remove the point");
    if(!raw.areas.empty() &&
       !(raw.areas[i] >= 0 && raw.areas[i] <= largest_coordinate * largest_coordinate))
      fail(" has the area " + CGAL::Area_projection::IO::to_text(raw.areas[i]) +
           ": must be from 0 to 1e30");
    const double length = std::sqrt(n.squared_length());
    if(!(length > 0)) {
      report.points_without_normal += options.estimate_normals ? 0 : 1;
      continue;
    }
    input.points.push_back(raw.points[i]);
    input.source_points.push_back(std::uint32_t(i));
    input.normals.push_back(n / (options.flip ? -length : length));
    if(!raw.areas.empty())
      input.areas.push_back(raw.areas[i]);
  }
  if(input.points.empty())
    file.fail("all " + std::to_string(raw.points.size()) +
              (options.estimate_normals
                   ? " points lie on lines or apart: give it points of a surface, or normals"
                   : " points have a normal of length 0: use --estimate-normals without them"));
  report.was_flipped = options.flip;
  report.bounding_box = CGAL::bbox_3(input.points.begin(), input.points.end());
  check_size(file, report.bounding_box, "points");
  report.area = std::accumulate(input.areas.begin(), input.areas.end(), 0.);
  if(!input.areas.empty() && !(report.area > 0))
    file.fail("all areas of its points are 0: give them areas, or leave the areas out");
}

} // namespace

Input read_input(const Input_file& file, const Reading_options& options)
{
  Raw_mesh raw = reader_of(file)(file);
  if(raw.points.empty())
    file.fail("has no vertices: the mesh is empty; export it again");
  if(std::max(raw.points.size(), raw.polygons.vertices.size()) > 0xffffffffu)
    file.fail("has more than 4294967295 vertices or corners: simplify the mesh");
  Input input;
  input.file = file.name;
  input.report.vertices = raw.points.size();
  if(raw.polygons.size() > 0 && options.estimate_normals)
    throw Usage_error("--estimate-normals: " + file.name +
                      " has faces, which tell the normals: leave it out");
  if(raw.polygons.size() > 0)
    take_mesh(file, std::move(raw), options, input);
  else
    take_points(file, std::move(raw), options, input);
  return input;
}

Input read_input(const std::string& name, const Reading_options& options)
{
  try {
    return read_input(load(name), options);
  } catch(const std::bad_alloc&) {
    throw Input_error(name + ": does not fit into the memory: simplify the mesh");
  }
}

} // namespace mapt
