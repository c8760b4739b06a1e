// SPDX-License-Identifier: MIT
#include <irg/geometry/clipped_line.hpp>

#include <limits>
#include <type_traits>

#include <irg/math/vec.hpp>

#include "support/check_both.hpp"

TEST_CASE("clipped_line: the whole line by default, parameters as precise as the coordinates") {
  using F = irg::clipped_line<irg::point<float, 2>>;
  static_assert(std::is_same_v<F::parameter, float>);
  static_assert(std::is_same_v<irg::clipped_line<irg::point<int, 2>>::parameter, double>);
  CHECK_BOTH((F{{1, 2}, {3, 4}}.t_first == 0 && F{{1, 2}, {3, 4}}.t_second == 1));
  CHECK_BOTH((F{{1, 2}, {3, 4}} == F{{1, 2}, {3, 4}, 0, 1}));
}

TEST_CASE("clipped_line: every coordinate of a point is looked at") {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  using P = irg::point<double, 3>;
  CHECK_BOTH(irg::detail::has_finite_coordinates(P{1, 2, 3}));
  CHECK_BOTH(!irg::detail::has_finite_coordinates(P{infinite, 2, 3}));
  CHECK_BOTH(!irg::detail::has_finite_coordinates(P{1, -infinite, 3}));
  CHECK_BOTH(!irg::detail::has_finite_coordinates(P{1, 2, infinite}));
  CHECK_BOTH(irg::detail::has_finite_coordinates(irg::point<int, 2>{1, 2}));
}
