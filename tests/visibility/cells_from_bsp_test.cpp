// SPDX-License-Identifier: MIT
#include <irg/visibility/cells_from_bsp.hpp>

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <vector>

#include <irg/geometry/point_in_convex_polygon.hpp>
#include <irg/visibility/potentially_visible.hpp>
#include <irg/visibility/sight_line.hpp>

#include "support/check_both.hpp"
#include "support/random.hpp"

namespace {

using place = irg::point<double, 2>;
using wall = irg::segment<double, 2>;

constexpr irg::box<double, 2> window{{-8, -8}, {8, 8}};

constexpr std::size_t cells_of(std::span<const wall> walls) {
  const auto made = irg::cells_from_bsp(walls, window);
  return irg::validate(made.plan).defect == irg::plan_defect::none ? made.plan.cells.size() : 0;
}

constexpr std::size_t of_one_wall() {
  const wall walls[] = {{{0, -4}, {0, 4}}};
  const auto made = irg::cells_from_bsp(std::span<const wall>(walls), window);
  return made.plan.cells.size() * 10 + made.plan.portals.size();  // portals above and below the wall
}

TEST_CASE("cells_from_bsp: walls of a few") {
  CHECK_BOTH(cells_of({}) == 1);
  CHECK_BOTH(of_one_wall() == 22);
  const wall along_the_border[] = {{{-8, -8}, {8, -8}}, {{9, 0}, {10, 3}}, {{1, 1}, {1, 1}}};
  CHECK(cells_of(along_the_border) == 2);  // the line of the wall beside the window divides it
  const wall room[] = {{{-1, -1}, {1, -1}}, {{1, -1}, {1, 1}}, {{1, 1}, {-1, 1}}, {{-1, 1}, {-1, -1}}};
  CHECK(cells_of(room) == 5);
}

double area_of(const irg::cell_plan<double>& plan) {
  double sum = 0;
  for (const auto& c : plan.cells)
    for (std::size_t i = 0; i < c.corners.size(); ++i) {
      const place &a = c.corners[i], &b = c.corners[(i + 1) % c.corners.size()];
      sum += (a.x * b.y - a.y * b.x) / 2;
    }
  return sum;
}

std::optional<std::uint32_t> cell_at(const irg::cell_plan<double>& plan, const place& p) {
  std::optional<std::uint32_t> found;
  for (std::uint32_t c = 0; c < plan.cells.size(); ++c)
    if (irg::point_in_convex_polygon(plan.cells[c].corners, p) == irg::location::inside) {
      if (found) return std::nullopt;  // where rounded cells overlap
      found = c;
    }
  return found;
}

std::vector<wall> random_walls(test::random& r, int kind) {
  std::vector<wall> out;
  const auto n = r.integer(0, 12);
  for (int i = 0; i < n; ++i) {
    const auto number = [&] {
      return kind == 0 ? static_cast<double>(r.integer(-7, 7)) : kind == 1 ? 14 * r.unit() - 7 : 20 * r.unit() - 10;
    };
    const place a{number(), number()}, b{number(), number()};
    if (kind == 2 && i % 2 == 0)
      out.push_back({{a.x, a.y}, {b.x, a.y}});
    else
      out.push_back({a, b});
  }
  return out;
}

TEST_CASE("cells_from_bsp: plans without defects that make up the window, and whose sets hold what sight lines see") {
  test::random r(22);
  const int times = std::getenv("IRG_RELEASE_TIER") != nullptr ? 30 : 1;
  int wrong = 0, missing = 0, seen = 0, cut = 0;
  for (int i = 0; i < 150 * times; ++i) {
    const std::vector<wall> walls = random_walls(r, i % 3);
    const auto made = irg::cells_from_bsp(std::span<const wall>(walls), window);
    wrong += irg::validate(made.plan).defect != irg::plan_defect::none;
    wrong += std::fabs(area_of(made.plan) - 256) > 1e-9;
    wrong += made.left_out != 0;
    cut += made.cut != 0;
    const auto sets = irg::potentially_visible(made.plan);
    for (int k = 0; k < 40; ++k) {
      const place p{16 * r.unit() - 8, 16 * r.unit() - 8}, q{16 * r.unit() - 8, 16 * r.unit() - 8};
      const auto from = cell_at(made.plan, p), to = cell_at(made.plan, q);
      if (!from || !to || !irg::has_line_of_sight(p, q, walls)) continue;
      ++seen;
      missing += !sets.seen.is_full({static_cast<int>(*to), static_cast<int>(*from), 0});
    }
  }
  CHECK(wrong == 0);
  CHECK(missing == 0);
  CHECK(seen > 1000);
  CHECK(cut > 0);
}

TEST_CASE("cells_from_bsp: walls of all sizes side by side") {
  test::random r(23);
  int wrong = 0;
  for (int i = 0; i < 40; ++i) {
    std::vector<wall> walls;
    for (int k = 0; k < 8; ++k) {
      const auto number = [&] { return std::ldexp(r.unit() - 0.5, static_cast<int>(r.integer(-300, 3))); };
      const place a{number(), number()}, b{number(), number()};
      walls.push_back({a, b});
    }
    const auto made = irg::cells_from_bsp(std::span<const wall>(walls), window);
    wrong += irg::validate(made.plan).defect != irg::plan_defect::none;
  }
  CHECK(wrong == 0);
}

}  // namespace
