// SPDX-License-Identifier: MIT
#include <irg/view/look_at.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <irg/view/camera_frame.hpp>

#include "support/check_both.hpp"
#include "support/orthonormal.hpp"
#include "support/own_types.hpp"
#include "support/random.hpp"

using irg::identity_matrix;
using irg::look_at;
using irg::look_at_checked;
using irg::look_at_status;
using irg::mat;
using irg::point;
using irg::vec;
using test::from_orthonormal;

namespace {

using P = point<double, 3>;
using V = vec<double, 3>;
using M = mat<double, 4, 4>;

template <class T>
bool finite(const mat<T, 4, 4>& m) {
  for (const auto& row : m.m)
    for (const T x : row)
      if (!std::isfinite(x)) return false;
  return true;
}

}  // namespace

TEST_CASE("look_at: by hand, in every life") {
  // From the z axis towards the origin: nothing but a shift.
  CHECK_BOTH(look_at(P{0, 0, 5}, P{0, 0, 0}, V{0, 1, 0}) ==
             M{{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, -5}, {0, 0, 0, 1}}});
  // From the x axis: the world's -z is to the right.
  constexpr M from_x = look_at(P{5, 0, 0}, P{0, 0, 0}, V{0, 1, 0});
  CHECK_BOTH(transform_point(from_x, P{0, 0, -1}) == P{1, 0, -5});
  CHECK_BOTH(transform_point(from_x, P{0, 2, 0}) == P{0, 2, -5});
  CHECK_BOTH(transform_point(from_x, P{5, 0, 0}) == P{0, 0, 0});
  CHECK_BOTH(look_at_checked(P{5, 0, 0}, P{0, 0, 0}, V{0, 1, 0}) ==
             irg::checked<mat<double, 4, 4>, look_at_status>{from_x, look_at_status::ok});

  constexpr M general = look_at(P{1, 2, 3}, P{-4, 0.5, 2}, V{0.1, 1, 0.2});
  constexpr auto straight_down = look_at_checked(P{0, 5, 0}, P{0, 0, 0}, V{0, 1, 0});
  constexpr auto hostile = look_at_checked(P{std::numeric_limits<double>::quiet_NaN(), 5, 0}, P{0, 0, 0}, V{0, 1, 0});
  volatile double one = 1;
  CHECK(look_at(P{one, 2 * one, 3 * one}, P{-4 * one, 0.5, 2}, V{0.1 * one, 1, 0.2}) == general);
  CHECK(look_at_checked(P{0, 5 * one, 0}, P{0, 0, 0}, V{0, one, 0}) == straight_down);
  static_assert(straight_down.status == look_at_status::up_parallel);
  static_assert(hostile.status == look_at_status::not_finite && hostile.value == identity_matrix<double, 4>());
  static_assert(std::same_as<decltype(look_at(std::array<float, 3>{}, std::array<float, 3>{}, std::array<float, 3>{})),
                             mat<float, 4, 4>>);
}

TEST_CASE("look_at: the course's and Hank's left-handed frames with their depth turned round") {
  // The course's eye system looks along +z; its x and y axes are ours, its z is our -z. O = (1,1,3), G = (0,0,0), z up.
  const M view = look_at(P{1, 1, 3}, P{0, 0, 0}, V{0, 0, 1});
  const double T[4][3] = {{-0.707106781186548, -0.639602149066831, -0.301511344577764},
                          {0.707106781186548, -0.639602149066831, -0.301511344577764},
                          {0, 0.426401432711221, -0.904534033733291},
                          {0, 0, 3.3166247903554}};
  for (int r = 0; r < 4; ++r)
    for (int c = 0; c < 3; ++c) CHECK(view(c, r) == doctest::Approx(c == 2 ? -T[r][c] : T[r][c]).epsilon(1e-13));
  // The third view is rational: O = (4,6,3), G = (1,2,3); (2,2,4) -> (-4/5, 1, 22/5).
  const P p = transform_point(look_at(P{4, 6, 3}, P{1, 2, 3}, V{0, 0, 1}), P{2, 2, 4});
  CHECK(std::abs(p.x + 0.8) <= 1e-15);
  CHECK(std::abs(p.y - 1) <= 1e-15);
  CHECK(std::abs(p.z + 4.4) <= 2e-15);
  // Hank's polar camera, alpha = 30, beta = 45, R = 10: (1,2,3) -> (-0.63, -0.78, 6.40), left-handed as well.
  const P q = transform_point(look_at(P{3.53553390593274, 7.07106781186548, 6.12372435695795}, P{0, 0, 0}, V{0, 1, 0}),
                              P{1, 2, 3});
  CHECK(q.x == doctest::Approx(-0.633974596215561).epsilon(1e-13));
  CHECK(q.y == doctest::Approx(-0.776457135307562).epsilon(1e-13));
  CHECK(q.z == doctest::Approx(-6.39511573994625).epsilon(1e-13));
}

