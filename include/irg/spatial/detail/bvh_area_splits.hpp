// SPDX-License-Identifier: MIT
// Splits of a bvh where rays are estimated to cost least.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include <irg/spatial/detail/bvh_item.hpp>

namespace irg::detail::inline IRG_ABI {

// From splits to nodes: what all ways to build a bvh share. A way to build is a source of ranges, with
//   range_of<Source>                      some of its items, with their count
//   split_range(source, range, second)    makes two of a range of more than eight primitives
//   priority_of(source, range)            the range to split next is that of the highest
//   item_at(source, range, i)             its i-th item
template <class Source>
using range_of = typename Source::range;

constexpr bvh_node empty_node() noexcept {
  bvh_node n{};
  for (int k = 0; k < bvh_node::width; ++k) set_child(n, k, no_index, empty_item());
  return n;
}

template <class Source>
struct later_part {
  range_of<Source> what;
  std::uint32_t node;
  int child;
};

template <class Source>
struct bvh_growth {
  Source& source;
  bvh& tree;
  std::size_t grain;  // nodes over ranges of at most so many primitives are left to tasks
  std::vector<later_part<Source>> later{};
};

template <class Source>
constexpr void append_part(bvh_growth<Source>& g, const bvh& part) {
  auto& nodes = g.tree.nodes;
  auto& order = g.tree.order;
  const auto first_node = static_cast<std::uint32_t>(nodes.size());
  const auto first_leaf = static_cast<std::uint32_t>(order.size());
  order.insert(order.end(), part.order.begin(), part.order.end());
  for (const bvh_node& from : part.nodes) {
    nodes.push_back(from);
    for (std::uint32_t& child : nodes.back().child)
      if (child != no_index) child += bvh_node::is_leaf(child) ? 2 * first_leaf : first_node;
  }
}

// The range split until there are eight, or all fit one block: first what is no leaf, then leaves of two blocks,
// which costs neither a node nor a block more.
template <class Source>
constexpr int split_for_node(bvh_growth<Source>& g, const range_of<Source>& whole,
                             range_of<Source> (&ranges)[bvh_node::width]) {
  int count = 1;
  ranges[0] = whole;
  for (const std::uint32_t limit : {bvh_node::most, bvh_node::block})
    while (count < bvh_node::width) {
      int best = -1;
      for (int i = 0; i < count; ++i)
        if (ranges[i].count > limit &&
            (best < 0 || priority_of(g.source, ranges[best]) < priority_of(g.source, ranges[i])))
          best = i;
      if (best < 0) break;
      split_range(g.source, ranges[best], ranges[count]);
      ++count;
    }
  return count;
}

template <class Source>
constexpr bvh_item grow_leaf(bvh_growth<Source>& g, const range_of<Source>& r, std::uint32_t node, int k) {
  const auto number = static_cast<std::uint32_t>(g.tree.order.size() / bvh_node::block);
  bvh_item around = empty_item();
  for (std::uint32_t i = 0; i < r.count || i % bvh_node::block != 0; ++i) {
    if (i >= r.count) {
      g.tree.order.push_back(no_index);
      continue;
    }
    const bvh_item& item = item_at(g.source, r, i);
    grow(around, item);
    g.tree.order.push_back(number_of(item));
  }
  set_child(g.tree.nodes[node], k, bvh_node::leaf_of(number, r.count), around);
  return around;
}

template <class Source>
constexpr bvh_item grow_node(bvh_growth<Source>& g, const range_of<Source>& r) {
  range_of<Source> ranges[bvh_node::width];
  const int count = split_for_node(g, r, ranges);
  const auto node = static_cast<std::uint32_t>(g.tree.nodes.size());
  g.tree.nodes.push_back(empty_node());
  bvh_item around = empty_item();
  for (int k = 0; k < count; ++k) {
    const range_of<Source>& part = ranges[k];
    if (part.count <= bvh_node::most) {
      grow(around, grow_leaf(g, part, node, k));
    } else if (part.count <= g.grain) {
      g.later.push_back({part, node, k});
    } else {
      const auto child = static_cast<std::uint32_t>(g.tree.nodes.size());
      const bvh_item inside = grow_node(g, part);
      set_child(g.tree.nodes[node], k, child, inside);
      grow(around, inside);
    }
  }
  return around;
}

// The tree over a range of all items. Which nodes are left to tasks depends on the primitives alone.
template <class Source, class E>
constexpr void grow_tree(Source& source, bvh& tree, const range_of<Source>& all, std::size_t grain, const E& executor) {
  bvh_growth<Source> g{source, tree, grain};
  grow_node(g, all);
  if (g.later.empty()) return;
  std::vector<bvh> parts(g.later.size(), bvh{});
  executor(g.later.size(), [&](std::size_t i) {
    const range_of<Source>& what = g.later[i].what;
    parts[i].nodes.reserve(what.count / 5 + 1);
    parts[i].order.reserve(what.count * 2 + 4);
    bvh_growth<Source> part{source, parts[i], 0};
    grow_node(part, what);
  });
  const std::size_t own = tree.nodes.size();
  std::size_t nodes = own, places = tree.order.size();
  for (const bvh& p : parts) {
    nodes += p.nodes.size();
    places += p.order.size();
  }
  tree.nodes.reserve(nodes);
  tree.order.reserve(places);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    tree.nodes[g.later[i].node].child[g.later[i].child] = static_cast<std::uint32_t>(tree.nodes.size());
    append_part(g, parts[i]);
  }
  for (std::size_t n = own; n-- > 0;)
    for (int k = 0; k < bvh_node::width; ++k)
      if (const std::uint32_t child = tree.nodes[n].child[k]; !bvh_node::is_leaf(child))
        set_child(tree.nodes[n], k, child, box_round(tree.nodes[child]));
}

