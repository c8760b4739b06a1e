// SPDX-License-Identifier: MIT
// bvh: a tree of boxes round boxes (bounding volume hierarchy), eight to a node, for rays against anything that has a
// box. Its boxes are floats that stand round the given ones, so that no ray misses what it would meet; what is met is
// decided by whoever owns the primitives.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include <irg/core/executor.hpp>
#include <irg/geometry/box.hpp>
#include <irg/spatial/bvh_node.hpp>
#if IRG_BODIES
#include <irg/spatial/detail/bvh_area_splits.hpp>
#endif

namespace irg {

/// How a bvh is built: by the estimated cost of rays (surface area heuristic, in bins), or by place alone, along a
/// curve through space (Morton order): in a third of the time, for rays that take some more; or by cost with primitives
/// cut where their boxes overlap (spatial splits): in some twelve times the time, for long and slanting primitives.
enum class bvh_method { surface_area, morton, spatial_splits };

struct bvh_options {
  bvh_method method = bvh_method::surface_area;
  int bins = 16;  // 2 to 32: places along each axis at which a split is tried, in ranges of many primitives
  float spare = 1;  // spatial splits, 0 to 4: at most so many more references than primitives, as a share of them
  float overlap = 1e-5f;  // and tried where two halves' boxes have that share of the whole area in common
  bool operator==(const bvh_options&) const = default;
};

inline namespace IRG_ABI {

/// The tree over boxes; primitive i is the one in boxes[i].
/// needs   fewer than 2^28 boxes, with spatial splits references to them
/// gives   a tree without nodes where there is no box to hold. Boxes that are empty, and those with a coordinate that
///         is NaN or infinite, are left out: no ray meets them. Flat boxes count as any other. Where many centres are
///         one, their boxes are halved as they come, so that the depth is at most 3 log2(n) + 18 for every input
///         With spatial splits a box may be in several leaves, in parts that cover it together
/// exact   the same tree, bit for bit, for every executor, compiler and instruction set
/// cost    O(n log n); allocates some 200 bytes a box, of which 100 stay. With threads, but for the first splits
/// source  Wald 2007 (bins); Wald, Benthin and Boulos 2008 (wide nodes); Lauterbach et al. 2009 (Morton order);
///         Stich, Friedrich and Dietrich 2009 (spatial splits)
template <Floating T, Executor E = sequential>
[[nodiscard]] constexpr bvh build_bvh(std::span<const box<T, 3>> boxes, const bvh_options& config = {},
                                      const E& executor = {});

}  // namespace IRG_ABI

inline namespace IRG_COMPILED_ABI {

/// Fits the tree to boxes that have moved: what is in a node stays in it.
/// needs   as many boxes as the tree was built of. Those that were left out stay out; those that are to be left out now
///         are met by no ray
/// gives   a tree that holds all boxes as they are now. Rays take longer the more the order of places has changed: then
///         build it anew
/// exact   the same for every compiler and instruction set
/// cost    linear, a tenth of building it; nothing allocated
template <Floating T>
IRG_API void refit(bvh& tree, std::span<const box<T, 3>> boxes);

}  // namespace IRG_COMPILED_ABI
}  // namespace irg

namespace irg::detail::inline IRG_COMPILED_ABI {

template <Floating T>
IRG_API bvh build_box_tree(std::span<const box<T, 3>> boxes, const bvh_options& config, const executor_ref& executor);

}  // namespace irg::detail::inline IRG_COMPILED_ABI

namespace irg::inline IRG_ABI {

template <Floating T, Executor E>
[[nodiscard]] constexpr bvh build_bvh(std::span<const box<T, 3>> boxes, const bvh_options& config, const E& executor) {
  return detail::build_box_tree(boxes, config, as_executor(executor));
}

}  // namespace irg::inline IRG_ABI

#if IRG_BODIES
namespace irg::detail::inline IRG_ABI {

// The two ways to split a bvh: where rays are estimated to cost least, and where a curve through space turns.

// Splits where the highest bit changes in which places along a curve of 2^10 steps an axis differ.
template <class Item>
struct morton_splits {
  struct range {
    std::uint32_t first = 0, count = 0;
  };

