// SPDX-License-Identifier: MIT
#include <irg/view/textbook/view_steps.hpp>

#include <limits>

#include "support/check_both.hpp"

using irg::hpoint;
using irg::identity_matrix;
using irg::mat;
using irg::textbook::transform_row;

namespace {

using P = irg::point<double, 3>;
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();

}  // namespace

TEST_CASE("textbook view steps: what each does to a row") {
  using irg::textbook::view_mirror;
  using irg::textbook::view_quarter_turn;
  using irg::textbook::view_rotation_y;
  using irg::textbook::view_rotation_z;
  CHECK_BOTH(transform_row(P{1, 2, 3}, irg::textbook::view_translation(P{5, -6, 7})) == P{-4, 8, -4});
  CHECK_BOTH(transform_row(P{0, 4, 3}, view_rotation_z(P{0, 4, 3})) == P{4, 0, 3});
  CHECK_BOTH(transform_row(P{-2, 0, 0}, view_rotation_y(P{-2, 0, 0})) == P{0, 0, 2});
  CHECK_BOTH(transform_row(P{1, 2, 3}, view_quarter_turn<double>()) == P{2, -1, 3});
  CHECK_BOTH(transform_row(P{1, 2, 3}, view_mirror<double>()) == P{-1, 2, 3});
  CHECK_BOTH(transform_row(hpoint<double, 3>{1, 2, 3, 2}, irg::textbook::view_translation(P{5, -6, 7})) ==
             hpoint<double, 3>{-9, 14, -11, 2});
}

TEST_CASE("textbook view steps: each alone is total") {
  CHECK_BOTH(irg::textbook::view_rotation_z(P{0, 0, 7}) == identity_matrix<double, 4>());
  CHECK_BOTH(irg::textbook::view_rotation_z(P{not_a_number, 0, 7}) == identity_matrix<double, 4>());
  CHECK_BOTH(irg::textbook::view_rotation_y(P{0, 0, 0}) == identity_matrix<double, 4>());
  CHECK_BOTH(irg::textbook::view_rotation_y(P{0, 0, inf}) == identity_matrix<double, 4>());
}
