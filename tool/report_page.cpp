// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "report_page.h"

#include "file_elements.h"
#include "page_arrays.h"
#include "report_template.h"
#include "salient_report.h"
#include "shown_mesh.h"

#include <CGAL/Area_projection_transform/internal/atomic_file.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <stdexcept>
#include <string_view>

namespace mapt {

namespace {

using Json = nlohmann::ordered_json;

Json surface_json(const Shown_mesh& mesh, const Input& input, Page_arrays& arrays)
{
  std::vector<std::uint32_t> corners;
  for(const auto& triangle : mesh.triangles)
    corners.insert(corners.end(), triangle.begin(), triangle.end());
  Json json;
  json["points"] = arrays.add_points(mesh.points);
  json["triangles"] = arrays.add_integers(corners, 3);
  json["joined_within"] = mesh.joined_within;
  std::vector<AP::Point_3> holes;
  for(const Segment& edge : holes_of(input))
    holes.insert(holes.end(), edge.begin(), edge.end());
  json["holes"] = arrays.add_points(holes);
  return json;
}

// The value of a map at a voxel, 0 where it is not of interest.
float value_at(const std::vector<float>& values, const AP::Row_spans& region, int i, int j, int k)
{
  return region.contains(i, j, k) ? values[region.index(i, j, k)] : 0.f;
}

// A map with 8 bits for a voxel: `largest` is 255. Of every `stride` voxels along an axis one is kept.
Json map_json(const std::vector<float>& values, const AP::Row_spans& region, int stride,
              Page_arrays& arrays)
{
  std::array<int, 3> size = region.grid().size();
  for(int& length : size)
    length = (length + stride - 1) / stride;
  std::vector<float> kept;
  for(int k = 0; k < size[2]; ++k)
    for(int j = 0; j < size[1]; ++j)
      for(int i = 0; i < size[0]; ++i)
        kept.push_back(value_at(values, region, stride * i, stride * j, stride * k));
  const float largest = *std::max_element(kept.begin(), kept.end());
  std::vector<std::uint8_t> voxels;
  for(const float value : kept)
    voxels.push_back(std::uint8_t(largest > 0 ? std::lround(255 * value / largest) : 0));
  return {{"largest", largest},
          {"stride", stride},
          {"voxels", arrays.add_voxels(std::move(voxels), size)}};
}

// The balls that collect are so large for large radii that every second voxel shows all there is to see.
int stride_of(const AP::Scale& scale, double voxel)
{
  return scale.sigma >= 4 * voxel ? 2 : 1;
}

Json maps_json(const Report_results& results, Page_arrays& arrays)
{
  const AP::Joint_map& joint = results.maps.joint;
  Json json;
  json["joint"] = map_json(joint.values(), joint.region(), 1, arrays);
  json["of_radii"] = Json::array();
  for(std::size_t k = 0; k < joint.scales().size(); ++k) {
    const AP::Scale& scale = joint.scales()[k];
    Json map = map_json(results.maps.of_scales->maps()[k], joint.region(),
                        stride_of(scale, joint.grid().spacing()), arrays);
    map["radius"] = scale.radius;
    map["sigma"] = scale.sigma;
    json["of_radii"].push_back(map);
  }
  return json;
}

Json lines_json(const AP::Centerline_graph& graph, Page_arrays& arrays)
{
  std::vector<AP::Point_3> points;
  std::vector<float> radii;
  Json branches = Json::array();
  for(const AP::Centerline_branch& branch : AP::branches(graph)) {
    branches.push_back({{"points", branch.vertices.size()},
                        {"length", branch.length},
                        {"mean_radius", branch.mean_radius},
                        {"score", branch.score}});
    for(const std::size_t v : branch.vertices) {
      points.push_back(graph[v].point);
      radii.push_back(float(graph[v].radius));
    }
  }
  return {{"branches", branches},
          {"points", arrays.add_points(points)},
          {"radii", arrays.add_floats(radii)}};
}

Json medial_json(const Shown_balls& shown, Page_arrays& arrays)
{
  std::vector<AP::Point_3> centers;
  std::vector<float> radii, importance, mapt;
  for(const AP::Medial_ball& ball : shown.balls) {
    centers.push_back(ball.refitted_center);
    radii.push_back(float(ball.refitted_radius));
    importance.push_back(float(AP::weight_of(ball, AP::Medial_weight::IMPORTANCE)));
    mapt.push_back(float(ball.mapt));
  }
  return {{"found", shown.found},
          {"points", arrays.add_points(centers)},
          {"radii", arrays.add_floats(radii)},
          {"importance", arrays.add_floats(importance)},
          {"mapt", arrays.add_floats(mapt)}};
}

Json descriptor_json(const Report_results& results)
{
  if(!results.descriptor)
    return {{"missing", results.no_descriptor}};
  const AP::Shape_descriptor& descriptor = *results.descriptor;
  Json radii = Json::array();
  for(const AP::Scale& scale : descriptor.scales)
    radii.push_back(scale.radius);
  return {{"values", descriptor.values},
          {"bins", descriptor.block_size},
          {"radii", radii},
          {"largest_value", AP::Shape_descriptor_options().largest_value},
          {"reference_length", descriptor.reference_length},
          {"volume", descriptor.volume},
          {"coverage", descriptor.coverage},
          {"voxels", descriptor.number_of_voxels}};
}

std::string name_of(const Input& input)
{
  return std::filesystem::path(input.file).filename().string();
}

// Pages are given away: where the file was is nobody's business.
std::string without_folder(const std::string& warning, const Input& input)
{
  const bool names_file = warning.compare(0, input.file.size(), input.file) == 0;
  return names_file ? name_of(input) + warning.substr(input.file.size()) : warning;
}

Json page_json(const Input& input, const Shown_mesh& mesh, const Report_results& results,
               const Report_options& options, const Json& report, Page_arrays& arrays)
{
  Json json = report;
  json["name"] = name_of(input);
  json["input"]["file"] = name_of(input);
  for(Json& warning : json["warnings"])
    warning = without_folder(warning, input);
  json["is_point_set"] = input.is_point_set;
  json["surface"] = surface_json(mesh, input, arrays);
  json["maps"] = maps_json(results, arrays);
  json["salient"] = results.salient ? to_json(*results.salient) : Json();
  json["lines"] = results.lines ? lines_json(*results.lines, arrays) : Json();
  json["medial"] = results.medial ? medial_json(*results.medial, arrays) : Json();
  json["descriptor"] = options.has("descriptor") ? descriptor_json(results) : Json();
  json["lattice"] = arrays.lattice();
  return json;
}

// JSON that may stand in a script element: names of files are text of others, and "</script>" in one would
// end it.
std::string for_script(const Json& json)
{
  const std::string text = json.dump(-1, ' ', true, Json::error_handler_t::replace);
  std::string result;
  for(const char c : text)
    if(c == '<')
      result += "\\u003c";
    else
      result += c;
  return result;
}

// Writes the template with `texts` in the places of their names.
std::size_t fill_template(std::ostream& stream,
                          const std::vector<std::pair<std::string_view, std::string>>& texts)
{
  std::string_view rest = report_template();
  std::size_t bytes = 0;
  const auto write = [&](std::string_view text) {
    stream.write(text.data(), std::streamsize(text.size()));
    bytes += text.size();
  };
  for(const auto& [name, text] : texts) {
    const std::size_t place = rest.find(name);
    if(place == std::string_view::npos)
      throw std::logic_error("the template of the page has no place for its data");
    write(rest.substr(0, place));
    write(text);
    rest.remove_prefix(place + name.size());
  }
  write(rest);
  return bytes;
}

} // namespace

Page_summary write_page(const Input& input, const Report_results& results,
                        const Report_options& options, const Json& report)
{
  const Shown_mesh mesh = shown_mesh(input, options.most_faces);
  Page_arrays arrays(input.report.bounding_box);
  const std::string json = for_script(page_json(input, mesh, results, options, report, arrays));
  Page_summary summary;
  summary.faces = mesh.triangles.size();
  AP::IO::internal::Atomic_file file(options.output);
  summary.bytes =
      fill_template(file.stream(), {{"@MAPT_REPORT@", json}, {"@MAPT_ARRAYS@", arrays.encoded()}});
  file.commit();
  return summary;
}

} // namespace mapt
