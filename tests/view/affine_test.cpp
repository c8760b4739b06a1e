// SPDX-License-Identifier: MIT
#include <irg/view/affine.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <irg/math/inverse.hpp>

#include "support/check_both.hpp"
#include "support/random.hpp"
#include "support/rational.hpp"

using irg::hpoint;
using irg::identity_matrix;
using irg::map_orientation;
using irg::mat;
using irg::mesh;
using irg::normal_matrix;
using irg::orientation_of;
using irg::point;
using irg::rotation;
using irg::rotation_x;
using irg::rotation_y;
using irg::rotation_z;
using irg::scaling;
using irg::transform_normal;
using irg::transformed;
using irg::translation;
using irg::vec;
using test::rational;

namespace {

using D = mat<double, 4, 4>;
using V = vec<double, 3>;
using P = point<double, 3>;

template <class A, class B>
constexpr double distance(const A& a, const B& b) {
  double worst = 0;
  for (int i = 0; i < irg::size_of<A>; ++i) {
    const double d = static_cast<double>(a[i]) - static_cast<double>(b[i]);
    if (d > worst) worst = d;
    if (-d > worst) worst = -d;
  }
  return worst;
}

template <class T, int N>
constexpr double distance(const mat<T, N, N>& a, const mat<T, N, N>& b) {
  double worst = 0;
  for (int r = 0; r < N; ++r)
    for (int c = 0; c < N; ++c) {
      const double d = static_cast<double>(a(r, c)) - static_cast<double>(b(r, c));
      if (d > worst) worst = d;
      if (-d > worst) worst = -d;
    }
  return worst;
}

V random_vector(test::random& r) {
  V v;
  for (int i = 0; i < 3; ++i) v[i] = 4 * r.unit() - 2;
  return v;
}

D random_rotation(test::random& r) {
  const V axis = random_vector(r);
  return rotation(axis, 6 * r.unit());
}

constexpr double degree = 3.14159265358979323846 / 180;

// A tetrahedron with outward faces and one normal per face.
mesh<double> tetrahedron() {
  mesh<double> m;
  m.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (const std::array<int, 3>& f :
       {std::array{0, 2, 1}, std::array{0, 1, 3}, std::array{0, 3, 2}, std::array{1, 2, 3}})
    add_face(m, f);
  const double third = 1 / std::sqrt(3.0);
  m.normals = {{0, 0, -1}, {0, -1, 0}, {-1, 0, 0}, {third, third, third}};
  for (std::size_t i = 0; i < m.corners.size(); ++i) m.corners[i].normal = static_cast<std::uint32_t>(i / 3);
  return m;
}

// Six times the volume, positive when the faces are counter-clockwise from outside.
double six_volumes(const mesh<double>& m) {
  double sum = 0;
  for (std::size_t f = 0; f < m.face_count(); ++f)
    for (std::size_t k = 2; k < m.face_size(f); ++k) {
      const V a = to_vec(m.positions[m.corner(f, 0).position]), b = to_vec(m.positions[m.corner(f, k - 1).position]),
              c = to_vec(m.positions[m.corner(f, k).position]);
      sum += dot(a, cross(b, c));
    }
  return sum;
}

}  // namespace

TEST_CASE("affine: by hand") {
  CHECK_BOTH(translation(V{1, 2, 3}) * P{4, 5, 6} == hpoint<double, 3>{5, 7, 9, 1});
  CHECK_BOTH(transform_vector(translation(V{1, 2, 3}), V{4, 5, 6}) == V{4, 5, 6});
  CHECK_BOTH(transform_point(scaling(2.0), P{4, 5, 6}) == P{8, 10, 12});
  CHECK_BOTH(rotation_x(0.0) == identity_matrix<double, 4>());
  CHECK_BOTH(linear_part(translation(V{1, 2, 3})) == identity_matrix<double, 3>());
  static_assert(std::same_as<decltype(rotation_z(1.0f)), mat<float, 4, 4>>);
  static_assert(std::same_as<decltype(translation(std::array<float, 3>{})), mat<float, 4, 4>>);

  constexpr D at_compile_time = rotation(V{1, 2, 3}, 0.7);
  volatile double angle = 0.7, one = 1;
  CHECK(rotation(V{one, 2 * one, 3 * one}, angle) == at_compile_time);
  constexpr auto normals = normal_matrix(at_compile_time);
  CHECK(normal_matrix(at_compile_time * one) == normals);
}

