// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Output files, which replace what was there when they are whole.

#include "file_test.h"

#include <CGAL/Area_projection_transform/IO/NRRD.h>
#include <CGAL/Area_projection_transform/IO/VTI.h>
#include <CGAL/Area_projection_transform/internal/atomic_file.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <string>

namespace AP = CGAL::Area_projection;
namespace IO = CGAL::Area_projection::IO;
namespace fs = std::filesystem;

namespace {

using Atomic_file = file_test::File_test;

TEST_F(Atomic_file, appears_whole_or_not_at_all)
{
  const std::string name = write("a.txt", "old");
  {
    IO::internal::Atomic_file file(name);
    file.stream() << "new";
    EXPECT_TRUE(file.is_seekable());
  }
  EXPECT_EQ(bytes_of(name), "old");
  EXPECT_EQ(number_of_files(), 1u);
  {
    IO::internal::Atomic_file file(name);
    file.stream() << "new";
    EXPECT_EQ(bytes_of(name), "old");
    file.commit();
  }
  EXPECT_EQ(bytes_of(name), "new");
  EXPECT_EQ(number_of_files(), 1u);
}

TEST_F(Atomic_file, is_written_through_a_link)
{
  write("a.txt", "old");
  fs::create_symlink("a.txt", folder / "link");
  IO::internal::Atomic_file file(path("link"));
  file.stream() << "new";
  file.commit();
  EXPECT_TRUE(fs::is_symlink(folder / "link"));
  EXPECT_EQ(bytes_of(path("a.txt")), "new");
}

TEST_F(Atomic_file, that_cannot_be_written)
{
  IO::Grid_image image(AP::Grid_3(AP::Point_3(0, 0, 0), 1, {2, 1, 1}));
  image.add_array<float>("a", [](std::size_t, float* out) { std::fill_n(out, 2, 1.f); });
  EXPECT_EQ(complaint([&] { IO::write_VTI(path("absent/a.vti"), image); }),
            "absent/a.vti: cannot be created: No such file or directory");
  EXPECT_THROW(IO::write_NRRD(folder.string(), image), IO::Output_error);
  if(fs::exists("/dev/full")) {
    EXPECT_EQ(complaint([&] { IO::write_VTI("/dev/full", image); }),
              "/dev/full: cannot be written: No space left on device");
    EXPECT_EQ(complaint([&] { IO::write_NRRD("/dev/full", image); }),
              "/dev/full: cannot be written: No space left on device");
  }
  EXPECT_EQ(number_of_files(), 0u);
}

} // namespace
