// SPDX-License-Identifier: MIT
// What is seen on grids, in the plane and in space.
#include <irg/hidden/faces_around.hpp>
#include <irg/hidden/visible_polygons.hpp>
#include <irg/visibility/cells_from_bsp.hpp>
#include <irg/visibility/cut_source.hpp>
#include <irg/visibility/field_of_view.hpp>
#include <irg/visibility/prepared_walls.hpp>
#include <irg/visibility/sight_in_space.hpp>
#include <irg/visibility/space_portals.hpp>
#include <irg/visibility/textbook/sight_3d.hpp>
#include <irg/visibility/visible_part.hpp>
#include <irg/visibility/weak_visibility.hpp>

#include "hashes.hpp"
#include "support/random.hpp"
#include "support/space_house.hpp"

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

using place = irg::point<double, 2>;
using wall = irg::segment<double, 2>;
constexpr irg::box<double, 2> window{{-5, -5}, {5, 5}};

constexpr place somewhere(test::random& r, bool whole) {
  const auto number = [&] { return whole ? static_cast<double>(r.integer(-4, 4)) : 8 * r.unit() - 4; };
  const double x = number();
  return {x, number()};
}
constexpr std::vector<wall> walls_of(test::random& r, int count, bool whole) {
  std::vector<wall> out;
  for (int k = 0; k < count; ++k) {
    const place a = somewhere(r, whole);
    out.push_back({a, somewhere(r, whole)});
  }
  return out;
}

constexpr std::uint64_t visibility_plane(int rounds) {
  test::random r(43);
  determinism::hasher h;
  const auto add_place = [&](const place& p) {
    h.add(p.x);
    h.add(p.y);
  };
  for (int i = 0; i < rounds; ++i) {
    const std::vector<wall> walls = walls_of(r, rounds == 1 ? 2 : 8, i % 2 == 0);
    const place from = somewhere(r, i % 2 == 0);
    const irg::prepared_walls<double> prepared(walls, window);
    for (const auto& v : prepared.seen_from(from).ring) add_place(v.at);
    if (rounds == 1) continue;
    for (const auto& c : irg::cells_from_bsp(std::span<const wall>(walls), window).plan.cells)
      for (const place& p : c.corners) add_place(p);
    const std::vector<place> lamp{from, {from.x + 1, from.y}, {from.x + 0.3, from.y + 0.3}, {from.x, from.y + 1}};
    const auto cut = irg::cut_source_rounded<double>(lamp, walls);
    const auto parts = irg::weak_visibility(std::span<const place>(cut.ring), cut.obstacles, window);
    for (const auto* list : {&parts.all, &parts.some, &parts.none})
      for (const auto& ring : *list)
        for (const place& p : ring) add_place(p);
  }
  return h.value();
}

constexpr std::uint64_t visibility_space(int rounds) {
  test::random r(44);
  determinism::hasher h;
  for (int i = 0; i < rounds; ++i) {
    irg::mesh<double> m;
    const auto add_triangle = [&] {
      std::vector<std::uint32_t> face;
      for (int k = 0; k < 3; ++k) {
        const place at = somewhere(r, i % 2 == 0);
        face.push_back(static_cast<std::uint32_t>(m.positions.size()));
        m.positions.push_back({at.x, at.y, 2 * r.unit() - 1});
      }
      irg::add_face(m, face);
    };
    for (int k = 0; k < (rounds == 1 ? 1 : 6); ++k) add_triangle();
    irg::space_region<double> eye, floor;
    eye.corners.push_back({0.25, 0.5, 3});
    for (const auto& p : {irg::point<double, 3>{-2, -2, -2}, {2, -2, -2}, {2, 2, -2.5}}) floor.corners.push_back(p);
    h.add(static_cast<int>(irg::sample_sight(eye, floor, m, {rounds == 1 ? 3 : 100, 5}).seen));
    h.add(irg::sample_sight(floor, eye, m, {rounds == 1 ? 3 : 100, 6}).high);
    if (rounds == 1) continue;
    if (i % 20 == 0) {
      const auto house = test::space_house(r, 3, 3, 2).plan;
      const auto sets = irg::potentially_visible(house);
      for (int row = 0; row < sets.seen.extent().height; ++row)
        for (int x = 0; x < sets.seen.extent().width; x += 64) h.add(sets.seen.row(row, 0)[x >> 6]);
      h.add(sets.undecided);
    }
    const auto sure = irg::sure_sight(eye, floor, m);
    h.add(sure ? static_cast<int>(*sure) : 3);
    const auto add_side = [&](std::size_t, const std::vector<irg::screen_face>& faces) {
      for (const auto& ring : irg::visible_polygons(faces, irg::cell_window{0, 0, 256, 256}).rings)
        h.add(static_cast<int>(ring.number + ring.count));
    };
    irg::faces_around(irg::point<double, 3>{0.25, 0.5, 3}, m, add_side, {256, 0.125});
  }
  return h.value();
}

HASHED(visibility_plane, 1, 40);
HASHED(visibility_space, 1, 60);
HASHED(visibility_fields, 1, 200);
HASHED(visibility_percentages, 1, 100);

}  // namespace
