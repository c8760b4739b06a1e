// SPDX-License-Identifier: MIT
#include <irg/geometry/clip_sutherland_hodgman.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <vector>

#include "line_clip_cases.hpp"
#include "support/archetypes.hpp"
#include "support/check_both.hpp"
#include "support/random.hpp"
#include "support/rational.hpp"

using irg::attributed_point;
using irg::box;
using irg::clip_sutherland_hodgman;
using irg::plane;
using irg::point;
using test::rational;
using P = point<double, 2>;
using R = point<rational, 2>;
using Polygon = std::vector<P>;

namespace {

// The same ring, wherever it starts.
template <class V>
constexpr bool same_cycle(const std::vector<V>& a, const std::vector<V>& b) {
  if (a.size() != b.size()) return false;
  for (std::size_t shift = 0; shift < a.size(); ++shift) {
    bool same = true;
    for (std::size_t i = 0; i < a.size(); ++i) same = same && a[i] == b[(i + shift) % b.size()];
    if (same) return true;
  }
  return a.empty();
}

template <class V>
auto twice_area(const std::vector<V>& ring) {
  auto sum = ring.empty() ? decltype(ring[0].x)(0) : decltype(ring[0].x)(0);
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const V &p = ring[i], &q = ring[(i + 1) % ring.size()];
    sum = sum + (p.x * q.y - p.y * q.x);
  }
  return sum;
}

// How often the ring goes round a place that is on no edge, by counting edges above it.
template <class V, class T>
int winding(const std::vector<V>& ring, T x, T y) {
  int turns = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const V &p = ring[i], &q = ring[(i + 1) % ring.size()];
    if ((p.x < x) == (q.x < x)) continue;
    const T side = (q.x - p.x) * (y - p.y) - (q.y - p.y) * (x - p.x);
    if (p.x < q.x ? side < T(0) : T(0) < side) turns += p.x < q.x ? -1 : 1;
  }
  return turns;
}

Polygon star(test::random& r, int n, double size) {
  Polygon ring;
  for (int i = 0; i < n; ++i) {
    const double angle = 6.283185307179586 * i / n, radius = size * (0.2 + 0.8 * r.unit());
    ring.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  return ring;
}

constexpr std::array<P, 3> tip{P{-1, 1}, P{5, 1}, P{2, 5}};
constexpr box<double, 2> window{{0, 0}, {4, 3}};

constexpr bool clips_tip() {
  const std::vector<P> expected{{0, 1}, {4, 1}, {4, 7.0 / 3}, {3.5, 3}, {0.5, 3}, {0, 7.0 / 3}};
  return same_cycle(clip_sutherland_hodgman(tip, window), expected);
}
constexpr std::size_t size_of_clipped(std::array<P, 3> t) { return clip_sutherland_hodgman(t, window).size(); }

using K = attributed_point<double, 2, 1>;
std::vector<K> with_attributes(const Polygon& ring) {
  std::vector<K> all;
  for (const P& p : ring) all.push_back({p, {static_cast<double>(all.size())}});
  return all;
}
Polygon places_of(const std::vector<K>& all) {
  Polygon ring;
  for (const K& k : all) ring.push_back(k.position);
  return ring;
}

}  // namespace

TEST_CASE("clip_sutherland_hodgman: by hand, in every life") {
  CHECK_BOTH(clips_tip());
  CHECK_BOTH(size_of_clipped({P{1, 1}, P{2, 1}, P{2, 2}}) == 3);
  CHECK_BOTH(size_of_clipped({P{5, 1}, P{6, 1}, P{5, 2}}) == 0);
  CHECK_BOTH(size_of_clipped({P{4, 1}, P{5, 1}, P{4, 2}}) == 0);  // touches along an edge
  CHECK_BOTH(size_of_clipped({P{-9, -9}, P{50, 1}, P{1, 50}}) == 4);
  volatile double one = 1;
  const std::array<P, 3> again{P{-1, one}, P{5, 1}, P{2, 5}};
  CHECK(clip_sutherland_hodgman(again, window) == clip_sutherland_hodgman(tip, window));
  // The first vertex stays first, the order is kept.
  CHECK(clip_sutherland_hodgman(std::array<P, 3>{P{1, 1}, P{6, 1}, P{1, 2}}, window) ==
        Polygon{{1, 1}, {4, 1}, {4, 1.4}, {1, 2}});
}

