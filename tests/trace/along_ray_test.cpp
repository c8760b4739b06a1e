// SPDX-License-Identifier: MIT
#include <irg/trace/along_ray.hpp>

#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

#include <doctest/doctest.h>

#include "support/random.hpp"

namespace {

using P = irg::point<double, 3>;
using R = irg::ray<double, 3>;
using triangle = std::array<P, 3>;
constexpr double infinite = std::numeric_limits<double>::infinity();

// Large triangles across z at these heights.
std::vector<triangle> sheets(const std::vector<double>& heights) {
  std::vector<triangle> all;
  for (const double z : heights) all.push_back({{{-9, -9, z}, {9, -9, z}, {0, 9, z}}});
  return all;
}

irg::triangle_bvh<double> tree_of(const std::vector<triangle>& all) {
  return irg::triangle_bvh<double>(std::span<const triangle>(all));
}

TEST_CASE("sorted_hits: by time, then by number") {
  const auto all = sheets({3, 1, 2, 1, -1});
  const auto tree = tree_of(all);
  std::vector<std::uint32_t> numbers;
  for (const auto& h : irg::sorted_hits(tree, R{{0, 0, 0}, {0, 0, 1}})) numbers.push_back(h.triangle);
  CHECK(numbers == std::vector<std::uint32_t>{1, 3, 2, 0});
  CHECK(irg::sorted_hits(tree, R{{0, 0, 0}, {0, 0, 0}}).empty());
}

TEST_CASE("is_visible: past sheets, from and to them, along them") {
  const auto all = sheets({1, 2});
  const auto tree = tree_of(all);
  const auto see = [&](const P& p, const P& q) {
    const auto corners = [&](std::uint32_t i) { return all[i]; };
    CHECK(irg::has_line_of_sight(tree, corners, p, q) == irg::has_line_of_sight(tree, corners, q, p));
    return irg::has_line_of_sight(tree, corners, p, q);
  };
  CHECK(see({0, 0, 0}, {1, 1, 0.5}));
  CHECK(!see({0, 0, 0}, {1, 1, 1.5}));
  CHECK(see({0, 0, 0}, {1, 1, 1}));      // it stands on the sheet
  CHECK(!see({0, 0, 0}, {1, 1, 2}));     // the other one is between
  CHECK(see({0, 0, 1}, {1, 1, 2}));
  CHECK(see({0, 0, 1}, {3, 1, 1}));
  CHECK(see({0, 0, 5}, {0, 0, 5}));
  CHECK(see({0, 50, 0}, {0, 50, 9}));
  CHECK(!see({0, 0, 0}, {0, infinite, 1}));
  CHECK(see({-1.5e308, 0, 5}, {1.5e308, 0, 5}));  // apart by more than the largest number
  CHECK(!see({0, 0, -1.5e308}, {0, 0, 1.5e308}));
  CHECK(see({0, 50, -1.5e308}, {0, 50, 1.5e308}));
}

TEST_CASE("visible_steps: whole steps before the first crossing") {
  const auto tree = tree_of(sheets({2}));
  const R up{{0, 0, 0}, {0, 0, 1}};
  CHECK(irg::visible_steps(tree, up, 0.5) == 4);
  CHECK(irg::visible_steps(tree, up, 0.3) == 6);
  CHECK(irg::visible_steps(tree, up, 3) == 0);
  CHECK(irg::visible_steps(tree, R{{0, 0, 0}, {0, 0, 1}, 1, infinite}, 0.25) == 4);
  CHECK(irg::visible_steps(tree, R{{0, 0, 0}, {0, 0, -1}, 0, 10}, 0.25) == 40);
  CHECK(irg::visible_steps(tree, R{{0, 0, 0}, {0, 0, -1}}, 1) == std::int64_t{1} << 53);
  CHECK(irg::visible_steps(tree, up, 0) == 0);
  CHECK(irg::visible_steps(tree, up, -1) == 0);
  CHECK(irg::visible_steps(tree, R{{0, 0, 0}, {0, 0, 0}}, 1) == 0);
}

TEST_CASE("visible_steps: no step ends behind the crossing, by however little") {
  const R up{{0, 0, 0}, {0, 0, 1}};
  CHECK(irg::visible_steps(tree_of(sheets({1})), up, 0.1) == 9);  // the double 0.1 is more than a tenth
  CHECK(irg::visible_steps(tree_of(sheets({1})), up, infinite) == 0);
  test::random r(72);
  for (int i = 0; i < 300; ++i) {
    const auto n = r.integer(1, 1000);
    const double height = r.unit() + 0.5, step = height / static_cast<double>(n);
    const auto tree = tree_of(sheets({height}));
    const auto steps = irg::visible_steps(tree, up, step);
    const double t = irg::closest_hit(tree, up)->at.t;
    CHECK(std::fma(static_cast<double>(steps), step, -t) <= 0);
    CHECK(std::fma(static_cast<double>(steps + 1), step, -t) > 0);
  }
}

TEST_CASE("longest_free_run: against all gaps of random sheets") {
  test::random r(71);
  for (int i = 0; i < 50; ++i) {
    std::vector<double> heights;
    for (int k = 0; k < i % 8; ++k) heights.push_back(static_cast<double>(r.integer(1, 31)) * 0.25);
    const auto run = irg::longest_free_run(tree_of(sheets(heights)), R{{0, 0, 0}, {0, 0, 1}, 0, 8}, 0.5);
    heights.push_back(0);
    heights.push_back(8);
    std::sort(heights.begin(), heights.end());
    double longest = 0, from = 0;
    for (std::size_t k = 1; k < heights.size(); ++k)
      if (heights[k] - heights[k - 1] > longest) longest = heights[k] - heights[k - 1], from = heights[k - 1];
    CHECK(run == irg::free_run{from, from + longest, static_cast<std::int64_t>(longest / 0.5)});
  }
  CHECK(irg::longest_free_run(tree_of({}), R{{0, 0, 0}, {0, 0, 0}}, 1) == irg::free_run{});
}

}  // namespace
