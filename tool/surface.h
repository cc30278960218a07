// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MAPT_SURFACE_H
#define MAPT_SURFACE_H

#include "input.h"

#include <CGAL/Area_projection_transform/scale_space/Constant_scale_space.h>
#include <CGAL/Area_projection_transform/surfels_from_mesh.h>

#include <memory>
#include <variant>

namespace mapt {

namespace AP = CGAL::Area_projection;

template <class Source>
using Shared_surface = std::shared_ptr<const AP::Constant_scale_space<Source>>;

/// an input as the library wants it: a mesh or soup, or points.
using Surface = std::variant<Shared_surface<AP::Triangle_surface>, Shared_surface<AP::Surfels>>;

/// \param use_interpolated_normals whether normals vary over the faces; not for points.
/// \throw Input_error if points have no areas and are too few to estimate them.
Surface make_surface(const Input& input, bool use_interpolated_normals);

/// the area of the surface, in squared units of the input.
double area_of(const Surface& surface);

} // namespace mapt

#endif // MAPT_SURFACE_H
