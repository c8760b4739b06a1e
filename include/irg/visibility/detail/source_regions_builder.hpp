// SPDX-License-Identifier: MIT
// From a source and obstacles to the rings of the parts that see all, some and none of it.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include <irg/geometry/box.hpp>
#include <irg/geometry/convex_hull.hpp>
#include <irg/geometry/orient2d.hpp>
#include <irg/geometry/polygon_convexity.hpp>
#include <irg/visibility/detail/finite_point.hpp>
#include <irg/visibility/detail/sight_arrangement.hpp>
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
  constexpr explicit source_regions_builder(const box<T, 2>& window) : window_(window) {}

  constexpr source_regions<T> run(std::span<const point<T, 2>> source, std::span<const segment<T, 2>> obstacles,
                                  line_choice choice) {
    source_regions<T> out;
    out.status = read(source, obstacles);
    if (out.status != visibility_status::done) return out;
    for (int axis = 0; axis < 2; ++axis)
      if (!(window_.low[axis] < window_.high[axis])) return out;
    add_cuts(choice, out);
    parts_.build(window_);
    const std::vector<int> label = labels();
    out.all = rings_around(parts_, label, static_cast<int>(seen_share::all));
    out.some = rings_around(parts_, label, static_cast<int>(seen_share::some));
    out.none = rings_around(parts_, label, static_cast<int>(seen_share::none));
    return out;
  }

private:
  box<T, 2> window_;
  source_view<T> view_{};
  sight_arrangement<T> parts_{};

  constexpr visibility_status read(std::span<const point<T, 2>> source, std::span<const segment<T, 2>> obstacles) {
    bool is_finite = is_finite_sight_point(window_.low) && is_finite_sight_point(window_.high);
    if (is_empty(window_)) is_finite = true;  // of which nothing is asked
    for (const auto& p : source) is_finite = is_finite && is_finite_sight_point(p);
    for (const auto& o : obstacles) is_finite = is_finite && is_finite_sight_point(o.a) && is_finite_sight_point(o.b);
    if (!is_finite) return visibility_status::not_finite;
    if (source.size() == 0 || !is_convex(source)) return visibility_status::source_not_convex;
    for (const std::uint32_t i : convex_hull(source)) view_.source.push_back(source[i]);
    view_.obstacles.assign(obstacles.begin(), obstacles.end());
    return view_.crosses_obstacle() ? visibility_status::source_crosses_obstacle : visibility_status::done;
  }

  constexpr void add_cuts(line_choice choice, source_regions<T>& out) {
    auto& cuts = parts_.cuts;
    parts_.sources = view_.source;
    std::vector<point<T, 2>> ends = view_.source;
    const auto add_end = [&](const point<T, 2>& p) {
      for (const auto& e : ends)
        if (e == p) return;
      ends.push_back(p);
    };
    for (const auto& o : view_.obstacles) {
      add_end(o.a);
      add_end(o.b);
      if (!(o.a == o.b)) cuts.push_back({o, false, choice == line_choice::needed});
    }
    const std::size_t n = view_.source.size(), sides = n == 2 ? 1 : n == 1 ? 0 : n;
    for (std::size_t i = 0; i < sides; ++i)
      cuts.push_back({{view_.source[i], view_.source[(i + 1) % n]}, false, false});
    for (const auto& u : ends)
      for (const auto& v : ends) {
        if (u == v) continue;
        ++out.lines;
        if (choice == line_choice::all || view_.matters_beyond(u, v))
          cuts.push_back({{u, v}, true, false});
        else
          ++out.skipped;
      }
    const std::array<point<T, 2>, 4> corners = corners_of_window();
    for (std::size_t i = 0; i < 4; ++i) cuts.push_back({{corners[i], corners[(i + 1) % 4]}, false, false});
  }

  constexpr std::array<point<T, 2>, 4> corners_of_window() const noexcept {
    const point<T, 2>&low = window_.low, &high = window_.high;
    return {low, point<T, 2>{high.x, low.y}, high, point<T, 2>{low.x, high.y}};
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
    const std::array<point<T, 2>, 4> corners = corners_of_window();
    for (std::size_t i = 0; i < 4; ++i)
      if (side(corners[i], corners[(i + 1) % 4]) < 0) return -1;
    return static_cast<int>(view_.share(side));
  }
};

}  // namespace IRG_ABI
}  // namespace irg::detail
