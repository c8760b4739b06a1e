// SPDX-License-Identifier: MIT
#include <irg/curve/bspline_surface.hpp>

#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <vector>

#include <irg/math/vec.hpp>

#include "support/check_both.hpp"
#include "support/random.hpp"
#include "support/spline_oracle.hpp"

namespace {

using P3 = irg::point<double, 3>;
using V3 = irg::vec<double, 3>;
using H3 = irg::hpoint<double, 3>;
constexpr double none = std::numeric_limits<double>::quiet_NaN();

constexpr std::array<double, 6> one_stretch{0, 0, 0, 1, 1, 1};
constexpr std::array<double, 5> two_stretches{0, 0, 1, 2, 2};
constexpr std::array<P3, 9> roof{P3{0, 0, 0}, {0, 1, 4}, {0, 2, 0}, {1, 0, 0}, {1, 1, 4},
                                 {1, 2, 0},   {2, 0, 2}, {2, 1, 6}, {2, 2, 2}};
constexpr irg::bspline_surface<P3, 2, 1> small{
    irg::bspline_knots<double, 2>(one_stretch), irg::bspline_knots<double, 1>(two_stretches), {roof, 3}};

// Random knots of any multiplicities from 0 on, with `count` control points.
std::vector<double> random_knots(test::random& r, std::size_t degree, std::size_t count) {
  std::vector<double> u(degree + 1, 0);
  while (u.size() < count) {
    const std::size_t times = static_cast<std::size_t>(r.integer(1, static_cast<std::int64_t>(degree) + 1));
    const double next = u.back() + 0.25 + r.unit();
    for (std::size_t i = 0; i < times && u.size() < count; ++i) u.push_back(next);
  }
  const double end = u.back() + 1;
  u.resize(count + degree + 1, end);
  return u;
}

struct random_surface {
  std::size_t degree_u, degree_v;
  std::vector<double> u, v;
  std::vector<P3> points;
  irg::bspline_surface<P3> view() const {
    return {*irg::make_bspline_knots(std::span<const double>(u), static_cast<int>(degree_u)),
            *irg::make_bspline_knots(std::span<const double>(v), static_cast<int>(degree_v)),
            {points, v.size() - degree_v - 1}};
  }
};

random_surface make_surface(test::random& r, std::size_t degree_u, std::size_t degree_v) {
  const std::size_t rows = degree_u + 1 + static_cast<std::size_t>(r.integer(0, 4)),
                    columns = degree_v + 1 + static_cast<std::size_t>(r.integer(0, 4));
  random_surface s{degree_u, degree_v, random_knots(r, degree_u, rows), random_knots(r, degree_v, columns), {}};
  for (std::size_t k = 0; k < rows * columns; ++k) s.points.push_back({r.unit(), r.unit(), r.unit()});
  return s;
}

}  // namespace

TEST_CASE("bspline surface: by hand") {
  CHECK_BOTH(*irg::bspline_surface_point(small, 0, 0) == P3{0, 0, 0});
  CHECK_BOTH(*irg::bspline_surface_point(small, 1, 2) == P3{2, 2, 2});
  CHECK_BOTH(*irg::bspline_surface_point(small, 0.5, 1) == P3{1, 1, 4.5});
  CHECK_BOTH(*irg::bspline_surface_sample(small, 1, 0.5) ==
             irg::surface_sample<P3>{{2, 0.5, 4}, {2, 0, 4}, {0, 1, 4}, {0, 0, 0}});
  CHECK_BOTH(!irg::bspline_surface_point(small, none, 0));
  CHECK_BOTH(!irg::bspline_surface_point(small, 0, 2.0000000000000004));
  CHECK_BOTH(!irg::bspline_surface_sample(small, -1, 0));
}

