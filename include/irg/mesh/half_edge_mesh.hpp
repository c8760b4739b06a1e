// SPDX-License-Identifier: MIT
// half_edge_mesh<T>: the boundary representation. Every edge is two half-edges that run back along each other; loops of
// half-edges bound faces, and what is next to what is one step away.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <irg/core/vocabulary.hpp>
#include <irg/core/contract.hpp>
#include <irg/mesh/mesh.hpp>

namespace irg {

/// One of the two sides of an edge, in the direction in which its loop runs.
struct half_edge {
  [[deprecated("irg: no_index")]] static constexpr std::uint32_t none = no_index;
  std::uint32_t origin = no_index;  // the vertex that it leaves
  std::uint32_t next = no_index, previous = no_index;  // in its loop
  std::uint32_t loop = no_index;  // none beside the border of an open surface
  bool operator==(const half_edge&) const = default;
};

/// A closed walk that bounds a face: the outer one, or a ring round a hole.
struct half_edge_loop {
  std::uint32_t first = no_index;  // one of its half-edges; none for a loop that is a lone vertex
  std::uint32_t face = no_index;  // none when the loop is no more
  std::uint32_t next = no_index;  // the face's next ring
  bool operator==(const half_edge_loop&) const = default;
};

/// A loop without half-edges: one vertex in a face.
struct lone_vertex {
  std::uint32_t loop = no_index, vertex = no_index;
  bool operator==(const lone_vertex&) const = default;
};

/// What a corner has besides its position: indices into normals and texcoords.
struct half_edge_attributes {
  std::uint32_t normal = no_index, texcoord = no_index;
  bool operator==(const half_edge_attributes&) const = default;
};

/// Vertices, edges, loops and faces, each known by its number. Half-edges 2e and 2e + 1 are the sides of edge e.
/// shape   elements that Euler operators have removed keep their numbers, and stand as none until they are made again:
///         half_edges with origin none, half_edge_at with gone, loops without a face, faces without a loop (0xffffffff)
template <Scalar T>
struct half_edge_mesh {
  [[deprecated("irg: no_index")]] static constexpr std::uint32_t none = no_index;
  static constexpr std::uint32_t gone = no_index - 1;

  std::vector<point<T, 3>> positions;
  std::vector<std::uint32_t> half_edge_at;  // for each vertex one that leaves it, or none
  std::vector<half_edge> half_edges;
  std::vector<half_edge_loop> loops;
  std::vector<std::uint32_t> faces;  // for each its outer loop; none when the face is no more
  std::vector<lone_vertex> lone_vertices;
  std::vector<vec<T, 3>> normals;
  std::vector<vec<T, 2>> texcoords;
  std::vector<half_edge_attributes> attributes;  // of each half-edge, where the mesh has any
  std::vector<mesh_part> parts;  // of their faces the names only, since faces come and go
  std::vector<std::uint32_t> face_parts;  // for each face its entry of parts, where there are any

  IRG_INLINE static constexpr std::uint32_t twin(std::uint32_t h) noexcept { return h ^ 1u; }
  [[nodiscard]] IRG_INLINE constexpr std::uint32_t next(std::uint32_t h) const noexcept { return half_edges[h].next; }
  [[nodiscard]] IRG_INLINE constexpr std::uint32_t previous(std::uint32_t h) const noexcept {
    return half_edges[h].previous;
  }
  [[nodiscard]] IRG_INLINE constexpr std::uint32_t origin(std::uint32_t h) const noexcept {
    return half_edges[h].origin;
  }
  [[nodiscard]] IRG_INLINE constexpr std::uint32_t target(std::uint32_t h) const noexcept {
    return half_edges[twin(h)].origin;
  }
  /// The face to the left of h, seen from outside; none beside a border.
  [[nodiscard]] IRG_INLINE constexpr std::uint32_t face(std::uint32_t h) const noexcept {
    return half_edges[h].loop == no_index ? no_index : loops[half_edges[h].loop].face;
  }
  /// The next half-edge that leaves the same vertex, counter-clockwise seen from outside.
  [[nodiscard]] IRG_INLINE constexpr std::uint32_t next_around(std::uint32_t h) const noexcept {
    return twin(half_edges[h].previous);
  }
  bool operator==(const half_edge_mesh&) const = default;
};

inline namespace IRG_ABI {

/// Calls use(h) for every half-edge that leaves vertex v, counter-clockwise seen from outside.
/// needs   v < positions.size()
/// cost    one step each; nothing allocated
template <Scalar T, class Use>
IRG_INLINE constexpr void each_half_edge_at(const half_edge_mesh<T>& b, std::uint32_t v, const Use& use) {
  const std::uint32_t first = b.half_edge_at[v];
  if (first >= half_edge_mesh<T>::gone) return;
  std::uint32_t h = first;
  do {
    use(h);
    h = b.next_around(h);
  } while (h != first);
}

/// Calls use(h) for every half-edge of a loop, in its direction, from its first one.
/// needs   a loop of b that is still there
template <Scalar T, class Use>
IRG_INLINE constexpr void each_half_edge_of(const half_edge_mesh<T>& b, std::uint32_t loop, const Use& use) {
  const std::uint32_t first = b.loops[loop].first;
  if (first == no_index) return;
  std::uint32_t h = first;
  do {
    use(h);
    h = b.next(h);
  } while (h != first);
}

/// Calls use(l) for every loop of a face, the outer one first.
/// needs   a face of b that is still there
template <Scalar T, class Use>
IRG_INLINE constexpr void each_loop_of(const half_edge_mesh<T>& b, std::uint32_t face, const Use& use) {
  for (std::uint32_t l = b.faces[face]; l != no_index; l = b.loops[l].next) use(l);
}

}  // namespace IRG_ABI
}  // namespace irg
