// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "salient_scenes.h"

#include "shapes.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace Paper {

namespace {

constexpr double pi = 3.14159265358979323846;

class Dice
{
public:
  explicit Dice(std::uint64_t seed) : m_random(seed) {}

  bool is_true(double probability) { return m_random.uniform() < probability; }
  double uniform(double low, double high) { return low + (high - low) * m_random.uniform(); }
  double log_uniform(double low, double high)
  {
    return low * std::pow(high / low, m_random.uniform());
  }
  int one_of(int low, int high) { return low + int(m_random.below(std::size_t(high - low + 1))); }
  double radius() { return log_uniform(0.2, 1); }
  Random& random() { return m_random; }

private:
  Random m_random;
};

/// \name Objects around the origin
/// @{

Labelled_shape plain_sphere(Dice& dice)
{
  const double radius = dice.radius();
  return labelled_sphere(radius, dice.is_true(0.4) ? 4 : 3);
}

/// quadrangles are a bit long, so that tubes have about as many faces as spheres.
Labelled_shape finished(Tube tube)
{
  tube.rows = rows_for(tube, 1.2);
  return labelled_tube(tube);
}

Labelled_shape plain_tube(Dice& dice)
{
  Tube tube;
  tube.radius = dice.radius();
  tube.length = tube.radius * dice.uniform(3, 7);
  tube.sides = dice.is_true(0.4) ? 64 : 32;
  return finished(tube);
}

Labelled_shape coarse_tube(Dice& dice)
{
  Tube tube;
  tube.radius = dice.radius();
  tube.length = tube.radius * dice.uniform(3, 7);
  tube.sides = dice.one_of(12, 16);
  tube.rows = dice.is_true(1. / 3) ? 1 : rows_for(tube, 1);
  return labelled_tube(tube);
}

Labelled_shape bent_tube(Dice& dice)
{
  Tube tube;
  tube.radius = dice.radius();
  tube.curvature = 1 / (tube.radius * dice.uniform(3, 8));
  tube.length = dice.uniform(40, 150) * pi / 180 / tube.curvature;
  tube.sides = 8 * dice.one_of(3, 6);
  return finished(tube);
}

Labelled_shape cone(Dice& dice)
{
  Tube tube;
  tube.radius = dice.radius();
  tube.length = tube.radius * dice.uniform(4, 8);
  tube.slope = dice.uniform(0.02, 0.1);
  tube.sides = 8 * dice.one_of(3, 6);
  return finished(tube);
}

Labelled_shape ellipsoid(Dice& dice)
{
  const double radius = dice.radius(), ratio = dice.log_uniform(1.15, 2);
  const int levels = dice.is_true(0.4) ? 4 : 3;
  return dice.is_true(0.5) ? labelled_ellipsoid(radius, ratio * radius, levels)
                           : labelled_ellipsoid(radius, radius / ratio, levels);
}
/// @}

/// puts objects beside each other.
class Arrangement
{
public:
  explicit Arrangement(Dice& dice) : m_dice(dice) {}

  void add_apart(const Labelled_shape& shape)
  {
    double side = 3; // of the cube in which there are centres
    for(;; side *= 1.05) {
      const double x = m_dice.uniform(0, side), y = m_dice.uniform(0, side),
                   z = m_dice.uniform(0, side);
      const Labelled_shape there = posed(shape, random_pose({x, y, z}, m_dice.random()));
      if(is_free(there, std::nullopt)) {
        add(there);
        return;
      }
    }
  }

  /// \pre the object is a sphere
  void add_touching(const Labelled_shape& sphere)
  {
    for(int attempt = 0; attempt < 200 && !m_placed.empty(); ++attempt) {
      const std::size_t neighbour = m_dice.random().below(m_placed.size());
      const Truth& other = m_placed[neighbour].truth;
      if(other.shape != Truth_shape::SPHERE && other.shape != Truth_shape::TUBE)
        continue;
      const Pose pose = random_pose(center_beside(other, sphere.truth.radius), m_dice.random());
      const Labelled_shape there = posed(sphere, pose);
      if(is_free(there, neighbour)) {
        add(there);
        return;
      }
    }
    add_apart(sphere);
  }

  /// cuts the last object in half.
  void cut_last()
  {
    Labelled_shape& last = m_placed.back();
    const Vector_3 normal = last.truth.is_tubular()
                                ? random_direction_across(last.truth.axis, m_dice.random())
                                : random_direction(m_dice.random());
    last = cut(last, normal);
  }

