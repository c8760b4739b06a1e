// SPDX-License-Identifier: MIT
#include <irg/geometry/plane.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "geometry/mixed_cases.hpp"
#include "support/check_both.hpp"
#include "support/random.hpp"
#include "support/rational.hpp"

using irg::hpoint;
using irg::newell_plane;
using irg::plane;
using irg::plane_through;
using irg::plane_value;
using irg::point;
using irg::side;
using irg::side_of;
using irg::vec;
using test::rational;

namespace {

using P = point<rational, 3>;
using L = plane<rational>;

// The course's fig. 4.1: the unit cube, its vertices counted from 1 in the face list.
constexpr P cube[] = {{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {1, 0, 1}, {1, 1, 0}, {1, 1, 1}, {0, 1, 0}, {0, 1, 1}};
constexpr int face[12][3] = {{1, 3, 2}, {3, 4, 2}, {3, 5, 4}, {5, 6, 4}, {5, 7, 6}, {7, 8, 6},
                             {7, 1, 8}, {1, 2, 8}, {1, 5, 3}, {1, 7, 5}, {2, 4, 6}, {2, 6, 8}};
constexpr L face_plane[12] = {{0, -1, 0, 0}, {0, -1, 0, 0}, {1, 0, 0, -1}, {1, 0, 0, -1}, {0, 1, 0, -1}, {0, 1, 0, -1},
                              {-1, 0, 0, 0}, {-1, 0, 0, 0}, {0, 0, -1, 0}, {0, 0, -1, 0}, {0, 0, 1, -1}, {0, 0, 1, -1}};

// The plane by formula 4.1 as printed, in the coordinates themselves.
constexpr L textbook(const P& p, const P& q, const P& r) {
  const rational a = (q.y - p.y) * (r.z - p.z) - (q.z - p.z) * (r.y - p.y);
  const rational b = -((q.x - p.x) * (r.z - p.z)) + (q.z - p.z) * (r.x - p.x);
  const rational c = (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
  return {a, b, c, -(p.x * a) - p.y * b - p.z * c};
}

}  // namespace

TEST_CASE("plane: type facts") {
  static_assert(irg::Plane<plane<float>> && irg::Plane<plane<rational>>);
  static_assert(std::is_aggregate_v<plane<double>> && sizeof(plane<double>) == 4 * sizeof(double));
}

TEST_CASE("plane: by hand, and one result in every life") {
  constexpr plane<double> xy{0, 0, 1, -4};
  CHECK_BOTH(plane_value(xy, point<double, 3>{7, 8, 9}) == 5);
  CHECK_BOTH(plane_value(xy, hpoint<double, 3>{7, 8, 9, 2}) == 1);
  CHECK_BOTH(side_of(xy, point<double, 3>{0, 0, 9}) == side::above);
  CHECK_BOTH(side_of(xy, point<double, 3>{0, 0, 3}) == side::below);
  CHECK_BOTH(side_of(xy, hpoint<double, 3>{1, 1, 8, 2}) == side::on);
  CHECK_BOTH(irg::normal_of(xy) == vec<double, 3>{0, 0, 1});
  CHECK_BOTH(side_of(std::array<double, 4>{0, 0, 1, -4}, std::array<double, 3>{0, 0, 9}) == side::above);

  constexpr auto p = plane_through(point<double, 3>{0.1, 0.2, 0.3}, {1.7, 0.4, -0.9}, {0.3, 2.1, 0.8});
  volatile double one = 1;
  CHECK(plane_through(point<double, 3>{0.1 * one, 0.2 * one, 0.3 * one}, {1.7 * one, 0.4 * one, -0.9 * one},
                      {0.3 * one, 2.1 * one, 0.8 * one}) == p);
}

TEST_CASE("plane: the course's values") {
  for (int f = 0; f < 12; ++f) {
    const P &p = cube[face[f][0] - 1], &q = cube[face[f][1] - 1], &r = cube[face[f][2] - 1];
    CHECK(plane_through(p, q, r) == face_plane[f]);
    CHECK(newell_plane(std::array<P, 3>{p, q, r}) == face_plane[f]);
    CHECK(plane_value(face_plane[f], P{rational(1, 2), rational(1, 2), rational(1, 2)}) == rational(-1, 2));
  }
  CHECK_BOTH(newell_plane(std::array<P, 4>{cube[0], cube[2], cube[4], cube[6]}) == L{0, 0, 2, 0});
  CHECK_BOTH(newell_plane(std::array<P, 4>{P{0, 0, 0}, P{2, 0, 0}, P{2, 2, 1}, P{0, 2, 0}}) == L{-2, -2, 8, 0});
  CHECK_BOTH(plane_through(P{1, 0, 0}, P{0, 2, 0}, P{0, 0, 3}) == L{6, 3, 2, -6});
  CHECK_BOTH(plane_through(P{1, 0, 1}, P{0, 1, 1}, P{1, 1, 2}) == L{1, 1, -1, 0});
  CHECK_BOTH(plane_through(P{0, 0, 4}, P{1, 0, 4}, P{0, 1, 4}) == L{0, 0, 1, -4});
  CHECK_BOTH(!plane_through(P{0, 0, 0}, P{1, 1, 1}, P{2, 2, 2}));
  CHECK_BOTH(plane_value(L{6, 3, 2, -6}, P{1, 1, 1}) == rational(5));
  CHECK_BOTH(plane_value(L{6, 3, 2, -6}, P{0, 0, 0}) == rational(-6));
  CHECK_BOTH(side_of(L{6, 3, 2, -6}, P{rational(1, 2), rational(1, 2), rational(3, 4)}) == side::on);
}

TEST_CASE("plane: agrees with the formula as printed; Newell's sum agrees with a fan of triangles") {
  test::random r(1);
  for (int i = 0; i < 1000; ++i) {
    std::vector<P> ring(static_cast<std::size_t>(r.integer(3, 8)));
    for (P& p : ring) p = {r.integer(-9, 9), r.integer(-9, 9), r.integer(-9, 9)};
    const auto through = plane_through(ring[0], ring[1], ring[2]);
    const L printed = textbook(ring[0], ring[1], ring[2]);
    const bool collinear = printed.a == rational(0) && printed.b == rational(0) && printed.c == rational(0);
    CHECK(through.has_value() == !collinear);
    if (through) {
      CHECK(*through == printed);
      for (int k = 0; k < 3; ++k) CHECK(side_of(*through, ring[static_cast<std::size_t>(k)]) == side::on);
    }
    L fan{};
    for (std::size_t k = 2; k < ring.size(); ++k) {
      const L t = textbook(ring[0], ring[k - 1], ring[k]);
      fan = {fan.a + t.a, fan.b + t.b, fan.c + t.c, fan.d + t.d};
    }
    const auto newell = newell_plane(ring);
    CHECK(newell.has_value() == !(fan.a == rational(0) && fan.b == rational(0) && fan.c == rational(0)));
    if (newell) CHECK(*newell == fan);
  }
}

TEST_CASE("plane: Newell's through the centroid of a quad that is not flat") {
  // Heights 1, 0, 1, 0: the normal is upright, the mean height a half.
  CHECK_BOTH(*irg::newell_plane_through_centroid(std::array<P, 4>{P{0, 0, 1}, P{2, 0, 0}, P{2, 2, 1}, P{0, 2, 0}}) ==
             L{0, 0, 8, -4});
  CHECK_BOTH(*irg::newell_plane_through_centroid(std::array<point<double, 3>, 4>{
                 {{0, 0, 1}, {2, 0, 0}, {2, 2, 1}, {0, 2, 0}}}) == plane<double>{0, 0, 8, -4});
}

TEST_CASE("plane: far from the origin Newell's normal keeps its direction") {
  test::random r(2);
  double worst = 0;
  for (int i = 0; i < 2000; ++i) {
    // A regular octagon of size 1 in a random plane, 10^6 away.
    const double n[3] = {r.unit() - 0.5, r.unit() - 0.5, r.unit() + 0.5}, size = std::hypot(n[0], n[1], n[2]);
    const double u[3] = {n[2], 0, -n[0]}, u_size = std::hypot(n[0], n[2]);
    const double v[3] = {n[1] * u[2] - n[2] * u[1], n[2] * u[0] - n[0] * u[2], n[0] * u[1] - n[1] * u[0]};
    const double v_size = size * u_size, offset[3] = {1e6 * r.unit(), 1e6 * r.unit(), 1e6};
    std::array<point<double, 3>, 8> ring;
    for (int k = 0; k < 8; ++k) {
      const double c = std::cos(k * 0.785398163397448), s = std::sin(k * 0.785398163397448);
      for (int j = 0; j < 3; ++j)
        ring[static_cast<std::size_t>(k)][j] = offset[j] + c * u[j] / u_size + s * v[j] / v_size;
    }
    const auto p = newell_plane(ring);
    CHECK(p.has_value());
    if (!p) continue;
    const double cross = std::hypot(p->b * n[2] - p->c * n[1], p->c * n[0] - p->a * n[2], p->a * n[1] - p->b * n[0]);
    worst = std::max(worst, cross / (std::hypot(p->a, p->b, p->c) * size));
  }
  CHECK(worst > 0);
  CHECK(worst <= 2e-10);
}

TEST_CASE("plane: degenerate and hostile") {
  using D = point<double, 3>;
  constexpr double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  CHECK_BOTH(!plane_through(D{1, 2, 3}, D{1, 2, 3}, D{4, 5, 6}));
  CHECK_BOTH(!newell_plane(std::array<D, 2>{D{0, 0, 0}, D{1, 0, 0}}));
  CHECK(!newell_plane(std::vector<D>{}));
  CHECK_BOTH(!newell_plane(std::array<D, 4>{D{0, 0, 0}, D{1, 1, 0}, D{1, 0, 0}, D{0, 1, 0}}));  // bow-tie: no area
  CHECK_BOTH(newell_plane(std::array<D, 5>{D{0, 0, 0}, D{1, 0, 0}, D{1, 0, 0}, D{1, 1, 0}, D{0, 1, 0}}) ==
             plane<double>{0, 0, 2, 0});
  CHECK(!plane_through(D{nan, nan, nan}, D{1, 0, 0}, D{0, 1, 0}));
  CHECK(!plane_through(D{inf, inf, inf}, D{1, 0, 0}, D{0, 1, 0}));
  CHECK(side_of(plane<double>{nan, 0, 0, 0}, D{1, 1, 1}) == side::on);
}

#ifdef IRG_HAVE_MPFR

TEST_CASE_TEMPLATE("line_value, plane_value: numbers of all sizes, of their bounds", T, double, float) {
  using namespace test::mixed;
  sweep(
      named<T>("line_value and plane_value"), 1,
      [](test::random& r, sizes which) {
        const auto c = numbers<T, 7>(r, which);
        const auto e = rationals(c);
        const E terms[4] = {e[0] * e[4], e[1] * e[5], e[2] * e[6], e[3]};
        bool fits = true;
        E sum = 0, size = 0;
        for (const E& term : terms) {
          fits = fits && in_range<T>(term);
          sum = sum + term, size = size + abs(term);
        }
        if (!fits) return 0.0;
        const T in_space = plane_value(irg::plane<T>{c[0], c[1], c[2], c[3]}, point<T, 3>{c[4], c[5], c[6]});
        const T in_plane = line_value(irg::line<T>{c[0], c[1], c[3]}, point<T, 2>{c[4], c[5]});
        return std::fmax(share_of(in_space, sum, 4, size), share_of(in_plane, sum - terms[2], 3, size - abs(terms[2])));
      },
      3000);
}

#endif
