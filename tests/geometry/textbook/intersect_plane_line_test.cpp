// SPDX-License-Identifier: MIT
#include <irg/geometry/textbook/intersect_plane_line.hpp>

#include "support/check_both.hpp"
#include "support/rational.hpp"

using irg::intersect_plane_line;
using irg::parametric_line;
using irg::parametric_plane;
using irg::point;
using test::rational;

namespace {

template <class T>
constexpr auto ground = parametric_plane<T>{{1, 0, 0}, {0, 1, 0}, {0, 0, 0}};
using Q = parametric_line<rational, 3>;
using L = parametric_line<double, 3>;

}  // namespace

TEST_CASE("textbook::intersect_plane_line_by_gauss: Hank's values") {
  constexpr auto first =
      *irg::textbook::intersect_plane_line_by_gauss(ground<rational>, Q{{{1, 4}, {1, 2}, 1}, {0, 0, -2}});
  CHECK_BOTH(first.s1 == rational(1, 4));
  CHECK_BOTH(first.s2 == rational(1, 2));
  CHECK_BOTH(first.t == rational(1, 2));
  constexpr auto second = *irg::textbook::intersect_plane_line_by_gauss(ground<rational>, Q{{0, 0, 2}, {2, 4, -1}});
  CHECK_BOTH(second.at == point<rational, 3>{4, 8, 0});
  CHECK_BOTH(second.s1 == rational(4));
  CHECK_BOTH(!irg::textbook::intersect_plane_line_by_gauss(ground<rational>, Q{{0, 0, 1}, {1, 0, 0}}));
  CHECK_BOTH(!irg::textbook::intersect_plane_line_by_gauss(ground<rational>, Q{{0, 0, 0}, {1, 1, 0}}));
}

TEST_CASE("textbook::intersect_plane_line_by_gauss: short directions are none to it") {
  constexpr L line{{0, 0, 1e-7}, {0, 0, 1e-7}};
  CHECK_BOTH(!irg::textbook::intersect_plane_line_by_gauss(ground<double>, line));
  CHECK_BOTH(intersect_plane_line(ground<double>, line).t == -1);
}
