// SPDX-License-Identifier: MIT
#include <irg/hidden/textbook/depth_sort.hpp>

#include <limits>

#include <irg/geometry/point_in_polygon.hpp>

#include "support/check_both.hpp"
#include "support/exact.hpp"
#include "support/random.hpp"

namespace {

using irg::newell_step;
using ring = std::vector<irg::point<double, 3>>;
__extension__ using wide = __int128;

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

TEST_CASE("depth sort: polygons that are nothing") {
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
    const std::vector<ring> crossing{{{0, 0, 0}, {8, 0, 8}, {0, 8, 0}}, {{0, 0, 4}, {8, 0, 0}, {0, 8, 4}}};
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

TEST_CASE("depth sort: polygons 1e-300 and 1e300 large end, too") {
  for (const double size : {1e-300, 1e-160, 1e150, 1e300}) {
    std::vector<ring> all = rods();
    for (ring& r : all)
      for (auto& p : r) p = {p.x * size / 128, p.y * size / 128, p.z * size / 128};
    CHECK(irg::textbook::depth_sort(all).size() > 3);
  }
}

}  // namespace
