// SPDX-License-Identifier: MIT
#include <irg/visibility/sight_line.hpp>

#include <cmath>
#include <cstdlib>
#include <limits>
#include <vector>

#include "support/check_both.hpp"
#include "support/plane_sight_oracle.hpp"
#include "support/random.hpp"

namespace {

using irg::obstacle_ends;
using irg::sight_reach;
using place = irg::point<double, 2>;
using wall = irg::segment<double, 2>;

constexpr wall cross[] = {{{3, -1}, {3, 1}}, {{1, -1}, {1, 1}}, {{5, 0}, {4, 0}}};

TEST_CASE("see and first_obstacle: ordinary, degenerate and hostile input") {
  constexpr double most = std::numeric_limits<double>::max(), least = std::numeric_limits<double>::denorm_min();
  constexpr wall dot[] = {{{1, 0}, {1, 0}}}, thin[] = {{{0, most}, {least, -most}}};
  CHECK_BOTH(irg::first_obstacle(place{0, 0}, place{6, 0}, cross) == 1u);
  CHECK_BOTH(irg::first_obstacle(place{6, 0}, place{0, 0}, cross) == 2u);
  CHECK_BOTH(irg::first_obstacle(place{1, 0}, place{3, 0}, cross) == std::nullopt);  // at its ends only
  CHECK_BOTH(irg::first_obstacle(place{1, 0}, place{2, 0}, cross, obstacle_ends::closed, sight_reach::onwards) == 0u);
  CHECK_BOTH(irg::first_obstacle(place{6, 1}, place{7, 1}, cross, obstacle_ends::closed, sight_reach::onwards) ==
             std::nullopt);
  CHECK_BOTH((irg::has_line_of_sight(place{0, 0}, place{1, 0}, cross) &&
              !irg::has_line_of_sight(place{0, 0}, place{2, 0}, cross)));
  CHECK_BOTH((irg::has_line_of_sight(place{2, 0}, place{2, 0}, cross) &&
              irg::has_line_of_sight(place{0, 0}, place{1, 1}, {})));
  CHECK_BOTH((!irg::has_line_of_sight(place{0, 2}, place{2, 0}, cross) &&
              irg::has_line_of_sight(place{0, 2}, place{2, 0}, cross, obstacle_ends::open)));
  CHECK_BOTH((!irg::has_line_of_sight(place{0, 0}, place{2, 0}, dot) &&
              irg::has_line_of_sight(place{0, 0}, place{2, 0}, dot, obstacle_ends::open)));
  CHECK_BOTH((!irg::has_line_of_sight(place{-most, 0}, place{most, 0}, thin) &&
              !irg::has_line_of_sight(place{-least, 0}, place{least, 0}, thin)));
}

#ifdef IRG_HAVE_MPFR
namespace oracle = test::plane_sight;
using oracle::number;

oracle::place exactly(const place& p) { return {number(p.x), number(p.y)}; }

// How far along the way from p to q an obstacle is met first: 0 when it goes on from p.
std::optional<number> met_at(const oracle::place& p, const oracle::place& q, const wall& w, bool closed, bool onwards) {
  const oracle::place d = q - p, a = exactly(w.a) - p, b = exactly(w.b) - p;
  const number along = oracle::dot(d, d), one(1), side_a = oracle::cross(d, a), side_b = oracle::cross(d, b);
  if (side_a.sign() == 0 && side_b.sign() == 0) {
    const number ta = oracle::dot(a, d) / along, tb = oracle::dot(b, d) / along;
    const number low = ta < tb ? ta : tb, high = ta < tb ? tb : ta;
    if (high.sign() <= 0 || !(onwards || low < one) || (low == high && !closed)) return std::nullopt;
    return low.sign() < 0 ? number(0) : low;
  }
  if (side_a.sign() * side_b.sign() > 0 || (side_a.sign() * side_b.sign() == 0 && !closed)) return std::nullopt;
  const number share = side_a / (side_a - side_b), t = oracle::dot(a + share * (b - a), d) / along;
  if (t.sign() <= 0 || !(onwards || t < one)) return std::nullopt;
  return t;
}

TEST_CASE("see and first_obstacle: as in rationals, both ways") {
  test::random r(9);
  const int times = std::getenv("IRG_RELEASE_TIER") != nullptr ? 100 : 1;
  int wrong = 0;
  for (int i = 0; i < 3000 * times; ++i) {
    const auto any = [&] {
      const auto coordinate = [&] {
        const auto n = static_cast<double>(r.integer(-3, 3));
        return std::ldexp(n, i % 4 == 0 ? static_cast<int>(r.integer(-1000, 1000)) : 0);
      };
      const double x = coordinate(), y = coordinate();
      return place{x, y};
    };
    const place p = any(), q = any();
    std::vector<wall> walls;
    for (auto n = r.integer(0, 4); n > 0; --n) {
      const place a = any(), b = any();
      walls.push_back({a, b});
    }
    for (const auto ends : {obstacle_ends::closed, obstacle_ends::open})
      for (const auto reach : {sight_reach::up_to, sight_reach::onwards}) {
        const bool closed = ends == obstacle_ends::closed, onwards = reach == sight_reach::onwards;
        std::optional<std::size_t> want;
        std::optional<number> at;
        for (std::size_t k = 0; k < walls.size() && !(p == q); ++k) {
          const auto t = met_at(exactly(p), exactly(q), walls[k], closed, onwards);
          if (t && (!at || *t < *at)) want = k, at = t;
        }
        wrong += irg::first_obstacle(p, q, walls, ends, reach) != want;
        if (!onwards)
          wrong += irg::has_line_of_sight(p, q, walls, ends) == want.has_value() ||
                   irg::has_line_of_sight(q, p, walls, ends) == want.has_value();
      }
  }
  CHECK(wrong == 0);
}
#endif

}  // namespace
