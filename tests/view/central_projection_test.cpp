// SPDX-License-Identifier: MIT
#include <irg/view/central_projection.hpp>

#include <cmath>
#include <limits>
#include <optional>

#include "support/check_both.hpp"
#include "support/random.hpp"
#include "support/rational.hpp"

using irg::central_projection;
using irg::central_projection_checked;
using irg::point;
using irg::project_central;
using irg::project_parallel;
using irg::projection_origin;
using irg::projection_status;
using test::rational;

namespace {

using R = rational;
using P3 = point<R, 3>;
using P2 = point<R, 2>;
using D3 = point<double, 3>;
using D2 = point<double, 2>;
constexpr auto eye = projection_origin::eye;
constexpr auto plane = projection_origin::picture_plane;

constexpr P2 by_matrix(const P3& p, R d, projection_origin o) {
  const P3 q = to_cartesian(central_projection(d, o) * p);
  return {q.x, q.y};
}

}  // namespace

TEST_CASE("central projection: Hank, the eye at the origin") {
  CHECK_BOTH(project_central(P3{3, -2, 6}, 2, eye) == P2{1, {-2, 3}});
  CHECK_BOTH(project_central(P3{3, -2, 3}, 2, eye) == P2{2, {-4, 3}});
  CHECK_BOTH(project_central(P3{3, -2, 0}, 2, eye) == std::nullopt);
  CHECK_BOTH(project_central(P3{3, -2, -1}, 2, eye) == std::nullopt);
  const D3 seen{-0.633974596215561, -0.776457135307562, 6.39511573994625};
  const auto p = *project_central(seen, 2, eye);
  CHECK(std::abs(p.x + 0.19826837292577) <= 1e-13);
  CHECK(std::abs(p.y + 0.242828172899992) <= 1e-13);
  CHECK_BOTH(project_parallel(D3{-0.633974596215561, -0.776457135307562, 6.39511573994625}) ==
             D2{-0.633974596215561, -0.776457135307562});
}

TEST_CASE("central projection: the slides, the picture plane at the origin, the eye at (0, 0, 20)") {
  CHECK_BOTH(project_central(P3{0, 0, 10}, 20, plane) == P2{0, 0});
  CHECK_BOTH(project_central(P3{8, 0, 6}, 20, plane) == P2{{80, 7}, 0});
  CHECK_BOTH(project_central(P3{0, 4, 2}, 20, plane) == P2{0, {40, 9}});
  CHECK_BOTH(project_central(P3{2, 1, 7}, 20, plane) == P2{{40, 13}, {20, 13}});
  CHECK_BOTH(project_central(P3{{8, 3}, {4, 3}, 6}, 20, plane) == P2{{80, 21}, {40, 21}});
  CHECK_BOTH(project_central(P3{1, 1, 20}, 20, plane) == std::nullopt);
  CHECK_BOTH(project_central(P3{1, 1, 21}, 20, plane) == std::nullopt);
  CHECK_BOTH(project_central(P3{5, 7, 0}, 20, plane) == P2{5, 7});  // on the picture plane
}

TEST_CASE("central projection: the matrix says the same, in rationals, and the ray goes through the picture") {
  test::random r(1);
  for (int i = 0; i < 2000; ++i) {
    const auto n = [&](int low) { return R{r.integer(low, 50), r.integer(1, 9)}; };
    const P3 p{n(-50), n(-50), n(-50)};
    const R d = n(1);
    for (const auto o : {eye, plane}) {
      const auto q = project_central(p, d, o);
      const R depth = o == eye ? p.z : d - p.z;
      CHECK(q.has_value() == (R(0) < depth));
      CHECK(((central_projection(d, o) * p).w == depth));
      if (!q) continue;
      CHECK(by_matrix(p, d, o) == *q);
      // Similar triangles: eye, picture and point are collinear.
      CHECK((q->x * depth == p.x * d && q->y * depth == p.y * d));
    }
    // Depth of the slides' matrix grows with z in front of the eye, and lines stay straight: z * d / (d - z).
    const R z1 = d - R{r.integer(1, 60), 7}, z2 = d - R{r.integer(1, 60), 7};
    const auto depth_of = [&](R z) { return to_cartesian(central_projection(d, plane) * P3{0, 0, z}).z; };
    CHECK((z1 < z2) == (depth_of(z1) < depth_of(z2)));
  }
}

TEST_CASE("central projection: bad distances and numbers, in every life") {
  constexpr double inf = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();
  static_assert(central_projection_checked(0.0, eye).status == projection_status::bad_distance);
  static_assert(central_projection_checked(-1.0, plane).status == projection_status::bad_distance);
  static_assert(central_projection_checked(nan, eye).status == projection_status::bad_distance);
  static_assert(central_projection_checked(inf, eye).status == projection_status::bad_distance);
  static_assert(central_projection_checked(inf, eye).value == irg::identity_matrix<double, 4>());
  static_assert(central_projection_checked(R(-1, 2), eye).status == projection_status::bad_distance);
  for (const auto o : {eye, plane}) {
    CHECK(!project_central(D3{1, 1, 1}, 0, o));
    CHECK(!project_central(D3{1, 1, 1}, -1, o));
    CHECK(!project_central(D3{1, 1, 1}, nan, o));
    CHECK(!project_central(D3{1, 1, 1}, inf, o));
    CHECK(!project_central(D3{1, 1, nan}, 1, o));
    CHECK(!project_central(D3{nan, 1, 0.5}, 1, o));
    CHECK(!project_central(D3{1, nan, 0.5}, 1, o));
  }
  static_assert(!project_central(D3{1, 1, nan}, 1, plane) && !project_central(D3{1, 1, inf}, 1, plane));
  constexpr auto at_compile_time = project_central(D3{0.1, 0.7, 0.3}, 1.3, plane);
  volatile double x = 0.1;
  CHECK(project_central(D3{x, 0.7, 0.3}, 1.3, plane) == at_compile_time);
}