TEST_CASE("look_at: orthonormal, right-handed, eye to the origin, target ahead, up upwards") {
  test::random r(1);
  double worst = 0, worst_float = 0, worst_det = 0;
  for (int i = 0; i < 20000; ++i) {
    P eye, target;
    V up;
    const double spread = std::ldexp(1.0, static_cast<int>(r.integer(-40, 40)));
    for (int k = 0; k < 3; ++k) {
      eye[k] = r.unit() - 0.5;
      target[k] = eye[k] + spread * (r.unit() - 0.5);
      up[k] = r.unit() - 0.5;
    }
    // Some nearly parallel: up is the view plus next to nothing.
    if (r.integer(0, 3) == 0) {
      const double off = std::ldexp(1.0, static_cast<int>(r.integer(-60, -1)));
      for (int k = 0; k < 3; ++k) up[k] = (eye[k] - target[k]) / spread + off * up[k];
    }
    const auto v = look_at_checked(eye, target, up);
    CHECK(v.status != look_at_status::not_finite);
    if (v.status == look_at_status::eye_at_target) continue;
    worst = std::max(worst, from_orthonormal(v.value));
    worst_det = std::max(worst_det, std::abs(determinant(submatrix(v.value, 3, 3)) - 1));
    const P at_eye = transform_point(v.value, eye), at_target = transform_point(v.value, target);
    for (int k = 0; k < 3; ++k) CHECK(std::abs(at_eye[k]) <= 1e-15);
    const double far = std::hypot(eye.x - target.x, eye.y - target.y, eye.z - target.z);
    CHECK(std::abs(at_target.x) <= 4e-15 * (1 + far));
    CHECK(std::abs(at_target.y) <= 4e-15 * (1 + far));
    CHECK(std::abs(at_target.z + far) <= 4e-15 * (1 + far));
    if (v.status == look_at_status::ok) {
      const V up_seen = transform_vector(v.value, up);
      CHECK(up_seen.y > 0);
      CHECK(std::abs(up_seen.x) <= 2e-15);
    }
    const auto f = look_at_checked(
        point<float, 3>{static_cast<float>(eye.x), static_cast<float>(eye.y), static_cast<float>(eye.z)},
        point<float, 3>{static_cast<float>(target.x), static_cast<float>(target.y), static_cast<float>(target.z)},
        vec<float, 3>{static_cast<float>(up.x), static_cast<float>(up.y), static_cast<float>(up.z)});
    worst_float = std::max(worst_float, from_orthonormal(f.value));
  }
  INFO("orthonormal within ", worst * 0x1p53, "u, float ", worst_float * 0x1p24, "u, determinant ", worst_det * 0x1p53,
       "u");
  CHECK(worst <= 8 * 0x1p-53);
  CHECK(worst_float <= 8 * 0x1p-24);
  CHECK(worst_det <= 16 * 0x1p-53);
}

