// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "file_elements.h"

#include "mesh_topology.h"

#include <cstdint>
#include <filesystem>

namespace mapt {

namespace {

// The elements of the file that those of the surface come from: some may have been left out, and polygons
// have several triangles.
std::vector<std::int32_t> places_in_file(const std::vector<std::uint32_t>& sources,
                                         const Input& input)
{
  std::vector<std::int32_t> places;
  for(const std::uint32_t source : sources)
    places.push_back(
        std::int32_t((input.is_point_set ? input.source_points : input.source_faces)[source]));
  return places;
}

} // namespace

std::vector<Segment> holes_of(const Input& input)
{
  std::vector<Segment> holes;
  for(const auto& [from, to] : boundary_edges(join_equal_points(input.points), input.triangles))
    holes.push_back({input.points[from], input.points[to]});
  return holes;
}

void write_labelled_elements(const std::string& file, std::vector<AP::IO::PLY_element> elements,
                             const std::string& what, const Surface& surface, const Input& input)
{
  const std::string source = input.is_point_set ? "source_point" : "source_face";
  AP::IO::PLY_options ply;
  ply.comments = {what, source + " counts from 0 in " +
                            std::filesystem::path(input.file).filename().string()};
  std::visit([&](const auto* s) { elements.back().add(source, places_in_file(s->sources, input)); },
             surface.source());
  AP::IO::write_PLY(file, elements, ply);
}

} // namespace mapt
