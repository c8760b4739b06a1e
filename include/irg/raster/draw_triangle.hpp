// SPDX-License-Identifier: MIT
// draw_triangle: the triangle kernel. Coverage in integers, depth test, perspective-correct weights, one pixel shader
// call per visible pixel. The arithmetic is written once, in detail::triangle_kernel, for scalars and packs.
#pragma once

#include <bit>
#include <cstdint>

#include <irg/core/lanes.hpp>
#include <irg/raster/depth.hpp>
#include <irg/raster/draw_counts.hpp>
#include <irg/raster/pixel_weights.hpp>
#include <irg/raster/screen_vertex.hpp>
#include <irg/raster/triangle_coverage.hpp>

namespace irg {

namespace detail {
inline namespace IRG_ABI {

// Stands in for a depth raster where none is wanted.
struct no_depth {};

// The three barycentric weights of a pixel: all positive, each accurate to a few units in its last place.
template <class F>
struct screen_weights {
  F b0, b1, b2;

  // A quantity that is linear on the screen, given at the three vertices. Quantities of one sign keep their relative
  // accuracy, however far apart the vertices' values are: nothing cancels.
  IRG_INLINE constexpr F operator()(float at0, float at1, float at2) const noexcept {
    using f = lanes<F>;
    return product(b0, f::broadcast(at0)) + (product(b1, f::broadcast(at1)) + product(b2, f::broadcast(at2)));
  }
};

// Everything about a triangle that its pixels share. Vertices and edges keep the order the vertices were given in. The
// barycentric weight i of a pixel is F * scale + rest[i]; all weights and their summands are positive, so nothing
// cancels.
struct triangle_setup {
  triangle_edge edge[3];
  float scale;  // 256 / double_area
  float rest[3];  // the edge's rest / double_area
  float depth_gain[3], depth_rest;  // depth = the sum of F * depth_gain[i], and depth_rest
  float inverse_w[3];
  float depth_low, depth_high;

  template <class F, class I>
  IRG_INLINE constexpr F weight(int i, const I& f) const noexcept {
    return product(to_float(f), lanes<F>::broadcast(scale)) + lanes<F>::broadcast(rest[i]);
  }
};

// The depth of a pixel from its three edge functions, limited to the range of the vertices' depths, which rounding
// might leave. Turning a triangle round exchanges its second and third vertex, and changes no bit.
template <class F, class I>
IRG_INLINE constexpr F depth_at(const I& f0, const I& f1, const I& f2, const F& gain0, const F& gain1, const F& gain2,
                                const F& rest, const F& low, const F& high) noexcept {
  const F depth = (product(to_float(f0), gain0) + rest) + (product(to_float(f1), gain1) + product(to_float(f2), gain2));
  return low_of(high, high_of(low, depth));
}

IRG_INLINE constexpr triangle_setup set_up(const triangle_coverage& t, const screen_vertex& v0, const screen_vertex& v1,
                                           const screen_vertex& v2) noexcept {
  const triangle_edge& edge1 = t.edge[t.flipped ? 2 : 1];
  const triangle_edge& edge2 = t.edge[t.flipped ? 1 : 2];
  triangle_setup s{{t.edge[0], edge1, edge2},
                   float{one_pixel} / to_float(t.double_area),
                   {},
                   {},
                   {},
                   {v0.inverse_w, v1.inverse_w, v2.inverse_w},
                   lesser(lesser(v0.depth, v1.depth), v2.depth),
                   greater(greater(v0.depth, v1.depth), v2.depth)};
  const float depth[3] = {v0.depth, v1.depth, v2.depth}, unit = s.scale * (1.0f / one_pixel);
  for (int i = 0; i < 3; ++i) {
    s.rest[i] = product(to_float(s.edge[i].rest), unit);
    s.depth_gain[i] = product(s.scale, depth[i]);
  }
  s.depth_rest = product(s.rest[0], depth[0]) + (product(s.rest[1], depth[1]) + product(s.rest[2], depth[2]));
  return s;
}

// The perspective-correct weights of a pixel from its barycentric ones.
template <class F>
IRG_INLINE constexpr pixel_weights<F> perspective_weights(const triangle_setup& s, const F& b0, const F& b1,
                                                          const F& b2, const F& depth) noexcept {
  using f = lanes<F>;
  const screen_weights<F> weights{b0, b1, b2};
  const F inverse = f::broadcast(1.0f) / weights(s.inverse_w[0], s.inverse_w[1], s.inverse_w[2]);
  return {product(product(b1, f::broadcast(s.inverse_w[1])), inverse),
          product(product(b2, f::broadcast(s.inverse_w[2])), inverse), depth};
}

// Whether F, at every pixel of the window widened by `margin` columns, fits in 32 bits with a bit to spare.
IRG_INLINE constexpr bool fits_32_bits(const triangle_coverage& t, const cell_window& w, int margin) noexcept {
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

// Adds one to the counter in every lane where the mask holds.
template <std::integral I>
IRG_INLINE constexpr void count_up(I& counter, bool mask) noexcept {
  counter += mask ? 1 : 0;
}
template <int N>
IRG_INLINE void count_up(pack<std::int32_t, N>& counter, const pack<std::int32_t, N>& mask) noexcept {
  counter = counter - mask;
}
template <class I>
IRG_INLINE constexpr std::int64_t total(const I& counter) noexcept {
  std::int64_t sum = 0;
  for (int i = 0; i < lanes<I>::count; ++i) sum += lane(counter, i);
  return sum;
}

// Writes the shaded colour of every lane whose bit is set.
template <class F, class P, class Shader>
IRG_INLINE constexpr void shade_pixels(P* row, unsigned bits, const pixel_weights<F>& at, const Shader& shader) {
  if constexpr (LaneShader<Shader, P>) {
    const auto light = shader.light(at);
    float r[lanes<F>::count]{}, g[lanes<F>::count]{}, b[lanes<F>::count]{};
    lanes<F>::store(r, light.r);
    lanes<F>::store(g, light.g);
    lanes<F>::store(b, light.b);
    for (; bits != 0; bits &= bits - 1) {
      const int i = std::countr_zero(bits);
      row[i] = shader.encode({r[i], g[i], b[i]});
    }
  } else {
    for (; bits != 0; bits &= bits - 1) {
      const int i = std::countr_zero(bits);
      row[i] = shader(pixel_weights<float>{lane(at.weight1, i), lane(at.weight2, i), lane(at.depth, i)});
    }
  }
}

// The pixels [x, x + count) of one row, where they lie in [x_first, x_last). F is float or a pack of them; I is the
// integer of the same shape, or int64 with a plain float. Returns early when nothing is left to do.
template <class F, class I, class Order, class P, class Shader>
IRG_INLINE constexpr void triangle_pixels(const triangle_setup& s, int x, int y, int x_first, int x_last,
                                          float* depth_row, P* colour_row, const Shader& shader, I& tested, I& shaded,
                                          I& ties) {
  using integers = lanes<I>;
  using integer = typename integers::scalar;
  const auto at = [&](const triangle_edge& e) {
    return integers::broadcast(static_cast<integer>(e(x, y))) +
           integers::broadcast(static_cast<integer>(e.right)) * integers::ramp();
  };
  const I zero = integers::broadcast(0), column = integers::broadcast(static_cast<integer>(x)) + integers::ramp();
  const I f0 = at(s.edge[0]), f1 = at(s.edge[1]), f2 = at(s.edge[2]);
  const auto in_range = both(column >= integers::broadcast(x_first), column < integers::broadcast(x_last));
  const auto covered = both((f0 | f1 | f2) >= zero, in_range);
  if (mask_bits(covered) == 0) return;
  count_up(tested, covered);

  const auto all = [](float v) { return lanes<F>::broadcast(v); };
  const F depth = depth_at<F>(f0, f1, f2, all(s.depth_gain[0]), all(s.depth_gain[1]), all(s.depth_gain[2]),
                              all(s.depth_rest), all(s.depth_low), all(s.depth_high));
  auto visible = covered;
  if (depth_row != nullptr) {
    const F stored = lanes<F>::load(depth_row + x);
    visible = both(covered, Order::nearer(depth, stored));
    count_up(ties, both(covered, depth == stored));
    if (mask_bits(visible) == 0) return;
    lanes<F>::store(depth_row + x, select(visible, depth, stored));
  }
  count_up(shaded, visible);

  const pixel_weights<F> where =
      perspective_weights(s, s.weight<F>(0, f0), s.weight<F>(1, f1), s.weight<F>(2, f2), depth);
  shade_pixels(colour_row + x, mask_bits(visible), where, shader);
}

// Walks over the rows of the window; packs of F never leave [reach_first, reach_last).
template <class F, class I, class Order, class Colour, class Depth, class Shader>
constexpr draw_counts triangle_kernel(const triangle_coverage& t, const triangle_setup& s, const cell_window& w,
                                      int reach_last, Colour& colour, Depth& depth, const Shader& shader) {
  constexpr int count = lanes<F>::count;
  I tested = lanes<I>::broadcast(0), shaded = tested, ties = tested;
  for (int y = w.y_first; y < w.y_last; ++y) {
    span_of_cells row{y, w.x_first, w.x_last};
    if (w.x_last - w.x_first > 4 * count) row = covered_span(t, y, w.x_first, w.x_last);  // finding the ends pays
    float* depth_row = nullptr;
    if constexpr (!std::same_as<Depth, const no_depth>) depth_row = raster_traits<Depth>::row(depth, y);
    for (int x = row.x_first; x < row.x_last; x += count)
      triangle_pixels<F, I, Order>(s, lesser(x, reach_last - count), y, x, row.x_last, depth_row,
                                   raster_traits<Colour>::row(colour, y), shader, tested, shaded, ties);
  }
  return {total(tested), total(shaded), total(ties)};
}

// Chooses the kernel: lanes with 32-bit coverage where the numbers fit, else one pixel at a time with 64 bits.
template <class Order, class Colour, class Depth, class Shader>
constexpr draw_counts draw_covered(Colour& colour, Depth& depth, const triangle_coverage& t, const screen_vertex& v0,
                                   const screen_vertex& v1, const screen_vertex& v2, const Shader& shader,
                                   const cell_window& window) {
  const cell_window w = intersect(t.bounds, window);
  if (t.double_area == 0 || w.empty()) return {};
  const triangle_setup s = set_up(t, v0, v1, v2);
  if (!std::is_constant_evaluated()) {
    constexpr int count = native_lanes<float>;
    if (window.x_last - window.x_first >= count && fits_32_bits(t, w, count))
      return triangle_kernel<pack<float, count>, pack<std::int32_t, count>, Order>(t, s, w, window.x_last, colour,
                                                                                   depth, shader);
  }
  return triangle_kernel<float, std::int64_t, Order>(t, s, w, window.x_last, colour, depth, shader);
}

}  // namespace IRG_ABI
}  // namespace detail

inline namespace IRG_ABI {

/// Draws the pixels of a triangle that are nearer than what `depth` holds, and returns how many were tested and drawn.
/// shape   v0, v1, v2 in either winding, t their coverage; `shader` receives the weights of v1 and v2
/// needs   positions within snap_limit, depths that are finite, inverse_w > 0; colour and depth cover `window`
/// gives   nothing for a degenerate triangle; equal depths leave the pixel as it was, so the first drawn wins
/// exact   coverage by cover_triangle; depth within 4 ulp for depths of one sign, and never outside the range of the
///         vertices' depths; weights within 4e-7
/// cost    proportional to the pixels of the bounding box for small triangles, to the covered ones for wide ones
/// source  Pineda 1988; Heckbert and Moreton 1991 for the perspective correction
template <DepthOrder Order = nearer_is_greater, RowRaster Colour, RowRaster Depth, PixelShader<pixel_of<Colour>> Shader>
  requires std::same_as<pixel_of<Depth>, float>
constexpr draw_counts draw_triangle(Colour& colour, Depth& depth, const triangle_coverage& t, const screen_vertex& v0,
                                    const screen_vertex& v1, const screen_vertex& v2, const Shader& shader,
                                    const cell_window& window) {
  return detail::draw_covered<Order>(colour, depth, t, v0, v1, v2, shader, window);
}

/// As above, the coverage worked out here and the whole raster open to drawing.
template <DepthOrder Order = nearer_is_greater, RowRaster Colour, RowRaster Depth, PixelShader<pixel_of<Colour>> Shader>
  requires std::same_as<pixel_of<Depth>, float>
constexpr draw_counts draw_triangle(Colour& colour, Depth& depth, const screen_vertex& v0, const screen_vertex& v1,
                                    const screen_vertex& v2, const Shader& shader) {
  return draw_triangle<Order>(colour, depth, cover_triangle(v0.position, v1.position, v2.position), v0, v1, v2, shader,
                              window_of(colour));
}

/// Draws every covered pixel of a triangle: no depth buffer, what is drawn later covers what was drawn before.
template <RowRaster Colour, PixelShader<pixel_of<Colour>> Shader>
constexpr draw_counts draw_triangle(Colour& colour, const screen_vertex& v0, const screen_vertex& v1,
                                    const screen_vertex& v2, const Shader& shader) {
  const detail::no_depth depth{};
  return detail::draw_covered<drawing_order>(colour, depth, cover_triangle(v0.position, v1.position, v2.position), v0,
                                             v1, v2, shader, window_of(colour));
}

}  // namespace IRG_ABI
}  // namespace irg
