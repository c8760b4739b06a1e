// SPDX-License-Identifier: MIT
// Points that are hard for geometric predicates: eleven distributions, from seeded integers alone. Those that are not
// uniform lie on or close to a common line, plane, circle or sphere, as `figure` says.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>

#include <irg/core/contraction.hpp>

#include "support/random.hpp"

namespace test {

enum class distribution {
  uniform,
  ulp_grid,  // one point in a grid of ulps at (0.5, 0.5), against others on three bases (Kettner et al. 2008)
  near_figure,  // rounded points of the figure
  smallest,  // near_figure or uniform, in multiples of 2^-1074
  scaled_down,  // ... scaled by 2^-500
  scaled_up,  // ... by 2^500
  largest,  // ... by 2^1000
  subnormal_lattice,
  mixed_exponents,
  byte_lattice,
  integer_extremes,  // near the ends of 64 bits, and near zero
};
inline constexpr int distribution_count = 11;
constexpr const char* name_of(distribution d) {
  constexpr const char* names[] = {"uniform",          "ulp grid",     "near the figure",  "smallest",
                                   "scaled by 2^-500", "by 2^500",     "by 2^1000",        "subnormal lattice",
                                   "mixed exponents",  "byte lattice", "extremes of int64"};
  return names[static_cast<int>(d)];
}

enum class figure { flat, round };

/// M points of D coordinates.
template <class T, int M, int D>
using points = std::array<std::array<T, static_cast<std::size_t>(D)>, static_cast<std::size_t>(M)>;

/// x * 2^exponent, rounded towards zero where it is subnormal; by integers, so that no mode of the processor counts.
constexpr double scaled(double x, int exponent) {
  auto bits = std::bit_cast<std::uint64_t>(x);
  const std::uint64_t sign = bits >> 63 << 63;
  bits &= ~sign;
  if (bits == 0) return x;
  const int field = static_cast<int>(bits >> 52) + exponent;
  std::uint64_t significand = (bits & ((std::uint64_t{1} << 52) - 1)) | (std::uint64_t{1} << 52);
  if (bits >> 52 == 0) return x;  // subnormals stay where they are
  if (field >= 2047) return std::bit_cast<double>(sign | 0x7fefffffffffffffu);
  if (field >= 1)
    return std::bit_cast<double>(sign | (static_cast<std::uint64_t>(field) << 52) |
                                 (significand & ((std::uint64_t{1} << 52) - 1)));
  significand = 1 - field < 64 ? significand >> (1 - field) : 0;
  return std::bit_cast<double>(sign | significand);
}

/// x moved by n steps in the last place; zero stays where it is.
constexpr double stepped(double x, std::int64_t n) {
  return x == 0 ? x : std::bit_cast<double>(std::bit_cast<std::uint64_t>(x) + static_cast<std::uint64_t>(n));
}

namespace predicate_points_detail {

template <int M, int D>
constexpr points<double, M, D> uniform(random& r) {
  points<double, M, D> p{};
  for (auto& point : p)
    for (double& c : point) c = r.unit();
  return p;
}

/// The last point on the line, plane through the others, rounded and moved by up to two steps; or all of them on a
/// circle or sphere: signs and orders of one triple, about a centre.
template <int M, int D>
constexpr points<double, M, D> near(figure f, random& r) {
  auto p = uniform<M, D>(r);
  const auto size = static_cast<std::size_t>(D);
  const std::int64_t steps = r.integer(0, 2);
  if (f == figure::flat) {
    for (std::size_t k = 0; k < size; ++k) p[size][k] = p[0][k];
    for (std::size_t i = 1; i < size; ++i) {
      const double t = r.unit() * 2 - 0.5;
      for (std::size_t k = 0; k < size; ++k) p[size][k] += irg::product(t, p[i][k] - p[0][k]);
    }
    for (double& c : p[size]) c = stepped(c, r.integer(-steps, steps));
  } else {
    const int bits = static_cast<int>(r.integer(3, 26));
    double radius[3]{}, centre[3]{};
    for (double& v : radius) v = static_cast<double>(r.integer(0, std::int64_t{1} << bits));
    for (double& v : centre) v = static_cast<double>(r.integer(-(std::int64_t{1} << bits), std::int64_t{1} << bits));
    for (auto& point : p) {
      const auto turn = static_cast<std::size_t>(r.integer(0, D - 1));
      for (std::size_t k = 0; k < size; ++k)
        point[k] = centre[k] + (r.integer(0, 1) == 0 ? -1 : 1) * radius[(k + turn) % size];
    }
    for (double& c : p[static_cast<std::size_t>(r.integer(0, M - 1))]) c = stepped(c, r.integer(-steps, steps));
  }
  return p;
}

/// A point in a grid of 256 ulps, against others on the diagonal or, for circles, on the corners of a box with it.
template <int M, int D>
constexpr points<double, M, D> ulp_grid(figure f, random& r) {
  constexpr double bases[3][3] = {{0.5, 12, 24}, {0.5, 17.300000000000001, 24.00000000000005}, {0.5, 8.8, 12.1}};
  const double(&base)[3] = bases[r.integer(0, 2)];
  points<double, M, D> p{};
  for (std::size_t k = 0; k < p[0].size(); ++k) {
    p[0][k] = base[0] + static_cast<double>(r.integer(0, 255)) * 0x1p-53;
    for (std::size_t i = 1; i < p.size(); ++i) p[i][k] = base[1 + (i + 1) % 2];
    if (f == figure::flat && D == 3) p[3][k] = k == 0 ? base[1] : k == 1 ? base[2] : (base[1] + base[2]) / 2;
  }
  if (f == figure::round)
    for (std::size_t i = 1; i < p.size(); ++i)
      for (std::size_t k = 0; k < p[0].size(); ++k) p[i][k] = ((i >> k) & 1) != 0 ? base[2] : base[k == 0 ? 0 : 1];
  if (f == figure::round)  // the box's corner, opposite to where all bits are set
    for (std::size_t k = 1; k < p[0].size(); ++k) p[0][k] += base[1] - base[0];
  return p;
}

/// Numbers of the lattice, often the same ones.
template <class T, int M, int D>
constexpr points<T, M, D> lattice(std::int64_t reach, random& r) {
  points<T, M, D> p{};
  for (auto& point : p)
    for (T& c : point) c = static_cast<T>(r.integer(-reach, reach));
  return p;
}

}  // namespace predicate_points_detail

/// Points near the ends of 64 bits and near zero, often on a line or plane.
template <int M, int D>
constexpr points<std::int64_t, M, D> extreme_integers(random& r) {
  constexpr std::int64_t low = std::numeric_limits<std::int64_t>::min(),
                         high = std::numeric_limits<std::int64_t>::max();
  points<std::int64_t, M, D> p{};
  const std::int64_t kind = r.integer(0, 3);
  for (auto& point : p)
    for (std::int64_t& c : point) {
      const std::int64_t near = r.integer(0, 2);
      const std::int64_t ends[] = {low + near, high - near, near - 1, r.integer(low, high)};
      c = ends[r.integer(0, kind == 0 ? 3 : 2)];
    }
  if (kind == 3)  // equal steps from the first point: on a line
    for (std::size_t i = 1; i < p.size(); ++i)
      for (std::size_t k = 0; k < p[0].size(); ++k)
        p[i][k] = (p[0][k] < 0 ? low : 0) + static_cast<std::int64_t>(i) * (std::int64_t{1} << (40 + k)) +
                  (i + 1 == p.size() ? r.integer(-1, 1) : 0);
  return p;
}

template <int M, int D>
constexpr points<double, M, D> hard_points(distribution d, figure f, random& r) {
  namespace make = predicate_points_detail;
  const auto some = [&] { return r.integer(0, 3) == 0 ? make::uniform<M, D>(r) : make::near<M, D>(f, r); };
  // Arguments of calls are evaluated in any order: no two of them draw numbers.
  const auto at_scale = [&](std::int64_t low, std::int64_t high) {
    auto p = some();
    const int exponent = static_cast<int>(r.integer(low, high));
    for (auto& point : p)
      for (double& c : point) c = scaled(c, exponent);
    return p;
  };
  switch (d) {
    case distribution::uniform: return make::uniform<M, D>(r);
    case distribution::ulp_grid: return make::ulp_grid<M, D>(f, r);
    case distribution::near_figure: return make::near<M, D>(f, r);
    case distribution::smallest: return at_scale(-1074, -1021);
    case distribution::scaled_down: return at_scale(-500, -500);
    case distribution::scaled_up: return at_scale(500, 500);
    case distribution::largest: return at_scale(990, 1000);
    case distribution::subnormal_lattice: {
      auto p = make::lattice<double, M, D>(r.integer(1, 9), r);
      for (auto& point : p)
        for (double& c : point)
          c = std::bit_cast<double>(static_cast<std::uint64_t>(c < 0 ? -c : c) | (c < 0 ? std::uint64_t{1} << 63 : 0));
      return p;
    }
    case distribution::mixed_exponents: {
      auto p = make::lattice<double, M, D>(r.integer(0, 1) == 0 ? 3 : std::int64_t{1} << 53, r);
      const std::int64_t span = std::int64_t{1} << r.integer(3, 10);
      // Each coordinate by itself; or an axis of numbers about to become subnormal and others of very large ones.
      const bool by_axes = r.integer(0, 1) == 0;
      int axis[3]{-1070 + static_cast<int>(r.integer(0, 60)), static_cast<int>(r.integer(200, 960)),
                  static_cast<int>(r.integer(200, 960))};
      if (r.integer(0, 1) == 0) std::swap(axis[0], axis[1]);
      for (auto& point : p)
        for (std::size_t k = 0; k < point.size(); ++k)
          point[k] = scaled(point[k], by_axes ? axis[k] + static_cast<int>(r.integer(-9, 9))
                                              : static_cast<int>(r.integer(-span, span > 900 ? 900 : span)));
      return p;
    }
    case distribution::byte_lattice: return make::lattice<double, M, D>(r.integer(0, 1) == 0 ? 127 : 3, r);
    case distribution::integer_extremes: break;
  }
  const auto whole = extreme_integers<M, D>(r);
  points<double, M, D> p{};
  for (std::size_t i = 0; i < p.size(); ++i)
    for (std::size_t k = 0; k < p[i].size(); ++k) p[i][k] = static_cast<double>(whole[i][k]);
  return p;
}

/// Points whose rounded determinants are about as wrong as they can be: coordinates of +-1 and a few units in the last
/// place, seen from a point up to half a unit away from the origin, so that differences lie half-way between doubles.
template <int M, int D>
constexpr points<double, M, D> half_way_points(random& r) {
  constexpr double unit = 0x1p-52;
  points<double, M, D> p{};
  const bool plus = r.integer(0, 1) == 0;
  for (auto& point : p)
    for (double& c : point) {
      const double sign = plus || r.integer(0, 1) == 0 ? 1 : -1;
      c = sign * (1 + static_cast<double>(r.integer(-3, 3)) * unit);
    }
  if (D == 2 && plus) p[1][0] = p[0][0] - (p[0][1] - 1) + (p[1][1] - 1);  // to first order, the area is 0
  const std::int64_t step = plus ? 1 : 32;
  for (double& c : p.back()) c = static_cast<double>(r.integer(-32 / step, 32 / step) * step) * 0x1p-58;
  return p;
}

}  // namespace test