TEST_CASE("look_at: up parallel to the view, zero, or nearly so") {
  // Straight down: y is the view, x is the first axis least aligned with it and stands in for up.
  constexpr auto down = look_at_checked(P{0, 5, 0}, P{0, 0, 0}, V{0, 1, 0});
  CHECK_BOTH(down.value == M{{{0, 0, 1, 0}, {1, 0, 0, 0}, {0, 1, 0, -5}, {0, 0, 0, 1}}});
  CHECK_BOTH(look_at_checked(P{0, 5, 0}, P{0, 0, 0}, V{0, -7, 0}) == down);
  CHECK_BOTH(look_at_checked(P{0, 5, 0}, P{0, 0, 0}, V{0, 0, 0}) == down);
  // In a general direction, where the cross product is rounding noise or exactly zero.
  test::random r(2);
  for (int i = 0; i < 5000; ++i) {
    V d;
    for (int k = 0; k < 3; ++k) d[k] = static_cast<double>(r.integer(-100, 100)) / 7;
    if (d == V{}) continue;
    const double s = r.unit() + 0.5;
    const auto v = look_at_checked(P{0, 0, 0} + d, P{0, 0, 0}, d * s);
    CHECK(v.status == look_at_status::up_parallel);
    CHECK(from_orthonormal(v.value) <= 8 * 0x1p-53);
    CHECK(v == look_at_checked(P{0, 0, 0} + d, P{0, 0, 0}, V{0, 0, 0}));
  }
  // A hair beside the view is enough to be an ordinary camera.
  CHECK_BOTH(look_at_checked(P{0, 0, 5}, P{0, 0, 0}, V{0, 1e-9, 1}).status == look_at_status::ok);
  CHECK_BOTH(look_at(P{0, 0, 5}, P{0, 0, 0}, V{0, 1e-9, 1}) == look_at(P{0, 0, 5}, P{0, 0, 0}, V{0, 1, 0}));
}

TEST_CASE("look_at: eye at the target") {
  constexpr auto v = look_at_checked(P{1, 2, 3}, P{1, 2, 3}, V{0, 1, 0});
  CHECK_BOTH(v.status == look_at_status::eye_at_target);
  CHECK_BOTH(v.value == M{{{1, 0, 0, -1}, {0, 1, 0, -2}, {0, 0, 1, -3}, {0, 0, 0, 1}}});
  constexpr auto both = look_at_checked(P{1, 2, 3}, P{1, 2, 3}, V{0, 0, 1});  // and up along the view that is taken
  CHECK_BOTH(both.status == look_at_status::eye_at_target);
  CHECK_BOTH(from_orthonormal(both.value) == 0.0);
}

TEST_CASE("look_at: hostile numbers give a finite matrix") {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  constexpr double most = std::numeric_limits<double>::max(), least = std::numeric_limits<double>::denorm_min();
  const double values[] = {0,     1,        -1,        least, -least, 1e-300, 1e-160, 1e160,
                           1e300, most / 4, -most / 4, most,  -most,  nan,    inf};
  for (const double a : values)
    for (const double b : values)
      for (const double c : values) {
        for (const auto& v :
             {look_at_checked(P{a, b, c}, P{0, 0, 0}, V{0, 1, 0}), look_at_checked(P{0, 1, 0}, P{a, b, c}, V{0, 1, 0}),
              look_at_checked(P{1, 2, 3}, P{3, 2, 1}, V{a, b, c}),
              look_at_checked(P{a, b, c}, P{b, c, a}, V{c, a, b})}) {
          CHECK(finite(v.value));
          CHECK(from_orthonormal(v.value) <= 8 * 0x1p-53);
        }
        const bool any_bad = !std::isfinite(a) || !std::isfinite(b) || !std::isfinite(c);
        const bool out = any_bad || std::max({std::abs(a), std::abs(b), std::abs(c)}) > most / 4;
        CHECK((look_at_checked(P{a, b, c}, P{0, 0, 0}, V{0, 1, 0}).status == look_at_status::not_finite) == out);
        CHECK((look_at_checked(P{1, 2, 3}, P{3, 2, 1}, V{a, b, c}).status == look_at_status::not_finite) == any_bad);
      }
  // Next to each other by one denormal: still a direction.
  CHECK(look_at_checked(P{0, 0, least}, P{0, 0, 0}, V{0, 1, 0}).status == look_at_status::ok);
  CHECK(look_at(P{0, 0, least}, P{0, 0, 0}, V{0, 1, 0}) ==
        M{{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, -least}, {0, 0, 0, 1}}});
}

#ifdef IRG_HAVE_GLM

