// SPDX-License-Identifier: MIT
#include <irg/view/frustum.hpp>

#include <cmath>
#include <limits>

#include <irg/geometry/clip_homogeneous.hpp>
#include <irg/math/inverse.hpp>
#include <irg/view/look_at.hpp>
#include <irg/view/oblique.hpp>

#include "support/check_both.hpp"
#include "support/random.hpp"
#include "support/rational.hpp"

using irg::bounding_sphere;
using irg::box;
using irg::classify;
using irg::containment;
using irg::depth_range;
using irg::frustum;
using irg::frustum_corners;
using irg::frustum_of;
using irg::frustum_plane;
using irg::hpoint;
using irg::mat;
using irg::plane;
using irg::point;
using test::rational;

namespace {

using R = rational;
using P = point<double, 3>;
using B = box<double, 3>;
using Ball = bounding_sphere<double, 3>;
using enum containment;
constexpr double inf = std::numeric_limits<double>::infinity(), not_a_number = std::numeric_limits<double>::quiet_NaN();

// A right angle, square, from 1 to 5, looking along -z.
constexpr auto right_angle = irg::perspective(irg::half_pi<double>, 1, 1, 5);

// The clip tests of a position, all six, in exact arithmetic: how many planes it is below of, as bits.
unsigned outside_bits(const mat<R, 4, 4>& m, const point<R, 3>& p) {
  const auto q = m * p;
  const R value[6] = {q.w - q.z, q.z, q.w + q.x, q.w - q.x, q.w + q.y, q.w - q.y};
  unsigned bits = 0;
  for (unsigned k = 0; k < 6; ++k) bits |= value[k] < R(0) ? 1u << k : 0u;
  return bits;
}

template <class T>
containment by_corners(const mat<R, 4, 4>& m, const box<T, 3>& b) {
  unsigned all = 63, any = 0;
  for (unsigned k = 0; k < 8; ++k) {
    const auto c = corner(b, k);
    unsigned bits;
    if constexpr (std::same_as<T, R>)
      bits = outside_bits(m, c);
    else
      bits = outside_bits(m, {R::of(c.x), R::of(c.y), R::of(c.z)});
    all &= bits, any |= bits;
  }
  return all ? outside : any ? crossing : inside;
}

mat<double, 4, 4> random_matrix(test::random& r, depth_range depth) {
  const P eye{4 * r.unit() - 2, 4 * r.unit() - 2, 4 * r.unit() - 2}, target{r.unit(), r.unit(), r.unit()};
  const auto view = irg::look_at(eye, target, irg::vec<double, 3>{r.unit(), 1, r.unit()});
  const double n = 0.1 + r.unit(), f = r.integer(0, 3) == 0 ? inf : n + 0.5 + 8 * r.unit();
  const irg::view_window<double> w{-r.unit() - 0.1, r.unit() + 0.1, -r.unit() - 0.1, r.unit() + 0.1};
  switch (r.integer(0, 2)) {
    case 0: return irg::perspective(w, 0.2 + r.unit(), n, f, depth) * view;
    case 1: return irg::orthographic(w, n - 2, n + 3, depth) * view;
    default: return irg::oblique(irg::oblique_depth<double>{6 * r.unit(), r.unit(), -2}, w, n - 2, n + 3, depth) * view;
  }
}

}  // namespace

