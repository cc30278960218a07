// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef AREA_PROJECTION_TRANSFORM_TEST_FILE_TEST_H
#define AREA_PROJECTION_TRANSFORM_TEST_FILE_TEST_H

// What tests of files share: a place for them, what is said about them, and damage.

#include <gtest/gtest.h>

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <sstream>
#include <stdexcept>
#include <string>

namespace file_test {

namespace fs = std::filesystem;

/// a folder of its own for each test, removed with all that is in it.
class File_test : public ::testing::Test
{
protected:
  void SetUp() override
  {
    const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
    folder = fs::temp_directory_path() /
             ("area_projection-" + std::to_string(std::random_device()()) + "-" + test->name());
    fs::create_directories(folder);
  }
  void TearDown() override { fs::remove_all(folder); }

  std::string path(const std::string& name) const { return (folder / name).string(); }

  std::string write(const std::string& name, const std::string& bytes) const
  {
    std::ofstream(path(name), std::ios_base::binary) << bytes;
    return path(name);
  }

  static std::string bytes_of(const std::string& file)
  {
    std::ostringstream bytes;
    bytes << std::ifstream(file, std::ios_base::binary).rdbuf();
    return bytes.str();
  }

  std::size_t number_of_files() const
  {
    return std::size_t(std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
  }

  /// what a function complains about, without the name of the folder.
  template <class Function>
  std::string complaint(Function function) const
  {
    try {
      function();
    } catch(const std::runtime_error& error) {
      std::string text = error.what();
      const std::string prefix = folder.string() + "/";
      if(text.compare(0, prefix.size(), prefix) == 0)
        text.erase(0, prefix.size());
      return text;
    }
    return "";
  }

  fs::path folder;
};

/// calls `function(bytes)` for 400 copies of a good file that are cut, or have up to three bytes changed, or both.
template <class Function>
void for_each_damaged(const std::string& good, std::mt19937& random, Function function)
{
  for(std::size_t trial = 0; trial < 400; ++trial) {
    std::string bytes = good.substr(0, trial % 2 == 0 ? good.size() : random() % good.size());
    for(std::size_t change = 0; change < trial % 4 && !bytes.empty(); ++change)
      bytes[random() % bytes.size()] = char(random());
    function(bytes);
  }
}

} // namespace file_test

#endif // AREA_PROJECTION_TRANSFORM_TEST_FILE_TEST_H
