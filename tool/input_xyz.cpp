// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "input_text.h"

namespace mapt {

namespace {

// returns how many words follow on the line.
std::size_t number_of_words(Text_cursor cursor)
{
  std::size_t words = 0;
  while(!cursor.word().empty())
    ++words;
  return words;
}

} // namespace

// One point a line: x y z nx ny nz, perhaps its area, after an optional line with their number.
Raw_mesh read_xyz(const Input_file& file)
{
  Raw_mesh mesh;
  Text_cursor cursor(file.bytes);
  std::size_t columns = 0;
  while(cursor.next_line()) {
    const std::size_t words = number_of_words(cursor);
    if(words == 1 && mesh.points.empty() && columns == 0) {
      long long number_of_points = 0;
      if(!parse(cursor.word(), number_of_points))
        file.fail(cursor.line(), "is not a point: must be x y z nx ny nz, perhaps with an area");
      continue;
    }
    if(columns == 0)
      columns = words;
    if(words != columns || (words != 3 && words != 6 && words != 7))
      file.fail(cursor.line(), "point " + std::to_string(mesh.points.size()) + " has " +
                                   std::to_string(words) +
                                   " numbers: all lines must have the "
                                   "same, x y z nx ny nz and perhaps an area");
    const auto element = [&mesh] { return "point " + std::to_string(mesh.points.size()); };
    const Vector_3 v = three_coordinates(file, cursor, element);
    if(columns >= 6)
      mesh.normals.push_back(three_numbers(file, cursor, element));
    if(columns == 7) {
      const std::string_view word = cursor.word();
      double area = 0;
      if(!parse(word, area))
        file.fail(cursor.line(), element() + " has " + in_quotes(word) + " for its area");
      mesh.areas.push_back(area);
    }
    mesh.points.emplace_back(v.x(), v.y(), v.z());
  }
  return mesh;
}

} // namespace mapt
