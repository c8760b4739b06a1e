// SPDX-License-Identifier: MIT
#include <irg/solid/orient_outward.hpp>

#include <array>
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
    return irg::orient_outward(m) == irg::outward_status::ok && m == before;
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
    CHECK(irg::orient_outward(m) == irg::outward_status::ok);
    CHECK(irg::solid_volume(m) == doctest::Approx(volume).epsilon(1e-14));
    const double centre_is_inside = depth % 2;
    CHECK((irg::point_in_solid(m, {0, 0, 0}) == irg::location::inside) == (centre_is_inside != 0));
  }
}

TEST_CASE("orient_outward: bodies whose volume is too small or too large for a number") {
  for (const double scale : {0x1p-1074, 0x1p-400, 0x1p400, 0x1p1023}) {
    body m;
    append(m, irg::shape_cube<double>(), scale);
    const body before = m;
    for (std::size_t f = 0; f < m.face_count(); ++f) irg::turn_face(m, f);
    CHECK(irg::orient_outward(m) == irg::outward_status::ok);
    CHECK(m == before);
  }
}

TEST_CASE("orient_outward: cavities that touch the shell round them, with a corner or with all") {
  const auto turned_at_random = [](const body& m, std::uint64_t seed) {
    body t = m;
    test::random r(seed);
    for (std::size_t f = 0; f < t.face_count(); ++f)
      if (r.integer(0, 1) == 1) irg::turn_face(t, f);
    return t;
  };
  const auto cube_from = [](double low, double size) {
    body m;
    append(m, irg::shape_cube<double>(), size);
    for (auto& p : m.positions) p = {p.x + low, p.y + low, p.z + low};
    return m;
  };
  body tip;  // its first corner is on a side of the cube
  tip.positions = {{0, 2, 2}, {2, 1, 1}, {2, 3, 1}, {2, 2, 3}};
  for (const auto& f : {std::array{0, 1, 2}, std::array{0, 2, 3}, std::array{0, 3, 1}, std::array{1, 3, 2}})
    irg::add_face(tip, f);
  body in_cube;
  append(in_cube, tip, 1);
  append(in_cube, cube_from(0, 4), 1);
  body inscribed;  // all corners of the octahedron are on sides of the cube, all of the tetrahedron on its corners
  append(inscribed, irg::shape_octahedron<double>(), 1);
  append(inscribed, cube_from(-1, 2), 1);
  body in_corners;
  append(in_corners, cube_from(0, 1), 1);
  body tetrahedron;
  tetrahedron.positions = {{1, 1, 1}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (const auto& f : {std::array{0, 1, 2}, std::array{0, 2, 3}, std::array{0, 3, 1}, std::array{1, 3, 2}})
    irg::add_face(tetrahedron, f);
  append(in_corners, tetrahedron, 1);
  body beside = cube_from(0, 1);  // with a side in common
  append(beside, cube_from(0, 1), 1);
  for (std::size_t v = 8; v < 16; ++v) beside.positions[v].x += 1;
  body twice = cube_from(0, 1);
  append(twice, cube_from(0, 1), 1);
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    const auto volume = [&](const body& m) {
      body t = turned_at_random(m, seed);
      CHECK(irg::orient_outward(t) == irg::outward_status::ok);
      return irg::solid_volume(t);
    };
    CHECK(volume(in_cube) == doctest::Approx(64 - 4 / 3.0));
    CHECK(volume(inscribed) == doctest::Approx(8 - 4 / 3.0));
    CHECK(volume(in_corners) == doctest::Approx(1 - 1 / 3.0));
    CHECK(volume(beside) == 2);
    CHECK(volume(twice) == 2);
  }
}

TEST_CASE("orient_outward: thousands of shells side by side, a shell in each") {
  body m;
  const int count = 3000;
  for (int i = 0; i < count; ++i)
    for (const double size : {1.0, 0.5}) {
      const std::size_t first = m.positions.size();
      append(m, irg::shape_tetrahedron<double>(), size);
      for (std::size_t v = first; v < m.positions.size(); ++v) m.positions[v].x += 4.0 * i;
    }
  CHECK(irg::orient_outward(m) == irg::outward_status::ok);
  CHECK(irg::solid_volume(m) ==
        doctest::Approx(count * 0.875 * irg::solid_volume(irg::shape_tetrahedron<double>())).epsilon(1e-9));
}
