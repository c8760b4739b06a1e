// SPDX-License-Identifier: MIT
// A register's worth of pixels over a run of bytes: the stores of every fill, plain or antialiased.
//
// Two things make long runs faster. A store that crosses a cache line costs two, so all stores but the first and the
// last are aligned. And a run starts far from where the run above ended, where the processor's own prefetching has
// nothing to go by; so while one row is written, the same columns of the row below are fetched.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>

#include <irg/core/raster_concept.hpp>
#include <irg/core/scalar.hpp>

namespace irg {
namespace detail {
inline namespace IRG_ABI {

// How many bytes the pixels below those of a row are further on, or 0 where that is not known.
template <WritableRaster R>
IRG_INLINE constexpr std::ptrdiff_t bytes_to_row_below(const R& raster) {
  if constexpr (EvenRowRaster<R>)
    return bytes_per_row_of(raster);
  else
    return 0;
}

// Copies the first N bytes of a pattern to p.
template <std::size_t N, class Pattern>
IRG_INLINE void store_front(char* p, const Pattern& pattern) noexcept {
  std::memcpy(p, &pattern, N);
}

// Writes a pattern of pixels of Unit bytes over size bytes from p on, a register at a time; the last stores overlap the
// ones before.
// shape   ahead: how many bytes further on the next row's pixels of the same columns are, or 0
// needs   Unit is a power of 2; the pattern fills one register, which is no more than size bytes
template <std::size_t Unit, class Pattern>
IRG_INLINE void fill_registers(char* p, std::size_t size, const Pattern& pattern, std::ptrdiff_t ahead) noexcept {
  constexpr std::size_t step = sizeof(Pattern), line = 64;
  static_assert(step <= line && Unit <= step);
  if (size > 2 * step) {
    const std::size_t last = size - 2 * step;
    std::size_t i = 0;
    if (size > 4 * line) {
      store_front<step>(p, pattern);
      const auto start = reinterpret_cast<std::uintptr_t>(p);
      // Whole pixels on: where pixels are not aligned themselves, nor are the stores.
      for (i = step - (start & (step - Unit)); i < size - line; i += line) {
#ifdef __GNUC__
        // May be beyond the raster, where no pointer may lead but one made from an integer.
        if (ahead != 0)
          // NOLINTNEXTLINE(performance-no-int-to-ptr)
          __builtin_prefetch(reinterpret_cast<const void*>(start + i + static_cast<std::uintptr_t>(ahead)), 1);
#endif
        for (std::size_t k = 0; k < line; k += step) store_front<step>(p + i + k, pattern);
      }
      i = size - line;
    }
    for (; i < last; i += 2 * step) {
      store_front<step>(p + i, pattern);
      store_front<step>(p + i + step, pattern);
    }
    store_front<step>(p + last, pattern);
  } else {
    store_front<step>(p, pattern);
  }
  store_front<step>(p + size - step, pattern);
}

}  // namespace IRG_ABI
}  // namespace detail
}  // namespace irg
