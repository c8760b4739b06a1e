// SPDX-License-Identifier: MIT
#include <irg/geometry/textbook/line.hpp>

#include "support/check_both.hpp"
#include "support/rational.hpp"

using irg::line;
using irg::point;
using test::rational;

namespace {

using P = point<double, 2>;
using Q = point<rational, 2>;

}  // namespace

TEST_CASE("textbook::line_through: the printed quotients") {
  CHECK_BOTH(irg::textbook::line_through(Q{1, 1}, Q{4, 3}) ==
             line<rational>{rational(-1, 3), rational(1, 2), rational(-1, 6)});  // (-2, 3, -1)/6
  CHECK_BOTH(!irg::textbook::line_through(P{0, 5}, P{0, 1}));
  CHECK_BOTH(!irg::textbook::line_through(P{1, 5}, P{4, 5}));
  CHECK_BOTH(irg::line_through(P{0, 5}, P{0, 1}).has_value());
}
