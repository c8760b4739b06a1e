// SPDX-License-Identifier: MIT
// The z-buffer as lectures draw it: SetPixel draws what is strictly nearer than what is there; polygons go row by row,
// their depths by adding -A/C. For reading: shade_triangle and render are fast, and have formats of depths.
#pragma once

#include <vector>

#include <irg/geometry/flat_ring.hpp>
#include <irg/hidden/plane_depth.hpp>
#include <irg/raster/depth.hpp>
#include <irg/raster/fill_convex.hpp>
#include <irg/raster/screen_face.hpp>

namespace irg::textbook {

/// A screen and a depth buffer, not owned: z towards the viewer with nearer_is_greater, distances with nearer_is_less.
/// Only pixels of the window are drawn, at first those that both have.
template <DepthOrder Order, WritableRaster Screen, DepthRaster Depth>
struct zbuffer {
  Screen& screen;
  Depth& depth;
  cell_window window;
  constexpr zbuffer(Order, Screen& s, Depth& d) : screen(s), depth(d), window(intersect(window_of(s), window_of(d))) {}

  /// Every pixel of the screen becomes the background, every depth that of the back plane (Zmin).
  constexpr void clear(const pixel_of<Screen>& background, const pixel_of<Depth>& back_plane) const {
    irg::clear(screen, background);
    irg::clear(depth, back_plane);
  }
  /// Draws v at (x, y) if z is nearer than the depth there, and says whether it was: not for NaN, nor for equal depths.
  constexpr bool set_pixel(int x, int y, const pixel_of<Depth>& z, const pixel_of<Screen>& v) const {
    if (x < window.x_first || x >= window.x_last || y < window.y_first || y >= window.y_last) return false;
    if (!Order::nearer(z, get_pixel(depth, x, y))) return false;
    irg::set_pixel(depth, x, y, z);
    irg::set_pixel(screen, x, y, v);
    return true;
  }
};

inline namespace IRG_ABI {

/// Draws a convex polygon in parallel projection: corners (x, y, z), x and y in pixels.
/// gives   false, and nothing drawn, when a coordinate is not within 2^30; nothing drawn where C is 0, seen edge on
/// exact   coverage as fill_convex; depths within the bound of depth_walk, none beyond the corners'
/// source  Hidden-surface slides; Fabris 2012, 2.2
template <class Order, class Screen, class Depth, SpaceRing R>
  requires Floating<ring_scalar<R>>
constexpr bool zbuffer_polygon(const zbuffer<Order, Screen, Depth>& out, const R& ring, const pixel_of<Screen>& v) {
  using T = ring_scalar<R>;
  T low = 1 << 30, high = -low;
  for (std::size_t i = 0; i < ring_size(ring); ++i) {
    const auto p = ring_vertex(ring, i);
    for (const T c : {coordinate(p, 0), coordinate(p, 1), coordinate(p, 2)})
      if (!(-(1 << 30) <= c && c <= 1 << 30)) return false;
    low = minimum(low, coordinate(p, 2));
    high = maximum(high, coordinate(p, 2));
  }
  const auto plane = irg::newell_plane(ring);
  const auto steps = plane ? plane_depth_steps(*plane) : std::nullopt;
  if (!steps) return true;
  depth_walk<T> walk(*steps);
  return irg::convex_spans(flat_ring<R>(ring, 2), out.window, [&](const span_of_cells& s) {
    walk.start(s.x_first, s.y);
    for (int x = s.x_first; x < s.x_last; ++x, walk.next())
      out.set_pixel(x, s.y, static_cast<pixel_of<Depth>>(clamped(walk.value(), low, high)), v);
  });
}

/// Draws a convex polygon seen from (0, 0, d): its picture on the plane z = 0, with the depths 1/(d - z), which are
/// linear there; the view's axis stands at pixel `axis`. z is d - 1/depth; clear to 1/(d - z) of the back plane.
/// needs   nearer_is_greater with d > 0, nearer_is_less with d < 0
/// gives   as zbuffer_polygon of the picture; false for numbers beyond 2^30, or a corner not in front of the eye: clip
template <class Order, class Screen, class Depth, SpaceRing R>
  requires Floating<ring_scalar<R>>
constexpr bool zbuffer_polygon_perspective(const zbuffer<Order, Screen, Depth>& out, const R& ring, ring_scalar<R> d,
                                           const pixel_of<Screen>& v, const point<ring_scalar<R>, 2>& axis = {}) {
  std::vector<point<ring_scalar<R>, 3>> picture;
  for (std::size_t i = 0; i < ring_size(ring); ++i) {
    const auto p = ring_vertex(ring, i);
    for (const auto c : {coordinate(p, 0), coordinate(p, 1), coordinate(p, 2), d})
      if (!(-(1 << 30) <= c && c <= 1 << 30)) return false;
    const auto w = d - coordinate(p, 2);
    if (!(d > 0 ? w > 0 : d < 0 && w < 0)) return false;
    picture.push_back({product(coordinate(p, 0), d / w) + axis.x, product(coordinate(p, 1), d / w) + axis.y, 1 / w});
  }
  return zbuffer_polygon(out, picture, v);
}

/// Draws a face of a picture: the pixels and the depths, bit for bit, of shade_triangle and render.
template <class Order, class Screen, class Depth>
constexpr void zbuffer_face(const zbuffer<Order, Screen, Depth>& out, const screen_face& f, const pixel_of<Screen>& v) {
  const triangle_setup setup = set_up_face(f);
  covered_spans(f.coverage, out.window, [&](const span_of_cells& s) {
    for (int x = s.x_first; x < s.x_last; ++x)
      out.set_pixel(x, s.y, static_cast<pixel_of<Depth>>(depth_at(setup, x, s.y)), v);
  });
}

}  // namespace IRG_ABI
}  // namespace irg::textbook
