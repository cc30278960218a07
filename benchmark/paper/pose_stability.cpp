// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "figures.h"
#include "input.h"
#include "salient.h"
#include "surface_location.h"

#include <CGAL/Area_projection_transform/salient_points/paper_salient_points.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <iostream>
#include <map>
#include <optional>
#include <stdexcept>
#include <utility>

namespace Paper {

namespace {

using Benchmarks::Row;

constexpr std::size_t number_of_points = 20; // the strongest of each pose
constexpr std::size_t rank_window = 5;       // how far ranks of the same point may be apart

struct Pair
{
  std::string name; // of the class
  std::array<std::string, 2> files;
};

/// the first two meshes of each class of a labelled set: a folder with `labels.csv`, of lines
/// `file,class`, and the files in `meshes`.
std::vector<Pair> read_pairs(const std::string& folder)
{
  std::ifstream in(folder + "/labels.csv");
  if(!in)
    throw std::runtime_error(folder + "/labels.csv: cannot be read");
  std::map<std::string, std::vector<std::string>> files;
  std::string line;
  std::getline(in, line); // the names of the columns
  while(std::getline(in, line)) {
    const std::size_t comma = line.find(',');
    if(comma != std::string::npos)
      files[line.substr(comma + 1)].push_back(folder + "/meshes/" + line.substr(0, comma));
  }
  std::vector<Pair> pairs;
  for(const auto& [name, of_class] : files)
    if(of_class.size() >= 2)
      pairs.push_back({name, {of_class[0], of_class[1]}});
  return pairs;
}

/// a mesh, and the places of its strongest points on the surface.
struct Pose
{
  Soup soup;
  Surface_locations locations;
  std::vector<Salient_point> points;
  std::vector<Distance_profile> places;

  explicit Pose(const std::string& file) : soup(read(file)), locations(soup) {}

  void find_points(Salient_mode mode, double factor)
  {
    mode.reference_length = factor * short_reference_length(soup);
    points = find_salient_points(soup, mode).points;
    points.resize(std::min(points.size(), number_of_points));
    places.clear();
    for(const Salient_point& p : points)
      places.push_back(locations.of_point(p));
  }

  static Soup read(const std::string& file)
  {
    const mapt::Input input = mapt::read_input(file);
    return {input.points, input.triangles};
  }
};

/// how unlike two points are, in what does not depend on the pose: relative radius, intensity, sphericity.
double unlikeness(const Pose& a, std::size_t i, const Pose& b, std::size_t j)
{
  const Salient_point &p = a.points[i], &q = b.points[j];
  const double size_ratio = std::sqrt(area(b.soup) / area(a.soup));
  return std::abs(std::log(p.scale * size_ratio / q.scale)) +
         std::abs(std::log(p.intensity / q.intensity)) + std::abs(p.sphericity - q.sphericity);
}

/// \brief for each point of `a`, the strongest first, the point of `b` that is most like it, among those of
/// a similar rank that are not taken yet.
std::vector<std::optional<std::size_t>> match(const Pose& a, const Pose& b)
{
  std::vector<bool> is_taken(b.points.size(), false);
  std::vector<std::optional<std::size_t>> partners;
  for(std::size_t i = 0; i < a.points.size(); ++i) {
    std::optional<std::size_t> best;
    for(std::size_t j = i - std::min(i, rank_window);
        j < std::min(i + rank_window + 1, b.points.size()); ++j)
      if(!is_taken[j] && (!best || unlikeness(a, i, b, j) < unlikeness(a, i, b, *best)))
        best = j;
    if(best)
      is_taken[*best] = true;
    partners.push_back(best);
  }
  return partners;
}

double median(std::vector<double> values)
{
  std::nth_element(values.begin(), values.begin() + std::ptrdiff_t(values.size() / 2),
                   values.end());
  return values[values.size() / 2];
}

/// how near the nearest place of the other pose comes, for the middle one of all faces: less cannot be told.
double resolution(const Pose& a, const Pose& b)
{
  std::vector<double> nearest;
  for(const Distance_profile& p : a.locations.of_faces()) {
    double least = difference(p, b.locations.of_faces()[0]);
    for(const Distance_profile& q : b.locations.of_faces())
      least = std::min(least, difference(p, q));
    nearest.push_back(least);
  }
  return median(nearest);
}

/// \param voxel in units of the square root of the area
Measures compare(const Pose& a, const Pose& b, double voxel)
{
  const auto apart = [&](std::size_t i, std::size_t j) {
    return difference(a.places[i], b.places[j]) / voxel;
  };
  const auto partners = match(a, b);
  std::vector<double> matched;
  double within = 0, some = 0, pairs_within = 0;
  for(std::size_t i = 0; i < a.points.size(); ++i) {
    if(partners[i]) {
      matched.push_back(apart(i, *partners[i]));
      within += matched.back() <= 2;
    }
    std::size_t near = 0;
    for(std::size_t j = 0; j < b.points.size(); ++j)
      near += apart(i, j) <= 2;
    some += near > 0;
    pairs_within += double(near);
  }
  Measures measures{{"points", double(a.points.size())},
                    {"of the other pose", double(b.points.size())},
                    {"resolution", resolution(a, b) / voxel}};
  if(!matched.empty())
    measures.insert(measures.end(),
                    {{"matched", double(matched.size())},
                     {"median apart", median(matched)},
                     {"within 2 voxels", within / double(matched.size())},
                     {"any within 2 voxels", some / double(a.points.size())},
                     {"by chance", pairs_within / double(a.points.size() * b.points.size())}});
  return measures;
}

} // namespace

void pose_stability(const Options& options, Benchmarks::Report& report)
{
  if(options.retrieval.empty()) {
    std::cout << "\nposes: left out, for want of a labelled set of meshes (--retrieval)\n";
    return;
  }
  report.add_group(
      "poses",
      "Salient points of two poses of a model, by the classes of a labelled set. The strongest "
      "twenty are matched by rank (no more than five apart), radius, intensity and sphericity. "
      "Vertices of the poses do not correspond: where the voters of a point lie is told by the "
      "geodesic distances from there to all of the surface, as quantiles. Places are at least as "
      "far "
      "apart as their quantiles differ in the mean; here in voxels of s. Resolution: how near the "
      "nearest face of the other pose comes in the median. By chance: how often two points, of "
      "all, "
      "are within two voxels.");
  std::vector<Pair> pairs = read_pairs(options.retrieval);
  pairs.resize(std::min(pairs.size(), options.pick(std::size_t(3), pairs.size())));
  std::map<double, std::vector<Row>> classes;
  std::map<std::pair<double, std::string>, std::vector<Measures>> all;
  for(const Pair& pair : pairs) {
    Pose a(pair.files[0]), b(pair.files[1]);
    for(double factor : options.pick<std::vector<double>>({4}, {1, 4, 16}))
      for(const Salient_mode& mode : salient_modes()) {
        a.find_points(mode, factor);
        b.find_points(mode, factor);
        const Measures measures = compare(a, b, factor * AP::paper_reference_length(1));
        classes[factor].push_back(row("poses", "classes", mode.name,
                                      {{"s in √A/80π", factor}, {"class", pair.name}}, measures));
        all[{factor, mode.name}].push_back(measures);
      }
  }
  std::vector<Row> means;
  for(const auto& [key, measures] : all)
    means.push_back(row("poses", "means over classes", key.second, {{"s in √A/80π", key.first}},
                        mean(measures)));
  for(const auto& [factor, rows] : classes)
    publish(rows, report);
  publish(means, report);
}

} // namespace Paper
