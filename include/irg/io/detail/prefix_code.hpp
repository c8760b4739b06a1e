// SPDX-License-Identifier: MIT
// Prefix codes of limited length, as DEFLATE uses them: optimal lengths from frequencies, canonical codes from lengths.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include <irg/core/contract.hpp>

namespace irg::detail {
inline namespace IRG_ABI {

/// A canonical prefix code over the symbols 0 to N - 1.
/// shape   length 0: the symbol has no code; bits stand in the order they are sent, the lowest first
template <std::size_t N>
struct prefix_code {
  std::array<std::uint8_t, N> length{};
  std::array<std::uint16_t, N> bits{};
};

/// Code lengths, none above `limit`, that need the fewest bits for these frequencies.
/// needs   two or more frequencies > 0 and at most 2^limit of them; limit <= 15; a sum below 2^32 / limit
/// exact   an optimal code; equal frequencies are ordered by symbol
/// cost    O(N * limit), and O(N^2) short steps of sorting
/// source  Larmore and Hirschberg 1990 (package-merge)
template <std::size_t N>
constexpr std::array<std::uint8_t, N> limited_code_lengths(const std::array<std::uint32_t, N>& frequency,
                                                           int limit) noexcept {
  std::array<std::size_t, N> order{};  // the used symbols, rarest first
  std::size_t used = 0;
  for (std::size_t symbol = 0; symbol < N; ++symbol) {
    if (frequency[symbol] == 0) continue;
    std::size_t k = used++;
    for (; k > 0 && frequency[order[k - 1]] > frequency[symbol]; --k) order[k] = order[k - 1];
    order[k] = symbol;
  }
  IRG_EXPECTS(used >= 2 && used <= std::size_t{1} << limit && limit <= 15);

  // Row by row, merge the symbols with the pairs of the row before, by weight. is_symbol keeps what each item was.
  const std::size_t wanted = 2 * used - 2;
  std::array<std::array<bool, 2 * N>, 15> is_symbol;
  std::array<std::array<std::uint32_t, 2 * N>, 2> weights;
  std::size_t size_before = 0;
  for (std::size_t row = 0; row < static_cast<std::size_t>(limit); ++row) {
    const auto& before = weights[(row + 1) % 2];
    auto& weight = weights[row % 2];
    std::size_t size = 0, symbol = 0, pair = 0;
    while (size < wanted && (symbol < used || pair + 1 < size_before)) {
      const bool pair_is_lighter =
          pair + 1 < size_before && symbol < used && before[pair] + before[pair + 1] < frequency[order[symbol]];
      is_symbol[row][size] = symbol < used && !pair_is_lighter;
      if (is_symbol[row][size]) {
        weight[size++] = frequency[order[symbol++]];
      } else {
        weight[size++] = before[pair] + before[pair + 1];
        pair += 2;
      }
    }
    size_before = size;
  }

  // Unpack from the last row: every symbol met makes its code one bit longer, every pair asks for two items above.
  std::array<std::uint8_t, N> length{};
  std::size_t items = wanted;
  for (std::size_t row = static_cast<std::size_t>(limit); row-- > 0;) {
    std::size_t symbols = 0;
    for (std::size_t i = 0; i < items; ++i)
      if (is_symbol[row][i]) ++length[order[symbols++]];
    items = 2 * (items - symbols);
  }
  return length;
}

/// The canonical code with these lengths.
/// needs   lengths that fulfil Kraft's inequality, none above 15
/// source  RFC 1951, 3.2.2
template <std::size_t N>
constexpr prefix_code<N> canonical_code(const std::array<std::uint8_t, N>& length) noexcept {
  std::array<std::uint32_t, 16> next{};
  for (const std::uint8_t l : length) ++next[l];
  next[0] = 0;
  std::uint32_t first = 0;
  for (std::uint32_t& n : next) {
    const std::uint32_t count = n;
    n = first;
    first = (first + count) << 1;
  }
  prefix_code<N> code{length, {}};
  for (std::size_t symbol = 0; symbol < N; ++symbol) {
    std::uint32_t value = length[symbol] == 0 ? 0 : next[length[symbol]]++;
    for (int bit = 0; bit < length[symbol]; ++bit, value >>= 1)
      code.bits[symbol] = static_cast<std::uint16_t>((std::uint32_t{code.bits[symbol]} << 1) | (value & 1));
  }
  return code;
}

}  // namespace IRG_ABI
}  // namespace irg::detail
