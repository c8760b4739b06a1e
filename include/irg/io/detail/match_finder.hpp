// SPDX-License-Identifier: MIT
// Where the same bytes stood before: the search of DEFLATE's compressor, through chains of equal hashes.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <irg/core/scalar.hpp>

namespace irg::detail {
inline namespace IRG_ABI {

inline constexpr std::size_t window_size = 32768;
inline constexpr int shortest_match = 4, longest_match = 258;  // the format allows 3, which seldom pays in pictures

/// How hard to look for matches.
struct deflate_effort {
  int candidates = 0;         // earlier places looked at per position; 0 stores the data as it is
  int improve_below = 1;      // a match shorter than this is dropped for a longer one that starts a byte later
  int content = longest_match;  // a match of this length ends the search
};

/// Eight bytes as a number, the first the lowest; compilers make one load of it.
IRG_INLINE constexpr std::uint64_t eight_bytes(const std::uint8_t* p) noexcept {
  return std::uint64_t{p[0]} | std::uint64_t{p[1]} << 8 | std::uint64_t{p[2]} << 16 | std::uint64_t{p[3]} << 24 |
         std::uint64_t{p[4]} << 32 | std::uint64_t{p[5]} << 40 | std::uint64_t{p[6]} << 48 | std::uint64_t{p[7]} << 56;
}
IRG_INLINE constexpr std::uint32_t four_bytes(const std::uint8_t* p) noexcept {
  return std::uint32_t{p[0]} | std::uint32_t{p[1]} << 8 | std::uint32_t{p[2]} << 16 | std::uint32_t{p[3]} << 24;
}

/// How many bytes from a and b on are equal, `limit` at most.
IRG_INLINE constexpr int common_length(const std::uint8_t* a, const std::uint8_t* b, int limit) noexcept {
  int n = 0;
  for (; n + 8 <= limit; n += 8) {
    const std::uint64_t difference = eight_bytes(a + n) ^ eight_bytes(b + n);
    if (difference != 0) return n + std::countr_zero(difference) / 8;
  }
  while (n < limit && a[n] == b[n]) ++n;
  return n;
}

/// A copy of earlier output: `length` bytes from `distance` bytes back; none when length is 0.
struct match {
  int length = 0;
  std::size_t distance = 0;
};

/// Finds earlier occurrences of the bytes at a position. Positions are kept modulo 2^16 (Position's range): a distance
/// read back from them may be stale, but a match is believed only after its bytes were compared.
template <class Position = std::uint16_t>
class match_finder {
public:
  constexpr explicit match_finder(std::span<const std::uint8_t> data)
      : data_(data.data()), size_(data.size()), shift_(32 - lesser(static_cast<int>(std::bit_width(data.size())), 15)),
        mask_(data.size() < window_size ? std::bit_ceil(data.size() + 1) - 1 : window_size - 1),
        newest_(std::size_t{1} << (32 - shift_), Position{0}), older_(mask_ + 1, Position{0}) {}

  /// Makes the position known to later searches.
  IRG_INLINE constexpr void insert(std::size_t position) noexcept {
    if (size_ - position < 4) return;
    Position& newest = newest_[hash(position)];
    older_[position & mask_] = newest;
    newest = static_cast<Position>(position);
  }

  /// The longest match at a position among those longer than `than`; the nearest of equals.
  constexpr match longer(std::size_t position, int than, const deflate_effort& effort) const noexcept {
    if (size_ - position < 4) return {};
    const int limit = size_ - position < longest_match ? static_cast<int>(size_ - position) : longest_match;
    const std::uint8_t* here = data_ + position;
    match best{than < shortest_match ? shortest_match - 1 : than, 0};
    if (best.length >= limit) return {};
    std::size_t last = 0;
    Position candidate = newest_[hash(position)];
    for (int i = 0; i < effort.candidates; ++i, candidate = older_[candidate & mask_]) {
      const std::size_t distance = static_cast<Position>(position - candidate);
      if (distance <= last || distance > window_size || distance > position) break;
      last = distance;
      const std::uint8_t* there = here - distance;
      if (there[best.length] != here[best.length] || four_bytes(there) != four_bytes(here)) continue;
      const int length = common_length(there, here, limit);
      if (length <= best.length) continue;
      best = {length, distance};
      if (length == limit || length >= effort.content) break;
    }
    return best.distance == 0 ? match{} : best;
  }

private:
  IRG_INLINE constexpr std::size_t hash(std::size_t position) const noexcept {
    return (four_bytes(data_ + position) * 2654435769u) >> shift_;  // Knuth's multiplicative hash
  }

  const std::uint8_t* data_;
  std::size_t size_;
  int shift_;
  std::size_t mask_;
  std::vector<Position> newest_;  // by hash
  std::vector<Position> older_;   // by position modulo the window
};

}  // namespace IRG_ABI
}  // namespace irg::detail
