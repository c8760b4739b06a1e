// SPDX-License-Identifier: MIT
#include <irg/visibility/space_plan.hpp>

#include <array>
#include <limits>

#include "support/check_both.hpp"
#include "support/space_house.hpp"

namespace {

using place = irg::point<double, 3>;
using plan = irg::space_plan<double>;
using portal = irg::space_portal<double>;
using irg::space_plan_defect;

// Two cubes side by side, with a square opening between them.
constexpr plan two_cubes() {
  plan p;
  for (const double x : {0.0, 1.0}) {
    p.cells.emplace_back();
    for (int i = 0; i < 8; ++i)
      p.cells.back().push_back({x + (i & 1), static_cast<double>(i >> 1 & 1), static_cast<double>(i >> 2)});
    p.faces.push_back({{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {1, 3, 7, 5}, {3, 2, 6, 7}, {2, 0, 4, 6}});
  }
  p.portals.emplace_back();
  p.portals[0].second = 1;
  for (const auto& [y, z] : {std::array{0.25, 0.25}, {0.25, 0.75}, {0.75, 0.75}, {0.75, 0.25}})
    p.portals[0].ring.push_back({1, y, z});
  return p;
}

template <class Change>
constexpr space_plan_defect changed(const Change& change) {
  plan p = two_cubes();
  change(p);
  return irg::validate(p).defect;
}
template <class Change>
constexpr space_plan_defect changed_portal(const Change& change) {
  return changed([&](plan& p) { change(p.portals[0]); });
}

constexpr double inf = std::numeric_limits<double>::infinity();

TEST_CASE("space_plan: each defect") {
  using enum space_plan_defect;
  CHECK_BOTH(changed_portal([](portal&) {}) == none);
  CHECK_BOTH(changed_portal([](portal& p) { p.second = 2; }) == portal_to_no_cell);
  CHECK_BOTH(changed_portal([](portal& p) { p.second = 0; }) == portal_to_itself);
  CHECK_BOTH(changed_portal([](portal& p) { p.ring.resize(2); }) == portal_without_area);
  CHECK_BOTH(changed_portal([](portal& p) { p.ring.assign(4, place{1, 0, 0}); }) == portal_without_area);
  CHECK_BOTH(changed_portal([](portal& p) { p.ring[3].x = 1.5; }) == portal_not_flat);
  CHECK_BOTH(changed_portal([](portal& p) { p.ring[3].x = inf; }) == portal_not_flat);
  CHECK_BOTH(changed_portal([](portal& p) { p.ring[2] = {1, 0.375, 0.5}; }) == portal_not_convex);
  CHECK_BOTH(changed_portal([](portal& p) { p.first = 1, p.second = 0; }) == cell_on_both_sides);
  CHECK_BOTH(changed_portal([](portal& p) { p.ring[2].y = p.ring[3].y = 1.5; }) == portal_off_the_wall);
  CHECK_BOTH(changed([](plan& p) { p.faces.clear(); }) == none);
  CHECK_BOTH(changed([](plan& p) { p.cells[1][7].z = -inf; }) == corner_not_finite);
  CHECK_BOTH(changed([](plan& p) { p.faces[0][0].resize(2); }) == face_without_area);
  CHECK_BOTH(changed([](plan& p) { p.faces[0][0][0] = 8; }) == face_without_area);
  CHECK_BOTH(changed([](plan& p) { p.cells[0][7].z = 2; }) == face_not_flat);
  CHECK_BOTH(changed([](plan& p) { p.faces[0][0] = {0, 3, 2, 1}; }) == face_not_convex);
  CHECK_BOTH(changed([](plan& p) { p.faces[0][0] = {0, 1, 3, 2}; }) == cell_not_convex);
  CHECK_BOTH(changed([](plan& p) { p.faces[0].pop_back(); }) == cell_not_closed);
  CHECK_BOTH(changed([](plan& p) { p.faces[0].push_back(p.faces[0][0]); }) == cell_not_closed);
  CHECK_BOTH(changed([](plan& p) { p.cells[0].resize(3), p.faces[0] = {{0, 1, 2}, {0, 2, 1}}; }) ==
             cell_without_volume);
  plan p = two_cubes();
  p.faces[1][4] = {0, 2, 3, 1};
  CHECK(irg::validate(p) == irg::space_plan_finding{space_plan_defect::cell_not_closed, 0, 1, 0});
  p.faces[1][4] = {7, 6, 2, 3};
  p.faces[1][2] = {0, 1};
  CHECK(irg::validate(p) == irg::space_plan_finding{space_plan_defect::face_without_area, 0, 1, 2});
}

TEST_CASE("space_plan: houses have none") {
  test::random r(3);
  for (int i = 0; i < 20; ++i)
    CHECK(irg::validate(test::space_house(r, 3, 2, 1 + i % 3).plan) == irg::space_plan_finding{});
}

TEST_CASE("are_on_side: before, behind and in the plane of a ring") {
  constexpr std::array<place, 3> ring{place{0, 0, 0}, place{1, 0, 0}, place{0, 1, 0}};
  constexpr std::array<place, 2> above{place{5, 5, 1}, place{5, 5, 0}}, through{place{0, 0, 1}, place{0, 0, -1}};
  CHECK_BOTH(irg::are_on_side<double>(ring, above, irg::orient3d(ring[0], ring[1], ring[2], above[0])));
  CHECK_BOTH(!irg::are_on_side<double>(ring, above, -irg::orient3d(ring[0], ring[1], ring[2], above[0])));
  CHECK_BOTH(!irg::are_on_side<double>(ring, through, 1));
  CHECK_BOTH(!irg::are_on_side<double>(ring, through, -1));
  CHECK_BOTH(irg::are_on_side<double>(ring, ring, 1));
  CHECK_BOTH(irg::are_on_side<double>(ring, ring, -1));
  // For the side from which the ring is seen counter-clockwise, that is 1.
  CHECK_BOTH(irg::are_on_side<double>(ring, above, 1));
}

}  // namespace
