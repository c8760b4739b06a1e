// SPDX-License-Identifier: MIT
// Lines and points in a picture that has depths: seen where no face is clearly nearer.
#pragma once

#include <optional>
#include <string_view>

#include <irg/geometry/clip_homogeneous.hpp>
#include <irg/raster/draw_text.hpp>
#include <irg/raster/image.hpp>
#include <irg/raster/line_bresenham.hpp>
#include <irg/raster/projected_vertices.hpp>

namespace irg::detail {
inline namespace IRG_ABI {

// A picture with depths, greater ones nearer, and the way from the world into it.
template <class T>
struct studio_canvas {
  image_view<rgba8> colour;
  const image<float>& depth;
  mat<T, 4, 4> to_clip;
  screen_mapping<T> mapping;

  // An edge lies in its faces, whose depths at the pixel's centre may be a little nearer or farther than the line's. So
  // it counts as seen unless all pixels around are nearer.
  constexpr bool sees_rounded(cell c, float own) const noexcept {
    for (int y = greater(c.y - 1, 0); y <= lesser(c.y + 1, depth.height() - 1); ++y)
      for (int x = greater(c.x - 1, 0); x <= lesser(c.x + 1, depth.width() - 1); ++x)
        if (depth(x, y) <= own) return true;
    return false;
  }

  static constexpr cell cell_at(const screen_vertex& v) noexcept {
    return {v.position.x >> subpixel_bits, v.position.y >> subpixel_bits};
  }

  constexpr void line_rounded(const hpoint<T, 3>& a, const hpoint<T, 3>& b, const rgba8& paint) {
    const auto left =
        clip_segment_homogeneous(clip_vertex<T, 0>{to_clip * a}, clip_vertex<T, 0>{to_clip * b}, mapping.guard);
    if (!left) return;
    if (!(T(0) < left->first.position.w && T(0) < left->second.position.w)) return;
    const screen_vertex from = to_screen(left->first.position, mapping), to = to_screen(left->second.position, mapping);
    const cell first = cell_at(from), last = cell_at(to);
    const int dx = last.x - first.x, dy = last.y - first.y;
    const bool flat = (dy < 0 ? -dy : dy) <= (dx < 0 ? -dx : dx);
    const int way = flat ? dx : dy;
    const float rise = to.depth - from.depth, steps = static_cast<float>(way == 0 ? 1 : way);
    line_bresenham(first, last, {0, 0, colour.width(), colour.height()}, [&](cell c) {
      const float gone = static_cast<float>(flat ? c.x - first.x : c.y - first.y);
      if (sees_rounded(c, from.depth + product(rise, gone / steps))) colour(c.x, c.y) = paint;
    });
  }
  constexpr void line_rounded(const point<T, 3>& a, const point<T, 3>& b, const rgba8& paint) {
    line_rounded(to_homogeneous(a), to_homogeneous(b), paint);
  }

  // Where a position is on the screen, if it is.
  constexpr std::optional<screen_vertex> place_of(const point<T, 3>& p) const noexcept {
    const hpoint<T, 3> at = to_clip * p;
    if (classify(at, mapping) != clip_code_pair{}) return std::nullopt;
    return to_screen(at, mapping);
  }

  // Nine pixels.
  constexpr void dot_rounded(const point<T, 3>& p, const rgba8& paint) {
    const auto v = place_of(p);
    if (!v || !sees_rounded(cell_at(*v), v->depth)) return;
    const cell c = cell_at(*v);
    for (int y = greater(c.y - 1, 0); y <= lesser(c.y + 1, colour.height() - 1); ++y)
      for (int x = greater(c.x - 1, 0); x <= lesser(c.x + 1, colour.width() - 1); ++x) colour(x, y) = paint;
  }

  constexpr void label(std::string_view text, const point<T, 3>& p, const rgba8& paint) {
    if (const auto v = place_of(p)) {
      const cell c = cell_at(*v);
      draw_text(colour, text, {static_cast<double>(c.x + 3), static_cast<double>(c.y - 3)}, {.size = 13}, paint);
    }
  }
};

}  // namespace IRG_ABI
}  // namespace irg::detail
