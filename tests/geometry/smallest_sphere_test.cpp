// SPDX-License-Identifier: MIT
#include <irg/geometry/smallest_sphere.hpp>

#include <array>
#include <limits>
#include <cmath>
#include <cstdlib>
#include <utility>
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

namespace {

// Points of a ball of radius 1 about (c, c, c), rounded: a grid of meridians, or anywhere.
std::vector<P3> points_on_ball(int n, double c, bool grid) {
  test::random r(53);
  std::vector<P3> points;
  const int rows = static_cast<int>(std::sqrt(n / 2));
  for (int i = 0; i < n; ++i) {
    const double a = grid ? 3.14159265358979 * (i / (2 * rows)) / rows : std::acos(2 * r.unit() - 1);
    const double b = grid ? 3.14159265358979 * (i % (2 * rows)) / rows : 6.28318530717959 * r.unit();
    points.push_back({c + std::sin(a) * std::cos(b), c + std::sin(a) * std::sin(b), c + std::cos(a)});
  }
  return points;
}

// A ring that counts how often its points are read.
struct counted_ring {
  const std::vector<P3>* points;
  mutable std::size_t* reads;
  std::size_t size() const { return points->size(); }
  const P3& operator[](std::size_t i) const { return ++*reads, (*points)[i]; }
};

template <std::size_t... I>
void try_close(const std::vector<P3>& points, std::index_sequence<I...>, int& open, int& wrong) {
  const auto ball = irg::detail::close_ball_on(points[I * 7]...);
  for (const P3& p : points) {
    const int side = irg::detail::close_side(ball, p).side;
    open += side == 0;
    wrong += side != 0 && (side > 0) != irg::detail::is_outside(p, points[I * 7]...);
  }
}

}  // namespace

TEST_CASE("smallest_sphere: points on a ball up to rounding are told from it without an exact decision") {
  const int n = std::getenv("IRG_RELEASE_TIER") ? 1'000'000 : 3000;
  for (const double c : {0.0, 3.0, -1e6}) {
    const auto points = points_on_ball(n, c, false);
    int open = 0, wrong = 0;
    try_close(points, std::make_index_sequence<2>(), open, wrong);
    try_close(points, std::make_index_sequence<3>(), open, wrong);
    try_close(points, std::make_index_sequence<4>(), open, wrong);
    CHECK(wrong == 0);
    CHECK(open <= 30);  // the points that it rests on themselves, and few that lie on it exactly
  }
  // Away from the range that the bound is made for nothing is said.
  const auto far = irg::detail::close_ball_on(P3{0, 0, 0}, P3{0x1p300, 0, 0});
  CHECK(irg::detail::close_side(far, P3{1, 1, 1}).side == 0);
}

TEST_CASE("smallest_sphere: growth, passes over points on a ball up to rounding") {
  const int most = std::getenv("IRG_RELEASE_TIER") ? 1'000'000 : 10'000;
  for (const bool grid : {false, true})
    for (int n = 1000; n <= most; n *= 10) {
      const auto points = points_on_ball(n, 3, grid);
      std::size_t reads = 0;
      const S s = *smallest_sphere(counted_ring{&points, &reads});
      CHECK(reads <= 40 * points.size());
      CHECK(holds_all<3>(s, points, 0x1p-50));
    }
}
