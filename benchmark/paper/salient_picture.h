// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef AREA_PROJECTION_PAPER_SALIENT_PICTURE_H
#define AREA_PROJECTION_PAPER_SALIENT_PICTURE_H

#include "experiment.h"

#include <CGAL/Area_projection_transform/salient_points/Salient_point.h>

#include <string>
#include <vector>

namespace Paper {

/// \brief writes a picture of salient points before the silhouette of a surface, along `z` and along `x`, if
/// pictures are wanted.
///
/// As in the figures of the paper, a point is a disk of half its scale: red if the map around it is round,
/// blue if it is long, and the brighter the larger the intensity. The strongest are in front.
/// \param name of the file, without the folder; blanks become underlines
/// \throw Output_error if it cannot be written.
void write_picture_of_points(const Options& options, const std::string& name, const Soup& soup,
                             const std::vector<AP::Salient_point>& points);

} // namespace Paper

#endif // AREA_PROJECTION_PAPER_SALIENT_PICTURE_H
