// SPDX-License-Identifier: MIT
// The faces that a window may show, and the four parts of a window: for methods that cut the picture where it is
// crowded.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <irg/hidden/order_in_window.hpp>
#include <irg/raster/window_coverage.hpp>

namespace irg::detail {
inline namespace IRG_ABI {

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

// Those of a list, in its order, that touch a window and are not hidden in all of it by one that covers it whole.
template <DepthOrder Order>
constexpr std::vector<const screen_face*> faces_of_window(const std::vector<const screen_face*>& list,
                                                          const cell_window& w, std::int64_t& hidden) {
  std::vector<const screen_face*> faces;
  const screen_face* front = nullptr;
  for (const screen_face* f : list) {
    const containment where = classify(f->coverage, w);
    if (where == containment::outside) continue;
    faces.push_back(f);
    if (where == containment::inside && (front == nullptr || is_nearer<Order>(*f, *front, w.x_first, w.y_first)))
      front = f;
  }
  if (front != nullptr)
    hidden += static_cast<std::int64_t>(std::erase_if(
        faces, [&](const screen_face* f) { return f != front && hides_in_window<Order>(*front, *f, w); }));
  return faces;
}

// Of faces that touch a window of one pixel the one that is seen there.
template <DepthOrder Order>
constexpr const screen_face* seen_in_pixel(const std::vector<const screen_face*>& faces,
                                           const cell_window& w) noexcept {
  const screen_face* seen = nullptr;
  for (const screen_face* f : faces)
    if (covers(*f, w.x_first, w.y_first) && (seen == nullptr || is_nearer<Order>(*f, *seen, w.x_first, w.y_first)))
      seen = f;
  return seen;
}

}  // namespace IRG_ABI
}  // namespace irg::detail
