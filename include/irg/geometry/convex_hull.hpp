// SPDX-License-Identifier: MIT
// The convex hull of points of the plane, every turn decided exactly: Andrew's monotone chains, in place in one array
// of indices.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>
#include <vector>

#include <irg/core/conversion.hpp>
#include <irg/core/contract.hpp>
#include <irg/geometry/orient2d.hpp>
#include <irg/geometry/polygon.hpp>

namespace irg {

/// What becomes of points that lie on a side of the hull between its corners.
enum class side_points { leave_out, keep };

namespace detail::inline IRG_ABI {

template <PlaneRing R>
class hull_builder {
public:
  constexpr hull_builder(const R& points, std::span<std::uint32_t> hull, side_points option) noexcept
      : points_(&points), hull_(hull), option_(option) {}

  constexpr std::size_t operator()() noexcept {
    const auto n = static_cast<std::uint32_t>(ring_size(*points_));
    std::uint32_t lowest = 0, highest = 0;
    for (std::uint32_t i = 1; i < n; ++i) {
      if (comes_before(at(i), at(lowest))) lowest = i;
      if (comes_before(at(highest), at(i))) highest = i;
    }
    if (n == 0) return 0;
    hull_[0] = lowest;
    if (same_place(at(lowest), at(highest))) return 1;
    find_inner(lowest, highest, n);
    const std::uint32_t upper = split(lowest, highest, n);
    const auto first = hull_.begin();
    std::sort(first + 1, first + upper - 1, [&](std::uint32_t i, std::uint32_t j) { return precedes(i, j); });
    std::sort(first + upper, first + last_, [&](std::uint32_t i, std::uint32_t j) {
      return comes_before(at(j), at(i)) || (same_place(at(i), at(j)) && i < j);
    });
    size_ = base_ = 0;
    push(lowest);
    for (std::uint32_t k = 1; k + 1 < upper; ++k) push(hull_[k]);
    push(highest);
    base_ = size_ - 1;
    for (std::uint32_t k = upper; k < last_; ++k) push(hull_[k]);
    trim(lowest);
    return size_;
  }

private:
  const R* points_;
  std::span<std::uint32_t> hull_;
  side_points option_;
  std::uint32_t size_ = 0, base_ = 0, last_ = 0;  // the chain under way is hull_[base_, size_)
  // From the lowest point to the highest, below and above the line between them: some points that stand far out.
  std::uint32_t inner_[2][5]{};

  constexpr ring_point<R> at(std::uint32_t i) const noexcept { return ring_vertex(*points_, i); }
  constexpr bool precedes(std::uint32_t i, std::uint32_t j) const noexcept {
    return comes_before(at(i), at(j)) || (i < j && same_place(at(i), at(j)));
  }

  // The points farthest out in eight directions, nearly: any will do.
  constexpr void find_inner(std::uint32_t lowest, std::uint32_t highest, std::uint32_t n) noexcept {
    for (auto& chain : inner_) {
      chain[0] = chain[1] = chain[2] = chain[3] = lowest;
      chain[4] = highest;
    }
    if constexpr (std::is_arithmetic_v<ring_scalar<R>>) {
      double farthest[6];
      for (std::uint32_t i = 0; i < n; ++i) {
        const auto p = at(i);
        const double x = widened(coordinate(p, 0)) * 0.5, y = widened(coordinate(p, 1)) * 0.5;
        const double value[6] = {-x - y, -y, x - y, y - x, y, x + y};
        for (int k = 0; k < 6; ++k)
          if (i == 0 || farthest[k] < value[k]) {
            farthest[k] = value[k];
            inner_[k / 3][1 + k % 3] = i;
          }
      }
    }
  }
  // Whether p, on that side of the line, is surely no point of the hull's boundary: it is between the line and the way
  // over two of the points far out.
  constexpr bool is_within(const ring_point<R>& p, int side) const noexcept {
    const auto& chain = inner_[side < 0 ? 0 : 1];
    if (!(coordinate(at(chain[0]), 0) < coordinate(p, 0) && coordinate(p, 0) < coordinate(at(chain[4]), 0)))
      return false;  // on the leftmost or the rightmost side, which may be upright
    for (int k = 1; k < 5; ++k) {
      const auto u = at(chain[k - 1]), v = at(chain[k]);
      if (coordinate(v, 0) < coordinate(p, 0)) continue;
      return !(coordinate(p, 0) < coordinate(u, 0)) && orient2d(u, v, p) == -side;
    }
    return false;
  }

