// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_IO_CENTERLINES_SWC_H
#define CGAL_AREA_PROJECTION_TRANSFORM_IO_CENTERLINES_SWC_H

#include <CGAL/Area_projection_transform/IO/number_text.h>
#include <CGAL/Area_projection_transform/centerlines/Centerline_graph.h>
#include <CGAL/Area_projection_transform/internal/atomic_file.h>

#include <cmath>
#include <cstddef>
#include <ostream>
#include <string>
#include <vector>

namespace CGAL {
namespace Area_projection {
namespace IO {

/// \cond SKIP_IN_MANUAL
namespace internal {

/// writes a graph as trees: of each edge that would close a cycle the end appears again, as a leaf.
class Swc_writer
{
public:
  Swc_writer(const Centerline_graph& graph, std::ostream& out)
      : m_graph(graph), m_out(out), m_sample(num_vertices(graph), none)
  {}

  void write()
  {
    for(std::size_t root : nodes(m_graph))
      if(m_sample[root] == none)
        write_tree(root);
  }

private:
  static constexpr long none = -1;

  struct Step
  {
    std::size_t from, to;
  };

  void write_tree(std::size_t root)
  {
    m_sample[root] = write_sample(root, none);
    std::vector<Step> steps = steps_from(root, root);
    while(!steps.empty()) {
      const Step step = steps.back();
      steps.pop_back();
      if(m_sample[step.to] != none) {
        // Seen from its other end, the edge is there already.
        if(m_sample[step.to] < m_sample[step.from])
          write_sample(step.to, m_sample[step.from]);
        continue;
      }
      m_sample[step.to] = write_sample(step.to, m_sample[step.from]);
      for(const Step& next : steps_from(step.to, step.from))
        steps.push_back(next);
    }
  }

  std::vector<Step> steps_from(std::size_t vertex, std::size_t parent) const
  {
    std::vector<Step> steps;
    const auto [first, last] = boost::adjacent_vertices(vertex, m_graph);
    bool came = parent == vertex;
    for(auto v = first; v != last; ++v) {
      if(!came && *v == parent)
        came = true; // once: two edges to the parent are a cycle
      else
        steps.push_back({vertex, *v});
    }
    return steps;
  }

  long write_sample(std::size_t v, long parent)
  {
    constexpr int undefined = 0; // of the kinds of neurites
    const Centerline_vertex& vertex = m_graph[v];
    const double radius = std::isfinite(vertex.radius) ? vertex.radius : 0;
    m_out << IO::to_text(++m_last) << ' ' << undefined << ' ' << IO::to_text(vertex.point.x())
          << ' ' << IO::to_text(vertex.point.y()) << ' ' << IO::to_text(vertex.point.z()) << ' '
          << IO::to_text(radius) << ' ' << IO::to_text(parent) << '\n';
    return m_last;
  }

  const Centerline_graph& m_graph;
  std::ostream& m_out;
  std::vector<long> m_sample; // of each vertex
  long m_last = 0;
};

} // namespace internal
/// \endcond

/// \ingroup PkgAreaProjectionTransformIO
/// \brief writes centrelines in the format of traced neurons (`.swc`): a sample `id type x y z radius parent` for each
/// vertex, parents first; the type is 0, undefined; the parent of a root is -1.
///
/// The format has trees only: where a graph has a cycle, one vertex of it appears a second time, as a leaf at the same
/// place. A radius that is unknown is 0.
/// \param file_name the file; replaced as a whole, if it exists
/// \param graph the lines
/// \throw Output_error if the file cannot be written; nothing is left of it then
inline void write_centerlines_SWC(const std::string& file_name, const Centerline_graph& graph)
{
  internal::Atomic_file file(file_name);
  file.stream() << "# id type x y z radius parent\n";
  internal::Swc_writer(graph, file.stream()).write();
  file.commit();
}

} // namespace IO
} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_IO_CENTERLINES_SWC_H
