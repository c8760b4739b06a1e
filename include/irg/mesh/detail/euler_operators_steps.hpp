// SPDX-License-Identifier: MIT
// The steps of euler_operators.hpp.
#pragma once

#include <cstddef>
#include <cstdint>

#include <irg/mesh/half_edge_mesh.hpp>

namespace irg {
namespace detail {
inline namespace IRG_ABI {

template <Scalar T>
class euler_editor {
public:
  /// Makes room for what one operator adds: where there is no memory, nothing has changed yet.
  constexpr explicit euler_editor(half_edge_mesh<T>& b) : b_(b) {
    make_room(b.positions, b.positions.size() + 1);
    make_room(b.half_edge_at, b.half_edge_at.size() + 1);
    make_room(b.half_edges, b.half_edges.size() + 2);
    make_room(b.loops, b.loops.size() + 1);
    make_room(b.faces, b.faces.size() + 1);
    make_room(b.lone_vertices, b.lone_vertices.size() + 2);
    if (!b.attributes.empty()) make_room(b.attributes, b.half_edges.size() + 2);
    if (!b.parts.empty()) make_room(b.face_parts, b.faces.size() + 1);
  }
  static constexpr std::uint32_t none = half_edge::none;

  constexpr bool is_edge(std::uint32_t h) const noexcept {
    return h < b_.half_edges.size() && b_.half_edges[h].origin != none;
  }
  constexpr bool is_face(std::uint32_t f) const noexcept { return f < b_.faces.size() && b_.faces[f] != none; }
  constexpr std::uint32_t& loop(std::uint32_t h) noexcept { return b_.half_edges[h].loop; }

  constexpr std::uint32_t add_vertex(const point<T, 3>& p) {
    b_.positions.push_back(p);
    b_.half_edge_at.push_back(none);
    return static_cast<std::uint32_t>(b_.positions.size() - 1);
  }
  constexpr std::uint32_t add_edge(std::uint32_t from, std::uint32_t to) {
    const auto h = static_cast<std::uint32_t>(b_.half_edges.size());
    b_.half_edges.push_back({from, none, none, none});
    b_.half_edges.push_back({to, none, none, none});
    if (!b_.attributes.empty()) b_.attributes.resize(b_.half_edges.size(), half_edge_attributes{});
    return h;
  }
  constexpr std::uint32_t add_loop(std::uint32_t first, std::uint32_t face) {
    b_.loops.push_back({first, face, none});
    return static_cast<std::uint32_t>(b_.loops.size() - 1);
  }
  constexpr std::uint32_t add_face(std::uint32_t loop, std::uint32_t like) {
    b_.faces.push_back(loop);
    const auto f = static_cast<std::uint32_t>(b_.faces.size() - 1);
    if (!b_.parts.empty()) {
      b_.face_parts.resize(b_.faces.size(), none);
      if (like != none) b_.face_parts[f] = b_.face_parts[like];
    }
    b_.loops[loop].face = f;
    return f;
  }

  constexpr void link(std::uint32_t before, std::uint32_t after) noexcept {
    b_.half_edges[before].next = after;
    b_.half_edges[after].previous = before;
  }
  // All half-edges from h on come to belong to l.
  constexpr void give_loop(std::uint32_t h, std::uint32_t l) noexcept {
    for (std::uint32_t g = h; b_.half_edges[g].loop != l; g = b_.next(g)) b_.half_edges[g].loop = l;
    b_.loops[l].first = h;
  }
  constexpr void remove_edge(std::uint32_t h) noexcept { b_.half_edges[h] = b_.half_edges[b_.twin(h)] = half_edge{}; }
  constexpr void remove_vertex(std::uint32_t v) noexcept { b_.half_edge_at[v] = half_edge_mesh<T>::gone; }

  // Takes a loop off its face's list; an outer loop is followed by the face's first ring.
  constexpr void take_off(std::uint32_t l) noexcept {
    std::uint32_t* at = &b_.faces[b_.loops[l].face];
    while (*at != l) at = &b_.loops[*at].next;
    *at = b_.loops[l].next;
    b_.loops[l].next = none;
  }
  // A loop, and those that follow it, come next to the face's outer one: its other rings, of which there may be many,
  // are not gone through.
  constexpr void add_rings(std::uint32_t face, std::uint32_t l) noexcept {
    std::uint32_t& first = b_.loops[b_.faces[face]].next;
    const std::uint32_t others = first;
    first = l;
    std::uint32_t last = l;
    for (; l != none; l = b_.loops[l].next) {
      b_.loops[l].face = face;
      last = l;
    }
    b_.loops[last].next = others;
  }
  constexpr void make_lone(std::uint32_t l, std::uint32_t v) {
    b_.loops[l].first = none;
    b_.half_edge_at[v] = none;
    b_.lone_vertices.push_back({l, v});
  }
  // The place of the loop's vertex in the list, or its end.
  constexpr std::size_t lone_place(lone_vertex v) const noexcept {
    std::size_t i = 0;
    while (i < b_.lone_vertices.size() &&
           (b_.lone_vertices[i].loop != v.loop || b_.lone_vertices[i].vertex != v.vertex))
      ++i;
    return i;
  }
  constexpr void forget_lone(std::size_t i) {
    b_.lone_vertices.erase(b_.lone_vertices.begin() + static_cast<std::ptrdiff_t>(i));
  }

private:
  template <class Elements>
  static constexpr void make_room(Elements& elements, std::size_t count) {
    if (elements.capacity() < count) elements.reserve(2 * count);
  }

  half_edge_mesh<T>& b_;
};

}  // namespace IRG_ABI
}  // namespace detail
}  // namespace irg
