// SPDX-License-Identifier: MIT
#include <irg/mesh/shape_sweeps.hpp>

#include <cmath>
#include <vector>

#include <irg/mesh/convex_body.hpp>
#include <irg/mesh/mesh_faults.hpp>

#include "support/check_both.hpp"

namespace {

using body = irg::mesh<double>;
using ring = std::vector<irg::point<double, 2>>;

double volume(const body& m) {
  double sum = 0;
  for (std::size_t f = 0; f < m.face_count(); ++f)
    for (std::size_t k = 2; k < m.face_size(f); ++k) {
      const auto a = m.positions[m.corner(f, 0).position], b = m.positions[m.corner(f, k - 1).position],
                 c = m.positions[m.corner(f, k).position];
      sum += a.x * (b.y * c.z - b.z * c.y) + a.y * (b.z * c.x - b.x * c.z) + a.z * (b.x * c.y - b.y * c.x);
    }
  return sum / 6;
}
double polygon_area(int n) { return n * std::sin(2 * 3.14159265358979323846 / n) / 2; }

}  // namespace

TEST_CASE("shapes by sweeps: closed and outward, at compile time, too") {
  CHECK_BOTH(irg::is_closed(irg::shape_cylinder<double>(5)));
  CHECK_BOTH(irg::is_closed(irg::shape_cone<float>(4)));
  CHECK_BOTH(irg::is_closed(irg::shape_dodecahedron<double>()));
  CHECK_BOTH(irg::is_closed(irg::shape_extrusion(ring{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}, 3.0)));
  CHECK_BOTH(irg::shape_dodecahedron<double>().face_count() == 12);
  CHECK_BOTH(irg::shape_cylinder<double>(0) == irg::shape_cylinder<double>(3));
  CHECK_BOTH(irg::shape_revolution<double>({}).face_count() == 0);
}

TEST_CASE("shapes by sweeps: counts, no faults, volumes") {
  for (const int n : {3, 4, 7, 32}) {
    const body cylinder = irg::shape_cylinder<double>(n), cone = irg::shape_cone<double>(n);
    CHECK(irg::list_faults(cylinder).empty());
    CHECK(irg::list_faults(cone).empty());
    CHECK(cylinder.face_count() == static_cast<std::size_t>(n) + 2);
    CHECK(cone.face_count() == static_cast<std::size_t>(n) + 1);
    CHECK(cone.positions.size() == static_cast<std::size_t>(n) + 1);
    CHECK(volume(cylinder) == doctest::Approx(2 * polygon_area(n)));
    CHECK(volume(cone) == doctest::Approx(2 * polygon_area(n) / 3));
  }
  const body prism = irg::shape_extrusion(ring{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}, 3.0);
  CHECK(irg::list_faults(prism).empty());
  CHECK(volume(prism) == 9);
  const body vase =
      irg::shape_revolution<double>({{0, 0}, {1, 0}, {0.5, 1}, {1, 2}, {0.75, 2}, {0.25, 1}, {0, 0.5}}, 16);
  CHECK(irg::list_faults(vase).empty());
  CHECK(volume(vase) > 0);
  const body dodecahedron = irg::shape_dodecahedron<double>();
  CHECK(irg::list_faults(dodecahedron).empty());
  const double edge = 4 / (std::sqrt(3.0) * (1 + std::sqrt(5.0)));
  CHECK(volume(dodecahedron) == doctest::Approx((15 + 7 * std::sqrt(5.0)) / 4 * edge * edge * edge));
  for (const auto& p : dodecahedron.positions)
    CHECK(std::abs(std::sqrt(p.x * p.x + p.y * p.y + p.z * p.z) - 1) < 4 * 0x1p-53);
}
