// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_VTK_IMAGE_READER_H
#define CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_VTK_IMAGE_READER_H

#include <CGAL/Area_projection_transform/IO/Grid_image.h>
#include <CGAL/Area_projection_transform/IO/number_text.h>
#include <CGAL/Area_projection_transform/internal/vtk_data_array.h>

#include <array>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

/// \cond SKIP_IN_MANUAL
namespace CGAL {
namespace Area_projection {
namespace IO {
namespace internal {

/// reads an image in VTK's XML format.
class Vtk_image_reader
{
public:
  explicit Vtk_image_reader(const std::string& name) : m_file(name, "ImageData") {}

  Stored_image read()
  {
    Stored_image image{read_grid(), {}, {}};
    read_metadata(image.metadata);
    read_piece(image);
    return image;
  }

private:
  Grid_3 read_grid() const
  {
    const Xml_element& element = m_file.data_set();
    const auto extent = m_file.numbers<std::int32_t>(element, "WholeExtent", 6);
    const auto origin = m_file.numbers<double>(element, "Origin", 3);
    const auto spacing = m_file.numbers<double>(element, "Spacing", 3);
    if(spacing[0] != spacing[1] || spacing[0] != spacing[2])
      m_file.fail("attribute Spacing of element 'ImageData' is " +
                  in_quotes(*element.attribute("Spacing")) +
                  ": must be the same along the three axes");
    check_direction(element);
    std::array<int, 3> size;
    for(std::size_t axis = 0; axis < 3; ++axis) {
      const std::int64_t length = std::int64_t(extent[2 * axis + 1]) - extent[2 * axis] + 1;
      if(length < 1 || length > std::numeric_limits<int>::max())
        m_file.fail("attribute WholeExtent of element 'ImageData' is " +
                    in_quotes(*element.attribute("WholeExtent")) + ": is empty or too large");
      size[axis] = int(length);
    }
    try {
      return Grid_3(Point_3(origin[0] + spacing[0] * extent[0], origin[1] + spacing[0] * extent[2],
                            origin[2] + spacing[0] * extent[4]),
                    spacing[0], size);
    } catch(const std::invalid_argument& error) {
      m_file.fail(std::string("element 'ImageData': ") + error.what());
    }
  }

  void check_direction(const Xml_element& element) const
  {
    if(!element.attribute("Direction"))
      return;
    const std::vector<double> identity = {1, 0, 0, 0, 1, 0, 0, 0, 1};
    if(m_file.numbers<double>(element, "Direction", 9) != identity)
      m_file.fail("attribute Direction of element 'ImageData' is " +
                  in_quotes(*element.attribute("Direction")) +
                  ": rotated images are not supported");
  }

  void read_metadata(Metadata& metadata)
  {
    const Xml_document& document = m_file.document();
    const Xml_element* const field = document.child(m_file.data_set(), "FieldData");
    if(field == nullptr)
      return;
    for(const Xml_element* e = document.first_child(*field); e; e = document.next(*e)) {
      const std::string name = e->attribute("Name").value_or("");
      if(e->attribute("type").value_or("") == "String")
        metadata.push_back({name, read_vtk_text(m_file, *e)});
      else if(e->name == "DataArray")
        metadata.push_back({name, converted<double>(read_vtk_array(m_file, *e))});
    }
  }

  void read_piece(Stored_image& image)
  {
    const Xml_document& document = m_file.document();
    const Xml_element* const piece = document.child(m_file.data_set(), "Piece");
    if(piece == nullptr || document.next(*piece, "Piece") != nullptr)
      m_file.fail("element 'ImageData' must have one element 'Piece'");
    if(m_file.numbers<std::int32_t>(*piece, "Extent", 6) !=
       m_file.numbers<std::int32_t>(m_file.data_set(), "WholeExtent", 6))
      m_file.fail("element 'Piece' does not cover the image");
    const Xml_element* const data = document.child(*piece, "PointData");
    if(data == nullptr)
      return;
    for(const Xml_element* e = document.child(*data, "DataArray"); e;
        e = document.next(*e, "DataArray"))
      image.arrays.push_back(read_array(image.grid, *e));
  }

  Stored_image::Array read_array(const Grid_3& grid, const Xml_element& element)
  {
    const std::string name = element.attribute("Name").value_or("");
    Typed_values values = read_vtk_array(m_file, element);
    const std::size_t components =
        with_array_name(m_file, name, [&] { return vtk_components(element); });
    // the number of voxels that the file claims may not fit into its type, this may
    const double needed = double(grid.size()[0]) * double(grid.number_of_rows());
    if(double(number_of_values(values)) / double(components) != needed)
      m_file.fail("array " + in_quotes(name) + ": has " + std::to_string(number_of_values(values)) +
                  " values: the image has " + std::to_string(grid.number_of_voxels()) +
                  " points with " + std::to_string(components) +
                  (components == 1 ? " component" : " components"));
    return {name, components, std::move(values)};
  }

  Vtk_xml_file m_file;
};

} // namespace internal
} // namespace IO
} // namespace Area_projection
} // namespace CGAL
/// \endcond

#endif // CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_VTK_IMAGE_READER_H
