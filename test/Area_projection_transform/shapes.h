// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef AREA_PROJECTION_TRANSFORM_TEST_SHAPES_H
#define AREA_PROJECTION_TRANSFORM_TEST_SHAPES_H

// Shapes whose transform is known, as triangle soups that name their points, facing outward; and what
// tests need to turn them into meshes, to move them, and to compare maps of them.

#include <CGAL/Area_projection_transform/regions.h>
#include <CGAL/Area_projection_transform/scales.h>
#include <CGAL/Area_projection_transform/scale_space/Constant_scale_space.h>
#include <CGAL/Area_projection_transform/surfels_from_mesh.h>

#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <map>
#include <random>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace shapes {

namespace AP = CGAL::Area_projection;

using AP::Point_3;
using AP::Vector_3;
using Triangle = std::array<std::uint32_t, 3>;

constexpr double pi = 3.14159265358979323846;

/// uniform numbers that are the same on every platform, unlike those of the standard distributions.
class Random
{
public:
  explicit Random(std::uint64_t seed) : m_engine(seed) {}

  double operator()(double low = 0, double high = 1)
  {
    return low + (high - low) * double(m_engine() >> 11) * 0x1p-53;
  }

  Point_3 point_in(const CGAL::Bbox_3& box)
  {
    const double x = (*this)(box.xmin(), box.xmax()), y = (*this)(box.ymin(), box.ymax());
    return Point_3(x, y, (*this)(box.zmin(), box.zmax()));
  }

  /// by Archimedes, height and longitude are independent and uniform on a sphere.
  Vector_3 direction()
  {
    const double z = (*this)(-1, 1), phi = (*this)(0, 2 * pi), r = std::sqrt(1 - z * z);
    return Vector_3(r * std::cos(phi), r * std::sin(phi), z);
  }

  template <class T>
  void shuffle(std::vector<T>& elements)
  {
    for(std::size_t i = elements.size(); i > 1; --i)
      std::swap(elements[i - 1], elements[std::size_t((*this)(0, double(i)))]);
  }

private:
  std::mt19937_64 m_engine;
};

struct Soup
{
  std::vector<Point_3> points;
  std::vector<Triangle> triangles;

  double area() const
  {
    double sum = 0;
    for(const Triangle& t : triangles)
      sum += std::sqrt(CGAL::squared_area(points[t[0]], points[t[1]], points[t[2]]));
    return sum;
  }

  /// of a closed soup, by the divergence theorem.
  double volume() const
  {
    double sum = 0;
    for(const Triangle& t : triangles)
      sum += CGAL::volume(Point_3(0, 0, 0), points[t[0]], points[t[1]], points[t[2]]);
    return sum;
  }
};

/// \name What is done to soups
/// @{

template <class Function>
Soup moved(Soup soup, Function function)
{
  for(Point_3& p : soup.points)
    p = function(p);
  return soup;
}

inline Soup translated(const Soup& soup, const Vector_3& v)
{
  return moved(soup, [v](const Point_3& p) { return p + v; });
}

inline Soup scaled(const Soup& soup, double factor)
{
  return moved(soup,
               [factor](const Point_3& p) { return CGAL::ORIGIN + factor * (p - CGAL::ORIGIN); });
}

inline Soup flipped(Soup soup)
{
  for(Triangle& t : soup.triangles)
    std::swap(t[1], t[2]);
  return soup;
}

inline Soup joined(Soup a, const Soup& b)
{
  const std::uint32_t offset = std::uint32_t(a.points.size());
  a.points.insert(a.points.end(), b.points.begin(), b.points.end());
  for(const Triangle& t : b.triangles)
    a.triangles.push_back({t[0] + offset, t[1] + offset, t[2] + offset});
  return a;
}

/// the same triangles, with faces and points in another order.
inline Soup shuffled(const Soup& soup, std::uint64_t seed)
{
  Random random(seed);
  std::vector<std::uint32_t> old_of_new(soup.points.size());
  for(std::uint32_t i = 0; i < old_of_new.size(); ++i)
    old_of_new[i] = i;
  random.shuffle(old_of_new);
  Soup result;
  std::vector<std::uint32_t> new_of_old(soup.points.size());
  for(std::uint32_t i = 0; i < old_of_new.size(); ++i) {
    new_of_old[old_of_new[i]] = i;
    result.points.push_back(soup.points[old_of_new[i]]);
  }
  for(const Triangle& t : soup.triangles)
    result.triangles.push_back({new_of_old[t[0]], new_of_old[t[1]], new_of_old[t[2]]});
  random.shuffle(result.triangles);
  return result;
}

