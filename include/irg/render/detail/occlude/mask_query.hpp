// SPDX-License-Identifier: MIT
// Questions to masks: the rectangle of pixels that a box could touch, and the squares that such a rectangle meets.
#pragma once

#include <cstdint>
#include <limits>

#include <irg/geometry/box.hpp>
#include <irg/math/mat.hpp>
#include <irg/raster/triangle_coverage.hpp>
#include <irg/raster/window.hpp>

namespace irg::detail {

// Where a box is on the screen: the pixels that it could touch, and a key that nothing in it exceeds.
enum class mask_place { on_screen, outside, before_the_eye };
struct mask_rectangle {
  mask_place where = mask_place::outside;
  cell_window pixels;
  float key = 0;
};

inline namespace IRG_ABI {

// The squares of `size` x `size` pixels that a window meets, by column and row.
// needs   a window that is not empty and begins at no negative pixel
IRG_INLINE constexpr cell_window squares_of(const cell_window& w, int size) noexcept {
  return {w.x_first / size, w.y_first / size, (w.x_last - 1) / size + 1, (w.y_last - 1) / size + 1};
}

// Whether found(part, column, row) says so of a square, `part` being what of it lies in the window.
template <class Found>
IRG_INLINE constexpr bool any_square(const cell_window& w, int size, const Found& found) {
  const cell_window squares = squares_of(w, size);
  for (int y = squares.y_first; y < squares.y_last; ++y)
    for (int x = squares.x_first; x < squares.x_last; ++x)
      if (found(intersect(w, {x * size, y * size, (x + 1) * size, (y + 1) * size}), x, y)) return true;
  return false;
}

// A number and how far rounding may have taken it from what it stands for.
template <class T>
struct mask_interval {
  T low, high;
};

// The quotients of the numbers of an interval and those of a positive one.
template <class T>
IRG_INLINE constexpr mask_interval<T> divide_interval(const mask_interval<T>& a, const mask_interval<T>& w) noexcept {
  return {a.low / (a.low < T(0) ? w.low : w.high), a.high / (a.high < T(0) ? w.high : w.low)};
}

// A coordinate on the screen in 1/256 pixel, kept near the picture and moved outwards by what projecting and snapping a
// vertex may amount to: half a step, and 2^15 pixels times some roundings of a float.
template <class T>
IRG_INLINE constexpr std::int32_t mask_coordinate(const T& v, int size, std::int32_t outwards) noexcept {
  return snap(clamped(v, T(-1), static_cast<T>(size + 1))) + outwards;
}

// The rectangle of a box. All that lies in the box and is projected by the same matrix in T lands in it.
template <class T>
constexpr mask_rectangle project_box(const box<T, 3>& b, const mat<T, 4, 4>& to_clip, int width, int height,
                                     float sign) noexcept {
  constexpr T unit = std::numeric_limits<T>::epsilon();
  if (b.low.x > b.high.x || b.low.y > b.high.y || b.low.z > b.high.z) return {};
  for (int k = 0; k < 3; ++k)
    if (!(b.low[k] >= std::numeric_limits<T>::lowest() && b.high[k] <= (std::numeric_limits<T>::max)()))
      return {mask_place::before_the_eye, {}, 0};
  // A row's sum has four roundings of half a unit, both here and for what lies in the box.
  const auto absolute = [](const T& v) { return v < T(0) ? -v : v; };
  T slack[4]{};
  for (int r = 0; r < 4; ++r) {
    T sum = absolute(to_clip(r, 3));
    for (int k = 0; k < 3; ++k)
      sum = sum + product(absolute(to_clip(r, k)), maximum(absolute(b.low[k]), absolute(b.high[k])));
    slack[r] = product(sum, T(8) * unit);
  }
  const T infinity = std::numeric_limits<T>::infinity();
  mask_interval<T> x{infinity, -infinity}, y = x, z = x;
  bool beyond[6] = {true, true, true, true, true, true}, before = false;
  for (int i = 0; i < 8; ++i) {
    const point<T, 3> corner{(i & 1) != 0 ? b.high.x : b.low.x, (i & 2) != 0 ? b.high.y : b.low.y,
                             (i & 4) != 0 ? b.high.z : b.low.z};
    const hpoint<T, 3> p = to_clip * corner;
    const mask_interval<T> px{p.x - slack[0], p.x + slack[0]}, py{p.y - slack[1], p.y + slack[1]},
        pz{p.z - slack[2], p.z + slack[2]}, pw{p.w - slack[3], p.w + slack[3]};
    const bool behind[6] = {pw.high + px.high < T(0), pw.high - px.low < T(0), pw.high + py.high < T(0),
                            pw.high - py.low < T(0),  pw.high - pz.low < T(0), pz.high < T(0)};
    for (int k = 0; k < 6; ++k) beyond[k] = beyond[k] && behind[k];
    // What the near plane cuts, and what is not a number.
    if (!(pw.low > T(0)) || !(sign > 0 ? pz.low <= pw.high : pz.high >= T(0))) {
      before = true;
      continue;
    }
    const auto widen = [&](mask_interval<T>& all, const mask_interval<T>& v) {
      const mask_interval<T> q = divide_interval(v, pw);
      if (!(q.low >= -infinity && q.high <= infinity)) before = true;
      all = {minimum(all.low, q.low), maximum(all.high, q.high)};
    };
    widen(x, px);
    widen(y, py);
    widen(z, pz);
  }
  for (const bool all : beyond)
    if (all) return {};
  if (before) return {mask_place::before_the_eye, {}, 0};

  const T half_width = static_cast<T>(width) / T(2), half_height = static_cast<T>(height) / T(2);
  constexpr std::int32_t outwards = 8;
  const cell_window pixels{first_centre(mask_coordinate(product(x.low, half_width) + half_width, width, -outwards)),
                           first_centre(mask_coordinate(half_height - product(y.high, half_height), height, -outwards)),
                           last_centre(mask_coordinate(product(x.high, half_width) + half_width, width, outwards)),
                           last_centre(mask_coordinate(half_height - product(y.low, half_height), height, outwards))};
  const cell_window seen = intersect(pixels, {0, 0, width, height});
  if (seen.empty()) return {};
  // The nearest depth, and some roundings of T and of a float.
  const float key = product(static_cast<float>(sign > 0 ? z.high : z.low), sign);
  return {mask_place::on_screen, seen, key + (product(key < 0 ? -key : key, 0x1p-20f) + 0x1p-140f)};
}

}  // namespace IRG_ABI
}  // namespace irg::detail
