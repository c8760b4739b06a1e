// SPDX-License-Identifier: MIT
#include <irg/visibility/visible_part.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

#include "support/check_both.hpp"
#include "support/sight_oracle.hpp"

namespace {

using irg::cell;

static_assert([] {
  irg::cell_grid g(irg::grid_extent{3, 1, 1});
  g.set(cell{1, 0});
  const auto p = irg::visible_percentages(g, cell{0, 0});
  return p[0] == 100 && p[1] == 100 && p[2] == 0;
}());

// Between two neighbouring directions to corners of the map nothing changes: a ray amid them tells of all of them.
double percent_by_rays(const irg::walled_grid& g, cell viewer, cell target) {
  if (viewer == target) return 100;
  const irg::grid_extent e = g.extent();
  const double dx = target.x - viewer.x, dy = target.y - viewer.y, middle = std::atan2(dy, dx);
  const auto relative = [&](double x, double y) {
    return std::remainder(std::atan2(y, x) - middle, 2 * std::acos(-1.0));
  };
  double low = 4, high = -4;
  for (double i : {-0.5, 0.5})
    for (double j : {-0.5, 0.5})
      low = std::min(low, relative(dx + i, dy + j)), high = std::max(high, relative(dx + i, dy + j));
  std::vector<double> angles{low, high};
  for (int y = 0; y <= e.height; ++y)
    for (int x = 0; x <= e.width; ++x)
      if (const double a = relative(x - 0.5 - viewer.x, y - 0.5 - viewer.y); a > low && a < high) angles.push_back(a);
  std::sort(angles.begin(), angles.end());
  double free = 0;
  for (std::size_t k = 1; k < angles.size(); ++k) {
    if (angles[k] - angles[k - 1] < 1e-12) continue;
    const double a = middle + (0.6 * angles[k] + 0.4 * angles[k - 1]), c = std::cos(a), s = std::sin(a);
    cell at = viewer;
    bool clear = true;
    while (clear && !(at == target)) {
      const double tx = (at.x - viewer.x + (c > 0 ? 0.5 : -0.5)) / c, ty = (at.y - viewer.y + (s > 0 ? 0.5 : -0.5)) / s;
      const int axis = tx < ty ? 0 : 1;
      cell next = at;
      (axis == 0 ? next.x : next.y) += (axis == 0 ? c : s) > 0 ? 1 : -1;
      const cell lower = axis == 0 ? (next.x < at.x ? next : at) : (next.y < at.y ? next : at);
      clear = e.holds(next) && !g.has_wall(lower, axis) && (next == target || !g.is_full(next));
      at = next;
    }
    if (clear) free += angles[k] - angles[k - 1];
  }
  return 100 * free / (high - low);
}

TEST_CASE("visible_percentages: rays between the corners") {
  test::random r(7);
  for (int i = 0; i < 150; ++i) {
    const irg::grid_extent e{static_cast<int>(r.integer(1, 9)), static_cast<int>(r.integer(1, 9)), 1};
    const irg::walled_grid g =
        test::random_map(r, e, static_cast<int>(r.integer(0, 30)), static_cast<int>(r.integer(0, 1) * 8));
    const cell viewer{static_cast<int>(r.integer(0, e.width - 1)), static_cast<int>(r.integer(0, e.height - 1))};
    const std::vector<double> percent = irg::visible_percentages(g, viewer);
    const irg::cell_grid any = irg::field_of_view_permissive(g, viewer),
                         all = irg::field_of_view_restrictive(g, viewer);
    double worst = 0;
    int wrong = 0;
    for (int y = 0; y < e.height; ++y)
      for (int x = 0; x < e.width; ++x) {
        const double p = percent[static_cast<std::size_t>(y * e.width + x)], q = percent_by_rays(g, viewer, {x, y});
        worst = std::max(worst, std::abs(p - q));
        wrong += any.is_full(cell{x, y}) != (q > 1e-9) || all.is_full(cell{x, y}) != (q > 100 - 1e-9);
      }
    CHECK(worst < 1e-9);
    CHECK(wrong == 0);
  }
  CHECK(irg::visible_percentages(irg::cell_grid(irg::grid_extent{3, 3, 1}), cell{3, 0}).empty());
}

}  // namespace
