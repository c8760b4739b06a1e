// SPDX-License-Identifier: MIT
// A ray as triangles are seen from it: along the axis of its direction's largest coordinate, everything sheared so that
// the ray is that axis. A triangle is crossed where its sheared sides all turn the same way round the ray.
//
// With A a corner seen from the origin, x = A_x - s A_z with s = d_x / d_z, |s| <= 1, is off by less than 6.01u m,
// where m is the largest coordinate of any A: u|A_x| from the first difference, 3u|A_z| from s and its product, 2u m
// from the last difference. |x| is at most 2m, so a side's x_a y_b - y_a x_b is off by 2*2*2*6.01u m^2 and, by its own
// three roundings, by 16u m^2: less than 65u m^2. What subnormal numbers lose, or processors that take them for zero,
// is less than 2^-1019 (m + 1); `least` in m makes the bound at least 2^-480 m * 2^-46.
#pragma once

#include <irg/core/conversion.hpp>
#include <irg/geometry/ray.hpp>
#include <irg/math/error_free.hpp>

namespace irg::detail::inline IRG_ABI {

struct ray_shear {
  int x, y, z;  // the axes, z that of the largest coordinate; x and y swapped where it is negative
  double origin[3], slope_x, slope_y;  // the origin in the order of the axes
};

using space_point = point<double, 3>;

using irg::exactly_widened;  // of numbers, beside which stand those of points and rays

template <Floating T>
IRG_INLINE constexpr space_point exactly_widened(const point<T, 3>& p) noexcept {
  return {exactly_widened(p.x), exactly_widened(p.y), exactly_widened(p.z)};
}

template <Floating T>
IRG_INLINE constexpr ray<double, 3> exactly_widened(const ray<T, 3>& r) noexcept {
  const vec<T, 3>& d = r.direction;
  return {exactly_widened(r.origin),
          {exactly_widened(d.x), exactly_widened(d.y), exactly_widened(d.z)},
          r.low < T(0) ? 0.0 : exactly_widened(r.low),
          exactly_widened(r.high)};
}

inline constexpr double side_error = 0x1.4p-47, side_least = 0x1p-480;

// The bound of a side's error, where no coordinate seen from the origin is larger than m.
IRG_INLINE constexpr double side_bound(double m) noexcept {
  const double size = m + side_least;
  return side_error * size * size;
}

/// needs   a direction that is finite and not zero
// It is made where it stays: a copy would wait for its numbers to reach memory.
IRG_INLINE constexpr void set_shear(ray_shear& s, const ray<double, 3>& r) noexcept {
  const vec<double, 3>& d = r.direction;
  int z = magnitude(d[1]) > magnitude(d[0]) ? 1 : 0;
  if (magnitude(d[2]) > magnitude(d[z])) z = 2;
  const bool back = d[z] < 0;
  const int next = z == 2 ? 0 : z + 1, last = z == 0 ? 2 : z - 1;
  s.x = back ? last : next;
  s.y = back ? next : last;
  s.z = z;
  s.origin[0] = r.origin[s.x];
  s.origin[1] = r.origin[s.y];
  s.origin[2] = r.origin[z];
  s.slope_x = d[s.x] / d[z];
  s.slope_y = d[s.y] / d[z];
}

// The corners of triangles as seen along the ray. F is a number or a pack, `origin` and `corner` hold the coordinates
// in the order of the shear's axes.
template <class F>
struct sheared_corners {
  F x[3], y[3], z[3];  // z only from the origin
};
template <class F>
IRG_INLINE constexpr sheared_corners<F> corners_along(const F (&origin)[3], const F& slope_x, const F& slope_y,
                                                      const F (&corner)[3][3]) noexcept {
  const F za = corner[0][2] - origin[2], zb = corner[1][2] - origin[2], zc = corner[2][2] - origin[2];
  return {{(corner[0][0] - origin[0]) - product(slope_x, za), (corner[1][0] - origin[0]) - product(slope_x, zb),
           (corner[2][0] - origin[0]) - product(slope_x, zc)},
          {(corner[0][1] - origin[1]) - product(slope_y, za), (corner[1][1] - origin[1]) - product(slope_y, zb),
           (corner[2][1] - origin[1]) - product(slope_y, zc)},
          {za, zb, zc}};
}

// How the sides of triangles turn round the ray: positive where counter-clockwise as seen along it.
template <class F>
struct sheared_sides {
  F bc, ca, ab;
};
template <class F>
IRG_INLINE constexpr sheared_sides<F> sides_of(const sheared_corners<F>& c) noexcept {
  const auto side = [&c](int i, int k) { return product(c.x[i], c.y[k]) - product(c.y[i], c.x[k]); };
  return {side(1, 2), side(2, 0), side(0, 1)};
}

}  // namespace irg::detail::inline IRG_ABI
