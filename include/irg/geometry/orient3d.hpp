// SPDX-License-Identifier: MIT
// On which side of the plane through three points a fourth one lies, decided exactly.
#pragma once

#include <type_traits>

#include <irg/core/coordinates.hpp>
#include <irg/geometry/detail/predicate_kernel.hpp>
#include <irg/math/error_free.hpp>

namespace irg::inline IRG_ABI {

/// 1 when d lies on the side of the plane abc from which a, b, c are seen counter-clockwise, which is the sign of
/// plane_through(a, b, c) at d; -1 on the other side, 0 on the plane and when a, b, c lie on a line.
/// needs   finite coordinates
/// exact   for every float, double and integer, subnormals and extremes included, under all floating-point flags and
///         with subnormals flushed to zero; other scalars: as exact as their own + - * are
/// cost    about 40 operations on floats where the points are not nearly coplanar, else 200 where multiply-adds are
///         fused; integers of 192 bits where that leaves it open, of 384 where exponents differ by more than 8; beyond
///         72 another 400 operations on floats, and an exact sum of 24 products for points nearly coplanar even so
/// source  Shewchuk 1997; Devillers and Pion 2003 (the filter)
template <Point P>
  requires(size_of<P> == 3)
[[nodiscard]] IRG_INLINE constexpr int orient3d(const P& a, const P& b, const P& c,
                                                const P& d) noexcept(std::is_arithmetic_v<scalar_of<P>>);

IRG_REFUSES_VECTORS(orient3d);

}  // namespace irg::inline IRG_ABI

namespace irg::detail::inline IRG_ABI {

// The determinant of the rows b, a, c, six times a volume: that of plane_through(a, b, c) at the origin.
template <class T>
IRG_INLINE constexpr auto difference_determinant(const point_table<T, 3, 3>& t) {
  const T *const a = t.v, *const b = t.v + 3, *const c = t.v + 6;
  return (c[0] * b[1] - c[1] * b[0]) * a[2] + (a[0] * c[1] - a[1] * c[0]) * b[2] + (b[0] * a[1] - b[1] * a[0]) * c[2];
}

// The sign, or 0 where rounded arithmetic cannot tell.
//
// With X, Y, Z the sizes of the largest differences along the axes, each of the determinant's six products is at most
// X*Y*Z and passes at most 8 roundings: three of differences, two of its own, and those of three sums. So the result is
// off by less than 6*((1 + u)^8 - 1)*X*Y*Z < 48.001u*X*Y*Z; the factor below, for 8*X*Y*Z, makes 48u(1 + 2^-9). What
// subnormals lose, less than 2^-1020 in each difference and product, is less than the bound's share from `least`, as
// in orient2d. The 8 keeps everything finite where the bound is: partial sums are at most 6*X*Y*Z.
IRG_INLINE constexpr int filtered_sign(const point_table<double, 4, 3>& t, double least) noexcept {
  constexpr double factor = 0x1.80cp-51;
  const auto d = relative_to_last(t);
  const double volume = difference_determinant(d);
  const double bound = (reach(d, 0) + least) * (reach(d, 1) * 8 + least) * (reach(d, 2) + least) * factor;
  return magnitude(volume) > bound ? sign_of_nonzero(volume) : 0;
}

#if IRG_BODIES
// The same with the rounding errors of differences, products and sums.
//
// Of p*q - r*s, for p and r below X and q and s below Y, the low part is below 9u*X*Y, made with at most 8 roundings;
// what is left out, products of two errors, is 2u^2*X*Y. So each product with a third difference is off by less than
// 74u^2*X*Y*Z, and 9u^2 for the low part times an error of that difference; its low part is below 14u*X*Y*Z, made with
// 4 roundings: 139u^2 in all, three of which make 417u^2. The sum's low parts are below 42u and 10u, from errors of
// partial sums below 4 and 6*X*Y*Z, and pass 4 roundings: 208u^2. The last sum's rounding does not change its sign. The
// bound is 1024u^2*X*Y*Z. Subnormals and overflow are met as in orient2d, with `least`.
IRG_INLINE constexpr int orient3d_compensated(const point_table<double, 4, 3>& t) noexcept {
  constexpr double factor = 0x1p-96, least = 0x1p-300;
  using number = exact_sum<double>;
  const auto difference = [&](int i, int k) { return two_sum(t(i, k), -t(3, k)); };
  const number ax = difference(0, 0), ay = difference(0, 1), az = difference(0, 2);
  const number bx = difference(1, 0), by = difference(1, 1), bz = difference(1, 2);
  const number cx = difference(2, 0), cy = difference(2, 1), cz = difference(2, 2);
  const auto term = [](const number& p, const number& q, const number& r, const number& s, const number& z) -> number {
    const number left = fast_two_product(p.value, q.value), right = fast_two_product(r.value, s.value);
    const number area = two_sum(left.value, -right.value);
    const double left_error = left.error + (p.value * q.error + p.error * q.value);
    const double right_error = right.error + (r.value * s.error + r.error * s.value);
    const number volume = fast_two_product(area.value, z.value);
    const double low = area.error + (left_error - right_error);
    return {volume.value, volume.error + (area.value * z.error + low * z.value)};
  };
  const number a = term(cx, by, cy, bx, az), b = term(ax, cy, ay, cx, bz), c = term(bx, ay, by, ax, cz);
  const number ab = two_sum(a.value, b.value), abc = two_sum(ab.value, c.value);
  const double volume = abc.value + ((ab.error + abc.error) + ((a.error + b.error) + c.error));
  const auto size = [](const number& p, const number& q, const number& r) {
    return maximum(maximum(magnitude(p.value), magnitude(q.value)), magnitude(r.value)) + least;
  };
  return magnitude(volume) > size(ax, bx, cx) * size(ay, by, cy) * size(az, bz, cz) * factor ? sign_of_nonzero(volume)
                                                                                             : 0;
}

IRG_INLINE constexpr int compensated_sign(const point_table<double, 4, 3>& t) noexcept {
  return has_fused_multiply_add ? orient3d_compensated(t) : 0;  // integers are faster where nothing is fused
}
#endif

}  // namespace irg::detail::inline IRG_ABI

namespace irg::inline IRG_ABI {

template <Point P>
  requires(size_of<P> == 3)
[[nodiscard]] constexpr int orient3d(const P& a, const P& b, const P& c,
                                     const P& d) noexcept(std::is_arithmetic_v<scalar_of<P>>) {
  return detail::predicate(a, b, c, d);
}

}  // namespace irg::inline IRG_ABI
