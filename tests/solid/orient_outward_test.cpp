// SPDX-License-Identifier: MIT
#include <irg/solid/orient_outward.hpp>

#include <initializer_list>

#include <irg/mesh/shapes.hpp>

#include "support/check_both.hpp"
#include "support/random.hpp"

namespace {

using body = irg::mesh<double>;

void append(body& m, const body& other, double scale) {
  const auto first = static_cast<std::uint32_t>(m.positions.size());
  for (const auto& p : other.positions) m.positions.push_back({p.x * scale, p.y * scale, p.z * scale});
  for (std::size_t f = 0; f < other.face_count(); ++f) {
    std::vector<std::uint32_t> corners;
    corners.reserve(other.face_size(f));
    for (std::size_t k = 0; k < other.face_size(f); ++k) corners.push_back(first + other.corner(f, k).position);
    irg::add_face(m, corners);
  }
}

}  // namespace

TEST_CASE("orient_outward: a body inside out, at compile time, too; what has no inside") {
  CHECK_BOTH([] {
    body m = irg::shape_tetrahedron<double>();
    const body before = m;
    for (std::size_t f = 0; f < 4; ++f) irg::turn_face(m, f);
    return irg::orient_outward(m) == irg::outward_status::done && m == before;
  }());
  body grid = irg::shape_grid<double>();
  CHECK(irg::orient_outward(grid) == irg::outward_status::open);
  body fin = irg::shape_cube<double>();
  fin.positions.push_back({2, 2, 2});
  irg::add_face(fin, std::initializer_list<int>{0, 1, 8});
  const body before = fin;
  CHECK(irg::orient_outward(fin) == irg::outward_status::no_surface);
  CHECK(fin == before);
}

TEST_CASE("orient_outward: shells in shells, faces turned at random") {
  test::random r(20);
  for (int trial = 0; trial < 40; ++trial) {
    body m;
    const int depth = static_cast<int>(r.integer(1, 4));
    double volume = 0;
    const body ball = irg::shape_icosahedron<double>();
    for (int i = 0; i < depth; ++i) {
      append(m, ball, 1.0 / (1 << i));
      volume += irg::solid_volume(ball) / (1 << 3 * i) * (i % 2 ? -1 : 1);
    }
    for (std::size_t f = 0; f < m.face_count(); ++f)
      if (r.integer(0, 1) == 1) irg::turn_face(m, f);
    CHECK(irg::orient_outward(m) == irg::outward_status::done);
    CHECK(irg::solid_volume(m) == doctest::Approx(volume).epsilon(1e-14));
    const double centre_is_inside = depth % 2;
    CHECK((irg::point_in_solid(m, {0, 0, 0}) == irg::location::inside) == (centre_is_inside != 0));
  }
}
