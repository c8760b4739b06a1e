// SPDX-License-Identifier: MIT
// Settle time: how many steps of a map z -> f(z) it takes to come to rest, and where. With Newton's step for a
// polynomial it is what pictures of the basins of its zeros show.
#pragma once

#include <irg/fractal/escape_time.hpp>

namespace irg::inline IRG_ABI {

/// The orbit of z under a map until a step is no longer than `rest`, or it has taken so many steps.
/// shape   `count` the steps before the one that was short, `z` where that led
/// gives   `most` for an orbit that does not come to rest, or becomes NaN, and where `rest` is negative or NaN
/// exact   the map's own rounding; lengths are compared squared, each operation rounded
/// cost    at most `most` steps; nothing is allocated
template <Floating T, ComplexMap<T> F>
[[nodiscard]] constexpr escape_end<T> settle_orbit(const F& f, point<T, 2> z, T rest, int most) {
  const T square = T(0) <= rest ? product(rest, rest) : T(-1);
  for (int k = 0; k < most; ++k) {
    const point<T, 2> next = f(z);
    const T step = detail::squared_size(next.x - z.x, next.y - z.y);
    z = next;
    if (step <= square) return {k, z};
  }
  return {most < 0 ? 0 : most, z};
}

}  // namespace irg::inline IRG_ABI
