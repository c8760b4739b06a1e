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
#include <type_traits>

#include <irg/colour/mix.hpp>
#include <irg/core/lanes.hpp>
#include <irg/raster/detail/fill_kernel.hpp>

namespace irg {
namespace detail::inline IRG_ABI {

// Pixel types that are mixed in lanes at run time.
template <class P>
inline constexpr bool mixes_in_lanes = std::same_as<P, rgba8> || std::same_as<P, bgra8>;

// How many pixels are mixed at once.
inline constexpr int mix_lanes = native_lanes<std::int32_t>;

// N pixels as they are in memory, and as twice as many numbers of two bytes.
template <int N>
using mix_words_of = pack<std::uint32_t, N>;
template <int N>
using mix_halves_of = pack<std::uint16_t, 2 * N>;

// A colour ready to be mixed in, N pixels at once.
template <int N>
struct mix_colour {
  mix_halves_of<N> even, odd;
  mix_words_of<N> whole;
};

template <int N = mix_lanes, class P>
IRG_INLINE mix_colour<N> prepare_mix(const P& colour) noexcept {
  static_assert(mixes_in_lanes<P> && sizeof(P) == 4);
  const auto whole = lanes<mix_words_of<N>>::broadcast(lanes<std::uint32_t>::load_bytes(&colour));
  const auto both = bits_as<std::uint16_t>(whole);
  return {both & 0xff, both >> 8, whole};
}

// Coverages, one in 32 bits each, as mix_words wants them.
template <int N>
IRG_INLINE mix_halves_of<N> in_both_halves(const pack<std::int32_t, N>& coverage) noexcept {
  return bits_as<std::uint16_t>(coverage | (coverage << 16));
}

// (x + x / 256) / 256 for each x, which is how mix() divides by 255: the upper half of x * 257.
template <int N>
IRG_INLINE pack<std::uint16_t, N> over_255(const pack<std::uint16_t, N>& x) noexcept {
  if constexpr (has_upper_product<N>)
    return upper_product(x, lanes<pack<std::uint16_t, N>>::broadcast(257));
  else
    return (x + (x >> 8)) >> 8;
}

// N pixels mixed.
template <int N>
IRG_INLINE mix_words_of<N> mix_words(const mix_words_of<N>& there, const mix_colour<N>& colour,
                                     const mix_halves_of<N>& coverage) noexcept {
  const auto both = bits_as<std::uint16_t>(there), rest = lanes<mix_halves_of<N>>::broadcast(255) - coverage;
  const auto even = (both & 0xff) * rest + (colour.even * coverage + 128);
  const auto odd = (both >> 8) * rest + (colour.odd * coverage + 128);
  return bits_as<std::uint32_t>(over_255(even) | (over_255(odd) << 8));
}

// Mixes N pixels from first on.
template <int N, class P>
IRG_INLINE void mix_all(P* first, const mix_colour<N>& colour, const mix_halves_of<N>& coverage) noexcept {
  using W = lanes<mix_words_of<N>>;
  W::store_bytes(first, mix_words<N>(W::load_bytes(first), colour, coverage));
}

// Mixes count pixels from first on by the first count coverages, without a branch.
// needs   1 <= count <= N
template <int N, class P>
IRG_INLINE void mix_some(P* first, int count, const mix_colour<N>& colour, const mix_halves_of<N>& coverage) noexcept {
  store_some(first, mix_words<N>(load_some<std::uint32_t, N>(first, count), colour, coverage), count);
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
IRG_INLINE void mix_ends(P* first, int count, const mix_colour<N>& colour, const mix_halves_of<N>& coverage,
                         std::ptrdiff_t ahead = 0) noexcept {
  using half = lanes<mix_words_of<N / 2>>;
  P* const last = first + (count - N / 2);
  const auto there = join_halves<std::uint32_t, N>(half::load_bytes(first), half::load_bytes(last));
  const auto mixed = mix_words<N>(there, colour, coverage);
  fill_words<N>(first, count, colour, ahead);
  half::store_bytes(first, low_half(mixed));
  half::store_bytes(last, high_half(mixed));
}

// The same with N pixels at each end.
// needs   count >= 2 * N
template <int N, class P>
IRG_INLINE void mix_ends(P* first, int count, const mix_colour<N>& colour, const mix_halves_of<N>& first_coverage,
                         const mix_halves_of<N>& last_coverage, std::ptrdiff_t ahead = 0) noexcept {
  using W = lanes<mix_words_of<N>>;
  P* const last = first + (count - N);
  const auto a = mix_words<N>(W::load_bytes(first), colour, first_coverage);
  const auto b = mix_words<N>(W::load_bytes(last), colour, last_coverage);
  fill_words<N>(first, count, colour, ahead);
  W::store_bytes(first, a);
  W::store_bytes(last, b);
}

// N coverages as mix_words wants them.
template <int N>
IRG_INLINE mix_halves_of<N> load_coverages(const std::uint8_t* coverage) noexcept {
  // Spelled as shuffles, because compilers take a conversion from bytes apart.
  if constexpr (N == 4) {  // each byte twice, then each two bytes twice
    const auto b = bits_as<std::uint8_t>(pack_of(lanes<std::uint32_t>::load_bytes(coverage), 0u, 0u, 0u));
    const auto twice = bits_as<std::uint16_t>(shuffled<0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 5, 5, 6, 6, 7, 7>(b));
    return shuffled<0, 0, 1, 1, 2, 2, 3, 3>(twice) & 0xff;
  } else if constexpr (N == 8) {  // all eight in both 128-bit halves, from where each byte is fetched four times
    const auto eight = lanes<std::uint64_t>::load_bytes(coverage);
    const auto b = bits_as<std::uint8_t>(lanes<pack<std::uint64_t, 4>>::broadcast(eight));
    return bits_as<std::uint16_t>(shuffled<0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2, 2, 3, 3, 3, 3, 20, 20, 20, 20, 21, 21, 21,
                                           21, 22, 22, 22, 22, 23, 23, 23, 23>(b)) &
           0xff;
  } else {
    return in_both_halves<N>(converted<std::int32_t>(lanes<pack<std::uint8_t, N>>::load(coverage)));
  }
}

// Mixes count pixels from first on.
template <class P>
IRG_INLINE void mix_run(P* first, std::size_t count, const std::uint8_t* coverage,
                        const mix_colour<mix_lanes>& colour) noexcept {
  constexpr int step = mix_lanes;
  std::size_t i = 0;
  for (; i + step <= count; i += step) mix_all<step>(first + i, colour, load_coverages<step>(coverage + i));
  if (i == count) return;
  const int rest = static_cast<int>(count - i);
  std::uint8_t last[static_cast<unsigned>(step)];
  for (int k = 0; k < step; ++k) last[k] = coverage[i + static_cast<std::size_t>(no_further_than(rest - 1, k))];
  mix_some<step>(first + i, rest, colour, load_coverages<step>(last));
}

}  // namespace detail::inline IRG_ABI

inline namespace IRG_ABI {

/// Mixes value into count pixels from first on, pixel i as far as coverage[i] says.
/// needs   count coverages and pixels, not overlapping
/// exact   the same bytes as mix() pixel by pixel; pixels of four 8-bit channels go through lanes
template <Mixable P>
IRG_INLINE constexpr void mix_pixels(P* first, std::size_t count, const std::uint8_t* coverage, const P& value) {
  if constexpr (detail::mixes_in_lanes<P>) {
    if (!std::is_constant_evaluated()) return detail::mix_run(first, count, coverage, detail::prepare_mix(value));
  }
  for (std::size_t i = 0; i < count; ++i) first[i] = mix(first[i], value, coverage[i]);
}

}  // namespace IRG_ABI
}  // namespace irg
