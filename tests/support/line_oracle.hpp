// SPDX-License-Identifier: MIT
// What line_bresenham must draw, found another way: not by rounding i * m / n, but by asking of a cell, through the
// implicit equation of the line, whether it is nearer to the line than its neighbours. And two trials that every line
// function with a window can be put to: random lines over the whole of int, and all lines and windows of a lattice.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <vector>

#include <irg/core/sinks.hpp>
#include <irg/raster/line_style.hpp>
#include <irg/raster/window.hpp>

#include "line_properties.hpp"
#include "random.hpp"

namespace test {

constexpr int least = std::numeric_limits<int>::min(), most = std::numeric_limits<int>::max();

inline constexpr irg::line_options all_line_options[4] = {{irg::line_ends::closed, irg::line_ties::start_side},
                                                          {irg::line_ends::closed, irg::line_ties::symmetric},
                                                          {irg::line_ends::half_open, irg::line_ties::start_side},
                                                          {irg::line_ends::half_open, irg::line_ties::symmetric}};

constexpr std::int64_t magnitude(std::int64_t v) { return v < 0 ? -v : v; }

/// Whether a cell belongs to the line from a to b: whether 2 * distance across < 1, or = 1 on the side ties go to, and
/// it lies between the ends.
constexpr bool on_line(irg::cell a, irg::cell b, irg::cell c, irg::line_options options) {
  __extension__ using product_type = __int128;
  const bool canonical_swap = [&] {
    const std::int64_t w = magnitude(std::int64_t{b.x} - a.x), h = magnitude(std::int64_t{b.y} - a.y);
    return options.ties == irg::line_ties::symmetric && (w > h ? b.x < a.x : b.y < a.y);
  }();
  if (options.ends == irg::line_ends::half_open && c == b) return false;
  const irg::cell from = canonical_swap ? b : a, to = canonical_swap ? a : b;
  const std::int64_t dx = std::int64_t{to.x} - from.x, dy = std::int64_t{to.y} - from.y;
  const std::int64_t x = std::int64_t{c.x} - from.x, y = std::int64_t{c.y} - from.y;
  const bool by_x = magnitude(dx) > magnitude(dy);
  const std::int64_t reach = by_x ? dx : dy, along = by_x ? x : y, n = magnitude(reach);
  if (reach < 0 ? along > 0 || along < reach : along < 0 || along > reach) return false;
  // across: how far the cell is beyond the line on the shorter axis, away from `from`, times n.
  const std::int64_t rise = by_x ? dy : dx, aside = by_x ? y : x;
  product_type across = product_type{aside} * n - product_type{rise} * (reach < 0 ? -along : along);
  if (rise < 0) across = -across;
  return n == 0 ? c == a : 2 * across < n && 2 * across >= -n;
}

/// The visible cells of a line, in drawing order.
inline void oracle_line(irg::cell a, irg::cell b, const irg::cell_window& w, irg::line_options options, cells& out) {
  out.clear();
  if (w.empty()) return;
  const std::int64_t dx = std::int64_t{b.x} - a.x, dy = std::int64_t{b.y} - a.y;
  const bool by_x = magnitude(dx) > magnitude(dy);
  const std::int64_t low =
      std::max<std::int64_t>(by_x ? w.x_first : w.y_first, by_x ? std::min(a.x, b.x) : std::min(a.y, b.y));
  const std::int64_t high =
      std::min<std::int64_t>((by_x ? w.x_last : w.y_last) - 1, by_x ? std::max(a.x, b.x) : std::max(a.y, b.y));
  const double slope = by_x ? static_cast<double>(dy) / static_cast<double>(dx)
                            : (dy == 0 ? 0.0 : static_cast<double>(dx) / static_cast<double>(dy));
  for (std::int64_t t = low; t <= high; ++t) {
    const std::int64_t start = by_x ? a.x : a.y, base = by_x ? a.y : a.x;
    const auto guess = base + static_cast<std::int64_t>(std::floor(static_cast<double>(t - start) * slope));
    for (std::int64_t s = guess - 2; s <= guess + 2; ++s) {  // the guess finds candidates; on_line decides
      const std::int64_t x = by_x ? t : s, y = by_x ? s : t;
      if (x < w.x_first || x >= w.x_last || y < w.y_first || y >= w.y_last) continue;
      const irg::cell c{static_cast<int>(x), static_cast<int>(y)};
      if (on_line(a, b, c, options)) out.push_back(c);
    }
  }
  if (by_x ? dx < 0 : dy < 0) std::reverse(out.begin(), out.end());
}

/// Twenty windows, small and thin, near the origin and at the borders of int.
inline constexpr std::array<irg::cell_window, 20> twenty_windows{
    {{0, 0, 12, 12},
     {-6, -6, 6, 6},
     {0, 0, 1, 1},
     {0, 0, 40, 1},
     {0, 0, 1, 40},
     {-20, 5, 20, 7},
     {5, -20, 7, 20},
     {100, 100, 116, 109},
     {-1000003, 999983, -999983, 1000003},
     {1 << 20, -(1 << 20), (1 << 20) + 16, -(1 << 20) + 16},
     {1 << 30, 1 << 30, (1 << 30) + 9, (1 << 30) + 9},
     {-(1 << 30), 0, -(1 << 30) + 24, 3},
     {0, 0, 16, 16},
     {31, 17, 44, 40},
     {least, least, least + 12, least + 12},
     {most - 12, most - 12, most, most},
     {least, most - 20, least + 30, most},
     {most - 33, least, most, least + 5},
     {-8, -8, 24, 24},
     {123456789, -987654321, 123456809, -987654301}}};

/// Ends anywhere in int. Three lines of four pass near a random cell of the window.
struct random_line {
  irg::cell a, b;
};
inline random_line random_line_at(random& r, const irg::cell_window& w) {
  const auto anywhere = [&]() -> std::int64_t {
    const std::int64_t half = std::int64_t{1} << r.integer(2, 31);
    return r.integer(-half, half - 1);
  };
  const auto to_int = [](double v) {
    return static_cast<int>(std::clamp(std::floor(v), static_cast<double>(least), static_cast<double>(most)));
  };
  const auto first_x = anywhere(), first_y = anywhere();
  if (r.integer(0, 3) == 0)
    return {{static_cast<int>(first_x), static_cast<int>(first_y)},
            {static_cast<int>(anywhere()), static_cast<int>(anywhere())}};
  const std::int64_t x = r.integer(w.x_first, w.x_last - 1), y = r.integer(w.y_first, w.y_last - 1);
  const std::int64_t ax = std::clamp<std::int64_t>(x + first_x, least, most),
                     ay = std::clamp<std::int64_t>(y + first_y, least, most);
  // b lies beyond (x, y) seen from a, as far as int allows at most, and so that neither coordinate is clamped.
  const auto room = [&](std::int64_t from, std::int64_t through) {
    const double d = static_cast<double>(through - from);
    return d > 0 ? static_cast<double>(most - through) / d : d < 0 ? static_cast<double>(least - through) / d : 1e10;
  };
  const double share = std::min({room(ax, x), room(ay, y), 1e10}) * (r.integer(0, 1) ? 1.0 : r.unit());
  const irg::cell a{static_cast<int>(ax), static_cast<int>(ay)};
  const irg::cell b{to_int(static_cast<double>(x) + share * static_cast<double>(x - ax)),
                    to_int(static_cast<double>(y) + share * static_cast<double>(y - ay))};
  if (r.integer(0, 1)) return {b, a};
  return {a, b};
}

struct line_trial {
  std::int64_t lines = 0, crossing = 0, wrong = 0;  // crossing: two or more cells in the window; wrong: lines
};

/// `draw(a, b, window, options, emit)` against the oracle, on random lines, each in one of twenty windows with one of
/// the four combinations of options.
template <class Draw>
line_trial try_random_lines(const Draw& draw, std::int64_t lines, std::uint64_t seed = 3) {
  random r(seed);
  line_trial trial;
  cells expected, drawn;
  for (std::int64_t i = 0; i < lines; ++i) {
    const irg::cell_window& window = twenty_windows[static_cast<std::size_t>(i % 20)];
    const irg::line_options& options = all_line_options[i / 20 % 4];
    const random_line line = random_line_at(r, window);
    oracle_line(line.a, line.b, window, options, expected);
    drawn.clear();
    draw(line.a, line.b, window, options, [&](irg::cell c) { drawn.push_back(c); });
    ++trial.lines;
    trial.crossing += expected.size() >= 2;
    trial.wrong += drawn != expected;
  }
  return trial;
}

/// all ordered pairs of a side x side lattice, every `pair_stride`th, against all windows in it, every
/// `window_stride`th: the cells are those of the whole line in the window, in order.
template <class Draw>
line_trial try_lattice(const Draw& draw, int side, int pair_stride, int window_stride, irg::line_options options) {
  struct range {
    int first, last;
  };
  std::vector<range> ranges;
  for (int first = 0; first < side; ++first)
    for (int last = first + 1; last <= side; ++last) ranges.push_back({first, last});
  const int pairs = side * side * side * side, windows = static_cast<int>(ranges.size() * ranges.size());
  const irg::cell_window whole{-1, -1, side + 1, side + 1};
  line_trial trial;
  cells line;
  for (int pair = 0; pair < pairs; pair += pair_stride) {
    const int from = pair / (side * side), to = pair % (side * side);
    const irg::cell a{from % side, from / side}, b{to % side, to / side};
    oracle_line(a, b, whole, options, line);
    for (int k = pair % window_stride; k < windows; k += window_stride) {
      const range x = ranges[static_cast<std::size_t>(k) % ranges.size()],
                  y = ranges[static_cast<std::size_t>(k) / ranges.size()];
      const auto inside = [&](irg::cell c) { return c.x >= x.first && c.x < x.last && c.y >= y.first && c.y < y.last; };
      std::size_t next = 0;  // the cells before `next` are drawn or outside the window
      bool right = true;
      int drawn = 0;
      draw(a, b, irg::cell_window{x.first, y.first, x.last, y.last}, options, [&](irg::cell c) {
        while (next < line.size() && !inside(line[next])) ++next;
        right = right && next < line.size() && line[next] == c;
        ++next;
        ++drawn;
      });
      while (next < line.size() && !inside(line[next])) ++next;
      ++trial.lines;
      trial.crossing += drawn >= 2;
      trial.wrong += !right || next < line.size();
    }
  }
  return trial;
}

inline bool release_tier() { return std::getenv("IRG_RELEASE_TIER") != nullptr; }

/// Both trials, in the size of the tier that runs.
template <class Draw>
void check_window_line(const Draw& draw) {
  const line_trial random = try_random_lines(draw, release_tier() ? 10'000'000 : 100'000);
  CHECK(random.wrong == 0);
  CHECK(2 * random.crossing >= random.lines);
  for (const irg::line_options& options : all_line_options) {
    const line_trial lattice =
        release_tier() ? try_lattice(draw, 12, 1, 1, options) : try_lattice(draw, 12, 7, 101, options);
    CHECK(lattice.wrong == 0);
    CHECK(lattice.lines >= (release_tier() ? 126'000'000 : 170'000));
  }
}

}  // namespace test
