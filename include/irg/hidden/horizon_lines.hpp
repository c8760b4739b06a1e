// SPDX-License-Identifier: MIT
// The floating horizon in vectors: curves that hide each other, near ones first, as the parts of their steps that are
// seen. The horizons are pieces of the steps themselves, and where a step crosses one is decided exactly; nothing is
// rounded to pixels, and nothing is drawn beside a curve.
//
// A point is hidden when steps of nearer curves, ends included, pass both above and below it. Touching hides nothing.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include <irg/core/function_ref.hpp>
#include <irg/hidden/vocabulary.hpp>
#include <irg/math/vec.hpp>
#if IRG_BODIES
#include <irg/core/is_finite.hpp>
#include <irg/hidden/detail/grid_sight.hpp>
#include <irg/math/error_free.hpp>
#endif

namespace irg {

/// What is sent of curves: what is seen, or what is hidden as well.
enum class drawn_parts { visible, all };

/// What was done.
struct horizon_line_counts {
  std::int64_t steps = 0;  // with a length
  std::int64_t parts = 0;  // that are seen
  std::int64_t hidden = 0;  // steps of which nothing is seen
  std::int64_t pieces = 0;  // of both horizons, at the end
  bool operator==(const horizon_line_counts&) const = default;
};

inline namespace IRG_ABI {

/// Sends the parts of curves that nearer curves, and nearer steps of the same one, leave to be seen to sink(edge_part).
/// shape   points: those of all curves, near ones first, y up; one that is not finite parts two curves, or two parts of
///         one. Edge k is the step from point k to k + 1; its parts follow each other, in order. With drawn_parts::all
///         what is hidden is sent as well, between them
/// needs   less than 2^31 points; nearer ones to the front at each x
/// gives   upright steps hide nothing; steps without length, and to or from points that are not finite, have no parts
/// exact   every decision; places are rounded once, to the nearest double
/// cost    some steps along the horizons for each step of a curve; memory for the horizons
/// source  Special-cases chapter, 2, with horizons of lines in place of pixels
template <class Emit>
constexpr horizon_line_counts visible_curves(std::span<const point<double, 2>> points, Emit&& sink,
                                             drawn_parts which = drawn_parts::visible);

}  // namespace IRG_ABI
}  // namespace irg

namespace irg::detail::inline IRG_COMPILED_ABI {

template <class Counts>
IRG_API Counts send_curves(std::span<const point<double, 2>> points, const function_ref<void(edge_part)>& sink,
                           drawn_parts which);

}  // namespace irg::detail::inline IRG_COMPILED_ABI

namespace irg::inline IRG_ABI {

template <class Emit>
constexpr horizon_line_counts visible_curves(std::span<const point<double, 2>> points, Emit&& sink, drawn_parts which) {
  return detail::send_curves<horizon_line_counts>(points, as_function<void(edge_part)>(sink), which);
}

}  // namespace irg::inline IRG_ABI

#if IRG_BODIES
namespace irg::detail::inline IRG_ABI {

// Curves in a picture, and what is decided of their steps, exactly: which passes above another at some x, and where
// they cross. Directions are the places from left to right; it is what grid_perimeter asks of a sight.

// Edge e joins points e and e + 1.
template <class T>
struct curve_sight {
  std::span<const point<T, 2>> points;

  constexpr const point<T, 2>& at(std::uint32_t v) const noexcept { return points[v]; }
  static constexpr std::uint32_t low(grid_edge e) noexcept { return e; }
  static constexpr std::uint32_t high(grid_edge e) noexcept { return e + 1; }
  constexpr turning_edge turning(grid_edge e) const noexcept {
    return at(e).x < at(e + 1).x ? turning_edge{e, e + 1} : turning_edge{e + 1, e};
  }

  // Curves begin and end anywhere: horizons jump there, at the place of a vertex.
  static constexpr bool has_jumps = true;
  static constexpr grid_edge stop_bit = grid_edge{1} << 31;
  static constexpr grid_edge stop_at(std::uint32_t vertex) noexcept { return vertex | stop_bit; }
  static constexpr bool is_vertex(grid_edge stop) noexcept { return (stop & stop_bit) != 0; }
  static constexpr std::uint32_t vertex_of(grid_edge stop) noexcept { return stop & ~stop_bit; }

