// SPDX-License-Identifier: MIT
#include <irg/geometry/sphere.hpp>

#include <limits>

#include "geometry/mixed_cases.hpp"
#include "geometry/nearest_cases.hpp"
#include "support/check_both.hpp"

using irg::bounding_sphere;
using irg::box;
using irg::box_boundary;
using irg::contains;
using irg::overlap;
using irg::plane;
using irg::point;
using irg::side;
using irg::side_of;
using irg::sphere_through;

namespace {

using P2 = point<double, 2>;
using P3 = point<double, 3>;
using C = bounding_sphere<double, 2>;
using S = bounding_sphere<double, 3>;
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double huge = (std::numeric_limits<double>::max)();
constexpr auto open = box_boundary::open;

}  // namespace

TEST_CASE("sphere_through: by hand") {
  CHECK_BOTH(sphere_through(P2{0, 0}, P2{6, 8}) == C{{3, 4}, 5});
  CHECK_BOTH(sphere_through(P2{0, 0}, P2{6, 0}, P2{0, 8}) == C{{3, 4}, 5});
  CHECK_BOTH(sphere_through(P2{0, 0}, P2{0, 8}, P2{6, 0}) == C{{3, 4}, 5});
  CHECK_BOTH(sphere_through(P3{0, 0, 7}, P3{6, 0, 7}, P3{0, 8, 7}) == S{{3, 4, 7}, 5});
  CHECK_BOTH(sphere_through(P3{5, 0, 0}, P3{-5, 0, 0}, P3{0, 3, 4}, P3{0, 0, -5}) == S{{0, 0, 0}, 5});
  CHECK_BOTH(!sphere_through(P2{1, 2}, P2{1, 2}));
  CHECK_BOTH(!sphere_through(P2{0, 0}, P2{1, 1}, P2{2, 2}));
  CHECK_BOTH(!sphere_through(P3{0, 0, 0}, P3{1, 1, 0}, P3{2, 5, 0}, P3{3, 3, 0}));
  CHECK_BOTH(!sphere_through(P2{0, 0}, P2{1, not_a_number}, P2{2, 2}));
  CHECK_BOTH(sphere_through(P2{-huge, 0}, P2{huge, 0}) == C{{0, 0}, huge});
  CHECK_BOTH(sphere_through(P2{0, 0}, P2{1, 0}, P2{2, 0x1p-52})->radius > 0x1p51);
}

TEST_CASE("sphere: against points, spheres, boxes and planes") {
  constexpr S s{{0, 0, 0}, 5};
  CHECK_BOTH(contains(s, P3{0, 3, 4}));
  CHECK_BOTH(!contains(s, P3{5e-324, 3, 4}));
  CHECK_BOTH(!contains(S{{0, 0, 0}, -1}, P3{0, 0, 0}));
  CHECK_BOTH(contains(S{{0, 0, 0}, 0}, P3{0, 0, 0}));
  CHECK_BOTH(!contains(s, P3{0, not_a_number, 4}));
  CHECK_BOTH(overlap(C{{0, 0}, 2}, C{{3, 4}, 3}));
  CHECK_BOTH(!overlap(C{{0, 0}, 2}, C{{3, 4}, 3}, open));
  CHECK_BOTH(!overlap(C{{0, 0}, 2}, C{{3, 4 + 0x1p-50}, 3}));
  CHECK_BOTH(!overlap(C{{0, 0}, 2}, C{{3, 4}, not_a_number}));
  CHECK_BOTH(overlap(C{{-huge, 0}, huge}, C{{huge, 0}, huge}));
  CHECK_BOTH(!overlap(C{{-huge, 0}, huge}, C{{huge, 0}, huge}, open));
  CHECK_BOTH(overlap(C{{4, 5}, 5}, box<double, 2>{{-3, -3}, {0, 2}}));
  CHECK_BOTH(!overlap(C{{4, 5}, 5}, box<double, 2>{{-3, -3}, {0, 2}}, open));
  CHECK_BOTH(!overlap(C{{4, 5}, 5}, box<double, 2>{}));
  CHECK_BOTH(overlap(C{{4, 5}, 0}, box<double, 2>{{3, 3}, {9, 9}}, box_boundary::closed));
  CHECK_BOTH(side_of(plane<double>{0, 0, 2, -12}, s) == side::below);
  CHECK_BOTH(side_of(plane<double>{0, 0, -2, 12}, s) == side::above);
  CHECK_BOTH(side_of(plane<double>{0, 0, 2, -10}, s) == side::on);
  CHECK_BOTH(side_of(plane<double>{3, 4, 0, -25}, s) == side::on);
  CHECK_BOTH(side_of(plane<double>{3, 4, 0, -25 - 0x1p-48}, s) == side::below);
  CHECK_BOTH(side_of(plane<double>{0, 0, 0, 9}, s) == side::on);
  CHECK_BOTH(side_of(plane<double>{0, not_a_number, 0, 9}, s) == side::on);
}

