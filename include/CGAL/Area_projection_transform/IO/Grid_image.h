// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_IO_GRID_IMAGE_H
#define CGAL_AREA_PROJECTION_TRANSFORM_IO_GRID_IMAGE_H

#include <CGAL/Area_projection_transform/Grid_3.h>
#include <CGAL/Area_projection_transform/IO/Typed_values.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace CGAL {
namespace Area_projection {
namespace IO {

/// \ingroup PkgAreaProjectionTransformIO
/// \brief a named number, list of numbers or text that is stored beside the values of an image.
struct Metadata_entry
{
  std::string name;                                     ///< what is told, such as `radii`
  std::variant<std::vector<double>, std::string> value; ///< numbers, or text
};

/// \ingroup PkgAreaProjectionTransformIO
/// what is known about how an image was made, in the order in which it is to be shown.
using Metadata = std::vector<Metadata_entry>;

/// \ingroup PkgAreaProjectionTransformIO
/// \brief describes an image that is to be written: a grid, arrays of values on it, metadata.
///
/// The values need not exist: each array is a function that computes a row of them when the writer
/// asks for it. So a map that is stored for a region of interest only is written without a dense
/// copy.
///
/// \code
/// Grid_image image(grid);
/// image.add_array<float>("JMAPT", [&](std::size_t row, float* values) { … });
/// image.add_metadata("radii", radii);
/// write_VTI("map.vti", image);
/// \endcode
class Grid_image
{
public:
  /// an array of values on the lattice, which is computed row by row.
  struct Array
  {
    std::string name; ///< the name that viewers show
    Scalar_type type; ///< the type of a value
    /// writes the values of a row, which has the given index in the grid, to `values`.
    std::function<void(std::size_t row, void* values)> fill_row;
  };

  /// constructs an image without arrays.
  explicit Grid_image(const Grid_3& grid) : m_grid(grid) {}

  /// \brief adds an array of `Scalar`.
  ///
  /// `fill_row(row, values)` writes `grid().size()[0]` values to the `Scalar* values`. The rows are
  /// asked for one at a time, in ascending order, and once for each file.
  /// \param name the name that viewers show
  /// \param fill_row computes a row
  /// \throw std::invalid_argument if there is an array of that name.
  template <class Scalar, class FillRow>
  void add_array(const std::string& name, FillRow fill_row)
  {
    if(std::any_of(m_arrays.begin(), m_arrays.end(),
                   [&](const Array& array) { return array.name == name; }))
      throw std::invalid_argument("name is '" + name + "': the image has such an array already");
    m_arrays.push_back({name, scalar_type<Scalar>,
                        [fill_row = std::move(fill_row)](std::size_t row, void* values) {
                          fill_row(row, static_cast<Scalar*>(values));
                        }});
  }

  /// adds a list of numbers to the metadata.
  void add_metadata(const std::string& name, std::vector<double> numbers)
  {
    m_metadata.push_back({name, std::move(numbers)});
  }
  /// adds a number to the metadata.
  void add_metadata(const std::string& name, double number)
  {
    m_metadata.push_back({name, std::vector<double>{number}});
  }
  /// adds a text to the metadata.
  void add_metadata(const std::string& name, const std::string& text)
  {
    m_metadata.push_back({name, text});
  }
  /// adds a text to the metadata.
  void add_metadata(const std::string& name, const char* text)
  {
    m_metadata.push_back({name, std::string(text)});
  }

  /// the lattice.
  const Grid_3& grid() const { return m_grid; }
  /// the arrays, in the order in which they were added.
  const std::vector<Array>& arrays() const { return m_arrays; }
  /// the metadata, in the order in which they were added.
  const Metadata& metadata() const { return m_metadata; }

private:
  Grid_3 m_grid;
  std::vector<Array> m_arrays;
  Metadata m_metadata;
};

/// \ingroup PkgAreaProjectionTransformIO
/// \brief how an image is written.
struct Image_options
{
  bool compress = true; ///< with zlib; the values are the same, files of maps far smaller
  int level = 1;        ///< from 1, fast, to 9: over twice the time for 7 % less
};

/// \ingroup PkgAreaProjectionTransformIO
/// \brief an image that was read from a file.
struct Stored_image
{
  /// an array of values on the lattice.
  struct Array
  {
    std::string name;       ///< its name in the file
    std::size_t components; ///< the number of values of a lattice point, which are neighbours
    Typed_values values;    ///< in the order of the lattice: `x` runs fastest
  };

  Grid_3 grid;               ///< the lattice
  std::vector<Array> arrays; ///< in the order of the file
  Metadata metadata;         ///< what is told beside the values

  /// returns the array of that name, or null.
  const Array* array(const std::string& name) const
  {
    const auto found =
        std::find_if(arrays.begin(), arrays.end(), [&](const Array& a) { return a.name == name; });
    return found == arrays.end() ? nullptr : &*found;
  }

  /// returns the metadata of that name, or null.
  const Metadata_entry* entry(const std::string& name) const
  {
    const auto found = std::find_if(metadata.begin(), metadata.end(),
                                    [&](const Metadata_entry& e) { return e.name == name; });
    return found == metadata.end() ? nullptr : &*found;
  }
};

} // namespace IO
} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_IO_GRID_IMAGE_H
