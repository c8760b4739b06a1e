// SPDX-License-Identifier: MIT
// The vertex stage: every position once to clip space, and where it is safely inside, on to the screen.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <irg/geometry/clip_homogeneous.hpp>
#include <irg/math/mat.hpp>
#include <irg/raster/draw_triangle.hpp>
#include <irg/view/viewport.hpp>

namespace irg {

/// Vertices on their way to the screen. Three arrays of one length.
template <Floating T>
struct projected_vertices {
  std::vector<hpoint<T, 3>> clip;
  std::vector<screen_vertex> screen;     // valid where `cut` is none
  std::vector<clip_planes> outside;      // the picture's borders and depth planes that the vertex is beyond
  std::vector<clip_planes> cut;          // the planes, sides widened to the guard band, that it is beyond
};

/// From clip space to the screen: the picture's place and how far beyond it the rasterizer's numbers reach.
template <Floating T>
struct screen_mapping {
  T half_width, half_height, centre_x, centre_y;
  clip_volume<T> picture, guard;
};

inline namespace IRG_ABI {

/// The mapping of clip space onto a picture of width x height pixels whose first pixel is (0, 0).
/// needs   1 <= width, height <= 65536
template <Floating T>
constexpr screen_mapping<T> map_to_screen(int width, int height) noexcept {
  // Up to 2^15 pixels from the picture's centre: coverage of small triangles then fits in 32 bits, and all in 64.
  const T half_width = static_cast<T>(width) / T(2), half_height = static_cast<T>(height) / T(2), reach = T(1 << 15);
  return {half_width,  half_height, half_width,
          half_height, {},          {clip_planes::all, reach / half_width, reach / half_height}};
}

/// Where a clip-space position stands on the screen.
/// needs   a position inside the guard band, w > 0
/// exact   each product, sum and quotient rounded once in T, then snapped; depth and 1/w rounded to float
template <Floating T>
IRG_INLINE constexpr screen_vertex to_screen(const hpoint<T, 3>& p, const screen_mapping<T>& m) noexcept {
  const T inverse = T(1) / p.w;
  const T x = product(product(p.x, inverse), m.half_width) + m.centre_x;
  const T y = m.centre_y - product(product(p.y, inverse), m.half_height);
  return {{snap(x), snap(y)}, static_cast<float>(product(p.z, inverse)), static_cast<float>(inverse)};
}

/// All positions in clip space, classified, and on the screen where they are inside the guard band.
/// exact   as to_screen; positions that are not finite are outside of every plane
/// cost    linear; allocates the result
template <Floating T>
constexpr projected_vertices<T> project_vertices(std::span<const point<T, 3>> positions, const mat<T, 4, 4>& to_clip,
                                                 const screen_mapping<T>& mapping) {
  const std::size_t n = positions.size();
  projected_vertices<T> v{std::vector<hpoint<T, 3>>(n, hpoint<T, 3>{}), std::vector<screen_vertex>(n, screen_vertex{}),
                          std::vector<clip_planes>(n, clip_planes::none),
                          std::vector<clip_planes>(n, clip_planes::none)};
  for (std::size_t i = 0; i < n; ++i) {
    const hpoint<T, 3> p = to_clip * positions[i];
    v.clip[i] = p;
    v.outside[i] = clip_code(p, mapping.picture);
    v.cut[i] = clip_code(p, mapping.guard);
    if (v.cut[i] == clip_planes::none) v.screen[i] = to_screen(p, mapping);
  }
  return v;
}

}  // namespace IRG_ABI
}  // namespace irg
