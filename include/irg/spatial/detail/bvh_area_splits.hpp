// SPDX-License-Identifier: MIT
// Splits of a bvh where rays are estimated to cost least.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include <irg/spatial/detail/bvh_item.hpp>

namespace irg::detail::inline IRG_ABI {

// From splits to nodes: what all ways to build a bvh share. A way to build is a source of ranges:
//   split(range, second)    makes two of a range of more than eight primitives
//   priority(range)         the range to split next is that of the highest
//   item(range, i)          its i-th item

constexpr bvh_node empty_node() noexcept {
  bvh_node n{};
  for (int k = 0; k < bvh_node::width; ++k) set_child(n, k, bvh_node::none, empty_item());
  return n;
}

// Nodes over ranges of at most `grain` primitives are left to tasks; which they are depends on the primitives alone.
template <class Source>
class bvh_grower {
public:
  using range = typename Source::range;

  constexpr bvh_grower(Source& source, bvh& tree, std::size_t grain)
      : source_(source), nodes_(tree.nodes), order_(tree.order), grain_(grain) {}

  template <class E>
  constexpr void operator()(const range& all, const E& executor) {
    grow_node(all);
    if (later_.empty()) return;
    std::vector<bvh> parts(later_.size(), bvh{});
    executor(later_.size(), [&](std::size_t i) {
      bvh_grower part(source_, parts[i], 0);
      part.reserve(later_[i].what.count);
      part.grow_node(later_[i].what);
    });
    const std::size_t own = nodes_.size();
    std::size_t nodes = own, places = order_.size();
    for (const bvh& p : parts) nodes += p.nodes.size(), places += p.order.size();
    nodes_.reserve(nodes);
    order_.reserve(places);
    for (std::size_t i = 0; i < parts.size(); ++i) {
      nodes_[later_[i].node].child[later_[i].child] = static_cast<std::uint32_t>(nodes_.size());
      append(parts[i]);
    }
    for (std::size_t n = own; n-- > 0;)
      for (int k = 0; k < bvh_node::width; ++k)
        if (const std::uint32_t child = nodes_[n].child[k]; !bvh_node::is_leaf(child))
          set_child(nodes_[n], k, child, box_round(nodes_[child]));
  }

private:
  struct postponed {
    range what;
    std::uint32_t node;
    int child;
  };

  constexpr void reserve(std::size_t count) {
    nodes_.reserve(count / 5 + 1);
    order_.reserve(count * 2 + 4);
  }

  constexpr void append(const bvh& part) {
    const auto nodes = static_cast<std::uint32_t>(nodes_.size()), leaves = static_cast<std::uint32_t>(order_.size());
    order_.insert(order_.end(), part.order.begin(), part.order.end());
    for (const bvh_node& from : part.nodes) {
      nodes_.push_back(from);
      for (std::uint32_t& child : nodes_.back().child)
        if (child != bvh_node::none) child += bvh_node::is_leaf(child) ? 2 * leaves : nodes;
    }
  }

  // The range split until there are eight, or all fit one block: first what is no leaf, then leaves of two blocks,
  // which costs neither a node nor a block more.
  constexpr int split_range(const range& whole, range (&ranges)[bvh_node::width]) {
    int count = 1;
    ranges[0] = whole;
    for (const std::uint32_t limit : {bvh_node::most, bvh_node::block})
      while (count < bvh_node::width) {
        int best = -1;
        for (int i = 0; i < count; ++i)
          if (ranges[i].count > limit && (best < 0 || source_.priority(ranges[best]) < source_.priority(ranges[i])))
            best = i;
        if (best < 0) break;
        source_.split(ranges[best], ranges[count]);
        ++count;
      }
    return count;
  }

  constexpr bvh_item grow_leaf(const range& r, std::uint32_t node, int k) {
    const auto number = static_cast<std::uint32_t>(order_.size() / bvh_node::block);
    bvh_item around = empty_item();
    for (std::uint32_t i = 0; i < r.count || i % bvh_node::block != 0; ++i) {
      if (i >= r.count) {
        order_.push_back(bvh_node::none);
        continue;
      }
      const bvh_item& item = source_.item(r, i);
      grow(around, item);
      order_.push_back(number_of(item));
    }
    set_child(nodes_[node], k, bvh_node::leaf_of(number, r.count), around);
    return around;
  }

