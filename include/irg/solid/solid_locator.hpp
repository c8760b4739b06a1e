// SPDX-License-Identifier: MIT
// Many points against one body: its triangles stand in a tree of boxes as they are seen from above, so that a point
// asks the few that its ray upward may meet.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

#include <irg/core/lanes.hpp>
#include <irg/math/vec.hpp>
#include <irg/solid/point_in_solid.hpp>

namespace irg {

/// What points have asked of a body so far.
struct solid_locator_counts {
  std::uint64_t points = 0, boxes = 0, triangles = 0;  // asked; triangles / points of all are not skipped
  bool operator==(const solid_locator_counts&) const = default;
};

}  // namespace irg

namespace irg::detail {

// Eight boxes side by side, as they are seen from above with their tops, and which of them a ray upward may meet.
template <Floating T>
struct IRG_APART box_block {
  static constexpr int width = 8;
  T low[2][width], high[2][width], top[width];

  // No boxes.
  constexpr box_block() noexcept {
    constexpr T most = (std::numeric_limits<T>::max)();
    for (int i = 0; i < width; ++i) {
      low[0][i] = low[1][i] = most;
      high[0][i] = high[1][i] = top[i] = -most;
    }
  }

  IRG_INLINE constexpr void enclose(int i, T x, T y, T z) noexcept {
    low[0][i] = minimum(low[0][i], x);
    high[0][i] = maximum(high[0][i], x);
    low[1][i] = minimum(low[1][i], y);
    high[1][i] = maximum(high[1][i], y);
    top[i] = maximum(top[i], z);
  }
  // The box round all of another block becomes part of box i.
  constexpr void enclose(int i, const box_block& b) noexcept {
    for (int k = 0; k < width; ++k)
      if (b.low[0][k] <= b.high[0][k]) {
        enclose(i, b.low[0][k], b.low[1][k], b.top[k]);
        enclose(i, b.high[0][k], b.high[1][k], b.top[k]);
      }
  }
};

inline namespace IRG_ABI {

// A bit for each box that is not beside or below p.
template <class F, class T>
IRG_INLINE constexpr unsigned ask_boxes(const box_block<T>& b, const point<T, 3>& p) noexcept {
  using f = lanes<F>;
  const F x = f::broadcast(p.x), y = f::broadcast(p.y), z = f::broadcast(p.z);
  unsigned bits = 0;
  for (int k = 0; k < box_block<T>::width; k += f::count) {
    const auto in_x = both(f::load(b.low[0] + k) <= x, x <= f::load(b.high[0] + k));
    const auto in_y = both(f::load(b.low[1] + k) <= y, y <= f::load(b.high[1] + k));
    bits |= static_cast<unsigned>(mask_bits(both(both(in_x, in_y), z <= f::load(b.top + k)))) << k;
  }
  return bits;
}

template <class T>
IRG_INLINE constexpr unsigned boxes_over(const box_block<T>& b, const point<T, 3>& p) noexcept {
  if (!has_lanes || std::is_constant_evaluated()) return ask_boxes<T>(b, p);
  return ask_boxes<pack<T, minimum(box_block<T>::width, native_lanes<T>)>>(b, p);
}

}  // namespace IRG_ABI
}  // namespace irg::detail

namespace irg {

/// A body made ready for point_in_solid and winding_number of many points.
template <Floating T>
class solid_locator {
public:
  /// needs   as point_in_solid
  /// cost    sorts the triangles by place, O(n log n); allocates some 130 bytes a triangle of doubles
  template <SpaceMesh M>
    requires std::same_as<scalar_of<mesh_point<M>>, T>
  IRG_APART constexpr explicit solid_locator(const M& body) {
    detail::each_solid_triangle(triangulated(to_mesh<T>(body)), [&](const auto& a, const auto& b, const auto& c) {
      triangles_.push_back({{a, b, c}});
    });
    build();
  }

  /// winding_number of the body; counts what it asks in `counts`, where that is given.
  /// gives   as winding_number
  /// exact   as winding_number
  /// cost    some log n boxes and the triangles above and beside p; nothing allocated
  IRG_APART constexpr std::optional<int> winding_number(const point<T, 3>& p,
                                                        solid_locator_counts* counts = nullptr) const {
    const detail::upward_crossings count = cross(p, counts);
    if (count.on_surface) return std::nullopt;
    return count.winding;
  }

