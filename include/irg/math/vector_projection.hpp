// SPDX-License-Identifier: MIT
// The part of a vector along another, as a number and as a vector; the cosine and the kind of the angle between two.
// Right over the whole range of float and double, as length is; a zero vector gives no result instead of NaN.
#pragma once

#include <optional>

#include <irg/core/conversion.hpp>
#include <irg/math/detail/compensated_terms.hpp>
#include <irg/math/detail/unrounded.hpp>
#include <irg/math/exact_sum.hpp>
#include <irg/math/length.hpp>

namespace irg {

namespace detail::inline IRG_ABI {

// The dot product of two vectors scaled to be near 1, in twice the precision.
template <int N>
constexpr unrounded unrounded_dot(const scaled_coordinates<N>& a, const scaled_coordinates<N>& b) noexcept {
  const compensated_sum sum =
      compensated_dot(N, [&](std::size_t i) { return a.c[i]; }, [&](std::size_t i) { return b.c[i]; });
  return renormalised({sum.value, sum.error});
}

template <int N>
constexpr unrounded unrounded_length(const scaled_coordinates<N>& a) noexcept {
  return renormalised(unrounded_sqrt(unrounded_dot(a, a)));
}

// Whether both are finite and the second is not zero.
template <int N>
constexpr bool can_project(const scaled_coordinates<N>& a, const scaled_coordinates<N>& b) noexcept {
  return a.scale >= 0 && b.scale > 0;
}

}  // namespace detail::inline IRG_ABI

inline namespace IRG_ABI {

/// The length of the part of a along b, negative where it points against b: |a| times the cosine of the angle.
/// gives   nothing when b is zero or a coordinate is NaN or infinite; infinity when the result is too large
/// exact   within 1.01 ulp, and N^2 2^-106 |a| more, which counts where a and b are nearly at right angles
template <Vector A, Vector B>
  requires(size_of<A> == size_of<B> && std::same_as<scalar_of<A>, scalar_of<B>> && Floating<scalar_of<A>>)
[[nodiscard]] constexpr std::optional<scalar_of<A>> scalar_projection(const A& a, const B& b) noexcept {
  const auto s = scaled_near_one(a);
  const auto t = scaled_near_one(b);
  if (!detail::can_project(s, t)) return std::nullopt;
  if (s.scale == 0) return scalar_of<A>(0);
  const auto part = detail::divide(detail::unrounded_dot(s, t), detail::unrounded_length(t));
  return converted<scalar_of<A>>(detail::round(part) / s.scale);
}

/// The part of a along b: the vector with b's direction, or the opposite, that a minus it is at right angles to b.
/// gives   nothing when b is zero or a coordinate is NaN or infinite; infinite coordinates when they are too large
/// exact   in rationals: no root is taken. In floats within 1.01 ulp a coordinate, and N^2 2^-106 |a| more, which
///         counts where a and b are nearly at right angles
template <Vector A, Vector B>
  requires(size_of<A> == size_of<B> && std::same_as<scalar_of<A>, scalar_of<B>> && Real<scalar_of<A>>)
[[nodiscard]] constexpr std::optional<B> vector_projection(const A& a, const B& b) noexcept {
  using T = scalar_of<A>;
  if constexpr (Floating<T>) {
    const auto s = scaled_near_one(a);
    const auto t = scaled_near_one(b);
    if (!detail::can_project(s, t)) return std::nullopt;
    if (s.scale == 0) return generate_coordinates<B>([](int) { return T(0); });
    const auto part = detail::divide(detail::unrounded_dot(s, t), detail::unrounded_dot(t, t));
    return generate_coordinates<B>(
        [&](int i) { return converted<T>(detail::round(detail::multiply(part, {t.c[i], 0.0})) / s.scale); });
  } else {
    const T square = dot(b, b);
    if (square == T(0)) return std::nullopt;
    const T part = dot(a, b) / square;
    return generate_coordinates<B>([&](int i) { return part * coordinate(b, i); });
  }
}

/// The cosine of the angle between two vectors, -1 to 1.
/// gives   nothing when one is zero or has a coordinate that is NaN or infinite
/// exact   within 0.51 ulp, and N^2 2^-106 more, which counts where they are nearly at right angles; never beyond 1.
///         angle_between is better for the angle itself: near 0 and pi its cosine says little
template <Vector A, Vector B>
  requires(size_of<A> == size_of<B> && std::same_as<scalar_of<A>, scalar_of<B>> && Floating<scalar_of<A>>)
[[nodiscard]] constexpr std::optional<scalar_of<A>> cosine_between(const A& a, const B& b) noexcept {
  const auto s = scaled_near_one(a);
  const auto t = scaled_near_one(b);
  if (!detail::can_project(s, t) || s.scale == 0) return std::nullopt;
  const auto cosine = detail::divide(detail::unrounded_dot(s, t),
                                     detail::multiply(detail::unrounded_length(s), detail::unrounded_length(t)));
  return converted<scalar_of<A>>(clamped(detail::round(cosine), -1.0, 1.0));
}

/// 1, 0 or -1 as the angle between two vectors is below, at or above a right angle; 0 when one is zero.
/// needs   finite coordinates
/// exact   for all finite coordinates
template <Vector A, Vector B>
  requires(size_of<A> == size_of<B> && std::same_as<scalar_of<A>, scalar_of<B>> && Floating<scalar_of<A>>)
[[nodiscard]] constexpr int dot_sign(const A& a, const B& b) noexcept {
  exact_accumulator<2> sum;
  for (int i = 0; i < size_of<A>; ++i) sum.add(widened(coordinate(a, i)), widened(coordinate(b, i)));
  return sum.sign();
}

IRG_REFUSES_POINTS(cosine_between);
IRG_REFUSES_POINTS(dot_sign);
IRG_REFUSES_POINTS(scalar_projection);
IRG_REFUSES_POINTS(vector_projection);

}  // namespace IRG_ABI
}  // namespace irg
