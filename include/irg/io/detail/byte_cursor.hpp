// SPDX-License-Identifier: MIT
// Numbers in bytes, in either order, read and written without looking at the machine's own.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include <irg/core/config.hpp>

namespace irg::detail {

/// Which byte of a number stands first.
enum class byte_order { little, big };

inline namespace IRG_ABI {

/// The Size bytes at p as a number.
template <int Size>
constexpr std::uint64_t ordered_bits(const char* p, byte_order order) noexcept {
  std::uint64_t bits = 0;
  for (int i = 0; i < Size; ++i) {
    const int place = order == byte_order::little ? i : Size - 1 - i;
    bits |= std::uint64_t{static_cast<unsigned char>(p[i])} << (8 * place);
  }
  return bits;
}

IRG_INLINE constexpr float load_float(const char* p, byte_order order) noexcept {
  return std::bit_cast<float>(static_cast<std::uint32_t>(ordered_bits<4>(p, order)));
}
IRG_INLINE constexpr double load_double(const char* p, byte_order order) noexcept {
  return std::bit_cast<double>(ordered_bits<8>(p, order));
}

/// Appends the low Size bytes of a number.
template <int Size, class Bytes>
constexpr void append_bytes(Bytes& out, std::uint64_t bits, byte_order order) {
  for (int i = 0; i < Size; ++i) {
    const int place = order == byte_order::little ? i : Size - 1 - i;
    out.push_back(static_cast<std::uint8_t>(bits >> (8 * place)));
  }
}
template <class Bytes>
constexpr void append_bytes(Bytes& out, float x, byte_order order) {
  append_bytes<4>(out, std::bit_cast<std::uint32_t>(x), order);
}
template <class Bytes>
constexpr void append_bytes(Bytes& out, double x, byte_order order) {
  append_bytes<8>(out, std::bit_cast<std::uint64_t>(x), order);
}

}  // namespace IRG_ABI
}  // namespace irg::detail
