// SPDX-License-Identifier: MIT
// Oracles of closest_point and distance: nearest points in rationals of any size, by comparing all candidates.
#pragma once

#include "support/exact.hpp"

#ifdef IRG_HAVE_MPFR
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include <irg/math/vec.hpp>

namespace test {

template <std::size_t D>
using place = std::array<exact, D>;

template <std::size_t D>
place<D> operator-(const place<D>& a, const place<D>& b) {
  place<D> r;
  for (std::size_t i = 0; i < D; ++i) r[i] = a[i] - b[i];
  return r;
}
template <std::size_t D>
exact dot(const place<D>& a, const place<D>& b) {
  exact sum = 0;
  for (std::size_t i = 0; i < D; ++i) sum = sum + a[i] * b[i];
  return sum;
}
template <std::size_t D>
place<D> between(const place<D>& a, const place<D>& b, const exact& t) {
  place<D> r;
  for (std::size_t i = 0; i < D; ++i) r[i] = a[i] + t * (b[i] - a[i]);
  return r;
}
template <class T, int N>
place<static_cast<std::size_t>(N)> exactly(const irg::point<T, N>& p) {
  place<static_cast<std::size_t>(N)> e;
  for (int i = 0; i < N; ++i) e[static_cast<std::size_t>(i)] = exact(static_cast<double>(p[i]));
  return e;
}

template <std::size_t D>
place<D> nearest_on_segment(const place<D>& a, const place<D>& b, const place<D>& p) {
  const exact length = dot(b - a, b - a);
  if (length.sign() == 0) return a;
  const exact t = dot(p - a, b - a) / length;
  return t.sign() < 0 ? a : exact(1) < t ? b : between(a, b, t);
}

template <std::size_t D>
const place<D>& nearest_of(const std::vector<place<D>>& candidates, const place<D>& p) {
  std::size_t best = 0;
  for (std::size_t i = 1; i < candidates.size(); ++i)
    if (dot(candidates[i] - p, candidates[i] - p) < dot(candidates[best] - p, candidates[best] - p)) best = i;
  return candidates[best];
}

/// The foot on the face, where it is inside, and the nearest points of the edges are the candidates.
inline place<3> nearest_on_triangle(const place<3>& a, const place<3>& b, const place<3>& c, const place<3>& p) {
  std::vector<place<3>> candidates{nearest_on_segment(a, b, p), nearest_on_segment(b, c, p),
                                   nearest_on_segment(c, a, p)};
  const place<3> u = b - a, v = c - a, w = p - a;
  const exact uu = dot(u, u), uv = dot(u, v), vv = dot(v, v), n = uu * vv - uv * uv;
  if (n.sign() != 0) {
    const exact s = (dot(w, u) * vv - dot(w, v) * uv) / n, t = (dot(w, v) * uu - dot(w, u) * uv) / n;
    place<3> foot;
    for (std::size_t i = 0; i < 3; ++i) foot[i] = a[i] + s * u[i] + t * v[i];
    if (s.sign() >= 0 && t.sign() >= 0 && !(exact(1) < s + t)) candidates.push_back(foot);
  }
  return nearest_of(candidates, p);
}

/// The squared distance of two segments: of the lines where both feet are inside, and of the four ends.
template <std::size_t D>
exact squared_distance_of_segments(const place<D>& a, const place<D>& b, const place<D>& c, const place<D>& d) {
  const auto squared = [](const place<D>& p, const place<D>& q) { return dot(p - q, p - q); };
  exact least = squared(a, nearest_on_segment(c, d, a));
  const auto consider = [&](const exact& other) { least = other < least ? other : least; };
  consider(squared(b, nearest_on_segment(c, d, b)));
  consider(squared(c, nearest_on_segment(a, b, c)));
  consider(squared(d, nearest_on_segment(a, b, d)));
  const place<D> u = b - a, v = d - c, w = c - a;
  const exact uu = dot(u, u), uv = dot(u, v), vv = dot(v, v), n = uu * vv - uv * uv;
  if (n.sign() == 0) return least;
  const exact t = (dot(w, u) * vv - dot(w, v) * uv) / n, s = (dot(w, u) * uv - dot(w, v) * uu) / n;
  if (t.sign() >= 0 && !(exact(1) < t) && s.sign() >= 0 && !(exact(1) < s))
    consider(squared(between(a, b, t), between(c, d, s)));
  return least;
}

/// The error of a root in units in the last place, from the exact square.
template <class T>
double root_error_in_ulp(T got, const exact& squared) {
  const exact largest(static_cast<double>((std::numeric_limits<T>::max)()));
  if (std::isinf(got) && got > 0) return largest * largest < squared ? 0 : 1e9;
  if (squared.sign() == 0 || got == 0) return got == 0 && squared < exact(1e-300) * exact(1e-300) ? 0 : 1e9;
  exact root(static_cast<double>(got));
  for (int step = 0; step < 3; ++step) root = (root + squared / root) / exact(2);  // Newton
  return error_in_ulp(got, root);
}

}  // namespace test
#endif
