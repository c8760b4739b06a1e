// SPDX-License-Identifier: MIT
// A plane in rounded numbers, with a bound of what they are off by: it tells the side of most points in a few
// operations, and says so where it does not.
#pragma once

#include <irg/math/error_free.hpp>
#include <irg/math/vec.hpp>

namespace irg::detail {

// A rounded value, and how far it may be off.
struct bounded_value {
  double value, bound;

  /// 1 or -1, or 0 where the bound leaves it open.
  IRG_INLINE constexpr int sign() const noexcept { return value > bound ? 1 : value < -bound ? -1 : 0; }
};

// normal . (p - at). With u = 2^-53, s the largest difference between corners along an axis and D that of p and `at`: a
// normal's coordinate is at most 2s^2 and off by less than 8.1u s^2; products with p - at and their sum are off by
// 24u s^2 D more, in all less than 49u s^2 D. `error` is 64u s^2. What subnormals lose is less than 2^-1000.
struct rounded_plane {
  double normal[3], at[3], error, size;  // size: the sum of the normal's absolute values

  // off   how far each coordinate of p may be off
  IRG_INLINE constexpr bounded_value operator()(const double (&p)[3], double off) const noexcept {
    constexpr double least = 0x1p-1000;
    const double dx = p[0] - at[0], dy = p[1] - at[1], dz = p[2] - at[2];
    const double reach = greater(greater(magnitude(dx), magnitude(dy)), magnitude(dz));
    const double value = product(normal[0], dx) + product(normal[1], dy) + product(normal[2], dz);
    return {value, product(error, reach) + product(size, off) + least};
  }
};

inline namespace IRG_ABI {

IRG_INLINE constexpr rounded_plane plane_of_corners(const double (&a)[3], const double (&b)[3],
                                                    const double (&c)[3]) noexcept {
  double u[3]{}, v[3]{}, s = 0;
  for (int k = 0; k < 3; ++k) {
    u[k] = b[k] - a[k];
    v[k] = c[k] - a[k];
    s = greater(s, greater(magnitude(u[k]), magnitude(v[k])));
  }
  rounded_plane p{{product(u[1], v[2]) - product(u[2], v[1]), product(u[2], v[0]) - product(u[0], v[2]),
                   product(u[0], v[1]) - product(u[1], v[0])},
                  {a[0], a[1], a[2]},
                  s > 0x1p-300 && s < 0x1p300 ? 0x1p-47 * product(s, s) : infinity<double>,
                  0};
  p.size = 1.01 * (magnitude(p.normal[0]) + magnitude(p.normal[1]) + magnitude(p.normal[2]));
  return p;
}

// Perpendicular to an axis. Its value is a difference, whose sign rounding leaves right.
IRG_INLINE constexpr rounded_plane plane_across(int axis, const double (&at)[3]) noexcept {
  rounded_plane p{{0, 0, 0}, {at[0], at[1], at[2]}, 0, 1.01};
  p.normal[axis] = 1;
  return p;
}

}  // namespace IRG_ABI

// The same for points without error, in fewer numbers: normal . p - offset. With R the largest coordinate of p and A
// that of `at`, the products and sums of normal . p and of `offset` are off by less than 24u s^2 R and 24u s^2 A, and
// the normal by 24.3u s^2 (R + A): `error` R + `error_at` is above both.
struct walked_plane {
  double normal[3], offset, error, error_at;

  IRG_INLINE constexpr explicit walked_plane(const rounded_plane& p) noexcept
      : normal{p.normal[0], p.normal[1], p.normal[2]},
        offset(product(p.normal[0], p.at[0]) + product(p.normal[1], p.at[1]) + product(p.normal[2], p.at[2])),
        error(greater(p.error, 0x1p-50 * p.size)),
        error_at(product(error, greater(greater(magnitude(p.at[0]), magnitude(p.at[1])), magnitude(p.at[2]))) +
                 0x1p-1000) {}

  // reach   the largest coordinate of p
  IRG_INLINE constexpr bounded_value operator()(const double (&p)[3], double reach) const noexcept {
    return {product(normal[0], p[0]) + product(normal[1], p[1]) + product(normal[2], p[2]) - offset,
            product(error, reach) + error_at};
  }
};

}  // namespace irg::detail
