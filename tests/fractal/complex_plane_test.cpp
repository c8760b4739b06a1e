// SPDX-License-Identifier: MIT
#include <irg/fractal/complex_plane.hpp>

#include "support/check_both.hpp"

namespace {

using plane = irg::complex_plane<double>;
using C = irg::point<double, 2>;
constexpr plane course{{-1.5, 0.5, -1, 1}, 9, 9};

}  // namespace

TEST_CASE("complex_plane: the borders are columns and rows, the first row is the top") {
  CHECK_BOTH(course.at(0, 8) == C{-1.5, -1});
  CHECK_BOTH(course.at(8, 0) == C{0.5, 1});
  CHECK_BOTH(course.at(4, 4) == C{-0.5, 0});
  CHECK_BOTH(course.at(6, 6) == C{0, -0.5});
}

TEST_CASE("complex_plane: pixel centres") {
  constexpr plane p{{0, 4, 0, 2}, 4, 2, irg::plane_sampling::centres};
  CHECK_BOTH(p.at(0, 0) == C{0.5, 1.5});
  CHECK_BOTH(p.at(3, 1) == C{3.5, 0.5});
}

TEST_CASE("complex_plane: one pixel, mirrored windows, packs") {
  CHECK_BOTH(plane{{3, 3, 2, 2}, 1, 1}.at(0, 0) == C{3, 2});
  CHECK_BOTH((plane{}.width == 0 && plane{}.height == 0));
  CHECK_BOTH(plane{{1, -1, 1, -1}, 3, 3}.at(0, 0) == C{1, -1});
  using F = irg::pack<double, 4>;
  const F real = course.real(irg::lanes<F>::ramp());
  for (int i = 0; i < 4; ++i) CHECK(real[i] == course.real(static_cast<double>(i)));
}