TEST_CASE("frustum: by hand, in every life") {
  constexpr auto f = frustum_of(right_angle);
  CHECK_BOTH(f[frustum_plane::z_near] == plane<double>{0, 0, -1, -1});
  CHECK_BOTH(f[frustum_plane::z_far] == plane<double>{0, 0, 1, 5});
  CHECK_BOTH(f.planes[0] == f[frustum_plane::z_near]);
  CHECK_BOTH(f.planes[5] == f[frustum_plane::top]);
  const double h = std::sqrt(0.5);
  const auto near = [](const plane<double>& a, const plane<double>& b) {
    return std::abs(a.a - b.a) + std::abs(a.b - b.b) + std::abs(a.c - b.c) + std::abs(a.d - b.d) <= 1e-15;
  };
  CHECK(near(f[frustum_plane::left], {h, 0, -h, 0}));
  CHECK(near(f[frustum_plane::right], {-h, 0, -h, 0}));
  CHECK(near(f[frustum_plane::bottom], {0, h, -h, 0}));
  CHECK(near(f[frustum_plane::top], {0, -h, -h, 0}));
  // Near is near with the standard depth too.
  constexpr auto s =
      frustum_of(irg::perspective(irg::half_pi<double>, 1, 1, 5, depth_range::standard), depth_range::standard);
  CHECK(near(s[frustum_plane::z_near], f[frustum_plane::z_near]));
  CHECK(near(s[frustum_plane::z_far], f[frustum_plane::z_far]));
  CHECK_BOTH(classify(f, B{{-0.5, -0.5, -3}, {0.5, 0.5, -2}}) == inside);
  CHECK_BOTH(classify(f, B{{-0.5, -0.5, -3}, {0.5, 0.5, -0.5}}) == crossing);
  CHECK_BOTH(classify(f, B{{-0.5, -0.5, -0.5}, {0.5, 0.5, 2}}) == outside);
  CHECK_BOTH(classify(f, B{{4, -1, -3}, {5, 1, -2}}) == outside);
  CHECK_BOTH(classify(f, B{{-99, -99, -99}, {99, 99, 99}}) == crossing);
  CHECK_BOTH(classify(f, Ball{{0, 0, -3}, 1}) == inside);
  CHECK_BOTH(classify(f, Ball{{0, 0, -1}, 0.5}) == crossing);
  CHECK_BOTH(classify(f, Ball{{0, 0, 1}, 1.5}) == outside);
  CHECK_BOTH(classify(f, Ball{{10, 0, -3}, 1}) == outside);
  CHECK_BOTH(classify(f, P{0, 0, -2}) == inside);
  CHECK_BOTH(classify(f, P{0, 0, 2}) == outside);
}

TEST_CASE("frustum: corners by hand; of an infinite far plane, the directions of the edges") {
  constexpr auto c = frustum_corners(frustum_of(right_angle));
  static_assert(c.has_value());
  for (int k = 0; k < 8; ++k) {
    const double d = k & 4 ? 5 : 1;
    const auto q = c->at[k];
    CHECK(q.w == 1);
    CHECK(std::abs(q.x - (k & 1 ? d : -d)) + std::abs(q.y - (k & 2 ? d : -d)) + std::abs(q.z + d) <= 4e-15 * d);
  }
  for (const auto depth : {depth_range::reversed, depth_range::standard}) {
    const auto f = frustum_of(irg::perspective(irg::half_pi<double>, 1, 1, inf, depth), depth);
    CHECK(f[frustum_plane::z_far] == plane<double>{0, 0, 0, 1});
    const auto open = frustum_corners(f);
    REQUIRE(open);
    for (int k = 4; k < 8; ++k) {
      const auto q = open->at[k];
      CHECK(q.w == 0);
      CHECK((std::abs(q.x / -q.z - (k & 1 ? 1 : -1)) <= 4e-15 && std::abs(q.y / -q.z - (k & 2 ? 1 : -1)) <= 4e-15 &&
             q.z < 0));
    }
    CHECK(classify(f, B{{-1, -1, -1e9}, {1, 1, -2}}) == inside);
  }
  // In rationals, where normals keep their length.
  constexpr mat<R, 4, 4> m{{{1, 0, 0, 0}, {0, 2, 0, 0}, {0, 0, {1, 4}, {5, 4}}, {0, 0, -1, 0}}};
  constexpr auto exact = frustum_corners(frustum_of(m));
  CHECK_BOTH(exact->at[7] == hpoint<R, 3>{5, {5, 2}, -5, 1});
  CHECK_BOTH(exact->at[2] == hpoint<R, 3>{-1, {1, 2}, -1, 1});
}