TEST_CASE("bspline surface: the points published in NURBS-Python's tests") {
  const std::vector<double> u{0, 0, 0, 0, .33, .66, 1, 1, 1, 1};
  constexpr std::array<std::array<double, 6>, 6> height{{{-10, -5, 0, 0, -5, -10},
                                                         {-8, -4, -4, -4, -4, -8},
                                                         {-5, -3, -8, -8, -3, -5},
                                                         {-3, -2, -8, -8, -2, -3},
                                                         {-8, -4, -4, -4, -4, -8},
                                                         {-10, -5, 2, 2, -5, -10}}};
  std::vector<P3> points;
  std::vector<H3> weighted;
  for (std::size_t i = 0; i < 6; ++i)
    for (std::size_t j = 0; j < 6; ++j) {
      points.push_back({static_cast<double>(i) * 10 - 25, static_cast<double>(j) * 10 - 25, height[i][j]});
      weighted.push_back(irg::to_homogeneous(points.back()));
    }
  const irg::bspline_knots<double, 3> knots(u);
  const irg::bspline_surface<P3, 3> s{knots, knots, {points, 6}};
  const irg::bspline_surface<H3, 3> rational{knots, knots, {weighted, 6}};
  constexpr double published[][5] = {
      {0, 0, -25, -25, -10},         {0, 0.2, -25, -11.403, -3.385},     {0, 1, -25, 25, -10},
      {0.3, 0, -7.006, -25, -5.725}, {0.3, 0.4, -7.006, -3.308, -6.265}, {0.3, 1, -7.006, 25, -5.725},
      {0.6, 0, 3.533, -25, -4.224},  {0.6, 0.6, 3.533, 3.533, -6.801},   {0.6, 1, 3.533, 25, -4.224},
      {1, 0, 25, -25, -10},          {1, 0.8, 25, 11.636, -2.751},       {1, 1, 25, 25, -10}};
  for (const auto& row : published) {
    const P3 want{row[2], row[3], row[4]};
    const P3 p = *irg::bspline_surface_point(s, row[0], row[1]);
    for (int axis = 0; axis < 3; ++axis) CHECK(std::abs(p[axis] - want[axis]) < 1e-3);  // three digits are published
    CHECK(irg::length(*irg::nurbs_surface_point(rational, row[0], row[1]) - p) < 1e-14 * 40);
    CHECK(irg::length(irg::nurbs_surface_sample(rational, row[0], row[1])->point - p) < 1e-14 * 40);
  }
  const auto near = [](const V3& a, const V3& b) { return irg::length(a - b) < 2e-4; };
  const auto first = *irg::nurbs_surface_sample(rational, 0, 0.25);
  CHECK(near(first.dv, {0, 43.6910, 17.5411}));
  CHECK(near(first.du, {90.9090, 0, -15.0882}));
  CHECK(near(first.duv, {0, 0, -140.0367}));
  std::array<V3, 9> d{};
  std::array<V3, 23> room{};
  CHECK(irg::bspline_surface_derivatives(s, {0.95, 0.75}, 2, std::span<V3>(d), std::span<V3>(room)));
  CHECK(near(d[0], {20.8948, 9.3097, -2.4845}));
  CHECK(near(d[1], {0, 43.7672, -15.0153}));
  CHECK(near(d[2], {0, 100.1022, -74.1165}));
  CHECK(near(d[3], {76.2308, 0, 18.0372}));
  CHECK(near(d[4], {0, 0, -158.5462}));
  CHECK(near(d[5], {0, 0, -284.3037}));
  CHECK(near(d[6], {224.5342, 0, 93.3843}));
  CHECK(near(d[8], {0, 0, -318.8808}));
}

