// SPDX-License-Identifier: MIT
#include <irg/view/plane_projection.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "support/check_both.hpp"
#include "support/random.hpp"
#include "support/rational.hpp"

using irg::central_projection_onto_checked;
using irg::hpoint;
using irg::parallel_projection_onto_checked;
using irg::plane;
using irg::plane_projection_status;
using irg::point;
using irg::projection_onto_plane_checked;
using irg::shadow_matrix_checked;
using irg::vec;
using test::rational;

namespace {

using R = rational;
using P = point<R, 3>;
using D = point<double, 3>;
constexpr double inf = std::numeric_limits<double>::infinity(), not_a_number = std::numeric_limits<double>::quiet_NaN();
using enum plane_projection_status;

// Refused in a question, too: integers have no quotient.
template <class T>
concept throws_shadows = requires(const plane<T>& o, const point<T, 3>& p) { central_projection_onto_checked(o, p); } ||
                         requires(const plane<T>& o, const vec<T, 3>& v) { parallel_projection_onto_checked(o, v); } ||
                         requires(const plane<T>& o, const hpoint<T, 3>& h) { shadow_matrix_checked(o, h); };
static_assert(throws_shadows<R> && !throws_shadows<int>);

R value(const plane<R>& o, const P& p) { return plane_value(o, p); }

// Where the line through p along `ray` meets the plane, solved by itself.
P meeting(const plane<R>& o, const P& p, const vec<R, 3>& ray) {
  const R slope = o.a * ray.x + o.b * ray.y + o.c * ray.z, t = -value(o, p) / slope;
  return {p.x + t * ray.x, p.y + t * ray.y, p.z + t * ray.z};
}

}  // namespace

TEST_CASE("plane_projection: by hand, in every life") {
  // From (0, 4, 0) on the floor y = 0.
  constexpr plane<double> floor{0, 1, 0, 0};
  constexpr auto m = central_projection_onto_checked(floor, D{0, 4, 0});
  CHECK_BOTH(m.status == ok);
  CHECK_BOTH((m.value * D{1, 2, 3}) == hpoint<double, 3>{1, 0, 3, 0.5});
  CHECK_BOTH((m.value * D{1, 0, 3}) == hpoint<double, 3>{1, 0, 3, 1});   // of the plane: stays
  CHECK_BOTH((m.value * D{1, 4, 3}).w == 0);                             // at the eye's height
  CHECK_BOTH((m.value * D{1, 5, 3}).w < 0);                              // above the eye
  CHECK_BOTH((m.value * D{1, -4, 3}) == hpoint<double, 3>{1, 0, 3, 2});  // beyond the plane
  // The sun at 45 degrees.
  constexpr auto s = parallel_projection_onto_checked(floor, vec<double, 3>{1, -1, 0});
  CHECK_BOTH(transform_point(s.value, D{1, 2, 3}) == D{3, 0, 3});
  CHECK_BOTH((s.value * D{1, 2, 3}).w == 1);
  // The slides: the eye at (0, 0, d) and the plane z = 0; x * d / (d - z).
  constexpr auto s1 = central_projection_onto_checked(plane<R>{0, 0, 1, 0}, P{0, 0, 20});
  CHECK_BOTH(to_cartesian(s1.value * P{8, 0, 6}) == P{{80, 7}, 0, 0});
  // Hank: the eye at the origin and the plane z = d; d * x / z.
  constexpr auto s3 = central_projection_onto_checked(plane<R>{0, 0, 1, -2}, P{0, 0, 0});
  CHECK_BOTH(to_cartesian(s3.value * P{3, -2, 6}) == P{1, {-2, 3}, 2});
  constexpr auto any = central_projection_onto_checked(plane<float>{0.1f, 0.2f, 0.7f, 1.3f}, point<float, 3>{3, 1, 2});
  volatile float a = 0.1f;
  CHECK(central_projection_onto_checked(plane<float>{a, 0.2f, 0.7f, 1.3f}, point<float, 3>{3, 1, 2}) == any);
}

