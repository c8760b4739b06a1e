// SPDX-License-Identifier: MIT
#include <irg/mesh/half_edge_mesh.hpp>

#include <algorithm>
#include <vector>

#include <irg/mesh/shapes.hpp>
#include <irg/mesh/to_half_edges.hpp>

#include "support/check_both.hpp"

TEST_CASE("half-edges: round a vertex and round a face, at compile time, too") {
  CHECK_BOTH([] {
    const auto b = irg::to_half_edges(irg::shape_tetrahedron<double>()).value;
    int at_vertices = 0, of_loops = 0, loops = 0;
    for (std::uint32_t v = 0; v < 4; ++v)
      irg::each_half_edge_at(b, v, [&](std::uint32_t h) { at_vertices += b.origin(h) == v ? 1 : 100; });
    for (std::uint32_t f = 0; f < 4; ++f)
      irg::each_loop_of(b, f, [&](std::uint32_t l) {
        ++loops;
        irg::each_half_edge_of(b, l, [&](std::uint32_t h) { of_loops += b.face(h) == f ? 1 : 100; });
      });
    return at_vertices == 12 && of_loops == 12 && loops == 4;
  }());
}

TEST_CASE("half-edges: neighbours of a grid's inner vertex stand counter-clockwise") {
  const auto m = irg::shape_grid<double>({.columns = 2, .rows = 2});
  const auto b = irg::to_half_edges(m).value;
  int inner = 0, beside_border = 0;
  for (std::uint32_t v = 0; v < b.positions.size(); ++v) {
    std::vector<std::uint32_t> round;
    irg::each_half_edge_at(b, v, [&](std::uint32_t h) { round.push_back(h); });
    const bool at_border =
        std::any_of(round.begin(), round.end(), [&](std::uint32_t h) { return b.face(h) == irg::no_index; });
    at_border ? ++beside_border : ++inner;
    for (std::size_t i = 0; i < round.size() && !at_border; ++i) {
      const auto p = b.positions[v], q = b.positions[b.target(round[i])],
                 r = b.positions[b.target(round[i + 1 < round.size() ? i + 1 : 0])];
      CHECK((q.z - p.z) * (r.x - p.x) - (q.x - p.x) * (r.z - p.z) > 0);  // seen from above
    }
  }
  CHECK(inner == 1);
  CHECK(beside_border == 8);
}
