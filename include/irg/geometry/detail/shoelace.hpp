// SPDX-License-Identifier: MIT
// The sum x1*y2 - x2*y1 over the edges of a polygon, twice its area: exactly.
#pragma once

#include <concepts>
#include <type_traits>

#include <irg/core/conversion.hpp>
#include <irg/geometry/orient2d.hpp>
#include <irg/geometry/polygon.hpp>
#include <irg/math/exact_sum.hpp>
#include <irg/math/wide_int.hpp>

namespace irg::detail::inline IRG_ABI {

template <class T>
constexpr auto shoelace_zero() noexcept {
  if constexpr (Floating<T>)
    return exact_accumulator<2>();
  else if constexpr (std::integral<T> && sizeof(T) <= 4)
    return int128{0};
  else if constexpr (std::integral<T>)
    return wide_int<4>();
  else
    return T(0);
}

// An exact_accumulator of floats and doubles, 128 bits of integers of up to 32, a wide_int of longer ones, or a T.
template <PlanePolygon P>
constexpr auto shoelace(const P& polygon) noexcept {
  using T = scalar_of<polygon_point<P>>;
  auto twice = shoelace_zero<T>();
  each_edge(polygon, [&](const auto& p, const auto& q) {
    const T x1 = coordinate(p, 0), y1 = coordinate(p, 1), x2 = coordinate(q, 0), y2 = coordinate(q, 1);
    if constexpr (Floating<T>) {
      twice.add(widened(x1), widened(y2));
      twice.subtract(widened(x2), widened(y1));
    } else if constexpr (std::integral<T> && sizeof(T) <= 4) {
      twice += int128{x1} * y2 - int128{x2} * y1;
    } else if constexpr (std::integral<T>) {
      twice += wide_int<2>(x1) * wide_int<2>(y2) - wide_int<2>(x2) * wide_int<2>(y1);
    } else {
      twice = twice + (x1 * y2 - x2 * y1);
    }
  });
  return twice;
}

template <PlanePolygon P>
constexpr int shoelace_sign(const P& polygon) noexcept {
  const auto twice = shoelace(polygon);
  if constexpr (requires { twice.sign(); })
    return twice.sign();
  else
    return twice < decltype(twice)(0) ? -1 : decltype(twice)(0) < twice ? 1 : 0;
}

// Whether the way from a over b to c turns back at b, or stands still.
template <Point P>
constexpr bool is_fold(const P& a, const P& b, const P& c) noexcept {
  if (orient2d(a, b, c) != 0) return false;
  return same_place(a, b) || same_place(b, c) || comes_before(a, b) != comes_before(b, c);
}

}  // namespace irg::detail::inline IRG_ABI
