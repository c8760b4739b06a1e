// SPDX-License-Identifier: MIT
#include <irg/curve/curve_frame.hpp>

#include <cmath>
#include <limits>

#include "support/check_both.hpp"
#include "support/random.hpp"

using namespace irg;

namespace {

using frame_vector = vec<double, 3>;

/// The helix (a cos t, a sin t, b t) and its derivatives by the cosine's: each a quarter turn further.
frame_vector helix(double a, double b, double t, int derivative) {
  const double turn = t + derivative * 1.5707963267948966;
  return {a * std::cos(turn), a * std::sin(turn), derivative == 0 ? b * t : derivative == 1 ? b : 0};
}

bool is_orthonormal(const curve_frame<frame_vector>& f) {
  const double u = 0x1p-53;
  return std::abs(dot(f.tangent, f.normal)) <= 6 * u && std::abs(dot(f.normal, f.binormal)) <= 6 * u &&
         std::abs(dot(f.tangent, f.binormal)) <= 6 * u && std::abs(length(f.normal) - 1) <= 3 * u &&
         std::abs(length(f.binormal) - 1) <= 3 * u && length(cross(f.tangent, f.normal) - f.binormal) <= 6 * u;
}

/// How far the frame carried along 1.5 turns of the helix in n steps is off: against Frenet's, it turns back by
/// torsion times length.
double twist_error(double a, double b, int n) {
  const double radius = std::sqrt(a * a + b * b), end = 9.42477796076938;
  curve_frame<frame_vector> f = *frenet_frame(helix(a, b, 0, 1), helix(a, b, 0, 2));
  for (int k = 1; k <= n; ++k) {
    const double t = end * k / n, before = end * (k - 1) / n;
    f = rotation_minimizing_frame(f, helix(a, b, t, 0) - helix(a, b, before, 0), helix(a, b, t, 1));
    CHECK(is_orthonormal(f));
  }
  const auto frenet = *frenet_frame(helix(a, b, end, 1), helix(a, b, end, 2));
  const double turn = std::atan2(dot(f.normal, frenet.binormal), dot(f.normal, frenet.normal));
  return std::abs(std::remainder(turn + b / radius * end, 6.283185307179586));
}

}  // namespace

TEST_CASE("curve frame: curvature and torsion of circles and helices") {
  CHECK_BOTH(curvature(vec<double, 2>{0, 2}, vec<double, 2>{-4, 7}) == 1.0);  // turns left
  CHECK_BOTH(curvature(vec<double, 2>{0, 2}, vec<double, 2>{4, 0}) == -1.0);  // turns right
  CHECK_BOTH(curvature(frame_vector{0, 0, 5}, frame_vector{3, 4, 1}) == 0.2);
  CHECK_BOTH(curvature(frame_vector{0, 0, 5}, frame_vector{0, 0, 1}) == 0.0);
  test::random r(71);
  for (int k = 0; k < 200; ++k) {
    const double a = 0.1 + r.unit(), b = 2 * r.unit() - 1, t = 10 * r.unit(), square = a * a + b * b;
    const auto first = helix(a, b, t, 1), second = helix(a, b, t, 2), third = helix(a, b, t, 3);
    CHECK(*curvature(first, second) == doctest::Approx(a / square).epsilon(1e-13));
    CHECK(*torsion(first, second, third) == doctest::Approx(b / square).epsilon(1e-12));
    const auto f = *frenet_frame(first, second);
    CHECK(is_orthonormal(f));
    CHECK(length(f.normal - frame_vector{-std::cos(t), -std::sin(t), 0}) <= 1e-14);
  }
}

TEST_CASE("curve frame: turns as little as possible, with the fourth power of the step") {
  const double coarse = twist_error(1, 0.4, 60), fine = twist_error(1, 0.4, 120);
  CHECK(coarse <= 1e-4);
  CHECK(coarse / fine == doctest::Approx(16).epsilon(0.1));
  // In a plane the binormal stays, over inflections too.
  curve_frame<frame_vector> f = *frame_with_up(frame_vector{1, 1, 0}, frame_vector{0, 0, 1});
  for (int k = 1; k <= 50; ++k) {
    const double t = k * 0.2;
    f = rotation_minimizing_frame(f, {0.2, std::sin(t) - std::sin(t - 0.2), 0}, {1, std::cos(t), 0});
    CHECK(length(f.normal - frame_vector{0, 0, 1}) <= 1e-14);
  }
}

