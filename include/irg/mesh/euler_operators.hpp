// SPDX-License-Identifier: MIT
// Euler operators: the steps by which a boundary representation is built and changed. Each keeps vertices - edges +
// faces - rings = 2 (shells - genus), and each has one that undoes it, but for rings that are lone vertices. What an
// operator cannot do it refuses, and changes nothing.
//
// Each takes steps along the loops and round the vertices that it changes, make_edge_kill_ring and
// make_face_kill_ring_hole over the rings of the face that are newer, kill_shell and make_edge_vertex from a lone
// vertex over all lone vertices.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include <irg/mesh/half_edge_mesh.hpp>

namespace irg::inline IRG_ABI {

/// A new shell: one face whose loop is one vertex at p (mvfs).
/// gives   the loop and its vertex, from which make_edge_vertex goes on
template <Scalar T>
constexpr lone_vertex make_shell(half_edge_mesh<T>& b, const point<T, 3>& p);

/// Undoes make_shell (kvfs).
/// gives   false, and b as it was, unless the vertex is all there is of its face
template <Scalar T>
constexpr bool kill_shell(half_edge_mesh<T>& b, lone_vertex v);

/// A new vertex at p and an edge to it, from the vertex that `first` and `last` leave (mev). The half-edges from
/// `first` on, clockwise seen from outside, up to the one before `last` leave the new vertex then; none when the two
/// are the same: the edge stands free in the loop, before it.
/// gives   the half-edge to the new vertex; nothing, and b as it was, when the two do not leave the same vertex
template <Scalar T>
constexpr std::optional<std::uint32_t> make_edge_vertex(half_edge_mesh<T>& b, std::uint32_t first, std::uint32_t last,
                                                        const point<T, 3>& p);

/// The same from a vertex without edges.
template <Scalar T>
constexpr std::optional<std::uint32_t> make_edge_vertex(half_edge_mesh<T>& b, lone_vertex from, const point<T, 3>& p);

/// Undoes make_edge_vertex (kev): the edge goes with the vertex that h leads to, and what left that leaves h's origin.
/// gives   false, and b as it was, when h is no half-edge or both its ends are the same vertex
template <Scalar T>
constexpr bool kill_edge_vertex(half_edge_mesh<T>& b, std::uint32_t h);

/// An edge from the vertex that `from` leaves to the one that `to` leaves, across their face (mef). The half-edges from
/// `from` to the one before `to` bound the new face.
/// shape   `from` and `to` are of one loop; the edge stands before both
/// gives   the new half-edge in the old face; nothing, and b as it was, when the two are the same or of two loops
template <Scalar T>
constexpr std::optional<std::uint32_t> make_edge_face(half_edge_mesh<T>& b, std::uint32_t from, std::uint32_t to);

/// Undoes make_edge_face (kef): the edge goes, and what lies beyond it becomes part of the face of h, with its rings.
/// gives   false, and b as it was, when the same face or a border is on both sides
template <Scalar T>
constexpr bool kill_edge_face(half_edge_mesh<T>& b, std::uint32_t h);

/// Takes an edge away that has the same loop on both sides (kemr): the loop falls into two, one of which becomes a
/// ring.
/// gives   the ring, which is what follows h and comes first of its face's; nothing, and b as it was, when there are
///         two loops beside the edge
template <Scalar T>
constexpr std::optional<std::uint32_t> kill_edge_make_ring(half_edge_mesh<T>& b, std::uint32_t h);

/// Undoes kill_edge_make_ring where that has left no lone vertex (mekr): an edge from the vertex that `from` leaves to
/// the one that `to` leaves, of another loop of the same face, which becomes part of the loop of `from`.
/// gives   the new half-edge, of which `to` comes next; nothing, and b as it was, when the two are of one loop or of
///         two faces
template <Scalar T>
constexpr std::optional<std::uint32_t> make_edge_kill_ring(half_edge_mesh<T>& b, std::uint32_t from, std::uint32_t to);

/// A face becomes a ring of another (kfmrh): joins two shells, or makes a hole through one.
/// gives   the ring; nothing, and b as it was, when the two are the same or `face` has rings
template <Scalar T>
constexpr std::optional<std::uint32_t> kill_face_make_ring_hole(half_edge_mesh<T>& b, std::uint32_t face,
                                                                std::uint32_t into);

/// Undoes kill_face_make_ring_hole (mfkrh): a ring becomes the outer loop of a new face.
/// gives   the face; nothing, and b as it was, when the loop is no ring
template <Scalar T>
constexpr std::optional<std::uint32_t> make_face_kill_ring_hole(half_edge_mesh<T>& b, std::uint32_t ring);

}  // namespace irg::inline IRG_ABI

