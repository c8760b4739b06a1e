// SPDX-License-Identifier: MIT
#include <irg/view/textbook/view_transform.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

#include <irg/view/look_at.hpp>
#include <irg/view/textbook/project_perspective.hpp>

#include "support/check_both.hpp"
#include "support/orthonormal.hpp"
#include "support/random.hpp"

using irg::hpoint;
using irg::identity_matrix;
using irg::look_at;
using irg::mat;
using irg::point;
using irg::vec;
using irg::textbook::perspective_matrix;
using irg::textbook::project_parallel;
using irg::textbook::project_perspective;
using irg::textbook::transform_row;
using irg::textbook::view_status;
using irg::textbook::view_steps;
using irg::textbook::view_transform;
using irg::textbook::view_transform_steps;
using test::from_orthonormal;
using test::worst_difference;

namespace {

using P = point<double, 3>;
using V = vec<double, 3>;
using M = mat<double, 4, 4>;
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
constexpr double most = std::numeric_limits<double>::max(), least = std::numeric_limits<double>::denorm_min();

constexpr double distance(double a, double b) { return a < b ? b - a : a - b; }

// A left-handed view matrix from a right-handed one.
constexpr M third_row_negated(M m) {
  for (double& entry : m.m[2]) entry = 0.0 - entry;
  return m;
}

constexpr view_steps<double> steps(const P& eye, const P& view_point) { return view_transform_steps(eye, view_point); }

}  // namespace

TEST_CASE("view_transform: the course's values, every step of the first view") {
  constexpr auto s = steps({1, 1, 3}, {0, 0, 0});
  static_assert(s.status == view_status::ok);
  const double r2 = std::sqrt(2.0) / 2, r11 = std::sqrt(11.0), r22 = std::sqrt(22.0);
  CHECK_BOTH(s.t1 == M{{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {-1, -1, -3, 1}}});
  CHECK(worst_difference(s.t2, M{{{-r2, r2, 0, 0}, {-r2, -r2, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}}}) <= 1e-15);
  CHECK(worst_difference(
            s.t3, M{{{-3 * r11 / 11, 0, r22 / 11, 0}, {0, 1, 0, 0}, {-r22 / 11, 0, -3 * r11 / 11, 0}, {0, 0, 0, 1}}}) <=
        1e-15);
  CHECK_BOTH(s.t4 == M{{{0, -1, 0, 0}, {1, 0, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}}});
  CHECK_BOTH(s.t5 == M{{{-1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}}});
  CHECK_BOTH(s.h == 3.3166247903553998);
  constexpr M t = view_transform(P{1, 1, 3}, P{0, 0, 0});
  CHECK(worst_difference(t, M{{{-0.707106781186548, -0.639602149066831, -0.301511344577764, 0},
                               {0.707106781186548, -0.639602149066831, -0.301511344577764, 0},
                               {0, 0.426401432711221, -0.904534033733291, 0},
                               {0, 0, 3.3166247903554, 1}}}) <= 1e-14);
  CHECK_BOTH(t == s.t1 * (s.t2 * (s.t3 * (s.t4 * s.t5))));
  CHECK(std::abs(determinant(submatrix(t, 3, 3)) + 1) <= 1e-15);
  volatile double one = 1;
  CHECK(view_transform(P{one, one, 3 * one}, P{0, 0, 0}) == t);
}

