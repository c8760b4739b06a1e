// SPDX-License-Identifier: MIT
// The pixels of a part of a face by the corners of their convex hull. A part is what planes leave of a triangle, so
// that its pixels are all that lie in the hull; and where one plane is nearer than another is a half of the picture, so
// that the corners tell of all pixels.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <irg/core/vocabulary.hpp>
#include <irg/hidden/order_in_window.hpp>
#include <irg/raster/face_order.hpp>
#include <irg/raster/triangle_coverage.hpp>

namespace irg::detail::inline IRG_ABI {

/// The left and the right corners of some pixels, each from the highest row that has any to the lowest.
struct pixel_hull {
  std::vector<cell> left, right;
  constexpr bool empty() const noexcept { return left.empty(); }
};

struct hull_halves {
  pixel_hull nearer, farther;
};

/// The pixels of a hull that are as deep as a plane, first, first + step, ... up to last, and where the others are.
struct pixels_in_plane {
  window_order others = window_order::crossing;
  cell first, last, step;
};

// Twice the area of a triangle of pixels.
constexpr std::int64_t turn_of(const cell& a, const cell& b, const cell& c) noexcept {
  return (std::int64_t{b.x} - a.x) * (std::int64_t{c.y} - a.y) - (std::int64_t{b.y} - a.y) * (std::int64_t{c.x} - a.x);
}

// Takes in a row below those that are there: the columns first to last.
constexpr void add_row(pixel_hull& h, int y, int first, int last) {
  const auto add = [](std::vector<cell>& chain, const cell& c, int bulge) {
    while (chain.size() > 1 && turn_of(chain[chain.size() - 2], chain.back(), c) * bulge >= 0) chain.pop_back();
    chain.push_back(c);
  };
  add(h.left, {first, y}, 1);
  add(h.right, {last, y}, -1);
}

constexpr pixel_hull hull_of_face(const screen_face& f, const cell_window& w) {
  pixel_hull h;
  covered_spans(f.coverage, w, [&](const span_of_cells& s) {
    if (s.x_first < s.x_last) add_row(h, s.y, s.x_first, s.x_last - 1);
  });
  return h;
}

constexpr cell_window window_of(const pixel_hull& h) noexcept {
  cell_window w{h.left[0].x, h.left[0].y, h.right[0].x + 1, h.left.back().y + 1};
  for (const cell& c : h.left) w.x_first = minimum(w.x_first, c.x);
  for (const cell& c : h.right) w.x_last = maximum(w.x_last, c.x + 1);
  return w;
}

// One of the two chains, row by row.
struct hull_side {
  const std::vector<cell>& chain;
  std::size_t next = 0;

  // The column where the chain meets a row, rounded down, or up; rows are asked for in order.
  constexpr int at(int y, bool up) noexcept {
    while (next + 1 < chain.size() && chain[next].y < y) ++next;
    const cell &b = chain[next], &a = chain[next == 0 ? 0 : next - 1];
    if (b.y == y || a.y == b.y) return b.x;
    const std::int64_t rows = std::int64_t{b.y} - a.y, way = (std::int64_t{b.x} - a.x) * (std::int64_t{y} - a.y);
    const std::int64_t down = way >= 0 ? way / rows : -((rows - 1 - way) / rows);
    return static_cast<int>(a.x + down + (up && down * rows != way ? 1 : 0));
  }
};

// Calls use(y, first, last) for the rows of a hull that have pixels.
template <class Use>
constexpr void each_row(const pixel_hull& h, const Use& use) {
  hull_side left{h.left}, right{h.right};
  for (int y = h.left.front().y; y <= h.left.back().y; ++y)
    if (const int first = left.at(y, true), last = right.at(y, false); first <= last) use(y, first, last);
}

/// Whether a face is_nearer than the plane of another one at all pixels of a hull, at none, or at some. Of no pixels:
/// at none.
template <DepthOrder Order>
constexpr window_order order_of_pixels(const pixel_hull& h, const screen_face& f, const screen_face& plane) noexcept {
  if (h.empty()) return window_order::farther;
  const auto is_near = [&](const cell& c) { return is_nearer<Order>(f, plane, c.x, c.y); };
  const bool first = is_near(h.left[0]);
  for (const std::vector<cell>* chain : {&h.left, &h.right})
    for (const cell& c : *chain)
      if (is_near(c) != first) return window_order::crossing;
  return first ? window_order::nearer : window_order::farther;
}

/// The pixels at which a face is_nearer than the plane of another one, and the others.
template <DepthOrder Order>
constexpr hull_halves split_hull(const pixel_hull& h, const screen_face& f, const screen_face& plane) {
  hull_halves halves;
  each_row(h, [&](int y, int first, int last) {
    const auto is_near = [&](int x) { return is_nearer<Order>(f, plane, x, y); };
    const bool left = is_near(first);
    if (left == is_near(last)) return add_row(left ? halves.nearer : halves.farther, y, first, last);
    int same = first, other = last;  // the last column that is as the first one, the first that is not
    while (other - same > 1) {
      const int middle = same + (other - same) / 2;
      (is_near(middle) == left ? same : other) = middle;
    }
    add_row(left ? halves.nearer : halves.farther, y, first, same);
    add_row(left ? halves.farther : halves.nearer, y, other, last);
  });
  return halves;
}

/// Those pixels of a hull that are exactly as deep as a plane, where all others lie on one side of it: they are on one
/// side of the hull, or a corner.
/// gives   others = crossing where there are such on both sides, or no others
template <DepthOrder Order>
constexpr pixels_in_plane find_pixels_in_plane(const pixel_hull& h, const screen_face& f, const screen_face& plane) {
  pixels_in_plane found{window_order::crossing, {}, {}, {}};
  bool nearer = false, farther = false, any = false;
  for (const std::vector<cell>* chain : {&h.left, &h.right})
    for (const cell& c : *chain) {
      const int side = compare_depths<Order>(f, plane, c.x, c.y);
      nearer = nearer || side > 0;
      farther = farther || side < 0;
      if (side != 0) continue;
      if (!any) found.first = found.last = c;
      if (found.first != c) found.last = c;
      any = true;
    }
  if (nearer == farther || !any) return found;
  found.others = nearer ? window_order::nearer : window_order::farther;
  const int dx = found.last.x - found.first.x, dy = found.last.y - found.first.y;
  int a = dx < 0 ? -dx : dx, b = dy < 0 ? -dy : dy;
  while (b != 0) {
    const int rest = a % b;
    a = b;
    b = rest;
  }
  if (a != 0) found.step = {dx / a, dy / a};
  return found;
}

}  // namespace irg::detail::inline IRG_ABI
