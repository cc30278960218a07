// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef AREA_PROJECTION_PAPER_SALIENT_SCORE_H
#define AREA_PROJECTION_PAPER_SALIENT_SCORE_H

#include "salient_scenes.h"

#include <array>
#include <chrono>
#include <cstddef>
#include <ctime>
#include <iosfwd>
#include <limits>
#include <string>
#include <vector>

namespace Paper {

enum class Found_shape { SPHERE, TUBE, CONE, OTHER };

inline constexpr std::array<const char*, 4> names_of_found_shapes = {"sphere", "tube", "cone",
                                                                     "other"};

/// what a method says of an object.
struct Detection
{
  Found_shape shape = Found_shape::OTHER;
  Point_3 position = Point_3(0, 0, 0);
  Vector_3 axis = Vector_3(0, 0, 0); ///< of tubes and cones, of any length but 0
  double radius = 0;                 ///< at `position`
  /// an interval for the radius; NaN if the method gives none.
  double low = std::numeric_limits<double>::quiet_NaN();
  double high = std::numeric_limits<double>::quiet_NaN();
  double slope = 0;                       ///< along `axis`
  Vector_3 curvature = Vector_3(0, 0, 0); ///< towards the centre of the bend, one over its radius
};

/// what there is of a truth near a point.
struct Place_of_truth
{
  double distance;    ///< from the centre, or from the axis or arc
  double along;       ///< from the middle of the axis or arc; 0 for spheres and ellipsoids
  double radius;      ///< there
  Vector_3 direction; ///< of the axis or arc there; null for spheres and ellipsoids
};

Place_of_truth place_of(const Truth& truth, const Point_3& point);

/// \brief whether a detection is right.
///
/// - Spheres: called so, the centre within 0.15 radii, the radius within 15 %.
/// - Tubes, straight, bent or conical: called tube or cone, within 0.15 radii from the axis or arc and
///   between its ends, the direction within 18°, the radius within 15 % of that at this place.
/// - Ellipsoids: the centre within a quarter of the mean semi-axis; any shape, but a sphere only if the
///   ratio of the axes is at most 1.3.
bool is_hit(const Detection& detection, const Truth& truth);

/// what a method found of the objects of scenes.
struct Score
{
  std::size_t scenes = 0, truths = 0, detections = 0, hits = 0;
  std::size_t duplicates = 0; ///< right, but of objects that another detection is matched with
  double seconds = 0;         ///< for all scenes
  double cpu_seconds = 0;     ///< the same, of all threads

  /// \name Of each hit, but for ellipsoids
  /// @{
  std::vector<double> radius_errors;   ///< relative
  std::vector<double> position_errors; ///< in radii; of tubes across the axis
  std::size_t intervals = 0, intervals_with_truth = 0;
  /// @}
  std::vector<double> slope_errors;     ///< of cones that are found: absolute
  std::vector<double> curvature_errors; ///< of bent tubes that are found: relative to the curvature

  /// for each shape of truth, how many were found as each shape, and last how many were missed.
  std::array<std::array<std::size_t, 5>, 5> confusion = {};

  std::vector<std::string> misses; ///< what was missed, and what was nearest
  std::vector<std::string> wrong;  ///< what was found and is not there, duplicates among it

  double recall() const;    ///< 1 if there was nothing to find
  double precision() const; ///< 1 if nothing was found
  double
  coverage() const; ///< the fraction of the intervals that hold the truth; NaN without intervals
};

/// \brief matches detections with the truths of a scene, each with one at most, the nearest pairs first,
/// and adds what comes of it.
void add(const Scene& scene, const std::vector<Detection>& detections, Score& score);

/// of values in any order; NaN if there is none.
/// \param fraction 0.5 for the median, 1 for the largest
double quantile(std::vector<double> values, double fraction);

/// numbers and the confusion table.
std::ostream& operator<<(std::ostream& out, const Score& score);

/// \brief lets a method loose on scenes: `detector(const Soup&)` returns detections.
///
/// Its time is taken, and that of all other threads of the process.
template <class Detector>
Score evaluate(const std::vector<Scene>& scenes, Detector&& detector)
{
  Score score;
  for(const Scene& scene : scenes) {
    const auto begin = std::chrono::steady_clock::now();
    const std::clock_t cpu_begin = std::clock();
    const std::vector<Detection> detections = detector(scene.soup);
    score.seconds +=
        std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    score.cpu_seconds += double(std::clock() - cpu_begin) / CLOCKS_PER_SEC;
    add(scene, detections, score);
  }
  return score;
}

} // namespace Paper

#endif // AREA_PROJECTION_PAPER_SALIENT_SCORE_H
