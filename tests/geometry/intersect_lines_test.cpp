// SPDX-License-Identifier: MIT
#include <irg/geometry/intersect_lines.hpp>

#include <array>
#include <cstdint>
#include <limits>
#include <type_traits>

#include "support/check_both.hpp"
#include "support/exact.hpp"
#include "support/rational.hpp"

using irg::flat_relation;
using irg::intersect_lines;
using irg::parametric_line;
using irg::point;
using test::rational;

namespace {

using P2 = point<double, 2>;
using P3 = point<double, 3>;
using Q3 = point<rational, 3>;
constexpr double undefined_number = std::numeric_limits<double>::quiet_NaN(),
                 huge = (std::numeric_limits<double>::max)();
constexpr rational half(1, 2);

template <class P>
constexpr bool crosses(const irg::lines_meeting<P>& m, const P& at, const irg::scalar_of<P>& t,
                       const irg::scalar_of<P>& s) {
  return m.relation == flat_relation::crossing && m.at == at && m.t == t && m.s == s;
}

// Hank's six pairs of lines.
template <class P>
constexpr std::array<P, 4> pairs[6] = {
    {P{0, 0, 0}, P{2, 2, 2}, P{2, 0, 0}, P{0, 2, 2}}, {P{0, 0, 0}, P{1, 0, 0}, P{0, 1, 1}, P{0, 1, 2}},
    {P{0, 0, 0}, P{0, 1, 1}, P{0, 0, 1}, P{0, 1, 0}}, {P{0, 0, 0}, P{1, 1, 0}, P{0, 0, 1}, P{1, 1, 1}},
    {P{0, 0, 0}, P{1, 1, 1}, P{2, 2, 2}, P{3, 3, 3}}, {P{0, 0, 0}, P{1, 1, 1}, P{3, 0, 3}, P{0, 3, 3}}};
constexpr flat_relation relations[6] = {flat_relation::crossing, flat_relation::skew,       flat_relation::crossing,
                                        flat_relation::parallel, flat_relation::coincident, flat_relation::skew};

template <class P>
constexpr auto meeting(const std::array<P, 4>& p) {
  return intersect_lines(p[0], p[1], p[2], p[3]);
}
template <class P>
constexpr bool relations_hold() {
  for (int i = 0; i < 6; ++i)
    if (meeting(pairs<P>[i]).relation != relations[i]) return false;
  return true;
}

}  // namespace

// Points of integers: the relation exactly, the place in doubles.
static_assert([] {
  using P = irg::point<int, 2>;
  constexpr int most = 2147483647;
  const auto m = irg::intersect_lines(P{0, 0}, P{3, 3}, P{0, 1}, P{1, 0});
  return m.relation == irg::flat_relation::crossing && m.at == irg::point<double, 2>{0.5, 0.5} &&
         irg::intersect_lines(P{-most, -most}, P{most, most - 1}, P{-most, -most + 1}, P{most, most}).relation ==
             irg::flat_relation::parallel;
}());
// 64 bits too, to the ends of the range: the difference of the directions is lost in doubles.
static_assert([] {
  using P = irg::point<long long, 2>;
  constexpr long long most = (std::numeric_limits<long long>::max)(), least = -most - 1;
  const auto m = irg::intersect_lines(P{least, least}, P{most, most - 1}, P{least, least}, P{most, most});
  return m.relation == irg::flat_relation::crossing && m.at == irg::point<double, 2>{-0x1p63, -0x1p63} && m.t == 0 &&
         irg::intersect_lines(P{least, least}, P{most, most}, P{0, 0}, P{most, most}).relation ==
             irg::flat_relation::coincident &&
         irg::intersect_lines(P{least, least}, P{most, most}, P{0, 1}, P{most - 1, most}).relation ==
             irg::flat_relation::parallel;
}());

TEST_CASE("intersect_lines: what comes out is a value") {
  constexpr irg::lines_meeting<P2> m{flat_relation::crossing, {1, 2}, 0.5, 0.25},
      other{flat_relation::crossing, {1, 3}, 0.5, 0.25};
  CHECK_BOTH((m == m && !(m == other) &&
              irg::lines_meeting<std::array<double, 2>>{} == irg::lines_meeting<std::array<double, 2>>{}));
}

TEST_CASE("intersect_lines: Hank's values") {
  CHECK_BOTH(relations_hold<P3>());
  CHECK_BOTH(relations_hold<Q3>());
  CHECK(relations_hold<point<float, 3>>());
  CHECK_BOTH(crosses(meeting(pairs<Q3>[0]), {1, 1, 1}, half, half));
  CHECK_BOTH(crosses(meeting(pairs<Q3>[2]), {0, half, half}, half, half));
  CHECK_BOTH(crosses(meeting(pairs<P3>[2]), {0, 0.5, 0.5}, 0.5, 0.5));
}