  // The ends of the picture, left and right.
  static constexpr std::uint32_t axes = 2;
  constexpr int behind_axis(std::uint32_t k, std::uint32_t) const noexcept { return k == 0 ? 1 : -1; }

  constexpr int turn(std::uint32_t b, std::uint32_t c) const noexcept {
    return at(c).x > at(b).x ? 1 : at(c).x < at(b).x ? -1 : 0;
  }
  constexpr int above_vertex(grid_edge e, std::uint32_t c) const noexcept {
    const turning_edge t = turning(e);
    return c == t.from || c == t.to ? 0 : -orient2d(at(t.from), at(t.to), at(c));
  }

  // 1 where f passes above e at the x of vertex c, -1 where below.
  constexpr int compare_at(grid_edge f, grid_edge e, std::uint32_t c) const noexcept {
    const turning_edge s = turning(e), t = turning(f);
    const auto formula = [](const auto& a, const auto& b, const auto& p, const auto& q, const auto& x) {
      return plane_turn(a, b, x) * (q.x - p.x) - plane_turn(p, q, x) * (b.x - a.x);
    };
    return irg::sign_of<3>(formula, at(s.from), at(s.to), at(t.from), at(t.to), at(c));
  }

  // -1 where g passes above the crossing of e and f, of which f is the higher one behind it, 1 where below; the other
  // way round where e is the higher one.
  constexpr int planes_turn(grid_edge e, grid_edge f, grid_edge g) const noexcept {
    const turning_edge r = turning(e), s = turning(f), t = turning(g);
    const auto formula = [](const auto&... corners) {
      // Each line as rise, run, and the height where it meets the upright line through the last point, times the run.
      const std::array p{corners...};
      const auto run = [&](std::size_t k) { return p[2 * k + 1].x - p[2 * k].x; };
      const auto rise = [&](std::size_t k) { return p[2 * k + 1].y - p[2 * k].y; };
      const auto height = [&](std::size_t k) {
        return (p[2 * k].y - p[5].y) * run(k) - rise(k) * (p[2 * k].x - p[5].x);
      };
      return rise(0) * (height(2) * run(1) - height(1) * run(2)) + height(0) * (rise(1) * run(2) - rise(2) * run(1)) +
             run(0) * (height(1) * rise(2) - height(2) * rise(1));
    };
    return irg::sign_of<4>(formula, at(r.from), at(r.to), at(s.from), at(s.to), at(t.from), at(t.to));
  }

  // How far along g it meets the line of e, or the place of a vertex.
  constexpr T place(grid_edge g, grid_edge e) const noexcept {
    if (!is_vertex(e))
      return irg::quotient_of<2>(meeting_in_plane{}, at(low(e)), at(high(e)), at(low(g)), at(high(g))).value_or(T(0));
    const auto along = [](const auto& from, const auto& to, const auto& x) { return std::array{to - from, x - from}; };
    return irg::quotient_of<1>(along, at(low(g)).x, at(high(g)).x, at(vertex_of(e)).x).value_or(T(0));
  }

