// SPDX-License-Identifier: MIT
#include <irg/visibility/prepared_walls.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <limits>
#include <vector>

#include "support/check_both.hpp"
#include "support/random.hpp"

namespace {

using place = irg::point<double, 2>;
using wall = irg::segment<double, 2>;
using irg::visibility_status;

constexpr irg::box<double, 2> room{{-8, -8}, {8, 8}};

// The same status and the same ring, from whatever corner on.
constexpr bool are_same(irg::visible_region<double> a, const irg::visible_region<double>& b) {
  if (a.ring.size() != b.ring.size()) return false;
  for (std::size_t i = 0; i < a.ring.size() && !(a.ring[0] == b.ring[0]); ++i)
    std::rotate(a.ring.begin(), a.ring.begin() + 1, a.ring.end());
  return a == b;
}

constexpr bool same(const std::vector<wall>& walls, const place& from, const irg::box<double, 2>& domain = room) {
  const irg::prepared_walls<double> prepared(walls, domain);
  return are_same(prepared.seen_from(from), irg::visibility_polygon(from, domain, walls));
}
constexpr bool of_few() {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  return same({}, {0, 0}) && same({{{1, -1}, {1, 1}}, {{2, -3}, {2, 3}}}, {0, 0}) && same({{{1, 0}, {2, 0}}}, {1, 0}) &&
         same({{{1, 0}, {nan, 0}}}, {1, 0}) && same({}, {nan, 0}) && same({}, {9, 0}) &&
         same({{{1, 0}, {2, 0}}}, {0, 0}, {});
}
static_assert(of_few());

TEST_CASE("prepared_walls: constants as at run time") { CHECK(of_few()); }

TEST_CASE("prepared_walls: the polygon of all walls, bit for bit") {
  test::random r(51);
  const int times = std::getenv("IRG_RELEASE_TIER") != nullptr ? 40 : 1;
  int wrong = 0;
  for (int i = 0; i < 160 * times; ++i) {
    std::vector<wall> walls;
    const auto n = r.integer(0, i % 8 == 0 ? 600 : 60);
    const double size = std::ldexp(1.0, static_cast<int>(r.integer(-4, 4)));
    for (int k = 0; k < n; ++k) {
      const auto number = [&](double most) {
        return i % 2 == 0 ? std::round(most * (2 * r.unit() - 1)) : most * (2 * r.unit() - 1);
      };
      const place a{number(9), number(9)};
      const double u = number(size), v = number(size);
      walls.push_back({a, {a.x + u, a.y + v}});
    }
    const irg::prepared_walls<double> prepared(walls, room);
    for (int k = 0; k < 8; ++k) {
      place from{16 * r.unit() - 8, 16 * r.unit() - 8};
      if (k % 2 == 0) from = {std::round(from.x), std::round(from.y)};  // on walls, borders, ends
      wrong += !are_same(prepared.seen_from(from), irg::visibility_polygon(from, room, walls));
    }
  }
  CHECK(wrong == 0);
}

TEST_CASE("prepared_walls: far from the origin, and of all sizes side by side") {
  test::random r(52);
  int wrong = 0;
  for (int i = 0; i < 60; ++i) {
    std::vector<wall> walls;
    const double far = std::ldexp(1.0, static_cast<int>(r.integer(0, 60)));
    const int low = i % 3 == 0 ? -1000 : -3, high = i % 3 == 0 ? 1000 : 3;
    const auto number = [&] {
      return std::ldexp(r.unit() - 0.5, static_cast<int>(r.integer(low, high))) + (i % 3 == 1 ? far : 0);
    };
    for (int k = 0; k < 40; ++k) {
      const place a{number(), number()};
      const place b{number(), number()};
      walls.push_back({a, b});
    }
    const place from{number(), number()};
    constexpr double most = std::numeric_limits<double>::max();
    wrong += !same(walls, from, {{-most, -most}, {most, most}});
    wrong += !same(walls, from, {{far - 2, far - 2}, {far + 2, far + 2}});
  }
  CHECK(wrong == 0);
}

TEST_CASE("prepared_walls: walls that are not finite, in a box without inside") {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<wall> walls{{{nan, 0}, {1, 1}}};
  for (const irg::box<double, 2>& domain : {irg::box<double, 2>{{1, 1}, {0, 0}}, {{nan, 0}, {1, 1}}, {{0, 0}, {1, 1}}})
    for (const place from : {place{0.5, 0.25}, place{7, 7}, place{nan, 0}}) CHECK(same(walls, from, domain));
}

TEST_CASE("prepared_walls: walls in hidden tiles are counted as passed over") {
  std::vector<wall> walls{{{-1, -1}, {1, -1}}, {{1, -1}, {1, 1}}, {{1, 1}, {-1, 1}}, {{-1, 1}, {-1, -1}}};
  for (int i = 0; i < 60; ++i) walls.push_back({{6.0 + i % 8 / 4.0, i / 8 - 3.75}, {6.1 + i % 8 / 4.0, i / 8 - 3.65}});
  const irg::box<double, 2> domain{{-8, -8}, {8, 8}};
  const irg::prepared_walls<double> prepared(walls, domain);
  irg::sight_counts counts;
  CHECK(prepared.seen_from({0.25, 0.125}, counts) == prepared.seen_from({0.25, 0.125}));
  CHECK(counts.walls == 68);
  CHECK(counts.passed_over == 60);  // the room round the source, and the domain's edges behind it, are compared
  CHECK(counts.directions == 8);
  irg::sight_counts outside;
  CHECK(prepared.seen_from({9, 0}, outside).ring.empty());
  CHECK(outside == irg::sight_counts{68, 68, 0, 0, 0});
}

}  // namespace
