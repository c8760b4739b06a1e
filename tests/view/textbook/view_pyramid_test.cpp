// SPDX-License-Identifier: MIT
#include <irg/view/textbook/view_pyramid.hpp>

#include "support/check_both.hpp"
#include "support/rational.hpp"

TEST_CASE("textbook::pyramid_corners: as printed the far corners lie before the near ones, by n/h") {
  using R = test::rational;
  using P = irg::point<R, 3>;
  constexpr irg::view_pyramid<R> course{2, 8, 6, 1, 10};
  CHECK_BOTH(irg::textbook::pyramid_corners(course).at[7] == P{{2, 5}, {3, 10}, {1, 5}});
  CHECK_BOTH(irg::textbook::pyramid_corners(course).at[3] == irg::pyramid_corners(course, irg::handedness::left).at[3]);
}
