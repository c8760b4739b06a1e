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

  bool operator==(const space_box&) const = default;

  constexpr void add(const point<double, 3>& p) noexcept {
    for (int i = 0; i < 3; ++i) {
      low[i] = minimum(low[i], p[i]);
      high[i] = maximum(high[i], p[i]);
    }
  }
  constexpr void add(const space_box& b) noexcept {
    for (int i = 0; i < 3; ++i) {
      low[i] = minimum(low[i], b.low[i]);
      high[i] = maximum(high[i], b.high[i]);
    }
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
    const double begin = maximum(a.low[i], b.low[i]);
    if (begin < cell.low[i] || !(begin < cell.high[i] || cell.high[i] == (std::numeric_limits<double>::max)()))
      return false;
  }
  return true;
}

/// Whether nothing of a box is above p, nor above any point within `slack` of it.
constexpr bool is_off_ray_upward(const space_box& box, const point<double, 3>& p, double slack) noexcept {
  return p.x + slack < box.low[0] || box.high[0] < p.x - slack || p.y + slack < box.low[1] ||
         box.high[1] < p.y - slack || box.high[2] < p.z - slack;
}

/// The halves of a box on either side of a place along an axis; false where the box is not on both sides of it.
constexpr bool halve_box(const space_box& box, int axis, double at, space_box (&halves)[2]) noexcept {
  if (!(box.low[axis] < at && at < box.high[axis])) return false;
  halves[0] = halves[1] = box;
  halves[0].high[axis] = halves[1].low[axis] = at;
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

  constexpr const std::vector<std::uint32_t>& items() const noexcept { return items_; }

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

/// Places among boxes.
using box_lot = std::vector<std::uint32_t>;

/// Narrows a region to what the boxes of a lot leave of it; false where that is nothing.
constexpr bool narrow_region(space_box& region, const std::vector<space_box>& boxes, const box_lot& lot) noexcept {
  space_box all = no_box();
  for (const std::uint32_t i : lot) all.add(boxes[i]);
  for (int i = 0; i < 3; ++i) {
    region.low[i] = maximum(region.low[i], all.low[i]);
    region.high[i] = minimum(region.high[i], all.high[i]);
    if (region.high[i] < region.low[i]) return false;
  }
  return true;
}

/// Those of a lot that keep(i) keeps. Adds to looks how many were asked.
template <class Keep>
constexpr box_lot those_of(const box_lot& lot, std::size_t& looks, const Keep& keep) {
  looks += lot.size();
  box_lot kept(lot.size(), 0);
  std::size_t n = 0;
  for (const std::uint32_t i : lot) {
    kept[n] = i;
    n += keep(i) ? 1u : 0u;
  }
  kept.resize(n, 0);
  return kept;
}

/// Calls use(i, k) for the boxes i of a lot and k of another that meet, where no plane tells them apart: each of one
/// lot is asked for in a tree of the other. Adds to looks how many were asked.
template <class Use>
constexpr void pair_by_tree(const std::vector<space_box>& boxes, const box_lot& a, const box_lot& b, std::size_t& looks,
                            const Use& use) {
  box_tree tree(b, 3);
  for (const std::uint32_t i : a)
    looks += tree.each(
        boxes, [&](const space_box& other) { return !boxes[i].meets(other); }, [&](std::uint32_t k) { use(i, k); });
}

/// Calls use(a, b) once for every pair of boxes that meet, boxes[a] of the first lot and boxes[b] of the second.
/// cost    O(n log n) and the pairs, where boxes are told apart by halving along one axis or another, or by a tree of
///         those that are not, such as the faces of shells in shells
template <class Use>
class box_pair_search {
public:
  std::size_t looks = 0;  // boxes that were asked for their half, and pairs that were asked whether they meet

  constexpr box_pair_search(const std::vector<space_box>& boxes, const Use& use) : boxes_(boxes), use_(use) {}

  constexpr void search(const box_lot& first, const box_lot& second) {
    constexpr double most = (std::numeric_limits<double>::max)();
    halve(first, second, {{{-most, -most, -most}, {most, most, most}}, 0});
  }

private:
  static constexpr std::size_t few = 400;  // pairs that are looked at one by one
  static constexpr int deepest = 100;
  struct call {
    space_box cell;  // what it answers for: pairs whose common box begins in it
    int depth;
  };

  constexpr box_lot within(const box_lot& l, const space_box& region) {
    return those_of(l, looks, [&](std::uint32_t i) { return boxes_[i].meets(region); });
  }

  constexpr void halve(const box_lot& first, const box_lot& second, const call& of) {
    space_box region = of.cell;
    if (!narrow_region(region, boxes_, first) || !narrow_region(region, boxes_, second)) return;
    const box_lot a = within(first, region), b = within(second, region);
    if (a.empty() || b.empty()) return;
    const auto use = [&](std::uint32_t i, std::uint32_t k) {
      if (boxes_[i].meets(boxes_[k]) && begins_in(boxes_[i], boxes_[k], of.cell)) use_(i, k);
    };
    if (a.size() * b.size() > few && of.depth < deepest) {
      int axes[3]{};
      order_axes(region, axes);
      for (const int axis : axes)
        if (halve_along(axis, a, b, region, of)) return;
      return pair_by_tree(boxes_, a, b, looks, use);
    }
    looks += a.size() * b.size();
    for (const std::uint32_t i : a)
      for (const std::uint32_t k : b) use(i, k);
  }

  // False where halving does not tell boxes apart: where nearly all are in both halves.
  constexpr bool halve_along(int axis, const box_lot& a, const box_lot& b, const space_box& region, const call& of) {
    space_box regions[2], cells[2];
    const double middle = region.low[axis] * 0.5 + region.high[axis] * 0.5;
    if (!halve_box(region, axis, middle, regions) || !halve_box(of.cell, axis, middle, cells)) return false;
    const box_lot of_a[] = {within(a, regions[0]), within(a, regions[1])};
    const box_lot of_b[] = {within(b, regions[0]), within(b, regions[1])};
    const std::size_t both = of_a[0].size() + of_a[1].size() + of_b[0].size() + of_b[1].size();
    if (both * 2 >= (a.size() + b.size()) * 3) return false;
    for (int i = 0; i < 2; ++i) halve(of_a[i], of_b[i], {cells[i], of.depth + 1});
    return true;
  }

  const std::vector<space_box>& boxes_;
  const Use& use_;
};

}  // namespace IRG_ABI
}  // namespace irg::detail
