// SPDX-License-Identifier: MIT
#include <irg/geometry/clip_line_cyrus_beck.hpp>

#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include <irg/geometry/clip_line_liang_barsky.hpp>

#include "geometry/mixed_cases.hpp"
#include "line_clip_cases.hpp"
#include "support/check_both.hpp"
#include "support/rational.hpp"

using irg::clip_line_cyrus_beck;
using irg::plane;
using irg::point;
using P = point<double, 2>;
using S = point<double, 3>;

namespace {

constexpr std::array<P, 4> kite{P{2, 0}, P{4, 2}, P{2, 5}, P{0, 2}};
constexpr bool gives(P a, P b, P first, P second) {
  const auto kept = clip_line_cyrus_beck(a, b, kite);
  return kept && kept->first == first && kept->second == second;
}

constexpr std::array<plane<double>, 4> corner{plane<double>{1, 0, 0, 0}, plane<double>{0, 1, 0, 0},
                                              plane<double>{0, 0, 1, 0}, plane<double>{-1, -1, -1, 3}};

}  // namespace

TEST_CASE("clip_line_cyrus_beck: by hand, in every life") {
  CHECK_BOTH(gives({2, 1}, {2, 3}, {2, 1}, {2, 3}));
  CHECK_BOTH(gives({-1, 2}, {5, 2}, {0, 2}, {4, 2}));
  CHECK_BOTH(gives({1, 0}, {1, 6}, {1, 1}, {1, 3.5}));
  CHECK_BOTH(gives({0, 0}, {4, 0}, {2, 0}, {2, 0}));                             // touches a corner
  CHECK_BOTH(gives({3, 1}, {5, 3}, {3, 1}, {4, 2}));                             // along an edge
  CHECK_BOTH(!clip_line_cyrus_beck(P{0, -0x1p-60}, P{4, -0x1p-1074}, kite));     // misses it by the least double
  CHECK_BOTH(!clip_line_cyrus_beck(P{0, 0}, P{1, 0.5}, kite));
  CHECK_BOTH(clip_line_cyrus_beck(P{1, 0}, P{1, 6}, kite)->t_first == 1.0 / 6);
  CHECK_BOTH(clip_line_cyrus_beck(P{1, 6}, P{1, 0}, kite)->first == P{1, 3.5});
  constexpr std::array<P, 5> clockwise{P{0, 2}, P{2, 5}, P{4, 2}, P{3, 1}, P{2, 0}};
  CHECK_BOTH(clip_line_cyrus_beck(P{1, 0}, P{1, 6}, clockwise)->first == P{1, 1});
  // A tetrahedron.
  CHECK_BOTH(clip_line_cyrus_beck(S{-1, 0.5, 0.5}, S{5, 0.5, 0.5}, corner)->first == S{0, 0.5, 0.5});
  CHECK_BOTH(clip_line_cyrus_beck(S{-1, 0.5, 0.5}, S{5, 0.5, 0.5}, corner)->second == S{2, 0.5, 0.5});
  CHECK_BOTH(!clip_line_cyrus_beck(S{-1, 2, 2}, S{5, 2, 2}, corner));
  CHECK_BOTH(clip_line_cyrus_beck(S{3, -1, 0}, S{3, 1, 0}, corner)->first == S{3, 0, 0});
  CHECK_BOTH(clip_line_cyrus_beck(S{1, 2, 3}, S{5, 2, 2}, {})->first == S{1, 2, 3});
  volatile double one = 1;
  CHECK(gives({one, 0}, {1, 6}, {1, 1}, {1, 3.5}));
}

TEST_CASE("clip_line_cyrus_beck: degenerate and hostile input") {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  for (const double bad : {nan, inf, -inf}) {
    CHECK(!clip_line_cyrus_beck(P{bad, 1}, P{2, 2}, kite));
    CHECK(!clip_line_cyrus_beck(P{2, 1}, P{2, bad}, kite));
    CHECK(!clip_line_cyrus_beck(P{2, 1}, P{2, 2}, std::array<P, 3>{P{0, 0}, P{9, 0}, P{bad, 9}}));
    CHECK(!clip_line_cyrus_beck(S{1, bad, 1}, S{2, 2, 2}, corner));
    CHECK(!clip_line_cyrus_beck(S{1, 1, 1}, S{2, 2, 2}, std::array{plane<double>{1, 0, 0, bad}}));
  }
  const std::vector<P> none, spot(4, P{1, 1}), bar{P{0, 0}, P{1, 1}, P{2, 2}};
  for (const auto& ring : {none, spot, bar}) CHECK(!clip_line_cyrus_beck(P{1, 0}, P{1, 6}, ring));
  const double most = std::numeric_limits<double>::max(), least = std::numeric_limits<double>::denorm_min();
  const auto far = clip_line_cyrus_beck(P{-most, 2}, P{most, 2}, kite);
  CHECK((far && far->first == P{0, 2} && far->second == P{4, 2}));
  const std::array<P, 3> dust{P{0, 0}, P{4 * least, 0}, P{0, 4 * least}};
  const auto in_dust = clip_line_cyrus_beck(P{-1, least}, P{1, least}, dust);
  CHECK((in_dust && in_dust->first == P{0, least} && in_dust->second == P{3 * least, least}));
  // Huge: the ends of the numbers' range make no difference.
  const std::array<P, 3> huge{P{-most, -most}, P{most, -most}, P{0, most}};
  const auto across = clip_line_cyrus_beck(P{-most, 0}, P{most, 0}, huge);
  CHECK((across && across->first == P{-most / 2, 0} && across->second == P{most / 2, 0}));
}

