// SPDX-License-Identifier: MIT
#include <irg/visibility/space_portals.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <vector>

#include "support/check_both.hpp"
#include "support/random.hpp"

namespace {

using place = irg::point<double, 3>;
using plan = irg::space_plan<double>;
using irg::space_plan_defect;

// Two cubes side by side, with a square opening between them.
constexpr plan two_cubes() {
  plan p;
  for (const double x : {0.0, 1.0}) {
    p.cells.emplace_back();
    for (int i = 0; i < 8; ++i)
      p.cells.back().push_back({x + (i & 1), static_cast<double>(i >> 1 & 1), static_cast<double>(i >> 2)});
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
  change(p.portals[0]);
  return irg::validate(p).defect;
}

constexpr bool defects() {
  using portal = irg::space_portal<double>;
  constexpr double inf = std::numeric_limits<double>::infinity();
  return changed([](portal&) {}) == space_plan_defect::none &&
         changed([](portal& p) { p.second = 2; }) == space_plan_defect::portal_to_no_cell &&
         changed([](portal& p) { p.second = 0; }) == space_plan_defect::portal_to_itself &&
         changed([](portal& p) { p.ring.resize(2); }) == space_plan_defect::portal_without_area &&
         changed([](portal& p) { p.ring.assign(4, place{1, 0, 0}); }) == space_plan_defect::portal_without_area &&
         changed([](portal& p) { p.ring[3].x = 1.5; }) == space_plan_defect::portal_not_flat &&
         changed([](portal& p) { p.ring[3].x = inf; }) == space_plan_defect::portal_not_flat &&
         changed([](portal& p) { p.ring[2] = {1, 0.375, 0.5}; }) == space_plan_defect::portal_not_convex &&
         changed([](portal& p) { p.first = 1, p.second = 0; }) == space_plan_defect::cell_on_both_sides;
}
TEST_CASE("space_plan: each defect") { CHECK_BOTH(defects()); }

int cells_seen(const plan& p, std::uint32_t cell, const place& eye) {
  int count = 0;
  irg::view_through_portals(p, cell, eye, [&](std::uint32_t) { ++count; });
  return count;
}

TEST_CASE("space portals: an eye in front of a portal, behind it, in its plane") {
  const plan p = two_cubes();
  CHECK(cells_seen(p, 0, {0.5, 0.5, 0.5}) == 2);
  CHECK(cells_seen(p, 1, {1.5, 0.1, 0.9}) == 2);
  CHECK(cells_seen(p, 0, {1, 0.5, 0.5}) == 1);
  CHECK(cells_seen(p, 7, {1, 0.5, 0.5}) == 0);
  CHECK(irg::potentially_visible(p).seen.count() == 4);
  CHECK(irg::potentially_visible(p, {0}).unfinished == 2);
  CHECK(irg::potentially_visible(plan{}).seen.count() == 0);
}

// Each cube of a bent grid as six tetrahedra round a diagonal, some of the faces between them open.
plan tetrahedra(test::random& r, int size, int open_of_ten) {
  std::vector<place> at;
  for (int z = 0; z <= size; ++z)
    for (int y = 0; y <= size; ++y)
      for (int x = 0; x <= size; ++x) {
        const double u = 0.2 * r.unit(), v = 0.2 * r.unit();
        at.push_back({x + u, y + v, z + 0.2 * r.unit()});
      }
  const auto number = [&](int x, int y, int z) {
    return static_cast<std::size_t>((z * (size + 1) + y) * (size + 1) + x);
  };
  std::vector<std::array<std::size_t, 4>> cells;
  for (int z = 0; z < size; ++z)
    for (int y = 0; y < size; ++y)
      for (int x = 0; x < size; ++x) {
        std::array<int, 3> axes{0, 1, 2};
        do {
          std::array<int, 3> c{x, y, z};
          std::array<std::size_t, 4> t{number(x, y, z)};
          for (std::size_t k = 0; k < 3; ++k) {
            ++c[static_cast<std::size_t>(axes[k])];
            t[k + 1] = number(c[0], c[1], c[2]);
          }
          cells.push_back(t);
        } while (std::next_permutation(axes.begin(), axes.end()));
      }
  plan out;
  for (const auto& c : cells) out.cells.push_back({at[c[0]], at[c[1]], at[c[2]], at[c[3]]});
  for (std::uint32_t i = 0; i < cells.size(); ++i)
    for (std::uint32_t k = 0; k < i; ++k) {
      std::vector<std::size_t> common;
      std::size_t other = 0;
      for (const std::size_t v : cells[i])
        if (std::find(cells[k].begin(), cells[k].end(), v) != cells[k].end())
          common.push_back(v);
        else
          other = v;
      if (common.size() != 3 || r.integer(0, 9) >= open_of_ten) continue;
      if (irg::orient3d(at[common[0]], at[common[1]], at[common[2]], at[other]) < 0) std::swap(common[0], common[1]);
      out.portals.push_back({i, k, {at[common[0]], at[common[1]], at[common[2]]}});
    }
  return out;
}

TEST_CASE("space portals: sight lines find no cell that is missing, from cells and from eyes") {
  test::random r(71);
  const int times = std::getenv("IRG_RELEASE_TIER") != nullptr ? 100 : 1;
  int missing = 0, wrong = 0;
  std::int64_t steps = 0;
  for (int i = 0; i < 6 * times; ++i) {
    const plan p = tetrahedra(r, 2, i % 2 == 0 ? 4 : 6);
    wrong += irg::validate(p).defect != space_plan_defect::none;
    const auto sets = irg::potentially_visible(p);
    const irg::detail::space_walk<double> walk(p);
    for (int row = 0; row < static_cast<int>(p.cells.size()); ++row)
      for (int c = 0; c < row; ++c) wrong += sets.seen.is_full({c, row, 0}) != sets.seen.is_full({row, c, 0});
    for (int k = 0; k < 300; ++k) {
      const auto cell = static_cast<std::uint32_t>(r.integer(0, static_cast<std::int64_t>(p.cells.size()) - 1));
      place from{};
      double whole = 0;
      for (const place& v : p.cells[cell]) {
        const double part = 0.05 + r.unit();
        whole += part;
        for (int n = 0; n < 3; ++n) from[n] += part * v[n];
      }
      for (int n = 0; n < 3; ++n) from[n] /= whole;
      const place to{8 * r.unit() - 3, 8 * r.unit() - 3, 8 * r.unit() - 3};
      std::vector<std::uint32_t> seen;
      irg::view_through_portals(p, cell, from, [&](std::uint32_t c) { seen.push_back(c); });
      std::uint32_t at = cell;
      for (bool on = true; on;) {
        on = false;
        for (const auto& d : walk.doors(at)) {
          bool within = irg::orient3d(d.ring[0], d.ring[1], d.ring[2], from) > 0 &&
                        irg::orient3d(d.ring[0], d.ring[1], d.ring[2], to) < 0;
          for (std::size_t n = 0; n < 3; ++n)
            within = within && irg::orient3d(from, to, d.ring[n], d.ring[(n + 1) % 3]) *
                                       irg::orient3d(from, to, d.ring[(n + 1) % 3], d.ring[(n + 2) % 3]) >
                                   0;
          if (!within) continue;
          at = d.to;
          on = true;
          ++steps;
          missing += !sets.seen.is_full({static_cast<int>(at), static_cast<int>(cell), 0});
          missing += std::find(seen.begin(), seen.end(), at) == seen.end();
          break;
        }
      }
    }
  }
  CHECK(wrong == 0);
  CHECK(missing == 0);
  CHECK(steps > 1000 * times);
}

}  // namespace
