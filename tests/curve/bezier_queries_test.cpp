// SPDX-License-Identifier: MIT
#include <irg/curve/bezier_queries.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <vector>

#include "support/big_rational.hpp"
#include "support/check_both.hpp"
#include "support/random.hpp"

namespace {

using P = irg::point<double, 2>;
using C = irg::vec<double, 1>;
using Z = irg::root_interval<double>;
constexpr double inf = std::numeric_limits<double>::infinity(), no_number = std::numeric_limits<double>::quiet_NaN();

constexpr std::array<P, 4> arch{P{0, 0}, P{0, 4}, P{4, 4}, P{4, 0}};

constexpr irg::box<double, 2> box_of_arch() {
  std::array<C, 32> scratch{};
  return irg::bezier_box(arch, scratch);
}
constexpr irg::nearest_place<P> nearest_to(const P& p) {
  std::array<C, 32> scratch{};
  std::array<P, 4> work{};
  return irg::bezier_nearest(arch, p, scratch, work);
}
constexpr int crossings_of(const P& a, const P& b) {
  std::array<C, 16> scratch{};
  int count = 0;
  const bool is_line =
      irg::bezier_line_intersections(arch, a, b, scratch, [&](const Z& z) { count += z.is_crossing(); });
  return is_line ? count : -1;
}

std::vector<Z> crossings(const std::vector<P>& curve, const P& a, const P& b) {
  std::vector<C> scratch(4 * curve.size());
  std::vector<Z> all;
  irg::bezier_line_intersections(curve, a, b, scratch, [&](const Z& z) { all.push_back(z); });
  return all;
}

/// Curves of degrees 0 to 12 with coincident points, on a line, or of all sizes.
std::vector<P> make_curve(test::random& r, bool mixed) {
  std::vector<P> c;
  const auto kind = r.integer(0, 4);
  for (auto k = r.integer(0, 12); k >= 0; --k) {
    double x = 2 * r.unit() - 1, y = 2 * r.unit() - 1;
    if (mixed) {
      x = std::ldexp(x, static_cast<int>(r.integer(-500, 500)));
      y = std::ldexp(y, static_cast<int>(r.integer(-500, 500)));
    }
    if (kind == 0 && !c.empty() && r.integer(0, 1) == 0) {
      x = c.back().x;
      y = c.back().y;
    }
    if (kind == 1) y = x;
    c.push_back({x, y});
  }
  return c;
}

}  // namespace

TEST_CASE("bezier_box, bezier_nearest, bezier_line_intersections: reference values") {
  constexpr auto box = box_of_arch();
  CHECK_BOTH(box.low == P{0, 0});
  CHECK_BOTH((box.high.x == 4 && box.high.y >= 3 && box.high.y < 3.0000000000001));
  CHECK_BOTH(nearest_to(P{-1, -1}) == irg::nearest_place<P>{0, P{0, 0}, irg::length(irg::vec<double, 2>{1, 1})});
  constexpr auto top = nearest_to(P{2, 9});
  CHECK(std::abs(top.t - 0.5) < 1e-7);
  CHECK(std::abs(top.distance - 6) < 1e-14);
  CHECK_BOTH(crossings_of({0, 1}, {1, 1}) == 2);
  CHECK_BOTH(crossings_of({0, 3.1}, {1, 3.1}) == 0);
  CHECK_BOTH(crossings_of({2, 0}, {2, 1}) == 1);
  CHECK_BOTH(crossings_of({2, 1}, {2, 1}) == -1);
  CHECK_BOTH(crossings_of({no_number, 1}, {2, 1}) == -1);
  CHECK_BOTH(crossings_of({inf, 1}, {no_number, 1}) == -1);
  const std::vector<P> straight{{0, 0}, {1, 1}, {3, 3}};
  CHECK(crossings(straight, P{-1, -1}, P{7, 7}) == std::vector<Z>{Z{0, 1, 0, 0}});
  const auto touching = crossings({{0, 0}, {1, 2}, {2, 0}}, P{0, 1}, P{5, 1});
  REQUIRE(touching.size() == 1);
  CHECK(!touching[0].is_crossing());
  CHECK(std::abs(touching[0].middle() - 0.5) < 1e-7);
}

