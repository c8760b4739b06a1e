// SPDX-License-Identifier: MIT
// Pairs of boxes that meet, one of each of two lots: both lots are halved together, and a half without boxes of one of
// them is done with. So only what is near both costs more than a look.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include <irg/core/scalar.hpp>
#include <irg/math/vec.hpp>

namespace irg::detail {

/// A box along the axes.
struct IRG_APART space_box {
  double low[3], high[3];

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

/// Calls use(a, b) once for every pair of boxes that meet, boxes[a] of the first lot and boxes[b] of the second.
template <class Use>
class box_pair_search {
public:
  constexpr box_pair_search(const std::vector<space_box>& boxes, const Use& use) : boxes_(boxes), use_(use) {}

  constexpr void search(const std::vector<std::uint32_t>& first, const std::vector<std::uint32_t>& second) {
    constexpr double most = (std::numeric_limits<double>::max)();
    halve(first, second, {{-most, -most, -most}, {most, most, most}}, 0);
  }

private:
  using lot = std::vector<std::uint32_t>;
  static constexpr std::size_t few = 400;  // pairs that are looked at one by one
  static constexpr int deepest = 100;

  constexpr space_box box_of(const lot& l) const noexcept {
    space_box all = no_box();
    for (const std::uint32_t i : l) all.add(boxes_[i]);
    return all;
  }
  constexpr lot within(const lot& l, const space_box& region) const {
    lot kept;
    kept.reserve(l.size());
    for (const std::uint32_t i : l)
      if (boxes_[i].meets(region)) kept.push_back(i);
    return kept;
  }

  // `cell` is what this call answers for: pairs whose common box begins in it.
  constexpr void halve(const lot& first, const lot& second, const space_box& cell, int depth) {
    space_box region = box_of(first);
    const space_box other = box_of(second);
    for (int i = 0; i < 3; ++i) {
      region.low[i] = greater(greater(region.low[i], other.low[i]), cell.low[i]);
      region.high[i] = lesser(lesser(region.high[i], other.high[i]), cell.high[i]);
      if (region.high[i] < region.low[i]) return;
    }
    const lot a = within(first, region), b = within(second, region);
    if (a.empty() || b.empty()) return;
    int axis = 0;
    for (int i = 1; i < 3; ++i)
      if (region.high[i] * 0.5 - region.low[i] * 0.5 > region.high[axis] * 0.5 - region.low[axis] * 0.5) axis = i;
    space_box lower = cell, upper = cell;
    const double middle = region.low[axis] * 0.5 + region.high[axis] * 0.5;
    lower.high[axis] = upper.low[axis] = middle;
    space_box lower_region = region, upper_region = region;
    lower_region.high[axis] = upper_region.low[axis] = middle;
    if (a.size() * b.size() > few && depth < deepest && region.low[axis] < middle && middle < region.high[axis]) {
      const lot a_low = within(a, lower_region), a_high = within(a, upper_region);
      const lot b_low = within(b, lower_region), b_high = within(b, upper_region);
      // Boxes that are nearly all on both sides are not told apart by halving.
      if ((a_low.size() + a_high.size() + b_low.size() + b_high.size()) * 2 < (a.size() + b.size()) * 3) {
        halve(a_low, b_low, lower, depth + 1);
        halve(a_high, b_high, upper, depth + 1);
        return;
      }
    }
    for (const std::uint32_t i : a)
      for (const std::uint32_t k : b)
        if (boxes_[i].meets(boxes_[k]) && begins_in(boxes_[i], boxes_[k], cell)) use_(i, k);
  }

  // Cells have their lower side, the last one its upper one, too.
  static constexpr bool begins_in(const space_box& a, const space_box& b, const space_box& cell) noexcept {
    for (int i = 0; i < 3; ++i) {
      const double begin = greater(a.low[i], b.low[i]);
      if (begin < cell.low[i] || !(begin < cell.high[i] || cell.high[i] == (std::numeric_limits<double>::max)()))
        return false;
    }
    return true;
  }

  const std::vector<space_box>& boxes_;
  const Use& use_;
};

}  // namespace IRG_ABI
}  // namespace irg::detail