#ifdef IRG_HAVE_MPFR
namespace {

using test::exact;
using test::exactly;
using test::operator-;
using test::dot;

// The centre as the solution of linear equations: at equal distances from the points, and in their plane.
template <std::size_t D>
bool solve(exact (&m)[D][D + 1]) {
  for (std::size_t k = 0; k < D; ++k) {
    std::size_t pivot = k;
    while (pivot < D && m[pivot][k].sign() == 0) ++pivot;
    if (pivot == D) return false;
    for (std::size_t c = 0; c <= D; ++c) std::swap(m[k][c], m[pivot][c]);
    for (std::size_t r = 0; r < D; ++r) {
      if (r == k || m[r][k].sign() == 0) continue;
      const exact f = m[r][k] / m[k][k];
      for (std::size_t c = 0; c <= D; ++c) m[r][c] = m[r][c] - f * m[k][c];
    }
  }
  return true;
}

template <int N, int Count>
double run() {
  constexpr std::size_t D = static_cast<std::size_t>(N);
  test::random r(43);
  double worst = 0;
  int wrong = 0, some = 0;
  for (const test::spread kind : test::all_spreads)
    for (int i = 0; i < test::trials(kind == test::spread::any_bits || kind == test::spread::wide ? 20 : 80); ++i) {
      point<double, N> p[4];
      test::place<D> e[4];
      for (int k = 0; k < 4; ++k) {
        for (int l = 0; l < N; ++l) p[k][l] = test::any_coordinate<double>(r, kind);
        e[k] = exactly(p[k]);
      }
      const auto got = [&] {
        if constexpr (Count == 2) return sphere_through(p[0], p[1]);
        if constexpr (Count == 3) return sphere_through(p[0], p[1], p[2]);
        if constexpr (Count == 4) return sphere_through(p[0], p[1], p[2], p[3]);
      }();
      exact m[D][D + 1];
      for (int k = 1; k < Count; ++k) {
        const auto way = e[k] - e[0];
        for (std::size_t l = 0; l < D; ++l) m[k - 1][l] = exact(2) * way[l];
        m[k - 1][D] = dot(e[k], e[k]) - dot(e[0], e[0]);
      }
      if (Count == 2) {  // the middle
        for (std::size_t l = 0; l < D; ++l) {
          for (std::size_t c = 0; c < D; ++c) m[l][c] = exact(c == l ? 2 : 0);
          m[l][D] = e[0][l] + e[1][l];
        }
      }
      if constexpr (N == 3 && Count == 3) {
        const auto u = e[1] - e[0], v = e[2] - e[0];
        for (std::size_t l = 0; l < 3; ++l) m[2][l] = u[(l + 1) % 3] * v[(l + 2) % 3] - u[(l + 2) % 3] * v[(l + 1) % 3];
        m[2][3] = m[2][0] * e[0][0] + m[2][1] * e[0][1] + m[2][2] * e[0][2];
      }
      const bool exists = Count == 2 ? !(p[0] == p[1]) : true;
      const bool regular = solve(m) && exists;
      wrong += regular != got.has_value();
      if (!regular || !got) continue;
      ++some;
      test::place<D> centre;
      for (std::size_t l = 0; l < D; ++l) {
        centre[l] = m[l][D] / m[l][l];
        worst = std::fmax(worst, test::error_in_ulp(got->centre[static_cast<int>(l)], centre[l]));
      }
      worst = std::fmax(worst, test::root_error_in_ulp(got->radius, dot(centre - e[0], centre - e[0])));
    }
  CHECK(wrong == 0);
  CHECK(some > 50);
  return worst;
}

}  // namespace

