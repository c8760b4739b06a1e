// SPDX-License-Identifier: MIT
#include <irg/solid/solid_locator.hpp>

#include <array>

#include <doctest/doctest.h>
#include <irg/mesh/shapes.hpp>

#include "support/random.hpp"

using irg::location;

namespace {

using solid_mesh = irg::mesh<double>;

TEST_CASE("solid_locator: empty bodies, equal triangles, constant evaluation") {
  static_assert([] {
    const solid_mesh m = irg::shape_cube<double>();
    const irg::solid_locator locate(m);
    irg::solid_locator_counts counts;
    const bool right = locate({0.5, 0.5, 0.5}, irg::fill_rule::non_zero, &counts) == location::inside &&
                       locate({2, 0.5, 0.5}) == location::outside && locate.winding_number({0.25, 0.5, 0.5}) == 1;
    return right && counts.points == 1 && counts.triangles <= 12;
  }());
  CHECK(irg::solid_locator(solid_mesh{})({0, 0, 0}) == location::outside);
  solid_mesh many;
  many.positions = {{0, 0, 1}, {1, 0, 1}, {0, 1, 1}};
  for (int i = 0; i < 20000; ++i) irg::add_face(many, std::array<std::size_t, 3>{0, 1, 2});
  CHECK(irg::solid_locator(many).winding_number({0.25, 0.25, 0}) == 20000);
  CHECK(irg::solid_locator(many)({0.25, 0.25, 1}) == location::boundary);
}

TEST_CASE("solid_locator: the answers of point_in_solid, for corners, middles of sides and points beside a torus") {
  const solid_mesh torus = irg::shape_torus<double>({.major_segments = 9, .minor_segments = 6});
  const irg::solid_locator locate(torus);
  test::random random(45);
  irg::solid_locator_counts counts;
  const auto any = [&] {
    return torus
        .positions[static_cast<std::size_t>(random.integer(0, static_cast<std::int64_t>(torus.positions.size()) - 1))];
  };
  for (int i = 0; i < 100; ++i) {
    irg::point<double, 3> p = any();
    if (i % 3 != 0) {
      const irg::point<double, 3> q = any();
      p = {p.x * 0.5 + q.x * 0.5, p.y * 0.5 + q.y * 0.5, p.z * 0.5 + q.z * 0.5};
    }
    CHECK(locate(p, irg::fill_rule::non_zero, &counts) == irg::point_in_solid(torus, p));
  }
  CHECK(counts.points == 100);
  CHECK(counts.triangles < 100 * 54);
}

}  // namespace
