// SPDX-License-Identifier: MIT
#include <irg/visibility/textbook/sight_steps.hpp>

#include <algorithm>
#include <vector>

#include <doctest/doctest.h>

namespace {

using irg::cell;
using irg::textbook::passage;
using irg::textbook::sight_step;

constexpr std::vector<sight_step> steps(cell a, cell b) {
  std::vector<sight_step> out;
  irg::textbook::sight_steps(a, b, [&](const sight_step& s) { return out.push_back(s), true; });
  return out;
}
std::vector<cell> cells(cell a, cell b) {
  std::vector<cell> out{steps(a, b)[0].at};
  for (const sight_step& s : steps(a, b)) out.push_back(s.next);
  return out;
}
std::vector<cell> thirds(cell a, cell b) {
  std::vector<cell> out;
  for (const sight_step& s : steps(a, b)) {
    if (s.through == passage::ahead) out.push_back(s.ahead);
    if (s.through == passage::aside) out.push_back(s.aside);
  }
  return out;
}

static_assert(steps({0, 0}, {3, 1}).size() == 3 && steps({0, 0}, {0, 0}).empty());

TEST_CASE("table 3: in canonical direction both orders have the same cells, and (3,2) blocks neither") {
  const std::vector<cell> table{{0, 0}, {1, 0}, {2, 1}, {3, 1}, {4, 2}, {5, 2}, {6, 3}, {7, 3}, {8, 4}};
  CHECK(cells({0, 0}, {8, 4}) == table);
  CHECK(cells({8, 4}, {0, 0}) == table);
  CHECK(std::find(table.begin(), table.end(), cell{3, 2}) == table.end());
  CHECK(cells({-8, 4}, {0, 0}) ==
        std::vector<cell>{{-8, 4}, {-7, 4}, {-6, 3}, {-5, 3}, {-4, 2}, {-3, 2}, {-2, 1}, {-1, 1}, {0, 0}});
  CHECK(cells({0, 4}, {8, 0}) ==
        std::vector<cell>{{0, 4}, {1, 4}, {2, 3}, {3, 3}, {4, 2}, {5, 2}, {6, 1}, {7, 1}, {8, 0}});
}

TEST_CASE("table 4: D against half the slope") {
  const auto s = steps({0, 0}, {3, 2});  // distances are over 2 n = 6, the slope is 2/3
  REQUIRE(s.size() == 3);
  CHECK(s[0].at == cell{0, 0});
  CHECK(s[0].distance == 1);  // 1/6
  CHECK(s[0].through == passage::ahead);
  CHECK(s[1].at == cell{1, 1});
  CHECK(s[1].distance == -1);  // -1/6
  CHECK(s[1].through == passage::none);
  CHECK(s[2].at == cell{2, 1});
  CHECK(s[2].distance == 3);  // 1/2
  CHECK(s[2].through == passage::aside);
  CHECK(thirds({0, 0}, {3, 2}) == std::vector<cell>{{1, 0}, {2, 2}});
}

TEST_CASE("partial crossings: figure 23 and others") {
  CHECK(thirds({0, 0}, {8, 4}) == std::vector<cell>{{1, 1}, {3, 2}, {5, 3}, {7, 4}});
  CHECK(thirds({0, 0}, {5, 2}) == std::vector<cell>{{1, 1}, {4, 1}});
  CHECK(thirds({0, 0}, {2, 5}) == std::vector<cell>{{1, 1}, {1, 4}});
  CHECK(thirds({0, 0}, {-5, 2}) == std::vector<cell>{{-4, 1}, {-1, 1}});
  CHECK(thirds({0, 0}, {8, 1}) == std::vector<cell>{{4, 1}});
  CHECK(steps({0, 0}, {3, 1})[1].through == passage::corner);
}

}  // namespace
