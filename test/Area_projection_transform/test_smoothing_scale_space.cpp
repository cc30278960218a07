// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Surfaces that are made when they are asked for: once, in any number of threads, and what a smoother throws is passed on.

#include "shapes.h"

#include <CGAL/Area_projection_transform/Map_session.h>
#include <CGAL/Area_projection_transform/projection/Exact_grid_projector.h>
#include <CGAL/Area_projection_transform/scale_space/Averaged_normals.h>
#include <CGAL/Area_projection_transform/scale_space/Constant_scale_space.h>
#include <CGAL/Area_projection_transform/scale_space/Smoothing_scale_space.h>

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <memory>
#include <stdexcept>
#include <thread>
#include <vector>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#endif

namespace {

namespace AP = CGAL::Area_projection;
using AP::Averaged_normals;
using AP::Side;
using AP::Smoothing_scale_space;
using AP::Triangle_surface;
using shapes::surface_of;

/// returns its source, and counts how often.
struct Counting_smoother
{
  using Source = Triangle_surface;
  Triangle_surface surface;
  std::shared_ptr<std::atomic<int>> calls = std::make_shared<std::atomic<int>>(0);

  const Triangle_surface& source() const { return surface; }
  Triangle_surface operator()(double radius) const
  {
    ++*calls;
    if(radius > 10)
      throw std::runtime_error("too large");
    return surface;
  }
};

TEST(Smoothing_scale_space, projects_what_its_smoother_makes)
{
  const Triangle_surface blob = surface_of(shapes::blob(3, 4));
  const auto batches = [](const auto& surface) {
    AP::Projected_surfels all;
    surface.project(0.3, Side::INSIDE, 0.1, [&all](const AP::Projected_surfels& batch) {
      for(std::size_t i = 0; i < batch.size(); ++i)
        all.push_back(batch.positions[i], batch.areas[i], batch.covariances[i]);
    });
    return all;
  };
  const AP::Projected_surfels expected = batches(AP::Constant_scale_space(blob));
  const AP::Projected_surfels found = batches(Smoothing_scale_space(Counting_smoother{blob}));
  EXPECT_EQ(found.positions, expected.positions);
  EXPECT_EQ(found.areas, expected.areas);
}

TEST(Smoothing_scale_space, makes_each_surface_once_and_forgets_the_oldest)
{
  const Counting_smoother smoother{surface_of(shapes::icosphere(1))};
  const Smoothing_scale_space surface(smoother, 2);
  std::vector<std::thread> threads;
  for(int i = 0; i < 8; ++i)
    threads.emplace_back([&surface] { surface.area(1); });
  for(std::thread& thread : threads)
    thread.join();
  EXPECT_EQ(*smoother.calls, 1);
  const auto in_use = surface.triangles(1);
  surface.area(2);
  surface.area(1); // used last: 2 is the one to go
  surface.area(3);
  surface.area(1);
  EXPECT_EQ(*smoother.calls, 3);
  surface.area(2);
  surface.area(3);
  EXPECT_EQ(*smoother.calls, 5);
  EXPECT_EQ(in_use->size(), smoother.surface.size());
}

#ifdef CGAL_LINKED_WITH_TBB
/// a smoother that works in parallel, on more pieces than there are threads.
struct Parallel_smoother
{
  using Source = Triangle_surface;
  Triangle_surface surface;

  const Triangle_surface& source() const { return surface; }
  Triangle_surface operator()(double) const
  {
    tbb::parallel_for(0, 64,
                      [](int) { std::this_thread::sleep_for(std::chrono::milliseconds(1)); });
    return surface;
  }
};

// Who waits for the loop of the smoother must not take up a task that waits for the smoother: that would be
// for ever.
TEST(Smoothing_scale_space, takes_smoothers_that_work_in_parallel)
{
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, 4);
  const Smoothing_scale_space surface(Parallel_smoother{surface_of(shapes::icosphere(1))}, 2);
  std::atomic<int> answers{0};
  tbb::parallel_for(0, 100, [&](int i) { answers += surface.area(1 + i / 50) > 0 ? 1 : 0; });
  EXPECT_EQ(answers, 100);
}
#endif

TEST(Smoothing_scale_space, passes_on_what_its_smoother_throws_and_asks_again)
{
  const Counting_smoother smoother{surface_of(shapes::icosphere(1))};
  const Smoothing_scale_space surface(smoother);
  EXPECT_THROW(surface.area(11), std::runtime_error);
  EXPECT_THROW(surface.area(11), std::runtime_error);
  EXPECT_EQ(*smoother.calls, 2);
  EXPECT_EQ(surface.triangles(1)->size(), smoother.surface.size());
}

TEST(Smoothing_scale_space, agrees_on_grids_with_its_exact_values)
{
  const Smoothing_scale_space surface(Averaged_normals(surface_of(shapes::blob(4, 2))));
  const AP::Row_spans region =
      AP::interior(surface.source(), AP::grid_around(surface.bbox(), 0.1)).region;
  const AP::Scale scale{0.6, 0.3};
  const auto grid = shapes::areas_on_grid(AP::Grid_projector(region), surface, region, scale);
  const auto exact =
      shapes::areas_on_grid(AP::Exact_grid_projector(region), surface, region, scale);
  EXPECT_LT(shapes::relative_rms(grid, exact), 0.01); // twice the error stated for the default
}

TEST(Smoothing_scale_space, gives_the_same_bits_for_any_number_of_threads)
{
  const auto maps = [](auto tag, [[maybe_unused]] int threads) {
#ifdef CGAL_LINKED_WITH_TBB
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                    std::size_t(threads));
#endif
    AP::Map_session<Smoothing_scale_space<Averaged_normals<>>, decltype(tag)> session(
        Smoothing_scale_space(Averaged_normals(surface_of(shapes::blob(4, 8))), 1), 0.1);
    // Two scales among more threads: they share a scale.
    return session.joint_map(AP::proportional_scales({0.4, 0.7}), Side::INSIDE).values();
  };
  const auto expected = maps(CGAL::Sequential_tag(), 1);
  for(const int threads : {1, 2, 3, 8})
    EXPECT_EQ(maps(CGAL::Parallel_if_available_tag(), threads), expected) << threads;
}

} // namespace
