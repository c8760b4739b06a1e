// SPDX-License-Identifier: MIT
#include <irg/solid/self_intersections.hpp>

#include <initializer_list>
#include <vector>

#include <irg/mesh/shapes.hpp>
#include <irg/solid/boolean.hpp>

#include "support/check_both.hpp"
#include "support/random.hpp"

namespace {

using irg::self_intersections;
using place = irg::point<double, 3>;

constexpr irg::mesh<double> two_triangles(const place& a, const place& b, const place& c) {
  irg::mesh<double> m;
  m.positions = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, a, b, c};
  irg::add_face(m, std::initializer_list<int>{0, 1, 2});
  irg::add_face(m, std::initializer_list<int>{3, 4, 5});
  return m;
}
constexpr std::size_t meetings(const place& a, const place& b, const place& c) {
  return self_intersections(two_triangles(a, b, c)).size();
}

}  // namespace

TEST_CASE("self_intersections: two triangles, at compile time, too") {
  CHECK_BOTH(meetings({1, 1, -1}, {1, 1, 1}, {2, 2, 1}) == 1);  // through each other
  CHECK_BOTH(meetings({1, 1, 0}, {1, 1, 1}, {2, 2, 1}) == 1);  // a corner in a face
  CHECK_BOTH(meetings({2, 0, 0}, {1, -1, 1}, {2, -2, 1}) == 1);  // a corner on a side
  CHECK_BOTH(meetings({1, 1, 0}, {3, 3, 0}, {1, 3, 0}) == 1);  // in one plane
  CHECK_BOTH(meetings({0, 0, 0}, {0, 4, 0}, {4, 0, 0}) == 1);  // on each other
  CHECK_BOTH(meetings({0, 0, 0}, {4, 0, 0}, {0, -4, 1}) == 0);  // a side in common
  CHECK_BOTH(meetings({0, 0, 0}, {-4, 0, 0}, {0, -4, 1}) == 0);  // a corner in common
  CHECK_BOTH(meetings({0, 0, 0}, {2, 0, 0}, {0, -4, 1}) == 1);  // half a side
  CHECK_BOTH(meetings({1, 1, 5e-324}, {1, 1, 1}, {2, 2, 1}) == 0);
  CHECK_BOTH(self_intersections(irg::mesh<float>{}).empty());
}

TEST_CASE("self_intersections: none in bodies; those of two bodies that cut each other are the pairs of all pairs") {
  CHECK(self_intersections(irg::shape_torus<double>()).empty());
  CHECK(self_intersections(irg::shape_sphere<float>()).empty());
  CHECK(self_intersections(irg::shape_cube<double>()).empty());
  test::random r(20);
  for (int trial = 0; trial < 20; ++trial) {
    irg::mesh<double> m = irg::shape_icosahedron<double>();
    const auto second = irg::shape_torus<double>({.major_segments = 9, .minor_segments = 7});
    const double x = static_cast<double>(r.integer(-4, 4)) * 0.25;
    const auto first = static_cast<std::uint32_t>(m.positions.size());
    for (const place& p : second.positions) m.positions.push_back({p.x + x, p.y, p.z});
    for (std::size_t f = 0; f < second.face_count(); ++f) {
      std::vector<std::uint32_t> corners;
      corners.reserve(second.face_size(f));
      for (std::size_t k = 0; k < second.face_size(f); ++k) corners.push_back(first + second.corner(f, k).position);
      irg::add_face(m, corners);
    }
    std::vector<irg::face_pair> expected;
    for (std::uint32_t s = 0; s < m.face_count(); ++s)
      for (std::uint32_t t = s + 1; t < m.face_count(); ++t) {
        irg::mesh<double> two;
        two.positions = m.positions;
        for (const std::uint32_t f : {s, t})
          irg::add_face(two, std::vector<std::uint32_t>{m.corner(f, 0).position, m.corner(f, 1).position,
                                                        m.corner(f, 2).position});
        if ((s < 20) != (t < 20) && !self_intersections(two).empty()) expected.push_back({s, t});
      }
    CHECK(self_intersections(m) == expected);
  }
}
