// SPDX-License-Identifier: MIT
#include <irg/hidden/textbook/depth_sort.hpp>

#include <array>
#include <limits>

#include <irg/geometry/clip_sutherland_hodgman.hpp>
#include <irg/geometry/point_in_polygon.hpp>

#include "support/check_both.hpp"
#include "support/exact.hpp"
#include "support/random.hpp"

namespace {

using irg::newell_step;
using ring = std::vector<irg::point<double, 3>>;
__extension__ using wide = __int128;

template <class P, class Q>
constexpr std::array<bool, 5> all_tests(const P& p, const Q& q) {
  std::array<bool, 5> says{};
  for (std::size_t i = 0; i < 5; ++i) says[i] = irg::textbook::does_not_hide_by(static_cast<newell_step>(i), p, q);
  return says;
}

template <class T>
constexpr bool six_pairs() {
  using triangle = std::array<irg::point<T, 3>, 3>;
  struct pair_of_triangles {
    triangle p, q;
    std::array<bool, 5> says, swapped;
  };
  const triangle slope{{{T(0), T(0), T(0)}, {T(4), T(0), T(0)}, {T(0), T(8), T(0)}}};
  const triangle tilted{{{T(0), T(0), T(0)}, {T(2), T(0), T(5)}, {T(0), T(2), T(0)}}};
  const pair_of_triangles pairs[] = {{tilted,
                                      {{{T(3), T(0), T(1)}, {T(5), T(0), T(2)}, {T(3), T(2), T(3)}}},
                                      {true, false, false, false, true},
                                      {true, false, true, false, true}},
                                     {tilted,
                                      {{{T(0), T(3), T(1)}, {T(2), T(3), T(2)}, {T(0), T(5), T(3)}}},
                                      {false, true, false, false, true},
                                      {false, true, false, true, true}},
                                     {{{{T(0), T(0), T(0)}, {T(4), T(0), T(0)}, {T(0), T(4), T(3)}}},
                                      {{{T(0), T(0), T(2)}, {T(4), T(0), T(2)}, {T(0), T(4), T(5)}}},
                                      {false, false, true, true, false},
                                      {false, false, false, false, false}},
      // Twice the size, since one corner's depth is 5/2.
                                     {{{{T(0), T(0), T(0)}, {T(16), T(0), T(16)}, {T(0), T(16), T(0)}}},
                                      {{{T(2), T(2), T(4)}, {T(4), T(2), T(5)}, {T(2), T(4), T(12)}}},
                                      {false, false, false, true, false},
                                      {false, false, false, false, false}},
                                     {{{{T(0), T(0), T(0)}, {T(4), T(0), T(9)}, {T(0), T(4), T(0)}}},
                                      {{{T(4), T(4), T(5)}, {T(4), T(1), T(1)}, {T(1), T(4), T(1)}}},
                                      {false, false, false, false, true},
                                      {false, false, true, true, true}},
                                     {{{{T(0), T(0), T(0)}, {T(4), T(0), T(10)}, {T(0), T(4), T(10)}}},
                                      {{{T(1), T(1), T(1)}, {T(3), T(1), T(1)}, {T(1), T(3), T(1)}}},
                                      {false, false, false, false, false},
                                      {false, false, true, false, false}}};
  for (const pair_of_triangles& c : pairs)
    if (all_tests(c.p, c.q) != c.says || all_tests(c.q, c.p) != c.swapped) return false;
  return irg::textbook::newell_step_of(pairs[5].p, pairs[5].q) == newell_step::moved &&
         irg::textbook::newell_step_of(pairs[0].p, pairs[0].q) == newell_step::x_apart &&
         irg::textbook::newell_step_of(pairs[4].p, pairs[4].q) == newell_step::projections_apart &&
         all_tests(slope, slope) == std::array{false, false, true, true, false};
}

// Three rods on each other in turn.
std::vector<ring> rods() {
  return {{{0, 0, 0}, {90, 0, 9}, {90, 10, 9}, {0, 10, 0}},
          {{80, -10, 0}, {90, -10, 0}, {55, 80, 9}, {45, 80, 9}},
          {{45, 90, 0}, {35, 90, 0}, {0, -10, 9}, {10, -10, 9}}};
}

// The depth of a polygon's plane, as a fraction, at x/256, y/256; all corners are integers.
struct fraction {
  wide over, under;
};
fraction depth_at(const ring& r, long long x, long long y) {
  const auto whole = [](double v) { return static_cast<wide>(v); };
  const wide ux = whole(r[1].x - r[0].x), uy = whole(r[1].y - r[0].y), uz = whole(r[1].z - r[0].z);
  const wide vx = whole(r[2].x - r[0].x), vy = whole(r[2].y - r[0].y), vz = whole(r[2].z - r[0].z);
  const wide a = uy * vz - uz * vy, b = uz * vx - ux * vz, c = ux * vy - uy * vx;
  const wide over = whole(r[0].z) * c * 256 - a * (x - 256 * whole(r[0].x)) - b * (y - 256 * whole(r[0].y));
  return c < 0 ? fraction{-over, -c * 256} : fraction{over, c * 256};
}
bool is_nearer(const fraction& a, const fraction& b) { return a.over * b.under > b.over * a.under; }

irg::location place_in(const ring& r, long long x, long long y) {
  std::vector<irg::point<double, 2>> flat;
  for (const auto& p : r) flat.push_back({p.x, p.y});
  return irg::point_in_polygon(flat, irg::point<double, 2>{static_cast<double>(x) / 256, static_cast<double>(y) / 256});
}

struct tally {
  int covered = 0, wrong = 0, torn = 0, splits = 0, moved = 0, parts = 0;
};

// Draws the polygons and looks at `samples` places: is the last one drawn there the nearest?
void try_scene(const std::vector<ring>& polygons, int size, int samples, test::random& r, tally& t) {
  const auto order = irg::textbook::depth_sort(polygons, [&](newell_step step, std::uint32_t, std::uint32_t) {
    t.splits += step == newell_step::split_by_plane;
    t.moved += step == newell_step::moved;
  });
  t.parts += static_cast<int>(order.size());
  for (int k = 0; k < samples; ++k) {
    const long long x = r.integer(0, size - 1) * 256 + 2 * r.integer(0, 127) + 1,
                    y = r.integer(0, size - 1) * 256 + 2 * r.integer(0, 127) + 1;
    int nearest = -1, drawn = -1;
    std::vector<int> parts_here(polygons.size(), 0);
    bool on_edge = false;
    for (const auto& part : order) {
      const irg::location at = place_in(part.corners, x, y);
      on_edge = on_edge || at == irg::location::boundary;
      if (at != irg::location::inside) continue;
      drawn = static_cast<int>(part.number);
      ++parts_here[part.number];
    }
    for (std::size_t i = 0; i < polygons.size(); ++i) {
      const irg::location at = place_in(polygons[i], x, y);
      on_edge = on_edge || at == irg::location::boundary;
      if (at == irg::location::inside &&
          (nearest < 0 ||
           is_nearer(depth_at(polygons[i], x, y), depth_at(polygons[static_cast<std::size_t>(nearest)], x, y))))
        nearest = static_cast<int>(i);
      // Where two planes meet a cut may run, and the rounded parts have the place twice, or not at all.
      bool on_cut = false;
      for (std::size_t j = 0; j < polygons.size(); ++j) {
        const fraction own = depth_at(polygons[i], x, y), other = depth_at(polygons[j], x, y);
        on_cut = on_cut || (i != j && !is_nearer(own, other) && !is_nearer(other, own));
      }
      t.torn += !on_edge && !on_cut && parts_here[i] != (at == irg::location::inside ? 1 : 0);
    }
    if (on_edge) continue;
    t.covered += nearest >= 0;
    if (nearest >= 0 && drawn >= 0)
      t.wrong += is_nearer(depth_at(polygons[static_cast<std::size_t>(nearest)], x, y),
                           depth_at(polygons[static_cast<std::size_t>(drawn)], x, y));
    else
      t.wrong += nearest >= 0 || drawn >= 0;
  }
}

TEST_CASE("depth sort: the five tests, by hand, both ways round") {
  CHECK_BOTH(six_pairs<int>());
  CHECK_BOTH(six_pairs<double>());
}

TEST_CASE("depth sort: polygons that touch, that are seen edge on, that are nothing") {
  constexpr auto quad = [](int x, int z) {
    return std::array<irg::point<int, 3>, 4>{{{x, 0, z}, {x + 4, 0, z}, {x + 4, 4, z}, {x, 4, z}}};
  };
  constexpr auto first = [](const auto& p, const auto& q) { return irg::textbook::newell_step_of(p, q); };
  CHECK_BOTH(first(quad(0, 3), quad(4, 0)) == newell_step::x_apart);
  CHECK_BOTH(first(quad(0, 3), quad(3, 0)) == newell_step::moved);
  CHECK_BOTH(first(quad(3, 0), quad(0, 3)) == newell_step::behind_plane);
  constexpr auto edge_on = std::array<irg::point<int, 3>, 3>{{{1, 1, 0}, {3, 3, 5}, {2, 2, 9}}};
  CHECK_BOTH(first(edge_on, quad(0, 3)) == newell_step::projections_apart);
  CHECK_BOTH(first(quad(0, 3), edge_on) == newell_step::projections_apart);
  CHECK_BOTH(first(std::array<irg::point<int, 3>, 0>{}, quad(0, 3)) == newell_step::x_apart);

  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK(irg::textbook::depth_sort(std::vector<ring>{}).empty());
  const auto left = irg::textbook::depth_sort(std::vector<ring>{{}, {{0, 0, nan}, {1, 0, 0}, {0, 1, 0}}, {{1, 2, 3}}});
  REQUIRE(left.size() == 1);
  CHECK(left[0].number == 2);
}

TEST_CASE("depth sort: three rods in turn are split, in constant evaluation too") {
  tally t;
  test::random r(1671);
  try_scene(rods(), 90, 4000, r, t);
  CHECK(t.covered > 500);
  CHECK(t.wrong == 0);
  CHECK(t.torn == 0);
  CHECK(t.splits >= 1);
  constexpr auto parts = [] {
    const std::array<std::array<irg::point<double, 3>, 3>, 2> crossing{
        {{{{0, 0, 0}, {8, 0, 8}, {0, 8, 0}}}, {{{0, 0, 4}, {8, 0, 0}, {0, 8, 4}}}}};
    return irg::textbook::depth_sort(crossing).size();
  };
  CHECK_BOTH(parts() == 3);
}

TEST_CASE("depth sort: the last polygon drawn at a place is the nearest there, on random scenes of integers") {
  tally t;
  test::random r(1672);
  const int scenes = test::trials(40);
  for (int s = 0; s < scenes; ++s) {
    const int size = s % 2 == 0 ? 12 : 60, count = static_cast<int>(r.integer(2, 14));
    const auto corner = [&]() -> irg::point<double, 3> {
      const auto x = r.integer(0, size), y = r.integer(0, size), z = r.integer(0, s % 3 == 0 ? 3 : size);
      return {static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)};
    };
    std::vector<ring> polygons;
    while (static_cast<int>(polygons.size()) < count) {
      const auto a = corner(), b = corner(), c = corner();
      if (irg::orient2d(irg::point<double, 2>{a.x, a.y}, {b.x, b.y}, {c.x, c.y}) == 0) continue;
      polygons.push_back({a, b, c});
      if (r.integer(0, 3) == 0) polygons.back().push_back({a.x + c.x - b.x, a.y + c.y - b.y, a.z + c.z - b.z});
      if (r.integer(0, 9) == 0) polygons.push_back(polygons.back());  // the same again
    }
    try_scene(polygons, size, 60, r, t);
  }
  MESSAGE(scenes, " scenes: ", t.parts, " parts, ", t.moved, " moves, ", t.splits, " splits, ", t.covered, " places");
  CHECK(t.wrong == 0);
  CHECK(t.torn == 0);
  CHECK(t.splits > scenes);
  CHECK(t.moved > scenes);
  CHECK(t.covered > 20 * scenes);
}

