// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Tries a harness without libFuzzer: the files of its corpus as they are, and changed in some hundred ways that
// depend on nothing but the seed.
//
//   replay_meshes FOLDER [MUTATIONS [SEED]]      MUTATIONS of each file, 100 by default

#include "fuzz.h"

#include <algorithm>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <random>
#include <vector>

namespace {

using Text = std::vector<std::uint8_t>;

std::vector<Text> corpus(const std::string& folder)
{
  std::vector<std::filesystem::path> paths;
  for(const auto& entry : std::filesystem::directory_iterator(folder))
    if(entry.is_regular_file())
      paths.push_back(entry.path());
  std::sort(paths.begin(), paths.end());
  std::vector<Text> texts;
  for(const auto& path : paths) {
    std::ifstream in(path, std::ios::binary);
    texts.emplace_back(std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>());
  }
  return texts;
}

/// one change of some bytes: set, turned, left out, doubled, cut off, or taken from another file.
void change(Text& text, const Text& other, std::mt19937_64& random)
{
  if(text.empty())
    text.push_back(0);
  const std::size_t place = random() % text.size();
  const std::size_t length = std::min<std::size_t>(random() % 16 + 1, text.size() - place);
  const auto at = text.begin() + std::ptrdiff_t(place);
  switch(random() % 6) {
  case 0:
    text[place] = std::uint8_t(random());
    break;
  case 1:
    text[place] ^= std::uint8_t(1u << random() % 8);
    break;
  case 2:
    text.erase(at, at + std::ptrdiff_t(length));
    break;
  case 3: {
    const Text piece(at, at + std::ptrdiff_t(length));
    text.insert(at, piece.begin(), piece.end());
    break;
  }
  case 4:
    text.resize(place);
    break;
  default:
    if(!other.empty())
      for(std::size_t i = 0; i < length; ++i)
        text[place + i] = other[(place + i) % other.size()];
  }
}

} // namespace

int main(int argc, char** argv)
{
  if(argc < 2 || argc > 4) {
    std::cerr << "usage: " << argv[0] << " FOLDER [MUTATIONS [SEED]]\n";
    return 2;
  }
  const std::vector<Text> texts = corpus(argv[1]);
  const unsigned long mutations = argc > 2 ? std::stoul(argv[2]) : 100;
  std::mt19937_64 random(argc > 3 ? std::stoul(argv[3]) : 1);
  std::size_t tried = 0;
  for(const Text& text : texts) {
    LLVMFuzzerTestOneInput(text.data(), text.size());
    for(unsigned long m = 0; m < mutations; ++m, ++tried) {
      Text changed = text;
      for(std::size_t changes = random() % 4 + 1; changes > 0; --changes)
        change(changed, texts[random() % texts.size()], random);
      LLVMFuzzerTestOneInput(changed.data(), changed.size());
    }
  }
  std::cout << texts.size() << " files and " << tried << " changed ones: no promise is broken\n";
  return texts.empty() ? 1 : 0;
}