  constexpr bvh_item grow_node(const range& r) {
    range ranges[bvh_node::width];
    const int count = split_range(r, ranges);
    const auto node = static_cast<std::uint32_t>(nodes_.size());
    nodes_.push_back(empty_node());
    bvh_item around = empty_item();
    for (int k = 0; k < count; ++k) {
      const range& part = ranges[k];
      if (part.count <= bvh_node::most) {
        grow(around, grow_leaf(part, node, k));
      } else if (part.count <= grain_) {
        later_.push_back({part, node, k});
      } else {
        const auto child = static_cast<std::uint32_t>(nodes_.size());
        const bvh_item inside = grow_node(part);
        set_child(nodes_[node], k, child, inside);
        grow(around, inside);
      }
    }
    return around;
  }

  Source& source_;
  std::vector<bvh_node>& nodes_;
  std::vector<std::uint32_t>& order_;
  std::size_t grain_;
  std::vector<postponed> later_;
};

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

// Where primitives may not be cut.
struct uncut {
  static constexpr bool cuts = false;
};

// Splits where the areas of both boxes, times the leaves that their primitives fill, come to least. With a Cut, which
// gives the parts of an item on both sides of a plane, planes are tried too that cut items in two.
template <class Item, class Cut = uncut>
class area_splits {
public:
  // Its items stand from `first` on, somewhere in its places of one of the two buffers.
  struct range {
    std::uint32_t begin = 0, places = 0, first = 0, count = 0;
    std::int32_t depth = 0, buffer = 0;
    float area = 0;
  };

  // overlap   planes that cut are tried where the boxes of both sides have that much area in common
  constexpr area_splits(std::vector<Item>& items, int bins, const Cut& cut = {}, float overlap = 0)
      : items_{&items, &other_}, other_(items.size(), Item{}), bins_(bins),
        deepest_(2 * static_cast<int>(std::bit_width(items.size())) + 16), cut_(cut), overlap_(overlap) {}

  IRG_INLINE constexpr float priority(const range& r) const noexcept { return r.area; }
  IRG_INLINE constexpr const Item& item(const range& r, std::uint32_t i) const noexcept {
    return (*items_[r.buffer])[r.first + i];
  }

  constexpr void split(range& r, range& second) noexcept {
    const std::vector<Item>& from = *items_[r.buffer];
    const Item centres = centres_round(from, r.first, r.count);
    binning b;
    b.count = bins_for(r.count);
    bool flat = true;
    for (int i = 0; i < 3; ++i) {
      const float extent = 0.0f - centres.v[4 + i] - centres.v[i];
      b.least[i] = centres.v[i];
      b.gain[i] = extent > 0 ? static_cast<float>(b.count) / extent : 0.0f;
      flat = flat && !(extent > 0);
    }
    choice best;
    if (!flat && r.depth < deepest_) best = cheapest(from, r, b);
    if constexpr (Cut::cuts) {
      if (r.depth < deepest_ && (best.axis < 0 || best.shared > overlap_) && split_by_plane(r, second, best)) return;
    }
    if (best.axis < 0) return halve(r, second);
    partition(from, r, second, b, best);
  }

private:
  static constexpr int most_bins = 32;
  static constexpr float infinite = std::numeric_limits<float>::infinity();

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
    float cost = 0, low_area = 0, high_area = 0, shared = 0;  // the area that both have in common
  };

