// SPDX-License-Identifier: MIT
// Triangles into an occlusion mask, in lanes. The greatest key counts, so they may come in any order: small ones by the
// shapes of their boxes, large ones block by block.
#pragma once

#include <cstdint>

#include <irg/render/detail/mask_small_kernel.hpp>

namespace irg {
namespace detail {
inline namespace IRG_ABI {

#ifdef IRG_LANES_VECTOR

template <class T>
struct mask_painter {
  mask_small_painter<T> small;
  mask_block_painter large;

  // A triangle of any size.
  IRG_INLINE void add(std::uint32_t number) noexcept {
    const triangle_corners c = small.find.corners(number);
    const cell_window box = pixels_touched(c.v[0]->position, c.v[1]->position, c.v[2]->position);
    if (box.x_last - box.x_first > small.few || box.y_last - box.y_first > small.few) return large.draw(c);
    const auto each = [](int v) { return lanes<mask_lanes::integers>::broadcast(v); };
    small.add(number, 1, small.shape_of(each(box.x_first), each(box.y_first), each(box.x_last), each(box.y_last)));
  }
};

#endif

}  // namespace IRG_ABI
}  // namespace detail
}  // namespace irg
