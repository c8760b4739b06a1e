// SPDX-License-Identifier: MIT
// The pixels of a transparent triangle: tested against depths that stay as they are, blended over the colours.
#pragma once

#include <bit>
#include <concepts>
#include <cstdint>

#include <irg/raster/depth_options.hpp>
#include <irg/raster/draw_triangle.hpp>
#include <irg/render/detail/mark_seen.hpp>

namespace irg {
namespace detail {
inline namespace IRG_ABI {

// The pixels [x, x + count) of one row, where they lie in [x_first, x_last). F is float or a pack of them; I is the
// integer of the same shape, or int64 with a plain float. The depths have the bits that draw_triangle gives them.
template <class F, class I, depth_test Test, class Order, class P, class Shader, class Blend>
IRG_INLINE constexpr void transparent_pixels(const triangle_setup& s, int x, int y, int x_first, int x_last,
                                             const float* depth_row, P* colour_row, const Shader& shader,
                                             const Blend& blend, I& tested, I& shaded, I& ties) {
  using integers = lanes<I>;
  using integer = typename integers::scalar;
  const auto at = [&](const triangle_edge& e) {
    return integers::broadcast(static_cast<integer>(e(x, y))) +
           integers::broadcast(static_cast<integer>(e.right)) * integers::ramp();
  };
  const auto all = [](float v) { return lanes<F>::broadcast(v); };
  const I zero = integers::broadcast(0), column = integers::broadcast(static_cast<integer>(x)) + integers::ramp();
  const I f0 = at(s.edge[0]), f1 = at(s.edge[1]), f2 = at(s.edge[2]);
  const auto in_range = both(column >= integers::broadcast(x_first), column < integers::broadcast(x_last));
  const auto covered = both((f0 | f1 | f2) >= zero, in_range);
  if (mask_bits(covered) == 0) return;
  count_up(tested, covered);
  const F depth = depth_at<F>(f0, f1, f2, all(s.depth_gain[0]), all(s.depth_gain[1]), all(s.depth_gain[2]),
                              all(s.depth_rest), all(s.depth_low), all(s.depth_high));
  const F stored = lanes<F>::load(depth_row + x);
  count_up(ties, both(covered, depth == stored));
  const auto visible = both(covered, passes<Test, Order>(depth, stored));
  unsigned bits = mask_bits(visible);
  if (bits == 0) return;
  count_up(shaded, visible);
  const pixel_weights<F> where =
      perspective_weights(s, s.weight<F>(0, f0), s.weight<F>(1, f1), s.weight<F>(2, f2), depth);
  for (; bits != 0; bits &= bits - 1) {
    const int i = std::countr_zero(bits);
    P& pixel = colour_row[x + i];
    pixel = blend(pixel,
                  shader(pixel_weights<float>{lane(where.weight1, i), lane(where.weight2, i), lane(where.depth, i)}));
  }
}

template <class F, class I, depth_test Test, class Order, class Colour, class Depth, class Shader, class Blend>
constexpr draw_counts transparent_rows(const triangle_coverage& t, const triangle_setup& s, const cell_window& w,
                                       int reach_last, Colour& colour, Depth& depth, const Shader& shader,
                                       const Blend& blend) {
  constexpr int count = lanes<F>::count;
  I tested = lanes<I>::broadcast(0), shaded = tested, ties = tested;
  for (int y = w.y_first; y < w.y_last; ++y) {
    span_of_cells row{y, w.x_first, w.x_last};
    if (w.x_last - w.x_first > 4 * count) row = covered_span(t, y, w.x_first, w.x_last);
    for (int x = row.x_first; x < row.x_last; x += count)
      transparent_pixels<F, I, Test, Order>(s, lesser(x, reach_last - count), y, x, row.x_last,
                                            raster_traits<Depth>::row(depth, y), raster_traits<Colour>::row(colour, y),
                                            shader, blend, tested, shaded, ties);
  }
  return {total(tested), total(shaded), total(ties)};
}

// A triangle over what is in the window.
template <depth_test Test, class Order, class Colour, class Depth, class Shader, class Blend>
constexpr draw_counts blend_triangle(Colour& colour, Depth& depth, const triangle_coverage& t, const triangle_setup& s,
                                     const Shader& shader, const Blend& blend, const cell_window& window) {
  const cell_window w = intersect(t.bounds, window);
  if (!std::is_constant_evaluated()) {
    constexpr int count = native_lanes<float>;
    if (window.x_last - window.x_first >= count && fits_32_bits(t, w, count))
      return transparent_rows<pack<float, count>, pack<std::int32_t, count>, Test, Order>(t, s, w, window.x_last,
                                                                                          colour, depth, shader, blend);
  }
  return transparent_rows<float, std::int64_t, Test, Order>(t, s, w, window.x_last, colour, depth, shader, blend);
}

// The farthest depths of a tile, block by block, each found when it is first asked for.
template <class Order, class Depth>
struct farthest_depths {
  static constexpr int block = 8, across = 8;
  Depth& depth;
  cell_window window;  // at most 64 x 64 pixels
  std::uint64_t known = 0;
  float farthest[across * across]{};

  // The farthest depth that is a number. (Where there is none, nothing passes, whatever comes out here.)
  constexpr float of_block(int bx, int by) {
    const int i = by * across + bx;
    if ((known >> i & 1) != 0) return farthest[i];
    known |= std::uint64_t{1} << i;
    const int x_first = window.x_first + bx * block, y_first = window.y_first + by * block;
    const int x_last = lesser(x_first + block, window.x_last), y_last = lesser(y_first + block, window.y_last);
    bool any = false;
    float hidden_at = 0;
    for (int y = y_first; y < y_last; ++y) {
      const float* row = raster_traits<Depth>::row(depth, y);
      for (int x = x_first; x < x_last; ++x) {
        if (row[x] != row[x] || (any && !Order::nearer(hidden_at, row[x]))) continue;
        hidden_at = row[x];
        any = true;
      }
    }
    return farthest[i] = hidden_at;
  }

  // Whether no pixel of a triangle in w, none of them nearer than `nearest`, passes.
  template <depth_test Test>
  constexpr bool hides(float nearest, const cell_window& w) {
    for (int by = (w.y_first - window.y_first) / block; window.y_first + by * block < w.y_last; ++by)
      for (int bx = (w.x_first - window.x_first) / block; window.x_first + bx * block < w.x_last; ++bx)
        if (passes<Test, Order>(nearest, of_block(bx, by))) return false;
    return true;
  }
};

}  // namespace IRG_ABI
}  // namespace detail
}  // namespace irg
