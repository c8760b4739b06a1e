// SPDX-License-Identifier: MIT
// Colours of counts: a palette, and counts without steps.
#pragma once

#include <limits>

#include <irg/colour/palette.hpp>
#include <irg/fractal/escape_time.hpp>
#include <irg/math/exponential.hpp>

namespace irg {

/// Blue, sand and red, sixteen counts from one to the next.
inline constexpr cyclic_palette<rgba8, 5> escape_palette{
    {{{18, 32, 74, 255}, {62, 130, 180, 255}, {238, 240, 230, 255}, {226, 160, 62, 255}, {120, 36, 52, 255}}}, 16};

inline namespace IRG_ABI {

/// The colour of a count that was made with `most` steps: of escape_palette, black for an orbit that stayed.
[[nodiscard]] constexpr rgba8 escape_colour(int count, int most) noexcept {
  return count < most ? escape_palette(count) : rgba8{0, 0, 0, 255};
}

/// The count of an orbit of z^2 + c with a fraction that makes it continuous.
/// needs   the end of an orbit that a limit of this radius ended, `most` its number of steps; radius > 1
/// gives   count + 1 - log2(log |z| / log radius), which is the count where |z| is the radius's square, one more where
///         it is the radius; `most` for an orbit that stayed or has become NaN or infinite
/// exact   but for rounding, continuous in z up to terms of the size of |c| / radius^2: take a radius of 100 or more
/// source  irg's own: the logarithm of the potential 2^-n log |z|
template <Floating T>
[[nodiscard]] constexpr T smooth_count(const escape_end<T>& end, T radius, int most) noexcept {
  const T square = detail::squared_size(end.z.x, end.z.y);
  if (end.count >= most || !(square <= (std::numeric_limits<T>::max)())) return static_cast<T>(most);
  return static_cast<T>(end.count) + T(1) - log2(log2(square) / log2(product(radius, radius)));
}

}  // namespace IRG_ABI
}  // namespace irg
