// SPDX-License-Identifier: MIT
// Escape time: how many steps of a map z -> f(z) it takes to leave a disc about the origin. With f(z) = z^2 + c it is
// what pictures of the Mandelbrot set and of Julia sets show.
//
//   k = -1;  do { k = k + 1; z = f(z) } while |z| < radius and k < most
#pragma once

#include <bit>
#include <concepts>
#include <cstdint>
#include <limits>

#include <irg/core/contraction.hpp>
#include <irg/math/sqrt.hpp>
#include <irg/math/vec.hpp>

namespace irg {

/// A step of an orbit in the complex plane; a point is the number x + iy.
template <class F, class T>
concept ComplexMap = Floating<T> && requires(const F& f, const point<T, 2>& z) {
  { f(z) } -> std::convertible_to<point<T, 2>>;
};

/// When an orbit ends: outside of the disc, or after so many steps.
template <Floating T>
struct escape_limit {
  T square;  // |z| < radius just where |z|^2, rounded, is less than this
  int most;
  bool operator==(const escape_limit&) const = default;
};

/// Where an orbit ended.
template <Floating T>
struct escape_end {
  int count;
  point<T, 2> z;  // the last point: outside of the disc, or still within it after `most` steps
  bool operator==(const escape_end&) const = default;
};

namespace detail::inline IRG_ABI {

// The number after and before x >= 0 (before: x > 0).
template <class T>
constexpr T neighbour_of(T x, int direction) noexcept {
  using bits = std::conditional_t<sizeof(T) == 4, std::int32_t, std::int64_t>;
  return std::bit_cast<T>(static_cast<bits>(std::bit_cast<bits>(x) + direction));
}

// x^2 + y^2, each product and the sum rounded.
template <class F>
IRG_INLINE constexpr F squared_size(const F& x, const F& y) noexcept {
  return product(x, x) + product(y, y);
}

}  // namespace detail::inline IRG_ABI

inline namespace IRG_ABI {

/// The limit of orbits that stay within |z| < radius for at most `most` steps.
/// needs   most >= 0
/// gives   for a radius that is not positive, or NaN, a limit that every orbit exceeds at once
/// exact   |z|^2 < square decides as sqrt(|z|^2) < radius does, both rounded: no root is needed in the loop
template <Floating T>
[[nodiscard]] constexpr escape_limit<T> make_escape_limit(T radius, int most) noexcept {
  IRG_EXPECTS(most >= 0);
  constexpr T large = sizeof(T) == 4 ? T(0x1p60f) : T(0x1p500), down = T(1) / (large / T(0x1p20));
  if (!(T(0) < radius)) return {T(0), most};
  if (large * (sizeof(T) == 4 ? T(0x1p5f) : T(0x1p13)) < radius) return {std::numeric_limits<T>::infinity(), most};
  const T scale = large < radius ? down : T(1), r = radius * scale;
  T square = product(r, r);
  while (sqrt(square) < r) square = detail::neighbour_of(square, 1);
  while (T(0) < square && !(sqrt(detail::neighbour_of(square, -1)) < r)) square = detail::neighbour_of(square, -1);
  if (scale == T(1)) return {square, most};
  constexpr T most_scaled = (std::numeric_limits<T>::max)() * down * down;
  return {most_scaled < square ? std::numeric_limits<T>::infinity() : square / down / down, most};
}

/// The orbit of z under a map until it leaves the disc or has taken so many steps, and where that was.
/// gives   a count from 0 to most; `most` also for an orbit that leaves just then. An orbit that becomes NaN has left
/// exact   the map's own rounding; counts are those of the loop in this header's first lines
/// cost    at most `most` steps; nothing is allocated
/// source  Mihajlovic 2016, chapter 8
template <Floating T, ComplexMap<T> F>
[[nodiscard]] constexpr escape_end<T> escape_orbit(const F& f, point<T, 2> z, const escape_limit<T>& limit) {
  for (int k = 0; k < limit.most; ++k) {
    z = f(z);
    if (!(detail::squared_size(z.x, z.y) < limit.square)) return {k, z};
  }
  return {limit.most, z};
}

/// How many steps the orbit of z takes.
/// gives   as escape_orbit
template <Floating T, ComplexMap<T> F>
[[nodiscard]] constexpr int escape_count(const F& f, const point<T, 2>& z, const escape_limit<T>& limit) {
  return escape_orbit(f, z, limit).count;
}

}  // namespace IRG_ABI
}  // namespace irg
