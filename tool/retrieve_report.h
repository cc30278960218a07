// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MAPT_RETRIEVE_REPORT_H
#define MAPT_RETRIEVE_REPORT_H

#include "console.h"

#include <CGAL/Area_projection_transform/retrieval/Metric_index.h>
#include <CGAL/Area_projection_transform/retrieval/evaluation.h>

#include <string>
#include <vector>

namespace mapt {

namespace AP = CGAL::Area_projection;

/// tells the scores, in the mean and of each class.
void report_scores(const AP::Retrieval_evaluation& evaluation, Console& console);

/// tells which shapes are nearest to one.
/// \param labels may be empty: then classes are not told
void report_neighbours(const std::string& query, const std::vector<AP::Neighbor>& neighbours,
                       const std::vector<std::string>& names, const AP::Class_labels& labels,
                       Console& console);

} // namespace mapt

#endif // MAPT_RETRIEVE_REPORT_H