#ifdef IRG_HAVE_MPFR
TEST_CASE("bspline surface: points and derivatives against rationals, degrees 0 to 5, knots of all multiplicities") {
  test::random r(41);
  double worst = 0;
  for (int trial = 0; trial < 60; ++trial) {
    const auto s =
        make_surface(r, static_cast<std::size_t>(r.integer(0, 5)), static_cast<std::size_t>(r.integer(0, 5)));
    const auto view = s.view();
    const double u = trial % 7 == 0 ? s.u.back() : r.unit() * s.u.back(), v = r.unit() * s.v.back();
    std::array<double, 12> numbers{};
    std::array<V3, 40> room{};
    std::array<V3, 9> d{};
    const P3 p = *irg::bspline_surface_point(view, u, v, numbers);
    REQUIRE(irg::bspline_surface_derivatives(view, {u, v}, 2, std::span<V3>(d), std::span<V3>(room)));
    const std::size_t columns = view.net.columns;
    for (int axis = 0; axis < 3; ++axis)
      for (int k = 0; k < 3; ++k)
        for (int l = 0; l < 3; ++l) {
          const auto want = test::spline_value(s.u, s.degree_u, u, k, [&](std::size_t i) {
            return test::spline_value(s.v, s.degree_v, v, l, [&](std::size_t j) {
              return test::big_rational(s.points[i * columns + j][axis]);
            });
          });
          const double scale = std::pow(40., k + l);  // degree over the shortest stretch, twice
          const double off = test::distance(d[static_cast<std::size_t>(3 * k + l)][axis], want) / scale;
          worst = std::fmax(worst, off);
          if (k + l == 0) CHECK(test::distance(p[axis], want) <= 1e-15);
        }
  }
  CHECK(worst <= 1e-14);
}
#endif

TEST_CASE("bspline surface: degrees known when compiling and when running, and Bezier nets of any degree, agree") {
  test::random r(42);
  for (int trial = 0; trial < 200; ++trial) {
    const auto s = make_surface(r, 3, 2);
    const auto view = s.view();
    const irg::bspline_surface<P3, 3, 2> fixed{irg::bspline_knots<double, 3>(s.u), irg::bspline_knots<double, 2>(s.v),
                                               view.net};
    const double u = r.unit() * s.u.back(), v = r.unit() * s.v.back();
    std::array<double, 7> numbers{};
    std::array<V3, 18> room{};
    CHECK(*irg::bspline_surface_point(fixed, u, v) == *irg::bspline_surface_point(view, u, v, numbers));
    CHECK(*irg::bspline_surface_sample(fixed, u, v) == *irg::bspline_surface_sample(view, u, v, std::span<V3>(room)));
  }
  for (int trial = 0; trial < 200; ++trial) {  // one degree: both bases side by side, weighted points in registers
    const auto s = make_surface(r, 3, 3);
    const auto view = s.view();
    std::vector<H3> weighted;
    for (const P3& p : view.net.points) weighted.push_back(irg::to_homogeneous(p, 0.5 + r.unit()));
    const bool at_knots = trial % 4 == 0, at_corner = trial % 10 == 0;
    if (at_corner) weighted[1].x = weighted.back().y = std::numeric_limits<double>::infinity();
    const auto knot = [&](const std::vector<double>& list) {
      return list[static_cast<std::size_t>(r.integer(0, static_cast<int>(list.size()) - 1))];
    };
    const double u = at_corner  ? s.u.front()
                     : at_knots ? knot(s.u)
                                : r.unit() * s.u.back(),
                 v = at_corner  ? s.v.front()
                     : at_knots ? knot(s.v)
                                : r.unit() * s.v.back();
    const irg::control_net<H3> net{weighted, view.net.columns};
    const irg::bspline_surface<H3, 3> fixed{irg::bspline_knots<double, 3>(s.u), irg::bspline_knots<double, 3>(s.v),
                                            net};
    const irg::bspline_surface<H3> any{view.u, view.v, net};
    std::array<double, 8> numbers{};
    const auto p = irg::bspline_surface_point(fixed, u, v);
    CHECK(p == irg::bspline_surface_point(any, u, v, numbers));
    CHECK(irg::nurbs_surface_point(fixed, u, v) == irg::nurbs_surface_point(any, u, v, numbers));
    if (at_corner && s.u[3] == u && s.v[3] == v && p) CHECK(*p == weighted[0]);
  }
  irg::bezier_patch<P3, 3, 2> patch;
  std::vector<P3> flat;
  for (auto& row : patch.points)
    for (P3& p : row) flat.push_back(p = {r.unit(), r.unit(), r.unit()});
  std::array<P3, 10> scratch{};
  for (int k = 0; k <= 20; ++k)
    CHECK(irg::patch_sample(irg::control_net<P3>{flat, 3}, k / 20., 1 - k / 23., scratch) ==
          irg::patch_sample(patch, k / 20., 1 - k / 23.));
  CHECK(irg::patch_sample(irg::control_net<P3>{std::span(flat).first(1), 1}, 0.3, 0.4, scratch) ==
        irg::surface_sample<P3>{flat[0], {}, {}, {}});
}

