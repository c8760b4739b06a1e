// SPDX-License-Identifier: MIT
// The result of clipping a line: its visible part, and which part of the whole that is.
#pragma once

#include <type_traits>

#include <irg/core/coordinates.hpp>
#include <irg/math/error_free.hpp>

namespace irg {

/// The visible part of the segment from a to b: from `first` to `second`, where the parameters are those of a + t*(b -
/// a).
/// shape   0 <= t_first <= t_second <= 1; a kept end is the given point, bit for bit, at 0 or 1. Parameters are numbers
///         of the coordinates' type, doubles for integers
template <Point P>
struct clipped_line {
  using parameter = std::conditional_t<std::is_integral_v<scalar_of<P>>, double, scalar_of<P>>;
  P first = zero_coordinates<P>(), second = zero_coordinates<P>();
  parameter t_first = parameter(0), t_second = parameter(1);
  // Coordinate by coordinate: == of foreign points need not be constexpr.
  IRG_APART constexpr bool operator==(const clipped_line& other) const {
    for (int i = 0; i < size_of<P>; ++i)
      if (coordinate(first, i) != coordinate(other.first, i) || coordinate(second, i) != coordinate(other.second, i))
        return false;
    return t_first == other.t_first && t_second == other.t_second;
  }
};

}  // namespace irg
