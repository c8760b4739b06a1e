// SPDX-License-Identifier: MIT
// What sweeps of geometric functions over numbers of all sizes share: points and coefficients, each number a random one
// times 2^k, k from the whole range of exponents, or one of them far below or above the others; and how far results are
// off from rationals. Functions of test::mixed stand with the sweeps in the tests of what they sweep.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include <irg/geometry/line.hpp>
#include <irg/geometry/plane.hpp>

#include "geometry/exact_quotients.hpp"
#include "geometry/nearest_cases.hpp"
#include "support/mixed_magnitudes.hpp"

#ifdef IRG_HAVE_MPFR

namespace test::mixed {

using irg::point;
using irg::vec;
using E = big_rational;
using quotients::of;
using quotients::quotient_error;
using quotients::root_error;
using test::dot;
using test::exactly;
using test::place;
using test::operator-;

constexpr double wrong = 1e9;

template <class T>
std::string named(const char* what) {
  return std::string(what) + (sizeof(T) == 4 ? ", float" : ", double");
}

// Points of mixed sizes; some share coordinates, of some the last is near the line through the first two.
template <class T, int N, std::size_t Count>
std::array<point<T, N>, Count> points(test::random& r, sizes which) {
  std::array<point<T, N>, Count> p{};
  const auto kind = r.integer(0, 3);
  for (std::size_t i = 0; i < Count; ++i)
    for (int k = 0; k < N; ++k)
      p[i][k] = kind == 1 && i > 0 && r.integer(0, 2) == 0 ? p[i - 1][k] : number<T>(r, which);
  if (kind == 2 && Count > 2) {
    const T t = static_cast<T>(3 * r.unit() - 1);
    for (int k = 0; k < N; ++k) {
      const T near = p[0][k] + (p[1][k] - p[0][k]) * t;
      if (std::isfinite(near)) p[Count - 1][k] = near;
    }
  }
  return p;
}

template <std::size_t D>
E gram(const place<D>& u, const place<D>& v) {
  return dot(u, u) * dot(v, v) - dot(u, v) * dot(u, v);
}

template <class T>
E twice_area(const point<T, 2>& a, const point<T, 2>& b, const point<T, 2>& c) {
  return of(a.x) * (of(b.y) - of(c.y)) + of(b.x) * (of(c.y) - of(a.y)) + of(c.x) * (of(a.y) - of(b.y));
}

template <class T>
int sign_of(T x) {
  return (x > 0) - (x < 0);
}

template <class T>
double off_from_area(T got, const E& twice) {
  const bool no_sign = got == 0 && abs(twice) < of(std::numeric_limits<T>::denorm_min()) * 4;
  if (!no_sign && sign_of(got) != twice.sign()) return wrong;
  return error_in_ulp(got, twice.times_power_of_two(-1));
}

template <class T>
std::vector<point<T, 2>> any_ring(test::random& r, sizes which) {
  const auto p = points<T, 2, 6>(r, which);
  return {p.begin(), p.begin() + r.integer(3, 6)};
}
template <class T>
const point<T, 2>& after(const std::vector<point<T, 2>>& ring, std::size_t i) {
  return ring[(i + 1) % ring.size()];
}
template <class T>
E twice_area(const std::vector<point<T, 2>>& ring) {
  E twice = 0;  // by trapezia
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const auto &p = ring[i], &q = after(ring, i);
    twice = twice + (of(p.x) - of(q.x)) * (of(p.y) + of(q.y));
  }
  return twice;
}

template <class T, std::size_t N>
std::array<E, N> rationals(const std::array<T, N>& x) {
  std::array<E, N> e;
  for (std::size_t i = 0; i < N; ++i) e[i] = of(x[i]);
  return e;
}

