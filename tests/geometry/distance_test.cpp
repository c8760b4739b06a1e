// SPDX-License-Identifier: MIT
#include <irg/geometry/distance.hpp>

#include <limits>

#include "geometry/mixed_cases.hpp"
#include "geometry/nearest_cases.hpp"
#include "support/check_both.hpp"

using irg::box;
using irg::distance;
using irg::distance_of_lines;
using irg::distance_of_segments;
using irg::distance_to_box;
using irg::distance_to_line;
using irg::distance_to_segment;
using irg::distance_to_triangle;
using irg::line;
using irg::plane;
using irg::point;
using irg::signed_distance;

namespace {

using P2 = point<double, 2>;
using P3 = point<double, 3>;
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double huge = (std::numeric_limits<double>::max)();

}  // namespace

TEST_CASE("distance: by hand") {
  CHECK_BOTH(distance(P2{1, 1}, P2{4, 5}) == 5);
  CHECK_BOTH(distance(point<float, 3>{1, 1, 1}, point<float, 3>{3, 4, 7}) == 7);
  CHECK_BOTH(distance_to_line(P2{0, 0}, P2{4, 3}, P2{3, -4}) == 5);
  CHECK_BOTH(distance_to_line(P3{0, 0, 0}, P3{0, 0, 9}, P3{3, 4, 100}) == 5);
  CHECK_BOTH(signed_distance(line<double>{3, 4, 5}, P2{0, 0}) == 1);
  CHECK_BOTH(signed_distance(line<double>{3, 4, -5}, P2{0, 0}) == -1);
  CHECK_BOTH(signed_distance(plane<double>{2, 3, 6, -14}, P3{0, 0, 0}) == -2);
  CHECK_BOTH(distance_to_segment(P2{0, 0}, P2{4, 0}, P2{7, 4}) == 5);
  CHECK_BOTH(distance_to_segment(P2{0, 0}, P2{4, 0}, P2{2, -4}) == 4);
  CHECK_BOTH(distance_to_triangle(P3{0, 0, 0}, P3{4, 0, 0}, P3{0, 4, 0}, P3{1, 1, -3}) == 3);
  CHECK_BOTH(distance_to_triangle(P3{0, 0, 0}, P3{4, 0, 0}, P3{0, 4, 0}, P3{1, -3, 4}) == 5);
  CHECK_BOTH(distance_to_triangle(P3{0, 0, 0}, P3{4, 0, 0}, P3{0, 4, 0}, P3{-3, -4, 0}) == 5);
  CHECK_BOTH(distance_of_lines(P3{0, 0, 0}, P3{1, 0, 0}, P3{3, 1, 2}, P3{3, 2, 2}) == 2);
  CHECK_BOTH(distance_of_lines(P3{0, 0, 0}, P3{1, 0, 0}, P3{3, 3, 4}, P3{4, 3, 4}) == 5);
  CHECK_BOTH(distance_of_lines(P3{0, 0, 0}, P3{2, 2, 2}, P3{2, 0, 0}, P3{0, 2, 2}) == 0);
  CHECK_BOTH(distance_of_segments(P3{0, 0, 0}, P3{1, 0, 0}, P3{3, 1, 2}, P3{3, 2, 2}) == 3);
  CHECK_BOTH(distance_of_segments(P2{0, 0}, P2{2, 2}, P2{0, 2}, P2{2, 0}) == 0);
  CHECK_BOTH(distance_of_segments(P2{0, 0}, P2{2, 0}, P2{5, 4}, P2{5, 9}) == 5);
  CHECK_BOTH(distance_to_box(box<double, 2>{{0, 0}, {1, 1}}, P2{4, 5}) == 5);
  CHECK_BOTH(distance_to_box(box<double, 2>{{0, 0}, {1, 1}}, P2{0.5, 0.7}) == 0);
}

TEST_CASE("distance: bad input and the ends of the range") {
  CHECK_BOTH(!distance(P2{1, not_a_number}, P2{4, 5}));
  CHECK_BOTH(!distance_to_line(P2{1, 1}, P2{1, 1}, P2{4, 5}));
  CHECK_BOTH(!signed_distance(line<double>{0, 0, 5}, P2{0, 0}));
  CHECK_BOTH(!signed_distance(plane<double>{0, 0, 0, 5}, P3{0, 0, 0}));
  CHECK_BOTH(!distance_to_segment(P2{1, 1}, P2{1, 1}, P2{4, not_a_number}));
  CHECK_BOTH(distance_to_segment(P2{1, 1}, P2{1, 1}, P2{4, 5}) == 5);
  CHECK_BOTH(!distance_of_lines(P3{0, 0, 0}, P3{0, 0, 0}, P3{3, 1, 2}, P3{3, 2, 2}));
  CHECK_BOTH(!distance_to_box(box<double, 2>{{0, 0}, {1, 1}}, P2{not_a_number, 5}));
  CHECK_BOTH(distance(P2{3e-324, 0}, P2{0, 3e-324}) == 5e-324);
  CHECK_BOTH(distance(P2{0, -huge / 2}, P2{0, huge / 2}) == huge);
  CHECK_BOTH(distance_to_line(P2{-huge, 1}, P2{huge, 1}, P2{0, 3}) == 2);
  CHECK_BOTH(signed_distance(plane<double>{5e-324, 0, 0, 0}, P3{7, 1, 1}) == 7);
  CHECK_BOTH(signed_distance(plane<double>{huge, 0, 0, huge}, P3{-1, huge, 1}) == 0);
  CHECK(distance(P2{-huge, -huge}, P2{huge, huge}) == std::numeric_limits<double>::infinity());
}