TEST_CASE("frustum: corners are what the inverse of the matrix makes of those of clip space") {
  test::random r(12);
  int open = 0;
  for (int i = 0; i < 1500; ++i) {
    const auto depth = r.integer(0, 1) ? depth_range::reversed : depth_range::standard;
    const auto m = random_matrix(r, depth);
    const auto c = frustum_corners(frustum_of(m, depth));
    const auto back = inverse(m);
    REQUIRE((c.has_value() && back.has_value()));
    for (int k = 0; k < 8; ++k) {
      const double z = ((k & 4) != 0) == (depth == depth_range::standard) ? 1 : 0;
      const auto q = *back * hpoint<double, 3>{k & 1 ? 1.0 : -1.0, k & 2 ? 1.0 : -1.0, z, 1};
      open += c->at[k].w == 0 ? 1 : 0;
      if (c->at[k].w == 0)  // the same direction; the inverse may miss w = 0 by rounding
        CHECK(std::abs(dot(normalized(irg::vec<double, 3>{q.x, q.y, q.z}),
                           normalized(irg::vec<double, 3>{c->at[k].x, c->at[k].y, c->at[k].z})) -
                       1) <= 1e-12);
      else
        CHECK(length(to_cartesian(q) - to_cartesian(c->at[k])) <= 1e-11 * (1 + length(to_vec(to_cartesian(q)))));
    }
  }
  CHECK(open > 100);
}

TEST_CASE("frustum: boxes in rationals are exactly what their corners say, plane by plane") {
  test::random r(13);
  int count[3] = {};
  for (int i = 0; i < 3000; ++i) {
    mat<R, 4, 4> m;
    for (auto& row : m.m)
      for (R& entry : row) entry = R(r.integer(-4, 4));
    const auto n = [&] { return R{r.integer(-6, 6), 2}; };
    const box<R, 3> b = bounding_box(box<R, 3>{}, point<R, 3>{n(), n(), n()});
    const box<R, 3> around = bounding_box(b, point<R, 3>{n(), n(), n()});
    const containment side = classify(frustum_of(m), around);
    ++count[static_cast<int>(side)];
    CHECK(side == by_corners(m, around));
    CHECK(classify(frustum_of(m), b.low) == by_corners(m, b));
  }
  for (const int n : count) CHECK(n > 10);
}

TEST_CASE("frustum: boxes and balls in floats err on the safe side, and seldom; every vertex has the clip code") {
  test::random r(14);
  int undecided = 0, count[3] = {};
  for (int i = 0; i < 4000; ++i) {
    const auto depth = r.integer(0, 1) ? depth_range::reversed : depth_range::standard;
    const auto m = random_matrix(r, depth);
    const auto f = frustum_of(m, depth);
    const auto exactly = [&](const P& p, int k) {  // the value of plane k, in long double
      long double q[4];
      for (int row = 0; row < 4; ++row) {
        q[row] = static_cast<long double>(m(row, 3));
        for (int c = 0; c < 3; ++c) q[row] += static_cast<long double>(m(row, c)) * static_cast<long double>(p[c]);
      }
      const bool upper = (k == 0) == (depth == depth_range::reversed);
      if (k < 2) return upper ? q[3] - q[2] : q[2];
      return k % 2 ? q[3] - q[(k - 2) / 2] : q[3] + q[(k - 2) / 2];
    };
    const double size = std::pow(10.0, -3 + 4 * r.unit());
    // A third of the boxes touch a plane as nearly as doubles can.
    const P middle{6 * r.unit() - 3, 6 * r.unit() - 3, 6 * r.unit() - 3};
    B b{middle, {middle.x + size * r.unit(), middle.y + size * r.unit(), middle.z + size * r.unit()}};
    if (r.integer(0, 2) == 0) {
      const auto& p = f.planes[r.integer(0, 5)];
      if (std::abs(p.a) > 0.1) {
        const double x = (p.b < 0 ? b.low.y : b.high.y) * p.b + (p.c < 0 ? b.low.z : b.high.z) * p.c + p.d;
        const double to = -x / p.a, width = b.high.x - b.low.x;
        b.low.x = p.a < 0 ? to : to - width, b.high.x = p.a < 0 ? to + width : to;
      }
    }
    const containment side = classify(f, b);
    ++count[static_cast<int>(side)];
    bool out[6], all_in = true, any_out = false;
    for (int k = 0; k < 6; ++k) {
      out[k] = true;
      for (unsigned c = 0; c < 8; ++c) {
        const long double v = exactly(corner(b, c), k);
        out[k] = out[k] && v < 0;
        all_in = all_in && v >= 0;
      }
      any_out = any_out || out[k];
    }
    if (side == outside) {
      CHECK(any_out);
      irg::clip_planes common = irg::clip_planes::all;
      for (int n = 0; n < 20; ++n) {
        const P p{b.low.x + (b.high.x - b.low.x) * r.unit(), b.low.y + (b.high.y - b.low.y) * r.unit(),
                  b.low.z + (b.high.z - b.low.z) * r.unit()};
        common = common & clip_code(m * (n < 8 ? corner(b, static_cast<unsigned>(n)) : p));
      }
      CHECK(common != irg::clip_planes::none);
    }
    if (side == inside) {
      CHECK(all_in);
      for (unsigned c = 0; c < 8; ++c) CHECK(clip_code(m * corner(b, c)) == irg::clip_planes::none);
    }
    if (side == crossing && (any_out || all_in)) ++undecided;

    const Ball ball{middle, size * r.unit()};
    const containment round = classify(f, ball);
    bool ball_out = false, ball_in = true;
    for (int k = 0; k < 6; ++k) {
      const auto row = [&](int c) {  // the normal of plane k
        const long double zero = exactly({0, 0, 0}, k);
        P unit{};
        unit[c] = 1;
        return exactly(unit, k) - zero;
      };
      const long double normal = std::sqrt(row(0) * row(0) + row(1) * row(1) + row(2) * row(2));
      const long double v = exactly(ball.centre, k), reach = static_cast<long double>(ball.radius) * normal;
      ball_out = ball_out || v < -reach;
      ball_in = ball_in && v >= reach;
    }
    if (round == outside) CHECK(ball_out);
    if (round == inside) CHECK(ball_in);
    undecided += round == crossing && (ball_out || ball_in) ? 1 : 0;
  }
  CHECK(count[static_cast<int>(outside)] > 500);
  CHECK(count[static_cast<int>(inside)] > 100);
  CHECK(count[static_cast<int>(crossing)] > 300);
  CHECK(undecided <= 200);
}