  // -1, 0 or 1: where g meets the line of e (or the place of a vertex) before that of f, at one place, or behind.
  constexpr int compare_places(grid_edge g, grid_edge e, grid_edge f) const noexcept {
    const int way = at(low(g)).x < at(high(g)).x ? 1 : -1;
    if (is_vertex(e) && is_vertex(f)) return way * turn(vertex_of(f), vertex_of(e));
    if (is_vertex(e)) return -compare_places(g, f, e);
    const auto falls = [&](grid_edge of) {
      const int a = orient2d(at(low(of)), at(high(of)), at(low(g)));
      return a != 0 ? a : -orient2d(at(low(of)), at(high(of)), at(high(g)));
    };
    if (is_vertex(f)) {
      const auto mixed = [](const auto& a, const auto& b, const auto& p, const auto& q, const auto& x) {
        return plane_turn(a, b, p) * (q.x - x.x) + plane_turn(a, b, q) * (x.x - p.x);
      };
      return falls(e) * way *
             irg::sign_of<3>(mixed, at(low(e)), at(high(e)), at(low(g)), at(high(g)), at(vertex_of(f)));
    }
    const auto formula = [](const auto& a, const auto& b, const auto& p, const auto& q, const auto& x, const auto& y) {
      return plane_turn(p, q, x) * plane_turn(a, b, y) - plane_turn(a, b, x) * plane_turn(p, q, y);
    };
    return falls(e) * falls(f) *
           irg::sign_of<4>(formula, at(low(e)), at(high(e)), at(low(f)), at(high(f)), at(low(g)), at(high(g)));
  }
};

template <class Sight>
struct line_horizons {
  const Sight& sight;
  grid_perimeter<Sight> upper{sight, perimeter_side::outer}, lower{sight, perimeter_side::inner};
  grid_parts<Sight> parts{sight};

  // Calls sink(from, to) for what is seen of a step, in order.
  // gives   how many parts that are
  template <class Emit>
  constexpr std::int64_t add(grid_edge e, const Emit& sink) {
    if (sight.at(e).x == sight.at(e + 1).x) return add_upright(e, sink);
    parts.add(e, upper.add(e));
    parts.add(e, lower.add(e));
    return parts.send(sink);
  }
  constexpr std::int64_t pieces() const noexcept { return static_cast<std::int64_t>(upper.size() + lower.size()); }

  // An upright step hides nothing: curves through its ends do.
  template <class Emit>
  constexpr std::int64_t add_upright(grid_edge e, const Emit& sink) {
    const bool rises = sight.at(e).y < sight.at(e + 1).y;
    const std::uint32_t bottom = rises ? e : e + 1, top = rises ? e + 1 : e;
    const grid_edge high = upper.edge_at(e), low = lower.edge_at(e);
    const bool is_hidden = high != no_grid_edge && low != no_grid_edge && sight.compare_at(high, low, e) > 0 &&
                           sight.above_vertex(high, bottom) > 0 && sight.above_vertex(low, top) < 0;
    if (!is_hidden) {
      sink(0.0, 1.0);
      return 1;
    }
    const bool below = sight.above_vertex(low, bottom) > 0, above = sight.above_vertex(high, top) < 0;
    const double from_low = below ? sight.place(e, low) : 0, from_high = above ? sight.place(e, high) : 0;
    if (below && rises) sink(0.0, from_low);
    if (above && !rises) sink(0.0, from_high);
    if (above && rises) sink(from_high, 1.0);
    if (below && !rises) sink(from_low, 1.0);
    return (below ? 1 : 0) + (above ? 1 : 0);
  }
};

}  // namespace irg::detail::inline IRG_ABI

namespace irg::detail::inline IRG_COMPILED_ABI {

template <class Counts>
IRG_API Counts send_curves(std::span<const point<double, 2>> points, const function_ref<void(edge_part)>& sink,
                           drawn_parts which) {
  const curve_sight<double> sight{points};
  line_horizons<curve_sight<double>> horizons{sight};
  Counts counts;
  for (std::size_t k = 0; k + 1 < points.size(); ++k) {
    if (!is_finite(points[k], points[k + 1]) || points[k] == points[k + 1]) continue;
    double seen_to = 0;
    const auto hide = [&](double to) {
      if (which == drawn_parts::all && seen_to < to) sink(edge_part{k, line_visibility::hidden, seen_to, to});
    };
    const std::int64_t parts = horizons.add(static_cast<grid_edge>(k), [&](double from, double to) {
      hide(from);
      sink(edge_part{k, line_visibility::visible, from, to});
      seen_to = to;
    });
    hide(1);
    ++counts.steps;
    counts.parts += parts;
    counts.hidden += parts == 0 ? 1 : 0;
  }
  counts.pieces = horizons.pieces();
  return counts;
}

}  // namespace irg::detail::inline IRG_COMPILED_ABI
#endif
