// SPDX-License-Identifier: MIT
// The continuity of two Bezier curves, how smoothly one goes on in the other, decided exactly: the differences of the
// control points about the joint are compared without rounding.
#pragma once

#include <array>
#include <cstddef>
#include <type_traits>

#include <irg/core/contract.hpp>
#include <irg/curve/bezier.hpp>
#include <irg/math/exact/sign_of.hpp>

namespace irg {

/// How one curve goes on in the next: not at all; from the same point (C0); in the same direction (G1); with the same
/// first derivative (C1); with the same first and second one (C2).
enum class curve_continuity { apart, position, direction, first_derivative, second_derivative };

namespace detail::inline IRG_ABI {

// The control points about a joint: those of the first curve backwards from its end, those of the second forwards; a
// curve with fewer points has its last one again, as long as the degree's factor is zero.
template <ControlPoints R>
struct joint_side {
  const R& points;
  bool is_first = false;
  double width = 1;

  constexpr std::size_t degree() const noexcept { return ring_traits<R>::size(points) - 1; }
  constexpr double at(std::size_t k, int axis) const noexcept {
    const std::size_t i = k < degree() ? k : degree();
    return static_cast<double>(coordinate(ring_traits<R>::vertex(points, is_first ? degree() - i : i), axis));
  }
  // The degree's factor of a derivative.
  constexpr double factor(int derivative) const noexcept {
    const auto n = static_cast<double>(static_cast<int>(degree()));
    return derivative == 1 ? n : n * (n - 1);
  }
  constexpr bool is_finite_near() const noexcept {
    bool finite = is_finite(width);
    for (std::size_t k = 0; k < 3; ++k)
      for (int axis = 0; axis < size_of<control_point<R>>; ++axis) finite = finite && is_finite(at(k, axis));
    return finite;
  }
};

template <class A, class B>
constexpr bool same_first_derivative(const A& a, const B& b, int axis) noexcept {
  return irg::sign_of<3>(
             [](const auto& x) {
               return (x[4] - x[8]) * (x[7] - x[8]) * (x[0] - x[1]) - (x[5] - x[8]) * (x[6] - x[8]) * (x[3] - x[2]);
             },
             std::array{a.at(0, axis), a.at(1, axis), b.at(0, axis), b.at(1, axis), a.factor(1), b.factor(1), a.width,
                        b.width, 0.0}) == 0;
}

template <class A, class B>
constexpr bool same_second_derivative(const A& a, const B& b, int axis) noexcept {
  return irg::sign_of<4>(
             [](const auto& x) {
               const auto first = (x[0] - x[1]) - (x[1] - x[2]), second = (x[3] - x[4]) - (x[4] - x[5]);
               const auto from = x[8] - x[10], to = x[9] - x[10];
               return (x[6] - x[10]) * to * to * first - (x[7] - x[10]) * from * from * second;
             },
             std::array{a.at(0, axis), a.at(1, axis), a.at(2, axis), b.at(0, axis), b.at(1, axis), b.at(2, axis),
                        a.factor(2), b.factor(2), a.width, b.width, 0.0}) == 0;
}

template <int Dimension, class A, class B>
constexpr bool same_direction(const A& a, const B& b) noexcept {
  for (int i = 0; i < Dimension; ++i)
    for (int j = 0; j < i; ++j)
      if (irg::sign_of<2>([](const auto& x) { return (x[0] - x[1]) * (x[7] - x[6]) - (x[2] - x[3]) * (x[5] - x[4]); },
                          std::array{a.at(0, i), a.at(1, i), a.at(0, j), a.at(1, j), b.at(0, i), b.at(1, i), b.at(0, j),
                                     b.at(1, j)}) != 0)
        return false;
  std::array<double, static_cast<std::size_t>(4 * Dimension)> all{};
  for (std::size_t i = 0; i < static_cast<std::size_t>(Dimension); ++i) {
    const int axis = static_cast<int>(i);
    all[4 * i] = a.at(0, axis), all[4 * i + 1] = a.at(1, axis);
    all[4 * i + 2] = b.at(1, axis), all[4 * i + 3] = b.at(0, axis);
  }
  return irg::sign_of<2>(
             [](const auto& x) {
               auto sum = (x[0] - x[1]) * (x[2] - x[3]);
               for (std::size_t i = 4; i + 3 < static_cast<std::size_t>(4 * Dimension); i += 4)
                 sum = sum + (x[i] - x[i + 1]) * (x[i + 2] - x[i + 3]);
               return sum;
             },
             all) > 0;
}

}  // namespace detail::inline IRG_ABI

inline namespace IRG_ABI {

/// The continuity at the joint: how smoothly the second curve goes on from the end of the first.
/// needs   one or more control points each; how long a stretch of the parameter each curve takes, greater than 0
/// gives   apart for coordinates that are not finite. Derivatives that are equal count even where both are zero, where
///         the curve may turn: a cusp is no matter of derivatives. A direction needs two that are not zero
/// exact   decided without rounding for all finite floats and doubles, as they are: points that were rounded may be off
/// cost    some differences and products, with exact arithmetic where they nearly cancel
/// source  Farin 2002, 5.2 and 11.1
template <ControlPoints R, ControlPoints S>
  requires(Floating<scalar_of<control_point<R>>> && std::is_same_v<control_point<R>, control_point<S>>)
[[nodiscard]] constexpr curve_continuity continuity_of(const R& first, const S& second, double first_width = 1,
                                                       double second_width = 1) noexcept {
  constexpr int dimension = size_of<control_point<R>>;
  IRG_EXPECTS(ring_traits<R>::size(first) > 0 && ring_traits<S>::size(second) > 0);
  IRG_EXPECTS(first_width > 0 && second_width > 0);
  const detail::joint_side<R> a{first, true, first_width};
  const detail::joint_side<S> b{second, false, second_width};
  if (!a.is_finite_near() || !b.is_finite_near()) return curve_continuity::apart;
  bool meets = true, first_same = true, second_same = true;
  for (int axis = 0; axis < dimension; ++axis) {
    meets = meets && a.at(0, axis) == b.at(0, axis);
    first_same = first_same && meets && detail::same_first_derivative(a, b, axis);
    second_same = second_same && first_same && detail::same_second_derivative(a, b, axis);
  }
  if (!meets) return curve_continuity::apart;
  if (first_same) return second_same ? curve_continuity::second_derivative : curve_continuity::first_derivative;
  return detail::same_direction<dimension>(a, b) ? curve_continuity::direction : curve_continuity::position;
}

IRG_RENAMED(joint_of, continuity_of)

}  // namespace IRG_ABI
}  // namespace irg
