// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef AREA_PROJECTION_PAPER_RANSAC_PEER_H
#define AREA_PROJECTION_PAPER_RANSAC_PEER_H

#include "scene_damage.h"
#include "salient_score.h"

#include <cstdint>
#include <vector>

namespace Paper {

/// what CGAL's Efficient RANSAC is told, with lengths in units of the mean length of the edges.
struct Ransac_parameters
{
  double epsilon = 0.1;
  double cluster_epsilon = 4;
  double normal_threshold = 0.9;
  double min_points = 0.005; ///< in units of the number of points
  double probability = 0.01;
  bool has_all_shapes = false; ///< cones and tori as well as spheres and cylinders
};

/// \brief the parameters that suit noise best, of those that were tried on other scenes of the same kind.
///
/// It is told how much noise there is, which other methods have to find out.
/// \param noise as in `Scene_damage`
/// \param is_hard whether there are bent and tapering tubes
Ransac_parameters ransac_parameters(double noise, bool is_hard);

/// \brief finds spheres and tubes by CGAL's Efficient RANSAC.
///
/// It gets the vertices that faces use, with the mean normals of their faces, weighted by area. Planes are
/// among the shapes, so that the caps of tubes do not become large cylinders, and left out of the answer, as are
/// shapes whose radius is more than a quarter of the diagonal of the bounding box.
/// \param is_refit whether shapes are fitted to their points again, as ours are: by robust least squares, less the
/// bias of noise
std::vector<Detection> detect_by_ransac(const Soup& soup, const Ransac_parameters& parameters,
                                        bool is_refit, std::uint64_t seed);

} // namespace Paper

#endif // AREA_PROJECTION_PAPER_RANSAC_PEER_H