TEST_CASE(
    "plane_projection: in rationals the image is where eye, point and plane say, for any scale and sign of both") {
  test::random r(9);
  int cases = 0;
  for (int i = 0; i < 3000; ++i) {
    const auto n = [&] { return R{r.integer(-9, 9), r.integer(1, 3)}; };
    const plane<R> o{n(), n(), n(), n()};
    const P eye{n(), n(), n()}, p{n(), n(), n()};
    const vec<R, 3> direction{n(), n(), n()};
    const R scale = R(r.integer(1, 5)) * R(r.integer(0, 1) ? 1 : -1);
    const bool normal = o.a != R(0) || o.b != R(0) || o.c != R(0);
    const auto central = central_projection_onto_checked(o, eye);
    if (!normal)
      CHECK(central.status == no_plane);
    else if (value(o, eye) == R(0))
      CHECK(central.status == eye_in_plane);
    else {
      REQUIRE(central.status == ok);
      ++cases;
      const auto q = central.value * p;
      CHECK(q.w == R(1) - value(o, p) / value(o, eye));
      const vec<R, 3> ray{p.x - eye.x, p.y - eye.y, p.z - eye.z};
      if (q.w != R(0)) CHECK(to_cartesian(q) == meeting(o, p, ray));
      CHECK(central.value * eye == hpoint<R, 3>{0, 0, 0, 0});  // the one position without an image
      CHECK(projection_onto_plane_checked(plane<R>{o.a * scale, o.b * scale, o.c * scale, o.d * scale},
                                          hpoint<R, 3>{eye.x * scale, eye.y * scale, eye.z * scale, scale}) == central);
    }
    const auto parallel = parallel_projection_onto_checked(o, direction);
    const R slope = o.a * direction.x + o.b * direction.y + o.c * direction.z;
    if (normal && slope != R(0)) {
      REQUIRE(parallel.status == ok);
      CHECK((parallel.value * p).w == R(1));
      CHECK(transform_point(parallel.value, p) == meeting(o, p, direction));
      CHECK(parallel.value * parallel.value == parallel.value);  // twice is once
    } else if (normal) {
      CHECK(parallel.status == (direction == vec<R, 3>{0, 0, 0} ? no_eye : direction_parallel));
    }
  }
  CHECK(cases > 1000);
}

TEST_CASE("plane_projection: in doubles close to rationals, the plane's points stay, whatever the scale") {
  test::random r(10);
  for (int i = 0; i < 2000; ++i) {
    const auto n = [&] { return static_cast<double>(r.integer(-99, 99)); };
    const double a = n(), b = n(), c = n(), d = n(), x = n(), y = n(), z = n();
    const auto exact = central_projection_onto_checked(plane<R>{R::of(a), R::of(b), R::of(c), R::of(d)},
                                                       P{R::of(x), R::of(y), R::of(z)});
    const auto m = central_projection_onto_checked(plane<double>{a, b, c, d}, D{x, y, z});
    CHECK(m.status == exact.status);
    if (m.status != ok) continue;
    const double height = a * x + b * y + c * z + d;
    const double bound =
        6 * 0x1p-53 * (std::abs(a * x) + std::abs(b * y) + std::abs(c * z) + std::abs(d)) / std::abs(height);
    for (int row = 0; row < 4; ++row)
      for (int col = 0; col < 4; ++col)
        CHECK(std::abs(m.value(row, col) - static_cast<double>(exact.value(row, col))) <=
              bound + 4 * 0x1p-53 * std::abs(m.value(row, col)));
    for (const double s : {0x1p-600, 0x1p600, -0x1p-1000})
      CHECK(central_projection_onto_checked(plane<double>{a * s, b * s, c * s, d * s}, D{x, y, z}) == m);
  }
}

TEST_CASE("plane_projection: an eye close to the plane, the bound of large entries") {
  test::random r(12);
  double beyond = 0;  // how far entries are off, in 6u s
  for (int i = 0; i < 3000; ++i) {
    const auto n = [&] { return r.integer(-(std::int64_t{1} << 30), std::int64_t{1} << 30); };
    const std::int64_t eye[] = {n(), n(), n()}, normal[] = {n(), n(), n()};
    std::int64_t height = 0, left = 0;
    double sizes = 0;
    for (int k = 0; k < 3; ++k) {
      left += eye[k] * normal[k];
      sizes += std::abs(static_cast<double>(eye[k] * normal[k]));
    }
    const double d = -static_cast<double>(left) * (1 + r.unit() / static_cast<double>(1 << i % 30));
    height = left + static_cast<std::int64_t>(d);
    if (height == 0 || std::abs(d) >= 0x1p61 || std::abs(d) < 0x1p53) continue;
    sizes = (sizes + std::abs(d)) / std::abs(static_cast<double>(height));
    const auto f = [](std::int64_t v) { return static_cast<double>(v); };
    const auto m = central_projection_onto_checked(plane<double>{f(normal[0]), f(normal[1]), f(normal[2]), d},
                                                   D{f(eye[0]), f(eye[1]), f(eye[2])});
    REQUIRE(m.status == ok);
    for (int row = 0; row < 3; ++row)
      for (int col = 0; col < 3; ++col) {
        const std::int64_t over = (row == col ? height : 0) - eye[row] * normal[col];
        const double e = f(over) / f(height), off = std::abs(m.value(row, col) - e) - 2 * 0x1p-53 * std::abs(e);
        CHECK(off <= 6 * 0x1p-53 * sizes * (1 + std::abs(e)));
        beyond = std::max(beyond, off / (6 * 0x1p-53 * sizes));
      }
  }
  CHECK(beyond > 100);  // so that the size of an entry counts
}

