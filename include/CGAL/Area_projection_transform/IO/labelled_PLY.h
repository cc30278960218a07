// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_IO_LABELLED_PLY_H
#define CGAL_AREA_PROJECTION_TRANSFORM_IO_LABELLED_PLY_H

#include <CGAL/Area_projection_transform/IO/PLY.h>
#include <CGAL/Area_projection_transform/Surfels.h>
#include <CGAL/Area_projection_transform/Triangle_surface.h>

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

constexpr Colour colour_of_no_label{150, 150, 155};

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

/// \brief the colour of a place in a list: steps of the golden angle within a range of hues, so that neighbours in
/// the list differ clearly.
inline Colour colour_of_rank(const Hues& hues, std::size_t rank)
{
  constexpr double golden_ratio = 0.6180339887498949;
  constexpr double brightness[] = {1, 0.72, 0.88};
  constexpr double saturation[] = {0.85, 0.85, 0.55};
  const double place = std::fmod(double(rank) * golden_ratio, 1.);
  return colour_of_hue(hues.first + hues.extent * place, saturation[rank % 3],
                       brightness[rank % 3]);
}

/// what belongs to which label: features that the elements of a surface support.
struct Labels
{
  std::string name;                     ///< of the property
  std::vector<std::int32_t> of_element; ///< of each face or point; -1: none
  std::vector<Colour> colours;          ///< of each label
};

/// \brief returns a label for each of `sources`: the position in `features` of the first one that has it among its
/// `voters`, or -1.
template <class FeatureRange>
std::vector<std::int32_t> labels_of(const std::vector<std::uint32_t>& sources,
                                    const FeatureRange& features)
{
  const auto last = std::max_element(sources.begin(), sources.end());
  std::vector<std::int32_t> of_source(last == sources.end() ? 0 : std::size_t(*last) + 1, -1);
  std::int32_t index = 0;
  for(const auto& feature : features) {
    for(const std::uint32_t voter : feature.voters)
      if(voter < of_source.size() && of_source[voter] < 0)
        of_source[voter] = index;
    ++index;
  }
  std::vector<std::int32_t> labels;
  labels.reserve(sources.size());
  for(const std::uint32_t source : sources)
    labels.push_back(of_source[source]);
  return labels;
}

/// writes labels into properties of a PLY element, with their colours.
inline void add_labels(Labels labels, PLY_element& element)
{
  std::array<std::vector<std::uint8_t>, 3> channels;
  for(const std::int32_t label : labels.of_element) {
    const Colour& colour = label < 0 ? colour_of_no_label : labels.colours[std::size_t(label)];
    for(std::size_t c = 0; c < channels.size(); ++c)
      channels[c].push_back(colour[c]);
  }
  constexpr const char* names[] = {"red", "green", "blue"};
  for(std::size_t c = 0; c < channels.size(); ++c)
    element.add(names[c], std::move(channels[c]));
  element.add(labels.name, std::move(labels.of_element));
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

/// a mesh of which the faces show their labels.
inline std::vector<PLY_element> labelled_PLY(const Triangle_surface& surface, Labels labels)
{
  PLY_element vertices("vertex", surface.points.size());
  add_coordinates({"x", "y", "z"}, surface.points, vertices);
  PLY_element faces("face", surface.size());
  faces.add_list("vertex_indices", surface.triangles);
  add_labels(std::move(labels), faces);
  return {std::move(vertices), std::move(faces)};
}

/// points that show their labels.
inline std::vector<PLY_element> labelled_PLY(const Surfels& surfels, Labels labels)
{
  PLY_element vertices("vertex", surfels.size());
  add_coordinates({"x", "y", "z"}, surfels.positions, vertices);
  add_coordinates({"nx", "ny", "nz"}, surfels.normals, vertices);
  add_labels(std::move(labels), vertices);
  return {std::move(vertices)};
}

} // namespace internal
/// \endcond

} // namespace IO
} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_IO_LABELLED_PLY_H
