// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "scale_options.h"

#include "command_line.h"
#include "errors.h"
#include "text.h"

#include <CGAL/Area_projection_transform/default_scales.h>

#include <algorithm>
#include <cmath>

namespace mapt {

namespace AP = CGAL::Area_projection;

namespace {

constexpr std::size_t most_scales = 255; // a joint map holds no more

[[noreturn]] void fail_for_number(double number)
{
  throw Usage_error(to_text(number, 9) + " radii are too many: at most " +
                    std::to_string(most_scales) + " fit into a map; raise --radius-step");
}

std::vector<double> uniform_radii(const Scale_options& options, double smallest, double largest)
{
  // A rounding error must not cost the last radius.
  const double fitting = std::floor((largest - smallest) / *options.step * (1 + 1e-12)) + 1;
  const double number = options.number ? double(*options.number) : fitting;
  if(number > double(most_scales))
    fail_for_number(number);
  return AP::uniform_radii(smallest, *options.step, std::size_t(number));
}

std::vector<double> geometric_radii(const Scale_options& options, double smallest, double largest)
{
  if(options.number)
    return AP::geometric_radii(smallest, largest, *options.number);
  const double steps =
      std::ceil(std::log(largest / smallest) / std::log(1 + options.sigma_ratio / 2));
  if(steps + 1 > double(most_scales))
    fail_for_number(steps + 1);
  return AP::geometric_radii(smallest, largest, std::size_t(steps) + 1);
}

std::vector<double> choose_radii(const Scale_options& options, const CGAL::Bbox_3& box,
                                 double voxel)
{
  if(!options.radii.empty()) {
    std::vector<double> radii = options.radii;
    std::sort(radii.begin(), radii.end());
    const auto twice = std::adjacent_find(radii.begin(), radii.end());
    if(twice != radii.end())
      throw Usage_error("--radii: " + to_text(*twice, 9) + " is there twice");
    return radii;
  }
  const std::vector<double> radii = AP::default_radii(box, voxel, options.sigma_ratio);
  if(!options.smallest && !options.largest && !options.step && !options.number)
    return radii;
  const double smallest =
      options.smallest.value_or(std::min(radii.front(), options.largest.value_or(radii.front())));
  const double largest = options.largest.value_or(std::max(radii.back(), smallest));
  if(smallest > largest)
    throw Usage_error("--radius-min is " + to_text(smallest, 9) + ": larger than --radius-max, " +
                      to_text(largest, 9));
  if(smallest == largest && options.number.value_or(1) > 1)
    throw Usage_error("--radius-min and --radius-max are both " + to_text(largest, 9) +
                      ": that is one radius, not the number that --scales asks for");
  return options.step ? uniform_radii(options, smallest, largest)
                      : geometric_radii(options, smallest, largest);
}

} // namespace

void add_scale_options(CLI::App& app, Scale_options& options)
{
  CLI::Option* radii = add_list_option(
      app, "-R,--radii", options.radii,
      "the radii, with commas between them (default: those that the grid and the shape allow)");
  CLI::Option* smallest =
      app.add_option("--radius-min", options.smallest,
                     "the smallest radius (default: its ball is a few voxels wide)");
  CLI::Option* largest =
      app.add_option("--radius-max", options.largest,
                     "the largest radius (default: half the shortest side of the bounding box)");
  CLI::Option* step =
      app.add_option("--radius-step", options.step,
                     "the difference of neighbouring radii (default: they have the same ratio)");
  for(CLI::Option* length : {smallest, largest, step})
    length->type_name("LENGTH")->check(positive_number());
  CLI::Option* number =
      app.add_option("-n,--scales", options.number,
                     "the number of radii (default: so many that "
                     "their balls overlap)")
          ->type_name("NUMBER")
          ->check(CLI::Validator(
              [](std::string& text) {
                double value = 0;
                const bool is_good = CLI::detail::lexical_cast(text, value) && value >= 1 &&
                                     value <= double(most_scales) && value == std::floor(value);
                return is_good ? std::string() : text + " is not a number of radii (1 to 255)";
              },
              std::string()));
  for(CLI::Option* option : {smallest, largest, step, number})
    radii->excludes(option);
  CLI::Option* ratio = app.add_option("-c,--sigma-ratio", options.sigma_ratio,
                                      "radius of the collecting ball, as a fraction of the radius")
                           ->type_name("FRACTION")
                           ->capture_default_str()
                           ->check(number_between_0_and_1());
  CLI::Option* sigma = app.add_option("--sigma", options.sigma,
                                      "radius of the collecting ball, the same for all radii")
                           ->type_name("LENGTH")
                           ->check(positive_number())
                           ->excludes(ratio);
  for(CLI::Option* option : {radii, smallest, largest, step, number, ratio, sigma})
    option->group("Radii");
}

std::vector<AP::Scale> choose_scales(const Scale_options& options, const CGAL::Bbox_3& box,
                                     double voxel)
{
  if(options.step && options.number && options.largest)
    throw Usage_error("--radius-step, --scales and --radius-max contradict each other: leave one "
                      "out");
  const std::vector<double> radii = choose_radii(options, box, voxel);
  if(radii.size() > most_scales)
    fail_for_number(double(radii.size()));
  // The smallest radius may be the voxel itself, computed in another way.
  if(radii.front() < voxel * (1 - 1e-9))
    throw Usage_error("the radius " + to_text(radii.front(), 9) + " is smaller than the voxel, " +
                      to_text(voxel, 9) +
                      ": lower --voxel (report: raise --resolution), or leave the radius out");
  const std::vector<AP::Scale> scales = options.sigma
                                            ? AP::fixed_sigma_scales(radii, *options.sigma)
                                            : AP::proportional_scales(radii, options.sigma_ratio);
  for(const AP::Scale& scale : scales)
    if(!(scale.sigma >= voxel / 50))
      throw Usage_error("sigma is " + to_text(scale.sigma, 9) +
                        ": less than a fiftieth of the voxel, " + to_text(voxel, 9) +
                        "; lower --voxel, or raise --sigma or --sigma-ratio");
  return scales;
}

} // namespace mapt
