// SPDX-License-Identifier: MIT
// The visibility polygon: what is seen in the plane from a point, among segments that may touch, cross, overlap or be
// points, within a box or within rings with holes.
//
// The directions to all ends are sorted; then, from pairs up, lists of what is nearest in which directions are merged.
// Of segments that cross only the crossings that are seen are ever looked at, however many there are.
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include <irg/core/ring.hpp>
#include <irg/core/scalar.hpp>
#include <irg/geometry/box.hpp>
#include <irg/geometry/polygon.hpp>
#include <irg/geometry/vocabulary.hpp>
#include <irg/visibility/sight_result.hpp>
#if IRG_BODIES
#include <irg/core/is_finite.hpp>
#include <irg/geometry/compare.hpp>
#include <irg/geometry/crossing_point.hpp>
#include <irg/visibility/detail/sight_envelope.hpp>
#endif

namespace irg {
inline namespace IRG_ABI {

/// What is seen from the source, counter-clockwise: all points to which the way from the source meets no obstacle
/// before its end and leaves the domain nowhere.
/// shape   `domain` is a ring or a list of rings; `options.rule` says what is inside. All its edges stop sight, also
///         with the inside on both sides. Obstacles may be points, and may reach out of the domain
/// needs   fewer than 2^28 obstacles and edges
/// gives   with closed obstacles the polygon without parts of no width; open ones let sight pass between ends that
///         touch, in needles to what stops it and back. Obstacles through the source, and such as are seen edge-on,
///         stop no sight but along themselves. `source_outside` and nothing where the source is not in the domain, in
///         an empty one, too; from its boundary the parts inside are seen, with the source as a vertex
/// exact   every decision, for all finite floats and doubles. Vertices are ends of obstacles and edges, bit for bit,
///         or where two cross, or a sight line past an end meets one, correctly rounded
/// cost    sorts n directions and merges n lists; O(n log n), with a factor that grows as the inverse of Ackermann's
///         function where obstacles cross
/// source  Hershberger 1989 (what is nearest, by merging); Suri and O'Rourke 1986 (the polygon)
template <Floating T, PlanePolygon Domain>
  requires std::same_as<scalar_of<polygon_point<Domain>>, T>
[[nodiscard]] constexpr visible_region<T> visibility_polygon(
    const point<T, 2>& source, const Domain& domain,
    std::span<const std::type_identity_t<segment<T, 2>>> obstacles = {}, const sight_options& options = {});

/// The same in a box.
template <Floating T>
[[nodiscard]] constexpr visible_region<T> visibility_polygon(
    const point<T, 2>& source, const box<T, 2>& domain,
    std::span<const std::type_identity_t<segment<T, 2>>> obstacles = {}, const sight_options& options = {});

/// The same, and adds to the counts what it took. Where there is no polygon, all walls are passed over.
template <Floating T, PlanePolygon Domain>
  requires std::same_as<scalar_of<polygon_point<Domain>>, T>
[[nodiscard]] constexpr visible_region<T> visibility_polygon(
    const point<T, 2>& source, const Domain& domain, std::span<const std::type_identity_t<segment<T, 2>>> obstacles,
    const sight_options& options, sight_counts& counts);

/// The same in a box. An empty box has no edges.
template <Floating T>
[[nodiscard]] constexpr visible_region<T> visibility_polygon(
    const point<T, 2>& source, const box<T, 2>& domain, std::span<const std::type_identity_t<segment<T, 2>>> obstacles,
    const sight_options& options, sight_counts& counts);

}  // namespace IRG_ABI
}  // namespace irg

namespace irg::detail::inline IRG_COMPILED_ABI {

// The visibility polygon within the edges of a domain, ring by ring.
template <Floating T>
IRG_API visible_region<T> region_within(const point<T, 2>& source, std::span<const segment<T, 2>> boundary,
                                        std::span<const segment<T, 2>> obstacles, const sight_options& options);
template <Floating T>
IRG_API visible_region<T> counted_region_within(const point<T, 2>& source, std::span<const segment<T, 2>> boundary,
                                                std::span<const segment<T, 2>> obstacles, const sight_options& options,
                                                sight_counts& counts);

}  // namespace irg::detail::inline IRG_COMPILED_ABI