TEST_CASE("view_transform: the course's values, the cubes as the eye sees them") {
  const M t = view_transform(P{1, 1, 3}, P{0, 0, 0});
  const double h = view_transform_steps(P{1, 1, 3}, P{0, 0, 0}).h;
  const double r2 = std::sqrt(2.0), r11 = std::sqrt(11.0) / 11, r22 = std::sqrt(22.0);
  const struct {
    P scene;
    double x_eye, y_eye, z_eye, x, y;
  } rows[] = {
      {{0, 0, 0}, 0, 0, 11 * r11, 0, 0},
      {{0, 0, 1}, 0, r22 / 11, 8 * r11, 0, r22 / 8},
      {{1, 0, 0}, -r2 / 2, -3 * r22 / 22, 10 * r11, -11 * r2 / 20, -3 * r22 / 20},
      {{1, 0, 1}, -r2 / 2, -r22 / 22, 7 * r11, -11 * r2 / 14, -r22 / 14},
      {{1, 1, 0}, 0, -3 * r22 / 11, 9 * r11, 0, -r22 / 3},
      {{1, 1, 1}, 0, -2 * r22 / 11, 6 * r11, 0, -r22 / 3},
      {{0, 1, 0}, r2 / 2, -3 * r22 / 22, 10 * r11, 11 * r2 / 20, -3 * r22 / 20},
      {{0, 1, 1}, r2 / 2, -r22 / 22, 7 * r11, 11 * r2 / 14, -r22 / 14},
      {{-1, -1, -1}, 0, 2 * r22 / 11, 16 * r11, 0, r22 / 8},
      {{-1, -1, 1}, 0, 4 * r22 / 11, 10 * r11, 0, 2 * r22 / 5},
      {{1, -1, -1}, -r2, -r22 / 11, 14 * r11, -11 * r2 / 14, -r22 / 14},
      {{1, -1, 1}, -r2, r22 / 11, 8 * r11, -11 * r2 / 8, r22 / 8},
      {{1, 1, -1}, 0, -4 * r22 / 11, 12 * r11, 0, -r22 / 3},
      {{-1, 1, -1}, r2, -r22 / 11, 14 * r11, 11 * r2 / 14, -r22 / 14},
      {{-1, 1, 1}, r2, r22 / 11, 8 * r11, 11 * r2 / 8, r22 / 8},
  };
  for (const auto& row : rows) {
    const P e = transform_row(row.scene, t);
    CHECK(distance(e.x, row.x_eye) <= 4e-15);
    CHECK(distance(e.y, row.y_eye) <= 4e-15);
    CHECK(distance(e.z, row.z_eye) <= 4e-15);
    const auto seen = project_perspective(e, h);
    REQUIRE(seen.has_value());
    CHECK(distance(seen->x, row.x) <= 4e-15);
    CHECK(distance(seen->y, row.y) <= 4e-15);
    // the same by the matrix P: [x y 0 z/h], and the division
    const hpoint<double, 3> by_matrix = transform_row(to_homogeneous(e), *perspective_matrix(h));
    CHECK(by_matrix.z == 0);
    CHECK(distance(by_matrix.x / by_matrix.w, row.x) <= 4e-15);
    CHECK(distance(by_matrix.y / by_matrix.w, row.y) <= 4e-15);
    CHECK(project_parallel(e) == point<double, 2>{e.x, e.y});
    CHECK(transform_row(to_homogeneous(e), irg::textbook::parallel_matrix<double>()) ==
          hpoint<double, 3>{e.x, e.y, 0, 1});
  }
  CHECK(transform_row(P{1, 1, 3}, t) == P{0, 0, 0});
}

TEST_CASE("view_transform: the course's values, views that are whole or rational numbers") {
  constexpr M t = view_transform(P{0, -5, 0}, P{0, 0, 0});
  CHECK_BOTH(t == M{{{1, 0, 0, 0}, {0, 0, 1, 0}, {0, 1, 0, 0}, {0, 0, 5, 1}}});
  CHECK_BOTH(transform_row(P{1, 0, 0}, t) == P{1, 0, 5});
  CHECK_BOTH(project_perspective(P{1, 0, 5}, 5) == point<double, 2>{1, 0});
  CHECK_BOTH(project_perspective(transform_row(P{0, 0, 1}, t), 5) == point<double, 2>{0, 1});
  CHECK_BOTH(project_perspective(transform_row(P{1, 5, 1}, t), 5) == point<double, 2>{0.5, 0.5});
  CHECK_BOTH(project_perspective(transform_row(P{-2, -1, 3}, t), 5) == point<double, 2>{-2.5, 3.75});
  constexpr auto s = steps({4, 6, 3}, {1, 2, 3});
  CHECK_BOTH(s.h == 5);
  CHECK(worst_difference(view_transform(P{4, 6, 3}, P{1, 2, 3}),
                         M{{{-0.8, 0, -0.6, 0}, {0.6, 0, -0.8, 0}, {0, 1, 0, 0}, {-0.4, -3, 7.2, 1}}}) <= 1e-15);
  const P e = transform_row(P{2, 2, 4}, view_transform(P{4, 6, 3}, P{1, 2, 3}));
  CHECK(distance(e.x, -0.8) + distance(e.y, 1) + distance(e.z, 4.4) <= 3e-15);
  const auto seen = project_perspective(e, 5);
  CHECK(distance(seen->x, -10.0 / 11) + distance(seen->y, 25.0 / 22) <= 3e-15);
}