  constexpr int bins_for(std::uint32_t count) const noexcept {
    const std::uint32_t quarter = count / 4 + 4;
    return quarter < static_cast<std::uint32_t>(bins_) ? static_cast<int>(quarter) : bins_;
  }

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
      Item rest[Cut::cuts ? most_bins : 1];
      Item around = empty_item();
      for (int i = b.count - 1; i > 0; --i) {
        grow(around, row.around[i]);
        above[i - 1] = area_of(around);
        if constexpr (Cut::cuts) rest[i - 1] = around;
      }
      around = empty_item();
      std::uint32_t count = 0;
      for (int i = 0; i + 1 < b.count; ++i) {
        grow(around, row.around[i]);
        count += row.count[i];
        if (count == 0 || count == r.count) continue;
        const float area = area_of(around);
        const float cost = product(area, leaves_for(count)) + product(above[i], leaves_for(r.count - count));
        if (best.axis < 0 || cost < best.cost) {
          best = {axis, i, cost, area, above[i], 0};
          if constexpr (Cut::cuts) best.shared = area_in_common(around, rest[i]);
        }
      }
    }
    return best;
  }

  // The items of lower bins to the front of the other buffer, the rest, turned round, to the back.
  constexpr void partition(const std::vector<Item>& from, range& r, range& second, const binning& b,
                           const choice& best) noexcept {
    std::vector<Item>& to = *items_[1 - r.buffer];
    std::size_t low = r.begin, high = std::size_t{r.begin} + r.places - 1;
    for (std::size_t i = r.first; i < std::size_t{r.first} + r.count; ++i) {
      const Item item = from[i];
      const float at = (item.v[best.axis] - item.v[4 + best.axis]) - b.least[best.axis];
      const bool is_low = static_cast<int>(low_of(at * b.gain[best.axis], static_cast<float>(b.count - 1))) <= best.bin;
      to[low] = item;  // one of the two is written over
      to[high] = item;
      low += is_low ? 1u : 0u;
      high -= is_low ? 0u : 1u;
    }
    share(r, second, low, high, best.low_area, best.high_area);
  }

  // What is between the items below `low` and those above `high` to both, as they have items.
  static constexpr void share(range& r, range& second, std::size_t low, std::size_t high, float low_area,
                              float high_area) noexcept {
    const std::size_t end = std::size_t{r.begin} + r.places, below = low - r.begin, above = end - 1 - high;
    const std::size_t middle =
        low + static_cast<std::size_t>(std::uint64_t{end - below - above - r.begin} * below / (below + above));
    const auto number = [](std::size_t n) { return static_cast<std::uint32_t>(n); };
    second = {number(middle), number(end - middle), number(high + 1), number(above),
              r.depth + 1,    1 - r.buffer,         high_area};
    r = {r.begin, number(middle - r.begin), r.begin, number(below), r.depth + 1, 1 - r.buffer, low_area};
  }

  // Twice the sides of the box that two have in common.
  static constexpr float area_in_common(const Item& a, const Item& b) noexcept {
    Item c = a;
    for (int i = 0; i < 8; ++i) c.v[i] = greater(a.v[i], b.v[i]);
    return is_box(c) ? area_of(c) : 0.0f;
  }

  static constexpr bool is_box(const Item& a) noexcept {
    bool full = true;
    for (int i = 0; i < 3; ++i) full = full && a.v[i] <= 0.0f - a.v[4 + i];
    return full;
  }

  // The bins along an axis into which planes divide the box round items.
  struct slices {
    float least = 0, width = 0, gain = 0;
    int count = 0;

    constexpr int bin_of(float x) const noexcept {
      const float at = (x - least) * gain;
      return at > 0.0f ? static_cast<int>(low_of(at, static_cast<float>(count - 1))) : 0;
    }
    constexpr float plane(int bin) const noexcept { return least + product(static_cast<float>(bin + 1), width); }
  };
  struct slice_row {
    Item around[most_bins];
    std::uint32_t first[most_bins], last[most_bins];  // how many items begin and end in it
  };

  constexpr void fill(slice_row& row, const range& r, const slices& s, int axis) const noexcept {
    for (int i = 0; i < s.count; ++i) row.around[i] = empty_item(), row.first[i] = row.last[i] = 0;
    for (std::uint32_t i = 0; i < r.count; ++i) {
      Item rest = item(r, i);
      const int first = s.bin_of(rest.v[axis]), last = s.bin_of(0.0f - rest.v[4 + axis]);
      ++row.first[first];
      ++row.last[last];
      for (int k = first; k < last; ++k) {
        Item low{}, high{};
        cut_(rest, axis, s.plane(k), low, high);
        if (is_box(low)) grow(row.around[k], low);
        rest = high;
      }
      if (is_box(rest)) grow(row.around[last], rest);
    }
  }

  // Splits by the plane that costs least, if that is less than `limit` and there are places for the parts.
  constexpr bool split_by_plane(range& r, range& second, const choice& without) noexcept {
    if (r.places == r.count) return false;
    float limit = without.axis < 0 ? infinite : without.cost;
    const int bins = bins_for(r.count);
    Item whole = empty_item();
    for (std::uint32_t i = 0; i < r.count; ++i) grow(whole, item(r, i));
    choice best;
    slices taken;
    for (int axis = 0; axis < 3; ++axis) {
      const float extent = 0.0f - whole.v[4 + axis] - whole.v[axis];
      if (!(extent > 0x1p-90f)) continue;
      const slices s{whole.v[axis], extent / static_cast<float>(bins), static_cast<float>(bins) / extent, bins};
      slice_row row;
      fill(row, r, s, axis);
      float above[most_bins];
      std::uint32_t ends[most_bins];
      Item around = empty_item();
      std::uint32_t count = 0;
      for (int i = s.count - 1; i > 0; --i) {
        grow(around, row.around[i]);
        count += row.last[i];
        above[i - 1] = area_of(around);
        ends[i - 1] = count;
      }
      around = empty_item();
      count = 0;
      for (int i = 0; i + 1 < s.count; ++i) {
        grow(around, row.around[i]);
        count += row.first[i];
        if (count == 0 || ends[i] == 0 || count + ends[i] > r.places) continue;
        const float area = area_of(around);
        const float cost = product(area, leaves_for(count)) + product(above[i], leaves_for(ends[i]));
        if (!(cost < limit)) continue;
        limit = cost;
        best = {axis, i, cost, area, above[i], 0};
        taken = s;
      }
    }
    if (best.axis < 0) return false;
    return cut_range(r, second, taken, best);
  }

  // As partition; what lies on both sides of the plane comes to both in part. Gives whether there is something on each.
  constexpr bool cut_range(range& r, range& second, const slices& s, const choice& best) noexcept {
    const std::vector<Item>& from = *items_[r.buffer];
    std::vector<Item>& to = *items_[1 - r.buffer];
    std::size_t low = r.begin, high = std::size_t{r.begin} + r.places - 1;
    const float plane = s.plane(best.bin);
    for (std::size_t i = r.first; i < std::size_t{r.first} + r.count; ++i) {
      Item below = from[i], above = from[i];
      const bool is_low = s.bin_of(0.0f - from[i].v[4 + best.axis]) <= best.bin,
                 is_high = s.bin_of(from[i].v[best.axis]) > best.bin;
      if (!is_low && !is_high) cut_(from[i], best.axis, plane, below, above);
      const bool has_low = is_low || (!is_high && is_box(below));
      if (has_low) to[low++] = below;
      if (is_high || (!is_low && is_box(above)))
        to[high--] = above;
      else if (!has_low)
        to[low++] = from[i];
    }
    if (low == r.begin || high + 1 == std::size_t{r.begin} + r.places) return false;
    share(r, second, low, high, best.low_area, best.high_area);
    return true;
  }

  constexpr float area_of_range(const range& r) const noexcept {
    Item around = empty_item();
    for (std::uint32_t i = 0; i < r.count; ++i) grow(around, item(r, i));
    return area_of(around);
  }

  constexpr void halve(range& r, range& second) const noexcept {
    const std::uint32_t half = r.count / 2;
    const std::uint32_t middle = r.first + half;
    second = {middle, r.begin + r.places - middle, middle, r.count - half, r.depth + 1, r.buffer, 0};
    r = {r.begin, middle - r.begin, r.first, half, r.depth + 1, r.buffer, 0};
    r.area = area_of_range(r);
    second.area = area_of_range(second);
  }

  std::vector<Item>* items_[2];
  std::vector<Item> other_;
  int bins_, deepest_;
  [[no_unique_address]] Cut cut_;
  float overlap_;
};

}  // namespace irg::detail::inline IRG_ABI
