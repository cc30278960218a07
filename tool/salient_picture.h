// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MAPT_SALIENT_PICTURE_H
#define MAPT_SALIENT_PICTURE_H

#include "body_view.h"
#include "picture.h"

#include <CGAL/Area_projection_transform/salient_points/Salient_point.h>

#include <string>
#include <vector>

namespace mapt {

/// what is drawn of a salient point.
enum class Salient_style {
  FITS,   // the outline of the sphere or the tube that was fitted; a small ball if none was
  SCALES, // a ball of half the scale, as in figures 9 to 11 of the paper
};

/// writes a PNG with salient points before the surface, seen along the three axes.
///
/// From blue to red points are the rounder (their sphericity; fitted tubes are blue and spheres red), and
/// the brighter the higher their intensity.
/// \param holes edges that are drawn in green
/// \throw Output_error if it cannot be written.
void write_salient_picture(const std::string& file, const Picture_source& surface,
                           const std::vector<AP::Salient_point>& points,
                           const std::vector<Segment>& holes, Salient_style style);

} // namespace mapt

#endif // MAPT_SALIENT_PICTURE_H
