// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Meshes and points in VTP made by hand, and VTK XML that is broken or claims more than it has.

#include "file_test.h"

#include <CGAL/Area_projection_transform/IO/NRRD.h>
#include <CGAL/Area_projection_transform/IO/VTI.h>
#include <CGAL/Area_projection_transform/IO/VTP.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <random>
#include <string>
#include <vector>

namespace AP = CGAL::Area_projection;
namespace IO = CGAL::Area_projection::IO;

namespace {

class Vtp : public file_test::File_test
{
protected:
  std::string vtp_complaint(const std::string& bytes) const
  {
    const std::string file = write("a.vtp", bytes);
    return complaint([&] { IO::read_VTP(file); });
  }
};

template <class Integer>
std::string little_endian(Integer value)
{
  std::string bytes(sizeof(value), '\0');
  std::memcpy(&bytes[0], &value, sizeof(value));
  return bytes;
}

/// a `.vtp` file with one piece.
std::string vtp(const std::string& content, const std::string& numbers,
                const std::string& root = "byte_order=\"LittleEndian\"",
                const std::string& tail = "")
{
  return "<VTKFile type=\"PolyData\" " + root + "><PolyData><Piece " + numbers + ">" + content +
         "</Piece></PolyData>" + tail + "</VTKFile>\n";
}

std::string data_array(const std::string& attributes, const std::string& text)
{
  return "<DataArray " + attributes + ">" + text + "</DataArray>";
}

const std::string square_points =
    "<Points>" +
    data_array("type=\"Float32\" NumberOfComponents=\"3\" format=\"ascii\" Name=\"Points\"",
               "0 0 0 1 0 0 1 1 0 0 1 0.25") +
    "</Points>";

std::string cells(const std::string& kind, const std::string& connectivity,
                  const std::string& offsets)
{
  return "<" + kind + ">" +
         data_array("type=\"Int64\" Name=\"connectivity\" format=\"ascii\"", connectivity) +
         data_array("type=\"Int32\" Name=\"offsets\" format=\"ascii\"", offsets) + "</" + kind +
         ">";
}

const std::string four = "NumberOfPoints=\"4\"";

using Polygons = std::vector<std::vector<std::size_t>>;

TEST_F(Vtp, made_by_hand)
{
  EXPECT_EQ(vtp_complaint(vtp(square_points + cells("Polys", "0 1 2 3 0 1 2", "4 7"), four)), "");
  const IO::Poly_data data = IO::read_VTP(path("a.vtp"));
  ASSERT_EQ(data.points.size(), 4u);
  EXPECT_EQ(data.points[3], AP::Point_3(0, 1, 0.25));
  EXPECT_EQ(data.polygons, (Polygons{{0, 1, 2, 3}, {0, 1, 2}}));
  EXPECT_TRUE(data.normals.empty());
}

TEST_F(Vtp, strips_keep_their_orientation)
{
  write("a.vtp", vtp(square_points + cells("Strips", "0 1 3 2", "4"), four));
  EXPECT_EQ(IO::read_VTP(path("a.vtp")).polygons, (Polygons{{0, 1, 3}, {1, 2, 3}}));
}

TEST_F(Vtp, points_with_normals)
{
  const std::string normals =
      "<PointData Normals='N'>" +
      data_array("type='Float64' Name='other' NumberOfComponents='3'", "9 9 9 9 9 9 9 9 9 9 9 9") +
      data_array("type='Float64' Name='N' NumberOfComponents='3'", "0 0 1 0 0 1 0 0 1 0 1 0") +
      "</PointData>";
  write("a.vtp", vtp(square_points + normals + cells("Verts", "0 1 2 3", "1 2 3 4"),
                     four + " NumberOfVerts='4'"));
  const IO::Poly_data data = IO::read_VTP(path("a.vtp"));
  EXPECT_TRUE(data.polygons.empty());
  EXPECT_EQ(data.number_of_vertex_cells, 4u);
  ASSERT_EQ(data.normals.size(), 4u);
  EXPECT_EQ(data.normals[3], AP::Vector_3(0, 1, 0));
}

TEST_F(Vtp, pieces_become_one)
{
  const std::string piece =
      "<Piece NumberOfPoints='4'>" + square_points + cells("Polys", "0 1 2", "3") + "</Piece>";
  write("a.vtp", "<VTKFile type='PolyData'><PolyData>" + piece + piece + "</PolyData></VTKFile>");
  const IO::Poly_data data = IO::read_VTP(path("a.vtp"));
  EXPECT_EQ(data.points.size(), 8u);
  EXPECT_EQ(data.polygons, (Polygons{{0, 1, 2}, {4, 5, 6}}));
}

TEST_F(Vtp, indices_are_checked)
{
  const auto defect = [&](const std::string& connectivity, const std::string& offsets) {
    return vtp_complaint(vtp(square_points + cells("Polys", connectivity, offsets), four));
  };
  EXPECT_EQ(defect("0 1 4", "3"), "a.vtp: array 'connectivity': value 2 is 4: there are 4 points");
  EXPECT_EQ(defect("0 -1 2", "3"),
            "a.vtp: array 'connectivity': value 1 is -1: there are 4 points");
  EXPECT_EQ(defect("0 1 2", "4"), "a.vtp: array 'offsets': value 0 is 4: must be from 0 to 3");
  EXPECT_EQ(defect("0 1 2 3", "3 2"), "a.vtp: array 'offsets': value 1 is 2: must be from 3 to 4");
  EXPECT_EQ(defect("0 1 2 3", "3"),
            "a.vtp: array 'offsets': ends at 3: array 'connectivity' has 4 values");
  EXPECT_EQ(defect("0 1 x", "3"),
            "a.vtp: array 'connectivity': value 2 is 'x': not a number of its type");
}

TEST_F(Vtp, numbers_are_claims)
{
  EXPECT_EQ(vtp_complaint(vtp(square_points, "NumberOfPoints='18446744073709551615'")),
            "a.vtp: array 'Points': has 4 points: NumberOfPoints is 18446744073709551615");
  EXPECT_EQ(vtp_complaint(vtp(square_points, "NumberOfPoints='-4'")),
            "a.vtp: attribute NumberOfPoints of element 'Piece' is '-4': must be 1 number");
  EXPECT_EQ(vtp_complaint(vtp("<Points><DataArray Name='p' type='Float32'>1 2</DataArray></Points>",
                              "NumberOfPoints='1'")),
            "a.vtp: array 'p': has 2 values in groups of 1: 3 coordinates are needed");
}

TEST_F(Vtp, xml_that_cannot_be_read)
{
  EXPECT_EQ(vtp_complaint(""), "a.vtp: is empty");
  EXPECT_EQ(vtp_complaint("OFF\n0 0 0\n"), "a.vtp: line 1: is not XML");
  EXPECT_EQ(vtp_complaint("<svg></svg>"), "a.vtp: is not a VTK XML file");
  EXPECT_EQ(vtp_complaint("<VTKFile type=\"PolyData\">\n<PolyData>"),
            "a.vtp: line 2: ends early: element 'PolyData' is not closed");
  EXPECT_EQ(vtp_complaint("<VTKFile>\n</VTKFiles>"),
            "a.vtp: line 2: the end tag 'VTKFiles' matches no start tag");
  EXPECT_EQ(vtp_complaint("<!DOCTYPE a [<!ENTITY b 'c'>]><a/>"),
            "a.vtp: line 1: has a document type or CDATA section, which are not supported");
  EXPECT_EQ(vtp_complaint("<VTKFile type=\"ImageData\"><ImageData/></VTKFile>"),
            "a.vtp: holds 'ImageData': PolyData is needed");
  EXPECT_EQ(vtp_complaint(vtp("", four, "byte_order=\"BigEndian\"")),
            "a.vtp: byte_order is not LittleEndian: not supported; write the file in ascii or on a "
            "little-endian machine");
  EXPECT_EQ(
      vtp_complaint(vtp("", four, "compressor=\"vtkLZ4DataCompressor\"")),
      "a.vtp: compressor is 'vtkLZ4DataCompressor': not supported; write the file with zlib or "
      "without compression");
  EXPECT_EQ(complaint([&] { IO::read_VTP(path("absent.vtp")); }),
            "absent.vtp: cannot be opened: No such file or directory");
  EXPECT_NE(complaint([&] { IO::read_VTP(folder.string()); }).find("Is a directory"),
            std::string::npos);
}

// a million nested elements neither exhaust the stack nor take long
TEST_F(Vtp, xml_nested_without_end)
{
  std::string bytes;
  for(int i = 0; i < 1100000; ++i)
    bytes += "<a>";
  EXPECT_EQ(vtp_complaint(bytes), "a.vtp: line 1: has more than 1000000 elements");
}

std::string appended_points(const std::string& root, const std::string& bytes,
                            const std::string& encoding = "raw", const std::string& offset = "0")
{
  return vtp("<Points>" +
                 data_array("type='Float64' NumberOfComponents='3' Name='P' format='appended' "
                            "offset='" +
                                offset + "'",
                            "") +
                 "</Points>",
             "NumberOfPoints='1'", root,
             "<AppendedData encoding=\"" + encoding + "\">_" + bytes + "</AppendedData>");
}

TEST_F(Vtp, appended_data_are_claims)
{
  const std::string root = "header_type='UInt64'";
  const std::string zlib = root + " compressor='vtkZLibDataCompressor'";
  const auto huge = little_endian(std::uint64_t(1) << 62);
  const auto one = little_endian(std::uint64_t(1));
  const auto three =
      little_endian(std::uint64_t(24)) + little_endian(1.) + little_endian(2.) + little_endian(3.);
  EXPECT_EQ(vtp_complaint(appended_points(root, three)), "");
  EXPECT_EQ(IO::read_VTP(path("a.vtp")).points.front(), AP::Point_3(1, 2, 3));
  EXPECT_EQ(vtp_complaint(appended_points(root, huge)),
            "a.vtp: array 'P': claims 4611686018427387904 bytes: more than are left in the file");
  EXPECT_EQ(vtp_complaint(appended_points(root, three, "raw", "99999")),
            "a.vtp: array 'P': offset is 99999: the appended data have 58 bytes");
  EXPECT_EQ(vtp_complaint(appended_points(root, three, "raw", "-1")),
            "a.vtp: array 'P': offset is '-1': not a number of bytes");
  EXPECT_EQ(vtp_complaint(appended_points(zlib, huge)),
            "a.vtp: array 'P': claims 4611686018427387904 compressed blocks: more than fit in the "
            "file");
  EXPECT_EQ(vtp_complaint(appended_points(zlib, one + huge + huge + huge)),
            "a.vtp: array 'P': block 0 claims 4611686018427387904 bytes: more than are left in the "
            "file");
  EXPECT_EQ(vtp_complaint(appended_points(zlib, one + huge + huge + one + "x")),
            "a.vtp: array 'P': the compressed data end early");
  EXPECT_EQ(vtp_complaint(appended_points(root, "!!!!", "base64")),
            "a.vtp: array 'P': is not base64: has the character '!'");
  EXPECT_EQ(vtp_complaint(appended_points(root, "AAAA", "base64")),
            "a.vtp: array 'P': ends early: needs 8 bytes, has 3");
}

// every prefix and every changed byte of a good file is read or refused, nothing else
TEST_F(Vtp, damaged_files_are_read_or_refused)
{
  const std::string good = vtp(square_points + cells("Polys", "0 1 2 3 0 1 2", "4 7"), four);
  std::mt19937 random(1);
  file_test::for_each_damaged(good, random, [&](const std::string& bytes) {
    vtp_complaint(bytes);
    complaint([&] { IO::read_VTI(write("a.vti", bytes)); });
    complaint([&] { IO::read_NRRD(write("a.nrrd", bytes)); });
  });
}

} // namespace
