// SPDX-License-Identifier: MIT
// Whether a point lies inside the circle through three others, or in space inside the sphere through four, decided
// exactly.
#pragma once

#include <type_traits>

#include <irg/core/coordinates.hpp>
#include <irg/geometry/detail/predicate_kernel.hpp>

namespace irg::inline IRG_ABI {

/// 1 when d lies inside the circle through a, b, c, -1 when it lies outside, 0 when it lies on it; for a, b, c that
/// turn left. Where they turn right the signs are the other way round; where they lie on a line, the sign is 0 when d
/// does, too, and else tells on which side of the line d lies.
/// needs   finite coordinates
/// exact   for every float, double and integer, subnormals and extremes included, under all floating-point flags and
///         with subnormals flushed to zero; other scalars: as exact as their own + - * are
/// cost    about 50 operations on floats where the points are not nearly on a circle; else integers of 256 bits, of 512
///         where exponents differ by more than 8; beyond 72 another 500 operations on floats, and an exact sum of 48
///         products for points that are nearly on a circle even so
/// source  Shewchuk 1997; Devillers and Pion 2003 (the filter)
template <Point P>
  requires(size_of<P> == 2)
[[nodiscard]] IRG_INLINE constexpr int in_circle(const P& a, const P& b, const P& c,
                                                 const P& d) noexcept(std::is_arithmetic_v<scalar_of<P>>);

/// 1 when e lies inside the sphere through a, b, c, d, -1 when it lies outside, 0 when it lies on it; for
/// orient3d(a, b, c, d) = 1. Where that is -1 the signs are the other way round; where it is 0, the sign is 0 when e
/// lies in the plane, too, or a, b, c, d on a circle.
/// needs   finite coordinates
/// exact   as in_circle
/// cost    about 120 operations on floats where the points are not nearly on a sphere; else integers of 320 bits, of
///         640 where exponents differ by more than 8; beyond 72 another 1200 operations on floats, and an exact sum of
///         360 products for points that are nearly on a sphere even so
/// source  as in_circle
template <Point P>
  requires(size_of<P> == 3)
[[nodiscard]] IRG_INLINE constexpr int in_sphere(const P& a, const P& b, const P& c, const P& d,
                                                 const P& e) noexcept(std::is_arithmetic_v<scalar_of<P>>);

IRG_REFUSES_VECTORS(in_circle);
IRG_REFUSES_VECTORS(in_sphere);

}  // namespace irg::inline IRG_ABI

namespace irg::detail::inline IRG_ABI {

// The determinant of the rows (x, y, x^2 + y^2) of three points seen from the fourth.
template <class T>
IRG_INLINE constexpr auto difference_determinant(const point_table<T, 3, 2>& t) {
  const T *const a = t.v, *const b = t.v + 2, *const c = t.v + 4;
  return (a[0] * a[0] + a[1] * a[1]) * (b[0] * c[1] - b[1] * c[0]) +
         (b[0] * b[0] + b[1] * b[1]) * (c[0] * a[1] - c[1] * a[0]) +
         (c[0] * c[0] + c[1] * c[1]) * (a[0] * b[1] - a[1] * b[0]);
}

// The determinant of the rows (x, y, z, x^2 + y^2 + z^2) of four points seen from the fifth, negated.
template <class T>
IRG_INLINE constexpr auto difference_determinant(const point_table<T, 4, 3>& t) {
  const T *const a = t.v, *const b = t.v + 3, *const c = t.v + 6, *const d = t.v + 9;
  const auto area = [](const T* p, const T* q) { return p[0] * q[1] - p[1] * q[0]; };
  const auto ab = area(a, b), bc = area(b, c), cd = area(c, d), da = area(d, a), ac = area(a, c), bd = area(b, d);
  const auto square = [](const T* p) { return p[0] * p[0] + p[1] * p[1] + p[2] * p[2]; };
  return square(a) * (cd * b[2] - bd * c[2] + bc * d[2]) - square(b) * (cd * a[2] + ac * d[2] + da * c[2]) +
         square(c) * (da * b[2] + bd * a[2] + ab * d[2]) - square(d) * (bc * a[2] - ac * b[2] + ab * c[2]);
}

// The largest sum of squares of a point's coordinates.
template <int M, int D>
IRG_INLINE constexpr double largest_square(const point_table<double, M, D>& t) noexcept {
  double largest = 0;
  for (int i = 0; i < M; ++i) {
    double sum = t(i, 0) * t(i, 0);
    for (int k = 1; k < D; ++k) sum += t(i, k) * t(i, k);
    largest = maximum(largest, sum);
  }
  return largest;
}

// The sign, or 0 where rounded arithmetic cannot tell.
//
// With X and Y the sizes of the largest differences along the axes and S the largest sum of squares, the absolute
// values of the determinant's products add up to at most 6*X*Y*S. Each passes at most 11 roundings: four of
// differences, two of the sum of squares, two of the difference of products, that of their product and two of sums. So
// the result is off by less than 66.001u*X*Y*S; the factor below, for 8*X*Y*S, makes 66u(1 + 2^-9). What subnormals
// lose, less than 2^-1020 in each difference and product, is less than the bound's share from `least`, as in orient2d.
// The 8 keeps everything finite where the bound is: partial sums are at most 6*X*Y*S.
IRG_INLINE constexpr int filtered_sign(const point_table<double, 4, 2>& t, double least) noexcept {
  constexpr double factor = 66.0 / 8 * (1 + 0x1p-9) * 0x1p-53;
  const auto d = relative_to_last(t);
  const double determinant = difference_determinant(d);
  const double bound = (reach(d, 0) + least) * (reach(d, 1) * 8 + least) * (largest_square(d) + least * least) * factor;
  return magnitude(determinant) > bound ? sign_of_nonzero(determinant) : 0;
}

// The same: the absolute values add up to at most 24*X*Y*Z*S, and each product passes at most 16 roundings: five of
// differences, two of an area, three of a volume, three of a sum of squares, that of their product and two (of the
// longer of the sums, three: 17) of sums. The factor, for 32*X*Y*Z*S, makes 24*17u(1 + 2^-9).
IRG_INLINE constexpr int filtered_sign(const point_table<double, 5, 3>& t, double least) noexcept {
  constexpr double factor = 24.0 * 17 / 32 * (1 + 0x1p-9) * 0x1p-53;
  const auto d = relative_to_last(t);
  const double determinant = difference_determinant(d);
  const double bound = (reach(d, 0) + least) * (reach(d, 1) * 32 + least) * (reach(d, 2) + least) *
                       (largest_square(d) + least * least) * factor;
  return magnitude(determinant) > bound ? sign_of_nonzero(determinant) : 0;
}

}  // namespace irg::detail::inline IRG_ABI

namespace irg::inline IRG_ABI {

template <Point P>
  requires(size_of<P> == 2)
[[nodiscard]] constexpr int in_circle(const P& a, const P& b, const P& c,
                                      const P& d) noexcept(std::is_arithmetic_v<scalar_of<P>>) {
  return detail::predicate(a, b, c, d);
}

template <Point P>
  requires(size_of<P> == 3)
[[nodiscard]] constexpr int in_sphere(const P& a, const P& b, const P& c, const P& d,
                                      const P& e) noexcept(std::is_arithmetic_v<scalar_of<P>>) {
  return detail::predicate(a, b, c, d, e);
}

}  // namespace irg::inline IRG_ABI