TEST_CASE("sphere_through: half an ulp from the exact centre and radius, all magnitudes") {
  const double worst[] = {run<2, 2>(), run<2, 3>(), run<3, 2>(), run<3, 3>(), run<3, 4>()};
  for (const double w : worst) {
    MESSAGE("worst ", w, " ulp");
    CHECK(w <= 0.501);
  }
}

namespace {

using namespace test::mixed;

// The sphere through points that are not in general position otherwise, by the equations of its centre: 2 (p_i - p_0) x
// = |p_i|^2 - |p_0|^2, and in space for a circle that it lies in the plane of the three.
template <class T, int N, std::size_t Count>
double off_from_sphere(test::random& r, sizes which) {
  constexpr std::size_t D = static_cast<std::size_t>(N);
  const auto p = points<T, N, Count>(r, which);
  const auto got = [&] {
    if constexpr (Count == 2) return sphere_through(p[0], p[1]);
    if constexpr (Count == 3) return sphere_through(p[0], p[1], p[2]);
    if constexpr (Count == 4) return sphere_through(p[0], p[1], p[2], p[3]);
  }();
  const auto o = exactly(p[0]);
  place<D> over;  // the centre times whole
  E whole = 2;
  if constexpr (Count == 2) {
    const auto q = exactly(p[1]);
    for (std::size_t k = 0; k < D; ++k) over[k] = o[k] + q[k];
    if (p[0] == p[1]) whole = 0;
  } else {
    std::array<std::array<E, D>, D> rows;
    std::array<E, D> right, unit{};
    for (std::size_t i = 0; i + 1 < Count; ++i) {
      const auto q = exactly(p[i + 1]);
      for (std::size_t k = 0; k < D; ++k) rows[i][k] = (q[k] - o[k]) * 2;
      right[i] = dot(q, q) - dot(o, o);
    }
    if constexpr (N == 3 && Count == 3) rows[2] = minors(rows[0], rows[1]), right[2] = dot(rows[2], o);
    for (std::size_t i = 0; i < D; ++i) unit[i] = rows[i][0];
    whole = replaced(rows, unit, 0);
    for (std::size_t k = 0; k < D; ++k) over[k] = replaced(rows, right, k);
  }
  if (got.has_value() != (whole.sign() != 0)) return wrong;
  if (!got) return 0;
  double worst = 0;
  place<D> way;
  for (std::size_t k = 0; k < D; ++k) {
    worst = std::fmax(worst, quotient_error(got->centre[static_cast<int>(k)], over[k], whole));
    way[k] = over[k] - o[k] * whole;
  }
  return std::fmax(worst, root_error(got->radius, dot(way, way), whole * whole));
}

}  // namespace

TEST_CASE_TEMPLATE("sphere_through: numbers of all sizes", T, double, float) {
  sweep(named<T>("sphere_through, 2 points of the plane"), 0.501, off_from_sphere<T, 2, 2>, 1000);
  sweep(named<T>("sphere_through, 3 points of the plane"), 0.501, off_from_sphere<T, 2, 3>, 1000);
  sweep(named<T>("sphere_through, 2 points"), 0.501, off_from_sphere<T, 3, 2>, 1000);
  sweep(named<T>("sphere_through, 3 points"), 0.501, off_from_sphere<T, 3, 3>, 500);
  sweep(named<T>("sphere_through, 4 points"), 0.501, off_from_sphere<T, 3, 4>, 500);
}
#endif
