// SPDX-License-Identifier: MIT
// Triangles of polygons with holes in O(n log n): a sweep that cuts the polygon into monotone parts and these into
// triangles in the same pass. Every decision is exact.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include <irg/core/conversion.hpp>
#include <irg/core/vocabulary.hpp>
#include <irg/geometry/detail/crossing_search.hpp>
#include <irg/geometry/detail/compiled_numbers.hpp>
#include <irg/geometry/detail/shoelace.hpp>
#include <irg/geometry/detail/sweep_order.hpp>
#include <irg/geometry/orient2d.hpp>
#include <irg/geometry/polygon.hpp>
#include <irg/math/vec.hpp>

namespace irg {

/// Whether a polygon could be cut into triangles.
enum class [[nodiscard]] triangulation_status {
  ok,
  crossing,    // edges cross each other, or a ring crosses itself at a vertex
  not_finite,  // a coordinate is NaN or infinite
  complete [[deprecated("irg: complete is now ok")]] = ok
};

/// Triangles as indices of vertices; no triangle unless the status is `ok`.
struct triangulation {
  triangulation_status status = triangulation_status::ok;
  std::vector<std::array<std::uint32_t, 3>> triangles;

  /// Whether the triangles make up the polygon.
  IRG_INLINE constexpr explicit operator bool() const noexcept { return status == triangulation_status::ok; }
  bool operator==(const triangulation&) const = default;
};

inline namespace IRG_ABI {

/// The triangles that make up a polygon: one ring, or any number of rings, of which those inside others are holes,
/// those inside holes islands, and so on, whichever way they run.
/// shape   vertices are numbered through all rings; triangles run as the first ring does. n - 2 for a ring of n
///         vertices, and 2 more for each hole than its number of vertices; each vertex of a ring with area is a corner.
///         In a polygon without repeated vertices whose edges meet at their ends only, every triangle has area
/// needs   fewer than 2^31 vertices
/// gives   `crossing` when edges cross, those of spikes too; what only touches does not: collinear and repeated
///         vertices, vertices on edges, edges that coincide in part (bridges to holes, holes at the rim), spikes that
///         end on an edge or before it, which go as triangles without area. Nothing for rings of fewer than three
///         vertices; triangles without area for rings without area
/// exact   for all finite floats and all integers: the triangles have the polygon's area to the last bit and cover it
///         once (even-odd)
/// cost    O(n log n); some 50 bytes for a vertex and 80 for each edge that one level line meets, beside the triangles;
///         about twice the time where rings turn back on themselves
/// source  Lee and Preparata 1977; Garey, Johnson, Preparata and Tarjan 1978; de Berg et al. 2008, chapter 3. Here both
///         passes are one, and ties are broken by the rings themselves
template <PlanePolygon P>
[[nodiscard]] constexpr triangulation triangulate_monotone(const P& polygon);

}  // namespace IRG_ABI
}  // namespace irg

namespace irg::detail::inline IRG_COMPILED_ABI {

// The triangles of rings, one after another, of so many points each.
// needs   finite points
template <Floating T>
IRG_API triangulation triangulate_rings(std::vector<point<T, 2>>&& points, std::span<const std::uint32_t> sizes);

}  // namespace irg::detail::inline IRG_COMPILED_ABI

namespace irg::detail::inline IRG_ABI {

// The triangles between two edges of an upward sweep: what is open there is a chain of vertices that no triangle could
// be cut off from yet; each new vertex, on the left or on the right, cuts off what it can.

// A chain from its newest vertex down. All but the lowest lie on one side, where the newest begins an edge; on the
// other the lowest does. Seen from inside, it turns nowhere towards the inside.
struct open_chain {
  std::uint32_t top = no_index;  // a link
  bool on_right = false;
};

// What is open between an edge and its right neighbour: one chain, or two that met at a vertex which ended the outside
// between them and awaits the next vertex to be joined to.
struct open_gap {
  open_chain first, second;
};

// The sweep of triangulate_monotone: from the lowest vertex up, edges in their order from left to right. Only where a
// vertex begins two edges is a place looked for; all others stand where an edge ends. So an order in which edges that
// coincide and vertices that touch edges lie beside each other, once chosen, is kept, and it suffices to see that
// neighbours never change sides: then no edges cross.
template <Scalar T>
struct monotone_sweep {
  using coordinate_type = T;
  struct link {
    std::uint32_t vertex, below;
  };
  struct edge {
    std::uint32_t low = no_index, high = no_index;
    bool inside_on_right = false;
    open_gap gap;  // to the right, where that is inside
  };
  struct ring_range {
    std::uint32_t first, size;
  };

