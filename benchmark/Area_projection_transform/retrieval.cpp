// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The ten nearest of many shapes, by comparing with all of them and by the index; and descriptors of meshes.

#include "benchmark_projectors.h"
#include "benchmark_suite.h"

#include <CGAL/Area_projection_transform/retrieval.h>
#include <CGAL/Area_projection_transform/shape_descriptor.h>

#include <CGAL/Random.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

namespace Benchmarks {

namespace {

using Histogram = std::vector<float>;

constexpr std::size_t blocks = 8, bins = 12, wanted = 10, number_of_queries = 50;

/// histograms as those of maps are: each radius falls off from its first bin on, some faster, some slower.
Histogram random_histogram(CGAL::Random& random)
{
  Histogram result;
  for(std::size_t block = 0; block < blocks; ++block) {
    const double decay = random.get_double(0.2, 2);
    std::vector<double> values(bins);
    double sum = 0;
    for(std::size_t b = 0; b < bins; ++b)
      sum += values[b] = std::exp(-decay * double(b)) * random.get_double(0.2, 1);
    for(double value : values)
      result.push_back(float(value / sum / double(blocks)));
  }
  return result;
}

/// \brief classes of shapes that differ in a few ways, as poses do, and in every number a little, as meshes do.
class Corpus
{
public:
  Corpus(std::size_t classes, unsigned seed) : m_random(seed)
  {
    for(std::size_t c = 0; c < classes; ++c)
      for(std::size_t i = 0; i < 1 + ways; ++i)
        m_ends.push_back(random_histogram(m_random));
  }

  Histogram shape()
  {
    const std::size_t c =
        (1 + ways) * std::size_t(m_random.get_int(0, int(m_ends.size() / (1 + ways))));
    std::vector<double> shares(1 + ways);
    shares[0] = 1;
    for(std::size_t w = 1; w <= ways; ++w)
      shares[0] -= shares[w] = m_random.get_double(0, 0.05);
    Histogram result(blocks * bins, 0.f);
    for(std::size_t i = 0; i < result.size(); ++i) {
      for(std::size_t w = 0; w <= ways; ++w)
        result[i] += float(shares[w]) * m_ends[c + w][i];
      result[i] *= float(m_random.get_double(0.98, 1.02));
    }
    return result;
  }

  AP::Descriptor_table table(std::size_t size)
  {
    AP::Descriptor_table result(blocks * bins, bins);
    result.reserve(size);
    while(result.size() < size)
      result.push_back(shape());
    return result;
  }

private:
  static constexpr std::size_t ways = 4;
  CGAL::Random m_random;
  std::vector<Histogram> m_ends; // of each class its middle, and those it varies towards
};

void compare_searches(Group& group, std::size_t shapes)
{
  Corpus corpus(50, 1);
  const AP::Descriptor_table table = corpus.table(shapes),
                             queries = corpus.table(number_of_queries);
  Comparison comparison =
      group.comparison("ten nearest", {{"shapes", shapes}, {"queries", number_of_queries}});
  for(const auto& [name, kind] : {std::pair("Jeffrey", AP::Distance_kind::JEFFREY),
                                  std::pair("root of JS", AP::Distance_kind::JENSEN_SHANNON)}) {
    const AP::Histogram_distance distance(kind, table.dimension(), bins);
    const auto index = std::make_shared<AP::Metric_index>(table, distance);
    std::size_t comparisons = 0;
    for(std::size_t q = 0; q < queries.size(); ++q)
      index->nearest(queries[q], wanted, &comparisons);
    comparison.add(std::string("nearest_by_scan, ") + name, [&, distance] {
      for(std::size_t q = 0; q < queries.size(); ++q)
        keep(AP::nearest_by_scan(table, distance, queries[q], wanted).size());
    });
    Row& row = comparison.add(std::string("Metric_index, ") + name, [&, index] {
      for(std::size_t q = 0; q < queries.size(); ++q)
        keep(index->nearest(queries[q], wanted).size());
    });
    row.measures.emplace_back("compared", double(comparisons) / double(queries.size() * shapes));
  }
  comparison.run();
}

void describe_meshes(Group& group)
{
  const std::vector<std::pair<std::string, AP::Descriptor_normals>> modes{
      {"face", AP::Descriptor_normals::FACE},
      {"interpolated", AP::Descriptor_normals::INTERPOLATED},
      {"subdivided", AP::Descriptor_normals::SUBDIVIDED},
      {"averaged", AP::Descriptor_normals::AVERAGED},
      {"smoothed", AP::Descriptor_normals::SMOOTHED}};
  for(const std::string& file : group.options().meshes) {
    const Mesh mesh = read_mesh(file);
    Comparison comparison =
        group.comparison("shape_descriptor",
                         {{"mesh", name_of_mesh(file)}, {"vertices", mesh.number_of_vertices()}});
    for(const auto& [name, normals] : modes) {
      AP::Shape_descriptor_options options;
      options.normals = normals;
      comparison.add(name, [&mesh, options] { keep(AP::shape_descriptor(mesh, options).volume); });
    }
    comparison.run();
  }
}

void retrieval(Group& group)
{
  describe_meshes(group);
  const std::vector<std::size_t> sizes =
      group.pick<std::vector<std::size_t>>({1000}, {1000, 10000}, {1000, 10000, 100000, 300000});
  for(std::size_t shapes : sizes)
    compare_searches(group, shapes);
}

const Registered_group registered("retrieval",
                                  "Descriptors of meshes, with all kinds of normals; and the ten "
                                  "nearest of many shapes to each of fifty, by "
                                  "comparing with all of them, which stops where a shape is too "
                                  "far, and by Metric_index, which finds the same. The "
                                  "shapes are made up: fifty classes that vary in four ways, and "
                                  "in every number by two percent. Compared is the "
                                  "fraction of the shapes that the index compares with.",
                                  retrieval);

} // namespace

} // namespace Benchmarks
