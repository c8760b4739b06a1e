// SPDX-License-Identifier: MIT
// Bytes of a text by the eight and by the 64.
#pragma once

#include <bit>
#include <cstdint>
#include <cstring>
#include <type_traits>

#include <irg/core/lane_masks.hpp>

namespace irg::detail {
inline namespace IRG_ABI {

/// Eight bytes as a number, the first one lowest. Compilers do not always make one load of eight.
IRG_INLINE constexpr std::uint64_t load_eight(const char* p) noexcept {
  if (std::endian::native == std::endian::little && !std::is_constant_evaluated()) {
    std::uint64_t eight;
    std::memcpy(&eight, p, sizeof eight);
    return eight;
  }
  const auto byte = [p](int i) { return std::uint64_t{static_cast<unsigned char>(p[i])} << (8 * i); };
  return byte(0) | byte(1) | byte(2) | byte(3) | byte(4) | byte(5) | byte(6) | byte(7);
}

IRG_INLINE std::uint64_t digit_bits_in_lanes(const char* p) noexcept {
  using bytes = pack<std::uint8_t, native_bytes>;
  // 70 more makes digits the largest numbers of 8 bits with a sign.
  const auto more = lanes<bytes>::broadcast(70);
  const auto largest = lanes<pack<std::int8_t, native_bytes>>::broadcast(117);
  const auto bits = [&](int i) IRG_INLINE_LAMBDA {
    return std::uint64_t{mask_bits(bits_as<std::int8_t>(lanes<bytes>::load_bytes(p + i) + more) > largest)} << i;
  };
  static_assert(native_bytes == 16 || native_bytes == 32);
  if constexpr (native_bytes == 32) return bits(0) | bits(32);
  return bits(0) | bits(16) | bits(32) | bits(48);
}

IRG_INLINE constexpr std::uint64_t digit_bits_of(const char* p) noexcept {
  if (!std::is_constant_evaluated()) return digit_bits_in_lanes(p);
  std::uint64_t bits = 0;
  for (int i = 0; i < 64; ++i) bits |= std::uint64_t{p[i] >= '0' && p[i] <= '9' ? 1u : 0u} << i;
  return bits;
}

}  // namespace IRG_ABI
}  // namespace irg::detail
