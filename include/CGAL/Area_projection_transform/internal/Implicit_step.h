// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_IMPLICIT_STEP_H
#define CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_IMPLICIT_STEP_H

#include <CGAL/Area_projection_transform/internal/Cell_hierarchy.h>

#include <Eigen/Core>

#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL {
namespace Area_projection {
namespace internal {

/// three values for each cell.
using Cell_vectors = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;

/// \brief solves `(areas + time · conductances) x = b` by conjugate gradients, preconditioned by a cycle over
/// the levels of a hierarchy: the number of steps hardly depends on the number of cells and on the time.
class Implicit_step
{
public:
  Implicit_step(const Cell_hierarchy& cells, double time)
  {
    for(const Linked_cells& level : cells.levels()) {
      m_levels.push_back({level.areas, time * level.conductances, {}, level.parents});
      Level& last = m_levels.back();
      // With the sum of the absolute values of a row instead of its diagonal, no eigenvalue exceeds 1,
      // whatever the signs of the links.
      Eigen::VectorXd sums = level.areas;
      double ratio = 0;
      for(Eigen::Index i = 0; i < level.size(); ++i) {
        for(Sparse_matrix::InnerIterator entry(last.system, i); entry; ++entry)
          sums[i] += std::abs(entry.value());
        ratio += sums[i] / level.areas[i];
      }
      last.system.diagonal() += level.areas;
      last.relaxation = (4. / 3) * sums.cwiseInverse();
      // Where areas outweigh links, relaxation alone is enough.
      if(ratio < 4 * double(level.size()))
        break;
    }
  }

  /// \param largest_error the root of the mean squared error over the surface
  /// \throw std::runtime_error if the solution is not found.
  Cell_vectors solve(const Cell_vectors& b, double largest_error) const
  {
    const Sparse_matrix& system = m_levels.front().system;
    const double target = largest_error * largest_error * m_levels.front().areas.sum();
    const Cell_vectors nothing = Cell_vectors::Zero(b.rows(), 3);
    Cell_vectors x = nothing, residual = b;
    Cell_vectors correction = cycle(0, residual);
    Cell_vectors direction = correction, image(b.rows(), 3);
    // The error in the energy of the system, which exceeds that in the mean over the surface.
    Triple energy = dot(residual, correction);
    for(int step = 0; (energy.array() > target).any(); ++step) {
      if(step == most_steps)
        throw std::runtime_error("the smoothing of the surface does not converge in " +
                                 std::to_string(step) + " steps: remove degenerate faces");
      for_each_residual(system, direction, nothing,
                        [&](Eigen::Index i, const Triple& r) { image.row(i) = -r; });
      const Triple length = ratio(energy, dot(direction, image));
      for(Eigen::Index i = 0; i < b.rows(); ++i) {
        x.row(i) += length.cwiseProduct(direction.row(i));
        residual.row(i) -= length.cwiseProduct(image.row(i));
      }
      correction = cycle(0, residual);
      const Triple before = energy;
      energy = dot(residual, correction);
      const Triple kept = ratio(energy, before);
      for(Eigen::Index i = 0; i < b.rows(); ++i)
        direction.row(i) = correction.row(i) + kept.cwiseProduct(direction.row(i));
    }
    return x;
  }

private:
  using Triple = Eigen::RowVector3d;

  struct Level
  {
    const Eigen::VectorXd& areas;
    Sparse_matrix system;
    Eigen::VectorXd relaxation;
    const std::vector<std::int32_t>& parents;
  };

  static constexpr int most_steps = 1000;
  static constexpr int sweeps_on_coarsest = 5; // and one before

  static Triple dot(const Cell_vectors& u, const Cell_vectors& v)
  {
    Triple sum = Triple::Zero();
    for(Eigen::Index i = 0; i < u.rows(); ++i)
      sum += u.row(i).cwiseProduct(v.row(i));
    return sum;
  }

  /// where nothing is left to divide, there is nothing left to do.
  static Triple ratio(const Triple& numerator, const Triple& denominator)
  {
    return (denominator.array() > 0).select(numerator.cwiseQuotient(denominator), 0.);
  }

  /// calls `function(i, (b - system · x) of cell i)` for each cell.
  template <class Function>
  static void for_each_residual(const Sparse_matrix& system, const Cell_vectors& x,
                                const Cell_vectors& b, Function&& function)
  {
    for(Eigen::Index i = 0; i < b.rows(); ++i) {
      Triple r = b.row(i);
      for(Sparse_matrix::InnerIterator entry(system, i); entry; ++entry)
        r -= entry.value() * x.row(entry.col());
      function(i, r);
    }
  }

  /// \brief an approximate solution, by relaxation on the level and a correction from the coarser ones;
  /// linear and symmetric in `b`, as the gradients need it.
  Cell_vectors cycle(std::size_t l, const Cell_vectors& b) const
  {
    const Level& level = m_levels[l];
    const bool is_coarsest = l + 1 == m_levels.size();
    Cell_vectors x = level.relaxation.asDiagonal() * b, relaxed(b.rows(), 3);
    if(!is_coarsest) {
      Cell_vectors sums = Cell_vectors::Zero(m_levels[l + 1].areas.size(), 3);
      for_each_residual(level.system, x, b, [&](Eigen::Index i, const Triple& r) {
        sums.row(level.parents[std::size_t(i)]) += r;
      });
      const Cell_vectors correction = cycle(l + 1, sums);
      for(Eigen::Index i = 0; i < b.rows(); ++i)
        x.row(i) += correction.row(level.parents[std::size_t(i)]);
    }
    for(int sweep = 0; sweep < (is_coarsest ? sweeps_on_coarsest : 1); ++sweep) {
      for_each_residual(level.system, x, b, [&](Eigen::Index i, const Triple& r) {
        relaxed.row(i) = x.row(i) + level.relaxation[i] * r;
      });
      x.swap(relaxed);
    }
    return x;
  }

  std::vector<Level> m_levels;
};

} // namespace internal
} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_IMPLICIT_STEP_H
