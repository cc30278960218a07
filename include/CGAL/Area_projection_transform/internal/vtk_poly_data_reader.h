// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_VTK_POLY_DATA_READER_H
#define CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_VTK_POLY_DATA_READER_H

#include <CGAL/Area_projection_transform/IO/Poly_data.h>
#include <CGAL/Area_projection_transform/IO/number_text.h>
#include <CGAL/Area_projection_transform/internal/vtk_data_array.h>

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

/// \cond SKIP_IN_MANUAL
namespace CGAL {
namespace Area_projection {
namespace IO {
namespace internal {

/// reads points, polygons and normals in VTK's XML format.
class Vtk_poly_data_reader
{
public:
  explicit Vtk_poly_data_reader(const std::string& name) : m_file(name, "PolyData") {}

  Poly_data read()
  {
    const Xml_document& document = m_file.document();
    const Xml_element* piece = document.child(m_file.data_set(), "Piece");
    if(piece == nullptr)
      m_file.fail("element 'PolyData' has no element 'Piece'");
    for(; piece != nullptr; piece = document.next(*piece, "Piece"))
      read_piece(*piece);
    // normals of some pieces only are normals of some points only
    if(m_data.normals.size() != m_data.points.size())
      m_data.normals.clear();
    return std::move(m_data);
  }

private:
  void read_piece(const Xml_element& piece)
  {
    const std::size_t first_point = m_data.points.size();
    read_points(piece);
    read_normals(piece, m_data.points.size() - first_point);
    const Cells polygons = read_cells(piece, "Polys", first_point);
    const Cells strips = read_cells(piece, "Strips", first_point);
    append_polygons(polygons);
    append_strips(strips);
    m_data.number_of_vertex_cells += count(piece, "NumberOfVerts");
    m_data.number_of_line_cells += count(piece, "NumberOfLines");
  }

  std::size_t count(const Xml_element& piece, const char* attribute) const
  {
    return piece.attribute(attribute) ? m_file.numbers<std::size_t>(piece, attribute, 1)[0] : 0;
  }

  void read_points(const Xml_element& piece)
  {
    const Xml_document& document = m_file.document();
    const Xml_element* const points = document.child(piece, "Points");
    const Xml_element* const array = points ? document.child(*points, "DataArray") : nullptr;
    const std::size_t announced = count(piece, "NumberOfPoints");
    if(array == nullptr) {
      if(announced != 0)
        m_file.fail("element 'Points' has no element 'DataArray'");
      return;
    }
    const std::vector<Vector_3> vectors = read_vectors(*array);
    if(vectors.size() != announced)
      m_file.fail("array " + in_quotes(array->attribute("Name").value_or("")) + ": has " +
                  std::to_string(vectors.size()) + " points: NumberOfPoints is " +
                  std::to_string(announced));
    for(const Vector_3& v : vectors)
      m_data.points.emplace_back(v.x(), v.y(), v.z());
  }

  /// reads the array that the point data call normals, or the one with that name.
  void read_normals(const Xml_element& piece, std::size_t number_of_points)
  {
    const Xml_document& document = m_file.document();
    const Xml_element* const data = document.child(piece, "PointData");
    if(data == nullptr)
      return;
    const std::string wanted = data->attribute("Normals").value_or("");
    for(const Xml_element* e = document.child(*data, "DataArray"); e;
        e = document.next(*e, "DataArray")) {
      const std::string name = e->attribute("Name").value_or("");
      if(wanted.empty() ? name != "Normals" && name != "normals" : name != wanted)
        continue;
      const std::vector<Vector_3> normals = read_vectors(*e);
      if(normals.size() != number_of_points)
        m_file.fail("array " + in_quotes(name) + ": has " + std::to_string(normals.size()) +
                    " normals: there are " + std::to_string(number_of_points) + " points");
      m_data.normals.insert(m_data.normals.end(), normals.begin(), normals.end());
      return;
    }
  }

