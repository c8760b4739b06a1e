// SPDX-License-Identifier: MIT
// The five steps of the lecture's view transform, each a matrix for row vectors, [x y z 1] * T, and what a row times a
// matrix is. view_transform.hpp puts them together.
#pragma once

#include <irg/math/length.hpp>
#include <irg/math/mat.hpp>

namespace irg::textbook::inline IRG_ABI {

/// The position [x y z 1] * m.
/// needs   an affine m: its last column is not read
template <class T>
[[nodiscard]] IRG_INLINE constexpr point<T, 3> transform_row(const point<T, 3>& p, const mat<T, 4, 4>& m) noexcept {
  const auto column = [&](int c) { return vec<T, 3>{m(0, c), m(1, c), m(2, c)}; };
  return generate_coordinates<point<T, 3>>([&](int c) { return dot(to_vec(p), column(c)) + m(3, c); });
}

/// The homogeneous position [x y z w] * m.
template <class T>
[[nodiscard]] IRG_INLINE constexpr hpoint<T, 3> transform_row(const hpoint<T, 3>& p, const mat<T, 4, 4>& m) noexcept {
  const vec<T, 4> row{p.x, p.y, p.z, p.w};
  return generate_coordinates<hpoint<T, 3>>(
      [&](int c) { return dot(row, vec<T, 4>{m(0, c), m(1, c), m(2, c), m(3, c)}); });
}

/// T1 (5.2): moves the eye into the origin.
template <Floating T>
[[nodiscard]] constexpr mat<T, 4, 4> view_translation(const point<T, 3>& eye) noexcept {
  auto m = identity_matrix<T, 4>();
  for (int i = 0; i < 3; ++i) m(3, i) = T(0) - eye[i];
  return m;
}

/// T2 (5.3): turns about z until the view point g1 has y = 0 and x >= 0.
/// gives   the identity when x and y are both 0, or one is NaN or infinite
/// exact   sine and cosine within 1.02 ulp
template <Floating T>
[[nodiscard]] constexpr mat<T, 4, 4> view_rotation_z(const point<T, 3>& g1) noexcept {
  const auto d = try_normalized(vec<T, 2>{g1.x, g1.y});
  if (!d) return identity_matrix<T, 4>();
  return {{{d->x, T(0) - d->y, 0, 0}, {d->y, d->x, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}}};
}

/// T3 (5.4): turns about y until the view point g2 lies on the positive z axis.
/// needs   g2.y = 0, as T2 leaves it
/// gives   the identity when x and z are both 0, or one is NaN or infinite
/// exact   sine and cosine within 1.02 ulp
template <Floating T>
[[nodiscard]] constexpr mat<T, 4, 4> view_rotation_y(const point<T, 3>& g2) noexcept {
  const auto d = try_normalized(vec<T, 2>{g2.z, g2.x});  // cosine, sine
  if (!d) return identity_matrix<T, 4>();
  return {{{d->x, 0, d->y, 0}, {0, 1, 0, 0}, {T(0) - d->y, 0, d->x, 0}, {0, 0, 0, 1}}};
}

/// T4 (5.5): a quarter turn about z, (x, y) to (y, -x).
template <Floating T>
[[nodiscard]] constexpr mat<T, 4, 4> view_quarter_turn() noexcept {
  return {{{0, -1, 0, 0}, {1, 0, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}}};
}

/// T5 (5.5): x to -x, the step from the right-handed scene to the left-handed eye.
template <Floating T>
[[nodiscard]] constexpr mat<T, 4, 4> view_mirror() noexcept {
  return {{{-1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}}};
}

}  // namespace irg::textbook::inline IRG_ABI
