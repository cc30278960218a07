// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Included once for each instruction set, before the kernels that use it; guarded for each of them.
//
// The area of a triangle within a disk for many disks or triangles side by side: what `triangle_disk.h`
// says of one, as formulas without branches.

#if CGAL_AREA_PROJECTION_LANES == 16
#ifndef CGAL_AREA_PROJECTION_TRIANGLE_DISK_16
#define CGAL_AREA_PROJECTION_TRIANGLE_DISK_16
#define CGAL_AREA_PROJECTION_DEFINE_TRIANGLE_DISK
#endif
#elif CGAL_AREA_PROJECTION_LANES == 8
#ifndef CGAL_AREA_PROJECTION_TRIANGLE_DISK_8
#define CGAL_AREA_PROJECTION_TRIANGLE_DISK_8
#define CGAL_AREA_PROJECTION_DEFINE_TRIANGLE_DISK
#endif
#else
#ifndef CGAL_AREA_PROJECTION_TRIANGLE_DISK_4
#define CGAL_AREA_PROJECTION_TRIANGLE_DISK_4
#define CGAL_AREA_PROJECTION_DEFINE_TRIANGLE_DISK
#endif
#endif

#ifdef CGAL_AREA_PROJECTION_DEFINE_TRIANGLE_DISK
#undef CGAL_AREA_PROJECTION_DEFINE_TRIANGLE_DISK

namespace CGAL {
namespace Area_projection {
namespace internal {
namespace CGAL_AREA_PROJECTION_ISA {

/// \brief `atan(t)` for `|t| <= tan(pi/8)`, by polynomials whose largest error is least: 3e-9, far below
/// the rounding of floats, and 6e-18.
///
/// Their terms are paired, so that few operations have to wait for others.
inline Floats small_arctangent(Floats t)
{
  const Floats u = t * t, v = u * u;
  const Floats high = (u * 0.10743731364f - 0.14263955586f) - v * 0.064519277894f;
  return t + (t * u) * ((u * 0.19999540483f - 0.33333331761f) + v * high);
}

inline Doubles small_arctangent(Doubles t)
{
  const Doubles u = t * t, v = u * u, w = v * v;
  const Doubles p0 = (u * 0.1999999999999552067 - 0.3333333333333333016) +
                     v * (u * 0.11111111015256223084 - 0.14285714284666541199);
  const Doubles p4 = (u * 0.076921831906952151496 - 0.090909045781182685081) +
                     v * (u * 0.058581488967880361054 - 0.066645114455384896733);
  const Doubles p8 =
      (u * 0.039231655874580167387 - 0.050854496541382525019) - v * 0.019176884154115975443;
  return t + (t * u) * (p0 + w * (p4 + w * p8));
}

/// the angle of the complex number `(x, y)`, in [-pi, pi].
template <class Lanes>
inline Lanes angle_of(Lanes x, Lanes y)
{
  const Lanes zero{};
  const Lanes pi = all_of<Lanes>(3.14159265358979323846);
  const Lanes width = max(x, -x), height = max(y, -y);
  const Lanes large = max(width, height), small = min(width, height);
  // tan(a - pi/4) = (tan(a) - 1) / (tan(a) + 1)
  const auto is_turned = small > large * all_of<Lanes>(0.41421356237309503);
  const Lanes t = (is_turned ? small - large : small) / (is_turned ? small + large : large);
  Lanes angle = small_arctangent(t);
  angle = is_turned ? angle + pi * all_of<Lanes>(0.25) : angle;
  angle = height > width ? pi * all_of<Lanes>(0.5) - angle : angle;
  angle = x < zero ? pi - angle : angle;
  return y < zero ? -angle : angle;
}

/// \brief what does not change when a triangle is moved: the lengths of its edges, and the angle from the
/// direction of each to that of the next, counterclockwise.
template <class Lanes>
struct Edges
{
  Lanes length[3], cosine[3], sine[3];
};

/// \brief the edges as seen from the centre of a disk: where each begins and ends, measured along it
/// from the place that is nearest to the centre, and how far the centre lies to the left of it.
template <class Lanes>
struct Seen_edges
{
  Lanes start[3], end[3], height[3];
};

/// \brief how the edges meet the disk: where each enters and leaves it, and how much of it is before and
/// after that. An edge that does not meet the disk enters and leaves it at the same place.
template <class Lanes>
struct Cut_edges
{
  Lanes in[3], out[3], before[3], after[3];
};

/// a complex number.
template <class Lanes>
struct Direction
{
  Lanes x, y;
};

/// \brief follows the boundary: from where edge `i` leaves the disk to its end and on to where the next
/// one enters it.
///
/// Best for triangles up to a few times as large as the disk: it errs by a rounding of the product of
/// the radius and the longest edge. Of small triangles not even small differences cancel.
struct Along_the_edges
{
  template <class Lanes>
  static Lanes chord(const Edges<Lanes>& edges, const Cut_edges<Lanes>& cut, int i)
  {
    return edges.length[i] - (cut.before[i] + cut.after[i]);
  }