TEST_CASE("clip_sutherland_hodgman: Hank's values, window and area") {
  const box<rational, 2> w{{0, 0}, {4, 3}};
  const auto clipped = clip_sutherland_hodgman(std::array<R, 3>{R{-1, 1}, R{5, 1}, R{2, 5}}, w);
  CHECK(same_cycle(clipped, {R{rational(7, 2), 3}, R{rational(1, 2), 3}, R{0, rational(7, 3)}, R{0, 1}, R{4, 1},
                             R{4, rational(7, 3)}}));
  CHECK(twice_area(clipped) == rational(46, 3));
  CHECK(clip_sutherland_hodgman(std::array<R, 3>{R{1, 1}, R{2, 1}, R{2, 2}}, w).size() == 3);
  CHECK(clip_sutherland_hodgman(std::array<R, 3>{R{5, 1}, R{6, 1}, R{5, 2}}, w).empty());
  const auto covered = clip_sutherland_hodgman(std::array<R, 4>{R{-1, -1}, R{5, -1}, R{5, 4}, R{-1, 4}}, w);
  CHECK(same_cycle(covered, {R{4, 3}, R{0, 3}, R{0, 0}, R{4, 0}}));
  // The same by the window's four lines.
  const std::array<R, 4> ring{R{0, 0}, R{4, 0}, R{4, 3}, R{0, 3}};
  CHECK(same_cycle(clip_sutherland_hodgman(std::array<R, 3>{R{-1, 1}, R{5, 1}, R{2, 5}}, ring), clipped));
}

TEST_CASE("clip_sutherland_hodgman: Hank's values, the view pyramid") {
  // 1 <= z <= 10, |x| <= 2z, |y| <= 3z/2, inward normals; near, far, left, right, top, bottom.
  using S = point<rational, 3>;
  using L = plane<rational>;
  const std::vector<L> pyramid{{0, 0, 1, -1}, {0, 0, -1, 10}, {1, 0, 2, 0}, {-1, 0, 2, 0}, {0, -2, 3, 0}, {0, 2, 3, 0}};
  const std::array<S, 3> t{S{0, 0, -1}, S{0, 0, 5}, S{20, 0, 5}};
  CHECK(same_cycle(clip_sutherland_hodgman(t, pyramid), {S{0, 0, 5}, S{10, 0, 5}, S{2, 0, 1}, S{0, 0, 1}}));
  CHECK(clip_sutherland_hodgman(std::array<S, 3>{S{0, 0, 0}, S{1, 0, 0}, S{0, 1, 0}}, pyramid).empty());
  CHECK(clip_sutherland_hodgman(t, std::vector<L>{}).size() == 3);
}