namespace irg::detail::inline IRG_ABI {

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

  constexpr bool is_edge(std::uint32_t h) const noexcept {
    return h < b_.half_edges.size() && b_.half_edges[h].origin != no_index;
  }
  constexpr bool is_face(std::uint32_t f) const noexcept { return f < b_.faces.size() && b_.faces[f] != no_index; }
  constexpr std::uint32_t& loop(std::uint32_t h) noexcept { return b_.half_edges[h].loop; }

  constexpr std::uint32_t add_vertex(const point<T, 3>& p) {
    b_.positions.push_back(p);
    b_.half_edge_at.push_back(no_index);
    return static_cast<std::uint32_t>(b_.positions.size() - 1);
  }
  constexpr std::uint32_t add_edge(std::uint32_t from, std::uint32_t to) {
    const auto h = static_cast<std::uint32_t>(b_.half_edges.size());
    b_.half_edges.push_back({from, no_index, no_index, no_index});
    b_.half_edges.push_back({to, no_index, no_index, no_index});
    if (!b_.attributes.empty()) b_.attributes.resize(b_.half_edges.size(), half_edge_attributes{});
    return h;
  }
  constexpr std::uint32_t add_loop(std::uint32_t first, std::uint32_t face) {
    b_.loops.push_back({first, face, no_index});
    return static_cast<std::uint32_t>(b_.loops.size() - 1);
  }
  constexpr std::uint32_t add_face(std::uint32_t loop, std::uint32_t like) {
    b_.faces.push_back(loop);
    const auto f = static_cast<std::uint32_t>(b_.faces.size() - 1);
    if (!b_.parts.empty()) {
      b_.face_parts.resize(b_.faces.size(), no_index);
      if (like != no_index) b_.face_parts[f] = b_.face_parts[like];
    }
    b_.loops[loop].face = f;
    return f;
  }

