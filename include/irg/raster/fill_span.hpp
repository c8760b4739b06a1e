// SPDX-License-Identifier: MIT
// fill_span: one colour over a run of pixels. The innermost kernel of every fill.
#pragma once

#include <cstddef>
#include <cstring>
#include <type_traits>

#include <irg/core/lanes.hpp>
#include <irg/core/sinks.hpp>
#include <irg/raster/paint.hpp>
#include <irg/raster/window.hpp>

namespace irg {

namespace detail {
inline namespace IRG_ABI {

template <class P>
inline constexpr bool fills_in_lanes =
    std::is_trivially_copyable_v<P> && sizeof(P) <= 16 && (sizeof(P) & (sizeof(P) - 1)) == 0;

// Writes count copies of value from first on, a register at a time; the last store overlaps the one before.
template <class P>
IRG_INLINE void fill_lanes(P* first, std::size_t count, const P& value) noexcept {
  using bytes = pack<std::uint8_t, native_bytes>;
  constexpr std::size_t step = static_cast<std::size_t>(native_bytes) / sizeof(P);
  if (count < step) {
    for (std::size_t i = 0; i < count; ++i) first[i] = value;
    return;
  }
  bytes pattern;
  for (std::size_t i = 0; i < step; ++i)
    std::memcpy(reinterpret_cast<char*>(&pattern.v) + i * sizeof(P), &value, sizeof(P));
  const std::size_t last = count - step;
  for (std::size_t i = 0; i < last; i += step) std::memcpy(static_cast<void*>(first + i), &pattern.v, sizeof pattern.v);
  std::memcpy(static_cast<void*>(first + last), &pattern.v, sizeof pattern.v);
}

}  // namespace IRG_ABI
}  // namespace detail

inline namespace IRG_ABI {

/// Writes count copies of value to the pixels from first on.
/// exact   the same bytes from the plain loop and from lanes
/// cost    one store per register's worth of pixels
template <class P>
IRG_INLINE constexpr void fill_pixels(P* first, std::size_t count, const P& value) noexcept {
  if constexpr (detail::fills_in_lanes<P>) {
    if (!std::is_constant_evaluated()) return detail::fill_lanes(first, count, value);
  }
  for (std::size_t i = 0; i < count; ++i) first[i] = value;
}

/// Paints those pixels of a span that lie in the raster.
/// gives   nothing when the span is empty or misses the raster
template <WritableRaster R, PaintFor<R> Paint = pixel_of<R>>
IRG_INLINE constexpr void fill_span(R& raster, const span_of_cells& span, const Paint& paint) {
  if (span.y < 0 || span.y >= height_of(raster)) return;
  const int first = greater(span.x_first, 0);
  const int last = lesser(span.x_last, width_of(raster));
  if (first >= last) return;
  if constexpr (RowRaster<R> && !BlendFunction<Paint, R>)
    fill_pixels(raster_traits<R>::row(raster, span.y) + first, static_cast<std::size_t>(last - first),
                static_cast<pixel_of<R>>(paint));
  else
    for (int x = first; x < last; ++x) paint_pixel(raster, x, span.y, paint);
}

/// Writes value to every pixel of the raster.
template <WritableRaster R>
constexpr void clear(R& raster, const pixel_of<R>& value) {
  for (int y = 0; y < height_of(raster); ++y) fill_span(raster, {y, 0, width_of(raster)}, value);
}

}  // namespace IRG_ABI
}  // namespace irg