TEST_CASE("clip_sutherland_hodgman: all 27 combinations of inside, on and outside, for each boundary") {
  for (int side = 0; side < 4; ++side)
    for (int combination = 0; combination < 27; ++combination) {
      const int state[3] = {combination % 3 - 1, combination / 3 % 3 - 1, combination / 9 - 1};
      const double across[3] = {1, 2, 1.75};
      std::array<P, 3> t;
      std::array<point<double, 3>, 3> u;
      int inside = 0, outside = 0;
      for (std::size_t i = 0; i < 3; ++i) {
        const double d = state[i];
        t[i] = side == 0   ? P{d, across[i]}
               : side == 1 ? P{4 - d, across[i]}
               : side == 2 ? P{across[i], d}
                           : P{across[i], 3 - d};
        if (side == 0 && i == 2) t[i].x += state[i] * 0.5;
        inside += state[i] > 0, outside += state[i] < 0;
        u[i] = {t[i].x, t[i].y, 0};
      }
      const auto kept = clip_sutherland_hodgman(t, window);
      const std::size_t expected = outside == 0 ? 3 : inside == 0 ? 0 : inside == 2 ? 4 : 3;
      CHECK(kept.size() == expected);
      CHECK(places_of(clip_sutherland_hodgman(with_attributes({t.begin(), t.end()}), window)) == kept);
      const std::array<P, 4> ring{P{0, 0}, P{4, 0}, P{4, 3}, P{0, 3}};
      CHECK(clip_sutherland_hodgman(t, ring) == kept);
      const std::vector<plane<double>> planes{{1, 0, 0, 0}, {-1, 0, 0, 4}, {0, 1, 0, 0}, {0, -1, 0, 3}};
      CHECK(clip_sutherland_hodgman(u, planes).size() == expected);
    }
}

TEST_CASE("clip_sutherland_hodgman: windows: samples, idempotence, walk and pipe alike") {
  test::random r(1);
  int kept_any = 0, wrong = 0;
  for (int k = 0; k < line_cases::release_or(3000); ++k) {
    const Polygon ring = star(r, static_cast<int>(r.integer(3, 30)), 3);
    box<double, 2> w;
    for (int i = 0; i < 2; ++i) w = irg::bounding_box(w, P{r.unit() * 5 - 2.5, r.unit() * 5 - 2.5});
    const Polygon kept = clip_sutherland_hodgman(ring, w);
    wrong += places_of(clip_sutherland_hodgman(with_attributes(ring), w)) == kept ? 0 : 1;
    kept_any += kept.empty() ? 0 : 1;
    for (const P& p : kept) wrong += irg::contains(w, p) ? 0 : 1;
    for (std::size_t i = 0; i < kept.size(); ++i) wrong += kept[i] == kept[(i + 1) % kept.size()] ? 1 : 0;
    wrong += kept.empty() || clip_sutherland_hodgman(kept, w) == kept ? 0 : 1;
    for (int s = 0; s < 10; ++s) {
      const double x = r.unit() * 6 - 3, y = r.unit() * 6 - 3;
      const bool expected = winding(ring, x, y) != 0 && irg::contains(w, P{x, y});
      wrong += (winding(kept, x, y) != 0) == expected ? 0 : 1;
    }
  }
  CHECK(wrong == 0);
  CHECK(kept_any > 1000);
}

