// SPDX-License-Identifier: MIT
// viewport: from clip space to pixels. Pixel (i, j) covers [i, i+1] x [j, j+1] with its centre at (i + 0.5, j + 0.5); x
// runs to the right, y down.
#pragma once

#include <irg/math/mat.hpp>

namespace irg {

/// The rectangle of the image that a picture fills; (x, y) is its upper left corner.
/// units   pixels, not necessarily whole ones
template <Real T>
struct viewport {
  T x{}, y{}, width{}, height{};
  bool operator==(const viewport&) const = default;
};

inline namespace IRG_ABI {

/// Where a normalised position (x and y in [-1, 1], y up) lies in the image; its depth is kept.
/// exact   corners and centre exactly where x, y, width/2 and height/2 add up without rounding; never outside of the
///         viewport by more than the rounding of its own borders
template <class T>
[[nodiscard]] IRG_INLINE constexpr point<T, 3> to_pixels(const viewport<T>& v, const point<T, 3>& p) noexcept {
  const T half_width = v.width / T(2), half_height = v.height / T(2);
  return {v.x + half_width + product(half_width, p.x), v.y + half_height - product(half_height, p.y), p.z};
}

/// Where a position in clip space lies in the image, and its depth z/w.
/// needs   w != 0; what clip_homogeneous leaves has w > 0
template <class T>
[[nodiscard]] IRG_INLINE constexpr point<T, 3> to_pixels(const viewport<T>& v, const hpoint<T, 3>& p) noexcept {
  return to_pixels(v, to_cartesian(p));
}

/// The normalised position of a place in the image: the inverse of to_pixels.
/// needs   width != 0 and height != 0
template <class T>
[[nodiscard]] IRG_INLINE constexpr point<T, 2> from_pixels(const viewport<T>& v, const point<T, 2>& p) noexcept {
  const T half_width = v.width / T(2), half_height = v.height / T(2);
  return {(p.x - (v.x + half_width)) / half_width, (v.y + half_height - p.y) / half_height};
}

/// The matrix that does what to_pixels does to normalised positions, for composition with a projection.
template <class T>
[[nodiscard]] constexpr mat<T, 4, 4> viewport_matrix(const viewport<T>& v) noexcept {
  auto m = identity_matrix<T, 4>();
  m(0, 0) = v.width / T(2);
  m(1, 1) = T(0) - v.height / T(2);
  m(0, 3) = v.x + v.width / T(2);
  m(1, 3) = v.y + v.height / T(2);
  return m;
}

}  // namespace IRG_ABI
}  // namespace irg
