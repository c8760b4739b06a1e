// SPDX-License-Identifier: MIT
// From an indexed mesh to half-edges. The two sides of an edge find each other in a short list at one of its vertices:
// nothing is hashed or sorted.
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include <irg/core/vocabulary.hpp>
#include <irg/mesh/half_edge_mesh.hpp>

namespace irg {

/// How a mesh became half-edges.
enum class [[nodiscard]] half_edge_status {
  ok,
  corner_repeated,  ///< a face names one vertex twice in a row
  edge_of_many_faces,  ///< three or more faces have an edge in common, or a face runs along an edge twice
  faces_turned_apart,  ///< two faces run along their common edge in the same direction
  vertex_of_many_fans,  ///< the faces round a vertex are no single fan
  done [[deprecated("irg: done is now ok")]] = ok
};

namespace detail::inline IRG_ABI {

// Makes half-edges of one face after another. An edge waits for its second face in the list of its lower vertex. Where
// that takes long it begins anew, by that of its vertices that has fewer edges: on a surface of low genus such lists
// are short, wherever edges are many.
template <Scalar T>
class half_edge_builder {
public:
  half_edge_mesh<T> made;
  half_edge_status status = half_edge_status::ok;

  constexpr explicit half_edge_builder(const mesh<T>& m) {
    made.positions = m.positions;
    made.half_edge_at.assign(m.positions.size(), no_index);
    made.half_edges.reserve(m.corners.size());
    made.loops.reserve(m.face_count());
    made.faces.reserve(m.face_count());
    next_in_list_.reserve(m.corners.size() / 2);
    list_of_.assign(m.positions.size(), no_index);
    most_steps_ = 8 * m.corners.size() + 64;
    const bool has_attributes = !m.normals.empty() || !m.texcoords.empty();
    for (std::uint32_t f = 0; f < m.face_count(); ++f) {
      const mesh_corner* corners = m.corners.data() + m.face_starts[f];
      const auto n = static_cast<std::uint32_t>(m.face_size(f));
      add_loop(corners, n, f);
      if (is_slow()) {  // many edges at one vertex: from the beginning
        degree_.assign(m.positions.size(), 0);
        for (const mesh_corner& c : m.corners) ++degree_[c.position];
        list_of_.assign(m.positions.size(), no_index);
        next_in_list_.clear(), made.half_edges.clear(), made.loops.clear(), made.faces.clear();
        made.attributes.clear();
        f = no_index;  // 0 comes next
        continue;
      }
      if (status != half_edge_status::ok) return;
      if (has_attributes) add_attributes(corners, n, f);
    }
    if (has_attributes) made.attributes.resize(made.half_edges.size(), half_edge_attributes{});
    link_border();
    if (!has_single_fans()) status = half_edge_status::vertex_of_many_fans;
  }

private:
  IRG_INLINE constexpr bool is_slow() const noexcept { return steps_ > most_steps_ && degree_.empty(); }

  // Stops where a face by itself is no part of a surface, or slow: it may have all the corners.
  constexpr void add_loop(const mesh_corner* corners, std::uint32_t n, std::uint32_t f) {
    const std::uint32_t last = half_edge_along(corners[n - 1].position, corners[0].position, f);
    std::uint32_t before = last, first = last;
    for (std::uint32_t k = 0; k + 1 < n; ++k) {
      if (status != half_edge_status::ok || is_slow()) return;
      const std::uint32_t h = half_edge_along(corners[k].position, corners[k + 1].position, f);
      if (k == 0) first = h;
      made.half_edges[h].previous = before;
      made.half_edges[before].next = h;
      before = h;
    }
    made.half_edges[last].previous = before;
    made.half_edges[before].next = last;
    made.loops.push_back({first, f, no_index});
    made.faces.push_back(f);
  }

  // Whether an edge waits at a rather than at b.
  IRG_INLINE constexpr bool goes_by(std::uint32_t a, std::uint32_t b) const noexcept {
    if (degree_.empty() || degree_[a] == degree_[b]) return a < b;
    return degree_[a] < degree_[b];
  }

