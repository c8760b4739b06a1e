// SPDX-License-Identifier: MIT
// On which side of the plane through three points a fourth one lies, decided exactly.
#pragma once

#include <cstdint>
#include <type_traits>

#include <irg/core/coordinates.hpp>
#include <irg/geometry/detail/predicate_kernel.hpp>

namespace irg {
namespace detail {
inline namespace IRG_ABI {

// The determinant of the rows b, a, c, six times a volume: that of plane_through(a, b, c) at the origin.
template <class T>
IRG_INLINE constexpr auto spanned_volume(const point_table<T, 3, 3>& t) {
  const T *const a = t.v, *const b = t.v + 3, *const c = t.v + 6;
  return (c[0] * b[1] - c[1] * b[0]) * a[2] + (a[0] * c[1] - a[1] * c[0]) * b[2] + (b[0] * a[1] - b[1] * a[0]) * c[2];
}

// The sign, for exact numbers: T holds the differences of coordinates, their products what they are made of.
template <class T>
IRG_INLINE constexpr int orient3d_of(const point_table<T, 4, 3>& t) {
  return coordinate_sign(spanned_volume(relative_to_last(t)));
}

// The sign, or 0 where rounded arithmetic cannot tell.
//
// With X, Y, Z the sizes of the largest differences along the axes, each of the determinant's six products is at most
// X*Y*Z and passes at most 8 roundings: three of differences, two of its own, and those of three sums. So the result is
// off by less than 6*((1 + u)^8 - 1)*X*Y*Z < 48.001u*X*Y*Z; the factor below, for 8*X*Y*Z, makes 48u(1 + 2^-9). What
// subnormals lose, less than 2^-1020 in each difference and product, is less than the bound's share from t, as in
// orient2d. The 8 keeps everything finite where the bound is: partial sums are at most 6*X*Y*Z.
IRG_INLINE constexpr int orient3d_filtered(const point_table<double, 4, 3>& t) noexcept {
  constexpr double factor = 0x1.80cp-51, least = 0x1p-320;
  const auto d = relative_to_last(t);
  const double volume = spanned_volume(d);
  const double bound = (reach(d, 0) + least) * (reach(d, 1) * 8 + least) * (reach(d, 2) + least) * factor;
  return magnitude(volume) > bound ? sign_of_nonzero(volume) : 0;
}

// The exact stages: integers of one word, of two, or as long as doubles need. The first two leave open what does not
// fit them.
IRG_INLINE constexpr bool orient3d_by_words(const point_table<double, 4, 3>& t, int& sign) noexcept {
  point_table<std::int64_t, 4, 3> n{};
  if (!to_words(t, n)) return false;
  sign = spanned_volume(widened<wide_int<1>>(relative_to_last(n))).sign();
  return true;
}
constexpr bool orient3d_by_double_words(const point_table<double, 4, 3>& t, int& sign) noexcept {
  point_table<wide_int<2>, 4, 3> n{};
  if (!to_double_words(t, n)) return false;
  sign = orient3d_of(n);
  return true;
}
// The determinant of all four points with ones beside them, by its 24 products.
constexpr int orient3d_by_sum(const point_table<double, 4, 3>& t) noexcept {
  constexpr int rows[4][3] = {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}};  // all but one, in alternating order
  exact_accumulator<3> sum;
  for (const int(&row)[3] : rows)
    for (int i = 0; i < 3; ++i) {
      const double *const p = t.v + 3 * row[i], *const q = t.v + 3 * row[(i + 1) % 3];
      const double* const r = t.v + 3 * row[(i + 2) % 3];
      sum.add(p[0], q[1], r[2]);
      sum.subtract(p[0], q[2], r[1]);
    }
  return sum.sign();
}
// Coordinates are passed in registers, so that nothing has to wait for the memory.
IRG_NOINLINE constexpr int orient3d_beyond_words(double ax, double ay, double az, double bx, double by, double bz,
                                                 double cx, double cy, double cz, double dx, double dy,
                                                 double dz) noexcept {
  const point_table<double, 4, 3> t{{ax, ay, az, bx, by, bz, cx, cy, cz, dx, dy, dz}};
  int sign = 0;
  return orient3d_by_double_words(t, sign) ? sign : orient3d_by_sum(t);
}
IRG_NOINLINE constexpr int orient3d_exact(double ax, double ay, double az, double bx, double by, double bz, double cx,
                                          double cy, double cz, double dx, double dy, double dz) noexcept {
  int sign = 0;
  if (orient3d_by_words({{ax, ay, az, bx, by, bz, cx, cy, cz, dx, dy, dz}}, sign)) return sign;
  return orient3d_beyond_words(ax, ay, az, bx, by, bz, cx, cy, cz, dx, dy, dz);
}

}  // namespace IRG_ABI
}  // namespace detail

inline namespace IRG_ABI {

/// 1 when d lies on the side of the plane abc from which a, b, c are seen counter-clockwise, which is the sign of
/// plane_through(a, b, c) at d; -1 on the other side, 0 on the plane and when a, b, c lie on a line.
/// needs   finite coordinates
/// exact   for every float, double and integer, subnormals and extremes included, under all floating-point flags and
///         with subnormals flushed to zero; other scalars: as exact as their own + - * are
/// cost    about 40 operations on floats where the points are not nearly coplanar; else integers of 192 bits, of 384
///         where exponents differ by more than 8, and of 6400 where they differ by more than 72
/// source  Shewchuk 1997; Devillers and Pion 2003 (the filter)
template <Point P>
  requires(size_of<P> == 3)
IRG_INLINE constexpr int orient3d(const P& a, const P& b, const P& c,
                                  const P& d) noexcept(std::is_arithmetic_v<scalar_of<P>>) {
  using T = scalar_of<P>;
  if constexpr (Floating<T>) {
    const auto t = detail::table_of<double>(a, b, c, d);
    if (!detail::in_constant_evaluation())
      if (const int sign = detail::orient3d_filtered(t); sign != 0) return sign;
    return detail::orient3d_exact(t.v[0], t.v[1], t.v[2], t.v[3], t.v[4], t.v[5], t.v[6], t.v[7], t.v[8], t.v[9],
                                  t.v[10], t.v[11]);
  } else if constexpr (std::is_integral_v<T>) {
    using wide = std::conditional_t<sizeof(T) <= 2, std::int64_t,
                                    std::conditional_t<sizeof(T) <= 4, detail::wide_signed, wide_int<2>>>;
    return detail::orient3d_of(detail::table_of<wide>(a, b, c, d));
  } else {
    return detail::orient3d_of(detail::table_of<T>(a, b, c, d));
  }
}

}  // namespace IRG_ABI
}  // namespace irg