  std::vector<Item> items{};  // along the curve
  std::vector<std::uint32_t> codes{};
};

constexpr std::uint32_t spread_bits(std::uint32_t x) noexcept {  // two zeros before each of 10 bits
  x = (x | x << 16) & 0x030000ff;
  x = (x | x << 8) & 0x0300f00f;
  x = (x | x << 4) & 0x030c30c3;
  return (x | x << 2) & 0x09249249;
}

// The places in the upper halves, the items' in the lower, by place.
template <class Item>
constexpr std::vector<std::uint64_t> sorted_morton_keys(const std::vector<Item>& items) {
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
    const std::uint32_t code = spread_bits(static_cast<std::uint32_t>(bin[0])) << 2 |
                               spread_bits(static_cast<std::uint32_t>(bin[1])) << 1 |
                               spread_bits(static_cast<std::uint32_t>(bin[2]));
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

template <class Item>
constexpr morton_splits<Item> make_morton_splits(const std::vector<Item>& items) {
  morton_splits<Item> splits;
  splits.items.reserve(items.size());
  splits.codes.reserve(items.size());
  for (const std::uint64_t key : sorted_morton_keys(items)) {
    splits.items.push_back(items[key & 0xffffffff]);
    splits.codes.push_back(static_cast<std::uint32_t>(key >> 32));
  }
  return splits;
}

template <class Item>
IRG_INLINE constexpr std::uint32_t priority_of(const morton_splits<Item>&,
                                               const range_of<morton_splits<Item>>& r) noexcept {
  return r.count;
}

template <class Item>
IRG_INLINE constexpr const Item& item_at(const morton_splits<Item>& splits, const range_of<morton_splits<Item>>& r,
                                         std::uint32_t i) noexcept {
  return splits.items[r.first + i];
}

template <class Item>
constexpr void split_range(const morton_splits<Item>& splits, range_of<morton_splits<Item>>& r,
                           range_of<morton_splits<Item>>& second) noexcept {
  const std::uint32_t differ = splits.codes[r.first] ^ splits.codes[r.first + r.count - 1];
  std::uint32_t low = r.count / 2;
  if (differ != 0) {
    const std::uint32_t bit = std::bit_floor(differ);
    low = 0;
    for (std::uint32_t rest = r.count; rest > 0;) {
      const std::uint32_t half = rest / 2;
      if ((splits.codes[r.first + low + half] & bit) == 0) {
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

// Ranges of at most so many primitives are built by tasks.
inline constexpr std::size_t bvh_grain = 8192;

// needs   items; numbers below 2^32
template <class E>
constexpr void build_by_area(bvh& tree, std::vector<bvh_item>&& items, int bins, const E& executor) {
  const auto count = static_cast<std::uint32_t>(items.size());
  area_splits<uncut> source = make_area_splits(std::move(items), bins, uncut{});
  grow_tree(source, tree, {0, count, 0, count, 0, 0, 0}, bvh_grain, executor);
}

template <class E>
constexpr void build_by_morton(bvh& tree, const std::vector<bvh_item>& items, const E& executor) {
  morton_splits<bvh_item> source = make_morton_splits(items);
  grow_tree(source, tree, {0, static_cast<std::uint32_t>(items.size())}, bvh_grain, executor);
}

// Building a bvh whose primitives may be cut: in several leaves, each time in a box round a part of them.

// The parts of an item's box below and above a plane across an axis: of primitives that are known by their boxes alone.
struct box_cut {
  static constexpr bool cuts = true;

  constexpr void operator()(const bvh_item& whole, int axis, float plane, bvh_item& low,
                            bvh_item& high) const noexcept {
    const bvh_item from = whole;
    low = high = from;
    low.v[4 + axis] = maximum(from.v[4 + axis], 0.0f - plane);
    high.v[axis] = maximum(from.v[axis], plane);
  }
};

// The same of triangles: boxes round what their corners and sides have on each side.
//
// A side from a to b meets the plane at a + (b - a) * share, where the share is off by 3u of itself (u = 2^-53), the
// difference by u and the product by u of what they are, and the sum by u of what it is. Coordinates are at most 1, so
// that is less than 12u, of 32u that boxes are made larger by.
template <class At>
struct triangle_cut {
  static constexpr bool cuts = true;
  const At& at;
  double scale;

  constexpr void operator()(const bvh_item& whole, int axis, float plane, bvh_item& low,
                            bvh_item& high) const noexcept {
    constexpr double slack = 0x1p-48;
    const bvh_item from = whole;
    const auto& triangle = at(number_of(from));
    const double x = widened(plane);
    double corner[3][3]{};
    for (std::size_t i = 0; i < 3; ++i)
      for (int k = 0; k < 3; ++k) corner[i][k] = exactly_widened(triangle[i][k]) * scale;
    extent below{}, above{};
    for (int i = 0; i < 3; ++i) {
      const double(&a)[3] = corner[i], (&b)[3] = corner[i == 2 ? 0 : i + 1];
      const double to_a = a[axis] - x, to_b = b[axis] - x;
      if (to_a <= 0) below.hold(a, 0);
      if (to_a >= 0) above.hold(a, 0);
      if (!((to_a < 0 && to_b > 0) || (to_a > 0 && to_b < 0))) continue;
      const double share = to_a / (a[axis] - b[axis]);
      double p[3]{};
      for (int k = 0; k < 3; ++k) p[k] = k == axis ? x : a[k] + product(b[k] - a[k], share);
      below.hold(p, slack);
      above.hold(p, slack);
    }
    limit(low, from, below);
    limit(high, from, above);
    low.v[4 + axis] = maximum(low.v[4 + axis], 0.0f - plane);
    high.v[axis] = maximum(high.v[axis], plane);
  }

private:
  struct extent {
    double low[3]{2, 2, 2}, high[3]{-2, -2, -2};

    constexpr void hold(const double (&p)[3], double off) noexcept {
      for (int k = 0; k < 3; ++k) {
        low[k] = minimum(low[k], p[k] - off);
        high[k] = maximum(high[k], p[k] + off);
      }
    }
  };

  // What a part has in common with the whole.
  static constexpr void limit(bvh_item& part, const bvh_item& from, const extent& e) noexcept {
    part = from;
    for (int k = 0; k < 3; ++k) {
      part.v[k] = maximum(from.v[k], float_below(e.low[k]));
      part.v[4 + k] = maximum(from.v[4 + k], float_below(-e.high[k]));
    }
  }
};

// Which primitives have been met before among the leaves, and where.
constexpr void list_references(bvh& tree, std::size_t primitives, std::size_t held) {
  std::size_t references = 0;
  for (const std::uint32_t number : tree.order) references += number != no_index ? 1u : 0u;
  if (references == held) return;
  std::vector<std::uint32_t> last(primitives, no_index);
  tree.earlier.assign(tree.order.size(), no_index);
  tree.boxes.assign(tree.order.size() / bvh_node::block, no_index);
  for (std::size_t n = 0; n < tree.nodes.size(); ++n)
    for (std::uint32_t k = 0; k < bvh_node::width; ++k) {
      const std::uint32_t child = tree.nodes[n].child[k];
      if (child == no_index || !bvh_node::is_leaf(child)) continue;
      for (std::uint32_t i = bvh_node::first_place(child); i <= bvh_node::last_place(child); ++i) {
        tree.earlier[i] = std::exchange(last[tree.order[i]], i);
        tree.boxes[i / bvh_node::block] = static_cast<std::uint32_t>(n) * bvh_node::width + k;
      }
    }
}

struct cut_limits {
  std::size_t primitives;
  int bins;
  float spare, overlap;  // as in bvh_options
};

template <class Cut, class E>
constexpr void build_by_cuts(bvh& tree, std::vector<bvh_item>&& items, const cut_limits& limits, const Cut& cut,
                             const E& executor) {
  bvh_item all = empty_item();
  for (const bvh_item& i : items) grow(all, i);
  const std::size_t held = items.size();
  const double spare = clamped(widened(limits.spare), 0.0, 4.0);
  items.resize(held + static_cast<std::size_t>(static_cast<double>(held) * spare), bvh_item{});
  const auto places = static_cast<std::uint32_t>(items.size()), count = static_cast<std::uint32_t>(held);
  area_splits<Cut> source = make_area_splits(std::move(items), limits.bins, cut, limits.overlap * area_of(all));
  grow_tree(source, tree, {0, places, 0, count, 0, 0, 0}, bvh_grain, executor);
  list_references(tree, limits.primitives, held);
}

// make_cut(scale) gives what cuts primitives.
template <Floating T, class E, class MakeCut>
constexpr bvh build_tree(std::span<const box<T, 3>> boxes, const bvh_options& config, const E& executor,
                         const MakeCut& make_cut) {
  bvh tree;
  std::vector<bvh_item> items = make_items(boxes, tree, executor);
  if (items.empty()) return tree;
  const int bins = clamped(config.bins, 2, 32);
  if (config.method == bvh_method::morton)
    build_by_morton(tree, items, executor);
  else if (config.method == bvh_method::surface_area)
    build_by_area(tree, std::move(items), bins, executor);
  else
    build_by_cuts(tree, std::move(items), {boxes.size(), bins, config.spare, config.overlap}, make_cut(tree.scale),
                  executor);
  return tree;
}

}  // namespace irg::detail::inline IRG_ABI

namespace irg::detail::inline IRG_COMPILED_ABI {

template <Floating T>
IRG_API bvh build_box_tree(std::span<const box<T, 3>> boxes, const bvh_options& config, const executor_ref& executor) {
  return build_tree(boxes, config, executor, [](double) { return box_cut{}; });
}

}  // namespace irg::detail::inline IRG_COMPILED_ABI

namespace irg::inline IRG_COMPILED_ABI {

template <Floating T>
IRG_API void refit(bvh& tree, std::span<const box<T, 3>> boxes) {
  detail::rescale(tree, boxes);
  for (std::size_t n = tree.nodes.size(); n-- > 0;) {
    bvh_node& node = tree.nodes[n];
    for (int k = 0; k < bvh_node::width; ++k) {
      const std::uint32_t child = node.child[k];
      if (child == no_index) continue;
      if (bvh_node::is_leaf(child)) {
        detail::bvh_item around = detail::empty_item();
        for (std::uint32_t i = bvh_node::first_place(child); i <= bvh_node::last_place(child); ++i)
          detail::grow(around, detail::item_of(boxes[tree.order[i]], 0, tree.scale));
        detail::set_child(node, k, child, around);
      } else {
        detail::set_child(node, k, child, detail::box_round(tree.nodes[child]));
      }
    }
  }
}

}  // namespace irg::inline IRG_COMPILED_ABI
#endif
