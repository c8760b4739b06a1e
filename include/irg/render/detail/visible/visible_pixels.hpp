// SPDX-License-Identifier: MIT
// The pixels of a window one by one: which triangle is seen, without lanes.
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include <irg/core/sinks.hpp>
#include <irg/raster/face_order.hpp>
#include <irg/raster/triangle_setup.hpp>
#include <irg/render/detail/bin/triangle_finder.hpp>
#include <irg/render/detail/visible/tile_test.hpp>

namespace irg::detail {

// The sign of keys where a depth order has none.
template <class Order>
inline constexpr float plain_sign = key_sign<Order> == 0 ? 1.0f : key_sign<Order>;

inline namespace IRG_ABI {

// The memory of such a window outside of a tile.
struct visible_pixels {
  std::vector<std::uint32_t> place;
  std::vector<float> key;

  constexpr explicit visible_pixels(const cell_window& w)
      : place(static_cast<std::size_t>((w.y_last - w.y_first) * tile_stride), no_index),
        key(place.size(), std::numeric_limits<float>::infinity()) {}
  static constexpr std::size_t at(const cell_window& w, int x, int y) noexcept {
    return static_cast<std::size_t>((y - w.y_first) * tile_stride + (x - w.x_first));
  }
};

// The face that a number stands for.
template <class T>
constexpr screen_face face_of(std::uint32_t number, const triangle_finder<T>& find) noexcept {
  const triangle_corners c = find.corners(number);
  return make_screen_face(*c.v[0], *c.v[1], *c.v[2], find.source(number));
}

// Whether face a is seen before face b, where both cover a pixel; of pieces of one triangle the first.
struct numbered_depth {
  std::uint32_t number;
  float depth;  // as it was rounded
};
template <class Order, class T>
constexpr bool is_seen_before(const numbered_depth& a, const numbered_depth& b, const cell& pixel,
                              const triangle_finder<T>& find) noexcept {
  const screen_face first = face_of(a.number, find), second = face_of(b.number, find);
  const int nearness = compare_depths<Order>({first, a.depth}, {second, b.depth}, pixel.x, pixel.y);
  if (nearness != 0) return nearness > 0;
  return first.number != second.number ? first.number < second.number : a.number < b.number;
}

// A list's triangles one after the other, each pixel by itself: what the lanes have to equal. Serves constant
// evaluation, orders of depth that are not irg's, and compilers without vector registers. What lies at the farthest
// depth is kept until all are drawn, though it is not seen: of what comes later, it may be the nearer one.
template <class Order, tile_test Test, class T, class Depth>
constexpr draw_counts find_visible_plainly(visible_pixels& out, Depth& depth, std::span<const std::uint32_t> numbers,
                                           const triangle_finder<T>& find, const cell_window& window) {
  constexpr bool by_depth = Test == tile_test::nearer && Order::nearer(1.0f, 0.0f) != Order::nearer(0.0f, 1.0f);
  draw_counts counts;
  for (std::uint32_t i = 0; i < numbers.size(); ++i) {
    const triangle_corners c = find.corners(numbers[i]);
    const covered_triangle t = cover_and_set_up(*c.v[0], *c.v[1], *c.v[2]);
    covered_spans(t.coverage, window, [&](const span_of_cells& span) {
      float* const row = raster_traits<Depth>::row(depth, span.y);
      counts.tested += span.x_last - span.x_first;
      for (int x = span.x_first; x < span.x_last; ++x) {
        const float here = depth_at(t.setup, x, span.y);
        if (Test == tile_test::nearer && here == row[x]) ++counts.ties;
        std::uint32_t& place = out.place[visible_pixels::at(window, x, span.y)];
        if (by_depth && place != no_index) {
          if (!is_seen_before<Order>({numbers[i], here}, {numbers[place], row[x]}, {x, span.y}, find)) continue;
        } else if (!Order::nearer(here, row[x]) && !(by_depth && here == Order::farthest && here == row[x])) {
          continue;
        }
        row[x] = here;
        place = i;
      }
    });
  }
  if (by_depth)
    for (int y = window.y_first; y < window.y_last; ++y)
      for (int x = window.x_first; x < window.x_last; ++x)
        if (raster_traits<Depth>::row(depth, y)[x] == Order::farthest)
          out.place[visible_pixels::at(window, x, y)] = no_index;
  for (int y = window.y_first; y < window.y_last; ++y)
    for (int x = window.x_first; x < window.x_last; ++x)
      out.key[visible_pixels::at(window, x, y)] = raster_traits<Depth>::row(depth, y)[x] * plain_sign<Order>;
  return counts;
}

}  // namespace IRG_ABI
}  // namespace irg::detail