TEST_CASE("bspline surface: its Bezier patches are the surface, and share their borders bit for bit") {
  test::random r(43);
  for (int trial = 0; trial < 40; ++trial) {
    const std::size_t m = static_cast<std::size_t>(r.integer(1, 4)), n = static_cast<std::size_t>(r.integer(1, 4));
    const auto s = make_surface(r, m, n);
    const auto view = s.view();
    std::vector<double> scratch((m + 1) * (m + 1) + (n + 1) * (n + 1));
    std::vector<P3> piece((m + 1) * (n + 1)), before;
    double before_to = -1, before_row = -1;
    irg::bspline_surface_patches(view, scratch, piece, [&](const irg::surface_piece<P3>& patch) {
      std::array<P3, 30> room{};
      for (int k = 0; k <= 4; ++k) {
        const double a = k / 4., b = (4 - k) / 4.;
        const double u = patch.u_from + a * (patch.u_to - patch.u_from),
                     v = patch.v_from + b * (patch.v_to - patch.v_from);
        if (k == 4 || k == 0) continue;  // at knots the surface behind is asked
        const P3 want = *irg::bspline_surface_point(view, u, v, scratch);
        CHECK(irg::length(irg::patch_sample(patch.net, a, b, room).point - want) < 2e-15);
      }
      const bool follows = before_row == patch.u_from && before_to == patch.v_from;
      std::size_t times = 0;
      for (const double x : s.v) times += x == patch.v_from;
      if (follows && times <= n)
        for (std::size_t i = 0; i <= m; ++i) CHECK(before[i * (n + 1) + n] == patch.net(i, 0));
      before.assign(patch.net.points.begin(), patch.net.points.end());
      before_to = patch.v_to;
      before_row = patch.u_from;
    });
  }
}

TEST_CASE("rational surfaces: no weight, no point") {
  std::array<H3, 9> net{};
  for (std::size_t k = 0; k < 9; ++k) net[k] = {1, 2, 3, 0};
  const irg::bspline_surface<H3, 2, 1> s{small.u, small.v, {net, 3}};
  CHECK(!irg::nurbs_surface_point(s, 0.5, 0.5));
  CHECK(!irg::nurbs_surface_sample(s, 0.5, 0.5));
  CHECK(!irg::nurbs_surface_point(s, none, 0.5));
  net[4].w = none;
  CHECK(!irg::nurbs_surface_point(s, 0.5, 0.5));
}

TEST_CASE("rational surfaces: no derivative that is finite, no sample") {
  constexpr double inf = std::numeric_limits<double>::infinity();
  constexpr irg::surface_sample<H3> sample{{1e20, 2, 3, 1}, {1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 0, 0}};
  CHECK_BOTH(irg::rational_sample(sample)->du == V3{1, 0, 0});
  for (const double x : {none, inf, -inf})
    for (const auto derivative :
         {&irg::surface_sample<H3>::du, &irg::surface_sample<H3>::dv, &irg::surface_sample<H3>::duv})
      for (int axis = 0; axis < 4; ++axis) {
        auto bad = sample;
        (bad.*derivative)[axis] = x;
        CHECK(!irg::rational_sample(bad));
      }
  constexpr irg::surface_sample<H3> unknown{{1, 2, 3, 1}, {none, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 0, inf}};
  CHECK_BOTH(!irg::rational_sample(unknown));
  auto steep = sample;
  steep.du.w = 1e300;  // times x beyond the largest number
  CHECK(!irg::rational_sample(steep));
}
