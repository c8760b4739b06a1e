// SPDX-License-Identifier: MIT
// Points in the order of their directions from a source, counter-clockwise from that of the x axis, exactly. Rounded
// angles sort most of them; orient2d decides among those that rounding may have mixed up.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <irg/core/conversion.hpp>
#include <irg/geometry/orient2d.hpp>
#include <irg/math/vec.hpp>

namespace irg::detail::inline IRG_ABI {

// Whether p lies below the source, or straight to the left of it: in the second half of the turn.
template <Floating T>
constexpr bool is_in_second_half(const point<T, 2>& source, const point<T, 2>& p) noexcept {
  return p.y < source.y || (p.y == source.y && p.x < source.x);
}

// Whether the direction to p comes before that to r. Neither is the source.
template <Floating T>
constexpr bool points_before(const point<T, 2>& source, const point<T, 2>& p, const point<T, 2>& r) noexcept {
  const bool late = is_in_second_half(source, p), later = is_in_second_half(source, r);
  return late != later ? later : orient2d(source, p, r) > 0;
}

// A number from 0 to 4 that grows with the direction to p and is off by less than 2^-48; -1 where that cannot be had.
// What is lost of differences that are subnormal is less than 2^-120 of the sum.
template <Floating T>
constexpr double rough_turn(const point<T, 2>& source, const point<T, 2>& p) noexcept {
  constexpr double most = 0x1p1000, least = 0x1p-900;
  const double x = widened(p.x), y = widened(p.y), from_x = widened(source.x), from_y = widened(source.y);
  for (const double v : {x, y, from_x, from_y})
    if (!(-most < v && v < most)) return -1;
  const double dx = x - from_x, dy = y - from_y, width = dx < 0 ? -dx : dx, height = dy < 0 ? -dy : dy;
  const double sum = width + height;
  if (sum < least) return -1;
  if (from_x < x && !(y < from_y)) return height / sum;
  if (from_y < y) return 1 + width / sum;
  if (x < from_x) return 2 + height / sum;
  return 3 + width / sum;
}

template <Floating T>
struct directions {
  std::vector<std::uint32_t> rank{};   // of each point: those in one direction have the same
  std::vector<std::uint32_t> order{};  // the points by rank
  std::vector<std::uint32_t> first{};  // the first place in `order` of each rank
};

template <Floating T>
struct turned_point {
  double turn;
  std::uint32_t index;
};

// Sorts by the rounded turn: into as many drawers as there are points, then each drawer.
template <Floating T>
constexpr void sort_by_turn(std::vector<turned_point<T>>& list) {
  const std::size_t n = list.size();
  const double scale = static_cast<double>(n) / 4;
  const auto drawer = [&](const turned_point<T>& p) {
    return minimum(static_cast<std::size_t>(p.turn * scale), n - 1);
  };
  std::vector<std::size_t> begin(n + 1, std::size_t{0});
  for (const auto& p : list) ++begin[drawer(p) + 1];
  for (std::size_t i = 0; i < n; ++i) begin[i + 1] += begin[i];
  std::vector<turned_point<T>> sorted(n, turned_point<T>{0, 0});
  for (const auto& p : list) sorted[begin[drawer(p)]++] = p;
  for (std::size_t i = 0, from = 0; i < n; from = begin[i++])
    if (begin[i] - from > 1)
      std::sort(sorted.begin() + static_cast<std::ptrdiff_t>(from),
                sorted.begin() + static_cast<std::ptrdiff_t>(begin[i]),
                [](const auto& p, const auto& r) { return p.turn < r.turn; });
  list.swap(sorted);
}

// The order of the directions from the source to the points; none of them is the source.
template <Floating T>
constexpr directions<T> ordered_directions(const point<T, 2>& source, const std::vector<point<T, 2>>& points) {
  constexpr double in_doubt = 0x1p-46;
  const std::size_t n = points.size();
  std::vector<turned_point<T>> list(n, turned_point<T>{0, 0});
  bool sure = true;
  for (std::size_t i = 0; i < n; ++i) {
    list[i] = {rough_turn(source, points[i]), static_cast<std::uint32_t>(i)};
    sure = sure && list[i].turn >= 0;
  }
  if (!sure)
    for (auto& p : list) p.turn = 0;
  if (n > 1) sort_by_turn(list);
  directions<T> out;
  out.rank.resize(n, 0u);
  out.order.resize(n, 0u);
  const auto place = [&](const turned_point<T>& p) -> const point<T, 2>& { return points[p.index]; };
  for (std::size_t i = 0, end = 0; i < n; i = end) {
    for (end = i + 1; end < n && list[end].turn - list[end - 1].turn <= in_doubt;) ++end;
    if (end - i > 1)
      std::sort(list.begin() + static_cast<std::ptrdiff_t>(i), list.begin() + static_cast<std::ptrdiff_t>(end),
                [&](const auto& p, const auto& r) { return points_before(source, place(p), place(r)); });
    for (std::size_t k = i; k < end; ++k) {
      if (k == i || points_before(source, place(list[k - 1]), place(list[k])))
        out.first.push_back(static_cast<std::uint32_t>(k));
      out.rank[list[k].index] = static_cast<std::uint32_t>(out.first.size() - 1);
      out.order[k] = list[k].index;
    }
  }
  return out;
}

}  // namespace irg::detail::inline IRG_ABI
