// SPDX-License-Identifier: MIT
// The whole pipeline on one screen: vertices through the matrix and on to the picture, triangles by their edge
// functions, pixels by their depth. For reading: irg::shade_triangles clips, sorts, and shades only what is seen.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>

#include <irg/colour/pixel.hpp>
#include <irg/math/mat.hpp>
#include <irg/raster/image.hpp>
#include <irg/raster/pixel_weights.hpp>
#include <irg/raster/triangle_coverage.hpp>

namespace irg::textbook::inline IRG_ABI {

/// Draws triangles, three corners each: those seen counter-clockwise, where no depth so far is as great; a pixel of the
/// n-th gets the colour shade(n, weights), a pixel_weights<float>.
/// needs   images of one size; depths cleared to 0, and a matrix that makes them greater where nearer, as perspective
/// gives   nothing is clipped: a triangle that reaches behind the eye or 2^21 pixels away is left out
/// exact   coverage as irg::shade_triangles, decided in integers; depths and weights rounded from doubles
/// source  Pineda 1988; Heckbert and Moreton 1991 for the weights
template <class Shade>
constexpr void shade_triangles(std::span<const point<double, 3>> corners, const mat<double, 4, 4>& to_clip,
                               image<rgba8>& picture, image<float>& depth, const Shade& shade) {
  const double half_width = picture.width() / 2.0, half_height = picture.height() / 2.0;
  for (std::size_t n = 0; 3 * n + 2 < corners.size(); ++n) {
    // 1. Vertices: through the matrix, divided by w, on to the picture (y down), rounded to 1/256 pixel.
    subpixel v[3];
    double z[3], inverse_w[3];
    std::size_t k = 0;
    for (; k < 3; ++k) {
      const hpoint<double, 3> p = to_clip * corners[3 * n + k];
      if (!(p.w > 0)) break;
      inverse_w[k] = 1 / p.w;
      z[k] = product(p.z, inverse_w[k]);
      const double x = half_width + product(product(p.x, inverse_w[k]), half_width);
      const double y = half_height - product(product(p.y, inverse_w[k]), half_height);
      if (!can_snap(x) || !can_snap(y)) break;
      v[k] = {snap(x), snap(y)};
    }
    // 2. The triangle: twice its area, negative where its back is seen, and the box of its pixels.
    const std::int64_t area = k == 3 ? twice_signed_area(v[2], v[1], v[0]) : 0;
    if (area <= 0) continue;
    const auto [left, right] = std::minmax({v[0].x, v[1].x, v[2].x});
    const auto [top, bottom] = std::minmax({v[0].y, v[1].y, v[2].y});
    for (int y = maximum(top / one_pixel, 0); y <= minimum(bottom / one_pixel, picture.height() - 1); ++y)
      for (int x = maximum(left / one_pixel, 0); x <= minimum(right / one_pixel, picture.width() - 1); ++x) {
        // 3. Pixels: inside of all three edges, or on one that is a left or a top edge; and nearer than what is there.
        double b[3];  // barycentric coordinates of the pixel's centre
        bool inside = true;
        for (k = 0; k < 3; ++k) {
          const subpixel from = v[(k + 2) % 3], to = v[(k + 1) % 3];
          const std::int64_t e = twice_signed_area(from, to, {x * one_pixel + half_pixel, y * one_pixel + half_pixel});
          inside = inside && (e > 0 || (e == 0 && (to.y < from.y || (to.y == from.y && to.x > from.x))));
          b[k] = static_cast<double>(e) / static_cast<double>(area);
        }
        const auto here = static_cast<float>(product(b[0], z[0]) + product(b[1], z[1]) + product(b[2], z[2]));
        if (!inside || !(here > depth(x, y))) continue;
        for (k = 0; k < 3; ++k) b[k] = product(b[k], inverse_w[k]);  // what is linear in space is divided by w, too
        const double sum = b[0] + b[1] + b[2];
        depth(x, y) = here;
        picture(x, y) = shade(n, pixel_weights<float>{float(b[1] / sum), float(b[2] / sum), here});
      }
  }
}

}  // namespace irg::textbook::inline IRG_ABI
