// SPDX-License-Identifier: MIT
#include <irg/hidden/horizon_surface.hpp>

#include <cmath>
#include <limits>
#include <string>

#include <irg/hidden/textbook/floating_horizon.hpp>
#include <irg/math/constants.hpp>

#include "horizon_runs.hpp"
#include "support/check_both.hpp"

using irg::horizon_curves;
using irg::horizon_view;

namespace {

constexpr double degree = irg::pi<double> / 180;
constexpr auto arch = [](double x, double z) { return 4 * x * (1 - x) * z; };
constexpr horizon_view small_view(horizon_curves families) { return {8, 8, 30 * degree, 30 * degree, 3, 0, families}; }

std::string horizons(const auto& h) {
  std::string text;
  for (int x = 0; x < h.columns(); ++x) text += std::to_string(h[x].lower) + "," + std::to_string(h[x].upper) + " ";
  return text;
}

constexpr int steps(double width, double degrees, int crossing, bool sine = false) {
  const horizon_view v{width, 1, degrees * degree, 0, crossing + 1};
  return irg::sample_steps(v, sine ? irg::sin(v.yaw) : irg::cos(v.yaw));
}

}  // namespace

TEST_CASE("sample_steps: the source's counts") {
  CHECK_BOTH(steps(300, 2, 25) == 300);
  CHECK_BOTH(steps(300, 2, 25, true) == 25);
  CHECK_BOTH(steps(300, 90, 25) == 25);
  CHECK_BOTH(steps(300, 45, 25) == 225);
  CHECK_BOTH(steps(300, 60, 25) == 150);
  CHECK_BOTH(steps(300, 60, 25, true) == 275);
  CHECK_BOTH(steps(300, 29, 40) == 280);
  CHECK_BOTH(steps(380, 29, 40, true) == 200);
  CHECK_BOTH(steps(640, 30, 20) == 560);
  for (int pixels = 0; pixels < 400; ++pixels)
    for (const int n : {1, 3, 25, 40}) {
      const int s = irg::sample_steps(horizon_view{static_cast<double>(pixels), 1, 0, 0, n + 1}, 1.0);
      CHECK((s % n == 0 && s > 0 && s >= pixels && s - n < (pixels > 0 ? pixels : 1)));
    }
  const horizon_view asked{300, 1, 0, 0, 26, 31};
  CHECK(irg::sample_steps(asked, 1.0) == 50);
}

TEST_CASE("draw_horizon_surface: the source's whole run, one family and both orders, its own rule") {
  const auto run = [](horizon_view v, test::line_text& lines) {
    irg::textbook::floating_horizon h(irg::horizon_width(v));
    draw_horizon_surface(h, arch, v, lines);
    return horizons(h);
  };
  test::line_text one;
  // Two samples of this run lie half-way between two columns, exactly; the last bit of the sine decides.
  const std::string last = run(small_view(horizon_curves::constant_z), one);
  CHECK(last == "3,3 7,7 2,9 3,11 0,11 0,10 0,8 1,6 1,5 1,4 2,2 2,2 ");
  CHECK(std::count(one.text.begin(), one.text.end(), ' ') == 36);
  CHECK(one.text.substr(0, 32) == "U4,0-5,0 L4,0-5,0 U5,0-6,0 L5,0-");
  test::line_text both;
  CHECK(run(small_view(horizon_curves::both), both) == "3,3 3,7 2,9 1,11 0,11 0,10 0,8 1,6 1,5 1,4 2,3 2,2 ");
  CHECK(std::count(both.text.begin(), both.text.end(), ' ') == 52);
}

TEST_CASE("draw_horizon_surface: both orders have the same horizons at 45 degrees, nearly") {
  const auto ripple = [](double u, double v) {
    return irg::cos(std::hypot(irg::pi<double> * (2 * u - 1), irg::pi<double> * (2 * v - 1)));
  };
  const auto run = [&](double degrees) {
    const horizon_view v{380, 120, degrees * degree, 40 * degree, 41};
    irg::floating_horizon h(irg::horizon_width(v));
    test::line_text lines;
    draw_horizon_surface(h, ripple, v, lines);
    CHECK(lines.text.size() > 100000);
    return h;
  };
  const auto flat = run(45.0), steep = run(std::nextafter(45.0, 46.0) + 1e-12);
  int differing = 0;
  for (int x = 0; x < flat.columns() && x < steep.columns(); ++x)
    differing += flat[x].upper - steep[x].upper > 1 || steep[x].upper - flat[x].upper > 1;
  CHECK(differing == 0);
}

TEST_CASE("horizon_view: numbers out of range") {
  const auto columns = [](double width) { return irg::horizon_width(horizon_view{width, 1, 45 * degree, 0, 3}); };
  CHECK(columns(1e300) == columns(0x1p28));
  CHECK(columns(std::numeric_limits<double>::quiet_NaN()) == 1);
  CHECK(columns(-5) == 1);
  for (const double yaw : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    const horizon_view turned{9, 1, yaw, 0, 3};
    CHECK(irg::horizon_width(turned) == 1);
    irg::floating_horizon h(irg::horizon_width(turned));
    draw_horizon_surface(h, arch, turned, [](auto&&...) { FAIL("a line from nowhere"); });
  }
  constexpr int most = std::numeric_limits<int>::max();
  CHECK_BOTH(irg::sample_steps(horizon_view{9, 1, 0, 0, most, most}, 1.0) > 0);
  CHECK_BOTH(irg::sample_steps(horizon_view{1e300, 1, 0, 0, 3}, 1.0) == 1 << 28);
  CHECK_BOTH(irg::sample_steps(horizon_view{9, 1, 0, 0, -7, 1}, 1.0) == 1);
}

TEST_CASE("draw_horizon_surface: right angles, gaps, heights without end, in constant evaluation") {
  constexpr auto lines = [](auto height, double degrees, horizon_curves families) {
    const horizon_view v{8, 8, degrees * degree, 0, 3, 0, families};
    irg::floating_horizon h(irg::horizon_width(v));
    int n = 0;
    draw_horizon_surface(h, height, v, [&](irg::cell, irg::cell, irg::horizon_side) { ++n; });
    return n;
  };
  constexpr auto level = [](double, double) { return 0.5; };
  CHECK_BOTH(lines(level, 0, horizon_curves::constant_z) > 0);
  CHECK_BOTH(lines(level, 90, horizon_curves::constant_x) > 0);
  CHECK(lines(level, 90, horizon_curves::both) > 0);
  constexpr double inf = std::numeric_limits<double>::infinity();
  CHECK(lines([](double, double) { return inf; }, 30, horizon_curves::both) == 0);
  CHECK(lines([](double, double) { return 1e300; }, 30, horizon_curves::both) == 0);
  const int whole = lines(level, 30, horizon_curves::constant_z);
  const int torn =
      lines([](double x, double) { return x > 0.4 && x < 0.6 ? std::numeric_limits<double>::quiet_NaN() : 0.5; }, 30,
            horizon_curves::constant_z);
  CHECK(torn > 0);
  CHECK(torn < whole);
}
