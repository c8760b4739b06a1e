// SPDX-License-Identifier: MIT
// Triangles into an occlusion mask, in lanes. The greatest key counts, so they may come in any order: small ones by the
// shapes of their boxes, large ones block by block.
#pragma once

#include <bit>
#include <cstdint>

#include <irg/render/detail/mask_small_kernel.hpp>

namespace irg {
namespace detail {
inline namespace IRG_ABI {

#ifdef IRG_LANES_VECTOR

template <class T>
struct mask_painter {
  mask_small_painter<T> small_ones;
  mask_block_painter large_ones;

  // Some triangles of a list, whatever their size.
  IRG_INLINE void add(const std::uint32_t* numbers, int used) noexcept {
    using integers = mask_lanes::integers;
    using I = lanes<integers>;
    corner_lanes<mask_lanes::count> c;
    c.collect(small_ones.find, numbers, used);
    const auto &x = c.x, &y = c.y;
    const integers left = low_of(low_of(x[0], x[1]), x[2]), right = high_of(high_of(x[0], x[1]), x[2]);
    const integers top = low_of(low_of(y[0], y[1]), y[2]), bottom = high_of(high_of(y[0], y[1]), y[2]);
    const integers before = I::broadcast(half_pixel - 1), behind = I::broadcast(one_pixel - half_pixel);
    const cell_window& w = small_ones.window;
    const integers x_first = high_of({(left + before).v >> subpixel_bits}, I::broadcast(w.x_first)),
                   x_last = low_of({(right + behind).v >> subpixel_bits}, I::broadcast(w.x_last)),
                   y_first = high_of({(top + before).v >> subpixel_bits}, I::broadcast(w.y_first)),
                   y_last = low_of({(bottom + behind).v >> subpixel_bits}, I::broadcast(w.y_last));
    const unsigned seen = mask_bits(both(x_first < x_last, y_first < y_last)) & ((1u << used) - 1);
    const integers limit = I::broadcast(small_ones.few * one_pixel);
    const unsigned few = seen & mask_bits(both(right - left < limit, bottom - top < limit));
    integers number;
    for (int i = 0; i < mask_lanes::count; ++i) number.v[i] = static_cast<std::int32_t>(numbers[lesser(i, used - 1)]);
    small_ones.add(number, few, small_ones.shape_of(x_first, y_first, x_last, y_last));
    for (unsigned bits = seen & ~few; bits != 0; bits &= bits - 1)
      large_ones.draw(small_ones.find.corners(numbers[std::countr_zero(bits)]));
  }
};

#endif

}  // namespace IRG_ABI
}  // namespace detail
}  // namespace irg
