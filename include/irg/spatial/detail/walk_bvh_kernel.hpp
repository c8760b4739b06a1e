// SPDX-License-Identifier: MIT
// The loops of the way through a bvh.
#pragma once

#include <bit>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <type_traits>

#include <irg/core/lane_memory.hpp>
#include <irg/core/lanes.hpp>
#include <irg/geometry/ray.hpp>
#include <irg/spatial/bvh_node.hpp>
#include <irg/spatial/detail/bvh_item.hpp>
#include <irg/spatial/detail/ray_shear.hpp>

namespace irg::detail {

// The arithmetic of making rays ready for boxes, in lanes.

template <class F>
struct box_ray_axes {
  F near_gain, far_gain, near_offset, far_offset;
  bool stands;  // on some axis it has hardly a direction
};

struct box_ray_numbers {
  float near_gain[4], far_gain[4], near_offset[4], far_offset[4];
};

// Where a direction is less, its largest coordinate being 1 or more, no reciprocal is taken.
inline constexpr float standing_direction = 0x1p-100f;

inline namespace IRG_ABI {

// How far an origin's float may be off, and what products with the reciprocal lose: origins nearer to 0 than 2^-53,
// where floats would be finer than 2^-76, count as that far.
template <class F>
IRG_INLINE constexpr F step_of_origin(const F& o) noexcept {
  const auto all = [](float x) { return lanes<F>::broadcast(x); };
  return maximum(magnitude(o) * all(0x1p-21f), all(0x1p-74f));
}

// D holds floats or doubles, as many as there are in F floats. Beyond the range of floats an origin is the last of
// them.
template <class F, class D>
IRG_INLINE constexpr box_ray_axes<F> set_up_axes(const D& origin, const D& direction) noexcept {
  using number = typename lanes<D>::scalar;
  const auto all = [](float x) { return lanes<F>::broadcast(x); };
  const auto limit = [](float x) { return lanes<D>::broadcast(static_cast<number>(x)); };
  const F o = converted<float>(minimum(maximum(origin, limit(-0x1.fffffep127f)), limit(0x1.fffffep127f)));
  const F d = converted<float>(direction);
  const auto stands = magnitude(d) < all(standing_direction);
  const F gain = all(1.0f) / select(stands, all(1.0f), d);
  const F to_origin = o * gain, slack = step_of_origin(o) * magnitude(gain);
  const F longer = all(1 + 0x1p-20f);
  return {gain, gain * longer, (-to_origin) - slack, (slack - to_origin) * longer, any_lane(stands)};
}

// Whether origins in the tree's units and directions are such that they need no scaling; NaN is not: maximum gives its
// second number where either is NaN.
template <class F>
IRG_INLINE constexpr auto middling_axes(const F& origin, const F& direction) noexcept {
  const auto all = [](float x) { return lanes<F>::broadcast(x); };
  return both(maximum(magnitude(direction), magnitude(origin)) <= all(0x1p20f), magnitude(direction) >= all(0x1p-60f));
}
IRG_INLINE constexpr bool are_middling(const float (&origin)[3], const float (&direction)[3]) noexcept {
  if (std::is_constant_evaluated())
    return middling_axes(origin[0], direction[0]) && middling_axes(origin[1], direction[1]) &&
           middling_axes(origin[2], direction[2]);
  return all_lanes(middling_axes(pack_of(origin[0], origin[1], origin[2], 0.0f),
                                 pack_of(direction[0], direction[1], direction[2], 1.0f)));
}

// Gives whether the ray has hardly a direction along some axis.
template <class T>
IRG_INLINE constexpr bool set_up_box_ray(const T (&origin)[3], const T (&direction)[3], box_ray_numbers& b) noexcept {
  if (std::is_constant_evaluated()) {
    bool stands = false;
    for (int i = 0; i < 3; ++i) {
      const box_ray_axes<float> axis = set_up_axes<float>(origin[i], direction[i]);
      b.near_gain[i] = axis.near_gain;
      b.far_gain[i] = axis.far_gain;
      b.near_offset[i] = axis.near_offset;
      b.far_offset[i] = axis.far_offset;
      stands = stands || axis.stands;
    }
    return stands;
  }
  const auto axes = set_up_axes<pack<float, 4>>(pack_of(origin[0], origin[1], origin[2], T(0)),
                                                pack_of(direction[0], direction[1], direction[2], T(1)));
  using f = lanes<pack<float, 4>>;
  f::store(b.near_gain, axes.near_gain);
  f::store(b.far_gain, axes.far_gain);
  f::store(b.near_offset, axes.near_offset);
  f::store(b.far_offset, axes.far_offset);
  return axes.stands;
}

}  // namespace IRG_ABI

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
constexpr void turn_standing_axes(box_ray& b, const double (&origin)[3], const double (&direction)[3],
                                  bool is_slow) noexcept {
  constexpr float infinite = std::numeric_limits<float>::infinity(), large = 0x1p120f;
  double most = 0;
  for (const double o : origin) most = maximum(most, magnitude(o));
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

IRG_NOINLINE constexpr void set_any_box_ray(box_ray& b, const ray<double, 3>& r, double scale) noexcept {
  const vec<double, 3>& d = r.direction;
  const double reach = maximum(magnitude(d.x), maximum(magnitude(d.y), magnitude(d.z)));
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
    const float low = maximum(r.low, 0.0f);
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
        b.low = minimum(early, 0x1p100f);
        b.high = late < 0x1p100f ? late : std::numeric_limits<float>::infinity();
        return true;
      }
    }
  }
  if (r.empty()) return false;
  set_any_box_ray(b, exactly_widened(r), scale);
  return true;
}

}  // namespace IRG_ABI

