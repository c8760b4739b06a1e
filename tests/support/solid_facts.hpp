// SPDX-License-Identifier: MIT
// Volumes of combinations of bodies in rationals, from what corners are made of, and whether surfaces are closed.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include <irg/solid/boolean.hpp>

#include "support/big_rational.hpp"

namespace test {

#ifdef IRG_HAVE_MPFR
using rational_point = std::array<big_rational, 3>;

inline rational_point minus(const rational_point& a, const rational_point& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
inline rational_point cross(const rational_point& a, const rational_point& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline big_rational dot(const rational_point& a, const rational_point& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline rational_point on_way(const rational_point& a, const rational_point& b, const big_rational& t) {
  const rational_point w = minus(b, a);
  return {a[0] + t * w[0], a[1] + t * w[1], a[2] + t * w[2]};
}

/// What a corner of a combination is, in rationals.
inline rational_point exact_corner(const irg::solid_corner_origin& c, const std::vector<rational_point>& p) {
  constexpr std::uint32_t none = irg::no_index;
  if (c.of[1] == none) return p[c.of[0]];
  if (c.of[5] != none) {
    const auto normal = [&](std::size_t k) {
      return cross(minus(p[c.of[k + 1]], p[c.of[k]]), minus(p[c.of[k + 2]], p[c.of[k]]));
    };
    const rational_point n[3] = {normal(0), normal(3), normal(6)};
    const rational_point h[3] = {cross(n[1], n[2]), cross(n[2], n[0]), cross(n[0], n[1])};
    const big_rational all = dot(n[0], h[0]);
    rational_point sum{big_rational(0), big_rational(0), big_rational(0)};
    for (std::size_t k = 0; k < 3; ++k)
      for (std::size_t i = 0; i < 3; ++i) sum[i] = sum[i] + h[k][i] * dot(n[k], p[c.of[3 * k]]) / all;
    return sum;
  }
  const rational_point &a = p[c.of[0]], &b = p[c.of[1]], &q = p[c.of[2]], u = minus(p[c.of[3]], q);
  if (c.of[4] != none) {
    const rational_point n = cross(u, minus(p[c.of[4]], q));
    return on_way(a, b, dot(n, minus(q, a)) / dot(n, minus(b, a)));
  }
  const rational_point n = cross(minus(b, a), u);
  return on_way(a, b, dot(cross(minus(q, a), u), n) / dot(n, n));
}

inline std::vector<rational_point> rational_points(const irg::mesh<double>& m) {
  std::vector<rational_point> all;
  for (const auto& p : m.positions) all.push_back({big_rational(p.x), big_rational(p.y), big_rational(p.z)});
  return all;
}

/// Six times the volume of a mesh of triangles with these corners.
inline big_rational six_volumes(const irg::mesh<double>& m, const std::vector<rational_point>& corners) {
  big_rational sum = 0;
  for (std::size_t f = 0; f < m.face_count(); ++f) {
    const auto at = [&](std::size_t k) -> const rational_point& { return corners[m.corner(f, k).position]; };
    for (std::size_t k = 2; k < m.face_size(f); ++k) sum = sum + dot(at(0), cross(at(k - 1), at(k)));
  }
  return sum;
}

/// Six times the volume of a combination of bodies.
inline big_rational six_volumes(const irg::solid_boolean_result<double>& r,
                                const std::vector<irg::mesh<double>>& bodies) {
  std::vector<rational_point> given;
  for (const auto& body : bodies)
    for (const auto& p : rational_points(body)) given.push_back(p);
  std::vector<rational_point> corners;
  for (const auto& c : r.corners) corners.push_back(exact_corner(c, given));
  return six_volumes(r.value, corners);
}

#endif

/// Whether faces run along each edge as often one way as the other.
template <class T>
bool is_balanced(const irg::mesh<T>& m) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> walks;
  for (std::size_t f = 0; f < m.face_count(); ++f)
    for (std::size_t k = 0, n = m.face_size(f); k < n; ++k) {
      const std::uint32_t a = m.corner(f, k).position, b = m.corner(f, k + 1 < n ? k + 1 : 0).position;
      if (a == b) return false;
      walks[{a < b ? a : b, a < b ? b : a}] += a < b ? 1 : -1;
    }
  for (const auto& [edge, sum] : walks)
    if (sum != 0) return false;
  return true;
}

}  // namespace test
