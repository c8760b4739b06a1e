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
  bool operator==(const depth_plane&) const
    requires std::equality_comparable<F>
  = default;
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
  bool operator==(const triangle_setup&) const = default;
};

/// The depth of a pixel from its three edge functions, limited to the range of the vertices' depths, which rounding
/// might leave. Turning a triangle round exchanges its second and third vertex, and changes no bit.
/// shape   a depth_plane, or what has its members
/// exact   within 4 ulp for depths of one sign and below 2^118; where they are tiny underflow adds up to 2^-72
template <class F, class J>
[[nodiscard]] IRG_INLINE constexpr F depth_at(const J (&f)[3], const auto& plane) noexcept {
  const F depth = (product(to_float(f[0]), plane.gain[0]) + plane.rest) +
                  (product(to_float(f[1]), plane.gain[1]) + product(to_float(f[2]), plane.gain[2]));
  return minimum(plane.high, maximum(plane.low, depth));
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
      {{}, 0, minimum(minimum(v0.depth, v1.depth), v2.depth), maximum(maximum(v0.depth, v1.depth), v2.depth)}};
  const float depth[3] = {v0.depth, v1.depth, v2.depth}, unit = s.scale * (1.0f / one_pixel);
  for (int i = 0; i < 3; ++i) {
    s.rest[i] = product(to_float(s.edge[i].rest), unit);
    s.depth.gain[i] = product(s.scale, depth[i]);
  }
  s.depth.rest = product(s.rest[0], depth[0]) + (product(s.rest[1], depth[1]) + product(s.rest[2], depth[2]));
  return s;
}

/// The boxes of N triangles on the screen, and twice their areas, a lane each.
template <int N>
struct triangle_boxes {
  using integers = pack<std::int32_t, N>;
  integers left, right, top, bottom;
  integers narrow;  // sides below 2^15, which leave the area within 31 bits and a sign; where not, it has no meaning
  integers double_area;

  IRG_INLINE triangle_boxes(const integers (&x)[3], const integers (&y)[3]) noexcept
      : left(minimum(minimum(x[0], x[1]), x[2])), right(maximum(maximum(x[0], x[1]), x[2])),
        top(minimum(minimum(y[0], y[1]), y[2])), bottom(maximum(maximum(y[0], y[1]), y[2])),
        narrow(both(right - left < (1 << 15), bottom - top < (1 << 15))),
        double_area((x[1] - x[0]) * (y[2] - y[0]) - (y[1] - y[0]) * (x[2] - x[0])) {}
};

/// The edges of N triangles, a lane each, in the order of their vertices, whichever way round they are given. It refers
/// to the coordinates that it is made of.
/// needs   narrow triangles with an area; what lanes of others hold has no meaning
/// exact   the bits of set_up_triangle, one by one
template <int N>
struct edge_lanes {
  using integers = pack<std::int32_t, N>;
  using floats = pack<float, N>;
  const integers (&x)[3], (&y)[3];  // of the vertices
  integers flip;  // a mask: which triangles run counter-clockwise on the screen
  integers dx[3], dy[3];  // edge k is opposite to vertex k, and runs by (dx, dy) with its inner side on the right
  floats scale, unit;  // 256 / double_area, 1 / double_area

  IRG_INLINE edge_lanes(const integers (&of_x)[3], const integers (&of_y)[3], const integers& double_area) noexcept
      : x(of_x), y(of_y), flip(double_area < 0) {
    const auto turned = [&](const integers& v) { return (v ^ flip) - flip; };
    scale = lanes<floats>::broadcast(one_pixel) / to_float(turned(double_area));
    unit = scale * lanes<floats>::broadcast(1.0f / one_pixel);
    for (int k = 0; k < 3; ++k) {
      const int p = (k + 1) % 3, q = (k + 2) % 3;
      dx[k] = turned(x[q] - x[p]);
      dy[k] = turned(y[q] - y[p]);
    }
  }

  /// An edge function at a pixel, and what it leaves of the exact one, as a weight.
  struct value {
    integers f;
    floats rest;
  };
  /// Edge k at the pixels (column, row).
  /// needs   pixels less than 2^15 from the triangle's corners, in 1/256 pixel; at others F has no meaning
  IRG_INLINE value operator()(int k, const integers& column, const integers& row) const noexcept {
    using J = lanes<integers>;
    const int p = (k + 1) % 3;
    const integers pixel = J::broadcast(one_pixel), half = J::broadcast(half_pixel);
    const integers e = dx[k] * (row * pixel + half - y[p]) - dy[k] * (column * pixel + half - x[p]);
    const integers f = ((e - J::broadcast(1)) - is_top_left(dx[k], dy[k])) >> subpixel_bits;
    return {f, to_float(e - f * pixel) * unit};
  }
};

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
    const std::int64_t low = corner + minimum(across, std::int64_t{0}) + minimum(along, std::int64_t{0});
    const std::int64_t high = corner + maximum(across, std::int64_t{0}) + maximum(along, std::int64_t{0});
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