TEST_CASE("intersect_lines: the plane") {
  CHECK_BOTH(crosses(intersect_lines(P2{0, 0}, P2{1, 1}, P2{4, 0}, P2{0, 4}), {2, 2}, 2, 0.5));
  CHECK_BOTH(intersect_lines(P2{0, 0}, P2{1, 1}, P2{1, 0}, P2{3, 2}).relation == flat_relation::parallel);
  CHECK_BOTH(intersect_lines(P2{0, 0}, P2{1, 1}, P2{7, 7}, P2{3, 3}).relation == flat_relation::coincident);
  CHECK_BOTH(crosses(intersect_lines(parametric_line<double, 2>{{0, 0}, {2, 0}}, {{1, 3}, {0, -1}}), {1, 0}, 0.5, 3));
  CHECK_BOTH(crosses(intersect_lines(parametric_line<rational, 3>{{0, 0, 1}, {2, 0, 0}}, {{1, 3, 1}, {0, -1, 0}}),
                     {1, 0, 1}, half, 3));
}

TEST_CASE("intersect_lines: bad input and the ends of the range") {
  CHECK_BOTH(intersect_lines(P2{1, 1}, P2{1, 1}, P2{0, 0}, P2{2, 2}).relation == flat_relation::none);
  CHECK_BOTH(intersect_lines(P3{1, 1, 1}, P3{0, 0, 0}, P3{2, 0, 0}, P3{2, 0, 0}).relation == flat_relation::none);
  CHECK_BOTH(intersect_lines(P2{undefined_number, 1}, P2{1, 2}, P2{0, 0}, P2{2, 2}).relation == flat_relation::none);
  CHECK_BOTH(
      intersect_lines(P2{0, 1}, P2{1, 2}, P2{0, 0}, P2{huge * 1, std::numeric_limits<double>::infinity()}).relation ==
      flat_relation::none);
  CHECK_BOTH(intersect_lines(parametric_line<double, 3>{{0, 0, 0}, {0, 0, 0}}, {{1, 0, 0}, {1, 0, 0}}).relation ==
             flat_relation::none);
  CHECK_BOTH(
      crosses(intersect_lines(P2{-huge, -huge}, P2{huge, huge}, P2{-huge, huge}, P2{huge, -huge}), {0, 0}, 0.5, 0.5));
  CHECK_BOTH(
      crosses(intersect_lines(P2{0, 0}, P2{5e-324, 5e-324}, P2{0, 1e-323}, P2{1e-323, 0}), {5e-324, 5e-324}, 1, 0.5));
  // Nearly parallel, one ulp apart: decided and placed all the same.
  CHECK_BOTH(crosses(intersect_lines(P2{0, 0}, P2{1, 1}, P2{0, 0}, P2{1, 1 + 0x1p-52}), {0, 0}, 0, 0));
  CHECK_BOTH(intersect_lines(P2{0, 0}, P2{1, 1}, P2{0, 0x1p-1074}, P2{1, 1 + 0x1p-52}).at ==
             P2{-0x1p-1022, -0x1p-1022});
}

