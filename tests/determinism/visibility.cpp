// SPDX-License-Identifier: MIT
// What is seen on grids.
#include <irg/visibility/field_of_view.hpp>
#include <irg/visibility/textbook/sight_3d.hpp>
#include <irg/visibility/visible_part.hpp>

#include "hashes.hpp"
#include "support/random.hpp"

namespace {

constexpr void add(determinism::hasher& h, const irg::cell_grid& cells) {
  cells.for_each([&](const irg::cell3& c) { h.add(c.x + 100 * (c.y + 100 * c.z)); });
}

// A map of the size with one full cell of eight and a few walls; the viewer's cell is empty.
constexpr irg::walled_grid map_of(test::random& r, const irg::grid_extent& e, const irg::cell3& viewer) {
  irg::walled_grid g(e);
  const auto somewhere = [&] {
    const int x = static_cast<int>(r.integer(0, e.width - 1)), y = static_cast<int>(r.integer(0, e.height - 1));
    return irg::cell3{x, y, static_cast<int>(r.integer(0, e.depth - 1))};
  };
  for (int i = 0; i < e.width * e.height * e.depth / 8; ++i) g.set(somewhere());
  for (int i = 0; i < 4; ++i) {
    const irg::cell3 c = somewhere();
    g.set_wall(c, static_cast<int>(r.integer(0, 1)), irg::wall_kind::wall);
  }
  g.set(viewer, false);
  return g;
}

constexpr std::uint64_t visibility_fields(int rounds) {
  test::random r(41);
  determinism::hasher h;
  for (int i = 0; i < rounds; ++i) {
    const irg::grid_extent e{rounds == 1 ? 7 : 40, rounds == 1 ? 6 : 30, i % 3 == 2 ? 4 : 1};
    const irg::cell3 viewer{i % e.width, i % e.height, 0};
    const irg::walled_grid g = map_of(r, e, viewer);
    irg::view_options o;
    o.rules.corners = static_cast<irg::corner_rule>(i % 3);
    add(h, irg::field_of_view(g, viewer, o));
    for (int k = 0; k < 20; ++k) {
      const irg::cell3 c{static_cast<int>(r.integer(0, e.width - 1)), static_cast<int>(r.integer(0, e.height - 1)), 0};
      h.add(static_cast<int>(irg::textbook::sight_3d(g, viewer, c)));
    }
  }
  return h.value();
}

constexpr std::uint64_t visibility_percentages(int rounds) {
  test::random r(42);
  determinism::hasher h;
  for (int i = 0; i < rounds; ++i) {
    const irg::grid_extent e{rounds == 1 ? 5 : 21, rounds == 1 ? 4 : 20, 1};
    const irg::cell viewer{i % e.width, i % e.height};
    for (const double percent : irg::visible_percentages(map_of(r, e, viewer), viewer)) h.add(percent);
  }
  return h.value();
}

HASHED(visibility_fields, 1, 200);
HASHED(visibility_percentages, 1, 100);

}  // namespace
