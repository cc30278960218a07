// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "input_file.h"
#include "input.h"

#include <sstream>

namespace mapt {

void Input_file::fail(const std::string& what) const
{
  throw Input_error(name + ": " + what);
}

void Input_file::fail(std::size_t line, const std::string& what) const
{
  fail("line " + std::to_string(line) + ": " + what);
}

std::string coordinate_defect(double x, double y, double z)
{
  std::ostringstream text;
  if(std::isfinite(x) && std::isfinite(y) && std::isfinite(z))
    text << "is too far away (" << x << ", " << y << ", " << z
         << "): coordinates up to 1e15 can be used; rescale the shape";
  else
    text << "is not finite (" << x << ", " << y << ", " << z
         << "): give it coordinates, or remove it and its faces";
  return text.str();
}

std::string index_defect(long long index, long long first, long long last)
{
  const std::string remedy = "the file is damaged or cut off; export it again";
  if(last < first)
    return "uses vertex " + std::to_string(index) + ", but there are no vertices: " + remedy;
  return "uses vertex " + std::to_string(index) + ", which is not in " + std::to_string(first) +
         ".." + std::to_string(last) + ": " + remedy;
}

} // namespace mapt
