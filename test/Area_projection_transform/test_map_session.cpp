// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Questions to a session: the same bits as the one-shot functions give, by any number of threads, and
// nothing is computed that is there already.

#include "shapes.h"

#include <CGAL/area_projection_transform.h>
#include <CGAL/Area_projection_transform/projection/Exact_grid_projector.h>
#include <CGAL/Area_projection_transform/projection/Paper_grid_projector.h>
#include <CGAL/Area_projection_transform/sinks.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <gtest/gtest.h>

#include <memory>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#include <tbb/task_arena.h>
#endif

namespace {

namespace AP = CGAL::Area_projection;
namespace P = CGAL::Area_projection::parameters;
using AP::Side;
using shapes::Soup;
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
using Surface = AP::Constant_scale_space<AP::Triangle_surface>;

/// counts how often the surface is projected, and how often its triangles are looked at.
class Counting_scale_space
{
public:
  explicit Counting_scale_space(const Soup& soup) : m_surface(shapes::scale_space_of(soup)) {}

  const AP::Triangle_surface& source() const
  {
    ++looks;
    return m_surface.source();
  }
  double area(double radius) const { return m_surface.area(radius); }
  CGAL::Bbox_3 bbox() const { return m_surface.bbox(); }

  template <class BatchSink>
  void project(double radius, Side side, double spacing, BatchSink&& sink) const
  {
    radii.push_back(radius);
    m_surface.project(radius, side, spacing, sink);
  }

