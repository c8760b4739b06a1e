// SPDX-License-Identifier: MIT
// Numbers to try packs on: all kinds of bits, extremes and equal ones often.
#pragma once

#include <bit>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <limits>

#include <irg/core/lanes.hpp>

#include "support/random.hpp"

namespace test {

template <class T>
using bits_of =
    std::conditional_t<sizeof(T) == 1, std::uint8_t,
                       std::conditional_t<sizeof(T) == 2, std::uint16_t,
                                          std::conditional_t<sizeof(T) == 4, std::uint32_t, std::uint64_t>>>;

template <class T>
T any_lane_number(random& r) {
  using limits = std::numeric_limits<T>;
  switch (r.integer(0, 5)) {
    case 0: return T(0);
    case 1: return limits::max();
    case 2: return limits::lowest();
    case 3: return static_cast<T>(r.integer(0, 3));
    default: return std::bit_cast<T>(static_cast<bits_of<T>>(r.next()));
  }
}

// NaN's payload is no part of the promise.
template <class T>
bool same_lane(T a, T b) {
  return (a != a && b != b) || std::bit_cast<bits_of<T>>(a) == std::bit_cast<bits_of<T>>(b);
}

template <class T, int N>
irg::pack<T, N> any_pack(random& r) {
  return irg::lanes<irg::pack<T, N>>::generate([&](int) { return any_lane_number<T>(r); });
}

// Whether lane i of a pack is expected(i), for all.
template <class T, int N, class Expected>
bool lanes_are(const irg::pack<T, N>& p, const Expected& expected) {
  for (int i = 0; i < N; ++i)
    if (!same_lane<T>(p[i], expected(i))) return false;
  return true;
}

// Calls check.operator()<T, N>() for N = 2 to 16.
template <class T, class Check>
void for_lanes(const Check& check) {
  check.template operator()<T, 2>();
  check.template operator()<T, 4>();
  check.template operator()<T, 8>();
  check.template operator()<T, 16>();
}
template <class Check>
void for_integer_lanes(const Check& check) {
  for_lanes<std::int8_t>(check);
  for_lanes<std::uint8_t>(check);
  for_lanes<std::int16_t>(check);
  for_lanes<std::uint16_t>(check);
  for_lanes<std::int32_t>(check);
  for_lanes<std::uint32_t>(check);
  for_lanes<std::int64_t>(check);
  for_lanes<std::uint64_t>(check);
}
template <class Check>
void for_floating_lanes(const Check& check) {
  for_lanes<float>(check);
  for_lanes<double>(check);
}
template <class Check>
void for_all_lanes(const Check& check) {
  for_integer_lanes(check);
  for_floating_lanes(check);
}

}  // namespace test
