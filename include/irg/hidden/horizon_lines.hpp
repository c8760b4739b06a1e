// SPDX-License-Identifier: MIT
// The floating horizon in vectors: curves that hide each other, near ones first, as the parts of their steps that are
// seen. The horizons are pieces of the steps themselves, and where a step crosses one is decided exactly; nothing is
// rounded to pixels, and nothing is drawn beside a curve.
//
// A point is hidden when steps of nearer curves, ends included, pass both above and below it. Touching hides nothing.
#pragma once

#include <cstdint>
#include <span>

#include <irg/hidden/detail/curve_sight.hpp>
#include <irg/hidden/detail/grid_parts.hpp>
#include <irg/hidden/edge_part.hpp>
#include <irg/math/error_free.hpp>

namespace irg {

/// What is sent of curves: what is seen, or what is hidden as well.
enum class drawn_parts { visible, all };

/// What was done.
struct horizon_line_counts {
  std::int64_t steps = 0;  // with a length
  std::int64_t parts = 0;  // that are seen
  std::int64_t hidden = 0;  // steps of which nothing is seen
  std::int64_t pieces = 0;  // of both horizons, at the end
};

namespace detail {
inline namespace IRG_ABI {

template <class Sight>
class line_horizons {
public:
  constexpr explicit line_horizons(const Sight& sight)
      : sight_(&sight), upper_(sight, perimeter_side::outer), lower_(sight, perimeter_side::inner), parts_(sight) {}

  // Calls sink(from, to) for what is seen of a step, in order.
  // gives   how many parts that are
  template <class Emit>
  constexpr std::int64_t add(grid_edge e, const Emit& sink) {
    if (sight_->at(e).x == sight_->at(e + 1).x) return add_upright(e, sink);
    parts_.add(e, upper_.add(e));
    parts_.add(e, lower_.add(e));
    return parts_.send(sink);
  }
  constexpr std::int64_t pieces() const noexcept { return static_cast<std::int64_t>(upper_.size() + lower_.size()); }

private:
  // An upright step hides nothing: curves through its ends do.
  template <class Emit>
  constexpr std::int64_t add_upright(grid_edge e, const Emit& sink) {
    const bool rises = sight_->at(e).y < sight_->at(e + 1).y;
    const std::uint32_t bottom = rises ? e : e + 1, top = rises ? e + 1 : e;
    const grid_edge high = upper_.edge_at(e), low = lower_.edge_at(e);
    const bool is_hidden = high != no_grid_edge && low != no_grid_edge && sight_->compare_at(high, low, e) > 0 &&
                           sight_->above_vertex(high, bottom) > 0 && sight_->above_vertex(low, top) < 0;
    if (!is_hidden) {
      sink(0.0, 1.0);
      return 1;
    }
    const bool below = sight_->above_vertex(low, bottom) > 0, above = sight_->above_vertex(high, top) < 0;
    const double from_low = below ? sight_->place(e, low) : 0, from_high = above ? sight_->place(e, high) : 0;
    if (below && rises) sink(0.0, from_low);
    if (above && !rises) sink(0.0, from_high);
    if (above && rises) sink(from_high, 1.0);
    if (below && !rises) sink(from_low, 1.0);
    return (below ? 1 : 0) + (above ? 1 : 0);
  }

  const Sight* sight_;
  grid_perimeter<Sight> upper_, lower_;
  grid_parts<Sight> parts_;
};

}  // namespace IRG_ABI
}  // namespace detail

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
                                             drawn_parts which = drawn_parts::visible) {
  const detail::curve_sight<double> sight{points};
  detail::line_horizons horizons(sight);
  horizon_line_counts counts;
  const auto is_point = [](const point<double, 2>& p) { return is_finite(p.x) && is_finite(p.y); };
  for (std::size_t k = 0; k + 1 < points.size(); ++k) {
    if (!is_point(points[k]) || !is_point(points[k + 1]) || points[k] == points[k + 1]) continue;
    double seen_to = 0;
    const auto hide = [&](double to) {
      if (which == drawn_parts::all && seen_to < to) sink(edge_part{k, line_visibility::hidden, seen_to, to});
    };
    const std::int64_t parts = horizons.add(static_cast<detail::grid_edge>(k), [&](double from, double to) {
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

}  // namespace IRG_ABI
}  // namespace irg