  // Puts the points below the line from the lowest to the highest at 1 and on and, behind a place for the highest,
  // those above; points on the line belong above if there is anything below. Returns where those above begin.
  constexpr std::uint32_t split(std::uint32_t lowest, std::uint32_t highest, std::uint32_t n) noexcept {
    const auto low = at(lowest), high = at(highest);
    std::uint32_t below = 1, above = n;  // [1, below) and [above, n)
    bool on_line = false;
    for (std::uint32_t i = 0; i < n; ++i) {
      const auto p = at(i);
      const int side = orient2d(low, high, p);
      if (side != 0 && is_within(p, side)) continue;
      if (side < 0) hull_[below++] = i;
      on_line = on_line || (side == 0 && !same_place(p, low) && !same_place(p, high));
      if (side > 0) hull_[--above] = i;
    }
    const std::uint32_t under = below;
    if (on_line && option_ == side_points::keep)
      for (std::uint32_t i = 0; i < n; ++i) {
        const auto p = at(i);
        if (orient2d(low, high, p) != 0 || same_place(p, low) || same_place(p, high)) continue;
        hull_[under == 1 ? below++ : --above] = i;
      }
    last_ = below + 1;
    for (std::uint32_t k = above; k < n; ++k) hull_[last_++] = hull_[k];
    return below + 1;
  }

  constexpr void push(std::uint32_t i) noexcept {
    if (size_ > base_ && same_place(at(hull_[size_ - 1]), at(i))) return;
    trim(i);
    hull_[size_++] = i;
  }
  // Takes the points off the chain that the way to i leaves on its left or, unless kept, passes through.
  constexpr void trim(std::uint32_t i) noexcept {
    const auto p = at(i);
    while (size_ >= base_ + 2) {
      const int turn = orient2d(at(hull_[size_ - 2]), at(hull_[size_ - 1]), p);
      if (turn > 0 || (turn == 0 && option_ == side_points::keep)) return;
      --size_;
    }
  }
};

}  // namespace detail::inline IRG_ABI

inline namespace IRG_ABI {

/// The corners of the convex hull, as indices of the points, counter-clockwise (y up) from the point of least x (of
/// these, of least y); returns how many. They stand at the front of `hull`.
/// shape   of points that coincide the one of least index; with side_points::keep, those on the sides in their order,
///         too. One place gives one index, points on a line give the two ends (with keep, all from end to end)
/// needs   finite coordinates; hull.size() >= the number of points, which is below 2^32. What stands behind the result
///         in `hull` is overwritten
/// exact   for all finite floats and all integers; other scalars: as exact as their own + - * are
/// cost    O(n log n), of which sorting is most; nothing allocates
/// source  Andrew 1979; Akl and Toussaint 1978 (points within a polygon of eight far ones are left out first)
template <PlaneRing R>
constexpr std::size_t convex_hull(const R& points, std::span<std::uint32_t> hull,
                                  side_points option = side_points::leave_out) noexcept {
  IRG_EXPECTS(hull.size() >= ring_size(points));
  return detail::hull_builder<R>(points, hull, option)();
}

/// The corners of the convex hull, as above.
/// gives   no index for no points, and when a coordinate is NaN or infinite
template <PlaneRing R>
[[nodiscard]] constexpr std::vector<std::uint32_t> convex_hull(const R& points,
                                                               side_points option = side_points::leave_out) {
  std::vector<std::uint32_t> hull(is_finite(points) ? ring_size(points) : 0, 0u);
  if (!hull.empty()) hull.resize(convex_hull(points, std::span<std::uint32_t>(hull), option));
  return hull;
}

}  // namespace IRG_ABI
}  // namespace irg
