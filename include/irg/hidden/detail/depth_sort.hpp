// SPDX-License-Identifier: MIT
// Faces sorted by their depths, by the bits of these: four looks at each face instead of one for each halving of the
// list.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <irg/hidden/detail/crowded_window.hpp>

namespace irg::detail {

struct keyed_place {
  std::uint32_t key, place;
};

inline namespace IRG_ABI {

// Sorts by keys; equal ones stay in their order.
template <class Keyed = keyed_place>
constexpr void sort_by_keys(std::vector<Keyed>& list) {
  constexpr int digits = 4, values = 256;
  std::uint32_t counts[digits][values] = {};
  const auto digit = [](const Keyed& k, int d) { return static_cast<std::size_t>((k.key >> (8 * d)) & (values - 1)); };
  for (const Keyed& k : list)
    for (int d = 0; d < digits; ++d) ++counts[d][digit(k, d)];
  std::vector<Keyed> sorted(list.size(), Keyed{});
  for (int d = 0; d < digits && !list.empty(); ++d) {
    std::uint32_t(&places)[values] = counts[d];
    if (places[digit(list[0], d)] == list.size()) continue;  // all have this digit
    std::uint32_t before = 0;
    for (int v = 0; v < values; ++v) {
      const std::uint32_t count = places[v];
      places[v] = before;
      before += count;
    }
    for (const Keyed& k : list) sorted[places[digit(k, d)]++] = k;
    list.swap(sorted);
  }
}

// A number that grows with a depth.
IRG_INLINE constexpr std::uint32_t key_of_depth(float depth) noexcept {
  constexpr std::uint32_t sign = 0x80000000;
  const auto bits = std::bit_cast<std::uint32_t>(depth == 0.0f ? 0.0f : depth);  // 0 and -0 are equal
  return (bits & sign) != 0 ? ~bits : bits | sign;
}

// The faces from near to far by their farthest depths, of equal ones those of lower numbers first.
template <DepthOrder Order>
constexpr std::vector<window_face> sorted_by_depth(const std::vector<screen_face>& faces) {
  std::vector<keyed_place> order;
  order.reserve(faces.size());
  bool by_number = true;
  for (const screen_face& f : faces) {
    by_number = by_number && (order.empty() || order.back().key <= f.number);
    order.push_back({f.number, static_cast<std::uint32_t>(order.size())});
  }
  if (!by_number) sort_by_keys(order);
  for (keyed_place& k : order) {
    const std::uint32_t key = key_of_depth(farthest_depth<Order>(faces[k.place]));
    k.key = depth_sense<Order> > 0 ? ~key : key;
  }
  sort_by_keys(order);
  std::vector<window_face> sorted;
  sorted.reserve(faces.size());
  for (const keyed_place& k : order) sorted.push_back(window_face_of<Order>(faces[k.place]));
  return sorted;
}

}  // namespace IRG_ABI
}  // namespace irg::detail
