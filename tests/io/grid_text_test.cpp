// SPDX-License-Identifier: MIT
#include <irg/io/grid_text.hpp>

#include <string>
#include <string_view>
#include <utility>

#include "support/check_both.hpp"
#include "support/sight_oracle.hpp"

namespace {

using irg::cell3;

static_assert([] {
  const auto r = irg::read_grid("3 2 1 # a map\n..#\n#..\n0 0\n2 1 0 # a unit\nwall 0 0 0 x+ closed-door\n");
  return r && r->grid.is_full({2, 0, 0}) && r->grid.is_full({0, 1, 0}) && r->grid.cells().count() == 2 &&
         r->units.size() == 2 && r->units[1] == cell3{2, 1, 0} && r->grid.has_wall({0, 0, 0}, 0) &&
         r->grid.wall({0, 0, 0}, 0) == irg::wall_kind::closed_door;
}());

void refused(std::string_view text, std::size_t line, std::size_t column, std::string_view part) {
  const auto r = irg::read_grid(text);
  REQUIRE(!r);
  CAPTURE(text);
  CHECK(r.error().line == line);
  CHECK(r.error().column == column);
  CHECK(std::string_view(r.error().message).find(part) != std::string_view::npos);
}

TEST_CASE("read_grid: comments stand between the parts, and rows may begin with #") {
  const auto r = irg::read_grid(
      "# first\n 2\n 2 # height\n2\n# the layers\n\n##\n#.\n\n  # second layer\n..\n.#\n# units\n1 1 0\n\n");
  REQUIRE(r);
  CHECK(r->grid.cells().count() == 4);
  CHECK(r->grid.is_full({1, 1, 1}));
  CHECK(r->units.size() == 1);
  CHECK(irg::read_grid("1 1 1\r\n.\r\n0 0\r\n"));
  CHECK(irg::read_grid("1 1 1\n#"));
  CHECK(irg::read_grid("\xEF\xBB\xBF 1 1 1\n."));  // a byte order mark
}

TEST_CASE("read_grid: what is wrong, and where") {
  refused("", 1, 1, "width");
  refused("3 x 1", 1, 3, "width");
  refused("\xEF\xBB\xBF 3 x 1", 1, 4, "width");
  refused("0 1 1\n\n", 1, 1, "from 1");
  refused("2147483648 1 1", 1, 1, "from 1");
  refused("1 1", 1, 4, "width");
  refused("1 1 1 1\n.", 1, 7, "nothing more");
  refused("2147483647 2147483647 2147483647\n.", 2, 2, "missing");
  refused("2 2 1\n..\n", 3, 1, "missing");
  refused("2 3 1\n....\n..\n", 2, 3, "as many");
  refused("4 2 1\n....\n...\n....\n", 3, 4, "as many");
  refused("2 1 1\n.?\n", 2, 2, "neither");
  refused("2 1 1\n..\n2 0\n", 3, 1, "outside");
  refused("2 1 1\n..\n0 -1\n", 3, 1, "outside");
  refused("2 1 1\n..\n0 0 1\n", 3, 1, "outside");
  refused("2 1 1\n.#\n 1 0\n", 3, 2, "full");
  refused("2 1 1\n..\n0\n", 3, 2, "coordinate");
  refused("2 1 1\n..\n0 99999999999\n", 3, 3, "coordinate");
  refused("2 1 1\n..\n0 0 0 0\n", 3, 7, "nothing more");
  refused("2 1 1\n..\nwall 0 0 0 x- wall\n", 3, 12, "side");
  refused("2 1 1\n..\nwall 0 0 0 x+ door\n", 3, 15, "kind");
  refused("2 1 1\n..\nwall 0 0 0 x+ none\n", 3, 15, "kind");
  refused("2 1 1\n..\nwall 0 5 0 x+ wall\n", 3, 6, "outside");
  refused("2 1 1\n..\nwall 0 0 x+ wall\n", 3, 10, "coordinate");
  refused("2 1 1\n..\nfloor\n", 3, 1, "coordinate");
}

TEST_CASE("read_grid: what encode_grid wrote") {
  test::random r(3);
  for (int i = 0; i < 100; ++i) {
    const irg::walled_grid g = test::random_map(
        r, {static_cast<int>(r.integer(1, 70)), static_cast<int>(r.integer(1, 5)), 1 + i % 3}, 40, i % 2 * 10);
    std::vector<cell3> units;
    if (!g.is_full({0, 0, 0})) units.push_back({0, 0, 0});
    const auto back = irg::read_grid(irg::encode_grid(g, units));
    REQUIRE(back);
    CHECK(back->grid.cells() == g.cells());
    CHECK(back->units == units);
    for (int axis = 0; axis < 3; ++axis) CHECK(back->grid.wall({0, 0, 0}, axis) == g.wall({0, 0, 0}, axis));
  }
}

TEST_CASE("read_grid: each side and kind of a wall by its name") {
  const std::string_view sides[] = {"x+", "y+", "z+"};
  const std::pair<std::string_view, irg::wall_kind> kinds[] = {{"wall", irg::wall_kind::wall},
                                                               {"half", irg::wall_kind::half_wall},
                                                               {"open-door", irg::wall_kind::open_door},
                                                               {"closed-door", irg::wall_kind::closed_door},
                                                               {"laser", irg::wall_kind::laser_field}};
  for (int axis = 0; axis < 3; ++axis)
    for (const auto& [name, kind] : kinds) {
      const std::string text =
          "2 2 2\n..\n..\n..\n..\nwall 0 1 0 " + std::string(sides[axis]) + ' ' + std::string(name) + '\n';
      const auto map = irg::read_grid(text);
      REQUIRE(map.has_value());
      for (int other = 0; other < 3; ++other)
        CHECK(map->grid.wall({0, 1, 0}, other) == (other == axis ? kind : irg::wall_kind::none));
    }
}

}  // namespace
