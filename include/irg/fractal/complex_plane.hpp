// SPDX-License-Identifier: MIT
// complex_plane<T>: the number that belongs to each pixel of a picture of the complex plane.
#pragma once

#include <irg/core/contract.hpp>
#include <irg/core/lanes.hpp>
#include <irg/math/vec.hpp>
#include <irg/view/view_window.hpp>

namespace irg {

/// Where in a pixel its number lies.
enum class plane_sampling {
  inclusive,  // the first and last column are the borders themselves: width - 1 steps (the lecture's)
  centres     // the pixel's centre: width steps
};

/// The picture of a rectangle of the complex plane: columns from left to right, rows from top to bottom.
/// needs   width and height at least 1, for `inclusive` 2 unless that side of the window has no length
template <Floating T>
struct complex_plane {
  view_window<T> window{};
  int width = 0, height = 0;
  plane_sampling sampling = plane_sampling::inclusive;

  /// The real part of column x, a number or a pack of them.
  /// exact   (right - left) / (width - 1) * x + left, each operation rounded
  template <class F>
  [[nodiscard]] IRG_INLINE constexpr F real(const F& x) const noexcept {
    return along(window.left, window.right, width, x);
  }
  /// The imaginary part of row y from the top.
  /// exact   (top - bottom) / (height - 1) * (height - 1 - y) + bottom, each operation rounded: as counted from below
  template <class F>
  [[nodiscard]] IRG_INLINE constexpr F imaginary(const F& y) const noexcept {
    return along(window.bottom, window.top, height, lanes<F>::broadcast(static_cast<T>(height - 1)) - y);
  }
  /// The number of a pixel.
  [[nodiscard]] IRG_INLINE constexpr point<T, 2> at(int x, int y) const noexcept {
    return {real(static_cast<T>(x)), imaginary(static_cast<T>(y))};
  }
  bool operator==(const complex_plane&) const = default;

private:
  template <class F>
  [[nodiscard]] IRG_INLINE constexpr F along(T first, T last, int count, const F& i) const noexcept {
    using f = lanes<F>;
    const bool inclusive = sampling == plane_sampling::inclusive;
    const int steps = inclusive && count > 1 ? count - 1 : count;
    const F place = inclusive ? i : i + f::broadcast(T(0.5));
    return product(f::broadcast((last - first) / static_cast<T>(steps)), place) + f::broadcast(first);
  }
};

}  // namespace irg