TEST_CASE("curve frame: degenerate and hostile input") {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  const curve_frame<frame_vector> start{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  CHECK_BOTH(!frenet_frame(frame_vector{1, 2, 3}, frame_vector{2, 4, 6}));
  CHECK_BOTH(!frenet_frame(frame_vector{}, frame_vector{2, 4, 6}));
  CHECK_BOTH(!frenet_frame(frame_vector{1, 0, 0}, frame_vector{}));
  CHECK(!curvature(frame_vector{}, frame_vector{1, 0, 0}));
  CHECK(!curvature(vec<double, 2>{}, vec<double, 2>{1, 0}));
  CHECK(!curvature(vec<double, 2>{infinite, 0}, vec<double, 2>{1, 0}));
  CHECK(!torsion(frame_vector{1, 0, 0}, frame_vector{2, 0, 0}, frame_vector{0, 1, 0}));
  CHECK(!frame_with_up(frame_vector{}, frame_vector{0, 1, 0}));
  for (const frame_vector& up : {frame_vector{0, 3, 0}, frame_vector{}, frame_vector{infinite, 0, 0}})
    CHECK(is_orthonormal(*frame_with_up(frame_vector{0, 2, 0}, up)));
  CHECK(rotation_minimizing_frame(start, {1, 0, 0}, frame_vector{}) == start);
  CHECK(rotation_minimizing_frame(start, {1, 0, 0}, {1, 0, 0}) == start);
  CHECK(rotation_minimizing_frame(start, frame_vector{}, {1, 0, 0}) == start);
  CHECK(rotation_minimizing_frame(start, frame_vector{}, {0, 1, 0}).tangent == frame_vector{0, 1, 0});
  CHECK(rotation_minimizing_frame(start, frame_vector{}, {0, 1, 0}).binormal == frame_vector{0, 0, 1});
  CHECK(is_orthonormal(rotation_minimizing_frame(start, frame_vector{}, {-1, 0, 0})));
  CHECK(is_orthonormal(rotation_minimizing_frame(start, {1e300, 1e300, 0}, {1e-300, 0, 1e-300})));
}

TEST_CASE("curve frame: parallel derivatives are told from nearly parallel ones") {
  CHECK_BOTH(!frenet_frame(frame_vector{1, 2, 3}, frame_vector{3, 6, 9}));
  CHECK_BOTH(!torsion(frame_vector{1, 2, 3}, frame_vector{3, 6, 9}, frame_vector{1, 0, 0}));
  for (int i = 1; i < 40; ++i)
    for (const double size : {1.0, 0x1p-1000, 0x1p1000}) {
      const double k = i, scaled = i * size;
      CHECK(!frenet_frame(frame_vector{size, 2 * size, 3 * size} * k, frame_vector{-7, -14, -21}));
      // Where `up` is no help, the axis that is farthest from the tangent takes its place.
      const frame_vector tangent{k, 2 * k, 3 * k};
      CHECK(*frame_with_up(tangent, frame_vector{5 * scaled, 10 * scaled, 15 * scaled}) ==
            *frame_with_up(tangent, frame_vector{}));
    }
  const double next = std::nextafter(9.0, 10.0);
  CHECK(is_orthonormal(*frenet_frame(frame_vector{1, 2, 3}, frame_vector{3, 6, next})));
  CHECK_BOTH(!frenet_frame(vec<float, 3>{1, 2, 3}, vec<float, 3>{5, 10, 15}));
}

TEST_CASE("curve frame: torsion of derivatives of any size") {
  const auto of = [](double a, double b, double c) {
    return torsion(frame_vector{a, 0, 0}, frame_vector{0, b, 0}, frame_vector{1, 1, c});
  };
  CHECK(*of(0x1p700, 0x1p600, 0x1p1000) == 0x1p-300);
  CHECK(*of(0x1p-700, 0x1p-600, 0x1p-400) == 0x1p900);
  CHECK(*of(0x1p-1074, 0x1p1000, 0x1p-74) == 1);
  CHECK(*of(0x1p-1000, 0x1p-1000, 0x1p-900) == std::numeric_limits<double>::infinity());
  CHECK(*of(1, 1, 0) == 0);
  CHECK(*torsion(frame_vector{1, 0, 0}, frame_vector{0, 1, 0}, frame_vector{}) == 0);
  CHECK(*torsion(vec<float, 3>{0x1p100f, 0, 0}, vec<float, 3>{0, 0x1p100f, 0}, vec<float, 3>{0, 0, 0x1p120f}) ==
        0x1p-80f);
  CHECK(!torsion(frame_vector{1, 0, 0}, frame_vector{0, 1, 0}, frame_vector{0, 0, std::nan("")}));
}
