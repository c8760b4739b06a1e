// SPDX-License-Identifier: MIT
// Boxes as a bvh keeps and sorts them: floats round the given ones, in the tree's units.
//
// Coordinates are multiples of 2^-100, at most 1 in size, so that no difference of two of them is subnormal: rays need
// not ask what a processor makes of such numbers.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <type_traits>
#include <vector>

#include <irg/core/conversion.hpp>
#include <irg/core/executor.hpp>
#include <irg/core/lanes.hpp>
#include <irg/geometry/box.hpp>
#include <irg/math/error_free.hpp>
#include <irg/spatial/bvh_node.hpp>

namespace irg::detail {
inline namespace IRG_ABI {

// The inner loops of building a bvh, in lanes.

// The lesser of 8 floats each.
template <class F>
IRG_INLINE constexpr void grow_by(float* around, const float* item) noexcept {
  for (int i = 0; i < 8; i += lanes<F>::count)
    lanes<F>::store(around + i, minimum(lanes<F>::load(item + i), lanes<F>::load(around + i)));
}
IRG_INLINE constexpr void grow_kernel(float* around, const float* item) noexcept {
  if (std::is_constant_evaluated())
    grow_by<float>(around, item);
  else
    grow_by<pack<float, native_lanes<float>>>(around, item);
}

// Twice the centre of an item, and that of the primitive's number, which is of no use: low + high.
template <class F>
IRG_INLINE constexpr void centre_by(float* centre, const float* item) noexcept {
  for (int i = 0; i < 4; i += lanes<F>::count)
    lanes<F>::store(centre + i, lanes<F>::load(item + i) - lanes<F>::load(item + 4 + i));
}
IRG_INLINE constexpr void centre_kernel(float* centre, const float* item) noexcept {
  if (std::is_constant_evaluated())
    centre_by<float>(centre, item);
  else
    centre_by<pack<float, 4>>(centre, item);
}

// The bins of an item along the axes: those of its centre.
template <class F>
IRG_INLINE constexpr void bins_by(std::int32_t* bin, const float* item, const float* least, const float* gain,
                                  std::int32_t last) noexcept {
  using J = typename lanes<F>::template rebind<std::int32_t>;
  for (int i = 0; i < 4; i += lanes<F>::count) {
    const F at = (lanes<F>::load(item + i) - lanes<F>::load(item + 4 + i)) - lanes<F>::load(least + i);
    const F place = minimum(at * lanes<F>::load(gain + i), lanes<F>::broadcast(static_cast<float>(last)));
    lanes<J>::store(bin + i, converted<std::int32_t>(place));
  }
}
IRG_INLINE constexpr void bins_kernel(std::int32_t* bin, const float* item, const float* least, const float* gain,
                                      std::int32_t last) noexcept {
  if (std::is_constant_evaluated())
    bins_by<float>(bin, item, least, gain, last);
  else
    bins_by<pack<float, 4>>(bin, item, least, gain, last);
}

}  // namespace IRG_ABI

// A box: lows and negated highs, so that one lesser-of makes it larger. Places 3 and 7 hold the primitive's number in
// two halves, as whole numbers.
struct alignas(32) bvh_item {
  float v[8];

