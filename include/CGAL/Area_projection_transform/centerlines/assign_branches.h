// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_CENTERLINES_ASSIGN_BRANCHES_H
#define CGAL_AREA_PROJECTION_TRANSFORM_CENTERLINES_ASSIGN_BRANCHES_H

#include <CGAL/Area_projection_transform/centerlines/Centerline_graph.h>
#include <CGAL/Area_projection_transform/centerlines/Line_samples.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Area_projection {
namespace internal {

/// \brief gives each face, or point, to the branch that most of its samples belong to.
/// \param branch_of_sample or -1
/// \param sources the elements of the input, in the order of those of `samples`
inline void assign_branches(const Line_samples& samples,
                            const std::vector<std::int32_t>& branch_of_sample,
                            const std::vector<std::uint32_t>& sources,
                            std::vector<Centerline_branch>& branches)
{
  std::size_t element = 0;
  std::vector<std::int32_t> votes;
  samples.for_each_element([&](const std::uint32_t* begin, const std::uint32_t* end) {
    votes.clear();
    for(const std::uint32_t* i = begin; i != end; ++i)
      votes.push_back(branch_of_sample[*i]);
    std::sort(votes.begin(), votes.end());
    std::int32_t best = -1;
    std::ptrdiff_t most = 0;
    for(auto first = votes.begin(); first != votes.end();) {
      const auto last = std::upper_bound(first, votes.end(), *first);
      if(last - first > most) {
        most = last - first;
        best = *first;
      }
      first = last;
    }
    if(best >= 0)
      branches[std::size_t(best)].voters.push_back(sources[element]);
    ++element;
  });
  for(Centerline_branch& branch : branches) {
    std::sort(branch.voters.begin(), branch.voters.end());
    branch.voters.erase(std::unique(branch.voters.begin(), branch.voters.end()),
                        branch.voters.end());
  }
}

} // namespace internal
} // namespace Area_projection
} // namespace CGAL

#endif // CGAL_AREA_PROJECTION_TRANSFORM_CENTERLINES_ASSIGN_BRANCHES_H
