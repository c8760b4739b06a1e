// SPDX-License-Identifier: MIT
// Facts about meshes that tests compare with, found from the faces alone.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <utility>

#include <irg/core/mesh_concept.hpp>

namespace test {

/// The mesh without its normals.
template <class T>
constexpr irg::mesh<T> without_normals(irg::mesh<T> m) {
  m.normals.clear();
  for (irg::mesh_corner& c : m.corners) c.normal = irg::no_index;
  return m;
}

struct mesh_facts {
  std::size_t vertices = 0;         // positions that a face uses
  std::size_t border_edges = 0;     // directed edges without their opposite
  std::size_t repeated_edges = 0;   // directed edges used by two faces: the orientation is inconsistent there
  std::size_t looped_edges = 0;     // from a vertex to itself
  long euler = 0;                   // vertices - edges + faces
  double volume = 0;                // positive when closed and counter-clockwise from outside
};

template <class M>
mesh_facts facts_of(const M& m) {
  using traits = irg::mesh_traits<M>;
  mesh_facts facts;
  std::map<std::pair<std::size_t, std::size_t>, int> edges;
  std::set<std::size_t> used;
  for (std::size_t f = 0; f < traits::face_count(m); ++f) {
    const std::size_t n = traits::face_size(m, f);
    for (std::size_t k = 0; k < n; ++k) {
      const std::size_t a = traits::face_vertex(m, f, k), b = traits::face_vertex(m, f, (k + 1) % n);
      used.insert(a);
      facts.looped_edges += a == b ? 1u : 0u;
      facts.repeated_edges += edges[{a, b}]++ > 0 ? 1u : 0u;
    }
    const auto p = traits::position(m, traits::face_vertex(m, f, 0));
    for (std::size_t k = 2; k < n; ++k) {
      const auto q = traits::position(m, traits::face_vertex(m, f, k - 1)),
                 r = traits::position(m, traits::face_vertex(m, f, k));
      const auto c = [](const auto& v, int i) { return static_cast<double>(irg::coordinate(v, i)); };
      facts.volume +=
          (c(p, 0) * (c(q, 1) * c(r, 2) - c(q, 2) * c(r, 1)) + c(p, 1) * (c(q, 2) * c(r, 0) - c(q, 0) * c(r, 2)) +
           c(p, 2) * (c(q, 0) * c(r, 1) - c(q, 1) * c(r, 0))) /
          6;
    }
  }
  std::size_t undirected = 0;
  for (const auto& [edge, count] : edges) {
    const bool has_opposite = edges.count({edge.second, edge.first}) > 0;
    facts.border_edges += has_opposite ? 0u : 1u;
    undirected += !has_opposite || edge.first < edge.second ? 1u : 0u;
  }
  facts.vertices = used.size();
  facts.euler =
      static_cast<long>(used.size()) - static_cast<long>(undirected) + static_cast<long>(traits::face_count(m));
  return facts;
}

template <class M>
bool is_closed(const M& m) {
  const mesh_facts f = facts_of(m);
  return f.border_edges == 0 && f.repeated_edges == 0 && f.looped_edges == 0;
}

}  // namespace test
