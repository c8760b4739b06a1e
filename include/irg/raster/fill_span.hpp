// SPDX-License-Identifier: MIT
// fill_span: one colour over a run of pixels. The innermost kernel of every fill stands before it: it chooses between
// the two lives, and no other file does.
#pragma once

#include <cstddef>
#include <cstdint>
#include <type_traits>

#include <irg/core/lanes.hpp>
#include <irg/core/sinks.hpp>
#include <irg/raster/detail/fill_kernel.hpp>
#include <irg/raster/paint.hpp>
#include <irg/raster/window.hpp>

namespace irg::detail::inline IRG_ABI {

template <class P>
inline constexpr bool fills_in_lanes =
    std::is_trivially_copyable_v<P> && sizeof(P) <= 16 && (sizeof(P) & (sizeof(P) - 1)) == 0;

// Writes a pattern over `count` pixels of Unit bytes, fewer than a register holds: two stores that overlap, or one that
// leaves out what is beyond.
template <std::size_t Unit>
IRG_INLINE void fill_part(char* p, std::size_t count, const pack<std::uint8_t, native_bytes>& pattern) noexcept {
  constexpr int unit = static_cast<int>(Unit);
  if constexpr (Unit >= 4 && has_masked_stores)
    return store_some(p, bits_as<std::uint32_t>(pattern), static_cast<int>(count * (Unit / 4)));
  const std::size_t size = count * Unit;
  if constexpr (sizeof pattern > 16) {
    if (size >= 16) {
      store_first_bytes<16>(p, pattern);
      return store_first_bytes<16>(p + size - 16, pattern);
    }
  }
  if (size >= 8) {
    store_first_bytes<8>(p, pattern);
    return store_first_bytes<8>(p + size - 8, pattern);
  }
  if constexpr (Unit <= 2) {
    if (size >= 4) {
      store_first_bytes<4>(p, pattern);
      return store_first_bytes<4>(p + size - 4, pattern);
    }
    if (size == 0) return;  // one to three units
    store_first_bytes<unit>(p, pattern);
    store_first_bytes<unit>(p + size / (2 * Unit) * Unit, pattern);
    store_first_bytes<unit>(p + size - Unit, pattern);
  } else if constexpr (Unit == 4) {
    if (size == 4) store_first_bytes<4>(p, pattern);
  }
}

// Writes count copies of value from first on.
// shape   ahead: as of fill_registers
template <class P>
IRG_INLINE void fill_lanes(P* first, std::size_t count, const P& value, std::ptrdiff_t ahead) noexcept {
  constexpr std::size_t unit = sizeof(P);
  const auto pattern = repeated_bytes<native_bytes>(value);
  const std::size_t size = count * unit;
  char* const p = reinterpret_cast<char*>(first);
  if (size < sizeof pattern) return fill_part<unit>(p, count, pattern);
  fill_registers<unit>(p, size, pattern, ahead);
}

// The same in constant evaluation, too, and for every type of pixel.
template <class P>
IRG_INLINE constexpr void fill_run(P* first, std::size_t count, const P& value,
                                   std::ptrdiff_t ahead) noexcept(std::is_nothrow_copy_assignable_v<P>) {
  if constexpr (fills_in_lanes<P>) {
    if (!std::is_constant_evaluated()) return fill_lanes(first, count, value, ahead);
  }
  for (std::size_t i = 0; i < count; ++i) first[i] = value;
}

// A paint as the loops over runs want it: the pixel itself, made once, or a reference to the function.
template <WritableRaster R, PaintFor<R> Paint>
IRG_INLINE constexpr decltype(auto) prepared_paint(const Paint& paint) {
  if constexpr (BlendFunction<Paint, R>)
    return (paint);
  else
    return static_cast<pixel_of<R>>(paint);
}

// Paints the columns first to last - 1 of row y.
// shape   ahead: as of fill_registers
// needs   0 <= first < last <= width, 0 <= y < height
template <WritableRaster R, PaintFor<R> Paint>
IRG_INLINE constexpr void paint_run(R& raster, int y, int first, int last, const Paint& paint,
                                    std::ptrdiff_t ahead = 0) {
  if constexpr (RowRaster<R> && !BlendFunction<Paint, R>)
    fill_run(raster_traits<R>::row(raster, y) + first, static_cast<std::size_t>(last - first), paint, ahead);
  else
    for (int x = first; x < last; ++x) paint_pixel(raster, x, y, paint);
}

}  // namespace irg::detail::inline IRG_ABI

namespace irg::inline IRG_ABI {

/// Writes count copies of value to the pixels from first on.
/// exact   the same bytes from the plain loop and from lanes
/// cost    one store per register's worth of pixels
template <class P>
IRG_INLINE constexpr void fill_pixels(P* first, std::size_t count,
                                      const P& value) noexcept(std::is_nothrow_copy_assignable_v<P>) {
  detail::fill_run(first, count, value, 0);
}

/// Paints those pixels of a span that lie in the raster.
/// gives   nothing when the span is empty or misses the raster
template <WritableRaster R, PaintFor<R> Paint = pixel_of<R>>
IRG_INLINE constexpr void fill_span(R& raster, const span_of_cells& span, const Paint& paint) {
  const cell_window w = window_of(raster);
  if (span.y < w.y_first || span.y >= w.y_last) return;
  const int first = maximum(span.x_first, w.x_first);
  const int last = minimum(span.x_last, w.x_last);
  if (first < last) detail::paint_run(raster, span.y, first, last, detail::prepared_paint<R>(paint));
}

/// Writes value to every pixel of the raster, or of its window.
template <WritableRaster R>
constexpr void clear(R& raster, const pixel_of<R>& value) {
  const cell_window w = window_of(raster);
  for (int y = w.y_first; y < w.y_last; ++y) fill_span(raster, {y, w.x_first, w.x_last}, value);
}

}  // namespace irg::inline IRG_ABI
