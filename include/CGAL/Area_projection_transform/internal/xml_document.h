// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_XML_DOCUMENT_H
#define CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_XML_DOCUMENT_H

#include <CGAL/Area_projection_transform/IO/number_text.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// \cond SKIP_IN_MANUAL
namespace CGAL {
namespace Area_projection {
namespace IO {
namespace internal {

/// replaces the characters that have a meaning in XML.
inline std::string xml_escaped(std::string_view text)
{
  std::string result;
  for(char c : text)
    switch(c) {
    case '&':
      result += "&amp;";
      break;
    case '<':
      result += "&lt;";
      break;
    case '>':
      result += "&gt;";
      break;
    case '"':
      result += "&quot;";
      break;
    default:
      result += c;
    }
  return result;
}

/// puts back the characters that `xml_escaped()` and other writers replace.
inline std::string xml_unescaped(std::string_view text)
{
  struct Entity
  {
    std::string_view name;
    char character;
  };
  constexpr Entity entities[] = {
      {"&amp;", '&'}, {"&lt;", '<'}, {"&gt;", '>'}, {"&quot;", '"'}, {"&apos;", '\''}};
  std::string result;
  while(!text.empty()) {
    const auto entity =
        std::find_if(std::begin(entities), std::end(entities),
                     [&](const Entity& e) { return text.substr(0, e.name.size()) == e.name; });
    const bool is_entity = entity != std::end(entities);
    result += is_entity ? entity->character : text.front();
    text.remove_prefix(is_entity ? entity->name.size() : 1);
  }
  return result;
}

/// an element of an XML document; it refers to the text it was read from.
struct Xml_element
{
  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  struct Attribute
  {
    std::string_view name;
    std::string_view value;
  };

  std::string_view name;
  std::string_view text; ///< the one piece of text that is not blank
  std::vector<Attribute> attributes;
  std::size_t first_child = none;
  std::size_t next_sibling = none;

  std::optional<std::string> attribute(std::string_view wanted) const
  {
    for(const Attribute& a : attributes)
      if(a.name == wanted)
        return xml_unescaped(a.value);
    return std::nullopt;
  }
};

/// \brief the elements of an XML document up to a given one.
///
/// Reads what VTK writes: elements, attributes, text, comments; no document type, no CDATA. A
/// general XML library will not do: the data that VTK appends to the document are no XML, text of
/// hundreds of megabytes is not to be copied, and deep nesting must not exhaust the stack.
class Xml_document
{
public:
  /// \brief reads `text`, which must outlive the document, to the end of the root element or to
  /// the start of an element called `last`.
  /// \throw std::runtime_error with the number of the line.
  Xml_document(std::string_view text, std::string_view last) : m_text(text), m_last(last)
  {
    if(m_text.substr(0, 3) == "\xEF\xBB\xBF")
      m_position = 3;
    while(!m_is_complete)
      read_text_and_tag();
  }

  const Xml_element& root() const { return m_elements.front(); }

  /// the element called `last`, if there is one, and what comes after its start tag.
  const Xml_element* last() const { return m_has_last ? &m_elements.back() : nullptr; }
  std::string_view rest() const { return m_text.substr(m_position); }

  /// the first child and the next element with the same parent, or null.
  const Xml_element* first_child(const Xml_element& parent) const { return at(parent.first_child); }
  const Xml_element* next(const Xml_element& element) const { return at(element.next_sibling); }

  /// the first child of that name, or null.
  const Xml_element* child(const Xml_element& parent, std::string_view name) const
  {
    return find(parent.first_child, name);
  }

  /// the next element of that name after `element` with the same parent, or null.
  const Xml_element* next(const Xml_element& element, std::string_view name) const
  {
    return find(element.next_sibling, name);
  }

private:
  static constexpr std::size_t most_elements = 1000000;

  const Xml_element* at(std::size_t index) const
  {
    return index == Xml_element::none ? nullptr : &m_elements[index];
  }

  const Xml_element* find(std::size_t index, std::string_view name) const
  {
    while(index != Xml_element::none && m_elements[index].name != name)
      index = m_elements[index].next_sibling;
    return at(index);
  }

