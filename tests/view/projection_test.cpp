// SPDX-License-Identifier: MIT
#include <irg/view/projection.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "support/check_both.hpp"
#include "support/random.hpp"

using irg::depth_range;
using irg::hpoint;
using irg::identity_matrix;
using irg::mat;
using irg::orthographic;
using irg::orthographic_checked;
using irg::perspective;
using irg::perspective_checked;
using irg::pi;
using irg::point;
using irg::projection_status;

namespace {

using P = point<double, 3>;
constexpr double inf = std::numeric_limits<double>::infinity();
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

template <class T>
constexpr point<T, 3> projected(const mat<T, 4, 4>& m, const point<T, 3>& p) {
  return to_cartesian(m * p);
}

bool near(const P& a, const P& b, double bound) {
  return std::abs(a.x - b.x) <= bound && std::abs(a.y - b.y) <= bound && std::abs(a.z - b.z) <= bound;
}

struct depth_order {
  int compared = 0, inverted = 0, tied = 0;
};

// Pairs of distances in front of the eye, log-uniform in [0.1, 10^5], whose true depths are at least 8 ulp of the
// stored float apart: how often does the stored order differ?
depth_order sort_pairs(const mat<float, 4, 4>& m, depth_range range, double far) {
  depth_order found;
  test::random r(7);
  const int trials = std::getenv("IRG_RELEASE_TIER") ? 1'000'000 : 100'000;
  const double n = static_cast<double>(0.1f);
  while (found.compared < trials) {
    const double exponent = -1 + 6 * r.unit(), apart = std::pow(10.0, -8 + 6 * r.unit());
    const float d1 = static_cast<float>(std::pow(10.0, exponent));
    const float d2 = static_cast<float>(static_cast<double>(d1) * (1 + apart));
    if (!(d1 < d2) || !(static_cast<double>(d2) < 1e5) || d1 < 0.1f) continue;
    const auto truth = [&](float d) {
      const double x = static_cast<double>(d);
      if (range == depth_range::reversed) return std::isinf(far) ? n / x : n * (far - x) / (x * (far - n));
      return far * (x - n) / (x * (far - n));
    };
    const auto stored = [&](float d) {
      const hpoint<float, 3> clip = m * point<float, 3>{d / 3, -d / 5, -d};
      return clip.z / clip.w;
    };
    const float s1 = stored(d1), s2 = stored(d2);
    const double ulp = static_cast<double>(std::nextafter(std::max(s1, s2), 2.0f) - std::max(s1, s2));
    if (std::abs(truth(d1) - truth(d2)) < 8 * ulp) continue;
    ++found.compared;
    const bool right = range == depth_range::reversed ? s1 > s2 : s1 < s2;
    found.tied += s1 == s2 ? 1 : 0;
    found.inverted += !right && s1 != s2 ? 1 : 0;
  }
  return found;
}

}  // namespace

TEST_CASE("perspective: by hand, in every life") {
  // A right angle, twice as wide as high, from 1 to 5.
  constexpr auto m = perspective(pi<double> / 2, 2, 1, 5);
  CHECK_BOTH(m(3, 2) == -1);
  CHECK_BOTH((m(2, 2) == 0.25 && m(2, 3) == 1.25));
  CHECK_BOTH((m * P{0, 0, -1}) == hpoint<double, 3>{0, 0, 1, 1});  // nearest: z = w
  CHECK_BOTH((m * P{0, 0, -5}) == hpoint<double, 3>{0, 0, 0, 5});  // farthest: z = 0
  CHECK_BOTH((m * P{0, 0, 0}).w == 0.0);                           // the eye
  CHECK(
      (near(projected(m, P{2, 1, -1}), P{1, 1, 1}, 1e-15) && near(projected(m, P{-10, -5, -5}), P{-1, -1, 0}, 1e-15)));
  constexpr auto standard = perspective(pi<double> / 2, 2, 1, 5, depth_range::standard);
  CHECK_BOTH((standard * P{0, 0, -1}) == hpoint<double, 3>{0, 0, 0, 1});
  CHECK_BOTH((standard * P{0, 0, -5}) == hpoint<double, 3>{0, 0, 5, 5});
  constexpr auto endless = perspective(pi<double> / 2, 2, 1, inf);
  CHECK_BOTH((endless * P{0, 0, -4}) == hpoint<double, 3>{0, 0, 1, 4});
  CHECK_BOTH((perspective(pi<double> / 2, 2, 1, inf, depth_range::standard) * P{0, 0, -4}) ==
             hpoint<double, 3>{0, 0, 3, 4});

  constexpr auto any = perspective(0.7f, 1.5f, 0.1f, 100.0f);
  volatile float angle = 0.7f;
  CHECK(perspective<float>(angle, 1.5f, 0.1f, 100.0f) == any);
  static_assert(perspective_checked(-1.0, 1, 1, 2).status == projection_status::bad_angle);
  static_assert(perspective_checked(not_a_number, 1, 1, 2).status == projection_status::bad_angle);
}

