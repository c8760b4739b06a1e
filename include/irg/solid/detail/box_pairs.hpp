// SPDX-License-Identifier: MIT
// Pairs of boxes that meet, one of each of two lots: both lots are halved together, and a half without boxes of one of
// them is done with. So only what is near both costs more than a look. And the boxes that may stand over a point, from
// a tree of them.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include <irg/core/scalar.hpp>
#include <irg/math/vec.hpp>

namespace irg::detail {

/// A box along the axes.
struct IRG_APART space_box {
  double low[3], high[3];

  constexpr bool operator==(const space_box&) const = default;

  constexpr void add(const point<double, 3>& p) noexcept {
    for (int i = 0; i < 3; ++i) low[i] = lesser(low[i], p[i]), high[i] = greater(high[i], p[i]);
  }
  constexpr void add(const space_box& b) noexcept {
    for (int i = 0; i < 3; ++i) low[i] = lesser(low[i], b.low[i]), high[i] = greater(high[i], b.high[i]);
  }
  IRG_INLINE constexpr bool meets(const space_box& b) const noexcept {
    return low[0] <= b.high[0] && b.low[0] <= high[0] && low[1] <= b.high[1] && b.low[1] <= high[1] &&
           low[2] <= b.high[2] && b.low[2] <= high[2];
  }
};

inline namespace IRG_ABI {

/// A box round nothing, to add to.
constexpr space_box no_box() noexcept {
  constexpr double most = (std::numeric_limits<double>::max)();
  return {{most, most, most}, {-most, -most, -most}};
}

/// Whether the common box of two that meet begins in a cell: cells have their lower side, the last one its upper one,
/// too, so one of those that a space is divided into has it.
constexpr bool begins_in(const space_box& a, const space_box& b, const space_box& cell) noexcept {
  for (int i = 0; i < 3; ++i) {
    const double begin = greater(a.low[i], b.low[i]);
    if (begin < cell.low[i] || !(begin < cell.high[i] || cell.high[i] == (std::numeric_limits<double>::max)()))
      return false;
  }
  return true;
}

/// The axes along which a box is long, the longest first.
constexpr void order_axes(const space_box& box, int* axes) noexcept {
  const auto half = [&](int i) { return box.high[i] * 0.5 - box.low[i] * 0.5; };
  for (int i = 0; i < 3; ++i) axes[i] = i;
  if (half(axes[1]) > half(axes[0])) std::swap(axes[0], axes[1]);
  if (half(axes[2]) > half(axes[1])) std::swap(axes[1], axes[2]);
  if (half(axes[1]) > half(axes[0])) std::swap(axes[0], axes[1]);
}

/// Some boxes, asked time and again: after the first passes over all of them they become a tree by their places, which
/// costs as much as some passes.
class IRG_APART box_tree {
public:
  /// shape   items: places among the boxes that the calls are given; a tree divides them along the first axes
  constexpr box_tree(std::vector<std::uint32_t> items, int axes) : items_(std::move(items)), axes_(axes) {}

  /// Calls use(i) for boxes that skips(box) does not skip: it skips a box round others only where it skips them.
  /// gives   how many boxes were asked
  template <class Skips, class Use>
  constexpr std::size_t each(const std::vector<space_box>& boxes, const Skips& skips, const Use& use) {
    constexpr int most = 16;
    if (passes_ < most || items_.size() <= few) {
      ++passes_;
      for (const std::uint32_t i : items_)
        if (!skips(boxes[i])) use(i);
      return items_.size();
    }
    if (nodes_.empty()) make(boxes, 0, static_cast<std::uint32_t>(items_.size()));
    std::size_t asked = 0;
    for (std::uint32_t i = 0; i < nodes_.size();) {
      const node& n = nodes_[i];
      ++asked;
      if (skips(n.bounds)) {
        i = n.after;
        continue;
      }
      for (std::uint32_t k = n.begin; k < n.end; ++k, ++asked)
        if (!skips(boxes[items_[k]])) use(items_[k]);
      ++i;
    }
    return asked;
  }

private:
  // Those below a node stand behind it, before `after`; the lowest have boxes.
  struct node {
    space_box bounds;
    std::uint32_t after, begin, end;
  };
  static constexpr std::uint32_t few = 8;

  constexpr void make(const std::vector<space_box>& boxes, std::uint32_t begin, std::uint32_t end) {
    const std::size_t here = nodes_.size();
    nodes_.push_back({no_box(), 0, begin, end - begin > few ? begin : end});
    space_box centres = no_box();
    const auto centre = [&](std::uint32_t i, int k) { return boxes[i].low[k] * 0.5 + boxes[i].high[k] * 0.5; };
    for (std::uint32_t i = begin; i < end; ++i) {
      nodes_[here].bounds.add(boxes[items_[i]]);
      centres.add(point<double, 3>{centre(items_[i], 0), centre(items_[i], 1), centre(items_[i], 2)});
    }
    if (end - begin > few) {
      const auto half = [&](int k) { return centres.high[k] * 0.5 - centres.low[k] * 0.5; };
      int axis = 0;
      for (int k = 1; k < axes_; ++k)
        if (half(k) > half(axis)) axis = k;
      const std::uint32_t middle = begin + (end - begin) / 2;
      const auto at = [&](std::uint32_t i) { return items_.begin() + static_cast<std::ptrdiff_t>(i); };
      std::nth_element(at(begin), at(middle), at(end),
                       [&](std::uint32_t i, std::uint32_t k) { return centre(i, axis) < centre(k, axis); });
      make(boxes, begin, middle);
      make(boxes, middle, end);
    }
    nodes_[here].after = static_cast<std::uint32_t>(nodes_.size());
  }

  std::vector<std::uint32_t> items_;
  int axes_, passes_ = 0;
  std::vector<node> nodes_{};
};

/// Calls use(a, b) once for every pair of boxes that meet, boxes[a] of the first lot and boxes[b] of the second.
/// cost    O(n log n) and the pairs, where boxes are told apart by halving along one axis or another, or by a tree of
///         those that are not
template <class Use>
class box_pair_search {
public:
  std::size_t looks = 0;  // boxes that were asked for their half, and pairs that were asked whether they meet

  constexpr box_pair_search(const std::vector<space_box>& boxes, const Use& use) : boxes_(boxes), use_(use) {}

  constexpr void search(const std::vector<std::uint32_t>& first, const std::vector<std::uint32_t>& second) {
    constexpr double most = (std::numeric_limits<double>::max)();
    halve(first, second, {{{-most, -most, -most}, {most, most, most}}, 0});
  }

private:
  using lot = std::vector<std::uint32_t>;
  static constexpr std::size_t few = 400;  // pairs that are looked at one by one
  static constexpr int deepest = 100;
  struct call {
    space_box cell;  // what it answers for: pairs whose common box begins in it
    int depth;
  };

  constexpr space_box box_of(const lot& l) const noexcept {
    space_box all = no_box();
    for (const std::uint32_t i : l) all.add(boxes_[i]);
    return all;
  }
  constexpr lot within(const lot& l, const space_box& region) {
    looks += l.size();
    lot kept(l.size(), 0);
    std::size_t n = 0;
    for (const std::uint32_t i : l) {
      kept[n] = i;
      n += boxes_[i].meets(region) ? 1u : 0u;
    }
    kept.resize(n, 0);
    return kept;
  }

  constexpr void halve(const lot& first, const lot& second, const call& of) {
    const space_box& cell = of.cell;
    space_box region = box_of(first);
    const space_box other = box_of(second);
    for (int i = 0; i < 3; ++i) {
      region.low[i] = greater(greater(region.low[i], other.low[i]), cell.low[i]);
      region.high[i] = lesser(lesser(region.high[i], other.high[i]), cell.high[i]);
      if (region.high[i] < region.low[i]) return;
    }
    const lot a = within(first, region), b = within(second, region);
    if (a.empty() || b.empty()) return;
    if (a.size() * b.size() > few && of.depth < deepest) {
      int axes[3]{};
      order_axes(region, axes);
      for (const int axis : axes)
        if (halve_along(axis, a, b, region, of)) return;
      return ask_tree(a, b, cell);
    }
    looks += a.size() * b.size();
    for (const std::uint32_t i : a)
      for (const std::uint32_t k : b) use_pair(i, k, cell);
  }

  // False where halving does not tell boxes apart: where nearly all are in both halves.
  constexpr bool halve_along(int axis, const lot& a, const lot& b, const space_box& region, const call& of) {
    space_box lower = of.cell, upper = of.cell;
    const double middle = region.low[axis] * 0.5 + region.high[axis] * 0.5;
    if (!(region.low[axis] < middle && middle < region.high[axis])) return false;
    lower.high[axis] = upper.low[axis] = middle;
    space_box lower_region = region, upper_region = region;
    lower_region.high[axis] = upper_region.low[axis] = middle;
    const lot a_low = within(a, lower_region), a_high = within(a, upper_region);
    const lot b_low = within(b, lower_region), b_high = within(b, upper_region);
    if ((a_low.size() + a_high.size() + b_low.size() + b_high.size()) * 2 >= (a.size() + b.size()) * 3) return false;
    halve(a_low, b_low, {lower, of.depth + 1});
    halve(a_high, b_high, {upper, of.depth + 1});
    return true;
  }

  constexpr void use_pair(std::uint32_t i, std::uint32_t k, const space_box& cell) {
    if (boxes_[i].meets(boxes_[k]) && begins_in(boxes_[i], boxes_[k], cell)) use_(i, k);
  }

  // Boxes that no middle plane tells apart, such as the faces of shells in shells: each of one lot is asked for in a
  // tree of the other.
  constexpr void ask_tree(const lot& a, const lot& b, const space_box& cell) {
    box_tree tree(b, 3);
    for (const std::uint32_t i : a)
      looks += tree.each(
          boxes_, [&](const space_box& other) { return !boxes_[i].meets(other); },
          [&](std::uint32_t k) { use_pair(i, k, cell); });
  }

  const std::vector<space_box>& boxes_;
  const Use& use_;
};

}  // namespace IRG_ABI
}  // namespace irg::detail