  bool operator==(const bvh_item&) const = default;
};

inline namespace IRG_ABI {

// The float next to x on the far side: not above it. 0 has no sign.
IRG_INLINE constexpr float float_below(double x) noexcept {
  constexpr double least = 0x1p-76;
  if (!(magnitude(x) >= least)) return x < 0 ? -0x1p-76f : 0.0f;
  const float f = converted<float>(x);
  if (widened(f) <= x) return f;
  const auto bits = std::bit_cast<std::uint32_t>(f);
  return std::bit_cast<float>(f < 0.0f ? bits + 1 : bits - 1);
}

template <Floating T>
IRG_INLINE constexpr bool is_held(const box<T, 3>& b) noexcept {
  bool held = true;
  constexpr T most = (std::numeric_limits<T>::max)();
  for (int i = 0; i < 3; ++i) held = held && -most <= b.low[i] && b.low[i] <= b.high[i] && b.high[i] <= most;
  return held;
}

IRG_INLINE constexpr bvh_item empty_item() noexcept {
  constexpr float most = std::numeric_limits<float>::infinity();
  return {{most, most, most, most, most, most, most, most}};
}

template <Floating T>
IRG_INLINE constexpr bvh_item item_of(const box<T, 3>& b, std::uint32_t number, double scale) noexcept {
  if (!is_held(b)) return empty_item();
  bvh_item item{};
  for (int i = 0; i < 3; ++i) {
    item.v[i] = float_below(exactly_widened(b.low[i]) * scale);
    item.v[4 + i] = float_below(-exactly_widened(b.high[i]) * scale);
  }
  item.v[3] = static_cast<float>(number & 0xffff);
  item.v[7] = static_cast<float>(number >> 16);
  return item;
}

IRG_INLINE constexpr std::uint32_t number_of(const bvh_item& item) noexcept {
  return static_cast<std::uint32_t>(item.v[3]) | static_cast<std::uint32_t>(item.v[7]) << 16;
}

IRG_INLINE constexpr void grow(bvh_item& around, const bvh_item& item) noexcept { grow_kernel(around.v, item.v); }

IRG_INLINE constexpr void set_child(bvh_node& node, int k, std::uint32_t child, const bvh_item& b) noexcept {
  node.child[k] = child;
  for (int i = 0; i < 3; ++i) {
    node.low(i, k) = b.v[i];
    node.high(i, k) = 0.0f - b.v[4 + i];
  }
}

IRG_INLINE constexpr bvh_item box_round(const bvh_node& node) noexcept {
  bvh_item b = empty_item();
  for (int k = 0; k < bvh_node::width; ++k)
    for (int i = 0; i < 3; ++i) {
      b.v[i] = minimum(b.v[i], node.low(i, k));
      b.v[4 + i] = minimum(b.v[4 + i], 0.0f - node.high(i, k));
    }
  return b;
}

// The power of two by which no coordinate of the boxes is larger than 1; tiny ones stay tiny.
template <Floating T>
constexpr void rescale(bvh& tree, std::span<const box<T, 3>> boxes) noexcept {
  double most = 0x1p-1000;
  for (const box<T, 3>& b : boxes)
    if (is_held(b))
      for (int i = 0; i < 3; ++i)
        most = maximum(most, maximum(magnitude(exactly_widened(b.low[i])), magnitude(exactly_widened(b.high[i]))));
  tree.scale = power_of_two(-(exponent_of(most) + 1) < -1022 ? -1022 : -(exponent_of(most) + 1));
}

// How many boxes a task takes when work is spread.
inline constexpr std::size_t bvh_portion = 16384;

template <Floating T, class E>
constexpr std::vector<bvh_item> make_items(std::span<const box<T, 3>> boxes, bvh& tree, const E& executor) {
  rescale(tree, boxes);
  std::vector<bvh_item> items(boxes.size(), bvh_item{});
  executor((boxes.size() + bvh_portion - 1) / bvh_portion, [&](std::size_t task) {
    const std::size_t last = (task + 1) * bvh_portion < boxes.size() ? (task + 1) * bvh_portion : boxes.size();
    for (std::size_t i = task * bvh_portion; i < last; ++i)
      items[i] = item_of(boxes[i], static_cast<std::uint32_t>(i), tree.scale);
  });
  std::size_t kept = 0;
  for (std::size_t i = 0; i < items.size(); ++i)
    if (items[i].v[0] <= 1.0f) {
      if (kept != i) items[kept] = items[i];
      ++kept;
    }
  items.resize(kept);
  return items;
}

}  // namespace IRG_ABI
}  // namespace irg::detail
