// SPDX-License-Identifier: MIT
#include <irg/geometry/compare_distance_to.hpp>
#include <irg/geometry/orient2d_batch.hpp>
#include <irg/geometry/side_of_line.hpp>
#include <irg/geometry/simulation_of_simplicity.hpp>

#include <array>

#include "hashes.hpp"

namespace {

using P2 = irg::point<double, 2>;
using P3 = irg::point<double, 3>;

/// Lattices, neighbours of 1/2, subnormal numbers, numbers of any size.
constexpr double number(test::random& r, int kind) {
  const double n = static_cast<double>(r.integer(-3, 3));
  switch (kind % 4) {
    case 0: return n;
    case 1: return 0.5 + n * 0x1p-53;
    case 2: return n * 0x1p-1074;
    default: return n * (r.integer(0, 1) == 0 ? 0x1p-300 : 0x1p500);
  }
}
template <class P>
constexpr P place(test::random& r, int kind) {
  P p{};
  for (int i = 0; i < irg::size_of<P>; ++i) p[i] = number(r, kind);
  return p;
}

constexpr std::uint64_t geometry_simulation_of_simplicity(int rounds) {
  test::random r(31);
  determinism::hasher h;
  for (int i = 0; i < rounds; ++i) {
    const auto a = place<P2>(r, i), b = place<P2>(r, i), c = place<P2>(r, i), d = place<P2>(r, i);
    const auto p = place<P3>(r, i), q = place<P3>(r, i), s = place<P3>(r, i), t = place<P3>(r, i), u = place<P3>(r, i);
    h.add(irg::orient2d_sos(a, b, c));
    h.add(irg::in_circle_sos(a, b, c, d));
    h.add(irg::orient3d_sos(p, q, s, t));
    h.add(irg::in_sphere_sos(p, q, s, t, u));
  }
  return h.value();
}
HASHED(geometry_simulation_of_simplicity, 4, 4000);

constexpr std::uint64_t geometry_comparisons(int rounds) {
  test::random r(32);
  determinism::hasher h;
  for (int i = 0; i < rounds; ++i) {
    const auto a = place<P2>(r, i), b = place<P2>(r, i), c = place<P2>(r, i), d = place<P2>(r, i);
    const auto p = place<P3>(r, i), q = place<P3>(r, i), s = place<P3>(r, i);
    const irg::plane<double> plane{p.x, p.y, p.z, number(r, i)};
    h.add(irg::order_along_line(a, b, c, d));
    h.add(irg::compare_distance(p, q, s));
    h.add(irg::compare_distance_to_line(a, b, c, d));
    h.add(irg::compare_distance_to_plane(plane, q, s));
    h.add(irg::sign_of(irg::side_of_line(irg::vec<double, 3>{p.x, p.y, p.z}, a)));
    h.add(static_cast<int>(irg::side_of(plane, q)));
  }
  return h.value();
}
HASHED(geometry_comparisons, 8, 10000);

// Constant evaluation takes the plain loop, run time the lanes.
constexpr std::uint64_t geometry_orient2d_batch(int rounds) {
  test::random r(33);
  determinism::hasher h;
  for (int i = 0; i < rounds; ++i) {
    constexpr std::size_t n = 19;
    std::array<double, n> x[3]{}, y[3]{};
    for (int k = 0; k < 3; ++k)
      for (std::size_t j = 0; j < n; ++j) x[k][j] = number(r, i), y[k][j] = number(r, i);
    std::array<std::int8_t, n> signs{}, line_signs{};
    h.add(irg::orient2d_all({x[0], y[0]}, {x[1], y[1]}, {x[2], y[2]}, signs));
    h.add(irg::orient2d_all(P2{x[0][0], y[0][0]}, P2{x[1][0], y[1][0]}, irg::point_columns{x[2], y[2]}, line_signs));
    for (std::size_t j = 0; j < n; ++j) h.add(signs[j]), h.add(line_signs[j]);
  }
  return h.value();
}
HASHED(geometry_orient2d_batch, 4, 1000);

}  // namespace
