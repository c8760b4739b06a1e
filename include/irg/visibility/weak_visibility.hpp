// SPDX-License-Identifier: MIT
// From where in the plane all of a source is seen, some of it, or nothing: weak visibility from a segment; light,
// penumbra and umbra of a point, a segment or an area that shines; what two regions see of each other.
//
// What is seen changes at obstacles, and at sight lines to the source past two ends. These cut the window into parts,
// each of which sees as much as one place in it does.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include <irg/core/vocabulary.hpp>
#include <irg/geometry/box.hpp>
#include <irg/geometry/vocabulary.hpp>
#include <irg/visibility/sight_result.hpp>
#if IRG_BODIES
#include <irg/core/is_finite.hpp>
#include <irg/geometry/convex_hull.hpp>
#include <irg/geometry/intersect_segments.hpp>
#include <irg/geometry/orient2d.hpp>
#include <irg/geometry/point_in_polygon.hpp>
#include <irg/geometry/polygon_convexity.hpp>
#include <irg/geometry/polygon_orientation.hpp>
#include <irg/visibility/detail/sight_arrangement.hpp>
#include <irg/visibility/detail/source_view.hpp>
#endif

namespace irg {
inline namespace IRG_COMPILED_ABI {

/// The parts of the window from where all of the source is seen, some of it, and nothing.
/// shape   `source` is a point, the two ends of a segment, or a ring, of any direction, whose inside is part of it.
///         Source and obstacles may reach out of the window; obstacles may touch, cross, overlap and be points
/// needs   fewer than 2^15 ends
/// gives   parts that have an area, with their boundaries; what is seen by no more than a point of the source counts
///         as nothing. No rings where the window is empty or flat, and for what sight_result.hpp calls not answered
/// exact   every decision, for all finite floats and doubles; vertices are given points, bit for bit, or correctly
///         rounded crossings of lines through two given points
/// cost    n ends have n^2 sight lines, of which those that obstacles cut off are skipped; the m others meet in up to
///         m^2 places, each of which costs n log n. Made for plans of some dozens of walls
/// source  irg's own, by the critical lines of Suri and O'Rourke 1986
template <Floating T>
[[nodiscard]] IRG_API source_regions<T> weak_visibility(std::span<const point<T, 2>> source,
                                                        std::span<const std::type_identity_t<segment<T, 2>>> obstacles,
                                                        const box<T, 2>& window);

/// The same for an area with holes, or several of them as one source: what is inside of an odd number of rings; or for
/// several segments, lists of two points each, which may touch and cross.
/// needs   rings that meet neither each other nor themselves, else the status says so
template <Floating T>
[[nodiscard]] IRG_API source_regions<T> weak_visibility(std::span<const std::vector<point<T, 2>>> source,
                                                        std::span<const std::type_identity_t<segment<T, 2>>> obstacles,
                                                        const box<T, 2>& window);

/// What a point, a segment or an area sees of the inside of a ring, and it of them: each place in one each place in the
/// other, some of them, or nothing.
/// shape   the source as for weak_visibility; `region` is a ring that does not meet itself. Neither stops sight
/// gives   what is seen in single lines only counts as nothing; `none` beside every status but `ok`
/// exact   for all finite floats and doubles
/// cost    as weak_visibility
template <Floating T>
[[nodiscard]] IRG_API checked<seen_share, visibility_status> sight_between(
    std::span<const point<T, 2>> source, std::span<const std::type_identity_t<point<T, 2>>> region,
    std::span<const std::type_identity_t<segment<T, 2>>> obstacles);

}  // namespace IRG_COMPILED_ABI

inline namespace IRG_ABI {

/// weak_visibility for the segment from source.a to source.b.
template <Floating T>
[[nodiscard]] constexpr source_regions<T> weak_visibility(
    const segment<T, 2>& source, std::span<const std::type_identity_t<segment<T, 2>>> obstacles,
    const box<T, 2>& window) {
  const point<T, 2> ends[] = {source.a, source.b};
  return weak_visibility(std::span<const point<T, 2>>(ends), obstacles, window);
}

}  // namespace IRG_ABI
}  // namespace irg

