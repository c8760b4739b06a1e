// SPDX-License-Identifier: MIT
// What of a mesh belongs together: vectors that are equal, by sorting, so that no input makes it slow; and corners that
// were joined.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <type_traits>
#include <vector>

#include <irg/core/scalar.hpp>

namespace irg::detail::inline IRG_ABI {

/// A vector's numbers as bits, and which vector it is; in this order equal ones are neighbours, the first in front.
template <Floating T, int N>
struct vector_key {
  using bits = std::conditional_t<sizeof(T) == 4, std::uint32_t, std::uint64_t>;
  std::array<bits, static_cast<std::size_t>(N)> numbers{};
  std::uint32_t index = 0;
  friend constexpr auto operator<=>(const vector_key&, const vector_key&) = default;
};

/// For each vector the first one with equal numbers; 0 and -0 are equal, NaN is equal to NaN of the same bits.
/// needs   fewer than 2^32 vectors
template <Floating T, int N, class Vectors>
constexpr std::vector<std::uint32_t> first_equal_vectors(const Vectors& vectors) {
  std::vector<vector_key<T, N>> keys;
  keys.reserve(vectors.size());
  for (const auto& v : vectors) {
    vector_key<T, N> key;
    key.index = static_cast<std::uint32_t>(keys.size());
    for (int i = 0; i < N; ++i)
      key.numbers[static_cast<std::size_t>(i)] =
          std::bit_cast<typename vector_key<T, N>::bits>(v[i] == T{0} ? T{0} : v[i]);
    keys.push_back(key);
  }
  std::sort(keys.begin(), keys.end());
  std::vector<std::uint32_t> first(vectors.size(), std::uint32_t{0});
  for (std::size_t i = 0, group = 0; i < keys.size(); ++i) {
    if (keys[i].numbers != keys[group].numbers) group = i;
    first[keys[i].index] = keys[group].index;
  }
  return first;
}

/// Corners of a mesh in groups, each known by its lowest corner.
class corner_groups {
public:
  constexpr explicit corner_groups(std::size_t count) : above_(count, 0) {
    std::iota(above_.begin(), above_.end(), std::uint32_t{0});
  }
  constexpr std::uint32_t of(std::uint32_t corner) noexcept {
    while (above_[corner] != corner) corner = above_[corner] = above_[above_[corner]];
    return corner;
  }
  constexpr void join(std::uint32_t a, std::uint32_t b) noexcept {
    a = of(a);
    b = of(b);
    above_[a < b ? b : a] = a < b ? a : b;
  }

private:
  std::vector<std::uint32_t> above_;
};

}  // namespace irg::detail::inline IRG_ABI