  void read_text_and_tag()
  {
    const std::size_t tag = m_text.find('<', m_position);
    if(tag == std::string_view::npos)
      fail(m_elements.empty()
               ? "is not XML"
               : "ends early: element " + in_quotes(m_elements[m_open.back().index].name) +
                     " is not closed");
    add_text(trim(m_text.substr(m_position, tag - m_position)));
    m_position = tag;
    if(starts_with("<!--"))
      skip_past("-->");
    else if(starts_with("<?"))
      skip_past("?>");
    else if(starts_with("<!"))
      fail("has a document type or CDATA section, which are not supported");
    else if(starts_with("</"))
      read_end_tag();
    else
      read_start_tag();
  }

  void add_text(std::string_view text)
  {
    if(text.empty())
      return;
    if(m_open.empty())
      fail("is not XML");
    Xml_element& element = m_elements[m_open.back().index];
    if(!element.text.empty())
      fail("the text of element " + in_quotes(element.name) + " is interrupted");
    element.text = text;
  }

  void read_end_tag()
  {
    m_position += 2;
    const std::string_view name = read_name();
    if(m_open.empty() || m_elements[m_open.back().index].name != name)
      fail("the end tag " + in_quotes(name) + " matches no start tag");
    skip_blanks();
    expect('>');
    m_open.pop_back();
    m_is_complete = m_open.empty();
  }

  void read_start_tag()
  {
    m_position += 1;
    Xml_element element;
    element.name = read_name();
    for(skip_blanks(); !starts_with(">") && !starts_with("/>"); skip_blanks())
      element.attributes.push_back(read_attribute());
    const bool is_empty = starts_with("/>");
    m_position += is_empty ? 2 : 1;
    m_has_last = element.name == m_last;
    append(std::move(element));
    if(!is_empty && !m_has_last)
      m_open.push_back({m_elements.size() - 1, Xml_element::none});
    m_is_complete = m_open.empty() || m_has_last;
  }

  void append(Xml_element&& element)
  {
    const std::size_t index = m_elements.size();
    if(index == most_elements)
      fail("has more than " + std::to_string(most_elements) + " elements");
    if(!m_open.empty()) {
      Open& parent = m_open.back();
      (parent.last_child == Xml_element::none ? m_elements[parent.index].first_child
                                              : m_elements[parent.last_child].next_sibling) = index;
      parent.last_child = index;
    }
    m_elements.push_back(std::move(element));
  }

  Xml_element::Attribute read_attribute()
  {
    Xml_element::Attribute attribute;
    attribute.name = read_name();
    skip_blanks();
    expect('=');
    skip_blanks();
    const char quote = starts_with("'") ? '\'' : '"';
    expect(quote);
    const std::size_t end = m_text.find(quote, m_position);
    attribute.value = m_text.substr(m_position, end - m_position);
    if(end == std::string_view::npos || attribute.value.find('<') != std::string_view::npos)
      fail("the value of attribute " + in_quotes(attribute.name) + " is not closed");
    m_position = end + 1;
    return attribute;
  }

  std::string_view read_name()
  {
    const std::size_t end =
        std::min(m_text.find_first_of(" \t\r\n=<>/\"'", m_position), m_text.size());
    const std::string_view name = m_text.substr(m_position, end - m_position);
    if(name.empty())
      fail("is not well-formed: a name is missing");
    m_position = end;
    return name;
  }

  bool starts_with(std::string_view text) const
  {
    return m_text.substr(m_position, text.size()) == text;
  }

  void skip_blanks()
  {
    while(m_position < m_text.size() && is_blank(m_text[m_position]))
      ++m_position;
  }

  void skip_past(std::string_view text)
  {
    const std::size_t found = m_text.find(text, m_position);
    if(found == std::string_view::npos)
      fail("ends early: '" + std::string(text) + "' is missing");
    m_position = found + text.size();
  }

  void expect(char c)
  {
    if(m_position >= m_text.size() || m_text[m_position] != c)
      fail(std::string("is not well-formed: '") + c + "' is missing");
    ++m_position;
  }

  [[noreturn]] void fail(const std::string& cause) const
  {
    const auto line = 1 + std::count(m_text.begin(), m_text.begin() + m_position, '\n');
    throw std::runtime_error("line " + std::to_string(line) + ": " + cause);
  }

  struct Open
  {
    std::size_t index;
    std::size_t last_child;
  };

  std::string_view m_text;
  std::string_view m_last;
  std::size_t m_position = 0;
  bool m_is_complete = false;
  bool m_has_last = false;
  std::vector<Open> m_open;
  std::vector<Xml_element> m_elements;
};

} // namespace internal
} // namespace IO
} // namespace Area_projection
} // namespace CGAL
/// \endcond

#endif // CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_XML_DOCUMENT_H
