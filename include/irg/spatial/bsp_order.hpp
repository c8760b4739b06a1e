// SPDX-License-Identifier: MIT
// What binary space partitions of the plane, of space and of the picture share.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include <irg/core/vocabulary.hpp>
#include <irg/geometry/box.hpp>
#include <irg/math/error_free.hpp>
#include <irg/math/vec.hpp>

namespace irg {

/// The old name of no_index: no segment, no triangle, no node.
[[deprecated("irg: no_index")]] inline constexpr std::uint32_t bsp_none = no_index;

/// Where a point lies: on the line or plane of a node (side 0), or in the cell without a node at that side of it.
struct bsp_place {
  std::uint32_t node = no_index;
  int side = 0;
  friend constexpr bool operator==(const bsp_place&, const bsp_place&) = default;
};

/// Which end of a walk comes first.
enum class bsp_order { back_to_front, front_to_back };

/// How the line or plane is chosen that divides a cell: of some candidates, spread over what is left, the one that cuts
/// the fewest and leaves the sides most alike, judged by some of them.
/// shape   one candidate is the first one left, as in the textbook
struct bsp_options {
  std::size_t candidates = 8, judges = 32;
  std::size_t cut_costs = 4;  // as much as so many more on one side than on the other
  bool operator==(const bsp_options&) const = default;
};

/// What lies at the two sides of a line or plane: cells of bsp_open_cells, or no_index.
struct bsp_halves {
  std::uint32_t front = no_index, back = no_index;
  bool operator==(const bsp_halves&) const = default;
};

/// How many items lie where: in front of a line or plane, behind it, and on both sides.
struct bsp_sides {
  std::size_t front = 0, back = 0, cut = 0;
  bool operator==(const bsp_sides&) const = default;
};

/// What some items lie in: a box, and the slab low <= normal . p <= high across the direction in which they are thin.
/// Of walls or faces that turn little, a box stands out over their planes by as much as they are long, a slab by the
/// square of it alone.
/// shape   a normal of zero: the box only
template <int N>
struct IRG_APART bsp_bounds {
  box<double, N> around;
  vec<double, N> normal{};
  double low = 0, high = 0;
};

/// The sum of slope . (p - origin), whose coefficients were rounded sums of terms of the size `size`.
template <int N>
struct IRG_APART linear_form {
  vec<double, N> slope, size;
  point<double, N> origin{};
};

namespace detail::inline IRG_ABI {

// A normal made as long that its greatest coordinate is 1 or -1; zero where that is `least` or less.
template <int N>
constexpr vec<double, N> scaled_normal(const vec<double, N>& v, double least) noexcept {
  double most = 0;
  for (int k = 0; k < N; ++k) most = maximum(most, magnitude(v[k]));
  vec<double, N> n{};
  if (most > least)
    for (int k = 0; k < N; ++k) n[k] = v[k] / most;
  return n;
}

// The least and the greatest value of a form within bounds. A share of the form is taken along the normal, where the
// slab tells, and the rest within the box.
//
// With u = 2^-53, each term passes at most 6 roundings (two differences, the share and its product, a product, a sum),
// the sum N more, and what the share is does not matter; so all are off by less than 16u of the sum of their sizes, and
// as much again for the sizes themselves: the bound is 2^-46 of it, 128u. Numbers below 2^-1022, which may be taken for
// zero, lose less than 2^-800 in products with others below 2^201.
template <int N>
constexpr box<double, 1> values_within(const linear_form<N>& f, const bsp_bounds<N>& b) noexcept {
  double along = 0, square = 0, start = 0, error = 0;
  for (int k = 0; k < N; ++k) {
    along += product(f.slope[k], b.normal[k]);
    square += product(b.normal[k], b.normal[k]);
    start += product(b.normal[k], f.origin[k]);
    error += magnitude(product(b.normal[k], f.origin[k]));
  }
  const double share = square > 0 ? along / square : 0.0;
  const double first = product(share, b.low - start), last = product(share, b.high - start);
  double low = minimum(first, last), high = maximum(first, last);
  error = product(magnitude(share), error + maximum(magnitude(b.low), magnitude(b.high)));
  for (int k = 0; k < N; ++k) {
    const double taken = product(share, b.normal[k]), left = f.slope[k] - taken;
    const double from = b.around.low[k] - f.origin[k], to = b.around.high[k] - f.origin[k];
    const double p = product(left, from), q = product(left, to);
    low += minimum(p, q);
    high += maximum(p, q);
    error += product(f.size[k] + magnitude(taken), maximum(magnitude(from), magnitude(to)));
  }
  error = product(error, 0x1p-46) + 0x1p-800;
  return {{low - error}, {high + error}};
}

template <int N>
constexpr linear_form<N> form_along(const vec<double, N>& normal) noexcept {
  linear_form<N> f{normal, normal};
  for (int k = 0; k < N; ++k) f.size[k] = magnitude(normal[k]);
  return f;
}

}  // namespace detail::inline IRG_ABI

inline namespace IRG_ABI {

/// 1 where the form is positive all over the bounds, -1 where it is negative, 0 where rounded numbers do not tell.
/// needs   coordinates and slopes up to 2^201 in size
template <int N>
[[nodiscard]] constexpr int rounded_side_of(const bsp_bounds<N>& b, const linear_form<N>& f) noexcept {
  const auto sure = [](const box<double, 1>& v) { return v.low[0] > 0 ? 1 : v.high[0] < 0 ? -1 : 0; };
  const int side = sure(detail::values_within(f, b));
  return side != 0 || b.normal == vec<double, N>{} ? side : sure(detail::values_within(f, bsp_bounds<N>{b.around}));
}

/// Bounds of the points of a segment, a triangle or a polygon, thin along a normal of any length.
template <int N, class Points>
[[nodiscard]] constexpr bsp_bounds<N> bounds_of(const Points& points, const vec<double, N>& normal) noexcept {
  bsp_bounds<N> b{{points[0], points[0]}};
  for (const point<double, N>& p : points)
    for (int k = 0; k < N; ++k) {
      b.around.low[k] = minimum(b.around.low[k], p[k]);
      b.around.high[k] = maximum(b.around.high[k], p[k]);
    }
  b.normal = detail::scaled_normal(normal, 0.0);
  const linear_form<N> f = detail::form_along(b.normal);
  bool any = false;
  for (const point<double, N>& p : points) {
    const box<double, 1> at = detail::values_within(f, bsp_bounds<N>{{p, p}});
    b.low = any ? minimum(b.low, at.low[0]) : at.low[0];
    b.high = any ? maximum(b.high, at.high[0]) : at.high[0];
    any = true;
  }
  return b;
}

/// Bounds of what either of two holds.
template <int N>
[[nodiscard]] constexpr bsp_bounds<N> bounds_of_both(const bsp_bounds<N>& a, const bsp_bounds<N>& b) noexcept {
  bsp_bounds<N> both = a;
  for (int k = 0; k < N; ++k) {
    both.around.low[k] = minimum(a.around.low[k], b.around.low[k]);
    both.around.high[k] = maximum(a.around.high[k], b.around.high[k]);
  }
  constexpr double cancelled = 0x1p-10;
  const bool turned = dot(a.normal, b.normal) < 0;  // of a normal either way serves
  both.normal = detail::scaled_normal(turned ? a.normal - b.normal : a.normal + b.normal, cancelled);
  const linear_form<N> f = detail::form_along(both.normal);
  const box<double, 1> first = detail::values_within(f, a), second = detail::values_within(f, b);
  both.low = minimum(first.low[0], second.low[0]);
  both.high = maximum(first.high[0], second.high[0]);
  return both;
}

}  // namespace IRG_ABI

/// The cells of a partition while they are divided. The items of a cell stand in a balanced tree of bounds, so that a
/// line or plane sends groups that lie at one side of it there as a whole, and looks only at the items that it comes
/// near: of a convex body, whose planes each leave all the rest on one side, at neighbours alone, some log n of them.
/// needs   fewer than 2^31 items
template <class Item, int N>
class IRG_APART bsp_open_cells {
public:
  /// An item, what it lies in, and the place that it was given at.
  struct entry {
    Item item;
    bsp_bounds<N> bounds;
    std::uint32_t place = 0;
  };

