// SPDX-License-Identifier: MIT
// On which side of a line the crossing of two others lies, decided exactly and without computing the crossing.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <type_traits>

#include <irg/core/coordinates.hpp>
#include <irg/geometry/detail/evaluate.hpp>
#include <irg/geometry/segment.hpp>
#include <irg/geometry/sign_of.hpp>

namespace irg {
namespace detail {
inline namespace IRG_ABI {

// The sign of the product of the two values of a formula, as sign_of filters them; 0 where rounding leaves it open.
template <Floating T, std::size_t Size, class Formula>
constexpr int filtered_sign_of_product(const Formula& formula, const std::array<T, Size>& in) noexcept {
  std::array<filtered_input, Size> x{};
  for (std::size_t i = 0; i < Size; ++i) {
    x[i].value = exactly_widened(in[i]);
    if (!suits_twofold(x[i].value)) return 0;
  }
  const std::array<filtered, 2> f = formula(x);
  int sign = 1;
  for (const filtered& v : f) {
    const double bound = polynomial_filter_bound * v.size;
    sign *= v.value > bound ? 1 : -v.value > bound ? -1 : 0;
  }
  return sign;
}

}  // namespace IRG_ABI
}  // namespace detail

inline namespace IRG_ABI {

/// On which side of the line `of` the point lies in which the lines `first` and `second` cross: 1 to its left (y up),
/// -1 to its right, 0 on it.
/// shape   lines through the ends of segments; the crossing may lie beyond the ends
/// needs   finite coordinates
/// gives   nothing when `first` and `second` do not cross in one point (parallel, or without length), and when
///         something is NaN or infinite; 0 when the ends of `of` are the same point
/// exact   for every finite float and double; other scalars: as exact as their own + - *
/// cost    some 20 ns; where the crossing is nearly on the line, a polynomial of degree 4 in doubled precision, in
///         exact numbers where that does not suffice
template <Scalar T>
  requires(Floating<T> || !std::is_arithmetic_v<T>)
constexpr std::optional<int> side_of_crossing(const segment<T, 2>& first, const segment<T, 2>& second,
                                              const segment<T, 2>& of) noexcept(Floating<T>) {
  // With f and g twice the areas that `second` spans with a and b, the crossing is (g*a - f*b)/(g - f): its side of a
  // line is the same mean of the sides of a and b.
  const auto formula = [](const auto& x) {
    const auto area = [&x](std::size_t line, std::size_t end) {
      return (x[line + 2] - x[line]) * (x[end + 1] - x[line + 1]) - (x[line + 3] - x[line + 1]) * (x[end] - x[line]);
    };
    const auto f = area(4, 0), g = area(4, 2);
    return std::array{g - f, area(8, 0) * g - area(8, 2) * f};
  };
  const std::array<T, 12> in{first.a[0],  first.a[1],  first.b[0], first.b[1], second.a[0], second.a[1],
                             second.b[0], second.b[1], of.a[0],    of.a[1],    of.b[0],     of.b[1]};
  if constexpr (Floating<T>)
    if (const int sure = detail::filtered_sign_of_product(formula, in); sure != 0) return sure;
  const auto values = detail::evaluate<4>(formula, in);
  if (!values) return std::nullopt;
  const int apart = detail::known_sign((*values)[0]);
  if (apart == 0) return std::nullopt;
  return apart * detail::known_sign((*values)[1]);
}

}  // namespace IRG_ABI
}  // namespace irg
