// SPDX-License-Identifier: MIT
#include <irg/view/handedness.hpp>

#include <irg/view/affine.hpp>
#include <irg/view/look_at.hpp>
#include <irg/view/oblique.hpp>
#include <irg/view/projection.hpp>

#include "support/check_both.hpp"
#include "support/random.hpp"

using irg::change_handedness;
using irg::from_other_handedness;
using irg::in_other_handedness;
using irg::point;

namespace {
using P = point<double, 3>;
}

TEST_CASE("handedness: a projection for the other hand maps the same place to the same clip coordinates, bit for bit") {
  test::random r(8);
  for (int i = 0; i < 500; ++i) {
    const P p{r.unit() - 0.5, r.unit() - 0.5, -5 * r.unit()};
    const auto check = [&](const irg::mat<double, 4, 4>& m) {
      CHECK(from_other_handedness(m) * change_handedness(p) == m * p);
      CHECK(from_other_handedness(from_other_handedness(m)) == m);
      CHECK(from_other_handedness(m) * change_handedness(to_homogeneous(p)) == m * p);
    };
    check(irg::perspective(1.0, 1.5, 0.1, 10));
    check(irg::perspective(irg::view_window<double>{-1, 2, -0.5, 3}, 2, 0.1, 10, irg::depth_range::standard));
    check(irg::orthographic(irg::view_window<double>{-1, 2, -0.5, 3}, 0.1, 10));
    check(irg::oblique(irg::oblique_depth<double>{0.6, 0.5}, {-1.0, 2, -0.5, 3}, 0.1, 10));
  }
  // By hand: the left-handed perspective of textbooks, the view along +z, w = z.
  constexpr auto left = from_other_handedness(irg::perspective(irg::half_pi<double>, 1, 1, 5));
  CHECK_BOTH((left * P{0, 0, 5}) == irg::hpoint<double, 3>{0, 0, 0, 5});
  CHECK_BOTH((left * P{0, 0, 1}) == irg::hpoint<double, 3>{0, 0, 1, 1});
  CHECK_BOTH(left(3, 2) == 1);
}

TEST_CASE("handedness: from the world through the left-handed camera space gives the picture of the right-handed one") {
  const auto view = irg::look_at(P{3, 2, 5}, P{0, 1, 0}, irg::vec<double, 3>{0, 1, 0});
  const auto projection = irg::perspective(0.7, 1.5, 0.1, 100);
  CHECK(from_other_handedness(projection) * change_handedness(view) == projection * view);
  const P ahead = transform_point(change_handedness(view), P{0, 1, 0});
  CHECK(ahead.z > 0);
}

TEST_CASE("handedness: planes and maps of the space into itself") {
  const auto turn = irg::rotation(irg::vec<double, 3>{1, 2, 3}, 0.8);
  const P p{0.3, -0.7, 1.9};
  const auto other = in_other_handedness(turn);
  CHECK(transform_point(other, change_handedness(p)) == change_handedness(transform_point(turn, p)));
  CHECK(orientation_of(other) == irg::map_orientation::preserving);
  CHECK(in_other_handedness(other) == turn);
  constexpr irg::plane<double> plane{1, 2, 3, 4};
  CHECK_BOTH(plane_value(change_handedness(plane), change_handedness(P{5, 6, 7})) == plane_value(plane, P{5, 6, 7}));
  CHECK_BOTH(in_other_handedness(irg::identity_matrix<double, 4>()) == irg::identity_matrix<double, 4>());
}