TEST_CASE("clip_line_cyrus_beck: on windows what Liang and Barsky's gives, nearly to the last bit") {
  test::random r(31);
  int wrong = 0, visible = 0;
  for (int k = 0; k < line_cases::release_or(4000); ++k) {
    const auto c = line_cases::draw_case<double>(r);
    const auto& w = c.window;
    if (w.low.x == w.high.x || w.low.y == w.high.y) continue;
    const std::array<P, 4> ring{w.low, P{w.high.x, w.low.y}, w.high, P{w.low.x, w.high.y}};
    const auto kept = clip_line_cyrus_beck(c.a, c.b, ring);
    const auto oracle = clip_line_liang_barsky(c.a, c.b, w);
    wrong += kept.has_value() == oracle.has_value() ? 0 : 1;
    if (!kept || !oracle) continue;
    ++visible;
    for (int i = 0; i < 2; ++i) {
      const auto near = [](double x, double y) { return x == y || std::nextafter(x, y) == y; };
      wrong += near(kept->first[i], oracle->first[i]) && near(kept->second[i], oracle->second[i]) ? 0 : 1;
    }
    const auto back = clip_line_cyrus_beck(c.b, c.a, ring);
    wrong += back && back->first == kept->second && back->second == kept->first ? 0 : 1;
  }
  CHECK(wrong == 0);
  CHECK(visible > 1000);
}

TEST_CASE("clip_line_cyrus_beck: decisions and points in rationals, on lattices where lines touch") {
  using test::rational;
  test::random r(32);
  int wrong = 0, visible = 0, touching = 0;
  const std::array<P, 6> ring{P{3, 0}, P{6, 1}, P{8, 4}, P{6, 8}, P{2, 7}, P{0, 4}};
  std::vector<point<rational, 2>> exact_ring;
  for (const P& p : ring) exact_ring.push_back({static_cast<std::int64_t>(p.x), static_cast<std::int64_t>(p.y)});
  for (int k = 0; k < line_cases::release_or(4000); ++k) {
    const auto c = [&] { return r.integer(-4, 12); };
    const std::int64_t ax = c(), ay = c(), bx = c(), by = c();
    const auto d = [](std::int64_t x) { return static_cast<double>(x); };
    const auto kept = clip_line_cyrus_beck(P{d(ax), d(ay)}, P{d(bx), d(by)}, ring);
    const auto exact = clip_line_cyrus_beck(point<rational, 2>{ax, ay}, point<rational, 2>{bx, by}, exact_ring);
    // Liang and Barsky's way with signed areas, by hand.
    rational low = 0, high = 1;
    bool visible_by_hand = true;
    for (std::size_t i = 0; i < 6; ++i) {
      const auto p = exact_ring[i], q = exact_ring[(i + 1) % 6];
      const auto area = [&](rational x, rational y) { return (q.x - p.x) * (y - p.y) - (q.y - p.y) * (x - p.x); };
      const rational from = area(ax, ay), to = area(bx, by);
      if (from < 0 && to < 0) visible_by_hand = false;
      if (from < 0 && !(to < 0)) low = std::max(low, from / (from - to));
      if (to < 0 && !(from < 0)) high = std::min(high, from / (from - to));
    }
    visible_by_hand = visible_by_hand && !(high < low);
    wrong += kept.has_value() == visible_by_hand && exact.has_value() == visible_by_hand ? 0 : 1;
    if (!kept || !exact) continue;
    ++visible;
    touching += exact->t_first == exact->t_second ? 1 : 0;
    wrong += exact->t_first == low && exact->t_second == high ? 0 : 1;
    const auto near = [](double x, const rational& y) { return std::abs(x - static_cast<double>(y)) <= 0x1p-50; };
    wrong += near(kept->first.x, exact->first.x) && near(kept->first.y, exact->first.y) ? 0 : 1;
    wrong += near(kept->second.x, exact->second.x) && near(kept->second.y, exact->second.y) ? 0 : 1;
  }
  CHECK(wrong == 0);
  CHECK(visible > 1500);
  CHECK(touching > 50);
}

#ifdef IRG_HAVE_MPFR

TEST_CASE_TEMPLATE("clip_line_cyrus_beck: numbers of all sizes", T, double, float) {
  using namespace test::mixed;
  sweep(
      named<T>("clip_line_cyrus_beck"), 0.501,
      [](test::random& r, sizes which) {
        const auto p = points<T, 2, 5>(r, which);
        const std::array<point<T, 2>, 3> region{p[2], p[3], p[4]};
        const auto got = clip_line_cyrus_beck(p[0], p[1], region);
        const int turn = twice_area(p[2], p[3], p[4]).sign();
        quotient low{E(0), E(1)}, high{E(1), E(1)};
        bool visible = turn != 0;
        for (std::size_t i = 0; i < 3; ++i) {
          const auto &from = region[i], &to = region[(i + 1) % 3];
          const E at_a = twice_area(from, to, p[0]) * turn, at_b = twice_area(from, to, p[1]) * turn;
          if (at_a.sign() < 0 && at_b.sign() < 0) visible = false;
          if (at_a.sign() < 0 && at_b.sign() >= 0) low = std::max(low, quotient{-at_a, at_b - at_a});
          if (at_a.sign() >= 0 && at_b.sign() < 0) high = std::min(high, quotient{at_a, at_a - at_b});
        }
        visible = visible && !(high < low);
        if (visible != got.has_value()) return wrong;
        if (!got) return 0.0;
        const double first =
            std::fmax(quotient_error(got->t_first, low.p, low.q), off_between(got->first, p[0], p[1], low));
        const double second =
            std::fmax(quotient_error(got->t_second, high.p, high.q), off_between(got->second, p[0], p[1], high));
        return std::fmax(first, second);
      },
      2000);
}

#endif
