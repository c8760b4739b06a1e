// SPDX-License-Identifier: MIT
#include <irg/geometry/intersect_segments.hpp>

#include <array>
#include <limits>

#include "geometry/mixed_cases.hpp"
#include "support/check_both.hpp"
#include "support/exact.hpp"
#include "support/rational.hpp"

using irg::intersect_segments;
using irg::point;
using irg::segment;
using irg::segment_relation;
using test::rational;

namespace {

using P2 = point<double, 2>;
using P3 = point<double, 3>;
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double huge = (std::numeric_limits<double>::max)();

template <class P>
constexpr bool meet(const P& a, const P& b, const P& c, const P& d, segment_relation relation, const P& first = {},
                    const P& last = {}) {
  const auto m = intersect_segments(a, b, c, d);
  return m.relation == relation && m.first == first && m.last == last;
}
constexpr auto none = segment_relation::none, touch = segment_relation::point, overlap = segment_relation::overlap;

}  // namespace

// Points of integers: the relation exactly, the place in doubles.
static_assert([] {
  using P = irg::point<int, 2>;
  const auto m = irg::intersect_segments(P{0, 0}, P{3, 3}, P{0, 1}, P{1, 0});
  return m.relation == irg::segment_relation::point && m.first == irg::point<double, 2>{0.5, 0.5};
}());
// Of 64 bits too: one unit beside the line, at the ends of the range.
static_assert([] {
  using P = irg::point<long long, 2>;
  using D = irg::point<double, 2>;
  constexpr long long most = (std::numeric_limits<long long>::max)(), least = -most - 1;
  constexpr P low{least, least}, high{most, most}, above{most - 2, most - 1};
  const auto on = irg::intersect_segments(low, high, {most - 1, most - 1}, P{most, least});
  const auto along = irg::intersect_segments(irg::segment{low, high}, irg::segment{P{0, 0}, high});
  return irg::intersect_segments(low, high, above, P{least, most}).relation == irg::segment_relation::none &&
         on.relation == irg::segment_relation::point && on.first == D{0x1p63, 0x1p63} &&
         along.relation == irg::segment_relation::overlap && along.first == D{0, 0} && along.last == D{0x1p63, 0x1p63};
}());

TEST_CASE("intersect_segments: by hand") {
  CHECK_BOTH(meet<P2>({0, 0}, {2, 2}, {0, 2}, {2, 0}, touch, {1, 1}, {1, 1}));
  CHECK_BOTH(intersect_segments(P2{0, 0}, {2, 2}, {0, 2}, {2, 0}).t == 0.5);
  CHECK_BOTH(meet<P2>({0, 0}, {2, 2}, {3, 0}, {0, 4}, touch, {12. / 7, 12. / 7}, {12. / 7, 12. / 7}));
  CHECK_BOTH(meet<P2>({0, 0}, {1, 1}, {3, 0}, {0, 4}, none));
  CHECK_BOTH(meet<P2>({0, 0}, {1, 1}, {1, 0}, {2, 1}, none));   // parallel
  CHECK_BOTH(meet<P2>({0, 0}, {1, 1}, {2, 2}, {3, 3}, none));   // one line, apart
  CHECK_BOTH(meet<P2>({0, 0}, {4, 4}, {3, 3}, {-1, -1}, overlap, {0, 0}, {3, 3}));
  CHECK_BOTH(meet<P2>({4, 4}, {0, 0}, {3, 3}, {-1, -1}, overlap, {3, 3}, {0, 0}));
  CHECK_BOTH(meet<P2>({0, 0}, {1, 1}, {1, 1}, {3, 3}, touch, {1, 1}, {1, 1}));
  CHECK_BOTH(meet<P2>({0, 0}, {0, 4}, {0, 9}, {0, 2}, overlap, {0, 2}, {0, 4}));
  CHECK_BOTH(meet<P3>({0, 0, 0}, {2, 2, 2}, {2, 0, 0}, {0, 2, 2}, touch, {1, 1, 1}, {1, 1, 1}));
  CHECK_BOTH(meet<P3>({0, 0, 0}, {1, 1, 1}, {3, 0, 3}, {0, 3, 3}, none));
  CHECK_BOTH(meet<P3>({0, 0, 0}, {0, 1, 1}, {0, 0, 1}, {0, 1, 0}, touch, {0, 0.5, 0.5}, {0, 0.5, 0.5}));
  CHECK_BOTH(meet<P3>({0, 0, 0}, {0, 0, 4}, {0, 0, 1}, {0, 0, 2}, overlap, {0, 0, 1}, {0, 0, 2}));
}

