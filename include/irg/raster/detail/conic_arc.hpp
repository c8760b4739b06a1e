// SPDX-License-Identifier: MIT
// The mirrored arcs that circles and ellipses are made of, and the part of one that a window sees.
#pragma once

#include <irg/raster/detail/integer_sqrt.hpp>
#include <irg/raster/detail/line_frame.hpp>

namespace irg::detail::inline IRG_ABI {

// One arc: k cells along and m aside from the centre, mirrored by the signs; along is x unless `upright`.
struct conic_arc {
  cell centre;
  int sign_along, sign_aside;
  bool upright;

  IRG_INLINE constexpr cell at(std::int64_t k, std::int64_t m) const noexcept {
    const std::int64_t x = upright ? sign_aside * m : sign_along * k, y = upright ? sign_along * k : sign_aside * m;
    return {static_cast<int>(centre.x + x), static_cast<int>(centre.y + y)};
  }
  // The k and the m that a window sees. On the axes an arc and its mirror image have the same cells: those belong to
  // the arc with the positive sign.
  constexpr step_range along(const cell_window& w) const noexcept { return steps(upright, sign_along, w); }
  constexpr step_range aside(const cell_window& w) const noexcept { return steps(!upright, sign_aside, w); }
  constexpr step_range steps(bool down, int sign, const cell_window& w) const noexcept {
    step_range r =
        down ? steps_within(centre.y, sign, w.y_first, w.y_last) : steps_within(centre.x, sign, w.x_first, w.x_last);
    if (sign < 0) r.first = maximum(r.first, std::int64_t{1});
    return r;
  }
};

// Calls body(arc) for the four mirror images.
template <class Body>
constexpr void for_mirrored_arcs(const cell& centre, bool upright, Body&& body) {
  for (int sign_along = 1; sign_along >= -1; sign_along -= 2)
    for (int sign_aside = 1; sign_aside >= -1; sign_aside -= 2)
      body(conic_arc{centre, sign_along, sign_aside, upright});
}

// The cells of an arc with k < end that lie in the window. A shape has height(k), the m nearest to it at k; reach(m),
// how many k >= 0 have a height of m or more; and excess(k, m), negative when it passes below m - 1/2 at k, which loses
// step * (2k + 1) from k to k + 1 and gains drop * (m - 1) from m to m - 1.
template <class Shape, CellSink Sink>
constexpr void emit_arc(const conic_arc& arc, const Shape& shape, std::int64_t end, const cell_window& w, Sink& sink) {
  const step_range along = arc.along(w), aside = arc.aside(w);
  std::int64_t first = along.first, last = minimum(along.last, end);
  if (first >= last || aside.first >= aside.last) return;
  last = minimum(last, shape.reach(aside.first));
  first = maximum(first, shape.reach(aside.last));
  if (first >= last) return;
  const auto step = shape.step(), drop = shape.drop();
  std::int64_t m = shape.height(first);
  auto excess = shape.excess(first, m);
  for (std::int64_t k = first; k < last; ++k) {
    sink(arc.at(k, m));
    excess -= step * (2 * k + 1);
    if (excess < 0 && m > 0) {
      --m;
      excess += drop * m;
    }
  }
}

// Calls sink(span) for the rows of the window that are at most radius_y away from the centre, half_width(dy) being the
// reach to both sides of it.
template <class HalfWidth, SpanSink Sink>
constexpr void symmetric_spans(const cell& centre, std::int64_t radius_y, const cell_window& w, Sink&& sink,
                               HalfWidth&& half_width) {
  if (w.empty()) return;
  const std::int64_t first = maximum(centre.y - radius_y, std::int64_t{w.y_first});
  const std::int64_t last = minimum(centre.y + radius_y + 1, std::int64_t{w.y_last});
  for (std::int64_t y = first; y < last; ++y) {
    const std::int64_t half = half_width(y - centre.y);
    const std::int64_t x_first = maximum(centre.x - half, std::int64_t{w.x_first});
    const std::int64_t x_last = minimum(centre.x + half + 1, std::int64_t{w.x_last});
    if (x_first < x_last) sink(span_of_cells{static_cast<int>(y), static_cast<int>(x_first), static_cast<int>(x_last)});
  }
}

}  // namespace irg::detail::inline IRG_ABI
