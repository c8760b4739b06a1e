// SPDX-License-Identifier: MIT
#include <irg/trace/ray_world.hpp>

#include <limits>

#include <doctest/doctest.h>
#include <irg/mesh/shapes.hpp>

#include "trace/worlds.hpp"

namespace {

using world = irg::ray_world<double>;
using R = irg::ray<double, 3>;

TEST_CASE("ray_world: bodies, their triangles, and points of them") {
  static_assert([] {
    const test::kept_body floor(test::rectangle({0, 0, 0}, {2, 0, 0}, {0, 2, 0}), {});
    const world w({floor.body({})}, {});
    const auto s = w.meet(R{{1.5, 0.5, 2}, {0, 0, -1}});
    return s && s->at == irg::point<double, 3>{1.5, 0.5, 0} && s->face == irg::vec<double, 3>{0, 0, 1} &&
           s->side == irg::facing::front && s->reach == 2;
  }());
  const test::kept_body floor(test::rectangle({0, 0, 0}, {2, 0, 0}, {0, 2, 0}), {}),
      cube(irg::shape_cube<double>(), {0, 0, 5});
  irg::optics<double> glass;
  glass.transmitted = {0.5, 0, 0};
  const world w({floor.body({}), irg::traced_body<double>{}, cube.body({}, glass)}, {}, {1, 2, 3});
  CHECK(w.is_transparent());
  CHECK(w.first_triangle(2) == 2);
  CHECK(w.body_of(1) == 0);
  CHECK(w.body_of(2) == 2);
  CHECK(w.body_of(13) == 2);
  const auto below = w.meet(R{{1.5, 0.5, -2}, {0, 0, 1}});
  REQUIRE(below.has_value());
  CHECK(below->side == irg::facing::back);
  CHECK(below->normal == irg::vec<double, 3>{0, 0, -1});
  CHECK(w.meet(R{{0.5, 0.5, 9}, {0, 0, -1}})->body == 2);
  CHECK(!w.meet(R{{0.5, 0.5, 9}, {0, 0, 1}}));
  CHECK(!w.meet(R{{0.5, 0.5, 9}, {0, 0, 0}}));
  CHECK(!world().meet(R{{0, 0, 0}, {0, 0, 1}}));
  CHECK(!world().is_transparent());
}

TEST_CASE("ray_world: normals between corners, turned to the ray; corners that are no numbers") {
  test::kept_body face(test::rectangle({0, 0, 0}, {2, 0, 0}, {0, 2, 0}), {});
  face.normals = {{0, 0, 2}, {1, 0, 1}, {0, 0, 1}, {0, 0, 0}};
  const world w({face.body({})}, {});
  const auto s = w.point_of(0, 0.5, 0.0, irg::facing::back);
  CHECK(s.normal.x < -0.3);
  CHECK(s.normal.z < -0.9);
  CHECK(s.face == irg::vec<double, 3>{0, 0, -1});
  face.positions[2].x = std::numeric_limits<double>::quiet_NaN();
  const world broken({face.body({})}, {});
  CHECK(!broken.meet(R{{0.5, 0.5, 9}, {0, 0, -1}}));
}

}  // namespace
