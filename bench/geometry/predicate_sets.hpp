// SPDX-License-Identifier: MIT
// The points that predicates are measured on: easy ones, and sets whose difficulty is known. Made from integers and
// guarded products, so that every flag set measures the same numbers.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include <irg/core/contraction.hpp>

#include "support/measure.hpp"
#include "support/random_numbers.hpp"

namespace bench {

/// The arguments of one call: N points of D coordinates.
template <class T, int N, int D>
using arguments = std::array<std::array<T, static_cast<std::size_t>(D)>, static_cast<std::size_t>(N)>;

template <class T, int N, int D>
struct point_set {
  std::string name;
  std::vector<arguments<T, N, D>> calls{};
};

inline int calls_of(int full) { return smoke() ? full / 16 : full; }

/// Coordinates made one by one by f(random numbers).
template <class T, int N, int D, class F>
point_set<T, N, D> set_of(const std::string& name, F f, int calls = 4096) {
  point_set<T, N, D> s{name, {}};
  random_numbers r{static_cast<std::uint64_t>(N * 10 + D)};
  s.calls.resize(static_cast<std::size_t>(calls_of(calls)));
  for (auto& call : s.calls)
    for (auto& p : call)
      for (T& c : p) c = f(r);
  return s;
}

template <int N, int D>
std::array<double, static_cast<std::size_t>(D)> combination(const arguments<double, N, D>& p, random_numbers& r) {
  std::array<double, static_cast<std::size_t>(D)> sum = p[0];
  for (std::size_t k = 1; k < static_cast<std::size_t>(D); ++k) {
    const double t = r.unit();
    for (std::size_t j = 0; j < sum.size(); ++j) sum[j] += irg::product(t, p[k][j] - p[0][j]);
  }
  return sum;
}

/// A point of the unit circle or sphere (stereographic projection), rounded.
template <int D>
std::array<double, static_cast<std::size_t>(D)> on_sphere(random_numbers& r) {
  std::array<double, static_cast<std::size_t>(D)> p{};
  double squares = 0;
  for (std::size_t j = 0; j + 1 < p.size(); ++j) {
    p[j] = 4 * r.unit() - 2;
    squares += irg::product(p[j], p[j]);
  }
  for (std::size_t j = 0; j + 1 < p.size(); ++j) p[j] = 2 * p[j] / (1 + squares);
  p.back() = (1 - squares) / (1 + squares);
  return p;
}

/// Points as nearly on one line, plane (N = D + 1), circle or sphere (N = D + 2) as roundings leave them.
template <int N, int D>
point_set<double, N, D> nearly_degenerate(const std::string& name) {
  auto s = set_of<double, N, D>(name, [](random_numbers& r) { return r.unit(); });
  random_numbers r{static_cast<std::uint64_t>(N)};
  for (auto& call : s.calls) {
    if (N == D + 1) call.back() = combination<N, D>(call, r);
    if (N == D + 2)
      for (auto& p : call) p = on_sphere<D>(r);
  }
  return s;
}

/// The same, each call at a size of its own from 2^-1074 to 2^1000.
template <int N, int D>
point_set<double, N, D> nearly_degenerate_at_all_sizes(const std::string& name) {
  auto s = nearly_degenerate<N, D>(name);
  random_numbers r{3};
  for (auto& call : s.calls) {
    const int exponent = r.integer(-1074, 1000);
    for (auto& p : call)
      for (double& c : p) c = std::ldexp(c, exponent);
  }
  return s;
}

/// One point of the call walks over a grid of neighbouring doubles; the others stand.
template <int N, int D>
point_set<double, N, D> ulp_grid(const std::string& name, const arguments<double, N, D>& base, std::size_t walker,
                                 int width) {
  point_set<double, N, D> s{name, {}};
  if (smoke()) width /= 4;
  const auto steps = [](double x) { return std::nextafter(x, 1e300) - x; };
  std::array<int, 3> at{};
  for (at[2] = 0; at[2] < (D == 3 ? width : 1); ++at[2])
    for (at[1] = 0; at[1] < width; ++at[1])
      for (at[0] = 0; at[0] < width; ++at[0]) {
        auto call = base;
        for (std::size_t j = 0; j < static_cast<std::size_t>(D); ++j) call[walker][j] += at[j] * steps(base[walker][j]);
        s.calls.push_back(call);
      }
  return s;
}

inline double any_double(random_numbers& r) {
  return std::ldexp(r.unit() + 0.5, r.integer(-1074, 1000)) * (r.integer(0, 1) ? 1 : -1);
}
inline double lattice_256(random_numbers& r) { return r.integer(0, 255); }
inline double subnormal_lattice(random_numbers& r) { return r.integer(-8, 8) * 0x1p-1074; }
inline std::int64_t any_int64(random_numbers& r) { return static_cast<std::int64_t>(r.next()); }

/// The sets that every predicate has.
template <int N, int D>
std::vector<point_set<double, N, D>> common_sets() {
  return {set_of<double, N, D>("random", [](random_numbers& r) { return r.unit(); }),
          nearly_degenerate<N, D>("nearly degenerate"),
          nearly_degenerate_at_all_sizes<N, D>("nearly degenerate at 2^-1074 to 2^1000"),
          set_of<double, N, D>("mixed exponents", any_double),
          set_of<double, N, D>("lattice 256", lattice_256),
          set_of<double, N, D>("subnormal lattice", subnormal_lattice)};
}

}  // namespace bench
