// SPDX-License-Identifier: MIT
// A ray made ready for the boxes of a bvh, in floats that stand on the safe side: a box that the ray meets is never
// missed.
//
// The origin is taken as an interval of floats, the reciprocal of each coordinate of the direction as two floats; which
// end serves is known from the direction's sign and from which face of the box is asked. So the time t at which a near
// face is reached is a difference and a product away from one that is too early, and that of a far face from one that
// is too late: two roundings each, 2^-24 of t. Far reciprocals are 2^-20 larger to make up for all four; near ones are
// 2^-21 less, which makes up for the roundings of the reciprocal itself. Differences are multiples of 2^-101 or zero
// and reciprocals at least 1/4: nothing is subnormal. Where a time is beyond floats it is infinite for near and far
// faces alike; 0 times infinity, the face of a box on a ray that runs along it, is NaN, which limits nothing. Times
// before 0 are never asked for.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>

#include <irg/geometry/ray.hpp>
#include <irg/spatial/detail/box_ray_kernel.hpp>
#include <irg/spatial/detail/bvh_item.hpp>
#include <irg/spatial/detail/ray_shear.hpp>

namespace irg::detail {

// Times count in 2^-unit.
struct box_ray {
  float near_origin[4], far_origin[4], near_gain[4], far_gain[4];
  std::ptrdiff_t near_at[3], far_at[3];  // where a node's bounds have the faces that are asked
  float low, high;
  int unit;
};

inline namespace IRG_ABI {

IRG_INLINE constexpr float float_above(double x) noexcept { return 0.0f - float_below(-x); }

// A time of the ray as one of its boxes', not before it.
IRG_INLINE constexpr float later_time(const box_ray& b, double t) noexcept {
  constexpr double slack = 1 + 0x1p-20, most = 0x1p100;
  const double late = times_power_of_two(t * slack, b.unit);
  return late < most ? float_above(late) : std::numeric_limits<float>::infinity();
}
IRG_INLINE constexpr float earlier_time(const box_ray& b, double t) noexcept {
  constexpr double slack = 1 - 0x1p-20, most = 0x1p100;
  const double early = times_power_of_two(t * slack, b.unit);
  return early < most ? float_below(early) : 0x1p100f;
}

// What floats take for zero need not be: then near faces are reached at some time.
constexpr void turn_standing_axes(box_ray& b, const vec<double, 3>& d) noexcept {
  constexpr float infinite = std::numeric_limits<float>::infinity();
  for (int i = 0; i < 3; ++i) {
    if (magnitude(b.near_gain[i]) < infinite) continue;
    const bool back = d[i] < 0;
    const float low = lesser(b.near_origin[i], b.far_origin[i]), high = greater(b.near_origin[i], b.far_origin[i]);
    b.near_origin[i] = back ? low : high;
    b.far_origin[i] = back ? high : low;
    b.near_gain[i] = back ? -0x1.fffffep127f : d[i] > 0 ? 0x1.fffffep127f : infinite;
    b.far_gain[i] = back ? -infinite : infinite;
  }
}

/// needs   a ray that is not empty, low not negative; `scale` of the tree
IRG_INLINE constexpr box_ray make_box_ray(const ray<double, 3>& r, double scale) noexcept {
  const vec<double, 3>& d = r.direction;
  const double reach = greater(magnitude(d.x), greater(magnitude(d.y), magnitude(d.z)));
  int exponent = -exponent_of(reach);
  if (exponent > 1023) exponent = 1023;  // for directions of subnormal numbers
  const double size = power_of_two(exponent);
  constexpr float infinite = std::numeric_limits<float>::infinity();
  box_ray b{};
  const double origin[3] = {r.origin.x * scale, r.origin.y * scale, r.origin.z * scale};
  const double direction[3] = {d.x * size, d.y * size, d.z * size};
  const bool stands = set_up_box_ray(origin, direction, b.near_origin, b.far_origin, b.near_gain, b.far_gain);
  for (int i = 0; i < 3; ++i) {
    const bool back = d[i] < 0;
    const int low_at = i * bvh_node::width, high_at = (3 + i) * bvh_node::width;
    b.near_at[i] = back ? high_at : low_at;
    b.far_at[i] = back ? low_at : high_at;
  }
  if (stands) turn_standing_axes(b, d);
  b.unit = exponent_of(scale) - exponent;
  b.low = r.low > 0 ? earlier_time(b, r.low) : 0.0f;
  b.high = r.high <= (std::numeric_limits<double>::max)() ? later_time(b, r.high) : infinite;
  return b;
}

}  // namespace IRG_ABI
}  // namespace irg::detail
