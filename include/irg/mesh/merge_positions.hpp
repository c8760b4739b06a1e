// SPDX-License-Identifier: MIT
// Corners that name equal positions come to share one: what files without indices need before neighbours are known.
// Equality is exact. Vertices that are only near each other are another question, and need a distance from the caller.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>
#include <vector>

#include <irg/mesh/mesh.hpp>

namespace irg {
namespace detail {

/// A position's numbers as bits, and which position it is; in this order equal positions are neighbours.
template <Floating T>
struct position_key {
  using bits = std::conditional_t<sizeof(T) == 4, std::uint32_t, std::uint64_t>;
  std::array<bits, 3> numbers{};
  std::uint32_t index = 0;
  friend constexpr auto operator<=>(const position_key&, const position_key&) = default;
};

inline namespace IRG_ABI {

/// -0 becomes 0, so that equal numbers have equal bits.
template <Floating T>
constexpr position_key<T> key_of_position(const point<T, 3>& p, std::uint32_t index) noexcept {
  const auto bits = [&](int i) { return std::bit_cast<typename position_key<T>::bits>(p[i] == T{0} ? T{0} : p[i]); };
  return {{bits(0), bits(1), bits(2)}, index};
}

/// For each position the first one that is equal to it.
template <Floating T>
constexpr std::vector<std::uint32_t> first_equal_positions(const std::vector<point<T, 3>>& positions) {
  std::vector<position_key<T>> keys;
  keys.reserve(positions.size());
  for (const point<T, 3>& p : positions) keys.push_back(key_of_position(p, static_cast<std::uint32_t>(keys.size())));
  std::sort(keys.begin(), keys.end());
  std::vector<std::uint32_t> first(positions.size(), std::uint32_t{0});
  for (std::size_t i = 0, group = 0; i < keys.size(); ++i) {
    if (keys[i].numbers != keys[group].numbers) group = i;
    first[keys[i].index] = keys[group].index;
  }
  return first;
}

}  // namespace IRG_ABI
}  // namespace detail

inline namespace IRG_ABI {

/// The mesh with one position for all that are equal: the first of them, in the order in which they stood.
/// shape   faces, normals, texture coordinates and parts stay; positions that no corner names stay, too
/// gives   0 and -0 as one position, the first one's; NaN equal to NaN of the same bits
/// needs   a mesh in which validate() finds no bad index, of less than 2^32 positions
/// exact   always; no two positions of the result are equal
/// cost    O(n log n) for n positions, whatever they are; 16 (float) or 32 bytes for each
template <Floating T>
constexpr mesh<T> merge_positions(mesh<T> m) {
  std::vector<std::uint32_t> to = detail::first_equal_positions(m.positions);
  std::uint32_t kept = 0;
  for (std::uint32_t v = 0; v < to.size(); ++v) {
    if (to[v] != v) {
      to[v] = to[to[v]];  // an earlier one, whose new place is known
      continue;
    }
    m.positions[kept] = m.positions[v];
    to[v] = kept++;
  }
  m.positions.erase(m.positions.begin() + static_cast<std::ptrdiff_t>(kept), m.positions.end());
  for (mesh_corner& c : m.corners) c.position = to[c.position];
  return m;
}

}  // namespace IRG_ABI
}  // namespace irg