namespace {

// The same polygon with attributes goes another way: through the pipe.
template <class T>
bool as_by_pipe(const std::vector<point<T, 2>>& ring, const box<T, 2>& w) {
  std::vector<attributed_point<T, 2, 1>> carrying;
  for (const auto& p : ring) carrying.push_back({p, {0}});
  const auto expected = clip_sutherland_hodgman(carrying, w);
  const auto kept = clip_sutherland_hodgman(ring, w);
  bool same = kept.size() == expected.size();
  for (std::size_t i = 0; same && i < kept.size(); ++i)
    same = std::memcmp(&kept[i], &expected[i].position, sizeof kept[i]) == 0;
  // Memory that is just enough, too.
  std::vector<point<T, 2>> exactly(kept.size() + 1, point<T, 2>{77, 77});
  const std::size_t count = clip_sutherland_hodgman(ring, w, std::span(exactly).first(kept.size()));
  return same && (kept.empty() || count >= kept.size()) && exactly.back() == point<T, 2>{77, 77} &&
         std::equal(kept.begin(), kept.end(), exactly.begin());
}

template <class T>
std::vector<point<T, 2>> rotated(std::vector<point<T, 2>> ring, std::size_t by) {
  std::rotate(ring.begin(), ring.begin() + static_cast<std::ptrdiff_t>(by), ring.end());
  return ring;
}

template <class T>
int wrong_by_walk(test::random& r, int rounds) {
  int wrong = 0;
  for (int k = 0; k < rounds; ++k) {
    const auto kind = r.integer(0, 4);
    const auto number = [&]() -> T {
      if (kind == 0) return static_cast<T>(r.integer(-4, 4));
      if (kind == 1) return static_cast<T>(static_cast<double>(r.integer(-8, 8)) / 2);
      if (kind == 2) return static_cast<T>(r.unit() * 8e3 + 5e5);
      return static_cast<T>(r.unit() * 8 - 4);
    };
    const std::int64_t lengths[] = {r.integer(3, 8), r.integer(3, 8), r.integer(3, 66), r.integer(14, 18)};
    std::vector<point<T, 2>> ring(static_cast<std::size_t>(lengths[r.integer(0, 3)]), point<T, 2>{});
    for (auto& p : ring) p = {number(), number()};
    const std::size_t n = ring.size();
    if (r.integer(0, 7) == 0)  // there and back again
      for (std::size_t i = n / 2; i < n; ++i) ring[i] = ring[n - 1 - i];
    if (r.integer(0, 7) == 0)  // places twice
      for (std::size_t i = 1; i < n; ++i)
        if (r.integer(0, 1) != 0) ring[i] = ring[i - 1];
    box<T, 2> w{{number(), number()}, {number(), number()}};
    for (int i = 0; i < 2; ++i)
      if (w.high[i] < w.low[i]) std::swap(w.low[i], w.high[i]);
    if (r.integer(0, 19) == 0) w.high.x = std::numeric_limits<T>::infinity();
    if (r.integer(0, 19) == 0) w.low.y = -std::numeric_limits<T>::infinity();
    if (r.integer(0, 9) == 0) w.low.y = -T(0), w.high.y = w.low.y < w.high.y ? w.high.y : T(1);
    wrong += as_by_pipe(ring, w) ? 0 : 1;
  }
  return wrong;
}

}  // namespace

TEST_CASE("clip_sutherland_hodgman: windows: the walk and the pipe alike, bit for bit") {
  test::random r(7);
  CHECK(wrong_by_walk<double>(r, line_cases::release_or(15000)) == 0);
  CHECK(wrong_by_walk<float>(r, line_cases::release_or(15000)) == 0);
}

TEST_CASE("clip_sutherland_hodgman: windows: lengths about those of words, wherever the ring starts") {
  const box<double, 2> w{{-1.1, -1.3}, {1.7, 0.9}};
  test::random r(8);
  int wrong = 0, walked = 0;
  for (const std::size_t n : {3u, 4u, 5u, 15u, 16u, 17u, 31u, 32u, 33u, 47u, 48u, 49u, 63u, 64u, 65u, 66u}) {
    Polygon zigzag, crown, wave;  // every edge passes one boundary, or both; every other one, near a corner
    for (std::size_t i = 0; i < n; ++i) {
      const double t = 0.02 * static_cast<double>(i);
      zigzag.push_back({t - 0.5, i % 2 == 0 ? 0.3 : 1.3 + t});
      crown.push_back({t - 0.5, i % 2 == 0 ? -2.1 : 1.3 + t});
      wave.push_back({i / 2 % 2 == 0 ? 1.5 + t / 9 : 1.9, i % 2 == 0 ? 0.8 - t / 8 : 1.1});
    }
    const Polygon round = star(r, static_cast<int>(n), 2.2);
    for (const Polygon& ring : {zigzag, crown, wave, round})
      for (std::size_t by = 0; by < n; ++by) {
        const Polygon given = rotated(ring, by);
        wrong += as_by_pipe(given, w) ? 0 : 1;
        Polygon turned;
        for (const P& p : given) turned.push_back({p.y, p.x});
        wrong += as_by_pipe(turned, w) ? 0 : 1;
        std::vector<P> out(400);
        if (n <= 64) walked += irg::detail::clip_few(std::span<const P>(given), w, std::span(out)) >= 0 ? 1 : 0;
      }
  }
  CHECK(wrong == 0);
  CHECK(walked > 1500);
}

