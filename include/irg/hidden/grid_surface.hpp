// SPDX-License-Identifier: MIT
// Grid surfaces by perimeter: the parts of the edges of a surface y = f(x, z) over a grid that its facets do not hide.
// Facets are drawn in covering order; the outer and the inner perimeter of those drawn so far hide what lies between
// them. Seen from above or below, only the outer one hides: all facets begin under the eye.
//
// A facet is what its four edges enclose: a point is hidden when nearer edges in the upright plane through it and the
// eye pass both above and below the line of sight (with the eye over the grid: on the eye's side of the surface).
// Touching hides nothing.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include <irg/core/function_ref.hpp>
#include <irg/core/vocabulary.hpp>
#include <irg/hidden/grid_covering_order.hpp>
#include <irg/math/vec.hpp>
#if IRG_BODIES
#include <irg/core/is_finite.hpp>
#include <irg/hidden/detail/grid_sight.hpp>
#endif

namespace irg {

/// A surface over a grid: heights[i*(m + 1) + j] is the height at (x[i], z[j]), for i = 0..n and j = 0..m.
struct grid_surface {
  std::span<const double> x, z, heights;
};

/// A part of the edge between the grid points (i1, j1) and (i2, j2), of which the first is the lower one.
/// shape   from < to: 0 at the first point, 1 at the second, even steps along the edge in space
struct grid_edge_part {
  int i1 = 0, j1 = 0, i2 = 0, j2 = 0;
  double from = 0, to = 1;
  bool operator==(const grid_edge_part&) const = default;
};

/// What a surface and an eye amount to. `not_a_grid`: fewer than two places each way, places that do not rise, numbers
/// that are not finite, another number of heights, or more than 2^30 of them.
enum class [[nodiscard]] grid_surface_status {
  ok,
  not_a_grid,
  eye_on_surface,
  drawn [[deprecated("irg: drawn is now ok")]] = ok
};

/// What was done.
struct grid_surface_counts {
  grid_view view = grid_view::front;
  std::int64_t facets = 0, edges = 0, parts = 0;
  std::int64_t hidden = 0;  // edges of which nothing is seen
  std::int64_t steps = 0;  // from piece to piece of the perimeters
  std::int64_t pieces = 0;  // of the perimeters, at the end
  bool operator==(const grid_surface_counts&) const = default;
};

inline namespace IRG_ABI {

/// Sends the parts of the edges of a surface that are seen from `eye` to sink(grid_edge_part), in the order in which
/// they are drawn: edges in line with the eye, the border that turns to it, then facet by facet in covering order.
/// shape   an edge's parts follow each other; they are as long as can be, and edges that are hidden have none
/// gives   nothing but the status where there is no picture
/// exact   every decision; places are rounded once, to the nearest double
/// cost    some 5 steps of the perimeters for an edge of smooth surfaces, a third of a microsecond; N^1.5 in all for N
///         facets where the perimeters stay as long as the border; memory for the perimeters
/// source  Special-cases chapter, 3 (perimeter)
template <class Emit>
constexpr checked<grid_surface_counts, grid_surface_status> visible_grid_edges(const grid_surface& surface,
                                                                               const point<double, 3>& eye,
                                                                               Emit&& sink);

}  // namespace IRG_ABI
}  // namespace irg

namespace irg::detail::inline IRG_COMPILED_ABI {

template <class Counts>
IRG_API checked<Counts, grid_surface_status> send_grid_edges(const grid_surface& surface, const point<double, 3>& eye,
                                                             const function_ref<void(grid_edge_part)>& sink);

}  // namespace irg::detail::inline IRG_COMPILED_ABI

namespace irg::inline IRG_ABI {

template <class Emit>
constexpr checked<grid_surface_counts, grid_surface_status> visible_grid_edges(const grid_surface& surface,
                                                                               const point<double, 3>& eye,
                                                                               Emit&& sink) {
  return detail::send_grid_edges<grid_surface_counts>(surface, eye, as_function<void(grid_edge_part)>(sink));
}

}  // namespace irg::inline IRG_ABI

#if IRG_BODIES
namespace irg::detail::inline IRG_ABI {

// The edges of a grid surface that lie in line with the eye, those of the grid's lines below it. Each such line is seen
// in one upright plane, in two directions from the eye, and hides nothing but itself: the other edges that meet the
// plane meet it at the line's own vertices.

template <class Sight>
struct grid_sight_lines {
  const Sight& sight;
  bool outer_hides, inner_hides;

