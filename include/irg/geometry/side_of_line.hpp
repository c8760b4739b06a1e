// SPDX-License-Identifier: MIT
// On which side of the line a*x + b*y + c = 0 a point lies, decided exactly.
#pragma once

#include <irg/core/coordinates.hpp>
#include <irg/core/vocabulary.hpp>
#include <irg/math/exact/sign_of.hpp>

namespace irg {
namespace detail {

template <class L>
concept has_abc = requires(const L& l) {
  requires Scalar<std::remove_cvref_t<decltype(l.a)>>;
  requires std::same_as<std::remove_cvref_t<decltype(l.a)>, std::remove_cvref_t<decltype(l.b)>>;
  requires std::same_as<std::remove_cvref_t<decltype(l.a)>, std::remove_cvref_t<decltype(l.c)>>;
} && !requires(const L& l) { l.d; };

}  // namespace detail

/// The coefficients of a line: members a, b and c, or three coordinates.
template <class L>
concept LineCoefficients = detail::has_abc<L> || (Vector<L> && coordinate_traits<L>::size == 3);

namespace detail::inline IRG_ABI {

template <LineCoefficients L>
IRG_INLINE constexpr auto line_coefficient(const L& l, int i) noexcept {
  if constexpr (has_abc<L>)
    return i == 0 ? l.a : i == 1 ? l.b : l.c;
  else
    return coordinate(l, i);
}

}  // namespace detail::inline IRG_ABI

inline namespace IRG_ABI {

/// On which side of the line a*x + b*y + c = 0 a point lies: above where the sum is positive, which the normal
/// (a, b) points to, below where it is negative.
/// shape   l has members a, b and c, or is a vector of them; q is a point, or a homogeneous point (x, y, w), for which
///         c counts w times. A negative w does not change the point, nor the answer; w = 0 is a direction
/// needs   finite numbers
/// gives   the side that c has for all points when a and b are 0, and `on` when something is NaN or infinite
/// exact   for every finite float, double and integer
/// cost    about 3 ns, where roundings do not tell some 100 ns
template <LineCoefficients L, Coordinates Q>
  requires((size_of<Q> == 2 && Point<Q>) || (size_of<Q> == 3 && HomogeneousPoint<Q>))
[[nodiscard]] constexpr side side_of_line(const L& l, const Q& q) noexcept {
  using T = scalar_of<Q>;
  static_assert(std::same_as<T, decltype(detail::line_coefficient(l, 0))>);
  const vec<T, 3> line{detail::line_coefficient(l, 0), detail::line_coefficient(l, 1), detail::line_coefficient(l, 2)};
  if constexpr (size_of<Q> == 2) {
    return static_cast<side>(
        sign_of<2>([](const auto& k, const auto& x) { return k.x * x.x + k.y * x.y + k.z; }, line, q));
  } else {
    const hpoint<T, 2> at{coordinate(q, 0), coordinate(q, 1), coordinate(q, 2)};
    const int sign =
        sign_of<2>([](const auto& k, const auto& x) { return k.x * x.x + k.y * x.y + k.z * x.z; }, line, at);
    return static_cast<side>(at.z < T(0) ? -sign : sign);
  }
}

}  // namespace IRG_ABI
}  // namespace irg
