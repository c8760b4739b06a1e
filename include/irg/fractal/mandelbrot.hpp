// SPDX-License-Identifier: MIT
// The Mandelbrot set: the numbers c whose orbit 0, c, c^2 + c, ... stays bounded.
#pragma once

#include <irg/fractal/escape_time.hpp>

namespace irg {

/// The map z -> z^2 + c.
/// exact   (x*x - y*y + c.x, 2*x*y + c.y), each operation rounded on its own
template <Floating T>
struct square_plus {
  point<T, 2> c;

  IRG_INLINE constexpr point<T, 2> operator()(const point<T, 2>& z) const noexcept {
    return {product(z.x, z.x) - product(z.y, z.y) + c.x, product(z.x + z.x, z.y) + c.y};
  }
  bool operator==(const square_plus&) const = default;
};

/// Parts of the Mandelbrot set whose points are known to stay bounded: c within them needs no orbit.
enum class mandelbrot_part { cardioid, disc, elsewhere };

namespace detail::inline IRG_ABI {

// How far inside its border a point of the cardioid or of the disc has to be to be told by a formula: rounding, of the
// formula and of the orbit, is far less.
inline constexpr double interior_margin = 0x1p-20;

// Negative within the cardioid: with q = |c - 1/4|^2, q (q + (x - 1/4)) < y^2 / 4.
template <class F>
IRG_INLINE constexpr F outside_cardioid(const F& x, const F& y) noexcept {
  using f = lanes<F>;
  using T = typename f::scalar;
  const F a = x - f::broadcast(T(0.25)), yy = product(y, y), q = product(a, a) + yy;
  return product(q, q + a) - product(yy, f::broadcast(T(0.25)));
}
// Negative within the disc of radius 1/4 about -1.
template <class F>
IRG_INLINE constexpr F outside_disc(const F& x, const F& y) noexcept {
  using f = lanes<F>;
  using T = typename f::scalar;
  const F a = x + f::broadcast(T(1));
  return product(a, a) + product(y, y) - f::broadcast(T(0.0625));
}

}  // namespace detail::inline IRG_ABI

inline namespace IRG_ABI {

/// Whether c lies in the main cardioid or the disc of period 2, at least 2^-20 within by the formula of each.
/// exact   no point outside of them is said to be inside
template <Floating T>
[[nodiscard]] constexpr mandelbrot_part mandelbrot_part_of(const point<T, 2>& c) noexcept {
  const T margin = T(0) - static_cast<T>(detail::interior_margin);
  if (detail::outside_cardioid(c.x, c.y) < margin) return mandelbrot_part::cardioid;
  return detail::outside_disc(c.x, c.y) < margin ? mandelbrot_part::disc : mandelbrot_part::elsewhere;
}

/// How many steps the orbit of 0 under z^2 + c takes: `most` for the numbers of the set, and a few more.
/// gives   0 for NaN
/// exact   in floats as they come: the lecture's loop in doubles, never contracted
/// source  Mandelbrot 1980; Mihajlovic 2016, chapter 8
template <Floating T>
[[nodiscard]] constexpr int mandelbrot_count(const point<T, 2>& c, const escape_limit<T>& limit) noexcept {
  return escape_count(square_plus<T>{c}, point<T, 2>{T(0), T(0)}, limit);
}

}  // namespace IRG_ABI
}  // namespace irg
