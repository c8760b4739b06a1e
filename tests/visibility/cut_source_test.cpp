// SPDX-License-Identifier: MIT
#include <irg/visibility/cut_source.hpp>

#include <cstdlib>
#include <vector>

#include <irg/visibility/weak_visibility.hpp>

#include "support/check_both.hpp"
#include "support/random.hpp"

namespace {

using place = irg::point<double, 2>;
using wall = irg::segment<double, 2>;

constexpr bool lamp_with_a_wall_through_it() {
  const place lamp[] = {{-1, 3}, {1, 3}, {1, 4}, {-1, 4}};
  const wall walls[] = {{{0, 2}, {0, 5}}, {{3, 3}, {4, 3}}};
  const auto cut = irg::cut_source_rounded<double>(lamp, walls);
  const auto untouched = irg::cut_source_rounded<double>(lamp, {});
  return cut.ring.size() == 6 && cut.ring[1] == place{0, 3} && cut.ring[4] == place{0, 4} &&
         cut.obstacles.size() == 4 && untouched.ring.size() == 4 && untouched.obstacles.empty() &&
         irg::cut_source_rounded<double>({}, walls).obstacles.size() == 2;
}
TEST_CASE("cut_source_rounded: a wall through a lamp, and none") { CHECK_BOTH(lamp_with_a_wall_through_it()); }

TEST_CASE("cut_source_rounded: a lamp with a wall through it is seen by half") {
  const place lamp[] = {{-1, 3}, {1, 3}, {1, 4}, {-1, 4}};
  const wall walls[] = {{{0, 2}, {0, 5}}};
  const irg::box<double, 2> window{{-5, -5}, {5, 5}};
  const auto refused = irg::weak_visibility(std::span<const place>(lamp), walls, window);
  CHECK(refused.status == irg::visibility_status::source_crosses_obstacle);
  const auto cut = irg::cut_source_rounded<double>(lamp, walls);
  const auto parts = irg::weak_visibility(std::span<const place>(cut.ring), cut.obstacles, window);
  CHECK(parts.status == irg::visibility_status::ok);
  CHECK(parts.none.empty());
  const auto area = [](const std::vector<std::vector<place>>& rings) {
    double sum = 0;
    for (const auto& r : rings)
      for (std::size_t i = 0; i < r.size(); ++i)
        sum += (r[i].x * r[(i + 1) % r.size()].y - r[i].y * r[(i + 1) % r.size()].x) / 2;
    return sum;
  };
  CHECK(parts.all.empty());
  CHECK(area(parts.some) == 100);
}

// An edge that two walls cut, and one runs along: that one is bent with the edge.
constexpr bool wall_along_a_cut_edge() {
  const place lamp[] = {{0, 0}, {3, 1}, {0, 3}};
  const wall walls[] = {{{-3, -1}, {6, 2}}, {{1, 0}, {1, 1}}, {{2, 0}, {2, 1}}};
  const auto cut = irg::cut_source_rounded<double>(lamp, walls);
  std::size_t along = 0;
  for (std::size_t i = 0; i < cut.ring.size(); ++i)
    for (const wall& w : cut.obstacles) along += w == wall{cut.ring[i], cut.ring[(i + 1) % cut.ring.size()]};
  return cut.ring.size() == 5 && cut.obstacles.size() == 9 && along == 3;
}
TEST_CASE("cut_source_rounded: a wall along an edge that others cut") { CHECK_BOTH(wall_along_a_cut_edge()); }

TEST_CASE("cut_segment_rounded: a segment with a wall through it is seen by half") {
  const wall lamp{{-1, 3}, {1, 3}}, walls[] = {{{0, 2}, {0, 5}}};
  const irg::box<double, 2> window{{-5, -5}, {5, 5}};
  CHECK(irg::weak_visibility(lamp, walls, window).status == irg::visibility_status::source_crosses_obstacle);
  const auto cut = irg::cut_segment_rounded(lamp, walls);
  CHECK(cut.pieces.size() == 2);
  const auto parts = irg::weak_visibility(std::span<const std::vector<place>>(cut.pieces), cut.obstacles, window);
  CHECK(parts.status == irg::visibility_status::ok);
  const auto holds = [](const std::vector<std::vector<place>>& rings, const place& p) {
    return irg::point_in_polygon(rings, p, irg::fill_rule::even_odd) == irg::location::inside;
  };
  CHECK(holds(parts.some, {1, 4}));
  CHECK(holds(parts.some, {-1, 2.5}));
  CHECK(parts.all.empty());
  CHECK(parts.none.empty());
  CHECK(irg::cut_segment_rounded<double>({{1, 1}, {1, 1}}, walls).pieces.size() == 1);
}

TEST_CASE("cut_source_rounded: nothing crosses any more, on grids and off them") {
  test::random r(61);
  int wrong = 0, cut_ones = 0;
  for (int i = 0; i < 300; ++i) {
    const auto any = [&] {
      const auto number = [&] { return i % 2 == 0 ? static_cast<double>(r.integer(-4, 4)) : 8 * r.unit() - 4; };
      const double x = number();
      return place{x, number()};
    };
    const std::vector<place> lamp{any(), any(), any()};
    std::vector<wall> walls;
    for (auto n = r.integer(0, 6); n > 0; --n) {
      const place a = any(), b = any();
      walls.push_back({a, b});
    }
    const auto cut = irg::cut_source_rounded<double>(lamp, walls);
    cut_ones += cut.obstacles.size() > walls.size();
    const irg::box<double, 2> window{{-5, -5}, {5, 5}};
    if (i % 10 != 0) {
      irg::detail::source_view<double> view;
      irg::detail::add_source(view, cut.ring);
      view.obstacles = cut.obstacles;
      wrong += irg::detail::crosses_obstacle(view);
      continue;
    }
    const auto status = irg::weak_visibility(std::span<const place>(cut.ring), cut.obstacles, window).status;
    wrong += status != irg::visibility_status::ok && irg::is_convex(cut.ring);
  }
  CHECK(wrong == 0);
  CHECK(cut_ones > 100);
}

}  // namespace