TEST_CASE("orthographic: by hand, in every life") {
  constexpr auto m = orthographic(irg::view_window<double>{-4, 4, -3, 3}, 1, 5);
  CHECK_BOTH(projected(m, P{-4, -3, -1}) == P{-1, -1, 1});
  CHECK_BOTH(projected(m, P{4, 3, -5}) == P{1, 1, 0});
  CHECK_BOTH(projected(m, P{0, 0, -3}) == P{0, 0, 0.5});
  CHECK_BOTH(projected(orthographic(irg::view_window<double>{-4, 4, -3, 3}, 1, 5, depth_range::standard),
                       P{4, 3, -5}) == P{1, 1, 1});
  CHECK_BOTH(projected(orthographic(irg::view_window<double>{0, 2, 1, 5}, -1, 1), P{0, 5, 1}) ==
             P{-1, 1, 1});       // off centre, from behind the eye
  CHECK_BOTH(projected(orthographic(irg::view_window<double>{2, 0, 1, 5}, -1, 1), P{0, 5, 1}) ==
             P{1, 1, 1});        // mirrored
  constexpr auto any = orthographic(irg::view_window<float>{0.1f, 1.5f, -0.3f, 0.9f}, 0.1f, 100.0f);
  volatile float left = 0.1f;
  CHECK(orthographic(irg::view_window<float>{left, 1.5f, -0.3f, 0.9f}, 0.1f, 100.0f) == any);
}

TEST_CASE("perspective of a window: by hand, off centre, mirrored, in every life") {
  using irg::view_window;
  constexpr auto m = perspective(view_window<double>{-1, 3, 0, 2}, 2, 1, 5);
  CHECK_BOTH((m * P{-1, 0, -2}) == hpoint<double, 3>{-2, -2, 0.75, 2});
  CHECK_BOTH((m * P{3, 2, -2}) == hpoint<double, 3>{2, 2, 0.75, 2});
  CHECK_BOTH((m * P{1, 1, -2}) == hpoint<double, 3>{0, 0, 0.75, 2});
  CHECK_BOTH((m * P{-0.5, 0, -1}) == hpoint<double, 3>{-1, -1, 1, 1});
  CHECK_BOTH((perspective(view_window<double>{3, -1, 0, 2}, 2, 1, 5) * P{3, 2, -2}) ==
             hpoint<double, 3>{-2, 2, 0.75, 2});
  // Centred, it is the projection by angle.
  CHECK_BOTH((perspective(irg::centred_window(4.0, 2), 1, 1, inf) * P{0, 0, -4}) == hpoint<double, 3>{0, 0, 1, 4});
  CHECK((perspective(irg::centred_window(4.0, 2), 1, 1, 5)(0, 0) == 0.5));
  // glFrustum's window: on the near plane.
  constexpr auto gl = perspective(view_window<double>{-2, 1, -1, 3}, 0.5, 0.5, 10, depth_range::standard);
  CHECK((near(projected(gl, P{-2, -1, -0.5}), P{-1, -1, 0}, 1e-15) &&
         near(projected(gl, P{20, 60, -10}), P{1, 1, 1}, 1e-15)));
  constexpr auto any = perspective(view_window<float>{-0.1f, 0.3f, -0.2f, 0.9f}, 0.7f, 0.1f, 100.0f);
  volatile float left = -0.1f;
  CHECK(perspective(view_window<float>{left, 0.3f, -0.2f, 0.9f}, 0.7f, 0.1f, 100.0f) == any);
}