TEST_CASE("intersect_segments: points as segments") {
  CHECK_BOTH(meet<P2>({1, 1}, {1, 1}, {0, 0}, {2, 2}, touch, {1, 1}, {1, 1}));
  CHECK_BOTH(meet<P2>({1, 1}, {1, 1}, {0, 0}, {2, 3}, none));
  CHECK_BOTH(meet<P2>({3, 3}, {3, 3}, {0, 0}, {2, 2}, none));
  CHECK_BOTH(meet<P2>({0, 0}, {2, 2}, {1, 1}, {1, 1}, touch, {1, 1}, {1, 1}));
  CHECK_BOTH(meet<P3>({1, 2, 3}, {1, 2, 3}, {1, 2, 3}, {1, 2, 3}, touch, {1, 2, 3}, {1, 2, 3}));
  CHECK_BOTH(meet<P3>({1, 2, 3}, {1, 2, 3}, {1, 2, 4}, {1, 2, 4}, none));
}

TEST_CASE("intersect_segments: ends come back as they are") {
  constexpr P2 vertex{0.1, 0.7};
  CHECK_BOTH(meet<P2>(vertex, {0.3, 0.9}, {-4, 0.2}, vertex, touch, vertex, vertex));
  CHECK_BOTH(meet<P2>({-0.1, 0.3}, vertex, vertex, {1e300, 1e-300}, touch, vertex, vertex));
  // One end on the other's inside: (0.5, 0.5) is exactly on the diagonal.
  CHECK_BOTH(meet<P2>({0, 0}, {0.75, 0.75}, {0.5, 0.5}, {0.1, 0.9}, touch, {0.5, 0.5}, {0.5, 0.5}));
  // Beside it by the smallest number: no common point.
  CHECK_BOTH(meet<P2>({0, 0}, {0.75, 0.75}, {0.5, 0.5 + 0x1p-53}, {0.1, 0.9}, none));
  CHECK(meet<P2>({-huge, -huge}, {huge, huge}, {-huge, huge}, {huge, -huge}, touch, {0, 0}, {0, 0}));
}

TEST_CASE("intersect_segments: NaN and infinity") {
  CHECK_BOTH(meet<P2>({not_a_number, 0}, {2, 2}, {0, 2}, {2, 0}, none));
  CHECK_BOTH(meet<P2>({0, 0}, {2, 2}, {0, 2}, {std::numeric_limits<double>::infinity(), 0}, none));
  CHECK_BOTH(meet<P3>({0, 0, 0}, {0, 0, 0}, {0, 0, not_a_number}, {0, 0, 0}, none));
}

TEST_CASE("intersect_segments: all pairs of a 3 x 3 lattice against rationals' own arithmetic, and symmetry") {
  const auto at = [](int k) { return P2{static_cast<double>(k % 3), static_cast<double>(k / 3)}; };
  const auto rational_at = [](int k) { return point<rational, 2>{k % 3, k / 3}; };
  int wrong = 0;
  for (int code = 0; code < 9 * 9 * 9 * 9; ++code) {
    const int a = code % 9, b = code / 9 % 9, c = code / 81 % 9, d = code / 729;
    const auto m = intersect_segments(at(a), at(b), at(c), at(d)),
               mirrored = intersect_segments(at(c), at(d), at(b), at(a));
    const auto want = intersect_segments(rational_at(a), rational_at(b), rational_at(c), rational_at(d));
    wrong += m.relation != want.relation || m.relation != mirrored.relation;
    for (int k = 0; k < 2; ++k) wrong += m.first[k] != static_cast<double>(want.first[k]);
    if (m.relation == touch) wrong += !(m.first == mirrored.first);
    if (m.relation == overlap) {
      const bool same = m.first == mirrored.first && m.last == mirrored.last;
      wrong += !same && !(m.first == mirrored.last && m.last == mirrored.first);
    }
  }
  CHECK(wrong == 0);
}

