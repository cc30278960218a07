// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MAPT_MAP_FILE_H
#define MAPT_MAP_FILE_H

#include <CGAL/Area_projection_transform/IO/Grid_image.h>

#include <string>
#include <vector>

namespace mapt {

/// the extension of a file name, in lower case.
std::string extension_of(const std::string& file);

/// \throw Usage_error if the extension of `file` is not one of `extensions`.
void check_extension(const std::string& option, const std::string& file,
                     const std::vector<std::string>& extensions);

/// \throw Output_error if a file of that name cannot be made; found out before a long computation.
void check_writable(const std::string& file);

/// \throw Usage_error if the output would replace an input, Output_error if it cannot be written.
void check_output(const std::string& option, const std::string& file,
                  const std::vector<std::string>& inputs);

/// a file that an option names; empty if it is not given.
struct Named_output
{
  std::string option, file;
};

/// \throw Usage_error also if two of them are one file.
void check_outputs(const std::vector<Named_output>& outputs,
                   const std::vector<std::string>& inputs);

/// writes .vti or .nrrd.
/// \throw Output_error if it cannot be written.
void write_map(const std::string& file, const CGAL::Area_projection::IO::Grid_image& image,
               bool is_compressed);

/// reads .vti or .nrrd.
/// \throw Input_error if it cannot be read.
CGAL::Area_projection::IO::Stored_image read_map(const std::string& file);

} // namespace mapt

#endif // MAPT_MAP_FILE_H
