// SPDX-License-Identifier: MIT
// Packs of integers that leave 32 bits, held by doubles.
#pragma once

#include <cstdint>

#include <irg/core/lane_integers.hpp>
#include <irg/core/lane_masks.hpp>
#include <irg/core/lane_shuffles.hpp>
#include <irg/core/pack.hpp>

namespace irg::inline IRG_ABI {

/// N integers below 2^53, held exactly by doubles in two registers: for what leaves 32 bits. Nothing is rounded, so
/// nothing has to be guarded against contraction.
template <int N>
struct wide_pack {
  static constexpr int half_count = N / 2;
  pack<double, N / 2> half[2];
};

template <int N>
[[nodiscard]] IRG_INLINE wide_pack<N> operator+(const wide_pack<N>& a, const wide_pack<N>& b) noexcept {
  return {{a.half[0] + b.half[0], a.half[1] + b.half[1]}};
}
template <int N>
[[nodiscard]] IRG_INLINE wide_pack<N> operator*(const wide_pack<N>& a, const wide_pack<N>& b) noexcept {
  const auto half = [&](int i) {
    return lanes_detail::lanewise<double, N / 2>([](auto& r, const auto& x, const auto& y) { r = x * y; }, a.half[i],
                                                 b.half[i]);
  };
  return {{half(0), half(1)}};
}
template <int N>
[[nodiscard]] IRG_INLINE double lane(const wide_pack<N>& a, int i) noexcept {
  return a.half[i / (N / 2)][i % (N / 2)];
}

template <int N>
[[nodiscard]] IRG_INLINE pack<float, N> to_float(const wide_pack<N>& a) noexcept {
  const auto half = [&](int i) { return lanes_detail::static_cast_lanes<float>(a.half[i]); };
  return join_halves<float, N>(half(0), half(1));
}

/// Where none of three numbers is negative.
template <int N>
[[nodiscard]] IRG_INLINE pack<std::int32_t, N> none_negative(const wide_pack<N>& a, const wide_pack<N>& b,
                                                             const wide_pack<N>& c) noexcept {
  const auto half = [&](int i) {
    return converted<std::int32_t>((a.half[i] >= 0) & (b.half[i] >= 0) & (c.half[i] >= 0));
  };
  return join_halves<std::int32_t, N>(half(0), half(1));
}

template <int N>
struct lanes<wide_pack<N>> {
  using scalar = double;
  static constexpr int count = N;
  using half = lanes<pack<double, N / 2>>;
  IRG_INLINE static wide_pack<N> broadcast(double x) noexcept { return {{half::broadcast(x), half::broadcast(x)}}; }
  IRG_INLINE static wide_pack<N> ramp() noexcept {
    return {{half::ramp(), half::ramp() + static_cast<double>(half::count)}};
  }
};

}  // namespace irg::inline IRG_ABI