  // Calls visit(part, seen) for each edge of the lines.
  template <class Visit>
  constexpr void visit(const Visit& visit) const {
    for (std::size_t i = 0; i < sight.x.size(); ++i)
      if (sight.x[i] == sight.eye.x) line(static_cast<int>(i), 1, visit);
    for (std::size_t j = 0; j < sight.z.size(); ++j)
      if (sight.z[j] == sight.eye.z) line(static_cast<int>(j), 0, visit);
  }

private:
  // The line of edges along `axis` (0: x, 1: z), in its plane: places along it and heights.
  struct sight_plane {
    const Sight& sight;
    int at, axis;
    constexpr int size() const noexcept { return static_cast<int>(axis == 0 ? sight.x.size() : sight.z.size()); }
    constexpr std::uint32_t vertex(int k) const noexcept {
      return axis == 0 ? sight.vertex(k, at) : sight.vertex(at, k);
    }
    constexpr double place(int k) const noexcept {
      return axis == 0 ? sight.x[static_cast<std::size_t>(k)] : sight.z[static_cast<std::size_t>(k)];
    }
    constexpr point<double, 2> point_at(int k) const noexcept { return {place(k), sight.heights[vertex(k)]}; }
    constexpr point<double, 2> eye() const noexcept { return {axis == 0 ? sight.eye.x : sight.eye.z, sight.eye.y}; }
    // 1 where vertex a is seen above vertex b, on one side of the eye.
    constexpr int compare(int a, int b) const noexcept {
      const int turn = orient2d(eye(), point_at(b), point_at(a));
      return place(a) > eye().x ? turn : -turn;
    }
    // Where the line of sight to vertex q meets the edge from k to k + 1.
    constexpr double meeting(int q, int k) const noexcept {
      return irg::quotient_of<2>(meeting_in_plane{}, eye(), point_at(q), point_at(k), point_at(k + 1)).value_or(0.0);
    }
    template <class Part>
    constexpr Part part(int k, double from, double to) const noexcept {
      return axis == 0 ? Part{k, at, k + 1, at, from, to} : Part{at, k, at, k + 1, from, to};
    }
  };

  template <class Visit, class Part = grid_edge_part>
  constexpr void line(int at, int axis, const Visit& visit) const {
    const sight_plane plane{sight, at, axis};
    const double eye = plane.eye().x;
    for (int k = 0; k + 1 < plane.size(); ++k)  // under the eye nothing is nearer
      if (plane.place(k) <= eye && eye <= plane.place(k + 1)) visit(plane.template part<Part>(k, 0, 1), true);
    int behind = 0;
    while (behind < plane.size() && plane.place(behind) <= eye) ++behind;
    walk<Part>(plane, behind, 1, visit);
    int before = plane.size() - 1;
    while (before >= 0 && plane.place(before) >= eye) --before;
    walk<Part>(plane, before, -1, visit);
  }

  // From vertex k away from the eye. Along an edge the slope of the line of sight rises, falls or stays.
  template <class Part, class Visit>
  constexpr void walk(const sight_plane& plane, int k, int step, const Visit& visit) const {
    int highest = k, lowest = k;
    for (; k >= 0 && k < plane.size() && k + step >= 0 && k + step < plane.size(); k += step) {
      const int next = k + step, rise = plane.compare(next, k);
      const bool tops = plane.compare(k, highest) == 0, bottoms = plane.compare(k, lowest) == 0;
      const int over = plane.compare(next, highest), under = plane.compare(next, lowest);
      const bool whole = (outer_hides && tops && rise >= 0) || (inner_hides && bottoms && rise <= 0);
      const bool emerges = (outer_hides && over > 0) || (inner_hides && under < 0);
      const int edge = step > 0 ? k : next;
      double from = 0, to = 1;
      if (!whole && emerges) (step > 0 ? from : to) = plane.meeting(over > 0 ? highest : lowest, edge);
      visit(plane.template part<Part>(edge, from, to), whole || emerges);
      if (over > 0) highest = next;
      if (under < 0) lowest = next;
    }
  }
};

// Neither NaN nor infinite.
constexpr bool is_number(double v) noexcept { return is_finite(v); }

template <class Surface>
constexpr bool is_grid(const Surface& s) noexcept {
  const auto rises = [](std::span<const double> v) {
    if (v.size() < 2 || v.size() > (std::size_t{1} << 30)) return false;
    for (std::size_t i = 0; i < v.size(); ++i)
      if (!is_finite(v[i]) || (i > 0 && !(v[i - 1] < v[i]))) return false;
    return true;
  };
  if (!rises(s.x) || !rises(s.z)) return false;
  if (s.x.size() * s.z.size() != s.heights.size() || s.heights.size() > (std::size_t{1} << 30)) return false;
  for (const double h : s.heights)
    if (!is_finite(h)) return false;
  return true;
}

// 1 where the surface passes above an eye over the grid, -1 below, 0 through it.
template <class Sight>
constexpr int surface_over_eye(const Sight& s, const grid_covering& c) noexcept {
  const auto i = static_cast<std::size_t>(c.first_i), j = static_cast<std::size_t>(c.first_j);
  const auto h = [&](std::size_t p, std::size_t q) { return s.heights[p * s.z.size() + q]; };
  const auto formula = [](const auto& p) {
    const auto left = p[0] - p[1], right = p[2] - p[0], front = p[3] - p[4], back = p[5] - p[3];
    return (right * (p[7] - p[6]) + left * (p[8] - p[6])) * back +
           (right * (p[9] - p[6]) + left * (p[10] - p[6])) * front;
  };
  return irg::sign_of<3>(formula, std::array<double, 11>{s.eye.x, s.x[i - 1], s.x[i], s.eye.z, s.z[j - 1], s.z[j],
                                                         s.eye.y, h(i - 1, j - 1), h(i, j - 1), h(i - 1, j), h(i, j)});
}

}  // namespace irg::detail::inline IRG_ABI