TEST_CASE("clip_sutherland_hodgman: windows: most jagged polygons are not left to the pipe") {
  const box<double, 2> w{{-1.1, -1.3}, {1.7, 0.9}};
  test::random r(9);
  int walked = 0, all = 0;
  for (int k = 0; k < 2000; ++k) {
    Polygon ring = star(r, static_cast<int>(r.integer(3, 64)), 1 + 4 * r.unit());
    const double x = r.unit() * 4 - 2, y = r.unit() * 4 - 2;
    for (P& p : ring) p.x += x, p.y += y;
    std::vector<P> out(400);
    walked += irg::detail::clip_few(std::span<const P>(ring), w, std::span(out)) >= 0 ? 1 : 0;
    ++all;
  }
  CHECK(walked > all * 17 / 20);  // jagged ones may come to the same corner twice
}

namespace {

constexpr std::uint64_t hash_of_clipped(const std::array<P, 5>& ring, const box<double, 2>& w) {
  std::array<P, 24> out{};
  const std::size_t n = clip_sutherland_hodgman(ring, w, out);
  std::uint64_t hash = n;
  for (std::size_t i = 0; i < n; ++i)
    for (const double x : {out[i].x, out[i].y}) hash = hash * 0x9e3779b97f4a7c15u + std::bit_cast<std::uint64_t>(x);
  return hash;
}
constexpr std::array<P, 5> covering{P{-9, -8}, P{7, -9}, P{9.5, 1.25}, P{8, 9}, P{-9, 7}};
constexpr std::array<P, 5> passing{P{-9, 1}, P{7, 0.75}, P{9.5, 2}, P{2, 2.5}, P{1, 1.5}};
constexpr std::array<P, 5> at_corner{P{3, 2}, P{5, 2.25}, P{4.75, 4}, P{3.5, 5}, P{3.25, 2.5}};
constexpr std::array<P, 5> on_boundary{P{4, 1}, P{5, 2}, P{4, 3}, P{2, 4}, P{1, 1}};
constexpr double infinite = std::numeric_limits<double>::infinity();

}  // namespace

TEST_CASE("clip_sutherland_hodgman: windows: constant evaluation has the bits of run time") {
  std::array<P, 5> given[] = {covering, passing, at_corner, on_boundary};
  for (auto& ring : given)
    for (P& p : ring) asm volatile("" : "+m"(p));
  constexpr box<double, 2> open{{0, -infinite}, {infinite, 3}};
  constexpr std::uint64_t hashes[] = {hash_of_clipped(covering, window), hash_of_clipped(passing, window),
                                      hash_of_clipped(at_corner, window), hash_of_clipped(on_boundary, window)};
  constexpr std::uint64_t open_hashes[] = {hash_of_clipped(covering, open), hash_of_clipped(passing, open),
                                           hash_of_clipped(at_corner, open), hash_of_clipped(on_boundary, open)};
  for (std::size_t i = 0; i < 4; ++i) {
    CHECK(hash_of_clipped(given[i], window) == hashes[i]);
    CHECK(hash_of_clipped(given[i], open) == open_hashes[i]);
  }
}

