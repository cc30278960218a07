// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The stream of scales: what sinks receive, in any number of threads, and how it is watched and
// stopped. (That its memory does not depend on the number of scales follows from its types: a worker
// owns one projector, and a joint map has five bytes for each voxel.)

#include "shapes.h"

#include <CGAL/area_projection_transform.h>
#include <CGAL/Area_projection_transform/forecast.h>
#include <CGAL/Area_projection_transform/projection/Exact_grid_projector.h>
#include <CGAL/Area_projection_transform/projection/Paper_grid_projector.h>
#include <CGAL/Area_projection_transform/sinks.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <gtest/gtest.h>

#include <atomic>
#include <memory>
#include <set>
#include <thread>
#include <vector>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#include <tbb/task_arena.h>
#endif

namespace {

namespace AP = CGAL::Area_projection;
using AP::Point_3;
using AP::Side;
using AP::Vector_3;
using shapes::Soup;

/// a shape, its interior and some scales.
struct Setting
{
  AP::Constant_scale_space<AP::Triangle_surface> surface;
  std::shared_ptr<const AP::Row_spans> region;
  std::vector<AP::Scale> scales;

  explicit Setting(const Soup& soup, double voxel = 0.1)
      : surface(shapes::scale_space_of(soup))
      , region(std::make_shared<const AP::Row_spans>(
            AP::interior(surface.source(), AP::grid_around(surface.bbox(), voxel)).region))
      , scales(AP::proportional_scales(AP::uniform_radii(0.3, 0.1, 7)))
  {}