TEST_CASE("view_transform: where the course divides by zero") {
  constexpr auto down = steps({0, 0, 5}, {0, 0, 0});  // cosine 1, sine 0
  static_assert(down.status == view_status::view_vertical && down.h == 5);
  CHECK_BOTH(view_transform(P{0, 0, 5}, P{0, 0, 0}) == M{{{0, 1, 0, 0}, {-1, 0, 0, 0}, {0, 0, -1, 0}, {0, 0, 5, 1}}});
  CHECK_BOTH(down.t2 == identity_matrix<double, 4>());
  // look_at's stand-in for up agrees looking down, and is turned by half a turn looking up.
  CHECK_BOTH(transpose(third_row_negated(look_at(P{0, 0, 5}, P{0, 0, 0}, V{0, 0, 1}))) ==
             view_transform(P{0, 0, 5}, P{0, 0, 0}));
  CHECK_BOTH(view_transform(P{0, 0, -5}, P{0, 0, 0}) == M{{{0, -1, 0, 0}, {-1, 0, 0, 0}, {0, 0, 1, 0}, {0, 0, 5, 1}}});
  CHECK_BOTH(look_at(P{0, 0, -5}, P{0, 0, 0}, V{0, 0, 1}) ==
             M{{{0, 1, 0, 0}, {1, 0, 0, 0}, {0, 0, -1, -5}, {0, 0, 0, 1}}});

  constexpr auto none = steps({1, 2, 3}, {1, 2, 3});
  static_assert(none.status == view_status::eye_at_view_point && none.h == 0);
  CHECK_BOTH((none.t2 == identity_matrix<double, 4>() && none.t3 == identity_matrix<double, 4>()));
  CHECK_BOTH(view_transform(P{1, 2, 3}, P{1, 2, 3}) == M{{{0, -1, 0, 0}, {-1, 0, 0, 0}, {0, 0, 1, 0}, {2, 1, -3, 1}}});
  CHECK_BOTH(!perspective_matrix(none.h));

  CHECK_BOTH(steps({not_a_number, 0, 0}, {0, 0, 0}) == view_steps<double>{});
  CHECK_BOTH(view_transform(P{0, 0, 0}, P{0, inf, 0}) == identity_matrix<double, 4>());
  CHECK_BOTH(steps({most, 0, 0}, {0, 0, 0}).status == view_status::not_finite);
}

