// SPDX-License-Identifier: MIT
// Equality of bits; all NaNs count as one, since their signs and payloads are the processor's business.
#pragma once

#include <bit>
#include <cstdint>
#include <limits>

#include <irg/math/mat.hpp>

namespace test {

constexpr bool same_bits(float a, float b) {
  return (a != a && b != b) || std::bit_cast<std::uint32_t>(a) == std::bit_cast<std::uint32_t>(b);
}
constexpr bool same_bits(double a, double b) {
  return (a != a && b != b) || std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}
template <class T, int R, int C>
constexpr bool same_bits(const irg::mat<T, R, C>& a, const irg::mat<T, R, C>& b) {
  for (int r = 0; r < R; ++r)
    for (int c = 0; c < C; ++c)
      if (!same_bits(a(r, c), b(r, c))) return false;
  return true;
}
template <irg::Coordinates V>
constexpr bool same_bits(const V& a, const V& b) {
  for (int i = 0; i < irg::size_of<V>; ++i)
    if (!same_bits(irg::coordinate(a, i), irg::coordinate(b, i))) return false;
  return true;
}

}  // namespace test
