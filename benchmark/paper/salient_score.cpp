// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "salient_score.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <ostream>
#include <sstream>
#include <tuple>

namespace Paper {

namespace {

constexpr double pi = 3.14159265358979323846;
constexpr double largest_distance = 0.15;              // in radii
constexpr double largest_distance_of_ellipsoid = 0.25; // in mean semi-axes
constexpr double largest_radius_error = 0.15;
constexpr double largest_angle = 18; // degrees
constexpr double largest_ratio_of_sphere = 1.3;
constexpr std::size_t missed = names_of_found_shapes.size();

double length(const Vector_3& v)
{
  return std::sqrt(v.squared_length());
}

Place_of_truth place_on_axis(const Truth& truth, const Point_3& point)
{
  const Vector_3 v = point - truth.center;
  const double along = v * truth.axis;
  return {length(v - along * truth.axis), along, truth.radius + truth.slope * along, truth.axis};
}

Place_of_truth place_on_arc(const Truth& truth, const Point_3& point)
{
  const double curvature = length(truth.curvature);
  const Vector_3 outward = -truth.curvature / curvature;
  const Point_3 center_of_bend = truth.center - outward / curvature;
  const Vector_3 v = point - center_of_bend;
  const double angle = std::atan2(v * truth.axis, v * outward);
  const Vector_3 there = std::cos(angle) * outward + std::sin(angle) * truth.axis;
  return {length(v - there / curvature), angle / curvature, truth.radius,
          std::cos(angle) * truth.axis - std::sin(angle) * outward};
}

/// in degrees, of lines without a direction; 90 if one has no extent.
double angle_between(const Vector_3& a, const Vector_3& b)
{
  const double lengths = length(a) * length(b);
  if(!(lengths > 0))
    return 90;
  return std::acos(std::min(std::abs(a * b) / lengths, 1.)) * 180 / pi;
}

bool is_called_sphere(const Detection& detection)
{
  return detection.shape == Found_shape::SPHERE;
}

bool is_called_tube(const Detection& detection)
{
  return detection.shape == Found_shape::TUBE || detection.shape == Found_shape::CONE;
}

bool is_right_shape(const Detection& detection, const Truth& truth)
{
  if(truth.shape == Truth_shape::SPHERE)
    return is_called_sphere(detection);
  if(truth.is_tubular())
    return is_called_tube(detection);
  const auto [least, most] = std::minmax_element(truth.semi_axes.begin(), truth.semi_axes.end());
  return !is_called_sphere(detection) || *most <= largest_ratio_of_sphere * *least;
}

double relative_radius(const Detection& detection, const Place_of_truth& place)
{
  return detection.radius / place.radius;
}

std::string to_text(const Point_3& p)
{
  std::ostringstream text;
  text << std::setprecision(3) << "(" << p.x() << ", " << p.y() << ", " << p.z() << ")";
  return text.str();
}

std::string to_text(const Truth& truth)
{
  std::ostringstream text;
  text << std::setprecision(3) << names_of_truth_shapes[std::size_t(truth.shape)] << " at "
       << to_text(truth.center) << ", radius " << truth.radius;
  if(truth.is_tubular())
    text << ", length " << truth.length;
  if(truth.shape == Truth_shape::ELLIPSOID)
    text << ", axes " << truth.semi_axes[0] << " and " << truth.semi_axes[2];
  text << ", " << truth.faces.size() << " faces";
  return text.str();
}

std::string to_text(const Detection& detection)
{
  std::ostringstream text;
  text << std::setprecision(3) << names_of_found_shapes[std::size_t(detection.shape)] << " at "
       << to_text(detection.position) << ", radius " << detection.radius;
  return text.str();
}

/// how a detection lies to a truth.
std::string relation(const Detection& detection, const Truth& truth)
{
  const Place_of_truth place = place_of(truth, detection.position);
  std::ostringstream text;
  text << std::setprecision(3) << place.distance / place.radius << " radii away, radius "
       << relative_radius(detection, place) << " times";
  if(truth.is_tubular())
    text << ", " << place.along / truth.length << " lengths along, "
         << angle_between(detection.axis, place.direction) << " degrees askew";
  return text.str();
}

/// from the object, not its axis: beyond the ends it counts as well.
double distance_from(const Truth& truth, const Point_3& point)
{
  const Place_of_truth place = place_of(truth, point);
  return std::hypot(place.distance, std::max(std::abs(place.along) - truth.length / 2, 0.)) /
         truth.radius;
}

std::string describe_miss(const Truth& truth, const std::vector<Detection>& detections)
{
  const auto nearest =
      std::min_element(detections.begin(), detections.end(), [&](const auto& a, const auto& b) {
        return distance_from(truth, a.position) < distance_from(truth, b.position);
      });
  return to_text(truth) + (nearest == detections.end() ? std::string("; nothing found")
                                                       : "; nearest: " + to_text(*nearest) + ", " +
                                                             relation(*nearest, truth));
}

std::string describe_wrong(const Detection& detection, const std::vector<Truth>& truths)
{
  const auto nearest =
      std::min_element(truths.begin(), truths.end(), [&](const auto& a, const auto& b) {
        return distance_from(a, detection.position) < distance_from(b, detection.position);
      });
  return to_text(detection) + (nearest == truths.end() ? std::string()
                                                       : "; nearest: " + to_text(*nearest) + ", " +
                                                             relation(detection, *nearest));
}

/// for each truth its detection, `detections.size()` if it has none.
std::vector<std::size_t> match(const std::vector<Truth>& truths,
                               const std::vector<Detection>& detections)
{
  std::vector<std::tuple<double, std::size_t, std::size_t>> pairs;
  for(std::size_t t = 0; t < truths.size(); ++t)
    for(std::size_t d = 0; d < detections.size(); ++d)
      if(is_hit(detections[d], truths[t])) {
        const Place_of_truth place = place_of(truths[t], detections[d].position);
        pairs.emplace_back(place.distance / place.radius, t, d);
      }
  std::sort(pairs.begin(), pairs.end());
  std::vector<std::size_t> matches(truths.size(), detections.size());
  std::vector<bool> is_used(detections.size(), false);
  for(const auto& [distance, t, d] : pairs)
    if(matches[t] == detections.size() && !is_used[d]) {
      matches[t] = d;
      is_used[d] = true;
    }
  return matches;
}

void add_hit(const Detection& detection, const Truth& truth, Score& score)
{
  ++score.hits;
  ++score.confusion[std::size_t(truth.shape)][std::size_t(detection.shape)];
  if(truth.shape == Truth_shape::ELLIPSOID)
    return;
  const Place_of_truth place = place_of(truth, detection.position);
  score.radius_errors.push_back(std::abs(relative_radius(detection, place) - 1));
  score.position_errors.push_back(place.distance / place.radius);
  if(!std::isnan(detection.low) && !std::isnan(detection.high)) {
    ++score.intervals;
    score.intervals_with_truth +=
        detection.low <= place.radius && place.radius <= detection.high ? 1 : 0;
  }
  if(truth.shape == Truth_shape::CONE) {
    const double sign = detection.axis * place.direction < 0 ? -1 : 1;
    score.slope_errors.push_back(std::abs(sign * detection.slope - truth.slope));
  }
  if(truth.shape == Truth_shape::BENT_TUBE)
    score.curvature_errors.push_back(
        std::abs(length(detection.curvature) / length(truth.curvature) - 1));
}

} // namespace

Place_of_truth place_of(const Truth& truth, const Point_3& point)
{
  if(truth.shape == Truth_shape::BENT_TUBE)
    return place_on_arc(truth, point);
  if(truth.is_tubular())
    return place_on_axis(truth, point);
  return {length(point - truth.center), 0, truth.radius, Vector_3(0, 0, 0)};
}

bool is_hit(const Detection& detection, const Truth& truth)
{
  if(!is_right_shape(detection, truth))
    return false;
  const Place_of_truth place = place_of(truth, detection.position);
  if(truth.shape == Truth_shape::ELLIPSOID)
    return place.distance <= largest_distance_of_ellipsoid * truth.radius;
  if(place.distance > largest_distance * place.radius ||
     !(std::abs(relative_radius(detection, place) - 1) <= largest_radius_error))
    return false;
  return !truth.is_tubular() || (std::abs(place.along) <= truth.length / 2 &&
                                 angle_between(detection.axis, place.direction) <= largest_angle);
}

double Score::recall() const
{
  return truths > 0 ? double(hits) / double(truths) : 1.;
}

double Score::precision() const
{
  return detections > 0 ? double(hits) / double(detections) : 1.;
}

double Score::coverage() const
{
  return intervals > 0 ? double(intervals_with_truth) / double(intervals)
                       : std::numeric_limits<double>::quiet_NaN();
}

void add(const Scene& scene, const std::vector<Detection>& detections, Score& score)
{
  const std::vector<std::size_t> matches = match(scene.truths, detections);
  const std::string where = "scene " + std::to_string(score.scenes) + ": ";
  ++score.scenes;
  score.truths += scene.truths.size();
  score.detections += detections.size();
  for(std::size_t t = 0; t < matches.size(); ++t)
    if(matches[t] < detections.size()) {
      add_hit(detections[matches[t]], scene.truths[t], score);
    } else {
      ++score.confusion[std::size_t(scene.truths[t].shape)][missed];
      score.misses.push_back(where + describe_miss(scene.truths[t], detections));
    }
  for(std::size_t d = 0; d < detections.size(); ++d) {
    if(std::find(matches.begin(), matches.end(), d) != matches.end())
      continue;
    const bool is_duplicate =
        std::any_of(scene.truths.begin(), scene.truths.end(),
                    [&](const Truth& truth) { return is_hit(detections[d], truth); });
    score.duplicates += is_duplicate ? 1 : 0;
    score.wrong.push_back(where + (is_duplicate ? "duplicate " : "") +
                          describe_wrong(detections[d], scene.truths));
  }
}

double quantile(std::vector<double> values, double fraction)
{
  if(values.empty())
    return std::numeric_limits<double>::quiet_NaN();
  std::sort(values.begin(), values.end());
  return values[std::size_t(std::lround(fraction * double(values.size() - 1)))];
}

std::ostream& operator<<(std::ostream& out, const Score& score)
{
  const auto percent = [](const std::vector<double>& errors, double fraction) {
    return 100 * quantile(errors, fraction);
  };
  out << score.scenes << " scenes, " << score.truths << " objects, " << score.detections
      << " detections, " << score.hits << " right, " << score.duplicates << " duplicates\n"
      << "recall " << score.recall() << ", precision " << score.precision() << "\n"
      << "radius error % (median, p90, max): " << percent(score.radius_errors, 0.5) << " "
      << percent(score.radius_errors, 0.9) << " " << percent(score.radius_errors, 1)
      << "; position error % R: " << percent(score.position_errors, 0.5) << " "
      << percent(score.position_errors, 0.9) << " " << percent(score.position_errors, 1) << "\n"
      << "truth in interval " << score.coverage() << " of " << score.intervals << "; slope error "
      << quantile(score.slope_errors, 0.5) << "; curvature error % "
      << percent(score.curvature_errors, 0.5) << "; "
      << 1000 * score.seconds / double(std::max<std::size_t>(score.scenes, 1)) << " ms/scene\n";
  out << std::left << std::setw(12) << "truth";
  for(const char* name : names_of_found_shapes)
    out << std::setw(8) << name;
  out << "missed\n";
  for(std::size_t shape = 0; shape < names_of_truth_shapes.size(); ++shape) {
    out << std::setw(12) << names_of_truth_shapes[shape];
    for(std::size_t number : score.confusion[shape])
      out << std::setw(8) << number;
    out << "\n";
  }
  return out << std::right;
}

} // namespace Paper