TEST_CASE("clip_sutherland_hodgman: windows: hostile numbers") {
  test::random r(2);
  int wrong = 0, kept_any = 0;
  for (int k = 0; k < line_cases::release_or(20000); ++k) {
    const auto c = line_cases::draw_case<double>(r), d = line_cases::draw_case<double>(r);
    const Polygon ring{c.a, c.b, r.integer(0, 1) != 0 ? d.a : c.window.low, d.b};
    const Polygon kept = clip_sutherland_hodgman(ring, c.window);
    kept_any += kept.empty() ? 0 : 1;
    wrong += places_of(clip_sutherland_hodgman(with_attributes(ring), c.window)) == kept ? 0 : 1;
    for (const P& p : kept) wrong += irg::contains(c.window, p) ? 0 : 1;
    wrong += kept.empty() || clip_sutherland_hodgman(kept, c.window) == kept ? 0 : 1;
    const Polygon back(ring.rbegin(), ring.rend());
    wrong += clip_sutherland_hodgman(back, c.window).size() == kept.size() ? 0 : 1;
  }
  CHECK(wrong == 0);
  CHECK(kept_any > 2000);
  constexpr double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  for (const double bad : {nan, inf, -inf})
    for (int i = 0; i < 6; ++i) {
      std::array<P, 3> t = tip;
      t[static_cast<std::size_t>(i / 2)][i % 2] = bad;
      CHECK(clip_sutherland_hodgman(t, window).empty());
      CHECK(clip_sutherland_hodgman(with_attributes({t.begin(), t.end()}), window).empty());
      CHECK(clip_sutherland_hodgman(t, std::array<P, 3>{P{0, 0}, P{9, 0}, P{0, 9}}).empty());
      CHECK(clip_sutherland_hodgman(tip, t).empty());
    }
  CHECK(clip_sutherland_hodgman(tip, box<double, 2>{}).empty());
  CHECK(clip_sutherland_hodgman(tip, std::array<P, 3>{P{0, 0}, P{1, 1}, P{2, 2}}).empty());
  CHECK(clip_sutherland_hodgman(Polygon{}, window).empty());
  CHECK(clip_sutherland_hodgman(Polygon{{1, 1}, {2, 2}}, window).empty());
  CHECK(clip_sutherland_hodgman(tip, box<double, 2>{{2, 2}, {2, 2}}).size() == 0);
  // A window without end on two sides.
  CHECK(clip_sutherland_hodgman(tip, box<double, 2>{{-inf, 2}, {inf, inf}}).size() == 3);
  // Too little memory: told, and nothing written beyond.
  std::array<P, 5> out;
  out.fill({7, 7});
  CHECK(clip_sutherland_hodgman(tip, window, std::span<P>(out).first(4)) >= 6);
  CHECK(out[4] == P{7, 7});
  // Longer than what the stack holds, and whole.
  Polygon comb;
  for (int i = 0; i < 200; ++i) comb.push_back({i * 0.01 + 1, i % 2 == 0 ? 1.0 : 5.0});
  comb.push_back({2, -1});
  const Polygon teeth = clip_sutherland_hodgman(comb, window);
  CHECK(teeth.size() > 300);
  CHECK(clip_sutherland_hodgman(teeth, window) == teeth);
}

#ifdef IRG_HAVE_MPFR
TEST_CASE("clip_sutherland_hodgman: windows: every cut is the nearest double on the given edge") {
  test::random r(3);
  int wrong = 0, cuts = 0;
  for (int k = 0; k < line_cases::release_or(2000); ++k) {
    const Polygon ring{{r.unit() * 8 - 4, r.unit() * 8 - 4},
                       {r.unit() * 8 - 4, r.unit() * 8 - 4},
                       {r.unit() * 8 - 4, r.unit() * 8 - 4}};
    const box<double, 2> w{{-1.1, -1.3}, {1.7, 0.9}};
    for (const P& p : clip_sutherland_hodgman(ring, w)) {
      if (std::find(ring.begin(), ring.end(), p) != ring.end()) continue;
      const bool on_x = p.x == w.low.x || p.x == w.high.x, on_y = p.y == w.low.y || p.y == w.high.y;
      wrong += on_x || on_y ? 0 : 1;
      if (on_x && on_y) continue;
      ++cuts;
      const int axis = on_x ? 0 : 1;
      bool found = false;
      for (std::size_t i = 0; i < 3; ++i) {
        using line_cases::mpq;
        const P a = ring[i], b = ring[(i + 1) % 3];
        if ((a[axis] < p[axis]) == (b[axis] < p[axis])) continue;
        const mpq t = (mpq(p[axis]) - mpq(a[axis])) / (mpq(b[axis]) - mpq(a[axis]));
        found =
            found || line_cases::is_nearest(p[1 - axis], mpq(a[1 - axis]) + t * (mpq(b[1 - axis]) - mpq(a[1 - axis])));
      }
      wrong += found ? 0 : 1;
    }
  }
  CHECK(wrong == 0);
  CHECK(cuts > 2000);
}
#endif

