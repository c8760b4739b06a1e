// SPDX-License-Identifier: MIT
#include <irg/raster/line_style.hpp>

#include <vector>

#include <irg/raster/line_bresenham.hpp>

#include "support/check_both.hpp"

namespace {

using irg::cell;

constexpr std::vector<cell> cells(cell a, cell b, irg::line_options options) {
  std::vector<cell> out;
  irg::line_bresenham(a, b, {-20, -20, 20, 20}, [&](cell c) { out.push_back(c); }, options);
  return out;
}

TEST_CASE("line_options: a half-open line leaves its last cell out, and a polyline draws each vertex once") {
  constexpr irg::line_options open{.ends = irg::line_ends::half_open};
  CHECK_BOTH(cells({0, 0}, {3, 1}, open) == std::vector<cell>{{0, 0}, {1, 0}, {2, 1}});
  CHECK_BOTH(cells({0, 0}, {0, 0}, open).empty());
  CHECK_BOTH(cells({5, 5}, {5, 4}, open) == std::vector<cell>{{5, 5}});
}

TEST_CASE("line_options: Fabris's values, symmetric ties give the same cells both ways") {
  constexpr irg::line_options symmetric{.ties = irg::line_ties::symmetric};
  CHECK_BOTH(cells({8, 4}, {0, 0}, symmetric) ==
             std::vector<cell>{{8, 4}, {7, 3}, {6, 3}, {5, 2}, {4, 2}, {3, 1}, {2, 1}, {1, 0}, {0, 0}});
  CHECK_BOTH(cells({0, 0}, {-8, 4}, symmetric) ==
             std::vector<cell>{{0, 0}, {-1, 1}, {-2, 1}, {-3, 2}, {-4, 2}, {-5, 3}, {-6, 3}, {-7, 4}, {-8, 4}});
  CHECK_BOTH(cells({8, 0}, {0, 4}, symmetric) ==
             std::vector<cell>{{8, 0}, {7, 1}, {6, 1}, {5, 2}, {4, 2}, {3, 3}, {2, 3}, {1, 4}, {0, 4}});
}

}  // namespace
