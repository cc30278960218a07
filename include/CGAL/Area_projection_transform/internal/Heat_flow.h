// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_HEAT_FLOW_H
#define CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_HEAT_FLOW_H

#include <CGAL/Area_projection_transform/Kernel.h>
#include <CGAL/Area_projection_transform/internal/Cell_hierarchy.h>
#include <CGAL/Area_projection_transform/internal/Implicit_step.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Area_projection {
namespace internal {

/// \brief the flow of heat on a surface that is cut into cells: a cell has an area, and a link
/// between two cells a conductance.
///
/// A link of conductance `w` carries `w` times the difference of its ends. Conductances have no unit:
/// between two squares side by side it is 1.
class Heat_flow
{
public:
  using Vectors = Cell_vectors;

  /// the links between the cells, each told once.
  class Links
  {
  public:
    explicit Links(std::size_t cells) : m_of_cells(cells, 0.) {}

    void add(std::size_t i, std::size_t j, double conductance)
    {
      m_entries.emplace_back(std::int32_t(i), std::int32_t(j), -conductance);
      m_entries.emplace_back(std::int32_t(j), std::int32_t(i), -conductance);
      m_of_cells[i] += conductance;
      m_of_cells[j] += conductance;
    }

  private:
    friend class Heat_flow;
    std::vector<double> m_of_cells; ///< the sum at each cell
    std::vector<Eigen::Triplet<double, std::int32_t>> m_entries;
  };

  /// \param areas not negative; one for each cell
  /// \param cell_of the cell of each element: several may share one; empty if each has its own
  /// \throw std::invalid_argument if there are 2^31 links or more, counted at both ends, with the
  /// cells.
  Heat_flow(const std::vector<double>& areas, Links&& links, std::vector<std::size_t> cell_of = {})
      : m_cells(linked_cells(areas, std::move(links))), m_cell_of(std::move(cell_of))
  {}

  /// \brief returns what becomes of the `values` of the elements in `time`, in squared units of
  /// length, by one implicit step: the solution of `(areas + time · links) x = areas · values`.
  ///
  /// Elements that share a cell have the mean of their values. The mean over the surface is kept.
  /// In the plane a point spreads to a variance of `2 time` along each axis.
  /// \param largest_error the root of the mean, over the surface, of the squared error of each
  /// column of the solution, as far as can be estimated; not less than about a millionth of the
  /// differences of the values
  /// \throw std::runtime_error if the solver does not converge.
  ///
  /// Complexity: linear in the number of cells and links.
  Vectors diffused(const Vectors& values, double time, double largest_error) const
  {
    if(values.rows() == 0)
      return values;
    if(m_cell_of.empty())
      return diffused_between_cells(values, time, largest_error);
    return of_elements(diffused_between_cells(of_cells(values), time, largest_error));
  }

private:
  Vectors diffused_between_cells(const Vectors& values, double time, double largest_error) const
  {
    // By then all is even, on rods and strips, too; and the solver works in floats.
    time = std::min(time, 1e6 * m_cells.levels().front().areas.sum());
    // What changes is found rather than the result: so that values may be far from zero.
    const Vectors change = -time * (m_cells.levels().front().conductances * values);
    return values + Implicit_step(m_cells, time, largest_error).solve(change);
  }

  /// the means of the values of the elements of each cell.
  Vectors of_cells(const Vectors& values) const
  {
    const Eigen::Index number = m_cells.levels().front().size();
    Vectors means = Vectors::Zero(number, 3);
    Eigen::VectorXd elements = Eigen::VectorXd::Zero(number);
    for(std::size_t i = 0; i < m_cell_of.size(); ++i) {
      means.row(Eigen::Index(m_cell_of[i])) += values.row(Eigen::Index(i));
      ++elements[Eigen::Index(m_cell_of[i])];
    }
    return elements.cwiseMax(1).cwiseInverse().asDiagonal() * means;
  }

  Vectors of_elements(const Vectors& values) const
  {
    Vectors result(Eigen::Index(m_cell_of.size()), 3);
    for(std::size_t i = 0; i < m_cell_of.size(); ++i)
      result.row(Eigen::Index(i)) = values.row(Eigen::Index(m_cell_of[i]));
    return result;
  }

  static Linked_cells linked_cells(const std::vector<double>& areas, Links&& links)
  {
    const Eigen::Index number = Eigen::Index(areas.size());
    for(std::size_t i = 0; i < areas.size(); ++i)
      links.m_entries.emplace_back(std::int32_t(i), std::int32_t(i), links.m_of_cells[i]);
    if(links.m_entries.size() > std::size_t(std::numeric_limits<std::int32_t>::max()))
      throw std::invalid_argument("the surface has " + std::to_string(areas.size()) +
                                  " elements: too many to be smoothed");
    Linked_cells cells{
        Eigen::Map<const Eigen::VectorXd>(areas.data(), number), Sparse_matrix(number, number), {}};
    cells.conductances.setFromTriplets(links.m_entries.begin(), links.m_entries.end());
    // So that a cell without area takes the value of its neighbours.
    const double mean = number > 0 ? cells.areas.mean() : 0;
    cells.areas = cells.areas.cwiseMax(mean > 0 ? 1e-12 * mean : 1);
    return cells;
  }

  Cell_hierarchy m_cells;
  std::vector<std::size_t> m_cell_of;
};

inline void set_row(Heat_flow::Vectors& vectors, std::size_t i, const Vector_3& v)
{
  vectors.row(Eigen::Index(i)) << v.x(), v.y(), v.z();
}

inline Vector_3 row(const Heat_flow::Vectors& vectors, std::size_t i)
{
  const auto r = vectors.row(Eigen::Index(i));
  return Vector_3(r[0], r[1], r[2]);
}

} // namespace internal
} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_HEAT_FLOW_H
