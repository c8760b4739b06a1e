// SPDX-License-Identifier: MIT
// A ray made ready for the boxes of a bvh, in floats that stand on the safe side: a box that the ray meets is never
// missed.
//
// A face at b is reached at (b - o) / d, computed as b * gain + offset, where gain is the float of 1/d and offset that
// of -o/d, less a slack for near faces and more by it for far ones. With u = 2^-24: o is off by u|o| or, near 0, by
// less than 2^-76, offset by two roundings, 2.1u|o gain|, the product, where it is rounded by itself, by u|b gain|, of
// which |b| <= |b - o| + |o|, the gain by 2.1u and the sum by u of what they are. That is less than 4.5u|o gain|, of 8u
// that the slack has, and 4.5u of the time itself. Far gains and offsets are 16u more than that, which costs them
// 2u|o gain|. Bounds are at most 1, reciprocals at most 2^100 and at least 2^-20: nothing cancels
// that has overflowed, and what is subnormal is less than the slack. Where a time is beyond floats it is infinite, for
// near and far faces alike; infinity less infinity is NaN, which limits nothing. Times before 0 are never asked for.
#pragma once

#include <bit>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>

#include <irg/geometry/ray.hpp>
#include <irg/spatial/detail/box_ray_kernel.hpp>
#include <irg/spatial/detail/bvh_item.hpp>
#include <irg/spatial/detail/ray_shear.hpp>

namespace irg::detail {

// Times count in 2^-unit.
struct box_ray : box_ray_numbers {
  std::ptrdiff_t near_at[3], far_at[3];  // where a node's bounds have the faces that are asked
  float low, high;
  int unit;
};

inline namespace IRG_ABI {

IRG_INLINE constexpr float float_above(double x) noexcept { return 0.0f - float_below(-x); }

// A time of the ray as one of its boxes', not before it. What is subnormal is off by more than its slack.
IRG_INLINE constexpr float later_time(const box_ray& b, double t) noexcept {
  constexpr double slack = 1 + 0x1p-20, most = 0x1p100;
  const double late = times_power_of_two(t * slack + 0x1p-1022, b.unit);
  return late < most ? float_above(late) : std::numeric_limits<float>::infinity();
}
IRG_INLINE constexpr float earlier_time(const box_ray& b, double t) noexcept {
  constexpr double slack = 1 - 0x1p-20, most = 0x1p100;
  const double early = times_power_of_two(t * slack, b.unit);
  return early < most ? float_below(early) : 0x1p100f;
}

// An axis along which the ray goes nowhere lets it through for all times or for none, which a large number tells as
// well as an infinite one: times that are asked are below 2^42, and its slack is worth 2^46. Along one that floats take
// for such, for origins that are far off and for directions so small that times are longer, it is not asked; nor is any
// axis for origins beyond the floats.
constexpr void turn_standing_axes(std::same_as<box_ray> auto& b, const double (&origin)[3],
                                  const double (&direction)[3], bool is_slow) noexcept {
  constexpr float infinite = std::numeric_limits<float>::infinity(), large = 0x1p120f;
  double most = 0;
  for (const double o : origin) most = greater(most, magnitude(o));
  for (int i = 0; i < 3; ++i) {
    if (most <= 0x1p127 && magnitude(direction[i]) >= widened(standing_direction)) continue;
    const bool goes = (std::bit_cast<std::uint64_t>(direction[i]) << 1) != 0;
    if (goes || most > 0x1p40 || is_slow) {
      b.near_gain[i] = b.far_gain[i] = 0;
      b.near_offset[i] = -infinite;
      b.far_offset[i] = infinite;
      continue;
    }
    const float o = converted<float>(origin[i]), to_origin = o * large, slack = step_of_origin(o) * large;
    const float sign = b.near_at[i] < b.far_at[i] ? 1.0f : -1.0f;
    b.near_gain[i] = b.far_gain[i] = sign * large;
    b.near_offset[i] = 0.0f - sign * to_origin - slack;
    b.far_offset[i] = slack - sign * to_origin;
  }
}

template <Floating T>
IRG_INLINE constexpr void set_faces(box_ray& b, const vec<T, 3>& d) noexcept {
  using bits = std::conditional_t<sizeof(T) == 4, std::uint32_t, std::uint64_t>;
  for (int i = 0; i < 3; ++i) {
    const auto back = static_cast<std::ptrdiff_t>(std::bit_cast<bits>(d[i]) >> (8 * sizeof(T) - 1));
    b.near_at[i] = (i + 3 * back) * bvh_node::width;
    b.far_at[i] = (i + 3 - 3 * back) * bvh_node::width;
  }
}

IRG_NOINLINE constexpr void set_any_box_ray(std::same_as<box_ray> auto& b, const ray<double, 3>& r,
                                            double scale) noexcept {
  const vec<double, 3>& d = r.direction;
  const double reach = greater(magnitude(d.x), greater(magnitude(d.y), magnitude(d.z)));
  int exponent = -exponent_of(reach);
  if (exponent > 1023) exponent = 1023;  // for directions of subnormal numbers
  const double size = power_of_two(exponent);
  const double origin[3] = {r.origin.x * scale, r.origin.y * scale, r.origin.z * scale};
  const double direction[3] = {d.x * size, d.y * size, d.z * size};
  set_up_box_ray(origin, direction, b);
  set_faces(b, d);
  turn_standing_axes(b, origin, direction, reach < 0x1p-1022);
  b.unit = exponent_of(scale) - exponent;
  b.low = r.low > 0 ? earlier_time(b, r.low) : 0.0f;
  constexpr float infinite = std::numeric_limits<float>::infinity();
  b.high = r.high <= (std::numeric_limits<double>::max)() ? later_time(b, r.high) : infinite;
}

/// needs   `scale` of the tree
/// gives   whether the ray has points
// Floats of middling sizes stay floats: products with powers of two are exact, or less than the slack.
// It is made where it stays: a copy would wait for its numbers to reach memory.
template <Floating T>
IRG_INLINE constexpr bool set_box_ray(box_ray& b, const ray<T, 3>& r, double scale) noexcept {
  if constexpr (std::is_same_v<T, float>) {
    constexpr std::uint32_t middling = 50;
    const auto scale_biased = static_cast<std::uint32_t>(std::bit_cast<std::uint64_t>(scale) >> 52);
    const float low = greater(r.low, 0.0f);
    if (scale_biased - (1023 - middling) <= 2 * middling && low <= r.high && r.low <= 0x1p100f) {
      const float s = static_cast<float>(scale);
      const vec<float, 3>& d = r.direction;
      const float origin[3] = {product(r.origin.x, s), product(r.origin.y, s), product(r.origin.z, s)};
      const float direction[3] = {d.x, d.y, d.z};
      if (are_middling(origin, direction)) {
        set_up_box_ray(origin, direction, b);
        set_faces(b, d);
        b.unit = static_cast<int>(scale_biased) - 1023;
        const float early = low * (1 - 0x1p-20f) * s, late = r.high * (1 + 0x1p-20f) * s + 0x1p-74f;
        b.low = lesser(early, 0x1p100f);
        b.high = late < 0x1p100f ? late : std::numeric_limits<float>::infinity();
        return true;
      }
    }
  }
  if (is_empty(r)) return false;
  set_any_box_ray(b, exactly_widened(r), scale);
  return true;
}

}  // namespace IRG_ABI
}  // namespace irg::detail