  std::vector<std::array<std::uint32_t, 3>>& triangles;
  std::vector<point<T, 2>> points{};
  std::vector<std::uint32_t> next{}, previous{};  // next is none for a vertex that has been removed
  std::vector<ring_range> rings{};
  bool has_folds = false;
  std::vector<link> links{};  // of all chains
  std::vector<std::uint32_t> events{}, arriving{};  // the edges that come to a vertex from its neighbours
  sweep_order<std::uint32_t> order{};
  std::vector<edge> edges{};
  std::vector<std::uint32_t> unused{}, starts{}, changed{};

  constexpr const point<T, 2>& at(std::uint32_t i) const noexcept { return points[i]; }
  constexpr bool is_before(std::uint32_t i, std::uint32_t j) const noexcept { return is_lower(at(i), at(j)); }
  constexpr int turn(std::uint32_t i, std::uint32_t j, std::uint32_t k) const noexcept {
    return orient2d(at(i), at(j), at(k));
  }
};

template <class Sweep>
constexpr std::uint32_t push_link(Sweep& s, std::uint32_t v, std::uint32_t below) {
  s.links.push_back({v, below});
  return static_cast<std::uint32_t>(s.links.size() - 1);
}
template <class Sweep>
constexpr void add_triangle(Sweep& s, bool on_right, std::uint32_t lower, std::uint32_t upper, std::uint32_t v) {
  s.triangles.push_back(on_right ? std::array{lower, upper, v} : std::array{upper, lower, v});
}
// The triangles of v with every edge of the chain.
template <class Sweep>
constexpr void add_fan(Sweep& s, const open_chain& chain, std::uint32_t v) {
  for (std::uint32_t upper = chain.top; s.links[upper].below != no_index; upper = s.links[upper].below)
    add_triangle(s, chain.on_right, s.links[s.links[upper].below].vertex, s.links[upper].vertex, v);
}
// Whether the chain turns towards the inside at `upper`, so that a triangle can be cut off there. Vertices at one
// place turn nowhere; they go at once, lest a corner that is made of several be taken for no_index.
template <class Sweep>
constexpr bool can_cut(const Sweep& s, std::uint32_t lower, std::uint32_t upper, std::uint32_t v,
                       bool on_right) noexcept {
  const int turn = s.turn(lower, upper, v);
  if (turn != 0) return (turn > 0) == on_right;
  return same_place(s.at(lower), s.at(upper)) || same_place(s.at(upper), s.at(v));
}
// Adds v on the left or on the right.
template <class Sweep>
constexpr void extend_chain(Sweep& s, open_chain& chain, std::uint32_t v, bool on_right) {
  std::uint32_t top = chain.top;
  if (chain.on_right != on_right && s.links[top].below != no_index) {
    add_fan(s, chain, v);
    chain = {push_link(s, v, push_link(s, s.links[top].vertex, no_index)), on_right};
    return;
  }
  for (std::uint32_t below = s.links[top].below; below != no_index; top = below, below = s.links[top].below) {
    const std::uint32_t lower = s.links[below].vertex, upper = s.links[top].vertex;
    if (!can_cut(s, lower, upper, v, on_right)) break;
    add_triangle(s, on_right, lower, upper, v);
  }
  chain = {push_link(s, v, top), on_right};
}
template <class Sweep>
constexpr open_gap begin_gap(Sweep& s, std::uint32_t v) {
  return {{push_link(s, v, no_index), false}, {}};
}

// v is on the gap's left or right edge.
template <class Sweep>
constexpr void add_to_gap(Sweep& s, open_gap& gap, std::uint32_t v, bool on_right) {
  if (gap.second.top != no_index) {
    add_fan(s, on_right ? gap.second : gap.first, v);
    if (!on_right) gap.first = gap.second;
    gap.second = {};
  }
  extend_chain(s, gap.first, v, on_right);
}
// Both edges of the gap end at v.
template <class Sweep>
constexpr void finish_gap(Sweep& s, open_gap& gap, std::uint32_t v) {
  add_fan(s, gap.first, v);
  if (gap.second.top != no_index) add_fan(s, gap.second, v);
}
// The outside begins at v, within the gap: returns the gap to its right and keeps the one to its left.
template <class Sweep>
constexpr open_gap split_gap(Sweep& s, open_gap& gap, std::uint32_t v) {
  open_gap right;
  if (gap.second.top != no_index) {
    right.first = gap.second;
    gap.second = {};
  } else {
    const open_chain fresh{push_link(s, s.links[gap.first.top].vertex, no_index), false};
    right.first = gap.first.on_right ? fresh : gap.first;
    if (!gap.first.on_right) gap.first = fresh;
  }
  extend_chain(s, gap.first, v, true);
  extend_chain(s, right.first, v, false);
  return right;
}
// The outside between two gaps ends at v.
template <class Sweep>
constexpr void merge_gaps(Sweep& s, open_gap& left, open_gap& right, std::uint32_t v) {
  add_to_gap(s, left, v, true);
  add_to_gap(s, right, v, false);
  left.second = right.first;
}

// The sweep sees the rings without their folds, which may cross what is left.
template <class Sweep>
constexpr bool whole_rings_cross(const Sweep& s) {
  crossing_search<typename Sweep::coordinate_type> search;
  for (const auto& r : s.rings) search.add_ring(s.points, r.first, r.size);
  return search.run();
}

// Vertices where the ring stands still or turns back go, as triangles without area.
template <class Sweep>
constexpr void remove_folds(Sweep& s, std::uint32_t first, std::uint32_t n) {
  std::uint32_t left = n;
  for (std::uint32_t i = first, quiet = 0; quiet < left;) {
    const std::uint32_t before = s.previous[i], after = s.next[i];
    if (!is_fold(s.at(before), s.at(i), s.at(after))) {
      ++quiet;
      i = after;
      continue;
    }
    s.has_folds = true;
    s.triangles.push_back({before, i, after});
    s.next[before] = after;
    s.previous[after] = before;
    s.next[i] = no_index;
    quiet = 0;
    if (--left == 2) {
      s.next[before] = s.next[after] = no_index;
      return;
    }
    i = before;
  }
}

// Ends the two edges that meet at v if they are neighbours, and then those around them that meet at the same place.
template <class Sweep>
constexpr void end_edges(Sweep& s, std::uint32_t v) {
  for (;;) {
    std::uint32_t l = s.arriving[2 * v], r = s.arriving[2 * v + 1];
    if (l == no_index) return;
    if (s.order.next(l) != r) std::swap(l, r);
    if (s.order.next(l) != r) return;
    const std::uint32_t before = s.order.previous(l), after = s.order.next(r);
    if (s.edges[l].inside_on_right)
      finish_gap(s, s.edges[l].gap, v);
    else
      merge_gaps(s, s.edges[before].gap, s.edges[r].gap, v);
    for (const std::uint32_t e : {l, r}) {
      s.order.erase(e);
      s.edges[e].high = no_index;
      s.unused.push_back(e);
    }
    s.arriving[2 * v] = s.arriving[2 * v + 1] = no_index;
    if (before == no_index || after == no_index) return;
    s.changed.push_back(before);
    const std::uint32_t next = s.edges[before].high;
    if (next != s.edges[after].high || s.is_before(v, next)) return;
    v = next;
  }
}

// Lets edge e run from v to its next or previous vertex.
template <class Sweep>
constexpr void lead_edge(Sweep& s, std::uint32_t e, std::uint32_t v, bool to_next) {
  s.edges[e].low = v;
  s.edges[e].high = to_next ? s.next[v] : s.previous[v];
  s.arriving[2 * s.edges[e].high + (to_next ? 0 : 1)] = e;
  s.changed.push_back(e);
}

template <class Sweep>
constexpr void continue_edge(Sweep& s, std::uint32_t v, bool from_previous) {
  const std::uint32_t e = s.arriving[2 * v + (from_previous ? 0 : 1)];
  if (s.edges[e].inside_on_right)
    add_to_gap(s, s.edges[e].gap, v, false);
  else
    add_to_gap(s, s.edges[s.order.previous(e)].gap, v, true);
  lead_edge(s, e, v, from_previous);
}

template <class Sweep>
constexpr bool next_is_left(const Sweep& s, std::uint32_t v) noexcept {
  return s.turn(v, s.previous[v], s.next[v]) > 0;
}

// From left to right by their left edges, the wider ones first: wedges within others come after them.
template <class Sweep>
constexpr void sort_starts(Sweep& s) {
  const auto ends = [&](std::uint32_t v) {
    return next_is_left(s, v) ? std::array{s.next[v], s.previous[v]} : std::array{s.previous[v], s.next[v]};
  };
  std::sort(s.starts.begin(), s.starts.end(), [&](std::uint32_t u, std::uint32_t v) {
    const auto a = ends(u), b = ends(v);
    const int left = s.turn(u, a[0], b[0]), right = s.turn(u, a[1], b[1]);
    return left != 0 ? left < 0 : right != 0 ? right > 0 : u < v;
  });
}

template <class Sweep>
constexpr std::uint32_t new_edge(Sweep& s) {
  if (s.unused.empty()) {
    s.unused.push_back(static_cast<std::uint32_t>(s.edges.size()));
    s.edges.push_back({});
  }
  const std::uint32_t e = s.unused.back();
  s.unused.pop_back();
  s.edges[e] = {};
  return e;
}

template <class Sweep>
constexpr bool start_edges(Sweep& s, std::uint32_t v) {
  std::uint32_t before = no_index;
  for (std::uint32_t e = s.order.root(); e != no_index;) {
    int side = s.turn(s.edges[e].low, s.edges[e].high, v);
    if (side == 0) {  // v is on it: where v's own edges lie decides
      const int a = s.turn(s.edges[e].low, s.edges[e].high, s.previous[v]);
      const int b = s.turn(s.edges[e].low, s.edges[e].high, s.next[v]);
      if (a * b < 0) return false;
      side = a + b;
    }
    if (side <= 0) before = e;
    e = side > 0 ? s.order.left(e) : s.order.right(e);
  }
  const std::uint32_t l = new_edge(s), r = new_edge(s);
  const bool to_next = next_is_left(s, v);
  s.order.insert_after(before, l);
  s.order.insert_after(l, r);
  const bool inside = before != no_index && s.edges[before].inside_on_right;
  s.edges[l].inside_on_right = !inside;
  s.edges[r].inside_on_right = inside;
  if (inside)
    s.edges[r].gap = split_gap(s, s.edges[before].gap, v);
  else
    s.edges[l].gap = begin_gap(s, v);
  lead_edge(s, l, v, to_next);
  lead_edge(s, r, v, !to_next);
  return true;
}

// Whether edge e, if it is still there, keeps to its side of its neighbours as far as they go beside each other.
template <class Sweep>
constexpr bool keeps_order(const Sweep& s, std::uint32_t e) noexcept {
  if (s.edges[e].high == no_index) return true;
  const std::uint32_t before = s.order.previous(e), after = s.order.next(e);
  return (before == no_index || keeps_order(s, s.edges[before], s.edges[e])) &&
         (after == no_index || keeps_order(s, s.edges[e], s.edges[after]));
}
template <class Sweep>
constexpr bool keeps_order(const Sweep& s, const typename Sweep::edge& l, const typename Sweep::edge& r) noexcept {
  return s.is_before(r.high, l.high) ? s.turn(l.low, l.high, r.high) <= 0 : s.turn(r.low, r.high, l.high) >= 0;
}

// The next n points are a ring.
template <class Sweep>
constexpr void add_sweep_ring(Sweep& s, std::uint32_t n) {
  const auto first = static_cast<std::uint32_t>(s.next.size());
  for (std::uint32_t i = 0; i < n; ++i) {
    s.next.push_back(first + (i + 1 < n ? i + 1 : 0));
    s.previous.push_back(first + (i > 0 ? i - 1 : n - 1));
  }
  if (n < 3) {
    for (std::uint32_t i = 0; i < n; ++i) s.next[first + i] = no_index;
    return;
  }
  s.rings.push_back({first, n});
  remove_folds(s, first, n);
}

// All vertices at one place: first the ends of edges, then what goes on, then the beginnings.
template <class Sweep>
constexpr bool handle_vertices(Sweep& s, std::size_t begin, std::size_t end) {
  s.starts.clear();
  s.changed.clear();
  for (std::size_t k = begin; k < end; ++k) {
    const std::uint32_t v = s.events[k];
    const bool from_previous = s.is_before(s.previous[v], v), from_next = s.is_before(s.next[v], v);
    if (from_previous && from_next)
      end_edges(s, v);
    else if (!from_previous && !from_next)
      s.starts.push_back(v);
  }
  for (std::size_t k = begin; k < end; ++k) {
    const std::uint32_t v = s.events[k];
    const bool from_previous = s.is_before(s.previous[v], v), from_next = s.is_before(s.next[v], v);
    if (from_previous && from_next && s.arriving[2 * v] != no_index) return false;  // others lie between its edges
    if (from_previous != from_next) continue_edge(s, v, from_previous);
  }
  if (s.starts.size() > 1) sort_starts(s);
  for (const std::uint32_t v : s.starts)
    if (!start_edges(s, v)) return false;
  for (const std::uint32_t e : s.changed)
    if (!keeps_order(s, e)) return false;
  return true;
}

// Whether no edges cross.
template <class Sweep>
constexpr bool sweep_upwards(Sweep& s) {
  if (s.has_folds && whole_rings_cross(s)) return false;
  for (std::uint32_t i = 0; i < s.points.size(); ++i)
    if (s.next[i] != no_index) s.events.push_back(i);
  std::sort(s.events.begin(), s.events.end(),
            [&](std::uint32_t i, std::uint32_t j) { return s.is_before(i, j) || (i < j && !s.is_before(j, i)); });
  s.arriving.assign(2 * s.points.size(), no_index);
  for (std::size_t begin = 0, end = 0; begin < s.events.size(); begin = end) {
    while (end < s.events.size() && !s.is_before(s.events[begin], s.events[end])) ++end;
    if (!handle_vertices(s, begin, end)) return false;
  }
  return true;
}

template <Scalar T>
constexpr triangulation sweep_rings(std::vector<point<T, 2>>&& points, std::span<const std::uint32_t> sizes) {
  triangulation result;
  const bool clockwise = !sizes.empty() && shoelace_sign(std::span<const point<T, 2>>(points.data(), sizes[0])) < 0;
  monotone_sweep<T> sweep{result.triangles, std::move(points)};
  for (const std::uint32_t n : sizes) add_sweep_ring(sweep, n);
  if (!sweep_upwards(sweep)) {
    result.status = triangulation_status::crossing;
    result.triangles.clear();
  }
  if (clockwise)
    for (auto& t : result.triangles) std::swap(t[1], t[2]);
  return result;
}

}  // namespace irg::detail::inline IRG_ABI

