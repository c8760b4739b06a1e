// SPDX-License-Identifier: MIT
#include <irg/hidden/horizon_view.hpp>

#include "support/check_both.hpp"

TEST_CASE("horizon_view: what is drawn unless said otherwise; curves in order of their distance") {
  constexpr irg::horizon_view v;
  CHECK_BOTH(v.curves == 41);
  CHECK_BOTH(v.families == irg::horizon_curves::both);
  CHECK_BOTH(sample_steps(v, 1.0) == 400);  // 380 columns, ten for each of 40 crossing curves
  constexpr auto order = [](double eye) {
    int digits = 0;
    irg::detail::visit_away_from(eye, 5, [&](int i) { digits = 10 * digits + i; });
    return digits;
  };
  CHECK_BOTH(order(-1) == 1234);
  CHECK_BOTH(order(2) == 43210);
  CHECK_BOTH(order(0.5) == 23410);  // from the curve under the eye on, then those before it
  CHECK_BOTH(order(0.3) == 23410);
}
