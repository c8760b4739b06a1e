// SPDX-License-Identifier: MIT
// Frames along a curve, from its derivatives: Frenet's with curvature and torsion, and frames that turn about the
// tangent as little as they can. Any curve will do, and any parameter: lengths of derivatives do not matter.
#pragma once

#include <optional>
#include <type_traits>

#include <irg/core/conversion.hpp>
#include <irg/curve/detail/parallel_vectors.hpp>
#include <irg/math/length.hpp>

namespace irg {

/// Three axes of length 1 at right angles: binormal = tangent x normal.
template <class V>
struct curve_frame {
  V tangent = zero_coordinates<V>(), normal = zero_coordinates<V>(), binormal = zero_coordinates<V>();
  bool operator==(const curve_frame&) const = default;
};

namespace detail::inline IRG_ABI {

template <Vector V>
IRG_INLINE constexpr V plus_scaled(const V& a, scalar_of<V> factor, const V& b) noexcept {
  return generate_coordinates<V>([&](int i) { return coordinate(a, i) + product(factor, coordinate(b, i)); });
}

/// The frame with this tangent whose normal is nearest to `normal`.
template <Vector V>
constexpr std::optional<curve_frame<V>> frame_towards(const V& tangent, const V& normal) noexcept {
  const auto binormal = try_normalized(cross(tangent, normal));
  if (!binormal) return std::nullopt;
  return curve_frame<V>{tangent, normalized(cross(*binormal, tangent)), *binormal};
}

}  // namespace detail::inline IRG_ABI

inline namespace IRG_ABI {

/// The curvature of a curve in the plane: positive where it turns left.
/// gives   nothing where the first derivative is zero or one is not finite
/// exact   the direction of `first` rounded, then three products and a quotient by its length, twice
/// source  Farin 2002, 10.6
template <Vector V>
  requires(size_of<V> == 2 && Floating<scalar_of<V>>)
[[nodiscard]] constexpr std::optional<scalar_of<V>> curvature(const V& first, const V& second) noexcept {
  const auto along = try_normalized(first);
  if (!along) return std::nullopt;
  const auto speed = length(first);
  return difference_of_products(coordinate(*along, 0), coordinate(second, 1), coordinate(*along, 1),
                                coordinate(second, 0)) /
         speed / speed;
}

/// The curvature of a curve in space, never negative: 1 over the radius of the circle that fits best.
/// gives   nothing where the first derivative is zero or one is not finite
/// exact   as in the plane
/// source  Farin 2002, 10.6
template <Vector V>
  requires(size_of<V> == 3 && Floating<scalar_of<V>>)
[[nodiscard]] constexpr std::optional<scalar_of<V>> curvature(const V& first, const V& second) noexcept {
  const auto along = try_normalized(first);
  if (!along) return std::nullopt;
  const auto speed = length(first);
  return length(cross(*along, second)) / speed / speed;
}

/// The torsion of a curve in space: how fast it leaves its plane, positive to the right-handed side.
/// gives   nothing where the first two derivatives are parallel or one is not finite
/// exact   a cross product, its direction and length, a dot product and a quotient, of derivatives of any size
/// source  Farin 2002, 10.6
template <Vector V>
  requires(size_of<V> == 3 && Floating<scalar_of<V>>)
[[nodiscard]] constexpr std::optional<scalar_of<V>> torsion(const V& first, const V& second,
                                                            const std::type_identity_t<V>& third) noexcept {
  using T = scalar_of<V>;
  const auto a = scaled_near_one(first), b = scaled_near_one(second), c = scaled_near_one(third);
  if (!(a.scale > 0 && b.scale > 0 && c.scale >= 0)) return std::nullopt;
  const auto moderate = [](const auto& s) {
    return generate_coordinates<V>([&](int i) { return converted<T>(s.c[i]); });
  };
  const V turn = cross(moderate(a), moderate(b));
  const auto axis = try_normalized(turn);
  if (!axis) return std::nullopt;
  if (c.scale == 0) return T(0);
  const int places = exponent_of(a.scale) + exponent_of(b.scale) - exponent_of(c.scale);
  return converted<T>(times_power_of_two(widened(dot(*axis, moderate(c)) / length(turn)), places));
}

/// Frenet's frame: the normal points to where the curve bends.
/// gives   nothing where the first two derivatives are parallel (inflections, straight curves, cusps) or not finite
/// exact   axes of length 1 within 2u, at right angles within 6u
/// source  Farin 2002, 11.2
template <Vector V>
  requires(size_of<V> == 3 && Floating<scalar_of<V>>)
[[nodiscard]] constexpr std::optional<curve_frame<V>> frenet_frame(const V& first, const V& second) noexcept {
  const auto tangent = try_normalized(first);
  const auto bend = try_normalized(second);
  if (!tangent || !bend || detail::are_parallel(first, second)) return std::nullopt;
  return detail::frame_towards(*tangent, *bend);
}

/// A frame to start with: the normal is as near to `up` as it can be, or to the axis that is farthest from the tangent
/// where `up` is parallel to it or zero.
/// gives   nothing for a tangent that is zero or not finite
template <Vector V>
  requires(size_of<V> == 3 && Floating<scalar_of<V>>)
[[nodiscard]] constexpr std::optional<curve_frame<V>> frame_with_up(const V& tangent,
                                                                    const std::type_identity_t<V>& up) noexcept {
  const auto along = try_normalized(tangent);
  if (!along) return std::nullopt;
  const auto above = try_normalized(up);
  if (above && !detail::are_parallel(tangent, up))
    if (const auto frame = detail::frame_towards(*along, *above)) return frame;
  int axis = 0;
  for (int i = 1; i < 3; ++i)
    if (magnitude(coordinate(*along, i)) < magnitude(coordinate(*along, axis))) axis = i;
  const V farthest = generate_coordinates<V>([&](int i) { return static_cast<scalar_of<V>>(i == axis); });
  return detail::frame_towards(*along, farthest);
}

/// The frame one step further along a curve that has turned about the tangent as little as it can: `frame`, mirrored by
/// the plane between the two points, then by the one that brings its tangent to `tangent`.
/// needs   the displacement from the old point to the new one, and the direction of the curve there
/// gives   the old frame where `tangent` is zero or not finite; no displacement: turned about the axis between the two
///         tangents
/// exact   the angle about the tangent is off by the fourth power of the step; axes of length 1 and at right angles as
///         frenet_frame's, however many the steps
/// source  Wang, Juttler, Zheng and Liu 2008 (double reflection)
template <Vector V>
  requires(size_of<V> == 3 && Floating<scalar_of<V>>)
[[nodiscard]] constexpr curve_frame<V> rotation_minimizing_frame(const curve_frame<V>& frame,
                                                                 const std::type_identity_t<V>& displacement,
                                                                 const std::type_identity_t<V>& tangent) noexcept {
  using T = scalar_of<V>;
  const auto along = try_normalized(tangent);
  if (!along) return frame;
  const auto mirrored = [](const V& v, const V& axis) {
    return detail::plus_scaled(v, product(T(-2), dot(v, axis)), axis);
  };
  const V across = try_normalized(displacement).value_or(frame.tangent);
  const V normal = mirrored(frame.normal, across), back = mirrored(frame.tangent, across);
  const auto between = try_normalized(detail::plus_scaled(*along, T(-1), back));
  return detail::frame_towards(*along, between ? mirrored(normal, *between) : normal).value_or(frame);
}

IRG_REFUSES_POINTS(curvature);
IRG_REFUSES_POINTS(torsion);
IRG_REFUSES_POINTS(frenet_frame);
IRG_REFUSES_POINTS(frame_with_up);

IRG_RENAMED(rotation_minimising_frame, rotation_minimizing_frame)

}  // namespace IRG_ABI
}  // namespace irg
