// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MAPT_PICTURE_H
#define MAPT_PICTURE_H

#include <CGAL/Area_projection_transform/Joint_map.h>
#include <CGAL/Area_projection_transform/Surfels.h>
#include <CGAL/Area_projection_transform/Triangle_surface.h>

#include <string>
#include <variant>

namespace mapt {

namespace AP = CGAL::Area_projection;

/// what a silhouette is drawn of.
using Picture_source = std::variant<const AP::Triangle_surface*, const AP::Surfels*>;

/// writes a PNG with the largest values of the joint map along each of the three axes, before the
/// silhouette of the surface.
/// \throw Output_error if it cannot be written.
void write_picture(const std::string& file, const AP::Joint_map& map,
                   const Picture_source& surface);

} // namespace mapt

#endif // MAPT_PICTURE_H
