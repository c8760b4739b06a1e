// SPDX-License-Identifier: MIT
#include <irg/geometry/side_of_meeting.hpp>

#include <cmath>

#include "support/big_rational.hpp"
#include "support/check_both.hpp"
#include "support/random.hpp"

namespace {

using irg::side;
using plane = irg::plane_points<double>;

constexpr plane across(int axis, double at) {
  plane p;
  p.a[axis] = p.b[axis] = p.c[axis] = at;
  p.b[(axis + 1) % 3] = 1;
  p.c[(axis + 2) % 3] = 1;
  return p;
}
constexpr std::optional<side> side_of_corner(double x, double y, double z, const plane& of) {
  return side_of_meeting(across(0, x), across(1, y), across(2, z), of);
}

TEST_CASE("side_of_meeting: the corner of a box, planes that meet nowhere, hostile numbers") {
  constexpr plane slope{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};  // x + y + z = 1
  CHECK_BOTH(side_of_corner(1, 1, 1, slope) == side::above);
  CHECK_BOTH(side_of_corner(0, 0, 0, slope) == side::below);
  CHECK_BOTH(side_of_corner(0.5, 0.25, 0.25, slope) == side::on);
  CHECK_BOTH(side_of_corner(0.5, 0.25, 0.25 + 0x1p-54, slope) == side::above);
  CHECK_BOTH(side_of_corner(0.5, 0.25, 0.25 - 0x1p-54, slope) == side::below);
  CHECK_BOTH(side_of_corner(1e300, -1e300, 1, slope) == side::on);
  CHECK_BOTH(side_of_corner(1e300, -1e300, 1 - 0x1p-53, slope) == side::below);
  CHECK_BOTH(!side_of_meeting(across(0, 1), across(0, 2), across(1, 3), slope));
  CHECK_BOTH(!side_of_meeting(slope, slope, across(1, 3), slope));
  constexpr plane flat{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}};
  CHECK_BOTH(!side_of_meeting(across(0, 1), flat, across(1, 3), slope));
  CHECK_BOTH(side_of_corner(1, 2, 3, flat) == side::on);
  CHECK(side_of_meeting(irg::plane_points<float>{{1, 0, 0}, {1, 1, 0}, {1, 0, 1}},
                        irg::plane_points<float>{{0, 1, 0}, {1, 1, 0}, {0, 1, 1}},
                        irg::plane_points<float>{{0, 0, 1}, {1, 0, 1}, {0, 1, 1}},
                        irg::plane_points<float>{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}) == side::above);
}

#ifdef IRG_HAVE_MPFR
using Q = test::big_rational;
struct equation {
  Q v[4];
};
equation equation_of(const plane& p) {
  Q u[3], w[3];
  for (int k = 0; k < 3; ++k) u[k] = Q(p.b[k]) - Q(p.a[k]), w[k] = Q(p.c[k]) - Q(p.a[k]);
  equation e;
  for (int k = 0; k < 3; ++k) {
    const int i = (k + 1) % 3, j = (k + 2) % 3;
    e.v[k] = u[i] * w[j] - u[j] * w[i];
    e.v[3] = e.v[3] - e.v[k] * Q(p.a[k]);
  }
  return e;
}
Q minor(const equation (&e)[3], int i, int j, int k) {
  return e[0].v[i] * (e[1].v[j] * e[2].v[k] - e[1].v[k] * e[2].v[j]) -
         e[0].v[j] * (e[1].v[i] * e[2].v[k] - e[1].v[k] * e[2].v[i]) +
         e[0].v[k] * (e[1].v[i] * e[2].v[j] - e[1].v[j] * e[2].v[i]);
}

TEST_CASE("side_of_meeting: against Cramer's rule in rationals, of all magnitudes") {
  test::random r(6);
  int none = 0, on = 0, off = 0;
  for (int trial = 0; trial < 3000; ++trial) {
    const auto number = [&] {
      const auto whole = static_cast<double>(r.integer(-3, 3));
      if (trial % 3 == 0) return whole;
      return trial % 3 == 1 ? whole + std::ldexp(r.unit(), -static_cast<int>(r.integer(0, 60)))
                            : std::ldexp(whole, static_cast<int>(r.integer(-900, 900)));
    };
    plane p[4];
    for (plane& q : p)
      for (auto* corner : {&q.a, &q.b, &q.c})
        for (int k = 0; k < 3; ++k) (*corner)[k] = number();
    if (trial % 5 == 0) p[3].a = p[0].a, p[1].b = p[0].a, p[2].c = p[0].a;  // all through one point
    const equation e[3] = {equation_of(p[0]), equation_of(p[1]), equation_of(p[2])}, of = equation_of(p[3]);
    const Q w = minor(e, 0, 1, 2);
    const auto got = side_of_meeting(p[0], p[1], p[2], p[3]);
    if (w.sign() == 0) {
      REQUIRE(!got);
      ++none;
      continue;
    }
    const Q x = -minor(e, 3, 1, 2), y = -minor(e, 0, 3, 2), z = -minor(e, 0, 1, 3);
    const Q value = (of.v[0] * x + of.v[1] * y + of.v[2] * z) / w + of.v[3];
    REQUIRE(got == static_cast<side>(value.sign()));
    ++(value.sign() == 0 ? on : off);
  }
  CHECK(none > 20);
  CHECK(on > 100);
  CHECK(off > 1000);
}
#endif

}  // namespace
