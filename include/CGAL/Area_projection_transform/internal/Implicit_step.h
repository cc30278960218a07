// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_IMPLICIT_STEP_H
#define CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_IMPLICIT_STEP_H

#include <CGAL/Area_projection_transform/internal/Cell_hierarchy.h>

#include <Eigen/Core>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL {
namespace Area_projection {
namespace internal {

/// three values for each cell.
using Cell_vectors = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;

/// \brief solves `(areas + time · conductances) x = b` by conjugate gradients, preconditioned by a
/// cycle over the levels of a hierarchy: the number of steps hardly depends on the number of cells
/// and on the time.
///
/// Works in floats, with the mean area of a cell and the error that is allowed as units, and with four
/// columns, of which the last is zero: a row is what a processor adds at once.
class Implicit_step
{
public:
  using Vectors = Eigen::Matrix<float, Eigen::Dynamic, 4, Eigen::RowMajor>;

  /// \param largest_error the root of the mean squared error of each column of the solution over
  /// the surface; not less than about a millionth of what is in the solution, or floats cannot tell
  Implicit_step(const Cell_hierarchy& cells, double time, double largest_error)
      : m_unit_of_area(cells.levels().front().areas.mean()), m_largest_error(largest_error)
  {
    for(const Linked_cells& level : cells.levels()) {
      m_levels.emplace_back(level, 1 / m_unit_of_area, time / m_unit_of_area);
      if(m_levels.back().is_dominated_by_areas())
        break;
    }
  }

  /// \brief returns the solution.
  ///
  /// The error is estimated, not bounded. Measured, it is at most what is allowed on meshes, noisy
  /// ones and those that lack most of their faces, too, at any time; up to four times that on wires
  /// and needles much thinner than the deviation.
  /// \throw std::runtime_error if the solution is not found.
  Cell_vectors solve(const Cell_vectors& b) const
  {
    const Level& finest = m_levels.front();
    Vectors residual = Vectors::Zero(b.rows(), 4);
    residual.leftCols<3>() = (b / (m_unit_of_area * m_largest_error)).cast<float>();
    const double target = double(b.rows()); // an error of 1 over the area
    Vectors x = Vectors::Zero(b.rows(), 4), correction = approximate(residual);
    Vectors direction = correction, image(b.rows(), 4);
    // The energy of the error is `residual · (solution of the residual)`, for which the cycle is
    // taken: it is the sum of the square of the error over the surface, and of `time` times that of
    // its slope.
    Numbers energy = dot(residual, correction);
    for(int step = 0; !(energy <= target).all(); ++step) {
      if(step == most_steps || !energy.isFinite().all())
        throw std::runtime_error("the smoothing of the surface does not converge in " +
                                 std::to_string(step) + " steps: remove degenerate faces");
      finest.for_each_image(
          direction, [&](Eigen::Index i, const Row& image_of_i) { image.row(i) = image_of_i; });
      const Row length = ratio(energy, dot(direction, image));
      for(Eigen::Index i = 0; i < b.rows(); ++i) {
        x.row(i) += length.cwiseProduct(direction.row(i));
        residual.row(i) -= length.cwiseProduct(image.row(i));
      }
      correction = approximate(residual);
      const Numbers before = energy;
      energy = dot(residual, correction);
      const Row kept = ratio(energy, before);
      for(Eigen::Index i = 0; i < b.rows(); ++i)
        direction.row(i) = correction.row(i) + kept.cwiseProduct(direction.row(i));
    }
    return m_largest_error * x.leftCols<3>().cast<double>();
  }

  /// \brief returns an approximate solution, by one cycle, in the units of the finest level.
  ///
  /// As the gradients need it, it is linear in `b`, symmetric and positive definite, whatever the
  /// signs of the links: relaxation never takes a cell more than 4/3 of the way, so that one sweep
  /// before and one after a correction that is positive definite are, too, and so is an even number
  /// of sweeps alone.
  Vectors approximate(const Vectors& b) const { return cycle(0, b); }

private:
  using Row = Eigen::Matrix<float, 1, 4>;
  using Numbers = Eigen::Array<double, 1, 4>;

  static constexpr int most_steps = 1000;
  static constexpr int sweeps_on_coarsest = 5; // and one before: an even number in all

