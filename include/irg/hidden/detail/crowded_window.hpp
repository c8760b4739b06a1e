// SPDX-License-Identifier: MIT
// The faces that a window may show, and the four parts of a window: for methods that cut the picture where it is
// crowded.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <irg/hidden/order_in_window.hpp>
#include <irg/raster/triangle_coverage.hpp>

namespace irg::detail::inline IRG_ABI {

constexpr bool is_one_pixel(const cell_window& w) noexcept {
  return w.x_last - w.x_first == 1 && w.y_last - w.y_first == 1;
}

// Quarters; halves and nothing of a window one pixel wide.
constexpr std::array<cell_window, 4> quarters(const cell_window& w) noexcept {
  const int x = w.x_first + (w.x_last - w.x_first) / 2, y = w.y_first + (w.y_last - w.y_first) / 2;
  return {{{w.x_first, w.y_first, x, y},
           {x, w.y_first, w.x_last, y},
           {w.x_first, y, x, w.y_last},
           {x, y, w.x_last, w.y_last}}};
}

template <DepthOrder Order>
IRG_INLINE constexpr float farthest_depth(const screen_face& f) noexcept {
  return depth_sense<Order> > 0 ? f.depth_low : f.depth_high;
}
template <DepthOrder Order>
IRG_INLINE constexpr float nearest_depth(const screen_face& f) noexcept {
  return depth_sense<Order> > 0 ? f.depth_high : f.depth_low;
}

// Whether a face that covers all of a window hides another one there: by the ranges of their depths, or by their planes
// where the other one may be.
template <DepthOrder Order>
constexpr bool hides_in_window(const screen_face& front, const screen_face& f, const cell_window& w) noexcept {
  if constexpr (depth_sense<Order> != 0)
    if (Order::nearer(farthest_depth<Order>(front), nearest_depth<Order>(f))) return true;
  return order_in_window<Order>(front, f, intersect(w, f.coverage.bounds)) == window_order::nearer;
}

// A face on a list, and what can be told of it without a look at the face, which lies anywhere in memory.
struct window_face {
  const screen_face* face = nullptr;
  cell_window bounds{};  // of its pixels
  float farthest = 0.0f, nearest = 0.0f;  // depths
};

template <DepthOrder Order>
IRG_INLINE constexpr window_face window_face_of(const screen_face& f) noexcept {
  return {&f, f.coverage.bounds, farthest_depth<Order>(f), nearest_depth<Order>(f)};
}

// classify, with the face's bounds at hand.
IRG_INLINE constexpr containment classify_face(const screen_face& f, const cell_window& b,
                                               const cell_window& w) noexcept {
  if (b.x_last <= w.x_first || w.x_last <= b.x_first || b.y_last <= w.y_first || w.y_last <= b.y_first)
    return containment::outside;
  const bool within = w.x_first < b.x_first && b.x_last < w.x_last && w.y_first < b.y_first && b.y_last < w.y_last;
  return within ? containment::crossing : classify(f.coverage, w);
}

// Those of a list, in its order, that touch a window and are not hidden in all of it by one that covers it whole.
template <DepthOrder Order>
constexpr std::vector<window_face> faces_of_window(const std::vector<window_face>& list, const cell_window& w,
                                                   std::int64_t& hidden) {
  std::vector<window_face> faces;
  const screen_face* front = nullptr;
  for (const window_face& f : list) {
    const containment where = classify_face(*f.face, f.bounds, w);
    if (where == containment::outside) continue;
    faces.push_back(f);
    if (where == containment::inside && (front == nullptr || is_nearer<Order>(*f.face, *front, w.x_first, w.y_first)))
      front = f.face;
  }
  if (front != nullptr)
    hidden += static_cast<std::int64_t>(std::erase_if(
        faces, [&](const window_face& f) { return f.face != front && hides_in_window<Order>(*front, *f.face, w); }));
  return faces;
}

// Of faces that touch a window of one pixel the one that is seen there.
template <DepthOrder Order>
constexpr const screen_face* seen_in_pixel(const std::vector<window_face>& faces, const cell_window& w) noexcept {
  const int x = w.x_first, y = w.y_first;
  const screen_face* seen = nullptr;
  for (const window_face& f : faces)
    if (covers(*f.face, x, y) && (seen == nullptr || is_nearer<Order>(*f.face, *seen, x, y))) seen = f.face;
  return seen;
}

}  // namespace irg::detail::inline IRG_ABI