// The error of coefficients that may all be multiplied by one power of two, where the largest one is beyond the range
// or the largest of the first `leading` so small that digits are lost.
template <class T, std::size_t N>
double error_together(const std::array<T, N>& got, const std::array<E, N>& want, std::size_t leading) {
  std::size_t most = 0, lead = 0;
  for (std::size_t i = 0; i < N; ++i) {
    if (!std::isfinite(got[i])) return wrong;
    if (abs(want[most]) < abs(want[i])) most = i;
    if (i < leading && abs(want[lead]) < abs(want[i])) lead = i;
  }
  const test::quotients::near_number exact(want[most]), rounded(of(got[most]));
  if (rounded.value == 0) return wrong;
  int shift = rounded.exponent - exact.exponent;
  const double ratio = rounded.value / exact.value;
  if (ratio > 1.5) ++shift;
  if (ratio < 0.75) --shift;
  const int high = std::numeric_limits<T>::max_exponent - 5;
  const int low = std::numeric_limits<T>::min_exponent + std::numeric_limits<T>::digits + 2;
  if (shift != 0 && exact.exponent < high && want[lead].exponent() > low) return wrong;
  double worst = 0;
  for (std::size_t i = 0; i < N; ++i) worst = std::fmax(worst, error_in_ulp(got[i], want[i].times_power_of_two(shift)));
  return worst;
}

template <std::size_t N>
bool all_zero(const std::array<E, N>& x) {
  for (const E& v : x)
    if (v.sign() != 0) return false;
  return true;
}

template <class T, std::size_t N>
std::array<T, N> numbers(test::random& r, sizes which) {
  std::array<T, N> x{};
  for (T& v : x) v = number<T>(r, which);
  return x;
}

// The cross product as the minors of two rows.
inline std::array<E, 3> minors(const std::array<E, 3>& a, const std::array<E, 3>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline E determinant(const std::array<E, 3>& a, const std::array<E, 3>& b, const std::array<E, 3>& c) {
  return a[0] * (b[1] * c[2] - b[2] * c[1]) - b[0] * (a[1] * c[2] - a[2] * c[1]) + c[0] * (a[1] * b[2] - a[2] * b[1]);
}

// A number p/q, q > 0, in no lowest terms.
struct quotient {
  E p = 0, q = 1;
};
inline bool operator<(const quotient& a, const quotient& b) { return a.p * b.q < b.p * a.q; }

// The nearest point of a segment to p: its parameter, cut off at the ends, and the squared distance.
template <std::size_t D>
struct segment_foot {
  quotient t, squared;
  segment_foot(const place<D>& a, const place<D>& b, const place<D>& p) {
    const auto u = b - a, w = p - a, v = p - b;
    t = {dot(u, w), dot(u, u)};
    if (t.p.sign() <= 0)
      t = {E(0), E(1)}, squared = {dot(w, w), E(1)};
    else if (!(t.p < t.q))
      t = {E(1), E(1)}, squared = {dot(v, v), E(1)};
    else
      squared = {gram(u, w), t.q};
  }
};
// The point at t between a and b.
template <class T, int N>
double off_between(const point<T, N>& got, const point<T, N>& a, const point<T, N>& b, const quotient& t) {
  double worst = 0;
  for (int k = 0; k < N; ++k)
    worst = std::fmax(worst, quotient_error(got[k], of(a[k]) * (t.q - t.p) + of(b[k]) * t.p, t.q));
  return worst;
}

// Squared distance of lines, and the parameters of the nearest points; q is 0 for parallel ones.
struct lines_foot {
  quotient t, s, squared;
  lines_foot(const place<3>& a, const place<3>& b, const place<3>& c, const place<3>& d) {
    const auto u = b - a, v = d - c, w = c - a;
    const E uu = dot(u, u), uv = dot(u, v), vv = dot(v, v), uw = dot(u, w), vw = dot(v, w), n = uu * vv - uv * uv;
    const E volume = determinant(u, v, w);
    t = {uw * vv - vw * uv, n}, s = {uw * uv - vw * uu, n}, squared = {volume * volume, n};
  }
  bool is_inside() const {
    return t.q.sign() > 0 && t.p.sign() >= 0 && !(t.q < t.p) && s.p.sign() >= 0 && !(s.q < s.p);
  }
};

template <class T, int N>
quotient squared_distance_of_segments(const std::array<point<T, N>, 4>& p) {
  const auto a = exactly(p[0]), b = exactly(p[1]), c = exactly(p[2]), d = exactly(p[3]);
  quotient least = segment_foot(c, d, a).squared;
  for (const auto& other : {segment_foot(c, d, b), segment_foot(a, b, c), segment_foot(a, b, d)})
    if (other.squared < least) least = other.squared;
  if constexpr (N == 3) {
    const lines_foot lines(a, b, c, d);
    if (lines.is_inside() && lines.squared < least) least = lines.squared;
  } else {
    const auto turn = [&](std::size_t i, std::size_t j, std::size_t k) { return twice_area(p[i], p[j], p[k]).sign(); };
    if (turn(0, 1, 2) * turn(0, 1, 3) < 0 && turn(2, 3, 0) * turn(2, 3, 1) < 0) least = {E(0), E(1)};
  }
  return least;
}

// The nearest point of a triangle: on its face, or the nearest one of its edges.
struct triangle_nearest {
  std::array<E, 3> weight{};
  E whole = 0;
  quotient squared;
  triangle_nearest(const place<3>& a, const place<3>& b, const place<3>& c, const place<3>& p) {
    const auto u = b - a, v = c - a, w = p - a;
    const E uu = dot(u, u), uv = dot(u, v), vv = dot(v, v), uw = dot(u, w), vw = dot(v, w);
    whole = uu * vv - uv * uv;
    weight[1] = uw * vv - vw * uv, weight[2] = vw * uu - uw * uv, weight[0] = whole - weight[1] - weight[2];
    if (whole.sign() > 0 && weight[0].sign() >= 0 && weight[1].sign() >= 0 && weight[2].sign() >= 0) {
      const E volume = determinant(u, v, w);
      squared = {volume * volume, whole};
      return;
    }
    const place<3>* corner[3] = {&a, &b, &c};
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3;
      const segment_foot foot(*corner[i], *corner[j], p);
      if (i > 0 && !(foot.squared < squared)) continue;
      squared = foot.squared, whole = foot.t.q;
      weight = {E(0), E(0), E(0)}, weight[j] = foot.t.p, weight[i] = foot.t.q - foot.t.p;
    }
  }
};