TEST_CASE("frustum: what has a point in common with it is never called outside (brute force over points inside)") {
  test::random r(15);
  for (int i = 0; i < 400; ++i) {
    const auto depth = r.integer(0, 1) ? depth_range::reversed : depth_range::standard;
    const auto m = random_matrix(r, depth);
    const auto f = frustum_of(m, depth);
    const auto back = inverse(m);
    REQUIRE(back);
    for (int n = 0; n < 20; ++n) {
      const P q =
          to_cartesian(*back * hpoint<double, 3>{2 * r.unit() - 1, 2 * r.unit() - 1, 0.001 + 0.99 * r.unit(), 1});
      if (clip_code(m * q) != irg::clip_planes::none) continue;
      const double a = r.unit(), b = r.unit();
      CHECK(classify(f, B{{q.x - a, q.y - b, q.z - 1}, {q.x + b, q.y, q.z + a}}) != outside);
      CHECK(classify(f, Ball{{q.x + a, q.y, q.z}, a}) != outside);
      CHECK(classify(f, q) != outside);
    }
  }
}

TEST_CASE("frustum: hostile input") {
  constexpr auto f = frustum_of(right_angle);
  CHECK_BOTH(classify(f, B{}) == outside);  // empty
  CHECK_BOTH(classify(f, B{{1, 0, -2}, {0, 0, -2}}) == outside);
  CHECK_BOTH(classify(f, B{{not_a_number, 0, -2}, {0, 0, -2}}) == outside);  // holds no point either
  CHECK_BOTH(classify(f, Ball{{0, 0, -2}, -1}) == outside);
  CHECK(classify(f, Ball{{0, 0, -2}, not_a_number}) == crossing);
  CHECK(classify(f, Ball{{0, not_a_number, -2}, 1}) == crossing);
  CHECK(classify(f, P{0, not_a_number, -2}) == crossing);
  CHECK(classify(f, B{{-inf, -inf, -inf}, {inf, inf, inf}}) == crossing);
  CHECK(classify(f, B{{-1, -1, -2}, {inf, 1, -2}}) == crossing);
  CHECK(classify(f, Ball{{0, 0, -2}, inf}) == crossing);
  CHECK(classify(f, Ball{{0, 0, 1e308}, 1}) == outside);
  CHECK(classify(f, Ball{{0, 0, -2}, 0}) == inside);
  auto broken = right_angle;
  broken(0, 0) = not_a_number;
  const auto unknown = frustum_of(broken);
  CHECK(unknown[frustum_plane::left] == plane<double>{0, 0, 0, 0});
  CHECK(classify(unknown, B{{-0.1, -0.1, -3}, {0.1, 0.1, -2}}) == crossing);
  CHECK(classify(unknown, B{{-0.1, -0.1, 3}, {0.1, 0.1, 4}}) == outside);  // the other planes still count
  CHECK(!frustum_corners(unknown));
  CHECK(!frustum_corners(frustum_of(mat<double, 4, 4>{})));
  CHECK(classify(frustum_of(mat<double, 4, 4>{}), P{0, 0, 0}) == crossing);
  CHECK(!frustum_corners(frustum_of(irg::identity_matrix<double, 4>() * 0.0)));
  // Entries from one end of the range to the other.
  const auto tiny = frustum_of(right_angle * 0x1p-1000), huge = frustum_of(right_angle * 0x1p1000);
  for (int k = 0; k < 6; ++k) CHECK((tiny.planes[k] == f.planes[k] && huge.planes[k] == f.planes[k]));
  // A far plane next to the largest number, and one beyond it when its normal has length 1.
  for (const double z_near : {0.1, 1e306}) {
    const auto deep = frustum_of(irg::perspective(1.0, 1.0, z_near, 1e308));
    CHECK(std::abs(deep[frustum_plane::z_far].d / 1e308 - 1) <= 1e-12);
    const auto ends = frustum_corners(deep);
    CHECK((ends && std::abs(ends->at[7].z / -1e308 - 1) <= 1e-12));
  }
  const mat<double, 4, 4> beyond{{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1e-300, 1e10}, {0, 0, -1, 0}}};
  CHECK(frustum_of(beyond)[frustum_plane::z_far] == plane<double>{0, 0, 0, 0});
  constexpr auto at_compile_time = frustum_of(irg::perspective(0.7f, 1.5f, 0.1f, 10.0f));
  volatile float angle = 0.7f;
  CHECK(frustum_of(irg::perspective<float>(angle, 1.5f, 0.1f, 10.0f)) == at_compile_time);
}

