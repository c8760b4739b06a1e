// SPDX-License-Identifier: MIT
// Rings as the outline of a region: that they meet neither each other nor themselves, and which way each has to run so
// that the region lies to its left.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include <irg/geometry/intersect_segments.hpp>
#include <irg/geometry/point_in_polygon.hpp>
#include <irg/geometry/polygon_orientation.hpp>
#include <irg/geometry/segment.hpp>

namespace irg::detail {
inline namespace IRG_ABI {

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

}  // namespace IRG_ABI
}  // namespace irg::detail
