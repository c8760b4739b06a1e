// SPDX-License-Identifier: MIT
// The steps of triangle_area.hpp.
#pragma once

#include <optional>

#include <irg/core/conversion.hpp>
#include <irg/core/coordinates.hpp>
#include <irg/math/compensated.hpp>
#include <irg/math/hypot.hpp>
#include <irg/math/sqrt.hpp>

namespace irg::detail::inline IRG_ABI {

/// Half of (b - a) x (c - a), exactly.
IRG_NOINLINE constexpr exact_accumulator<3> exact_area(double ax, double ay, double bx, double by, double cx,
                                                       double cy) noexcept {
  exact_accumulator<3> sum;
  sum.add(0.5, ax, by), sum.subtract(0.5, ay, bx);
  sum.add(0.5, bx, cy), sum.subtract(0.5, by, cx);
  sum.add(0.5, cx, ay), sum.subtract(0.5, cy, ax);
  return sum;
}

/// Half of (b - a) x (c - a) with an error below 2^-52 of it, and with its sign.
/// needs   finite numbers
/// source  Shewchuk 1997 (the second stage of his filter)
constexpr double signed_area_of_doubles(double ax, double ay, double bx, double by, double cx, double cy) noexcept {
  const auto fits = [](double v) { return is_compensable(v); };
  if (fits(ax) && fits(ay) && fits(bx) && fits(by) && fits(cx) && fits(cy)) {
    const auto [p, p_rest] = two_sum(bx, -ax);
    const auto [q, q_rest] = two_sum(by, -ay);
    const auto [r, r_rest] = two_sum(cx, -ax);
    const auto [s, s_rest] = two_sum(cy, -ay);
    const auto [left, left_rest] = two_product(p, s);
    const auto [right, right_rest] = two_product(q, r);
    const auto [heads, heads_rest] = two_sum(left, -right);
    if (p_rest == 0 && q_rest == 0 && r_rest == 0 && s_rest == 0)
      return 0.5 * (heads + (heads_rest + (left_rest - right_rest)));
    const double tails = (product(p, s_rest) + product(p_rest, s)) - (product(q, r_rest) + product(q_rest, r));
    const double area = heads + (heads_rest + ((left_rest - right_rest) + tails));
    // What is missing, products of two rests and roundings of the tails, is below 8u^2 of the products' sizes.
    if (magnitude(area) > product(magnitude(left) + magnitude(right), 0x1p-48)) return 0.5 * area;
  }
  return exact_area(ax, ay, bx, by, cx, cy).rounded();
}

template <class P>
IRG_INLINE constexpr double signed_area_in_plane(const P& a, const P& b, const P& c, int x, int y) noexcept {
  const auto at = [](const P& p, int i) { return widened(coordinate(p, i)); };
  return signed_area_of_doubles(at(a, x), at(a, y), at(b, x), at(b, y), at(c, x), at(c, y));
}

}  // namespace irg::detail::inline IRG_ABI
