// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MAPT_RETRIEVE_FILES_H
#define MAPT_RETRIEVE_FILES_H

#include <CGAL/Area_projection_transform/IO/shape_descriptors_CSV.h>
#include <CGAL/Area_projection_transform/retrieval/Distance_matrix.h>
#include <CGAL/Area_projection_transform/retrieval/evaluation.h>

#include <string>
#include <vector>

namespace mapt {

namespace AP = CGAL::Area_projection;

/// \throw Input_error if the table cannot be used
AP::IO::Named_descriptors read_descriptors(const std::string& file);

/// the classes of shapes. Of those that have none there is a warning: their number is returned.
/// \throw Input_error if the labels cannot be used
AP::Class_labels read_labels(const std::string& file, const std::vector<std::string>& names);

/// writes .csv, with names, or .f32.
/// \throw Output_error if it cannot be written
void write_distances(const std::string& file, const std::vector<std::string>& names,
                     const AP::Distance_matrix& distances);

/// writes precision over recall by both conventions: of all queries, whose class is empty, and of each class.
/// \throw Output_error if it cannot be written
void write_precision_recall(const std::string& file, const AP::Relevant_ranks& ranks,
                            const AP::Class_labels& labels, std::size_t smallest_class);

} // namespace mapt

#endif // MAPT_RETRIEVE_FILES_H