TEST_CASE("bezier queries: a single point, coincident points, huge and not finite ones") {
  std::vector<C> scratch(64);
  std::vector<P> work(8);
  const std::vector<P> one{{3, 4}}, same(5, P{3, 4}), huge{{-1e308, 0}, {0, 1e308}, {1e308, 0}};
  CHECK(irg::bezier_box(one, scratch) == irg::box<double, 2>{{3, 4}, {3, 4}});
  CHECK(irg::bezier_nearest(one, P{0, 0}, scratch, std::span<P>(work)).distance == 5);
  CHECK(irg::bezier_nearest(same, P{0, 0}, scratch, std::span<P>(work)).distance == 5);
  CHECK(irg::bezier_nearest(same, P{3, 4}, scratch, std::span<P>(work)).distance == 0);
  const auto box = irg::bezier_box(huge, scratch);
  CHECK(box.low == P{-1e308, 0});
  CHECK(box.high.x == 1e308);
  CHECK(box.high.y >= 5e307);
  CHECK(box.high.y < 5.0000000001e307);
  CHECK(crossings(huge, P{0, -1e308}, P{0, 1e308}).size() == 1);
  std::vector<P> tiny;
  for (const P& p : arch) tiny.push_back({p.x * 1e-300, p.y * 1e-300});
  std::vector<P> four(4);
  CHECK(std::abs(irg::bezier_nearest(tiny, P{2e-300, 9e-300}, scratch, std::span<P>(four)).distance - 6e-300) < 1e-314);
  CHECK(crossings(tiny, P{0, 1e-300}, P{1e-300, 1e-300}).size() == 2);
  const std::vector<P> bad{{0, 0}, {no_number, inf}, {1, 1}};
  CHECK(irg::bezier_box(bad, scratch).high.x == (std::numeric_limits<double>::max)());
  CHECK(crossings(bad, P{0, 0}, P{1, 0}) == std::vector<Z>{Z{0, 1, 0, 0}});
}

TEST_CASE("bezier_nearest: a curve that is the point itself, in constant evaluation too") {
  constexpr auto distance_from_itself = [] {
    const std::array<P, 3> same{P{3, 4}, P{3, 4}, P{3, 4}};
    std::array<C, 24> scratch{};
    std::array<P, 3> work{};
    return irg::bezier_nearest(same, P{3, 4}, scratch, work).distance;
  };
  CHECK_BOTH(distance_from_itself() == 0);
}

TEST_CASE("bezier_line_intersections: the largest and the smallest numbers") {
  constexpr double most = std::numeric_limits<double>::max(), least = std::numeric_limits<double>::denorm_min();
  const auto found = crossings({{-most, -most}, {most, most}}, P{-most, most}, P{most, -most});
  REQUIRE(found.size() == 1);
  CHECK(found[0].is_crossing());
  CHECK(found[0].to - found[0].from < 1e-13);
  CHECK(crossings({{0, -1}, {0, 1}}, P{0, 0}, P{least, 0}).size() == 1);
}

TEST_CASE("bezier_nearest: distances beyond the largest number") {
  constexpr double most = std::numeric_limits<double>::max();
  const std::array<P, 2> line{P{-most, -most}, P{most, -most}};
  const auto place = [&](const P& p) {
    std::array<C, 16> scratch{};
    std::array<P, 2> work{};
    return irg::bezier_nearest(line, p, scratch, work).t;
  };
  CHECK(place({most, most}) >= 1 - 0x1p-24);
  CHECK(place({-most, most}) == 0);
  CHECK(std::abs(place({most / 2, most}) - 0.75) <= 0x1p-24);
}

// Curve and point moved together by what their coordinates bear without rounding: the same place, the same distance.
TEST_CASE("bezier_nearest: far from the origin as beside it") {
  test::random r(43);
  int other = 0;
  for (int round = 0; round < (std::getenv("IRG_RELEASE_TIER") ? 100'000 : 1'000); ++round) {
    const auto coordinate = [&] { return static_cast<double>(r.integer(-255, 255)) / 64; };
    std::vector<P> c(static_cast<std::size_t>(r.integer(1, 8)));
    for (P& p : c) p = {coordinate(), coordinate()};
    const P from{coordinate(), coordinate()};
    const std::array<P, 3> moves{P{0x1p45, -0x1p45}, {148376, -223423}, {std::ldexp(1.0, round % 46), 0}};
    const P move = moves[static_cast<std::size_t>(round % 3)];
    std::vector<P> far = c;
    for (P& p : far) p = {p.x + move.x, p.y + move.y};
    std::vector<C> scratch(8 * c.size());
    std::vector<P> work(c.size());
    const auto here = irg::bezier_nearest(c, from, scratch, std::span<P>(work));
    const auto there = irg::bezier_nearest(far, P{from.x + move.x, from.y + move.y}, scratch, std::span<P>(work));
    other += here.t != there.t || here.distance != there.distance ? 1 : 0;
  }
  CHECK(other == 0);
}

