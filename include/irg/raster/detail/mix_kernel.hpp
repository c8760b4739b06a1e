// SPDX-License-Identifier: MIT
// Mixing runs of pixels of four 8-bit channels by coverages, in lanes: bit for bit what colour/mix.hpp says.
//
// A pixel is seen as two 16-bit numbers, its even bytes and its odd ones, and a coverage stands in both halves of its
// pixel's 32 bits; so nothing is unpacked or packed. The largest sum, 255 * 255 + 128, fits 16 bits.
//
// No pixel outside [first, first + count) is read or written: there may be none.
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>

#include <irg/colour/mix.hpp>
#include <irg/core/lanes.hpp>
#include <irg/raster/detail/fill_kernel.hpp>

namespace irg {
namespace detail {
inline namespace IRG_ABI {

// Pixel types that are mixed in lanes at run time.
#ifdef IRG_LANES_VECTOR
template <class P>
inline constexpr bool mixes_in_lanes = std::same_as<P, rgba8> || std::same_as<P, bgra8>;
#else
template <class P>
inline constexpr bool mixes_in_lanes = false;
#endif

// How many pixels are mixed at once.
inline constexpr int mix_lanes = native_lanes<std::int32_t>;

#ifdef IRG_LANES_VECTOR

template <int N>
struct mix_types {
  using halves = typename pack<std::uint16_t, 2 * N>::storage;
  using words = typename pack<std::uint32_t, N>::storage;
  using integers = typename pack<std::int32_t, N>::storage;
};

// A colour ready to be mixed in, N pixels at once.
template <int N>
struct mix_colour {
  typename mix_types<N>::halves even, odd;
  typename mix_types<N>::words whole;
};

template <int N = mix_lanes, class P>
IRG_INLINE mix_colour<N> prepare_mix(const P& colour) noexcept {
  static_assert(mixes_in_lanes<P> && sizeof(P) == 4);
  using halves = typename mix_types<N>::halves;
  std::uint32_t word;
  std::memcpy(&word, &colour, 4);
  const typename mix_types<N>::words whole = word - typename mix_types<N>::words{};
  const halves both = reinterpret_cast<halves>(whole);
  return {both & 0xff, both >> 8, whole};
}

// Coverages, one in 32 bits each, as mix_words wants them.
template <int N>
IRG_INLINE typename mix_types<N>::halves in_both_halves(const pack<std::int32_t, N>& coverage) noexcept {
  return reinterpret_cast<typename mix_types<N>::halves>(coverage.v | (coverage.v << 16));
}

// (x + x / 256) / 256 for each x, which is how mix() divides by 255: the upper half of x * 257.
template <int N>
IRG_INLINE typename mix_types<N>::halves over_255(typename mix_types<N>::halves x) noexcept {
  using halves = typename mix_types<N>::halves;
#ifdef __SSE2__
  using shorts = typename pack<std::int16_t, 2 * N>::storage;
  const halves factor = 257 - halves{};
  if constexpr (N == 4)
    return reinterpret_cast<halves>(
        __builtin_ia32_pmulhuw128(reinterpret_cast<shorts>(x), reinterpret_cast<shorts>(factor)));
#ifdef __AVX2__
  if constexpr (N == 8)
    return reinterpret_cast<halves>(
        __builtin_ia32_pmulhuw256(reinterpret_cast<shorts>(x), reinterpret_cast<shorts>(factor)));
#endif
#endif
  return (x + (x >> 8)) >> 8;
}

// N pixels mixed.
template <int N>
IRG_INLINE typename mix_types<N>::words mix_words(typename mix_types<N>::words there, const mix_colour<N>& colour,
                                                  typename mix_types<N>::halves coverage) noexcept {
  using halves = typename mix_types<N>::halves;
  const halves both = reinterpret_cast<halves>(there), rest = 255 - coverage;
  const halves even = (both & 0xff) * rest + (colour.even * coverage + 128);
  const halves odd = (both >> 8) * rest + (colour.odd * coverage + 128);
  return reinterpret_cast<typename mix_types<N>::words>(over_255<N>(even) | (over_255<N>(odd) << 8));
}

// Mixes N pixels from first on.
template <int N, class P>
IRG_INLINE void mix_all(P* first, const mix_colour<N>& colour, typename mix_types<N>::halves coverage) noexcept {
  typename mix_types<N>::words there;
  std::memcpy(&there, first, sizeof there);
  there = mix_words<N>(there, colour, coverage);
  std::memcpy(static_cast<void*>(first), &there, sizeof there);
}

// i, but no more than last; spelled without a comparison, which would become branches.
IRG_INLINE int no_further_than(int last, int i) noexcept {
  const int rest = last - i;
  return i + (rest & (rest >> 31));
}

// Mixes count pixels from first on by the first count coverages, without a branch.
// needs   1 <= count <= N
template <int N, class P>
IRG_INLINE void mix_some(P* first, int count, const mix_colour<N>& colour,
                         typename mix_types<N>::halves coverage) noexcept {
  using words = typename mix_types<N>::words;
#ifdef __AVX2__
  using integers = typename mix_types<N>::integers;
  integers lane{};
  for (int i = 0; i < N; ++i) lane[i] = i;
  const integers wanted = lane < count;
  integers* const p = reinterpret_cast<integers*>(first);
  if constexpr (N == 8) {
    const words there = reinterpret_cast<words>(__builtin_ia32_maskloadd256(p, wanted));
    __builtin_ia32_maskstored256(p, wanted, reinterpret_cast<integers>(mix_words<N>(there, colour, coverage)));
    return;
  } else if constexpr (N == 4) {
    const words there = reinterpret_cast<words>(__builtin_ia32_maskloadd(p, wanted));
    __builtin_ia32_maskstored(p, wanted, reinterpret_cast<integers>(mix_words<N>(there, colour, coverage)));
    return;
  }
#endif
  // Lanes past the last pixel read it once more; stored from the last lane down, its own value comes last.
  const auto at = [&](int i) { return first + no_further_than(count - 1, i); };
  const auto read = [&](int i) {
    std::uint32_t word;
    std::memcpy(&word, at(i), 4);
    return word;
  };
  words there{};
  if constexpr (N == 4)
    there = words{read(0), read(1), read(2), read(3)};
  else
    for (int i = 0; i < N; ++i) there[i] = read(i);
  there = mix_words<N>(there, colour, coverage);
  for (int i = N - 1; i >= 0; --i) {
    const std::uint32_t mixed = there[i];
    std::memcpy(static_cast<void*>(at(i)), &mixed, 4);
  }
}

// Writes the colour to count pixels from first on.
// shape   ahead: as of fill_registers
// needs   count >= N
template <int N, class P>
IRG_INLINE void fill_words(P* first, int count, const mix_colour<N>& colour, std::ptrdiff_t ahead = 0) noexcept {
  fill_registers<sizeof(P)>(reinterpret_cast<char*>(first), sizeof(P) * static_cast<std::size_t>(count), colour.whole,
                            ahead);
}

// Mixes the first N / 2 of count pixels by the lower half of the coverages and the last N / 2 by the upper half; the
// pixels between become the colour. The fill runs over the ends, too, before they are written: so it needs no pieces.
// needs   count >= N
template <int N, class P>
IRG_INLINE void mix_ends(P* first, int count, const mix_colour<N>& colour, typename mix_types<N>::halves coverage,
                         std::ptrdiff_t ahead = 0) noexcept {
  using half = typename pack<std::uint32_t, N / 2>::storage;
  constexpr int n = N / 2;
  half ends[2];
  std::memcpy(&ends[0], first, sizeof(half));
  std::memcpy(&ends[1], first + (count - n), sizeof(half));
  typename mix_types<N>::words there;
  std::memcpy(&there, ends, sizeof there);
  there = mix_words<N>(there, colour, coverage);
  fill_words<N>(first, count, colour, ahead);
  std::memcpy(ends, &there, sizeof there);
  std::memcpy(static_cast<void*>(first), &ends[0], sizeof(half));
  std::memcpy(static_cast<void*>(first + (count - n)), &ends[1], sizeof(half));
}

// The same with N pixels at each end.
// needs   count >= 2 * N
template <int N, class P>
IRG_INLINE void mix_ends(P* first, int count, const mix_colour<N>& colour, typename mix_types<N>::halves first_coverage,
                         typename mix_types<N>::halves last_coverage, std::ptrdiff_t ahead = 0) noexcept {
  using words = typename mix_types<N>::words;
  words a, b;
  std::memcpy(&a, first, sizeof a);
  std::memcpy(&b, first + (count - N), sizeof b);
  a = mix_words<N>(a, colour, first_coverage);
  b = mix_words<N>(b, colour, last_coverage);
  fill_words<N>(first, count, colour, ahead);
  std::memcpy(static_cast<void*>(first), &a, sizeof a);
  std::memcpy(static_cast<void*>(first + (count - N)), &b, sizeof b);
}

// N coverages as mix_words wants them.
template <int N>
IRG_INLINE typename mix_types<N>::halves load_coverages(const std::uint8_t* coverage) noexcept {
#if defined(__has_builtin)
#if __has_builtin(__builtin_shufflevector)
  // Spelled as shuffles, because compilers take a conversion from bytes apart.
  if constexpr (N == 4) {  // each byte twice, then each two bytes twice
    typedef std::uint8_t bytes __attribute__((vector_size(16)));
    std::uint32_t word;
    std::memcpy(&word, coverage, 4);
    const bytes b = reinterpret_cast<bytes>(mix_types<4>::words{word});
    const auto twice = reinterpret_cast<mix_types<4>::halves>(
        __builtin_shufflevector(b, b, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 5, 5, 6, 6, 7, 7));
    return __builtin_shufflevector(twice, twice, 0, 0, 1, 1, 2, 2, 3, 3) & 0xff;
  } else if constexpr (N == 8) {  // all eight in both 128-bit halves, from where each byte is fetched four times
    typedef std::uint8_t bytes __attribute__((vector_size(32)));
    typedef std::uint64_t longs __attribute__((vector_size(32)));
    std::uint64_t eight;
    std::memcpy(&eight, coverage, 8);
    const bytes b = reinterpret_cast<bytes>(eight - longs{});
    return reinterpret_cast<mix_types<8>::halves>(__builtin_shufflevector(b, b, 0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2, 2, 3,
                                                                          3, 3, 3, 20, 20, 20, 20, 21, 21, 21, 21, 22,
                                                                          22, 22, 22, 23, 23, 23, 23)) &
           0xff;
  }
#endif
#endif
  typedef std::uint8_t bytes __attribute__((vector_size(static_cast<unsigned>(N))));
  bytes b;
  std::memcpy(&b, coverage, sizeof b);
  return in_both_halves<N>({__builtin_convertvector(b, typename mix_types<N>::integers)});
}

// Mixes count pixels from first on.
template <class P>
IRG_INLINE void mix_run(P* first, std::size_t count, const std::uint8_t* coverage, const P& value) noexcept {
  constexpr int step = mix_lanes;
  const mix_colour<step> colour = prepare_mix(value);
  std::size_t i = 0;
  for (; i + step <= count; i += step) mix_all<step>(first + i, colour, load_coverages<step>(coverage + i));
  if (i == count) return;
  const int rest = static_cast<int>(count - i);
  std::uint8_t last[static_cast<unsigned>(step)];
  for (int k = 0; k < step; ++k) last[k] = coverage[i + static_cast<std::size_t>(no_further_than(rest - 1, k))];
  mix_some<step>(first + i, rest, colour, load_coverages<step>(last));
}

#endif

}  // namespace IRG_ABI
}  // namespace detail

inline namespace IRG_ABI {

/// Mixes value into count pixels from first on, pixel i as far as coverage[i] says.
/// needs   count coverages and pixels, not overlapping
/// exact   the same bytes as mix() pixel by pixel; pixels of four 8-bit channels go through lanes
template <Mixable P>
IRG_INLINE constexpr void mix_pixels(P* first, std::size_t count, const std::uint8_t* coverage, const P& value) {
#ifdef IRG_LANES_VECTOR
  if constexpr (detail::mixes_in_lanes<P>) {
    if (!std::is_constant_evaluated()) return detail::mix_run(first, count, coverage, value);
  }
#endif
  for (std::size_t i = 0; i < count; ++i) first[i] = mix(first[i], value, coverage[i]);
}

}  // namespace IRG_ABI
}  // namespace irg
