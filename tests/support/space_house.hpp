// SPDX-License-Identifier: MIT
// Buildings of convex cells in space, none of whose walls is along an axis.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include <irg/visibility/space_plan.hpp>

#include "random.hpp"

namespace test {

// Rooms in storeys with roofs like pyramids, joined by doors, windows and hatches of three, four and six corners; all of
// it sheared. All coordinates are few binary digits.
class space_house {
public:
  using place = irg::point<double, 3>;
  irg::space_plan<double> plan;

  space_house(random& r, int wide, int deep, int storeys) : r_(r), wide_(wide), deep_(deep) {
    for (int z = 0; z <= storeys; ++z)
      for (int y = 0; y < deep; ++y)
        for (int x = 0; x < wide; ++x) add_cell(x, y, z, z == storeys);
    for (int z = 0; z <= storeys; ++z)
      for (int y = 0; y < deep; ++y)
        for (int x = 0; x < wide; ++x) {
          if (z < storeys && x > 0 && r.integer(0, 9) < 7) open(0, {x, y, z}, number(x - 1, y, z));
          if (z < storeys && y > 0 && r.integer(0, 9) < 7) open(1, {x, y, z}, number(x, y - 1, z));
          if (z > 0 && r.integer(0, 9) < 4) open(2, {x, y, z}, number(x, y, z - 1));
        }
  }

private:
  random& r_;
  int wide_, deep_;

  static place sheared(double x, double y, double z) { return {x + z / 4, y - z / 4 + x / 2, z + y / 4}; }
  std::uint32_t number(int x, int y, int z) const { return static_cast<std::uint32_t>((z * deep_ + y) * wide_ + x); }

  void add_cell(int x, int y, int z, bool is_roof) {
    auto& corners = plan.cells.emplace_back();
    for (int i = 0; i < (is_roof ? 4 : 8); ++i)
      corners.push_back(sheared(8 * (x + (i & 1)), 8 * (y + (i >> 1 & 1)), 8 * (z + (i >> 2))));
    if (is_roof) {
      corners.push_back(sheared(8 * x + 4, 8 * y + 4, 8 * z + 4));
      plan.faces.push_back({{0, 2, 3, 1}, {0, 1, 4}, {1, 3, 4}, {3, 2, 4}, {2, 0, 4}});
    } else {
      plan.faces.push_back({{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {1, 3, 7, 5}, {3, 2, 6, 7}, {2, 0, 4, 6}});
    }
  }

  // An opening between a cell and the one before it along an axis.
  void open(int axis, const std::array<int, 3>& cell, std::uint32_t before) {
    const auto some = [&](int least, int most) { return static_cast<double>(r_.integer(least, most)); };
    const double a = some(0, 4), b = some(0, 4), w = some(2, 4), h = some(2, 4);
    std::vector<std::array<double, 2>> shape{{a, b}, {a + w, b}, {a + w, b + h}, {a, b + h}};
    const auto corners = r_.integer(0, 2);
    if (corners == 0) shape.pop_back();
    if (corners == 1) shape = {{a, b + 1}, {a + 1, b}, {a + w, b}, {a + w, b + h - 1}, {a + w - 1, b + h}, {a, b + h}};
    std::vector<place> ring;
    for (const auto& [s, t] : shape) {
      std::array<double, 3> v{8.0 * cell[0], 8.0 * cell[1], 8.0 * cell[2]};
      v[static_cast<std::size_t>(axis + 1) % 3] += s;
      v[static_cast<std::size_t>(axis + 2) % 3] += t;
      ring.push_back(sheared(v[0], v[1], v[2]));
    }
    const std::uint32_t here = number(cell[0], cell[1], cell[2]);
    if (!irg::are_on_side<double>(ring, plan.cells[before], 1)) std::reverse(ring.begin(), ring.end());
    plan.portals.push_back({before, here, ring});
  }
};

}  // namespace test
