// SPDX-License-Identifier: MIT
// The steps of ellipse_midpoint.hpp.
#pragma once

#include <irg/raster/detail/conic_arc.hpp>
#include <irg/raster/fill_span.hpp>

namespace irg {
namespace detail {
inline namespace IRG_ABI {

// The ellipse with radius p along and q aside, both positive; J holds 4 * p^2 * q^2.
template <class J>
struct ellipse_radii {
  std::int64_t p, q;

  // 4 q^2 (p^2 - k^2) - (2m - 1)^2 p^2: positive when the ellipse at k is above m - 1/2.
  constexpr J excess(std::int64_t k, std::int64_t m) const noexcept {
    const J odd = 2 * m - 1, along = static_cast<J>(p) * p;
    return 4 * (static_cast<J>(q) * q) * (along - static_cast<J>(k) * k) - odd * odd * along;
  }
  constexpr J step() const noexcept { return 4 * (static_cast<J>(q) * q); }
  constexpr J drop() const noexcept { return 8 * (static_cast<J>(p) * p); }
  // The nearest height at k, 0 <= k <= p.
  constexpr std::int64_t height(std::int64_t k) const noexcept {
    const J along = static_cast<J>(p) * p;
    const std::int64_t m =
        floor_sqrt(static_cast<std::int64_t>(static_cast<J>(q) * q * (along - static_cast<J>(k) * k) / along));
    return excess(k, m + 1) > 0 ? m + 1 : m;
  }
  // How many k >= 0 have a height of m or more.
  constexpr std::int64_t reach(std::int64_t m) const noexcept {
    if (m <= 0 || m > q) return m <= 0 ? p + 1 : 0;
    return floor_sqrt(static_cast<std::int64_t>((excess(0, m) - 1) / step())) + 1;
  }
  // One past the last k of the flat part.
  constexpr std::int64_t flat_end() const noexcept {
    const J pp = static_cast<J>(p) * p, qq = static_cast<J>(q) * q;
    return floor_sqrt(static_cast<std::int64_t>(pp * pp / (pp + qq))) + 1;
  }
};

template <class J, CellSink Sink>
constexpr void ellipse_outline(const cell& centre, std::int64_t a, std::int64_t b, const cell_window& w, Sink&& sink) {
  const ellipse_radii<J> columns{a, b}, rows{b, a};
  const std::int64_t x = columns.flat_end(), y = rows.flat_end();  // the first ones that the arcs leave out
  const bool same_last_cell = columns.height(x - 1) == y - 1 && rows.height(y - 1) == x - 1;
  const bool corner = (x <= a && columns.height(x) == y) || (y <= b && rows.height(y) == x);
  for_mirrored_arcs(centre, false, [&](const conic_arc& arc) {
    emit_arc(arc, columns, x, w, sink);
    const step_range along = arc.along(w), aside = arc.aside(w);
    if (corner && x >= along.first && x < along.last && y >= aside.first && y < aside.last) sink(arc.at(x, y));
  });
  for_mirrored_arcs(centre, true,
                    [&](const conic_arc& arc) { emit_arc(arc, rows, same_last_cell ? y - 1 : y, w, sink); });
}

// Radii for which 64 bits hold 4 * a^2 * b^2.
IRG_INLINE constexpr bool is_small_ellipse(int a, int b) noexcept { return a < (1 << 15) && b < (1 << 15); }

// An ellipse with a radius of 0 is a line along an axis.
template <SpanSink Sink>
constexpr void flat_ellipse_spans(const cell& centre, std::int64_t a, std::int64_t b, const cell_window& w,
                                  Sink&& sink) {
  symmetric_spans(centre, b, w, sink, [a](std::int64_t) { return a; });
}

template <class J, SpanSink Sink>
constexpr void full_ellipse_spans(const cell& centre, std::int64_t a, std::int64_t b, const cell_window& w,
                                  Sink&& sink) {
  const J aa = static_cast<J>(a) * a, bb = static_cast<J>(b) * b;
  symmetric_spans(centre, b, w, sink, [&](std::int64_t dy) {
    return floor_sqrt(static_cast<std::int64_t>(aa * (bb - static_cast<J>(dy) * dy) / bb));
  });
}

}  // namespace IRG_ABI
}  // namespace detail
}  // namespace irg
