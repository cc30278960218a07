// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_IO_TYPED_VALUES_H
#define CGAL_AREA_PROJECTION_TRANSFORM_IO_TYPED_VALUES_H

#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace CGAL {
namespace Area_projection {
namespace IO {

/// \ingroup PkgAreaProjectionTransformIO
/// \brief the type of the values of an array in a file.
enum class Scalar_type {
  INT8,
  UINT8,
  INT16,
  UINT16,
  INT32,
  UINT32,
  INT64,
  UINT64,
  FLOAT32,
  FLOAT64
};

/// \ingroup PkgAreaProjectionTransformIO
/// \brief the values of an array in the type that the file has; the alternatives are in the order
/// of `Scalar_type`.
using Typed_values =
    std::variant<std::vector<std::int8_t>, std::vector<std::uint8_t>, std::vector<std::int16_t>,
                 std::vector<std::uint16_t>, std::vector<std::int32_t>, std::vector<std::uint32_t>,
                 std::vector<std::int64_t>, std::vector<std::uint64_t>, std::vector<float>,
                 std::vector<double>>;

/// \cond SKIP_IN_MANUAL
namespace internal {

template <class Scalar, std::size_t index = 0>
constexpr std::size_t index_of_scalar()
{
  static_assert(index < std::variant_size_v<Typed_values>, "no file format has this scalar type");
  using Values = std::variant_alternative_t<index, Typed_values>;
  if constexpr(std::is_same_v<typename Values::value_type, Scalar>)
    return index;
  else
    return index_of_scalar<Scalar, index + 1>();
}

template <std::size_t... index>
Typed_values empty_values(std::size_t wanted, std::index_sequence<index...>)
{
  Typed_values values;
  ((index == wanted ? void(values.emplace<index>()) : void()), ...);
  return values;
}

} // namespace internal
/// \endcond

/// \ingroup PkgAreaProjectionTransformIO
/// the `Scalar_type` of a C++ type.
template <class Scalar>
constexpr Scalar_type scalar_type = Scalar_type(internal::index_of_scalar<Scalar>());

/// \ingroup PkgAreaProjectionTransformIO
/// returns an array of the given type without values.
/// \param type the type of a value
inline Typed_values empty_values(Scalar_type type)
{
  return internal::empty_values(std::size_t(type),
                                std::make_index_sequence<std::variant_size_v<Typed_values>>());
}

/// \ingroup PkgAreaProjectionTransformIO
/// returns the type of `values`.
/// \param values the values
inline Scalar_type type_of(const Typed_values& values)
{
  return Scalar_type(values.index());
}

/// \ingroup PkgAreaProjectionTransformIO
/// returns the number of bytes of a value.
/// \param type the type of a value
inline std::size_t size_of(Scalar_type type)
{
  constexpr std::size_t sizes[] = {1, 1, 2, 2, 4, 4, 8, 8, 4, 8};
  return sizes[std::size_t(type)];
}

/// \ingroup PkgAreaProjectionTransformIO
/// returns the number of values.
/// \param values the values
inline std::size_t number_of_values(const Typed_values& values)
{
  return std::visit([](const auto& v) { return v.size(); }, values);
}

/// \ingroup PkgAreaProjectionTransformIO
/// returns the values converted to another type.
/// \param values the values
template <class Scalar>
std::vector<Scalar> converted(const Typed_values& values)
{
  return std::visit(
      [](const auto& v) {
        std::vector<Scalar> result;
        result.reserve(v.size());
        for(const auto value : v)
          result.push_back(static_cast<Scalar>(value));
        return result;
      },
      values);
}

} // namespace IO
} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_IO_TYPED_VALUES_H
