// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Does it need a mesh? No: points with normals will do, of only a part of the surface, and the area of
// each is estimated from the density. A scan that sees half of a ball still finds its centre.

#include <CGAL/Area_projection_transform/projection/Sampled_evaluator.h>
#include <CGAL/Area_projection_transform/scale_space/Constant_scale_space.h>
#include <CGAL/Area_projection_transform/surfels_from_points.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/point_generators_3.h>

#include <iostream>
#include <utility>
#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;
using Point_with_normal = std::pair<Kernel::Point_3, Kernel::Vector_3>;
namespace AP = CGAL::Area_projection;

int main()
{
  // A ball of radius 2 about (0, 0, 5), seen from above.
  CGAL::Random random(1);
  CGAL::Random_points_on_sphere_3<Kernel::Point_3> direction(1., random);
  std::vector<Point_with_normal> points;
  for(int n = 0; n < 10000; ++n, ++direction) {
    const Kernel::Vector_3 normal = *direction - CGAL::ORIGIN;
    if(normal.z() > 0)
      points.emplace_back(Kernel::Point_3(0, 0, 5) + 2. * normal, normal);
  }

  const AP::Surfels surfels = AP::surfels_from_points(
      points, CGAL::parameters::point_map(CGAL::First_of_pair_property_map<Point_with_normal>())
                  .normal_map(CGAL::Second_of_pair_property_map<Point_with_normal>()));
  std::cout << surfels.size() << " points stand for an area of " << surfels.total_area()
            << " (half of the sphere has " << 8 * CGAL_PI << ")\n";

  const AP::Constant_scale_space<AP::Surfels> surface(surfels);
  const AP::Scale scale{2., 1.};
  const AP::Sampled_evaluator evaluator(surface, scale.radius, AP::Side::INSIDE,
                                        AP::default_sampling_ratio * scale.sigma);
  for(const double z : {4., 4.5, 5., 5.5, 6.5}) {
    const double area = evaluator(Kernel::Point_3(0, 0, z), scale.sigma);
    std::cout << "MAPT at height " << z << ": " << area * scale.normalization() << '\n';
  }
}
