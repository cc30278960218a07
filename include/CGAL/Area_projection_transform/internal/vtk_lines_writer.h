// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_VTK_LINES_WRITER_H
#define CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_VTK_LINES_WRITER_H

#include <CGAL/Area_projection_transform/IO/number_text.h>
#include <CGAL/Area_projection_transform/internal/xml_document.h>

#include <boost/endian/conversion.hpp>

#include <cstddef>
#include <cstdint>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

/// \cond SKIP_IN_MANUAL
namespace CGAL {
namespace Area_projection {
namespace IO {
namespace internal {

static_assert(boost::endian::order::native == boost::endian::order::little,
              "lines are written on little-endian machines only");

/// \brief writes polylines in VTK's XML format, with appended raw data, which has a place for numbers that are
/// unknown: VTK does not read `nan` as text.
class Vtk_lines_writer
{
public:
  /// \param components of each tuple of `values`
  void add_to_points(const std::string& name, std::vector<double> values, int components = 1)
  {
    add(m_point_data, name, "Float64", std::move(values), components);
  }
  void add_to_points(const std::string& name, std::vector<std::int64_t> values)
  {
    add(m_point_data, name, "Int64", std::move(values), 1);
  }
  void add_to_lines(const std::string& name, std::vector<double> values)
  {
    add(m_cell_data, name, "Float64", std::move(values), 1);
  }
  void add_to_lines(const std::string& name, std::vector<std::int64_t> values)
  {
    add(m_cell_data, name, "Int64", std::move(values), 1);
  }

  /// \param coordinates three for each point
  /// \param lines indices of points
  void write(std::ostream& out, const std::vector<double>& coordinates,
             const std::vector<std::vector<std::size_t>>& lines)
  {
    std::vector<std::int64_t> connectivity, ends;
    for(const std::vector<std::size_t>& line : lines) {
      connectivity.insert(connectivity.end(), line.begin(), line.end());
      ends.push_back(std::int64_t(connectivity.size()));
    }
    std::string points, cells;
    add(points, "Points", "Float64", coordinates, 3);
    add(cells, "connectivity", "Int64", connectivity, 1);
    add(cells, "offsets", "Int64", ends, 1);
    out << "<?xml version=\"1.0\"?>\n"
        << "<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\" "
        << "header_type=\"UInt64\">\n  <PolyData>\n    <Piece NumberOfPoints=\""
        << IO::to_text(coordinates.size() / 3) << "\" NumberOfVerts=\"0\" NumberOfLines=\""
        << IO::to_text(lines.size()) << "\" NumberOfStrips=\"0\" NumberOfPolys=\"0\">\n"
        << "      <PointData>\n"
        << m_point_data << "      </PointData>\n"
        << "      <CellData>\n"
        << m_cell_data << "      </CellData>\n"
        << "      <Points>\n"
        << points << "      </Points>\n"
        << "      <Lines>\n"
        << cells << "      </Lines>\n"
        << "    </Piece>\n  </PolyData>\n  <AppendedData encoding=\"raw\">\n   _" << m_data
        << "\n  </AppendedData>\n</VTKFile>\n";
  }

private:
  template <class Number>
  void add(std::string& elements, const std::string& name, const char* type,
           const std::vector<Number>& values, int components)
  {
    elements += "        <DataArray type=\"" + std::string(type) + "\" Name=\"" +
                xml_escaped(name) + "\" NumberOfComponents=\"" + IO::to_text(components) +
                "\" format=\"appended\" offset=\"" + IO::to_text(m_data.size()) + "\"/>\n";
    const std::uint64_t size = values.size() * sizeof(Number);
    m_data.append(reinterpret_cast<const char*>(&size), sizeof size);
    m_data.append(reinterpret_cast<const char*>(values.data()), std::size_t(size));
  }

  std::string m_point_data, m_cell_data; // their elements
  std::string m_data;
};

} // namespace internal
} // namespace IO
} // namespace Area_projection
} // namespace CGAL
/// \endcond

#endif // CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_VTK_LINES_WRITER_H
