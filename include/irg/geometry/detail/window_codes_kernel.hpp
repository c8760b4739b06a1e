// SPDX-License-Identifier: MIT
// The codes of points against a window: one bit for each boundary that a point is beyond. Those of a whole polygon are
// packed into words, four bits a vertex, so that its passages over boundaries are found by a few operations on words.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <type_traits>

#include <irg/core/conversion.hpp>
#include <irg/core/lanes.hpp>
#include <irg/geometry/attributed_point.hpp>
#include <irg/geometry/box.hpp>
#include <irg/geometry/clipped_line.hpp>

namespace irg::detail {

// Bits of a code, by axis: below the window in bits 0 and 1, above it in bits 2 and 3.
template <int Axis>
inline constexpr unsigned axis_bits = 5u << Axis;

// The longest polygon that is clipped by way of words, and how many codes a word holds.
inline constexpr std::size_t few_vertices = 64, codes_per_word = 16;

// A polygon on the stack: its vertices as doubles, the first one again behind the last, and room for reading on; their
// codes; the bits that all codes have; the sum of all magnitudes, infinite when one of them is 2^200 or beyond. Not
// initialised on purpose.
struct coded_ring {
  double at[2 * (few_vertices + 4)];
  std::uint64_t words[few_vertices / codes_per_word + 1];
  std::size_t count;
  unsigned all;
  double reach;
};

inline namespace IRG_ABI {

// A NaN is beyond both boundaries of its axis.
template <class V, class T>
IRG_INLINE constexpr unsigned window_code(const V& v, const box<T, 2>& w) noexcept {
  unsigned code = 0;
  for (int i = 0; i < 2; ++i) {
    const T x = coordinate(position_of(v), i);
    bool below = x < w.low[i], above = w.high[i] < x;
    if constexpr (Floating<T>) below = !(w.low[i] <= x), above = !(x <= w.high[i]);
    code |= (static_cast<unsigned>(below) | static_cast<unsigned>(above) << 2) << i;
  }
  return code;
}

// Words of codes, from code(i) for vertices i, i + 1, ... i + Step - 1 where n is a multiple of Step.
template <unsigned Step, class Code>
IRG_INLINE constexpr void pack_codes(std::size_t n, std::uint64_t* words, const Code& code) noexcept {
  for (std::size_t i = 0;;) {
    std::uint64_t word = 0;
    unsigned shift = 0;
    for (; shift < 64 && i < n; shift += 4 * Step, i += Step) word |= std::uint64_t{code(i)} << shift;
    *words++ = word;
    if (shift < 64) return;
  }
}

template <Point P, class T>
constexpr void code_ring_plainly(const P* points, std::size_t n, const box<T, 2>& w, coded_ring& ring) noexcept {
  ring.reach = 0, ring.all = 15;
  pack_codes<1>(n, ring.words, [&](std::size_t i) {
    for (int k = 0; k < 2; ++k) {
      const double x = widened(coordinate(points[i], k));
      ring.at[2 * i + static_cast<std::size_t>(k)] = x;
      ring.reach = magnitude(x) < 0x1p200 ? ring.reach + magnitude(x) : std::numeric_limits<double>::infinity();
    }
    const unsigned code = window_code(points[i], w);
    ring.all &= code;
    return code;
  });
}

// The codes of N / 2 vertices, four bits each: which coordinates are below the window, then which are above.
template <int N>
IRG_INLINE unsigned codes_of_lanes(const pack<double, N>& p, const pack<double, N>& low,
                                   const pack<double, N>& high) noexcept {
  const auto words = [](const auto& mask) { return bits_as<float>(mask); };
  const auto below = words(not_at_most(low, p)), above = words(not_at_most(p, high));
  if constexpr (N == 2)
    return sign_bits(shuffled<0, 2, 4, 6>(below, above));
  else
    return sign_bits(shuffled<0, 2, 8, 10, 4, 6, 12, 14>(below, above));
}

// One vertex, or two where registers hold as many, at once. A register is stored by halves, as it will be read.
template <class T = double>
IRG_INLINE void code_ring(const point<double, 2>* points, std::size_t n, const box<double, 2>& w,
                          coded_ring& ring) noexcept {
  using two = pack<double, 2>;
  using four = pack<double, 4>;
  const two low = pack_of(w.low.x, w.low.y), high = pack_of(w.high.x, w.high.y);
  two reach{};
  unsigned all = 255;
  const auto code_one = [&](std::size_t i) {
    const two p = lanes<two>::load_bytes(points + i);
    lanes<two>::store(ring.at + 2 * i, p);
    reach = reach + magnitude(p);
    const unsigned code = codes_of_lanes(p, low, high);
    all &= code;
    return code;
  };
  if constexpr (native_lanes<double> >= 4) {
    const four low2 = repeated<4>(low), high2 = repeated<4>(high);
    four reach2{};
    const std::size_t even = n & ~std::size_t{1};
    pack_codes<2>(even, ring.words, [&](std::size_t i) {
      const four p = lanes<four>::load_bytes(points + i);
      lanes<two>::store(ring.at + 2 * i, low_half(p));
      lanes<two>::store(ring.at + 2 * i + 2, high_half(p));
      reach2 = reach2 + magnitude(p);
      const unsigned codes = codes_of_lanes(p, low2, high2);
      all &= codes;
      return codes;
    });
    all &= all >> 4;
    reach = low_half(reach2) + high_half(reach2);
    if (even < n) ring.words[even / codes_per_word] |= std::uint64_t{code_one(even)} << (4 * (even % codes_per_word));
  } else {
    pack_codes<1>(n, ring.words, code_one);
  }
  ring.all = all & 15;
  ring.reach = reach[0] + reach[1];
}

// The ring of n points, 3 <= n <= few_vertices.
template <Point P, class T>
IRG_INLINE constexpr void find_window_codes(const P* points, std::size_t n, const box<T, 2>& w,
                                            coded_ring& ring) noexcept {
  ring.count = n;
  if constexpr (std::is_same_v<P, point<double, 2>>)
    if (!std::is_constant_evaluated()) {
      code_ring(points, n, w, ring);
      std::memcpy(ring.at + 2 * n, points, sizeof(P));
      return;
    }
  code_ring_plainly(points, n, w, ring);
  ring.at[2 * n] = ring.at[0], ring.at[2 * n + 1] = ring.at[1];
}

}  // namespace IRG_ABI
}  // namespace irg::detail