#ifdef IRG_HAVE_MPFR
namespace {

using E = test::exact;
E cross(const std::array<E, 2>& o, const std::array<E, 2>& p, const std::array<E, 2>& q) {
  return (p[0] - o[0]) * (q[1] - o[1]) - (p[1] - o[1]) * (q[0] - o[0]);
}

}  // namespace

TEST_CASE("intersect_segments: touching or not against signs of areas, all magnitudes") {
  test::random r(11);
  int wrong = 0, points = 0;
  double worst = 0;
  for (const test::spread kind : test::all_spreads)
    for (int i = 0; i < test::trials(500); ++i) {
      P2 p[4];
      std::array<E, 2> e[4];
      for (int k = 0; k < 4; ++k) {
        p[k] = {test::any_coordinate<double>(r, kind), test::any_coordinate<double>(r, kind)};
        if (i % 3 == 0 && k == 2) p[k] = p[0];
        e[k] = {E(p[k].x), E(p[k].y)};
      }
      const auto got = intersect_segments(p[0], p[1], p[2], p[3]);
      const int turns[] = {cross(e[0], e[1], e[2]).sign(), cross(e[0], e[1], e[3]).sign(),
                           cross(e[2], e[3], e[0]).sign(), cross(e[2], e[3], e[1]).sign()};
      if (turns[0] == 0 && turns[1] == 0 && turns[2] == 0) continue;  // one line: by order alone
      const bool common = turns[0] * turns[1] <= 0 && turns[2] * turns[3] <= 0 && turns[0] != turns[1];
      wrong += common != (got.relation == segment_relation::point);
      if (!common || got.relation != segment_relation::point) continue;
      ++points;
      const E n = cross(e[0], e[1], e[3]) - cross(e[0], e[1], e[2]);
      const E s = (E(0) - cross(e[0], e[1], e[2])) / n;
      worst = std::fmax(worst, test::error_in_ulp(got.s, s));
      for (std::size_t k = 0; k < 2; ++k)
        worst = std::fmax(worst, test::error_in_ulp(got.first[static_cast<int>(k)], e[2][k] + s * (e[3][k] - e[2][k])));
    }
  MESSAGE(points, " points, worst ", worst, " ulp");
  CHECK(wrong == 0);
  CHECK(worst <= 0.501);
  CHECK(points > 500);
}

TEST_CASE_TEMPLATE("intersect_segments: numbers of all sizes", T, double, float) {
  using namespace test::mixed;
  sweep(
      named<T>("intersect_segments"), 0.501,
      [](test::random& r, sizes which) {
        const auto p = points<T, 2, 4>(r, which);
        const auto got = intersect_segments(p[0], p[1], p[2], p[3]);
        const auto area = [&](std::size_t i, std::size_t j, std::size_t k) { return twice_area(p[i], p[j], p[k]); };
        const E c = area(0, 1, 2), d = area(0, 1, 3), a = area(2, 3, 0), b = area(2, 3, 1);
        if (c == d) return 0.0;  // parallel
        const bool meet = c.sign() * d.sign() <= 0 && a.sign() * b.sign() <= 0;
        if (meet != (got.relation == irg::segment_relation::point)) return wrong;
        if (!meet) return 0.0;
        const quotient t{a, a - b}, s{c, c - d};
        const double parameters = std::fmax(quotient_error(got.t, t.p, t.q), quotient_error(got.s, s.p, s.q));
        return std::fmax(parameters, off_between(got.first, p[0], p[1], t));
      },
      3000);
}
#endif
