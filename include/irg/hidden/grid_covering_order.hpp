// SPDX-License-Identifier: MIT
// The facets of a grid surface in covering order: one that can hide another comes first. The surface stands over a
// rectangular grid, x_0 < ... < x_n by z_0 < ... < z_m; upright sight planes leave the eye in all directions and cross
// the grid's cells one after the other, whatever the heights are. Four loops away from the eye follow them all.
#pragma once

#include <span>

#include <irg/core/scalar.hpp>
#include <irg/core/config.hpp>

namespace irg {

/// From where a grid surface is seen: over the grid or its border (`front`), beside it in one coordinate, in both
/// (`corner`), or outside in the plane of height 0.
enum class grid_view { front, side, corner, horizontal };

/// The facet between x_(i-1) and x_i, z_(j-1) and z_j: both count from 1.
struct grid_facet {
  int i = 0, j = 0;
  friend constexpr bool operator==(const grid_facet&, const grid_facet&) = default;
};

/// The four loops: over i from first_i up to n and from last_i down to 1, each with j from first_j up to m, then each
/// with j from last_j down to 1.
/// shape   k and l: where the eye stands, x_(k-1) <= eye <= x_k with x_(-1) and x_(n+1) infinite, the smaller k on a
///         grid line; first = max(1, k), last = min(n, k - 1)
struct grid_covering {
  int n = 0, m = 0, k = 0, l = 0;
  int first_i = 1, last_i = 0, first_j = 1, last_j = 0;
  bool operator==(const grid_covering&) const = default;
};

inline namespace IRG_ABI {

/// The least k with places[k - 1] <= v <= places[k], where what lies before the first and behind the last place is
/// infinite.
/// needs   rising places
/// gives   0 up to the first place, places.size() beyond the last
template <class Places>
[[nodiscard]] constexpr int grid_interval(const Places& places, double v) noexcept {
  int low = 0, high = static_cast<int>(places.size());
  while (low < high) {
    const int half = low + (high - low) / 2;
    if (v <= places[static_cast<std::size_t>(half)])
      high = half;
    else
      low = half + 1;
  }
  return low;
}

/// The loops for an eye over (x, z) and a grid at these places.
/// needs   rising places, two or more each way
/// cost    O(log n + log m)
/// source  Special-cases chapter, 3 (covering order)
template <class Places>
[[nodiscard]] constexpr grid_covering covering_loops(const Places& xs, const Places& zs, double x, double z) noexcept {
  grid_covering c;
  c.n = static_cast<int>(xs.size()) - 1, c.m = static_cast<int>(zs.size()) - 1;
  c.k = grid_interval(xs, x), c.l = grid_interval(zs, z);
  c.first_i = maximum(1, c.k), c.last_i = minimum(c.n, c.k - 1);
  c.first_j = maximum(1, c.l), c.last_j = minimum(c.m, c.l - 1);
  return c;
}

/// Calls visit(grid_facet) for every facet once, in covering order.
/// source  Special-cases chapter, 3 (covering order)
template <class Covering, class Visit>
constexpr void visit_in_covering_order(const Covering& c, Visit&& visit) {
  const auto columns = [&](auto&& along_j) {
    for (int i = c.first_i; i <= c.n; ++i) along_j(i);
    for (int i = c.last_i; i >= 1; --i) along_j(i);
  };
  columns([&](int i) {
    for (int j = c.first_j; j <= c.m; ++j) visit(grid_facet{i, j});
  });
  columns([&](int i) {
    for (int j = c.last_j; j >= 1; --j) visit(grid_facet{i, j});
  });
}

/// How a surface over these places is seen from (x, y, z).
/// exact   comparisons alone
template <class Places>
[[nodiscard]] constexpr grid_view grid_view_from(const Places& xs, const Places& zs, double x, double y,
                                                 double z) noexcept {
  const bool within_x = xs.front() <= x && x <= xs.back(), within_z = zs.front() <= z && z <= zs.back();
  if (within_x && within_z) return grid_view::front;
  if (y == 0) return grid_view::horizontal;
  return within_x || within_z ? grid_view::side : grid_view::corner;
}

}  // namespace IRG_ABI
}  // namespace irg