namespace irg::detail::inline IRG_ABI {

template <Floating T, PlaneRing R>
constexpr void append_edges(std::vector<segment<T, 2>>& edges, const R& ring) {
  const auto vertex = [&](std::size_t i) {
    const auto v = ring_vertex(ring, i);
    return point<T, 2>{coordinate(v, 0), coordinate(v, 1)};
  };
  const std::size_t n = ring_size(ring);
  for (std::size_t i = 0; i < n; ++i) edges.push_back({vertex(i), vertex(i + 1)});
}

template <Floating T, PlanePolygon Domain>
constexpr std::vector<segment<T, 2>> edges_of_domain(const Domain& domain) {
  std::vector<segment<T, 2>> edges;
  if constexpr (PlaneRing<Domain>)
    append_edges(edges, domain);
  else
    for (std::size_t i = 0; i < std::size(domain); ++i) append_edges(edges, domain[i]);
  return edges;
}

// needs   a box that is not empty
template <Floating T>
constexpr std::array<segment<T, 2>, 4> edges_of_box(const box<T, 2>& domain) noexcept {
  const point<T, 2>&low = domain.low, &high = domain.high, right{high.x, low.y}, left{low.x, high.y};
  return {{{low, right}, {right, high}, {high, left}, {left, low}}};
}

}  // namespace irg::detail::inline IRG_ABI

namespace irg::inline IRG_ABI {

template <Floating T, PlanePolygon Domain>
  requires std::same_as<scalar_of<polygon_point<Domain>>, T>
[[nodiscard]] constexpr visible_region<T> visibility_polygon(
    const point<T, 2>& source, const Domain& domain, std::span<const std::type_identity_t<segment<T, 2>>> obstacles,
    const sight_options& options) {
  return detail::region_within<T>(source, detail::edges_of_domain<T>(domain), obstacles, options);
}

template <Floating T>
[[nodiscard]] constexpr visible_region<T> visibility_polygon(
    const point<T, 2>& source, const box<T, 2>& domain, std::span<const std::type_identity_t<segment<T, 2>>> obstacles,
    const sight_options& options) {
  if (domain.empty()) return {visibility_status::source_outside, {}};
  return detail::region_within<T>(source, detail::edges_of_box(domain), obstacles, options);
}

template <Floating T, PlanePolygon Domain>
  requires std::same_as<scalar_of<polygon_point<Domain>>, T>
[[nodiscard]] constexpr visible_region<T> visibility_polygon(
    const point<T, 2>& source, const Domain& domain, std::span<const std::type_identity_t<segment<T, 2>>> obstacles,
    const sight_options& options, sight_counts& counts) {
  return detail::counted_region_within<T>(source, detail::edges_of_domain<T>(domain), obstacles, options, counts);
}

template <Floating T>
[[nodiscard]] constexpr visible_region<T> visibility_polygon(
    const point<T, 2>& source, const box<T, 2>& domain, std::span<const std::type_identity_t<segment<T, 2>>> obstacles,
    const sight_options& options, sight_counts& counts) {
  const auto walls = static_cast<std::int64_t>(obstacles.size());
  if (domain.empty()) {
    counts += {.walls = walls, .passed_over = walls};
    return {visibility_status::source_outside, {}};
  }
  return detail::counted_region_within<T>(source, detail::edges_of_box(domain), obstacles, options, counts);
}

}  // namespace irg::inline IRG_ABI

#if IRG_BODIES
namespace irg::detail::inline IRG_ABI {

// From obstacles and edges to the ring of a visibility polygon: what stops sight and where the source lies, then the
// nearest in each direction, then the vertices.

template <Floating T, class Tally = no_sight_tally>
class visible_ring_builder {
public:
  constexpr visible_ring_builder(const point<T, 2>& source, const sight_options& options) : options_(options) {
    envelope_.source = source;
    is_finite_ = is_finite(source);
  }

  constexpr void expect_obstacles(std::size_t count) { envelope_.edges.reserve(count + 16); }

