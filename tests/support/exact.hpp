// SPDX-License-Identifier: MIT
// Coordinates of every size, and the rationals that judge what is made of them. Without MPFR and GMP (IRG_HAVE_MPFR
// undefined) tests that need those are left out.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>

#include "big_rational.hpp"
#include "random.hpp"

#ifdef IRG_HAVE_MPFR
namespace test {
using exact = big_rational;
}
#endif

namespace test {

/// How many trials a run takes, from how many it takes per commit.
inline int trials(int per_commit) { return std::getenv("IRG_RELEASE_TIER") != nullptr ? 100 * per_commit : per_commit; }

/// The same for decisions that cost little: some 10^8 of them in the release tier.
inline int many_trials(int per_commit) {
  return std::getenv("IRG_RELEASE_TIER") != nullptr ? 1000 * per_commit : per_commit;
}

/// Coordinates of controlled difficulty.
enum class spread { unit, small_integers, tenths, tiny_steps, any_bits, wide, subnormal };
inline constexpr spread all_spreads[] = {spread::unit,     spread::small_integers, spread::tenths,   spread::tiny_steps,
                                         spread::any_bits, spread::wide,           spread::subnormal};

/// A finite number of the kind, of type T.
template <class T>
T any_coordinate(random& r, spread kind) {
  switch (kind) {
    case spread::unit: return static_cast<T>(2 * r.unit() - 1);
    case spread::small_integers: return static_cast<T>(r.integer(-2, 2));
    case spread::tenths: return static_cast<T>(r.integer(0, 5)) * static_cast<T>(0.1);
    case spread::tiny_steps:
      return static_cast<T>(1) + static_cast<T>(r.integer(0, 4)) * std::numeric_limits<T>::epsilon();
    case spread::any_bits:
      for (;;) {
        T x;
        if constexpr (sizeof(T) == 4)
          x = std::bit_cast<T>(static_cast<std::uint32_t>(r.next()));
        else
          x = std::bit_cast<T>(r.next());
        if (std::isfinite(x)) return x;
      }
    case spread::wide:
      return static_cast<T>(
          std::ldexp(2 * r.unit() - 1, static_cast<int>(sizeof(T) == 4 ? r.integer(-100, 100) : r.integer(-800, 800))));
    case spread::subnormal: return static_cast<T>(r.integer(-9, 9)) * std::numeric_limits<T>::denorm_min();
  }
  return T(0);
}

}  // namespace test
