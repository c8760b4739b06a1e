// SPDX-License-Identifier: MIT
// Memory that is not simply read and written: asked for ahead, written past the caches, written by several threads.
#pragma once

#include <cstddef>
#include <cstdint>
#include <type_traits>

#include <irg/core/pack.hpp>

namespace irg::inline IRG_ABI {

namespace lanes_detail {

template <int Write>
IRG_INLINE void ask_for([[maybe_unused]] const void* p, [[maybe_unused]] std::ptrdiff_t ahead) noexcept {
#ifdef __GNUC__
  // May be behind the array, where no pointer may lead but one made from an integer.
  const std::uintptr_t place = reinterpret_cast<std::uintptr_t>(p) + static_cast<std::uintptr_t>(ahead);
  __builtin_prefetch(reinterpret_cast<const void*>(place), Write);  // NOLINT(performance-no-int-to-ptr)
#endif
}

}  // namespace lanes_detail

/// Asks for the cache line `ahead` bytes behind p, to read it or to write it. Where that is beyond all memory, nothing
/// happens.
IRG_INLINE constexpr void prefetch(const void* p, std::ptrdiff_t ahead = 0) noexcept {
  if (!std::is_constant_evaluated()) lanes_detail::ask_for<0>(p, ahead);
}
IRG_INLINE void prefetch_to_write(const void* p, std::ptrdiff_t ahead = 0) noexcept {
  lanes_detail::ask_for<1>(p, ahead);
}

/// Whether stream() writes past the caches.
#if defined(IRG_LANES_VECTOR) && defined(__SSE2__)
inline constexpr bool has_streaming_stores = true;
#else
inline constexpr bool has_streaming_stores = false;
#endif

/// Writes a pack to p, past the caches where has_streaming_stores.
/// needs   p at a multiple of the pack's size; a pack of floats or doubles that fills a register; end_of_streams()
///         before anybody else may look
template <std::floating_point T, int N>
IRG_INLINE void stream(T* p, const pack<T, N>& f) noexcept {
#if defined(IRG_LANES_VECTOR) && defined(__SSE2__)
#ifdef __clang__
  __builtin_nontemporal_store(f.v, reinterpret_cast<typename pack<T, N>::storage*>(p));
#else
  constexpr int bytes = static_cast<int>(sizeof f);
  static_assert(bytes >= 16 && bytes <= widest_bytes);
  constexpr bool is_float = std::is_same_v<T, float>;
  if constexpr (bytes == 16 && is_float) __builtin_ia32_movntps(p, f.v);
  if constexpr (bytes == 16 && !is_float) __builtin_ia32_movntpd(p, f.v);
#ifdef __AVX__
  if constexpr (bytes == 32 && is_float) __builtin_ia32_movntps256(p, f.v);
  if constexpr (bytes == 32 && !is_float) __builtin_ia32_movntpd256(p, f.v);
#endif
#ifdef __AVX512F__
  if constexpr (bytes == 64 && is_float) __builtin_ia32_movntps512(p, f.v);
  if constexpr (bytes == 64 && !is_float) __builtin_ia32_movntpd512(p, f.v);
#endif
#endif
#else
  lanes<pack<T, N>>::store(p, f);
#endif
}

/// What was streamed becomes visible to other threads before anything that is stored afterwards.
IRG_INLINE void end_of_streams() noexcept {
#if defined(IRG_LANES_VECTOR) && defined(__SSE2__)
  __builtin_ia32_sfence();
#endif
}

/// Writes a byte that several threads may write and read at the same time, in no order with anything else. (The header
/// <atomic> would cost its users a tenth of a second.)
IRG_INLINE constexpr void store_relaxed(std::uint8_t& to, std::uint8_t x) noexcept {
  if (std::is_constant_evaluated()) {
    to = x;
    return;
  }
#ifdef __GNUC__
  __atomic_store_n(&to, x, __ATOMIC_RELAXED);
#else
  *static_cast<volatile std::uint8_t*>(&to) = x;
#endif
}

}  // namespace irg::inline IRG_ABI
