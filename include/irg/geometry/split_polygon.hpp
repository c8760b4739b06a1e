// SPDX-License-Identifier: MIT
// Cutting a polygon in two: in space by a plane, in the plane by a line. Which vertices lie on which side is decided
// exactly, and two polygons that share an edge get the same new point on it.
#pragma once

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>
#include <vector>

#include <irg/core/is_finite.hpp>
#include <irg/core/plane_concept.hpp>
#include <irg/geometry/attributed_point.hpp>
#include <irg/geometry/detail/compiled_numbers.hpp>
#include <irg/geometry/detail/half_space.hpp>
#include <irg/geometry/detail/shoelace.hpp>
#include <irg/geometry/flat_ring.hpp>
#include <irg/geometry/orient2d.hpp>

namespace irg {

/// Where a polygon lies against a plane or a line.
enum class split_side {
  front,      // in front, or touching from there; nothing was cut
  back,       // behind, or touching from there
  both,       // on both sides
  on,         // all vertices on it, or none at all
  not_finite  // a number is NaN or infinite
};

/// The parts of a polygon; none of them without area.
template <PolygonVertex V>
struct split_parts {
  split_side side = split_side::on;
  std::vector<std::vector<V>> front, back;
  bool operator==(const split_parts&) const = default;
};

/// The vertices of a polygon in a container with size() and [].
template <class R>
concept VertexRing = requires(const R& r, std::size_t i) {
  { r.size() } -> std::convertible_to<std::size_t>;
  requires PolygonVertex<std::remove_cvref_t<decltype(r[i])>>;
};

/// The type of such a ring's vertices.
template <VertexRing R>
using ring_vertex_type = std::remove_cvref_t<decltype(std::declval<const R&>()[std::size_t{}])>;

inline namespace IRG_ABI {

/// The parts of a polygon in space before and behind a plane.
/// shape   parts run as the polygon does. Vertices on the plane belong to both sides; along the cut the parts of both
///         sides have the same vertices, all those that lie there. `interpolate(a, b, t)` makes a vertex at t of the
///         way from a, in front, to b, behind; its position is set afterwards. A polygon on one side comes back whole
/// needs   a simple polygon, convex or not, flat or nearly so; its vertices may touch its edges. Holes must be joined
///         to it by bridges
/// gives   no part without area. For a polygon that crosses itself one ring for each side, whose parts hang together
///         along the cut
/// exact   sides are decided exactly for the plane's and the vertices' numbers as they are, and so is the order along
///         the cut. A new point is at t = sa/(sa - sb) with sa and sb the plane's values at the ends, computed so that
///         each coordinate is within 1 ulp of the exact one and between those of the ends; from either polygon at an
///         edge it is the same. t is within 1 ulp, too
/// cost    linear, and the sorting of the points on the plane; allocates
/// source  Fuchs, Kedem and Naylor 1980, for BSP trees; the pairing of ends along the cut: Weiler and Atherton 1977
template <VertexRing R, Plane P, class F = lerp_vertex>
  requires(size_of<vertex_position<ring_vertex_type<R>>> == 3 && Real<vertex_scalar<ring_vertex_type<R>>> &&
           std::same_as<plane_scalar<P>, vertex_scalar<ring_vertex_type<R>>>)
[[nodiscard]] constexpr split_parts<ring_vertex_type<R>> split_polygon(const R& ring, const P& plane,
                                                                       const F& interpolate = {});

/// The parts of a polygon of the plane on the left (front) and on the right (back) of the line from one point over
/// another; as above.
/// gives   side `on` when the two points coincide
template <VertexRing R, class F = lerp_vertex>
  requires(size_of<vertex_position<ring_vertex_type<R>>> == 2 && Real<vertex_scalar<ring_vertex_type<R>>>)
[[nodiscard]] constexpr split_parts<ring_vertex_type<R>> split_polygon(const R& ring,
                                                                       const vertex_position<ring_vertex_type<R>>& from,
                                                                       const vertex_position<ring_vertex_type<R>>& over,
                                                                       const F& interpolate = {});

}  // namespace IRG_ABI
}  // namespace irg