  template <class ConcurrencyTag = CGAL::Sequential_tag, class Sink,
            class NamedParameters = CGAL::parameters::Default_named_parameters>
  AP::Multiscale_summary run(Sink& sink,
                             const NamedParameters& np = CGAL::parameters::default_values()) const
  {
    return AP::project_scales<ConcurrencyTag>(
        surface, *region, scales, Side::INSIDE, [this] { return AP::Grid_projector(*region); },
        sink, np);
  }
};

// ---------------------------------------------------------------- values

TEST(Project_scales, hands_over_the_normalized_map_of_each_scale)
{
  const Setting setting(shapes::blob(3, 41));
  AP::Scale_maps_sink maps(*setting.region, setting.scales.size());
  const AP::Multiscale_summary summary = setting.run(maps);
  EXPECT_TRUE(summary.is_complete);
  ASSERT_EQ(summary.areas_outside.size(), setting.scales.size());
  for(std::size_t s = 0; s < setting.scales.size(); ++s) {
    const AP::Scale& scale = setting.scales[s];
    AP::Grid_projector projector(*setting.region);
    const auto areas = shapes::areas_on_grid(projector, setting.surface, *setting.region, scale);
    EXPECT_EQ(summary.areas_outside[s],
              projector.project(setting.surface, scale, Side::INSIDE, shapes::Never()));
    shapes::for_each_voxel(*setting.region, [&](const Point_3&, std::size_t place) {
      // The factor is rounded to a float, and so is the product.
      ASSERT_NEAR(maps.maps()[s][place], areas[place] * scale.normalization(),
                  2e-7 * areas[place] * scale.normalization());
    });
  }
}

TEST(Project_scales, the_centre_of_a_sphere_reads_one_at_its_radius_and_two_and_a_quarter_below)
{
  const Soup sphere = shapes::icosphere(4);
  const Setting setting(sphere);
  const auto scales = AP::proportional_scales({0.67, 1.});
  AP::Scale_maps_sink maps(*setting.region, 2);
  AP::project_scales(
      setting.surface, *setting.region, scales, Side::INSIDE,
      [&] { return AP::Exact_grid_projector(*setting.region); }, maps);
  const auto& size = setting.region->grid().size();
  const std::size_t center = setting.region->index(size[0] / 2, size[1] / 2, size[2] / 2);
  const double loss = sphere.area() / (4 * shapes::pi);
  EXPECT_NEAR(maps.maps()[1][center], loss, 1e-6);
  EXPECT_NEAR(maps.maps()[0][center], loss / (0.67 * 0.67), 1e-6);
}

TEST(Joint_map, is_the_maximum_over_the_scales_and_the_radius_that_attains_it)
{
  const Setting setting(shapes::blob(3, 42));
  AP::Scale_maps_sink maps(*setting.region, setting.scales.size());
  AP::Joint_map joint(setting.region, setting.scales);
  AP::Sink_pair<AP::Scale_maps_sink, AP::Joint_map> both(maps, joint);
  setting.run(both);

  std::set<double> radii;
  const AP::Grid_3& grid = setting.region->grid();
  for(int k = 0; k < grid.size()[2]; ++k)
    for(int j = 0; j < grid.size()[1]; ++j)
      for(int i = 0; i < grid.size()[0]; ++i) {
        float largest = 0;
        double radius = 0;
        if(setting.region->contains(i, j, k)) {
          for(std::size_t s = 0; s < setting.scales.size(); ++s) {
            const float value = maps.maps()[s][setting.region->index(i, j, k)];
            if(value > largest) { // the first of several, which has the smallest radius
              largest = value;
              radius = setting.scales[s].radius;
            }
          }
        }
        ASSERT_EQ(joint.value(i, j, k), largest);
        ASSERT_EQ(joint.radius(i, j, k), radius);
        radii.insert(radius);
      }
  EXPECT_EQ(radii.size(), setting.scales.size() + 1); // each scale wins somewhere, and none outside
}

TEST(Joint_map, gives_ties_to_the_smaller_radius_whatever_comes_first)
{
  const auto region =
      std::make_shared<const AP::Row_spans>(AP::Grid_3(Point_3(0, 0, 0), 1, {4, 1, 1}));
  const auto scales = AP::proportional_scales({1., 2., 3.});
  const std::vector<std::array<float, 4>> values{{1, 2, 0, 5}, {1, 3, 0, 5}, {1, 3, 0, 4}};
  std::vector<std::size_t> order{0, 1, 2};
  do {
    AP::Joint_map map(region, scales);
    for(const std::size_t s : order)
      map.consume(s, scales[s], 0, values[s].data(), 4);
    EXPECT_EQ(map.radius(0, 0, 0), 1);
    EXPECT_EQ(map.radius(1, 0, 0), 2);
    EXPECT_EQ(map.radius(2, 0, 0), 0); // zero at all scales
    EXPECT_EQ(map.radius(3, 0, 0), 1);
    EXPECT_EQ(map.value(1, 0, 0), 3);
    EXPECT_EQ(map.scale_indices()[2], AP::Joint_map::no_scale);
  } while(std::next_permutation(order.begin(), order.end()));
}

TEST(Joint_map, refuses_scales_that_it_cannot_tell_apart)
{
  const auto region =
      std::make_shared<const AP::Row_spans>(AP::Grid_3(Point_3(0, 0, 0), 1, {1, 1, 1}));
  EXPECT_EQ(shapes::complaint([&] {
              AP::Joint_map(region, {{1, 1}, {2, 1}, {2, 1}});
            }),
            "scales[2] has not a larger radius than the one before");
  EXPECT_EQ(shapes::complaint([&] {
              AP::Joint_map(region, AP::fixed_sigma_scales(AP::uniform_radii(1, 1, 256), 1));
            }),
            "scales has 256 elements: a joint map holds at most 255");
  AP::Joint_map(region, AP::fixed_sigma_scales(AP::uniform_radii(1, 1, 255), 1));
}

// ---------------------------------------------------------------- threads

/// runs `function` with the given number of threads, or in one without TBB.
template <class Function>
void with_threads(int number, Function function)
{
#ifdef CGAL_LINKED_WITH_TBB
  // More threads than cores are allowed, so that the test is the same on every machine.
  const tbb::global_control allowed(tbb::global_control::max_allowed_parallelism,
                                    std::size_t(number));
  tbb::task_arena(number).execute(function);
#else
  static_cast<void>(number);
  function();
#endif
}

TEST(Same_bits, the_number_of_threads_does_not_matter)
{
  const Setting setting(shapes::blob(4, 43), 0.07);
  const auto expect_same = [&](auto make_projector) {
    AP::Joint_map expected(setting.region, setting.scales);
    AP::project_scales(setting.surface, *setting.region, setting.scales, Side::INSIDE,
                       make_projector, expected);
    for(const int threads : {1, 2, 3, 8}) {
      AP::Joint_map map(setting.region, setting.scales);
      with_threads(threads, [&] {
        AP::project_scales<CGAL::Parallel_if_available_tag>(
            setting.surface, *setting.region, setting.scales, Side::INSIDE, make_projector, map);
      });
      EXPECT_EQ(map.values(), expected.values()) << threads;
      EXPECT_EQ(map.scale_indices(), expected.scale_indices()) << threads;
    }
  };
  expect_same([&] { return AP::Grid_projector(*setting.region); });
  expect_same([&] { return AP::Exact_grid_projector(*setting.region); });
  expect_same([&] { return AP::Paper_grid_projector(*setting.region); });
}

// ---------------------------------------------------------------- progress

struct Counting_visitor : AP::Multiscale_default_visitor
{
  std::vector<int> begun = std::vector<int>(7, 0), ended = std::vector<int>(7, 0);
  std::vector<double> areas_outside = std::vector<double>(7, -1);