IRG_INLINE constexpr float area_of(const bvh_item& b) noexcept {
  const float x = 0.0f - b.v[4] - b.v[0], y = 0.0f - b.v[5] - b.v[1], z = 0.0f - b.v[6] - b.v[2];
  return (product(x, y) + product(y, z)) + product(z, x);
}

// The box of twice the centres of items.
constexpr bvh_item centres_round(const std::vector<bvh_item>& items, std::size_t first, std::size_t count) noexcept {
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

// Its items stand from `first` on, somewhere in its places of one of the two buffers.
struct area_split_range {
  std::uint32_t begin = 0, places = 0, first = 0, count = 0;
  std::int32_t depth = 0, buffer = 0;
  float area = 0;
};

inline constexpr int most_bvh_bins = 32;

struct bvh_bins {
  float least[4]{}, gain[4]{};
  int count = 0;
};

struct bin_row {
  bvh_item around[most_bvh_bins];
  std::uint32_t count[most_bvh_bins];
};

struct split_choice {
  int axis = -1, bin = 0;
  float cost = 0, low_area = 0, high_area = 0, shared = 0;  // the area that both have in common
};

// The bins along an axis into which planes divide the box round items.
struct bvh_slices {
  float least = 0, width = 0, gain = 0;
  int count = 0;

  constexpr int bin_of(float x) const noexcept {
    const float at = (x - least) * gain;
    return at > 0.0f ? static_cast<int>(minimum(at, static_cast<float>(count - 1))) : 0;
  }
  constexpr float plane(int bin) const noexcept { return least + product(static_cast<float>(bin + 1), width); }
};

struct slice_row {
  bvh_item around[most_bvh_bins];
  std::uint32_t first[most_bvh_bins], last[most_bvh_bins];  // how many items begin and end in it
};

// Splits where the areas of both boxes, times the leaves that their primitives fill, come to least. With a Cut, which
// gives the parts of an item on both sides of a plane, planes are tried too that cut items in two.
template <class Cut>
struct area_splits {
  using range = area_split_range;

  std::vector<bvh_item> items[2];  // a split moves those of a range from one buffer to the other
  int bins, deepest;
  [[no_unique_address]] Cut cut{};
  float overlap = 0;  // planes that cut are tried where the boxes of both sides have that much area in common
};

template <class Cut>
constexpr area_splits<Cut> make_area_splits(std::vector<bvh_item>&& items, int bins, const Cut& cut,
                                            float overlap = 0) {
  const int deepest = 2 * static_cast<int>(std::bit_width(items.size())) + 16;
  std::vector<bvh_item> other(items.size(), bvh_item{});
  return {{std::move(items), std::move(other)}, bins, deepest, cut, overlap};
}

template <class Cut>
IRG_INLINE constexpr float priority_of(const area_splits<Cut>&, const area_split_range& r) noexcept {
  return r.area;
}

template <class Cut>
IRG_INLINE constexpr const bvh_item& item_at(const area_splits<Cut>& splits, const area_split_range& r,
                                             std::uint32_t i) noexcept {
  return splits.items[r.buffer][r.first + i];
}

template <class Cut>
constexpr int bins_for(const area_splits<Cut>& splits, std::uint32_t count) noexcept {
  const std::uint32_t quarter = count / 4 + 4;
  return quarter < static_cast<std::uint32_t>(splits.bins) ? static_cast<int>(quarter) : splits.bins;
}

constexpr float leaves_for(std::uint32_t count) noexcept {
  const std::uint32_t leaves = (count + bvh_node::block - 1) / bvh_node::block;
  return static_cast<float>(leaves);
}

constexpr void fill_rows(bin_row (&rows)[3], const std::vector<bvh_item>& from, const area_split_range& r,
                         const bvh_bins& b) noexcept {
  for (bin_row& row : rows)
    for (int i = 0; i < b.count; ++i) {
      row.around[i] = empty_item();
      row.count[i] = 0;
    }
  for (std::size_t i = r.first; i < std::size_t{r.first} + r.count; ++i) {
    std::int32_t bin[4];
    bins_kernel(bin, from[i].v, b.least, b.gain, b.count - 1);
    for (int axis = 0; axis < 3; ++axis) {
      grow(rows[axis].around[bin[axis]], from[i]);
      ++rows[axis].count[bin[axis]];
    }
  }
}

constexpr bool is_box(const bvh_item& a) noexcept {
  bool full = true;
  for (int i = 0; i < 3; ++i) full = full && a.v[i] <= 0.0f - a.v[4 + i];
  return full;
}

// Twice the sides of the box that two have in common.
constexpr float area_in_common(const bvh_item& a, const bvh_item& b) noexcept {
  bvh_item c = a;
  for (int i = 0; i < 8; ++i) c.v[i] = maximum(a.v[i], b.v[i]);
  return is_box(c) ? area_of(c) : 0.0f;
}

template <class Cut>
constexpr split_choice cheapest_split(const std::vector<bvh_item>& from, const area_split_range& r,
                                      const bvh_bins& b) noexcept {
  bin_row rows[3];
  fill_rows(rows, from, r, b);
  split_choice best;
  for (int axis = 0; axis < 3; ++axis) {
    if (!(b.gain[axis] > 0)) continue;
    const bin_row& row = rows[axis];
    float above[most_bvh_bins];
    bvh_item rest[Cut::cuts ? most_bvh_bins : 1];
    bvh_item around = empty_item();
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

// What is between the items below `low` and those above `high` to both, as they have items.
constexpr void share_places(area_split_range& r, area_split_range& second, std::size_t low, std::size_t high,
                            const split_choice& best) noexcept {
  const std::size_t end = std::size_t{r.begin} + r.places, below = low - r.begin, above = end - 1 - high;
  const std::size_t middle =
      low + static_cast<std::size_t>(std::uint64_t{end - below - above - r.begin} * below / (below + above));
  const auto number = [](std::size_t n) { return static_cast<std::uint32_t>(n); };
  second = {number(middle), number(end - middle), number(high + 1), number(above),
            r.depth + 1,    1 - r.buffer,         best.high_area};
  r = {r.begin, number(middle - r.begin), r.begin, number(below), r.depth + 1, 1 - r.buffer, best.low_area};
}

// The items of lower bins to the front of the other buffer, the rest, turned round, to the back.
template <class Cut>
constexpr void partition_range(area_splits<Cut>& splits, area_split_range& r, area_split_range& second,
                               const bvh_bins& b, const split_choice& best) noexcept {
  const std::vector<bvh_item>& from = splits.items[r.buffer];
  std::vector<bvh_item>& to = splits.items[1 - r.buffer];
  std::size_t low = r.begin, high = std::size_t{r.begin} + r.places - 1;
  for (std::size_t i = r.first; i < std::size_t{r.first} + r.count; ++i) {
    const bvh_item item = from[i];
    const float at = (item.v[best.axis] - item.v[4 + best.axis]) - b.least[best.axis];
    const bool is_low = static_cast<int>(minimum(at * b.gain[best.axis], static_cast<float>(b.count - 1))) <= best.bin;
    to[low] = item;  // one of the two is written over
    to[high] = item;
    low += is_low ? 1u : 0u;
    high -= is_low ? 0u : 1u;
  }
  share_places(r, second, low, high, best);
}

template <class Cut>
constexpr void fill_slices(const area_splits<Cut>& splits, slice_row& row, const area_split_range& r,
                           const bvh_slices& s, int axis) noexcept {
  for (int i = 0; i < s.count; ++i) {
    row.around[i] = empty_item();
    row.first[i] = row.last[i] = 0;
  }
  for (std::uint32_t i = 0; i < r.count; ++i) {
    bvh_item rest = item_at(splits, r, i);
    const int first = s.bin_of(rest.v[axis]), last = s.bin_of(0.0f - rest.v[4 + axis]);
    ++row.first[first];
    ++row.last[last];
    for (int k = first; k < last; ++k) {
      bvh_item low{}, high{};
      splits.cut(rest, axis, s.plane(k), low, high);
      if (is_box(low)) grow(row.around[k], low);
      rest = high;
    }
    if (is_box(rest)) grow(row.around[last], rest);
  }
}

// As partition_range; what lies on both sides of the plane comes to both in part. Gives whether there is something on
// each.
template <class Cut>
constexpr bool cut_range(area_splits<Cut>& splits, area_split_range& r, area_split_range& second, const bvh_slices& s,
                         const split_choice& best) noexcept {
  const std::vector<bvh_item>& from = splits.items[r.buffer];
  std::vector<bvh_item>& to = splits.items[1 - r.buffer];
  std::size_t low = r.begin, high = std::size_t{r.begin} + r.places - 1;
  const float plane = s.plane(best.bin);
  for (std::size_t i = r.first; i < std::size_t{r.first} + r.count; ++i) {
    bvh_item below = from[i], above = from[i];
    const bool is_low = s.bin_of(0.0f - from[i].v[4 + best.axis]) <= best.bin,
               is_high = s.bin_of(from[i].v[best.axis]) > best.bin;
    if (!is_low && !is_high) splits.cut(from[i], best.axis, plane, below, above);
    const bool has_low = is_low || (!is_high && is_box(below));
    if (has_low) to[low++] = below;
    if (is_high || (!is_low && is_box(above)))
      to[high--] = above;
    else if (!has_low)
      to[low++] = from[i];
  }
  if (low == r.begin || high + 1 == std::size_t{r.begin} + r.places) return false;
  share_places(r, second, low, high, best);
  return true;
}

// Splits by the plane that costs least, if that is less than `limit` and there are places for the parts.
template <class Cut>
constexpr bool split_by_plane(area_splits<Cut>& splits, area_split_range& r, area_split_range& second,
                              const split_choice& without) noexcept {
  if (r.places == r.count) return false;
  float limit = without.axis < 0 ? infinity<float> : without.cost;
  const int bins = bins_for(splits, r.count);
  bvh_item whole = empty_item();
  for (std::uint32_t i = 0; i < r.count; ++i) grow(whole, item_at(splits, r, i));
  split_choice best;
  bvh_slices taken;
  for (int axis = 0; axis < 3; ++axis) {
    const float extent = 0.0f - whole.v[4 + axis] - whole.v[axis];
    if (!(extent > 0x1p-90f)) continue;
    const bvh_slices s{whole.v[axis], extent / static_cast<float>(bins), static_cast<float>(bins) / extent, bins};
    slice_row row;
    fill_slices(splits, row, r, s, axis);
    float above[most_bvh_bins];
    std::uint32_t ends[most_bvh_bins];
    bvh_item around = empty_item();
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
  return cut_range(splits, r, second, taken, best);
}

template <class Cut>
constexpr float area_of_range(const area_splits<Cut>& splits, const area_split_range& r) noexcept {
  bvh_item around = empty_item();
  for (std::uint32_t i = 0; i < r.count; ++i) grow(around, item_at(splits, r, i));
  return area_of(around);
}

template <class Cut>
constexpr void halve_range(const area_splits<Cut>& splits, area_split_range& r, area_split_range& second) noexcept {
  const std::uint32_t half = r.count / 2;
  const std::uint32_t middle = r.first + half;
  second = {middle, r.begin + r.places - middle, middle, r.count - half, r.depth + 1, r.buffer, 0};
  r = {r.begin, middle - r.begin, r.first, half, r.depth + 1, r.buffer, 0};
  r.area = area_of_range(splits, r);
  second.area = area_of_range(splits, second);
}

template <class Cut>
constexpr void split_range(area_splits<Cut>& splits, area_split_range& r, area_split_range& second) noexcept {
  const std::vector<bvh_item>& from = splits.items[r.buffer];
  const bvh_item centres = centres_round(from, r.first, r.count);
  bvh_bins b;
  b.count = bins_for(splits, r.count);
  bool flat = true;
  for (int i = 0; i < 3; ++i) {
    const float extent = 0.0f - centres.v[4 + i] - centres.v[i];
    b.least[i] = centres.v[i];
    b.gain[i] = extent > 0 ? static_cast<float>(b.count) / extent : 0.0f;
    flat = flat && !(extent > 0);
  }
  split_choice best;
  if (!flat && r.depth < splits.deepest) best = cheapest_split<Cut>(from, r, b);
  if constexpr (Cut::cuts) {
    if (r.depth < splits.deepest && (best.axis < 0 || best.shared > splits.overlap) &&
        split_by_plane(splits, r, second, best))
      return;
  }
  if (best.axis < 0) return halve_range(splits, r, second);
  partition_range(splits, r, second, b, best);
}

}  // namespace irg::detail::inline IRG_ABI