  Scene scene() const
  {
    Scene scene;
    for(const Labelled_shape& shape : m_placed) {
      const std::uint32_t first_point = std::uint32_t(scene.soup.points.size());
      const std::uint32_t first_face = std::uint32_t(scene.soup.triangles.size());
      scene.soup.points.insert(scene.soup.points.end(), shape.soup.points.begin(),
                               shape.soup.points.end());
      for(const auto& [a, b, c] : shape.soup.triangles)
        scene.soup.triangles.push_back({first_point + a, first_point + b, first_point + c});
      scene.truths.push_back(shape.truth);
      for(std::uint32_t& face : scene.truths.back().faces)
        face += first_face;
    }
    return scene;
  }

private:
  void add(const Labelled_shape& shape) { m_placed.push_back(shape); }

  Point_3 center_beside(const Truth& other, double radius)
  {
    const double distance = other.radius + radius;
    if(other.shape == Truth_shape::SPHERE)
      return other.center + distance * random_direction(m_dice.random());
    return other.center + m_dice.uniform(-0.45, 0.45) * other.length * other.axis +
           distance * random_direction_across(other.axis, m_dice.random());
  }

  /// whether it keeps a gap from all others but one.
  bool is_free(const Labelled_shape& shape, std::optional<std::size_t> neighbour) const
  {
    for(std::size_t i = 0; i < m_placed.size(); ++i)
      if(i != neighbour && are_near(shape, m_placed[i]))
        return false;
    return true;
  }

  static bool are_near(const Labelled_shape& a, const Labelled_shape& b)
  {
    const double gap = 0.1 * std::max(a.truth.radius, b.truth.radius);
    for(const Ball& p : a.cover)
      for(const Ball& q : b.cover)
        if(std::sqrt(CGAL::squared_distance(p.center, q.center)) < p.radius + q.radius + gap)
          return true;
    return false;
  }

  Dice& m_dice;
  std::vector<Labelled_shape> m_placed;
};

void add_plain(Dice& dice, Arrangement& arrangement)
{
  if(!dice.is_true(0.5))
    arrangement.add_apart(plain_tube(dice));
  else if(dice.is_true(0.4))
    arrangement.add_touching(plain_sphere(dice));
  else
    arrangement.add_apart(plain_sphere(dice));
  if(dice.is_true(0.3))
    arrangement.cut_last();
}

void add_hard(Dice& dice, Arrangement& arrangement)
{
  const int kind = dice.one_of(0, 9);
  if(kind < 3)
    arrangement.add_apart(coarse_tube(dice));
  else if(kind < 5)
    arrangement.add_apart(bent_tube(dice));
  else if(kind < 7)
    arrangement.add_apart(cone(dice));
  else if(kind < 9)
    arrangement.add_apart(ellipsoid(dice));
  else
    add_plain(dice, arrangement);
}

Scene scene_of(std::uint64_t seed, void (*add)(Dice&, Arrangement&))
{
  Dice dice(seed);
  Arrangement arrangement(dice);
  for(int left = dice.one_of(3, 10); left > 0; --left)
    add(dice, arrangement);
  return arrangement.scene();
}

} // namespace

Scene easy_scene(std::uint64_t seed)
{
  return scene_of(seed, add_plain);
}

Scene hard_scene(std::uint64_t seed)
{
  return scene_of(seed, add_hard);
}

std::vector<Distractor> distractors(std::uint64_t seed)
{
  Random random(seed);
  const auto distractor = [&](const std::string& name, Soup soup) {
    const Pose pose = random_pose(CGAL::ORIGIN, random);
    for(Point_3& p : soup.points)
      p = pose(p);
    return Distractor{name, {std::move(soup), {}}};
  };
  std::vector<Distractor> all;
  const auto add_box = [&](const std::string& name, const std::array<int, 3>& sides,
                           double spacing) {
    all.push_back(distractor(name, box(sides, spacing)));
    Soup coarse = box({1, 1, 1}, 1);
    for(Point_3& p : coarse.points)
      p = Point_3(spacing * sides[0] * p.x(), spacing * sides[1] * p.y(),
                  spacing * sides[2] * p.z());
    all.push_back(distractor("coarse " + name, std::move(coarse)));
  };
  add_box("box", {36, 36, 36}, 1. / 18);
  add_box("brick", {60, 40, 20}, 1. / 20);
  add_box("plate", {75, 60, 6}, 1. / 15);
  all.push_back(distractor("torus", torus(1, 1 / 3.3, 160, 48)));
  return all;
}

} // namespace Paper
