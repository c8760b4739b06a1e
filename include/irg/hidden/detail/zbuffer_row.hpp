// SPDX-License-Identifier: MIT
// A polygon in space on its way into a z-buffer: its picture as a ring for fill_convex, and its rows.
#pragma once

#include <irg/hidden/plane_depth.hpp>
#include <irg/raster/fill_convex.hpp>

namespace irg {
namespace detail {

// A polygon's corners on the picture plane, in pixels.
template <class R, class Project>
struct picture_ring {
  const R* ring;
  const Project* project;
};

}  // namespace detail

// How irg reads the picture of a polygon.
template <class R, class Project>
struct ring_traits<detail::picture_ring<R, Project>> {
  using point = irg::point<scalar_of<ring_point<R>>, 2>;
  IRG_INLINE static constexpr std::size_t size(const detail::picture_ring<R, Project>& r) noexcept {
    return ring_size(*r.ring);
  }
  IRG_INLINE static constexpr point vertex(const detail::picture_ring<R, Project>& r, std::size_t i) {
    return (*r.project)(ring_traits<R>::vertex(*r.ring, i));
  }
};

namespace detail {

// What keeps every depth of a polygon between its corners' depths.
template <class T>
struct depth_bounds {
  T low{}, high{};
};

inline namespace IRG_ABI {

inline constexpr double textbook_reach = 0x1p30;

// Whether every coordinate of every corner is a number within reach.
template <class R>
constexpr bool corners_within_reach(const R& ring) {
  using T = scalar_of<ring_point<R>>;
  constexpr T reach = static_cast<T>(textbook_reach);
  for (std::size_t i = 0; i < ring_size(ring); ++i)
    for (int k = 0; k < 3; ++k) {
      const T c = coordinate(ring_traits<R>::vertex(ring, i), k);
      if (!(-reach <= c && c <= reach)) return false;
    }
  return true;
}

// The greatest and least of f(vertex).
template <class T, class R, class F>
constexpr depth_bounds<T> bounds_over(const R& ring, const F& f) {
  depth_bounds<T> b;
  for (std::size_t i = 0; i < ring_size(ring); ++i) {
    const T v = f(ring_traits<R>::vertex(ring, i));
    b = i == 0 ? depth_bounds<T>{v, v} : depth_bounds<T>{lesser(b.low, v), greater(b.high, v)};
  }
  return b;
}

// The plane of a triangle by the determinant, of other polygons by Newell's sums.
template <class R>
constexpr auto polygon_plane(const R& ring) {
  if (ring_size(ring) != 3) return newell_plane(ring);
  return plane_through(ring_traits<R>::vertex(ring, 0), ring_traits<R>::vertex(ring, 1),
                       ring_traits<R>::vertex(ring, 2));
}

// v, kept within the bounds; the far bound where v is NaN.
template <class Order, class T>
IRG_INLINE constexpr T within_bounds(const T& v, const depth_bounds<T>& b) noexcept {
  if constexpr (Order::nearer(1.0f, 0.0f))
    return clamp(v, b.low, b.high);
  else
    return v < b.high ? (b.low < v ? v : b.low) : b.high;
}

template <class Buffers, class Walk, class T, class V>
constexpr void draw_row(const Buffers& buffers, const span_of_cells& s, Walk& walk, const depth_bounds<T>& b,
                        const V& value) {
  walk.start(s.x_first, s.y);
  for (int x = s.x_first; x < s.x_last; ++x, walk.next())
    buffers.set_pixel_within(
        x, s.y, static_cast<typename Buffers::depth_type>(within_bounds<typename Buffers::order>(walk.value(), b)),
        value);
}

template <class Buffers, class Picture, class Walk, class T, class V>
constexpr bool draw_polygon(const Buffers& buffers, const Picture& picture, Walk walk, const depth_bounds<T>& b,
                            const V& value) {
  return convex_spans(picture, buffers.window(), [&](const span_of_cells& s) { draw_row(buffers, s, walk, b, value); });
}

// A coordinate of the picture plane in pixels.
template <class T>
constexpr point<T, 2> on_grid(const picture_grid<T>& g, const T& x, const T& y) noexcept {
  const T half = T(1) / T(2);
  return {product(x, T(1) / g.per_column) + (half - g.x / g.per_column),
          product(y, T(1) / g.per_row) + (half - g.y / g.per_row)};
}

}  // namespace IRG_ABI
}  // namespace detail
}  // namespace irg
