// SPDX-License-Identifier: MIT
// What holds in every boundary representation, whatever operators have made of it.
#pragma once

#include <cstdint>
#include <vector>

#include <irg/mesh/half_edge_mesh.hpp>

namespace test {

/// Whether half-edges, loops, faces and vertices agree with each other.
template <class T>
constexpr bool is_sound(const irg::half_edge_mesh<T>& b) {
  constexpr std::uint32_t none = irg::no_index;
  std::vector<std::uint32_t> leaving(b.positions.size(), 0);
  for (std::uint32_t h = 0; h < b.half_edges.size(); ++h) {
    const irg::half_edge& e = b.half_edges[h];
    if (e.origin == none) continue;
    if (e.origin >= b.positions.size() || b.half_edges[b.twin(h)].origin == none) return false;
    if (b.half_edges[e.next].previous != h || b.half_edges[e.previous].next != h) return false;
    if (b.half_edges[e.next].loop != e.loop || b.origin(e.next) != b.target(h)) return false;
    if (e.loop != none && (b.loops[e.loop].face == none || b.loops[e.loop].first == none)) return false;
    ++leaving[e.origin];
  }
  for (std::uint32_t v = 0; v < b.positions.size(); ++v) {
    std::uint32_t met = 0;
    bool own = true;
    irg::each_half_edge_at(b, v, [&](std::uint32_t h) {
      ++met;
      own = own && b.origin(h) == v;
    });
    if (met != leaving[v] || !own) return false;
  }
  std::uint32_t loops = 0, listed = 0, lone = 0;
  for (std::uint32_t l = 0; l < b.loops.size(); ++l) {
    if (b.loops[l].face == none) continue;
    ++loops;
    lone += b.loops[l].first == none ? 1u : 0u;
    bool own = true;
    irg::each_half_edge_of(b, l, [&](std::uint32_t h) { own = own && b.half_edges[h].loop == l; });
    if (!own) return false;
  }
  if (lone != b.lone_vertices.size()) return false;
  for (const irg::lone_vertex& v : b.lone_vertices)
    if (b.loops[v.loop].first != none || b.half_edge_at[v.vertex] != none) return false;
  for (std::uint32_t f = 0; f < b.faces.size(); ++f) {
    if (b.faces[f] == none) continue;
    bool own = true;
    irg::each_loop_of(b, f, [&](std::uint32_t l) {
      ++listed;
      own = own && b.loops[l].face == f;
    });
    if (!own) return false;
  }
  return loops == listed;
}

}  // namespace test
