// SPDX-License-Identifier: MIT
#include <irg/spatial/grid_concept.hpp>

#include <limits>

#include "support/check_both.hpp"

namespace {

using irg::cell3;
constexpr int least = std::numeric_limits<int>::min(), most = std::numeric_limits<int>::max();

static_assert(cell3(irg::cell{3, 4}) == cell3{3, 4, 0} && cell3{1, 2, 3}[0] == 1 && cell3{1, 2, 3}[2] == 3);
static_assert(irg::grid_extent{}.empty() && irg::grid_extent{1, 1}.holds({0, 0, 0}) && irg::grid_extent{5, -1}.empty());

static_assert(cell3() == cell3{0, 0, 0} && irg::grid_extent{} == irg::grid_extent{0, 0, 1});
static_assert(!irg::grid_extent{1, 1, 1}.empty() && irg::grid_extent{0, 1, 1}.empty());
static_assert(irg::grid_extent{1, 0, 1}.empty() && irg::grid_extent{1, 1, 0}.empty());

TEST_CASE("grid_extent: the cells it holds") {
  const irg::grid_extent e{2, 3, 4};
  int held = 0;
  for (int z = -1; z < 6; ++z)
    for (int y = -1; y < 6; ++y)
      for (int x = -1; x < 6; ++x) held += e.holds({x, y, z});
  CHECK(held == 24);
  CHECK(!e.holds({least, 0, 0}));
  CHECK(!e.holds({0, most, 0}));
}

}  // namespace
