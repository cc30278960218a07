// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MAPT_SURFACE_H
#define MAPT_SURFACE_H

#include "command_line.h"
#include "input.h"

#include <CGAL/Area_projection_transform/Projected_surfels.h>
#include <CGAL/Area_projection_transform/Side.h>
#include <CGAL/Area_projection_transform/Triangle_surface.h>

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <variant>

namespace mapt {

namespace AP = CGAL::Area_projection;

/// how normals are taken from an input.
struct Surface_options
{
  std::string normals = "face";
  std::optional<double> smoothing_ratio; // of the radius; default: that of the library

  bool is_smoothing() const { return normals == "averaged" || normals == "smoothed"; }
  /// the ratio that counts, if any does.
  std::optional<double> used_smoothing_ratio() const;
};

/// adds --normals and --smoothing-ratio.
void add_surface_options(CLI::App& app, Surface_options& options);

/// \throw Usage_error if a ratio is given and nothing is smoothed.
void check(const Surface_options& options);

/// an input as the library wants it: a scale space of triangles or points, behind one type, so that what
/// computes with it is compiled once.
/// \cgalModels `TriangleScaleSpace`
class Surface
{
public:
  using Source = std::variant<const AP::Triangle_surface*, const AP::Surfels*>;
  using Batch_sink = std::function<void(const AP::Projected_surfels&)>;

  virtual ~Surface() = default;

  /// the surface before smoothing.
  virtual Source source() const = 0;
  virtual double area(double radius) const = 0;
  virtual void project_to(double radius, AP::Side side, double spacing,
                          const Batch_sink& sink) const = 0;
  /// \pre the source are triangles
  virtual std::shared_ptr<const AP::Triangle_surface> triangles(double radius) const = 0;

  template <class Sink>
  void project(double radius, AP::Side side, double spacing, Sink&& sink) const
  {
    project_to(radius, side, spacing, std::ref(sink));
  }

  CGAL::Bbox_3 bbox() const
  {
    return std::visit([](const auto* s) { return s->bbox(); }, source());
  }

  /// in squared units of the input, before smoothing.
  double total_area() const
  {
    return std::visit([](const auto* s) { return s->total_area(); }, source());
  }

  std::size_t number_of_elements() const
  {
    return std::visit([](const auto* s) { return s->size(); }, source());
  }
};

/// \param threads how many threads will use the surface at a time
/// \throw Usage_error if the input has no such normals.
std::shared_ptr<const Surface> make_surface(const Input& input, const Surface_options& options,
                                            std::size_t threads);

/// what `make_surface()` takes for each triangle or point, measured, in bytes.
double bytes_per_element(const Surface_options& options, std::size_t threads);

} // namespace mapt

#endif // MAPT_SURFACE_H
