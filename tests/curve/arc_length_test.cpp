// SPDX-License-Identifier: MIT
#include <irg/curve/arc_length.hpp>

#include <cmath>
#include <limits>
#include <vector>

#include <irg/curve/bezier.hpp>
#include <irg/math/length.hpp>

#include "support/check_both.hpp"
#include "support/exact.hpp"

using namespace irg;

namespace {

using length_point = point<double, 3>;
using length_curve = std::array<length_point, 4>;

auto speed_of(const length_curve& c) {
  return [&c](double t) { return length(bezier_sample(c, t).derivative); };
}

/// The length of a cubic by 64-bit sums of 20,000 chords and Richardson's two.
long double by_chords(const length_curve& c, double to) {
  const auto place = [&](long double t, int i) {
    const long double s = 1 - t;
    const auto b = [&](std::size_t k) { return static_cast<long double>(c[k][i]); };
    return s * s * s * b(0) + 3 * s * s * t * b(1) + 3 * s * t * t * b(2) + t * t * t * b(3);
  };
  const auto chords = [&](int n) {
    long double sum = 0;
    for (int k = 1; k <= n; ++k) {
      long double square = 0;
      for (int i = 0; i < 3; ++i) {
        const long double d =
            place(static_cast<long double>(to) * k / n, i) - place(static_cast<long double>(to) * (k - 1) / n, i);
        square += d * d;
      }
      sum += std::sqrt(square);
    }
    return sum;
  };
  return (4 * chords(2000) - chords(1000)) / 3;
}

/// The same by Simpson's rule in 64 bits, halved until it agrees with its halves.
template <class F>
long double by_simpson(const F& f, long double a, long double b, long double tolerance, int depth) {
  const long double h = b - a, m = a + h / 2, left = f(a + h / 4), middle = f(m), right = f(b - h / 4),
                    ends = f(a) + f(b);
  const long double whole = h / 6 * (ends + 4 * middle), halves = h / 12 * (ends + 2 * middle + 4 * (left + right));
  if (depth == 0 || std::abs(halves - whole) <= 15 * tolerance) return halves + (halves - whole) / 15;
  return by_simpson(f, a, m, tolerance / 2, depth - 1) + by_simpson(f, m, b, tolerance / 2, depth - 1);
}
long double by_simpson(const length_curve& c, double to) {
  const auto speed = [&](long double t) {
    const long double s = 1 - t;
    long double square = 0;
    for (int i = 0; i < 3; ++i) {
      const auto side = [&](std::size_t k) {
        return 3 * (static_cast<long double>(c[k + 1][i]) - static_cast<long double>(c[k][i]));
      };
      const long double d = s * s * side(0) + 2 * s * t * side(1) + t * t * side(2);
      square += d * d;
    }
    return std::sqrt(square);
  };
  long double sum = 0;
  for (int k = 0; k < 8; ++k) {
    const long double h = static_cast<long double>(to) / 8;
    sum += by_simpson(speed, k * h, (k + 1) * h, 1e-15L, 30);
  }
  return sum;
}

constexpr bool is_within(double got, double want, double off) { return got - want <= off && want - got <= off; }

constexpr double circle_speed(double) { return 3; }
constexpr double at_half_length() {
  std::array<double, 9> lengths{};
  return parameter_at_length(circle_speed, arc_lengths<double>(circle_speed, 0, 2, lengths), 3);
}

}  // namespace

TEST_CASE("arc length: lines and circles, parabolas and a cusp by their formulas") {
  CHECK_BOTH(is_within(arc_length(circle_speed, 0.0, 2, 0), 6, 4e-15));
  CHECK_BOTH(is_within(at_half_length(), 1, 4e-15));
  CHECK_BOTH((arc_length_table<double>{}.first == 0 && arc_length_table<double>{}.last == 1));
  const auto parabola = [](double t) { return std::sqrt(1 + 4 * t * t); };
  for (const double b : {0.5, 1.0, 3.0})
    CHECK(arc_length(parabola, 0.0, b, 0) ==
          doctest::Approx(b / 2 * std::sqrt(1 + 4 * b * b) + std::asinh(2 * b) / 4).epsilon(4e-15));
  const auto cusp = [](double t) { return std::abs(t) * std::sqrt(4 + 9 * t * t); };  // of (t^2, t^3)
  const double whole = 2 * (std::pow(13.0, 1.5) - 8) / 27;
  CHECK(arc_length(cusp, -1.0, 1, 0) == doctest::Approx(whole).epsilon(1e-14));
  CHECK(arc_length(cusp, -1.0, 1.3, 1e-9) ==
        doctest::Approx(whole / 2 + (std::pow(4 + 9 * 1.69, 1.5) - 8) / 27).epsilon(1e-9));
  CHECK(arc_length(circle_speed, 1.0, 1, 0) == 0);
}

