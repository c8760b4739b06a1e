// SPDX-License-Identifier: MIT
// Lines to draw, the exact cells of a line, and how far a contender's cells are from the true line.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include <irg/core/sinks.hpp>

#include "raster/contest.hpp"

namespace bench {

struct segment {
  irg::cell a, b;
};
using line_list = lazy<std::vector<segment>>;

/// The definition: n steps along the longer axis, m aside; step i goes to the cell nearest to i * m / n, on a tie to the
/// one on the side of a.
struct walk {
  std::int64_t n, m;
  int sign_along, sign_aside;
  bool steep;
  irg::cell a;

  explicit walk(const segment& s) : a(s.a) {
    const std::int64_t dx = std::int64_t{s.b.x} - s.a.x, dy = std::int64_t{s.b.y} - s.a.y;
    steep = std::abs(dy) >= std::abs(dx);
    n = std::abs(steep ? dy : dx);
    m = std::abs(steep ? dx : dy);
    sign_along = (steep ? dy : dx) < 0 ? -1 : 1;
    sign_aside = (steep ? dx : dy) < 0 ? -1 : 1;
  }
  std::int64_t aside(std::int64_t i) const { return n == 0 ? 0 : (2 * i * m + n - 1) / (2 * n); }
  irg::cell at(std::int64_t along, std::int64_t beside) const {
    const int u = static_cast<int>(sign_along * along), v = static_cast<int>(sign_aside * beside);
    return {a.x + (steep ? v : u), a.y + (steep ? u : v)};
  }
  /// Every cell of the line on the canvas, in order.
  template <class Sink>
  void cells(const canvas& c, Sink&& emit) const {
    for (std::int64_t i = 0; i <= n; ++i) {
      const irg::cell p = at(i, aside(i));
      if (c.holds(p.x, p.y)) emit(p);
    }
  }
};

inline std::int64_t visible_cells(const canvas& c, const segment& s) {
  std::int64_t count = 0;
  walk(s).cells(c, [&](irg::cell) { ++count; });
  return count;
}

// Workloads. Length L: the end lies at distance L from the start, in the given or a random direction.

enum class heading { random, horizontal, vertical, diagonal };

inline segment any_line(random_numbers& r, const canvas& c, double length, heading h, int margin) {
  constexpr double quarter = 1.5707963267948966;
  double angle = r.between(0, 4 * quarter);
  if (h == heading::horizontal) angle = 2 * quarter * r.integer(0, 1);
  if (h == heading::vertical) angle = quarter + 2 * quarter * r.integer(0, 1);
  if (h == heading::diagonal) angle = quarter / 2 + quarter * r.integer(0, 3);
  const irg::cell a{r.integer(-margin, c.width() - 1 + margin), r.integer(-margin, c.height() - 1 + margin)};
  const auto dx = static_cast<int>(std::lround(length * std::cos(angle)));
  const auto dy = static_cast<int>(std::lround(length * std::sin(angle)));
  return {a, {a.x + dx, a.y + dy}};
}

inline std::vector<segment> lines_inside(const canvas& c, int count, double length, heading h) {
  random_numbers r(static_cast<std::uint64_t>(length) * 8 + static_cast<std::uint64_t>(h));
  std::vector<segment> out;
  while (static_cast<int>(out.size()) < count) {
    const segment s = any_line(r, c, length, h, 0);
    if (c.holds(s.b.x, s.b.y)) out.push_back(s);
  }
  return out;
}

/// Lines of which about a tenth can be seen: 8 to 12 % of the cells.
inline std::vector<segment> lines_clipped(const canvas& c, int count, double length) {
  random_numbers r(90);
  std::vector<segment> out;
  while (static_cast<int>(out.size()) < count) {
    const segment s = any_line(r, c, length, heading::random, static_cast<int>(length));
    const double part = static_cast<double>(visible_cells(c, s)) / static_cast<double>(walk(s).n + 1);
    if (part >= 0.08 && part <= 0.12) out.push_back(s);
  }
  return out;
}

/// Lines that miss the canvas: their boxes miss it, too, or they pass by a corner.
enum class passing { far_away, by_a_corner };

inline std::vector<segment> lines_outside(const canvas& c, int count, passing where) {
  random_numbers r(static_cast<std::uint64_t>(100 + static_cast<int>(where)));
  std::vector<segment> out;
  while (static_cast<int>(out.size()) < count) {
    const segment s = any_line(r, c, 512, heading::random, 600);
    const bool box_misses = std::max(s.a.x, s.b.x) < 0 || std::min(s.a.x, s.b.x) >= c.width() ||
                            std::max(s.a.y, s.b.y) < 0 || std::min(s.a.y, s.b.y) >= c.height();
    if (where == passing::far_away ? box_misses : !box_misses && visible_cells(c, s) == 0) out.push_back(s);
  }
  return out;
}

/// How many lines of 8, 32, 128, 512 and 1500 pixels, of clipped ones and of ones outside; which lengths are drawn in
/// fixed directions, too.
struct line_cases {
  std::array<int, 5> counts;
  int clipped, outside;
  int shortest, longest;
};

/// The lines of a contest, and how many cells of theirs can be seen.
struct line_case {
  const canvas& on;
  std::string name;
  int count;
  line_list& lines;
  lazy<std::int64_t>& cells;
  bool any_visible;