  constexpr void add_obstacle(const segment<T, 2>& s, std::size_t index) {
    const bool stops_at_ends = options_.ends == obstacle_ends::closed;
    if (add_edge(s.a, s.b, index, false)) on_obstacle_ = true;
    if (s.a == s.b && s.a == envelope_.source && stops_at_ends) on_obstacle_ = true;
  }

  constexpr void add_boundary(const segment<T, 2>& edge) { add_boundary(edge.a, edge.b); }

  constexpr visible_region<T> run() {
    if (!is_finite_) return {visibility_status::not_finite, {}};
    order_directions();
    const bool is_on_boundary = !through_.empty();
    if (!is_on_boundary && !is_inside(winding_)) return {visibility_status::source_outside, {}};
    if (is_on_boundary && !cover_outside()) return {visibility_status::source_outside, {}};
    merge_envelope(envelope_);
    walk();
    out_.status = is_on_boundary ? visibility_status::source_on_boundary
                  : on_obstacle_ ? visibility_status::source_on_obstacle
                                 : visibility_status::ok;
    return std::move(out_);
  }

  // What run() took among so many obstacles. An obstacle that the source lies on may be two edges.
  constexpr sight_counts counts(std::size_t obstacles) const
    requires std::same_as<Tally, sight_tally>
  {
    std::vector<std::uint8_t> was_compared(obstacles + boundary_edges_, std::uint8_t{0});
    for (std::size_t i = 0; i < envelope_.tally.was_compared.size(); ++i) {
      const auto& e = envelope_.edges[i];
      if (envelope_.tally.was_compared[i] != 0) was_compared[e.is_boundary ? obstacles + e.index : e.index] = 1;
    }
    sight_counts out{.walls = static_cast<std::int64_t>(was_compared.size()),
                     .directions = ranks(envelope_),
                     .compared = envelope_.tally.pairs,
                     .crossings = envelope_.tally.crossings};
    for (const std::uint8_t compared : was_compared) out.passed_over += 1 - compared;
    return out;
  }

private:
  // An edge of the domain runs from the source to this point, or from there to the source: how much greater the winding
  // number is on the left of the way there than on its right.
  struct boundary_ray {
    point<T, 2> to;
    int step;
  };

  sight_options options_;
  sight_envelope<T, Tally> envelope_{};
  std::vector<boundary_ray> through_{};
  visible_region<T> out_{};
  std::size_t boundary_edges_ = 0;
  int winding_ = 0;  // just above the source's right
  bool is_finite_ = true, on_obstacle_ = false;

  constexpr bool is_inside(int winding) const noexcept {
    return options_.rule == fill_rule::even_odd ? winding % 2 != 0 : winding != 0;
  }

  // Whether the source lies on it.
  constexpr bool add_edge(const point<T, 2>& a, const point<T, 2>& b, std::size_t index, bool is_boundary) {
    const point<T, 2>& source = envelope_.source;
    is_finite_ = is_finite_ && is_finite(a, b);
    if (!is_finite_ || a == b) return false;
    const auto number = static_cast<std::uint32_t>(index);
    const int turn = orient2d(source, a, b);
    if (turn != 0) {
      envelope_.edges.push_back({turn > 0 ? a : b, turn > 0 ? b : a, 0, 0, number, is_boundary, false});
      return false;
    }
    const bool is_on = is_between_ends(a, b, source);
    if (options_.ends == obstacle_ends::closed) return is_on;
    const bool a_first = is_between_ends(source, b, a);
    const auto add = [&](const point<T, 2>& nearest, const point<T, 2>& end) {
      if (!(end == source)) envelope_.edges.push_back({nearest, end, 0, 0, number, is_boundary, true});
    };
    if (!is_on) {
      add(a_first ? a : b, a_first ? b : a);
    } else {
      add(source, a);
      add(source, b);
    }
    return is_on;
  }

  constexpr void add_boundary(const point<T, 2>& a, const point<T, 2>& b) {
    const point<T, 2>& source = envelope_.source;
    if (add_edge(a, b, boundary_edges_++, true)) {
      if (!(b == source)) through_.push_back({b, 1});
      if (!(a == source)) through_.push_back({a, -1});
    } else if (is_finite_ && (source.y < a.y) != (source.y < b.y)) {
      const bool up = source.y < b.y;
      if ((orient2d(a, b, source) > 0) == up) winding_ += up ? 1 : -1;
    }
  }

