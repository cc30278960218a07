// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_IO_MEDIAL_BALLS_PLY_H
#define CGAL_AREA_PROJECTION_TRANSFORM_IO_MEDIAL_BALLS_PLY_H

#include <CGAL/Area_projection_transform/IO/PLY.h>
#include <CGAL/Area_projection_transform/medial_balls/Medial_ball.h>
#include <CGAL/Area_projection_transform/medial_complex.h>

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Area_projection {
namespace IO {

/// \ingroup PkgAreaProjectionTransformIO
/// \brief returns medial balls as the vertices of a file, for `write_PLY()`.
///
/// The properties are `x`, `y`, `z`, `radius`, `mapt`, `lambda`, `angle` (degrees), `scale_axis`, `kept` (1 or 0), `spread`,
/// `refitted_x`, `refitted_y`, `refitted_z`, `refitted_radius` and `source`, as the members of `Medial_ball`. A ball that no
/// other one is larger than has the `scale_axis` infinity.
/// \param balls the balls
/// \param kept positions in `balls` of those that were selected
/// \param only_kept whether the others are left out
/// \throw std::invalid_argument if one of `kept` is out of range
inline std::vector<PLY_element> medial_balls_PLY(const std::vector<Medial_ball>& balls,
                                                 const std::vector<std::size_t>& kept,
                                                 bool only_kept = false)
{
  std::vector<std::uint8_t> is_kept(balls.size(), 0);
  for(const std::size_t i : kept) {
    if(i >= balls.size())
      throw std::invalid_argument("kept names ball " + std::to_string(i) + " of " +
                                  std::to_string(balls.size()));
    is_kept[i] = 1;
  }
  std::vector<std::size_t> rows;
  for(std::size_t i = 0; i < balls.size(); ++i)
    if(is_kept[i] != 0 || !only_kept)
      rows.push_back(i);
  PLY_element vertices("vertex", rows.size());
  const auto add = [&](const char* name, auto value_of) {
    std::vector<double> values;
    for(const std::size_t i : rows)
      values.push_back(value_of(balls[i]));
    vertices.add(name, std::move(values));
  };
  using Ball = Medial_ball;
  add("x", [](const Ball& b) { return b.center.x(); });
  add("y", [](const Ball& b) { return b.center.y(); });
  add("z", [](const Ball& b) { return b.center.z(); });
  add("radius", [](const Ball& b) { return b.radius; });
  add("mapt", [](const Ball& b) { return b.mapt; });
  add("lambda", [](const Ball& b) { return b.lambda; });
  add("angle", [](const Ball& b) { return b.angle; });
  add("scale_axis", [](const Ball& b) { return b.scale_axis; });
  std::vector<std::uint8_t> flags;
  std::vector<std::uint32_t> sources;
  for(const std::size_t i : rows) {
    flags.push_back(is_kept[i]);
    sources.push_back(balls[i].source);
  }
  vertices.add("kept", std::move(flags));
  add("spread", [](const Ball& b) { return b.spread; });
  add("refitted_x", [](const Ball& b) { return b.refitted_center.x(); });
  add("refitted_y", [](const Ball& b) { return b.refitted_center.y(); });
  add("refitted_z", [](const Ball& b) { return b.refitted_center.z(); });
  add("refitted_radius", [](const Ball& b) { return b.refitted_radius; });
  vertices.add("source", std::move(sources));
  return {vertices};
}

/// \ingroup PkgAreaProjectionTransformIO
/// \brief the same, and how the balls are connected: elements `face` with `vertex_indices`, and `edge` with `vertex1` and
/// `vertex2`.
/// \param balls all of them
/// \param kept positions in `balls` of those that were selected
/// \param complex that of the selected balls
/// \param only_kept whether the others are left out
/// \throw std::invalid_argument also if the complex has a ball that is left out
inline std::vector<PLY_element> medial_balls_PLY(const std::vector<Medial_ball>& balls,
                                                 const std::vector<std::size_t>& kept,
                                                 const Medial_complex& complex,
                                                 bool only_kept = false)
{
  std::vector<PLY_element> elements = medial_balls_PLY(balls, kept, only_kept);
  std::vector<bool> is_written(balls.size(), !only_kept);
  for(const std::size_t i : kept)
    is_written[i] = true;
  std::vector<std::uint32_t> rows;
  for(std::size_t i = 0, row = 0; i < balls.size(); ++i)
    rows.push_back(std::uint32_t(is_written[i] ? row++ : 0));
  const auto row_of = [&](std::uint32_t ball) {
    if(ball >= balls.size() || !is_written[ball])
      throw std::invalid_argument("complex has ball " + std::to_string(ball) +
                                  ", which is not written");
    return rows[ball];
  };
  std::vector<std::int32_t> first, second;
  for(const auto& [a, b] : complex.edges) {
    first.push_back(std::int32_t(row_of(a)));
    second.push_back(std::int32_t(row_of(b)));
  }
  PLY_element::Triangles triangles;
  for(const auto& [a, b, c] : complex.triangles)
    triangles.push_back({row_of(a), row_of(b), row_of(c)});
  // Edges last: VTK's reader takes what follows an element that it does not know for the next one that it does.
  elements.emplace_back("face", triangles.size());
  elements.back().add_list("vertex_indices", std::move(triangles));
  elements.emplace_back("edge", first.size());
  elements.back().add("vertex1", std::move(first)).add("vertex2", std::move(second));
  return elements;
}

} // namespace IO
} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_IO_MEDIAL_BALLS_PLY_H
