// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MAPT_INPUT_H
#define MAPT_INPUT_H

#include "input_file.h"
#include "mesh_report.h"

#include <array>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

namespace mapt {

/// an input that cannot be used; the message is one line with the file, the element, the cause and
/// the remedy.
class Input_error : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

struct Reading_options
{
  bool orient = false;           // turn faces over until neighbours agree
  bool flip = false;             // turn all faces over, and do not look for faces that point inward
  bool estimate_normals = false; // of points that have none
};

/// a file, checked and ready for the library: either triangles or points with normals.
///
/// Indices are in range, coordinates are finite, every triangle has an area and every normal is of
/// unit length.
struct Input
{
  std::string file;
  bool is_point_set = false;
  std::vector<Point_3> points;
  std::vector<std::array<std::uint32_t, 3>> triangles; // none of a point set
  std::vector<std::uint32_t> source_faces;             // the face of the file of each triangle
  std::vector<Vector_3> normals;                       // of a point set
  std::vector<std::uint32_t> source_points;            // the place in the file of each point of one
  std::vector<double> areas;                           // of a point set, if the file has them
  Mesh_report report;
};

/// reads a mesh, a soup of polygons, or points with normals from a file in a format that its
/// extension tells: .off .obj .ply .stl .vtp .xyz.
///
/// Polygons become triangles. Faces without an area and points without a normal are left out.
/// Closed parts of which the faces point inward are turned over.
/// \throw Input_error if the file cannot be read or there is nothing to compute with.
/// \throw Usage_error if normals are to be estimated and there are faces, or normals.
Input read_input(const std::string& file, const Reading_options& options = {});

/// the same for bytes that are in memory already.
Input read_input(const Input_file& file, const Reading_options& options = {});

} // namespace mapt

#endif // MAPT_INPUT_H