  mutable std::vector<double> radii;
  mutable int looks = 0;

private:
  Surface m_surface;
};

struct Counting_visitor : AP::Multiscale_default_visitor
{
  std::vector<std::size_t> begun, ended;
  void scale_begins(std::size_t index, const AP::Scale&) { begun.push_back(index); }
  void scale_ends(std::size_t index, const AP::Scale&, double) { ended.push_back(index); }
};

/// makes projectors, and counts them.
struct Counting_factory
{
  std::shared_ptr<int> made = std::make_shared<int>(0);
  AP::Grid_projector operator()(const AP::Row_spans& region) const
  {
    ++*made;
    return AP::Grid_projector(region);
  }
};

template <class Function>
void with_threads(int number, Function function)
{
#ifdef CGAL_LINKED_WITH_TBB
  const tbb::global_control allowed(tbb::global_control::max_allowed_parallelism,
                                    std::size_t(number));
  tbb::task_arena(number).execute(function);
#else
  static_cast<void>(number);
  function();
#endif
}

void expect_same(const AP::Joint_map& a, const AP::Joint_map& b)
{
  EXPECT_EQ(a.grid(), b.grid());
  EXPECT_EQ(a.values(), b.values());
  EXPECT_EQ(a.scale_indices(), b.scale_indices());
}

const std::vector<double> radii{0.3, 0.45, 0.6, 0.9};

// ---------------------------------------------------------------- the same bits

TEST(Map_session, gives_the_joint_maps_of_the_one_shot_function)
{
  const Soup soup = shapes::blob(3, 61);
  const Mesh mesh = shapes::mesh_of<Mesh>(soup);
  for(const bool keep : {false, true}) {
    AP::Map_session<Surface, CGAL::Parallel_if_available_tag> session(shapes::scale_space_of(soup),
                                                                      0.08, radii.back());
    session.keep_maps(keep);
    for(const double ratio : {0.5, 0.3, 0.5})
      for(const Side side : {Side::OUTSIDE, Side::INSIDE})
        expect_same(session.joint_map(AP::proportional_scales(radii, ratio), side),
                    AP::joint_area_projection_transform(
                        mesh, P::combine(P::radii(radii), P::voxel_size(0.08), P::side(side),
                                         P::sigma_ratio(ratio))));
  }
}

TEST(Map_session, gives_the_map_of_each_scale)
{
  const Soup soup = shapes::blob(3, 62);
  const Surface surface = shapes::scale_space_of(soup);
  AP::Map_session<Surface> session(surface, 0.08);
  const auto region = session.region(Side::INSIDE);
  const auto scales = AP::proportional_scales(radii);
  AP::Scale_maps_sink maps(*region, scales.size());
  const AP::Multiscale_summary summary = AP::project_scales(
      surface, *region, scales, Side::INSIDE, [&] { return AP::Grid_projector(*region); }, maps);
  for(const std::size_t k : {3u, 0u, 2u, 3u, 1u}) {
    EXPECT_EQ(session.scale_map(scales[k], Side::INSIDE), maps.maps()[k]);
    EXPECT_EQ(session.summary().areas_outside[0], summary.areas_outside[k]);
  }
}

// The grid is cut in the middle of the surface, and area falls outside of it.
template <class MakeProjector>
void expect_same_for_any_number_of_threads(MakeProjector make_projector)
{
  const Surface surface = shapes::scale_space_of(shapes::blob(3, 63));
  const AP::Row_spans region(AP::Grid_3(AP::Point_3(-0.6, -1.1, -0.5), 0.1, {13, 21, 12}));
  for(const std::size_t number_of_scales : {1u, 2u, 3u}) {
    const auto scales = AP::proportional_scales(AP::uniform_radii(0.3, 0.2, number_of_scales));
    AP::Scale_maps_sink expected(region, number_of_scales);
    const auto of_one =
        AP::project_scales(surface, region, scales, Side::OUTSIDE, make_projector, expected);
    for(const int threads : {1, 2, 3, 5, 16}) {
      AP::Scale_maps_sink found(region, number_of_scales);
      Counting_visitor visitor;
      AP::Multiscale_summary summary;
      with_threads(threads, [&] {
        summary = AP::project_scales<CGAL::Parallel_if_available_tag>(
            surface, region, scales, Side::OUTSIDE, make_projector, found,
            CGAL::parameters::visitor(std::ref(visitor)));
      });
      EXPECT_EQ(found.maps(), expected.maps()) << threads;
      EXPECT_EQ(summary.areas_outside, of_one.areas_outside) << threads;
      EXPECT_EQ(visitor.begun.size(), number_of_scales);
      EXPECT_EQ(visitor.ended.size(), number_of_scales);
    }
    EXPECT_GT(of_one.areas_outside[0], 0);
  }
}

TEST(Project_scales, shares_a_scale_among_threads_and_gives_the_same_bits)
{
  expect_same_for_any_number_of_threads(
      [](const AP::Row_spans& part) { return AP::Grid_projector(part); });
  expect_same_for_any_number_of_threads(
      [](const AP::Row_spans& part) { return AP::Exact_grid_projector(part); });
  expect_same_for_any_number_of_threads(
      [](const AP::Row_spans& part) { return AP::Paper_grid_projector(part); });
}

// ---------------------------------------------------------------- nothing twice

TEST(Map_session, finds_each_region_once_and_only_if_it_is_needed)
{
  const auto surface = std::make_shared<const Counting_scale_space>(shapes::blob(2, 64));
  AP::Map_session<Counting_scale_space> session(surface, 0.1, 1.);
  session.scale_map({0.5, 0.25}, Side::OUTSIDE);
  EXPECT_EQ(surface->looks, 0);
  const auto region = session.region(Side::INSIDE);
  for(const double radius : radii)
    session.scale_map({radius, 0.2}, Side::INSIDE);
  EXPECT_EQ(surface->looks, 1);
  EXPECT_EQ(session.region(Side::INSIDE), region);
}

TEST(Map_session, keeps_its_projectors)
{
  const auto surface = std::make_shared<const Surface>(shapes::scale_space_of(shapes::blob(2, 65)));
  Counting_factory factory;
  AP::Map_session<Surface, CGAL::Sequential_tag, Counting_factory> session(surface, 0.1, 1.,
                                                                           factory);
  for(const double radius : radii)
    session.scale_map({radius, 0.2}, Side::INSIDE);
  session.joint_map(AP::proportional_scales(radii), Side::INSIDE);
  EXPECT_EQ(*factory.made, 1);
  session.scale_map({0.5, 0.2}, Side::OUTSIDE);
  session.scale_map({0.6, 0.2}, Side::OUTSIDE);
  EXPECT_EQ(*factory.made, 2);
}

TEST(Map_session, recomputes_only_the_scales_that_are_new)
{
  const auto surface = std::make_shared<const Counting_scale_space>(shapes::blob(2, 66));
  AP::Map_session<Counting_scale_space> session(surface, 0.1, 1.);
  session.keep_maps(true);
  const auto computed = [&] { return std::exchange(surface->radii, {}); };
  auto scales = AP::proportional_scales(radii);
  session.joint_map(scales, Side::INSIDE);
  EXPECT_EQ(computed().size(), radii.size());
  session.joint_map(scales, Side::INSIDE);
  EXPECT_TRUE(computed().empty());

  scales[1] = {0.5, 0.25};
  Counting_visitor visitor;
  const AP::Joint_map changed =
      session.joint_map(scales, Side::INSIDE, CGAL::parameters::visitor(std::ref(visitor)));
  EXPECT_EQ(computed(), std::vector<double>{0.5});
  EXPECT_EQ(visitor.begun, std::vector<std::size_t>{1});
  EXPECT_EQ(visitor.ended, std::vector<std::size_t>{1});
  EXPECT_EQ(session.summary().areas_outside.size(), scales.size());
  session.scale_map(scales[2], Side::INSIDE);
  EXPECT_TRUE(computed().empty());

  AP::Map_session<Counting_scale_space> other(surface, 0.1, 1.);
  expect_same(changed, other.joint_map(scales, Side::INSIDE));
  computed();
  session.joint_map(scales, Side::OUTSIDE); // has maps of its own
  session.joint_map(scales, Side::INSIDE);
  EXPECT_EQ(computed().size(), scales.size());
  session.keep_maps(false);
  session.joint_map(scales, Side::INSIDE);
  EXPECT_EQ(computed().size(), scales.size());
}

// ---------------------------------------------------------------- what goes wrong

TEST(Map_session, answers_rightly_after_it_was_stopped)
{
  const Soup soup = shapes::blob(3, 67);
  AP::Map_session<Surface, CGAL::Parallel_if_available_tag> session(shapes::scale_space_of(soup),
                                                                    0.1);
  AP::Map_session<Surface> other(shapes::scale_space_of(soup), 0.1);
  session.keep_maps(true);
  auto scales = AP::proportional_scales(radii);
  session.joint_map(scales, Side::INSIDE);
  scales[2].sigma = 0.2;
  for(const int calls_before_stop : {1, 2, 5, 20}) {
    int calls = 0;
    const auto stop = CGAL::parameters::callback(
        std::function<bool(double)>([&](double) { return ++calls < calls_before_stop; }));
    session.joint_map(scales, Side::INSIDE, stop);
    EXPECT_FALSE(session.summary().is_complete);
    calls = 0;
    session.scale_map({0.7, 0.2}, Side::INSIDE, stop);
    EXPECT_FALSE(session.summary().is_complete);
  }
  EXPECT_EQ(session.scale_map({0.7, 0.2}, Side::INSIDE), other.scale_map({0.7, 0.2}, Side::INSIDE));
  expect_same(session.joint_map(scales, Side::INSIDE), other.joint_map(scales, Side::INSIDE));
  EXPECT_TRUE(session.summary().is_complete);
}

TEST(Map_session, answers_rightly_after_it_has_thrown)
{
  AP::Map_session<Surface> session(shapes::scale_space_of(shapes::blob(2, 68)), 0.1);
  session.keep_maps(true);
  const auto scales = AP::proportional_scales(radii);
  const AP::Joint_map before = session.joint_map(scales, Side::INSIDE);
  EXPECT_EQ(shapes::complaint([&] {
              session.scale_map({-1, 1}, Side::INSIDE);
            }),
            "radius of scales[0] is -1: must be positive and finite");
  EXPECT_THROW(session.joint_map({{0.3, 0.1}, {0.4, 1e-9}}, Side::INSIDE), std::invalid_argument);
  EXPECT_EQ(shapes::complaint([&] {
              session.joint_map({{1, 1}, {1, 1}}, Side::INSIDE);
            }),
            "scales[1] has not a larger radius than the one before");
  expect_same(session.joint_map(scales, Side::INSIDE), before);
}

TEST(Map_session, takes_regions_of_others)
{
  const Surface surface = shapes::scale_space_of(shapes::blob(2, 69));
  AP::Map_session<Surface> session(surface, 0.1);
  const auto scales = AP::proportional_scales(radii);
  const AP::Joint_map before = session.joint_map(scales, Side::INSIDE);
  const auto band = std::make_shared<const AP::Row_spans>(
      AP::band(surface.source(), AP::grid_around(surface.bbox(), 0.07, 0.3), 0.2));
  session.set_region(Side::INSIDE, band);
  const AP::Joint_map of_band = session.joint_map(scales, Side::INSIDE);
  EXPECT_EQ(&of_band.region(), band.get());
  AP::Joint_map expected(band, scales);
  AP::project_scales(
      surface, *band, scales, Side::INSIDE, [&] { return AP::Grid_projector(*band); }, expected);
  expect_same(of_band, expected);
}

TEST(Map_session, of_points_has_the_whole_box_inside)
{
  AP::Surfels points;
  points.push_back(AP::Point_3(0, 0, 0), AP::Vector_3(0, 0, 1), 1., 0);
  points.push_back(AP::Point_3(1, 1, 1), AP::Vector_3(0, 0, 1), 1., 1);
  AP::Map_session<AP::Constant_scale_space<AP::Surfels>> session(
      AP::Constant_scale_space<AP::Surfels>(points), 0.1);
  EXPECT_EQ(session.region(Side::INSIDE)->number_of_voxels(), 11u * 11 * 11);
  EXPECT_GT(session.scale_map({0.5, 0.25}, Side::INSIDE)[0], -1);
}

} // namespace
