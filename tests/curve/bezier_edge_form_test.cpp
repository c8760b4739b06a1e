// SPDX-License-Identifier: MIT
#include <irg/curve/bezier_edge_form.hpp>

#include <cmath>
#include <vector>

#include "support/check_both.hpp"
#include "support/exact.hpp"

using namespace irg;

namespace {

using P3 = point<double, 3>;
using V3 = vec<double, 3>;
constexpr std::array<P3, 4> course_polygon{P3{0, 0, 0}, P3{1, 3, 0}, P3{4, 3, 2}, P3{5, 0, 4}};
constexpr std::array<V3, 4> course_edges{V3{0, 0, 0}, V3{1, 3, 0}, V3{3, 0, 2}, V3{1, -3, 2}};

constexpr std::array<V3, 4> edges_by_irg() {
  std::array<V3, 4> e{};
  edges_of_control_polygon(course_polygon, e);
  return e;
}
constexpr std::array<P3, 4> polygon_by_irg() {
  std::array<P3, 4> p{};
  control_polygon_of_edges(course_edges, std::span<P3>(p));
  return p;
}
constexpr V3 by_edges(double t) {
  std::array<double, 4> weights{};
  return bezier_point_of_edges(course_edges, t, weights);
}

constexpr std::array<P3, 3> there_and_back() {
  constexpr std::array<P3, 3> away{P3{7, -2, 3}, P3{8, 5, 3}, P3{-1, 5, 0}};
  std::array<V3, 3> e{};
  edges_of_control_polygon(away, e);
  std::array<P3, 3> p{};
  control_polygon_of_edges(e, std::span<P3>(p));
  return p;
}

}  // namespace

TEST_CASE("bezier edge form: the course's edges and points, golden") {
  CHECK_BOTH(edges_by_irg() == course_edges);
  CHECK_BOTH(polygon_by_irg() == course_polygon);
  CHECK_BOTH(there_and_back() == std::array<P3, 3>{P3{7, -2, 3}, P3{8, 5, 3}, P3{-1, 5, 0}});
  CHECK_BOTH(by_edges(0) == V3{0, 0, 0});
  CHECK_BOTH(by_edges(0.25) == V3{17.0 / 16, 27.0 / 16, 11.0 / 32});
  CHECK_BOTH(by_edges(0.5) == V3{2.5, 2.25, 1.25});
  CHECK_BOTH(by_edges(0.75) == V3{63.0 / 16, 27.0 / 16, 81.0 / 32});
  CHECK_BOTH(by_edges(1) == V3{5, 0, 4});
  V3 sum{};
  for (int k = 0; k <= 100; ++k) sum += by_edges(k / 100.0);
  CHECK(sum.x == doctest::Approx(252.5).epsilon(1e-14));
  CHECK(sum.y == doctest::Approx(149.985).epsilon(1e-14));
  CHECK(sum.z == doctest::Approx(152.005).epsilon(1e-14));
}

TEST_CASE("bezier edge form: weights, golden and at the ends") {
  const double expected[] = {1, 19.0 / 27, 7.0 / 27, 1.0 / 27};
  for (int i = 0; i < 4; ++i) CHECK(bezier_weight(3, i, 1.0 / 3) == doctest::Approx(expected[i]).epsilon(1e-15));
  CHECK_BOTH((bezier_weight(0, 0, 0.0) == 1 && bezier_weight(5, -1, 0.25) == 1 && bezier_weight(5, 6, 0.25) == 0));
  CHECK_BOTH((bezier_weight(5, 1, 0.0) == 0 && bezier_weight(5, 5, 1.0) == 1 && bezier_weight(5, 1, 1.0) == 1));
  CHECK_BOTH(bezier_weight(3, 1, 0.5) == 0.875);
  std::array<double, 1> one{};
  bezier_weights<double>(0.3, one);
  CHECK(one[0] == 1);
}

TEST_CASE("bezier edge form: one point, and points that coincide") {
  const std::array<P3, 1> alone{P3{7, 8, 9}};
  std::array<V3, 1> edge{};
  std::array<double, 5> weights{};
  edges_of_control_polygon(alone, edge);
  CHECK(bezier_point_of_edges(edge, 0.7, weights) == V3{7, 8, 9});
  const std::array<P3, 5> same{P3{0.1, 2, 3}, P3{0.1, 2, 3}, P3{0.1, 2, 3}, P3{0.1, 2, 3}, P3{0.1, 2, 3}};
  std::array<V3, 5> edges{};
  edges_of_control_polygon(same, edges);
  for (const double t : {0.0, 1e-300, 0.3, 1.0}) CHECK(bezier_point_of_edges(edges, t, weights) == V3{0.1, 2, 3});
}

#ifdef IRG_HAVE_MPFR
namespace {

using test::exact;

/// f_{i,n}(t) by its definition: the sum of C(n, j) t^j (1-t)^(n-j) over j from i on.
exact weight_by_definition(int n, int i, double t) {
  exact sum(0), term(1);
  for (int k = 0; k < n; ++k) term = term * (exact(1) - exact(t));
  for (int j = 0; j <= n; ++j) {
    if (j > 0) term = term * exact(t) / (exact(1) - exact(t)) * exact(n - j + 1) / exact(j);
    if (j >= i) sum = sum + term;
  }
  return sum;
}

}  // namespace

TEST_CASE("bezier edge form: both ways to the weights against rationals") {
  test::random r(19);
  double worst_closed = 0, worst_recursive = 0;
  for (int k = 0; k < test::trials(60); ++k) {
    const int n = static_cast<int>(r.integer(1, 20)), i = static_cast<int>(r.integer(1, n));
    const double t = k % 7 == 0 ? std::ldexp(r.unit(), -30) : r.unit() * 0.999;
    const exact want = weight_by_definition(n, i, t);
    std::vector<double> all(static_cast<std::size_t>(n) + 1, 0.0);
    bezier_weights<double>(t, all);
    const double closed = test::distance(bezier_weight(n, i, t), want) / want.rounded() * 0x1p53 / n;
    const double recursive = test::distance(all[static_cast<std::size_t>(i)], want) / want.rounded() * 0x1p53 / n;
    worst_closed = std::max(worst_closed, closed), worst_recursive = std::max(worst_recursive, recursive);
  }
  MESSAGE("closed formula ", worst_closed, " n u, recursion ", worst_recursive, " n u");
  CHECK(worst_closed <= 6);
  CHECK(worst_recursive <= 3);
}
#endif
