// SPDX-License-Identifier: MIT
// Phong's reflection model: how bright a point of a surface looks. (Phong *shading* is another thing of the same
// author, the interpolation of normals: shading.hpp.) Vectors are named as in the textbook: L from the point to the
// light, N the surface normal, V from the point to the viewer, R the reflection of L in N; all of length 1.
// An intensity L is a colour rgb<T> or one number T. The terms are exact on rationals.
#pragma once

#include <cstddef>

#include <irg/core/contract.hpp>
#include <irg/math/exponential.hpp>
#include <irg/math/length.hpp>
#include <irg/shade/per_channel.hpp>
#include <irg/shade/light.hpp>
#include <irg/shade/material.hpp>

namespace irg::detail::inline IRG_ABI {

// The integer that x is, or -1 when it is none of 0 to 1024.
template <Scalar T>
constexpr int small_integer(T x) noexcept {
  if constexpr (Floating<T>) {
    if (!(T(0) <= x && x <= T(1024))) return -1;
    const int n = static_cast<int>(x);
    return static_cast<T>(n) == x ? n : -1;
  } else {
    int n = 0;
    for (int bit = 1024; bit != 0; bit /= 2)
      if (!(x < T(bit))) {
        x = x - T(bit);
        n += bit;
      }
    return x == T(0) && n <= 1024 ? n : -1;
  }
}

}  // namespace irg::detail::inline IRG_ABI

