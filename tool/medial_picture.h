// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// A picture of medial balls in a surface.

#ifndef MAPT_MEDIAL_PICTURE_H
#define MAPT_MEDIAL_PICTURE_H

#include "body_view.h"
#include "picture.h"

#include <CGAL/Area_projection_transform/medial_balls/Medial_ball.h>

#include <string>
#include <vector>

namespace mapt {

// Writes three views of a surface with balls, the colour by their MAPT: blue for walls, violet for tubes, red for
// spheres. Few balls are drawn as such, many as their centres.
// \throw Output_error if the file cannot be written.
void write_medial_picture(const std::string& file, const Picture_source& surface,
                          const std::vector<AP::Medial_ball>& balls,
                          const std::vector<std::size_t>& kept, const std::vector<Segment>& holes);

} // namespace mapt

#endif // MAPT_MEDIAL_PICTURE_H
