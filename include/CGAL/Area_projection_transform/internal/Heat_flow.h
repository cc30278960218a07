// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_HEAT_FLOW_H
#define CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_HEAT_FLOW_H

#include <CGAL/Area_projection_transform/Kernel.h>

#include <Eigen/SparseCore>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL {
namespace Area_projection {
namespace internal {

/// \brief the flow of heat on a surface that is cut into cells: a cell has an area, and a link between two
/// cells a conductance.
///
/// A link of conductance `w` carries `w` times the difference of its ends. Conductances have no unit:
/// between two squares side by side it is 1.
class Heat_flow
{
public:
  using Vectors = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;

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
  Heat_flow(const std::vector<double>& areas, Links&& links)
      : m_areas(Eigen::Map<const Eigen::VectorXd>(areas.data(), Eigen::Index(areas.size())))
      , m_stiffness(Eigen::Index(areas.size()), Eigen::Index(areas.size()))
  {
    for(std::size_t i = 0; i < areas.size(); ++i)
      links.m_entries.emplace_back(std::int32_t(i), std::int32_t(i), links.m_of_cells[i]);
    m_stiffness.setFromTriplets(links.m_entries.begin(), links.m_entries.end());
    // So that a cell without area takes the value of its neighbours.
    if(!areas.empty())
      m_areas =
          m_areas.cwiseMax(std::max(1e-12 * m_areas.mean(), std::numeric_limits<double>::min()));
  }

  /// \brief returns what becomes of `values` in `time`, in squared units of length, by one implicit step:
  /// the solution of `(areas + time · links) x = areas · values`.
  ///
  /// The mean over the surface is kept. In the plane a point spreads to a variance of `2 time` along each
  /// axis.
  /// \param largest_error the root of the mean, over the surface, of the squared error of the solution
  /// \throw std::runtime_error if the solver does not converge.
  ///
  /// Complexity: linear in the number of cells and links, times the number of cells across `sqrt(time)`.
  Vectors diffused(const Vectors& values, double time, double largest_error) const
  {
    if(values.rows() == 0)
      return values;
    Matrix system = time * m_stiffness;
    // What changes is found rather than the result: so that values may be far from zero.
    Vectors change = system * values;
    system.diagonal() += m_areas;
    change = solve(system, -change, largest_error);
    return values + change;
  }

private:
  using Matrix = Eigen::SparseMatrix<double, Eigen::RowMajor, std::int32_t>;
  using Columns = Eigen::Array<double, 1, 3>;

  static constexpr int most_steps = 10000;

  static Columns dot(const Vectors& u, const Vectors& v)
  {
    return u.cwiseProduct(v).colwise().sum().array();
  }

  /// where nothing is left to divide, there is nothing left to do.
  static Columns ratio(const Columns& numerator, const Columns& denominator)
  {
    return (denominator > 0).select(numerator / denominator, 0.);
  }

  /// \brief the method of conjugate gradients for three right hand sides at once, which read the matrix
  /// together.
  ///
  /// Since the system is the areas and something positive, its solution is no farther off than the
  /// residual over the areas.
  Vectors solve(const Matrix& system, const Vectors& right, double largest_error) const
  {
    const Eigen::VectorXd inverse = system.diagonal().cwiseInverse();
    const Eigen::VectorXd weight = m_areas.cwiseMax(0.01 * m_areas.mean()).cwiseInverse();
    const double target = largest_error * largest_error * m_areas.sum();
    Vectors x = Vectors::Zero(right.rows(), 3), residual = right;
    Vectors scaled = inverse.asDiagonal() * residual;
    Vectors direction = scaled, image(x.rows(), 3);
    Columns energy = dot(residual, scaled);
    for(int step = 0; (dot(residual, weight.asDiagonal() * residual) > target).any(); ++step) {
      if(step == most_steps)
        throw std::runtime_error("the smoothing of the surface does not converge in " +
                                 std::to_string(step) + " steps: remove degenerate faces");
      image.noalias() = system * direction;
      const Columns length = ratio(energy, dot(direction, image));
      x += direction * length.matrix().asDiagonal();
      residual -= image * length.matrix().asDiagonal();
      scaled = inverse.asDiagonal() * residual;
      const Columns before = energy;
      energy = dot(residual, scaled);
      direction = scaled + direction * ratio(energy, before).matrix().asDiagonal();
    }
    return x;
  }

  Eigen::VectorXd m_areas;
  Matrix m_stiffness;
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
