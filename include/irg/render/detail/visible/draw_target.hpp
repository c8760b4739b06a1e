// SPDX-License-Identifier: MIT
// Where drawing goes, and whether it is cleared first.
#pragma once

#include <type_traits>

#include <irg/raster/image.hpp>
#include <irg/raster/window.hpp>

namespace irg {

/// Whether the picture and its depth are cleared first: tile by tile, just before each is drawn, while it is in the
/// cache.
enum class clearing { none, before_drawing };

/// Whether the depths are wanted afterwards. Where they are not, and the picture is cleared first, the depth raster is
/// left as it is at run time: no work is spent on it.
enum class depth_result { kept, dropped };

/// Where drawing goes: a raster of colours or numbers, and the depths of what it shows, of one size. At a call
/// `{picture, depth}` is enough where they are images or views of the pixels that the function takes by default, else
/// `irg::render_target{picture, depth}`.
template <RowRaster Colour, RowRaster Depth>
struct render_target {
  Colour& colour;
  Depth& depth;
};
/// Of two views, which images become on the way in.
template <class P, class Z>
struct render_target<image_view<P>, image_view<Z>> {
  image_view<P> colour;
  image_view<Z> depth;
};
template <class Colour, class Depth>
render_target(Colour&, Depth&) -> render_target<Colour, Depth>;

namespace detail {

template <class R>
inline constexpr bool has_window = false;
template <class R>
inline constexpr bool has_window<raster_within<R>> = true;

inline namespace IRG_ABI {

// A raster for as long as one draws into a copy of it; what may be touched of it is copied back.
template <RowRaster R, class Draw>
constexpr auto on_copy(R& r, const Draw& draw) {
  image<pixel_of<R>> copy(width_of(r), height_of(r));
  for (int y = 0; y < copy.height(); ++y)
    for (int x = 0; x < copy.width(); ++x) copy(x, y) = get_pixel(r, x, y);
  image_view<pixel_of<R>> rows = copy.view();
  const auto result = draw(rows);
  const cell_window w = window_of(r);
  for (int y = w.y_first; y < w.y_last; ++y)
    for (int x = w.x_first; x < w.x_last; ++x) set_pixel(r, x, y, copy(x, y));
  return result;
}

// Calls draw(rows) with a raster as its rows allow: a view where they stand evenly, else itself. Where only a window of
// it may be touched, and for irg::compiled, which knows views alone, that is a view of a copy.
template <RowRaster R, class Draw>
constexpr auto on_rows(R& r, const Draw& draw) {
  if constexpr (has_window<std::remove_const_t<R>> || (!EvenRowRaster<R> && IRG_BODIES == 0)) {
    return on_copy(r, draw);
  } else if constexpr (EvenRowRaster<R>) {
    image_view<pixel_of<R>> rows = view_of(r);
    return draw(rows);
  } else {
    return draw(r);
  }
}

// The same of a target's two rasters: draw(colour, depth).
template <class Target, class Draw>
constexpr auto on_rows_of(Target& target, const Draw& draw) {
  auto& [to, second] = target;
  auto& depth_to = second;  // clang 14 captures no bindings
  return on_rows(to, [&](auto& colour) { return on_rows(depth_to, [&](auto& depth) { return draw(colour, depth); }); });
}

}  // namespace IRG_ABI
}  // namespace detail
}  // namespace irg
