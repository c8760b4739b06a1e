// SPDX-License-Identifier: MIT
// A ray made ready for the boxes of a bvh, in floats that stand on the safe side: a box that the ray meets is never
// missed.
//
// The origin is taken as the interval of floats round it, the reciprocal of each coordinate of the direction as that of
// two floats; which end serves is known from the direction's sign and from which face of the box is asked. So the time
// t at which a near face is reached is a difference and a product away from one that is too early, and that of a far
// face from one that is too late: two roundings each, 2^-24 of t, and far reciprocals are 2^-20 larger to make up for
// all four. Differences are multiples of 2^-100 or zero and reciprocals at least 1/2: nothing is subnormal. Where a
// time is beyond floats it is infinite for near and far faces alike; 0 times infinity, the face of a box on a ray that
// runs along it, is NaN, which limits nothing. Times before 0 are never asked for.
#pragma once

#include <bit>
#include <cstdint>
#include <limits>

#include <irg/spatial/detail/ray_shear.hpp>
#include <irg/geometry/ray.hpp>
#include <irg/spatial/detail/bvh_item.hpp>

namespace irg::detail {

// Times count in 2^-unit.
struct box_ray {
  float near_origin[3], far_origin[3], near_gain[3], far_gain[3];
  int near_row[3], far_row[3];  // of a node's bounds
  float low = 0, high = 0;
  int unit = 0;
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

// The origin along one axis, rounded down; beyond the floats the end of their range.
IRG_INLINE constexpr float origin_below(double x) noexcept {
  constexpr double largest = 0x1.fffffep127;
  if (x > largest) return 0x1.fffffep127f;
  if (x < -largest) return -std::numeric_limits<float>::infinity();
  return float_below(x);
}

/// needs   a ray that is not empty, low not negative; `scale` of the tree
IRG_INLINE constexpr box_ray make_box_ray(const ray<double, 3>& r, double scale) noexcept {
  constexpr double largest = 0x1.fffffep127, slack = 1 + 0x1p-20;
  constexpr float infinite = std::numeric_limits<float>::infinity();
  double reach = 0;
  for (int i = 0; i < 3; ++i) reach = greater(reach, magnitude(r.direction[i]));
  const int exponent = -exponent_of(reach);
  box_ray b{};
  for (int i = 0; i < 3; ++i) {
    const double o = times_power_of_two(r.origin[i], exponent_of(scale));
    const double d = times_power_of_two(r.direction[i], exponent);
    const bool back = r.direction[i] < 0;
    const float low = origin_below(o), high = 0.0f - origin_below(-o);
    b.near_origin[i] = back ? low : high;
    b.far_origin[i] = back ? high : low;
    b.near_row[i] = back ? 3 + i : i;
    b.far_row[i] = back ? i : 3 + i;
    const double size = magnitude(d);
    const double gain = size >= 0x1p-1000 ? 1 / size : std::numeric_limits<double>::infinity();
    float near = infinite, far = infinite;
    if (r.direction[i] < 0 || r.direction[i] > 0) near = gain < largest ? float_below(gain) : 0x1.fffffep127f;
    if (gain * slack < largest) far = float_above(gain * slack);
    b.near_gain[i] = back ? -near : near;
    b.far_gain[i] = back ? -far : far;
  }
  b.unit = exponent_of(scale) - exponent;
  b.low = earlier_time(b, r.low);
  b.high = later_time(b, r.high);
  return b;
}

}  // namespace IRG_ABI
}  // namespace irg::detail