  constexpr void order_directions() {
    auto& edges = envelope_.edges;
    std::vector<point<T, 2>> points;
    points.reserve(2 * (edges.size() + through_.size()));
    for (const auto& e : edges) {
      points.push_back(e.is_edge_on ? e.b : e.a);
      points.push_back(e.b);
    }
    for (const auto& ray : through_) points.push_back(ray.to);
    const directions<T> sorted = ordered_directions(envelope_.source, points);
    for (const std::uint32_t i : sorted.first) envelope_.towards.push_back(points[sorted.order[i]]);
    for (std::size_t i = 0; i < edges.size(); ++i) {
      edges[i].start = sorted.rank[2 * i];
      edges[i].finish = sorted.rank[2 * i + 1];
    }
    envelope_.nearest.reserve(2 * edges.size() + 16);
    for (const std::uint32_t i : sorted.order)
      if (i % 2 == 0 && i / 2 < edges.size()) cover(i / 2);
    steps_.assign(through_.empty() ? 0 : envelope_.towards.size(), 0);
    for (std::size_t i = 0; i < through_.size(); ++i) steps_[sorted.rank[2 * edges.size() + i]] += through_[i].step;
  }
  std::vector<int> steps_{};  // of the winding number, by rank

  constexpr void cover(std::uint32_t edge) {
    const sight_edge<T>& e = envelope_.edges[edge];
    const std::uint32_t from = 2 * e.start, to = 2 * (e.finish < e.start ? e.finish + ranks(envelope_) : e.finish);
    if (e.is_edge_on)
      cover_slots(envelope_, edge, from, from + 1);
    else if (options_.ends == obstacle_ends::closed)
      cover_slots(envelope_, edge, from, to);
    else if (e.is_boundary)
      cover_slots(envelope_, edge, from, to + 1);
    else
      cover_slots(envelope_, edge, from + 1, to);
  }

  // Hides the directions that lead out of the domain at once; false when all do.
  constexpr bool cover_outside() {
    const std::uint32_t n = ranks(envelope_);
    const point<T, 2>&source = envelope_.source, &first = envelope_.towards[0];
    std::vector<std::uint32_t> changes;
    bool any = false;
    int winding = winding_;
    for (std::uint32_t r = 0; r < n; ++r) {
      if (r > 0 || !(first.y == source.y && source.x < first.x)) winding += steps_[r];
      any = any || is_inside(winding);
      if (!is_inside(winding)) changes.push_back(r);
    }
    const std::uint32_t more = options_.ends == obstacle_ends::closed ? 0 : 1;
    for (std::size_t i = 0, k = 0; i < changes.size() && any; i = k) {
      for (k = i + 1; k < changes.size() && changes[k] == changes[k - 1] + 1;) ++k;
      cover_slots(envelope_, at_source, 2 * changes[i], 2 * (changes[k - 1] + 1) + more);
    }
    return any;
  }

  constexpr void push(const point<T, 2>& at, std::uint32_t edge) {
    if (edge == no_sight_edge || edge == at_source) {
      out_.ring.push_back({at, sight_stop::nothing, 0});
    } else {
      const auto& e = envelope_.edges[edge];
      out_.ring.push_back({at, e.is_boundary ? sight_stop::boundary : sight_stop::obstacle, e.index});
    }
  }

  constexpr point<T, 2> crossing_with(const segment<T, 2>& line, std::uint32_t edge) const {
    const auto& e = envelope_.edges[edge];
    return *intersection_point(line, segment<T, 2>{e.a, e.b});
  }
  constexpr point<T, 2> seen_at(std::uint32_t edge, std::uint32_t rank) const {
    const auto& e = envelope_.edges[edge];
    if (e.is_edge_on || e.start == rank) return e.a;
    if (e.finish == rank) return e.b;
    return crossing_with({envelope_.source, envelope_.towards[rank]}, edge);
  }