  // The half-edge of loop l from a to b: the other side of an edge that waits, or one of a new edge.
  IRG_INLINE constexpr std::uint32_t half_edge_along(std::uint32_t a, std::uint32_t b, std::uint32_t l) {
    std::uint32_t& list = list_of_[goes_by(a, b) ? a : b];
    for (std::uint32_t* e = &list; *e != no_index; e = &next_in_list_[*e]) {
      ++steps_;
      half_edge &there = made.half_edges[2 * std::size_t{*e}], &back = made.half_edges[2 * std::size_t{*e} + 1];
      if (there.origin == b && back.origin == a) {
        if (back.loop != no_index) status = half_edge_status::edge_of_many_faces;
        back.loop = l;
        return 2 * *e + 1;
      }
      if (there.origin == a && back.origin == b)
        status = back.loop == no_index ? half_edge_status::faces_turned_apart : half_edge_status::edge_of_many_faces;
    }
    if (a == b) status = half_edge_status::corner_repeated;
    const auto h = static_cast<std::uint32_t>(made.half_edges.size());
    made.half_edges.push_back({a, no_index, no_index, l});
    made.half_edges.push_back({b, no_index, no_index, no_index});
    next_in_list_.push_back(list);
    list = h / 2;
    made.half_edge_at[a] = h;
    made.half_edge_at[b] = h + 1;
    return h;
  }

  constexpr void add_attributes(const mesh_corner* corners, std::uint32_t n, std::uint32_t f) {
    made.attributes.resize(made.half_edges.size(), half_edge_attributes{});
    std::uint32_t h = made.loops[f].first;
    for (std::uint32_t k = 0; k < n; ++k, h = made.half_edges[h].next)
      made.attributes[h] = {corners[k].normal, corners[k].texcoord};
  }

  // Half-edges beside the border, each followed by the next round the hole.
  constexpr void link_border() {
    for (std::uint32_t h = 1; h < made.half_edges.size(); h += 2) {
      if (made.half_edges[h].loop != no_index) continue;
      std::uint32_t g = made.twin(h);  // leaves the vertex that h goes to: turned until it is beside the border
      while (made.half_edges[g].loop != no_index) g = made.twin(made.half_edges[g].previous);
      made.half_edges[h].next = g;
      made.half_edges[g].previous = h;
    }
  }

  // Whether all half-edges that leave a vertex are met when one goes round it.
  constexpr bool has_single_fans() const {
    std::size_t met = 0;
    for (std::uint32_t v = 0; v < made.positions.size(); ++v) each_half_edge_at(made, v, [&](std::uint32_t) { ++met; });
    return met == made.half_edges.size();
  }

  std::size_t steps_ = 0, most_steps_ = 0;
  std::vector<std::uint32_t> degree_, list_of_, next_in_list_;
};

template <Scalar T>
constexpr checked<half_edge_mesh<T>, half_edge_status> build_half_edges(const mesh<T>& m) {
  half_edge_builder<T> builder(m);
  if (builder.status != half_edge_status::ok) return {{}, builder.status};
  half_edge_mesh<T>& b = builder.made;
  b.normals = m.normals, b.texcoords = m.texcoords, b.parts = m.parts;
  for (std::uint32_t i = 0; i < m.parts.size(); ++i) b.face_parts.insert(b.face_parts.end(), m.parts[i].face_count, i);
  return {std::move(b), half_edge_status::ok};
}

}  // namespace detail::inline IRG_ABI

namespace detail::inline IRG_COMPILED_ABI {

template <Floating T>
IRG_API checked<half_edge_mesh<T>, half_edge_status> half_edges_of(const mesh<T>& m);

}  // namespace detail::inline IRG_COMPILED_ABI

inline namespace IRG_ABI {

/// The half-edges of a mesh, open or closed.
/// shape   vertices and faces keep their numbers, loop f is that of face f and begins at its first corner; normals,
///         texture coordinates and parts are kept
/// needs   a mesh in which validate() finds no defect, of less than 2^31 corners
/// gives   an empty mesh and the reason when it is no surface of faces that run alike. list_faults() tells every place
/// exact   always: positions are not looked at. with_merged_positions() comes first where equal ones are one vertex
/// cost    linear for surfaces of bounded genus, O(n^1.5) for any mesh; 16 bytes for each half-edge and for each face
/// source  Weiler 1985; Mantyla 1988; Chiba and Nishizeki 1985 (the vertex with fewer edges)
template <Scalar T>
[[nodiscard]] constexpr checked<half_edge_mesh<T>, half_edge_status> to_half_edges(const mesh<T>& m) {
  if constexpr (Floating<T>)
    return detail::half_edges_of(m);
  else
    return detail::build_half_edges(m);
}

}  // namespace IRG_ABI
}  // namespace irg

#if IRG_BODIES
namespace irg::detail::inline IRG_COMPILED_ABI {

template <Floating T>
IRG_API checked<half_edge_mesh<T>, half_edge_status> half_edges_of(const mesh<T>& m) {
  return build_half_edges(m);
}

}  // namespace irg::detail::inline IRG_COMPILED_ABI
#endif
