// SPDX-License-Identifier: MIT
// Numbers of all sizes side by side, and how far functions of them are off at worst.
#pragma once

#include <cmath>
#include <limits>
#include <string>

#include <doctest/doctest.h>

#include <irg/core/coordinates.hpp>

#include "support/big_rational.hpp"
#include "support/random.hpp"
#include "support/ulp.hpp"

#ifdef IRG_HAVE_MPFR

namespace test::mixed {

using test::big_rational;

enum class sizes { all, one_apart, subnormal, roots_of_largest };
constexpr sizes all_sizes[] = {sizes::all, sizes::one_apart, sizes::subnormal, sizes::roots_of_largest};

// What the numbers are: of all sizes, of one size but for one in four, subnormal, or near the root of the largest one.
template <class T>
T number(random& r, sizes which) {
  constexpr int low = std::numeric_limits<T>::min_exponent - std::numeric_limits<T>::digits;
  constexpr int high = std::numeric_limits<T>::max_exponent - 2;
  std::int64_t k = 0;
  switch (which) {
    case sizes::all: k = r.integer(low, high); break;
    case sizes::one_apart: k = r.integer(0, 3) == 0 ? r.integer(low, high) : 0; break;
    case sizes::subnormal: k = r.integer(low, low + 60); break;
    case sizes::roots_of_largest: k = r.integer(high / 2 - 60, high / 2); break;
  }
  return std::ldexp(static_cast<T>(2 * r.unit() - 1), static_cast<int>(k));
}
template <class T, int N>
irg::vec<T, N> vector(random& r, sizes which) {
  return irg::generate_coordinates<irg::vec<T, N>>([&](int) { return number<T>(r, which); });
}
template <class T>
big_rational rational(T x) {
  return big_rational(static_cast<double>(x));
}

// The largest of error(random, sizes) over the trials.
template <class F>
void sweep(const std::string& what, double bound, F error, int per_commit = 10'000) {
  random r(0x5eed);
  const int count = count_of(per_commit);
  double worst = 0;
  for (int i = 0; i < count; ++i) worst = std::fmax(worst, error(r, all_sizes[i % 4]));
  MESSAGE(what, ": ", worst, " ulp on ", count, " arguments");
  INFO(what);
  CHECK(worst <= bound);
}

}  // namespace test::mixed

#endif
