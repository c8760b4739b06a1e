// SPDX-License-Identifier: MIT
// shade_triangle: the triangle kernel. Coverage in integers, depth test, perspective-correct weights, one pixel shader
// call per visible pixel. The arithmetic is written once, in detail::triangle_pixels, for scalars and packs; it stands
// before shade_triangle, since it chooses between the two lives and no other file does.
#pragma once

#include <bit>
#include <cstdint>

#include <irg/core/lanes.hpp>
#include <irg/raster/depth_format.hpp>
#include <irg/raster/depth_options.hpp>
#include <irg/raster/draw_counts.hpp>
#include <irg/raster/pixel_weights.hpp>
#include <irg/raster/triangle_setup.hpp>

namespace irg {

/// What paint_triangle calls to draw with a pixel shader: the shaded colour goes into every pixel of a row whose bit is
/// set.
template <class Shader>
struct shade_over {
  const Shader& shader;

  template <class F, class P>
  IRG_INLINE constexpr void operator()(P* row, unsigned bits, const pixel_weights<F>& at) const {
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
};

namespace detail::inline IRG_ABI {

// Stands in for a depth raster where none is wanted, and for its pixels.
struct no_depth {};
template <class Depth>
struct depth_pixel {
  using type = pixel_of<Depth>;
};
template <>
struct depth_pixel<const no_depth> {
  using type = float;
};

// Counts of pixels, lane by lane.
template <class J>
struct lane_counts {
  J tested, shaded, ties;
};

// Adds one to the counter in every lane where the mask holds.
template <std::integral J>
IRG_INLINE constexpr void count_up(J& counter, bool mask) noexcept {
  counter += mask ? 1 : 0;
}
template <int N>
IRG_INLINE void count_up(pack<std::int32_t, N>& counter, const pack<std::int32_t, N>& mask) noexcept {
  counter = counter - mask;
}

// A row of the picture, and the part of it that may be drawn to.
template <class P, class Z>
struct triangle_row {
  int y, x_first, x_last;
  Z* depth;  // null where there are no depths
  P* colour;
};

// The pixels [x, x + count) of a row. F is float or a pack of them; J is the integer of the same shape, or int64 with a
// plain float. Returns early when nothing is left to do.
template <class Kept, class Policy, class F, class J, class P, class Z, class Paint>
IRG_INLINE constexpr void triangle_pixels(const triangle_setup& s, int x, const triangle_row<P, Z>& row,
                                          const Paint& paint, lane_counts<J>& counts) {
  using integers = lanes<J>;
  using integer = typename integers::scalar;
  const auto at = [&](const triangle_edge& e) {
    return integers::broadcast(static_cast<integer>(e(x, row.y))) +
           integers::broadcast(static_cast<integer>(e.right)) * integers::ramp();
  };
  const J zero = integers::broadcast(0), column = integers::broadcast(static_cast<integer>(x)) + integers::ramp();
  const J f0 = at(s.edge[0]), f1 = at(s.edge[1]), f2 = at(s.edge[2]);
  const auto in_range = both(column >= integers::broadcast(row.x_first), column < integers::broadcast(row.x_last));
  const auto covered = both((f0 | f1 | f2) >= zero, in_range);
  if (mask_bits(covered) == 0) return;
  count_up(counts.tested, covered);

  const auto all = [](float v) { return lanes<F>::broadcast(v); };
  const depth_plane<F> plane{{all(s.depth.gain[0]), all(s.depth.gain[1]), all(s.depth.gain[2])},
                             all(s.depth.rest),
                             all(s.depth.low),
                             all(s.depth.high)};
  const F depth = depth_at<F>({f0, f1, f2}, plane);
  auto visible = covered;
  if (row.depth != nullptr) {
    using kept = lanes<typename lanes<F>::template rebind<Z>>;
    const auto stored = kept::load(row.depth + x);
    const auto level = Kept::level(depth), there = Kept::level_of(stored);
    visible = both(covered, passes<Policy::test, typename Kept::order>(level, there));
    count_up(counts.ties, both(covered, level == there));
    if (mask_bits(visible) == 0) return;
    if constexpr (Policy::write == depth_write::on)
      kept::store(row.depth + x, Kept::with_level(stored, select(visible, level, there)));
  }
  count_up(counts.shaded, visible);
  paint(row.colour + x, mask_bits(visible),
        perspective_weights(s, s.weight<F>(0, f0), s.weight<F>(1, f1), s.weight<F>(2, f2), depth));
}

// Walks over the rows of the triangle's part of the window; packs of F never leave the window.
template <class How, class Policy, class F, class J, class Colour, class Depth, class Paint>
constexpr draw_counts triangle_rows(Colour& colour, Depth& depth, const covered_triangle& t, const Paint& paint,
                                    const cell_window& window) {
  using Z = typename depth_pixel<Depth>::type;
  constexpr int count = lanes<F>::count;
  const cell_window w = intersect(t.coverage.bounds, window);
  const J none = lanes<J>::broadcast(0);
  lane_counts<J> counts{none, none, none};
  for (int y = w.y_first; y < w.y_last; ++y) {
    span_of_cells span{y, w.x_first, w.x_last};
    if (w.x_last - w.x_first > 4 * count)  // finding the ends pays
      span = covered_span(t.coverage, y, w.x_first, w.x_last);
    triangle_row<pixel_of<Colour>, Z> row{y, span.x_first, span.x_last, nullptr, raster_traits<Colour>::row(colour, y)};
    if constexpr (!std::same_as<Depth, const no_depth>) row.depth = raster_traits<Depth>::row(depth, y);
    for (; row.x_first < row.x_last; row.x_first += count)
      triangle_pixels<depth_kept<How, Z>, Policy, F, J>(t.setup, minimum(row.x_first, window.x_last - count), row,
                                                        paint, counts);
  }
  return {reduce_add(counts.tested), reduce_add(counts.shaded), reduce_add(counts.ties)};
}

// A raster that triangles can be drawn into by depth: in an order floats are kept, in a format what it says.
template <class R, class How>
concept KeepsDepths = DepthKeeping<How, pixel_of<R>> && (DepthFormat<How> || std::same_as<pixel_of<R>, float>);

}  // namespace detail::inline IRG_ABI

inline namespace IRG_ABI {

/// shade_triangle with a painter in place of the shader: paint(row, bits, weights) is given a row from some pixel on,
/// as many bits as registers have lanes, set for the pixels to be drawn, and the weights of all these lanes.
/// shape   How, Policy, window and counts as shade_triangle has them; shade_over is the painter for shaders
/// needs   a painter for weights of float and of registers of float
template <class How, DepthPolicy Policy, RowRaster Colour, class Depth, class Paint>
constexpr draw_counts paint_triangle(Colour& colour, Depth& depth, const covered_triangle& t, const Paint& paint,
                                     const cell_window& window) {
  const cell_window w = intersect(t.coverage.bounds, window);
  if (t.coverage.double_area == 0 || w.empty()) return {};
  if (!std::is_constant_evaluated()) {
    constexpr int count = native_lanes<float>;
    // Lanes with 32-bit coverage where the numbers fit, else one pixel at a time with 64 bits.
    if (window.x_last - window.x_first >= count && fits_32_bits(t.coverage, w, count))
      return detail::triangle_rows<How, Policy, pack<float, count>, pack<std::int32_t, count>>(colour, depth, t, paint,
                                                                                               window);
  }
  return detail::triangle_rows<How, Policy, float, std::int64_t>(colour, depth, t, paint, window);
}

/// Draws the pixels of a triangle whose depths pass the test, by default those nearer than what `depth` holds, and
/// returns how many were tested and drawn.
/// shape   How says how `depth` keeps depths: a DepthOrder, floats as they come, or a DepthFormat, its `stored`.
///         `shader` receives the weights of the second and third vertex
/// needs   positions within snap_limit, depths that are finite, inverse_w > 0; colour and depth cover `window`
/// gives   nothing for a degenerate triangle; with the default policy equal depths leave the pixel as it was, so the
///         first drawn wins
/// exact   coverage by cover_triangle; depth within 4 ulp for depths of one sign, where they are tiny as depth_at says,
///         and never outside the range of the vertices' depths; weights within 4e-7
/// cost    proportional to the pixels of the bounding box for small triangles, to the covered ones for wide ones
/// source  Pineda 1988; Heckbert and Moreton 1991 for the perspective correction
template <class How = nearer_is_greater, DepthPolicy Policy = depth_policy<>, RowRaster Colour, RowRaster Depth,
          PixelShader<pixel_of<Colour>> Shader>
  requires detail::KeepsDepths<Depth, How>
constexpr draw_counts shade_triangle(Colour& colour, Depth& depth, const covered_triangle& t, const Shader& shader,
                                     const cell_window& window) {
  return paint_triangle<How, Policy>(colour, depth, t, shade_over<Shader>{shader}, window);
}

/// As above, the coverage worked out here and the whole raster open to drawing.
/// shape   the vertices in either winding; `shader` receives the weights of v[1] and v[2]; depth_inverse_w keeps their
///         inverse_w
template <class How = nearer_is_greater, DepthPolicy Policy = depth_policy<>, RowRaster Colour, RowRaster Depth,
          PixelShader<pixel_of<Colour>> Shader>
  requires detail::KeepsDepths<Depth, How>
constexpr draw_counts shade_triangle(Colour& colour, Depth& depth, const screen_vertex (&v)[3], const Shader& shader) {
  return shade_triangle<How, Policy>(
      colour, depth, cover_and_set_up(vertex_for<How>(v[0]), vertex_for<How>(v[1]), vertex_for<How>(v[2])), shader,
      window_of(colour));
}

/// Draws every covered pixel of a triangle: no depth buffer, what is drawn later covers what was drawn before.
template <RowRaster Colour, PixelShader<pixel_of<Colour>> Shader>
constexpr draw_counts shade_triangle(Colour& colour, const screen_vertex (&v)[3], const Shader& shader) {
  const detail::no_depth depth{};
  return paint_triangle<drawing_order, depth_policy<>>(colour, depth, cover_and_set_up(v[0], v[1], v[2]),
                                                       shade_over<Shader>{shader}, window_of(colour));
}

// The old name, spelled out: calls of it have braces and template arguments, which IRG_RENAMED does not pass on.
template <class How = nearer_is_greater, DepthPolicy Policy = depth_policy<>, RowRaster Colour, RowRaster Depth,
          PixelShader<pixel_of<Colour>> Shader>
  requires detail::KeepsDepths<Depth, How>
[[deprecated("irg: now shade_triangle")]] constexpr draw_counts draw_triangle(Colour& colour, Depth& depth,
                                                                              const covered_triangle& t,
                                                                              const Shader& shader,
                                                                              const cell_window& window) {
  return shade_triangle<How, Policy>(colour, depth, t, shader, window);
}
template <class How = nearer_is_greater, DepthPolicy Policy = depth_policy<>, RowRaster Colour, RowRaster Depth,
          PixelShader<pixel_of<Colour>> Shader>
  requires detail::KeepsDepths<Depth, How>
[[deprecated("irg: now shade_triangle")]] constexpr draw_counts draw_triangle(Colour& colour, Depth& depth,
                                                                              const screen_vertex (&v)[3],
                                                                              const Shader& shader) {
  return shade_triangle<How, Policy>(colour, depth, v, shader);
}
template <RowRaster Colour, PixelShader<pixel_of<Colour>> Shader>
[[deprecated("irg: now shade_triangle")]] constexpr draw_counts draw_triangle(Colour& colour,
                                                                              const screen_vertex (&v)[3],
                                                                              const Shader& shader) {
  return shade_triangle(colour, v, shader);
}

}  // namespace IRG_ABI
}  // namespace irg