template <class Predicate>
Soup without_faces(Soup soup, Predicate is_removed)
{
  const auto centroid_is_removed = [&](const Triangle& t) {
    return is_removed(CGAL::centroid(soup.points[t[0]], soup.points[t[1]], soup.points[t[2]]));
  };
  soup.triangles.erase(
      std::remove_if(soup.triangles.begin(), soup.triangles.end(), centroid_is_removed),
      soup.triangles.end());
  return soup;
}

/// each point moved by up to `size` in each direction of the axes: with a variance of `size² / 3` in all directions.
inline Soup displaced(const Soup& soup, double size, std::uint64_t seed)
{
  Random random(seed);
  return moved(soup, [&](const Point_3& p) {
    const double x = random(-size, size), y = random(-size, size);
    return p + Vector_3(x, y, random(-size, size));
  });
}

/// the triangles `keep(i)` is true for.
template <class Predicate>
Soup only_triangles(const Soup& soup, Predicate keep)
{
  Soup result{soup.points, {}};
  for(std::size_t i = 0; i < soup.triangles.size(); ++i)
    if(keep(i))
      result.triangles.push_back(soup.triangles[i]);
  return result;
}

/// a share of the triangles, drawn at random.
inline Soup thinned(const Soup& soup, double share, std::uint64_t seed)
{
  Random random(seed);
  return only_triangles(soup, [&](std::size_t) { return random() < share; });
}

/// each triangle has points of its own.
inline Soup unmerged(const Soup& soup)
{
  Soup result;
  for(const Triangle& t : soup.triangles) {
    const std::uint32_t first = std::uint32_t(result.points.size());
    for(const std::uint32_t v : t)
      result.points.push_back(soup.points[v]);
    result.triangles.push_back({first, first + 1, first + 2});
  }
  return result;
}

/// a rotation by the angle `angle` about a unit vector (Rodrigues' formula).
struct Rotation
{
  Vector_3 axis;
  double angle;

  Point_3 operator()(const Point_3& p) const
  {
    const Vector_3 v = p - CGAL::ORIGIN;
    return CGAL::ORIGIN + std::cos(angle) * v + std::sin(angle) * CGAL::cross_product(axis, v) +
           (1 - std::cos(angle)) * (axis * v) * axis;
  }
};

/// @}
/// \name Shapes
/// @{

/// \brief a patch of `n` by `m` squares, cut into triangles, with the corners `point(i, j)`; the normal is
/// that of ∂/∂i × ∂/∂j. Rows that coincide are not joined: `welded()` does that.
template <class PointOf>
Soup lattice_patch(int n, int m, PointOf point)
{
  Soup soup;
  for(int i = 0; i <= n; ++i)
    for(int j = 0; j <= m; ++j)
      soup.points.push_back(point(i, j));
  const auto index = [m](int i, int j) { return std::uint32_t(i * (m + 1) + j); };
  for(int i = 0; i < n; ++i)
    for(int j = 0; j < m; ++j) {
      soup.triangles.push_back({index(i, j), index(i + 1, j), index(i + 1, j + 1)});
      soup.triangles.push_back({index(i, j), index(i + 1, j + 1), index(i, j + 1)});
    }
  return soup;
}

/// \brief joins the points that are the same up to `1e-9` and drops the triangles that are left
/// without area: makes closed surfaces of patches.
inline Soup welded(const Soup& soup)
{
  Soup result;
  std::map<std::array<long long, 3>, std::uint32_t> index_of;
  std::vector<std::uint32_t> new_of_old;
  for(const Point_3& p : soup.points) {
    const std::array<long long, 3> key{std::llround(p.x() * 1e9), std::llround(p.y() * 1e9),
                                       std::llround(p.z() * 1e9)};
    const auto [found, is_new] = index_of.emplace(key, std::uint32_t(result.points.size()));
    if(is_new)
      result.points.push_back(p);
    new_of_old.push_back(found->second);
  }
  for(const Triangle& t : soup.triangles) {
    const Triangle u{new_of_old[t[0]], new_of_old[t[1]], new_of_old[t[2]]};
    if(u[0] != u[1] && u[1] != u[2] && u[2] != u[0])
      result.triangles.push_back(u);
  }
  return result;
}

