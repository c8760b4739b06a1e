// SPDX-License-Identifier: MIT
// The two ways to split a bvh: where rays are estimated to cost least, and where a curve through space turns.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include <irg/spatial/detail/bvh_grower.hpp>

namespace irg::detail {
inline namespace IRG_ABI {

IRG_INLINE constexpr float area_of(const bvh_item& b) noexcept {
  const float x = 0.0f - b.v[4] - b.v[0], y = 0.0f - b.v[5] - b.v[1], z = 0.0f - b.v[6] - b.v[2];
  return (product(x, y) + product(y, z)) + product(z, x);
}

// The box of twice the centres of items.
template <class Items>
constexpr bvh_item centres_round(const Items& items, std::size_t first, std::size_t count) noexcept {
  bvh_item around = empty_item();
  for (std::size_t i = first; i < first + count; ++i) {
    bvh_item c;
    centre_kernel(c.v, items[i].v);
    for (int k = 0; k < 4; ++k) c.v[4 + k] = 0.0f - c.v[k];
    grow(around, c);
  }
  return around;
}

// Splits where the areas of both boxes, times the leaves that their primitives fill, come to least.
template <class Item>
class area_splits {
public:
  struct range {
    std::uint32_t first = 0, count = 0;
    std::int32_t depth = 0, buffer = 0;  // which of the two its items stand in
    float area = 0;
  };

  constexpr area_splits(std::vector<Item>& items, int bins)
      : items_{&items, &other_}, other_(items.size(), Item{}), bins_(bins),
        deepest_(2 * static_cast<int>(std::bit_width(items.size())) + 16) {}

  IRG_INLINE constexpr float priority(const range& r) const noexcept { return r.area; }
  IRG_INLINE constexpr const Item& item(const range& r, std::uint32_t i) const noexcept {
    return (*items_[r.buffer])[r.first + i];
  }

  constexpr void split(range& r, range& second) noexcept {
    const std::vector<Item>& from = *items_[r.buffer];
    const Item centres = centres_round(from, r.first, r.count);
    binning b;
    const std::uint32_t quarter = r.count / 4 + 4;
    b.count = quarter < static_cast<std::uint32_t>(bins_) ? static_cast<int>(quarter) : bins_;
    bool flat = true;
    for (int i = 0; i < 3; ++i) {
      const float extent = 0.0f - centres.v[4 + i] - centres.v[i];
      b.least[i] = centres.v[i];
      b.gain[i] = extent > 0 ? static_cast<float>(b.count) / extent : 0.0f;
      flat = flat && !(extent > 0);
    }
    choice best;
    if (!flat && r.depth < deepest_) best = cheapest(from, r, b);
    if (best.axis < 0) return halve(r, second);
    partition(from, r, second, b, best);
  }

private:
  static constexpr int most_bins = 32;

  struct binning {
    float least[4]{}, gain[4]{};
    int count = 0;
  };
  struct bin_row {
    Item around[most_bins];
    std::uint32_t count[most_bins];
  };
  struct choice {
    int axis = -1, bin = 0;
    float cost = 0, low_area = 0, high_area = 0;
  };

  static constexpr float leaves_for(std::uint32_t count) noexcept {
    const std::uint32_t leaves = (count + bvh_node::block - 1) / bvh_node::block;
    return static_cast<float>(leaves);
  }

  static constexpr void fill(bin_row (&rows)[3], const std::vector<Item>& from, const range& r,
                             const binning& b) noexcept {
    for (bin_row& row : rows)
      for (int i = 0; i < b.count; ++i) row.around[i] = empty_item(), row.count[i] = 0;
    for (std::size_t i = r.first; i < std::size_t{r.first} + r.count; ++i) {
      std::int32_t bin[4];
      bins_kernel(bin, from[i].v, b.least, b.gain, b.count - 1);
      for (int axis = 0; axis < 3; ++axis) {
        grow(rows[axis].around[bin[axis]], from[i]);
        ++rows[axis].count[bin[axis]];
      }
    }
  }

  static constexpr choice cheapest(const std::vector<Item>& from, const range& r, const binning& b) noexcept {
    bin_row rows[3];
    fill(rows, from, r, b);
    choice best;
    for (int axis = 0; axis < 3; ++axis) {
      if (!(b.gain[axis] > 0)) continue;
      const bin_row& row = rows[axis];
      float above[most_bins];
      Item around = empty_item();
      for (int i = b.count - 1; i > 0; --i) {
        grow(around, row.around[i]);
        above[i - 1] = area_of(around);
      }
      around = empty_item();
      std::uint32_t count = 0;
      for (int i = 0; i + 1 < b.count; ++i) {
        grow(around, row.around[i]);
        count += row.count[i];
        if (count == 0 || count == r.count) continue;
        const float area = area_of(around);
        const float cost = product(area, leaves_for(count)) + product(above[i], leaves_for(r.count - count));
        if (best.axis < 0 || cost < best.cost) best = {axis, i, cost, area, above[i]};
      }
    }
    return best;
  }

  // The items of lower bins to the front of the other buffer, the rest, turned round, to the back.
  constexpr void partition(const std::vector<Item>& from, range& r, range& second, const binning& b,
                           const choice& best) noexcept {
    std::vector<Item>& to = *items_[1 - r.buffer];
    std::size_t low = r.first, high = std::size_t{r.first} + r.count - 1;
    for (std::size_t i = r.first; i < std::size_t{r.first} + r.count; ++i) {
      const Item item = from[i];
      const float at = (item.v[best.axis] - item.v[4 + best.axis]) - b.least[best.axis];
      const bool is_low = static_cast<int>(low_of(at * b.gain[best.axis], static_cast<float>(b.count - 1))) <= best.bin;
      to[low] = item;  // one of the two is written over
      to[high] = item;
      low += is_low ? 1u : 0u;
      high -= is_low ? 0u : 1u;
    }
    const std::uint32_t count = static_cast<std::uint32_t>(low) - r.first;
    second = {r.first + count, r.count - count, r.depth + 1, 1 - r.buffer, best.high_area};
    r = {r.first, count, r.depth + 1, 1 - r.buffer, best.low_area};
  }

  constexpr float area_of_range(const range& r) const noexcept {
    Item around = empty_item();
    for (std::uint32_t i = 0; i < r.count; ++i) grow(around, item(r, i));
    return area_of(around);
  }

  constexpr void halve(range& r, range& second) const noexcept {
    const std::uint32_t half = r.count / 2;
    second = {r.first + half, r.count - half, r.depth + 1, r.buffer, 0};
    r = {r.first, half, r.depth + 1, r.buffer, 0};
    r.area = area_of_range(r);
    second.area = area_of_range(second);
  }

  std::vector<Item>* items_[2];
  std::vector<Item> other_;
  int bins_, deepest_;
};

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
  area_splits<bvh_item> source(items, bins);
  bvh_grower<area_splits<bvh_item>>(source, tree, bvh_grain)({0, static_cast<std::uint32_t>(items.size()), 0, 0, 0},
                                                             executor);
}

template <class E>
constexpr void build_by_morton(bvh& tree, const std::vector<bvh_item>& items, const E& executor) {
  morton_splits<bvh_item> source(items);
  bvh_grower<morton_splits<bvh_item>>(source, tree, bvh_grain)({0, static_cast<std::uint32_t>(items.size())}, executor);
}

}  // namespace IRG_ABI
}  // namespace irg::detail
