// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_IO_CLASS_LABELS_H
#define CGAL_AREA_PROJECTION_TRANSFORM_IO_CLASS_LABELS_H

#include <CGAL/Area_projection_transform/IO/CSV.h>
#include <CGAL/Area_projection_transform/IO/number_text.h>
#include <CGAL/Area_projection_transform/internal/whole_file.h>
#include <CGAL/Area_projection_transform/retrieval/Class_labels.h>

#include <cstddef>
#include <filesystem>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Area_projection {
namespace IO {

/// \ingroup PkgAreaProjectionTransformIO
/// \brief the classes of shapes by their names, as a file tells them.
struct Label_list
{
  std::vector<std::pair<std::string, std::string>>
      classes; ///< a shape and its class, in the order of the file
  bool has_numbers =
      false; ///< shapes are numbers, which stand at the end of the names of their files
};

/// \cond SKIP_IN_MANUAL
namespace internal {

/// reads the classification of the Princeton shape benchmark.
class Cla_reader
{
public:
  Cla_reader(std::string_view text, const std::string& name) : m_text(text), m_name(name) {}

  Label_list read()
  {
    if(next("PSB") != "PSB" || next("the version of the format") != "1")
      fail("does not begin with 'PSB 1'");
    const std::size_t classes = number("the number of classes");
    const std::size_t shapes = number("the number of shapes");
    Label_list list;
    list.has_numbers = true;
    for(std::size_t c = 0; c < classes; ++c) {
      const std::string name = next("the name of a class");
      next("the parent of a class"); // levels above the finest do not matter
      const std::size_t members = number("the number of shapes of a class");
      for(std::size_t i = 0; i < members; ++i)
        list.classes.emplace_back(next("a shape of a class"), name);
    }
    if(list.classes.size() != shapes)
      fail("says that there are " + std::to_string(shapes) + " shapes, and lists " +
           std::to_string(list.classes.size()));
    if(const std::string_view rest = next_word(m_text); !rest.empty())
      fail("goes on after the last class with " + in_quotes(rest));
    return list;
  }

private:
  [[noreturn]] void fail(const std::string& cause) const
  {
    throw std::runtime_error(m_name + ": " + cause);
  }

  std::string next(const char* what)
  {
    const std::string_view word = next_word(m_text);
    if(word.empty())
      fail("ends before " + std::string(what));
    return std::string(word);
  }

  std::size_t number(const char* what)
  {
    const std::string word = next(what);
    std::size_t value = 0;
    if(!from_text(word, value))
      fail(std::string(what) + " is " + in_quotes(word) + ": not a whole number");
    return value;
  }

  std::string_view m_text;
  const std::string& m_name;
};

inline Label_list read_labels_CSV(const std::string& text, const std::string& name)
{
  std::istringstream in(text);
  CSV_reader reader(in, name);
  std::vector<std::string> fields;
  Label_list list;
  if(!reader.read(fields))
    reader.fail("is empty: the first line must name the columns file, class");
  if(fields.size() < 2 || fields[0] != "file" || fields[1] != "class")
    reader.fail("the first line must name the columns file, class");
  while(reader.read(fields)) {
    if(fields.size() < 2 || fields[0].empty())
      reader.fail("a shape and its class are expected");
    list.classes.emplace_back(fields[0], fields[1]);
  }
  return list;
}

/// the number at the end of a name, without leading zeros; empty if there is none.
inline std::string number_at_end(const std::string& name)
{
  std::size_t begin = name.size();
  while(begin > 0 && name[begin - 1] >= '0' && name[begin - 1] <= '9')
    --begin;
  while(begin + 1 < name.size() && name[begin] == '0')
    ++begin;
  return name.substr(begin);
}

} // namespace internal
/// \endcond

/// \ingroup PkgAreaProjectionTransformIO
/// \brief reads classes of shapes: a table of comma-separated values with a shape and its class in a row, after a first
/// line that names these columns `file` and `class`; or the classification of the Princeton shape benchmark (`.cla`), which begins
/// with `PSB 1`.
/// \param file_name the file
/// \throw std::runtime_error if the file cannot be read, or is neither; its text names the defect
inline Label_list read_class_labels(const std::string& file_name)
{
  const std::string text = internal::read_whole_file(file_name);
  std::string_view rest = text;
  if(internal::next_word(rest) == "PSB")
    return internal::Cla_reader(text, file_name).read();
  return internal::read_labels_CSV(text, file_name);
}

/// \ingroup PkgAreaProjectionTransformIO
/// \brief returns the classes of some shapes by the names of their files.
///
/// A shape is looked up by its whole name, the name without folders, and that without extension, in this order; in a
/// list of numbers by the number at the end of the latter. One that is not in the list has no class.
/// \param shapes the names of the shapes, in the order of the labels that are wanted
/// \param list the labels that were read
/// \throw std::invalid_argument if the list has two classes for a shape
inline Class_labels labels_of(const std::vector<std::string>& shapes, const Label_list& list)
{
  std::unordered_map<std::string, std::string> class_of;
  for(const auto& [shape, name] : list.classes)
    if(const auto [place, is_new] = class_of.emplace(shape, name); !is_new && place->second != name)
      throw std::invalid_argument("list has two classes for " + shape + ": " + place->second +
                                  " and " + name);
  Class_labels labels;
  for(const std::string& shape : shapes) {
    const std::filesystem::path path(shape);
    std::vector<std::string> keys{shape, path.filename().string(), path.stem().string()};
    if(list.has_numbers)
      keys.push_back(internal::number_at_end(keys.back()));
    std::string name;
    for(std::size_t k = 0; k < keys.size() && name.empty(); ++k)
      if(const auto found = class_of.find(keys[k]); found != class_of.end())
        name = found->second;
    labels.push_back(name);
  }
  return labels;
}

} // namespace IO
} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_IO_CLASS_LABELS_H
