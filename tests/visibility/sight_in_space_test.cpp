// SPDX-License-Identifier: MIT
#include <irg/visibility/sight_in_space.hpp>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <vector>

#include <irg/mesh/shapes.hpp>

#include "support/check_both.hpp"
#include "support/random.hpp"

namespace {

using irg::seen_share;
using place = irg::point<double, 3>;
using body = irg::mesh<double>;
using region = irg::space_region<double>;

constexpr void add(body& m, std::initializer_list<place> corners) {
  std::vector<std::uint32_t> face;
  for (const place& p : corners) {
    face.push_back(static_cast<std::uint32_t>(m.positions.size()));
    m.positions.push_back(p);
  }
  irg::add_face(m, face);
}

// A wall from -1 to 1 in y and z, at x = 0.
constexpr body a_wall() {
  body m;
  add(m, {{0, -1, -1}, {0, 1, -1}, {0, 1, 1}, {0, -1, 1}});
  return m;
}

constexpr bool points() {
  const body m = a_wall();
  const place at{-1, 0, 0}, behind{1, 0, 0}, past{1, 5, 0}, edge{1, 2, 0}, in_it{0, 0, 0}, beside{0, 2, 0};
  return !irg::has_line_of_sight(at, behind, m) && irg::has_line_of_sight(at, past, m) &&
         !irg::has_line_of_sight(at, edge, m) && irg::has_line_of_sight(at, in_it, m) &&
         irg::has_line_of_sight(at, at, m) && irg::has_line_of_sight(beside, place{0, 3, 0}, m) &&
         !irg::has_line_of_sight(beside, in_it, m) && !irg::has_line_of_sight(beside, place{0, -2, 0}, m) &&
         irg::has_line_of_sight(place{0, 2, 0.75}, place{0, 0.75, 2}, m) &&
         !irg::has_line_of_sight(place{0, 2, 0}, place{0, 0, 2}, m);
}

constexpr std::optional<seen_share> of_eye(double y) {
  return irg::sure_sight(region{{{-1, 0, 0}}}, region{{{1, y, 0}, {1, y, 0.5}}}, a_wall());
}
std::optional<seen_share> of_boxes(double y) {
  const region a = irg::region_of(irg::box<double, 3>{{-3, -0.25, -0.25}, {-2, 0.25, 0.25}});
  const region b = irg::region_of(irg::box<double, 3>{{2, y - 0.25, -0.25}, {3, y + 0.25, 0.25}});
  return irg::sure_sight(a, b, a_wall());
}

TEST_CASE("sight in space: past a wall") {
  CHECK_BOTH(points());
  CHECK_BOTH(of_eye(0) == seen_share::none);
  CHECK_BOTH(of_eye(9) == seen_share::all);
  CHECK(of_boxes(0) == seen_share::none);
  CHECK(of_boxes(2) == seen_share::some);
  CHECK(of_boxes(9) == seen_share::all);
  const region eye{{{-1, 0, 0}}}, sky{{{5, 9, 9}}}, floor{{{1, -1, -1}, {1, 1, -1}, {1, 1, 1}, {1, -1, 1}}};
  CHECK(irg::sure_sight(eye, sky, a_wall()) == seen_share::all);
  CHECK(irg::sure_sight(eye, region{{{1, 0, 0}}}, a_wall()) == seen_share::none);
  CHECK(irg::sure_sight(eye, floor, a_wall()) == seen_share::none);
  CHECK(irg::sure_sight(region{{{-1, 0, 0}, {-1, 3, 0}}}, floor, a_wall()) == seen_share::some);
  CHECK(irg::sure_sight(eye, floor, body{}) == seen_share::all);
}

TEST_CASE("sight in space: a wall of two faces hides what neither does alone, and that is not known") {
  body m;
  add(m, {{0, -1, -1}, {0, 0, -1}, {0, 0, 1}, {0, -1, 1}});
  add(m, {{0, 0, -1}, {0, 1, -1}, {0, 1, 1}, {0, 0, 1}});
  const region a{{{-2, -0.5, 0}, {-2, 0.5, 0}}}, b{{{2, -0.5, 0}, {2, 0.5, 0}}};
  CHECK(irg::sure_sight(a, b, m) == std::nullopt);
  CHECK(irg::sample_sight(a, b, m).seen == 0);
}

TEST_CASE("sight in space: the faces of a cube from outside") {
  const body cube = irg::shape_cube<double>();  // from 0 to 1, two triangles a side
  const auto count = [&](const place& eye, std::optional<seen_share> what) {
    int n = 0;
    for (const auto& s : irg::sure_sight_of_faces(region{{eye}}, cube)) n += s == what;
    return n;
  };
  CHECK(count({9, 0.5, 0.5}, seen_share::all) == 2);
  CHECK(count({9, 0.5, 0.5}, seen_share::some) == 0);
  CHECK(count({9, 9, 9}, seen_share::all) == 6);
  CHECK(count({9, 9, 9}, seen_share::some) == 0);
  CHECK(count({0.5, 0.5, 0.5}, seen_share::all) == 12);
}

// Whether the open segment meets the triangle: by the stretch of it that lies in the plane and within all three edges.
// The numbers are whole and small, so that nothing is rounded.
bool meets(const place& p, const place& q, const std::array<place, 3>& t) {
  const auto cross = [](const irg::vec<double, 3>& u, const irg::vec<double, 3>& v) {
    return irg::vec<double, 3>{u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
  };
  const auto times = [](const irg::vec<double, 3>& u, const irg::vec<double, 3>& v) {
    return u.x * v.x + u.y * v.y + u.z * v.z;
  };
  const auto normal = cross(t[1] - t[0], t[2] - t[0]);
  if (times(normal, normal) == 0) return false;
  struct fraction {
    double up, down;  // down > 0
    bool operator<(const fraction& o) const { return up * o.down < o.up * down; }
  };
  fraction from{0, 1}, to{1, 1};
  bool from_is_open = true, to_is_open = true, empty = p == q;
  const auto within = [&](double at_p, double at_q) {  // where at_p + s (at_q - at_p) >= 0
    if (at_p < 0 && at_q < 0) empty = true;
    if (at_p == at_q) return empty = empty || at_p < 0, void();
    const fraction at = at_p > at_q ? fraction{at_p, at_p - at_q} : fraction{-at_p, at_q - at_p};
    if (at_q > at_p) {
      if (from < at) from = at, from_is_open = false;
    } else {
      if (at < to) to = at, to_is_open = false;
    }
  };
  within(times(normal, p - t[0]), times(normal, q - t[0]));
  within(-times(normal, p - t[0]), -times(normal, q - t[0]));
  for (std::size_t i = 0; i < 3; ++i) {
    const auto inwards = cross(normal, t[(i + 1) % 3] - t[i]);
    within(times(inwards, p - t[i]), times(inwards, q - t[i]));
  }
  return !empty && (from < to || (!(to < from) && !from_is_open && !to_is_open));
}

TEST_CASE("sight in space: has_line_of_sight() against the stretch within planes, on small grids") {
  test::random r(31);
  const int times = std::getenv("IRG_RELEASE_TIER") != nullptr ? 100 : 1;
  int wrong = 0, hits = 0;
  for (int i = 0; i < 20000 * times; ++i) {
    const auto any = [&] {
      const auto x = static_cast<double>(r.integer(-2, 2)), y = static_cast<double>(r.integer(-2, 2));
      return place{x, y, static_cast<double>(r.integer(i % 4 == 0 ? 0 : -2, i % 4 == 0 ? 0 : 2))};
    };
    const std::array<place, 3> t{any(), any(), any()};
    const place p = any(), q = any();
    body m;
    add(m, {t[0], t[1], t[2]});
    const bool hit = meets(p, q, t);
    hits += hit;
    wrong += irg::has_line_of_sight(p, q, m) == hit;
    for (place& v : m.positions) v = {std::ldexp(v.x, 300), std::ldexp(v.y, -200), v.z};
    const auto stretched = [](const place& v) { return place{std::ldexp(v.x, 300), std::ldexp(v.y, -200), v.z}; };
    wrong += irg::has_line_of_sight(stretched(q), stretched(p), m) == hit;
  }
  CHECK(wrong == 0);
  CHECK(hits > 1000 * times);
}

region random_region(test::random& r, double x) {
  const auto any = [&] {
    const double along = x + 2 * r.unit(), y = 4 * r.unit() - 2;
    return place{along, y, 4 * r.unit() - 2};
  };
  const place at = any();
  switch (r.integer(0, 3)) {
    case 0: return {{at}};
    case 1: return {{at, any()}};
    case 2: return {{at, any(), any()}};
    default: return irg::region_of(irg::box<double, 3>{at, {at.x + r.unit(), at.y + r.unit(), at.z + r.unit()}});
  }
}

TEST_CASE("sight in space: what is sure, none of the random lines contradicts") {
  test::random r(32);
  const int times = std::getenv("IRG_RELEASE_TIER") != nullptr ? 50 : 1;
  int wrong = 0, of[3]{}, open = 0, missed = 0;
  for (int i = 0; i < 300 * times; ++i) {
    const region a = random_region(r, -4), b = random_region(r, 2);
    body m;
    for (auto n = r.integer(0, 4); n > 0; --n) {
      const double size = i % 2 == 0 ? 4 : 30;
      const auto any = [&] {
        const double x = 2 * r.unit() - 1, y = size * (r.unit() - 0.5);
        return place{x, y, size * (r.unit() - 0.5)};
      };
      add(m, {any(), any(), any()});
    }
    const auto sure = irg::sure_sight(a, b, m);
    const auto lines = irg::sample_sight(a, b, m, {300, static_cast<std::uint64_t>(i)});
    wrong += sure == seen_share::all && lines.seen != lines.lines;
    wrong += sure == seen_share::none && lines.seen != 0;
    wrong += !(lines.low <= lines.share && lines.share <= lines.high && lines.low >= 0 && lines.high <= 1);
    wrong += irg::sure_sight(b, a, m) != sure && sure && irg::sure_sight(b, a, m);
    missed += sure == seen_share::some && lines.seen == lines.lines;
    if (sure)
      ++of[static_cast<int>(*sure)];
    else
      ++open;
  }
  CHECK(wrong == 0);
  for (const int n : of) CHECK(n > 20);
  CHECK(open < 40 * times);  // what several faces hide together
  CHECK(missed < 20 * times);  // seen but for a share too small for the lines
}

TEST_CASE("sight in space: error bars hold the true share as often as they say") {
  body m;
  add(m, {{0, -9, -9}, {0, 0, -9}, {0, 0, 9}, {0, -9, 9}});  // hides what is below y = 0 on the way
  const region eye{{{-1, 0, 0}}}, line{{{1, -1, 0}, {1, 3, 0}}};  // three quarters are seen
  const region square{{{1, -1, -1}, {1, 1, -1}, {1, 1, 1}, {1, -1, 1}}};
  int off = 0;
  for (std::uint64_t seed = 1; seed <= 400; ++seed) {
    const auto s = irg::sample_sight(eye, line, m, {500, seed}), t = irg::sample_sight(eye, square, m, {500, seed});
    off += s.low > 0.75 || s.high < 0.75;
    off += t.low > 0.5 || t.high < 0.5;
  }
  CHECK(off < 20);  // 8 expected
  const auto all = irg::sample_sight(eye, region{{{1, 1, 0}}}, m);
  CHECK(all.share == 1);
  CHECK(all.high == 1);
  CHECK(all.low > 0.99);
}

TEST_CASE("sight in space: places are as evenly spread in squares of every size") {
  const auto seen_at = [](double size) {
    const auto at = [size](double x, double y, double z) { return place{x * size, y * size, z * size}; };
    body m;
    m.positions = {at(-0.5, -0.5, 0.25), at(0.5, -0.5, 0.25), at(0.5, 0.5, 0.25)};
    add_face(m, std::array{0, 1, 2});
    const region square{{at(-0.5, -0.5, 0), at(0.5, -0.5, 0), at(0.5, 0.5, 0), at(-0.5, 0.5, 0)}};
    return irg::sample_sight(square, region{{at(0, 0, 0.5)}}, m, {2000, 7}).seen;
  };
  const auto seen = seen_at(1);
  CHECK((900 < seen && seen < 1100));
  for (const double size : {0x1p-1000, 0x1p-300, 0x1p300, 0x1p1000, 0x1p1023, 0x1.8p1023}) CHECK(seen_at(size) == seen);
}

}  // namespace