#if IRG_BODIES
namespace irg::detail::inline IRG_ABI {

// Rings as the outline of a region: that they meet neither each other nor themselves, and which way each has to run so
// that the region lies to its left.

template <Floating T>
using plane_ring = std::vector<point<T, 2>>;

// The ring without corners that repeat the one before.
template <Floating T, class Ring>
constexpr plane_ring<T> without_repeats(const Ring& ring) {
  plane_ring<T> out;
  for (const point<T, 2>& p : ring)
    if (out.empty() || !(out.back() == p)) out.push_back(p);
  while (out.size() > 1 && out.back() == out.front()) out.pop_back();
  return out;
}

// Whether two edges have more in common than the end of the first, where the second begins.
template <Floating T>
constexpr bool edges_touch(const segment<T, 2>& e, const segment<T, 2>& f, bool is_next) noexcept {
  const auto common = intersect_segments(e, f);
  return common.relation == segment_relation::overlap || (common.relation == segment_relation::point && !is_next);
}

// Whether no edge touches another one, but for neighbours at their corner.
// needs   rings without repeats
// cost    the square of the corners
template <Floating T>
constexpr bool are_apart(const std::vector<plane_ring<T>>& rings) noexcept {
  struct edge {
    segment<T, 2> s;
    std::size_t ring, index;
  };
  std::vector<edge> edges;
  for (std::size_t r = 0; r < rings.size(); ++r) {
    const std::size_t n = rings[r].size();
    if (n < 3) return false;
    for (std::size_t i = 0; i < n; ++i) edges.push_back({{rings[r][i], rings[r][(i + 1) % n]}, r, i});
  }
  for (std::size_t k = 0; k < edges.size(); ++k)
    for (std::size_t i = 0; i < k; ++i) {
      const edge &e = edges[i], &f = edges[k];
      const bool is_last = f.index + 1 == rings[f.ring].size() && e.index == 0;
      const bool is_next = e.ring == f.ring && (f.index == e.index + 1 || is_last);
      if (edges_touch(e.s, f.s, is_next)) return false;
    }
  return true;
}

// Turns each ring so that the region of all of them, by the even-odd rule, lies to its left.
// needs   rings that are apart
template <Floating T>
constexpr void turn_outwards(std::vector<plane_ring<T>>& rings) {
  for (std::size_t i = 0; i < rings.size(); ++i) {
    bool is_hole = false;
    for (std::size_t k = 0; k < rings.size(); ++k)
      if (k != i && point_in_polygon(rings[k], rings[i][0], fill_rule::even_odd) == location::inside)
        is_hole = !is_hole;
    const bool runs_left = orientation_of(rings[i]) == orientation::counter_clockwise;
    if (runs_left == is_hole) reverse_ring(rings[i]);
  }
}

// From a source and obstacles to the rings of the parts that see all, some and none of it.

// Which sight lines cut the window: those at which something can change, or all, for the same parts in smaller pieces.
enum class line_choice { needed, all };

// The rings around the parts of one kind: label[e] is the kind of the part to the left of half-edge e.
template <Floating T>
constexpr std::vector<std::vector<point<T, 2>>> rings_around(const sight_arrangement<T>& parts,
                                                             const std::vector<int>& label, int kind) {
  const auto& edges = parts.edges;
  std::vector<std::uint8_t> used(edges.size(), std::uint8_t{0});
  std::vector<std::vector<point<T, 2>>> rings;
  const auto is_border = [&](std::uint32_t e) { return label[e] == kind && label[e ^ 1u] != kind; };
  const auto following = [&](std::uint32_t e) {
    for (e = edges[e].next; !is_border(e);) e = edges[e ^ 1u].next;
    return e;
  };
  for (std::uint32_t start = 0; start < edges.size(); ++start) {
    if (used[start] != 0 || !is_border(start)) continue;
    std::vector<point<T, 2>> ring;
    for (std::uint32_t e = start; used[e] == 0; e = following(e)) {
      used[e] = 1;
      const std::uint32_t next = following(e);
      const bool goes_straight =
          turn_between(direction_of(parts, edges[e]), direction_of(parts, edges[next])) == 0 && next != (e ^ 1u);
      if (!goes_straight) ring.push_back(parts.vertices[edges[next].origin].at);
    }
    if (ring.size() > 2) rings.push_back(std::move(ring));
  }
  return rings;
}

template <Floating T>
struct weak_visibility_state {
  box<T, 2> bounds{};
  std::vector<segment<T, 2>> window{};  // its outline, the inside to the left
  source_view<T> view{};
  sight_arrangement<T> parts{};
};

template <Floating T>
constexpr visibility_status take_window(weak_visibility_state<T>& s, const box<T, 2>& window) {
  const point<T, 2>&low = window.low, &high = window.high;
  s.bounds = window;
  const std::array<point<T, 2>, 4> corners{low, point<T, 2>{high.x, low.y}, high, point<T, 2>{low.x, high.y}};
  for (std::size_t i = 0; i < 4; ++i) s.window.push_back({corners[i], corners[(i + 1) % 4]});
  return window.empty() || is_finite(low, high) ? visibility_status::ok : visibility_status::not_finite;
}

// The inside of a ring as the window.
template <Floating T>
constexpr visibility_status take_window(weak_visibility_state<T>& s, std::span<const point<T, 2>> ring) {
  if (!is_finite(ring)) return visibility_status::not_finite;
  std::vector<plane_ring<T>> rings(1, without_repeats<T>(ring));
  if (!are_apart(rings)) return visibility_status::window_not_simple;
  turn_outwards(rings);
  const std::size_t n = rings[0].size();
  for (std::size_t i = 0; i < n; ++i) {
    s.bounds = bounding_box(s.bounds, rings[0][i]);
    s.window.push_back({rings[0][i], rings[0][(i + 1) % n]});
  }
  return visibility_status::ok;
}

template <Floating T>
constexpr visibility_status take_rings(source_view<T>& view, std::vector<plane_ring<T>> rings) {
  if (rings.empty()) return visibility_status::source_not_simple;
  bool are_segments = true;
  for (const auto& ring : rings) are_segments = are_segments && ring.size() == 2;
  if (!are_segments && !are_apart(rings)) return visibility_status::source_not_simple;
  if (!are_segments) turn_outwards(rings);
  for (const auto& ring : rings) add_source(view, ring);
  return visibility_status::ok;
}

template <Floating T>
constexpr visibility_status take_source(source_view<T>& view, std::span<const point<T, 2>> source) {
  if (source.empty()) return visibility_status::source_not_simple;
  if (!is_convex(source)) return take_rings(view, std::vector<plane_ring<T>>(1, without_repeats<T>(source)));
  plane_ring<T> corners;
  for (const std::uint32_t i : convex_hull(source)) corners.push_back(source[i]);
  add_source(view, corners);
  return visibility_status::ok;
}

template <Floating T>
constexpr visibility_status take_source(source_view<T>& view, std::span<const plane_ring<T>> source) {
  std::vector<plane_ring<T>> rings;
  for (const auto& ring : source) rings.push_back(without_repeats<T>(ring));
  return take_rings(view, std::move(rings));
}

// Takes what is given, in the order in which the status tells of it. The window is a box or a ring, the source the
// points of one ring or a list of rings.
template <Floating T, class Window, class Source>
constexpr visibility_status take_all(weak_visibility_state<T>& s, const Window& window, std::span<const Source> source,
                                     std::span<const segment<T, 2>> obstacles) {
  const visibility_status of_window = take_window(s, window);
  bool all_finite = of_window != visibility_status::not_finite;
  for (const auto& p : source) all_finite = all_finite && is_finite(p);  // a point or a ring of them
  for (const auto& o : obstacles) all_finite = all_finite && is_finite(o.a, o.b);
  if (!all_finite) return visibility_status::not_finite;
  if (of_window != visibility_status::ok) return of_window;
  s.view.obstacles.assign(obstacles.begin(), obstacles.end());
  if (const auto status = take_source(s.view, source); status != visibility_status::ok) return status;
  return crosses_obstacle(s.view) ? visibility_status::source_crosses_obstacle : visibility_status::ok;
}

template <Floating T>
constexpr void add_cuts(weak_visibility_state<T>& s, line_choice choice, source_regions<T>& out) {
  auto& cuts = s.parts.cuts;
  s.parts.sources = s.view.source;
  std::vector<point<T, 2>> ends;
  const auto add_end = [&](const point<T, 2>& p) {
    for (const auto& e : ends)
      if (e == p) return;
    ends.push_back(p);
  };
  for (const auto& p : s.view.source) add_end(p);
  for (const auto& o : s.view.obstacles) {
    add_end(o.a);
    add_end(o.b);
    if (!(o.a == o.b)) cuts.push_back({o, false, choice == line_choice::needed});
  }
  const std::size_t step = s.view.has_area ? 1 : 2;  // segments are there and back
  for (std::size_t i = 0; i < s.view.outline.size(); i += step) cuts.push_back({s.view.outline[i], false, false});
  for (const auto& u : ends)
    for (const auto& v : ends) {
      if (u == v) continue;
      ++out.lines;
      if (choice == line_choice::all || matters_beyond(s.view, u, v))
        cuts.push_back({{u, v}, true, false});
      else
        ++out.skipped;
    }
  for (const auto& side : s.window) cuts.push_back({side, false, false});
}

template <Floating T>
constexpr int label_beside(const weak_visibility_state<T>& s, std::uint32_t edge) {
  const auto side = [&](const point<T, 2>& u, const point<T, 2>& v) { return side_beside(s.parts, edge, u, v); };
  if (!holds_place(s.window, side)) return -1;
  return static_cast<int>(share_seen(s.view, side));
}

// For each half-edge the share of the source that is seen from the part to its left; -1 out of the window.
template <Floating T>
constexpr std::vector<int> label_edges(const weak_visibility_state<T>& s) {
  const auto& edges = s.parts.edges;
  constexpr int unknown = -2;
  std::vector<int> label(edges.size(), unknown);
  for (std::uint32_t e = 0; e < edges.size(); ++e) {
    if (label[e] != unknown) continue;
    std::uint32_t best = e;  // where the origin is given, sides cost least
    for (std::uint32_t k = edges[e].next; k != e; k = edges[k].next)
      if (s.parts.vertices[edges[k].origin].is_given) best = k;
    const int share = label_beside(s, best);
    std::uint32_t k = e;
    do {
      label[k] = share;
      k = edges[k].next;
    } while (k != e);
  }
  return label;
}

// The share of the source that is seen, as label_edges gives it, once the window is cut into its parts.
template <Floating T>
constexpr std::vector<int> cut_window(weak_visibility_state<T>& s, line_choice choice, source_regions<T>& out) {
  add_cuts(s, choice, out);
  build_arrangement(s.parts, s.bounds);
  return label_edges(s);
}

template <Floating T, class Source>
constexpr source_regions<T> regions_of_source(const box<T, 2>& window, std::span<const Source> source,
                                              std::span<const segment<T, 2>> obstacles, line_choice choice) {
  weak_visibility_state<T> s;
  source_regions<T> out;
  out.status = take_all(s, window, source, obstacles);
  const bool has_area = window.low.x < window.high.x && window.low.y < window.high.y;
  if (out.status != visibility_status::ok || !has_area) return out;
  const std::vector<int> label = cut_window(s, choice, out);
  out.all = rings_around(s.parts, label, static_cast<int>(seen_share::all));
  out.some = rings_around(s.parts, label, static_cast<int>(seen_share::some));
  out.none = rings_around(s.parts, label, static_cast<int>(seen_share::none));
  return out;
}

}  // namespace irg::detail::inline IRG_ABI