#ifdef IRG_HAVE_MPFR
namespace {

using E = test::exact;
template <int N>
using EV = std::array<E, static_cast<std::size_t>(N)>;

template <class T, int N>
EV<N> exactly(const point<T, N>& p) {
  EV<N> e;
  for (int i = 0; i < N; ++i) {
    if constexpr (sizeof(T) == 8 && std::is_integral_v<T>) {  // in two parts that doubles hold
      const T high = p[i] >> 32, low = p[i] & T(0xffffffff);
      e[static_cast<std::size_t>(i)] = E(static_cast<double>(high)) * E(0x1p32) + E(static_cast<double>(low));
    } else {
      e[static_cast<std::size_t>(i)] = E(static_cast<double>(p[i]));
    }
  }
  return e;
}

// An oracle by elimination: unknowns t and s of a + t u = c + s v, one equation per coordinate.
template <int N>
struct oracle {
  flat_relation relation = flat_relation::none;
  E t, s;
  EV<N> at;
  oracle(EV<N> a, EV<N> b, EV<N> c, EV<N> d) {
    E m[3][3];
    for (std::size_t i = 0; i < a.size(); ++i) m[i][0] = b[i] - a[i], m[i][1] = c[i] - d[i], m[i][2] = c[i] - a[i];
    int rank = 0;
    for (int column = 0; column < 2; ++column)
      for (int row = rank; row < N; ++row) {
        if (m[row][column].sign() == 0) continue;
        for (int k = 0; k < 3; ++k) std::swap(m[row][k], m[rank][k]);
        for (int other = 0; other < N; ++other) {
          if (other == rank || m[other][column].sign() == 0) continue;
          const E f = m[other][column] / m[rank][column];
          for (int k = 0; k < 3; ++k) m[other][k] = m[other][k] - f * m[rank][k];
        }
        ++rank;
        break;
      }
    bool solvable = true;
    for (int row = rank; row < N; ++row) solvable = solvable && m[row][2].sign() == 0;
    if (a == b || c == d) return;
    if (rank < 2) {
      relation = solvable ? flat_relation::coincident : flat_relation::parallel;
      return;
    }
    relation = solvable ? flat_relation::crossing : flat_relation::skew;
    if (!solvable) return;
    t = m[0][2] / m[0][0], s = m[1][2] / m[1][1];
    for (std::size_t i = 0; i < a.size(); ++i) at[i] = a[i] + t * (b[i] - a[i]);
  }
};

struct tally {
  int wrong = 0, crossings = 0, others = 0;
  double worst = 0;
};

template <class T, int N>
void compare(const point<T, N> (&p)[4], tally& sum) {
  const auto got = intersect_lines(p[0], p[1], p[2], p[3]);
  const oracle<N> want(exactly(p[0]), exactly(p[1]), exactly(p[2]), exactly(p[3]));
  if (got.relation != want.relation) ++sum.wrong;
  if (want.relation != flat_relation::crossing) {
    ++sum.others;
    return;
  }
  ++sum.crossings;
  double worst = std::fmax(test::error_in_ulp(got.t, want.t), test::error_in_ulp(got.s, want.s));
  for (int i = 0; i < N; ++i)
    worst = std::fmax(worst, test::error_in_ulp(got.at[i], want.at[static_cast<std::size_t>(i)]));
  sum.worst = std::fmax(sum.worst, worst);
}

// Integers of all sizes up to the ends of the range, nearly parallel, parallel and with common points.
template <class T, int N>
tally run_integers(int count) {
  test::random r(8);
  tally sum;
  for (int i = 0; i < test::trials(count); ++i) {
    const int dropped = static_cast<int>(r.next() % (8 * sizeof(T)));
    point<T, N> p[4];
    for (auto& q : p)
      for (int k = 0; k < N; ++k) q[k] = static_cast<T>(r.next()) >> (i % 2 == 0 ? 2 : dropped);
    for (int k = 0; k < N; ++k) {
      if (i % 8 == 2) p[3][k] = static_cast<T>(p[2][k] / 2 + p[1][k] / 2 - p[0][k] / 2);  // at times parallel
      if (i % 8 == 4) p[2][k] = p[1][k];
      if (i % 8 == 6) p[3][k] = static_cast<T>(p[1][k] + (k == 0)), p[2][k] = p[0][k];  // off by one
    }
    if (i % 3 == 0 && N == 3)
      for (auto& q : p) q[2] = T(7);
    if (i % 16 == 8)
      for (int k = 0; k < N; ++k) {  // one line: all four are multiples of the first
        const T step = static_cast<T>(p[0][k] / 8);
        for (int q = 0; q < 4; ++q) p[q][k] = static_cast<T>(step * (q * q - 3));
      }
    compare(p, sum);
  }
  return sum;
}

template <class T, int N>
tally run(int count) {
  test::random r(7);
  tally sum;
  for (const test::spread kind : test::all_spreads)
    for (int i = 0; i < test::trials(count); ++i) {
      point<T, N> p[4];
      for (auto& q : p)
        for (int k = 0; k < N; ++k) q[k] = test::any_coordinate<T>(r, kind);
      if (i % 4 == 1) p[3] = point<T, N>{p[2] + (p[1] - p[0])};  // parallel, but for rounding
      if (i % 4 == 2) p[2] = p[i % 8 == 2 ? 0 : 1];              // a common point
      if (i % 4 == 3 && N == 3)
        for (auto& q : p) q[2] = T(0);  // a common plane
      bool finite = true;
      for (const auto& q : p)
        for (int k = 0; k < N; ++k) finite = finite && std::isfinite(q[k]);
      if (finite) compare(p, sum);
    }
  return sum;
}

}  // namespace

TEST_CASE("intersect_lines: relations and positions against rationals, all magnitudes") {
  for (const tally& sum : {run<double, 2>(300), run<double, 3>(300), run<float, 2>(200), run<float, 3>(200)}) {
    MESSAGE(sum.crossings, " crossings, ", sum.others, " others, worst ", sum.worst, " ulp");
    CHECK(sum.wrong == 0);
    CHECK(sum.worst <= 0.501);
    CHECK(sum.crossings > 200);
    CHECK(sum.others > 100);
  }
}

TEST_CASE("intersect_lines: integers of 32 and 64 bits against rationals, to the ends of the range") {
  using big = std::int64_t;
  for (const tally& sum : {run_integers<int, 2>(1000), run_integers<int, 3>(1000), run_integers<big, 2>(1000),
                           run_integers<big, 3>(1000)}) {
    MESSAGE(sum.crossings, " crossings, ", sum.others, " others, worst ", sum.worst, " ulp");
    CHECK(sum.wrong == 0);
    CHECK(sum.worst <= 0.501);
    CHECK(sum.crossings > 200);
    CHECK(sum.others > 50);
  }
}
#endif
