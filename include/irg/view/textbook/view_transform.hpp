// SPDX-License-Identifier: MIT
// The lecture's view transform T = T1 T2 T3 T4 T5 and projection P, for row vectors: [x y z 1] * T. The scene is
// right-handed with z up; the eye's system is left-handed: x to the right, y up, z the distance along the view. T takes
// the eye to the origin and the view point to (0, 0, H). Each step is a function of its own. look_at is the same camera
// for column vectors, right-handed: its rows are T's columns, the third one negated.
#pragma once

#include <limits>
#include <optional>

#include <irg/core/conversion.hpp>
#include <irg/math/error_free.hpp>
#include <irg/math/hypot.hpp>
#include <irg/math/length.hpp>
#include <irg/math/mat.hpp>
#include <irg/view/look_at.hpp>

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
  mat<T, 4, 4> t1 = identity<T, 4>(), t2 = t1, t3 = t1, t4 = t1, t5 = t1;
  point<T, 3> g1{}, g2{}, g3{};  // the view point after T1, T2 and T3; T4 and T5 leave it
  T h{};  // the distance from the eye to the view point, where the picture plane is
  view_status status = view_status::not_finite;
  constexpr bool operator==(const view_steps&) const = default;
};

inline namespace IRG_ABI {

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
  auto m = identity<T, 4>();
  for (int i = 0; i < 3; ++i) m(3, i) = T(0) - eye[i];
  return m;
}

/// T2 (5.3): turns about z until the view point g1 has y = 0 and x >= 0.
/// gives   the identity when x and y are both 0, or one is NaN or infinite
/// exact   sine and cosine within 1.02 ulp
template <Floating T>
[[nodiscard]] constexpr mat<T, 4, 4> view_rotation_z(const point<T, 3>& g1) noexcept {
  const auto d = try_normalized(vec<T, 2>{g1.x, g1.y});
  if (!d) return identity<T, 4>();
  return {{{d->x, T(0) - d->y, 0, 0}, {d->y, d->x, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}}};
}

/// T3 (5.4): turns about y until the view point g2 lies on the positive z axis.
/// needs   g2.y = 0, as T2 leaves it
/// gives   the identity when x and z are both 0, or one is NaN or infinite
/// exact   sine and cosine within 1.02 ulp
template <Floating T>
[[nodiscard]] constexpr mat<T, 4, 4> view_rotation_y(const point<T, 3>& g2) noexcept {
  const auto d = try_normalized(vec<T, 2>{g2.z, g2.x});  // cosine, sine
  if (!d) return identity<T, 4>();
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

namespace irg::detail::inline IRG_ABI {

// x * h / z, the rounding of the product made up for.
// needs   |x|, h and z between 2^-300 and 2^300
constexpr double corrected_proportion(double x, double h, double z) noexcept {
  const exact_sum<double> p = fast_two_product(x, h);
  const double q = p.value / z;
  const exact_sum<double> b = fast_two_product(q, z);
  return q + ((p.value - b.value) - b.error + p.error) / z;
}

// x * h / z without overflow or underflow on the way; nothing when the result is too large.
// needs   x finite, h and z finite and positive
template <class T>
constexpr std::optional<T> textbook_proportion(T x, T h, T z) noexcept {
  constexpr T most = (std::numeric_limits<T>::max)();
  if constexpr (std::same_as<T, float>) {
    const double q = widened(x) * widened(h) / widened(z);  // exact but the division
    if (!(magnitude(q) <= static_cast<double>(most))) return std::nullopt;
    return converted<float>(q);
  } else {
    const auto moderate = [](T v) { return T(0x1p-300) <= v && v <= T(0x1p300); };
    if (x == T(0)) return T(0);
    if (moderate(magnitude(x)) && moderate(h) && moderate(z)) return corrected_proportion(x, h, z);
    const scaled_number a = decompose(x), b = decompose(h), c = decompose(z);
    const T q = corrected_proportion(a.significand, b.significand, c.significand);  // from 1/2 to 4
    const int e = a.exponent + b.exponent - c.exponent;
    if (e < -1100) return T(0);
    if (e < 0) return q * T(0x1p-200) * power_of_two(e + 200);
    if (e > 1025) return std::nullopt;
    const T sixteenth = q * power_of_two(e - 4);
    if (most / 16 < magnitude(sixteenth)) return std::nullopt;
    return sixteenth * 16;
  }
}

}  // namespace irg::detail::inline IRG_ABI

namespace irg::textbook::inline IRG_ABI {

/// P (5.10): the perspective projection onto the plane at the distance h in front of the eye, for row vectors; it gives
/// [x y 0 z/h], and the division by z/h leads to (5.9).
/// gives   nothing when h is not positive or not finite, or so small that 1/h is infinite
template <Floating T>
[[nodiscard]] constexpr std::optional<mat<T, 4, 4>> perspective_matrix(T h) noexcept {
  using limits = std::numeric_limits<T>;
  if (!(T(1) / (limits::max)() < h) || !(h <= (limits::max)())) return std::nullopt;
  return mat<T, 4, 4>{{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 0, T(1) / h}, {0, 0, 0, 0}}};
}

/// Where a position of the eye's system is seen in the plane at distance h: x h / z and y h / z (5.9).
/// gives   nothing at and behind the eye (z <= 0), for NaN and infinity, for h <= 0, and where a coordinate would be
///         beyond the largest number
/// exact   within 0.51 ulp over the whole range (1 ulp where the result is subnormal), so that a position in the plane
///         itself, z = h, is seen where it is
template <Floating T>
[[nodiscard]] constexpr std::optional<point<T, 2>> project_perspective(const point<T, 3>& p,
                                                                       std::type_identity_t<T> h) noexcept {
  constexpr T most = (std::numeric_limits<T>::max)();
  if (!(T(0) < p.z) || !(T(0) < h) || !(h <= most) || !detail::within(p, most)) return std::nullopt;
  const auto x = detail::textbook_proportion(p.x, h, p.z), y = detail::textbook_proportion(p.y, h, p.z);
  if (!x || !y) return std::nullopt;
  return point<T, 2>{*x, *y};
}

/// The parallel projection that the lecture names beside P: drops z.
template <Floating T>
[[nodiscard]] constexpr mat<T, 4, 4> parallel_matrix() noexcept {
  return {{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 0, 0}, {0, 0, 0, 1}}};
}

/// Where a position of the eye's system is seen in parallel projection: (x, y), at any depth, behind the eye too.
template <class T>
[[nodiscard]] constexpr point<T, 2> project_parallel(const point<T, 3>& p) noexcept {
  return {p.x, p.y};
}

}  // namespace irg::textbook::inline IRG_ABI
