// SPDX-License-Identifier: MIT
// look_at: the view matrix of a camera from where it stands, what it looks at and which way is up. It is total: up
// parallel to the view, and eye at target, give a documented camera, never NaN.
#pragma once

#include <irg/core/vocabulary.hpp>
#include <irg/math/length.hpp>
#include <irg/math/mat.hpp>

namespace irg {

/// What the three arguments of look_at amount to.
enum class [[nodiscard]] look_at_status {
  ok,
  up_parallel,    // up is zero or parallel to the view: an axis of the world took its place
  eye_at_target,  // there is no direction: the camera looks along the world's -z
  not_finite,  // a coordinate is NaN or infinite, or the eye or the target too far out for the matrix to be finite
  ordinary [[deprecated("irg: ordinary is now ok")]] = ok
};

namespace detail::inline IRG_ABI {

// Whether no coordinate is NaN or larger than the limit.
template <Coordinates C>
constexpr bool within(const C& c, scalar_of<C> limit) noexcept {
  for (int i = 0; i < size_of<C>; ++i)
    if (!(magnitude(coordinate(c, i)) <= limit)) return false;
  return true;
}

// The unit vector of the coordinate axis that is nearest to being at right angles to v; the first of several.
template <class T>
constexpr vec<T, 3> axis_least_aligned(const vec<T, 3>& v) noexcept {
  int least = 0;
  for (int i = 1; i < 3; ++i)
    if (magnitude(v[i]) < magnitude(v[least])) least = i;
  return generate_coordinates<vec<T, 3>>([&](int i) { return i == least ? T(1) : T(0); });
}

}  // namespace detail::inline IRG_ABI

inline namespace IRG_ABI {

/// The matrix from world space into the space of a camera at `eye`, and whether a fallback was needed. In camera space
/// the eye is the origin, the view goes along -z, x points to the right and y up; like the world it is right-handed.
/// shape   in bare braces points of doubles, or of the type of the others
/// gives   `up_parallel` when up is zero or makes an angle with the view whose sine is at most 8u: the coordinate axis
///         least aligned with the view (the first of x, y, z on a tie) stands in for it; `eye_at_target`: the view goes
///         along the world's -z; `not_finite`, with the identity, when a coordinate is NaN or infinite, or one of eye
///         or target is beyond a quarter of the largest number. The matrix is finite always
/// exact   axes of length 1 and at right angles within 8u, determinant 1 within 16u (u = 2^-53, float 2^-24), however
///         near or far the target and however nearly parallel up
template <Point P = point<double, 3>, Vector V = vec<scalar_of<P>, 3>>
  requires(size_of<P> == 3 && size_of<V> == 3 && std::same_as<scalar_of<P>, scalar_of<V>> && Floating<scalar_of<P>>)
constexpr checked<mat<scalar_of<P>, 4, 4>, look_at_status> look_at_checked(const P& eye, const P& target,
                                                                           const V& up) noexcept {
  using T = scalar_of<P>;
  using limits = std::numeric_limits<T>;
  if (!detail::within(eye, (limits::max)() / 4) || !detail::within(target, (limits::max)() / 4) ||
      !detail::within(up, (limits::max)()))
    return {identity_matrix<T, 4>(), look_at_status::not_finite};

  const auto backward = try_normalized(
      generate_coordinates<vec<T, 3>>([&](int i) { return coordinate(eye, i) - coordinate(target, i); }));
  const vec<T, 3> z = backward ? *backward : vec<T, 3>{0, 0, 1};
  const vec<T, 3> unit_up = normalized(generate_coordinates<vec<T, 3>>([&](int i) { return coordinate(up, i); }));
  vec<T, 3> side = cross(unit_up, z);
  const bool parallel = detail::within(side, 4 * limits::epsilon());
  if (parallel) side = cross(detail::axis_least_aligned(z), z);

  // When up is nearly parallel to z, rounding may tilt `side` towards z. y is at right angles to z all the same, and x
  // follows from these two.
  const vec<T, 3> y = normalized(cross(z, side));
  const vec<T, 3> x = cross(y, z);
  const vec<T, 3> from_origin = generate_coordinates<vec<T, 3>>([&](int i) { return coordinate(eye, i); });
  const auto shift = [&](const vec<T, 3>& axis) { return T(0) - dot(axis, from_origin); };
  return {{{{x.x, x.y, x.z, shift(x)}, {y.x, y.y, y.z, shift(y)}, {z.x, z.y, z.z, shift(z)}, {0, 0, 0, 1}}},
          !backward  ? look_at_status::eye_at_target
          : parallel ? look_at_status::up_parallel
                     : look_at_status::ok};
}

/// The matrix from world space into the space of a camera at `eye` that looks at `target`; see look_at_checked, whose
/// fallbacks it takes without a word.
template <Point P = point<double, 3>, Vector V = vec<scalar_of<P>, 3>>
  requires(size_of<P> == 3 && size_of<V> == 3 && std::same_as<scalar_of<P>, scalar_of<V>> && Floating<scalar_of<P>>)
constexpr mat<scalar_of<P>, 4, 4> look_at(const P& eye, const P& target, const V& up) noexcept {
  return look_at_checked(eye, target, up).value;
}

}  // namespace IRG_ABI
}  // namespace irg
