// SPDX-License-Identifier: MIT
// PNG's row filters: a row is stored as its differences from one of five predictions, each made from the byte one pixel
// to the left, the byte above and the byte above that one's left.
#pragma once

#include <cstddef>
#include <cstdint>

#include <irg/core/config.hpp>

namespace irg::detail::inline IRG_ABI {

enum class png_filter : std::uint8_t { none, sub, up, average, paeth };

/// The byte that the filter expects.
template <png_filter F>
IRG_INLINE constexpr std::uint8_t predict(std::uint8_t left, std::uint8_t above, std::uint8_t corner) noexcept {
  if constexpr (F == png_filter::none) {
    return 0;
  } else if constexpr (F == png_filter::sub) {
    return left;
  } else if constexpr (F == png_filter::up) {
    return above;
  } else if constexpr (F == png_filter::average) {
    return static_cast<std::uint8_t>((left & above) + ((left ^ above) >> 1));  // rounded down, without a ninth bit
  } else {
    // The one of left, above, corner that is nearest to left + above - corner; the first of equals.
    int from_left = above - corner, from_above = left - corner, from_corner = from_left + from_above;
    from_left = from_left < 0 ? -from_left : from_left;
    from_above = from_above < 0 ? -from_above : from_above;
    from_corner = from_corner < 0 ? -from_corner : from_corner;
    const int nearer = from_left <= from_above ? left : above;
    const int distance = from_left <= from_above ? from_left : from_above;
    return static_cast<std::uint8_t>(distance <= from_corner ? nearer : corner);
  }
}

/// A row and what its predictions are made from.
/// shape   `pixel` bytes of zero stand before row[0] and before above[0]
struct png_row {
  const std::uint8_t* row = nullptr;
  const std::uint8_t* above = nullptr;
  std::size_t pixel = 0;  // bytes per pixel
  std::size_t count = 0;  // bytes in the row
};

/// The sum of the differences' sizes over Count bytes. With a constant count compilers make vector code of the loop.
template <png_filter F, int Count>
IRG_INLINE constexpr std::uint32_t sum_of_differences(const png_row& r, std::size_t first) noexcept {
  const std::uint8_t *row = r.row + first, *above = r.above + first, *left = row - r.pixel, *corner = above - r.pixel;
  std::uint32_t sum = 0;
  for (int i = 0; i < Count; ++i) {
    const auto difference = static_cast<std::uint8_t>(row[i] - predict<F>(left[i], above[i], corner[i]));
    const auto negative = static_cast<std::uint8_t>(-difference);
    sum += difference < negative ? difference : negative;
  }
  return sum;
}

/// The filter whose differences have the smallest sum of sizes; the first of equals.
/// source  PNG, 12.8 (minimum sum of absolute differences)
constexpr png_filter best_filter(const png_row& r) noexcept {
  std::uint64_t sums[5] = {};
  const auto add = [&]<int Count>(std::size_t first) {
    sums[0] += sum_of_differences<png_filter::none, Count>(r, first);
    sums[1] += sum_of_differences<png_filter::sub, Count>(r, first);
    sums[2] += sum_of_differences<png_filter::up, Count>(r, first);
    sums[3] += sum_of_differences<png_filter::average, Count>(r, first);
    sums[4] += sum_of_differences<png_filter::paeth, Count>(r, first);
  };
  std::size_t i = 0;
  for (; i + 16 <= r.count; i += 16) add.template operator()<16>(i);
  for (; i < r.count; ++i) add.template operator()<1>(i);

  int best = 0;
  for (int f = 1; f < 5; ++f)
    if (sums[f] < sums[best]) best = f;
  return static_cast<png_filter>(best);
}

template <png_filter F>
constexpr void write_differences(const png_row& r, std::uint8_t* out) noexcept {
  for (std::size_t i = 0; i < r.count; ++i)
    out[i] = static_cast<std::uint8_t>(r.row[i] - predict<F>((r.row - r.pixel)[i], r.above[i], (r.above - r.pixel)[i]));
}

/// Writes the filter's number and the row's differences: 1 + count bytes.
constexpr void write_filtered(const png_row& r, png_filter filter, std::uint8_t* out) noexcept {
  *out++ = static_cast<std::uint8_t>(filter);
  switch (filter) {
    case png_filter::none: return write_differences<png_filter::none>(r, out);
    case png_filter::sub: return write_differences<png_filter::sub>(r, out);
    case png_filter::up: return write_differences<png_filter::up>(r, out);
    case png_filter::average: return write_differences<png_filter::average>(r, out);
    case png_filter::paeth: return write_differences<png_filter::paeth>(r, out);
  }
}

}  // namespace irg::detail::inline IRG_ABI
