// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "map_file.h"

#include "errors.h"
#include "input.h"

#include <CGAL/Area_projection_transform/IO/NRRD.h>
#include <CGAL/Area_projection_transform/IO/VTI.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <new>
#include <set>

namespace mapt {

namespace IO = CGAL::Area_projection::IO;

std::string extension_of(const std::string& file)
{
  std::string extension = std::filesystem::path(file).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return char(std::tolower(c)); });
  return extension;
}

void check_extension(const std::string& option, const std::string& file,
                     const std::vector<std::string>& extensions)
{
  if(std::find(extensions.begin(), extensions.end(), extension_of(file)) != extensions.end())
    return;
  std::string list;
  for(const std::string& extension : extensions)
    list += (list.empty() ? "" : " or ") + extension;
  throw Usage_error(option + ": " + file + " must end in " + list);
}

void check_writable(const std::string& file)
{
  std::error_code ignored;
  if(std::filesystem::is_regular_file(file, ignored) || !std::filesystem::exists(file, ignored) ||
     std::filesystem::is_directory(file, ignored))
    IO::internal::Atomic_file probe(file); // is removed at once, since it is not committed
}

void check_output(const std::string& option, const std::string& file,
                  const std::vector<std::string>& inputs)
{
  for(const std::string& input : inputs) {
    std::error_code ignored; // of a file that does not exist
    if(std::filesystem::equivalent(input, file, ignored))
      throw Usage_error(option + " " + file + " would replace the input " + input +
                        ": choose another name");
  }
  check_writable(file);
}

void check_outputs(const std::vector<Named_output>& outputs, const std::vector<std::string>& inputs)
{
  std::set<std::filesystem::path> places;
  for(const auto& [option, file] : outputs) {
    if(file.empty())
      continue;
    std::error_code ignored; // of a file that does not exist
    if(!places.insert(std::filesystem::weakly_canonical(file, ignored)).second)
      throw Usage_error(option + " " + file + " is to be written twice: choose another name");
    check_output(option, file, inputs);
  }
}

void write_map(const std::string& file, const IO::Grid_image& image, bool is_compressed)
{
  IO::Image_options options;
  options.compress = is_compressed;
  if(extension_of(file) == ".nrrd")
    IO::write_NRRD(file, image, options);
  else
    IO::write_VTI(file, image, options);
}

IO::Stored_image read_map(const std::string& file)
{
  try {
    return extension_of(file) == ".nrrd" ? IO::read_NRRD(file) : IO::read_VTI(file);
  } catch(const std::bad_alloc&) {
    throw Input_error(file + ": does not fit into the memory");
  } catch(const std::exception& error) {
    throw Input_error(error.what());
  }
}

} // namespace mapt
