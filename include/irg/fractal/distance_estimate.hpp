// SPDX-License-Identifier: MIT
// How far a number is from the Mandelbrot set, or from a Julia set of z^2 + c: two bounds, beside the set a factor of
// four apart. The orbit's derivative goes along with it; where the orbit has gone far out, its logarithm over 2^count
// is the potential G, and G over its slope the distance's size.
#pragma once

#include <array>
#include <limits>

#include <irg/core/instructions.hpp>
#include <irg/fractal/mandelbrot.hpp>
#include <irg/math/exponential.hpp>

namespace irg {

/// The steps of an orbit, and how far its beginning is from the set.
template <Floating T>
struct escape_distance {
  int count = 0;
  T at_least = 0, at_most = 0;  // 0 for what stays
  bool operator==(const escape_distance&) const = default;
};

namespace detail::inline IRG_ABI {

// The larger of |x| and |y|.
template <class T>
constexpr T reach_of(const point<T, 2>& z) noexcept {
  return maximum(magnitude(z.x), magnitude(z.y));
}
template <class T>
constexpr point<T, 2> complex_product(const point<T, 2>& a, const point<T, 2>& b) noexcept {
  return {product(a.x, b.x) - product(a.y, b.y), product(a.x, b.y) + product(a.y, b.x)};
}

// (1 - e^-2G) / 2G and (e^G - e^-G) / 2G, which bend the bounds far from the set.
template <class T>
constexpr std::array<T, 2> potential_factors(T g) noexcept {
  if (g < T(0x1p-10f)) return {T(1) - g, T(1) + product(g, g)};
  const T e = exp(g), falling = 1 / e;
  return {(1 - product(falling, falling)) / (2 * g), (e - falling) / (2 * g)};
}

// Where an orbit of z under z^2 + c begins: d is its derivative, to which `also` is added in each step, and z is the
// value of a polynomial of degree 2^doublings.
template <class T>
struct distance_orbit {
  point<T, 2> z, c, d;
  T also;
  int doublings;
};

template <class T>
constexpr escape_distance<T> distance_of_orbit(const distance_orbit<T>& begin, const escape_limit<T>& limit) noexcept {
  constexpr T large = sizeof(T) == 4 ? T(0x1p20f) : T(0x1p100);
  const square_plus<T> f{begin.c};
  point<T, 2> z = begin.z, d = begin.d;  // the derivative is d / unit
  T unit = 1, degree = begin.doublings > 0 ? T(1) / 2 : T(1);
  for (int k = 0; k < limit.most; ++k) {
    const point<T, 2> zd = complex_product(z, d);
    d = {zd.x + zd.x + product(begin.also, unit), zd.y + zd.y};
    if (reach_of(d) > large) d = {d.x / large, d.y / large}, unit = unit / large;
    z = f(z);
    const T size = squared_size(z.x, z.y), slope = sqrt(squared_size(d.x, d.y));
    if (size < limit.square) {
      degree /= 2;
      continue;
    }
    if (!(size <= (std::numeric_limits<T>::max)())) return {k, T(0), T(0)};
    const T away = sqrt(size), distant = product(product(away, log(away)) / slope, unit);
    const auto [below, above] = potential_factors(product(degree, log(away)));
    return {k, product(distant / 2, below), product(2 * distant, above)};
  }
  return {limit.most, T(0), T(0)};
}

}  // namespace detail::inline IRG_ABI

inline namespace IRG_ABI {

/// How far c is from the Mandelbrot set.
/// needs   a limit of a large radius, 1000 say: as its square grows the orbit's logarithm comes near the potential
/// gives   bounds of the distance, but for rounding and the radius; 0 for what stays, for c that is NaN or infinite,
///         and where the orbit's end overflows
/// cost    twice that of a count
/// source  Milnor 2006, for the bounds Koebe's theorem
template <Floating T>
[[nodiscard]] constexpr escape_distance<T> mandelbrot_distance(const point<T, 2>& c,
                                                               const escape_limit<T>& limit) noexcept {
  const point<T, 2> zero{T(0), T(0)};
  return detail::distance_of_orbit<T>({zero, c, zero, T(1), 0}, limit);
}

/// How far z is from the Julia set of z^2 + c, for z outside.
/// needs   as mandelbrot_distance; a connected set (julia_is_connected)
/// gives   as mandelbrot_distance
template <Floating T>
[[nodiscard]] constexpr escape_distance<T> julia_distance(const point<T, 2>& z, const point<T, 2>& c,
                                                          const escape_limit<T>& limit) noexcept {
  return detail::distance_of_orbit<T>({z, c, {T(1), T(0)}, T(0), 1}, limit);
}

}  // namespace IRG_ABI
}  // namespace irg
