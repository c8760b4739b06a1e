// SPDX-License-Identifier: MIT
#include <irg/hidden/textbook/facet_angles.hpp>

#include <array>
#include <cmath>

#include "support/check_both.hpp"

using irg::textbook::facet_corner;

TEST_CASE("pseudo_angle: the source's values, rising from -45 degrees to 315") {
  using irg::textbook::pseudo_angle;
  CHECK_BOTH(pseudo_angle(1.0, 0.0) == 0);
  CHECK_BOTH(pseudo_angle(2.0, 1.0) == 0.5);
  CHECK_BOTH(pseudo_angle(1.0, 1.0) == 1);
  CHECK_BOTH(pseudo_angle(1.0, 2.0) == 1.5);
  CHECK_BOTH(pseudo_angle(0.0, 1.0) == 2);
  CHECK_BOTH(pseudo_angle(-1.0, 2.0) == 2.5);
  CHECK_BOTH(pseudo_angle(-1.0, 1.0) == 3);
  CHECK_BOTH(pseudo_angle(-2.0, 1.0) == 3.5);
  CHECK_BOTH(pseudo_angle(-1.0, 0.0) == 4);
  CHECK_BOTH(pseudo_angle(-2.0, -1.0) == 4.5);
  CHECK_BOTH(pseudo_angle(-1.0, -1.0) == 5);
  CHECK_BOTH(pseudo_angle(-1.0, -2.0) == 5.5);
  CHECK_BOTH(pseudo_angle(0.0, -1.0) == 6);
  CHECK_BOTH(pseudo_angle(1.0, -2.0) == 6.5);
  CHECK_BOTH(pseudo_angle(1.0, -1.0) == -1);
  CHECK_BOTH(pseudo_angle(2.0, -1.0) == -0.5);
  CHECK(pseudo_angle(0.0, 0.0) != pseudo_angle(0.0, 0.0));
  double last = -2;
  for (int degrees = -45; degrees < 315; ++degrees) {
    const double a = degrees * 3.14159265358979 / 180, now = pseudo_angle(std::cos(a), std::sin(a));
    if (degrees > -45) CHECK(now > last);
    last = now;
  }
}

TEST_CASE("angle_precedes, advances_perimeter: cyclic; at equal angles the facet goes on") {
  using irg::textbook::angle_precedes;
  CHECK_BOTH(angle_precedes(6.0, 0.0));
  CHECK_BOTH(!angle_precedes(0.0, 6.0));
  CHECK_BOTH(!angle_precedes(3.0, 3.0));
  CHECK_BOTH(!angle_precedes(-1.0, 6.5));
  CHECK_BOTH(angle_precedes(6.5, -1.0));
  CHECK_BOTH(irg::textbook::advances_perimeter(1.0, 1.5));
  CHECK_BOTH(!irg::textbook::advances_perimeter(1.5, 1.5));
}

TEST_CASE("facet_corner_order: the four positions of the source, and the four that it leaves out") {
  using irg::textbook::facet_corner_order;
  using corners = std::array<facet_corner, 4>;
  CHECK_BOTH(facet_corner_order(2, 4, 2, 2) == corners{{{1, 0}, {1, 1}, {0, 1}, {0, 0}}});
  CHECK_BOTH(facet_corner_order(2, 0, 2, 2) == corners{{{0, 1}, {0, 0}, {1, 0}, {1, 1}}});
  CHECK_BOTH(facet_corner_order(4, 2, 2, 2) == corners{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}});
  CHECK_BOTH(facet_corner_order(0, 2, 2, 2) == corners{{{1, 1}, {0, 1}, {0, 0}, {1, 0}}});
  CHECK_BOTH(facet_corner_order(4, 4, 2, 2) == corners{{{1, 0}, {0, 0}, {1, 1}, {0, 1}}});
  CHECK_BOTH(facet_corner_order(0, 4, 2, 2) == corners{{{1, 1}, {1, 0}, {0, 1}, {0, 0}}});
  CHECK_BOTH(facet_corner_order(0, 0, 2, 2) == corners{{{0, 1}, {1, 1}, {0, 0}, {1, 0}}});
  CHECK_BOTH(facet_corner_order(4, 0, 2, 2) == corners{{{0, 0}, {0, 1}, {1, 0}, {1, 1}}});
}
