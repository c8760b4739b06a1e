// SPDX-License-Identifier: MIT
#include <irg/curve/bezier_prepared.hpp>

#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include <irg/curve/bezier_accurate.hpp>
#include <irg/math/length.hpp>

#include "support/check_both.hpp"
#include "support/random.hpp"

namespace {

using P = irg::point<double, 3>;
constexpr double none = std::numeric_limits<double>::quiet_NaN();

constexpr P arch_at(double t) {
  constexpr std::array<P, 4> arch{P{0, 0, 1}, {1, 3, 2}, {4, 3, 5}, {5, 0, 7}};
  std::array<double, irg::prepared_bezier<P>::numbers_for(4)> space{};
  std::array<irg::exact_sum<double>, 4> sums{};
  return irg::bezier_point(*irg::prepare_bezier(arch, std::span<double>(space), sums), t);
}

// A curve ready for points, with the space that it refers to.
template <class Point>
struct ready {
  using T = irg::scalar_of<Point>;
  std::vector<T> space;
  std::vector<irg::exact_sum<T>> sums;
  std::optional<irg::prepared_bezier<Point>> curve;
  explicit ready(const std::vector<Point>& points)
      : space(irg::prepared_bezier<Point>::numbers_for(points.size())), sums(points.size()),
        curve(irg::prepare_bezier(points, std::span<T>(space), sums)) {}
};

template <class Point>
std::vector<Point> random_points(test::random& r, std::size_t count) {
  using T = irg::scalar_of<Point>;
  std::vector<Point> points(count);
  for (Point& p : points) p = irg::generate_coordinates<Point>([&](int) { return static_cast<T>(2 * r.unit() - 1); });
  return points;
}

}  // namespace

TEST_CASE("prepared Bezier curves: by hand, ends") {
  CHECK_BOTH(arch_at(0) == P{0, 0, 1});
  CHECK_BOTH(arch_at(1) == P{5, 0, 7});
  CHECK_BOTH(arch_at(0.5) == P{2.5, 2.25, 3.625});
  CHECK_BOTH(irg::length(arch_at(0.25) - P{1.0625, 1.6875, 2.078125}) < 1e-15);
}

TEST_CASE("prepared Bezier curves: the documented error; plain, in lanes and in batches the same bits") {
  test::random r(101);
  double worst = 0;
  for (const std::size_t degree : {0u, 1u, 2u, 3u, 4u, 7u, 10u, 13u, 20u, 30u, 50u, 130u}) {
    const auto points = random_points<P>(r, degree + 1);
    std::vector<double> t;
    t.reserve(361);
    const ready<P> kept(points);
    const auto curve = *kept.curve;
    CHECK(curve.degree() == degree);
    for (int k = 0; k < 200; ++k)
      t.push_back(k % 3 == 0 ? r.unit() : k % 3 == 1 ? r.unit() * 0.4 : 1 - r.unit() * 0x1p-20);
    for (int k = 0; k < 100; ++k) t.push_back(0.49 * r.unit() / 3);  // of which 1 - t is no double
    for (int k = 0; k < 61; ++k) t.push_back(k / 60.);
    std::vector<P> batch(t.size());
    irg::bezier_points(curve, t, std::span<P>(batch));
    std::vector<irg::exact_sum<double>> room(degree + 1);
    bool same = true;
    for (std::size_t k = 0; k < t.size(); ++k) {
      const P p = irg::bezier_point(curve, t[k]);
      same = same && p == irg::detail::prepared_point_plain<P>(curve, t[k]) && p == batch[k];
      const P want = irg::bezier_point_accurate(points, t[k], std::span<irg::exact_sum<double>>(room));
      for (int i = 0; i < 3; ++i) worst = std::fmax(worst, std::abs(p[i] - want[i]) * 0x1p53);
    }
    CHECK(same);
    MESSAGE("degree ", degree, ": ", worst, " u");
    CHECK(worst <= 3.5);
    worst = 0;
    CHECK(irg::bezier_point(curve, 0) == points.front());
    CHECK(irg::bezier_point(curve, 1) == points.back());
  }
}