TEST_CASE("clip_sutherland_hodgman: no crack: what shares an edge cuts it at the same points") {
  test::random r(4);
  int wrong = 0, shared = 0;
  const std::array<P, 5> ring{P{0.1, -1.2}, P{1.3, 0.1}, P{0.7, 1.9}, P{-0.9, 1.1}, P{-1.2, -0.3}};
  for (int k = 0; k < line_cases::release_or(4000); ++k) {
    const auto draw = [&] { return P{r.unit() * 6 - 3, r.unit() * 6 - 3}; };
    const P a = draw(), b = draw(), c = draw(), d = draw();
    const box<double, 2> w{{-1.1, -1.3}, {1.7, 0.9}};
    // The ends of the shared edge, by their first attribute: 1 - t and t of a and b, nothing of the third vertex.
    using A = attributed_point<double, 2, 3>;
    const std::array<A, 3> one{A{a, {1, 0, 0}}, A{b, {0, 1, 0}}, A{c, {0, 0, 1}}};
    const std::array<A, 3> other{A{b, {0, 1, 0}}, A{a, {1, 0, 0}}, A{d, {0, 0, 1}}};
    const auto on_edge = [](const std::vector<A>& all) {
      std::vector<std::array<double, 4>> found;
      for (const A& v : all)
        if (v.attributes[2] == 0) found.push_back({v.position.x, v.position.y, v.attributes[0], v.attributes[1]});
      std::sort(found.begin(), found.end());
      return found;
    };
    for (int region = 0; region < 2; ++region) {
      const auto p = region == 0 ? clip_sutherland_hodgman(one, w) : clip_sutherland_hodgman(one, ring);
      const auto q = region == 0 ? clip_sutherland_hodgman(other, w) : clip_sutherland_hodgman(other, ring);
      if (p.empty() || q.empty()) continue;
      wrong += on_edge(p) == on_edge(q) ? 0 : 1;
      shared += on_edge(p).size() == 2 ? 1 : 0;
      // Vertices are where their attributes say.
      for (const A& v : p)
        for (int i = 0; i < 2; ++i) {
          const double there = v.attributes[0] * a[i] + v.attributes[1] * b[i] + v.attributes[2] * c[i];
          wrong += std::abs(there - v.position[i]) <= 1e-13 ? 0 : 1;
        }
    }
  }
  CHECK(wrong == 0);
  CHECK(shared > 1000);
}

