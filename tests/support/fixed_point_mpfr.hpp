// SPDX-License-Identifier: MIT
// A fixed_point as a number of MPFR.
#pragma once

#include <mpfr.h>

#include <irg/math/fixed_point.hpp>

namespace test {

/// Exactly, for a number of MPFR with 64 N bits or more.
template <int N>
void set_to_fixed_point(mpfr_ptr to, const irg::fixed_point<N>& from) {
  mpfr_set_si(to, static_cast<long>(static_cast<std::int64_t>(from.units.word[N - 1])), MPFR_RNDN);
  for (int i = N - 2; i >= 0; --i) {
    mpfr_mul_2ui(to, to, 64, MPFR_RNDN);
    mpfr_add_ui(to, to, static_cast<unsigned long>(from.units.word[i]), MPFR_RNDN);
  }
  mpfr_div_2ui(to, to, 64 * (N - 1), MPFR_RNDN);
}

}  // namespace test
