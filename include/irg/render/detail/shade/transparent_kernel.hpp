// SPDX-License-Identifier: MIT
// What transparent triangles need beside draw_triangle: blending, and the depths behind which nothing of them is seen.
#pragma once

#include <bit>
#include <cstdint>

#include <irg/raster/draw_triangle.hpp>
#include <irg/render/detail/shade/tile_shading.hpp>

namespace irg {
namespace detail {
inline namespace IRG_ABI {

// Blends what a shader gives over the pixels that are there.
template <class Shader, class Blend>
struct blend_over {
  const Shader& shader;
  const Blend& blend;
  const piece_weights* piece;

  template <class F, class P>
  IRG_INLINE constexpr void operator()(P* row, unsigned bits, pixel_weights<F> at) const {
    if (piece != nullptr) at = in_source(at, *piece);
    for (; bits != 0; bits &= bits - 1) {
      const int i = std::countr_zero(bits);
      row[i] = blend(row[i], shader(pixel_weights<float>{lane(at.weight1, i), lane(at.weight2, i), lane(at.depth, i)}));
    }
  }
};

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