TEST_CASE("prepared Bezier curves: floats, other dimensions, homogeneous points") {
  test::random r(102);
  const auto agree = [&]<class Point>(Point, double tolerance) {
    using T = irg::scalar_of<Point>;
    const auto points = random_points<Point>(r, 6);
    std::vector<T> t;
    t.reserve(101);
    std::vector<Point> room(6);
    const ready<Point> kept(points);
    const auto curve = *kept.curve;
    for (int k = 0; k <= 100; ++k) t.push_back(static_cast<T>(k) / 100);
    std::vector<Point> batch(t.size());
    irg::bezier_points(curve, t, std::span<Point>(batch));
    for (std::size_t k = 0; k < t.size(); ++k) {
      const Point want = irg::bezier_point(points, t[k], room), p = irg::bezier_point(curve, t[k]);
      CHECK(p == batch[k]);
      CHECK(p == irg::detail::prepared_point_plain<Point>(curve, t[k]));
      for (int i = 0; i < irg::size_of<Point>; ++i)
        CHECK(std::abs(static_cast<double>(irg::coordinate(p, i) - irg::coordinate(want, i))) < tolerance);
    }
  };
  agree(irg::point<float, 3>{}, 1e-6);
  agree(irg::point<float, 2>{}, 1e-6);
  agree(irg::point<double, 2>{}, 2e-15);
  agree(irg::vec<double, 4>{}, 2e-15);
  agree(irg::hpoint<double, 3>{}, 2e-15);
}

TEST_CASE("prepared Bezier curves: what cannot be prepared; t outside, NaN") {
  std::vector<P> points(4, P{1, 2, 3});
  for (const double bad : {none, 1e308, -1e299, -std::numeric_limits<double>::infinity()}) {
    points[2].y = bad;
    CHECK(!ready<P>(points).curve);
  }
  const auto huge = ready<P>({{1e297, 0, 0}, {-1e297, 1e-300, 0}});
  CHECK(irg::bezier_point(*huge.curve, 0.75) == P{-5e296, 0.75e-300, 0});
  const std::vector<P> one_place(130, P{1, 1, 1});
  const ready<P> long_one(one_place);
  CHECK(irg::length(irg::bezier_point(*long_one.curve, 0.3) - P{1, 1, 1}) < 1e-15);
  const ready<P> kept({P{0, 0, 0}, P{1, 2, 3}});
  const auto line = *kept.curve;
  CHECK(irg::length(irg::bezier_point(line, 3) - P{3, 6, 9}) < 1e-14);
  CHECK(irg::length(irg::bezier_point(line, -1) - P{-1, -2, -3}) < 1e-14);
  CHECK(irg::bezier_point(line, none).x != irg::bezier_point(line, none).x);
}

TEST_CASE("prepared Bezier curves: batches about the borders between two expansions, the same bits as one by one") {
  test::random r(103);
  const auto agree = [&]<class Point>(Point) {
    using T = irg::scalar_of<Point>;
    for (const std::size_t count : {1u, 2u, 3u, 4u, 6u, 8u, 12u, 21u}) {
      const ready<Point> kept(random_points<Point>(r, count));
      const auto curve = *kept.curve;
      std::vector<T> t(16);
      std::vector<Point> batch(t.size());
      const T step = 1 / static_cast<T>(curve.pieces), end = std::numeric_limits<T>::infinity();
      int differing = 0;
      for (int trial = 0; trial < 80; ++trial) {
        // An expansion's place, its two borders and what is next to all of them; now and then places outside, and NaN.
        const T node = static_cast<T>(r.integer(0, static_cast<std::int64_t>(curve.pieces))) * step;
        const bool inner = trial % 3 != 0;
        for (T& place : t) {
          const T off = static_cast<T>(r.integer(-1, 1)) * step / 2;
          place = std::fmin(std::fmax(node + off, T(0)), T(1));
          const auto how = r.integer(0, inner ? 3 : 9);
          if (how == 1) place = std::nextafter(place, -end);
          if (how == 2) place = std::nextafter(place, end);
          if (how == 3) place = node + static_cast<T>(r.unit() - 0.5) * step;
          if (how == 9) place = static_cast<T>(static_cast<double>(how) * (r.unit() - 0.5));
          if (how == 8) place = std::numeric_limits<T>::quiet_NaN();
        }
        irg::bezier_points(curve, t, std::span<Point>(batch));
        for (std::size_t k = 0; k < t.size(); ++k) {
          const Point p = irg::bezier_point(curve, t[k]);
          differing += !(p == batch[k] || (p[0] != p[0] && batch[k][0] != batch[k][0]));
        }
      }
      CHECK(differing == 0);
    }
  };
  agree(P{});
  agree(irg::point<double, 2>{});
  agree(irg::point<float, 3>{});
  agree(irg::point<float, 2>{});
}