TEST_CASE("perspective of a window: similar triangles, and two tiles join to the whole") {
  test::random r(21);
  for (int i = 0; i < 2000; ++i) {
    const double l = -2 * r.unit(), w = 0.1 + 2 * r.unit(), b = -2 * r.unit(), h = 0.1 + 2 * r.unit(),
                 d = 0.1 + r.unit();
    const auto m = perspective(irg::view_window<double>{l, l + w, b, b + h}, d, 0.1, 100);
    const P p{4 * r.unit() - 2, 4 * r.unit() - 2, -0.1 - 20 * r.unit()};
    // Where the ray meets the plane of the window, in shares of the window.
    const long double t = static_cast<long double>(d) / static_cast<long double>(-p.z);
    const auto share = [&](double x, double low, double size) {
      return static_cast<double>(
          2 * (static_cast<long double>(x) * t - static_cast<long double>(low)) / static_cast<long double>(size) - 1);
    };
    const P q = projected(m, p);
    const double bound =
        1e-14 * (1 + std::abs(q.x) + std::abs(q.y)) * (1 + (std::abs(l) + w) / w + (std::abs(b) + h) / h);
    CHECK(std::abs(q.x - share(p.x, l, w)) <= bound);
    CHECK(std::abs(q.y - share(p.y, b, h)) <= bound);
    // The left half of the window shows the left half of the picture, twice as wide.
    const P half = projected(perspective(irg::view_window<double>{l, l + w / 2, b, b + h}, d, 0.1, 100), p);
    CHECK(std::abs(half.x - (2 * q.x + 1)) <= 4 * bound);
    CHECK((half.y == q.y && half.z == q.z));
  }
}

TEST_CASE("perspective of a window: what is refused") {
  using enum projection_status;
  const auto status = [](irg::view_window<double> w, double d, double n, double f) {
    const auto p = perspective_checked(w, d, n, f);
    CHECK((p.status == ok || p.value == identity_matrix<double, 4>()));
    return p.status;
  };
  constexpr irg::view_window<double> w{-1, 1, -1, 1};
  for (const double bad : {0.0, -1.0, inf, -inf, not_a_number}) CHECK(status(w, bad, 1, 2) == bad_distance);
  for (const double bad : {inf, -inf, not_a_number, 1.0}) {
    CHECK(status({bad, 1, -1, 1}, 1, 1, 2) == bad_window);
    CHECK(status({-1, 1, bad, 1}, 1, 1, 2) == bad_window);
  }
  for (const double bad : {0.0, -1.0, 2.0, 3.0, inf, not_a_number}) CHECK(status(w, 1, bad, 2) == bad_depth);
  CHECK(status(w, 1, 1, not_a_number) == bad_depth);
  CHECK(status(w, 1, 1, inf) == ok);
  CHECK(status(w, 1, 1e-3, 1e9) == ok);
  CHECK(status({-1e307, 1e307, -1, 1}, 1, 1, 2) == ok);
  CHECK(status({-1e-320, 1e-320, -1, 1}, 1, 1, 2) == not_representable);
  static_assert(perspective_checked(w, -1, 1, 2).status == bad_distance);
}

TEST_CASE("perspective: Hank's values, central projection") {
  // Camera point (3,-2,6) on the plane d = 2 of a left-handed camera: (1, -2/3). Here z = -6 and the half height is 2.
  const auto m = perspective(pi<double> / 2, 1, 1, 10);
  const P p = projected(m, P{3, -2, -6});
  CHECK((std::abs(2 * p.x - 1) <= 1e-15 && std::abs(2 * p.y + 2.0 / 3) <= 1e-15));
  const P q = projected(m, P{3, -2, -3});
  CHECK((std::abs(2 * q.x - 2) <= 1e-15 && std::abs(2 * q.y + 4.0 / 3) <= 1e-15));
  // The frustum m1 = 8, m2 = 6, d = 2, n = 1, h = 10: near corner (2, 3/2, 1), far corner (20, 15, 10).
  const auto f = perspective(2 * std::atan(1.5), 4.0 / 3, 1, 10);
  CHECK(near(projected(f, P{2, 1.5, -1}), P{1, 1, 1}, 1e-15));
  CHECK(near(projected(f, P{-20, 15, -10}), P{-1, 1, 0}, 1e-15));
}