namespace irg::inline IRG_ABI {

/// x to the power n by repeated squaring, from the lowest bit of n up.
/// needs   n >= 0
/// exact   on exact numbers; on floats the relative error is at most (n - 1) u to first order (u = 2^-53, float
///         2^-24), unless the result is subnormal
/// cost    at most 2 log2(n) + 1 products
template <Scalar T>
[[nodiscard]] constexpr T integer_power(T x, int n) noexcept {
  IRG_EXPECTS(n >= 0);
  T power = T(1);
  for (; n > 0; n /= 2) {
    if (n % 2 != 0) power = product(power, x);
    if (n > 1) x = product(x, x);
  }
  return power;
}

/// R = 2 (L.N) N - L, the direction in which a mirror of normal N throws the light that comes from L.
/// needs   N of length 1; R is as long as L
/// source  Phong 1975; the textbook's R, which it does not define
template <Scalar T>
[[nodiscard]] IRG_INLINE constexpr vec<T, 3> reflected_direction(const vec<T, 3>& to_light,
                                                                 const vec<T, 3>& normal) noexcept {
  const T ln = dot(to_light, normal);
  return normal * (ln + ln) - to_light;
}

/// Ia ka: the light that comes from everywhere (7.5).
template <class L>
[[nodiscard]] IRG_INLINE constexpr L ambient_term(const L& light, const L& ambient) noexcept {
  return per_channel([](auto ia, auto ka) { return product(ia, ka); }, light, ambient);
}

/// Ii kd (L.N): the light that a dull surface scatters alike in all directions, brightest where the light falls on it
/// at right angles (7.6).
/// gives   0 where L.N <= 0, the light being behind the surface or grazing it
/// source  Lambert 1760
template <class L, Scalar T>
[[nodiscard]] IRG_INLINE constexpr L diffuse_term(const L& light, const L& diffuse, const vec<T, 3>& to_light,
                                                  const vec<T, 3>& normal) noexcept {
  const T ln = dot(to_light, normal);
  return per_channel([&](auto ii, auto kd) { return T(0) < ln ? product(product(ii, kd), ln) : decltype(ii)(0); },
                     light, diffuse);
}

/// (R.V)^n: how near the viewer is to the reflected ray, 1 on it.
/// gives   0 where R.V <= 0, and where L.N <= 0: light from behind makes no highlight
/// needs   a shininess n > 0; an integer up to 1024 if T is neither float nor double
/// exact   integers n up to 1024 by integer_power, others by pow, for which R.V is at most 1: what rounding puts above
///         it, a large n would make infinite
template <Scalar T>
[[nodiscard]] constexpr T specular_factor(const vec<T, 3>& to_light, const vec<T, 3>& normal,
                                          const vec<T, 3>& to_viewer, const T& shininess) noexcept {
  if (!(T(0) < dot(to_light, normal))) return T(0);
  const T rv = dot(reflected_direction(to_light, normal), to_viewer);
  if (!(T(0) < rv)) return T(0);
  const int n = detail::small_integer(shininess);
  if constexpr (Floating<T>) {
    return n < 0 ? pow(minimum(rv, T(1)), shininess) : integer_power(rv, n);
  } else {
    IRG_EXPECTS(n >= 0);
    return integer_power(rv, n);
  }
}

/// Ii ks (R.V)^n: the highlight (7.8).
/// gives   0 where R.V <= 0 or L.N <= 0
/// needs   as specular_factor
template <class T, class L>
[[nodiscard]] IRG_INLINE constexpr L specular_term(const material<T, L>& surface, const L& light,
                                                   const vec<T, 3>& to_light, const vec<T, 3>& normal,
                                                   const vec<T, 3>& to_viewer) noexcept {
  const T factor = specular_factor(to_light, normal, to_viewer, surface.shininess);
  return per_channel(
      [&](auto ii, auto ks) { return factor == T(0) ? decltype(ii)(0) : product(product(ii, ks), factor); }, light,
      surface.specular);
}

/// What one source of intensity Ii adds: Ii (kd (L.N) + ks (R.V)^n), the bracket of (7.9).
/// needs   L, N and V of length 1, or 0 where there is none: no L no light, no V no highlight
template <class T, class L>
[[nodiscard]] IRG_INLINE constexpr L reflected_light(const material<T, L>& surface, const L& light,
                                                     const vec<T, 3>& to_light, const vec<T, 3>& normal,
                                                     const vec<T, 3>& to_viewer) noexcept {
  return diffuse_term(light, surface.diffuse, to_light, normal) +
         specular_term(surface, light, to_light, normal, to_viewer);
}

/// Ii / (r + k): a source's intensity, weakened by the distance r (7.10).
/// needs   r + k > 0
template <class L, Scalar T>
[[nodiscard]] IRG_INLINE constexpr L weakened_by_distance(const L& light, const T& r, const T& k) noexcept {
  return per_channel([&](auto ii) { return ii / (r + k); }, light);
}

/// A point of a surface and the normal there.
template <Scalar T>
struct surface_place {
  point<T, 3> p;
  vec<T, 3> normal;
  bool operator==(const surface_place&) const = default;
};

/// The intensity of the point p of a surface as the eye sees it: the ambient term and what each source adds (7.9 or
/// 7.10), where arriving(i, intensity) tells what of source i's intensity arrives at p: shadows are made of it.
/// shape   p, the lights, the eye and the normal in one coordinate system, with the same unit on all axes
/// needs   a normal of length 1; where distance counts, k > 0 or an eye that is not in p: L / (r + k) is 0 / 0 for a
///         channel without light there
/// gives   values over 1 (or 255) where much light meets: see fit_intensities; nothing from a light that stands in p
///         itself, no highlight when the eye does; the ambient term where the normal is 0
/// exact   written from + - * / sqrt and pow in one order: the same bits everywhere
/// source  Phong 1975
template <Floating T, class L, class Arriving>
[[nodiscard]] constexpr L phong_model(const material<T, L>& surface, const lighting<T, L>& light,
                                      const point<T, 3>& eye, const surface_place<T>& place, const Arriving& arriving) {
  const auto& [p, normal] = place;
  const bool weakened = light.distance == distance_term::viewer;
  const vec<T, 3> to_viewer = normalized(eye - p);
  const T r = weakened ? length(eye - p) : T(0);
  L sum = ambient_term(light.ambient, surface.ambient);
  for (std::size_t i = 0; i < light.lights.size(); ++i) {
    const auto& source = light.lights[i];
    const L emitted = weakened ? weakened_by_distance(source.intensity, r, light.k) : source.intensity;
    const vec<T, 3> to_light = normalized(direction_to_light(source, p));
    sum = sum + reflected_light(surface, arriving(i, emitted), to_light, normal, to_viewer);
  }
  return sum;
}

/// The same with nothing between the lights and p.
template <Floating T, class L>
[[nodiscard]] constexpr L phong_model(const material<T, L>& surface, const lighting<T, L>& light,
                                      const point<T, 3>& eye, const surface_place<T>& place) noexcept {
  return phong_model(surface, light, eye, place, [](std::size_t, const L& emitted) { return emitted; });
}

}  // namespace irg::inline IRG_ABI
