// SPDX-License-Identifier: MIT
// Polygons to fill, the exact rows of pixels that they cover, and how many pixels a contender gets wrong.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include <irg/core/sinks.hpp>
#include <irg/raster/subpixel.hpp>
#include <irg/raster/fill_span.hpp>
#include <irg/raster/subpixel.hpp>
#include <irg/raster/window.hpp>

#include "raster/contest.hpp"

namespace bench {

enum class placing { inside, clipped, outside };

/// Polygons with their vertices on a circle of `diameter` pixels, in every n-th part of it one, shifted by up to 35 % of
/// the part; `turns` coprime to n makes stars that cross themselves. Clipped ones have about a tenth of their circle's
/// box on the canvas. In 1/256 pixel.
struct round_polygons {
  const canvas& on;
  int count, corners;
  double diameter;
  int turns;
  placing where;

  std::vector<irg::subpixel> vertices() const {
    constexpr double full_turn = 6.283185307179586;
    random_numbers r(static_cast<std::uint64_t>(diameter) * 100 + static_cast<std::uint64_t>(corners));
    const double radius = diameter / 2;
    std::vector<irg::subpixel> all;
    for (int k = 0; k < count; ++k) {
      double x = r.between(radius, on.width() - radius), y = r.between(radius, on.height() - radius);
      if (where == placing::clipped) x = r.integer(0, 1) ? -0.8 * radius : on.width() + 0.8 * radius;
      if (where == placing::outside)
        x = r.integer(0, 1) ? r.between(-9, -1.1) * radius : on.width() + r.between(1.1, 9) * radius;
      const double start = r.between(0, full_turn);
      std::vector<irg::subpixel> ring;
      for (int i = 0; i < corners; ++i) {
        const double angle = start + (i + r.between(-0.35, 0.35)) * full_turn / corners;
        ring.push_back(irg::snap(irg::point<double, 2>{x + radius * std::cos(angle), y + radius * std::sin(angle)}));
      }
      for (int i = 0; i < corners; ++i) all.push_back(ring[static_cast<std::size_t>(i * turns % corners)]);
    }
    return all;
  }
};

/// Rings of equally many vertices, made when they are first asked for.
struct polygon_set : round_polygons {
  std::string name;
  lazy<std::vector<irg::subpixel>>& vertices;

