// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The transform of small soups, at parameters of all kinds: what is not refused is finite, between 0 and all of the
// area, and the same by the tree, by the grid and triangle by triangle.

#include "fuzz_soup.h"

#include <CGAL/Area_projection_transform/projection/Exact_evaluator.h>
#include <CGAL/Area_projection_transform/projection/Exact_grid_projector.h>
#include <CGAL/Area_projection_transform/projection/Grid_projector.h>

#include <algorithm>
#include <stdexcept>

namespace {

namespace AP = CGAL::Area_projection;
using fuzz::Bytes;
using fuzz::Coordinates;
using fuzz::require;

struct Parameters
{
  AP::Scale scale;
  double voxel;
  AP::Side side;
};

/// of one part in four any numbers, otherwise such as suit a shape that is some units wide.
Parameters parameters_of(Bytes& bytes)
{
  const AP::Side side = bytes.choice(2) == 0 ? AP::Side::INSIDE : AP::Side::OUTSIDE;
  if(bytes.choice(4) == 3) {
    const double radius = bytes.any(), sigma = bytes.any();
    return {{radius, sigma}, bytes.any(), side};
  }
  const double radius = bytes.between(0.01, 8), sigma = radius * bytes.between(0.01, 1);
  return {{radius, sigma}, bytes.between(0.5, 4), side};
}

/// what a user would wait for all day is not a defect: so few voxels and samples only.
bool is_small(const AP::Grid_3& grid, double area, const AP::Scale& scale)
{
  constexpr double most_voxels = 5000, most_samples = 5000;
  return double(grid.number_of_voxels()) <= most_voxels &&
         area / (scale.sigma * scale.sigma) <= most_samples && scale.sigma / grid.spacing() <= 100;
}

double triangle_by_triangle(const AP::Triangle_surface& surface, const AP::Point_3& x,
                            const Parameters& p, double sigma)
{
  const double distance = AP::internal::signed_distance(p.side, p.scale.radius);
  double area = 0;
  for(std::size_t t = 0; t < surface.size(); ++t)
    area += surface.areas[t] *
            AP::internal::projected_triangle(surface, t, distance).fraction_within(x, sigma);
  return area;
}

void require_in_bounds(double value, double area, const char* what)
{
  require(value >= 0 && value <= area * (1 + 1e-6),
          std::string(what) + " is between 0 and all area: " + std::to_string(value) + " of " +
              std::to_string(area));
}

/// \brief What a sum over all triangles differs from the tree by: where the rim of a ball passes is rounded, to some
/// 1e-15 of how far away all is from the ball and from the origin.
void compare_sum(const AP::Exact_evaluator& tree, const AP::Triangle_surface& surface,
                 const AP::Point_3& x, const Parameters& p, double area)
{
  const CGAL::Bbox_3 box = surface.bbox() + x.bbox() + AP::Point_3(0, 0, 0).bbox();
  const double extent =
      std::max({box.x_span(), box.y_span(), box.z_span(), p.scale.sigma, p.scale.radius});
  const double rim = 1e-14 * extent;
  double edges = 0;
  for(std::size_t t = 0; t < surface.size(); ++t)
    edges += AP::internal::projected_triangle(surface, t, 0).longest_edge();
  const double tolerance = 1e-9 * area + rim * edges;
  const double sum = triangle_by_triangle(surface, x, p, p.scale.sigma);
  require(sum >= tree(x, std::max(p.scale.sigma - rim, 0.)) - tolerance &&
              sum <= tree(x, p.scale.sigma + rim) + tolerance,
          "the tree sums the triangles");
}

/// \brief The grid knows places up to some 1e-6 of itself, so that its values are between those of a slightly smaller and a
/// slightly larger ball; each triangle is rounded to 2^-30 of all area.
void compare_grid(const AP::Constant_scale_space<AP::Triangle_surface>& surface,
                  const AP::Row_spans& region, const Parameters& p)
{
  const double area = surface.area(p.scale.radius);
  const auto map =
      shapes::areas_on_grid(AP::Exact_grid_projector(region), surface, region, p.scale, p.side);
  const AP::Exact_evaluator tree(surface, p.scale.radius, p.side);
  const double rim = 1e-5 * p.scale.sigma + 1e-4 * region.grid().spacing();
  const double tolerance = (1e-6 + double(surface.source().size()) * 0x1p-30) * area;
  std::size_t voxel = 0;
  shapes::for_each_voxel(region, [&](const AP::Point_3& x, std::size_t place) {
    require_in_bounds(map[place], area, "a value of the exact grid");
    if(voxel++ % 31 != 0)
      return;
    compare_sum(tree, surface.source(), x, p, area);
    const double exact = tree(x, p.scale.sigma);
    require(map[place] >= tree(x, std::max(p.scale.sigma - rim, 0.)) - tolerance &&
                map[place] <= tree(x, p.scale.sigma + rim) + tolerance,
            "the exact grid has what the tree has: " + std::to_string(map[place]) + " and " +
                std::to_string(exact) + " of " + std::to_string(area));
  });
}

void try_transform(const AP::Triangle_surface& triangles, const Parameters& p, bool is_tame)
{
  for(const auto& triangle : triangles.triangles)
    for(const std::uint32_t v : triangle)
      require(v < triangles.points.size(), "indices are in range");
  const AP::Constant_scale_space surface(triangles);
  const double area = surface.area(p.scale.radius);
  const AP::Exact_evaluator tree(surface, p.scale.radius, p.side);
  if(is_tame)
    require_in_bounds(tree(AP::Point_3(0, 0, 0), p.scale.sigma), area, "a value of the tree");
  const AP::Grid_3 grid = AP::grid_around(surface.bbox(), p.voxel);
  if(!is_small(grid, area, p.scale))
    return;
  const AP::Row_spans all(grid);
  const AP::Interior inside = AP::interior(triangles, grid);
  require(inside.coverage >= 0 && inside.coverage <= 1, "the coverage is a part");
  for(const AP::Row_spans* region : {&all, &inside.region}) {
    const auto map =
        shapes::areas_on_grid(AP::Grid_projector(*region), surface, *region, p.scale, p.side);
    if(is_tame)
      for(const float value : map)
        require_in_bounds(value, area, "a value of the grid");
  }
  // Where a shape is smaller than its distance is rounded to, it is in or out by chance.
  const CGAL::Bbox_3 box = surface.bbox();
  const double extent = std::max({box.x_span(), box.y_span(), box.z_span()});
  if(is_tame && p.scale.radius <= 1e4 * extent)
    compare_grid(surface, all, p);
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  Bytes bytes(data, size);
  const std::size_t kind = bytes.choice(4);
  const Parameters parameters = parameters_of(bytes);
  const shapes::Soup soup =
      kind == 3 ? fuzz::damaged_soup(bytes) : fuzz::raw_soup(bytes, static_cast<Coordinates>(kind));
  try {
    AP::internal::check_positive(parameters.scale.sigma, "sigma"); // as those do that make scales
    try_transform(shapes::surface_of(soup), parameters,
                  static_cast<Coordinates>(kind) != Coordinates::ANY);
  } catch(const std::invalid_argument& error) {
    fuzz::require_one_line(error.what());
  }
  return 0;
}
