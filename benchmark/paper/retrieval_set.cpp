// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "retrieval_set.h"

#include "input.h"
#include "labelled_shapes.h"

#include <CGAL/Area_projection_transform/IO/class_labels.h>
#include <CGAL/Area_projection_transform/internal/parallel_workers.h>
#include <CGAL/Area_projection_transform/surfels_from_mesh.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <filesystem>
#include <functional>

namespace Paper {

namespace {

constexpr double lost_faces = 0.1;
constexpr double noise_length = 0.2; // of the displacement, in units of the mean length of an edge

using Change = std::function<Soup(const Soup&, std::uint64_t seed)>;

Soup without_faces(const Soup& soup, std::uint64_t seed)
{
  return remove_random_faces(soup, lost_faces, seed);
}

Soup with_noise(const Soup& soup, std::uint64_t seed)
{
  return add_noise(soup, noise_length / std::sqrt(3.), seed); // along each axis
}

/// changes the shapes in turn by each of some changes, the first of which may be none.
std::vector<Soup> changed(const std::vector<Soup>& shapes, const std::vector<Change>& changes,
                          std::uint64_t seed)
{
  std::vector<Soup> result = shapes;
  for(std::size_t i = 0; i < shapes.size(); ++i)
    if(const Change& change = changes[i % changes.size()])
      result[i] = change(shapes[i], seed * 1000003 + i);
  return result;
}

Soup read_mesh(const std::string& file)
{
  const mapt::Input input = mapt::read_input(file);
  if(input.is_point_set)
    throw mapt::Input_error(file + ": has no faces: a mesh is needed");
  return {input.points, input.triangles};
}

} // namespace

Labelled_set read_labelled_set(const std::string& folder, std::size_t most_classes)
{
  namespace fs = std::filesystem;
  const std::string csv = folder + "/labels.csv";
  const auto list = AP::IO::read_class_labels(fs::exists(csv) ? csv : folder + "/labels.cla");
  std::vector<std::string> files;
  for(const auto& entry : fs::directory_iterator(folder + "/meshes"))
    files.push_back(entry.path().string());
  std::sort(files.begin(), files.end());
  const AP::Class_labels all = AP::IO::labels_of(files, list);
  Labelled_set set;
  for(std::size_t i = 0; i < files.size(); ++i)
    if(all[i] < most_classes) {
      set.shapes.push_back(read_mesh(files[i]));
      set.labels.push_back(all.name(all[i]));
    }
  return set;
}

std::vector<Soup> half_without_faces(const std::vector<Soup>& shapes, std::uint64_t seed)
{
  return changed(shapes, {nullptr, without_faces}, seed);
}

std::vector<Soup> half_with_noise(const std::vector<Soup>& shapes, std::uint64_t seed)
{
  return changed(shapes, {nullptr, with_noise}, seed);
}

std::vector<Soup> thirds(const std::vector<Soup>& shapes, std::uint64_t seed)
{
  return changed(shapes, {nullptr, without_faces, with_noise}, seed);
}

std::vector<Soup> moved(const std::vector<Soup>& shapes, std::uint64_t seed)
{
  const Change move = [](const Soup& soup, std::uint64_t seed_of_shape) {
    Random random(seed_of_shape);
    const double size = std::pow(10., 2 * random.uniform() - 1);
    const Vector_3 way = size * Vector_3(random.normal(), random.normal(), random.normal());
    const Pose pose = random_pose(CGAL::ORIGIN + way, random);
    Soup result = soup;
    for(Point_3& p : result.points)
      p = pose(CGAL::ORIGIN + size * (p - CGAL::ORIGIN));
    return result;
  };
  return changed(shapes, {move}, seed);
}

std::vector<Retrieval_method> retrieval_methods()
{
  const auto with = [](AP::Binning binning, AP::Descriptor_normals normals) {
    AP::Shape_descriptor_options options;
    options.binning = binning;
    options.normals = normals;
    return options;
  };
  using AP::Binning;
  using AP::Descriptor_normals;
  using AP::Distance_kind;
  return {{"paper", {}, Distance_kind::JEFFREY},
          {"paper, root of JS", {}, Distance_kind::JENSEN_SHANNON},
          {"soft bins, root of JS", with(Binning::SOFT, Descriptor_normals::FACE),
           Distance_kind::JENSEN_SHANNON},
          {"pairs, root of JS", with(Binning::PAIRS, Descriptor_normals::FACE),
           Distance_kind::JENSEN_SHANNON},
          {"averaged normals", with(Binning::SOFT, Descriptor_normals::AVERAGED),
           Distance_kind::JENSEN_SHANNON},
          {"subdivided", with(Binning::SOFT, Descriptor_normals::SUBDIVIDED),
           Distance_kind::JENSEN_SHANNON}};
}

Described_set describe(const std::vector<Soup>& shapes, const AP::Shape_descriptor_options& options)
{
  std::vector<AP::Shape_descriptor> descriptors(shapes.size());
  const std::clock_t begin = std::clock(); // of all threads
  AP::internal::for_each_index<CGAL::Parallel_if_available_tag>(shapes.size(), [&](std::size_t i) {
    descriptors[i] = AP::shape_descriptor(
        AP::surface_from_triangle_soup(shapes[i].points, shapes[i].triangles), options);
  });
  const double seconds = double(std::clock() - begin) / CLOCKS_PER_SEC;
  AP::Descriptor_table table(descriptors.at(0).values.size(), descriptors[0].block_size);
  for(const AP::Shape_descriptor& descriptor : descriptors)
    table.push_back(descriptor.values);
  return {std::move(table), seconds / double(shapes.size())};
}

AP::Relevant_ranks ranks(const AP::Descriptor_table& table, AP::Distance_kind distance,
                         const AP::Class_labels& labels)
{
  return AP::relevant_ranks<CGAL::Parallel_if_available_tag>(
      table, AP::Histogram_distance(distance, table.dimension(), table.block_size()), labels);
}

} // namespace Paper
