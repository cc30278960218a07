// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Maps written as images, read back, made by hand and damaged; test_vtk_readers.py has them read by VTK.

#include "file_test.h"

#include <CGAL/Area_projection_transform/IO/CSV.h>
#include <CGAL/Area_projection_transform/IO/NRRD.h>
#include <CGAL/Area_projection_transform/IO/VTI.h>
#include <CGAL/Area_projection_transform/IO/VTP.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <clocale>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <locale>
#include <random>
#include <sstream>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

namespace AP = CGAL::Area_projection;
namespace IO = CGAL::Area_projection::IO;
namespace fs = std::filesystem;

namespace {

using file_test::File_test;

class Image_io : public File_test
{
protected:
  std::string vti_complaint(const std::string& bytes) const
  {
    const std::string file = write("a.vti", bytes);
    return complaint([&] { IO::read_VTI(file); });
  }

  std::string nrrd_complaint(const std::string& bytes) const
  {
    const std::string file = write("a.nrrd", bytes);
    return complaint([&] { IO::read_NRRD(file); });
  }
};

/// two arrays that no two voxels share a value of, with all a value can be.
struct Sample
{
  AP::Grid_3 grid{AP::Point_3(-0.1, 1e-17, 12345.678), 0.1, {5, 4, 3}};
  std::vector<float> values;
  std::vector<float> radii;

  Sample()
  {
    for(std::size_t i = 0; i < grid.number_of_voxels(); ++i) {
      values.push_back(1.f / (3.f + float(i)));
      radii.push_back(-float(i));
    }
    values[7] = std::numeric_limits<float>::denorm_min();
    values[8] = std::numeric_limits<float>::infinity();
  }

  IO::Grid_image image() const
  {
    IO::Grid_image result(grid);
    add(result, "JMAPT", values);
    add(result, "a <\"&'> b", radii);
    result.add_metadata("radii", std::vector<double>{0.1, 1. / 3, 1e300});
    result.add_metadata("side", "inside");
    result.add_metadata("text", "a\\n\nb — é");
    result.add_metadata("empty", "");
    result.add_metadata("limits", std::vector<double>{-INFINITY, INFINITY});
    result.add_metadata("sigma_ratio", 0.5);
    return result;
  }

