// SPDX-License-Identifier: MIT
#include <irg/view/camera_frame.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

#include <irg/view/affine.hpp>

#include "support/check_both.hpp"
#include "support/orthonormal.hpp"
#include "support/random.hpp"

using irg::camera_frame_status;
using irg::camera_to_world;
using irg::change_handedness;
using irg::frame_of_view;
using irg::handedness;
using irg::look_at;
using irg::look_at_frame;
using irg::mat;
using irg::orthonormalized;
using irg::orthonormalized_checked;
using irg::view_matrix;
using irg::view_rotation;
using irg::view_translation;
using test::from_orthonormal;
using test::worst_difference;

namespace {

using P = irg::point<double, 3>;
using V = irg::vec<double, 3>;
using M = mat<double, 4, 4>;
using frame = irg::camera_frame<double>;
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();

V random_vector(test::random& r) {
  V v;
  for (int k = 0; k < 3; ++k) v[k] = r.unit() - 0.5;
  return v;
}

}  // namespace

TEST_CASE("camera_frame: by hand, either handedness, in every life") {
  static_assert(std::is_aggregate_v<frame> && std::is_trivially_copyable_v<frame>);
  constexpr frame from_x = look_at_frame(P{5, 0, 0}, P{0, 0, 0}, V{0, 1, 0});
  CHECK_BOTH(from_x == frame{{5, 0, 0}, {0, 0, -1}, {0, 1, 0}, {-1, 0, 0}});
  CHECK_BOTH(view_matrix(from_x) == M{{{0, 0, -1, 0}, {0, 1, 0, 0}, {1, 0, 0, -5}, {0, 0, 0, 1}}});
  CHECK_BOTH(view_matrix(from_x, handedness::left) == M{{{0, 0, -1, 0}, {0, 1, 0, 0}, {-1, 0, 0, 5}, {0, 0, 0, 1}}});
  CHECK_BOTH(view_matrix(from_x) == view_rotation(from_x) * view_translation(from_x));
  CHECK_BOTH(transform_point(view_matrix(from_x, handedness::left), P{0, 2, -1}) == P{1, 2, 5});
  CHECK_BOTH(transform_point(camera_to_world(from_x, handedness::left), P{1, 2, 5}) == P{0, 2, -1});
  CHECK_BOTH(transform_point(camera_to_world(from_x), P{1, 2, -5}) == P{0, 2, -1});
  CHECK_BOTH(view_matrix(frame{}) == irg::identity_matrix<double, 4>());
  CHECK_BOTH(irg::orientation_of(view_matrix(from_x)) == irg::map_orientation::preserving);
  CHECK_BOTH(irg::orientation_of(view_matrix(from_x, handedness::left)) == irg::map_orientation::reversing);
  volatile double five = 5;
  CHECK(look_at_frame(P{five, 0, 0}, P{0, 0, 0}, V{0, 1, 0}) == from_x);
}

TEST_CASE("camera_frame: Hank's left-handed camera at alpha = beta = 0, R = 5") {
  constexpr frame s3{{0, 0, 5}, {1, 0, 0}, {0, 1, 0}, {0, 0, -1}};  // X, Y, Z as printed
  constexpr M m = view_matrix(s3, handedness::left);
  CHECK_BOTH(transform_point(m, P{1, 0, 0}) == P{1, 0, 5});  // X is the viewer's right
  CHECK_BOTH(transform_point(m, P{0, 1, 0}) == P{0, 1, 5});
  CHECK_BOTH(transform_point(m, P{0, 0, 1}) == P{0, 0, 4});
  CHECK_BOTH(transform_point(m, P{0, 0, 0}) == P{0, 0, 5});
}

