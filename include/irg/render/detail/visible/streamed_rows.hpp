// SPDX-License-Identifier: MIT
// Finished rows of a tile on their way into the picture. A picture that does not fit the cache is written past it:
// storing the ordinary way would first read from memory what is overwritten. What is written is the same.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>

#include <irg/core/lanes.hpp>
#include <irg/core/raster_concept.hpp>

namespace irg::detail {

// Whether rows stay in the cache, as they should where the whole picture does, or go past it.
enum class row_store { cached, streamed };

// A picture of this many pixels or more is streamed: with its depths it fills a core's cache several times.
inline constexpr std::int64_t streamed_pixels = std::int64_t{1} << 20;

inline namespace IRG_ABI {

inline constexpr std::ptrdiff_t cache_line = 64;

template <class R>
IRG_INLINE row_store row_store_for(const R& raster) noexcept {
  return std::int64_t{width_of(raster)} * height_of(raster) < streamed_pixels ? row_store::cached : row_store::streamed;
}

// One line of the cache, past it.
IRG_INLINE void stream_line(char* to, const char* from) noexcept {
  for (std::ptrdiff_t i = 0; i < cache_line; i += 16)
    stream(reinterpret_cast<float*>(to + i), lanes<pack<float, 4>>::load_bytes(from + i));
}

// Less than a line.
IRG_INLINE void copy_part(char* to, const char* from, std::size_t bytes) noexcept {
  std::size_t i = 0;
  for (; i + 16 <= bytes; i += 16) std::memcpy(to + i, from + i, 16);
  for (; i < bytes; ++i) to[i] = from[i];
}

// Copies a row. Only whole lines are streamed: the ends, which neighbouring tiles share, are stored.
IRG_INLINE void copy_row(void* row, const void* from, std::size_t bytes, row_store how) noexcept {
  char* const to = static_cast<char*>(row);
  const char* const source = static_cast<const char*>(from);
  const auto address = reinterpret_cast<std::uintptr_t>(to);
  const auto head = static_cast<std::size_t>(-address % std::uintptr_t{cache_line});
  if (how == row_store::cached || head >= bytes) {
    std::memcpy(to, source, bytes);
    return;
  }
  copy_part(to, source, head);
  std::size_t i = head;
  for (; i + cache_line <= bytes; i += cache_line) stream_line(to + i, source + i);
  copy_part(to + i, source + i, bytes - i);
}

// Streamed rows become visible to other threads before anything that is stored afterwards.
IRG_INLINE void end_of_rows(row_store how) noexcept {
  if (how == row_store::streamed) end_of_streams();
}

}  // namespace IRG_ABI
}  // namespace irg::detail
