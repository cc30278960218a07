// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_IO_NRRD_H
#define CGAL_AREA_PROJECTION_TRANSFORM_IO_NRRD_H

#include <CGAL/Area_projection_transform/IO/Grid_image.h>
#include <CGAL/Area_projection_transform/internal/atomic_file.h>
#include <CGAL/Area_projection_transform/internal/nrrd_reader.h>
#include <CGAL/Area_projection_transform/internal/nrrd_writer.h>

#include <ostream>
#include <string>

namespace CGAL {
namespace Area_projection {
namespace IO {

/// \ingroup PkgAreaProjectionTransformIO
/// \brief writes an image as NRRD, which 3D Slicer, ITK-SNAP, VTK and pynrrd read.
///
/// The coordinates of the mesh are taken as left-posterior-superior, as 3D Slicer takes those of
/// meshes. An image with one array becomes a plain volume, the array its content. Several arrays
/// become the first axis of one file, of kind list; 3D Slicer shows it as a sequence whose items
/// have the names of the arrays. If their types differ all become doubles. Metadata become key and
/// value. The values are computed row by row. Failure is told by the state of `out`.
///
/// VTK 9.1 reads a part only of several arrays that are compressed; write them uncompressed for it.
/// \param out where the image goes
/// \param image what is written
/// \param options how
/// \throw std::invalid_argument if the image has no array.
inline void write_NRRD(std::ostream& out, const Grid_image& image,
                       const Image_options& options = {})
{
  internal::Nrrd_writer(out, image, options).write();
}

/// \ingroup PkgAreaProjectionTransformIO
/// \brief writes an image to a `.nrrd` file, which appears whole or not at all.
/// \param file_name the file; replaced as a whole, if it exists
/// \param image what is written
/// \param options how
/// \throw Output_error if the file cannot be written.
/// \throw std::invalid_argument if the image has no array.
inline void write_NRRD(const std::string& file_name, const Grid_image& image,
                       const Image_options& options = {})
{
  internal::Atomic_file file(file_name);
  write_NRRD(file.stream(), image, options);
  file.commit();
}

/// \ingroup PkgAreaProjectionTransformIO
/// \brief reads a `.nrrd` file as `write_NRRD()` writes it: header and data in one file, raw or
/// gzip, little endian, axes parallel to those of space, with the same spacing.
///
/// The format does not tell numbers from text: values made of numbers only are read as numbers.
/// \param file_name the file
/// \throw std::runtime_error if the file cannot be read or is none of these.
inline Stored_image read_NRRD(const std::string& file_name)
{
  return internal::Nrrd_reader(file_name).read();
}

} // namespace IO
} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_IO_NRRD_H
