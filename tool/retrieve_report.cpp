// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "retrieve_report.h"

#include "text.h"

#include <algorithm>
#include <cstdio>

namespace mapt {

namespace {

using Json = nlohmann::ordered_json;

Json to_json(const AP::Retrieval_scores& scores)
{
  return {{"NN", scores.nearest_neighbor}, {"FT", scores.first_tier},
          {"ST", scores.second_tier},      {"E", scores.e_measure},
          {"DCG", scores.discounted_gain}, {"E_ceiling", scores.e_ceiling}};
}

std::string filled(const std::string& text, std::size_t width)
{
  return text + std::string(text.size() < width ? width - text.size() : 0, ' ');
}

std::string columns(const AP::Retrieval_scores& scores)
{
  std::string line;
  for(const double value : {scores.nearest_neighbor, scores.first_tier, scores.second_tier,
                            scores.e_measure, scores.e_ceiling, scores.discounted_gain}) {
    char text[16];
    std::snprintf(text, sizeof text, "%8.4f", value);
    line += text;
  }
  return line;
}

} // namespace

void report_scores(const AP::Retrieval_evaluation& evaluation, Console& console)
{
  console.report.update(to_json(evaluation.micro));
  console.report["macro"] = to_json(evaluation.macro);
  console.report["queries"] = evaluation.number_of_queries;
  Json& classes = console.report["classes"] = Json::object();
  std::size_t width = std::string("mean of classes").size();
  for(const AP::Class_scores& c : evaluation.classes) {
    classes[c.name] = to_json(c.scores);
    classes[c.name]["queries"] = c.number_of_queries;
    width = std::max(width, c.name.size());
  }
  console.line("");
  console.line(filled("", width) + "      NN      FT      ST       E  (most)     DCG  queries");
  const auto line = [&](const std::string& name, const AP::Retrieval_scores& scores,
                        std::size_t queries) {
    console.line(filled(name, width) + columns(scores) + "  " + std::to_string(queries));
  };
  line("mean of queries", evaluation.micro, evaluation.number_of_queries);
  line("mean of classes", evaluation.macro, evaluation.number_of_queries);
  for(const AP::Class_scores& c : evaluation.classes)
    line(c.name, c.scores, c.number_of_queries);
}

void report_neighbours(const std::string& query, const std::vector<AP::Neighbor>& neighbours,
                       const std::vector<std::string>& names, const AP::Class_labels& labels,
                       Console& console)
{
  console.line("");
  console.line("Nearest to " + query + ":");
  Json list = Json::array();
  for(const AP::Neighbor& n : neighbours) {
    Json entry{{"file", names[n.index]}, {"distance", n.distance}};
    std::string text = filled(to_text(n.distance), 12) + names[n.index];
    if(labels.size() > 0 && labels[n.index] != AP::Class_labels::none) {
      entry["class"] = labels.name(labels[n.index]);
      text += "  (" + labels.name(labels[n.index]) + ")";
    }
    console.line(text);
    list.push_back(std::move(entry));
  }
  console.report["neighbours"].push_back({{"query", query}, {"neighbours", std::move(list)}});
}

} // namespace mapt
