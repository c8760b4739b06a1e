// SPDX-License-Identifier: MIT
// On which side of a plane the point lies in which three others meet, decided exactly and without computing the point.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <type_traits>

#include <irg/geometry/detail/evaluate.hpp>
#include <irg/geometry/side_of_crossing.hpp>
#include <irg/math/vec.hpp>

namespace irg {

/// A plane through three points, in front where they are seen counter-clockwise.
template <Scalar T>
struct plane_points {
  point<T, 3> a{}, b{}, c{};
  constexpr bool operator==(const plane_points&) const = default;
};

namespace detail {
inline namespace IRG_ABI {

// Where three planes meet in one point, as the sign of the first number, and the point's side of a fourth one, as that
// of both multiplied. In shares of the corners of the first plane, which sum up to 1, every other plane is a linear
// equation whose coefficients are the corners' distances from it; so the point is the cross product of two of these.
struct meeting_formula {
  template <class Input>
  constexpr auto operator()(const Input& x) const {
    const auto row = [&x](std::size_t plane) {
      const std::size_t a = 9 * plane, b = a + 3, c = b + 3;
      const auto ux = x[b] - x[a], uy = x[b + 1] - x[a + 1], uz = x[b + 2] - x[a + 2];
      const auto vx = x[c] - x[a], vy = x[c + 1] - x[a + 1], vz = x[c + 2] - x[a + 2];
      const auto nx = uy * vz - uz * vy, ny = uz * vx - ux * vz, nz = ux * vy - uy * vx;
      const auto at = [&](std::size_t p) {
        return nx * (x[p] - x[a]) + ny * (x[p + 1] - x[a + 1]) + nz * (x[p + 2] - x[a + 2]);
      };
      return std::array{at(0), at(3), at(6)};
    };
    const auto p = row(1), q = row(2), r = row(3);
    const auto s0 = p[1] * q[2] - p[2] * q[1], s1 = p[2] * q[0] - p[0] * q[2], s2 = p[0] * q[1] - p[1] * q[0];
    return std::array{s0 + s1 + s2, r[0] * s0 + r[1] * s1 + r[2] * s2};
  }
};

// Of degree 9: apart from code that seldom needs it.
template <std::size_t Size>
IRG_NOINLINE constexpr std::array<int, 2> exact_meeting_signs(const std::array<double, Size>& in) noexcept {
  const auto values = meeting_formula()(numbers_of<dyadic<words_for_degree(9)>>(in));
  return {values[0].sign(), values[1].sign()};
}

}  // namespace IRG_ABI
}  // namespace detail

inline namespace IRG_ABI {

/// On which side of `of` the point lies in which three planes meet: 1 in front, -1 behind, 0 on it.
/// needs   finite coordinates
/// gives   nothing when the three do not meet in one point, 0 when the points of `of` lie on a line
/// exact   for every finite float and double, of any magnitudes
/// cost    some 0.3 us; where the point is nearly on the plane, a polynomial of degree 9 in exact numbers
template <Floating T>
constexpr std::optional<int> side_of_meeting(const plane_points<T>& first, const plane_points<T>& second,
                                             const plane_points<T>& third, const plane_points<T>& of) noexcept {
  // The formula's roundings: 1 of a difference, 3 of a normal, 3 of a distance, 4 of a cross product and a sum. No
  // number enters a value by more than 40 of them: side_of_crossing's filter serves, whose bound is for 60.
  std::array<double, 36> in{};
  std::size_t n = 0;
  for (const plane_points<T>* plane : {&first, &second, &third, &of})
    for (const point<T, 3>* p : {&plane->a, &plane->b, &plane->c})
      for (int k = 0; k < 3; ++k) in[n++] = widened(coordinate(*p, k));
  if (const int sure = detail::filtered_sign_of_product(detail::meeting_formula(), in); sure != 0) return sure;
  const std::array<int, 2> signs = detail::exact_meeting_signs(in);
  if (signs[0] == 0) return std::nullopt;
  return signs[0] * signs[1];
}

}  // namespace IRG_ABI
}  // namespace irg