  std::vector<Vector_3> read_vectors(const Xml_element& element)
  {
    const std::vector<double> values = converted<double>(read_vtk_array(m_file, element));
    return with_array_name(m_file, element.attribute("Name").value_or(""), [&] {
      const std::size_t components = vtk_components(element);
      if(components != 3 || values.size() % 3 != 0)
        throw std::runtime_error("has " + std::to_string(values.size()) + " values in groups of " +
                                 std::to_string(components) + ": 3 coordinates are needed");
      std::vector<Vector_3> vectors;
      for(std::size_t i = 0; i < values.size(); i += 3)
        vectors.emplace_back(values[i], values[i + 1], values[i + 2]);
      return vectors;
    });
  }

  /// cells as VTK stores them: the points of all, and where each of them ends.
  struct Cells
  {
    std::vector<std::size_t> connectivity;
    std::vector<std::size_t> offsets;
  };

  Cells read_cells(const Xml_element& piece, const char* kind, std::size_t first_point)
  {
    Cells cells;
    if(const Xml_element* const element = m_file.document().child(piece, kind)) {
      cells.connectivity = read_indices(*element, "connectivity");
      cells.offsets = read_indices(*element, "offsets");
    }
    check_connectivity(cells, first_point);
    check_offsets(cells);
    return cells;
  }

  std::vector<std::size_t> read_indices(const Xml_element& cells, const std::string& name)
  {
    const Xml_document& document = m_file.document();
    const Xml_element* array = document.child(cells, "DataArray");
    while(array != nullptr && array->attribute("Name").value_or("") != name)
      array = document.next(*array, "DataArray");
    if(array == nullptr)
      return {};
    const Typed_values values = read_vtk_array(m_file, *array);
    if(type_of(values) == Scalar_type::FLOAT32 || type_of(values) == Scalar_type::FLOAT64)
      m_file.fail("array " + in_quotes(name) + ": its type must be an integer");
    // what is negative becomes larger than any number of points or of indices
    return converted<std::size_t>(values);
  }

  /// makes the indices of a piece those of the whole.
  void check_connectivity(Cells& cells, std::size_t first_point) const
  {
    const std::size_t points = m_data.points.size() - first_point;
    for(std::size_t i = 0; i < cells.connectivity.size(); ++i) {
      if(cells.connectivity[i] >= points)
        m_file.fail("array 'connectivity': value " + std::to_string(i) + " is " +
                    std::to_string(static_cast<std::int64_t>(cells.connectivity[i])) +
                    ": there are " + std::to_string(points) + " points");
      cells.connectivity[i] += first_point;
    }
  }

  void check_offsets(const Cells& cells) const
  {
    std::size_t last = 0;
    for(std::size_t i = 0; i < cells.offsets.size(); ++i) {
      const std::size_t offset = cells.offsets[i];
      if(offset < last || offset > cells.connectivity.size())
        m_file.fail("array 'offsets': value " + std::to_string(i) + " is " +
                    std::to_string(static_cast<std::int64_t>(offset)) + ": must be from " +
                    std::to_string(last) + " to " + std::to_string(cells.connectivity.size()));
      last = offset;
    }
    if(last != cells.connectivity.size())
      m_file.fail("array 'offsets': ends at " + std::to_string(last) +
                  ": array 'connectivity' has " + std::to_string(cells.connectivity.size()) +
                  " values");
  }

  void append_polygons(const Cells& cells)
  {
    auto begin = cells.connectivity.begin();
    for(const std::size_t offset : cells.offsets) {
      const auto end = cells.connectivity.begin() + std::ptrdiff_t(offset);
      m_data.polygons.emplace_back(begin, end);
      begin = end;
    }
  }

  /// each point of a strip makes a triangle with the two before it; every other one is turned.
  void append_strips(const Cells& cells)
  {
    std::size_t begin = 0;
    for(const std::size_t end : cells.offsets) {
      for(std::size_t i = begin; i + 2 < end; ++i) {
        const std::size_t odd = (i - begin) % 2;
        m_data.polygons.push_back({cells.connectivity[i], cells.connectivity[i + 1 + odd],
                                   cells.connectivity[i + 2 - odd]});
      }
      begin = end;
    }
  }

  Vtk_xml_file m_file;
  Poly_data m_data;
};

} // namespace internal
} // namespace IO
} // namespace Area_projection
} // namespace CGAL
/// \endcond

#endif // CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_VTK_POLY_DATA_READER_H
