// SPDX-License-Identifier: MIT
// How much memory a z-buffer takes: the table of every exercise.
#pragma once

#include <bit>
#include <cstdint>
#include <limits>

#include <irg/core/contract.hpp>
#include <irg/core/vocabulary.hpp>

namespace irg {

/// How many values a pixel must tell apart in each buffer; 0 and 1 need no memory.
struct zbuffer_levels {
  std::uint64_t depth = 0, colours = 0, objects = 0;
  bool operator==(const zbuffer_levels&) const = default;
};

/// Bits per pixel and bytes of one buffer. Rows and pixels follow each other without a gap.
struct buffer_memory {
  int bits_per_pixel = 0;
  std::uint64_t bytes = 0;
  bool operator==(const buffer_memory&) const = default;
};

/// The buffers of a z-buffer picture, and what they come to.
struct zbuffer_memory_table {
  buffer_memory depth, colours, objects;
  std::uint64_t bytes = 0;
  bool operator==(const zbuffer_memory_table&) const = default;
};

inline namespace IRG_ABI {

/// The bits it takes to tell n values apart: log2 n, rounded up; 0 for n <= 1.
[[nodiscard]] IRG_INLINE constexpr int bits_for_levels(std::uint64_t n) noexcept {
  return n <= 1 ? 0 : static_cast<int>(std::bit_width(n - 1));
}

/// The memory of a picture of this size: depth buffer, screen buffer, buffer of object references.
/// needs   width >= 0, height >= 0
/// gives   2^64 - 1 bytes where it is that or more
/// exact   in integers; a last byte that is used in part counts as one
/// source  Hidden-surface slides: 2048 x 1024 pixels, 256 depths, 2^24 colours: 2 MiB and 6 MiB
[[nodiscard]] constexpr zbuffer_memory_table zbuffer_memory(const extent2& size,
                                                            const zbuffer_levels& levels) noexcept {
  const auto [width, height] = size;
  IRG_EXPECTS(width >= 0 && height >= 0);
  constexpr std::uint64_t most = (std::numeric_limits<std::uint64_t>::max)();
  const auto plus = [](std::uint64_t a, std::uint64_t b) { return b > most - a ? most : a + b; };
  const std::uint64_t pixels =
      width < 0 || height < 0 ? 0 : static_cast<std::uint64_t>(width) * static_cast<std::uint64_t>(height);
  const auto buffer = [&](std::uint64_t count) -> buffer_memory {
    const int bits = bits_for_levels(count);
    const std::uint64_t each = static_cast<std::uint64_t>(bits), eights = pixels / 8;
    if (each != 0 && eights > most / each) return {bits, most};
    return {bits, plus(eights * each, (pixels % 8 * each + 7) / 8)};
  };
  const buffer_memory depth = buffer(levels.depth), colours = buffer(levels.colours), objects = buffer(levels.objects);
  return {depth, colours, objects, plus(plus(depth.bytes, colours.bytes), objects.bytes)};
}
[[nodiscard, deprecated("irg: zbuffer_memory({width, height}, levels)")]] constexpr zbuffer_memory_table zbuffer_memory(
    int width, int height, const zbuffer_levels& levels) noexcept {
  return zbuffer_memory({width, height}, levels);
}

}  // namespace IRG_ABI
}  // namespace irg