TEST_CASE("affine: Hank's values") {
  // Hank n.d., 2.6: P(20,0,10), translate by -20 along x, rotate by 20 degrees about z.
  constexpr D T = translation(V{-20, 0, 0}), R = rotation_z(20 * degree);
  CHECK_BOTH(distance(transform_point(R * T, P{20, 0, 10}), P{0, 0, 10}) <= 1e-14);
  CHECK_BOTH(distance(transform_point(T * R, P{20, 0, 10}), P{-1.2061475842818323, 6.8404028665133747, 10}) <= 1e-14);
  CHECK_BOTH(distance(R * T, D{{{0.939692620786, -0.342020143326, 0, -18.7938524157},
                                {0.342020143326, 0.939692620786, 0, -6.84040286651},
                                {0, 0, 1, 0},
                                {0, 0, 0, 1}}}) <= 6e-11);
  CHECK_BOTH(distance(T * R, D{{{0.939692620786, -0.342020143326, 0, -20},
                                {0.342020143326, 0.939692620786, 0, 0},
                                {0, 0, 1, 0},
                                {0, 0, 0, 1}}}) <= 6e-13);
  // Quarter turns, right-handed.
  CHECK_BOTH(distance(transform_point(rotation_x(90 * degree), P{0, 1, 0}), P{0, 0, 1}) <= 1e-16);
  CHECK_BOTH(distance(transform_point(rotation_y(90 * degree), P{0, 0, 1}), P{1, 0, 0}) <= 1e-16);
  CHECK_BOTH(distance(transform_point(rotation_z(90 * degree), P{1, 0, 0}), P{0, 1, 0}) <= 1e-16);
  CHECK_BOTH(transform_point(scaling(V{2, 3, -1}), P{1, 2, 3}) == P{2, 6, -3});
  CHECK_BOTH(to_cartesian(hpoint<double, 3>{4, 6, 2, 2}) == P{2, 3, 1});
  CHECK_BOTH(distance(transform_point(translation(V{0, 0, 5}) * rotation_z(90 * degree) * scaling(2.0), P{1, 0, 0}),
                      P{0, 2, 5}) <= 2e-16);
}