TEST_CASE("clip_sutherland_hodgman: convex polygons: samples, area, clipped again") {
  test::random r(5);
  int wrong = 0, kept_any = 0, changed = 0;
  for (int k = 0; k < line_cases::release_or(1500); ++k) {
    const Polygon ring = star(r, static_cast<int>(r.integer(3, 12)), 3);
    Polygon region;
    const int n = static_cast<int>(r.integer(3, 9));
    const double cx = r.unit() * 2 - 1, cy = r.unit() * 2 - 1, turn = r.unit();
    for (int i = 0; i < n; ++i)
      region.push_back({cx + 1.5 * std::cos(turn + 6.283185307179586 * i / n),
                        cy + 1.5 * std::sin(turn + 6.283185307179586 * i / n)});
    if (r.integer(0, 1) != 0) std::reverse(region.begin(), region.end());
    const Polygon kept = clip_sutherland_hodgman(ring, region);
    kept_any += kept.empty() ? 0 : 1;
    for (int s = 0; s < 10; ++s) {
      const double x = r.unit() * 6 - 3, y = r.unit() * 6 - 3;
      const bool expected = winding(ring, x, y) != 0 && winding(region, x, y) != 0;
      wrong += (winding(kept, x, y) != 0) == expected ? 0 : 1;
    }
    changed += kept.empty() || clip_sutherland_hodgman(kept, region) == kept ? 0 : 1;
  }
  CHECK(wrong == 0);
  CHECK(changed == 0);
  CHECK(kept_any > 1000);
}

TEST_CASE("clip_sutherland_hodgman: planes: a view pyramid, clipped again, both sides of an edge") {
  using S = point<double, 3>;
  const std::vector<plane<double>> pyramid{{0, 0, 1, -1}, {0, 0, -1, 10}, {1, 0, 2, 0},
                                           {-1, 0, 2, 0}, {0, -2, 3, 0},  {0, 2, 3, 0}};
  test::random r(6);
  int wrong = 0, kept_any = 0, most = 0;
  for (int k = 0; k < line_cases::release_or(2000); ++k) {
    const auto draw = [&] { return S{r.unit() * 40 - 20, r.unit() * 30 - 15, r.unit() * 16 - 3}; };
    const S a = draw(), b = draw(), c = draw(), d = draw();
    const auto one = clip_sutherland_hodgman(std::array<S, 3>{a, b, c}, pyramid);
    const auto other = clip_sutherland_hodgman(std::array<S, 3>{b, a, d}, pyramid);
    kept_any += one.empty() ? 0 : 1;
    most = std::max(most, static_cast<int>(one.size()));
    for (const S& p : one)
      for (const auto& l : pyramid) wrong += irg::plane_value(l, p) >= -1e-13 ? 0 : 1;
    wrong += one.empty() || clip_sutherland_hodgman(one, pyramid) == one ? 0 : 1;
    // Where the edge goes into one of them, it goes into the other at the same point, bit for bit.
    const auto off = [&](const S& p) {  // twice the area of the triangle with the edge
      const S u{b.x - a.x, b.y - a.y, b.z - a.z}, v{p.x - a.x, p.y - a.y, p.z - a.z};
      return std::abs(u.y * v.z - u.z * v.y) + std::abs(u.z * v.x - u.x * v.z) + std::abs(u.x * v.y - u.y * v.x);
    };
    std::vector<S> on_one, on_other;
    for (const S& p : one)
      if (off(p) < 1e-11) on_one.push_back(p);
    for (const S& p : other)
      if (off(p) < 1e-11) on_other.push_back(p);
    if (on_one.size() == 2 && on_other.size() == 2)
      wrong += (on_one[0] == on_other[0] || on_one[0] == on_other[1]) ? 0 : 1;
  }
  CHECK(wrong == 0);
  CHECK(most >= 7);
  CHECK(kept_any > 300);
}

TEST_CASE("clip_sutherland_hodgman: numbers that can do no more than Scalar asks for") {
  using S = archetype::scalar;
  const auto ring = [](int left, int low, int right, int high) {
    return std::array{point<S, 2>{S(left), S(low)}, point<S, 2>{S(right), S(low)}, point<S, 2>{S(right), S(high)},
                      point<S, 2>{S(left), S(high)}};
  };
  const auto result = clip_sutherland_hodgman(ring(0, 0, 4, 4), ring(2, -1, 6, 6));
  const auto expected = ring(2, 0, 4, 4);
  CHECK(result.size() == 4);
  for (const point<S, 2>& p : expected) CHECK(std::find(result.begin(), result.end(), p) != result.end());
}