  template <class Scalar>
  void add(IO::Grid_image& image, const std::string& name, const std::vector<Scalar>& v) const
  {
    const std::size_t length = std::size_t(grid.size()[0]);
    image.add_array<Scalar>(name, [&v, length](std::size_t row, Scalar* out) {
      std::copy_n(v.begin() + std::ptrdiff_t(row * length), length, out);
    });
  }
};

template <class Value>
const Value& metadata(const IO::Stored_image& image, const std::string& name)
{
  return std::get<Value>(image.entry(name)->value);
}

void expect_sample(const IO::Stored_image& read, const Sample& sample)
{
  EXPECT_EQ(read.grid, sample.grid);
  ASSERT_EQ(read.arrays.size(), 2u);
  EXPECT_EQ(read.arrays[0].name, "JMAPT");
  EXPECT_EQ(read.arrays[1].name, "a <\"&'> b");
  EXPECT_EQ(read.array("JMAPT")->components, 1u);
  EXPECT_EQ(std::get<std::vector<float>>(read.arrays[0].values), sample.values);
  EXPECT_EQ(std::get<std::vector<float>>(read.arrays[1].values), sample.radii);
  ASSERT_EQ(read.metadata.size(), 6u);
  EXPECT_EQ(read.metadata[0].name, "radii");
  EXPECT_EQ(metadata<std::vector<double>>(read, "radii"), (std::vector<double>{.1, 1. / 3, 1e300}));
  EXPECT_EQ(metadata<std::string>(read, "side"), "inside");
  EXPECT_EQ(metadata<std::string>(read, "text"), "a\\n\nb — é");
  EXPECT_EQ(metadata<std::string>(read, "empty"), "");
  EXPECT_EQ(metadata<std::vector<double>>(read, "limits"),
            (std::vector<double>{-INFINITY, INFINITY}));
  EXPECT_EQ(metadata<std::vector<double>>(read, "sigma_ratio"), (std::vector<double>{0.5}));
  EXPECT_EQ(read.array("SMAPT"), nullptr);
  EXPECT_EQ(read.entry("SMAPT"), nullptr);
}

TEST_F(Image_io, survives_every_format_exactly)
{
  const Sample sample;
  for(const bool compress : {false, true}) {
    const std::string name = path(compress ? "zlib.vti" : "raw.vti");
    IO::write_VTI(name, sample.image(), {compress, 6});
    expect_sample(IO::read_VTI(name), sample);
    const std::string nrrd = path(compress ? "gzip.nrrd" : "raw.nrrd");
    IO::write_NRRD(nrrd, sample.image(), {compress, 6});
    expect_sample(IO::read_NRRD(nrrd), sample);
  }
  EXPECT_EQ(number_of_files(), 4u);
}

TEST_F(Image_io, vti_has_the_same_bytes_on_a_stream)
{
  const Sample sample;
  for(const bool compress : {false, true}) {
    std::ostringstream stream;
    IO::write_VTI(stream, sample.image(), {compress, 1});
    IO::write_VTI(path("a.vti"), sample.image(), {compress, 1});
    EXPECT_EQ(stream.str(), bytes_of(path("a.vti")));
  }
}

// more than a block of the compressed data, whose end is not the end of a row
TEST_F(Image_io, larger_than_a_block)
{
  const AP::Grid_3 grid(AP::Point_3(0, 0, 0), 1, {999, 67, 11});
  IO::Grid_image image(grid);
  const auto value = [](std::size_t row, int x) { return double(row) * 1000 + x / 7; };
  image.add_array<double>("d", [&](std::size_t row, double* out) {
    for(int x = 0; x < 999; ++x)
      out[x] = value(row, x);
  });
  IO::write_VTI(path("a.vti"), image);
  IO::write_NRRD(path("a.nrrd"), image);
  for(const IO::Stored_image& read : {IO::read_VTI(path("a.vti")), IO::read_NRRD(path("a.nrrd"))}) {
    const auto& values = std::get<std::vector<double>>(read.array("d")->values);
    ASSERT_EQ(values.size(), grid.number_of_voxels());
    for(std::size_t row = 0; row < grid.number_of_rows(); row += 7)
      for(int x = 0; x < 999; ++x)
        ASSERT_EQ(values[row * 999 + std::size_t(x)], value(row, x));
  }
}

template <class Scalar>
class Scalar_types : public File_test
{};
using All_scalars =
    ::testing::Types<std::int8_t, std::uint8_t, std::int16_t, std::uint16_t, std::int32_t,
                     std::uint32_t, std::int64_t, std::uint64_t, float, double>;
TYPED_TEST_SUITE(Scalar_types, All_scalars, );

TYPED_TEST(Scalar_types, keep_their_extremes)
{
  using Limits = std::numeric_limits<TypeParam>;
  const std::vector<TypeParam> values = {Limits::lowest(), Limits::max(), TypeParam(1),
                                         Limits::min()};
  IO::Grid_image image(AP::Grid_3(AP::Point_3(1, 2, 3), 2, {2, 1, 2}));
  image.add_array<TypeParam>("a", [&](std::size_t row, TypeParam* out) {
    std::copy_n(values.begin() + std::ptrdiff_t(2 * row), 2, out);
  });
  EXPECT_EQ(image.arrays()[0].type, IO::scalar_type<TypeParam>);
  IO::write_VTI(this->path("a.vti"), image);
  IO::write_NRRD(this->path("a.nrrd"), image);
  for(const auto& read : {IO::read_VTI(this->path("a.vti")), IO::read_NRRD(this->path("a.nrrd"))})
    EXPECT_EQ(std::get<std::vector<TypeParam>>(read.array("a")->values), values);
}

TEST_F(Image_io, nrrd_of_one_array_is_a_plain_volume)
{
  const Sample sample;
  IO::Grid_image image(sample.grid);
  sample.add(image, "JMAPT", sample.values);
  std::ostringstream stream;
  IO::write_NRRD(stream, image, {false, 1});
  const std::string text = stream.str();
  EXPECT_NE(text.find("dimension: 3\n"), std::string::npos);
  EXPECT_NE(text.find("content: JMAPT\n"), std::string::npos);
  EXPECT_NE(text.find("space: left-posterior-superior\n"), std::string::npos);
  EXPECT_NE(text.find("space origin: (-0.1,1e-17,12345.678)\n"), std::string::npos);
  EXPECT_EQ(text.size() - text.find("\n\n") - 2, sample.values.size() * sizeof(float));
}

TEST_F(Image_io, nrrd_of_different_types_becomes_double)
{
  const Sample sample;
  IO::Grid_image image(sample.grid);
  sample.add(image, "JMAPT", sample.values);
  image.add_array<std::uint8_t>(
      "mask", [](std::size_t row, std::uint8_t* out) { std::fill_n(out, 5, std::uint8_t(row)); });
  IO::write_NRRD(path("a.nrrd"), image);
  const IO::Stored_image read = IO::read_NRRD(path("a.nrrd"));
  EXPECT_EQ(std::get<std::vector<double>>(read.array("JMAPT")->values),
            std::vector<double>(sample.values.begin(), sample.values.end()));
  EXPECT_EQ(std::get<std::vector<double>>(read.array("mask")->values)[11 * 5 + 4], 11.);
  EXPECT_THROW(IO::write_NRRD(path("b.nrrd"), IO::Grid_image(sample.grid)), std::invalid_argument);
  EXPECT_FALSE(fs::exists(path("b.nrrd")));
  EXPECT_EQ(number_of_files(), 1u);
}

TEST_F(Image_io, refuses_two_arrays_of_a_name)
{
  IO::Grid_image image(Sample().grid);
  image.add_array<float>("a", [](std::size_t, float*) {});
  EXPECT_THROW(image.add_array<float>("a", [](std::size_t, float*) {}), std::invalid_argument);
}

TEST_F(Image_io, compression_has_levels)
{
  const Sample sample;
  for(const int level : {-1, 10}) {
    EXPECT_THROW(IO::write_VTI(path("a.vti"), sample.image(), {true, level}),
                 std::invalid_argument);
    EXPECT_THROW(IO::write_NRRD(path("a.nrrd"), sample.image(), {true, level}),
                 std::invalid_argument);
  }
  EXPECT_EQ(number_of_files(), 0u);
}

TEST_F(Image_io, without_arrays_is_an_image)
{
  const Sample sample;
  IO::write_VTI(path("a.vti"), IO::Grid_image(sample.grid));
  EXPECT_EQ(IO::read_VTI(path("a.vti")).grid, sample.grid);
}

std::string vti(const std::string& attributes, const std::string& content,
                const std::string& extent = "0 1 0 0 0 0")
{
  return "<?xml version='1.0'?>\n<!-- <a> -->\n<VTKFile type='ImageData' version='0.1'>\n"
         "<ImageData WholeExtent='0 1 0 0 0 0' " +
         attributes + ">\n<Piece Extent='" + extent + "'><PointData>" + content +
         "</PointData></Piece></ImageData></VTKFile>";
}

const std::string unit = "Origin='1 2 3' Spacing='2 2 2'";
const std::string two_values = "<DataArray type='Float32' Name='a'> 0.5 +2e0\n</DataArray>";

TEST_F(Image_io, vti_by_hand)
{
  EXPECT_EQ(vti_complaint(vti(unit, two_values)), "");
  const IO::Stored_image read = IO::read_VTI(path("a.vti"));
  EXPECT_EQ(read.grid, AP::Grid_3(AP::Point_3(1, 2, 3), 2, {2, 1, 1}));
  EXPECT_EQ(std::get<std::vector<float>>(read.array("a")->values), (std::vector<float>{0.5f, 2.f}));
}

TEST_F(Image_io, vti_that_is_no_map)
{
  EXPECT_EQ(
      vti_complaint(vti("Origin='1 2 3' Spacing='2 2 1'", two_values)),
      "a.vti: attribute Spacing of element 'ImageData' is '2 2 1': must be the same along the "
      "three axes");
  EXPECT_EQ(vti_complaint(vti("Origin='1 2' Spacing='2 2 2'", two_values)),
            "a.vti: attribute Origin of element 'ImageData' is '1 2': must be 3 numbers");
  EXPECT_EQ(vti_complaint(vti("Origin='1 nan 2' Spacing='2 2 2'", two_values)),
            "a.vti: element 'ImageData': origin has a coordinate that is not finite");
  EXPECT_EQ(vti_complaint(vti(unit + " Direction='0 1 0 1 0 0 0 0 1'", two_values)),
            "a.vti: attribute Direction of element 'ImageData' is '0 1 0 1 0 0 0 0 1': rotated "
            "images are not supported");
  EXPECT_EQ(vti_complaint(vti(unit, two_values, "0 0 0 0 0 0")),
            "a.vti: element 'Piece' does not cover the image");
  EXPECT_EQ(vti_complaint(vti(unit, "<DataArray type='Int8' Name='a'>1 2 3</DataArray>")),
            "a.vti: array 'a': has 3 values: the image has 2 points with 1 component");
  EXPECT_EQ(vti_complaint(vti(unit, "<DataArray type='Int8' Name='a'>1 200</DataArray>")),
            "a.vti: array 'a': value 1 is '200': not a number of its type");
  EXPECT_EQ(vti_complaint(vti(unit, "<DataArray type='Bit' Name='a'>1 0</DataArray>")),
            "a.vti: array 'a': type is 'Bit': not supported");
}

TEST_F(Image_io, nrrd_that_is_no_map)
{
  const std::string start = "NRRD0004\ntype: uchar\ndimension: 3\nsizes: 2 1 1\n";
  const std::string space = "space directions: (1,0,0) (0,1,0) (0,0,1)\nspace origin: (0,0,0)\n";
  EXPECT_EQ(nrrd_complaint(start + space + "encoding: raw\n\nab"), "");
  EXPECT_EQ(nrrd_complaint(start + space + "encoding: raw\n\nabc"),
            "a.nrrd: has 3 bytes of data: its sizes announce 2");
  EXPECT_EQ(nrrd_complaint(start + space + "encoding: raw\n"),
            "a.nrrd: ends early: no empty line after the header");
  EXPECT_EQ(nrrd_complaint(start + "encoding: raw\n\nab"),
            "a.nrrd: field 'space directions' is missing");
  EXPECT_EQ(nrrd_complaint(start + space + "encoding: bzip2\n\nab"),
            "a.nrrd: field 'encoding' is 'bzip2': must be raw or gzip");
  EXPECT_EQ(nrrd_complaint(start + space + "encoding: gzip\n\nab"),
            "a.nrrd: the compressed data are damaged: incorrect header check");
  EXPECT_EQ(nrrd_complaint(start + space + "encoding: raw\ndata file: a.raw\n\n"),
            "a.nrrd: field 'data file' is not supported");
  EXPECT_EQ(nrrd_complaint(start + space + "nonsense\n\n"),
            "a.nrrd: line 7: 'nonsense' is no field");
  EXPECT_EQ(nrrd_complaint("NRRD0004\ntype: uchar\ndimension: 3\nsizes: 2147483647 2147483647 "
                           "2147483647\nencoding: gzip\n" +
                           space + "\nab"),
            "a.nrrd: has 2 bytes of data: its sizes announce 9.903520300447984e+27");
  EXPECT_EQ(nrrd_complaint("P5 1 1"), "a.nrrd: is not a NRRD file");
}

// every prefix and every changed byte of a good file is read or refused, nothing else
TEST_F(Image_io, damaged_files_are_read_or_refused)
{
  const Sample sample;
  std::ostringstream compressed, plain, nrrd;
  IO::write_VTI(compressed, sample.image());
  IO::write_VTI(plain, sample.image(), {false, 1});
  IO::write_NRRD(nrrd, sample.image());
  std::mt19937 random(1);
  for(const std::string& good : {compressed.str(), plain.str(), nrrd.str()})
    file_test::for_each_damaged(good, random, [&](const std::string& bytes) {
      vti_complaint(bytes);
      nrrd_complaint(bytes);
      complaint([&] { IO::read_VTP(write("a.vtp", bytes)); });
    });
}

TEST_F(Image_io, file_of_an_image_that_throws_is_removed)
{
  IO::Grid_image image(Sample().grid);
  image.add_array<float>("a", [](std::size_t row, float*) {
    if(row == 5)
      throw std::runtime_error("row 5");
  });
  for(const bool compress : {false, true}) {
    EXPECT_EQ(complaint([&] { IO::write_VTI(path("a.vti"), image, {compress, 1}); }), "row 5");
    EXPECT_EQ(complaint([&] { IO::write_NRRD(path("a.nrrd"), image, {compress, 1}); }), "row 5");
  }
  EXPECT_EQ(number_of_files(), 0u);
}

// a comma for the decimal point must neither be written nor expected
TEST_F(Image_io, locale_does_not_matter)
{
  const std::string before = std::setlocale(LC_ALL, nullptr);
  for(const char* name : {"de_DE.UTF-8", "fr_FR.UTF-8"})
    if(std::setlocale(LC_ALL, name) != nullptr)
      break;
  const Sample sample;
  const IO::Grid_image image = sample.image();
  struct Comma : std::numpunct<char>
  {
    char do_decimal_point() const override { return ','; }
    std::string do_grouping() const override { return "\1"; }
    char do_thousands_sep() const override { return '.'; }
  };
  const std::locale global = std::locale::global(std::locale(std::locale(), new Comma));
  EXPECT_EQ(IO::to_text(1234.5), "1234.5");
  std::istringstream table("x,y,z,radius\n1234.5,2,3,4\n");
  EXPECT_EQ(IO::read_queries(table, "table").at(0).point.x(), 1234.5);
  std::ostringstream vti, nrrd;
  IO::write_VTI(vti, image, {false, 1});
  IO::write_NRRD(nrrd, image, {false, 1});
  std::locale::global(global);
  std::setlocale(LC_ALL, before.c_str());
  std::ostringstream vti_before, nrrd_before;
  IO::write_VTI(vti_before, image, {false, 1});
  IO::write_NRRD(nrrd_before, image, {false, 1});
  EXPECT_EQ(vti.str(), vti_before.str());
  EXPECT_EQ(nrrd.str(), nrrd_before.str());
}

} // namespace
