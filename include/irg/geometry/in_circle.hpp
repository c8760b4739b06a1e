// SPDX-License-Identifier: MIT
// Whether a point lies inside the circle through three others, or in space inside the sphere through four, decided
// exactly.
#pragma once

#include <cstdint>
#include <type_traits>

#include <irg/core/coordinates.hpp>
#include <irg/geometry/detail/predicate_kernel.hpp>

namespace irg {
namespace detail {
inline namespace IRG_ABI {

// The determinant of the rows (x, y, x^2 + y^2) of three points seen from the fourth.
template <class T>
IRG_INLINE constexpr auto circle_determinant(const point_table<T, 3, 2>& t) {
  const T *const a = t.v, *const b = t.v + 2, *const c = t.v + 4;
  return (a[0] * a[0] + a[1] * a[1]) * (b[0] * c[1] - b[1] * c[0]) +
         (b[0] * b[0] + b[1] * b[1]) * (c[0] * a[1] - c[1] * a[0]) +
         (c[0] * c[0] + c[1] * c[1]) * (a[0] * b[1] - a[1] * b[0]);
}

// The determinant of the rows (x, y, z, x^2 + y^2 + z^2) of four points seen from the fifth.
template <class T>
IRG_INLINE constexpr auto sphere_determinant(const point_table<T, 4, 3>& t) {
  const T *const a = t.v, *const b = t.v + 3, *const c = t.v + 6, *const d = t.v + 9;
  const auto area = [](const T* p, const T* q) { return p[0] * q[1] - p[1] * q[0]; };
  const auto ab = area(a, b), bc = area(b, c), cd = area(c, d), da = area(d, a), ac = area(a, c), bd = area(b, d);
  const auto square = [](const T* p) { return p[0] * p[0] + p[1] * p[1] + p[2] * p[2]; };
  return square(d) * (bc * a[2] - ac * b[2] + ab * c[2]) - square(c) * (da * b[2] + bd * a[2] + ab * d[2]) +
         square(b) * (cd * a[2] + ac * d[2] + da * c[2]) - square(a) * (cd * b[2] - bd * c[2] + bc * d[2]);
}

// The signs, for exact numbers: T holds the differences of coordinates, their products what they are made of.
template <class T>
IRG_INLINE constexpr int in_circle_of(const point_table<T, 4, 2>& t) {
  return coordinate_sign(circle_determinant(relative_to_last(t)));
}
template <class T>
IRG_INLINE constexpr int in_sphere_of(const point_table<T, 5, 3>& t) {
  return -coordinate_sign(sphere_determinant(relative_to_last(t)));
}

// The sign, or 0 where rounded arithmetic cannot tell.
//
// With X and Y the sizes of the largest differences along the axes, the absolute values of the determinant's products
// add up to at most 6*X*Y*(X^2 + Y^2). Each passes at most 11 roundings: four of differences, two of the sum of
// squares, two of the difference of products, that of their product and two of sums. So the result is off by less than
// 66.001u*X*Y*(X^2 + Y^2); the factor below, for 8*X*Y, makes 66u(1 + 2^-9). What subnormals lose, less than 2^-1020 in
// each difference and product, is less than the bound's share from `least`, as in orient2d. The 8 keeps everything
// finite where the bound is: partial sums are at most 6*X*Y*(X^2 + Y^2).
IRG_INLINE constexpr int in_circle_filtered(const point_table<double, 4, 2>& t) noexcept {
  constexpr double factor = 66.0 / 8 * (1 + 0x1p-9) * 0x1p-53, least = 0x1p-240;
  const auto d = relative_to_last(t);
  const double determinant = circle_determinant(d);
  const double x = reach(d, 0) + least, y = reach(d, 1);
  const double bound = (x * (y * 8 + least)) * (x * x + y * y) * factor;
  return magnitude(determinant) > bound ? sign_of_nonzero(determinant) : 0;
}

// The same: the absolute values add up to at most 24*X*Y*Z*(X^2 + Y^2 + Z^2), and each product passes at most 16
// roundings: five of differences, two of an area, three of a volume, three of a sum of squares, that of their product
// and two (of the longer of the sums, three: 17) of sums. The factor, for 32*X*Y*Z, makes 24*17u(1 + 2^-9).
IRG_INLINE constexpr int in_sphere_filtered(const point_table<double, 5, 3>& t) noexcept {
  constexpr double factor = 24.0 * 17 / 32 * (1 + 0x1p-9) * 0x1p-53, least = 0x1p-190;
  const auto d = relative_to_last(t);
  const double determinant = sphere_determinant(d);
  const double x = reach(d, 0) + least, y = reach(d, 1), z = reach(d, 2);
  const double bound = (x * (y * 32 + least) * (z + least)) * (x * x + y * y + z * z) * factor;
  return magnitude(determinant) > bound ? -sign_of_nonzero(determinant) : 0;
}

// The exact stages: integers of one word, of two, or as long as doubles need. The first two leave open what does not
// fit them.
IRG_INLINE constexpr bool in_circle_by_words(const point_table<double, 4, 2>& t, int& sign) noexcept {
  point_table<std::int64_t, 4, 2> n{};
  if (!to_words(t, n)) return false;
  sign = circle_determinant(widened<wide_int<1>>(relative_to_last(n))).sign();
  return true;
}
constexpr bool in_sphere_by_words(const point_table<double, 5, 3>& t, int& sign) noexcept {
  point_table<std::int64_t, 5, 3> n{};
  if (!to_words(t, n)) return false;
  sign = -sphere_determinant(widened<wide_int<1>>(relative_to_last(n))).sign();
  return true;
}
constexpr bool in_circle_by_double_words(const point_table<double, 4, 2>& t, int& sign) noexcept {
  point_table<wide_int<2>, 4, 2> n{};
  if (!to_double_words(t, n)) return false;
  sign = in_circle_of(n);
  return true;
}
constexpr bool in_sphere_by_double_words(const point_table<double, 5, 3>& t, int& sign) noexcept {
  point_table<wide_int<2>, 5, 3> n{};
  if (!to_double_words(t, n)) return false;
  sign = in_sphere_of(n);
  return true;
}

// The determinant of M points with ones and the squares of their distances from the origin beside them, by all its
// products: those of the squares of point s with the determinant of the others and ones.
template <int D, int M>
constexpr int sphere_sign_by_sum(const point_table<double, M, D>& t) noexcept {
  exact_accumulator<D + 2> sum;
  // Calls add with the points' numbers, one for each axis, and with the sign of their order, for each choice of them.
  for (int s = 0; s < M; ++s)
    for (int last = 0; last < M; ++last) {  // the one whose entry is the 1
      if (last == s) continue;
      int rest[static_cast<unsigned>(D)]{}, n = 0;
      for (int i = 0; i < M; ++i)
        if (i != s && i != last) rest[n++] = i;
      const bool odd = ((s + last + (last > s ? 1 : 0)) & 1) != 0;
      for (int order = 0; order < (D == 2 ? 2 : 6); ++order) {
        int p[static_cast<unsigned>(D)]{};
        for (int k = 0; k < D; ++k)  // rotated, and turned round from the middle of the orders on
          p[k] = rest[((order < D ? k : D - 1 - k) + order) % D];
        const bool minus = odd != (D == 2 ? order % 2 != 0 : order >= D);
        const double* const q = t.v + D * s;
        for (int k = 0; k < D; ++k) {
          const double x = t(p[0], 0), y = t(p[1], 1);
          if constexpr (D == 2)
            minus ? sum.subtract(x, y, q[k], q[k]) : sum.add(x, y, q[k], q[k]);
          else
            minus ? sum.subtract(x, y, t(p[2], 2), q[k], q[k]) : sum.add(x, y, t(p[2], 2), q[k], q[k]);
        }
      }
    }
  return sum.sign();
}
constexpr int in_circle_by_sum(const point_table<double, 4, 2>& t) noexcept { return sphere_sign_by_sum<2>(t); }
constexpr int in_sphere_by_sum(const point_table<double, 5, 3>& t) noexcept { return -sphere_sign_by_sum<3>(t); }

// Coordinates are passed in registers, so that nothing has to wait for the memory.
IRG_NOINLINE constexpr int in_circle_beyond_words(double ax, double ay, double bx, double by, double cx, double cy,
                                                  double dx, double dy) noexcept {
  const point_table<double, 4, 2> t{{ax, ay, bx, by, cx, cy, dx, dy}};
  int sign = 0;
  return in_circle_by_double_words(t, sign) ? sign : in_circle_by_sum(t);
}
IRG_NOINLINE constexpr int in_circle_exact(double ax, double ay, double bx, double by, double cx, double cy, double dx,
                                           double dy) noexcept {
  int sign = 0;
  if (in_circle_by_words({{ax, ay, bx, by, cx, cy, dx, dy}}, sign)) return sign;
  return in_circle_beyond_words(ax, ay, bx, by, cx, cy, dx, dy);
}
IRG_NOINLINE constexpr int in_sphere_exact(const point_table<double, 5, 3>& t) noexcept {
  int sign = 0;
  return in_sphere_by_words(t, sign) || in_sphere_by_double_words(t, sign) ? sign : in_sphere_by_sum(t);
}

}  // namespace IRG_ABI
}  // namespace detail

inline namespace IRG_ABI {

/// 1 when d lies inside the circle through a, b, c, -1 when it lies outside, 0 when it lies on it; for a, b, c that
/// turn left. Where they turn right the signs are the other way round; where they lie on a line, the sign is 0 when d
/// does, too, and else tells on which side of the line d lies.
/// needs   finite coordinates
/// exact   for every float, double and integer, subnormals and extremes included, under all floating-point flags and
///         with subnormals flushed to zero; other scalars: as exact as their own + - * are
/// cost    about 50 operations on floats where the points are not nearly on a circle; else integers of 256 bits, of 512
///         where exponents differ by more than 8, and of 8500 where they differ by more than 72
/// source  Shewchuk 1997; Devillers and Pion 2003 (the filter)
template <Point P>
  requires(size_of<P> == 2)
IRG_INLINE constexpr int in_circle(const P& a, const P& b, const P& c,
                                   const P& d) noexcept(std::is_arithmetic_v<scalar_of<P>>) {
  using T = scalar_of<P>;
  if constexpr (Floating<T>) {
    const auto t = detail::table_of<double>(a, b, c, d);
    if (!detail::in_constant_evaluation())
      if (const int sign = detail::in_circle_filtered(t); sign != 0) return sign;
    return detail::in_circle_exact(t.v[0], t.v[1], t.v[2], t.v[3], t.v[4], t.v[5], t.v[6], t.v[7]);
  } else if constexpr (std::is_integral_v<T>) {
    using wide = std::conditional_t<sizeof(T) <= 2, detail::wide_signed,
                                    std::conditional_t<sizeof(T) <= 4, wide_int<1>, wide_int<2>>>;
    return detail::in_circle_of(detail::table_of<wide>(a, b, c, d));
  } else {
    return detail::in_circle_of(detail::table_of<T>(a, b, c, d));
  }
}

/// 1 when e lies inside the sphere through a, b, c, d, -1 when it lies outside, 0 when it lies on it; for
/// orient3d(a, b, c, d) = 1. Where that is -1 the signs are the other way round; where it is 0, the sign is 0 when e
/// lies in the plane, too, or a, b, c, d on a circle.
/// needs   finite coordinates
/// exact   as in_circle
/// cost    about 120 operations on floats where the points are not nearly on a sphere; else integers of 320 bits, of
///         640 where exponents differ by more than 8, and of 10600 where they differ by more than 72
/// source  as in_circle
template <Point P>
  requires(size_of<P> == 3)
IRG_INLINE constexpr int in_sphere(const P& a, const P& b, const P& c, const P& d,
                                   const P& e) noexcept(std::is_arithmetic_v<scalar_of<P>>) {
  using T = scalar_of<P>;
  if constexpr (Floating<T>) {
    const auto t = detail::table_of<double>(a, b, c, d, e);
    if (!detail::in_constant_evaluation())
      if (const int sign = detail::in_sphere_filtered(t); sign != 0) return sign;
    return detail::in_sphere_exact(t);
  } else if constexpr (std::is_integral_v<T>) {
    using wide = std::conditional_t<sizeof(T) <= 2, detail::wide_signed,
                                    std::conditional_t<sizeof(T) <= 4, wide_int<1>, wide_int<2>>>;
    return detail::in_sphere_of(detail::table_of<wide>(a, b, c, d, e));
  } else {
    return detail::in_sphere_of(detail::table_of<T>(a, b, c, d, e));
  }
}

}  // namespace IRG_ABI
}  // namespace irg
