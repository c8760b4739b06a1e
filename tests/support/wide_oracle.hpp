// SPDX-License-Identifier: MIT
// Doubles over the whole range, and errors against arithmetic in long double.
#pragma once

#include <cmath>

#include "support/random.hpp"

namespace test {

/// A double whose exponent is uniform in [low, high].
inline double of_exponents(random& r, int low, int high) {
  const int exponent = static_cast<int>(r.integer(low, high));
  const double x = std::ldexp(1 + r.unit(), exponent);
  return (r.next() & 1u) != 0 ? x : -x;
}

inline long double wide(double x) { return static_cast<long double>(x); }

/// The error of x in units in the last place of a double.
inline double ulps(double x, long double expected) {
  int exponent = 0;
  std::frexp(expected, &exponent);
  const int place = exponent - 53 < -1074 ? -1074 : exponent - 53;
  return static_cast<double>(std::abs(wide(x) - expected) / std::ldexp(1.0L, place));
}

}  // namespace test
