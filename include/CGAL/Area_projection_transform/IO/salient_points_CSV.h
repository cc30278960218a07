// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_IO_SALIENT_POINTS_CSV_H
#define CGAL_AREA_PROJECTION_TRANSFORM_IO_SALIENT_POINTS_CSV_H

#include <CGAL/Area_projection_transform/IO/CSV.h>
#include <CGAL/Area_projection_transform/Side.h>
#include <CGAL/Area_projection_transform/internal/atomic_file.h>
#include <CGAL/Area_projection_transform/salient_points/Salient_point.h>

#include <cmath>
#include <ostream>
#include <string>
#include <type_traits>

namespace CGAL {
namespace Area_projection {
namespace IO {

/// \ingroup PkgAreaProjectionTransformIO
/// \brief returns `sphere`, `tube`, `cone` or `other`.
/// \param shape the shape
inline const char* to_text(Salient_shape shape)
{
  switch(shape) {
  case Salient_shape::SPHERE:
    return "sphere";
  case Salient_shape::TUBE:
    return "tube";
  case Salient_shape::CONE:
    return "cone";
  case Salient_shape::OTHER:
    break;
  }
  return "other";
}

/// \ingroup PkgAreaProjectionTransformIO
/// returns `inside` or `outside`.
/// \param side the side
inline const char* to_text(Side side)
{
  return side == Side::INSIDE ? "inside" : "outside";
}

/// \ingroup PkgAreaProjectionTransformIO
/// \brief calls `visit(name, value)` for each column of a table of salient points, in their order.
///
/// Names and order are a promise; columns may be added behind the last. A value is a `double`, a
/// `std::size_t`, a `bool` or a text. What was not determined, or does not apply to the shape (such as the
/// axis of a sphere), is NaN.
///
/// | columns | |
/// |---|---|
/// | `x`, `y`, `z`, `radius`, `scale`, `intensity`, `sphericity` | see `Salient_point` |
/// | `blobness`, `flatness`, `vesselness` | see `Inertia_descriptors` |
/// | `observed_fraction` | see `Salient_point` |
/// | `type` | `sphere`, `tube`, `cone` or `other` |
/// | `axis_x`, `axis_y`, `axis_z`, `radius_low`, `radius_high`, `residual` | see `Salient_point` |
/// | `voters` | their number |
/// | `length`, `slope`, `curvature_x`, `curvature_y`, `curvature_z` | see `Salient_point` |
/// | `one_sided` | whether it is seen from one side only |
/// | `side` | `inside` or `outside`: where the centre was sought |
/// \param point the salient point
/// \param side the side on which it was found
/// \param visit a function of the name of a column and its value
template <class Visitor>
void for_each_column(const Salient_point& point, Side side, Visitor&& visit)
{
  const bool has_axis = point.axis != Vector_3(0, 0, 0);
  const auto of_axis = [has_axis](double value) {
    return has_axis ? value : Salient_point::unknown;
  };
  visit("x", point.position.x());
  visit("y", point.position.y());
  visit("z", point.position.z());
  visit("radius", point.radius);
  visit("scale", point.scale);
  visit("intensity", point.intensity);
  visit("sphericity", point.sphericity);
  visit("blobness", point.inertia.blobness);
  visit("flatness", point.inertia.flatness);
  visit("vesselness", point.inertia.vesselness);
  visit("observed_fraction", point.observed_fraction);
  visit("type", to_text(point.shape));
  visit("axis_x", of_axis(point.axis.x()));
  visit("axis_y", of_axis(point.axis.y()));
  visit("axis_z", of_axis(point.axis.z()));
  visit("radius_low", point.radius_low);
  visit("radius_high", point.radius_high);
  visit("residual", point.residual);
  visit("voters", point.voters.size());
  visit("length", point.length);
  visit("slope", of_axis(point.slope));
  visit("curvature_x", of_axis(point.curvature.x()));
  visit("curvature_y", of_axis(point.curvature.y()));
  visit("curvature_z", of_axis(point.curvature.z()));
  visit("one_sided", point.is_seen_from_one_side);
  visit("side", to_text(side));
}

/// \ingroup PkgAreaProjectionTransformIO
/// \brief writes a table of salient points, one in a row, with the columns of `for_each_column()`.
///
/// NaN becomes an empty field, and `one_sided` is 0 or 1. Other numbers read back as exactly the same ones.
class Salient_points_CSV_writer
{
public:
  /// writes the names of the columns.
  explicit Salient_points_CSV_writer(std::ostream& out) : m_table(out)
  {
    for_each_column(Salient_point(), Side::INSIDE,
                    [this](const char* name, const auto&) { m_table.field(name); });
    m_table.end_row();
  }

  /// \brief writes the row of a point.
  /// \param point the point
  /// \param side the side on which it was found, for the column `side`
  void write(const Salient_point& point, Side side = Side::INSIDE)
  {
    for_each_column(point, side, [this](const char*, const auto& value) { write_field(value); });
    m_table.end_row();
  }

private:
  template <class Value>
  void write_field(const Value& value)
  {
    if constexpr(std::is_same_v<Value, bool>)
      m_table.field(int(value));
    else if constexpr(std::is_floating_point_v<Value>)
      std::isnan(value) ? m_table.field("") : m_table.field(value);
    else
      m_table.field(value);
  }

  CSV_writer m_table;
};

/// \ingroup PkgAreaProjectionTransformIO
/// \brief writes a range of salient points as a table: see `Salient_points_CSV_writer`.
/// \param out where the table goes
/// \param points a range of salient points
/// \param side the side on which they were found
template <class SalientPointRange>
void write_salient_points_CSV(std::ostream& out, const SalientPointRange& points,
                              Side side = Side::INSIDE)
{
  Salient_points_CSV_writer table(out);
  for(const Salient_point& point : points)
    table.write(point, side);
}

/// \ingroup PkgAreaProjectionTransformIO
/// \brief writes a range of salient points to a `.csv` file, which appears whole or not at all.
/// \param file_name the file; replaced as a whole, if it exists
/// \param points a range of salient points
/// \param side the side on which they were found
/// \throw Output_error if the file cannot be written.
template <class SalientPointRange>
void write_salient_points_CSV(const std::string& file_name, const SalientPointRange& points,
                              Side side = Side::INSIDE)
{
  internal::Atomic_file file(file_name);
  write_salient_points_CSV(file.stream(), points, side);
  file.commit();
}

} // namespace IO
} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_IO_SALIENT_POINTS_CSV_H
