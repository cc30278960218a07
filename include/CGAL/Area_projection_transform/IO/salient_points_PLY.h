// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_IO_SALIENT_POINTS_PLY_H
#define CGAL_AREA_PROJECTION_TRANSFORM_IO_SALIENT_POINTS_PLY_H

#include <CGAL/Area_projection_transform/IO/PLY.h>
#include <CGAL/Area_projection_transform/Surfels.h>
#include <CGAL/Area_projection_transform/Triangle_surface.h>
#include <CGAL/Area_projection_transform/salient_points/Salient_point.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Area_projection {
namespace IO {

/// \cond SKIP_IN_MANUAL
namespace internal {

using Colour = std::array<std::uint8_t, 3>; // red, green, blue

constexpr Colour colour_of_no_point{150, 150, 155};

/// the colour of a hue in degrees, with a saturation and a brightness in [0, 1].
inline Colour colour_of_hue(double hue, double saturation, double brightness)
{
  Colour colour;
  for(int c = 0; c < 3; ++c) {
    const double place = std::fmod(hue + 600 - 120 * c, 360.) / 60; // 4 at the hue of the channel
    const double share = std::clamp(2 - std::abs(place - 4), 0., 1.);
    colour[std::size_t(c)] =
        std::uint8_t(std::lround(255 * brightness * (1 - saturation * (1 - share))));
  }
  return colour;
}

/// a range of hues, in degrees.
struct Hues
{
  double first, extent;
};

inline Hues hues_of(Salient_shape shape)
{
  switch(shape) {
  case Salient_shape::SPHERE:
    return {335, 85}; // crimson to yellow
  case Salient_shape::TUBE:
  case Salient_shape::CONE:
    return {165, 100}; // turquoise to blue
  case Salient_shape::OTHER:
    break;
  }
  return {280, 40}; // violet
}

} // namespace internal
/// \endcond

/// \ingroup PkgAreaProjectionTransformIO
/// \brief returns a colour (red, green, blue) for the salient point of that rank in a list: warm for spheres,
/// cool for tubes and cones, violet for others.
///
/// Hues are steps of the golden angle within their range, so that neighbours in the list differ clearly.
inline std::array<std::uint8_t, 3> colour_of_salient_point(Salient_shape shape, std::size_t rank)
{
  constexpr double golden_ratio = 0.6180339887498949;
  constexpr double brightness[] = {1, 0.72, 0.88};
  constexpr double saturation[] = {0.85, 0.85, 0.55};
  const internal::Hues hues = internal::hues_of(shape);
  const double place = std::fmod(double(rank) * golden_ratio, 1.);
  return internal::colour_of_hue(hues.first + hues.extent * place, saturation[rank % 3],
                                 brightness[rank % 3]);
}

/// \ingroup PkgAreaProjectionTransformIO
/// \brief returns for each element of an input, a face or a point, the position in `points` of the first one
/// that it supports, or -1.
/// \param sources the elements that are asked for, as `Triangle_surface::sources`
template <class SalientPointRange>
std::vector<std::int32_t> supported_points(const std::vector<std::uint32_t>& sources,
                                           const SalientPointRange& points)
{
  const auto last = std::max_element(sources.begin(), sources.end());
  std::vector<std::int32_t> of_source(last == sources.end() ? 0 : std::size_t(*last) + 1, -1);
  std::int32_t index = 0;
  for(const Salient_point& point : points) {
    for(const std::uint32_t voter : point.voters)
      if(voter < of_source.size() && of_source[voter] < 0)
        of_source[voter] = index;
    ++index;
  }
  std::vector<std::int32_t> supported;
  supported.reserve(sources.size());
  for(const std::uint32_t source : sources)
    supported.push_back(of_source[source]);
  return supported;
}

/// \ingroup PkgAreaProjectionTransformIO
/// \brief returns a mesh of which the faces show what they support, for `write_PLY()`.
///
/// The elements are `vertex`, with `x`, `y`, `z`, and `face`, with `vertex_indices`, `red`, `green`, `blue`
/// and `salient_point`: the position in `points` of the one that the face supports (the first, if there are
/// several), or -1. All vertices and triangles of the surface are there, in its order. Faces that support the
/// same point have the same colour, `colour_of_salient_point()`; those that support none are grey.
template <class SalientPointRange>
std::vector<PLY_element> salient_points_PLY(const Triangle_surface& surface,
                                            const SalientPointRange& points);

/// \ingroup PkgAreaProjectionTransformIO
/// \brief returns a point set that shows what its points support, for `write_PLY()`.
///
/// As for meshes, but everything is in the element `vertex`, which has the normals `nx`, `ny`, `nz`, too.
template <class SalientPointRange>
std::vector<PLY_element> salient_points_PLY(const Surfels& surfels,
                                            const SalientPointRange& points);

/// \cond SKIP_IN_MANUAL
namespace internal {

/// writes what the elements of an input support into properties of a PLY element.
template <class SalientPointRange>
void add_salient_points(const std::vector<std::uint32_t>& sources, const SalientPointRange& points,
                        PLY_element& element)
{
  std::vector<Colour> colours;
  for(const Salient_point& point : points)
    colours.push_back(colour_of_salient_point(point.shape, colours.size()));
  std::vector<std::int32_t> supported = supported_points(sources, points);
  std::array<std::vector<std::uint8_t>, 3> channels;
  for(const std::int32_t point : supported) {
    const Colour& colour = point < 0 ? colour_of_no_point : colours[std::size_t(point)];
    for(std::size_t c = 0; c < channels.size(); ++c)
      channels[c].push_back(colour[c]);
  }
  constexpr const char* names[] = {"red", "green", "blue"};
  for(std::size_t c = 0; c < channels.size(); ++c)
    element.add(names[c], std::move(channels[c]));
  element.add("salient_point", std::move(supported));
}

/// adds the three coordinates of points or vectors.
template <class Triple>
void add_coordinates(const std::array<const char*, 3>& names, const std::vector<Triple>& triples,
                     PLY_element& element)
{
  for(int axis = 0; axis < 3; ++axis) {
    std::vector<double> coordinates;
    coordinates.reserve(triples.size());
    for(const Triple& triple : triples)
      coordinates.push_back(triple[axis]);
    element.add(names[std::size_t(axis)], std::move(coordinates));
  }
}

} // namespace internal
/// \endcond

template <class SalientPointRange>
std::vector<PLY_element> salient_points_PLY(const Triangle_surface& surface,
                                            const SalientPointRange& points)
{
  PLY_element vertices("vertex", surface.points.size());
  internal::add_coordinates({"x", "y", "z"}, surface.points, vertices);
  PLY_element faces("face", surface.size());
  faces.add_list("vertex_indices", surface.triangles);
  internal::add_salient_points(surface.sources, points, faces);
  return {std::move(vertices), std::move(faces)};
}

template <class SalientPointRange>
std::vector<PLY_element> salient_points_PLY(const Surfels& surfels, const SalientPointRange& points)
{
  PLY_element vertices("vertex", surfels.size());
  internal::add_coordinates({"x", "y", "z"}, surfels.positions, vertices);
  internal::add_coordinates({"nx", "ny", "nz"}, surfels.normals, vertices);
  internal::add_salient_points(surfels.sources, points, vertices);
  return {std::move(vertices)};
}

} // namespace IO
} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_IO_SALIENT_POINTS_PLY_H