TEST_CASE("bezier_box and bezier_nearest: against a thousand points of each curve") {
  test::random r(41);
  long outside = 0, loose = 0, farther = 0, false_place = 0;
  for (int round = 0; round < (std::getenv("IRG_RELEASE_TIER") ? 30'000 : 200); ++round) {
    const bool mixed = round % 3 == 0;
    const auto c = make_curve(r, mixed);
    std::vector<C> scratch(8 * c.size());
    std::vector<P> work(c.size());
    const auto box = irg::bezier_box(c, scratch);
    const double x = 4 * r.unit() - 2, y = 4 * r.unit() - 2;
    const P from{x, y};
    const auto place = irg::bezier_nearest(c, from, scratch, std::span<P>(work));
    P low = c[0], high = c[0];
    double least = inf, size_x = 0, size_y = 0;
    for (const P& p : c) size_x = std::fmax(size_x, std::abs(p.x)), size_y = std::fmax(size_y, std::abs(p.y));
    constexpr int steps = 1000;
    for (int k = 0; k <= steps; ++k) {
      const P p = irg::bezier_point(c, k / double{steps}, std::span<P>(work));
      low = {std::fmin(low.x, p.x), std::fmin(low.y, p.y)};
      high = {std::fmax(high.x, p.x), std::fmax(high.y, p.y)};
      least = std::fmin(least, std::hypot(p.x - x, p.y - y));
      const double off_x = size_x * 0x1p-46, off_y = size_y * 0x1p-46;  // what bezier_point may be off
      outside += !(box.low.x <= p.x + off_x && p.x - off_x <= box.high.x);
      outside += !(box.low.y <= p.y + off_y && p.y - off_y <= box.high.y);
    }
    // Between two of the points a curve of degree n rises by n (n - 1) / 2 * 4 sizes / (2 * steps)^2 at most.
    const double n = static_cast<double>(c.size()), gap = 2 * n * n / (4.0 * steps * steps) + 0x1p-44;
    loose += box.high.x - high.x > gap * size_x || low.x - box.low.x > gap * size_x;
    loose += box.high.y - high.y > gap * size_y || low.y - box.low.y > gap * size_y;
    const double all = std::fmax(std::fmax(size_x, size_y), 2);
    const double got = place.distance / all, want = least / all;
    farther += !(mixed ? got * got <= want * want + 0x1p-41 : got <= want + 0x1p-46);
    false_place += !(place.point == irg::bezier_point(c, place.t, std::span<P>(work)));
    false_place += !(std::abs(std::hypot(place.point.x - x, place.point.y - y) - place.distance) <= all * 0x1p-50);
  }
  CHECK(outside == 0);
  CHECK(loose == 0);
  CHECK(farther == 0);
  CHECK(false_place == 0);
}

#ifdef IRG_HAVE_MPFR
namespace {

using test::big_rational;

/// The side of the line on which the curve is at t, by de Casteljau's algorithm in rationals.
int exact_side(const std::vector<P>& c, const P& a, const P& b, double t) {
  std::vector<big_rational> side;
  const big_rational at(t), rest = big_rational(1) - at;
  for (const P& p : c)
    side.push_back((big_rational(b.x) - big_rational(a.x)) * (big_rational(p.y) - big_rational(a.y)) -
                   (big_rational(b.y) - big_rational(a.y)) * (big_rational(p.x) - big_rational(a.x)));
  for (std::size_t n = side.size(); n > 1; --n)
    for (std::size_t i = 0; i + 1 < n; ++i) side[i] = side[i] * rest + side[i + 1] * at;
  return side[0].sign();
}

}  // namespace

TEST_CASE("bezier_line_intersections: no crossing is missed and every sign is right, in rationals") {
  test::random r(43);
  long found = 0, missed = 0, wrong = 0;
  for (int round = 0; round < (std::getenv("IRG_RELEASE_TIER") ? 10'000 : 150); ++round) {
    const auto c = make_curve(r, round % 2 == 0);
    const auto pick = [&] {
      return c[static_cast<std::size_t>(r.integer(0, static_cast<std::int64_t>(c.size()) - 1))];
    };
    const double x = r.unit(), y = r.unit();
    const P a = pick(), other = pick(), b = r.integer(0, 1) == 0 ? P{x, y} : other;
    if (a == b) continue;
    const auto all = crossings(c, a, b);
    for (const Z& z : all) {
      if (z.before != 0) wrong += exact_side(c, a, b, z.from) != z.before;
      if (z.behind != 0) wrong += exact_side(c, a, b, z.to) != z.behind;
      found += z.is_crossing();
    }
    int last = 0;
    double last_t = 0;
    for (int k = 0; k <= 64; ++k) {
      const double t = k / 64.0;
      const int side = exact_side(c, a, b, t);
      const auto holds = [&](double from, double to) {
        return std::any_of(all.begin(), all.end(), [&](const Z& z) { return z.from <= to && from <= z.to; });
      };
      if (side == 0) missed += !holds(t, t);
      if (side * last < 0) missed += !holds(last_t, t);
      if (side != 0) last = side, last_t = t;
    }
  }
  MESSAGE(found, " crossings");
  CHECK(found > 20);
  CHECK(missed == 0);
  CHECK(wrong == 0);
}
#endif
