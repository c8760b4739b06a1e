// SPDX-License-Identifier: MIT
#include <irg/geometry/closest_point.hpp>

#include <limits>

#include "geometry/mixed_cases.hpp"
#include "geometry/nearest_cases.hpp"
#include "support/check_both.hpp"
#include "support/rational.hpp"

using irg::box;
using irg::closest_point_in_box;
using irg::closest_point_on_line;
using irg::closest_point_on_plane;
using irg::closest_point_on_segment;
using irg::closest_point_on_triangle;
using irg::closest_points_of_lines;
using irg::closest_points_of_segments;
using irg::plane;
using irg::point;
using irg::triangle_region;
using test::rational;

namespace {

using P2 = point<double, 2>;
using P3 = point<double, 3>;
using Q3 = point<rational, 3>;
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double huge = (std::numeric_limits<double>::max)();

constexpr auto on_triangle(const P3& p) { return *closest_point_on_triangle(P3{0, 0, 0}, P3{4, 0, 0}, P3{0, 4, 0}, p); }
constexpr bool nearest(const P3& p, triangle_region region, const P3& at) {
  return on_triangle(p).region == region && on_triangle(p).at == at;
}

}  // namespace

TEST_CASE("closest points: what comes out is a value") {
  CHECK_BOTH((irg::point_on_line<P2>{{1, 2}, 3} == irg::point_on_line<P2>{{1, 2}, 3}));
  CHECK_BOTH((irg::point_on_line<P2>{{1, 2}, 3} != irg::point_on_line<P2>{{1, 2}, 4}));
  CHECK_BOTH((irg::point_pair<P3>{{}, {1, 2, 3}} != irg::point_pair<P3>{{}, {1, 2, 4}}));
}

TEST_CASE("closest_point: line, segment, plane, box") {
  CHECK_BOTH(closest_point_on_line(P2{0, 0}, P2{4, 0}, P2{6, 3})->at == P2{6, 0});
  CHECK_BOTH(closest_point_on_line(P2{0, 0}, P2{4, 0}, P2{6, 3})->t == 1.5);
  CHECK_BOTH(closest_point_on_segment(P2{0, 0}, P2{4, 0}, P2{6, 3})->at == P2{4, 0});
  CHECK_BOTH(closest_point_on_segment(P2{0, 0}, P2{4, 0}, P2{-1, 3})->t == 0);
  CHECK_BOTH(closest_point_on_segment(P2{0, 0}, P2{4, 0}, P2{1, 3})->t == 0.25);
  CHECK_BOTH(closest_point_on_segment(P2{2, 2}, P2{2, 2}, P2{1, 3})->at == P2{2, 2});
  CHECK_BOTH(closest_point_on_line(Q3{0, 0, 0}, Q3{1, 1, 1}, Q3{1, 2, 4})->t == rational(7, 3));
  CHECK_BOTH(closest_point_on_plane(plane<rational>{1, 1, 1, -3}, Q3{0, 0, 0}) == Q3{1, 1, 1});
  CHECK_BOTH(closest_point_on_plane(plane<double>{0, 0, 2, -6}, P3{5, 7, 100}) == P3{5, 7, 3});
  CHECK_BOTH(closest_point_in_box(box<double, 3>{{0, 0, 0}, {1, 1, 1}}, P3{2, 0.5, -3}) == P3{1, 0.5, 0});
  CHECK_BOTH(closest_point_in_box(box<int, 2>{{0, 0}, {4, 4}}, point<int, 2>{2, 9}) == point<int, 2>{2, 4});
}

