// SPDX-License-Identifier: MIT
#include <irg/visibility/viewshed.hpp>

#include <cstdint>
#include <limits>
#include <numeric>

#include <irg/raster/image.hpp>

#include "support/check_both.hpp"
#include "support/sight_oracle.hpp"

namespace {

using irg::cell;
using irg::cell3;

// Each prism clipped against the line by itself.
bool passes(const irg::image<int>& h, cell a, cell b, const irg::sight_heights& above) {
  const std::int64_t eye = h(a.x, a.y) + above.eye, target = h(b.x, b.y) + above.target;
  const auto below = [&](int x, int y, test::part t) { return (eye - h(x, y)) * t.d + (target - eye) * t.n < 0; };
  const auto corner_blocks = [&](int x, int y, test::part t) {  // all cells that have this point as a corner
    int high = 0, cells = 0;
    for (int j = -1; j <= 1; ++j)
      for (int i = -1; i <= 1; ++i) {
        const cell c{x + i, y + j};
        if (c.x < 0 || c.y < 0 || c.x >= h.width() || c.y >= h.height()) continue;
        const test::stretch s = test::within_box(a, b, {2 * c.x - 1, 2 * c.y - 1, -1}, {2 * c.x + 1, 2 * c.y + 1, 1});
        if (!s.empty() && s.first == s.last && s.first == t) ++cells, high += below(c.x, c.y, t);
      }
    return cells == 2 && high == 2;
  };
  for (int y = 0; y < h.height(); ++y)
    for (int x = 0; x < h.width(); ++x) {
      if (cell{x, y} == a || cell{x, y} == b) continue;
      const test::stretch s = test::within_box(a, b, {2 * x - 1, 2 * y - 1, -1}, {2 * x + 1, 2 * y + 1, 1});
      if (s.empty()) continue;
      if (s.first == s.last ? corner_blocks(x, y, s.first) : below(x, y, s.first) || below(x, y, s.last)) return false;
    }
  return true;
}

static_assert([] {
  irg::image<int> h(3, 1, 0);
  h(1, 0) = 2;
  return !irg::has_line_of_sight(h, {0, 0}, {2, 0}, {1, 1}) && irg::has_line_of_sight(h, {0, 0}, {2, 0}, {2, 2}) &&
         irg::viewshed(h, {0, 0}).count() == 2 && irg::viewshed(h, {3, 0}).count() == 0;
}());

TEST_CASE("viewshed: against prisms clipped one by one") {
  test::random r(10);
  for (int i = 0; i < 200; ++i) {
    irg::image<int> h(static_cast<int>(r.integer(1, 8)), static_cast<int>(r.integer(1, 8)), 0);
    for (int y = 0; y < h.height(); ++y)
      for (int x = 0; x < h.width(); ++x) h(x, y) = static_cast<int>(r.integer(0, 4));
    const cell eye{static_cast<int>(r.integer(0, h.width() - 1)), static_cast<int>(r.integer(0, h.height() - 1))};
    const irg::sight_heights above{static_cast<int>(r.integer(0, 2)), static_cast<int>(r.integer(0, 2))};
    const irg::cell_grid seen = irg::viewshed(h, eye, above);
    int wrong = 0;
    for (int y = 0; y < h.height(); ++y)
      for (int x = 0; x < h.width(); ++x) {
        wrong += seen.is_full({x, y, 0}) != passes(h, eye, {x, y}, above);
        wrong += irg::has_line_of_sight(h, eye, {x, y}, {1, 1}) != irg::has_line_of_sight(h, {x, y}, eye, {1, 1});
      }
    CHECK(wrong == 0);
  }
}

// A row of cells behind a post; a flat square, whose diagonal is one step; a raster without cells.
constexpr bool counted_by_hand() {
  irg::image<int> post(5, 1, 0);
  post(1, 0) = 2;
  irg::viewshed_counts behind, flat, none, twice;
  const bool same = irg::viewshed(post, {0, 0}, {}, behind) == irg::viewshed(post, {0, 0});
  (void)irg::viewshed(irg::image<int>(2, 2, 0), {0, 0}, {}, flat);
  (void)irg::viewshed(post, {5, 0}, {}, none);
  (void)irg::viewshed(irg::image<int>(), {0, 0}, {}, none);
  for (int i = 0; i < 2; ++i) (void)irg::viewshed(post, {0, 0}, {}, twice);
  // The lines to cells 2, 3 and 4 end at the post, a step from the eye; 1, 2 and 3 steps are left of them.
  return same && behind == irg::viewshed_counts{5, 3, 4, 6} && flat == irg::viewshed_counts{4, 0, 3, 0} &&
         none == irg::viewshed_counts{} && twice == irg::viewshed_counts{10, 6, 8, 12};
}
static_assert(counted_by_hand());

TEST_CASE("viewshed: counting changes nothing, and adds up to the lengths of all lines") {
  CHECK(counted_by_hand());
  test::random r(11);
  for (int i = 0; i < 100; ++i) {
    irg::image<int> h(static_cast<int>(r.integer(1, 12)), static_cast<int>(r.integer(1, 12)), 0);
    for (int y = 0; y < h.height(); ++y)
      for (int x = 0; x < h.width(); ++x) h(x, y) = static_cast<int>(r.integer(0, 4));
    const cell eye{static_cast<int>(r.integer(0, h.width() - 1)), static_cast<int>(r.integer(0, h.height() - 1))};
    irg::viewshed_counts counts;
    const irg::cell_grid seen = irg::viewshed(h, eye, {1, 1}, counts);
    CHECK(seen == irg::viewshed(h, eye, {1, 1}));
    std::int64_t steps = 0;  // borders, of which those that cross in a corner of the line are one
    for (int y = 0; y < h.height(); ++y)
      for (int x = 0; x < h.width(); ++x) {
        const int dx = x < eye.x ? eye.x - x : x - eye.x, dy = y < eye.y ? eye.y - y : y - eye.y, g = std::gcd(dx, dy);
        steps += dx + dy - (g != 0 && dx / g % 2 != 0 && dy / g % 2 != 0 ? g : 0);
      }
    CHECK(counts.lines == std::int64_t{h.width()} * h.height());
    CHECK(counts.lines - counts.cut_short == seen.count());
    CHECK(counts.steps + counts.passed_over == steps);
  }
}

TEST_CASE("viewshed: heights at the ends of 32 bits") {
  constexpr int most = std::numeric_limits<int>::max(), least = std::numeric_limits<int>::min();
  irg::image<int> h(5, 1, least);
  h(4, 0) = most;
  CHECK(irg::has_line_of_sight(h, {0, 0}, {4, 0}, {most, most}));
  h(1, 0) = most;
  CHECK(!irg::has_line_of_sight(h, {0, 0}, {4, 0}, {0, most}));
}

}  // namespace
