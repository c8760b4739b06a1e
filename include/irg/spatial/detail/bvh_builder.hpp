// SPDX-License-Identifier: MIT
// The two ways to split a bvh: where rays are estimated to cost least, and where a curve through space turns.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include <irg/spatial/detail/bvh_area_splits.hpp>

namespace irg::detail {
inline namespace IRG_ABI {

// Splits where the highest bit changes in which places along a curve of 2^10 steps an axis differ.
template <class Item>
class morton_splits {
public:
  struct range {
    std::uint32_t first = 0, count = 0;
  };

  constexpr explicit morton_splits(const std::vector<Item>& items) {
    const std::vector<std::uint64_t> keys = sorted_keys(items);
    items_.reserve(items.size());
    codes_.reserve(items.size());
    for (const std::uint64_t key : keys) {
      items_.push_back(items[key & 0xffffffff]);
      codes_.push_back(static_cast<std::uint32_t>(key >> 32));
    }
  }

  IRG_INLINE constexpr std::uint32_t priority(const range& r) const noexcept { return r.count; }
  IRG_INLINE constexpr const Item& item(const range& r, std::uint32_t i) const noexcept { return items_[r.first + i]; }

  constexpr void split(range& r, range& second) const noexcept {
    const std::uint32_t differ = codes_[r.first] ^ codes_[r.first + r.count - 1];
    std::uint32_t low = r.count / 2;
    if (differ != 0) {
      const std::uint32_t bit = std::bit_floor(differ);
      low = 0;
      for (std::uint32_t rest = r.count; rest > 0;) {
        const std::uint32_t half = rest / 2;
        if ((codes_[r.first + low + half] & bit) == 0) {
          low += half + 1;
          rest -= half + 1;
        } else {
          rest = half;
        }
      }
    }
    second = {r.first + low, r.count - low};
    r.count = low;
  }

private:
  static constexpr std::uint32_t spread(std::uint32_t x) noexcept {  // two zeros before each of 10 bits
    x = (x | x << 16) & 0x030000ff;
    x = (x | x << 8) & 0x0300f00f;
    x = (x | x << 4) & 0x030c30c3;
    return (x | x << 2) & 0x09249249;
  }

  // The places in the upper halves, the items' in the lower, by place.
  static constexpr std::vector<std::uint64_t> sorted_keys(const std::vector<Item>& items) {
    const Item centres = centres_round(items, 0, items.size());
    float least[4]{}, gain[4]{};
    for (int i = 0; i < 3; ++i) {
      const float extent = 0.0f - centres.v[4 + i] - centres.v[i];
      least[i] = centres.v[i];
      gain[i] = extent > 0 ? 1024.0f / extent : 0.0f;
    }
    std::vector<std::uint64_t> keys(items.size(), std::uint64_t{0}), other(items.size(), std::uint64_t{0});
    std::uint32_t starts[3][1024]{};
    for (std::size_t i = 0; i < items.size(); ++i) {
      std::int32_t bin[4];
      bins_kernel(bin, items[i].v, least, gain, 1023);
      const std::uint32_t code = spread(static_cast<std::uint32_t>(bin[0])) << 2 |
                                 spread(static_cast<std::uint32_t>(bin[1])) << 1 |
                                 spread(static_cast<std::uint32_t>(bin[2]));
      keys[i] = std::uint64_t{code} << 32 | i;
      for (int digit = 0; digit < 3; ++digit) ++starts[digit][code >> (10 * digit) & 1023];
    }
    for (int digit = 0; digit < 3; ++digit) {
      std::uint32_t before = 0;
      for (std::uint32_t& start : starts[digit]) before += std::exchange(start, before);
      for (const std::uint64_t key : keys) other[starts[digit][key >> (32 + 10 * digit) & 1023]++] = key;
      keys.swap(other);
    }
    return keys;
  }

  std::vector<Item> items_;
  std::vector<std::uint32_t> codes_;
};

// Ranges of at most so many primitives are built by tasks.
inline constexpr std::size_t bvh_grain = 8192;

/// needs   items; numbers below 2^32
template <class E>
constexpr void build_by_area(bvh& tree, std::vector<bvh_item>& items, int bins, const E& executor) {
  const auto count = static_cast<std::uint32_t>(items.size());
  area_splits<bvh_item> source(items, bins);
  bvh_grower<area_splits<bvh_item>>(source, tree, bvh_grain)({0, count, 0, count, 0, 0, 0}, executor);
}

template <class E>
constexpr void build_by_morton(bvh& tree, const std::vector<bvh_item>& items, const E& executor) {
  morton_splits<bvh_item> source(items);
  bvh_grower<morton_splits<bvh_item>>(source, tree, bvh_grain)({0, static_cast<std::uint32_t>(items.size())}, executor);
}

}  // namespace IRG_ABI
}  // namespace irg::detail