namespace irg::detail {

// How a polygon is cut apart along a line of its plane. The polygon's edge is cut where it meets the line into chains
// on either side; along the line their ends alternate between those where the inside begins and those where it ends,
// and each two are joined by a stretch of the line. Their order is that of the edges they lie on, decided by exact
// turns.

// A vertex of the polygon, `back` and `front` being its number, or a cut of the edge between these two.
template <class T, int D>
struct split_entry {
  std::uint32_t back, front;
  int side;
  T t;  // of a cut
  point<T, D> at;
};

// A polygon with its cuts, and the parts of both sides as numbers of entries.
template <class T, int D>
struct split_plan {
  std::vector<split_entry<T, D>> entries{};
  std::vector<std::vector<std::uint32_t>> front{}, back{};
};

inline namespace IRG_COMPILED_ABI {

template <Floating T, int D>
IRG_API split_plan<T, D> plan_of_split(const std::vector<point<T, D>>& ring, const std::vector<int>& sides,
                                       const half_space<T, D>& boundary);

}  // namespace IRG_COMPILED_ABI

inline namespace IRG_ABI {

template <class T, int D>
class polygon_splitter {
public:
  constexpr explicit polygon_splitter(const std::vector<point<T, D>>& positions) {
    const auto flatten = [&](const auto& flat) {
      for (std::size_t i = 0; i < positions.size(); ++i)
        flat_.push_back({coordinate(flat[i], 0), coordinate(flat[i], 1)});
    };
    if constexpr (D == 3)
      flatten(flat_ring<std::vector<point<T, D>>>(positions, dropped_axis(positions).value_or(2)));
    else
      flatten(positions);
    orientation_ = shoelace_sign(flat_);
  }

  // The ring with a new vertex wherever an edge passes through the boundary.
  constexpr void cut(const std::vector<point<T, D>>& ring, const std::vector<int>& sides,
                     const half_space<T, D>& boundary) {
    const auto n = static_cast<std::uint32_t>(sides.size());
    entries_.reserve(n + std::size_t{2});
    for (std::uint32_t i = 0; i < n; ++i) {
      const std::uint32_t j = i + 1 < n ? i + 1 : 0;
      entries_.push_back({i, i, sides[i], T(0), ring[i]});
      if (sides[i] > 0) front_vertex_ = i;
      if (sides[i] * sides[j] >= 0) continue;
      const std::uint32_t front = sides[i] > 0 ? i : j, back = sides[i] > 0 ? j : i;
      const auto meeting = meet_half_space(ring[front], ring[back], boundary);
      entries_.push_back({back, front, 0, meeting.t, meeting.at});
    }
    for (std::uint32_t k = 0; k < entries_.size(); ++k)
      if (entries_[k].side == 0) on_line_.push_back(k);
    heap_sort(on_line_, [&](std::uint32_t a, std::uint32_t b) { return place_order(a, b) < 0; });
    rank_.assign(entries_.size(), 0u);
    for (std::uint32_t k = 0; k < on_line_.size(); ++k) rank_[on_line_[k]] = k;
  }

  // The parts on one side, 1 for the front, -1 for the back, as numbers of entries.
  constexpr std::vector<std::vector<std::uint32_t>> parts(int side) {
    std::vector<std::vector<std::uint32_t>> out;
    find_chains(side);
    if (orientation_ == 0 || !pair_ends(side)) {  // the polygon crosses itself: one ring, parts joined along the line
      ring_ = {};
      for (std::uint32_t k = 0; k < entries_.size(); ++k)
        if (entries_[k].side * side >= 0) ring_.push_back(k);
      put_ring(out);
      return out;
    }
    for (std::uint32_t c = 0; c < chains_.size(); ++c) {
      ring_ = {};
      for (std::uint32_t at = c; !chains_[at].done; at = walk(at)) {
      }
      put_ring(out);
    }
    return out;
  }

  constexpr std::vector<split_entry<T, D>> take_entries() noexcept { return std::move(entries_); }

private:
  using entry = split_entry<T, D>;
  struct chain {
    std::uint32_t first, last;  // entries on the line
    std::uint32_t next = 0;  // the chain that the stretch of line from `last` leads to
    bool done = false;
  };
  struct chain_end {
    std::uint32_t chain;
    bool is_last;
  };

  std::vector<point<T, 2>> flat_;
  int orientation_ = 0;
  std::uint32_t front_vertex_ = 0;
  std::vector<entry> entries_;
  std::vector<std::uint32_t> on_line_, rank_;  // entries on the line from left to right, where the front is above
  std::vector<chain> chains_;
  std::vector<chain_end> ends_;
  std::vector<std::uint32_t> ring_;

  // Sorts by whatever order, also one that contradicts itself.
  template <class A, class Less>
  static constexpr void heap_sort(A& a, const Less& less) {
    std::make_heap(a.begin(), a.end(), less);
    std::sort_heap(a.begin(), a.end(), less);
  }

  constexpr int turn(std::uint32_t a, std::uint32_t b, std::uint32_t c) const noexcept {
    return orient2d(flat_[a], flat_[b], flat_[c]);
  }
  // Where an entry on the line lies against another: -1 to the left, 1 to the right, 0 at one place.
  constexpr int place_order(std::uint32_t i, std::uint32_t j) const noexcept {
    const entry &a = entries_[i], &b = entries_[j];
    if (a.back == a.front && b.back == b.front) return -turn(a.back, b.back, front_vertex_);
    if (b.back == b.front) return turn(a.back, a.front, b.back);
    if (a.back == a.front) return -turn(b.back, b.front, a.back);
    const int low = turn(b.back, b.front, a.back), high = turn(b.back, b.front, a.front);
    if (low * high >= 0) return low != 0 || high != 0 ? -sign_of_sum(low, high) : 0;
    return sign_of_sum(turn(a.back, a.front, b.back), turn(a.back, a.front, b.front));
  }
  static constexpr int sign_of_sum(int a, int b) noexcept { return a + b < 0 ? -1 : a + b > 0 ? 1 : 0; }

  constexpr std::uint32_t after(std::uint32_t k) const noexcept { return k + 1 < entries_.size() ? k + 1 : 0; }

  constexpr void find_chains(int side) {
    chains_.clear();
    ends_.clear();
    for (std::uint32_t k = 0; k < entries_.size(); ++k) {
      if (entries_[k].side != 0 || entries_[after(k)].side != side) continue;
      std::uint32_t last = after(k);
      while (entries_[last].side != 0) last = after(last);
      const auto c = static_cast<std::uint32_t>(chains_.size());
      chains_.push_back({k, last});
      ends_.push_back({c, false});
      ends_.push_back({c, true});
    }
  }

  constexpr std::uint32_t place_of(const chain_end& e) const noexcept {
    return e.is_last ? chains_[e.chain].last : chains_[e.chain].first;
  }
  // The vertex that the chain comes from or goes to there.
  constexpr std::uint32_t neighbour(const chain_end& e, int side) const noexcept {
    const entry& at = entries_[place_of(e)];
    if (at.back != at.front) return side > 0 ? at.front : at.back;
    const chain& c = chains_[e.chain];
    const std::uint32_t k =
        e.is_last ? (c.last == 0 ? static_cast<std::uint32_t>(entries_.size()) : c.last) - 1 : after(c.first);
    return entries_[k].back;
  }
  constexpr bool end_order(const chain_end& a, const chain_end& b, int side) const noexcept {
    const std::uint32_t i = place_of(a), j = place_of(b);
    if (const int order = i == j ? 0 : place_order(i, j); order != 0) return order < 0;
    const std::uint32_t u = neighbour(a, side), v = neighbour(b, side);  // one place: by the chains' directions
    const entry &at = entries_[i], &other = entries_[j];
    if (at.back == at.front) return side * turn(at.back, u, v) < 0;
    return other.back == other.front && side * turn(other.back, u, v) < 0;
  }

  // Joins each end where the inside begins to the next, where it ends. False where ends do not alternate.
  constexpr bool pair_ends(int side) {
    heap_sort(ends_, [&](const chain_end& a, const chain_end& b) { return end_order(a, b, side); });
    const bool opens_with_last = orientation_ * side > 0;
    for (std::size_t k = 0; k < ends_.size(); ++k) {
      const bool wanted = (k % 2 == 0) == opens_with_last;
      std::size_t found = k;  // among those at one place and in one direction any will do
      while (ends_[found].is_last != wanted) {
        ++found;
        if (found == ends_.size() || place_order(place_of(ends_[k]), place_of(ends_[found])) != 0) return false;
      }
      std::swap(ends_[k], ends_[found]);
    }
    for (std::size_t k = 0; k < ends_.size(); k += 2) {
      const chain_end &last = ends_[k + (opens_with_last ? 0 : 1)], &first = ends_[k + (opens_with_last ? 1 : 0)];
      chains_[last.chain].next = first.chain;
    }
    return true;
  }

  // Adds a chain to the ring, and the entries between its end and the next chain's beginning.
  constexpr std::uint32_t walk(std::uint32_t c) {
    chain& from = chains_[c];
    from.done = true;
    for (std::uint32_t k = from.first; k != from.last; k = after(k)) ring_.push_back(k);
    ring_.push_back(from.last);
    const std::uint32_t to = chains_[from.next].first;
    for (std::uint32_t k = rank_[from.last]; k != rank_[to];) {
      k = rank_[from.last] < rank_[to] ? k + 1 : k - 1;
      const std::uint32_t between = on_line_[k];
      if (place_order(between, from.last) != 0 && place_order(between, to) != 0) ring_.push_back(between);
    }
    return from.next;
  }

  // The ring, if it has an area.
  constexpr void put_ring(std::vector<std::vector<std::uint32_t>>& out) const {
    std::vector<std::uint32_t> ring;
    std::vector<point<T, D>> positions;
    ring.reserve(ring_.size());
    positions.reserve(ring_.size());
    for (const std::uint32_t k : ring_) {
      const auto& at = entries_[k].at;
      if (!ring.empty() && same_place(positions.back(), at)) continue;
      ring.push_back(k);
      positions.push_back(at);
    }
    while (ring.size() > 1 && same_place(positions.back(), positions.front())) ring.pop_back(), positions.pop_back();
    if (ring.size() < 3) return;
    if constexpr (D == 2) {
      if (shoelace_sign(positions) != 0) out.push_back(std::move(ring));
    } else {
      for (int axis = 0; axis < 3; ++axis)
        if (shoelace_sign(flat_ring<std::vector<point<T, D>>>(positions, axis)) != 0) {
          out.push_back(std::move(ring));
          return;
        }
    }
  }
};

template <class T, int D>
constexpr split_plan<T, D> make_split_plan(const std::vector<point<T, D>>& ring, const std::vector<int>& sides,
                                           const half_space<T, D>& boundary) {
  polygon_splitter<T, D> splitter(ring);
  splitter.cut(ring, sides, boundary);
  split_plan<T, D> plan{{}, splitter.parts(1), splitter.parts(-1)};
  plan.entries = splitter.take_entries();
  return plan;
}

// The parts of a ring with vertices on both sides.
template <int D, VertexRing R, class F>
constexpr void split_as_planned(split_parts<ring_vertex_type<R>>& parts, const R& ring, const std::vector<int>& sides,
                                const half_space<vertex_scalar<ring_vertex_type<R>>, D>& boundary,
                                const F& interpolate) {
  using V = ring_vertex_type<R>;
  using T = vertex_scalar<V>;
  std::vector<point<T, D>> positions;
  positions.reserve(sides.size());
  for (std::size_t i = 0; i < sides.size(); ++i) positions.push_back(as_point<T>(position_of(ring[i])));
  split_plan<T, D> plan;
  if constexpr (Floating<T>)
    plan = plan_of_split(positions, sides, boundary);
  else
    plan = make_split_plan(positions, sides, boundary);
  std::vector<V> vertices;
  vertices.reserve(plan.entries.size());
  for (const auto& e : plan.entries)
    if (e.back == e.front)
      vertices.push_back(ring[e.back]);
    else
      vertices.push_back(
          placed_at(V(interpolate(V(ring[e.front]), V(ring[e.back]), e.t)), own_point<vertex_position<V>>(e.at)));
  const auto put = [&](std::vector<std::vector<V>>& out, const std::vector<std::vector<std::uint32_t>>& rings) {
    for (const auto& numbers : rings) {
      out.emplace_back().reserve(numbers.size());
      for (const std::uint32_t k : numbers) out.back().push_back(vertices[k]);
    }
  };
  put(parts.front, plan.front);
  put(parts.back, plan.back);
}

template <int D, VertexRing R, class F>
constexpr split_parts<ring_vertex_type<R>> split(const R& ring,
                                                 const half_space<vertex_scalar<ring_vertex_type<R>>, D>& boundary,
                                                 const F& interpolate) {
  using V = ring_vertex_type<R>;
  split_parts<V> parts;
  bool finite = true, any_front = false, any_back = false;
  for (const auto& x : boundary.numbers) finite = finite && is_finite(x);
  std::vector<int> sides;
  for (std::size_t i = 0; i < ring.size() && finite; ++i) {
    const auto& p = position_of(ring[i]);
    for (int k = 0; k < D; ++k) finite = finite && is_finite(coordinate(p, k));
    if (!finite) break;
    sides.push_back(half_space_side(boundary, p));
    any_front = any_front || sides.back() > 0;
    any_back = any_back || sides.back() < 0;
  }
  parts.side = !finite                 ? split_side::not_finite
               : any_front && any_back ? split_side::both
               : any_front             ? split_side::front
               : any_back              ? split_side::back
                                       : split_side::on;
  const auto whole = [&] {
    std::vector<V> copy;
    for (std::size_t i = 0; i < ring.size(); ++i) copy.push_back(ring[i]);
    return copy;
  };
  if (parts.side == split_side::front) parts.front.push_back(whole());
  if (parts.side == split_side::back) parts.back.push_back(whole());
  if (parts.side != split_side::both) return parts;
  split_as_planned<D>(parts, ring, sides, boundary, interpolate);
  return parts;
}
}  // namespace IRG_ABI
}  // namespace irg::detail