TEST_CASE("classify: clip coordinates that vanish have no codes, the planes know") {
  irg::mat<float, 4, 4> m{};
  m(0, 0) = m(1, 1) = m(3, 2) = 0x1p-100f;
  const irg::point<float, 3> p{-0x1p-60f, 0, 0x1p-61f};
  CHECK(classify(irg::frustum_of(m), p) == irg::containment::outside);
  CHECK(m * irg::hpoint<float, 3>{p.x, p.y, p.z, 1} == irg::hpoint<float, 3>{0, 0, 0, 0});
}

TEST_CASE("frustum: the weights are the absolute values that each coefficient was added up from") {
  const mat<R, 4, 4> m{{{R(1), R(-2), R(3), R(-4)},
                        {R(5), R(6), R(-7), R(-8)},
                        {R(-9), R(10), R(11), R(12)},
                        {R(13), R(-14), R(-15), R(16)}}};
  for (const auto depth : {depth_range::reversed, depth_range::standard}) {
    const frustum<R> f = frustum_of(m, depth);
    const bool reversed = depth == depth_range::reversed;
    CHECK(f.weights[static_cast<int>(reversed ? frustum_plane::z_near : frustum_plane::z_far)] ==
          plane<R>{R(22), R(24), R(26), R(28)});
    CHECK(f.weights[static_cast<int>(reversed ? frustum_plane::z_far : frustum_plane::z_near)] ==
          plane<R>{R(9), R(10), R(11), R(12)});
    for (const auto side : {frustum_plane::left, frustum_plane::right})
      CHECK(f.weights[static_cast<int>(side)] == plane<R>{R(14), R(16), R(18), R(20)});
    for (const auto side : {frustum_plane::bottom, frustum_plane::top})
      CHECK(f.weights[static_cast<int>(side)] == plane<R>{R(18), R(20), R(22), R(24)});
  }
}
