// SPDX-License-Identifier: MIT
// The predicates that N points of D coordinates have: irg's own, and determinants as textbooks have them.
#pragma once

#include <array>
#include <cstddef>

#include <irg/geometry/in_circle.hpp>
#include <irg/geometry/orient2d.hpp>
#include <irg/geometry/orient3d.hpp>

#include "geometry/predicate_sets.hpp"

namespace bench {

template <class T, int D>
irg::point<T, D> as_point(const std::array<T, static_cast<std::size_t>(D)>& c) {
  return irg::generate_coordinates<irg::point<T, D>>([&](int j) { return c[static_cast<std::size_t>(j)]; });
}

template <class T, int N, int D>
std::vector<std::array<irg::point<T, D>, static_cast<std::size_t>(N)>> own_points(const point_set<T, N, D>& s) {
  std::vector<std::array<irg::point<T, D>, static_cast<std::size_t>(N)>> points(s.calls.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t k = 0; k < points[i].size(); ++k) points[i][k] = as_point<T, D>(s.calls[i][k]);
  return points;
}

template <int N, int D, class Points>
int irg_sign(const Points& p) {
  if constexpr (N == 3)
    return irg::orient2d(p[0], p[1], p[2]);
  else if constexpr (N == 4 && D == 3)
    return irg::orient3d(p[0], p[1], p[2], p[3]);
  else if constexpr (N == 4)
    return irg::in_circle(p[0], p[1], p[2], p[3]);
  else
    return irg::in_sphere(p[0], p[1], p[2], p[3], p[4]);
}

/// The determinant of the rows of differences from the last point, in numbers of type R.
template <class R, class T, int N, int D>
R textbook_determinant(const arguments<T, N, D>& p) {
  R m[4][4];
  for (std::size_t i = 0; i + 1 < p.size(); ++i) {
    R squares = 0;
    for (std::size_t j = 0; j < static_cast<std::size_t>(D); ++j) {
      m[i][j] = static_cast<R>(p[i][j]) - static_cast<R>(p.back()[j]);
      squares += m[i][j] * m[i][j];
    }
    if (N == D + 2) m[i][D] = squares;
  }
  const auto two = [&](int i, int j) { return m[i][0] * m[j][1] - m[j][0] * m[i][1]; };
  const auto three = [&](int i, int j, int k) {
    return m[i][2] * two(j, k) + m[j][2] * two(k, i) + m[k][2] * two(i, j);
  };
  R value;
  if constexpr (N == 3)
    value = two(0, 1);
  else if constexpr (N == 4)
    value = three(0, 1, 2);
  else
    value = m[3][3] * three(0, 1, 2) - m[2][3] * three(0, 1, 3) + m[1][3] * three(0, 2, 3) - m[0][3] * three(1, 2, 3);
  return D == 3 ? -value : value;
}

}  // namespace bench
