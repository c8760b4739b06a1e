// SPDX-License-Identifier: MIT
// What binary space partitions of the plane, of space and of the picture share.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include <irg/geometry/box.hpp>
#include <irg/math/error_free.hpp>

namespace irg {

/// No segment, no triangle, no node.
inline constexpr std::uint32_t bsp_none = 0xffffffff;

/// Where a point lies: on the line or plane of a node (side 0), or in the cell without a node at that side of it.
struct bsp_place {
  std::uint32_t node = bsp_none;
  int side = 0;
  friend constexpr bool operator==(const bsp_place&, const bsp_place&) = default;
};

/// Which end of a walk comes first.
enum class bsp_order { back_to_front, front_to_back };

/// How the line or plane is chosen that divides a cell: of some candidates, spread over what is left, the one that cuts
/// the fewest and leaves the sides most alike, judged by some of them.
/// shape   one candidate is the first one left, as in the textbook
struct bsp_choice {
  std::size_t candidates = 8, judges = 32;
  std::size_t cut_costs = 4;  // as much as so many more on one side than on the other
};

/// What lies at the two sides of a line or plane: cells of bsp_open_cells, or bsp_none.
struct bsp_halves {
  std::uint32_t front = bsp_none, back = bsp_none;
};

/// How many items lie where: in front of a line or plane, behind it, and on both sides.
struct bsp_sides {
  std::size_t front = 0, back = 0, cut = 0;
};

/// The cells of a partition while they are divided. The items of a cell stand in a balanced tree of boxes, so that a
/// line or plane sends groups that lie at one side of it there as a whole, and looks only at the items that it comes
/// near: of a convex body, whose planes each leave all the rest on one side, at neighbours alone, some sqrt(n) of them.
/// needs   fewer than 2^31 items
template <class Item, Floating T, int N>
class IRG_APART bsp_open_cells {
public:
  /// An item, a box that it lies in, and the place that it was given at.
  struct entry {
    Item item;
    box<T, N> bounds;
    std::uint32_t place = 0;
  };

  /// A cell of some items, or bsp_none of none.
  /// cost    O(n log n); allocates
  constexpr std::uint32_t make_cell(std::vector<entry> items) {
    return items.empty() ? bsp_none : make(items, 0, items.size());
  }
  [[nodiscard]] constexpr std::size_t size(std::uint32_t cell) const noexcept {
    return cell == bsp_none ? 0 : nodes_[cell].count;
  }
  /// Item i of a cell, neighbours by place following each other.
  /// cost    the height of the cell's tree, some log n
  [[nodiscard]] constexpr const Item& at(std::uint32_t cell, std::size_t i) const noexcept {
    return items_[item_at(cell, i)].item;
  }
  [[nodiscard]] constexpr Item& at(std::uint32_t cell, std::size_t i) noexcept { return items_[item_at(cell, i)].item; }
  /// The item of a cell that was given first.
  [[nodiscard]] constexpr const Item& first(std::uint32_t cell) const noexcept {
    while (nodes_[cell].child[0] != bsp_none)
      cell = nodes_[cell].child[nodes_[nodes_[cell].child[0]].place == nodes_[cell].place ? 0 : 1];
    return items_[nodes_[cell].item].item;
  }

  /// Divides a cell, which is no more then.
  /// needs   side_of(box): 1 or -1 where all that may lie in a box is in front, or behind, and 0 where that is not
  ///         sure; part(entry, front, back): calls front(entry) or back(entry) with what becomes of an item, or both,
  ///         or none
  /// cost    what is not told by its box, and some log n for each; nothing allocated but for what is cut
  template <class SideOf, class Part>
  constexpr bsp_halves divide(std::uint32_t cell, const SideOf& side_of, const Part& part) {
    const int side = side_of(nodes_[cell].bounds);
    if (side > 0) return {cell, bsp_none};
    if (side < 0) return {bsp_none, cell};
    if (nodes_[cell].child[0] == bsp_none) return divide_leaf(cell, part);
    const std::uint32_t left = nodes_[cell].child[0], right = nodes_[cell].child[1];
    const bsp_halves a = divide(left, side_of, part), b = divide(right, side_of, part);
    free_nodes_.push_back(cell);
    return {join(a.front, b.front), join(a.back, b.back)};
  }

  /// How the items of a cell lie to a line or plane.
  /// needs   count(item, sides): adds an item to what it is of; side_of as divide
  /// gives   less than all of them where more than `looks` items would have to be looked at
  template <class SideOf, class Count>
  [[nodiscard]] constexpr bsp_sides count_sides(std::uint32_t cell, const SideOf& side_of, const Count& count,
                                                std::size_t looks) const {
    bsp_sides sides;
    add_sides(cell, side_of, count, looks, sides);
    return sides;
  }

