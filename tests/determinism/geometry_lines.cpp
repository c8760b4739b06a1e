// SPDX-License-Identifier: MIT
#include <irg/geometry/closest_point.hpp>
#include <irg/geometry/distance.hpp>
#include <irg/geometry/intersect_planes.hpp>
#include <irg/geometry/intersect_segments.hpp>
#include <irg/geometry/smallest_sphere.hpp>

#include <array>

#include "hashes.hpp"

namespace {

using P2 = irg::point<double, 2>;
using P3 = irg::point<double, 3>;

/// Lattice points, tenths, and numbers whose exponents are far apart: ordinary and degenerate positions.
constexpr double number(test::random& r, int kind) {
  const double n = static_cast<double>(r.integer(-3, 3));
  switch (kind % 4) {
    case 0: return n;
    case 1: return n * 0.1;
    case 2: return r.unit() - 0.5;
    default: return (r.unit() - 0.5) * (r.integer(0, 1) == 0 ? 0x1p-90 : 0x1p60);
  }
}
template <class P>
constexpr P place(test::random& r, int kind) {
  P p{};
  for (int i = 0; i < irg::size_of<P>; ++i) p[i] = number(r, kind);
  return p;
}
template <class P>
constexpr void add(determinism::hasher& h, const P& p) {
  for (int i = 0; i < irg::size_of<P>; ++i) h.add(p[i]);
}

constexpr std::uint64_t geometry_intersect_segments(int rounds) {
  test::random r(2026);
  determinism::hasher h;
  for (int i = 0; i < rounds; ++i) {
    const P2 a = place<P2>(r, i), b = place<P2>(r, i), c = place<P2>(r, i), d = place<P2>(r, i);
    const auto m = irg::intersect_segments(a, b, c, d);
    h.add(static_cast<int>(m.relation)), h.add(m.t), h.add(m.s), add(h, m.first), add(h, m.last);
  }
  return h.value();
}
constexpr std::uint64_t geometry_intersect_lines(int rounds) {
  test::random r(2026);
  determinism::hasher h;
  for (int i = 0; i < rounds; ++i) {
    const P3 a = place<P3>(r, i), b = place<P3>(r, i), c = place<P3>(r, i), d = place<P3>(r, i);
    const auto m = irg::intersect_lines(a, b, c, d);
    h.add(static_cast<int>(m.relation)), h.add(m.t), h.add(m.s), add(h, m.at);
  }
  return h.value();
}
constexpr std::uint64_t geometry_intersect_planes(int rounds) {
  test::random r(2026);
  determinism::hasher h;
  for (int i = 0; i < rounds; ++i) {
    std::array<irg::plane<double>, 3> p{};
    for (auto& q : p) q = {number(r, i), number(r, i), number(r, i), number(r, i)};
    const auto two = irg::intersect_planes(p[0], p[1]);
    const auto three = irg::intersect_planes(p[0], p[1], p[2]);
    const P3 a = place<P3>(r, i), b = place<P3>(r, i);
    const auto line = irg::intersect_plane_line(p[0], a, b);
    h.add(static_cast<int>(two.relation)), add(h, two.line.origin), add(h, two.line.direction);
    h.add(static_cast<int>(three.relation)), add(h, three.at);
    h.add(static_cast<int>(line.relation)), h.add(line.t), add(h, line.at);
  }
  return h.value();
}
constexpr std::uint64_t geometry_closest_point(int rounds) {
  test::random r(2026);
  determinism::hasher h;
  for (int i = 0; i < rounds; ++i) {
    const P3 a = place<P3>(r, i), b = place<P3>(r, i), c = place<P3>(r, i), d = place<P3>(r, i);
    const auto m = *irg::closest_point_on_triangle(a, b, c, d);
    h.add(static_cast<int>(m.region)), add(h, m.at);
    for (const double w : m.weights) h.add(w);
    h.add(*irg::distance_to_triangle(a, b, c, d));
    h.add(*irg::distance_of_segments(a, b, c, d));
  }
  return h.value();
}
constexpr std::uint64_t geometry_smallest_sphere(int rounds) {
  test::random r(2026);
  determinism::hasher h;
  for (int i = 0; i < rounds; ++i) {
    std::array<P3, 6> points{};
    for (P3& p : points) p = place<P3>(r, i % 3);
    const auto s = *irg::smallest_sphere(points);
    add(h, s.centre), h.add(s.radius);
  }
  return h.value();
}

HASHED(geometry_intersect_segments, 8, 20'000);
HASHED(geometry_intersect_lines, 4, 20'000);
HASHED(geometry_intersect_planes, 4, 10'000);
HASHED(geometry_closest_point, 2, 4'000);
HASHED(geometry_smallest_sphere, 1, 2'000);

}  // namespace
