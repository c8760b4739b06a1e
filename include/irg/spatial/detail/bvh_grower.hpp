// SPDX-License-Identifier: MIT
// From splits to nodes: what all ways to build a bvh share. A way to build is a source of ranges:
//   split(range, second)    makes two of a range of more than eight primitives
//   priority(range)         the range to split next is that of the highest
//   item(range, i)          its i-th item
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <irg/spatial/detail/bvh_item.hpp>

namespace irg::detail {
inline namespace IRG_ABI {

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

}  // namespace IRG_ABI
}  // namespace irg::detail
