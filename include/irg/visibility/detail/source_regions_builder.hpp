// SPDX-License-Identifier: MIT
// From a source and obstacles to the rings of the parts that see all, some and none of it.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include <irg/core/checked.hpp>
#include <irg/geometry/box.hpp>
#include <irg/geometry/convex_hull.hpp>
#include <irg/geometry/orient2d.hpp>
#include <irg/geometry/polygon_convexity.hpp>
#include <irg/visibility/detail/finite_point.hpp>
#include <irg/visibility/detail/sight_arrangement.hpp>
#include <irg/visibility/detail/source_rings.hpp>
#include <irg/visibility/detail/source_view.hpp>
#include <irg/visibility/sight_result.hpp>

namespace irg::detail {
inline namespace IRG_ABI {

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
          turn_between(parts.direction(edges[e]), parts.direction(edges[next])) == 0 && next != (e ^ 1u);
      if (!goes_straight) ring.push_back(parts.vertices[edges[next].origin].at);
    }
    if (ring.size() > 2) rings.push_back(std::move(ring));
  }
  return rings;
}

template <Floating T>
class source_regions_builder {
public:
  constexpr explicit source_regions_builder(const box<T, 2>& window) : bounds_(window) {
    const point<T, 2>&low = window.low, &high = window.high;
    is_flat_ = !(low.x < high.x && low.y < high.y);
    is_finite_ = is_empty(window) || (is_finite_sight_point(low) && is_finite_sight_point(high));
    const std::array<point<T, 2>, 4> corners{low, point<T, 2>{high.x, low.y}, high, point<T, 2>{low.x, high.y}};
    for (std::size_t i = 0; i < 4; ++i) window_.push_back({corners[i], corners[(i + 1) % 4]});
  }

  // In the inside of a ring.
  constexpr explicit source_regions_builder(std::span<const point<T, 2>> ring) {
    for (const auto& p : ring) is_finite_ = is_finite_ && is_finite_sight_point(p);
    if (!is_finite_) return;
    std::vector<plane_ring<T>> rings(1, without_repeats<T>(ring));
    is_simple_ = are_apart(rings);
    if (!is_simple_) return;
    turn_outwards(rings);
    const std::size_t n = rings[0].size();
    for (std::size_t i = 0; i < n; ++i) {
      bounds_ = enclosing_box(bounds_, rings[0][i]);
      window_.push_back({rings[0][i], rings[0][(i + 1) % n]});
    }
  }

  // The source is the points of one, or a list of rings.
  template <class Source>
  constexpr source_regions<T> run(std::span<const Source> source, std::span<const segment<T, 2>> obstacles,
                                  line_choice choice) {
    source_regions<T> out;
    out.status = read(source, obstacles);
    if (out.status != visibility_status::done || is_flat_) return out;
    const std::vector<int> label = cut(choice, out);
    out.all = rings_around(parts_, label, static_cast<int>(seen_share::all));
    out.some = rings_around(parts_, label, static_cast<int>(seen_share::some));
    out.none = rings_around(parts_, label, static_cast<int>(seen_share::none));
    return out;
  }

  // What the window as a whole and the source see of each other.
  constexpr checked<seen_share, visibility_status> run_whole(std::span<const point<T, 2>> source,
                                                             std::span<const segment<T, 2>> obstacles) {
    const auto status = read(source, obstacles);
    if (status != visibility_status::done) return {seen_share::none, status};
    source_regions<T> counts;
    bool all = true, none = true;
    for (const int share : cut(line_choice::needed, counts)) {
      all = all && (share < 0 || share == static_cast<int>(seen_share::all));
      none = none && (share < 0 || share == static_cast<int>(seen_share::none));
    }
    return {none ? seen_share::none : all ? seen_share::all : seen_share::some, status};
  }

private:
  box<T, 2> bounds_{};
  std::vector<segment<T, 2>> window_{};  // its outline, the inside to the left
  bool is_finite_ = true, is_flat_ = false, is_simple_ = true;
  source_view<T> view_{};
  sight_arrangement<T> parts_{};

  constexpr std::vector<int> cut(line_choice choice, source_regions<T>& out) {
    add_cuts(choice, out);
    parts_.build(bounds_);
    return labels();
  }