namespace irg::inline IRG_ABI {

template <PlanePolygon P>
[[nodiscard]] constexpr triangulation triangulate_monotone(const P& polygon) {
  if (!irg::is_finite(polygon)) return {triangulation_status::not_finite, {}};
  using T = scalar_of<polygon_point<P>>;
  using N = typename detail::library_number_or<T>::type;
  std::vector<point<N, 2>> points;
  std::vector<std::uint32_t> sizes;
  detail::each_ring(polygon, [&](const auto& ring) {
    sizes.push_back(static_cast<std::uint32_t>(ring_size(ring)));
    for (std::uint32_t i = 0; i < sizes.back(); ++i) {
      const auto p = ring_vertex(ring, i);
      points.push_back({converted<N>(coordinate(p, 0)), converted<N>(coordinate(p, 1))});
    }
    return true;
  });
  if constexpr (Floating<N>)
    return detail::triangulate_rings(std::move(points), sizes);
  else
    return detail::sweep_rings(std::move(points), sizes);
}

}  // namespace irg::inline IRG_ABI

#if IRG_BODIES
namespace irg::detail::inline IRG_COMPILED_ABI {

template <Floating T>
IRG_API triangulation triangulate_rings(std::vector<point<T, 2>>&& points, std::span<const std::uint32_t> sizes) {
  return sweep_rings(std::move(points), sizes);
}

}  // namespace irg::detail::inline IRG_COMPILED_ABI
#endif
