// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef AREA_PROJECTION_PAPER_RETRIEVAL_SET_H
#define AREA_PROJECTION_PAPER_RETRIEVAL_SET_H

#include "damage.h"

#include <CGAL/Area_projection_transform/retrieval.h>
#include <CGAL/Area_projection_transform/shape_descriptor.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace Paper {

namespace AP = CGAL::Area_projection;

/// shapes with their classes.
struct Labelled_set
{
  std::vector<Soup> shapes;
  AP::Class_labels labels;
};

/// \brief reads a folder with `labels.csv` or `labels.cla` and the meshes in `meshes`, in the order of their names.
/// \param most_classes how many of the classes, the first ones, are read
/// \throw std::runtime_error if there are no labels, or a mesh cannot be read
Labelled_set read_labelled_set(const std::string& folder, std::size_t most_classes);

/// \name What the paper does to the set to see how robust descriptors are (section 6.3)
/// Shapes that nothing is done to stay as they are. The same seed has the same effect everywhere.
/// @{

/// every second shape has lost 10 % of its faces.
std::vector<Soup> half_without_faces(const std::vector<Soup>& shapes, std::uint64_t seed);

/// \brief the vertices of every second shape are displaced: by a fifth of the mean length of an edge, in the root of the mean
/// square.
std::vector<Soup> half_with_noise(const std::vector<Soup>& shapes, std::uint64_t seed);

/// a third as it is, a third without 10 % of its faces, a third with noise.
std::vector<Soup> thirds(const std::vector<Soup>& shapes, std::uint64_t seed);

/// all turned, moved and made larger or smaller by up to ten times.
std::vector<Soup> moved(const std::vector<Soup>& shapes, std::uint64_t seed);
/// @}

/// a descriptor and a distance.
struct Retrieval_method
{
  std::string name;
  AP::Shape_descriptor_options options;
  AP::Distance_kind distance;
};

/// the paper's first.
std::vector<Retrieval_method> retrieval_methods();

/// descriptors, and the CPU time that each took in the mean, in seconds.
struct Described_set
{
  AP::Descriptor_table table;
  double seconds;
};

/// describes all shapes, in parallel.
Described_set describe(const std::vector<Soup>& shapes,
                       const AP::Shape_descriptor_options& options);

/// where those of the same class come.
AP::Relevant_ranks ranks(const AP::Descriptor_table& table, AP::Distance_kind distance,
                         const AP::Class_labels& labels);

} // namespace Paper

#endif // AREA_PROJECTION_PAPER_RETRIEVAL_SET_H
