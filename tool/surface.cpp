// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "surface.h"

#include "errors.h"
#include "text.h"

#include <CGAL/Area_projection_transform/areas_from_density.h>
#include <CGAL/Area_projection_transform/scale_space/Averaged_normals.h>
#include <CGAL/Area_projection_transform/scale_space/Constant_scale_space.h>
#include <CGAL/Area_projection_transform/scale_space/Mean_curvature_flow.h>
#include <CGAL/Area_projection_transform/scale_space/Smoothing_scale_space.h>
#include <CGAL/Area_projection_transform/surfels_from_mesh.h>

#include <numeric>
#include <type_traits>
#include <utility>

namespace mapt {

namespace {

AP::Surfels surfels_of(const Input& input)
{
  AP::Surfels surfels;
  surfels.positions = input.points;
  surfels.normals = input.normals;
  surfels.areas =
      !input.areas.empty()
          ? input.areas
          : AP::areas_from_density<CGAL::Parallel_if_available_tag>(input.points, input.normals);
  surfels.sources.resize(input.points.size());
  std::iota(surfels.sources.begin(), surfels.sources.end(), 0u);
  return surfels;
}

// A scale space of the library as a surface of the command.
template <class Scale_space>
class Surface_of : public Surface
{
public:
  explicit Surface_of(Scale_space scale_space) : m_scale_space(std::move(scale_space)) {}

  Source source() const override { return &m_scale_space.source(); }

  double area(double radius) const override { return m_scale_space.area(radius); }

  void project_to(double radius, AP::Side side, double spacing,
                  const Batch_sink& sink) const override
  {
    m_scale_space.project(radius, side, spacing, sink);
  }

  std::shared_ptr<const AP::Triangle_surface> triangles(double radius) const override
  {
    if constexpr(has_triangles)
      return m_scale_space.triangles(radius);
    else
      throw std::logic_error("points have no triangles");
  }

private:
  static constexpr bool has_triangles =
      std::is_same_v<std::decay_t<decltype(std::declval<Scale_space>().source())>,
                     AP::Triangle_surface>;

  Scale_space m_scale_space;
};

template <class Scale_space>
std::shared_ptr<const Surface> as_surface(Scale_space scale_space)
{
  return std::make_shared<const Surface_of<Scale_space>>(std::move(scale_space));
}

template <class Source>
std::shared_ptr<const Surface> averaged(Source source, const Surface_options& options,
                                        std::size_t threads)
{
  using Smoother = AP::Averaged_normals<Source>;
  return as_surface(AP::Smoothing_scale_space(
      Smoother(std::move(source), *options.used_smoothing_ratio()), threads));
}

std::shared_ptr<const Surface> surface_of_points(const Input& input, const Surface_options& options,
                                                 std::size_t threads)
{
  if(options.normals == "interpolated" || options.normals == "smoothed")
    throw Usage_error("--normals " + options.normals + ": " + input.file +
                      " has points only, with normals of their own; use face or averaged");
  AP::Surfels surfels = surfels_of(input);
  if(options.normals == "averaged")
    return averaged(std::move(surfels), options, threads);
  return as_surface(AP::Constant_scale_space(std::move(surfels)));
}

} // namespace

std::optional<double> Surface_options::used_smoothing_ratio() const
{
  if(!is_smoothing())
    return std::nullopt;
  return smoothing_ratio.value_or(normals == "averaged"
                                      ? AP::Averaged_normals<>::default_averaging_ratio
                                      : AP::Mean_curvature_flow::default_smoothing_ratio);
}

void add_surface_options(CLI::App& app, Surface_options& options)
{
  app.add_option("--normals", options.normals,
                 "face: constant on each face, the same at every radius; interpolated: between "
                 "those of the vertices; averaged: over a part of the surface that grows with the "
                 "radius, against noise and small bumps; smoothed: those of a surface that is "
                 "smoothed the more the larger the radius")
      ->check(
          CLI::IsMember(std::vector<std::string>{"face", "interpolated", "averaged", "smoothed"}))
      ->type_name("WORD")
      ->capture_default_str()
      ->group("Mesh");
  app.add_option("--smoothing-ratio", options.smoothing_ratio,
                 "averaged and smoothed: how far, as a fraction of the radius (default: " +
                     to_text(AP::Averaged_normals<>::default_averaging_ratio) + " and " +
                     to_text(AP::Mean_curvature_flow::default_smoothing_ratio) + ")")
      ->type_name("FRACTION")
      ->check(positive_number())
      ->group("Mesh");
}

void check(const Surface_options& options)
{
  if(options.smoothing_ratio && !options.is_smoothing())
    throw Usage_error("--smoothing-ratio has no effect on --normals " + options.normals +
                      ": add --normals averaged or smoothed");
}

std::shared_ptr<const Surface> make_surface(const Input& input, const Surface_options& options,
                                            std::size_t threads)
{
  if(input.is_point_set)
    return surface_of_points(input, options, threads);
  AP::Triangle_surface surface = AP::surface_from_triangle_soup(
      input.points, input.triangles,
      AP::parameters::use_interpolated_normals(options.normals == "interpolated"));
  if(options.normals == "averaged")
    return averaged(std::move(surface), options, threads);
  if(options.normals == "smoothed")
    return as_surface(AP::Smoothing_scale_space(
        AP::Mean_curvature_flow(std::move(surface), *options.used_smoothing_ratio()), threads));
  return as_surface(AP::Constant_scale_space(std::move(surface)));
}

double bytes_per_element(const Surface_options& options, std::size_t threads)
{
  // Beside the surface at each radius and what it takes to find it, less what is free again by then.
  constexpr double bytes_of_radius = 650, bytes_free = 150;
  return options.is_smoothing() ? bytes_of_radius * double(threads) - bytes_free
                                : 0; // the tree itself is part of every forecast
}

} // namespace mapt