TEST_CASE("arc length: random cubics against 64-bit chords, and back") {
  test::random r(72);
  double worst_length = 0, worst_place = 0;
  for (int trial = 0; trial < test::trials(6); ++trial) {
    length_curve c{};
    for (length_point& p : c)
      for (int i = 0; i < 3; ++i) p[i] = test::any_coordinate<double>(r, test::spread::unit);
    const auto speed = speed_of(c);
    std::vector<double> lengths(33, 0.0);
    const auto table = arc_lengths<double>(speed, 0, 1, lengths);
    const auto off = [&](double got, double t) {
      return static_cast<double>(std::abs(static_cast<long double>(got) - by_chords(c, t))) / table.length();
    };
    worst_length = std::max(worst_length, std::max(off(arc_length(speed, 0.0, 1, 0), 1), off(table.length(), 1)));
    for (int k = 1; k < 8; ++k) {
      const double s = table.length() * (k - r.unit()) / 7;
      worst_place = std::max(worst_place, off(s, parameter_at_length(speed, table, s)));
    }
  }
  MESSAGE("relative error of the length ", worst_length, ", of the place ", worst_place);
  CHECK(worst_length <= 2e-11);  // of the chords: their fourth power
  CHECK(worst_place <= 2e-11);
}

// Plane and spatial cubics of all shapes, loops and sharp turns too, and tables of few lengths.
TEST_CASE("arc length: places by tables of few lengths, against Simpson's rule") {
  test::random r(75);
  double worst = 0, worst_at_cusps = 0;
  for (int trial = test::trials(10); trial > 0; --trial) {
    length_curve c{};
    for (length_point& p : c)
      for (int i = 0; i < 2 + trial % 2; ++i) p[i] = static_cast<double>(r.integer(-10, 10));
    const auto speed = speed_of(c);
    double slowest = speed(0);
    for (int k = 1; k <= 500; ++k) slowest = std::min(slowest, speed(k / 500.0));
    for (const std::size_t count : {2u, 5u, 9u, 17u, 33u}) {
      std::vector<double> lengths(count, 0.0);
      const auto table = arc_lengths<double>(speed, 0, 1, lengths);
      if (!(table.length() > 0)) continue;
      for (int k = 0; k < 5; ++k) {
        const double s = table.length() * (k + r.unit()) / 5, t = parameter_at_length(speed, table, s);
        const auto off = static_cast<double>(std::abs(by_simpson(c, t) - static_cast<long double>(s)));
        double& most = slowest < 0.01 * table.length() ? worst_at_cusps : worst;
        most = std::max(most, off / table.length());
      }
    }
  }
  MESSAGE("worst ", worst * 0x1p53, " u of the length, ", worst_at_cusps, " of it where a curve nearly stands still");
  CHECK(worst <= 64 * 0x1p-53);
  CHECK(worst_at_cusps <= 1e-11);
}

TEST_CASE("arc length: places and lengths undo each other, and ends hold") {
  const length_curve c{length_point{0, 0, 0}, {1, 3, 0}, {4, 3, 2}, {5, 0, 4}};
  const auto speed = speed_of(c);
  std::vector<double> lengths(17, 0.0);
  const auto table = arc_lengths<double>(speed, 0, 1, lengths);
  for (int k = 1; k < 64; ++k) {
    const double t = k / 64.0, s = arc_length(speed, 0.0, t, 0);
    CHECK(parameter_at_length(speed, table, s) == doctest::Approx(t).epsilon(1e-14));
  }
  CHECK(parameter_at_length(speed, table, -1) == 0);
  CHECK(parameter_at_length(speed, table, 0) == 0);
  CHECK(parameter_at_length(speed, table, table.length()) == 1);
  CHECK(parameter_at_length(speed, table, std::numeric_limits<double>::infinity()) == 1);
  CHECK(parameter_at_length(speed, table, std::nan("")) == 0);
}

TEST_CASE("arc length: a curve that stands still, and one with a place without speed") {
  const auto none = [](double) { return 0.0; };
  std::vector<double> lengths(5, 0.0);
  const auto standing = arc_lengths<double>(none, 0, 1, lengths);
  CHECK(standing.length() == 0);
  CHECK(parameter_at_length(none, standing, 0.5) == 1);
  const auto cusp = [](double t) { return std::abs(t - 0.5) * 2; };
  const auto table = arc_lengths<double>(cusp, 0, 1, lengths);
  constexpr auto with_a_rest = [](double length) {
    const auto half_way = [](double t) { return t < 0.5 ? 0.5 - t : 0.0; };
    std::array<double, 2> one{};
    return parameter_at_length(half_way, arc_lengths<double>(half_way, 0, 1, one), length);
  };
  CHECK_BOTH((with_a_rest(0.12) > 0.39 && with_a_rest(0.12) < 0.41));
  CHECK(parameter_at_length(cusp, table, 0.25) == doctest::Approx(0.5).epsilon(1e-6));
  CHECK(parameter_at_length(cusp, table, 0.375) == doctest::Approx(0.5 + std::sqrt(0.125)).epsilon(1e-12));
}
