// SPDX-License-Identifier: MIT
#include <irg/visibility/textbook/sight_3d.hpp>

#include <initializer_list>
#include <utility>
#include <vector>

#include "support/check_both.hpp"
#include "support/sight_oracle.hpp"

namespace {

using irg::cell3;
using irg::textbook::sight_3d;
using irg::textbook::three_axis_rule;
using list = std::vector<cell3>;

list one_pass(const cell3& a, const cell3& b) {
  list out;
  irg::textbook::sight_cells_one_pass(a, b, [&](const cell3& c) { out.push_back(c); });
  return out;
}
constexpr irg::cell_grid map(std::initializer_list<cell3> full) {
  irg::cell_grid g(irg::grid_extent{5, 5, 5});
  for (const cell3& c : full) g.set(c);
  return g;
}
static_assert(!sight_3d(map({{1, 0, 0}, {0, 0, 1}}), {0, 0, 0}, {1, 0, 1}));
static_assert(sight_3d(map({{1, 0, 0}}), {0, 0, 0}, {1, 0, 1}));

TEST_CASE("one pass: the lists") {
  CHECK(one_pass({0, 0, 0}, {8, 0, 4}) ==
        list{{0, 0, 0}, {1, 0, 0}, {2, 0, 1}, {3, 0, 1}, {4, 0, 2}, {5, 0, 2}, {6, 0, 3}, {7, 0, 3}, {8, 0, 4}});
  CHECK(one_pass({0, 0, 0}, {8, 8, 4}) ==
        list{{0, 0, 0}, {1, 1, 0}, {2, 2, 1}, {3, 3, 1}, {4, 4, 2}, {5, 5, 2}, {6, 6, 3}, {7, 7, 3}, {8, 8, 4}});
  CHECK(one_pass({0, 0, 0}, {8, 6, 5}) ==
        list{{0, 0, 0}, {1, 1, 1}, {2, 1, 1}, {3, 2, 2}, {4, 3, 2}, {5, 4, 3}, {6, 4, 4}, {7, 5, 4}, {8, 6, 5}});
  CHECK(one_pass({0, 0, 0}, {3, 4, 5}) == list{{0, 0, 0}, {1, 1, 1}, {1, 2, 2}, {2, 2, 3}, {2, 3, 4}, {3, 4, 5}});
  CHECK(one_pass({0, 0, 0}, {2, 1, 7}) ==
        list{{0, 0, 0}, {0, 0, 1}, {1, 0, 2}, {1, 0, 3}, {1, 1, 4}, {1, 1, 5}, {2, 1, 6}, {2, 1, 7}});
  CHECK(one_pass({0, 0, 0}, {0, 0, 3}) == list{{0, 0, 0}, {0, 0, 1}, {0, 0, 2}, {0, 0, 3}});
  CHECK(one_pass({0, 0, 0}, {-4, 2, 1}) == list{{0, 0, 0}, {-1, 1, 0}, {-2, 1, 1}, {-3, 2, 1}, {-4, 2, 1}});
  CHECK(one_pass({3, 2, 2}, {0, 0, 0}) == list{{3, 2, 2}, {2, 1, 1}, {1, 1, 1}, {0, 0, 0}});
}

TEST_CASE("two nested passes: where they differ from one") {
  using irg::textbook::sight_cells_nested;
  CHECK(sight_cells_nested({0, 0, 0}, {3, 4, 5}) ==
        list{{0, 0, 0}, {1, 1, 1}, {1, 2, 2}, {1, 2, 3}, {2, 3, 4}, {3, 4, 5}});
  CHECK(sight_cells_nested({0, 0, 0}, {2, 1, 7}) ==
        list{{0, 0, 0}, {0, 0, 1}, {1, 0, 2}, {1, 0, 3}, {1, 0, 4}, {1, 0, 5}, {2, 1, 6}, {2, 1, 7}});
  list differing;
  for (int x = 0; x < 7; ++x)
    for (int y = 0; y < 7; ++y)
      for (int z = 0; z < 7; ++z)
        if (one_pass({0, 0, 0}, {x, y, z}) != sight_cells_nested({0, 0, 0}, {x, y, z})) {
          differing.push_back({x, y, z});
          CHECK(z > std::max(x, y));
        }
  REQUIRE(differing.size() >= 4);
  CHECK(list(differing.begin(), differing.begin() + 4) == list{{1, 2, 3}, {1, 2, 4}, {1, 2, 5}, {1, 2, 6}});
}

TEST_CASE("both lists are the same both ways, and connected") {
  test::random r(3);
  const auto any = [&] {
    return cell3{static_cast<int>(r.integer(-6, 6)), static_cast<int>(r.integer(-6, 6)),
                 static_cast<int>(r.integer(-6, 6))};
  };
  for (int i = 0; i < 3000; ++i) {
    const cell3 a = any(), b = any();
    for (const auto& [there, back] :
         {std::pair{one_pass(a, b), one_pass(b, a)},
          std::pair{irg::textbook::sight_cells_nested(a, b), irg::textbook::sight_cells_nested(b, a)}}) {
      CHECK(there == list(back.rbegin(), back.rend()));
      CHECK(there.front() == a);
      CHECK(there.back() == b);
      for (std::size_t k = 1; k < there.size(); ++k)
        for (int axis = 0; axis < 3; ++axis) CHECK(std::abs(there[k][axis] - there[k - 1][axis]) <= 1);
    }
  }
}

TEST_CASE("as printed, the height misses the target") {
  const auto last = [](const cell3& b) {
    double z = 0;
    irg::textbook::sight_heights_as_printed({0, 0, 0}, b, [&](double height) { z = height; });
    return z;
  };
  CHECK(last({8, 0, 4}) == 4);
  CHECK(last({8, 8, 4}) == 3);
  CHECK(last({8, 6, 5}) == 4);
  CHECK(last({3, 4, 5}) == 4);
  CHECK(last({2, 1, 7}) == doctest::Approx(6.261).epsilon(0.0001));
  CHECK(last({0, 0, 3}) == 0);
}

TEST_CASE("three axes: 64 sets, ten blocked by the printed two, eighteen by all five") {
  int thesis = 0, all = 0;
  for (unsigned m = 0; m < 64; ++m) {
    irg::cell_grid g(irg::grid_extent{2, 2, 2});
    unsigned blocked = 0;
    for (unsigned i = 0; i < 6; ++i)
      if ((m >> i & 1) != 0) {
        const unsigned s = i + 1;
        blocked |= 1u << s;
        g.set({static_cast<int>(s & 1), static_cast<int>(s >> 1 & 1), static_cast<int>(s >> 2)});
      }
    const bool by_path = irg::textbook::three_axis_blocked(blocked, three_axis_rule::face_path);
    const bool by_thesis = irg::textbook::three_axis_blocked(blocked, three_axis_rule::thesis);
    CHECK(by_path == !test::way_exists(g, {0, 0, 0}, {1, 1, 1}, 7, 0, 1));
    CHECK((by_path || !by_thesis));
    thesis += by_thesis, all += by_path;
  }
  CHECK(thesis == 10);
  CHECK(all == 18);
}

TEST_CASE("verdicts") {
  const auto seen = [](std::initializer_list<cell3> full, cell3 b) {
    const auto g = map(full);
    const bool t = sight_3d(g, {0, 0, 0}, b), f = sight_3d(g, {0, 0, 0}, b, three_axis_rule::face_path);
    CHECK(sight_3d(g, b, {0, 0, 0}) == t);
    CHECK(sight_3d(g, b, {0, 0, 0}, three_axis_rule::face_path) == f);
    return std::pair{t, f};
  };
  CHECK(seen({}, {2, 0, 2}) == std::pair{true, true});
  CHECK(seen({{1, 0, 0}}, {1, 0, 1}) == std::pair{true, true});
  CHECK(seen({{1, 0, 0}, {0, 0, 1}}, {1, 0, 1}) == std::pair{false, false});
  CHECK(seen({{1, 0, 0}, {1, 0, 1}, {0, 1, 0}, {0, 1, 1}}, {1, 1, 1}) == std::pair{false, false});
  CHECK(seen({{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {1, 1, 1}) == std::pair{false, false});
  CHECK(seen({{1, 1, 0}, {1, 0, 1}, {0, 1, 1}}, {1, 1, 1}) == std::pair{true, false});
  CHECK(seen({{1, 0, 0}, {1, 1, 0}, {0, 0, 1}, {0, 1, 1}}, {1, 1, 1}) == std::pair{true, false});
  CHECK(seen({{1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0, 1, 1}}, {1, 1, 1}) == std::pair{true, true});
  CHECK(seen({{2, 1, 0}}, {4, 2, 1}) == std::pair{false, false});
  CHECK(seen({{0, 0, 2}}, {0, 0, 3}) == std::pair{false, false});
  CHECK(seen({}, {0, 0, 3}) == std::pair{true, true});
  // Where z = 0 at both ends, the test in the plane sees the cells that are crossed in part.
  CHECK(seen({{1, 1, 0}}, {4, 2, 0}) == std::pair{false, false});
}

TEST_CASE("walls stand at z = 0 and count for steps that touch it") {
  irg::walled_grid g(irg::grid_extent{3, 3, 3});
  g.set_wall({0, 0, 0}, 0, irg::wall_kind::wall);
  g.set({0, 0, 1});
  CHECK(!sight_3d(g, {0, 0, 0}, {1, 0, 1}));
  g.set({0, 0, 1}, false);
  CHECK(sight_3d(g, {0, 0, 0}, {1, 0, 1}));
  g.set_wall({0, 0, 1}, 0, irg::wall_kind::wall);
  CHECK(sight_3d(g, {0, 0, 1}, {1, 0, 1}));
}

}  // namespace
