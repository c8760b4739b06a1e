// SPDX-License-Identifier: MIT
// The lecture's view transform T = T1 T2 T3 T4 T5, for row vectors: [x y z 1] * T. The scene is right-handed with z up;
// the eye's system is left-handed: x to the right, y up, z the distance along the view. T takes the eye to the origin
// and the view point to (0, 0, H). view_steps.hpp has each step. look_at is the same camera for column vectors,
// right-handed: its rows are T's columns, the third one negated.
#pragma once

#include <limits>

#include <irg/core/conversion.hpp>
#include <irg/math/hypot.hpp>
#include <irg/view/look_at.hpp>
#include <irg/view/textbook/view_steps.hpp>

namespace irg::textbook {

/// What an eye and a view point amount to.
enum class [[nodiscard]] view_status {
  ok,
  view_vertical,  // along the scene's z axis, where the lecture divides 0 by 0: sin 0, cos 1 took its place in T2
  eye_at_view_point,  // there is no direction: T2 and T3 are identities, the view goes along the scene's z, H = 0
  not_finite,  // a coordinate is NaN, infinite or beyond a quarter of the largest number: every step is the identity
  ordinary [[deprecated("irg: ordinary is now ok")]] = ok
};

/// The five steps, where they take the view point, and H.
template <Floating T>
struct view_steps {
  mat<T, 4, 4> t1 = identity_matrix<T, 4>(), t2 = t1, t3 = t1, t4 = t1, t5 = t1;
  point<T, 3> g1{}, g2{}, g3{};  // the view point after T1, T2 and T3; T4 and T5 leave it
  T h{};  // the distance from the eye to the view point, where the picture plane is
  view_status status = view_status::not_finite;
  bool operator==(const view_steps&) const = default;
};

inline namespace IRG_ABI {

/// All five steps for an eye and the view point it looks at, the view point's way through them, and H.
/// gives   every status of view_status; all numbers finite always
/// exact   h within 0.501 ulp of the length of the rounded difference; T2 and T3 orthonormal within 4u, however near or
///         far the view point (u = 2^-53, float 2^-24)
template <Floating T>
[[nodiscard]] constexpr view_steps<T> view_transform_steps(const point<T, 3>& eye,
                                                           const point<T, 3>& view_point) noexcept {
  using limits = std::numeric_limits<T>;
  view_steps<T> s;
  if (!detail::within(eye, (limits::max)() / 4) || !detail::within(view_point, (limits::max)() / 4)) return s;
  const vec<T, 3> d = view_point - eye;
  s.status = d == vec<T, 3>{}             ? view_status::eye_at_view_point
             : d.x == T(0) && d.y == T(0) ? view_status::view_vertical
                                          : view_status::ok;
  s.t1 = view_translation(eye);
  s.g1 = to_point(d);
  s.t2 = view_rotation_z(s.g1);
  s.g2 = {hypot(d.x, d.y), T(0), d.z};
  // Among subnormal numbers the length of (x, y) would be rounded too coarsely for an angle.
  constexpr bool single = std::same_as<T, float>;
  constexpr T tiny = single ? T(0x1p-100f) : T(0x1p-900), up = single ? T(0x1p100f) : T(0x1p900);
  const bool is_tiny = detail::within(d, tiny);
  s.t3 = view_rotation_y(is_tiny ? point<T, 3>{hypot(d.x * up, d.y * up), T(0), d.z * up} : s.g2);
  s.h = length(d);
  s.g3 = {T(0), T(0), s.h};
  s.t4 = view_quarter_turn<T>();
  s.t5 = view_mirror<T>();
  return s;
}

/// T = T1 T2 T3 T4 T5 (5.6): scene to eye, for row vectors. Multiplied from right to left: then what the eye loses to
/// rounding in the turns, it has lost in T's last row as well.
/// gives   a finite matrix always; view_transform_steps says what stands in for what
/// exact   the upper 3x3 block orthonormal within 8u, of determinant -1 within 16u; transform_row takes the eye
///         to the origin exactly
/// source  Mihajlovic 2016, 5.1 to 5.6
template <Floating T>
[[nodiscard]] constexpr mat<T, 4, 4> view_transform(const point<T, 3>& eye, const point<T, 3>& view_point) noexcept {
  const view_steps<T> s = view_transform_steps(eye, view_point);
  return s.t1 * (s.t2 * (s.t3 * (s.t4 * s.t5)));
}

}  // namespace IRG_ABI
}  // namespace irg::textbook
