// SPDX-License-Identifier: MIT
// Trials of predicates that are to be exact for floats, doubles and int64: numbers that are hard for them, and how often
// each sign must have been due.
#pragma once

#include <array>
#include <concepts>
#include <limits>

#include <doctest/doctest.h>

#include "support/exact.hpp"

namespace test {

/// A number of T, hard in the given way, or (kind == 8) in a way of its own.
template <class T>
T hard_number(random& r, int kind) {
  if (kind == 8) kind = static_cast<int>(r.integer(0, 7));
  if constexpr (std::integral<T>) {
    constexpr std::int64_t most = std::numeric_limits<T>::max(), least = std::numeric_limits<T>::min();
    if (kind < 2) return static_cast<T>(r.integer(least, most));
    if (kind < 5) return static_cast<T>(r.integer(-2, 2));
    return static_cast<T>(r.integer(0, 1) != 0 ? most - r.integer(0, 2) : least + r.integer(0, 2));
  } else {
    if (kind < 7) return any_coordinate<T>(r, all_spreads[kind]);
    const T ends[] = {std::numeric_limits<T>::max(), std::numeric_limits<T>::min(),
                      std::numeric_limits<T>::denorm_min(), 0, 1};
    return ends[r.integer(0, 4)] * (r.integer(0, 1) != 0 ? T(1) : T(-1));
  }
}
inline int hard_kind(random& r) { return static_cast<int>(r.integer(0, 8)); }

/// Counts signs; each has to come up in more than 1 of 100 trials.
class sign_counts {
public:
  void add(int sign) { ++seen_[static_cast<std::size_t>(sign + 1)]; }
  void check() const {
    for (const int count : seen_) CHECK(100 * count > seen_[0] + seen_[1] + seen_[2]);
  }

private:
  std::array<int, 3> seen_{};
};

#ifdef IRG_HAVE_MPFR
template <class T>
exact exact_of(T x) {
  if constexpr (std::integral<T>)
    return exact(static_cast<double>(x >> 32)) * exact(0x1p32) + exact(static_cast<double>(x & 0xffffffff));
  else
    return exact(static_cast<double>(x));
}
#endif

}  // namespace test