TEST_CASE("camera_frame: the other handedness, there and back") {
  constexpr frame f = look_at_frame(P{1, 2, 3}, P{-4, 0.5, 2}, V{0.1, 1, 0.2});
  constexpr M right = view_matrix(f), left = view_matrix(f, handedness::left);
  CHECK_BOTH(change_handedness(right) == left);
  CHECK_BOTH(change_handedness(left) == right);
  CHECK_BOTH(change_handedness(P{1, 2, 3}) == P{1, 2, -3});
  CHECK_BOTH(change_handedness(V{1, 2, -3}) == V{1, 2, 3});
  CHECK_BOTH(transform_point(left, P{7, 8, 9}) == change_handedness(transform_point(right, P{7, 8, 9})));
  CHECK_BOTH(frame_of_view(left, handedness::left).forward == f.forward);
  CHECK_BOTH(frame_of_view(right).right == f.right);
}

TEST_CASE("camera_frame: M = R * T equals look_at, its inverse undoes it, its frame comes back") {
  test::random r(1);
  double inverse_off = 0, position_off = 0;
  for (int i = 0; i < 20000; ++i) {
    const P eye = to_point(random_vector(r));
    const double spread = std::ldexp(1.0, static_cast<int>(r.integer(-40, 40)));
    const P target = eye + random_vector(r) * spread;
    const V up = random_vector(r);
    const frame f = look_at_frame(eye, target, up);
    CHECK(f.position == eye);
    CHECK(view_matrix(f) == look_at(eye, target, up));
    CHECK(view_matrix(f, handedness::left) == change_handedness(look_at(eye, target, up)));
    const auto sense = i % 2 ? handedness::left : handedness::right;
    inverse_off = std::max(inverse_off, worst_difference(view_matrix(f, sense) * camera_to_world(f, sense),
                                                         irg::identity_matrix<double, 4>()));
    const frame back = frame_of_view(view_matrix(f, sense), sense);
    CHECK((back.right == f.right && back.up == f.up && back.forward == f.forward));
    for (int k = 0; k < 3; ++k) position_off = std::max(position_off, std::abs(back.position[k] - eye[k]));
  }
  INFO("inverse within ", inverse_off * 0x1p53, "u, position within ", position_off * 0x1p53, "u");
  CHECK(inverse_off <= 8 * 0x1p-53);
  CHECK(position_off <= 8 * 0x1p-53);
}

TEST_CASE("camera_frame: look_at's fallbacks") {
  CHECK_BOTH(look_at_frame(P{0, 5, 0}, P{0, 0, 0}, V{0, 1, 0}) == frame{{0, 5, 0}, {0, 0, 1}, {1, 0, 0}, {0, -1, 0}});
  CHECK_BOTH(look_at_frame(P{1, 2, 3}, P{1, 2, 3}, V{0, 1, 0}) == frame{{1, 2, 3}, {1, 0, 0}, {0, 1, 0}, {0, 0, -1}});
  CHECK_BOTH(look_at_frame(P{1, not_a_number, 3}, P{1, 2, 3}, V{0, 1, 0}) == frame{});
}

