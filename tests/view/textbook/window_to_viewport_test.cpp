// SPDX-License-Identifier: MIT
// Beside window_to_viewport, on the same values: tests/view/window_to_viewport_test.cpp.
#include <irg/view/textbook/window_to_viewport.hpp>

#include "support/check_both.hpp"
#include "support/rational.hpp"

TEST_CASE("textbook::to_pixels: the upper edge has to be negated") {
  using R = test::rational;
  using P = irg::point<R, 2>;
  constexpr irg::viewport<R> whole{0, 0, 800, 600};
  CHECK_BOTH(irg::textbook::to_pixels(irg::textbook::edged_window<R>{-4, -3, 8, 6}, whole, P{-4, 3}) == P{0, 0});
  CHECK_BOTH(irg::textbook::to_pixels(irg::textbook::edged_window<R>{-4, 3, 8, 6}, whole, P{-4, 3}) == P{0, -600});
}
