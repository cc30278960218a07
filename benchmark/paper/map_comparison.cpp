// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "map_comparison.h"

#include "local_maxima.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>

namespace Paper {

namespace {

using mapt::Local_maximum;
using Voxel = std::array<int, 3>;

/// calls `visit(i, j, k)` for the voxels of a region.
template <class Visit>
void for_each_voxel(const AP::Row_spans& region, Visit&& visit)
{
  const AP::Grid_3& grid = region.grid();
  for(int k = 0; k < grid.size()[2]; ++k)
    for(int j = 0; j < grid.size()[1]; ++j) {
      const auto [begin, end] = region.runs(grid.row(j, k));
      for(auto run = begin; run != end; ++run)
        for(int i = run->first; i < run->last; ++i)
          visit(i, j, k);
    }
}

Voxel voxel_at(const AP::Grid_3& grid, const AP::Point_3& p)
{
  const AP::Vector_3 c = grid.lattice_coordinates(p);
  return {int(std::lround(c.x())), int(std::lround(c.y())), int(std::lround(c.z()))};
}

Eigen::Vector3d to_vector(const AP::Vector_3& v)
{
  return {v.x(), v.y(), v.z()};
}

/// the voxels around a maximum that are almost as high.
std::vector<Voxel> plateau(const AP::Joint_map& map, const Local_maximum& maximum)
{
  const Voxel top = voxel_at(map.grid(), maximum.position);
  const double reach = std::pow(maximum.radius / map.grid().spacing(), 2);
  std::set<Voxel> seen{top};
  std::vector<Voxel> voxels{top};
  for(std::size_t next = 0; next < voxels.size(); ++next)
    for(int place = 0; place < 27; ++place) {
      const Voxel v{voxels[next][0] + place % 3 - 1, voxels[next][1] + place / 3 % 3 - 1,
                    voxels[next][2] + place / 9 - 1};
      const double distance =
          std::pow(v[0] - top[0], 2) + std::pow(v[1] - top[1], 2) + std::pow(v[2] - top[2], 2);
      if(distance <= reach && map.value(v[0], v[1], v[2]) >= 0.9 * maximum.value &&
         seen.insert(v).second)
        voxels.push_back(v);
    }
  return voxels;
}

/// the covariance of voxels, each a cube of side 1.
Eigen::Matrix3d covariance(const std::vector<Voxel>& voxels)
{
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for(const Voxel& v : voxels)
    mean += Eigen::Vector3d(v[0], v[1], v[2]) / double(voxels.size());
  Eigen::Matrix3d sum = Eigen::Matrix3d::Identity() / 12;
  for(const Voxel& v : voxels) {
    const Eigen::Vector3d d = Eigen::Vector3d(v[0], v[1], v[2]) - mean;
    sum += d * d.transpose() / double(voxels.size());
  }
  return sum;
}

/// the part of a displacement in the directions in which the plateau of a maximum is narrow.
double length_across(const AP::Joint_map& map, const Local_maximum& maximum,
                     const Eigen::Vector3d& displacement)
{
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(covariance(plateau(map, maximum)));
  double square = 0;
  for(int axis = 0; axis < 3; ++axis)
    if(solver.eigenvalues()[axis] <=
       4 * solver.eigenvalues()[0]) // twice as far: four times squared
      square += std::pow(solver.eigenvectors().col(axis).dot(displacement), 2);
  return std::sqrt(square);
}

bool have_similar_radii(const AP::Joint_map& map, double a, double b)
{
  if(std::abs(a - b) <= 0.25 * std::max(a, b))
    return true;
  const auto place = [&](double radius) {
    return std::find_if(map.scales().begin(), map.scales().end(),
                        [radius](const AP::Scale& s) { return s.radius == radius; }) -
           map.scales().begin();
  };
  return std::abs(place(a) - place(b)) <= 1;
}

/// takes the nearest candidate that may be the same maximum out of the list.
bool take_match(const AP::Joint_map& map, const Local_maximum& maximum,
                std::vector<Local_maximum>& candidates, Local_maximum& match)
{
  auto nearest = candidates.end();
  double least = std::pow(2 * maximum.radius, 2);
  for(auto c = candidates.begin(); c != candidates.end(); ++c) {
    const double distance = CGAL::squared_distance(c->position, maximum.position);
    if(distance <= least && have_similar_radii(map, c->radius, maximum.radius)) {
      least = distance;
      nearest = c;
    }
  }
  if(nearest == candidates.end())
    return false;
  match = *nearest;
  candidates.erase(nearest);
  return true;
}

Maximum_change change(const AP::Joint_map& clean, const Local_maximum& maximum,
                      const Local_maximum& match)
{
  const Eigen::Vector3d displacement =
      to_vector((match.position - maximum.position) / clean.grid().spacing());
  const Voxel there = voxel_at(clean.grid(), match.position);
  Maximum_change result;
  result.is_lost = false;
  result.displacement = displacement.norm();
  result.across = length_across(clean, maximum, displacement);
  result.score_ratio = match.value / maximum.value;
  result.clean_value_there = clean.value(there[0], there[1], there[2]) / maximum.value;
  return result;
}

} // namespace

Map_difference compare(const AP::Row_spans& region, const std::vector<float>& clean,
                       const std::vector<float>& other, double factor)
{
  const double n = double(region.number_of_voxels());
  double mean_a = 0, mean_b = 0, squares_of_difference = 0;
  for_each_voxel(region, [&](int i, int j, int k) {
    const std::size_t v = region.index(i, j, k);
    const double a = clean[v], b = factor * other[v];
    mean_a += a / n;
    mean_b += b / n;
    squares_of_difference += (a - b) * (a - b);
  });
  double aa = 0, ab = 0, bb = 0;
  for_each_voxel(region, [&](int i, int j, int k) {
    const std::size_t v = region.index(i, j, k);
    const double a = clean[v] - mean_a, b = factor * other[v] - mean_b;
    aa += a * a;
    ab += a * b;
    bb += b * b;
  });
  const double squares = aa + n * mean_a * mean_a;
  return {aa > 0 && bb > 0 ? ab / std::sqrt(aa * bb) : 0.,
          squares > 0 ? std::sqrt(squares_of_difference / squares) : 0.};
}

Region_agreement compare(const AP::Row_spans& clean, const AP::Row_spans& other)
{
  double common = 0;
  for_each_voxel(clean, [&](int i, int j, int k) { common += other.contains(i, j, k); });
  const double size = double(clean.number_of_voxels());
  const double size_of_other = double(other.number_of_voxels());
  return {size > 0 ? common / size : 0., size_of_other > 0 ? 1 - common / size_of_other : 0.};
}

std::vector<Maximum_change> compare_maxima(const AP::Joint_map& clean, const AP::Joint_map& other,
                                           std::size_t number)
{
  std::vector<Local_maximum> candidates =
      mapt::strongest_local_maxima(other, std::numeric_limits<std::size_t>::max());
  std::vector<Maximum_change> changes;
  for(const Local_maximum& maximum : mapt::strongest_local_maxima(clean, number)) {
    Local_maximum match;
    changes.push_back(take_match(clean, maximum, candidates, match) ? change(clean, maximum, match)
                                                                    : Maximum_change());
  }
  return changes;
}

} // namespace Paper