  /// the system of a level: areas, and links that carry the difference of their ends.
  class Level
  {
  public:
    Level(const Linked_cells& cells, double area_factor, double link_factor)
        : m_cells(cells), m_areas((area_factor * cells.areas).cast<float>())
    {
      const Eigen::Index number = cells.size();
      m_first_link.reserve(std::size_t(number) + 1);
      m_relaxation.resize(number);
      const std::size_t links = std::size_t(cells.conductances.nonZeros() - number);
      m_ends.reserve(links);
      m_strengths.reserve(links);
      double sum_of_ratios = 0;
      Eigen::Index number_linked = 0;
      for(Eigen::Index i = 0; i < number; ++i) {
        m_first_link.push_back(std::uint32_t(m_ends.size()));
        double sum = 0, sum_of_absolutes = 0;
        for(Sparse_matrix::InnerIterator link(cells.conductances, i); link; ++link)
          if(link.col() != i) {
            const double strength = -link_factor * link.value();
            m_ends.push_back(link.col());
            m_strengths.push_back(float(strength));
            sum += strength;
            sum_of_absolutes += std::abs(strength);
          }
        // Divided by the sum of the absolute values of its row instead of its diagonal, the system
        // has no eigenvalue beyond 1, whatever the signs of the links.
        const double area = area_factor * cells.areas[i];
        m_relaxation[i] = float(4. / 3 / (area + std::abs(sum) + sum_of_absolutes));
        sum_of_ratios += sum_of_absolutes / area;
        number_linked += sum_of_absolutes > 0 ? 1 : 0;
      }
      m_first_link.push_back(std::uint32_t(m_ends.size()));
      m_is_dominated_by_areas = sum_of_ratios <= 2 * double(number_linked);
    }

    Eigen::Index size() const { return m_areas.size(); }

    /// whether the links are so weak that relaxation alone is enough.
    bool is_dominated_by_areas() const { return m_is_dominated_by_areas; }

    /// calls `function(i, parent)` for each cell that is a part of a cell of the next level.
    template <class Function>
    void for_each_parent(Function&& function) const
    {
      for(Eigen::Index i = 0; i < size(); ++i)
        if(m_cells.parents[std::size_t(i)] != Linked_cells::no_parent)
          function(i, Eigen::Index(m_cells.parents[std::size_t(i)]));
    }

    float relaxation(Eigen::Index i) const { return m_relaxation[i]; }

    /// calls `function(i, (system · x) of cell i)` for each cell.
    template <class Function>
    void for_each_image(const Vectors& x, Function&& function) const
    {
      for(Eigen::Index i = 0; i < size(); ++i) {
        const Row here = x.row(i);
        Row image = m_areas[i] * here;
        for(std::uint32_t l = m_first_link[std::size_t(i)]; l < m_first_link[std::size_t(i) + 1];
            ++l)
          image += m_strengths[l] * (here - x.row(m_ends[l]));
        function(i, image);
      }
    }

  private:
    const Linked_cells& m_cells;
    Eigen::VectorXf m_areas, m_relaxation;
    std::vector<std::uint32_t> m_first_link;
    std::vector<std::int32_t> m_ends;
    std::vector<float> m_strengths;
    bool m_is_dominated_by_areas;
  };

  static Numbers dot(const Vectors& u, const Vectors& v)
  {
    Numbers sum = Numbers::Zero();
    for(Eigen::Index i = 0; i < u.rows(); ++i)
      sum += u.row(i).cwiseProduct(v.row(i)).array().cast<double>();
    return sum;
  }

  /// where nothing is left to divide, there is nothing left to do.
  static Row ratio(const Numbers& numerator, const Numbers& denominator)
  {
    return (denominator > 0).select(numerator / denominator, 0.).cast<float>();
  }

  /// an approximate solution, by relaxation on the level and a correction from the coarser ones.
  Vectors cycle(std::size_t l, const Vectors& b) const
  {
    const Level& level = m_levels[l];
    const bool is_coarsest = l + 1 == m_levels.size();
    Vectors x(b.rows(), 4), relaxed(b.rows(), 4);
    for(Eigen::Index i = 0; i < b.rows(); ++i)
      x.row(i) = level.relaxation(i) * b.row(i);
    if(!is_coarsest) {
      level.for_each_image(
          x, [&](Eigen::Index i, const Row& image) { relaxed.row(i) = b.row(i) - image; });
      Vectors sums = Vectors::Zero(m_levels[l + 1].size(), 4);
      level.for_each_parent(
          [&](Eigen::Index i, Eigen::Index parent) { sums.row(parent) += relaxed.row(i); });
      const Vectors correction = cycle(l + 1, sums);
      level.for_each_parent(
          [&](Eigen::Index i, Eigen::Index parent) { x.row(i) += correction.row(parent); });
    }
    for(int sweep = 0; sweep < (is_coarsest ? sweeps_on_coarsest : 1); ++sweep) {
      level.for_each_image(x, [&](Eigen::Index i, const Row& image) {
        relaxed.row(i) = x.row(i) + level.relaxation(i) * (b.row(i) - image);
      });
      x.swap(relaxed);
    }
    return x;
  }

  double m_unit_of_area, m_largest_error;
  std::vector<Level> m_levels;
};

} // namespace internal
} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_INTERNAL_IMPLICIT_STEP_H
