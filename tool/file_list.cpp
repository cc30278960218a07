// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "file_list.h"

#include "errors.h"
#include "input.h"
#include "map_file.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <unordered_set>

namespace mapt {

namespace {

namespace fs = std::filesystem;

std::vector<std::string> lines_of(std::istream& stream)
{
  std::vector<std::string> lines;
  for(std::string line; std::getline(stream, line);) {
    if(!line.empty() && line.back() == '\r')
      line.pop_back();
    if(!line.empty())
      lines.push_back(line);
  }
  return lines;
}

std::vector<std::string> read_list(const std::string& name)
{
  std::vector<std::string> lines;
  if(name == "-") {
    lines = lines_of(std::cin);
  } else {
    std::ifstream stream(name, std::ios::binary);
    if(!stream)
      throw Input_error(name + ": cannot be opened: check its name, folder and permissions");
    lines = lines_of(stream);
    if(stream.bad() || fs::is_directory(name))
      throw Input_error(name + ": cannot be read: must be a text file with a mesh in each line");
  }
  if(lines.empty())
    throw Input_error((name == "-" ? "standard input" : name) +
                      ": is an empty list: write a mesh into each line");
  return lines;
}

bool is_mesh(const fs::directory_entry& entry)
{
  static const std::unordered_set<std::string> extensions{".off", ".obj", ".ply", ".stl", ".vtp"};
  std::error_code ignored; // of a link that leads nowhere
  return entry.is_regular_file(ignored) &&
         extensions.count(extension_of(entry.path().string())) > 0;
}

void append_folder(const std::string& folder, std::vector<std::string>& files)
{
  const auto first = std::ptrdiff_t(files.size());
  std::error_code error;
  for(auto place = fs::recursive_directory_iterator(folder, error);
      !error && place != fs::recursive_directory_iterator(); place.increment(error))
    if(is_mesh(*place))
      files.push_back(place->path().string());
  if(error)
    throw Input_error(folder + ": cannot be read: " + error.message() +
                      "; check its permissions and those of its folders");
  if(first == std::ptrdiff_t(files.size()))
    throw Input_error(folder + ": has no mesh (.off .obj .ply .stl .vtp) in it");
  std::sort(files.begin() + first, files.end());
}

void check_names(const std::vector<std::string>& files)
{
  std::unordered_set<std::string> known;
  for(const std::string& file : files) {
    if(file.empty())
      throw Usage_error("the name of a mesh is empty: leave it out");
    if(!known.insert(file).second)
      throw Usage_error(file + ": is listed twice: name it once");
  }
}

} // namespace

std::vector<std::string> list_files(const std::vector<std::string>& arguments,
                                    const std::string& list)
{
  std::vector<std::string> names = arguments, files;
  if(!list.empty()) {
    const std::vector<std::string> more = read_list(list);
    names.insert(names.end(), more.begin(), more.end());
  }
  for(const std::string& name : names) {
    std::error_code ignored; // of a file that does not exist: the reader will tell
    if(fs::is_directory(name, ignored))
      append_folder(name, files);
    else
      files.push_back(name);
  }
  check_names(files);
  return files;
}

} // namespace mapt