/// the faces of an icosahedron, divided `level` times into four; all points on the sphere.
inline Soup icosphere(int level, const Point_3& center = Point_3(0, 0, 0), double radius = 1)
{
  const double t = (1 + std::sqrt(5.)) / 2;
  Soup soup;
  soup.points = {{-1, t, 0},  {1, t, 0},  {-1, -t, 0}, {1, -t, 0}, {0, -1, t},  {0, 1, t},
                 {0, -1, -t}, {0, 1, -t}, {t, 0, -1},  {t, 0, 1},  {-t, 0, -1}, {-t, 0, 1}};
  soup.triangles = {{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                    {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                    {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                    {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}};
  for(int l = 0; l < level; ++l) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
    const auto middle = [&](std::uint32_t a, std::uint32_t b) {
      const auto [found, is_new] =
          middles.emplace(std::minmax(a, b), std::uint32_t(soup.points.size()));
      if(is_new) {
        const Vector_3 v = AP::internal::normalized(soup.points[a] - CGAL::ORIGIN) +
                           AP::internal::normalized(soup.points[b] - CGAL::ORIGIN);
        soup.points.push_back(CGAL::ORIGIN + v);
      }
      return found->second;
    };
    std::vector<Triangle> finer;
    for(const Triangle& f : soup.triangles) {
      const std::uint32_t ab = middle(f[0], f[1]), bc = middle(f[1], f[2]), ca = middle(f[2], f[0]);
      finer.insert(finer.end(), {{f[0], ab, ca}, {f[1], bc, ab}, {f[2], ca, bc}, {ab, bc, ca}});
    }
    soup.triangles = std::move(finer);
  }
  return moved(soup, [&](const Point_3& p) {
    return center + radius * AP::internal::normalized(p - CGAL::ORIGIN);
  });
}

/// \brief a prism of `sides` planes at the distance `radius` from the `z` axis, from `-length/2` to
/// `length/2`: the faces touch the cylinder, so that each is projected across the axis.
inline Soup cylinder(int sides, double radius, double length, bool is_closed, int rows = 8)
{
  const double corner_radius = radius / std::cos(pi / sides);
  const auto point = [&](double r, int i, double z) {
    const double phi = 2 * pi * i / sides;
    return Point_3(r * std::cos(phi), r * std::sin(phi), z);
  };
  Soup soup = lattice_patch(sides, rows, [&](int i, int j) {
    return point(corner_radius, i, length * (double(j) / rows - 0.5));
  });
  if(is_closed)
    for(const double z : {-0.5 * length, 0.5 * length}) {
      const Soup lid =
          lattice_patch(sides, 1, [&](int i, int j) { return point(j * corner_radius, i, z); });
      soup = joined(soup, z > 0 ? flipped(lid) : lid);
    }
  return welded(soup);
}

/// a closed cone with its base of the given radius at `z = 0` and its apex at `height`.
inline Soup cone(int sides, double radius, double height, int rows = 8)
{
  const auto point = [&](double r, int i, double z) {
    const double phi = 2 * pi * i / sides;
    return Point_3(r * std::cos(phi), r * std::sin(phi), z);
  };
  const Soup side = lattice_patch(sides, rows, [&](int i, int j) {
    return point(radius * (rows - j) / rows, i, height * j / rows);
  });
  const Soup base = lattice_patch(sides, 1, [&](int i, int j) { return point(j * radius, i, 0); });
  return welded(joined(side, base));
}

/// a torus about the `z` axis.
inline Soup torus(double ring_radius, double tube_radius, int n, int m)
{
  return welded(lattice_patch(n, m, [&](int i, int j) {
    const double u = 2 * pi * i / n, v = 2 * pi * j / m;
    const double r = ring_radius + tube_radius * std::cos(v);
    return Point_3(r * std::cos(u), r * std::sin(u), tube_radius * std::sin(v));
  }));
}

/// an open piece of a torus about the `z` axis, from the `x` axis on, all points on it.
inline Soup torus_arc(double ring_radius, double tube_radius, double angle, int n, int m)
{
  return welded(lattice_patch(n, m, [&](int i, int j) {
    const double u = angle * i / n, v = 2 * pi * j / m;
    const double r = ring_radius + tube_radius * std::cos(v);
    return Point_3(r * std::cos(u), r * std::sin(u), tube_radius * std::sin(v));
  }));
}

/// the box from 0 to `size`, its faces cut into squares of about the side `edge`.
inline Soup fine_box(const Vector_3& size, double edge)
{
  Soup all;
  for(int axis = 0; axis < 3; ++axis) {
    const int b = (axis + 1) % 3, c = (axis + 2) % 3;
    const int n = std::max(1, int(std::lround(size[b] / edge)));
    const int m = std::max(1, int(std::lround(size[c] / edge)));
    for(const double height : {0., size[axis]}) {
      const Soup side = lattice_patch(n, m, [&](int i, int j) {
        std::array<double, 3> p;
        p[std::size_t(axis)] = height;
        p[std::size_t(b)] = size[b] * i / n;
        p[std::size_t(c)] = size[c] * j / m;
        return Point_3(p[0], p[1], p[2]);
      });
      all = joined(all, height > 0 ? side : flipped(side));
    }
  }
  return welded(all);
}

/// a square of the given side in the plane of height `z`, facing up, its centre on the `z` axis.
inline Soup plane_patch(double side, double z, int n = 4)
{
  return lattice_patch(n, n, [&](int i, int j) {
    return Point_3(side * (double(i) / n - 0.5), side * (double(j) / n - 0.5), z);
  });
}

/// two squares a `thickness` apart, facing away from each other.
inline Soup slab(double side, double thickness)
{
  return joined(plane_patch(side, 0.5 * thickness), flipped(plane_patch(side, -0.5 * thickness)));
}

/// half a sphere about the origin, `z >= 0`, without a base.
inline Soup hemisphere(int n, double radius = 1)
{
  return welded(lattice_patch(4 * n, n, [&](int i, int j) {
    const double phi = pi / 2 * i / n, theta = pi / 2 * j / n;
    return Point_3(radius * std::cos(theta) * std::cos(phi),
                   radius * std::cos(theta) * std::sin(phi), radius * std::sin(theta));
  }));
}

inline Soup box(const Point_3& low, const Point_3& high)
{
  Soup soup;
  for(int corner = 0; corner < 8; ++corner)
    soup.points.emplace_back(corner & 1 ? high.x() : low.x(), corner & 2 ? high.y() : low.y(),
                             corner & 4 ? high.z() : low.z());
  soup.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                    {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return soup;
}

/// a random closed shape without symmetry: a sphere with waves of random directions on it.
inline Soup blob(int level, std::uint64_t seed)
{
  Random random(seed);
  std::vector<std::pair<Vector_3, double>> waves;
  for(int w = 0; w < 6; ++w) {
    const Vector_3 direction = random.direction() * random(1, 4);
    waves.emplace_back(direction, random(0, 2 * pi));
  }
  return moved(icosphere(level), [&](const Point_3& p) {
    const Vector_3 v = p - CGAL::ORIGIN;
    double radius = 1;
    for(const auto& [direction, phase] : waves)
      radius += 0.06 * std::sin(direction * v + phase);
    return CGAL::ORIGIN + radius * v;
  });
}

/// @}

inline AP::Triangle_surface surface_of(const Soup& soup)
{
  return AP::surface_from_triangle_soup(soup.points, soup.triangles);
}

inline AP::Constant_scale_space<AP::Triangle_surface> scale_space_of(const Soup& soup)
{
  return AP::Constant_scale_space(surface_of(soup));
}

/// makes a `Surface_mesh` or `Polyhedron_3` of any kernel; faces and vertices keep their order.
template <class Mesh>
Mesh mesh_of(const Soup& soup)
{
  using Point = typename boost::property_traits<
      typename boost::property_map<Mesh, CGAL::vertex_point_t>::type>::value_type;
  using Coordinate = std::decay_t<decltype(std::declval<Point>().x())>;
  std::vector<Point> points;
  for(const Point_3& p : soup.points)
    points.emplace_back(Coordinate(p.x()), Coordinate(p.y()), Coordinate(p.z()));
  std::vector<std::vector<std::size_t>> triangles;
  for(const Triangle& t : soup.triangles)
    triangles.push_back({t[0], t[1], t[2]});
  Mesh mesh;
  CGAL::Polygon_mesh_processing::polygon_soup_to_polygon_mesh(points, triangles, mesh);
  return mesh;
}

/// `number` points of equal area on the unit sphere, on a spiral that turns by the golden angle.
inline AP::Surfels fibonacci_sphere(std::size_t number)
{
  AP::Surfels surfels;
  for(std::size_t i = 0; i < number; ++i) {
    const double z = 1 - (2 * double(i) + 1) / double(number), phi = double(i) * 2.399963229728653;
    const double rho = std::sqrt(1 - z * z);
    const Vector_3 n(rho * std::cos(phi), rho * std::sin(phi), z);
    surfels.push_back(CGAL::ORIGIN + n, n, 4 * pi / double(number), std::uint32_t(i));
  }
  return surfels;
}

/// reads one of the meshes of the folder `data`, which are made of triangles.
inline Soup bundled_mesh(const std::string& name)
{
  std::ifstream in(std::string(AREA_PROJECTION_TRANSFORM_DATA) + "/" + name);
  if(!in)
    throw std::runtime_error(name + " is not in " AREA_PROJECTION_TRANSFORM_DATA);
  Soup soup;
  for(std::string line; std::getline(in, line);) {
    std::istringstream words(line);
    std::string kind;
    words >> kind;
    if(kind == "v") {
      double x, y, z;
      words >> x >> y >> z;
      soup.points.emplace_back(x, y, z);
    } else if(kind == "f") {
      std::array<std::string, 3> corners;
      words >> corners[0] >> corners[1] >> corners[2];
      Triangle t;
      for(int i = 0; i < 3; ++i)
        t[std::size_t(i)] = std::uint32_t(std::stoul(corners[std::size_t(i)]) - 1);
      soup.triangles.push_back(t);
    }
  }
  return soup;
}

/// never asks to stop.
struct Never
{
  bool operator()() const { return false; }
};

/// the areas that a projector finds in all voxels with storage, at the places of `Row_spans::index()`.
template <class Projector, class ScaleSpace>
std::vector<float> areas_on_grid(Projector&& projector, const ScaleSpace& surface,
                                 const AP::Row_spans& region, const AP::Scale& scale,
                                 AP::Side side = AP::Side::INSIDE)
{
  projector.project(surface, scale, side, Never());
  std::vector<float> areas(region.storage_size());
  std::vector<float> row_areas(std::size_t(region.grid().size()[0]));
  for(std::size_t row = 0; row < region.number_of_rows(); ++row) {
    const AP::Row_spans::Hull& hull = region.hull(row);
    if(hull.first == hull.last)
      continue;
    projector.take_row(row, row_areas.data());
    std::copy_n(row_areas.begin(), hull.last - hull.first,
                areas.begin() + std::ptrdiff_t(hull.offset));
  }
  return areas;
}

/// calls `function(centre, place)` for each voxel of interest.
template <class Function>
void for_each_voxel(const AP::Row_spans& region, Function function)
{
  const auto& size = region.grid().size();
  for(int k = 0; k < size[2]; ++k)
    for(int j = 0; j < size[1]; ++j) {
      const auto [begin, end] = region.runs(region.grid().row(j, k));
      for(auto run = begin; run != end; ++run)
        for(int i = run->first; i < run->last; ++i)
          function(region.grid().point(i, j, k), region.index(i, j, k));
    }
}

/// the root of the mean squared difference over that of the mean square of `expected`.
template <class Values, class Expected>
double relative_rms(const Values& values, const Expected& expected)
{
  double differences = 0, squares = 0;
  for(std::size_t i = 0; i < expected.size(); ++i) {
    const double d = double(values[i]) - double(expected[i]);
    differences += d * d;
    squares += double(expected[i]) * double(expected[i]);
  }
  return std::sqrt(differences / squares);
}

/// what a function complains about when it throws `std::invalid_argument`; empty if it does not.
template <class Function>
std::string complaint(Function function)
{
  try {
    function();
  } catch(const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

} // namespace shapes

#endif // AREA_PROJECTION_TRANSFORM_TEST_SHAPES_H
