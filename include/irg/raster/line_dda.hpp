// SPDX-License-Identifier: MIT
// The digital differential analyser: a line's cells by adding the slope and rounding. line_dda adds real numbers, as
// textbooks do; line_dda_exact adds 64-bit fractions and has exactly the cells of line_bresenham.
//
// Why line_dda_exact is exact. Step i of n lies aside by floor(v), v = (2*i*m + n - 1 + tie) / 2n, a multiple of
// 1/(2n); so every number in [v, v + 1/(2n)) has the right floor. In units of 2^-64, the slope rounded down is short
// by at most 1, and after j steps from an exact start the sum is short by at most j. Starting more than 2^64/(2n) - 2
// units above v leaves room for j <= 2^64/(2n) - 2 steps: at least 2^31 - 2, whatever the line. A longer walk is
// started anew, exactly.
//
// The same with a 32-bit fraction (the usual 32.32) leaves room for j <= 2^32/(2n) - 2: all of a line, j = n, only up
// to 46339 steps. A 16-bit fraction (16.16) is exact up to 180 steps.
// The exact walk comes first, beside this reason.
#pragma once

#include <cstdint>

#include <irg/raster/textbook/line_bresenham.hpp>

namespace irg {

/// The most steps for which line_dda strays less than half a cell: 2^26 for double, 2^11 for float.
template <Real T>
inline constexpr std::int64_t line_dda_steps = detail::proven_steps<T>(1, 2);

namespace detail::inline IRG_ABI {

// A walk by 64-bit fractions, from a step that is known exactly; see above.
struct dda_walk {
  std::uint64_t fraction, slope;
  std::int64_t aside, room;  // room: the steps for which the walk is exact
};

constexpr dda_walk dda_walk_from(const bresenham_frame& f, std::int64_t i) noexcept {
  const auto n = static_cast<uint128>(f.n), m = static_cast<uint128>(f.m);
  const std::int64_t aside = f.aside_at(i);
  // rest: v - floor(v) in units of 1/(2n), so 0 <= rest < 2n.
  const auto rest = static_cast<uint128>(int128{2} * i * f.m + f.n - 1 + f.tie - int128{2} * f.n * aside);
  const uint128 slope = f.m == f.n ? ~std::uint64_t{0} : (m << 64) / n;
  const uint128 unit = (uint128{1} << 64) / (2 * n), room = minimum(unit - 2, uint128{1} << 33);
  return {static_cast<std::uint64_t>(((rest + 1) << 64) / (2 * n) - 1), static_cast<std::uint64_t>(slope), aside,
          static_cast<std::int64_t>(room)};
}

template <class Sink>
constexpr void emit_dda(const bresenham_frame& f, const step_range& steps, Sink& sink) {
  if (f.n == 0 && steps.first < steps.last) return static_cast<void>(sink(f.at(0, 0)));
  for (std::int64_t i = steps.first; i < steps.last;) {
    dda_walk walk = dda_walk_from(f, i);
    const std::int64_t stop = minimum(steps.last, i + walk.room + 1);
    for (; i < stop; ++i) {
      sink(f.at(i, walk.aside));
      walk.fraction += walk.slope;
      walk.aside += walk.fraction < walk.slope;  // the carry
    }
  }
}

}  // namespace detail::inline IRG_ABI

inline namespace IRG_ABI {

/// Calls sink(cell) for the cells of the line from a to b, in this order, and says whether it did.
/// shape   8-connected; max(|dx|, |dy|) + 1 cells, both ends among them; 45 degrees is y-driven
/// needs   a Real made from std::int64_t
/// gives   false, and no call, when the line has more than line_dda_steps<Number> steps
/// exact   no: the sum strays by up to n * m * 2^-p for p binary digits. Up to 2^17 steps in double (2^7 in float) that
///         can decide exact ties only; they go to either side unless n / gcd(n, m) is a power of 2. Beyond, cells near
///         a tie may lie one aside, too
/// cost    one addition and one rounding per cell; nothing is clipped
template <Real Number = double, CellSink Sink>
constexpr bool line_dda(cell a, cell b, Sink&& sink) {
  const detail::bresenham_frame f = detail::frame_of(a, b);
  if (f.n > line_dda_steps<Number>) return false;
  if (f.n == 0) return sink(cell{a}), true;
  const Number slope = Number(f.m) / Number(f.n), half = Number(1) / Number(2);
  Number sum(0);
  std::int64_t aside = 0;  // sum, rounded to nearest, ties down: it grows by 0 or 1 per step
  for (std::int64_t i = 0; i < f.n; ++i) {
    sink(f.at(i, aside));
    sum = sum + slope;
    if (Number(aside) + half < sum) ++aside;
  }
  sink(f.at(f.n, aside));
  return true;
}

/// Calls sink(cell) for the cells of the line from a to b that lie in the window, in the order from a to b.
/// exact   the cells of line_bresenham with the same options, for all int coordinates
/// cost    one addition and its carry per visible cell, without a branch; a few 128-bit divisions per line
template <CellSink Sink>
constexpr void line_dda_exact(cell a, cell b, const cell_window& window, Sink&& sink,
                              const line_options& options = {}) {
  if (window.empty()) return;
  const detail::bresenham_frame f = detail::frame_of(a, b, options.ties);
  detail::emit_dda(f, detail::visible_steps(f, window, options.ends), sink);
}

/// Calls sink(cell) for all cells of the line, up to 2^32 of them.
template <CellSink Sink>
constexpr void line_dda_exact(cell a, cell b, Sink&& sink, const line_options& options = {}) {
  const detail::bresenham_frame f = detail::frame_of(a, b, options.ties);
  detail::emit_dda(f, {0, detail::steps_drawn(f, options.ends)}, sink);
}

}  // namespace IRG_ABI
}  // namespace irg
