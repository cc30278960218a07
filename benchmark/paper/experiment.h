// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef AREA_PROJECTION_PAPER_EXPERIMENT_H
#define AREA_PROJECTION_PAPER_EXPERIMENT_H

#include "benchmark_report.h"
#include "damage.h"
#include "map_comparison.h"
#include "transform.h"

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace Paper {

struct Options
{
  std::uint64_t seed = 1;
  int voxels = 64; ///< along the longest side
  int scenes = 20; ///< of round objects, for each damage
  bool is_quick = false;
  std::vector<std::string> meshes; ///< files, instead of the bundled ones
  std::string retrieval;           ///< the folder of a labelled set; empty: there is none
  std::string pictures;            ///< the folder for pictures; empty: none are made

  /// one of two numbers, by the effort.
  template <class T>
  T pick(T quick, T full) const
  {
    return is_quick ? quick : full;
  }
};

struct Mesh
{
  std::string name;
  Soup soup;
};

/// reads the meshes of the options, or the bundled ones of these names, only the first of them if it has to
/// be quick.
/// \throw Input_error if one cannot be read.
std::vector<Mesh> read_meshes(const Options& options, const std::vector<std::string>& bundled);

/// a surface before anything happens to it: its maps over its own interior.
class Subject
{
public:
  /// \param radii_in_voxels ascending
  Subject(Mesh mesh, int voxels, const std::vector<double>& radii_in_voxels);

  const std::string& name() const { return m_mesh.name; }
  const Soup& soup() const { return m_mesh.soup; }
  const std::shared_ptr<const AP::Row_spans>& region() const { return m_region; }
  const std::vector<AP::Scale>& scales() const { return m_scales; }

  /// the maps with the normals of a mode, computed when they are asked for first.
  const Maps& maps(const std::string& mode);

  /// name, size, resolution.
  Benchmarks::Parameters parameters() const;

private:
  Mesh m_mesh;
  std::shared_ptr<const AP::Row_spans> m_region;
  std::vector<AP::Scale> m_scales;
  std::map<std::string, Maps> m_maps;
};

/// the radii of the paper's descriptor, in voxels: 2, 3, …, 9.
std::vector<double> descriptor_radii();

/// the radius of a scale in voxels, without the rounding of lengths.
double radius_in_voxels(const AP::Joint_map& map, std::size_t scale);

/// something that is done to a surface; the same seed does the same.
struct Damage
{
  std::string kind;
  double amount;
  std::function<Soup(const Soup&, std::uint64_t seed)> apply;
};

Damage removed_faces(double fraction);
Damage holes(double fraction);
Damage noise(double ratio);

/// a surface after that, and what can be said of it without its maps.
struct Damaged
{
  Soup soup;
  double area_ratio; ///< its area, relative to that of the whole surface
  double coverage;   ///< what its own interior sees of it
  Region_agreement interior;
};

Damaged apply(const Damage& damage, const Subject& subject, std::uint64_t seed);

using Measures = std::vector<std::pair<std::string, double>>;

/// \brief what is found of the clean maps in those of the damaged surface: correlations, and relative RMS
/// differences: without compensation for the area that is missing, divided by the coverage, and by
/// the ratio of the areas.
Measures measure_maps(const Maps& clean, const Maps& other, const Damaged& damaged);

/// \brief what became of the ten strongest maxima of the joint map: means over those that are found.
Measures measure_maxima(const Maps& clean, const Maps& other, const Damaged& damaged);

/// what is known of the surface alone.
Measures measure_interior(const Damaged& damaged);

/// the means of measures of the same names; one that is missing somewhere does not count there.
Measures mean(const std::vector<Measures>& all);

Benchmarks::Row row(const std::string& group, const std::string& comparison,
                    const std::string& name, Benchmarks::Parameters parameters, Measures measures);

/// prints the rows of a comparison and adds them to the report.
void publish(const std::vector<Benchmarks::Row>& rows, Benchmarks::Report& report);

/// writes pictures of the given scales and of the joint map, if pictures are wanted.
/// \param stem the beginning of the names of the files
void write_pictures(const Options& options, const std::string& stem, const Maps& maps,
                    const std::vector<std::size_t>& scales, const Soup& silhouette);

} // namespace Paper

#endif // AREA_PROJECTION_PAPER_EXPERIMENT_H
