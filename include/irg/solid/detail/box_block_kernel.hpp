// SPDX-License-Identifier: MIT
// Eight boxes side by side, as they are seen from above with their tops, and which of them a ray upward may meet.
#pragma once

#include <limits>
#include <type_traits>

#include <irg/core/lanes.hpp>
#include <irg/math/vec.hpp>

namespace irg::detail {

template <Floating T>
struct IRG_APART box_block {
  static constexpr int width = 8;
  T low[2][width], high[2][width], top[width];

  /// No boxes.
  constexpr box_block() noexcept {
    constexpr T most = (std::numeric_limits<T>::max)();
    for (int i = 0; i < width; ++i) {
      low[0][i] = low[1][i] = most;
      high[0][i] = high[1][i] = top[i] = -most;
    }
  }

  IRG_INLINE constexpr void enclose(int i, T x, T y, T z) noexcept {
    low[0][i] = lesser(low[0][i], x), high[0][i] = greater(high[0][i], x);
    low[1][i] = lesser(low[1][i], y), high[1][i] = greater(high[1][i], y);
    top[i] = greater(top[i], z);
  }
  /// The box round all of another block becomes part of box i.
  constexpr void enclose(int i, const box_block& b) noexcept {
    for (int k = 0; k < width; ++k)
      if (b.low[0][k] <= b.high[0][k]) {
        enclose(i, b.low[0][k], b.low[1][k], b.top[k]);
        enclose(i, b.high[0][k], b.high[1][k], b.top[k]);
      }
  }
};

inline namespace IRG_ABI {

/// A bit for each box that is not beside or below p.
template <class F, class T>
IRG_INLINE constexpr unsigned ask_boxes(const box_block<T>& b, const point<T, 3>& p) noexcept {
  using f = lanes<F>;
  const F x = f::broadcast(p.x), y = f::broadcast(p.y), z = f::broadcast(p.z);
  unsigned bits = 0;
  for (int k = 0; k < box_block<T>::width; k += f::count) {
    const auto in_x = both(f::load(b.low[0] + k) <= x, x <= f::load(b.high[0] + k));
    const auto in_y = both(f::load(b.low[1] + k) <= y, y <= f::load(b.high[1] + k));
    bits |= static_cast<unsigned>(mask_bits(both(both(in_x, in_y), z <= f::load(b.top + k)))) << k;
  }
  return bits;
}

template <class T>
IRG_INLINE constexpr unsigned boxes_over(const box_block<T>& b, const point<T, 3>& p) noexcept {
  if (!has_lanes || std::is_constant_evaluated()) return ask_boxes<T>(b, p);
  return ask_boxes<pack<T, lesser(box_block<T>::width, native_lanes<T>)>>(b, p);
}

}  // namespace IRG_ABI
}  // namespace irg::detail
