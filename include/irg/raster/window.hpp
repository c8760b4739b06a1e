// SPDX-License-Identifier: MIT
// within(raster, window): a raster of which drawing touches a rectangle of pixels only, for every function that draws.
#pragma once

#include <irg/core/raster_concept.hpp>
#include <irg/core/sinks.hpp>

namespace irg {

/// A raster of which drawing touches a window only. Its size and its pixels are those of the raster it refers to; it is
/// one itself, and like a pointer writes even when it is const.
template <ReadableRaster R>
struct raster_within {
  R& raster;
  cell_window window;
};

template <class R>
struct raster_traits<const raster_within<R>> {
  using view = raster_within<R>;
  using pixel = pixel_of<R>;
  IRG_INLINE static constexpr int width(const view& v) { return width_of(v.raster); }
  IRG_INLINE static constexpr int height(const view& v) { return height_of(v.raster); }
  IRG_INLINE static constexpr pixel get(const view& v, int x, int y) { return get_pixel(v.raster, x, y); }
  IRG_INLINE static constexpr void set(const view& v, int x, int y, const pixel& p)
    requires WritableRaster<R>
  {
    set_pixel(v.raster, x, y, p);
  }
  IRG_INLINE static constexpr pixel* row(const view& v, int y)
    requires RowRaster<R>
  {
    return raster_traits<R>::row(v.raster, y);
  }
  IRG_INLINE static constexpr std::ptrdiff_t bytes_per_row(const view& v)
    requires EvenRowRaster<R>
  {
    return raster_traits<R>::bytes_per_row(v.raster);
  }
};

template <class R>
struct raster_traits<raster_within<R>> : raster_traits<const raster_within<R>> {};

inline namespace IRG_ABI {

/// The pixels that both windows hold.
[[nodiscard]] IRG_INLINE constexpr cell_window intersect(const cell_window& a, const cell_window& b) noexcept {
  return {maximum(a.x_first, b.x_first), maximum(a.y_first, b.y_first), minimum(a.x_last, b.x_last),
          minimum(a.y_last, b.y_last)};
}

/// The pixels of a raster that drawing may touch: all, or those that within() leaves.
template <ReadableRaster R>
[[nodiscard]] IRG_INLINE constexpr cell_window window_of(const R& r) {
  return {0, 0, width_of(r), height_of(r)};
}
template <class R>
[[nodiscard]] IRG_INLINE constexpr cell_window window_of(const raster_within<R>& r) {
  return r.window;
}

/// The raster as functions that draw shall see it: draw_line(within(picture, window), a, b, paint).
/// needs   a raster that outlives the result
/// gives   a raster whose window_of is the part of the window that the raster, or an earlier within(), allows
template <ReadableRaster R>
IRG_INLINE constexpr const raster_within<R> within(R& r, const cell_window& window) {
  return {r, intersect(window, window_of(r))};
}
template <class R>
[[nodiscard]] IRG_INLINE constexpr const raster_within<R> within(const raster_within<R>& r, const cell_window& window) {
  return {r.raster, intersect(window, r.window)};
}

}  // namespace IRG_ABI
}  // namespace irg