TEST_CASE("affine: rotations are orthonormal and agree with each other") {
  test::random r(1);
  double worst = 0, worst_entry = 0, worst_float = 0, worst_axis = 0, worst_turn = 0;
  for (int i = 0; i < 5000; ++i) {
    const V axis = random_vector(r);
    const double angle = 20 * r.unit() - 10;
    const D m = rotation(axis, angle);
    const auto a = linear_part(m);
    // Rodrigues' formula in a wider type.
    using wide = long double;
    const wide length = std::hypot(static_cast<wide>(axis.x), static_cast<wide>(axis.y), static_cast<wide>(axis.z));
    const wide n[3] = {static_cast<wide>(axis.x) / length, static_cast<wide>(axis.y) / length,
                       static_cast<wide>(axis.z) / length};
    const wide c = std::cos(static_cast<wide>(angle)), s = std::sin(static_cast<wide>(angle));
    for (int y = 0; y < 3; ++y)
      for (int x = 0; x < 3; ++x) {
        const wide turn = x == y ? c : (x == (y + 1) % 3 ? -s : s) * n[3 - x - y];
        worst_entry = std::max(
            worst_entry, static_cast<double>(std::abs(turn + (1 - c) * n[x] * n[y] - static_cast<wide>(a(y, x)))));
      }
    worst = std::max({worst, distance(transpose(a) * a, identity_matrix<double, 3>()), std::abs(determinant(a) - 1)});
    const auto f = linear_part(
        rotation(vec<float, 3>{static_cast<float>(axis.x), static_cast<float>(axis.y), static_cast<float>(axis.z)},
                 static_cast<float>(angle)));
    worst_float = std::max(worst_float, distance(transpose(f) * f, identity_matrix<float, 3>()));
    worst_axis = std::max(worst_axis, distance(transform_vector(m, axis), axis));
    // Another way: turn the axis into z by two coordinate rotations, turn about z, turn back.
    const double azimuth = std::atan2(axis.y, axis.x), polar = std::atan2(std::hypot(axis.x, axis.y), axis.z);
    const D to_z = rotation_y(-polar) * rotation_z(-azimuth);
    worst_turn = std::max(worst_turn, distance(m, rotation_z(azimuth) * rotation_y(polar) * rotation_z(angle) * to_z));
  }
  CHECK(worst <= 16 * 0x1p-53);
  CHECK(worst_entry <= 10 * 0x1p-53);
  CHECK(worst_float <= 16 * 0x1p-24);
  CHECK(worst_axis <= 4e-15);
  CHECK(worst_turn <= 2e-15);
  for (const double angle : {0.3, -2.0, 3.1, 100.0}) {
    CHECK(distance(rotation(V{5, 0, 0}, angle), rotation_x(angle)) <= 0x1p-52);
    CHECK(distance(rotation(V{0, 5, 0}, angle), rotation_y(angle)) <= 0x1p-52);
    CHECK(distance(rotation(V{0, 0, 5}, angle), rotation_z(angle)) <= 0x1p-52);
    CHECK(distance(rotation(V{0, 0, -5}, angle), rotation_z(-angle)) <= 0x1p-52);
  }
}

TEST_CASE("affine: the order of composition matters; inverses undo") {
  test::random r(2);
  for (int i = 0; i < 1000; ++i) {
    const V factors = random_vector(r), shift = random_vector(r);
    const D turn = random_rotation(r);
    const D m = translation(shift) * turn * scaling(factors);
    const P p = to_point(random_vector(r));
    CHECK(distance(transform_point(m, p),
                   transform_point(translation(shift), transform_point(turn, transform_point(scaling(factors), p)))) <=
          1e-14);
    CHECK(m != scaling(factors) * turn * translation(shift));
    const auto undo = inverse(m);
    CHECK(undo.has_value());
    if (!undo) continue;
    const double least = std::min({std::abs(factors.x), std::abs(factors.y), std::abs(factors.z)});
    CHECK(distance(*undo * m, identity_matrix<double, 4>()) <= 1e-14 / least);
    CHECK(transform_vector(*undo, V{0, 0, 0}) == V{0, 0, 0});
    CHECK(((*undo)(3, 0) == 0 && (*undo)(3, 1) == 0 && (*undo)(3, 2) == 0 && (*undo)(3, 3) == 1));
  }
}

