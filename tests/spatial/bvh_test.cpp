// SPDX-License-Identifier: MIT
#include <irg/spatial/bvh.hpp>

#include <cstdlib>
#include <limits>
#include <vector>

#include <doctest/doctest.h>
#include <irg/core/threads.hpp>
#include <irg/spatial/bvh_hits.hpp>

#include "spatial/bvh_boxes.hpp"

namespace {

using box = irg::box<double, 3>;
using boxes_of = std::vector<box>;
constexpr double nan = std::numeric_limits<double>::quiet_NaN(), infinite = std::numeric_limits<double>::infinity();
constexpr irg::bvh_options by_area{}, by_place{irg::bvh_method::morton}, by_cuts{irg::bvh_method::spatial_splits};

template <class T>
irg::bvh build(const std::vector<irg::box<T, 3>>& boxes, const irg::bvh_options& config = {}) {
  return irg::build_bvh(std::span<const irg::box<T, 3>>(boxes), config);
}

// That the tree holds all boxes but `left_out`, each once, in boxes round them.
template <class T>
int check_tree(const irg::bvh& tree, const std::vector<irg::box<T, 3>>& boxes, std::size_t left_out = 0) {
  std::vector<int> seen(boxes.size());
  const int depth = tree.nodes.empty() ? 0 : test::depth_of<T>(tree, std::span<const irg::box<T, 3>>(boxes), seen);
  CHECK(depth >= 0);
  CHECK(static_cast<std::size_t>(std::count(seen.begin(), seen.end(), 1)) == boxes.size() - left_out);
  CHECK(tree.order.size() % 4 == 0);
  return depth;
}

TEST_CASE("build_bvh: none, one to nine, flat ones, equal ones") {
  static_assert([] {
    test::random r(1);
    const boxes_of boxes = test::lattice_boxes<double>(r, 9, 1);
    std::vector<int> seen(9, 0);
    const irg::bvh tree = irg::build_bvh(std::span<const box>(boxes));
    const irg::bvh curve = irg::build_bvh(std::span<const box>(boxes), by_place);
    return test::depth_of<double>(tree, boxes, seen) == 0 && tree.order.size() >= 12 && curve.order.size() >= 12;
  }());
  CHECK(build(boxes_of{}).nodes.empty());
  for (const irg::bvh_options& config : {by_area, by_place}) {
    test::random r(2);
    for (std::size_t n = 1; n < 10; ++n) {
      const boxes_of boxes = test::lattice_boxes<double>(r, n, 0.125);
      const irg::bvh tree = build(boxes, config);
      CHECK(tree.nodes.size() == 1);
      check_tree(tree, boxes);
    }
    const boxes_of equal(std::getenv("IRG_RELEASE_TIER") != nullptr ? 1000000 : 20000, box{{1, 1, 1}, {1, 2, 2}});
    CHECK(check_tree(build(equal, config), equal) < 12);
  }
}

TEST_CASE("build_bvh: boxes that are none are left out") {
  for (const irg::bvh_options& config : {by_area, by_place}) {
    test::random r(3);
    boxes_of boxes = test::lattice_boxes<double>(r, 50, 1);
    boxes[0] = {};
    boxes[7].low.x = nan;
    boxes[8].high.z = nan;
    boxes[20].high.y = infinite;
    boxes[49].low.y = -infinite;
    boxes[30] = {{1, 1, 1}, {2, 0, 2}};
    check_tree(build(boxes, config), boxes, 6);
  }
  CHECK(build(boxes_of(3, box{})).nodes.empty());
}

TEST_CASE("build_bvh: every scale, and depths that stay bounded where sizes do not") {
  for (const irg::bvh_options& config : {by_area, by_place})
    for (const double s : {1.0, 0x1p-1070, 0x1p-1022, 1e-300, 1e300, 0x1p1019}) {
      test::random r(4);
      const boxes_of boxes = test::lattice_boxes<double>(r, 300, s);
      CHECK(check_tree(build(boxes, config), boxes) < 8);
    }
  boxes_of spiral;  // each split by area would leave one
  for (int i = -1000; i < 1000; ++i) {
    const double x = irg::power_of_two(i);
    spiral.push_back({{x, x, x}, {x, x, x}});
  }
  CHECK(check_tree(build(spiral), spiral) < 60);
  std::vector<irg::box<float, 3>> floats;
  test::random r(5);
  floats = test::lattice_boxes<float>(r, 200, 1e-44);
  check_tree(build(floats), floats);
}

TEST_CASE("build_bvh: the same tree for every executor; refit") {
  test::random r(6);
  std::vector<irg::box<float, 3>> boxes = test::lattice_boxes<float>(r, 40000, 0.25, 200);
  for (const irg::bvh_options& config : {by_area, by_place}) {
    irg::bvh tree = build(boxes, config);
    check_tree(tree, boxes);
    CHECK(tree == irg::build_bvh(std::span<const irg::box<float, 3>>(boxes), config, irg::parallel{3}));
    const irg::bvh before = tree;
    irg::refit(tree, std::span<const irg::box<float, 3>>(boxes));
    CHECK(tree == before);
    std::vector<irg::box<float, 3>> moved = boxes;
    for (auto& b : moved) b.low.x += 100, b.high.x += 101, b.low.y *= 3, b.high.y *= 3;
    irg::refit(tree, std::span<const irg::box<float, 3>>(moved));
    check_tree(tree, moved);
    CHECK(tree.order == before.order);
  }
}

std::size_t references(const irg::bvh& tree) {
  return tree.order.size() - static_cast<std::size_t>(std::count(tree.order.begin(), tree.order.end(), irg::no_index));
}

// How many of the boxes' corners and centres lie in no leaf with the box, or come with it more than once.
template <class T>
int uncovered(const irg::bvh& tree, const std::vector<irg::box<T, 3>>& boxes) {
  int wrong = 0;
  for (std::uint32_t i = 0; i < boxes.size(); ++i)
    for (unsigned corner = 0; corner < 9; ++corner) {
      irg::point<T, 3> p;
      for (int axis = 0; axis < 3; ++axis) {
        const T low = boxes[i].low[axis], high = boxes[i].high[axis];
        p[axis] = corner == 8 ? low + (high - low) / 2 : (corner >> axis & 1) != 0 ? high : low;
      }
      int found = 0;
      irg::each_in_box(tree, irg::box<T, 3>{p, p}, [&](std::uint32_t number) { found += number == i ? 1 : 0; });
      wrong += found != 1;
    }
  return wrong;
}

TEST_CASE(
    "build_bvh with spatial splits: parts cover their boxes, within the limit of references, for every executor") {
  static_assert([] {
    const boxes_of boxes(3, box{{0, 0, 0}, {1, 1, 1}});
    return irg::build_bvh(std::span<const box>(boxes), by_cuts).order[2] != irg::no_index;
  }());
  test::random r(7, test::in_every_round{});
  for (const double s : {1.0, 1e-30, 1e30, 0x1p-1060}) {
    boxes_of crossed;  // beams along the axes, each through the boxes of many others
    for (int i = 0; i < 300; ++i) {
      const int along = i % 3;
      box b;
      for (int axis = 0; axis < 3; ++axis) {
        const auto at = static_cast<double>(r.integer(-1000, 1000));
        b.low[axis] = (axis == along ? -1000 : at) * s;
        b.high[axis] = (axis == along ? 1000 : at + static_cast<double>(r.integer(0, 2))) * s;
      }
      crossed.push_back(b);
    }
    for (const float spare : {0.0f, 0.5f, 1.0f, 4.0f, -1.0f}) {
      irg::bvh_options config = by_cuts;
      config.spare = spare;
      irg::bvh tree = build(crossed, config);
      const auto limit = static_cast<std::size_t>(300 * (1 + std::max(spare, 0.0f)));
      CHECK(references(tree) <= limit);
      CHECK(references(tree) >= (spare > 0.0f ? 400 : 300));
      CHECK(tree.earlier.empty() == (references(tree) == 300));
      CHECK(uncovered(tree, crossed) == 0);
      irg::refit(tree, std::span<const box>(crossed));
      CHECK(uncovered(tree, crossed) == 0);
    }
  }
  std::vector<irg::box<float, 3>> many = test::lattice_boxes<float>(r, 20000, 0.25, 200);
  for (std::size_t i = 0; i < many.size(); i += 50) many[i].high.x = many[i].low.x + 60;
  const irg::bvh tree = build(many, by_cuts);
  CHECK(references(tree) > 20400);
  CHECK(uncovered(tree, many) == 0);
  CHECK(tree == irg::build_bvh(std::span<const irg::box<float, 3>>(many), by_cuts, irg::parallel{3}));
  const boxes_of equal(20000, box{{1, 1, 1}, {1, 2, 2}});
  CHECK(references(build(equal, by_cuts)) <= 40000);
  boxes_of broken = test::lattice_boxes<double>(r, 50, 1);
  broken[0] = {};
  broken[7].low.x = nan;
  broken[20].high.y = infinite;
  const irg::bvh rest = build(broken, by_cuts);
  for (const std::uint32_t number : rest.order) CHECK((number != 0 && number != 7 && number != 20));
  CHECK(build(boxes_of(3, box{}), by_cuts).nodes.empty());
}

}  // namespace
