// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Features of small soups, with options of all kinds: what is not refused is consistent.

#include "fuzz_soup.h"

#include <CGAL/Area_projection_transform/centerlines.h>
#include <CGAL/Area_projection_transform/medial_balls.h>
#include <CGAL/Area_projection_transform/salient_points.h>
#include <CGAL/Area_projection_transform/shape_descriptor.h>

#include <algorithm>
#include <optional>
#include <set>
#include <stdexcept>

namespace {

namespace AP = CGAL::Area_projection;
using fuzz::Bytes;
using fuzz::Coordinates;
using fuzz::require;

AP::Side side_of(Bytes& bytes)
{
  return bytes.choice(2) == 0 ? AP::Side::INSIDE : AP::Side::OUTSIDE;
}

/// mostly nothing, sometimes a length that suits, seldom any number.
std::optional<double> length_of(Bytes& bytes, double low, double high)
{
  const std::size_t kind = bytes.choice(8);
  if(kind < 5)
    return std::nullopt;
  return kind < 7 ? bytes.between(low, high) : bytes.any();
}

void try_salient_points(const AP::Triangle_surface& surface, Bytes& bytes)
{
  AP::Salient_point_options options;
  options.side = side_of(bytes);
  options.smallest_radius = length_of(bytes, 0.1, 2);
  options.largest_radius = length_of(bytes, 0.1, 8);
  options.tube_spacing = length_of(bytes, 0.1, 4);
  std::set<std::uint32_t> voters;
  for(const AP::Salient_point& point : AP::salient_points(surface, options)) {
    require(point.intensity >= options.threshold, "intensities reach the threshold");
    require(!(point.observed_fraction < 0) && !(point.observed_fraction > 1 + 1e-9),
            "the observed part is a part");
    for(const std::uint32_t voter : point.voters)
      require(voter < surface.sources.back() + 1 && voters.insert(voter).second,
              "a face votes once");
  }
}

void try_centerlines(const AP::Triangle_surface& surface, Bytes& bytes)
{
  AP::Centerline_options options;
  options.side = side_of(bytes);
  options.smallest_radius = length_of(bytes, 0.1, 2);
  options.largest_radius = length_of(bytes, 0.1, 8);
  options.do_join = bytes.choice(2) == 0;
  options.do_extend = bytes.choice(2) == 0;
  const AP::Centerline_graph graph = AP::centerlines(surface, options);
  std::size_t edges = 0;
  for(const AP::Centerline_branch& branch : AP::branches(graph)) {
    require(branch.vertices.size() >= 2, "a branch has two vertices at least");
    edges += branch.vertices.size() - 1;
    for(const std::size_t v : branch.vertices)
      require(v < num_vertices(graph) && std::isfinite(graph[v].point.x()) && graph[v].radius > 0,
              "vertices of a branch have a place and a radius");
  }
  require(edges == num_edges(graph), "each edge belongs to one branch");
}

void try_medial_balls(const AP::Triangle_surface& surface, Bytes& bytes)
{
  AP::Medial_ball_options options;
  options.side = side_of(bytes);
  // The default has 8000 samples at least: too many for sanitizers.
  const CGAL::Bbox_3 box = surface.bbox();
  options.spacing = std::max({box.x_span(), box.y_span(), box.z_span()}) / 16;
  options.stop_angle = bytes.between(0.5, 179);
  options.crease_angle = bytes.between(0, 180);
  options.sigma_ratio = bytes.between(0.01, 0.99);
  for(const AP::Medial_ball& ball : AP::medial_balls(surface, options)) {
    require(ball.radius > 0 && std::isfinite(ball.center.x()), "a ball has a centre and a radius");
    require(ball.mapt >= 0, "the transform is not negative");
    require(ball.angle >= 0 && ball.angle <= 180.001, "an angle is one");
  }
}

void try_shape_descriptor(const AP::Triangle_surface& surface, Bytes& bytes)
{
  AP::Shape_descriptor_options options;
  options.scale_divisor = bytes.between(2, 12);
  options.binning = static_cast<AP::Binning>(bytes.choice(3));
  options.normals = static_cast<AP::Descriptor_normals>(bytes.choice(5));
  options.compensate = bytes.choice(2) == 0;
  double sum = 0;
  for(const float value : AP::shape_descriptor(surface, options).values) {
    require(value >= 0, "counts are not negative");
    sum += double(value);
  }
  require(std::abs(sum - 1) < 1e-4, "histograms sum to 1: " + std::to_string(sum));
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  Bytes bytes(data, size);
  const std::size_t feature = bytes.choice(4), kind = bytes.choice(6);
  Bytes of_options(data, std::min<std::size_t>(size, 40)); // they share bytes with the soup
  const shapes::Soup soup =
      kind >= 3 ? fuzz::damaged_soup(bytes) : fuzz::raw_soup(bytes, static_cast<Coordinates>(kind));
  try {
    const AP::Triangle_surface surface = shapes::surface_of(soup);
    if(surface.empty())
      return 0;
    if(feature == 0)
      try_salient_points(surface, of_options);
    else if(feature == 1)
      try_centerlines(surface, of_options);
    else if(feature == 2)
      try_medial_balls(surface, of_options);
    else
      try_shape_descriptor(surface, of_options);
  } catch(const std::invalid_argument& error) {
    fuzz::require_one_line(error.what());
  }
  return 0;
}