TEST_CASE("closest_point: all regions of a triangle") {
  CHECK_BOTH(nearest({1, 1, 5}, triangle_region::face, {1, 1, 0}));
  CHECK_BOTH(nearest({-1, -1, 5}, triangle_region::corner_a, {0, 0, 0}));
  CHECK_BOTH(nearest({9, -1, 5}, triangle_region::corner_b, {4, 0, 0}));
  CHECK_BOTH(nearest({-1, 6, 5}, triangle_region::corner_c, {0, 4, 0}));
  CHECK_BOTH(nearest({1, -2, 5}, triangle_region::edge_ab, {1, 0, 0}));
  CHECK_BOTH(nearest({4, 4, 5}, triangle_region::edge_bc, {2, 2, 0}));
  CHECK_BOTH(nearest({-2, 1, 5}, triangle_region::edge_ca, {0, 1, 0}));
  CHECK_BOTH(on_triangle({1, 1, 5}).weights == std::array{0.5, 0.25, 0.25});
  CHECK_BOTH(on_triangle({1, -2, 5}).weights == std::array{0.75, 0.25, 0.0});
  CHECK_BOTH(on_triangle({3, 4, 5}).weights == std::array{0.0, 0.375, 0.625});
  CHECK_BOTH(on_triangle({-2, 1, 5}).weights == std::array{0.75, 0.0, 0.25});
  CHECK_BOTH(on_triangle({-1, -1, 5}).weights == std::array{1.0, 0.0, 0.0});
  CHECK_BOTH(on_triangle({9, -1, 5}).weights == std::array{0.0, 1.0, 0.0});
  CHECK_BOTH(on_triangle({-1, 6, 5}).weights == std::array{0.0, 0.0, 1.0});
  // Triangles that are segments or points.
  const auto degenerate = [](const P3& a, const P3& b, const P3& c, const P3& p) {
    return closest_point_on_triangle(a, b, c, p)->at;
  };
  CHECK(degenerate({0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {1.5, 3, 0}) == P3{1.5, 0, 0});
  CHECK(degenerate({0, 0, 0}, {2, 0, 0}, {1, 0, 0}, {1.5, 3, 0}) == P3{1.5, 0, 0});
  CHECK(degenerate({1, 0, 0}, {0, 0, 0}, {2, 0, 0}, {1.5, 3, 0}) == P3{1.5, 0, 0});
  CHECK(degenerate({0, 0, 0}, {0, 0, 0}, {2, 0, 0}, {1.5, 3, 0}) == P3{1.5, 0, 0});
  CHECK(degenerate({0, 0, 0}, {2, 0, 0}, {2, 0, 0}, {1.5, 3, 0}) == P3{1.5, 0, 0});
  CHECK(degenerate({1, 2, 3}, {1, 2, 3}, {1, 2, 3}, {1.5, 3, 0}) == P3{1, 2, 3});
}

TEST_CASE("closest_points: lines and segments") {
  constexpr auto skew = *closest_points_of_lines(P3{0, 0, 0}, P3{1, 0, 0}, P3{3, 1, 2}, P3{3, 2, 2});
  CHECK_BOTH(skew.first == P3{3, 0, 0});
  CHECK_BOTH(skew.second == P3{3, 0, 2});
  CHECK_BOTH(skew.t == 3);
  CHECK_BOTH(skew.s == -1);
  constexpr auto parallel = *closest_points_of_lines(P3{0, 0, 0}, P3{1, 0, 0}, P3{3, 1, 2}, P3{5, 1, 2});
  CHECK_BOTH(parallel.first == P3{0, 0, 0});
  CHECK_BOTH(parallel.second == P3{0, 1, 2});
  constexpr auto ends = *closest_points_of_segments(P3{0, 0, 0}, P3{1, 0, 0}, P3{3, 1, 2}, P3{3, 2, 2});
  CHECK_BOTH(ends.first == P3{1, 0, 0});
  CHECK_BOTH(ends.second == P3{3, 1, 2});
  CHECK_BOTH(ends.t == 1);
  constexpr auto inside = *closest_points_of_segments(P3{0, 0, 0}, P3{4, 0, 0}, P3{3, -1, 2}, P3{3, 3, 2});
  CHECK_BOTH(inside.second == P3{3, 0, 2});
  CHECK_BOTH(inside.s == 0.25);
  constexpr auto crossing = *closest_points_of_segments(P2{0, 0}, P2{2, 2}, P2{0, 2}, P2{2, 0});
  CHECK_BOTH(crossing.first == P2{1, 1});
  CHECK_BOTH(crossing.t == 0.5);
  constexpr auto overlap = *closest_points_of_segments(P2{0, 0}, P2{4, 0}, P2{6, 0}, P2{2, 0});
  CHECK_BOTH(overlap.first == P2{2, 0});
  CHECK_BOTH(overlap.t == 0.5);
  CHECK_BOTH(overlap.s == 1);
}

TEST_CASE("closest_point: bad input and the ends of the range") {
  CHECK_BOTH(!closest_point_on_line(P2{1, 1}, P2{1, 1}, P2{2, 2}));
  CHECK_BOTH(!closest_point_on_line(P2{1, not_a_number}, P2{1, 1}, P2{2, 2}));
  CHECK_BOTH(!closest_point_on_segment(P2{1, 1}, P2{1, 1}, P2{2, not_a_number}));
  CHECK_BOTH(!closest_point_on_plane(plane<double>{0, 0, 0, 1}, P3{1, 2, 3}));
  CHECK_BOTH(!closest_point_on_triangle(P3{0, 0, 0}, P3{4, 0, 0}, P3{0, 4, 0}, P3{0, not_a_number, 0}));
  CHECK_BOTH(!closest_points_of_lines(P3{0, 0, 0}, P3{0, 0, 0}, P3{1, 1, 0}, P3{2, 4, 0}));
  CHECK_BOTH(!closest_points_of_segments(P2{0, 0}, P2{1, 0}, P2{1, not_a_number}, P2{2, 4}));
  CHECK_BOTH(closest_point_on_segment(P2{-huge, 0}, P2{huge, 0}, P2{1, huge})->at == P2{1, 0});
  CHECK_BOTH(closest_point_on_plane(plane<double>{huge, huge, huge, 0}, P3{huge, -huge, 5}) ==
             P3{huge, -huge, 10.0 / 3});
}

#ifdef IRG_HAVE_MPFR
namespace {

using test::dot;
using test::exactly;
using test::nearest_on_segment;
using test::nearest_on_triangle;
using test::squared_distance_of_segments;
using test::operator-;

struct tally {
  double worst = 0;
  int wrong = 0;
  template <class T, int N>
  void add(const point<T, N>& got, const test::place<static_cast<std::size_t>(N)>& want) {
    for (int i = 0; i < N; ++i) worst = std::fmax(worst, test::error_in_ulp(got[i], want[static_cast<std::size_t>(i)]));
  }
};

template <int N>
void compare(const point<double, N> (&p)[4], tally& sum) {
  const auto a = exactly(p[0]), b = exactly(p[1]), c = exactly(p[2]), d = exactly(p[3]);
  sum.add(closest_point_on_segment(p[0], p[1], p[2])->at, nearest_on_segment(a, b, c));
  if constexpr (N == 3) sum.add(closest_point_on_triangle(p[0], p[1], p[2], p[3])->at, nearest_on_triangle(a, b, c, d));
  // Nearest points of segments need not be the only ones: their distance is the least, but for rounding.
  const auto pair = *closest_points_of_segments(p[0], p[1], p[2], p[3]);
  const auto first = exactly(pair.first), second = exactly(pair.second);
  const test::exact least = squared_distance_of_segments(a, b, c, d);
  const test::exact size = dot(first, first) + dot(second, second), smallest(0x1p-1074);
  const test::exact rounding = size * test::exact(0x1p-60) + smallest * smallest * test::exact(0x1p50);
  sum.wrong += least + least * test::exact(0x1p-40) + rounding < dot(first - second, first - second);
  sum.wrong += !(pair.t >= 0 && pair.t <= 1 && pair.s >= 0 && pair.s <= 1);
}

template <int N>
tally run() {
  test::random r(37);
  tally sum;
  for (const test::spread kind : test::all_spreads)
    for (int i = 0; i < test::trials(kind == test::spread::any_bits || kind == test::spread::wide ? 15 : 60); ++i) {
      point<double, N> p[4];
      for (auto& q : p)
        for (int k = 0; k < N; ++k) q[k] = test::any_coordinate<double>(r, kind);
      if (i % 4 == 1) p[3] = p[2] + (p[1] - p[0]);
      if (i % 8 == 2) p[1] = p[0];
      if (i % 8 == 6) p[2] = p[0] + (p[1] - p[0]) * 0.5;
      bool finite = true;
      for (const auto& q : p)
        for (int k = 0; k < N; ++k) finite = finite && std::isfinite(q[k]);
      if (finite) compare(p, sum);
    }
  return sum;
}

}  // namespace

TEST_CASE("closest_point: half an ulp from the exact nearest point, all magnitudes") {
  for (const tally& sum : {run<2>(), run<3>()}) {
    MESSAGE("worst ", sum.worst, " ulp");
    CHECK(sum.worst <= 0.501);
    CHECK(sum.wrong == 0);
  }
}

TEST_CASE_TEMPLATE("closest points: numbers of all sizes", T, double, float) {
  using namespace test::mixed;
  using test::mixed::squared_distance_of_segments;
  sweep(
      named<T>("closest_point_on_line and on_segment"), 0.501,
      [](test::random& r, sizes which) {
        const auto p = points<T, 3, 3>(r, which);
        const auto a = exactly(p[0]), b = exactly(p[1]), c = exactly(p[2]);
        const auto on_line = closest_point_on_line(p[0], p[1], p[2]);
        const auto on_segment = closest_point_on_segment(p[0], p[1], p[2]);
        const segment_foot foot(a, b, c);
        double worst = off_between(on_segment->at, p[0], p[1], foot.t);
        worst = std::fmax(worst, quotient_error(on_segment->t, foot.t.p, foot.t.q));
        if (foot.t.p.sign() == 0 && !(on_segment->at == p[0])) return wrong;
        if (foot.t.p == foot.t.q && !(on_segment->at == p[1])) return wrong;
        if (p[0] == p[1]) return on_line ? wrong : worst;
        const quotient t{dot(b - a, c - a), dot(b - a, b - a)};
        worst = std::fmax(worst, quotient_error(on_line->t, t.p, t.q));
        return std::fmax(worst, off_between(on_line->at, p[0], p[1], t));
      },
      1000);
  sweep(
      named<T>("closest_point_on_plane"), 0.501,
      [](test::random& r, sizes which) {
        const auto c = numbers<T, 7>(r, which);
        const auto e = rationals(c);
        const auto got = closest_point_on_plane(irg::plane<T>{c[0], c[1], c[2], c[3]}, point<T, 3>{c[4], c[5], c[6]});
        const E squared = e[0] * e[0] + e[1] * e[1] + e[2] * e[2];
        const E height = e[0] * e[4] + e[1] * e[5] + e[2] * e[6] + e[3];
        if (got.has_value() != (squared.sign() != 0)) return wrong;
        double worst = 0;
        for (std::size_t k = 0; got && k < 3; ++k)
          worst = std::fmax(worst,
                            quotient_error((*got)[static_cast<int>(k)], e[4 + k] * squared - e[k] * height, squared));
        return worst;
      },
      3000);
  sweep(
      named<T>("closest_point_on_triangle"), 0.501,
      [](test::random& r, sizes which) {
        const auto p = points<T, 3, 4>(r, which);
        const auto got = closest_point_on_triangle(p[0], p[1], p[2], p[3]);
        const auto a = exactly(p[0]), b = exactly(p[1]), c = exactly(p[2]);
        const triangle_nearest want(a, b, c, exactly(p[3]));
        double worst = 0;
    // A degenerate triangle's weights are not the only ones.
        const bool is_triangle = gram(b - a, c - a).sign() > 0;
        for (std::size_t i = 0; i < 3 && is_triangle; ++i)
          worst = std::fmax(worst, quotient_error(got->weights[i], want.weight[i], want.whole));
        for (int k = 0; k < 3; ++k) {
          const E at = of(p[0][k]) * want.weight[0] + of(p[1][k]) * want.weight[1] + of(p[2][k]) * want.weight[2];
          worst = std::fmax(worst, quotient_error(got->at[k], at, want.whole));
        }
        return worst;
      },
      1000);
  sweep(
      named<T>("closest_points_of_lines"), 0.501,
      [](test::random& r, sizes which) {
        const auto p = points<T, 3, 4>(r, which);
        const auto got = closest_points_of_lines(p[0], p[1], p[2], p[3]);
        if (p[0] == p[1] || p[2] == p[3]) return got ? wrong : 0.0;
        const lines_foot want(exactly(p[0]), exactly(p[1]), exactly(p[2]), exactly(p[3]));
        if (want.t.q.sign() == 0) return got->first == p[0] ? 0.0 : wrong;
        const double first =
            std::fmax(quotient_error(got->t, want.t.p, want.t.q), off_between(got->first, p[0], p[1], want.t));
        const double second =
            std::fmax(quotient_error(got->s, want.s.p, want.s.q), off_between(got->second, p[2], p[3], want.s));
        return std::fmax(first, second);
      },
      1000);
  // Inside of both segments, or an end and the point nearest to it: an end as near as any, but for 2^-60.
  sweep(
      named<T>("closest_points_of_segments"), 0.501,
      [](test::random& r, sizes which) {
        const auto p = points<T, 3, 4>(r, which);
        const auto got = closest_points_of_segments(p[0], p[1], p[2], p[3]);
        const quotient least = squared_distance_of_segments(p);
        if (!got) return wrong;
        if (least.p.sign() == 0) return got->first == got->second ? 0.0 : wrong;
        const place<3> e[4] = {exactly(p[0]), exactly(p[1]), exactly(p[2]), exactly(p[3])};
        const lines_foot lines(e[0], e[1], e[2], e[3]);
        const auto off = [&](const quotient& t, const quotient& s) {
          const double first = std::fmax(quotient_error(got->t, t.p, t.q), off_between(got->first, p[0], p[1], t));
          const double second = std::fmax(quotient_error(got->s, s.p, s.q), off_between(got->second, p[2], p[3], s));
          return std::fmax(first, second);
        };
        const quotient enough{least.p * (E(1) + E(0x1p-60)), least.q};
        double best = lines.is_inside() ? off(lines.t, lines.s) : wrong;
        for (std::size_t i = 0; i < 4; ++i) {
          const std::size_t other = i < 2 ? 2 : 0;
          const segment_foot foot(e[other], e[other + 1], e[i]);
          if (enough < foot.squared) continue;
          const quotient end{E(static_cast<int>(i % 2)), E(1)};
          best = std::fmin(best, i < 2 ? off(end, foot.t) : off(foot.t, end));
        }
        return best;
      },
      1000);
}
#endif