namespace irg::detail::inline IRG_COMPILED_ABI {

template <class Counts>
IRG_API checked<Counts, grid_surface_status> send_grid_edges(const grid_surface& surface, const point<double, 3>& eye,
                                                             const function_ref<void(grid_edge_part)>& sink) {
  Counts counts;
  if (!is_grid(surface) || !is_finite(eye)) return {counts, grid_surface_status::not_a_grid};
  const grid_sight<double> sight{surface.x, surface.z, surface.heights, eye};
  const grid_covering loops = covering_loops(sight.x, sight.z, eye.x, eye.z);
  counts.view = grid_view_from(sight.x, sight.z, eye.x, eye.y, eye.z);
  const bool over = counts.view == grid_view::front;
  const int surface_is = over ? surface_over_eye(sight, loops) : 0;
  if (over && surface_is == 0) return {counts, grid_surface_status::eye_on_surface};
  const bool outer_hides = surface_is <= 0, inner_hides = surface_is >= 0;

  grid_perimeter outer(sight, perimeter_side::outer), inner(sight, perimeter_side::inner);
  grid_parts<grid_sight<double>> parts{sight};
  const auto sent = [&](std::int64_t count) {
    ++counts.edges;
    counts.parts += count;
    counts.hidden += count == 0 ? 1 : 0;
  };
  const auto draw = [&](grid_edge g) {
    if (outer_hides) parts.add(g, outer.add(g));
    if (inner_hides) parts.add(g, inner.add(g));
    const auto a = sight.low(g), b = sight.high(g), rows = sight.rows();
    const auto index = [](std::uint32_t n) { return static_cast<int>(n); };
    sent(parts.send([&](double from, double to) {
      sink(grid_edge_part{index(a / rows), index(a % rows), index(b / rows), index(b % rows), from, to});
    }));
  };
  const grid_sight_lines<grid_sight<double>> lines{sight, outer_hides, inner_hides};
  lines.visit([&](const grid_edge_part& part, bool seen) {
    if (seen) sink(part);
    sent(seen ? 1 : 0);
  });

  const auto edge = [&](int i, int j, bool along_z) { return 2 * sight.vertex(i, j) + (along_z ? 1u : 0u); };
  const auto x_at = [&](int i) { return sight.x[static_cast<std::size_t>(i)]; };
  const auto z_at = [&](int j) { return sight.z[static_cast<std::size_t>(j)]; };
  for (int j = 0; j < loops.m; ++j) {
    if (x_at(0) > eye.x) draw(edge(0, j, true));
    if (x_at(loops.n) < eye.x) draw(edge(loops.n, j, true));
  }
  for (int i = 0; i < loops.n; ++i) {
    if (z_at(0) > eye.z) draw(edge(i, 0, false));
    if (z_at(loops.m) < eye.z) draw(edge(i, loops.m, false));
  }
  visit_in_covering_order(loops, [&](const grid_facet& f) {
    ++counts.facets;
    if (z_at(f.j - 1) < eye.z) draw(edge(f.i - 1, f.j - 1, false));
    if (x_at(f.i) > eye.x) draw(edge(f.i, f.j - 1, true));
    if (z_at(f.j) > eye.z) draw(edge(f.i - 1, f.j, false));
    if (x_at(f.i - 1) < eye.x) draw(edge(f.i - 1, f.j - 1, true));
  });
  counts.steps = outer.steps() + inner.steps();
  counts.pieces = static_cast<std::int64_t>(outer.size() + inner.size());
  return {counts, grid_surface_status::ok};
}

}  // namespace irg::detail::inline IRG_COMPILED_ABI
#endif
