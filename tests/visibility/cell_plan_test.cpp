// SPDX-License-Identifier: MIT
#include <irg/visibility/cell_plan.hpp>

#include <limits>

#include "support/check_both.hpp"
#include "support/house_plans.hpp"

namespace {

using irg::plan_defect;
using plan = irg::cell_plan<double>;
using at = irg::point<double, 2>;

constexpr plan two_rooms() {
  return {{{{at{0, 0}, at{4, 0}, at{4, 3}, at{0, 3}}, 0.0, 3.0}, {{at{4, 0}, at{8, 0}, at{8, 3}, at{4, 3}}, 0.0, 3.0}},
          {{0, 1, at{4, 1}, at{4, 2}}}};
}

// What a change to the two rooms is judged as.
template <class Change>
constexpr irg::plan_finding changed(const Change& change) {
  plan p = two_rooms();
  change(p);
  return irg::validate(p);
}
constexpr irg::plan_finding portal(const at& a, const at& b) {
  return changed([&](plan& p) { p.portals[0] = {0, 1, a, b}; });
}
constexpr irg::plan_finding corner(std::size_t i, const at& to) {
  return changed([&](plan& p) { p.cells[1].corners[i] = to; });
}

TEST_CASE("cell_plan: each defect") {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  CHECK_BOTH(irg::validate(two_rooms()) == irg::plan_finding{});
  CHECK_BOTH(irg::validate(plan{}) == irg::plan_finding{});
  CHECK_BOTH(changed([](plan& p) { p.cells[1].corners.resize(2, at{}); }) ==
             irg::plan_finding{plan_defect::short_cell, 1, 1});
  CHECK_BOTH(corner(1, {infinity, 0}).defect == plan_defect::corner_not_finite);
  CHECK_BOTH(corner(2, {5, 1}).defect == plan_defect::cell_not_convex);
  CHECK_BOTH(corner(2, {4, 0}).defect != plan_defect::none);
  CHECK_BOTH(changed([](plan& p) { std::swap(p.cells[1].corners[1], p.cells[1].corners[3]); }).defect ==
             plan_defect::cell_not_counter_clockwise);
  CHECK_BOTH(changed([](plan& p) { p.cells[0].corners = {{0, 0}, {1, 1}, {2, 2}}; }).defect ==
             plan_defect::cell_not_counter_clockwise);
  CHECK_BOTH(changed([](plan& p) { p.cells[1].ceiling = 0; }) ==
             irg::plan_finding{plan_defect::heights_not_in_order, 1, 1});
  CHECK_BOTH(changed([](plan& p) { p.cells[1].ceiling = infinity; }).defect == plan_defect::heights_not_in_order);
  CHECK_BOTH(changed([](plan& p) { p.portals[0].second = 2; }).defect == plan_defect::portal_to_no_cell);
  CHECK_BOTH(changed([](plan& p) { p.portals[0].second = 0; }).defect == plan_defect::portal_to_itself);
  CHECK_BOTH(portal({4, 1}, {4, infinity}).defect == plan_defect::portal_not_finite);
  CHECK_BOTH(portal({4, 1}, {4, 1}).defect == plan_defect::portal_without_length);
  CHECK_BOTH(portal({4, 2}, {4, 4}).defect == plan_defect::portal_off_the_wall);
  CHECK_BOTH(portal({4, 1}, {4 + 0x1p-50, 2}).defect == plan_defect::portal_off_the_wall);
  CHECK_BOTH(portal({4, 2}, {4, 1}) == irg::plan_finding{});
  CHECK_BOTH(portal({4, 0}, {4, 3}) == irg::plan_finding{});
  CHECK_BOTH(changed([](plan& p) { p.cells[1] = p.cells[0]; }) ==
             irg::plan_finding{plan_defect::portal_on_one_side, 0, 0});
  CHECK_BOTH(changed([](plan& p) { p.portals.push_back({1, 0, at{4, 3}, at{4, 1.5}}); }) ==
             irg::plan_finding{plan_defect::portals_overlap, 1, 0});
  CHECK_BOTH(changed([](plan& p) { p.portals.push_back({1, 0, at{4, 3}, at{4, 2}}); }) == irg::plan_finding{});
}

TEST_CASE("cell_plan: corners within a wall, and a portal over one of them") {
  CHECK_BOTH(changed([](plan& p) { p.cells[0].corners = {{0, 0}, {4, 0}, {4, 1.5}, {4, 1.5}, {4, 3}, {0, 3}}; }) ==
             irg::plan_finding{});
}

TEST_CASE("cell_plan: whichever corner of a cell is listed first") {
  for (std::size_t first = 0; first < 4; ++first)
    for (std::size_t second = 0; second < 4; ++second)
      for (const bool upwards : {false, true}) {
        plan p = two_rooms();
        std::ranges::rotate(p.cells[0].corners, p.cells[0].corners.begin() + static_cast<std::ptrdiff_t>(first));
        std::ranges::rotate(p.cells[1].corners, p.cells[1].corners.begin() + static_cast<std::ptrdiff_t>(second));
        p.portals[0].a.y = upwards ? 1 : 2, p.portals[0].b.y = upwards ? 2 : 1;
        CHECK(irg::validate(p) == irg::plan_finding{});
        const irg::portal_graph<double> g(p);
        REQUIRE((g.doors(0).size() == 1 && g.doors(1).size() == 1));
        CHECK((g.doors(0)[0].right == at{4, 1} && g.doors(1)[0].right == at{4, 2}));
        p.portals[0].a.y = upwards ? -1 : 4;
        CHECK(irg::validate(p) == irg::plan_finding{plan_defect::portal_off_the_wall, 0, 0});
      }
}

TEST_CASE("cell_plan: sizes from 1e-300 to 1e300") {
  for (const double scale : {1e-300, 1e-150, 1e-3, 1e150, 1e300}) {
    plan p = two_rooms();
    for (auto& c : p.cells)
      for (at& corner : c.corners) corner = {corner.x * scale, corner.y * scale};
    for (at* end : {&p.portals[0].a, &p.portals[0].b}) *end = {end->x * scale, end->y * scale};
    CHECK(irg::validate(p) == irg::plan_finding{});
    p.portals[0].a.x = std::nextafter(p.portals[0].a.x, 0.0);
    CHECK(irg::validate(p).defect == plan_defect::portal_off_the_wall);
  }
}

TEST_CASE("portal_graph: each portal is passed both ways, its left end on the left") {
  test::random r(3);
  const plan house = test::random_house<double>(r, 100, 5);
  REQUIRE(irg::validate(house) == irg::plan_finding{});
  const irg::portal_graph<double> g(house);
  REQUIRE(g.cell_count() == house.cells.size());
  std::size_t doors = 0;
  for (std::uint32_t c = 0; c < g.cell_count(); ++c)
    for (const irg::doorway<double>& d : g.doors(c)) {
      ++doors;
      const auto& p = house.portals[d.portal];
      CHECK((p.first == c ? p.second : p.first) == d.to);
      at middle{};
      for (const at& corner : house.cells[c].corners) middle = {middle.x + corner.x / 4, middle.y + corner.y / 4};
      CHECK(irg::orient2d(middle, d.right, d.left) > 0);
    }
  CHECK(doors == 2 * house.portals.size());
}

}  // namespace
