// SPDX-License-Identifier: MIT
// The axes by added right angles stand beside polar_frame's in tests/view/polar_camera_test.cpp, in the table of values
// and on random angles.
#include <irg/view/textbook/polar_camera.hpp>

#include "support/check_both.hpp"

namespace {

using P = irg::point<double, 3>;
constexpr auto seen_from = [](double d) { return view_matrix(irg::textbook::viewer_frame(d), irg::handedness::left); };

}  // namespace

TEST_CASE("textbook::viewer_frame: the polar camera of both angles 0, its depth d minus the distance along the view") {
  CHECK_BOTH(irg::textbook::viewer_frame(7.0) ==
             polar_frame(P{0, 0, 0}, 7.0, {irg::sin_cos_degrees(0.0), irg::sin_cos_degrees(0.0)}));
  CHECK_BOTH(7 - transform_point(seen_from(7.0), P{1, 2, 3}).z == 3);
}

TEST_CASE("textbook::polar_frame: right, up and forward are left-handed, and X = Z x Y points to the right") {
  constexpr auto f = irg::textbook::polar_frame(5.0, 0.0, 0.0);
  CHECK_BOTH((f.position == P{0, 0, 5} && f.right == irg::vec<double, 3>{1, 0, 0}));
  CHECK_BOTH(dot(f.right, cross(f.up, f.forward)) == -1);
  CHECK_BOTH(irg::textbook::polar_frame(0.0, 0.0, 0.0).position == P{0, 0, 0});
}