namespace irg::inline IRG_COMPILED_ABI {

template <Floating T>
[[nodiscard]] IRG_API source_regions<T> weak_visibility(std::span<const point<T, 2>> source,
                                                        std::span<const std::type_identity_t<segment<T, 2>>> obstacles,
                                                        const box<T, 2>& window) {
  return detail::regions_of_source(window, source, obstacles, detail::line_choice::needed);
}

template <Floating T>
[[nodiscard]] IRG_API source_regions<T> weak_visibility(std::span<const std::vector<point<T, 2>>> source,
                                                        std::span<const std::type_identity_t<segment<T, 2>>> obstacles,
                                                        const box<T, 2>& window) {
  return detail::regions_of_source(window, source, obstacles, detail::line_choice::needed);
}

template <Floating T>
[[nodiscard]] IRG_API checked<seen_share, visibility_status> sight_between(
    std::span<const point<T, 2>> source, std::span<const std::type_identity_t<point<T, 2>>> region,
    std::span<const std::type_identity_t<segment<T, 2>>> obstacles) {
  detail::weak_visibility_state<T> s;
  const auto status = detail::take_all(s, region, source, obstacles);
  if (status != visibility_status::ok) return {seen_share::none, status};
  source_regions<T> counts;
  bool all = true, none = true;
  for (const int share : detail::cut_window(s, detail::line_choice::needed, counts)) {
    all = all && (share < 0 || share == static_cast<int>(seen_share::all));
    none = none && (share < 0 || share == static_cast<int>(seen_share::none));
  }
  return {none ? seen_share::none : all ? seen_share::all : seen_share::some, status};
}

}  // namespace irg::inline IRG_COMPILED_ABI
#endif
