// SPDX-License-Identifier: MIT
// Affine transformations of space as 4x4 matrices for column vectors: translation, scaling, rotation. The matrix
// product composes them; in `c * b * a` the transformation a comes first. Surface normals, orientation and meshes.
#pragma once

#include <cstddef>

#include <irg/core/conversion.hpp>
#include <irg/math/exact/sign_of.hpp>
#include <irg/math/length.hpp>
#include <irg/math/mat.hpp>
#include <irg/math/trigonometry.hpp>
#include <irg/mesh/mesh.hpp>

namespace irg {

/// What a map does to the sense of rotation: keeps it, turns it round (a mirror image), or flattens space.
enum class map_orientation { reversing = -1, singular = 0, preserving = 1 };
template <>
inline constexpr bool is_sign_word<map_orientation> = true;

inline namespace IRG_ABI {

/// Moves everything by v, in bare braces one of doubles.
template <Vector V = vec<double, 3>>
  requires(size_of<V> == 3)
[[nodiscard]] constexpr mat<scalar_of<V>, 4, 4> translation(const V& v) noexcept {
  auto m = identity_matrix<scalar_of<V>, 4>();
  for (int i = 0; i < 3; ++i) m(i, 3) = coordinate(v, i);
  return m;
}

/// Stretches x, y and z by factors of their own; negative ones mirror, 0 flattens.
template <Vector V>
  requires(size_of<V> == 3)
[[nodiscard]] constexpr mat<scalar_of<V>, 4, 4> scaling(const V& factors) noexcept {
  auto m = identity_matrix<scalar_of<V>, 4>();
  for (int i = 0; i < 3; ++i) m(i, i) = coordinate(factors, i);
  return m;
}

/// Stretches everything by one factor about the origin.
template <Real T>
[[nodiscard]] constexpr mat<T, 4, 4> scaling(const T& factor) noexcept {
  return scaling(vec<T, 3>{factor, factor, factor});
}

/// Turns about the x axis, y towards z: counter-clockwise as seen from the axis' positive end.
/// units   radians
/// exact   entries are sin(angle) and cos(angle) as rounded by irg
template <Floating T>
[[nodiscard]] constexpr mat<T, 4, 4> rotation_x(T angle) noexcept {
  const T c = cos(angle), s = sin(angle);
  return {{{1, 0, 0, 0}, {0, c, -s, 0}, {0, s, c, 0}, {0, 0, 0, 1}}};
}

/// Turns about the y axis, z towards x: counter-clockwise as seen from the axis' positive end.
/// units   radians
/// exact   as rotation_x
template <Floating T>
[[nodiscard]] constexpr mat<T, 4, 4> rotation_y(T angle) noexcept {
  const T c = cos(angle), s = sin(angle);
  return {{{c, 0, s, 0}, {0, 1, 0, 0}, {-s, 0, c, 0}, {0, 0, 0, 1}}};
}

/// Turns about the z axis, x towards y: counter-clockwise as seen from the axis' positive end.
/// units   radians
/// exact   as rotation_x
template <Floating T>
[[nodiscard]] constexpr mat<T, 4, 4> rotation_z(T angle) noexcept {
  const T c = cos(angle), s = sin(angle);
  return {{{c, -s, 0, 0}, {s, c, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}}};
}

/// Turns about an axis through the origin, counter-clockwise as seen from its tip. Its length does not matter.
/// units   radians
/// gives   the identity for an axis that is zero, NaN or infinite
/// exact   entries within 10u of the true ones (u = 2^-53, float 2^-24; found: 7.1u), orthonormal within 16u
/// source  Rodrigues 1840
template <Vector V = vec<double, 3>>
  requires(size_of<V> == 3 && Floating<scalar_of<V>>)
[[nodiscard]] constexpr mat<scalar_of<V>, 4, 4> rotation(const V& axis, scalar_of<V> angle) noexcept {
  using T = scalar_of<V>;
  const auto unit = try_normalized(axis);
  if (!unit) return identity_matrix<T, 4>();
  const T x = coordinate(*unit, 0), y = coordinate(*unit, 1), z = coordinate(*unit, 2);
  const T c = cos(angle), s = sin(angle), versine = T(1) - c;
  const auto along = [&](T a, T b) { return product(versine, product(a, b)); };
  const T sx = product(s, x), sy = product(s, y), sz = product(s, z);
  return {{{c + along(x, x), along(x, y) - sz, along(x, z) + sy, 0},
           {along(x, y) + sz, c + along(y, y), along(y, z) - sx, 0},
           {along(x, z) - sy, along(y, z) + sx, c + along(z, z), 0},
           {0, 0, 0, 1}}};
}

/// The upper left 3x3 block of a 4x4 matrix: what an affine map does to displacements.
template <class T>
[[nodiscard]] constexpr mat<T, 3, 3> linear_part(const mat<T, 4, 4>& m) noexcept {
  return submatrix(m, 3, 3);
}

}  // namespace IRG_ABI

namespace detail::inline IRG_ABI {

// Whether products of two entries are far from the ends of the range.
template <Floating T>
constexpr bool has_ordinary_entries(const mat<T, 3, 3>& a) noexcept {
  constexpr T most = std::same_as<T, float> ? T(0x1p30f) : T(0x1p250);
  for (const auto& row : a.m)
    for (const T& entry : row)
      if (entry != T(0) && !(T(1) / most <= magnitude(entry) && magnitude(entry) <= most)) return false;
  return true;
}

// The cofactors; where one of their products is near an end of the range, times a power of two that brings the largest
// of them near to 2^500, or 2^60 in floats.
template <Floating T>
constexpr mat<T, 3, 3> scaled_cofactors(const mat<T, 3, 3>& a) noexcept {
  constexpr bool single = std::same_as<T, float>;
  constexpr int aim = single ? 60 : 500, least = single ? -100 : -960, none = -10000;
  struct pair {
    double significand = 0;
    int exponent = none;
  };
  const auto times = [&](int r, int c, int q, int d) -> pair {
    const double x = widened(a(r % 3, c % 3)), y = widened(a(q % 3, d % 3));
    if (x == 0 || y == 0) return {};
    const scaled_number u = decompose(x), v = decompose(y);
    return {product(u.significand, v.significand), u.exponent + v.exponent};
  };
  int largest = none, smallest = aim;
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < 3; ++c)
      for (const pair& p : {times(r + 1, c + 1, r + 2, c + 2), times(r + 1, c + 2, r + 2, c + 1)})
        largest = maximum(largest, p.exponent),
        smallest = p.exponent == none ? smallest : minimum(smallest, p.exponent);
  if (least <= smallest && largest < aim) return cofactor_matrix(a);
  return generate_mat<T, 3, 3>([&](int r, int c) {
    const auto value = [&](const pair& p) { return times_power_of_two(p.significand, p.exponent - largest + aim); };
    return converted<T>(value(times(r + 1, c + 1, r + 2, c + 2)) - value(times(r + 1, c + 2, r + 2, c + 1)));
  });
}

}  // namespace detail::inline IRG_ABI

