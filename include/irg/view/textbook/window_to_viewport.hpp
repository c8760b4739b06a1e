// SPDX-License-Identifier: MIT
// Window to viewport by Hank's formula.
#pragma once

#include <irg/view/window_to_viewport.hpp>

namespace irg::textbook {

/// A window as Hank writes it: its left and upper edge, width and height. For its formula to be right `top` must
/// be the negated height of the upper edge.
template <Real T>
struct edged_window {
  T left{}, top{}, width{T(1)}, height{T(1)};
  bool operator==(const edged_window&) const = default;
};

inline namespace IRG_ABI {

/// Hank's own formula: ((x - left) * (VW / width) + VL, (-y - top) * (VH / height) + VT).
/// needs   width and height that are not 0
/// exact   in rationals; in floats each operation is rounded once
/// source  Hank n.d., 4.2.2
template <Real T>
[[nodiscard]] constexpr point<T, 2> to_pixels(const edged_window<T>& window, const viewport<T>& view,
                                              const point<T, 2>& p) noexcept {
  return {product(p.x - window.left, view.width / window.width) + view.x,
          product(-p.y - window.top, view.height / window.height) + view.y};
}

}  // namespace IRG_ABI
}  // namespace irg::textbook