  int size() const { return count; }
  bool convex() const { return turns == 1; }
  irg::fill_rule rule() const { return convex() ? irg::fill_rule::non_zero : irg::fill_rule::even_odd; }
  std::span<const irg::subpixel> ring(int k) const {
    const auto n = static_cast<std::size_t>(corners);
    return {vertices->data() + static_cast<std::size_t>(k) * n, n};
  }
  contest with(const char* kernel, const char* unit, const char* limit) const {
    return {kernel,    name + " " + std::to_string(static_cast<int>(diameter)) + " px " + on.name() + build_suffix(),
            "polygon", count,
            unit,      where == placing::outside ? "" : limit};
  }
};

/// The cases of all contests of fills: `counts` polygons of 8, 32, 128 and 512 pixels; those of up to `small_corners` on
/// the small canvas, too. run(set) enters one.
template <class Run>
void enter_fills(const canvas& large, const canvas& small, const std::array<int, 4>& counts, int small_corners,
                 Run run) {
  struct shape {
    int corners;
    const char* name;
  };
  const auto on = [&](const canvas& c, const char* name, double diameter, int n, int corners, int turns = 1,
                      placing where = placing::inside) {
    const round_polygons what{c, smoke() ? n / 200 + 2 : n, corners, diameter, turns, where};
    run(keep(polygon_set{what, name, keep_lazy([what] { return what.vertices(); })}));
  };
  for (std::size_t i = 0; i < counts.size(); ++i) {
    const double diameter = std::array{8, 32, 128, 512}[i];
    for (const auto [corners, name] :
         {shape{3, "triangle"}, {4, "4 vertices"}, {8, "8 vertices"}, {32, "32 vertices"}}) {
      on(large, name, diameter, counts[i], corners);
      if (corners <= small_corners) on(small, name, diameter, counts[i], corners);
    }
    if (diameter >= 32) on(large, "star", diameter, counts[i], 7, 3);
  }
  on(large, "triangle clipped 90 %", 128, counts[2], 3, 1, placing::clipped);
  on(large, "triangle outside", 128, counts[2], 3, 1, placing::outside);
}

/// A contender of irg: draw(ring) for each polygon.
template <class Draw>
drawer own(std::string name, const polygon_set& set, Draw draw, std::string note = {}) {
  return {std::move(name),
          [&set, draw](int first, int last) mutable {
            for (int k = first; k < last; ++k) draw(set.ring(k));
          },
          true, std::move(note), promise::nothing_wrong};
}

/// Calls emit(span) for the covered pixels of the ring by the definition: in row y each edge that passes the height of
/// the centres (its upper end included) is crossed at one place; centres at or right of it see it on their left.
template <class Sink>
void exact_rows(const polygon_set& set, int k, const irg::cell_window& w, Sink&& emit) {
  struct crossing {
    int column, direction;
  };
  const auto ring = set.ring(k);
  std::vector<crossing> crossings;
  for (int y = w.y_first; y < w.y_last; ++y) {
    const std::int64_t level = std::int64_t{y} * 256 + 128;
    crossings.clear();
    for (std::size_t i = 0; i < ring.size(); ++i) {
      irg::subpixel a = ring[i], b = ring[(i + 1) % ring.size()];
      const int direction = a.y < b.y ? 1 : -1;
      if (direction < 0) std::swap(a, b);
      if (!(a.y <= level && level < b.y)) continue;
      const std::int64_t height = std::int64_t{b.y} - a.y;
      const std::int64_t n = (std::int64_t{a.x} - 128) * height + (level - a.y) * (std::int64_t{b.x} - a.x);
      const std::int64_t d = 256 * height;  // the first column is n / d, rounded up
      crossings.push_back({static_cast<int>(n > 0 ? (n - 1) / d + 1 : -(-n / d)), direction});
    }
    std::sort(crossings.begin(), crossings.end(), [](auto& a, auto& b) { return a.column < b.column; });
    int winding = 0;
    for (std::size_t i = 0; i + 1 < crossings.size(); ++i) {
      winding += set.rule() == irg::fill_rule::even_odd ? 1 : crossings[i].direction;
      const bool in = set.rule() == irg::fill_rule::even_odd ? winding % 2 != 0 : winding != 0;
      const irg::span_of_cells s{y, std::max(crossings[i].column, w.x_first),
                                 std::min(crossings[i + 1].column, w.x_last)};
      if (in && s.x_first < s.x_last) emit(s);
    }
  }
}

/// The pixels that a ring may touch, and `margin` more on each side, on the canvas.
inline irg::cell_window surroundings(const canvas& c, const polygon_set& set, int k, int margin) {
  irg::cell_window w{1 << 30, 1 << 30, -(1 << 30), -(1 << 30)};
  for (const irg::subpixel& v : set.ring(k))
    w = {std::min(w.x_first, v.x), std::min(w.y_first, v.y), std::max(w.x_last, v.x), std::max(w.y_last, v.y)};
  return irg::intersect({(w.x_first >> 8) - margin, (w.y_first >> 8) - margin, (w.x_last >> 8) + 1 + margin,
                         (w.y_last >> 8) + 1 + margin},
                        {0, 0, c.width(), c.height()});
}

inline lazy<std::int64_t>& covered_pixels(const canvas& c, const polygon_set& set) {
  return keep_lazy([&c, &set] {
    std::int64_t count = 0;
    for (int k = 0; k < set.size(); ++k)
      exact_rows(set, k, surroundings(c, set, k, 0),
                 [&](const irg::span_of_cells& s) { count += s.x_last - s.x_first; });
    return count;
  });
}

/// How many items to judge, so that it takes no longer than the race.
inline int sample_size(const polygon_set& set) {
  const double pixels = smoke() ? 1e5 : 6e6;
  return std::min(set.size(), static_cast<int>(std::min(1000.0, 3 + pixels / (set.diameter * set.diameter))));
}

/// From a pixel's centre to the nearest point of the ring, in pixels.
inline double distance_to_ring(std::span<const irg::subpixel> ring, int x, int y) {
  double least = 1e30;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const irg::subpixel &a = ring[i], &b = ring[(i + 1) % ring.size()];
    const double dx = b.x - a.x, dy = b.y - a.y, px = x * 256 + 128 - a.x, py = y * 256 + 128 - a.y;
    const double square = dx * dx + dy * dy;
    const double t = square > 0 ? std::clamp((px * dx + py * dy) / square, 0.0, 1.0) : 0;
    least = std::min(least, std::hypot(px - t * dx, py - t * dy) / 256);
  }
  return least;
}

