// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "experiment.h"

#include "input.h"
#include "text.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <numeric>

namespace Paper {

namespace {

constexpr std::size_t number_of_maxima = 10;
constexpr std::size_t number_of_holes = 30;

double mean_of(const std::vector<double>& values)
{
  return std::accumulate(values.begin(), values.end(), 0.) / double(values.size());
}

/// means over the maxima that are found; none if none is.
void append_means(const std::vector<Maximum_change>& changes, const Damaged& damaged,
                  Measures& measures)
{
  std::vector<double> displacements, across, scores, values;
  for(const Maximum_change& c : changes)
    if(!c.is_lost) {
      displacements.push_back(c.displacement);
      across.push_back(c.across);
      scores.push_back(c.score_ratio);
      values.push_back(c.clean_value_there);
    }
  if(displacements.empty())
    return;
  measures.insert(measures.end(),
                  {{"displacement", mean_of(displacements)},
                   {"across", mean_of(across)},
                   {"farthest across", *std::max_element(across.begin(), across.end())},
                   {"clean value there", mean_of(values)},
                   {"score", mean_of(scores)},
                   {"score / coverage", mean_of(scores) / damaged.coverage},
                   {"score / area", mean_of(scores) / damaged.area_ratio}});
}

/// leaves out what cannot be divided by a coverage that is zero, for want of an interior.
Measures finite(Measures measures)
{
  measures.erase(std::remove_if(measures.begin(), measures.end(),
                                [](const auto& m) { return !std::isfinite(m.second); }),
                 measures.end());
  return measures;
}

} // namespace

std::vector<Mesh> read_meshes(const Options& options, const std::vector<std::string>& bundled)
{
  std::vector<std::string> files = options.meshes;
  if(files.empty())
    for(const std::string& name : bundled)
      files.push_back(AREA_PROJECTION_TRANSFORM_DATA "/" + name);
  if(options.meshes.empty() && options.is_quick && !files.empty())
    files.resize(1);
  std::vector<Mesh> meshes;
  for(const std::string& file : files) {
    const mapt::Input input = mapt::read_input(file);
    if(input.is_point_set)
      throw mapt::Input_error(file + ": has no faces, so that none can be removed: give a mesh");
    meshes.push_back(
        {std::filesystem::path(file).stem().string(), {input.points, input.triangles}});
  }
  return meshes;
}

Subject::Subject(Mesh mesh, int voxels, const std::vector<double>& radii_in_voxels)
    : m_mesh(std::move(mesh)), m_region(inside(m_mesh.soup, grid_of(m_mesh.soup, voxels)).region)
{
  std::vector<double> radii = radii_in_voxels;
  for(double& radius : radii)
    radius *= m_region->grid().spacing();
  m_scales = AP::proportional_scales(radii);
}

const Maps& Subject::maps(const std::string& mode)
{
  const auto known = m_maps.find(mode);
  if(known != m_maps.end())
    return known->second;
  return m_maps.emplace(mode, compute_maps(mode, soup(), m_region, m_scales)).first->second;
}

Benchmarks::Parameters Subject::parameters() const
{
  const auto& size = m_region->grid().size();
  return {{"mesh", name()},
          {"faces", soup().triangles.size()},
          {"voxels", *std::max_element(size.begin(), size.end()) - 1},
          {"voxels inside", m_region->number_of_voxels()}};
}

std::vector<double> descriptor_radii()
{
  return {2, 3, 4, 5, 6, 7, 8, 9};
}

double radius_in_voxels(const AP::Joint_map& map, std::size_t scale)
{
  return 1e-6 * std::round(1e6 * map.scales()[scale].radius / map.grid().spacing());
}

Damage removed_faces(double fraction)
{
  return {"faces removed", fraction, [fraction](const Soup& soup, std::uint64_t seed) {
            return remove_random_faces(soup, fraction, seed);
          }};
}

Damage holes(double fraction)
{
  return {"holes", fraction, [fraction](const Soup& soup, std::uint64_t seed) {
            return remove_holes(soup, fraction, number_of_holes, seed);
          }};
}

Damage noise(double ratio)
{
  return {"noise", ratio,
          [ratio](const Soup& soup, std::uint64_t seed) { return add_noise(soup, ratio, seed); }};
}

Damaged apply(const Damage& damage, const Subject& subject, std::uint64_t seed)
{
  Damaged damaged{damage.apply(subject.soup(), seed), 0, 0, {}};
  damaged.area_ratio = area(damaged.soup) / area(subject.soup());
  const Inside own = inside(damaged.soup, subject.region()->grid());
  damaged.coverage = own.coverage;
  damaged.interior = compare(*subject.region(), *own.region);
  return damaged;
}

Measures measure_maps(const Maps& clean, const Maps& other, const Damaged& damaged)
{
  const AP::Row_spans& region = clean.joint.region();
  std::vector<Map_difference> scales;
  for(std::size_t k = 0; k < clean.scales.size(); ++k)
    scales.push_back(compare(region, clean.scales[k], other.scales[k]));
  double mean_correlation = 0;
  for(const Map_difference& d : scales)
    mean_correlation += d.correlation / double(scales.size());
  const auto joint = [&](double factor) {
    return compare(region, clean.joint.values(), other.joint.values(), factor);
  };
  return finite({{"joint correlation", joint(1).correlation},
                 {"mean correlation", mean_correlation},
                 {"largest R correlation", scales.back().correlation},
                 {"largest R error", scales.back().relative_rms},
                 {"joint error", joint(1).relative_rms},
                 {"/ coverage error", joint(1 / damaged.coverage).relative_rms},
                 {"/ area error", joint(1 / damaged.area_ratio).relative_rms}});
}

Measures measure_maxima(const Maps& clean, const Maps& other, const Damaged& damaged)
{
  const std::vector<Maximum_change> changes =
      compare_maxima(clean.joint, other.joint, number_of_maxima);
  Measures measures{{"maxima", double(changes.size())},
                    {"lost", double(std::count_if(changes.begin(), changes.end(),
                                                  [](const auto& c) { return c.is_lost; }))}};
  append_means(changes, damaged, measures);
  return finite(std::move(measures));
}

Measures measure_interior(const Damaged& damaged)
{
  return {{"area", damaged.area_ratio},
          {"coverage", damaged.coverage},
          {"interior found", damaged.interior.found},
          {"interior wrong", damaged.interior.wrong}};
}

Measures mean(const std::vector<Measures>& all)
{
  Measures means;
  std::map<std::string, double> numbers;
  for(const Measures& measures : all)
    for(const auto& [name, value] : measures) {
      const auto is_same = [&name = name](const auto& m) { return m.first == name; };
      auto place = std::find_if(means.begin(), means.end(), is_same);
      if(place == means.end())
        place = means.insert(place, {name, 0.});
      place->second += value;
      ++numbers[name];
    }
  for(auto& [name, value] : means)
    value /= numbers[name];
  return means;
}

Benchmarks::Row row(const std::string& group, const std::string& comparison,
                    const std::string& name, Benchmarks::Parameters parameters, Measures measures)
{
  Benchmarks::Row row;
  row.group = group;
  row.comparison = comparison;
  row.name = name;
  row.parameters = std::move(parameters);
  row.measures = std::move(measures);
  return row;
}

void publish(const std::vector<Benchmarks::Row>& rows, Benchmarks::Report& report)
{
  Benchmarks::print_table(rows, std::cout);
  std::cout.flush();
  report.add(rows);
}

void write_pictures(const Options& options, const std::string& stem, const Maps& maps,
                    const std::vector<std::size_t>& scales, const Soup& silhouette)
{
  if(options.pictures.empty())
    return;
  std::filesystem::create_directories(options.pictures);
  const std::string begin = options.pictures + "/" + stem + "_";
  for(std::size_t k : scales)
    write_picture_of_scale(begin + "R" + mapt::to_text(radius_in_voxels(maps.joint, k)) + ".png",
                           maps, k, silhouette);
  write_picture_of_joint_map(begin + "joint.png", maps, silhouette);
}

} // namespace Paper
