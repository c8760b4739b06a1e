// SPDX-License-Identifier: MIT
// The rational definition of filling, told pixel by pixel: how often rings run round a pixel's centre, a centre on a
// left or top edge being inside. It knows neither columns nor steps.
#pragma once

#include <cstdint>
#include <vector>

#include <irg/core/sinks.hpp>
#include <irg/raster/edge_walk.hpp>
#include <irg/raster/subpixel.hpp>
#include <irg/raster/window.hpp>

#include "support/random.hpp"

namespace test {

__extension__ typedef __int128 wide;

using ring = std::vector<irg::subpixel>;
using far_ring = std::vector<irg::far_subpixel>;

/// What an edge from a to b adds to the winding number of the centre of pixel (px, py).
template <class V>
int turn_of_edge(V a, V b, std::int64_t px, std::int64_t py) {
  const std::int64_t x = px * 256 + 128, y = py * 256 + 128;
  int direction = 1;
  if (a.y > b.y) {
    const V t = a;
    a = b;
    b = t;
    direction = -1;
  }
  if (!(a.y <= y && y < b.y)) return 0;  // level edges cross no centre line
  const wide dx = wide{b.x} - a.x, dy = wide{b.y} - a.y;
  return wide{a.x} * dy + (wide{y} - a.y) * dx <= wide{x} * dy ? direction : 0;
}

template <class Ring>
int winding_number(const Ring& r, std::int64_t px, std::int64_t py) {
  int winding = 0;
  for (std::size_t i = 0; i < r.size(); ++i) winding += turn_of_edge(r[i], r[(i + 1) % r.size()], px, py);
  return winding;
}

template <class Rings>
bool oracle_inside(const Rings& rings, irg::fill_rule rule, std::int64_t px, std::int64_t py) {
  int winding = 0;
  for (const auto& r : rings) winding += winding_number(r, px, py);
  return rule == irg::fill_rule::even_odd ? winding % 2 != 0 : winding != 0;
}

/// Counts how often each pixel of a window is painted; tells spans that are empty, outside, out of order or touching.
struct canvas {
  explicit canvas(const irg::cell_window& w)
      : window(w), width(w.empty() ? 0 : static_cast<std::size_t>(w.x_last - w.x_first)),
        count(width * (w.empty() ? 0 : static_cast<std::size_t>(w.y_last - w.y_first)), 0) {}
  void operator()(const irg::span_of_cells& s) {
    if (s.x_first >= s.x_last || s.y < window.y_first || s.y >= window.y_last || s.x_first < window.x_first ||
        s.x_last > window.x_last || (any && (s.y < last.y || (s.y == last.y && s.x_first <= last.x_last)))) {
      ++bad_spans;
      return;
    }
    any = true;
    last = s;
    for (int x = s.x_first; x < s.x_last; ++x) ++at(x, s.y);
  }
  /// Starts over: the next span may be anywhere, the counts stay.
  canvas& again() {
    any = false;
    return *this;
  }
  int& at(int x, int y) {
    return count[static_cast<std::size_t>(y - window.y_first) * width + static_cast<std::size_t>(x - window.x_first)];
  }
  /// How many pixels are not painted exactly once where `inside` says so and not at all elsewhere.
  template <class Inside>
  long wrong(Inside inside) {
    long n = bad_spans;
    for (int y = window.y_first; y < window.y_last; ++y)
      for (int x = window.x_first; x < window.x_last; ++x) n += at(x, y) != (inside(x, y) ? 1 : 0);
    return n;
  }
  long painted() const {
    long n = 0;
    for (const int c : count) n += c;
    return n;
  }

  irg::cell_window window;
  std::size_t width;
  std::vector<int> count;
  irg::span_of_cells last;
  bool any = false;
  long bad_spans = 0;
};

inline int random_int(random& r, std::int64_t low, std::int64_t high) { return static_cast<int>(r.integer(low, high)); }

/// A window within [low, high), empty or inverted now and then.
inline irg::cell_window random_window(random& r, int low, int high) {
  const int x = random_int(r, low, high - 1), y = random_int(r, low, high - 1);
  return {x, y, random_int(r, x - 1, high), random_int(r, y - 1, high)};
}

/// A convex ring of up to n vertices: points of an ellipse in the order of their angle, which may repeat.
inline ring random_convex(random& r, int n, int extent) {
  // Rational points of the unit circle, ((1-t^2), 2t) / (1+t^2), so that no compiler's cosine matters.
  std::vector<std::int64_t> t;
  for (int i = 0; i < n; ++i) t.push_back(r.integer(-999, 999));
  for (std::size_t i = 1; i < t.size(); ++i)
    for (std::size_t k = i; k > 0 && t[k] < t[k - 1]; --k) {
      const std::int64_t swap = t[k];
      t[k] = t[k - 1];
      t[k - 1] = swap;
    }
  const std::int64_t rx = r.integer(1, extent), ry = r.integer(1, extent), cx = r.integer(-extent, extent),
                     cy = r.integer(-extent, extent);
  const std::int64_t unit = 250;
  ring out;
  for (const std::int64_t k : t) {
    const std::int64_t d = unit * unit + k * k,
                       s = r.next() % 8 == 0 ? 0 : 1;  // some vertices fall into the centre's column
    out.push_back({static_cast<std::int32_t>(cx + s * rx * (unit * unit - k * k) / d),
                   static_cast<std::int32_t>(cy + ry * 2 * unit * k / d)});
  }
  return out;
}

}  // namespace test
