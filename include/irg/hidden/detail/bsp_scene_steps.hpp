// SPDX-License-Identifier: MIT
// Planes of space on the screen, for bsp_scene_painter.
#pragma once

#include <irg/math/length.hpp>
#include <irg/math/mat.hpp>
#include <irg/raster/screen_mapping.hpp>

namespace irg {
namespace detail {

// A plane of space on the screen: right x + down y + depth z + rest is positive in front of it, x and y being those of
// a pixel's centre in pixels.
struct plane_on_screen {
  double right = 0, down = 0, depth = 0, rest = 0;

  IRG_INLINE constexpr double at(double x, double y) const noexcept {
    return product(right, x) + product(down, y) + rest;
  }
};

inline namespace IRG_ABI {

// From a point of the plane and two directions in it, u x v pointing to its front.
// positive   whether to_clip has a positive determinant
template <class T>
constexpr plane_on_screen to_plane_on_screen(const double (&a)[3], const double (&u)[3], const double (&v)[3],
                                             const mat<double, 4, 4>& to_clip, const screen_mapping<T>& mapping) {
  vec<double, 4> at, along, across;
  for (int i = 0; i < 4; ++i) {
    const auto moved = [&](const double(&w)[3]) {
      return product(to_clip(i, 0), w[0]) + product(to_clip(i, 1), w[1]) + product(to_clip(i, 2), w[2]);
    };
    at[i] = moved(a) + to_clip(i, 3);
    along[i] = moved(u);
    across[i] = moved(v);
  }
  // Their sizes are free, and products of three must stay within the range.
  const auto ordinary_at = scaled(at), ordinary_along = scaled(along), ordinary_across = scaled(across);
  const auto &p = ordinary_at.c, &q = ordinary_along.c, &r = ordinary_across.c;
  // What is perpendicular to all three.
  double k[4];
  for (int i = 0; i < 4; ++i) {
    const int x = (i + 1) % 4, y = (i + 2) % 4, z = (i + 3) % 4;
    const double minor = product(p[x], product(q[y], r[z]) - product(q[z], r[y])) -
                         product(p[y], product(q[x], r[z]) - product(q[z], r[x])) +
                         product(p[z], product(q[x], r[y]) - product(q[y], r[x]));
    k[i] = i % 2 == 0 ? minor : -minor;
  }
  const double right = k[0] / widened(mapping.half_width), down = -k[1] / widened(mapping.half_height);
  return {right, down, k[2],
          k[3] - product(right, widened(mapping.centre_x)) - product(down, widened(mapping.centre_y))};
}

}  // namespace IRG_ABI
}  // namespace detail

}  // namespace irg