/// Wrong: pixels that are drawn but not covered by the definition, or covered but not drawn. Error: how far the centre
/// of such a pixel is from the polygon's outline, in pixels; 0 for the right ones, which the mean counts, too.
inline errors judge_fill(const canvas& c, const polygon_set& set, const drawer& d) {
  errors e{0, 0, 0};
  double sum = 0;
  std::int64_t pixels = 0, too_many = 0;
  std::vector<std::uint8_t> due;
  const int sample = sample_size(set);
  for (int k = 0; k < sample; ++k) {
    const irg::cell_window w = surroundings(c, set, k, 4);
    if (w.empty()) continue;
    const auto width = static_cast<std::size_t>(w.x_last - w.x_first);
    due.assign(width * static_cast<std::size_t>(w.y_last - w.y_first), 0);
    exact_rows(set, k, w, [&](const irg::span_of_cells& s) {
      const auto first = due.begin() + static_cast<std::ptrdiff_t>(static_cast<std::size_t>(s.y - w.y_first) * width);
      std::fill(first + (s.x_first - w.x_first), first + (s.x_last - w.x_first), std::uint8_t{1});
    });
    d.draw(k, k + 1);
    std::size_t i = 0;
    for (int y = w.y_first; y < w.y_last; ++y)
      for (int x = w.x_first; x < w.x_last; ++x, ++i) {
        const bool set_here = c.at(x, y) != 0;
        c.at(x, y) = 0;
        pixels += set_here || due[i];
        if (set_here == (due[i] != 0)) continue;
        ++e.wrong;
        too_many += set_here;
        const double away = distance_to_ring(set.ring(k), x, y);
        sum += away;
        e.max = std::max(e.max, away);
      }
  }
  e.mean = pixels ? sum / static_cast<double>(pixels) : 0;
  e.note = std::to_string(pixels) + " pixels judged";
  if (e.wrong) e.note += " (" + std::to_string(too_many) + " too many)";
  return e;
}

// Limits.

/// How far ahead of their use runs are fetched, where they are.
inline constexpr std::size_t runs_ahead = 24;

/// The rows known beforehand. `plain`: written by std::fill_n one after the other. `ahead`: fetched ahead of time, which a
/// fill can do, too, and written in registers that overlap, by irg::fill_pixels.
enum class replaying { plain, ahead };

