// SPDX-License-Identifier: MIT
#include <irg/solid/measures.hpp>

#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>

#include <irg/mesh/shapes.hpp>

#include "support/big_rational.hpp"
#include "support/check_both.hpp"
#include "support/random.hpp"
#include "support/ulp.hpp"

namespace {

using solid_mesh = irg::mesh<double>;
using solid_point = irg::point<double, 3>;

constexpr solid_mesh moved(solid_mesh m, double scale, const solid_point& to) {
  for (solid_point& p : m.positions) p = {p.x * scale + to.x, p.y * scale + to.y, p.z * scale + to.z};
  return m;
}

// A staircase of unit cubes, one face of it with eight corners: volume 6, surface 22 by counting squares.
constexpr solid_mesh stairs() {
  constexpr std::array<std::array<double, 2>, 8> side{{{0, 0}, {3, 0}, {3, 1}, {2, 1}, {2, 2}, {1, 2}, {1, 3}, {0, 3}}};
  solid_mesh m;
  for (const double z : {0.0, 1.0})
    for (const auto& p : side) m.positions.push_back({p[0], p[1], z});
  irg::add_face(m, std::array<std::size_t, 8>{7, 6, 5, 4, 3, 2, 1, 0});
  irg::add_face(m, std::array<std::size_t, 8>{8, 9, 10, 11, 12, 13, 14, 15});
  for (std::size_t i = 0; i < 8; ++i)
    irg::add_face(m, std::array<std::size_t, 4>{i, (i + 1) % 8, (i + 1) % 8 + 8, i + 8});
  return m;
}

TEST_CASE("measures: the cube, a staircase, a body turned inside out") {
  CHECK_BOTH(irg::solid_volume(irg::shape_cube<double>()) == 1);
  CHECK_BOTH(irg::surface_area(irg::shape_cube<double>()) == 6);
  CHECK_BOTH(*irg::centre_of_mass(irg::shape_cube<double>()) == solid_point{0.5, 0.5, 0.5});
  CHECK_BOTH(irg::solid_volume(irg::shape_cube<float>()) == 1.0f);
  CHECK_BOTH(irg::solid_volume(stairs()) == 6);
  CHECK_BOTH(irg::surface_area(stairs()) == 24);
  CHECK_BOTH(*irg::centre_of_mass(stairs()) == solid_point{7.0 / 6, 7.0 / 6, 0.5});
  solid_mesh turned = irg::shape_cube<double>();
  for (std::size_t f = 0; f < turned.face_count(); ++f) std::swap(turned.corners[3 * f], turned.corners[3 * f + 1]);
  CHECK(irg::solid_volume(turned) == -1);
  CHECK(irg::surface_area(turned) == 6);
  CHECK(*irg::centre_of_mass(turned) == solid_point{0.5, 0.5, 0.5});
}

TEST_CASE("measures: a cube of one unit, sixteen digits from the origin, and at the ends of the range") {
  const solid_mesh cube = irg::shape_cube<double>(), apart = moved(cube, 1, {0x1p52, -0x1p52, 0x1p51});
  CHECK(irg::solid_volume(apart) == 1);
  CHECK(irg::surface_area(apart) == 6);
  CHECK(*irg::centre_of_mass(apart) == solid_point{0x1p52, 0.5 - 0x1p52, 0x1p51 + 0.5});
  CHECK(irg::solid_volume(moved(cube, 0x1p341, {})) == 0x1p1023);
  CHECK(irg::solid_volume(moved(cube, 0x1p-358, {})) == 0x1p-1074);
  CHECK_BOTH(irg::solid_volume(moved(irg::shape_cube<double>(), 0x1p342, {})) ==
             std::numeric_limits<double>::infinity());
  CHECK(irg::solid_volume(moved(cube, 0x1p-400, {})) == 0);
  CHECK(irg::surface_area(moved(cube, 0x1p600, {})) == std::numeric_limits<double>::infinity());
  CHECK(*irg::centre_of_mass(moved(cube, 0x1p1023, {})) == solid_point{0x1p1022, 0x1p1022, 0x1p1022});
  CHECK(*irg::centre_of_mass(moved(cube, 0x1p-1000, {})) == solid_point{0x1p-1001, 0x1p-1001, 0x1p-1001});
}

TEST_CASE("measures: nothing, a sheet, positions that are not finite") {
  CHECK_BOTH(irg::solid_volume(solid_mesh{}) == 0);
  CHECK_BOTH(irg::surface_area(solid_mesh{}) == 0);
  CHECK_BOTH(!irg::centre_of_mass(solid_mesh{}));
  solid_mesh sheet;
  sheet.positions = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  irg::add_face(sheet, std::array<std::size_t, 3>{0, 1, 2});
  irg::add_face(sheet, std::array<std::size_t, 3>{0, 2, 1});
  CHECK(irg::solid_volume(sheet) == 0);
  CHECK(!irg::centre_of_mass(sheet));
  sheet.positions[0].x = std::numeric_limits<double>::quiet_NaN();
  CHECK(irg::surface_area(sheet) == 0);
}

TEST_CASE("measures: the same bits at every size, down to the least normal number") {
  test::random random(52);
  for (int i = 0; i < 300; ++i) {
    solid_mesh m;
    for (int k = 0; k < 4; ++k) m.positions.push_back({random.unit(), random.unit(), random.unit()});
    for (const auto& f : {std::array<std::size_t, 3>{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}) irg::add_face(m, f);
    const double volume = irg::solid_volume(m);
    solid_mesh small = m, least = m;
    const int cubed = -1022 - std::ilogb(volume), a = cubed / 3, b = (cubed - a) / 2, c = cubed - a - b;
    for (auto& p : small.positions) p = {std::ldexp(p.x, a), std::ldexp(p.y, b), std::ldexp(p.z, c)};
    CHECK(irg::solid_volume(small) == std::ldexp(volume, cubed));
    // Whole numbers of the least one.
    for (auto& p : least.positions)
      for (int j = 0; j < 3; ++j) p[j] = std::floor(p[j] * 0x1p20);
    const auto whole = irg::centre_of_mass(least);
    for (auto& p : least.positions)
      for (int j = 0; j < 3; ++j) p[j] *= 0x1p-1074;
    const auto denormal = irg::centre_of_mass(least);
    REQUIRE((whole && denormal));
    for (int j = 0; j < 3; ++j) CHECK(std::fabs(std::ldexp((*denormal)[j], 1074) - (*whole)[j]) < 1);
  }
}

#ifdef IRG_HAVE_MPFR
using rational = test::big_rational;

TEST_CASE("measures: tetrahedra of all magnitudes and a torus, against rationals") {
  test::random random(51);
  double worst_volume = 0, worst_centre = 0;
  for (int i = 0, n = std::getenv("IRG_RELEASE_TIER") ? 100000 : 500; i < n; ++i) {
    const int reach = i % 3 == 0 ? 3 : i % 3 == 1 ? 60 : 300;
    solid_mesh m;
    for (int k = 0; k < 4; ++k) {
      solid_point p;
      for (int j = 0; j < 3; ++j) {
        const double significand = 2 * random.unit() - 1;
        p[j] = std::ldexp(significand, static_cast<int>(random.integer(-reach, reach)));
      }
      m.positions.push_back(p);
    }
    for (const auto& f : {std::array<std::size_t, 3>{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}) irg::add_face(m, f);
    // By one determinant of differences: another way than cones from the origin.
    const auto& v = m.positions;
    std::array<std::array<rational, 3>, 3> d;
    for (std::size_t k = 0; k < 3; ++k)
      for (int j = 0; j < 3; ++j) d[k][static_cast<std::size_t>(j)] = rational(v[k + 1][j]) - rational(v[0][j]);
    const rational six = d[0][0] * (d[1][1] * d[2][2] - d[1][2] * d[2][1]) -
                         d[0][1] * (d[1][0] * d[2][2] - d[1][2] * d[2][0]) +
                         d[0][2] * (d[1][0] * d[2][1] - d[1][1] * d[2][0]);
    worst_volume = std::fmax(worst_volume, test::error_in_ulp(irg::solid_volume(m), six / rational(6)));
    const auto centre = irg::centre_of_mass(m);
    REQUIRE(centre.has_value() == (six.sign() != 0));
    for (int j = 0; centre && j < 3; ++j) {
      const rational mean =
          (rational(v[0][j]) + rational(v[1][j]) + rational(v[2][j]) + rational(v[3][j])) / rational(4);
      worst_centre = std::fmax(worst_centre, test::error_in_ulp((*centre)[j], mean));
    }
  }
  MESSAGE("volume within ", worst_volume, " ulp, centre within ", worst_centre, " ulp");
  CHECK(worst_volume <= 0.51);
  CHECK(worst_centre <= 0.51);
}
#endif

TEST_CASE("measures: a sphere of many triangles has nearly a sphere's") {
  const auto sphere = irg::shape_sphere<double>({.slices = 96, .stacks = 64});
  CHECK(std::fabs(irg::solid_volume(sphere) - 4.18879) < 0.02);
  CHECK(std::fabs(irg::surface_area(sphere) - 12.56637) < 0.02);
  const auto centre = *irg::centre_of_mass(sphere);
  CHECK(std::fabs(centre.x) + std::fabs(centre.y) + std::fabs(centre.z) < 1e-14);
}

}  // namespace
