// SPDX-License-Identifier: MIT
#include <irg/view/textbook/project_perspective.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

#include "support/check_both.hpp"
#include "support/random.hpp"

using irg::point;
using irg::textbook::perspective_matrix;
using irg::textbook::project_perspective;

namespace {

using P = point<double, 3>;
using M = irg::mat<double, 4, 4>;
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
constexpr double most = std::numeric_limits<double>::max(), least = std::numeric_limits<double>::denorm_min();

}  // namespace

TEST_CASE("project_perspective: what cannot be seen, and the ends of the range") {
  using opt = std::optional<point<double, 2>>;
  CHECK_BOTH(project_perspective(P{3, -2, 6}, 2) == point<double, 2>{1, -2.0 / 3});  // Hank's
  CHECK_BOTH(project_perspective(P{3, -2, 3}, 2) == point<double, 2>{2, -4.0 / 3});
  CHECK_BOTH(project_perspective(P{3, -2, 0}, 2) == opt{});
  CHECK_BOTH(project_perspective(P{3, -2, -0.0}, 2) == opt{});
  CHECK_BOTH(project_perspective(P{0, 0, 0}, 2) == opt{});
  CHECK_BOTH(project_perspective(P{1e-300, 0, 0}, 2) == opt{});
  CHECK_BOTH(project_perspective(P{3, -2, -3}, 2) == opt{});
  CHECK_BOTH(project_perspective(P{3, -2, 3}, 0) == opt{});
  CHECK_BOTH(project_perspective(P{3, -2, 3}, -2) == opt{});
  CHECK_BOTH(project_perspective(P{3, not_a_number, 3}, 2) == opt{});
  CHECK_BOTH(project_perspective(P{3, 2, not_a_number}, 2) == opt{});
  CHECK_BOTH(project_perspective(P{3, 2, inf}, 2) == opt{});
  CHECK_BOTH(project_perspective(P{3, 2, 3}, inf) == opt{});
  CHECK_BOTH(project_perspective(P{1e300, 0, 1e-300}, 1) == opt{});
  CHECK_BOTH(project_perspective(P{1e300, 0, 1e300}, 1e300) == point<double, 2>{1e300, 0});
  CHECK_BOTH(project_perspective(P{most, -most, least}, least) == point<double, 2>{most, -most});
  CHECK_BOTH(project_perspective(P{least, 0, most}, most) == point<double, 2>{least, 0});
  CHECK_BOTH(project_perspective(P{least, -least, 1e300}, 1e-300) == point<double, 2>{0, 0});
  CHECK_BOTH(project_perspective(P{0x1p1023, 0, 1}, 2) == opt{});
  CHECK_BOTH(project_perspective(P{0x1p1000, 0x1p-1000, 0x1p500}, 0x1p500) == point<double, 2>{0x1p1000, 0x1p-1000});
  CHECK_BOTH(!project_perspective(point<float, 3>{1e38f, 0, 1e-38f}, 1));
  CHECK_BOTH(project_perspective(point<float, 3>{1e38f, 0, 1e38f}, 1e-38f) == point<float, 2>{1e-38f, 0});
  for (const double h : {0.0, -1.0, not_a_number, inf, least}) CHECK(!perspective_matrix(h));
  CHECK_BOTH(perspective_matrix(4.0) == M{{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 0, 0.25}, {0, 0, 0, 0}}});
  CHECK((*perspective_matrix(most))(2, 3) > 0);
}

TEST_CASE("project_perspective: within 0.51 ulp of the quotient in extended precision") {
  if constexpr (std::numeric_limits<long double>::digits < 64) return;
  test::random r(2);
  double worst = 0;
  for (int i = 0; i < 100000; ++i) {
    const int range = i % 2 ? 30 : 1020;
    const auto number = [&] {
      const double significand = 1 + r.unit();
      return std::ldexp(significand, static_cast<int>(r.integer(-range, range)));
    };
    const double x = number(), h = number(), z = number();
    CHECK(project_perspective(P{x, 0, h}, h) == point<double, 2>{x, 0});
    const long double expected = static_cast<long double>(x) * static_cast<long double>(h) /
                                 static_cast<long double>(z);  // relative error 2^-63
    const auto seen = project_perspective(P{x, 0, z}, h);
    if (expected > static_cast<long double>(most)) {
      CHECK(!seen);
      continue;
    }
    REQUIRE(seen.has_value());
    if (expected < 0x1p-1000L) {
      CHECK(std::abs(static_cast<double>(static_cast<long double>(seen->x) - expected)) <= std::max(0x1p-1050, least));
      continue;
    }
    const long double off = std::abs(static_cast<long double>(seen->x) - expected);
    worst = std::max(worst, static_cast<double>(std::ldexp(off, 52 - std::ilogb(seen->x))));
  }
  INFO("worst ", worst, " ulp");
  CHECK(worst <= 0.51);
}