  /// Whether holds(item) is true for one of a cell's items whose boxes pass may_hold(box).
  template <class MayHold, class Holds>
  [[nodiscard]] constexpr bool any_of(std::uint32_t cell, const MayHold& may_hold, const Holds& holds) const {
    if (cell == bsp_none || !may_hold(nodes_[cell].bounds)) return false;
    if (nodes_[cell].child[0] == bsp_none) return holds(items_[nodes_[cell].item].item);
    return any_of(nodes_[cell].child[0], may_hold, holds) || any_of(nodes_[cell].child[1], may_hold, holds);
  }

private:
  struct node {
    box<T, N> bounds;
    std::uint32_t child[2]{bsp_none, bsp_none};
    std::uint32_t count = 1, place = 0, item = bsp_none;
  };

  [[nodiscard]] constexpr std::uint32_t item_at(std::uint32_t cell, std::size_t i) const noexcept {
    while (nodes_[cell].child[0] != bsp_none) {
      const std::size_t first = nodes_[nodes_[cell].child[0]].count;
      const bool is_second = i >= first;
      if (is_second) i -= first;
      cell = nodes_[cell].child[is_second ? 1 : 0];
    }
    return nodes_[cell].item;
  }
  constexpr std::uint32_t add_node(const node& n) {
    if (free_nodes_.empty()) {
      nodes_.push_back(n);
      return static_cast<std::uint32_t>(nodes_.size() - 1);
    }
    const std::uint32_t at = free_nodes_.back();
    free_nodes_.pop_back();
    nodes_[at] = n;
    return at;
  }
  constexpr std::uint32_t add_leaf(entry e) {
    std::uint32_t at = static_cast<std::uint32_t>(items_.size());
    const node leaf{e.bounds, {bsp_none, bsp_none}, 1, e.place, free_items_.empty() ? at : free_items_.back()};
    if (free_items_.empty()) {
      items_.push_back(std::move(e));
    } else {
      items_[free_items_.back()] = std::move(e);
      free_items_.pop_back();
    }
    return add_node(leaf);
  }
  [[nodiscard]] static constexpr box<T, N> box_around(const box<T, N>& a, const box<T, N>& b) noexcept {
    box<T, N> both;
    for (int k = 0; k < N; ++k) both.low[k] = lesser(a.low[k], b.low[k]), both.high[k] = greater(a.high[k], b.high[k]);
    return both;
  }
  constexpr std::uint32_t join(std::uint32_t a, std::uint32_t b) {
    if (a == bsp_none || b == bsp_none) return a == bsp_none ? b : a;
    const node &m = nodes_[a], &n = nodes_[b];
    return add_node({box_around(m.bounds, n.bounds), {a, b}, m.count + n.count, lesser(m.place, n.place), bsp_none});
  }

  // The tree of a run of items, halved along the longest side of the box round it.
  constexpr std::uint32_t make(std::vector<entry>& items, std::size_t begin, std::size_t end) {
    if (end - begin == 1) return add_leaf(std::move(items[begin]));
    box<T, N> around = items[begin].bounds;
    for (std::size_t i = begin + 1; i < end; ++i) around = box_around(around, items[i].bounds);
    int axis = 0;
    const auto half = [](const box<T, N>& b, int k) { return product(b.high[k], T(0.5)) - product(b.low[k], T(0.5)); };
    for (int k = 1; k < N; ++k)
      if (half(around, k) > half(around, axis)) axis = k;
    const auto at = [&](std::size_t i) { return items.begin() + static_cast<std::ptrdiff_t>(i); };
    const auto centre = [axis](const entry& e) {
      return product(e.bounds.low[axis], T(0.5)) + product(e.bounds.high[axis], T(0.5));
    };
    const std::size_t middle = begin + (end - begin) / 2;
    std::nth_element(at(begin), at(middle), at(end), [&](const entry& a, const entry& b) {
      const T p = centre(a), q = centre(b);
      return p != q ? p < q : a.place < b.place;
    });
    const std::uint32_t left = make(items, begin, middle), right = make(items, middle, end);
    return join(left, right);
  }

  template <class SideOf, class Count>
  constexpr void add_sides(std::uint32_t cell, const SideOf& side_of, const Count& count, std::size_t& looks,
                           bsp_sides& sides) const {
    if (looks == 0) return;
    const node& n = nodes_[cell];
    if (const int side = side_of(n.bounds); side != 0) {
      (side > 0 ? sides.front : sides.back) += n.count;
    } else if (n.child[0] == bsp_none) {
      --looks;
      count(items_[n.item].item, sides);
    } else {
      add_sides(n.child[0], side_of, count, looks, sides);
      add_sides(n.child[1], side_of, count, looks, sides);
    }
  }

  template <class Part>
  constexpr bsp_halves divide_leaf(std::uint32_t leaf, const Part& part) {
    bsp_halves halves;
    const std::uint32_t item = nodes_[leaf].item;
    entry e = std::move(items_[item]);
    free_items_.push_back(item);
    free_nodes_.push_back(leaf);
    part(
        std::move(e), [&](entry&& in_front) { halves.front = add_leaf(std::move(in_front)); },
        [&](entry&& behind) { halves.back = add_leaf(std::move(behind)); });
    return halves;
  }

  std::vector<node> nodes_{};
  std::vector<entry> items_{};
  std::vector<std::uint32_t> free_nodes_{}, free_items_{};
};

}  // namespace irg