  // Each comes next to the one before.
  template <class... More>
  constexpr void link(std::uint32_t before, std::uint32_t after, More... more) noexcept {
    b_.half_edges[before].next = after;
    b_.half_edges[after].previous = before;
    if constexpr (sizeof...(more) > 0) link(after, more...);
  }
  // An edge from the vertex that `from` leaves to the one that `to` leaves, across what is on their left.
  constexpr std::uint32_t add_edge_across(std::uint32_t from, std::uint32_t to) {
    const std::uint32_t before_from = b_.previous(from), before_to = b_.previous(to);
    const std::uint32_t there = add_edge(b_.origin(from), b_.origin(to));
    link(before_from, there, to);
    link(before_to, there + 1, from);
    return there;
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
    b_.loops[l].next = no_index;
  }
  // A loop, and those that follow it, come next to the face's outer one: its other rings, of which there may be many,
  // are not gone through.
  constexpr void add_rings(std::uint32_t face, std::uint32_t l) noexcept {
    std::uint32_t& first = b_.loops[b_.faces[face]].next;
    const std::uint32_t others = first;
    first = l;
    std::uint32_t last = l;
    for (; l != no_index; l = b_.loops[l].next) {
      b_.loops[l].face = face;
      last = l;
    }
    b_.loops[last].next = others;
  }
  constexpr void make_lone(std::uint32_t l, std::uint32_t v) {
    b_.loops[l].first = no_index;
    b_.half_edge_at[v] = no_index;
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

}  // namespace irg::detail::inline IRG_ABI

namespace irg::inline IRG_ABI {

template <Scalar T>
constexpr lone_vertex make_shell(half_edge_mesh<T>& b, const point<T, 3>& p) {
  detail::euler_editor<T> edit(b);
  const std::uint32_t v = edit.add_vertex(p), l = edit.add_loop(no_index, no_index);
  edit.add_face(l, no_index);
  edit.make_lone(l, v);
  return {l, v};
}

template <Scalar T>
constexpr bool kill_shell(half_edge_mesh<T>& b, lone_vertex v) {
  detail::euler_editor<T> edit(b);
  const std::size_t i = edit.lone_place(v);
  if (i == b.lone_vertices.size()) return false;
  const std::uint32_t f = b.loops[v.loop].face;
  if (b.faces[f] != v.loop || b.loops[v.loop].next != no_index) return false;
  edit.forget_lone(i);
  edit.remove_vertex(v.vertex);
  b.loops[v.loop] = half_edge_loop{};
  b.faces[f] = no_index;
  return true;
}

template <Scalar T>
constexpr std::optional<std::uint32_t> make_edge_vertex(half_edge_mesh<T>& b, std::uint32_t first, std::uint32_t last,
                                                        const point<T, 3>& p) {
  detail::euler_editor<T> edit(b);
  if (!edit.is_edge(first) || !edit.is_edge(last) || b.origin(first) != b.origin(last)) return std::nullopt;
  const std::uint32_t v = b.origin(first), w = edit.add_vertex(p), there = edit.add_edge(v, w), back = there + 1;
  for (std::uint32_t h = first; h != last; h = b.next(b.twin(h))) b.half_edges[h].origin = w;
  const std::uint32_t before_first = b.previous(first), before_last = b.previous(last);
  edit.loop(there) = edit.loop(first);
  edit.loop(back) = edit.loop(last);
  if (first == last) {
    edit.link(before_first, there, back, first);
  } else {
    edit.link(before_first, there, first);
    edit.link(before_last, back, last);
  }
  b.half_edge_at[v] = there;
  b.half_edge_at[w] = back;
  return there;
}

template <Scalar T>
constexpr std::optional<std::uint32_t> make_edge_vertex(half_edge_mesh<T>& b, lone_vertex from, const point<T, 3>& p) {
  detail::euler_editor<T> edit(b);
  const std::size_t i = edit.lone_place(from);
  if (i == b.lone_vertices.size()) return std::nullopt;
  edit.forget_lone(i);
  const std::uint32_t w = edit.add_vertex(p), there = edit.add_edge(from.vertex, w), back = there + 1;
  edit.link(there, back, there);
  edit.loop(there) = edit.loop(back) = from.loop;
  b.loops[from.loop].first = there;
  b.half_edge_at[from.vertex] = there;
  b.half_edge_at[w] = back;
  return there;
}

template <Scalar T>
constexpr bool kill_edge_vertex(half_edge_mesh<T>& b, std::uint32_t h) {
  detail::euler_editor<T> edit(b);
  if (!edit.is_edge(h) || b.origin(h) == b.target(h)) return false;
  const std::uint32_t v = b.origin(h), w = b.target(h), back = b.twin(h);
  each_half_edge_at(b, w, [&](std::uint32_t g) { b.half_edges[g].origin = v; });
  const std::uint32_t loops[2] = {edit.loop(h), edit.loop(back)};
  std::uint32_t left = no_index;  // a half-edge that leaves v
  for (const std::uint32_t g : {h, back})
    if (b.next(g) != b.twin(g) && b.origin(b.next(g)) == v) left = b.next(g);
  if (b.next(h) == back && b.next(back) == h) {
    edit.make_lone(loops[0], v);
  } else {
    for (const std::uint32_t g : {h, back}) {  // one after the other, since they may be neighbours
      edit.link(b.previous(g), b.next(g));
      if (b.loops.size() > edit.loop(g) && b.loops[edit.loop(g)].first == g)
        b.loops[edit.loop(g)].first = b.next(g) != b.twin(g) ? b.next(g) : b.previous(g);
    }
    b.half_edge_at[v] = left;
  }
  edit.remove_edge(h);
  edit.remove_vertex(w);
  return true;
}

template <Scalar T>
constexpr std::optional<std::uint32_t> make_edge_face(half_edge_mesh<T>& b, std::uint32_t from, std::uint32_t to) {
  detail::euler_editor<T> edit(b);
  if (from == to || !edit.is_edge(from) || !edit.is_edge(to)) return std::nullopt;
  const std::uint32_t l = edit.loop(from);
  if (l == no_index || l != edit.loop(to)) return std::nullopt;
  const std::uint32_t there = edit.add_edge_across(from, to), back = there + 1;
  edit.loop(there) = l;
  b.loops[l].first = there;
  const std::uint32_t added = edit.add_loop(back, no_index);
  edit.add_face(added, b.loops[l].face);
  edit.give_loop(back, added);
  return there;
}

template <Scalar T>
constexpr bool kill_edge_face(half_edge_mesh<T>& b, std::uint32_t h) {
  detail::euler_editor<T> edit(b);
  if (!edit.is_edge(h)) return false;
  const std::uint32_t back = b.twin(h), keep = b.face(h), drop = b.face(back);
  if (keep == no_index || drop == no_index || keep == drop || b.faces[drop] != edit.loop(back)) return false;
  const std::uint32_t l = edit.loop(h), gone = edit.loop(back), after = b.next(back), next = b.next(h);
  edit.take_off(gone);
  if (b.faces[drop] != no_index) edit.add_rings(keep, b.faces[drop]);
  b.faces[drop] = no_index;
  b.loops[gone] = half_edge_loop{};
  const std::uint32_t before = b.previous(h), before_back = b.previous(back);
  const bool was_round = next == h, was_round_back = after == back;  // an edge from a vertex to itself
  const std::uint32_t v = b.origin(h), w = b.origin(back);
  if (!was_round) edit.link(before_back, next);
  if (!was_round_back) edit.link(before, after);
  const std::uint32_t first = was_round_back ? next : after;
  if (was_round && was_round_back) {
    edit.make_lone(l, v);
  } else {
    if (!was_round_back) b.half_edge_at[v] = after;
    if (!was_round) b.half_edge_at[w] = next;
    if (was_round) edit.link(before_back, after);
    if (was_round_back) edit.link(before, next);
    edit.loop(first) = no_index;  // so that going round begins
    edit.give_loop(first, l);
  }
  edit.remove_edge(h);
  return true;
}

template <Scalar T>
constexpr std::optional<std::uint32_t> kill_edge_make_ring(half_edge_mesh<T>& b, std::uint32_t h) {
  detail::euler_editor<T> edit(b);
  if (!edit.is_edge(h)) return std::nullopt;
  const std::uint32_t back = b.twin(h), l = edit.loop(h);
  if (l == no_index || l != edit.loop(back)) return std::nullopt;
  const std::uint32_t v = b.origin(h), w = b.origin(back), f = b.loops[l].face;
  const std::uint32_t before = b.previous(h), after = b.next(back), next = b.next(h), before_back = b.previous(back);
  const std::uint32_t ring = edit.add_loop(no_index, f);
  edit.add_rings(f, ring);
  if (next == back) {
    edit.make_lone(ring, w);
  } else {
    edit.link(before_back, next);
    edit.give_loop(next, ring);
    b.half_edge_at[w] = next;
  }
  if (after == h) {
    edit.make_lone(l, v);
  } else {
    edit.link(before, after);
    b.loops[l].first = after;
    b.half_edge_at[v] = after;
  }
  edit.remove_edge(h);
  return ring;
}

template <Scalar T>
constexpr std::optional<std::uint32_t> make_edge_kill_ring(half_edge_mesh<T>& b, std::uint32_t from, std::uint32_t to) {
  detail::euler_editor<T> edit(b);
  if (!edit.is_edge(from) || !edit.is_edge(to)) return std::nullopt;
  const std::uint32_t f = b.face(from);
  if (f == no_index || f != b.face(to) || edit.loop(from) == edit.loop(to)) return std::nullopt;
  const bool is_outer = b.faces[f] == edit.loop(to);
  const std::uint32_t keep = edit.loop(from), ring = edit.loop(to);
  edit.take_off(ring);
  if (is_outer) {  // what is joined to the outer loop is the outer loop
    edit.take_off(keep);
    b.loops[keep].next = b.faces[f];
    b.faces[f] = keep;
  }
  const std::uint32_t there = edit.add_edge_across(from, to);
  for (std::uint32_t h = there; h != from; h = b.next(h)) b.half_edges[h].loop = keep;
  b.loops[ring] = half_edge_loop{};
  return there;
}

template <Scalar T>
constexpr std::optional<std::uint32_t> kill_face_make_ring_hole(half_edge_mesh<T>& b, std::uint32_t face,
                                                                std::uint32_t into) {
  detail::euler_editor<T> edit(b);
  if (face == into || !edit.is_face(face) || !edit.is_face(into)) return std::nullopt;
  const std::uint32_t l = b.faces[face];
  if (b.loops[l].next != no_index) return std::nullopt;
  b.faces[face] = no_index;
  edit.add_rings(into, l);
  return l;
}

template <Scalar T>
constexpr std::optional<std::uint32_t> make_face_kill_ring_hole(half_edge_mesh<T>& b, std::uint32_t ring) {
  detail::euler_editor<T> edit(b);
  if (ring >= b.loops.size() || b.loops[ring].face == no_index) return std::nullopt;
  const std::uint32_t f = b.loops[ring].face;
  if (b.faces[f] == ring) return std::nullopt;
  edit.take_off(ring);
  return edit.add_face(ring, f);
}

}  // namespace irg::inline IRG_ABI
