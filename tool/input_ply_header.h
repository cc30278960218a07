// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MAPT_INPUT_PLY_HEADER_H
#define MAPT_INPUT_PLY_HEADER_H

#include "input_text.h"

#include <cstddef>
#include <string>
#include <vector>

namespace mapt {

enum class Ply_type { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

enum class Ply_encoding { text, little_endian, big_endian };

struct Ply_property
{
  std::string name;
  Ply_type type = Ply_type::float32;
  bool is_list = false;
  Ply_type count_type = Ply_type::uint8; // of a list
};

struct Ply_element
{
  std::string name;
  std::size_t count = 0;
  std::vector<Ply_property> properties;
};

struct Ply_header
{
  Ply_encoding encoding = Ply_encoding::text;
  std::vector<Ply_element> elements;
};

/// reads the header and leaves the cursor behind the line end_header.
Ply_header read_ply_header(const Input_file& file, Text_cursor& cursor);

std::size_t size_of(Ply_type type);

} // namespace mapt

#endif // MAPT_INPUT_PLY_HEADER_H
