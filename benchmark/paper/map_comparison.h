// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef AREA_PROJECTION_PAPER_MAP_COMPARISON_H
#define AREA_PROJECTION_PAPER_MAP_COMPARISON_H

#include <CGAL/Area_projection_transform/Joint_map.h>
#include <CGAL/Area_projection_transform/Row_spans.h>

#include <cstddef>
#include <vector>

namespace Paper {

namespace AP = CGAL::Area_projection;

/// how far a map is from another.
struct Map_difference
{
  /// Pearson's; 0, but for rounding, if a map is constant.
  double correlation = 0;
  /// the root mean square of the difference, relative to that of the clean map.
  double relative_rms = 0;
};

/// \brief compares the values of two maps at the voxels of a region.
/// \param factor what `other` is multiplied by before it is compared
Map_difference compare(const AP::Row_spans& region, const std::vector<float>& clean,
                       const std::vector<float>& other, double factor = 1);

/// how well one region covers another of the same grid.
struct Region_agreement
{
  double found; ///< the fraction of the voxels of the clean region that are in the other one
  double wrong; ///< the fraction of the voxels of the other one that are not in the clean region
};

Region_agreement compare(const AP::Row_spans& clean, const AP::Row_spans& other);

/// what became of a local maximum; lengths are in voxels.
struct Maximum_change
{
  bool is_lost = true; ///< there is no maximum of similar radius near: then the rest means nothing
  double displacement = 0;
  /// \brief the displacement without that along the plateau on which the maximum stands.
  ///
  /// On the axis of a tube the map is about constant, and chance decides where its maximum is: it slides
  /// along the axis at the slightest touch, and nothing is lost by that.
  double across = 0;
  /// the value of the maximum of the other map, relative to that of the clean one.
  double score_ratio = 0;
  /// the value of the *clean* map at the new place, relative to its maximum: near 1 for one that has slid
  /// along a plateau, whatever its shape.
  double clean_value_there = 0;
};

/// \brief looks for the strongest local maxima of a joint map in another of the same region.
///
/// The maxima are those that `mapt` lists. Each of the clean map, the strongest first, takes the nearest
/// of the other map that is not taken yet, no farther than twice its radius, and whose radius is that of a
/// neighbouring scale or differs by less than a quarter.
///
/// The plateau of a maximum is made of the voxels around it, no farther than its radius, that hang
/// together and have at least nine tenths of its value. It is free to slide in the directions in which the plateau spreads
/// more than twice as far as in its narrowest: none for a ball, one for a tube, two between plates.
std::vector<Maximum_change> compare_maxima(const AP::Joint_map& clean, const AP::Joint_map& other,
                                           std::size_t number);

} // namespace Paper

#endif // AREA_PROJECTION_PAPER_MAP_COMPARISON_H
