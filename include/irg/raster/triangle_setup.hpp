// SPDX-License-Identifier: MIT
// What the pixels of a triangle share, and from it the depth and the weights at each: the arithmetic of every method
// that draws triangles, written once, for scalars and packs.
#pragma once

#include <cstdint>

#include <irg/core/lanes.hpp>
#include <irg/raster/pixel_weights.hpp>
#include <irg/raster/subpixel.hpp>
#include <irg/raster/triangle_coverage.hpp>

namespace irg::inline IRG_ABI {

/// The three barycentric weights of a pixel on the screen: all positive, each accurate to a few units in its last
/// place.
template <class F>
struct screen_weights {
  F b0, b1, b2;

  /// A quantity that is linear on the screen, given at the three vertices. Quantities of one sign keep their relative
  /// accuracy, however far apart the vertices' values are: nothing cancels.
  IRG_INLINE constexpr F operator()(float at0, float at1, float at2) const noexcept {
    using f = lanes<F>;
    return product(b0, f::broadcast(at0)) + (product(b1, f::broadcast(at1)) + product(b2, f::broadcast(at2)));
  }
};

/// How depths follow from a triangle's edge functions F, for one pixel or a register of them: the sum of F * gain[i],
/// and `rest`, within the vertices' range.
template <class F>
struct depth_plane {
  F gain[3], rest, low, high;
};

/// Everything about a triangle that its pixels share. Vertices and edges keep the order the vertices were given in. The
/// barycentric weight i of a pixel is F * scale + rest[i]; all weights and their summands are positive, so nothing
/// cancels.
struct triangle_setup {
  triangle_edge edge[3];
  float scale;  // 256 / double_area
  float rest[3];  // the edge's rest / double_area
  float inverse_w[3];
  depth_plane<float> depth;

  template <class F, class J>
  [[nodiscard]] IRG_INLINE constexpr F weight(int i, const J& f) const noexcept {
    return product(to_float(f), lanes<F>::broadcast(scale)) + lanes<F>::broadcast(rest[i]);
  }
};

/// The depth of a pixel from its three edge functions, limited to the range of the vertices' depths, which rounding
/// might leave. Turning a triangle round exchanges its second and third vertex, and changes no bit.
/// shape   a depth_plane, or what has its members
/// exact   within 4 ulp for depths of one sign and below 2^118; where they are tiny underflow adds up to 2^-72
template <class F, class J>
[[nodiscard]] IRG_INLINE constexpr F depth_at(const J (&f)[3], const auto& plane) noexcept {
  const F depth = (product(to_float(f[0]), plane.gain[0]) + plane.rest) +
                  (product(to_float(f[1]), plane.gain[1]) + product(to_float(f[2]), plane.gain[2]));
  return low_of(plane.high, high_of(plane.low, depth));
}

/// The set-up of a triangle: its edges in the order of its vertices, whichever way round it is given.
/// needs   a coverage with an area, of the positions of the three vertices
[[nodiscard]] IRG_INLINE constexpr triangle_setup set_up_triangle(const triangle_coverage& t, const screen_vertex& v0,
                                                                  const screen_vertex& v1,
                                                                  const screen_vertex& v2) noexcept {
  const triangle_edge& edge1 = t.edge[t.flipped ? 2 : 1];
  const triangle_edge& edge2 = t.edge[t.flipped ? 1 : 2];
  triangle_setup s{
      {t.edge[0], edge1, edge2},
      float{one_pixel} / to_float(t.double_area),
      {},
      {v0.inverse_w, v1.inverse_w, v2.inverse_w},
      {{}, 0, lesser(lesser(v0.depth, v1.depth), v2.depth), greater(greater(v0.depth, v1.depth), v2.depth)}};
  const float depth[3] = {v0.depth, v1.depth, v2.depth}, unit = s.scale * (1.0f / one_pixel);
  for (int i = 0; i < 3; ++i) {
    s.rest[i] = product(to_float(s.edge[i].rest), unit);
    s.depth.gain[i] = product(s.scale, depth[i]);
  }
  s.depth.rest = product(s.rest[0], depth[0]) + (product(s.rest[1], depth[1]) + product(s.rest[2], depth[2]));
  return s;
}

/// The perspective-correct weights of a pixel from its barycentric ones.
/// exact   within 4e-7
/// source  Heckbert and Moreton 1991
template <class F>
[[nodiscard]] IRG_INLINE constexpr pixel_weights<F> perspective_weights(const triangle_setup& s, const F& b0,
                                                                        const F& b1, const F& b2,
                                                                        const F& depth) noexcept {
  using f = lanes<F>;
  const screen_weights<F> weights{b0, b1, b2};
  const F inverse = f::broadcast(1.0f) / weights(s.inverse_w[0], s.inverse_w[1], s.inverse_w[2]);
  return {product(product(b1, f::broadcast(s.inverse_w[1])), inverse),
          product(product(b2, f::broadcast(s.inverse_w[2])), inverse), depth};
}

/// A triangle on the screen, ready to be drawn.
struct covered_triangle {
  triangle_coverage coverage;
  triangle_setup setup;  // undefined where the coverage has no area
};

/// The triangle of three vertices, in either winding.
/// needs   positions within snap_limit
[[nodiscard]] IRG_INLINE constexpr covered_triangle cover_and_set_up(const screen_vertex& v0, const screen_vertex& v1,
                                                                     const screen_vertex& v2) noexcept {
  const triangle_coverage t = cover_triangle(v0.position, v1.position, v2.position);
  return {t, t.double_area == 0 ? triangle_setup{} : set_up_triangle(t, v0, v1, v2)};
}

/// Whether F, at every pixel of the window widened by `margin` columns, fits in 32 bits with a bit to spare.
[[nodiscard]] IRG_INLINE constexpr bool fits_32_bits(const triangle_coverage& t, const cell_window& w,
                                                     int margin) noexcept {
  const std::int64_t limit = std::int64_t{1} << 30;
  for (const triangle_edge& e : t.edge) {
    const std::int64_t corner = e(w.x_first - margin, w.y_first);
    const std::int64_t across = std::int64_t{e.right} * (w.x_last - w.x_first + 2 * margin);
    const std::int64_t along = std::int64_t{e.down} * (w.y_last - w.y_first);
    const std::int64_t low = corner + lesser(across, std::int64_t{0}) + lesser(along, std::int64_t{0});
    const std::int64_t high = corner + greater(across, std::int64_t{0}) + greater(along, std::int64_t{0});
    if (low < -limit || high > limit) return false;
  }
  return true;
}

/// The depth of the triangle at pixel (x, y), one by one.
[[nodiscard]] IRG_INLINE constexpr float depth_at(const triangle_setup& s, int x, int y) noexcept {
  return depth_at<float>({s.edge[0](x, y), s.edge[1](x, y), s.edge[2](x, y)}, s.depth);
}

/// The depth and the perspective-correct weights of the triangle at pixel (x, y), one by one.
[[nodiscard]] IRG_INLINE constexpr pixel_weights<float> weights_at(const triangle_setup& s, int x, int y) noexcept {
  const auto weight = [&](int i) { return s.weight<float>(i, s.edge[i](x, y)); };
  return perspective_weights<float>(s, weight(0), weight(1), weight(2), depth_at(s, x, y));
}

}  // namespace irg::inline IRG_ABI
