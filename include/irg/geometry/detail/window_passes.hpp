// SPDX-License-Identifier: MIT
// Polygons of few plain points against a window: two passes, one per axis, over arrays on the stack. The result is that
// of polygon_pipe, in a fraction of its time. Numbers travel one by one, not as structures: copies of what was just
// written in parts would stall.
#pragma once

#include <cstddef>
#include <cstdint>
#include <type_traits>

#include <irg/geometry/attributed_point.hpp>
#include <irg/geometry/box.hpp>
#include <irg/geometry/detail/axis_crossing.hpp>
#include <irg/geometry/detail/window_codes_kernel.hpp>

namespace irg::detail {

// The longest polygon that is clipped on the stack, and what one pass may make of it.
inline constexpr std::size_t few_vertices = 64;

// Vertices between the passes, the edge of the given polygon that leaves each (-1 along the window's boundary), and
// their codes. Not initialised on purpose. Each edge leaves two at most: its start or a cut, and another cut.
template <class T>
struct passing_vertices {
  T place[2][2 * few_vertices + 4];
  std::int16_t leaves_by[2 * few_vertices + 4];
  std::uint8_t codes[2 * few_vertices + 4];
  std::size_t count;

  IRG_INLINE constexpr T at(std::size_t i, int axis) const noexcept { return place[axis][i]; }
  IRG_INLINE constexpr int edge(std::size_t i) const noexcept { return leaves_by[i]; }
  IRG_INLINE constexpr unsigned code(std::size_t i) const noexcept { return codes[i]; }
  IRG_INLINE constexpr bool has_room() const noexcept { return true; }
  // Writes a vertex behind the others, which belongs to them when `counts`.
  IRG_INLINE constexpr void put(T x, T y, int edge, unsigned code, bool counts) noexcept {
    place[0][count] = x, place[1][count] = y;
    leaves_by[count] = static_cast<std::int16_t>(edge), codes[count] = static_cast<std::uint8_t>(code);
    count += static_cast<std::size_t>(counts);
  }
  // Whether the last one stands here; it then leaves by this edge.
  IRG_INLINE constexpr bool ends_at(T x, T y, int edge) noexcept {
    if (count == 0 || place[0][count - 1] != x || place[1][count - 1] != y) return false;
    leaves_by[count - 1] = static_cast<std::int16_t>(edge);
    return true;
  }
};

// The given polygon.
template <Point P>
struct given_vertices {
  const P* points;
  const std::uint8_t* codes;
  std::size_t count;

  IRG_INLINE constexpr scalar_of<P> at(std::size_t i, int axis) const noexcept { return coordinate(points[i], axis); }
  IRG_INLINE constexpr int edge(std::size_t i) const noexcept { return static_cast<int>(i); }
  IRG_INLINE constexpr unsigned code(std::size_t i) const noexcept { return codes[i]; }
};

inline namespace IRG_ABI {

// One axis: cuts off what is beyond either boundary. False when `to` has no room. Vertices that stay are written
// without a branch, since none could be foretold.
template <int Axis, class T, class From, class P, class To>
IRG_INLINE constexpr bool pass_axis(const From& from, const given_vertices<P>& given, const box<T, 2>& window,
                                    To& to) noexcept {
  constexpr int other = 1 - Axis;
  constexpr unsigned bits = axis_bits<Axis>, other_bits = axis_bits<other>;
  const T low = window.low[Axis], high = window.high[Axis];
  const auto bound = [&](unsigned beyond) { return (beyond & below_bit<Axis>) != 0 ? low : high; };
  const auto cut = [&](std::size_t i, std::size_t j, unsigned beyond, bool leaves) {
    const int e = from.edge(i);
    T ax = from.at(i, Axis), ay = from.at(i, other), bx = from.at(j, Axis), by = from.at(j, other);
    if constexpr (!std::is_same_v<From, given_vertices<P>>)
      if (e >= 0) {
        const auto k = static_cast<std::size_t>(e), l = k + 1 < given.count ? k + 1 : 0;
        ax = given.at(k, Axis), ay = given.at(k, other), bx = given.at(l, Axis), by = given.at(l, other);
      }
    const T x = bound(beyond), y = axis_crossing_of(ax, ay, bx, by, x);
    unsigned code = from.code(i) & from.code(j) & other_bits;
    if (((from.code(i) ^ from.code(j)) & other_bits) != 0)
      code = (static_cast<unsigned>(y < window.low[other]) | static_cast<unsigned>(window.high[other] < y) << 2)
             << other;
    const T px = Axis == 0 ? x : y, py = Axis == 0 ? y : x;
    if (!to.ends_at(px, py, leaves ? -1 : e)) to.put(px, py, leaves ? -1 : e, code, true);
  };
  const std::size_t n = from.count;
  unsigned was = from.code(0) & bits;
  bool stays = was == 0;
  for (std::size_t i = 0; i < n; ++i) {
    if (!to.has_room()) return false;
    const std::size_t j = i + 1 < n ? i + 1 : 0;
    const unsigned is = from.code(j) & bits;
    const bool on = was == 0 && is != 0 && from.at(i, Axis) == bound(is);
    to.put(from.at(i, 0), from.at(i, 1), on ? -1 : from.edge(i), from.code(i), stays);
    if (on && !stays) to.ends_at(from.at(i, 0), from.at(i, 1), -1);  // it stands there already, and leaves
    stays = is == 0;
    if (was != is) {
      if (was != 0) {
        if (is != 0 || from.at(j, Axis) != bound(was))
          cut(i, j, was, false);
        else  // comes in at a vertex; not twice at one place
          stays = !to.ends_at(from.at(j, 0), from.at(j, 1), from.edge(j));
      }
      if (is != 0 && !on) cut(i, j, is, true);
    }
    was = is;
  }
  return true;
}

}  // namespace IRG_ABI
}  // namespace irg::detail