TEST_CASE("affine: normals stay at right angles and outside, under non-uniform scaling and mirror images") {
  test::random r(3);
  for (int i = 0; i < 2000; ++i) {
    V factors = random_vector(r);
    const D m = translation(random_vector(r)) * random_rotation(r) * scaling(factors) * random_rotation(r);
    const V u = random_vector(r), v = random_vector(r);
    const V n = normalized(cross(u, v));
    const V image = normalized(transform_normal(m, n));
    const V image_u = normalized(transform_vector(m, u)), image_v = normalized(transform_vector(m, v));
    const double least = std::min({std::abs(factors.x), std::abs(factors.y), std::abs(factors.z)});
    CHECK(std::abs(dot(image, image_u)) <= 1e-14 / (least * least));
    CHECK(std::abs(dot(image, image_v)) <= 1e-14 / (least * least));
    // What lies on the normal's side still does.
    CHECK(dot(transform_vector(m, n), image) > 0);
    CHECK(orientation_of(m) ==
          (factors.x * factors.y * factors.z > 0 ? map_orientation::preserving : map_orientation::reversing));
  }
  // Scaling by (1, 4, 1): the plane x + y = 1 becomes x + y/4 = 1. The naive image of its normal would be (1, 4, 0).
  CHECK_BOTH(transform_normal(scaling(V{1, 4, 1}), V{1, 1, 0}) == V{4, 1, 0});
  CHECK_BOTH(transform_normal(scaling(V{-1, 1, 1}), V{1, 0, 0}) == V{-1, 0, 0});
  CHECK_BOTH(transform_normal(scaling(V{-1, 1, 1}), V{0, 1, 0}) == V{0, 1, 0});
}

TEST_CASE("affine: the normal matrix is the inverse transpose times a positive factor, in rationals") {
  test::random r(4);
  for (int i = 0; i < 500; ++i) {
    auto m = identity_matrix<rational, 4>();
    for (int y = 0; y < 3; ++y)
      for (int x = 0; x < 4; ++x) m(y, x) = r.integer(-5, 5);
    const auto undo = inverse(linear_part(m));
    const rational d = determinant(linear_part(m));
    CHECK(orientation_of(m) == (rational(0) < d   ? map_orientation::preserving
                                : d < rational(0) ? map_orientation::reversing
                                                  : map_orientation::singular));
    if (undo) CHECK(normal_matrix(m) == transpose(*undo) * (d < rational(0) ? -d : d));
  }
}

TEST_CASE("affine: meshes") {
  const mesh<double> body = tetrahedron();
  CHECK(six_volumes(body) == doctest::Approx(1));
  test::random r(5);
  for (int i = 0; i < 200; ++i) {
    const V factors = random_vector(r);
    const D m = translation(random_vector(r)) * random_rotation(r) * scaling(factors);
    const mesh<double> image = transformed(body, m);
    // Fronts stay counter-clockwise from outside, mirrored or not, and normals agree with the faces.
    CHECK(six_volumes(image) == doctest::Approx(std::abs(factors.x * factors.y * factors.z)).epsilon(1e-9));
    for (std::size_t f = 0; f < image.face_count(); ++f) {
      const P a = image.positions[image.corner(f, 0).position], b = image.positions[image.corner(f, 1).position],
              c = image.positions[image.corner(f, 2).position];
      CHECK(distance(normalized(cross(b - a, c - a)), image.normals[image.corner(f, 0).normal]) <= 1e-9);
      CHECK(image.corner(f, 0) == body.corner(f, 0));
    }
  }
  // The corners of a pentagon, mirrored: the first stays, the others are turned round.
  mesh<float> pentagon;
  pentagon.positions = {{0, 0, 0}, {1, 0, 0}, {2, 1, 0}, {1, 2, 0}, {0, 1, 0}};
  add_face(pentagon, std::array{0, 1, 2, 3, 4});
  const auto mirrored = transformed(pentagon, scaling(vec<float, 3>{-1, 1, 1}));
  for (std::size_t k = 0; k < 5; ++k) CHECK(mirrored.corner(0, k).position == (5 - k) % 5);
  CHECK(mirrored.positions[2] == point<float, 3>{-2, 1, 0});
  CHECK(transformed(transformed(pentagon, scaling(vec<float, 3>{-1, 1, 1})), scaling(vec<float, 3>{-1, 1, 1})) ==
        pentagon);
  CHECK(transformed(mesh<float>{}, identity_matrix<float, 4>()) == mesh<float>{});
}