// Which of a node's eight boxes a ray meets, in lanes.

// How b * gain + offset is computed: rounded twice everywhere, so that what a user's test is asked about is the same on
// every processor, or once where that is one instruction, for tests that give the same whatever they are asked.
enum class box_arithmetic { portable, fused };

// The parts of a box_ray in all lanes.
template <class F, box_arithmetic A>
struct wide_box_ray {
  F near_gain[3], far_gain[3], near_offset[3], far_offset[3], low;
  std::ptrdiff_t near_at[3], far_at[3];
};

inline namespace IRG_ABI {

template <class F, box_arithmetic A>
IRG_INLINE constexpr wide_box_ray<F, A> widen_box_ray(const box_ray& r) noexcept {
  const auto all = [](float x) { return lanes<F>::broadcast(x); };
  return {{all(r.near_gain[0]), all(r.near_gain[1]), all(r.near_gain[2])},
          {all(r.far_gain[0]), all(r.far_gain[1]), all(r.far_gain[2])},
          {all(r.near_offset[0]), all(r.near_offset[1]), all(r.near_offset[2])},
          {all(r.far_offset[0]), all(r.far_offset[1]), all(r.far_offset[2])},
          all(r.low),
          {r.near_at[0], r.near_at[1], r.near_at[2]},
          {r.far_at[0], r.far_at[1], r.far_at[2]}};
}

template <box_arithmetic A, class F>
IRG_INLINE constexpr F time_at_face(const F& bound, const F& gain, const F& offset) noexcept {
  if (A == box_arithmetic::fused && !std::is_constant_evaluated()) return fused_multiply_add(bound, gain, offset);
  if constexpr (lanes<F>::count == 1)
    return product(bound, gain) + offset;
  else
    return bound * gain + offset;
}

/// A bit for each box that the ray meets not after `high`, and when it does into `times`.
// A NaN that stands first in minimum and maximum is passed over; one that stands second takes the other limit with it,
// which makes the box larger at worst.
template <class F, box_arithmetic A>
IRG_INLINE constexpr unsigned meet_boxes(const bvh_node& node, const wide_box_ray<F, A>& r, float high,
                                         float* times) noexcept {
  unsigned bits = 0;
  for (int k = 0; k < bvh_node::width; k += lanes<F>::count) {
    const auto nearby = [&](int i) {
      return time_at_face<A>(lanes<F>::load(node.bounds + r.near_at[i] + k), r.near_gain[i], r.near_offset[i]);
    };
    const auto distant = [&](int i) {
      return time_at_face<A>(lanes<F>::load(node.bounds + r.far_at[i] + k), r.far_gain[i], r.far_offset[i]);
    };
    const F first = maximum(maximum(nearby(0), nearby(1)), maximum(nearby(2), r.low));
    const F last = minimum(minimum(distant(0), distant(1)), minimum(distant(2), lanes<F>::broadcast(high)));
    lanes<F>::store(times + k, first);
    bits |= static_cast<unsigned>(mask_bits(first <= last)) << k;
  }
  return bits;
}

template <RayCounts C>
IRG_INLINE constexpr void count_rays(C& counts, [[maybe_unused]] std::uint64_t rays) noexcept {
  if constexpr (std::same_as<C, ray_counts>) counts.rays += rays;
}
template <RayCounts C>
IRG_INLINE constexpr void count_node(C& counts) noexcept {
  if constexpr (std::same_as<C, ray_counts>) ++counts.nodes;
}
template <RayCounts C>
IRG_INLINE constexpr void count_leaf(C& counts, [[maybe_unused]] std::uint32_t leaf) noexcept {
  if constexpr (std::same_as<C, ray_counts>) {
    ++counts.leaves;
    counts.primitives += bvh_node::count_of(leaf);
  }
}

// A node leaves at most seven others waiting on each of the levels, of which there are at most 3*29 + 18.
inline constexpr int bvh_waiting = 7 * (3 * 29 + 18) + 8;

// A child and when the ray meets it, which is not before 0: in the order of times.
IRG_INLINE constexpr std::uint64_t waiting_child(std::uint32_t child, float time) noexcept {
  return std::uint64_t{std::bit_cast<std::uint32_t>(time)} << 32 | child;
}

// Where a walk stands: what waits, the next on top.
struct bvh_walk {
  std::uint64_t waiting[bvh_waiting];
  std::uint64_t* top;
};

// The leaf that comes next in the order of times, from `at` on; none at the end, and for an empty box that a ray meets
// whose times are not numbers. It stands apart from what is done with leaves, so that a ray's numbers stay in registers
// from node to node.
template <class F, box_arithmetic A, RayCounts C>
IRG_INLINE constexpr std::uint32_t next_leaf(const bvh_node* nodes, const box_ray& r, std::uint32_t at, bvh_walk& walk,
                                             C& counts) noexcept {
  const wide_box_ray<F, A> wide = widen_box_ray<F, A>(r);
  const float high = r.high;
  std::uint64_t* top = walk.top;
  const auto pop = [&]() IRG_INLINE_LAMBDA {
    std::uint64_t next = 0;
    do {
      if (top == walk.waiting) return no_index;
      next = *--top;
    } while (high < std::bit_cast<float>(static_cast<std::uint32_t>(next >> 32)));
    return static_cast<std::uint32_t>(next);
  };
  while (!bvh_node::is_leaf(at)) {
    const bvh_node& node = nodes[at];
    count_node(counts);
    float times[bvh_node::width];
    unsigned bits = meet_boxes(node, wide, high, times);
    if (bits == 0) {
      at = pop();
      continue;
    }
    unsigned k = static_cast<unsigned>(std::countr_zero(bits));
    bits &= bits - 1;
    if (bits == 0) {
      at = node.child[k];
      continue;
    }
    std::uint64_t nearest = waiting_child(node.child[k], times[k]);
    std::uint64_t* const base = top;
    do {  // the nearest is kept apart, the others stand with the latest lowest
      k = static_cast<unsigned>(std::countr_zero(bits));
      bits &= bits - 1;
      std::uint64_t child = waiting_child(node.child[k], times[k]);
      if (child < nearest) {
        const std::uint64_t farther = nearest;
        nearest = child;
        child = farther;
      }
      std::uint64_t* place = top++;
      for (; place != base && place[-1] < child; --place) *place = place[-1];
      *place = child;
    } while (bits != 0);
    at = static_cast<std::uint32_t>(nearest);
  }
  walk.top = top;
  return at;
}

template <class F, box_arithmetic A, class Visit, RayCounts C = const uncounted_rays>
IRG_INLINE constexpr void walk_sorted(const bvh_node* nodes, const box_ray& r, const Visit& visit,
                                      C& counts = not_counted) {
  bvh_walk walk;
  walk.top = walk.waiting;
  std::uint32_t at = 0;
  for (;;) {
    const std::uint32_t leaf = next_leaf<F, A>(nodes, r, at, walk, counts);
    if (leaf != no_index) {
      count_leaf(counts, leaf);
      visit(leaf);
    }
    for (;;) {
      if (walk.top == walk.waiting) return;
      const std::uint64_t next = *--walk.top;
      if (r.high < std::bit_cast<float>(static_cast<std::uint32_t>(next >> 32))) continue;
      at = static_cast<std::uint32_t>(next);
      break;
    }
  }
}

// The children whose bits are set, one behind the other from `to` on, where there is room for all.
template <class F>
IRG_INLINE constexpr void put_met(std::uint32_t* to, const bvh_node& node, unsigned bits) noexcept {
  if constexpr (lanes<F>::count == bvh_node::width) {
    store_compressed(to, lanes<pack<std::uint32_t, bvh_node::width>>::load(node.child), bits);
  } else {
    for (int k = 0; k < bvh_node::width; ++k) {
      *to = node.child[k];
      to += bits >> k & 1;
    }
  }
}

// The last child that is met comes next, or what waits on top where none is: both are known without a branch, which
// would be guessed wrong at most nodes. So all wait for a moment, and the next is taken from the node itself. Below
// stands what tells the end; an empty box that a ray meets whose times are not numbers is told from that.
template <class F, box_arithmetic A, class Visit, RayCounts C = const uncounted_rays>
IRG_INLINE constexpr bool walk_unsorted(const bvh_node* nodes, const box_ray& r, const Visit& visit,
                                        C& counts = not_counted) {
  const wide_box_ray<F, A> wide = widen_box_ray<F, A>(r);
  std::uint32_t waiting[bvh_waiting + bvh_node::width];
  waiting[0] = no_index;
  const float high = r.high;
  std::uint32_t* top = waiting + 1;
  std::uint32_t at = 0;
  for (;;) {
    while (!bvh_node::is_leaf(at)) {
      const bvh_node& node = nodes[at];
      const std::uint32_t waits = top[-1];
      count_node(counts);
      float times[bvh_node::width];
      const unsigned bits = meet_boxes(node, wide, high, times);
      const std::uint32_t met = node.child[static_cast<unsigned>(std::bit_width(bits | 1)) - 1];
      put_met<F>(top, node, bits);
      top += std::popcount(bits) - 1;
      at = bits != 0 ? met : waits;
    }
    if (at != no_index) {
      count_leaf(counts, at);
      if (visit(at)) return true;
    } else if (top == waiting) {
      return false;
    }
    at = *--top;
  }
}

IRG_INLINE constexpr bool walks_in_packets() noexcept { return !std::is_constant_evaluated(); }
IRG_INLINE constexpr bool walks_in_lanes() noexcept { return has_lanes && !std::is_constant_evaluated(); }

}  // namespace IRG_ABI
}  // namespace irg::detail