  void scale_begins(std::size_t index, const AP::Scale&) { ++begun[index]; }
  void scale_ends(std::size_t index, const AP::Scale&, double area_outside)
  {
    ++ended[index];
    areas_outside[index] = area_outside;
  }
};

/// notices calls at the same time that concern the same scale.
class Overlap_sink
{
public:
  explicit Overlap_sink(std::size_t scales) : m_calls(scales) {}

  void consume(std::size_t scale, const AP::Scale&, std::size_t, const float*, std::size_t)
  {
    if(m_calls[scale]++ > 0)
      m_has_overlap = true;
    std::this_thread::yield();
    --m_calls[scale];
  }

  bool has_overlap() const { return m_has_overlap; }

private:
  std::vector<std::atomic<int>> m_calls;
  std::atomic<bool> m_has_overlap{false};
};

TEST(Project_scales, calls_for_a_scale_come_one_after_the_other_however_many_threads_share_it)
{
  const Setting setting(shapes::icosphere(3), 0.05);
  const std::vector<AP::Scale> one = {setting.scales[2]};
  Overlap_sink sink(1);
  with_threads(4, [&] {
    AP::project_scales<CGAL::Parallel_if_available_tag>(
        setting.surface, *setting.region, one, Side::INSIDE,
        [](const AP::Row_spans& part) { return AP::Grid_projector(part); }, sink);
  });
  EXPECT_FALSE(sink.has_overlap());
}

TEST(Progress, the_visitor_is_told_once_of_the_beginning_and_end_of_each_scale)
{
  const Setting setting(shapes::blob(3, 44));
  for(const int threads : {1, 2, 3}) {
    AP::Joint_map map(setting.region, setting.scales);
    Counting_visitor visitor;
    AP::Multiscale_summary summary;
    with_threads(threads, [&] {
      summary = setting.run<CGAL::Parallel_if_available_tag>(
          map, CGAL::parameters::visitor(std::ref(visitor)));
    });
    EXPECT_EQ(visitor.begun, std::vector<int>(7, 1));
    EXPECT_EQ(visitor.ended, std::vector<int>(7, 1));
    EXPECT_EQ(visitor.areas_outside, summary.areas_outside);
  }
}

TEST(Progress, the_callback_hears_of_growing_fractions_up_to_one)
{
  const Setting setting(shapes::blob(3, 45));
  for(const int threads : {1, 3}) {
    AP::Joint_map map(setting.region, setting.scales);
    std::vector<double> fractions;
    with_threads(threads, [&] {
      const auto summary = setting.run<CGAL::Parallel_if_available_tag>(
          map, CGAL::parameters::callback(std::function<bool(double)>([&](double fraction) {
            fractions.push_back(fraction);
            return true;
          })));
      EXPECT_TRUE(summary.is_complete);
    });
    ASSERT_GE(fractions.size(), setting.scales.size());
    for(std::size_t i = 1; i < fractions.size(); ++i)
      EXPECT_GE(fractions[i], fractions[i - 1]);
    EXPECT_GE(fractions.front(), 0);
    EXPECT_EQ(fractions.back(), 1);
  }
}

// A long scale can be stopped in the middle: the callback is asked for each batch of some thousand
// surfels and each layer of voxels, not only between the scales.
TEST(Progress, the_callback_is_asked_within_a_scale)
{
  const Setting setting(shapes::blob(3, 45));
  AP::Joint_map map(setting.region, {setting.scales.front()});
  int calls = 0;
  AP::project_scales(
      setting.surface, *setting.region, {setting.scales.front()}, Side::INSIDE,
      [&] { return AP::Grid_projector(*setting.region); }, map,
      CGAL::parameters::callback(std::function<bool(double)>([&](double) {
        ++calls;
        return true;
      })));
  EXPECT_GT(calls, setting.region->grid().size()[2]);
}

TEST(Progress, the_callback_stops_the_computation)
{
  const Setting setting(shapes::blob(3, 46));
  for(const int threads : {1, 3})
    for(const int calls_before_stop : {1, 4}) {
      AP::Joint_map map(setting.region, setting.scales);
      Counting_visitor visitor;
      int calls = 0;
      with_threads(threads, [&] {
        const auto summary = setting.run<CGAL::Parallel_if_available_tag>(
            map, CGAL::parameters::callback(std::function<bool(double)>([&](double) {
                   return ++calls < calls_before_stop;
                 })).visitor(std::ref(visitor)));
        EXPECT_FALSE(summary.is_complete);
      });
      EXPECT_EQ(calls, calls_before_stop); // nobody asks after the answer was no
      int begun = 0, ended = 0;
      for(std::size_t s = 0; s < setting.scales.size(); ++s) {
        begun += visitor.begun[s];
        ended += visitor.ended[s];
      }
      // Two calls for each scale; a thread that is at work may still end what it has begun.
      EXPECT_LE(begun, (calls_before_stop + 1) / 2 + threads);
      EXPECT_LE(ended, calls_before_stop / 2 + threads - 1);
    }
}

// ---------------------------------------------------------------- scales

TEST(Scales, are_what_they_are_called)
{
  const auto proportional = AP::proportional_scales({1., 3.}, 0.25);
  EXPECT_EQ(proportional[1].radius, 3);
  EXPECT_EQ(proportional[1].sigma, 0.75);
  EXPECT_EQ(AP::fixed_sigma_scales({1., 3.}, 0.5)[1].sigma, 0.5);
  EXPECT_EQ(AP::uniform_radii(1, 0.5, 4), (std::vector<double>{1, 1.5, 2, 2.5}));
  EXPECT_TRUE(AP::uniform_radii(1, 0.5, 0).empty());
  const auto geometric = AP::geometric_radii(1, 8, 4);
  for(std::size_t k = 0; k < 4; ++k)
    EXPECT_NEAR(geometric[k], std::pow(2., double(k)), 1e-14);
  EXPECT_EQ(geometric.back(), 8);
  EXPECT_EQ(AP::geometric_radii(2, 8, 1), std::vector<double>{2.});
  EXPECT_NEAR((AP::Scale{0.5, 0.1}.normalization()), 1 / shapes::pi, 1e-15);
}

TEST(Scales, name_the_argument_that_is_out_of_range)
{
  EXPECT_EQ(shapes::complaint([] {
              AP::proportional_scales({1, 2, -0.1});
            }),
            "radii[2] is -0.1: must be positive and finite");
  for(const double ratio : {0., 1., -1., double(NAN)})
    EXPECT_NE(shapes::complaint([=] {
                AP::proportional_scales({1}, ratio);
              }).find("must be greater than 0 and less than 1"),
              std::string::npos);
  EXPECT_EQ(shapes::complaint([] { AP::proportional_scales({1}, 1.5); }),
            "sigma_ratio is 1.5: must be greater than 0 and less than 1");
  EXPECT_EQ(shapes::complaint([] { AP::fixed_sigma_scales({1}, 0); }),
            "sigma is 0: must be positive and finite");
  EXPECT_EQ(shapes::complaint([] { AP::fixed_sigma_scales({0}, 1); }),
            "radii[0] is 0: must be positive and finite");
  EXPECT_EQ(shapes::complaint([] { AP::uniform_radii(0, 1, 3); }),
            "first is 0: must be positive and finite");
  EXPECT_EQ(shapes::complaint([] { AP::uniform_radii(1, -1, 3); }),
            "step is -1: must be positive and finite");
  EXPECT_EQ(shapes::complaint([] { AP::geometric_radii(1, INFINITY, 3); }),
            "last is inf: must be positive and finite");
}

TEST(Default_scales, cover_what_fits_into_the_box)
{
  const CGAL::Bbox_3 box(0, 0, 0, 4, 2, 8);
  EXPECT_EQ(AP::default_voxel_size(box), 8. / 128);
  for(const double ratio : {0.2, 0.5, 0.8}) {
    const auto radii = AP::default_radii(box, 8. / 128, ratio);
    EXPECT_DOUBLE_EQ(radii.front() * ratio, 1.5 * 8. / 128); // σ of one and a half voxels
    EXPECT_DOUBLE_EQ(radii.back(), 1);                       // half the shortest side
    for(std::size_t k = 1; k < radii.size(); ++k)
      EXPECT_LE(radii[k] / radii[k - 1], 1 + ratio / 2 + 1e-12);
  }
  EXPECT_EQ(AP::default_radii(CGAL::Bbox_3(0, 0, 0, 1, 1, 0), 1. / 128).size(), 1u); // flat
  EXPECT_EQ(shapes::complaint([&] { AP::default_radii(box, 0); }),
            "voxel_size is 0: must be positive and finite");
  EXPECT_EQ(shapes::complaint([&] { AP::default_radii(box, 1, 1); }),
            "sigma_ratio is 1: must be greater than 0 and less than 1");
}

// Twice the area and twice the faces are twice the work, on any grid.
TEST(Forecast, grows_with_what_it_is_about)
{
  const auto scales = AP::proportional_scales({1., 2.});
  const auto forecast = [&](double voxels, double area, double maps) {
    return AP::forecast_joint_map(voxels, 100, 1000, area, 0.1, scales, 0.2, 2, maps);
  };
  EXPECT_EQ(forecast(1e4, 1e3, 0).voxels, 1e4);
  EXPECT_NEAR(forecast(1e4, 2e4, 0).writes / forecast(1e4, 1e4, 0).writes, 2, 1e-9);
  EXPECT_NEAR(forecast(2e4, 1e3, 0).bytes - forecast(1e4, 1e3, 0).bytes, 1e4 * (5 + 2 * 4), 1);
  EXPECT_NEAR(forecast(1e4, 1e3, 3).bytes - forecast(1e4, 1e3, 0).bytes, 3 * 4e4, 1);
}

// ---------------------------------------------------------------- the facade

using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
namespace P = CGAL::Area_projection::parameters;

// Along the axis of a cylinder the joint map is 0.55, where R is 0.845 of its radius. The faces of a
// prism are sampled alike, so its samples lie in rings, about nine of them in a ball: the value at a
// voxel is off by up to one ring, but not the mean of many voxels.
TEST(Joint_area_projection_transform, finds_the_axis_of_a_cylinder)
{
  const Mesh cylinder = shapes::mesh_of<Mesh>(shapes::cylinder(100, 1, 8, true));
  const AP::Joint_map map = AP::joint_area_projection_transform<CGAL::Parallel_if_available_tag>(
      cylinder, P::combine(P::voxel_size(0.1), P::radii(AP::geometric_radii(0.5, 1.5, 23))));
  const auto& size = map.grid().size();
  double sum_of_values = 0, sum_of_radii = 0;
  for(int k = size[2] / 2 - 10; k < size[2] / 2 + 10; ++k) {
    float largest = 0;
    std::array<int, 2> where{};
    for(int j = 0; j < size[1]; ++j)
      for(int i = 0; i < size[0]; ++i)
        if(map.value(i, j, k) > largest) {
          largest = map.value(i, j, k);
          where = {i, j};
        }
    const Point_3 p = map.grid().point(where[0], where[1], k);
    EXPECT_LT(std::hypot(p.x(), p.y()), 0.15);
    EXPECT_NEAR(largest, 0.5503, 0.5503 / 9);
    sum_of_values += largest;
    sum_of_radii += map.radius(where[0], where[1], k);
  }
  EXPECT_NEAR(sum_of_values / 20, 0.5503, 0.02);
  EXPECT_NEAR(sum_of_radii / 20, 0.845, 0.05);
}

TEST(Joint_area_projection_transform, takes_its_parameters)
{
  const Mesh mesh = shapes::mesh_of<Mesh>(shapes::blob(3, 47));
  const AP::Joint_map map = AP::joint_area_projection_transform(
      mesh, P::combine(P::voxel_size(0.2), P::radii({0.4, 0.8}), P::sigma_ratio(0.25),
                       P::side(Side::OUTSIDE)));
  EXPECT_EQ(map.grid().spacing(), 0.2);
  ASSERT_EQ(map.scales().size(), 2u);
  EXPECT_EQ(map.scales()[1].sigma, 0.2);
  // Outside: the whole box, and the largest radius around it.
  EXPECT_EQ(map.region().number_of_voxels(), map.grid().number_of_voxels());
  EXPECT_GE(map.grid().size()[0] * 0.2, 2 * 0.8 + 1.5);
  EXPECT_EQ(map.value(map.grid().size()[0] / 2, map.grid().size()[1] / 2, map.grid().size()[2] / 2),
            0);
  EXPECT_GT(*std::max_element(map.values().begin(), map.values().end()), 0);

  const AP::Joint_map by_default = AP::joint_area_projection_transform(mesh);
  const auto box = shapes::surface_of(shapes::blob(3, 47)).bbox();
  EXPECT_EQ(by_default.grid().spacing(), AP::default_voxel_size(box));
  EXPECT_EQ(by_default.scales().size(), AP::default_radii(box, AP::default_voxel_size(box)).size());
}

TEST(Joint_area_projection_transform, hands_over_callback_and_visitor)
{
  const Mesh mesh = shapes::mesh_of<Mesh>(shapes::blob(2, 48));
  Counting_visitor visitor;
  int calls = 0;
  AP::joint_area_projection_transform(
      mesh, P::combine(P::radii(AP::uniform_radii(0.3, 0.1, 7)), P::voxel_size(0.1),
                       CGAL::parameters::visitor(std::ref(visitor))
                           .callback(std::function<bool(double)>([&](double) {
                             ++calls;
                             return true;
                           }))));
  EXPECT_EQ(visitor.ended, std::vector<int>(7, 1));
  EXPECT_GE(calls, 7);
}

TEST(Facade, names_the_argument_that_is_out_of_range)
{
  const Mesh mesh = shapes::mesh_of<Mesh>(shapes::icosphere(1));
  const auto joint = [&](const auto& np) {
    return shapes::complaint([&] { AP::joint_area_projection_transform(mesh, np); });
  };
  EXPECT_EQ(joint(P::voxel_size(-1)), "voxel_size is -1: must be positive and finite");
  EXPECT_EQ(joint(P::radii({1, 0.5})), "scales[1] has not a larger radius than the one before");
  EXPECT_EQ(joint(P::radii({0})), "radii[0] is 0: must be positive and finite");
  EXPECT_EQ(joint(P::sigma_ratio(1)), "sigma_ratio is 1: must be greater than 0 and less than 1");
  EXPECT_EQ(shapes::complaint([] { AP::joint_area_projection_transform(Mesh()); }),
            "mesh has no face with an area");
  const auto at = [&](double radius, double sigma) {
    return shapes::complaint(
        [&] { AP::area_projection_transform(mesh, Point_3(0, 0, 0), radius, sigma); });
  };
  EXPECT_EQ(at(0, 1), "radius is 0: must be positive and finite");
  EXPECT_EQ(at(1, -2), "sigma is -2: must be positive and finite");
}

// Where the shape is smaller than places are rounded to, it is within the ball or not, but no more than all of it.
TEST(Area_projection_transform, is_a_part_of_the_area_at_any_radius)
{
  const shapes::Soup ball = shapes::icosphere(2);
  const Mesh mesh = shapes::mesh_of<Mesh>(ball);
  for(const double radius : {1e8, 1e15, 1e17, 1e40, 1e88})
    for(const double share : {0.2, 0.5, 1.}) {
      const Point_3 x(-share * radius, share * radius, -share * radius);
      const double value = AP::area_projection_transform(mesh, x, radius, radius);
      EXPECT_GE(value, 0) << radius;
      EXPECT_LE(value, ball.area() * (1 + 1e-12)) << radius;
    }
}

} // namespace
