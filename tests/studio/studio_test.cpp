// SPDX-License-Identifier: MIT
#include <studio/studio.hpp>

#include "support/check_both.hpp"

TEST_CASE("studio: the camera of a view, at compile time, too") {
  CHECK_BOTH([] {
    irg::studio<double> s;
    irg::studio_camera<double>& c = s.of(irg::studio_view::main);
    c.eye = {1, 2, 3};
    c.pyramid = {1, 4, 2, 0.5, 9};
    c.projection = irg::projection_kind::oblique;
    const irg::camera<double> made = irg::camera_of(c);
    return made.eye == c.eye && made.near_distance == 0.5 && made.far_distance == 9 &&
           made.vertical_angle == 2 * irg::atan2(1.0, 1.0) && made.receding.angle == irg::radians(45.0) &&
           made.receding.factor == 0.5 && s.of(irg::studio_view::outer).shows(irg::studio_helper::pyramid) &&
           !c.shows(irg::studio_helper::pyramid);
  }());
}

TEST_CASE("studio: a body stands where its transformations before and after the camera put it") {
  using transformation = irg::studio_transformation<double>;
  irg::studio<double> s;
  irg::studio_body<double> b;
  CHECK(irg::placement_of(s, b) == irg::identity_matrix<double, 4>());
  b.transformations[0] = {{irg::studio_map::translate, {1, 2, 3}}, {irg::studio_map::rotate_z, {30}}};
  const auto before = irg::placement_of(s, b);
  CHECK(before == irg::rotation_z(irg::radians(30.0)) * irg::translation(irg::vec<double, 3>{1, 2, 3}));
  b.transformations[1] = {{irg::studio_map::scale, {2, 1, 1}}, {irg::studio_map::translate, {0.5, 0, 0}}};
  const auto both = irg::placement_of(s, b);
  const auto& c = s.of(irg::studio_view::main);
  const auto view = irg::look_at(c.eye, c.target, c.up);
  const auto after = irg::matrix_of(std::span<const transformation>(b.transformations[1]));
  for (const irg::point<double, 3>& p :
       {irg::point<double, 3>{0, 0, 0}, irg::point<double, 3>{1, -1, 2}, irg::point<double, 3>{-3, 5, 0.25}}) {
    const auto seen = irg::transform_point(view, irg::transform_point(both, p));
    const auto expected = irg::transform_point(after, irg::transform_point(view, irg::transform_point(before, p)));
    for (int k = 0; k < 3; ++k) CHECK(seen[k] == doctest::Approx(expected[k]).epsilon(1e-12).scale(10));
  }
}
