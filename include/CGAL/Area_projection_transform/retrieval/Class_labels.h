// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_RETRIEVAL_CLASS_LABELS_H
#define CGAL_AREA_PROJECTION_TRANSFORM_RETRIEVAL_CLASS_LABELS_H

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <unordered_map>
#include <vector>

namespace CGAL {
namespace Area_projection {

/// \ingroup PkgAreaProjectionTransformRetrieval
/// \brief which class each of some shapes belongs to.
class Class_labels
{
public:
  /// the class of a shape that has none: it is found by others, and is wrong then.
  static constexpr std::uint32_t none = ~std::uint32_t(0);

  Class_labels() = default;

  /// \param class_of_shape for each shape the name of its class; empty: it has none
  explicit Class_labels(const std::vector<std::string>& class_of_shape)
  {
    for(const std::string& name : class_of_shape)
      push_back(name);
  }

  /// \brief adds a shape. Classes are numbered in the order in which they come.
  /// \param class_name its class; empty if it has none
  void push_back(const std::string& class_name)
  {
    if(class_name.empty()) {
      m_classes.push_back(none);
      return;
    }
    const auto [place, is_new] = m_numbers.emplace(class_name, std::uint32_t(m_names.size()));
    if(is_new) {
      m_names.push_back(class_name);
      m_sizes.push_back(0);
    }
    ++m_sizes[place->second];
    m_classes.push_back(place->second);
  }

  /// the number of shapes.
  std::size_t size() const { return m_classes.size(); }
  /// the number of the class of a shape.
  std::uint32_t operator[](std::size_t shape) const { return m_classes[shape]; }

  /// the number of classes.
  std::size_t number_of_classes() const { return m_names.size(); }
  /// the name of a class.
  const std::string& name(std::size_t class_number) const { return m_names[class_number]; }
  /// how many shapes a class has.
  std::size_t size_of_class(std::size_t class_number) const { return m_sizes[class_number]; }

private:
  std::vector<std::uint32_t> m_classes;
  std::vector<std::string> m_names;
  std::vector<std::size_t> m_sizes;
  std::unordered_map<std::string, std::uint32_t> m_numbers;
};

} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_RETRIEVAL_CLASS_LABELS_H
