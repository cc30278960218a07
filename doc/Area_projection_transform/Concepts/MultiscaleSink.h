// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

/// \ingroup PkgAreaProjectionTransformConcepts
/// \cgalConcept
///
/// What becomes of the values of the multiscale transform. Runs of voxels come scale by scale, several
/// scales at a time if there are several threads, but no two calls at a time concern the same scale
/// or the same layer of voxels: a sink that touches only data of the scale or of the voxels that it is
/// given needs no lock.
///
/// \cgalHasModel `CGAL::Area_projection::Joint_map`
/// \cgalHasModel `CGAL::Area_projection::Scale_maps_sink`
/// \cgalHasModel `CGAL::Area_projection::Sink_pair`
class MultiscaleSink
{
public:
  /// \param scale_index the place of the scale in the list of scales
  /// \param scale the scale
  /// \param first_voxel the place of the first voxel in the storage of the region
  /// \param values `APT / (4πR²)` at this and the following voxels
  /// \param number how many
  void consume(std::size_t scale_index, const CGAL::Area_projection::Scale& scale,
               std::size_t first_voxel, const float* values, std::size_t number);
};
