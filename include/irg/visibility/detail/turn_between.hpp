// SPDX-License-Identifier: MIT
// Which way one segment turns from another, wherever they lie, exactly; and points as numbers for polynomials.
#pragma once

#include <array>
#include <cstddef>

#include <irg/core/conversion.hpp>
#include <irg/geometry/orient2d.hpp>
#include <irg/geometry/vocabulary.hpp>
#include <irg/math/exact/sign_of.hpp>

namespace irg::detail::inline IRG_ABI {

template <Floating T, std::size_t Size>
constexpr std::array<double, 2 * Size> plane_numbers(const std::array<point<T, 2>, Size>& points) noexcept {
  std::array<double, 2 * Size> in{};
  for (std::size_t i = 0; i < Size; ++i) {
    in[2 * i] = widened(points[i].x);
    in[2 * i + 1] = widened(points[i].y);
  }
  return in;
}

// The sign of (a.b - a.a) x (b.b - b.a).
template <Floating T>
constexpr int turn_between(const segment<T, 2>& a, const segment<T, 2>& b) noexcept {
  const auto formula = [](const auto& x) { return (x[2] - x[0]) * (x[7] - x[5]) - (x[3] - x[1]) * (x[6] - x[4]); };
  return irg::sign_of<2>(formula, plane_numbers<T, 4>({a.a, a.b, b.a, b.b}));
}

// Whether two segments cross, each within the other.
template <Floating T>
constexpr bool cross_properly(const segment<T, 2>& e, const segment<T, 2>& o) noexcept {
  return orient2d(e.a, e.b, o.a) * orient2d(e.a, e.b, o.b) < 0 && orient2d(o.a, o.b, e.a) * orient2d(o.a, o.b, e.b) < 0;
}

}  // namespace irg::detail::inline IRG_ABI
