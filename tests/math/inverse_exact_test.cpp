// SPDX-License-Identifier: MIT
// The errors of inverse_exact are measured beside those of the other tiers, in inverse_test.cpp.
#include <irg/math/inverse_exact.hpp>

#include "support/check_both.hpp"
#include "support/random.hpp"

using irg::inverse_exact;
using irg::mat;

TEST_CASE("inverse_exact: by hand") {
  CHECK_BOTH(*inverse_exact(mat<double, 2, 2>{{{3, 1}, {5, 2}}}) == mat<double, 2, 2>{{{2, -1}, {-5, 3}}});
  CHECK_BOTH(*inverse_exact(mat<float, 2, 2>{{{3, 0}, {0, 7}}}) == mat<float, 2, 2>{{{1.0f / 3, 0}, {0, 1.0f / 7}}});
  CHECK_BOTH(!inverse_exact(mat<double, 2, 2>{{{3, 1}, {6, 2}}}));
  // 2^53 + 1 is half-way between two doubles.
  CHECK_BOTH((*inverse_exact(mat<double, 2, 2>{{{1, -0x1p53}, {0, 1}}}))(0, 1) == 0x1p53);
  CHECK_BOTH((*inverse_exact(mat<double, 3, 3>{{{1, 0x1p53, 1}, {0, 1, 1}, {0, 0, 1}}}))(0, 2) == 0x1p53 - 1);
  CHECK_BOTH((*inverse_exact(mat<double, 3, 3>{{{1, 0x1p53, -1}, {0, 1, 1}, {0, 0, 1}}}))(0, 2) == 0x1p53);
}

TEST_CASE("inverse_exact: a matrix of integers and determinant 1 has an inverse of integers, found without error") {
  test::random r(1);
  for (int i = 0; i < 200; ++i) {
    mat<double, 4, 4> a = irg::identity<double, 4>(), undo = a;
    for (int k = 0; k < 12; ++k) {
      const int from = static_cast<int>(r.integer(0, 3)), to = static_cast<int>(r.integer(0, 3));
      if (from == to) continue;
      const auto factor = static_cast<double>(r.integer(-9, 9));
      mat<double, 4, 4> shear = irg::identity<double, 4>(), back = shear;
      shear(to, from) = factor;
      back(to, from) = -factor;
      a = shear * a;
      undo = undo * back;
    }
    CHECK(inverse_exact(a) == undo);
  }
}
