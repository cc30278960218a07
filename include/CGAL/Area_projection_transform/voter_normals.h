// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_VOTER_NORMALS_H
#define CGAL_AREA_PROJECTION_TRANSFORM_VOTER_NORMALS_H

#include <CGAL/Area_projection_transform/Covariance_3.h>
#include <CGAL/Area_projection_transform/Kernel.h>
#include <CGAL/Area_projection_transform/Side.h>
#include <CGAL/Area_projection_transform/Surfels.h>
#include <CGAL/Area_projection_transform/at_points.h>
#include <CGAL/Area_projection_transform/internal/symmetric_eigen.h>
#include <CGAL/Area_projection_transform/internal/to_text.h>
#include <CGAL/Area_projection_transform/projection/Sampled_evaluator.h>
#include <CGAL/Area_projection_transform/scales.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Area_projection {

/// \ingroup PkgAreaProjectionTransformRidges
/// \brief the normals of the surface that is projected into a ball (of the voters), as a structure tensor.
struct Voter_normals
{
  /// the integral of `n nᵀ` over the surface that is projected into the ball, in squared units of length
  Covariance_3 moments;

  /// the area that is projected into the ball: that of the transform.
  double area() const { return moments.trace(); }

  /// \brief the shares of the three main directions, the smallest first; they sum to 1.
  ///
  /// 0, 1/2, 1/2 for a tube; 1/3 each for a sphere; 0, 0, 1 for two walls. All zero if there is no voter.
  std::array<double, 3> shares() const
  {
    if(!(area() > 0))
      return {0, 0, 0};
    std::array<double, 3> shares = internal::eigenvalues_by_magnitude((1 / area()) * moments);
    for(double& share : shares) // that is zero, but for rounding
      share = std::max(share, 0.);
    std::sort(shares.begin(), shares.end());
    return shares;
  }

  /// \brief the axis of a tube: a unit vector, of either sign, in the direction to which the normals are most
  /// nearly perpendicular.
  ///
  /// Where the two smallest `shares()` are about the same, it means nothing.
  Vector_3 axis() const { return internal::direction_of_smallest(moments); }
};

/// \cond SKIP_IN_MANUAL
namespace internal {

/// \brief finds the normals of the voters of any ball, at one radius.
///
/// The tensor is known from the integrals of `(u·n)²` for the six axes `u` of an icosahedron, since for them
/// `Σ (uᵀMu) u uᵀ = (4/5) M + (2/5) trace(M)` and `Σ uᵀMu = 2 trace(M)`. These are areas, so that what sums
/// areas in balls, exactly and in any order, sums tensors as well.
class Voter_normals_evaluator
{
public:
  template <class Source>
  Voter_normals_evaluator(const Source& surface, double radius, Side side, double spacing)
  {
    std::array<Projected_surfels, 6> projected;
    surface.for_each_batch(spacing, [&](const Surfels& batch) {
      for(std::size_t s = 0; s < batch.size(); ++s)
        for(std::size_t i = 0; i < 6; ++i) {
          const double cosine = axis(i) * batch.normals[s];
          projected[i].push_back(batch.positions[s] +
                                     signed_distance(side, radius) * batch.normals[s],
                                 batch.areas[s] * cosine * cosine);
        }
    });
    for(Projected_surfels& surfels : projected)
      m_sums.emplace_back(std::move(surfels));
  }

  Voter_normals operator()(const Point_3& point, double sigma) const
  {
    Covariance_3 sum;
    double trace = 0;
    for(std::size_t i = 0; i < 6; ++i) {
      const double area = m_sums[i](point, sigma);
      sum.add(axis(i), axis(i), 1.25 * area);
      trace += 0.5 * area;
    }
    return {sum + Covariance_3{-0.5 * trace, 0, 0, -0.5 * trace, 0, -0.5 * trace}};
  }

private:
  static Vector_3 axis(std::size_t i)
  {
    static const double a = std::sqrt(0.5 - std::sqrt(0.05)), b = std::sqrt(0.5 + std::sqrt(0.05));
    const double s = i % 2 == 0 ? a : -a;
    return i / 2 == 0 ? Vector_3(s, b, 0) : i / 2 == 1 ? Vector_3(0, s, b) : Vector_3(b, 0, s);
  }

  std::vector<Sampled_evaluator> m_sums;
};

} // namespace internal
/// \endcond

/// \ingroup PkgAreaProjectionTransformRidges
/// \brief returns the normals of the surface that is projected into each of some balls: a source of directions
/// other than the Hessian of the map (`vesselness()`).
///
/// It needs no derivatives and no lattice, so that it stands noise better, and tells tubes, walls and spheres from
/// each other. It is computed where it is asked for, not for all voxels: those for whose direction
/// somebody asks are few, and a map of tensors would take as much memory as twelve maps.
///
/// \tparam ConcurrencyTag `CGAL::Sequential_tag`, `CGAL::Parallel_tag` or
/// `CGAL::Parallel_if_available_tag`; the result has the same bits for any number of threads and any order of the
/// faces
/// \tparam Source `Triangle_surface` or `Surfels`
/// \param surface the surface
/// \param queries the balls: places, radii and `σ`, in the units of the surface
/// \param side the side on which it is projected
/// \param sampling_ratio the spacing of the samples of the surface, in units of the smallest `σ` of each radius, in
/// (0, 1]; 0.15 by default
/// \throw std::invalid_argument if a radius, a `σ` or `sampling_ratio` is not positive, or the ratio more than 1.
///
/// Complexity: for each radius `O(n log n)` for `n` samples, and for each query six searches as those of
/// `Sampled_evaluator`. Memory: some 300 bytes for each sample of the surface.
template <class ConcurrencyTag = CGAL::Sequential_tag, class Source>
std::vector<Voter_normals> voter_normals(const Source& surface, const std::vector<Query>& queries,
                                         Side side = Side::INSIDE,
                                         double sampling_ratio = default_sampling_ratio)
{
  internal::check_positive(sampling_ratio, "sampling_ratio");
  if(sampling_ratio > 1)
    throw std::invalid_argument("sampling_ratio is " + internal::to_text(sampling_ratio) +
                                ": must be at most 1");
  std::vector<Voter_normals> result(queries.size());
  internal::evaluate_by_radius<ConcurrencyTag>(
      queries,
      [&](const Scale& scale) {
        return internal::Voter_normals_evaluator(surface, scale.radius, side,
                                                 sampling_ratio * scale.sigma);
      },
      [&](std::size_t q, const internal::Voter_normals_evaluator& evaluator) {
        result[q] = evaluator(queries[q].point, queries[q].scale.sigma);
      });
  return result;
}

} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_VOTER_NORMALS_H