// Cramer's rule: column k of the rows replaced by the right side.
inline E replaced(std::array<std::array<E, 3>, 3> rows, const std::array<E, 3>& right, std::size_t k) {
  for (std::size_t i = 0; i < 3; ++i) rows[i][k] = right[i];
  return determinant(rows[0], rows[1], rows[2]);
}
inline E replaced(std::array<std::array<E, 2>, 2> rows, const std::array<E, 2>& right, std::size_t k) {
  for (std::size_t i = 0; i < 2; ++i) rows[i][k] = right[i];
  return rows[0][0] * rows[1][1] - rows[0][1] * rows[1][0];
}

// |got - exact| over the bound u * factor * size.
template <class T>
double share_of(T got, const E& exact, double factor, const E& size) {
  if (!std::isfinite(got)) return wrong;
  const test::quotients::near_number off(of(got) - exact), unit(size * E(factor));
  if (off.value == 0) return 0;
  const int place = std::numeric_limits<T>::digits;
  return std::fabs(std::ldexp(off.value / unit.value, off.exponent - unit.exponent + place));
}
// Whether terms stay in the range.
template <class T>
bool in_range(const E& term) {
  return term.sign() == 0 || (term.exponent() > std::numeric_limits<T>::min_exponent + 2 &&
                              term.exponent() < std::numeric_limits<T>::max_exponent - 4);
}

// How far the coefficients of a line, or of a plane, are off from those wanted.
template <class T>
double off_from_line(const std::optional<irg::line<T>>& got, const std::array<E, 3>& want) {
  if (got.has_value() == all_zero(want)) return wrong;
  return got ? error_together<T, 3>({got->a, got->b, got->c}, want, 3) : 0.0;
}
template <class T>
double off_from_plane(const std::optional<irg::plane<T>>& got, const std::array<E, 4>& want) {
  const bool exists = want[0].sign() != 0 || want[1].sign() != 0 || want[2].sign() != 0;
  if (got.has_value() != exists) return wrong;
  return got ? error_together<T, 4>({got->a, got->b, got->c, got->d}, want, 3) : 0.0;
}
// The coefficients of the plane through three points, as determinants with a row of the matrix left out.
inline std::array<E, 4> plane_coefficients(const std::array<E, 4>& p, const std::array<E, 4>& q,
                                           const std::array<E, 4>& s) {
  const auto without = [&](std::size_t i, std::size_t j, std::size_t k) {
    return determinant({p[i], p[j], p[k]}, {q[i], q[j], q[k]}, {s[i], s[j], s[k]});
  };
  return {without(1, 2, 3), -without(0, 2, 3), without(0, 1, 3), -without(0, 1, 2)};
}

}  // namespace test::mixed

#endif