TEST_CASE("camera_frame: orthonormal repair of drifted frames") {
  test::random r(2);
  double worst = 0, single = 0, moved = 0;
  for (int i = 0; i < 20000; ++i) {
    const P eye = to_point(random_vector(r)), target = to_point(random_vector(r));
    frame f = look_at_frame(eye, target, random_vector(r));
    const frame clean = f;
    const double drift = std::ldexp(1.0, static_cast<int>(r.integer(-50, -2)));
    for (V* axis : {&f.right, &f.up, &f.forward})
      *axis = (*axis + random_vector(r) * drift) * std::ldexp(1.0, static_cast<int>(r.integer(-600, 600)));
    const auto fixed = orthonormalized_checked(f);
    CHECK(fixed.status == camera_frame_status::ok);
    CHECK(fixed.value.position == f.position);
    worst = std::max(worst, from_orthonormal(fixed.value));
    for (int k = 0; k < 3; ++k) {
      moved = std::max(moved, std::abs(fixed.value.forward[k] - normalized(f.forward)[k]));
      CHECK(std::abs(fixed.value.right[k] - clean.right[k]) <= 4 * drift);
      CHECK(std::abs(fixed.value.up[k] - clean.up[k]) <= 4 * drift);
    }
    CHECK(dot(fixed.value.up, normalized(f.up)) > 0);
    irg::camera_frame<float> g;
    for (int k = 0; k < 3; ++k) {
      g.up[k] = static_cast<float>(random_vector(r).x);
      g.forward[k] = static_cast<float>(random_vector(r).y);
    }
    single = std::max(single, from_orthonormal(orthonormalized(g)));
  }
  INFO("orthonormal within ", worst * 0x1p53, "u, float ", single * 0x1p24, "u");
  CHECK(moved == 0);
  CHECK(worst <= 8 * 0x1p-53);
  CHECK(single <= 8 * 0x1p-24);
  // A clean frame stays what it is, a mirrored one is righted.
  constexpr frame clean{{1, 2, 3}, {0, 0, -1}, {0, 1, 0}, {-1, 0, 0}};
  CHECK_BOTH(orthonormalized_checked(clean) ==
             irg::checked<irg::camera_frame<double>, camera_frame_status>{clean, camera_frame_status::ok});
  CHECK_BOTH(orthonormalized(frame{{1, 2, 3}, {0, 0, 1}, {0, 1, 0}, {-1, 0, 0}}) == clean);
  // Unlike the axes of a mean of all three, forward is kept and up only loses what lies along it.
  CHECK_BOTH(orthonormalized(frame{{1, 2, 3}, {7, 7, 7}, {-5, 2, 0}, {-3, 0, 0}}) == clean);
}

TEST_CASE("camera_frame: repair of frames with an axis missing") {
  using result = irg::checked<irg::camera_frame<double>, camera_frame_status>;
  constexpr auto ordinary = camera_frame_status::ok, up = camera_frame_status::up_replaced,
                 forward = camera_frame_status::forward_replaced;
  constexpr V zero{}, nans{not_a_number, 0, 1}, infinite{inf, 0, 0}, x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
  const auto repaired = [](const V& r, const V& u, const V& f) { return orthonormalized_checked(frame{{}, r, u, f}); };
  for (const V& gone : {zero, nans, infinite}) {
    CHECK(repaired(gone, y, -z) == result{frame{}, ordinary});
    CHECK(repaired(x, gone, -z) == result{frame{}, up});
    CHECK(repaired(x, y, gone) == result{frame{}, forward});
    CHECK(repaired(-z, y, gone) == result{frame{{}, -z, y, -x}, forward});
    CHECK(repaired(gone, gone, -z) == result{frame{{}, -y, x, -z}, up});  // x is the first axis least along z
    CHECK(repaired(gone, y, gone) == result{frame{}, forward});
    CHECK(repaired(gone, gone, gone) == result{frame{{}, -y, x, -z}, forward});
  }
  CHECK(repaired(x, -z, -z) == result{frame{}, up});  // up along the view: right tells what is above
  CHECK(repaired(z, z, -z) == result{frame{{}, -y, x, -z}, up});
  CHECK(repaired(y, y, zero) == result{frame{}, forward});
  test::random r(3);
  for (int i = 0; i < 5000; ++i) {  // up along the view but for rounding
    V d;
    for (int k = 0; k < 3; ++k) d[k] = static_cast<double>(r.integer(-100, 100)) / 7;
    if (d == zero) continue;
    const auto fixed = repaired(zero, d * (r.unit() + 0.5), d);
    CHECK(fixed.status == up);
    CHECK(fixed == repaired(zero, zero, d));
  }
  for (int i = 0; i < 20000; ++i) {
    frame f;
    for (V* axis : {&f.right, &f.up, &f.forward})
      for (int k = 0; k < 3; ++k) {
        const double values[] = {0, 1, -1, 1e-310, 1e300, 1e-16, not_a_number, inf, r.unit()};
        (*axis)[k] = values[r.integer(0, 8)];
      }
    CHECK(from_orthonormal(orthonormalized(f)) <= 8 * 0x1p-53);
  }
}
