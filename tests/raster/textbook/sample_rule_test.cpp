// SPDX-License-Identifier: MIT
#include <irg/raster/textbook/sample_rule.hpp>

#include "support/check_both.hpp"
#include "support/random.hpp"

namespace {

using irg::textbook::cells_of_row;
using irg::textbook::row_cells;
using irg::textbook::row_crossing;
using irg::textbook::sample_rule;

// Whether a rule gives cell x to a row from l / (256 ld) to d / (256 dd), by its words alone.
bool has_cell(long long x, long long l, long long ld, long long d, long long dd, sample_rule rule) {
  const bool level = l * dd == d * ld, rises = l * dd < d * ld;
  if (rule == sample_rule::closed ? !level && !rises : !rises) return false;
  const bool from_l = l <= 256 * x * ld, to_d = 256 * x * dd <= d;
  if (rule == sample_rule::course || rule == sample_rule::closed) return from_l && to_d;
  if (rule == sample_rule::half_open) return from_l && 256 * x * dd < d;
  return 2 * l < (2 * x + 1) * 256 * ld && (2 * x - 1) * 256 * dd <= 2 * d;  // L < x + 1/2, x - 1/2 <= D
}

TEST_CASE("textbook::cells_of_row: rows of the lecture's polygon") {
  constexpr row_crossing l{299 * 256, 3}, d{102 * 256, 1};  // 99 2/3 to 102
  CHECK_BOTH(cells_of_row(l, d, sample_rule::course) == row_cells{100, 103});
  CHECK_BOTH(cells_of_row(l, d, sample_rule::half_open) == row_cells{100, 102});
  CHECK_BOTH(cells_of_row(d, d, sample_rule::closed) == row_cells{102, 103});
  CHECK_BOTH(cells_of_row(d, d, sample_rule::course) == row_cells{});
  CHECK_BOTH(cells_of_row(d, l, sample_rule::closed) == row_cells{});
  CHECK_BOTH(cells_of_row(l, {525 * 256, 2}, sample_rule::rounded) == row_cells{100, 264});
}

TEST_CASE("textbook::cells_of_row: each cell by the rule's words, for random fractions") {
  test::random r(305);
  int cells = 0, wrong = 0;
  for (int trial = 0; trial < 4000; ++trial) {
    const long long ld = r.integer(1, 9), dd = r.integer(1, 9);
    const long long l = r.integer(-20, 20) * 128 * (r.integer(0, 1) * (ld - 1) + 1) + r.integer(-1, 1);
    const long long d = r.integer(0, 9) == 0 ? l * dd / ld : r.integer(-20, 20) * 128 * dd + r.integer(-1, 1);
    for (const sample_rule rule :
         {sample_rule::course, sample_rule::closed, sample_rule::rounded, sample_rule::half_open}) {
      const row_cells row = cells_of_row({l, ld}, {d, dd}, rule);
      for (int x = -50; x < 50; ++x) {
        const bool drawn = row.first <= x && x < row.last;
        wrong += drawn != has_cell(x, l, ld, d, dd, rule);
        cells += drawn;
      }
    }
  }
  CHECK(wrong == 0);
  CHECK(cells > 10000);
}

}  // namespace