  constexpr visibility_status read(std::span<const point<T, 2>> source, std::span<const segment<T, 2>> obstacles) {
    for (const auto& p : source) is_finite_ = is_finite_ && is_finite_sight_point(p);
    if (const auto status = take(obstacles); status != visibility_status::done) return status;
    if (source.size() == 0) return visibility_status::source_not_simple;
    if (!is_convex(source)) {
      std::vector<plane_ring<T>> ring(1, without_repeats<T>(source));
      return take_rings(std::move(ring));
    }
    plane_ring<T> corners;
    for (const std::uint32_t i : convex_hull(source)) corners.push_back(source[i]);
    view_.add_source(corners);
    return crossing_status();
  }

  constexpr visibility_status read(std::span<const plane_ring<T>> source, std::span<const segment<T, 2>> obstacles) {
    std::vector<plane_ring<T>> rings;
    for (const auto& ring : source) {
      for (const auto& p : ring) is_finite_ = is_finite_ && is_finite_sight_point(p);
      rings.push_back(without_repeats<T>(ring));
    }
    const auto status = take(obstacles);
    return status != visibility_status::done ? status : take_rings(std::move(rings));
  }

  constexpr visibility_status take(std::span<const segment<T, 2>> obstacles) {
    for (const auto& o : obstacles) is_finite_ = is_finite_ && is_finite_sight_point(o.a) && is_finite_sight_point(o.b);
    if (!is_finite_) return visibility_status::not_finite;
    if (!is_simple_) return visibility_status::window_not_simple;
    view_.obstacles.assign(obstacles.begin(), obstacles.end());
    return visibility_status::done;
  }

  constexpr visibility_status take_rings(std::vector<plane_ring<T>> rings) {
    if (rings.empty()) return visibility_status::source_not_simple;
    bool are_segments = true;
    for (const auto& ring : rings) are_segments = are_segments && ring.size() == 2;
    if (!are_segments && !are_apart(rings)) return visibility_status::source_not_simple;
    if (!are_segments) turn_outwards(rings);
    for (const auto& ring : rings) view_.add_source(ring);
    return crossing_status();
  }

  constexpr visibility_status crossing_status() const noexcept {
    return view_.crosses_obstacle() ? visibility_status::source_crosses_obstacle : visibility_status::done;
  }

  constexpr void add_cuts(line_choice choice, source_regions<T>& out) {
    auto& cuts = parts_.cuts;
    parts_.sources = view_.source;
    std::vector<point<T, 2>> ends;
    const auto add_end = [&](const point<T, 2>& p) {
      for (const auto& e : ends)
        if (e == p) return;
      ends.push_back(p);
    };
    for (const auto& p : view_.source) add_end(p);
    for (const auto& o : view_.obstacles) {
      add_end(o.a);
      add_end(o.b);
      if (!(o.a == o.b)) cuts.push_back({o, false, choice == line_choice::needed});
    }
    const std::size_t step = view_.has_area ? 1 : 2;  // segments are there and back
    for (std::size_t i = 0; i < view_.outline.size(); i += step) cuts.push_back({view_.outline[i], false, false});
    for (const auto& u : ends)
      for (const auto& v : ends) {
        if (u == v) continue;
        ++out.lines;
        if (choice == line_choice::all || view_.matters_beyond(u, v))
          cuts.push_back({{u, v}, true, false});
        else
          ++out.skipped;
      }
    for (const auto& side : window_) cuts.push_back({side, false, false});
  }

  // For each half-edge the share of the source that is seen from the part to its left; -1 out of the window.
  constexpr std::vector<int> labels() const {
    const auto& edges = parts_.edges;
    constexpr int unknown = -2;
    std::vector<int> label(edges.size(), unknown);
    for (std::uint32_t e = 0; e < edges.size(); ++e) {
      if (label[e] != unknown) continue;
      std::uint32_t best = e;  // where the origin is given, sides cost least
      for (std::uint32_t k = edges[e].next; k != e; k = edges[k].next)
        if (parts_.vertices[edges[k].origin].is_given) best = k;
      const int share = label_beside(best);
      std::uint32_t k = e;
      do {
        label[k] = share;
        k = edges[k].next;
      } while (k != e);
    }
    return label;
  }

  constexpr int label_beside(std::uint32_t edge) const {
    const auto side = [&](const point<T, 2>& u, const point<T, 2>& v) { return parts_.side_beside(edge, u, v); };
    if (!holds_place(window_, side)) return -1;
    return static_cast<int>(view_.share(side));
  }
};

}  // namespace IRG_ABI
}  // namespace irg::detail
