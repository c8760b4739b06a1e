// SPDX-License-Identifier: MIT
#include <studio/studio_transformation.hpp>

#include <limits>
#include <random>
#include <vector>

#include "support/check_both.hpp"

namespace {

using transformation = irg::studio_transformation<double>;
using enum irg::studio_map;

constexpr irg::point<double, 3> moved(const transformation& t, const irg::point<double, 3>& p) {
  const irg::hpoint<double, 3> q = *irg::matrix_of(t) * irg::to_homogeneous(p);
  return {q.x / q.w, q.y / q.w, q.z / q.w};
}

}  // namespace

TEST_CASE("studio transformations: by their names, at compile time, too") {
  using p = irg::point<double, 3>;
  CHECK_BOTH(moved({translate, {1, 2, 3}}, {10, 20, 30}) == p{11, 22, 33});
  CHECK_BOTH(moved({scale, {1, -2, 0}}, {10, 20, 30}) == p{10, -40, 0});
  CHECK_BOTH(moved({shear, {2, 0, 0, 0, 0, 3}}, {1, 10, 100}) == p{21, 10, 130});
  CHECK_BOTH(moved({shear, {0, 1, 2, 3, 4, 0}}, {1, 10, 100}) == p{101, 312, 104});
  CHECK_BOTH(moved({mirror, {0, 2, 0, -6}}, {5, 1, 7}) == p{5, 5, 7});
  CHECK_BOTH(moved({mirror, {1, -1, 0, 0}}, {3, 8, 1}) == p{8, 3, 1});
  CHECK_BOTH(moved({parallel, {0, 1, 0, 0, 1, 1, 0}}, {5, 3, 2}) == p{2, 0, 2});
  CHECK_BOTH(moved({central, {0, 1, 0, 0, 0, 4, 0}}, {1, 2, 3}) == p{2, 0, 6});
  CHECK_BOTH(moved({matrix, {0, 0, 1, 5, 1, 0, 0, 6, 0, 1, 0, 7, 0, 0, 0, 1}}, {1, 2, 3}) == p{8, 7, 9});
  CHECK_BOTH(moved({rotate, {0, 0, 0, 50}}, {1, 2, 3}) == p{1, 2, 3});  // an axis without length
  CHECK_BOTH(moved({rotate_x, {0}}, {1, 2, 3}) == p{1, 2, 3});
}

TEST_CASE("studio transformations: turns as those about their axes") {
  for (const double degrees : {-400.0, -30.0, 0.0, 12.5, 90.0, 1e6}) {
    const double a = irg::radians(degrees);
    CHECK(*irg::matrix_of(transformation{rotate_x, {degrees}}) == irg::rotation_x(a));
    CHECK(*irg::matrix_of(transformation{rotate_y, {degrees}}) == irg::rotation_y(a));
    CHECK(*irg::matrix_of(transformation{rotate_z, {degrees}}) == irg::rotation_z(a));
    CHECK(*irg::matrix_of(transformation{rotate, {1, 2, 3, degrees}}) ==
          irg::rotation(irg::vec<double, 3>{1, 2, 3}, a));
  }
}

TEST_CASE("studio transformations: a mirror image twice is where it was, its way halved by the plane") {
  std::mt19937_64 random(11);
  std::uniform_int_distribution<int> whole(-9, 9);
  for (int i = 0; i < 1000; ++i) {
    const double a = whole(random), b = whole(random), c = whole(random), d = whole(random);
    const transformation t{mirror, {a, b, c, d}};
    CHECK(irg::matrix_of(t).has_value() == (a != 0 || b != 0 || c != 0));
    if (!irg::matrix_of(t)) continue;
    const irg::point<double, 3> p{double(whole(random)), double(whole(random)), double(whole(random))};
    const auto q = moved(t, p), back = moved(t, q);
    for (int k = 0; k < 3; ++k) CHECK(back[k] == doctest::Approx(p[k]).epsilon(1e-12).scale(10));
    const double distance = a * (p.x + q.x) / 2 + b * (p.y + q.y) / 2 + c * (p.z + q.z) / 2 + d;
    CHECK(distance == doctest::Approx(0).epsilon(1e-12).scale(1000));
  }
}

TEST_CASE("studio transformations: none where there is none") {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  CHECK_BOTH(!irg::matrix_of(transformation{mirror, {0, 0, 0, 1}}));
  CHECK_BOTH(!irg::matrix_of(transformation{parallel, {0, 1, 0, 0, 1, 0, 0}}));  // along the plane
  CHECK_BOTH(!irg::matrix_of(transformation{central, {0, 1, 0, 0, 5, 0, 5}}));  // from within it
  CHECK_BOTH(!irg::matrix_of(transformation{translate, {0, nan, 0}}));
  CHECK_BOTH(!irg::matrix_of(transformation{rotate_x, {inf}}));
  CHECK_BOTH(!irg::matrix_of(transformation{scale, {1, 1, 1, nan}}));  // a number that it does not take
  CHECK(irg::matrix_of(transformation{translate, {1e308, -1e308, 5e-324}}).has_value());
  CHECK(irg::matrix_of(transformation{mirror, {1e300, 1e-300, 0, 1e300}}).has_value());
}

TEST_CASE("studio transformations: a list, the first one first") {
  const std::vector<transformation> list{{translate, {1, 0, 0}}, {scale, {2, 2, 2}}, {mirror, {}}};
  const auto m = irg::matrix_of(std::span<const transformation>(list));
  CHECK(irg::transform_point(m, irg::point<double, 3>{3, 4, 5}) == irg::point<double, 3>{8, 8, 10});
  CHECK(irg::matrix_of(std::span<const transformation>()) == irg::identity_matrix<double, 4>());
}
