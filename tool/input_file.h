// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MAPT_INPUT_FILE_H
#define MAPT_INPUT_FILE_H

#include <CGAL/Area_projection_transform/Kernel.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace mapt {

using CGAL::Area_projection::Point_3;
using CGAL::Area_projection::Vector_3;

/// the bytes of a file, with its name for the messages.
struct Input_file
{
  std::string name;
  std::string bytes;

  /// throws `Input_error` with the message "name: what".
  [[noreturn]] void fail(const std::string& what) const;
  /// throws `Input_error` with the message "name: line 9: what".
  [[noreturn]] void fail(std::size_t line, const std::string& what) const;
};

/// the faces of a file, as vertex indices one face after the other.
struct Polygons
{
  std::vector<std::uint32_t> vertices;
  std::vector<std::size_t> ends; // of face i in `vertices`; it begins where face i-1 ends

  std::size_t size() const { return ends.size(); }
  std::size_t begin_of(std::size_t face) const { return face == 0 ? 0 : ends[face - 1]; }
  std::size_t degree(std::size_t face) const { return ends[face] - begin_of(face); }
  void close_face() { ends.push_back(vertices.size()); }
};

/// what a reader found: indices are in range and coordinates usable, nothing else is promised.
struct Raw_mesh
{
  std::vector<Point_3> points;
  Polygons polygons;
  std::vector<Vector_3> normals; // per point, or empty
  std::vector<double> areas;     // per point, or empty
};

// Readers of our own, because CGAL's of 5.5.1 and 6 trust their input: counts of the header are
// allocated or looped over unseen, some indices are not checked, PLY coordinates of integer type
// crash, and a failure has no cause. All of these end on any bytes, in time and memory
// proportional to the size of the file.
Raw_mesh read_off(const Input_file& file);
Raw_mesh read_obj(const Input_file& file);
Raw_mesh read_ply(const Input_file& file);
Raw_mesh read_stl(const Input_file& file);
Raw_mesh read_xyz(const Input_file& file);
Raw_mesh read_vtp(const Input_file& file);

/// \brief maps are floats: of shapes up to this size, and of those over one of it, all that is stored is a normal number.
///
/// The library takes more, for what is not stored.
constexpr double largest_coordinate = 1e15;

inline bool is_usable(double x, double y, double z)
{
  // written so that NaN fails
  return std::abs(x) <= largest_coordinate && std::abs(y) <= largest_coordinate &&
         std::abs(z) <= largest_coordinate;
}

/// returns the cause and the remedy for coordinates that are not usable, as the end of a sentence
/// that begins with the element ("vertex 812 ").
std::string coordinate_defect(double x, double y, double z);

/// returns the cause and the remedy for an index of a face that is not in [`first`, `last`].
std::string index_defect(long long index, long long first, long long last);

} // namespace mapt

#endif // MAPT_INPUT_FILE_H
