// SPDX-License-Identifier: MIT
// What depth sort's list holds: polygons and the parts of those that were split, which of them hide each other by the
// five tests, and how a plane splits one. depth_sort.hpp has the list.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <irg/geometry/box.hpp>
#include <irg/hidden/textbook/newell_tests.hpp>
#include <irg/hidden/textbook/split_by_plane.hpp>

namespace irg::textbook {

/// A polygon, or a part of one, in the order of drawing.
template <Floating T>
struct depth_sorted_polygon {
  std::vector<point<T, 3>> corners{};
  std::uint32_t number = 0;  // of the polygon, counted from 0
  bool operator==(const depth_sorted_polygon&) const = default;
};

/// The same in the list.
template <Floating T>
struct depth_sort_part {
  depth_sorted_polygon<T> polygon{};
  visible_plane<T> plane{};  // of the whole polygon
  T farthest = 0, nearest = 0;
  std::vector<std::pair<std::uint32_t, int>> cuts{};  // by the planes of which polygons, and on which side it lies
  std::uint32_t made = 0;  // as which of all polygons and parts
  std::vector<std::uint32_t> let_pass{};  // those of them that it does not hide but for roundings
  bool moved = false;
  bool operator==(const depth_sort_part&) const = default;
};

/// The parts that are left, what is drawn first at the end, and how many were made.
template <Floating T>
struct depth_sort_list {
  std::vector<depth_sort_part<T>> parts{};
  std::uint32_t made = 0;
  bool operator==(const depth_sort_list&) const = default;
};

inline namespace IRG_ABI {

/// A polygon, or a part of one, with its depths.
template <Floating T>
[[nodiscard]] constexpr depth_sort_part<T> make_part(const std::vector<point<T, 3>>& corners, std::uint32_t number,
                                                     const visible_plane<T>& plane, std::uint32_t made) {
  const auto box = bounding_box(corners);
  return {{corners, number}, plane, box.low.z, box.high.z, {}, made};
}

/// Whether a part has corners on a side of the plane of another's polygon. What that plane cut lies on one side of it,
/// whatever its rounded points say.
template <Floating T>
[[nodiscard]] constexpr bool reaches(const depth_sort_part<T>& p, const depth_sort_part<T>& other, int side) {
  for (const auto& [number, its_side] : p.cuts)
    if (number == other.polygon.number) return its_side == side;
  return has_corner_on(p.polygon.corners, other.plane, side);
}

/// Whether P does not hide Q: their depths are apart, or one of the five tests says so.
template <Floating T>
[[nodiscard]] constexpr bool does_not_hide(const depth_sort_part<T>& p, const depth_sort_part<T>& q) {
  const auto by = [&](newell_step test) { return does_not_hide_by(test, p.polygon.corners, q.polygon.corners); };
  return p.nearest <= q.farthest || p.polygon.number == q.polygon.number ||
         std::find(p.let_pass.begin(), p.let_pass.end(), q.made) != p.let_pass.end() || by(newell_step::x_apart) ||
         by(newell_step::y_apart) || (q.plane.up != 0 && !reaches(p, q, 1)) ||
         (p.plane.up != 0 && !reaches(q, p, -1)) || by(newell_step::projections_apart);
}

/// Splits a part by the plane of another's polygon; both halves go where their farthest corners belong in the list.
/// gives   false, and nothing done, where that plane does not cut it
template <Floating T>
[[nodiscard]] constexpr bool split_part(depth_sort_list<T>& list, std::size_t cut, std::size_t by) {
  const depth_sort_part<T> whole = list.parts[cut], other = list.parts[by];
  if (other.polygon.number == whole.polygon.number || !reaches(whole, other, 1) || !reaches(whole, other, -1))
    return false;
  list.parts.erase(list.parts.begin() + static_cast<std::ptrdiff_t>(cut));
  for (const int side : {1, -1}) {
    depth_sort_part<T> half = make_part(part_on_side(whole.polygon.corners, other.plane, side), whole.polygon.number,
                                        whole.plane, list.made++);
    half.cuts = whole.cuts;
    half.cuts.push_back({other.polygon.number, side});
    const auto is_nearer = [](const auto& p, const auto& q) { return p.farthest > q.farthest; };
    list.parts.insert(std::lower_bound(list.parts.begin(), list.parts.end(), half, is_nearer), half);
  }
  return true;
}

}  // namespace IRG_ABI
}  // namespace irg::textbook
