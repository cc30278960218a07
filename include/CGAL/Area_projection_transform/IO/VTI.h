// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_IO_VTI_H
#define CGAL_AREA_PROJECTION_TRANSFORM_IO_VTI_H

#include <CGAL/Area_projection_transform/IO/Grid_image.h>
#include <CGAL/Area_projection_transform/internal/atomic_file.h>
#include <CGAL/Area_projection_transform/internal/vtk_image_reader.h>
#include <CGAL/Area_projection_transform/internal/vtk_image_writer.h>

#include <ostream>
#include <sstream>
#include <string>

namespace CGAL {
namespace Area_projection {
namespace IO {

/// \ingroup PkgAreaProjectionTransformIO
/// \brief writes an image as VTK XML image data, which ParaView, VTK and PyVista read.
///
/// Arrays become point data, metadata field data. The values are computed row by row; the
/// compressed bytes are held in memory until all are known. Failure is told by the state of `out`.
/// \param out where the image goes
/// \param image what is written
/// \param options how
inline void write_VTI(std::ostream& out, const Grid_image& image, const Image_options& options = {})
{
  if(!options.compress) {
    internal::Vtk_image_writer(out, image, 0).write();
    return;
  }
  std::stringstream buffer(std::ios_base::in | std::ios_base::out | std::ios_base::binary);
  internal::Vtk_image_writer(buffer, image, options.level).write();
  out << buffer.rdbuf();
}

/// \ingroup PkgAreaProjectionTransformIO
/// \brief writes an image to a `.vti` file, which appears whole or not at all.
///
/// Needs no more memory than a row and a block of a megabyte, compressed or not.
/// \param file_name the file; replaced as a whole, if it exists
/// \param image what is written
/// \param options how
/// \throw Output_error if the file cannot be written.
inline void write_VTI(const std::string& file_name, const Grid_image& image,
                      const Image_options& options = {})
{
  internal::Atomic_file file(file_name);
  if(file.is_seekable())
    internal::Vtk_image_writer(file.stream(), image, options.compress ? options.level : 0).write();
  else
    write_VTI(file.stream(), image, options);
  file.commit();
}

/// \ingroup PkgAreaProjectionTransformIO
/// \brief reads a `.vti` file.
///
/// Reads ascii, binary and appended data, raw or in base64, plain or compressed with zlib, as
/// written by this package, VTK and ParaView; the point data and the field data of an image with
/// the same spacing along the three axes. A field that is a list of texts becomes the lines of one.
/// \param file_name the file
/// \throw std::runtime_error if the file cannot be read or is none of these.
inline Stored_image read_VTI(const std::string& file_name)
{
  return internal::Vtk_image_reader(file_name).read();
}

} // namespace IO
} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_IO_VTI_H
