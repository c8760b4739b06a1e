// SPDX-License-Identifier: MIT
#include <irg/geometry/exact_point.hpp>

#include <array>
#include <cmath>

#include <irg/geometry/orient3d.hpp>

#include "support/big_rational.hpp"
#include "support/check_both.hpp"
#include "support/random.hpp"

namespace {

using irg::exact_point;
using place = irg::point<double, 3>;

// A place of a lattice, of numbers of one size, or of 400 decades, in turn.
place any_place(test::random& r, int trial) {
  place p{};
  for (int i = 0; i < 3; ++i)
    p[i] = trial % 2 ? static_cast<double>(r.integer(-3, 3))
                     : std::ldexp(static_cast<double>(r.integer(-(1 << 30), 1 << 30)),
                                  static_cast<int>(r.integer(-660, 660)) * (trial % 4 / 2));
  return p;
}

}  // namespace

TEST_CASE("exact_point: crossings, their sides and orders, at compile time, too") {
  CHECK_BOTH(exact_point::on_plane({0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {0, 0, 0}, {3, 0, 3}).rounded() == place{1, 0, 1});
  CHECK_BOTH(exact_point::on_lines({0, 0, 0}, {2, 2, 0}, {0, 2, 0}, {2, 0, 0}).rounded() == place{1, 1, 0});
  CHECK_BOTH(!exact_point::on_plane({0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {0, 0, 0}, {3, 0, 0}).is_known());
  CHECK_BOTH(!exact_point::on_lines({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {5, 1, 0}).is_known());
  CHECK_BOTH(!exact_point().is_known());
  using planes = std::array<std::array<place, 3>, 3>;
  constexpr planes box{
      {{{{3, 0, 0}, {3, 1, 0}, {3, 0, 1}}}, {{{0, 5, 0}, {0, 5, 1}, {1, 5, 0}}}, {{{0, 0, 7}, {1, 0, 7}, {0, 1, 7}}}}};
  CHECK_BOTH(exact_point::on_planes(box).rounded() == place{3, 5, 7});
  CHECK_BOTH(!exact_point::on_planes({box[0], box[1], box[1]}).is_known());
  CHECK_BOTH(!exact_point::on_planes({box[0], box[1], {{{1, 2, 3}, {2, 4, 6}, {3, 6, 9}}}}).is_known());
  CHECK_BOTH([] {  // a third is no double: the point lies on the line still
    const auto third = exact_point::on_plane({0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {0, 0, 0}, {1, 2, 3});
    const exact_point o(place{0, 0, 0}), a(place{1, 2, 3}), b(place{1, 2, 3.5});
    return irg::orientation_along(0, o, third, a) == 0 && irg::orientation_along(2, o, third, a) == 0 &&
           irg::orientation_along(0, o, third, b) == 1 && irg::compare_along(1, third, a) == -1 &&
           irg::compare_along(1, third, third) == 0 &&
           irg::side_of_plane({0, 0, 1}, {1, 0, 1}, {0, 1, 1}, third) == irg::side::on;
  }());
  CHECK_BOTH(irg::side_of_plane({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, exact_point(place{0, 0, 5e-324})) == irg::side::above);
  CHECK_BOTH(exact_point::mean_of(exact_point(place{3, 0, 0}), exact_point(place{0, 6, 0}), exact_point(place{0, 0, 9}))
                 .rounded() == place{1, 2, 3});
}

TEST_CASE("exact_point: where three planes meet, of lattices and of 400 decades") {
  test::random r(21);
  int met = 0;
  for (int trial = 0; trial < 1000; ++trial) {
    const auto any = [&] { return any_place(r, trial); };
    const auto plane = [&] { return std::array{any(), any(), any()}; };
    const std::array<place, 3> a = plane(), b = plane(), c{a[0], a[1], any()};
    const exact_point p = exact_point::on_planes({a, b, plane()}), q = exact_point::on_planes({a, b, c});
    const exact_point on_edge = exact_point::on_plane(b[0], b[1], b[2], a[0], a[1]);
    if (!p.is_known() || !q.is_known()) continue;
    ++met;
    CHECK(irg::side_of_plane(a[0], a[1], a[2], p) == irg::side::on);
    CHECK(irg::side_of_plane(b[0], b[1], b[2], p) == irg::side::on);
    CHECK(irg::side_of_plane(a[0], a[1], a[2], exact_point::mean_of(p, q, p)) == irg::side::on);
    for (int axis = 0; axis < 3; ++axis) {
      CHECK(irg::compare_along(axis, q, on_edge) == 0);
      CHECK(irg::orientation_along(axis, p, q, exact_point::mean_of(p, q, p)) == 0);
      CHECK(irg::orientation_along(axis, q, exact_point::mean_of(q, p, exact_point(a[2])), p) ==
            irg::orientation_along(axis, q, exact_point(a[2]), p));
    }
  }
  CHECK(met > 500);
}

#ifdef IRG_HAVE_MPFR
namespace {

using rational = test::big_rational;

struct rational_point {
  rational x[3];
};
rational_point exactly(const place& p) { return {{rational(p.x), rational(p.y), rational(p.z)}}; }

rational determinant(const rational_point& a, const rational_point& b, const rational_point& c,
                     const rational_point& d) {
  const auto u = [&](int i) { return b.x[i] - a.x[i]; };
  const auto v = [&](int i) { return c.x[i] - a.x[i]; };
  const auto w = [&](int i) { return d.x[i] - a.x[i]; };
  return (u(1) * v(2) - u(2) * v(1)) * w(0) + (u(2) * v(0) - u(0) * v(2)) * w(1) + (u(0) * v(1) - u(1) * v(0)) * w(2);
}
rational area(int axis, const rational_point& a, const rational_point& b, const rational_point& c) {
  const int i = axis == 0 ? 1 : 0, k = axis == 2 ? 1 : 2;
  return (b.x[i] - a.x[i]) * (c.x[k] - a.x[k]) - (b.x[k] - a.x[k]) * (c.x[i] - a.x[i]);
}
rational_point crossing(const place (&p)[5]) {
  const auto a = exactly(p[3]), b = exactly(p[4]);
  const rational from = determinant(exactly(p[0]), exactly(p[1]), exactly(p[2]), a),
                 to = determinant(exactly(p[0]), exactly(p[1]), exactly(p[2]), b), t = from / (from - to);
  rational_point at;
  for (int i = 0; i < 3; ++i) at.x[i] = a.x[i] + (b.x[i] - a.x[i]) * t;
  return at;
}

}  // namespace

TEST_CASE("exact_point: crossings against rationals, of lattices and of 400 decades") {
  test::random r(20);
  int zeros = 0;
  for (int trial = 0; trial < 3000; ++trial) {
    const auto any = [&] { return any_place(r, trial); };
    exact_point made[3];
    rational_point true_point[3];
    bool all = true;
    for (int i = 0; i < 3 && all; ++i) {
      const place p[5] = {any(), any(), any(), any(), any()};
      made[i] = exact_point::on_plane(p[0], p[1], p[2], p[3], p[4]);
      all = made[i].is_known();
      if (all) true_point[i] = crossing(p);
    }
    if (!all) continue;
    const int axis = static_cast<int>(r.integer(0, 2));
    const int turn = area(axis, true_point[0], true_point[1], true_point[2]).sign();
    CHECK(irg::orientation_along(axis, made[0], made[1], made[2]) == turn);
    CHECK(irg::compare_along(axis, made[0], made[1]) == (true_point[0].x[axis] - true_point[1].x[axis]).sign());
    const place a = any(), b = any(), c = any();
    CHECK(sign_of(irg::side_of_plane(a, b, c, made[2])) ==
          determinant(exactly(a), exactly(b), exactly(c), true_point[2]).sign());
    rational_point middle;
    for (int i = 0; i < 3; ++i)
      middle.x[i] = (true_point[0].x[i] + true_point[1].x[i] + true_point[2].x[i]) / rational(3);
    CHECK(sign_of(irg::side_of_plane(a, b, c, exact_point::mean_of(made[0], made[1], made[2]))) ==
          determinant(exactly(a), exactly(b), exactly(c), middle).sign());
    zeros += turn == 0 ? 1 : 0;
    const place near = made[0].rounded();
    for (int i = 0; i < 3; ++i)
      if (std::isfinite(near[i]) && std::abs(near[i]) > 1e-300) {
        const rational off = abs(rational(near[i]) - true_point[0].x[i]);
        CHECK(!(abs(rational(near[i])) * rational(0x1.01p-53) < off));
      }
  }
  CHECK(test::enough(zeros > 3));
}
#endif