  /// the angle under which this way is seen from the centre.
  template <class Lanes>
  static Direction<Lanes> turn(const Edges<Lanes>& edges, const Seen_edges<Lanes>& seen,
                               const Cut_edges<Lanes>& cut, int i, int next)
  {
    // Keeps a corner at the very centre from making all vanish.
    const Lanes tiny = all_of<Lanes>(Lanes_traits<Lanes>::tiny);
    const Lanes out = cut.out[i], after = cut.after[i], before = cut.before[next];
    const Lanes height = seen.height[i];
    return {out * out + height * height + tiny + after * out +
                before * (seen.start[next] - after * edges.cosine[i]),
            after * height + before * (seen.height[next] - after * edges.sine[i])};
  }
};

/// \brief knows of the same way only where it begins and ends: best for large triangles. It errs by a
/// rounding of the squared radius, be the corners as far away as they may.
struct Between_the_ends
{
  template <class Lanes>
  static Lanes chord(const Edges<Lanes>&, const Cut_edges<Lanes>& cut, int i)
  {
    return cut.out[i] - cut.in[i];
  }

  template <class Lanes>
  static Direction<Lanes> turn(const Edges<Lanes>& edges, const Seen_edges<Lanes>& seen,
                               const Cut_edges<Lanes>& cut, int i, int next)
  {
    const Lanes out = cut.out[i], in = cut.in[next];
    const Lanes height = seen.height[i], next_height = seen.height[next];
    const Lanes dot = out * in + height * next_height, cross = out * next_height - height * in;
    // A corner within the disk is no angle, even if it lies at the very centre and is rounded.
    const auto is_cut = cut.after[i] + cut.before[next] > Lanes{};
    return {is_cut ? edges.cosine[i] * dot + edges.sine[i] * cross : all_of<Lanes>(1),
            is_cut ? edges.sine[i] * dot - edges.cosine[i] * cross : Lanes{}};
  }
};

/// \brief the arcs of a circle within a triangle, as an angle.
///
/// Three arcs, each from where one edge leaves the disk to where the next one enters it; for edges that
/// do not meet the disk, what they end at cancels. Each is less than half a turn, so that their product
/// as complex numbers tells the sum up to a full turn.
template <class Way, class Lanes>
inline Lanes arcs_within_triangle(const Edges<Lanes>& edges, const Seen_edges<Lanes>& seen,
                                  const Cut_edges<Lanes>& cut, Lanes squared_radius,
                                  Lanes least_height)
{
  const auto a = Way::turn(edges, seen, cut, 0, 1);
  const auto b = Way::turn(edges, seen, cut, 1, 2);
  const auto c = Way::turn(edges, seen, cut, 2, 0);
  const Lanes x = a.x * b.x - a.y * b.y, y = a.x * b.y + a.y * b.x;
  const Lanes angle = angle_of(x * c.x - y * c.y, x * c.y + y * c.x);

  // An edge at 3/4 of the radius cuts off 83 degrees. So with all edges farther away the arcs have at
  // least 111 degrees, otherwise at most 277: the turn to add is found whatever the rounding.
  const Lanes nearest = max(least_height, Lanes{});
  const auto is_deep = nearest * nearest > squared_radius * all_of<Lanes>(0.5625);
  const Lanes least = is_deep ? all_of<Lanes>(0.96) : all_of<Lanes>(-0.72);
  return angle < least ? angle + all_of<Lanes>(6.28318530717958647692) : angle;
}

/// \brief twice the area of a triangle within a disk, with lengths in units of about the radius; zero
/// if they are apart.
///
/// \tparam Way `Along_the_edges` or `Between_the_ends`
template <class Way, class Lanes>
inline Lanes doubled_area_within_disk(const Edges<Lanes>& edges, const Seen_edges<Lanes>& seen,
                                      Lanes squared_radius)
{
  const Lanes zero{};
  const Lanes* height = seen.height;
  Cut_edges<Lanes> cut;
  Lanes straight{};
  for(int i = 0; i < 3; ++i) {
    const Lanes half = sqrt(max(squared_radius - height[i] * height[i], zero));
    cut.in[i] = min(max(-half, seen.start[i]), seen.end[i]);
    cut.out[i] = min(max(half, seen.start[i]), seen.end[i]);
    cut.before[i] = cut.in[i] - seen.start[i];
    cut.after[i] = seen.end[i] - cut.out[i];
    straight = straight + Way::chord(edges, cut, i) * height[i];
  }
  const Lanes least_height = min(min(height[0], height[1]), height[2]);
  const Lanes arcs = arcs_within_triangle<Way>(edges, seen, cut, squared_radius, least_height);
  // If no edge meets the disk, it lies within the triangle or outside.
  const auto is_met = (cut.out[0] > cut.in[0]) | (cut.out[1] > cut.in[1]) |
                      (cut.out[2] > cut.in[2]) | (least_height > zero);
  return is_met ? max(straight + squared_radius * arcs, zero) : zero;
}

} // namespace CGAL_AREA_PROJECTION_ISA
} // namespace internal
} // namespace Area_projection
} // namespace CGAL

#endif
