// SPDX-License-Identifier: MIT
// Sixteen rays that go about the same way, walked through a tree as one: a box_ray that reaches near faces no later and
// far faces no earlier than any of them. What it meets is asked of each ray, in lanes.
//
// The least gain and the farthest origin give the earliest time at a near face beyond the origins, the largest gain and
// the nearest origin the latest at a far face; before the origins both are negative, as those of all rays are.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>

#include <irg/core/lanes.hpp>
#include <irg/spatial/detail/walk_bvh_kernel.hpp>

namespace irg::detail {

// Lows and highs are of rays' times times the tree's scale.
struct ray_packet {
  static constexpr int size = 16;

  float near_gain[3][size], far_gain[3][size], near_offset[3][size], far_offset[3][size], low[size], high[size];
  box_ray whole;  // all of them
};

inline namespace IRG_ABI {

using packet_lanes = pack<float, native_lanes<float>>;

// Where all rays of a packet go forward along an axis, or all go backward: their numbers, and those of the whole. Gives
// whether they do, by numbers of middling size.
// A direction of 0 is as in turn_standing_axes.
IRG_INLINE bool set_up_packet_axis(ray_packet& p, int axis, const float* origins, const float* directions,
                                   unsigned& standing) noexcept {
  using F = packet_lanes;
  const auto all = [](float x) { return lanes<F>::broadcast(x); };
  constexpr float infinite = std::numeric_limits<float>::infinity();
  F least_near = all(infinite), most_far = all(-infinite);
  F least_origin = all(infinite), most_origin = all(-infinite);
  unsigned back = 0, good = 0, still = 0;
  for (int k = 0; k < ray_packet::size; k += lanes<F>::count) {
    const F o = lanes<F>::load(origins + k), given = lanes<F>::load(directions + k);
    const auto stands = given == all(0.0f);
    const F one = bits_as<float>((bits_as<std::int32_t>(given) & (std::numeric_limits<std::int32_t>::min)()) |
                                 bits_as<std::int32_t>(all(1.0f)));
    const F d = select(stands, one * all(0x1p-120f), given);
    good |= static_cast<unsigned>(
                mask_bits(both(magnitude(o) <= all(0x1p20f),
                               both(magnitude(d) <= all(0x1p20f), (magnitude(given) >= all(0x1p-60f)) | stands))))
            << k;
    back |= static_cast<unsigned>(sign_bits(given)) << k;
    still |= static_cast<unsigned>(mask_bits(stands)) << k;
    const F gain = all(1.0f) / d, longer = all(1 + 0x1p-20f);
    const F to_origin = o * gain, slack = step_of_origin(o) * magnitude(gain);
    const F far_gain = gain * longer;
    lanes<F>::store(p.near_gain[axis] + k, gain);
    lanes<F>::store(p.far_gain[axis] + k, far_gain);
    lanes<F>::store(p.near_offset[axis] + k, (-to_origin) - slack);
    lanes<F>::store(p.far_offset[axis] + k, (slack - to_origin) * longer);
    least_near = minimum(magnitude(gain), least_near);
    most_far = maximum(magnitude(far_gain), most_far);
    least_origin = minimum(o, least_origin);
    most_origin = maximum(o, most_origin);
  }
  standing &= still;
  constexpr unsigned every = (1u << ray_packet::size) - 1;
  if (good != every || (back != 0 && back != every)) return false;
  const float low_gain = reduce_min(least_near), high_gain = reduce_max(most_far);
  const float low_origin = reduce_min(least_origin), high_origin = reduce_max(most_origin);
  const float sign = back != 0 ? -1.0f : 1.0f;
  const float last = back != 0 ? -low_origin : high_origin, first = back != 0 ? -high_origin : low_origin;
  p.whole.near_gain[axis] = sign * low_gain;
  p.whole.far_gain[axis] = sign * high_gain;
  p.whole.near_offset[axis] = 0.0f - product(last, low_gain) - product(step_of_origin(last), low_gain);
  p.whole.far_offset[axis] = product(step_of_origin(first), high_gain) - product(first, high_gain);
  const std::ptrdiff_t side = back != 0 ? 3 : 0;
  p.whole.near_at[axis] = (axis + side) * bvh_node::width;
  p.whole.far_at[axis] = (axis + 3 - side) * bvh_node::width;
  return true;
}

IRG_INLINE float latest_of(const ray_packet& p) noexcept {
  using F = packet_lanes;
  F most = lanes<F>::load(p.high);
  for (int k = lanes<F>::count; k < ray_packet::size; k += lanes<F>::count)
    most = maximum(lanes<F>::load(p.high + k), most);
  return reduce_max(most);
}

// The rays' lows and highs as the boxes', on the safe side. Gives whether all are in order.
IRG_INLINE bool set_up_packet_times(ray_packet& p, float scale) noexcept {
  using F = packet_lanes;
  const auto all = [](float x) { return lanes<F>::broadcast(x); };
  constexpr float infinite = std::numeric_limits<float>::infinity();
  const F zero = all(0.0f), much = all(0x1p100f);
  F least = all(infinite), most = zero;
  unsigned good = 0;
  for (int k = 0; k < ray_packet::size; k += lanes<F>::count) {
    const F low = lanes<F>::load(p.low + k), high = lanes<F>::load(p.high + k);
    good |= static_cast<unsigned>(mask_bits(both(maximum(low, zero) <= high, low <= much))) << k;
    const F early = minimum(maximum(low * all(1 - 0x1p-20f) * all(scale), zero), much);
    const F late = high * all(1 + 0x1p-20f) * all(scale) + all(0x1p-74f);
    const F last = select(late < much, late, all(infinite));
    lanes<F>::store(p.low + k, early);
    lanes<F>::store(p.high + k, last);
    least = minimum(early, least);
    most = maximum(last, most);
  }
  p.whole.low = reduce_min(least);
  p.whole.high = reduce_max(most);
  return good == (1u << ray_packet::size) - 1;
}

// Gives whether the rays can go as one: they are not empty, go the same way along each axis, and their numbers are of
// middling size.
IRG_INLINE bool set_up_packet(ray_packet& p, const ray<float, 3>* rays, double scale) noexcept {
  constexpr std::uint64_t least = 1023 - 50, range = 100;
  if ((std::bit_cast<std::uint64_t>(scale) >> 52) - least > range) return false;
  const float s = static_cast<float>(scale);
  alignas(32) float origins[3][ray_packet::size], directions[3][ray_packet::size];
  for (int k = 0; k < ray_packet::size; ++k) {
    const ray<float, 3>& r = rays[k];
    prefetch(rays + k, ray_packet::size * sizeof r);
    for (int axis = 0; axis < 3; ++axis) {
      origins[axis][k] = r.origin[axis] * s;
      directions[axis][k] = r.direction[axis];
    }
    p.low[k] = r.low;
    p.high[k] = r.high;
  }
  unsigned stands = (1u << ray_packet::size) - 1;  // rays without a direction
  for (int axis = 0; axis < 3; ++axis)
    if (!set_up_packet_axis(p, axis, origins[axis], directions[axis], stands)) return false;
  p.whole.unit = exponent_of(scale);
  return set_up_packet_times(p, s) && stands == 0;
}

// A bit for each ray that meets box k of a node.
IRG_INLINE unsigned rays_at_box(const ray_packet& p, const bvh_node& node, std::uint32_t k) noexcept {
  using F = packet_lanes;
  const auto bound = [&](std::ptrdiff_t at) {
    return lanes<F>::broadcast(node.bounds[at + static_cast<std::ptrdiff_t>(k)]);
  };
  const F near_bound[3] = {bound(p.whole.near_at[0]), bound(p.whole.near_at[1]), bound(p.whole.near_at[2])};
  const F far_bound[3] = {bound(p.whole.far_at[0]), bound(p.whole.far_at[1]), bound(p.whole.far_at[2])};
  unsigned bits = 0;
  for (int i = 0; i < ray_packet::size; i += lanes<F>::count) {
    F first = lanes<F>::load(p.low + i), last = lanes<F>::load(p.high + i);
    for (int axis = 0; axis < 3; ++axis) {
      const F nearby = fused_multiply_add(near_bound[axis], lanes<F>::load(p.near_gain[axis] + i),
                                          lanes<F>::load(p.near_offset[axis] + i));
      const F distant = fused_multiply_add(far_bound[axis], lanes<F>::load(p.far_gain[axis] + i),
                                           lanes<F>::load(p.far_offset[axis] + i));
      first = maximum(nearby, first);
      last = minimum(distant, last);
    }
    bits |= static_cast<unsigned>(mask_bits(first <= last)) << i;
  }
  return bits;
}

// Calls visit(child, bits) for the leaves that rays meet, whose bits are set; those near their beginning first. visit
// may make p.high and p.whole.high less.
// What waits is a place in a node: eight times its number, and which child.
template <class Visit, RayCounts C>
IRG_INLINE void walk_packet(const bvh_node* nodes, ray_packet& p, C& counts, const Visit& visit) {
  using F = packet_lanes;
  const auto wide = widen_box_ray<F, box_arithmetic::fused>(p.whole);
  std::uint64_t waiting[bvh_waiting];
  std::uint64_t* top = waiting;
  std::uint32_t at = 0;
  for (;;) {
    const bvh_node& node = nodes[at];
    count_node(counts);
    float times[bvh_node::width];
    std::uint64_t* const base = top;
    for (unsigned bits = meet_boxes(node, wide, p.whole.high, times); bits != 0; bits &= bits - 1) {
      const auto k = static_cast<std::uint32_t>(std::countr_zero(bits));
      const std::uint64_t entry = waiting_child(at * bvh_node::width + k, times[k]);
      std::uint64_t* place = top++;
      for (; place != base && place[-1] < entry; --place) *place = place[-1];
      *place = entry;
    }
    for (;;) {
      if (top == waiting) return;
      const std::uint64_t next = *--top;
      if (p.whole.high < std::bit_cast<float>(static_cast<std::uint32_t>(next >> 32))) continue;
      const auto slot = static_cast<std::uint32_t>(next);
      const bvh_node& parent = nodes[slot / bvh_node::width];
      const std::uint32_t k = slot % bvh_node::width, child = parent.child[k];
      const unsigned rays = rays_at_box(p, parent, k);
      if (rays == 0 || child == no_index) continue;
      if (!bvh_node::is_leaf(child)) {
        at = child;
        break;
      }
      count_leaf(counts, child);
      visit(child, rays);
    }
  }
}

}  // namespace IRG_ABI
}  // namespace irg::detail