  contest with(const char* kernel, const char* unit, const char* limit) const {
    return {kernel, name + " " + on.name() + build_suffix(), "line", count, unit, any_visible ? limit : ""};
  }
};

template <class Make>
line_case make_line_case(const canvas& c, std::string name, int count, Make make) {
  line_list& lines = keep_lazy(std::function<std::vector<segment>()>(make));
  auto& cells = keep_lazy([&c, &lines] {
    std::int64_t sum = 0;
    for (const segment& s : *lines) sum += visible_cells(c, s);
    return sum;
  });
  const bool any_visible = !name.starts_with("outside");
  return {c, std::move(name), count, lines, cells, any_visible};
}

/// The cases of all contests of lines; run(case, heading, steps) enters one of lines of
/// at most so many steps.
template <class Run>
void enter_lines(const canvas& large, const canvas& small, const line_cases& cases, Run run) {
  const auto items = [](int n) { return smoke() ? n / 100 + 2 : n; };
  for (std::size_t i = 0; i < cases.counts.size(); ++i) {
    const int length = std::array{8, 32, 128, 512, 1500}[i];
    const auto on = [&](const canvas& c, const std::string& name, heading h) {
      const int n = items(cases.counts[i]);
      run(make_line_case(c, name + " " + std::to_string(length) + " px", n,
                         [&c, n, length, h] { return lines_inside(c, n, length, h); }),
          h, length);
    };
    on(large, "random", heading::random);
    if (length <= 512) on(small, "random", heading::random);
    if (length < cases.shortest || length > cases.longest) continue;
    on(large, "horizontal", heading::horizontal);
    on(large, "vertical", heading::vertical);
    on(large, "diagonal", heading::diagonal);
  }
  const int clipped = items(cases.clipped), outside = items(cases.outside);
  run(make_line_case(large, "clipped 90 % 1280 px", clipped,
                     [&large, clipped] { return lines_clipped(large, clipped, 1280); }),
      heading::random, 1280);
  run(make_line_case(large, "outside", outside,
                     [&large, outside] { return lines_outside(large, outside, passing::far_away); }),
      heading::random, 512);
}

/// A contender of irg: draw(a, b) for each line.
template <class Draw>
drawer own(std::string name, line_list& lines, Draw draw, promise promised, std::string note = {}) {
  return {std::move(name),
          [&lines, draw](int first, int last) mutable {
            const segment* all = lines->data();
            for (int k = first; k < last; ++k) draw(all[k].a, all[k].b);
          },
          true, std::move(note), promised};
}

/// Draws lines one by one and looks at the cells within 4 of the true line. Error: the distance of a cell from the line
/// along the shorter axis, in pixels. Wrong: cells more than 1/2 away, before the start, behind the end, or in a step
/// that has one already, and steps without a cell. Which way an exact tie goes is counted apart.
inline errors judge_lines(const canvas& c, const std::vector<segment>& lines, const drawer& d) {
  constexpr int reach = 4;
  const int sample = std::min(static_cast<int>(lines.size()), smoke() ? 60 : 1000);
  errors e{0, 0, 0};
  std::int64_t cells = 0, other_way = 0;
  double sum = 0;
  const auto judge_step = [&](const walk& w, std::int64_t i) {
    const bool beyond = i < 0 || i > w.n;
    const std::int64_t middle = w.aside(std::clamp<std::int64_t>(i, 0, w.n));
    const irg::cell due = w.at(i, middle);
    int here = 0;
    bool tie_out_of_sight = false;
    for (std::int64_t b = middle - reach; b <= middle + reach; ++b) {
      const irg::cell p = w.at(i, b);
      const double away = w.n == 0 ? static_cast<double>(std::max(std::abs(i), std::abs(b)))
                                   : std::abs(static_cast<double>(i * w.m - w.n * b)) / static_cast<double>(w.n);
      if (!c.holds(p.x, p.y)) {
        tie_out_of_sight = tie_out_of_sight || away == 0.5;
        continue;
      }
      if (c.at(p.x, p.y) == 0) continue;
      c.at(p.x, p.y) = 0;
      const double error = beyond ? std::max(away, static_cast<double>(i < 0 ? -i : i - w.n)) : away;
      ++cells;
      sum += error;
      e.max = std::max(e.max, error);
      if (beyond || error > 0.5 || ++here > 1)
        ++e.wrong;
      else
        other_way += p != due;
    }
    if (!beyond && here == 0 && c.holds(due.x, due.y) && !tie_out_of_sight) ++e.wrong;
  };
  for (int k = 0; k < sample; ++k) {
    d.draw(k, k + 1);
    const walk w(lines[static_cast<std::size_t>(k)]);
    for (std::int64_t i = -reach; i <= w.n + reach; ++i) judge_step(w, i);
  }
  e.mean = cells ? sum / static_cast<double>(cells) : 0;
  e.note = std::to_string(cells) + " cells judged";
  if (other_way) e.note += " (" + std::to_string(other_way) + " ties the other way)";
  return e;
}

// Limits.

/// One store per step along the longer axis, without a step aside: the least that writes as many pixels in as many rows.
inline drawer limit_store_per_step(const canvas& c, line_list& lines) {
  struct run {
    std::uint32_t* first = nullptr;
    std::ptrdiff_t step = 0;
    std::int64_t count = 0;
  };
  auto& runs = keep_lazy([&c, &lines] {
    std::vector<run> all;
    for (const segment& s : *lines) {
      const walk w(s);
      run r{nullptr, w.sign_along * std::ptrdiff_t{w.steep ? c.width() : 1}, 0};
      w.cells(c, [&](irg::cell p) {
        if (!r.first) r.first = &c.at(p.x, p.y);
        ++r.count;
      });
      all.push_back(r);
    }
    return all;
  });
  return {"limit:store per step", [&runs](int first, int last) {
            for (int k = first; k < last; ++k) {
              const run& r = (*runs)[static_cast<std::size_t>(k)];
              std::uint32_t* p = r.first;
              for (std::int64_t i = 0; i < r.count; ++i) {
                *p = white;
                p += r.step;
                asm volatile("" : "+r"(p));  // no vectors: one store, one step
              }
            }
          }};
}

/// The cells known beforehand. `ahead`: fetched ahead of time, which an algorithm can do, too.
enum class fetching { not_ahead, ahead };

inline drawer limit_replay(const canvas& c, line_list& lines, fetching how) {
  constexpr std::size_t cells_ahead = 64;
  struct record {
    std::vector<std::uint32_t> offsets{};
    std::vector<std::size_t> ends{0};
  };
  auto& all = keep_lazy([&c, &lines] {
    record r;
    for (const segment& s : *lines) {
      walk(s).cells(c, [&](irg::cell p) { r.offsets.push_back(static_cast<std::uint32_t>(p.y * c.width() + p.x)); });
      r.ends.push_back(r.offsets.size());
    }
    r.offsets.resize(r.offsets.size() + cells_ahead);
    return r;
  });
  const auto range = [&all](int first, int last) {
    return std::span(all->offsets.data() + all->ends[static_cast<std::size_t>(first)],
                     all->offsets.data() + all->ends[static_cast<std::size_t>(last)]);
  };
  if (how == fetching::not_ahead)
    return {"limit:replay", [range, pixels = c.pixels()](int first, int last) {
              for (const std::uint32_t offset : range(first, last)) pixels[offset] = white;
            }};
  return {"limit:replay ahead", [range, pixels = c.pixels()](int first, int last) {
            for (const std::uint32_t& offset : range(first, last)) {
              __builtin_prefetch(pixels + (&offset)[cells_ahead], 1);
              pixels[offset] = white;
            }
          }};
}

/// Bresenham's loop in integers as it is usually printed, with a test of each cell against the canvas.
inline drawer textbook_lines(const canvas& c, line_list& lines) {
  const auto draw = [&c](irg::cell a, const irg::cell& b) {
    const int dx = std::abs(b.x - a.x), dy = -std::abs(b.y - a.y);
    const int sx = a.x < b.x ? 1 : -1, sy = a.y < b.y ? 1 : -1;
    for (int error = dx + dy;;) {
      if (c.holds(a.x, a.y)) c.at(a.x, a.y) = white;
      if (a == b) return;
      const int twice = 2 * error;
      if (twice >= dy) {
        error += dy;
        a.x += sx;
      }
      if (twice <= dx) {
        error += dx;
        a.y += sy;
      }
    }
  };
  return own("irg:textbook loop", lines, draw, promise::none, "a plain loop in the benchmark");
}

}  // namespace bench