TEST_CASE("view_transform: every step does what the course says, and T is look_at's matrix in other words") {
  test::random r(1);
  double orthonormal = 0, determinant_off = 0, look_at_off = 0, eye_off = 0, single = 0, step_off = 0;
  for (int i = 0; i < 20000; ++i) {
    P eye, g;
    const double spread = std::ldexp(1.0, static_cast<int>(r.integer(-40, 40)));
    for (int k = 0; k < 3; ++k) {
      eye[k] = r.integer(0, 15) == 0 ? 0 : r.unit() - 0.5;
      g[k] = r.integer(0, 15) == 0 ? eye[k] : eye[k] + spread * (r.unit() - 0.5);
    }
    const auto s = steps(eye, g);
    const M t = view_transform(eye, g);
    CHECK(s.status != view_status::not_finite);
    orthonormal = std::max(orthonormal, from_orthonormal(t));
    determinant_off = std::max(determinant_off, std::abs(determinant(submatrix(t, 3, 3)) + 1));
    const P at_eye = transform_row(eye, t);
    for (int k = 0; k < 3; ++k) eye_off = std::max(eye_off, std::abs(at_eye[k]));
    const P after_t2 = transform_row(s.g1, s.t2), after_t3 = transform_row(s.g2, s.t3);
    const double size = s.h > 0 ? s.h : 1;
    step_off = std::max({step_off, std::abs(after_t2.x - s.g2.x) / size, std::abs(after_t2.y) / size,
                         std::abs(after_t3.x) / size, std::abs(after_t3.z - s.h) / size});
    CHECK(after_t2.z == s.g2.z);
    CHECK(s.g2.x >= 0);
    const vec<float, 3> narrow{static_cast<float>(eye.x), static_cast<float>(eye.y), static_cast<float>(eye.z)};
    single = std::max(single, from_orthonormal(view_transform(
                                  to_point(narrow), point<float, 3>{static_cast<float>(g.x), static_cast<float>(g.y),
                                                                    static_cast<float>(g.z)})));
    // The z axis is up: a view next to it leaves look_at's up to rounding, exactly along it to the fallback.
    if (s.status != view_status::ok || s.g2.x < 1e-3 * s.h) continue;
    const M v = third_row_negated(look_at(eye, g, V{0, 0, 1}));
    look_at_off = std::max(look_at_off, worst_difference(transpose(v), t));
  }
  INFO("orthonormal within ", orthonormal * 0x1p53, "u, float ", single * 0x1p24, "u, determinant ",
       determinant_off * 0x1p53, "u, eye at the origin within ", eye_off * 0x1p53, "u, steps ", step_off * 0x1p53,
       "u, from look_at ", look_at_off * 0x1p53, "u");
  CHECK(orthonormal <= 8 * 0x1p-53);
  CHECK(single <= 8 * 0x1p-24);
  CHECK(determinant_off <= 16 * 0x1p-53);
  CHECK(eye_off == 0);
  CHECK(step_off <= 6 * 0x1p-53);
  CHECK(look_at_off <= 8 * 0x1p-53);
}

TEST_CASE("view_transform: hostile numbers give finite matrices") {
  const double values[] = {0,     1,     -1,       least,     -least, 1e-300,       1e-160,
                           1e160, 1e300, most / 4, -most / 4, most,   not_a_number, inf};
  for (const double a : values)
    for (const double b : values)
      for (const double c : values)
        for (const auto& pair : {std::pair{P{a, b, c}, P{0, 0, 0}}, std::pair{P{0, 0, 0}, P{a, b, c}},
                                 std::pair{P{a, b, c}, P{b, c, a}}}) {
          const auto s = view_transform_steps(pair.first, pair.second);
          const M t = view_transform(pair.first, pair.second);
          bool finite = std::isfinite(s.h);
          for (const auto& row : t.m)
            for (const double x : row) finite = finite && std::isfinite(x);
          CHECK(finite);
          CHECK(from_orthonormal(t) <= 8 * 0x1p-53);
          CHECK(from_orthonormal(s.t2) <= 4 * 0x1p-53);
          CHECK(from_orthonormal(s.t3) <= 4 * 0x1p-53);
          const bool bad =
              !(std::max({std::abs(a), std::abs(b), std::abs(c)}) <= most / 4) || a != a || b != b || c != c;
          CHECK((s.status == view_status::not_finite) == bad);
        }
  // One subnormal step away there is a direction all the same.
  CHECK_BOTH(view_transform(P{0, -least, 0}, P{0, 0, 0}) ==
             M{{{1, 0, 0, 0}, {0, 0, 1, 0}, {0, 1, 0, 0}, {0, 0, least, 1}}});
  const auto s = steps({0, 0, 0}, {least, least, least});
  CHECK(distance(s.t2(0, 0), std::sqrt(0.5)) <= 1e-15);
  CHECK(distance(s.t3(0, 0), std::sqrt(1.0 / 3)) <= 1e-15);
}
