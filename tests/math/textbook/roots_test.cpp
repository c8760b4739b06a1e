// SPDX-License-Identifier: MIT
#include <irg/math/textbook/roots.hpp>

#include "support/check_both.hpp"

using irg::textbook::quadratic_roots;

TEST_CASE("textbook::quadratic_roots: by hand") {
  CHECK_BOTH(quadratic_roots(1.0, -3.0, 2.0) == irg::quadratic_roots(1.0, -3.0, 2.0));
  CHECK_BOTH(quadratic_roots(1.0, 0.0, 1.0).count == 0);
  CHECK_BOTH(quadratic_roots(2.0f, -6.0f, 4.0f).root[1] == 2.0f);
}

TEST_CASE("textbook::quadratic_roots: what is wrong with it") {
  CHECK_BOTH(quadratic_roots(1.0, -1e9, 1.0).root[0] == 0);
  CHECK_BOTH(irg::quadratic_roots(1.0, -1e9, 1.0).root[0] == 1e-9);
  // The discriminant is 2^-56 above zero.
  CHECK_BOTH(quadratic_roots(1 + 0x1p-28, 2.0, 1 - 0x1p-28).count == 1);
  CHECK_BOTH(irg::quadratic_roots(1 + 0x1p-28, 2.0, 1 - 0x1p-28).count == 2);
}