#ifdef IRG_HAVE_MPFR
namespace {

using E = test::exact;
using test::between;
using test::dot;
using test::exactly;
using test::nearest_on_segment;
using test::nearest_on_triangle;
using test::squared_distance_of_segments;
using test::operator-;

template <int N>
double run() {
  test::random r(41);
  double worst = 0;
  const auto add = [&](double got, const E& squared) {
    worst = std::fmax(worst, test::root_error_in_ulp(got, squared));
  };
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
      if (!finite) continue;
      const auto a = exactly(p[0]), b = exactly(p[1]), c = exactly(p[2]), d = exactly(p[3]);
      add(*distance(p[0], p[2]), dot(c - a, c - a));
      const auto on_segment = nearest_on_segment(a, b, c);
      add(*distance_to_segment(p[0], p[1], p[2]), dot(c - on_segment, c - on_segment));
      add(*distance_of_segments(p[0], p[1], p[2], p[3]), squared_distance_of_segments(a, b, c, d));
      if (!(p[0] == p[1])) {
        const auto foot = between(a, b, dot(c - a, b - a) / dot(b - a, b - a));
        add(*distance_to_line(p[0], p[1], p[2]), dot(c - foot, c - foot));
      }
      if constexpr (N == 3) {
        const auto on_triangle = nearest_on_triangle(a, b, c, d);
        add(*distance_to_triangle(p[0], p[1], p[2], p[3]), dot(d - on_triangle, d - on_triangle));
        const E n = dot(a, a), height = dot(a, b) + c[0];
        if (n.sign() != 0)
          add(std::fabs(*signed_distance(plane<double>{p[0].x, p[0].y, p[0].z, p[2].x}, p[1])), height * height / n);
      }
    }
  return worst;
}

}  // namespace

TEST_CASE("distance: half an ulp from the exact one, all magnitudes") {
  const double plane = run<2>(), space = run<3>();
  MESSAGE("worst ", plane, " and ", space, " ulp");
  CHECK(plane <= 0.501);
  CHECK(space <= 0.501);
}

TEST_CASE_TEMPLATE("distances: numbers of all sizes", T, double, float) {
  using namespace test::mixed;
  using test::mixed::squared_distance_of_segments;
  const auto off = [](const std::optional<T>& got, const quotient& squared) {
    if (got.has_value() == (squared.q.sign() == 0)) return wrong;
    return got ? root_error(*got, squared.p, squared.q) : 0.0;
  };
  const auto of_dimension = [&]<int N>(const char* where, std::integral_constant<int, N>) {
    sweep(
        named<T>("distance of points, to lines and segments") + where, 0.501,
        [&](test::random& r, sizes which) {
          const auto p = points<T, N, 3>(r, which);
          const auto a = exactly(p[0]), b = exactly(p[1]), c = exactly(p[2]);
          const double apart = off(distance(p[0], p[1]), {dot(b - a, b - a), E(1)});
          const double line = off(distance_to_line(p[0], p[1], p[2]), {gram(b - a, c - a), dot(b - a, b - a)});
          const double segment = off(distance_to_segment(p[0], p[1], p[2]), segment_foot(a, b, c).squared);
          return std::fmax(apart, std::fmax(line, segment));
        },
        1500);
    sweep(
        named<T>("distance_of_segments") + where, 0.501,
        [&](test::random& r, sizes which) {
          const auto p = points<T, N, 4>(r, which);
          return off(distance_of_segments(p[0], p[1], p[2], p[3]), squared_distance_of_segments(p));
        },
        1000);
  };
  of_dimension(" in the plane", std::integral_constant<int, 2>());
  of_dimension(" in space", std::integral_constant<int, 3>());
  sweep(
      named<T>("signed_distance"), 0.501,
      [&](test::random& r, sizes which) {
        const auto c = numbers<T, 7>(r, which);
        const auto e = rationals(c);
        const auto with_sign = [&](const std::optional<T>& got, const E& height, const E& squared) {
          if (got && sign_of(*got) != height.sign() && *got != 0) return wrong;
          return off(got ? std::optional(std::fabs(*got)) : got, {height * height, squared});
        };
        const double line = with_sign(signed_distance(irg::line<T>{c[0], c[1], c[2]}, point<T, 2>{c[3], c[4]}),
                                      e[0] * e[3] + e[1] * e[4] + e[2], e[0] * e[0] + e[1] * e[1]);
        const E height = e[0] * e[4] + e[1] * e[5] + e[2] * e[6] + e[3];
        return std::fmax(
            line, with_sign(signed_distance(irg::plane<T>{c[0], c[1], c[2], c[3]}, point<T, 3>{c[4], c[5], c[6]}),
                            height, e[0] * e[0] + e[1] * e[1] + e[2] * e[2]));
      },
      3000);
  sweep(
      named<T>("distance_to_triangle and distance_of_lines"), 0.501,
      [&](test::random& r, sizes which) {
        const auto p = points<T, 3, 4>(r, which);
        const auto a = exactly(p[0]), b = exactly(p[1]), c = exactly(p[2]), d = exactly(p[3]);
        const double triangle = off(distance_to_triangle(p[0], p[1], p[2], p[3]), triangle_nearest(a, b, c, d).squared);
        const lines_foot lines(a, b, c, d);
        const auto got = distance_of_lines(p[0], p[1], p[2], p[3]);
        if (p[0] == p[1] || p[2] == p[3]) return got ? wrong : triangle;
        const quotient parallel{gram(b - a, c - a), dot(b - a, b - a)};
        return std::fmax(triangle, off(got, lines.t.q.sign() == 0 ? parallel : lines.squared));
      },
      1000);
}
#endif
