// SPDX-License-Identifier: MIT
// Julia sets of z^2 + c: the border of the numbers z whose orbit stays bounded.
#pragma once

#include <irg/fractal/mandelbrot.hpp>

namespace irg {

/// Whether a set is in one piece, as far as could be found out.
enum class connectedness { no, undecided, yes };

inline namespace IRG_ABI {

/// How many steps the orbit of z under z^2 + c takes.
/// gives   the same for z and -z; 0 for NaN
/// exact   in floats as they come: the lecture's loop in doubles, never contracted
/// source  Julia 1918; Mihajlovic 2016, chapter 8
template <Floating T>
[[nodiscard]] constexpr int julia_count(const point<T, 2>& z, const point<T, 2>& c,
                                        const escape_limit<T>& limit) noexcept {
  return escape_count(square_plus<T>{c}, z, limit);
}

/// Whether the Julia set of z^2 + c is connected: it is just where c belongs to the Mandelbrot set.
/// gives   no where the orbit of 0 leaves the disc of radius 2 within `most` steps, yes where c lies in the cardioid or
///         the disc of period 2, or its orbit in floats comes back to where it was; else undecided
/// exact   but for the orbit's own rounding
/// source  Fatou 1919; Julia 1918
template <Floating T>
[[nodiscard]] constexpr connectedness julia_is_connected(const point<T, 2>& c, int most) noexcept {
  if (!(c.x == c.x && c.y == c.y)) return connectedness::undecided;
  if (mandelbrot_part_of(c) != mandelbrot_part::elsewhere) return connectedness::yes;
  const escape_limit<T> limit = make_escape_limit(T(2) + T(0x1p-20f), most);
  const square_plus<T> f{c};
  point<T, 2> z{T(0), T(0)}, kept = z;
  for (int k = 0, next = 1; k < limit.most; ++k) {
    z = f(z);
    if (!(detail::squared_size(z.x, z.y) < limit.square)) return connectedness::no;
    if (z == kept) return connectedness::yes;
    if (k == next) {
      kept = z;
      next = next <= limit.most / 2 ? 2 * next : limit.most;
    }
  }
  return connectedness::undecided;
}

}  // namespace IRG_ABI
}  // namespace irg