TEST_CASE("projections: the eight corners of the view volume become those of the clip volume") {
  test::random r(1);
  for (int i = 0; i < 2000; ++i) {
    const double angle = 0.05 + 3 * r.unit(), aspect = 0.1 + 5 * r.unit(), n = 0.01 + r.unit(),
                 f = n * (1.5 + 1000 * r.unit());
    const double left = -r.unit(), right = r.unit() + 0.1, bottom = -r.unit(), top = r.unit() + 0.1;
    const depth_range depth = r.integer(0, 1) ? depth_range::reversed : depth_range::standard;
    const auto m = perspective(angle, aspect, n, f, depth);
    const auto o = orthographic(irg::view_window<double>{left, right, bottom, top}, n, f, depth);
    for (int corner = 0; corner < 8; ++corner) {
      const double sx = corner & 1 ? 1 : -1, sy = corner & 2 ? 1 : -1, d = corner & 4 ? f : n;
      const double z = ((corner & 4) != 0) == (depth == depth_range::standard) ? 1 : 0;
      const double half = d * std::tan(angle / 2);
      CHECK(near(projected(m, P{sx * half * aspect, sy * half, -d}), P{sx, sy, z}, 1e-14));
      CHECK(near(projected(o, P{sx < 0 ? left : right, sy < 0 ? bottom : top, -d}), P{sx, sy, z}, 4e-15));
    }
  }
}

TEST_CASE("perspective: reversed float depth never inverts an order that the float can hold (row 20)") {
  const auto reversed = sort_pairs(perspective(1.0f, 1.5f, 0.1f, 1e5f), depth_range::reversed, 1e5);
  CHECK(reversed.inverted == 0);
  CHECK(reversed.tied == 0);
  const auto endless =
      sort_pairs(perspective(1.0f, 1.5f, 0.1f, std::numeric_limits<float>::infinity()), depth_range::reversed, inf);
  CHECK(endless.inverted == 0);
  CHECK(endless.tied == 0);
}

TEST_CASE("perspective: depth falls with the distance, float by float, up to and beyond the far plane") {
  const auto m = perspective(1.0f, 1.5f, 0.1f, 1e5f);
  const auto depth = [&](float d) {
    const hpoint<float, 3> p = m * point<float, 3>{0, 0, -d};
    return p.z / p.w;
  };
  test::random r(2);
  for (int i = 0; i < 20000; ++i) {
    float d = static_cast<float>(std::pow(10.0, -1 + 6.05 * r.unit()));
    for (int k = 0; k < 8; ++k) {
      const float next = std::nextafter(d, 1e9f);
      CHECK(depth(next) <= depth(d));
      d = next;
    }
  }
  CHECK(depth(0.1f) == doctest::Approx(1).epsilon(1e-6));
  CHECK(depth(1e5f) == doctest::Approx(0));
}

