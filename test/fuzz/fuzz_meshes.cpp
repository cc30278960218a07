// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Files of meshes and points: a line with the extension and options, then the bytes of the file.

#include "fuzz.h"

#include "errors.h"
#include "input.h"

#include <cctype>
#include <cmath>

namespace {

using fuzz::require;

mapt::Reading_options options_of(std::string_view line)
{
  mapt::Reading_options options;
  options.orient = line.find("orient") != line.npos;
  options.flip = line.find("flip") != line.npos;
  options.estimate_normals = line.find("normals") != line.npos;
  return options;
}

/// a name as files may have: what a message says of others is theirs.
std::string name_of(std::string_view line)
{
  std::string name = "file";
  for(const char c : line.substr(0, line.find(' ')))
    name += c == '.' || std::isalnum(static_cast<unsigned char>(c)) ? c : '_';
  return name;
}

/// what the comment of `mapt::Input` says.
void check_mesh(const mapt::Input& input)
{
  require(!input.triangles.empty() && input.source_faces.size() == input.triangles.size(),
          "a mesh has triangles, of a face each");
  require(input.report.area > 0, "a mesh has an area");
  for(const auto& triangle : input.triangles)
    for(const std::uint32_t v : triangle)
      require(v < input.points.size(), "indices are in range");
  for(const std::uint32_t face : input.source_faces)
    require(face < input.report.faces, "triangles come from faces of the file");
}

void check_points(const mapt::Input& input)
{
  require(input.triangles.empty() && !input.points.empty(), "a point set has points only");
  require(input.normals.size() == input.points.size() &&
              input.source_points.size() == input.points.size(),
          "each point has a normal and comes from the file");
  require(input.areas.empty() || input.areas.size() == input.points.size(),
          "all points have an area, or none has");
  for(const mapt::Vector_3& n : input.normals)
    require(std::abs(n.squared_length() - 1) < 1e-12, "normals are of unit length");
}

void check(const mapt::Input& input)
{
  for(const mapt::Point_3& p : input.points)
    require(mapt::is_usable(p.x(), p.y(), p.z()), "coordinates are finite");
  if(input.is_point_set)
    check_points(input);
  else
    check_mesh(input);
  for(const std::string& warning : mapt::warnings(input.report))
    fuzz::require_one_line(warning);
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  std::string_view text(reinterpret_cast<const char*>(data), size);
  const std::string_view line = fuzz::first_line(text);
  const mapt::Input_file file{name_of(line), std::string(text)};
  try {
    check(mapt::read_input(file, options_of(line)));
  } catch(const mapt::Input_error& error) {
    fuzz::require_one_line(error.what(), file.name);
  } catch(const mapt::Usage_error& error) {
    fuzz::require_one_line(error.what(), "--estimate-normals");
  }
  return 0;
}