TEST_CASE("depth sort: the area in common is that of Sutherland and Hodgman's clipping, whichever way corners run") {
  test::random rnd(61);
  int common = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    ring p, q;
    for (ring* r : {&p, &q})
      for (int i = 0; i < 3; ++i)
        r->push_back({double(rnd.integer(-9, 9)), double(rnd.integer(-9, 9)), double(rnd.integer(-99, 99))});
    const auto flat_q = irg::detail::without_depth(q);
    if (irg::polygon_area(flat_q) == 0) continue;
    const double area = irg::detail::area_in_common(p, q);
    const double expected = irg::polygon_area(irg::clip_sutherland_hodgman(irg::detail::without_depth(p), flat_q));
    const double off = area - (expected < 0 ? -expected : expected);
    CHECK((off < 1e-12 && -1e-12 < off));
    common += area > 0 ? 1 : 0;
  }
  CHECK(test::enough(common > 800));
}

TEST_CASE("depth sort: polygons 1e-300 and 1e300 large end, too") {
  for (const double size : {1e-300, 1e-160, 1e150, 1e300}) {
    std::vector<ring> all = rods();
    for (ring& r : all)
      for (auto& p : r) p = {p.x * size / 128, p.y * size / 128, p.z * size / 128};
    CHECK(irg::textbook::depth_sort(all).size() > 3);
  }
}

}  // namespace