TEST_CASE("projections: what is refused, and extreme ranges") {
  using enum projection_status;
  const auto status = [](double angle, double aspect, double n, double f) {
    const auto p = perspective_checked(angle, aspect, n, f);
    CHECK((p.status == ok || p.value == identity_matrix<double, 4>()));
    return p.status;
  };
  for (const double angle : {0.0, -0.0, -1.0, pi<double>, 4.0, inf, -inf, not_a_number})
    CHECK(status(angle, 1, 1, 2) == bad_angle);
  for (const double aspect : {0.0, -1.0, inf, not_a_number}) CHECK(status(1, aspect, 1, 2) == bad_aspect);
  CHECK(status(1, 1, 0, 2) == bad_depth);
  CHECK(status(1, 1, -1, 2) == bad_depth);
  CHECK(status(1, 1, 2, 2) == bad_depth);
  CHECK(status(1, 1, 3, 2) == bad_depth);
  CHECK(status(1, 1, not_a_number, 2) == bad_depth);
  CHECK(status(1, 1, 1, not_a_number) == bad_depth);
  CHECK(status(1, 1, inf, inf) == bad_depth);
  CHECK(status(1e-320, 1, 1, 2) == not_representable);
  CHECK(status(1, 1e-320, 1, 2) == not_representable);
  CHECK(status(1, 1, 0x1.ffffffffffffep1023, 0x1.fffffffffffffp1023) == not_representable);
  CHECK(status(std::nextafter(pi<double>, 0.0), 1, 1, 2) == ok);
  CHECK(status(1e-300, 1, 1, 2) == ok);
  CHECK(status(1, 1, 1e-3, 1e9) == ok);
  CHECK(status(1, 1, 1e-320, 1e308) == ok);
  CHECK(status(1, 1, 1, std::nextafter(1.0, 2.0)) == ok);
  // Windows of a few subnormal numbers, and entries next to the largest number.
  constexpr double d = std::numeric_limits<double>::denorm_min();
  const auto fine = irg::perspective_checked(irg::view_window<double>{0, 3 * d, -d, 4 * d}, 3 * d, 1, 2);
  CHECK((fine.status == ok && fine.value(0, 0) == 2 && fine.value(0, 2) == 1));
  CHECK((fine.value(1, 1) == 6.0 / 5 && fine.value(1, 2) == 3.0 / 5));
  CHECK(irg::perspective_checked(irg::view_window<double>{-1e-308, 1e-308, -1, 1}, 1, 1, 2).value(0, 0) == 1e308);
  CHECK(irg::perspective_checked(irg::view_window<double>{-1e-308, 1e-308, -1, 1}, 2, 1, 2).status ==
        not_representable);
  // near 1e-3, far 1e9: both ends where they belong.
  const auto m = perspective(1.0, 1.0, 1e-3, 1e9);
  CHECK(near(projected(m, P{0, 0, -1e-3}), P{0, 0, 1}, 1e-15));
  CHECK(near(projected(m, P{0, 0, -1e9}), P{0, 0, 0}, 1e-15));

  const auto box = [](double l, double r, double b, double t, double n, double f) {
    const auto p = orthographic_checked(irg::view_window<double>{l, r, b, t}, n, f);
    CHECK((p.status == ok || p.value == identity_matrix<double, 4>()));
    return p.status;
  };
  CHECK(box(1, 1, 0, 1, 0, 1) == bad_window);
  CHECK(box(0, 1, 2, 2, 0, 1) == bad_window);
  CHECK(box(not_a_number, 1, 0, 1, 0, 1) == bad_window);
  CHECK(box(0, inf, 0, 1, 0, 1) == bad_window);
  CHECK(box(0, 1, 0, 1, 1, 1) == bad_depth);
  CHECK(box(0, 1, 0, 1, 2, 1) == bad_depth);
  CHECK(box(0, 1, 0, 1, 2, inf) == bad_depth);
  CHECK(box(0, 1, 0, 1, not_a_number, 1) == bad_depth);
  CHECK(box(0, 1e-320, 0, 1, 0, 1) == not_representable);
  CHECK(box(-1e307, 1e307, -1, 1, -1, 1) == ok);
  // Half of the largest number is the last that is taken, on either side.
  constexpr double most = std::numeric_limits<double>::max() / 2, beyond = 0x1p1023;
  static_assert(most < beyond);
  CHECK(box(-most, 1, -1, 1, -1, 1) == box(-1, most, -1, 1, -1, 1));
  CHECK(box(-most, 1, -1, 1, -1, 1) != bad_window);
  CHECK(box(-beyond, 1, -1, 1, -1, 1) == bad_window);
  CHECK(box(-1, beyond, -1, 1, -1, 1) == bad_window);
}

TEST_CASE("checked_projection: the matrix, or the identity where an entry overflowed") {
  CHECK_BOTH(irg::checked_projection(identity_matrix<double, 4>()).ok());
  constexpr auto with = [](double entry) {
    auto m = identity_matrix<double, 4>();
    m(2, 3) = entry;
    return irg::checked_projection(m);
  };
  CHECK_BOTH(with(-1e300).value(2, 3) == -1e300);
  CHECK_BOTH(with(inf).status == projection_status::not_representable);
  CHECK_BOTH(with(not_a_number).value == identity_matrix<double, 4>());
}
