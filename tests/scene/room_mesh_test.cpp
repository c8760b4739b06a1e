// SPDX-License-Identifier: MIT
#include <irg/scene/room_mesh.hpp>

#include <array>
#include <map>

#include <irg/mesh/triangulate.hpp>
#include <irg/mesh/validate.hpp>

#include "support/check_both.hpp"
#include "support/house_plans.hpp"

namespace {

using plan = irg::cell_plan<double>;
using at = irg::point<double, 2>;

constexpr plan two_rooms() {
  return {{{{at{0, 0}, at{4, 0}, at{4, 3}, at{0, 3}}, 0.0, 3.0}, {{at{4, 0}, at{8, 0}, at{8, 3}, at{4, 3}}, 1.0, 4.0}},
          {{0, 1, at{4, 1}, at{4, 2}}}};
}

TEST_CASE("room_mesh: a room with a step and a lintel beyond") {
  // The side with the door has two walls, and below the door one more: the sill is 1 high. Floor and ceiling besides.
  CHECK_BOTH(irg::room_mesh(two_rooms(), irg::portal_graph(two_rooms()), 0).face_count() == 8);
  CHECK_BOTH(irg::room_mesh(two_rooms(), irg::portal_graph(two_rooms()), 1).face_count() == 8);
  CHECK_BOTH([] {
    plan p = two_rooms();
    p.cells[1].floor = 3, p.cells[1].ceiling = 4;  // no height in common: the wall is whole
    return irg::room_mesh(p, irg::portal_graph(p), 0).face_count() == 8;
  }());
}

TEST_CASE("room_mesh: all rooms of a house are one closed surface") {
  test::random r(31);
  for (int i = 0; i < 10; ++i) {
    plan p = test::random_house<double>(r, 100, 5);
    for (auto& c : p.cells) {
      c.floor = static_cast<double>(r.integer(0, 3));
      c.ceiling = c.floor + static_cast<double>(r.integer(1, 4));
    }
    for (auto& d : p.portals) {  // no two doors end at one point
      const double u = 0.125 * static_cast<double>(r.integer(1, 3));
      const at a = d.a, b = d.b;
      d.a = {a.x + u * (b.x - a.x), a.y + u * (b.y - a.y)};
      d.b = {b.x + u * (a.x - b.x), b.y + u * (a.y - b.y)};
    }
    REQUIRE(irg::validate(p) == irg::plan_finding{});
    const irg::portal_graph<double> g(p);
    using place = std::array<double, 3>;
    std::map<std::pair<place, place>, int> edges;
    for (std::uint32_t c = 0; c < g.cell_count(); ++c) {
      const irg::mesh<double> room = irg::room_mesh(p, g, c);
      REQUIRE(irg::validate(room).defect == irg::mesh_defect::none);
      for (std::size_t f = 0; f < room.face_count(); ++f)
        for (std::size_t k = 0; k < room.face_size(f); ++k) {
          const auto& u = room.positions[room.corner(f, k).position];
          const auto& v = room.positions[room.corner(f, (k + 1) % room.face_size(f)).position];
          const place from{u.x, u.y, u.z}, to{v.x, v.y, v.z};
          ++edges[{from, to}];
          --edges[{to, from}];
        }
    }
    int open = 0;
    for (const auto& [edge, count] : edges) open += count != 0;
    CHECK(open == 0);
  }
}

}  // namespace