TEST_CASE("shadow_matrix: what is between light and floor throws a shadow, nothing else does") {
  constexpr plane<double> floor{0, 2, 0, 0};
  for (const double w : {1.0, -1.0, 0.5}) {  // one lamp at (0, 10, 0), whatever the weight
    const auto m = shadow_matrix_checked(floor, hpoint<double, 3>{0, 10 * w, 0, w}).value;
    CHECK((m * D{1, 5, 0}).w == 0.5);
    CHECK(to_cartesian(m * D{1, 5, 0}) == D{2, 0, 0});
    CHECK((m * D{1, 10, 0}).w == 0);
    CHECK((m * D{1, 11, 0}).w < 0);
    CHECK((m * D{1, -1, 0}).w > 1);
  }
  CHECK(shadow_matrix_checked(floor, hpoint<double, 3>{1, 2, 3, 0}) ==
        parallel_projection_onto_checked(floor, vec<double, 3>{-1, -2, -3}));
  CHECK_BOTH(irg::shadow_matrix(plane<double>{0, 2, 0, 0}, hpoint<double, 3>{1, 2, 3, 0}) ==
             irg::parallel_projection_onto(plane<double>{0, 2, 0, 0}, vec<double, 3>{-1, -2, -3}));
  CHECK_BOTH(irg::central_projection_onto(plane<double>{0, 2, 0, 0}, D{0, 4, 0}) ==
             irg::projection_onto_plane(plane<double>{0, 2, 0, 0}, hpoint<double, 3>{0, 4, 0, 1}));
}

TEST_CASE("plane_projection: singular and hostile cases, each one classified") {
  const auto status = [](const plane<double>& o, const hpoint<double, 3>& eye) {
    const auto m = projection_onto_plane_checked(o, eye);
    CHECK((m.status == ok || m.value == irg::identity_matrix<double, 4>()));
    return m.status;
  };
  constexpr plane<double> z0{0, 0, 1, 0};
  static_assert(projection_onto_plane_checked(z0, hpoint<double, 3>{1, 2, 0, 1}).status == eye_in_plane);
  static_assert(projection_onto_plane_checked(z0, hpoint<double, 3>{1, 2, 0, 0}).status == direction_parallel);
  static_assert(projection_onto_plane_checked(z0, hpoint<double, 3>{0, 0, 0, 0}).status == no_eye);
  static_assert(projection_onto_plane_checked(plane<double>{0, 0, 0, 1}, hpoint<double, 3>{1, 2, 3, 1}).status ==
                no_plane);
  static_assert(projection_onto_plane_checked(z0, hpoint<double, 3>{not_a_number, 2, 3, 1}).status == not_finite);
  for (const double bad : {not_a_number, inf, -inf})
    for (int k = 0; k < 4; ++k) {
      hpoint<double, 3> eye{1, 2, 3, 1};
      eye[k] = bad;
      CHECK(status(z0, eye) == not_finite);
      plane<double> o{1, 2, 3, 4};
      (k == 0 ? o.a : k == 1 ? o.b : k == 2 ? o.c : o.d) = bad;
      CHECK(status(o, {1, 2, 3, 1}) == not_finite);
    }
  CHECK(status({3, 1, 0, -6}, {2, 0, 5, 1}) == eye_in_plane);
  CHECK(status({3, 1, 0, -6}, {1, -3, 5, 0}) == direction_parallel);
  CHECK(status(z0, {1e160, 0, 1e-150, 1}) == not_representable);
  CHECK(status({0, 1, 1e-200, 0}, {0, 0, 1e-200, 1}) == not_representable);  // not in the plane
  CHECK(status(z0, {1, 1, 1e-300, 1}) == ok);
  CHECK(status({0, 0, 1e-320, 0}, {1, 1, 1, 1}) == ok);
  CHECK(status({0, 0, 1e308, 1e308}, {1, 1, 1e308, 1}) == ok);
  using F = point<float, 3>;
  CHECK(central_projection_onto_checked(plane<float>{0, 0, 1, 0}, F{1e38f, 0, 1e-10f}).status == not_representable);
  static_assert(central_projection_onto_checked(plane<float>{0, 0, 1, 0}, F{1e38f, 0, 1e-10f}).status ==
                not_representable);
  CHECK(central_projection_onto_checked(plane<float>{0, 0, 1e-45f, 0}, F{1, 0, 1}).status == ok);
}
