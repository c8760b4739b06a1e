// SPDX-License-Identifier: MIT
#include <irg/geometry/vocabulary.hpp>

#include <array>
#include <limits>
#include <type_traits>

#include "support/check_both.hpp"
#include "support/own_types.hpp"

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
  CHECK_BOTH(bounding_box(s) == box<double, 3>{{0.1, 1, -2}, {0.75, 5, -2}});
  CHECK_BOTH(reversed(s) == S{s.b, s.a});
  CHECK_BOTH(bounding_box(S{s.a, s.a}) == box<double, 3>{s.a, s.a});
  static_assert(std::is_aggregate_v<S> && sizeof(S) == 6 * sizeof(double));
}

#include <irg/geometry/box.hpp>
#include <irg/geometry/clip_line_cohen_sutherland.hpp>
#include <irg/geometry/clip_line_liang_barsky.hpp>
#include <irg/geometry/clip_line_nicholl_lee_nicholl.hpp>
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
  CHECK_BOTH(irg::is_finite(P{1, 2, 3}));
  CHECK_BOTH(!irg::is_finite(P{infinite, 2, 3}));
  CHECK_BOTH(!irg::is_finite(P{1, -infinite, 3}));
  CHECK_BOTH(!irg::is_finite(P{1, 2, infinite}));
  CHECK_BOTH(irg::is_finite(irg::point<int, 2>{1, 2}));
  CHECK_BOTH(irg::is_finite(std::array<double, 2>{1, 2}));  // and none beyond the last
}

#if defined(IRG_HAVE_EIGEN) || defined(IRG_HAVE_OPENCV)
namespace {

// Of points whose == is not constexpr: all three find (0, 2) and (4, 2).
template <class P>
void clip_foreign_line() {
  const irg::box<double, 2> window{{0, 0}, {4, 4}};
  const P a(-2, 2), b(6, 2);
  const auto liang_barsky = irg::clip_line_liang_barsky(a, b, window);
  REQUIRE(liang_barsky);
  CHECK(irg::coordinate(liang_barsky->first, 0) == 0);
  CHECK(irg::coordinate(liang_barsky->second, 0) == 4);
  CHECK(liang_barsky->t_first == 0.25);
  CHECK(irg::clip_line_cohen_sutherland(a, b, window) == liang_barsky);
  CHECK(irg::clip_line_nicholl_lee_nicholl(a, b, window) == liang_barsky);
}

}  // namespace
#endif

TEST_CASE("clipped_line: points of Eigen and OpenCV") {
#ifdef IRG_HAVE_EIGEN
  clip_foreign_line<Eigen::Vector2d>();
#else
  MESSAGE("skipped: Eigen was not found");
#endif
#ifdef IRG_HAVE_OPENCV
  clip_foreign_line<cv::Point2d>();
#else
  MESSAGE("skipped: OpenCV was not found");
#endif
}
