// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_SHAPE_DESCRIPTOR_HISTOGRAM_SINKS_H
#define CGAL_AREA_PROJECTION_TRANSFORM_SHAPE_DESCRIPTOR_HISTOGRAM_SINKS_H

#include <CGAL/Area_projection_transform/scales.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL {
namespace Area_projection {

/// \ingroup PkgAreaProjectionTransformDescriptors
/// \brief equal bins over the range from 0 to some value, and the place of a value among them.
class Bins
{
public:
  /// \param number at least 2
  /// \param largest_value where the last bin ends
  /// \param factor what values are multiplied by
  Bins(std::size_t number, double largest_value, double factor = 1)
      : m_number(number)
      , m_factor(float(std::min(factor * double(number) / largest_value,
                                double(std::numeric_limits<float>::max())))) // 0 times that is 0
  {}

  /// how many bins there are.
  std::size_t number() const { return m_number; }

  /// the bin of a value; the last one if it is larger than all.
  std::size_t bin(float value) const
  {
    return std::size_t(std::min(value * m_factor, float(m_number - 1)));
  }

  /// a value between the middles of two neighbouring bins, the lower of which is `bin`.
  struct Place
  {
    std::size_t bin;    ///< the lower of the two
    std::int64_t upper; ///< the share of the upper one, in units of `1 / unit`
  };

  /// shares are whole numbers of this, so that sums do not depend on the order of their terms.
  static constexpr std::int64_t unit = 1 << 12;

  /// the place of a value; before the first middle and behind the last one that of the middle.
  Place place(float value) const
  {
    const float t = std::clamp(value * m_factor - 0.5f, 0.f, float(m_number - 1));
    const std::size_t bin = std::min(std::size_t(t), m_number - 2);
    return {bin, std::int64_t((t - float(bin)) * float(unit) + 0.5f)};
  }

private:
  std::size_t m_number;
  float m_factor;
};

/// \ingroup PkgAreaProjectionTransformDescriptors
/// \brief counts, for each scale, into which bin the values of its map fall. Keeps no map.
/// \cgalModels `MultiscaleSink`
class Histogram_sink
{
public:
  /// \param scales how many scales will come
  /// \param bins where values are counted
  /// \param is_soft whether a value is shared by two bins
  Histogram_sink(std::size_t scales, const Bins& bins, bool is_soft)
      : m_bins(bins)
      , m_is_soft(is_soft)
      , m_histograms(scales, std::vector<std::int64_t>(bins.number(), 0))
  {}

  /// counts the values of some voxels.
  void consume(std::size_t scale_index, const Scale&, std::size_t, const float* values,
               std::size_t number)
  {
    std::vector<std::int64_t>& histogram = m_histograms[scale_index];
    if(!m_is_soft) {
      for(std::size_t i = 0; i < number; ++i)
        ++histogram[m_bins.bin(values[i])];
      return;
    }
    for(std::size_t i = 0; i < number; ++i) {
      const Bins::Place place = m_bins.place(values[i]);
      histogram[place.bin] += Bins::unit - place.upper;
      histogram[place.bin + 1] += place.upper;
    }
  }

  /// for each scale the histogram: voxels, or `Bins::unit` times as many if it is soft.
  const std::vector<std::vector<std::int64_t>>& histograms() const { return m_histograms; }

private:
  Bins m_bins;
  bool m_is_soft;
  std::vector<std::vector<std::int64_t>> m_histograms;
};

/// \ingroup PkgAreaProjectionTransformDescriptors
/// \brief counts into which cells of a table the pairs of values of two maps fall: one map is given, the other
/// comes as a stream of one scale. Pairs are shared by four cells.
/// \cgalModels `MultiscaleSink`
class Pair_histogram_sink
{
public:
  /// \param first the values of the first map at the places that `Row_spans::index()` gives; must outlive the sink
  /// \param bins the bins of both maps
  Pair_histogram_sink(const std::vector<float>& first, const Bins& bins)
      : m_first(first), m_bins(bins), m_table(bins.number() * bins.number(), 0)
  {}

  /// counts the pairs of values of some voxels.
  void consume(std::size_t, const Scale&, std::size_t first_voxel, const float* values,
               std::size_t number)
  {
    const std::size_t stride = m_bins.number();
    for(std::size_t i = 0; i < number; ++i) {
      const Bins::Place a = m_bins.place(m_first[first_voxel + i]), b = m_bins.place(values[i]);
      std::int64_t* const cell = m_table.data() + a.bin * stride + b.bin;
      const std::int64_t lower = Bins::unit - a.upper, left = Bins::unit - b.upper;
      cell[0] += lower * left;
      cell[1] += lower * b.upper;
      cell[stride] += a.upper * left;
      cell[stride + 1] += a.upper * b.upper;
    }
  }

  /// the table, a row for each bin of the first map: voxels times the square of `Bins::unit`.
  const std::vector<std::int64_t>& table() const { return m_table; }

private:
  const std::vector<float>& m_first;
  Bins m_bins;
  std::vector<std::int64_t> m_table;
};

} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_SHAPE_DESCRIPTOR_HISTOGRAM_SINKS_H
