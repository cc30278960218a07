// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Area_projection_transform/IO/CSV.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace AP = CGAL::Area_projection;
namespace IO = CGAL::Area_projection::IO;

namespace {

std::vector<IO::Query> queries(const std::string& text)
{
  std::istringstream in(text);
  return IO::read_queries(in, "points.csv");
}

std::string queries_complaint(const std::string& text)
{
  try {
    queries(text);
  } catch(const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

TEST(Csv, queries)
{
  const auto q = queries("\xEF\xBB\xBF# made by hand\r\n\r\nname,radius, y ,x,\"z\",sigma\r\n"
                         "\"a, \"\"b\"\"\nc\",0.5,2,1,+3e-1,\n\n  # again\n,1,5,4,\"6\",0.25");
  ASSERT_EQ(q.size(), 2u);
  EXPECT_EQ(q[0].point, AP::Point_3(1, 2, 0.3));
  EXPECT_EQ(q[0].radius, 0.5);
  EXPECT_TRUE(std::isnan(q[0].sigma));
  EXPECT_EQ(q[1].point, AP::Point_3(4, 5, 6));
  EXPECT_EQ(q[1].sigma, 0.25);
  EXPECT_TRUE(std::isnan(queries("x,y,z,radius\n1,2,3,4\n").at(0).sigma));
  EXPECT_TRUE(queries("x,y,z,radius\n").empty());
}

TEST(Csv, defects_of_queries)
{
  const std::string header = "x,y,z,radius,sigma\n\n# one\n1,2,3,4,5\n";
  EXPECT_EQ(queries_complaint(header + "1,2,3,abc,5\n"),
            "points.csv: line 5: radius is 'abc': not a number");
  EXPECT_EQ(queries_complaint(header + "1,2,3,0,5\n"),
            "points.csv: line 5: radius is '0': must be positive");
  EXPECT_EQ(queries_complaint(header + "1,nan,3,1,5\n"),
            "points.csv: line 5: y is 'nan': must be finite");
  EXPECT_EQ(queries_complaint(header + "1,2,3,1,-1\n"),
            "points.csv: line 5: sigma is '-1': must be positive");
  EXPECT_EQ(queries_complaint(header + "1,2,3,1e200,1\n"),
            "points.csv: line 5: radius is '1e200': must be from 1e-150 to 1e150, for its "
            "square to be a number");
  EXPECT_EQ(queries_complaint(header + "1,2,3,1,1,5\n"),
            "points.csv: line 5: has 6 fields: the first line names 5");
  EXPECT_EQ(queries_complaint(header + "1,2,,1,1\n"), "points.csv: line 5: z is '': not a number");
  EXPECT_EQ(queries_complaint(header + "1,2,3\n"),
            "points.csv: line 5: radius is missing: there are 3 fields");
  EXPECT_EQ(queries_complaint(header + "\"1,2\n3,4"), "points.csv: line 5: a quote is not closed");
  EXPECT_EQ(queries_complaint("1,2,3,4\n"),
            "points.csv: line 1: column 'x' is missing: the first line must name the columns x, y, "
            "z, radius[, sigma]");
  EXPECT_EQ(queries_complaint("x,y,z,radius,y\n"), "points.csv: line 1: column 'y' is there twice");
  EXPECT_EQ(queries_complaint("# nothing\n"),
            "points.csv: is empty: the first line must name the columns x, y, z, radius[, sigma]");
}

TEST(Csv, round_trip)
{
  const double third = 1. / 3, tiny = std::numeric_limits<double>::denorm_min();
  std::stringstream table;
  IO::CSV_writer writer(table);
  writer.row("file", "x", std::string("a \"b\", c\nd"), " blank ", "");
  writer.row(third, tiny, 0.1f, -3, std::uint64_t(18446744073709551615u));
  EXPECT_NE(table.str().find("\n0.3333333333333333,5e-324,0.1,-3,18446744073709551615\n"),
            std::string::npos);
  IO::CSV_reader reader(table, "table");
  std::vector<std::string> fields;
  ASSERT_TRUE(reader.read(fields));
  EXPECT_EQ(fields, (std::vector<std::string>{"file", "x", "a \"b\", c\nd", " blank ", ""}));
  ASSERT_TRUE(reader.read(fields));
  double value = 0;
  EXPECT_TRUE(IO::from_text(fields[0], value));
  EXPECT_EQ(value, third);
  EXPECT_TRUE(IO::from_text(fields[1], value));
  EXPECT_EQ(value, tiny);
  EXPECT_FALSE(reader.read(fields));
}

// what a reader takes for a mark, a remark, a blank or the end of a line is none within a field
TEST(Csv, text_is_read_as_it_was_written)
{
  for(const std::string text :
      {"\xEF\xBB\xBF", "\xEF\xBB\xBF.off", "a\r\nb", "\r", "#1", "\"", "\t", "=1+1"}) {
    std::stringstream table;
    IO::CSV_writer(table).row(text, text);
    IO::CSV_reader reader(table, "table");
    std::vector<std::string> fields;
    ASSERT_TRUE(reader.read(fields));
    EXPECT_EQ(fields, (std::vector<std::string>{text, text}));
    EXPECT_FALSE(reader.read(fields));
  }
}

TEST(Csv, lines_may_end_as_on_other_systems)
{
  std::istringstream table("\xEF\xBB\xBF"
                           "a,b\r\n\r\n\"c\",d \r\n");
  IO::CSV_reader reader(table, "table");
  std::vector<std::string> fields;
  ASSERT_TRUE(reader.read(fields));
  EXPECT_EQ(fields, (std::vector<std::string>{"a", "b"}));
  ASSERT_TRUE(reader.read(fields));
  EXPECT_EQ(fields, (std::vector<std::string>{"c", "d"}));
  EXPECT_FALSE(reader.read(fields));
}

} // namespace