inline namespace IRG_ABI {

/// Whether an affine map keeps the sense of rotation, by the sign of its determinant.
/// gives   singular where an entry is NaN or infinite
/// exact   in rationals, and for all finite floats and doubles
template <class T>
[[nodiscard]] constexpr map_orientation orientation_of(const mat<T, 4, 4>& m) noexcept {
  const mat<T, 3, 3> a = linear_part(m);
  const auto row = [&](int r) { return vec<T, 3>{a(r, 0), a(r, 1), a(r, 2)}; };
  return static_cast<map_orientation>(irg::sign_of<3>(
      [](const auto& x, const auto& y, const auto& z) { return dot(x, cross(y, z)); }, row(0), row(1), row(2)));
}

/// The matrix that takes surface normals along with an affine map: the inverse transpose times a positive factor.
/// Normals that point outward stay so, under mirror images too; renormalise what comes out.
/// gives   for a map that flattens space onto a plane, normals of that plane (or 0); for one onto a line or point, 0
/// exact   in rationals; in floats each entry is off by at most 2u times the sum of its two products' absolute values,
///         where these are not 450 decades (float: 36) below the largest of all
/// source  irg's own: the cofactor matrix times the sign of the determinant; no division, so singular maps need no
///         exception
template <class T>
[[nodiscard]] constexpr mat<T, 3, 3> normal_matrix(const mat<T, 4, 4>& m) noexcept {
  const mat<T, 3, 3> a = linear_part(m);
  const auto cofactors = [&] {
    if constexpr (Floating<T>)
      if (!detail::has_ordinary_entries(a) && is_finite(a)) return detail::scaled_cofactors(a);
    return cofactor_matrix(a);
  }();
  return orientation_of(m) == map_orientation::reversing ? -cofactors : cofactors;
}

/// The direction of a surface normal after an affine map, not of length 1. For many normals, keep normal_matrix(m).
/// exact   as normal_matrix
template <class T>
[[nodiscard]] constexpr vec<T, 3> transform_normal(const mat<T, 4, 4>& m, const vec<T, 3>& normal) noexcept {
  return normal_matrix(m) * normal;
}

/// The mesh with its positions transformed, its normals transformed and of length 1 again, and, under a mirror image,
/// its faces turned round so that they stay counter-clockwise as seen from outside (their first corner stays first).
/// needs   an affine m; its last row is not read
/// gives   normals 0, 0, 0 where none is left (a zero normal, a flattened body)
template <Floating T>
[[nodiscard]] constexpr mesh<T> transformed(mesh<T> body, const mat<T, 4, 4>& m) {
  for (auto& p : body.positions) p = transform_point(m, p);
  const mat<T, 3, 3> normals = normal_matrix(m);
  for (auto& n : body.normals) {
    const auto s = scaled_near_one(n);
    n = normalized(normals * vec<T, 3>{converted<T>(s.c[0]), converted<T>(s.c[1]), converted<T>(s.c[2])});
  }
  if (orientation_of(m) != map_orientation::reversing) return body;
  for (std::size_t f = 0; f < body.face_count(); ++f) {
    std::size_t first = body.face_starts[f] + 1, last = body.face_starts[f + 1];
    for (; first + 1 < last; ++first) {
      const mesh_corner kept = body.corners[first];
      body.corners[first] = body.corners[--last];
      body.corners[last] = kept;
    }
  }
  return body;
}

IRG_REFUSES_POINTS(rotation);
IRG_REFUSES_POINTS(scaling);
IRG_REFUSES_POINTS(translation);

IRG_RENAMED(transform_mesh, transformed)

}  // namespace IRG_ABI
}  // namespace irg