TEST_CASE("affine: degenerate and hostile") {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  CHECK_BOTH(rotation(V{0, 0, 0}, 1.0) == identity_matrix<double, 4>());
  CHECK(rotation(V{nan, 0, 0}, 1.0) == identity_matrix<double, 4>());
  CHECK(rotation(V{inf, 0, 0}, 1.0) == identity_matrix<double, 4>());
  CHECK(distance(rotation(V{0, 0, 1e-320}, 1.0), rotation_z(1.0)) <= 0x1p-52);
  CHECK(distance(rotation(V{1e308, 1e308, 1e308}, 1.0), rotation(V{1, 1, 1}, 1.0)) <= 0x1p-52);
  // Flattened onto the plane z = 0, every normal that has one becomes that plane's.
  CHECK_BOTH(orientation_of(scaling(V{1, 1, 0})) == map_orientation::singular);
  CHECK_BOTH(transform_normal(scaling(V{1, 1, 0}), V{3, 4, 5}) == V{0, 0, 5});
  CHECK_BOTH(transform_normal(scaling(V{1, 0, 0}), V{3, 4, 5}) == V{0, 0, 0});
  CHECK_BOTH(normal_matrix(scaling(0.0)) == mat<double, 3, 3>{});
  // Far beyond where the products of three entries leave the range.
  for (const double size : {1e-300, 1e-200, 1e200, 1e300}) {
    const D m = rotation(V{1, 2, 3}, 2.0) * scaling(V{size, 2 * size, -size});
    CHECK(orientation_of(m) == map_orientation::reversing);
    const V n = normalized(transform_normal(m, V{1, 1, 0}));
    const V expected = normalized(transform_normal(rotation(V{1, 2, 3}, 2.0) * scaling(V{1, 2, -1}), V{1, 1, 0}));
    CHECK(distance(n, expected) <= 1e-15);
  }
  // Where they cancel, and where entries of one matrix differ by hundreds of decades.
  for (const V& size : {V{1e300, -1e-10, 1e-300}, V{1e-200, 1e-200, -1e200}, V{-1e200, 1e-200, 1e-200},
                        V{5e-324, -5e-324, 5e-324}, V{1e150, 1e-150, -1e-300}}) {
    CHECK(orientation_of(scaling(size)) == map_orientation::reversing);
    const V n = normalized(transform_normal(scaling(size), V{0, size.y, size.z}));
    CHECK(distance(n, V{0, std::sqrt(0.5), std::sqrt(0.5)}) <= 1e-15);
  }
  // Nearly flat: the sign is that of the entries as they are.
  test::random r(6);
  for (int i = 0; i < 200; ++i) {
    mat<float, 4, 4> m = identity_matrix<float, 4>();
    auto exact = identity_matrix<rational, 4>();
    for (int y = 0; y < 3; ++y)
      for (int x = 0; x < 3; ++x) {
        m(y, x) = static_cast<float>(3 * y + x + 1) * 0.1f + static_cast<float>(r.integer(-1, 1)) * 0x1p-23f;
        exact(y, x) = rational::of(static_cast<double>(m(y, x)));
      }
    CHECK(orientation_of(m) == orientation_of(exact));
  }
  CHECK(orientation_of(scaling(V{1, inf, 1})) == map_orientation::singular);
  mesh<double> body;
  body.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  body.normals = {{0, 0, 1e300}, {0, 0, 1e-300}};
  for (const V& n : transformed(body, scaling(1e70)).normals) CHECK(n == V{0, 0, 1});
  CHECK(orientation_of(scaling(-1e-30f)) == map_orientation::reversing);
  CHECK(orientation_of(scaling(1e30f)) == map_orientation::preserving);
}

TEST_CASE("affine: vectors in braces are of doubles") {
  CHECK_BOTH(irg::translation({1, 2, 3}) == irg::translation(V{1, 2, 3}));
  CHECK_BOTH(irg::rotation({0, 0, 1}, 0.5) == irg::rotation(V{0, 0, 1}, 0.5));
}