inline drawer limit_span_replay(const canvas& c, const polygon_set& set, replaying how) {
  struct run {
    std::uint32_t offset = 0, count = 1;
  };
  struct record {
    std::vector<run> runs{};
    std::vector<std::size_t> ends{0};
  };
  auto& all = keep_lazy([&c, &set] {
    record r;
    for (int k = 0; k < set.size(); ++k) {
      exact_rows(set, k, surroundings(c, set, k, 0), [&](const irg::span_of_cells& s) {
        r.runs.push_back({static_cast<std::uint32_t>(s.y * c.width() + s.x_first),
                          static_cast<std::uint32_t>(s.x_last - s.x_first)});
      });
      r.ends.push_back(r.runs.size());
    }
    r.runs.resize(r.runs.size() + runs_ahead);
    return r;
  });
  const auto range = [&all](int first, int last) {
    return std::span(all->runs.data() + all->ends[static_cast<std::size_t>(first)],
                     all->runs.data() + all->ends[static_cast<std::size_t>(last)]);
  };
  if (how == replaying::plain)
    return {"limit:span replay", [range, pixels = c.pixels()](int first, int last) {
              for (const run& r : range(first, last)) std::fill_n(pixels + r.offset, r.count, white);
            }};
  return {"limit:span replay ahead", [range, pixels = reinterpret_cast<irg::rgba8*>(c.pixels())](int first, int last) {
            for (const run& r : range(first, last)) {
              const run& next = (&r)[runs_ahead];
              __builtin_prefetch(pixels + next.offset, 1);
              __builtin_prefetch(pixels + next.offset + next.count - 1, 1);
              irg::fill_pixels(pixels + r.offset, r.count, white_rgba);
            }
          }};
}

/// The convex fill that textbooks show: each edge is followed in floating point from row to row and widens the row's
/// range; then the ranges are filled.
inline drawer textbook_fill(const canvas& c, const polygon_set& set) {
  struct range {
    float first, last;
  };
  drawer d{"irg:textbook loop", {}};
  d.draw = [&c, &set, rows = std::vector<range>(static_cast<std::size_t>(c.height()))](int first, int last) mutable {
    for (int k = first; k < last; ++k) {
      const auto ring = set.ring(k);
      float top = 1e9f, bottom = -1e9f;
      for (const irg::subpixel& v : ring) {
        const float y = static_cast<float>(v.y) / 256;
        top = std::min(top, y);
        bottom = std::max(bottom, y);
      }
      const int y_first = std::max(0, static_cast<int>(std::ceil(top - 0.5f)));
      const int y_last = std::min(c.height(), static_cast<int>(std::ceil(bottom - 0.5f)));
      for (int y = y_first; y < y_last; ++y) rows[static_cast<std::size_t>(y)] = {1e9f, -1e9f};
      for (std::size_t i = 0; i < ring.size(); ++i) {
        irg::subpixel a = ring[i], b = ring[i + 1 == ring.size() ? 0 : i + 1];
        if (a.y > b.y) std::swap(a, b);
        const float ay = static_cast<float>(a.y) / 256, by = static_cast<float>(b.y) / 256;
        const float ax = static_cast<float>(a.x) / 256, bx = static_cast<float>(b.x) / 256;
        const int from = std::max(y_first, static_cast<int>(std::ceil(ay - 0.5f)));
        const int to = std::min(y_last, static_cast<int>(std::ceil(by - 0.5f)));
        if (from >= to) continue;
        const float slope = (bx - ax) / (by - ay);
        float x = ax + (static_cast<float>(from) + 0.5f - ay) * slope;
        for (int y = from; y < to; ++y, x += slope) {
          range& row = rows[static_cast<std::size_t>(y)];
          row.first = std::min(row.first, x);
          row.last = std::max(row.last, x);
        }
      }
      for (int y = y_first; y < y_last; ++y) {
        const range& row = rows[static_cast<std::size_t>(y)];
        const int x_first = std::max(0, static_cast<int>(std::ceil(row.first - 0.5f)));
        const int x_last = std::min(c.width(), static_cast<int>(std::ceil(row.last - 0.5f)));
        if (x_first < x_last) std::fill(&c.at(x_first, y), &c.at(x_first, y) + (x_last - x_first), white);
      }
    }
  };
  d.note = "a plain loop in the benchmark";
  return d;
}

}  // namespace bench
