// SPDX-License-Identifier: MIT
// The two checksums of a PNG file: CRC-32 over each chunk, Adler-32 over the uncompressed data.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include <irg/core/config.hpp>

namespace irg::detail::inline IRG_ABI {

struct crc32_table {
  std::uint32_t of[256] = {};
  constexpr crc32_table() noexcept {
    for (std::uint32_t n = 0; n < 256; ++n) {
      std::uint32_t c = n;
      for (int bit = 0; bit < 8; ++bit) c = (c & 1) != 0 ? 0xedb88320u ^ (c >> 1) : c >> 1;
      of[n] = c;
    }
  }
};
inline constexpr crc32_table crc32_steps{};

/// The CRC-32 of the bytes, continuing one over earlier bytes (0 at the start).
/// source  ISO 3309; PNG, annex D
constexpr std::uint32_t crc32(std::span<const std::uint8_t> bytes, std::uint32_t earlier = 0) noexcept {
  std::uint32_t c = ~earlier;
  for (const std::uint8_t byte : bytes) c = crc32_steps.of[(c ^ byte) & 255] ^ (c >> 8);
  return ~c;
}

/// The Adler-32 of the bytes.
/// source  RFC 1950
constexpr std::uint32_t adler32(std::span<const std::uint8_t> bytes) noexcept {
  constexpr std::uint32_t prime = 65521;
  constexpr std::size_t without_overflow = 5552;  // so many bytes of 255 keep both sums below 2^32
  std::uint32_t sum = 1, sum_of_sums = 0;
  for (std::size_t first = 0; first < bytes.size(); first += without_overflow) {
    const std::size_t rest = bytes.size() - first;
    for (const std::uint8_t byte : bytes.subspan(first, rest < without_overflow ? rest : without_overflow)) {
      sum += byte;
      sum_of_sums += sum;
    }
    sum %= prime;
    sum_of_sums %= prime;
  }
  return sum_of_sums << 16 | sum;
}

}  // namespace irg::detail::inline IRG_ABI
