// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "figures.h"
#include "ransac_peer.h"
#include "salient_conditions.h"
#include "salient_detectors.h"

#include <CGAL/Area_projection_transform/salient_points.h>
#include <CGAL/Area_projection_transform/surfels_from_mesh.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <vector>

namespace Paper {

namespace {

const std::string group = "salient";

/// finds round objects; only RANSAC is told what helps it.
struct Method
{
  const char* name;
  std::vector<Detection> (*detect)(const Soup& soup, const Ransac_parameters& parameters);
};

const Method methods[] = {
    {"area projection",
     [](const Soup& soup, const Ransac_parameters&) {
       return detections_of(AP::salient_points<CGAL::Parallel_if_available_tag>(
           AP::surface_from_triangle_soup(soup.points, soup.triangles)));
     }},
    {"RANSAC",
     [](const Soup& soup, const Ransac_parameters& parameters) {
       return detect_by_ransac(soup, parameters, false, 1);
     }},
    {"RANSAC, refit",
     [](const Soup& soup, const Ransac_parameters& parameters) {
       return detect_by_ransac(soup, parameters, true, 1);
     }},
};

/// the fraction of the truths of a shape that were called cones, of those that were found.
double called_cones(const Score& score, Truth_shape shape)
{
  const auto& found = score.confusion[std::size_t(shape)];
  const auto missed = found.end() - 1;
  return double(found[std::size_t(Found_shape::CONE)]) /
         double(std::accumulate(found.begin(), missed, std::size_t(0)));
}

Measures measures_of(const Score& score)
{
  const double scenes = double(score.scenes);
  Measures measures{{"recall", score.recall()},
                    {"precision", score.precision()},
                    {"duplicates", double(score.duplicates)},
                    {"radius error", quantile(score.radius_errors, 0.5)},
                    {"p90 radius error", quantile(score.radius_errors, 0.9)},
                    {"position error", quantile(score.position_errors, 0.5)},
                    {"p90 position error", quantile(score.position_errors, 0.9)},
                    {"truth in interval", score.coverage()},
                    {"cones as cones", called_cones(score, Truth_shape::CONE)},
                    {"tubes as cones", called_cones(score, Truth_shape::TUBE)},
                    {"slope off by", quantile(score.slope_errors, 0.5)},
                    {"curvature error", quantile(score.curvature_errors, 0.5)},
                    {"ms", 1000 * score.seconds / scenes},
                    {"cpu ms", 1000 * score.cpu_seconds / scenes}};
  measures.erase(std::remove_if(measures.begin(), measures.end(),
                                [](const auto& m) { return !std::isfinite(m.second); }),
                 measures.end());
  return measures;
}

void compare_methods(const Condition& condition, const Options& options, Benchmarks::Report& report)
{
  const std::size_t number = options.pick<std::size_t>(1, std::size_t(options.scenes));
  const std::vector<Scene> scenes = scenes_of(condition, options.seed, number);
  const Ransac_parameters parameters = ransac_parameters(condition.damage.noise, condition.is_hard);
  std::vector<Benchmarks::Row> rows;
  for(const Method& method : methods) {
    const Score score =
        evaluate(scenes, [&](const Soup& soup) { return method.detect(soup, parameters); });
    rows.push_back(row(group, condition.name, method.name,
                       {{"scenes", score.scenes}, {"objects", score.truths}}, measures_of(score)));
  }
  publish(rows, report);
}

Measures count_shapes(const std::vector<Detection>& detections)
{
  const auto number = [&](Found_shape shape) {
    return double(std::count_if(detections.begin(), detections.end(),
                                [&](const Detection& d) { return d.shape == shape; }));
  };
  return {{"spheres", number(Found_shape::SPHERE)},
          {"tubes", number(Found_shape::TUBE) + number(Found_shape::CONE)},
          {"others", number(Found_shape::OTHER)}};
}

/// what is found where there is no sphere, and but for the torus no tube: means over some seeds.
void show_distractors(double noise, const Options& options, Benchmarks::Report& report)
{
  const std::uint64_t repetitions = options.pick(1, 3);
  Scene_damage damage;
  damage.noise = noise;
  std::vector<Benchmarks::Row> rows;
  const std::size_t number = distractors(options.seed).size();
  for(std::size_t i = 0; i < number; ++i)
    for(const Method& method : methods) {
      std::vector<Measures> all;
      std::string name;
      for(std::uint64_t seed = options.seed; seed < options.seed + repetitions; ++seed) {
        const Distractor distractor = distractors(seed)[i];
        name = distractor.name;
        const Soup soup = damaged(distractor.scene, damage, seed).soup;
        all.push_back(count_shapes(method.detect(soup, ransac_parameters(noise, false))));
      }
      rows.push_back(
          row(group, "no spheres", method.name, {{"object", name}, {"noise", noise}}, mean(all)));
    }
  publish(rows, report);
}

} // namespace

void salient_comparison(const Options& options, Benchmarks::Report& report)
{
  report.add_group(
      group,
      "Spheres and tubes in scenes of 3 to 10 objects whose truth is known: easy ones, a third of "
      "which are cut in half, and hard ones with coarse, bent and conical tubes and ellipsoids. "
      "Beside them what CGAL's Efficient RANSAC finds from the vertices and their normals (planes, "
      "spheres and cylinders, in hard scenes cones and tori), with the best parameters that were "
      "found for each amount of noise, which it is told; and the same with its shapes fitted "
      "again, as ours are. Errors of radius and position are medians, relative to the radius. The "
      "transform runs on all cores, RANSAC has one thread only.");
  for(const Condition& condition : salient_conditions())
    if(!options.is_quick || condition.name == "easy, clean" || condition.name == "hard, noise 20 %")
      compare_methods(condition, options, report);
  for(double noise : options.pick<std::vector<double>>({0.2}, {0, 0.2, 0.5, 1}))
    show_distractors(noise, options, report);
}

} // namespace Paper