  /// point_in_solid of the body.
  /// gives   as point_in_solid
  /// exact   as point_in_solid
  /// cost    as winding_number
  IRG_APART constexpr location operator()(const point<T, 3>& p, fill_rule rule = fill_rule::non_zero,
                                          solid_locator_counts* counts = nullptr) const {
    return detail::location_by_winding(cross(p, counts), rule);
  }

private:
  using triangle = std::array<point<T, 3>, 3>;
  using block = detail::box_block<T>;
  static constexpr std::uint32_t width = block::width;

  [[nodiscard]] IRG_APART static constexpr T centre(const triangle& t, int axis) noexcept {
    const T a = t[0][axis] * T(0.25), b = t[1][axis] * T(0.25), c = t[2][axis] * T(0.25);
    return minimum(minimum(a, b), c) + maximum(maximum(a, b), c);
  }

  // Divides runs of triangles along the longer side of the box round them, seen from above, until they are short; the
  // first part has a power of two of them, so that eight by eight they are near each other on every level.
  IRG_APART constexpr void sort() {
    struct run {
      std::uint32_t first, last;
    };
    std::vector<run> open{{0, static_cast<std::uint32_t>(triangles_.size())}};
    while (!open.empty()) {
      const run r = open.back();
      open.pop_back();
      if (r.last - r.first <= width) continue;
      block around;
      for (std::uint32_t i = r.first; i < r.last; ++i)
        for (const point<T, 3>& q : triangles_[i]) around.enclose(0, q.x, q.y, q.z);
      const auto half = [&](int k) { return around.high[k][0] * T(0.5) - around.low[k][0] * T(0.5); };
      const int axis = half(0) < half(1) ? 1 : 0;
      const std::uint32_t middle = r.first + std::bit_floor(r.last - r.first - 1);
      const auto at = [&](std::uint32_t i) { return triangles_.begin() + static_cast<std::ptrdiff_t>(i); };
      std::nth_element(at(r.first), at(middle), at(r.last),
                       [axis](const triangle& a, const triangle& b) { return centre(a, axis) < centre(b, axis); });
      open.push_back({r.first, middle});
      open.push_back({middle, r.last});
    }
  }

  // Boxes of triangles on level 0, of the blocks of the level below on the others, up to one block.
  IRG_APART constexpr void build() {
    if (triangles_.empty()) return;
    sort();
    const auto blocks_for = [](std::size_t n) { return std::vector<block>((n + width - 1) / width, block{}); };
    levels_.push_back(blocks_for(triangles_.size()));
    for (std::size_t i = 0; i < triangles_.size(); ++i)
      for (const point<T, 3>& q : triangles_[i])
        levels_[0][i / width].enclose(static_cast<int>(i % width), q.x, q.y, q.z);
    while (levels_.back().size() > 1) {
      const std::vector<block>& below = levels_.back();
      std::vector<block> level = blocks_for(below.size());
      for (std::size_t i = 0; i < below.size(); ++i) level[i / width].enclose(static_cast<int>(i % width), below[i]);
      levels_.push_back(std::move(level));
    }
  }

  IRG_APART constexpr detail::upward_crossings cross(const point<T, 3>& p, solid_locator_counts* counts) const {
    detail::upward_crossings out;
    solid_locator_counts asked{1, 0, 0};
    struct step {
      std::uint32_t first = 0;  // of the eight below the block
      unsigned asks = 0;  // a bit for each whose box is over p
    };
    std::array<step, 12> steps{};  // 8^11 triangles are more than there can be
    std::size_t level = levels_.size();
    const auto open = [&](std::size_t at, std::uint32_t which) {
      steps[level = at] = {which * width, detail::boxes_over(levels_[at][which], p)};
      asked.boxes += width;
    };
    if (level > 0 && is_finite(p)) open(level - 1, 0);
    while (level < levels_.size() && !out.on_surface) {
      step& s = steps[level];
      if (s.asks == 0) {
        ++level;
        continue;
      }
      const std::uint32_t next = s.first + static_cast<std::uint32_t>(std::countr_zero(s.asks));
      s.asks &= s.asks - 1;
      if (level > 0) {
        open(level - 1, next);
        continue;
      }
      const triangle& t = triangles_[next];
      detail::count_upward_crossing(t[0], t[1], t[2], p, out);
      ++asked.triangles;
    }
    if (counts) {
      counts->points += asked.points;
      counts->boxes += asked.boxes;
      counts->triangles += asked.triangles;
    }
    return out;
  }

  std::vector<triangle> triangles_;
  std::vector<std::vector<block>> levels_;
};

template <SpaceMesh M>
solid_locator(const M&) -> solid_locator<scalar_of<mesh_point<M>>>;

}  // namespace irg
