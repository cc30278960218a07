// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "retrieve_files.h"

#include "input.h"
#include "map_file.h"
#include "progress.h"

#include <CGAL/Area_projection_transform/IO/CSV.h>
#include <CGAL/Area_projection_transform/IO/class_labels.h>
#include <CGAL/Area_projection_transform/IO/float_matrix.h>
#include <CGAL/Area_projection_transform/internal/atomic_file.h>
#include <CGAL/Area_projection_transform/retrieval/precision_recall.h>

#include <exception>
#include <new>
#include <utility>

namespace mapt {

namespace {

// What readers of the library throw has the file and the defect in it.
template <class Read>
auto read_guarded(const std::string& file, const Read& read)
{
  try {
    return read();
  } catch(const std::bad_alloc&) {
    throw Input_error(file + ": does not fit into the memory");
  } catch(const std::invalid_argument& error) {
    throw Input_error(file + ": " + error.what());
  } catch(const std::runtime_error& error) {
    throw Input_error(error.what());
  }
}

void write_curve(AP::IO::CSV_writer& table, const std::string& name,
                 const AP::Precision_recall& without, const AP::Precision_recall& with)
{
  const auto precision = [&table](const AP::Precision_recall& curve, std::size_t i) {
    if(curve.numbers_of_queries[i] > 0)
      table.field(curve.precisions[i]);
    else
      table.field("");
  };
  for(std::size_t i = 0; i < without.recalls.size(); ++i) {
    table.field(name).field(without.recalls[i]);
    precision(without, i);
    table.field(without.numbers_of_queries[i]);
    precision(with, i);
    table.field(with.numbers_of_queries[i]);
    table.end_row();
  }
}

} // namespace

AP::IO::Named_descriptors read_descriptors(const std::string& file)
{
  return read_guarded(file, [&] {
    // The table does not tell its blocks; a distance that wants them is told.
    AP::IO::Named_descriptors read = AP::IO::read_shape_descriptors_CSV(file, 1);
    if(read.names.empty())
      throw std::runtime_error(file + ": has no row: describe meshes with mapt describe first");
    return read;
  });
}

AP::Class_labels read_labels(const std::string& file, const std::vector<std::string>& names)
{
  return read_guarded(file,
                      [&] { return AP::IO::labels_of(names, AP::IO::read_class_labels(file)); });
}

void write_distances(const std::string& file, const std::vector<std::string>& names,
                     const AP::Distance_matrix& distances)
{
  if(extension_of(file) == ".f32") {
    AP::IO::write_float_matrix(file, distances);
    return;
  }
  AP::IO::internal::Atomic_file output(file);
  AP::IO::CSV_writer table(output.stream());
  table.field("file");
  for(const std::string& name : names)
    table.field(name);
  table.end_row();
  for(std::size_t i = 0; i < names.size(); ++i) {
    Signal_watch::check(); // one that came meanwhile leaves nothing behind
    table.field(names[i]);
    for(std::size_t j = 0; j < names.size(); ++j)
      table.field(distances[i][j]);
    table.end_row();
  }
  output.commit();
}

void write_precision_recall(const std::string& file, const AP::Relevant_ranks& ranks,
                            const AP::Class_labels& labels, std::size_t smallest_class)
{
  AP::IO::internal::Atomic_file output(file);
  AP::IO::CSV_writer table(output.stream());
  table.row("class", "recall", "precision", "queries", "precision_with_query",
            "queries_with_query");
  const auto write = [&](const std::string& name, const auto& is_query) {
    write_curve(table, name, AP::precision_recall(ranks, is_query, AP::Query_counts::NO),
                AP::precision_recall(ranks, is_query, AP::Query_counts::YES));
  };
  const auto is_large = [&](std::size_t c) { return labels.size_of_class(c) >= smallest_class; };
  write("", [&](std::size_t i) { return is_large(labels[i]); });
  for(std::size_t c = 0; c < labels.number_of_classes(); ++c)
    if(is_large(c))
      write(labels.name(c), [&](std::size_t i) { return labels[i] == c; });
  output.commit();
}

} // namespace mapt