  /// A cell of some items, or no_index of none.
  /// cost    O(n log n); allocates
  constexpr std::uint32_t make_cell(std::vector<entry> items) {
    return items.empty() ? no_index : make(items, 0, items.size());
  }
  [[nodiscard]] constexpr std::size_t size(std::uint32_t cell) const noexcept {
    return cell == no_index ? 0 : nodes_[cell].count;
  }
  /// Item i of a cell, neighbours by place following each other.
  /// cost    the height of the cell's tree, some log n
  [[nodiscard]] constexpr const Item& at(std::uint32_t cell, std::size_t i) const noexcept {
    return items_[item_at(cell, i)].item;
  }
  [[nodiscard]] constexpr Item& at(std::uint32_t cell, std::size_t i) noexcept { return items_[item_at(cell, i)].item; }
  /// The item of a cell that was given first.
  [[nodiscard]] constexpr const Item& first(std::uint32_t cell) const noexcept {
    while (nodes_[cell].child[0] != no_index)
      cell = nodes_[cell].child[nodes_[nodes_[cell].child[0]].place == nodes_[cell].place ? 0 : 1];
    return items_[nodes_[cell].item].item;
  }

  /// Divides a cell, which is no more then.
  /// needs   side_of(bounds): 1 or -1 where all that may lie in them is in front, or behind, and 0 where that is not
  ///         sure; part(entry, front, back): calls front(entry) or back(entry) with what becomes of an item, or both,
  ///         or none
  /// cost    what is not told by its bounds, and some log n for each; nothing allocated but for what is cut
  template <class SideOf, class Part>
  constexpr bsp_halves divide(std::uint32_t cell, const SideOf& side_of, const Part& part) {
    const int side = side_of(nodes_[cell].bounds);
    if (side > 0) return {cell, no_index};
    if (side < 0) return {no_index, cell};
    if (nodes_[cell].child[0] == no_index) return divide_leaf(cell, part);
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

  /// Whether holds(item) is true for one of a cell's items whose bounds pass may_hold(bounds).
  template <class MayHold, class Holds>
  [[nodiscard]] constexpr bool any_of(std::uint32_t cell, const MayHold& may_hold, const Holds& holds) const {
    if (cell == no_index || !may_hold(nodes_[cell].bounds)) return false;
    if (nodes_[cell].child[0] == no_index) return holds(items_[nodes_[cell].item].item);
    return any_of(nodes_[cell].child[0], may_hold, holds) || any_of(nodes_[cell].child[1], may_hold, holds);
  }

private:
  struct node {
    bsp_bounds<N> bounds;
    std::uint32_t child[2]{no_index, no_index};
    std::uint32_t count = 1, place = 0, item = no_index;
  };

  [[nodiscard]] constexpr std::uint32_t item_at(std::uint32_t cell, std::size_t i) const noexcept {
    while (nodes_[cell].child[0] != no_index) {
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
    const node leaf{e.bounds, {no_index, no_index}, 1, e.place, free_items_.empty() ? at : free_items_.back()};
    if (free_items_.empty()) {
      items_.push_back(std::move(e));
    } else {
      items_[free_items_.back()] = std::move(e);
      free_items_.pop_back();
    }
    return add_node(leaf);
  }
  constexpr std::uint32_t join(std::uint32_t a, std::uint32_t b) {
    if (a == no_index || b == no_index) return a == no_index ? b : a;
    const node &m = nodes_[a], &n = nodes_[b];
    return add_node(
        {bounds_of_both(m.bounds, n.bounds), {a, b}, m.count + n.count, minimum(m.place, n.place), no_index});
  }

  // The tree of a run of items, halved along the longest side of the box round it.
  constexpr std::uint32_t make(std::vector<entry>& items, std::size_t begin, std::size_t end) {
    if (end - begin == 1) return add_leaf(std::move(items[begin]));
    box<double, N> around = items[begin].bounds.around;
    for (std::size_t i = begin + 1; i < end; ++i)
      for (int k = 0; k < N; ++k) {
        around.low[k] = minimum(around.low[k], items[i].bounds.around.low[k]);
        around.high[k] = maximum(around.high[k], items[i].bounds.around.high[k]);
      }
    int axis = 0;
    for (int k = 1; k < N; ++k)
      if (around.high[k] - around.low[k] > around.high[axis] - around.low[axis]) axis = k;
    const auto at = [&](std::size_t i) { return items.begin() + static_cast<std::ptrdiff_t>(i); };
    const auto centre = [axis](const entry& e) { return e.bounds.around.low[axis] + e.bounds.around.high[axis]; };
    const std::size_t middle = begin + (end - begin) / 2;
    std::nth_element(at(begin), at(middle), at(end), [&](const entry& a, const entry& b) {
      const double p = centre(a), q = centre(b);
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
    } else if (n.child[0] == no_index) {
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
