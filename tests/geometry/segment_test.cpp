// SPDX-License-Identifier: MIT
#include <irg/geometry/segment.hpp>

#include <limits>

#include "support/check_both.hpp"

using irg::box;
using irg::point;
using irg::point_at;
using irg::segment;

TEST_CASE("segment: ends, box, the way back") {
  using S = segment<double, 3>;
  constexpr S s{{0.1, 5, -2}, {0.75, 1, -2}};
  CHECK_BOTH(point_at(s, 0) == s.a);
  CHECK_BOTH(point_at(s, 1) == s.b);
  CHECK_BOTH(point_at(s, 0.5) == point<double, 3>{0.425, 3, -2});
  CHECK_BOTH(enclosing_box(s) == box<double, 3>{{0.1, 1, -2}, {0.75, 5, -2}});
  CHECK_BOTH(reversed(s) == S{s.b, s.a});
  CHECK_BOTH(enclosing_box(S{s.a, s.a}) == box<double, 3>{s.a, s.a});
  static_assert(std::is_aggregate_v<S> && sizeof(S) == 6 * sizeof(double));
}