namespace irg::inline IRG_ABI {

template <VertexRing R, Plane P, class F>
  requires(size_of<vertex_position<ring_vertex_type<R>>> == 3 && Real<vertex_scalar<ring_vertex_type<R>>> &&
           std::same_as<plane_scalar<P>, vertex_scalar<ring_vertex_type<R>>>)
[[nodiscard]] constexpr split_parts<ring_vertex_type<R>> split_polygon(const R& ring, const P& plane,
                                                                       const F& interpolate) {
  return detail::split<3>(ring,
                          {{plane_coefficient(plane, 0), plane_coefficient(plane, 1), plane_coefficient(plane, 2),
                            plane_coefficient(plane, 3)}},
                          interpolate);
}

template <VertexRing R, class F>
  requires(size_of<vertex_position<ring_vertex_type<R>>> == 2 && Real<vertex_scalar<ring_vertex_type<R>>>)
[[nodiscard]] constexpr split_parts<ring_vertex_type<R>> split_polygon(const R& ring,
                                                                       const vertex_position<ring_vertex_type<R>>& from,
                                                                       const vertex_position<ring_vertex_type<R>>& over,
                                                                       const F& interpolate) {
  return detail::split<2>(ring, {{coordinate(from, 0), coordinate(from, 1), coordinate(over, 0), coordinate(over, 1)}},
                          interpolate);
}

}  // namespace irg::inline IRG_ABI

#if IRG_BODIES
namespace irg::detail::inline IRG_COMPILED_ABI {

template <Floating T, int D>
IRG_API split_plan<T, D> plan_of_split(const std::vector<point<T, D>>& ring, const std::vector<int>& sides,
                                       const half_space<T, D>& boundary) {
  return make_split_plan(ring, sides, boundary);
}

}  // namespace irg::detail::inline IRG_COMPILED_ABI
#endif
