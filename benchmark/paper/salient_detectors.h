// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef AREA_PROJECTION_PAPER_SALIENT_DETECTORS_H
#define AREA_PROJECTION_PAPER_SALIENT_DETECTORS_H

#include "salient_score.h"

#include <CGAL/Area_projection_transform/salient_points/Salient_point.h>

#include <vector>

namespace Paper {

inline Detection detection_of(const CGAL::Area_projection::Salient_point& point)
{
  using Shape = CGAL::Area_projection::Salient_shape;
  Detection detection;
  detection.shape = point.shape == Shape::SPHERE ? Found_shape::SPHERE
                    : point.shape == Shape::TUBE ? Found_shape::TUBE
                    : point.shape == Shape::CONE ? Found_shape::CONE
                                                 : Found_shape::OTHER;
  detection.position = point.position;
  detection.axis = point.axis;
  detection.radius = point.radius;
  detection.low = point.radius_low;
  detection.high = point.radius_high;
  detection.slope = point.slope;
  detection.curvature = point.curvature;
  return detection;
}

inline std::vector<Detection>
detections_of(const std::vector<CGAL::Area_projection::Salient_point>& points)
{
  std::vector<Detection> detections;
  for(const CGAL::Area_projection::Salient_point& point : points)
    detections.push_back(detection_of(point));
  return detections;
}

} // namespace Paper

#endif // AREA_PROJECTION_PAPER_SALIENT_DETECTORS_H