TEST_CASE("look_at: GLM's lookAtRH is the same, lookAtLH the same of a left-handed world") {
  const auto of_glm = [](const glm::dmat4& m) {
    M r;
    for (int row = 0; row < 4; ++row)
      for (int c = 0; c < 4; ++c) r(row, c) = m[c][row];
    return r;
  };
  const M mirror{{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, -1, 0}, {0, 0, 0, 1}}};
  test::random r(5);
  double right = 0, left = 0, mirrored = 0;
  for (int i = 0; i < 5000; ++i) {
    double v[9];
    for (double& x : v) x = static_cast<double>(r.integer(-1000, 1000)) / 256;
    const P eye{v[0], v[1], v[2]}, target{v[3], v[4], v[5]};
    const V up{v[6], v[7], v[8]}, view = target - eye, side = cross(view, up);
    if (!(dot(side, side) > 1e-2 * dot(view, view) * dot(up, up))) continue;  // GLM loses digits next to the poles
    const M irg = look_at(eye, target, up);
    right = std::max(right, test::worst_difference(
                                irg, of_glm(glm::lookAtRH(glm::dvec3(v[0], v[1], v[2]), glm::dvec3(v[3], v[4], v[5]),
                                                          glm::dvec3(v[6], v[7], v[8])))));
    const M lh =
        of_glm(glm::lookAtLH(glm::dvec3(v[0], v[1], v[2]), glm::dvec3(v[3], v[4], v[5]), glm::dvec3(v[6], v[7], v[8])));
    for (int c = 0; c < 4; ++c)
      for (int row = 0; row < 3; ++row)
        mirrored = std::max(mirrored, std::abs((row == 1 ? irg(row, c) : -irg(row, c)) - lh(row, c)));
    // The same camera in the world seen in a mirror, which is left-handed.
    const M other = of_glm(
        glm::lookAtLH(glm::dvec3(v[0], v[1], -v[2]), glm::dvec3(v[3], v[4], -v[5]), glm::dvec3(v[6], v[7], -v[8])));
    left = std::max(left, test::worst_difference(
                              view_matrix(irg::look_at_frame(eye, target, up), irg::handedness::left), other * mirror));
  }
  INFO("within ", right * 0x1p53, "u, ", left * 0x1p53, "u, ", mirrored * 0x1p53, "u");
  CHECK(right > 0);
  CHECK(right <= 1e-13);
  CHECK(left <= 1e-13);
  CHECK(mirrored <= 1e-13);
}

#endif

TEST_CASE("look_at: eye and target within a quarter of the largest number, up within all of it") {
  constexpr double most = std::numeric_limits<double>::max(), last = most / 4, beyond = 0x1p1022;
  static_assert(last < beyond);
  for (int axis = 0; axis < 3; ++axis)
    for (const double sign : {1.0, -1.0}) {
      P far_away{0, 0, 0}, too_far{0, 0, 0};
      V up{1, 2, 3};
      far_away[axis] = sign * last;
      too_far[axis] = sign * beyond;
      up[axis] = sign * most;
      CHECK(look_at_checked(far_away, P{1, 2, 3}, up).status != look_at_status::not_finite);
      CHECK(look_at_checked(P{1, 2, 3}, far_away, up).status != look_at_status::not_finite);
      CHECK(look_at_checked(too_far, P{1, 2, 3}, up).status == look_at_status::not_finite);
      CHECK(look_at_checked(P{1, 2, 3}, too_far, up).status == look_at_status::not_finite);
      up[axis] = sign * std::numeric_limits<double>::infinity();
      CHECK(look_at_checked(far_away, P{1, 2, 3}, up).status == look_at_status::not_finite);
    }
}

TEST_CASE("look_at: points in braces are of doubles, or of the type of the others") {
  constexpr irg::point<double, 3> eye{3, 2, 5};
  CHECK_BOTH(irg::look_at({3, 2, 5}, {0, 0, 0}, {0, 1, 0}) ==
             irg::look_at(eye, irg::point<double, 3>{0, 0, 0}, irg::vec<double, 3>{0, 1, 0}));
  CHECK_BOTH(look_at_checked(irg::point<float, 3>{3, 2, 5}, {3, 2, 5}, {0, 1, 0}).status ==
             look_at_status::eye_at_target);
}