  // Whether sight in this direction goes on past the point p to the edge.
  constexpr bool is_beyond(std::uint32_t edge, const point<T, 2>& p) const noexcept {
    if (edge == at_source || edge == no_sight_edge) return false;
    const auto& e = envelope_.edges[edge];
    if (e.is_edge_on) return is_between_ends(envelope_.source, e.a, p) && !(e.a == p);
    return orient2d(e.a, e.b, p) > 0;
  }

  // The vertices in the direction of a rank: `before` is seen before it, `there` in it, `after` after it.
  constexpr void turn_to(std::uint32_t rank, std::uint32_t before, std::uint32_t there, std::uint32_t after) {
    if (before == after) return;
    if (before == at_source) return push(seen_at(after, rank), after);
    if (after == at_source) {
      push(seen_at(before, rank), no_sight_edge);
      return push(envelope_.source, no_sight_edge);
    }
    const auto &e = envelope_.edges[before], &f = envelope_.edges[after];
    const bool ends = e.finish == rank, starts = f.start == rank;
    if (ends && starts && is_beyond(there, e.b) && is_beyond(there, f.a)) {
      push(e.b, no_sight_edge);
      push(seen_at(there, rank), no_sight_edge);
      return push(f.a, after);
    }
    if (!ends && !starts) return push(crossing_with({e.a, e.b}, after), after);
    const bool at_one = ends ? orient2d(f.a, f.b, e.b) == 0 : orient2d(e.a, e.b, f.a) == 0;
    if (at_one) return push(ends ? e.b : f.a, after);
    push(seen_at(before, rank), no_sight_edge);
    push(seen_at(after, rank), after);
  }

  constexpr void walk() {
    const auto& list = envelope_.nearest;
    const std::size_t n = list.size() - 1;  // the last one says that the turn is over
    std::uint32_t before = list[n - 1].edge;
    out_.ring.reserve(2 * n);
    for (std::size_t i = 0; i < n; ++i) {
      const auto& at = list[i].at;
      std::uint32_t there = at.slot % 2 == 0 ? list[i].edge : before, after = list[i].edge;
      if (at.a != no_sight_edge) {
        // Other edges may cross in the same direction further on, and it is these that `at` may name.
        const auto& e = envelope_.edges[before];
        push(crossing_with({e.a, e.b}, after), after);
      } else {
        const auto& next = list[i + 1].at;
        if (at.slot % 2 == 0 && next.slot == at.slot + 1 && next.a == no_sight_edge) after = list[++i].edge;
        turn_to(at.slot / 2, before, there, after);
      }
      before = after;
    }
  }
};

// Hands a sweep all that stops sight.
template <class Sweep, Floating T>
constexpr void add_walls(Sweep& sweep, std::span<const segment<T, 2>> boundary,
                         std::span<const segment<T, 2>> obstacles) {
  sweep.expect_obstacles(obstacles.size());
  for (std::size_t i = 0; i < obstacles.size(); ++i) sweep.add_obstacle(obstacles[i], i);
  for (const segment<T, 2>& edge : boundary) sweep.add_boundary(edge);
}

}  // namespace irg::detail::inline IRG_ABI

namespace irg::detail::inline IRG_COMPILED_ABI {

template <Floating T>
IRG_API visible_region<T> region_within(const point<T, 2>& source, std::span<const segment<T, 2>> boundary,
                                        std::span<const segment<T, 2>> obstacles, const sight_options& options) {
  visible_ring_builder<T> sweep(source, options);
  add_walls(sweep, boundary, obstacles);
  return sweep.run();
}

template <Floating T>
IRG_API visible_region<T> counted_region_within(const point<T, 2>& source, std::span<const segment<T, 2>> boundary,
                                                std::span<const segment<T, 2>> obstacles, const sight_options& options,
                                                sight_counts& counts) {
  visible_ring_builder<T, sight_tally> sweep(source, options);
  add_walls(sweep, boundary, obstacles);
  visible_region<T> seen = sweep.run();
  counts += sweep.counts(obstacles.size());
  return seen;
}

}  // namespace irg::detail::inline IRG_COMPILED_ABI
#endif
