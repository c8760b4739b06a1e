// SPDX-License-Identifier: MIT
// A register's worth of pixels over a run of bytes: the stores of every fill, plain or antialiased.
//
// Two things make long runs faster. A store that crosses a cache line costs two, so all stores but the first and the
// last are aligned. And a run starts far from where the run above ended, where the processor's own prefetching has
// nothing to go by; so while one row is written, the same columns of the row below are fetched.
#pragma once

#include <cstddef>
#include <cstdint>

#include <irg/core/lane_memory.hpp>
#include <irg/core/memory_access.hpp>
#include <irg/core/raster_concept.hpp>
#include <irg/core/scalar.hpp>

namespace irg::detail::inline IRG_ABI {

// How many bytes the pixels below those of a row are further on, or 0 where that is not known.
template <WritableRaster R>
IRG_INLINE constexpr std::ptrdiff_t bytes_to_row_below(const R& raster) {
  if constexpr (EvenRowRaster<R>)
    return bytes_per_row_of(raster);
  else
    return 0;
}

// Writes a pattern of pixels of Unit bytes over size bytes from p on, a register at a time; the last stores overlap the
// ones before.
// shape   ahead: how many bytes further on the next row's pixels of the same columns are, or 0
// needs   Unit is a power of 2; the pattern fills one register, which is no more than size bytes
template <std::size_t Unit, class T, int N>
IRG_INLINE void fill_registers(char* p, std::size_t size, const pack<T, N>& pattern, std::ptrdiff_t ahead) noexcept {
  constexpr std::size_t step = sizeof pattern, line = 64;
  static_assert(step <= line && Unit <= step);
  if (size > 2 * step) {
    const std::size_t last = size - 2 * step;
    std::size_t i = 0;
    if (size > 4 * line) {
      lanes<pack<T, N>>::store_bytes(p, pattern);
      const auto start = reinterpret_cast<std::uintptr_t>(p);
      // Whole pixels on: where pixels are not aligned themselves, nor are the stores.
      for (i = step - (start & (step - Unit)); i < size - line; i += line) {
        if (ahead != 0) prefetch_to_write(p + i, ahead);  // may be beyond the raster
        for (std::size_t k = 0; k < line; k += step) lanes<pack<T, N>>::store_bytes(p + i + k, pattern);
      }
      i = size - line;
    }
    for (; i < last; i += 2 * step) {
      lanes<pack<T, N>>::store_bytes(p + i, pattern);
      lanes<pack<T, N>>::store_bytes(p + i + step, pattern);
    }
    lanes<pack<T, N>>::store_bytes(p + last, pattern);
  } else {
    lanes<pack<T, N>>::store_bytes(p, pattern);
  }
  lanes<pack<T, N>>::store_bytes(p + size - step, pattern);
}

}  // namespace irg::detail::inline IRG_ABI
