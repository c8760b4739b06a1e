// SPDX-License-Identifier: MIT
#include <irg/geometry/smallest_sphere.hpp>

#include <array>
#include <limits>
#include <cmath>
#include <vector>

#include "support/check_both.hpp"
#include "support/random.hpp"

using irg::bounding_sphere;
using irg::point;
using irg::smallest_sphere;

namespace {

using P2 = point<double, 2>;
using P3 = point<double, 3>;
using C = bounding_sphere<double, 2>;
using S = bounding_sphere<double, 3>;
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

template <int N>
bool holds_all(const bounding_sphere<double, N>& s, const std::vector<point<double, N>>& points, double slack) {
  double centre_off = 0;  // by what the centre's coordinates are rounded
  for (int k = 0; k < N; ++k) centre_off += std::fabs(s.centre[k]) * 0x1p-53;
  for (const auto& p : points)
    if (!contains(bounding_sphere<double, N>{s.centre, s.radius * (1 + slack) + centre_off}, p)) return false;
  return true;
}

// The least radius of all balls through two, three or four of the points that hold the others: slow, but independent of
// any order.
template <int N>
double least_radius(const std::vector<point<double, N>>& p) {
  double least = std::numeric_limits<double>::infinity();
  const auto consider = [&](const auto& s) {
    if (s && s->radius < least && holds_all<N>(*s, p, 0x1p-48)) least = s->radius;
  };
  const std::size_t n = p.size();
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < i; ++j) {
      consider(sphere_through(p[i], p[j]));
      for (std::size_t k = 0; k < j; ++k) {
        consider(sphere_through(p[i], p[j], p[k]));
        if constexpr (N == 3)
          for (std::size_t l = 0; l < k; ++l) consider(sphere_through(p[i], p[j], p[k], p[l]));
      }
    }
  return least;
}

template <int N>
void run(bool lattice) {
  test::random r(47);
  int wrong = 0;
  for (int i = 0; i < 60; ++i) {
    std::vector<point<double, N>> points(static_cast<std::size_t>(r.integer(2, N == 2 ? 12 : 8)), point<double, N>{});
    for (auto& p : points)
      for (int k = 0; k < N; ++k) p[k] = lattice ? static_cast<double>(r.integer(0, 2)) : r.unit();
    const auto s = smallest_sphere(points);
    wrong += !s || !holds_all<N>(*s, points, 0x1p-50);
    const double least = least_radius<N>(points);
    const bool is_point = s && s->radius == 0 && least == std::numeric_limits<double>::infinity();
    wrong += !(is_point || std::fabs(s->radius - least) <= 0x1p-48 * least);
  }
  CHECK(wrong == 0);
}

}  // namespace

TEST_CASE("smallest_sphere: by hand") {
  CHECK_BOTH(smallest_sphere(std::array{P2{0, 0}, P2{6, 0}, P2{0, 8}}) == C{{3, 4}, 5});
  CHECK_BOTH(smallest_sphere(std::array{P2{0, 0}, P2{3, 1}, P2{6, 0}, P2{3, 0}}) == C{{3, 0}, 3});
  CHECK_BOTH(smallest_sphere(std::array{P2{2, 2}, P2{0, 0}, P2{1, 1}}) ==
             smallest_sphere(std::array{P2{0, 0}, P2{2, 2}}));
  CHECK_BOTH(smallest_sphere(std::array{P2{7, 7}}) == C{{7, 7}, 0});
  CHECK_BOTH(smallest_sphere(std::array{P2{7, 7}, P2{7, 7}, P2{7, 7}}) == C{{7, 7}, 0});
  CHECK_BOTH(!smallest_sphere(std::array<P2, 0>{}));
  CHECK_BOTH(!smallest_sphere(std::array{P2{0, 0}, P2{6, not_a_number}}));
  // The corners of a cube rest on one sphere; so do four of its diagonal tetrahedron.
  CHECK_BOTH(smallest_sphere(std::array{P3{5, 0, 0}, P3{-5, 0, 0}, P3{0, 3, 4}, P3{0, 0, -5}, P3{1, 1, 1}}) ==
             S{{0, 0, 0}, 5});
  const std::vector<P3> cube{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {2, 2, 0}, {0, 0, 2}, {2, 0, 2}, {0, 2, 2}, {2, 2, 2}};
  CHECK(smallest_sphere(cube) == S{{1, 1, 1}, 1.7320508075688772});
}

TEST_CASE("smallest_sphere: no smaller one among all through two, three or four points") {
  run<2>(false);
  run<3>(false);
  run<2>(true);
  run<3>(true);
}

TEST_CASE("smallest_sphere: 2000 points on a circle") {
  std::vector<P2> points;
  for (int i = 0; i < 2000; ++i) points.push_back({3 + std::cos(i * 0.00314), 4 + std::sin(i * 0.00314)});
  const C s = *smallest_sphere(points);
  CHECK(std::fabs(s.radius - 1) < 1e-6);
  CHECK(holds_all<2>(s, points, 0x1p-50));
}
