// SPDX-License-Identifier: MIT
#include <irg/curve/bezier_accurate.hpp>

#include <cmath>
#include <vector>

#include "support/check_both.hpp"
#include "support/exact.hpp"

using namespace irg;

namespace {

using accurate_point = vec<double, 2>;
constexpr std::array<accurate_point, 4> accurate_course{accurate_point{0, 0}, {1, 3}, {4, 3}, {5, 0}};

}  // namespace

TEST_CASE("bezier accurate: golden points, ends, the same in constant evaluation") {
  CHECK_BOTH(bezier_point_accurate(accurate_course, 0.25) == accurate_point{17.0 / 16, 27.0 / 16});
  CHECK_BOTH(bezier_point_accurate(accurate_course, 0) == accurate_point{0, 0});
  CHECK_BOTH(bezier_point_accurate(accurate_course, 1) == accurate_point{5, 0});
  CHECK_BOTH(bezier_point_accurate(std::array{accurate_point{7, 8}}, 0.3) == accurate_point{7, 8});
  constexpr auto constant = bezier_point_accurate(accurate_course, 0.3);
  volatile double t = 0.3;
  CHECK(bezier_point_accurate(accurate_course, t) == constant);
}

TEST_CASE("bezier accurate: coincident points are met within an ulp, the largest numbers do not overflow") {
  const double largest = 1.7976931348623157e308;
  const std::array<accurate_point, 3> same{accurate_point{0.1, largest}, {0.1, largest}, {0.1, largest}};
  for (const double t : {1e-300, 0.1, 0.5, 0.7, 1 - 0x1p-53}) {
    const accurate_point p = bezier_point_accurate(same, t);
    CHECK(std::abs(p.x - 0.1) <= 0x1p-56);
    CHECK(std::abs(p.y - largest) <= 0x1p971);
  }
}

#ifdef IRG_HAVE_MPFR
namespace {

using accurate_oracle = test::exact;

/// p(t) and the sum of |b_i| B_i(t), in rationals.
struct exact_value {
  accurate_oracle value, size;
};
exact_value by_bernstein(const std::vector<vec<double, 1>>& b, double t) {
  const int n = static_cast<int>(b.size()) - 1;
  exact_value sum{accurate_oracle(0), accurate_oracle(0)};
  for (int i = 0; i <= n; ++i) {
    accurate_oracle term(b[static_cast<std::size_t>(i)][0]);
    for (int k = 0; k < i; ++k) term = term * accurate_oracle(t) * accurate_oracle(n - k) / accurate_oracle(k + 1);
    for (int k = i; k < n; ++k) term = term * (accurate_oracle(1) - accurate_oracle(t));
    sum = {sum.value + term, sum.size + abs(term)};
  }
  return sum;
}

/// The error over its bound u + 5 n^2 u^2 c.
double share_of_bound(const std::vector<vec<double, 1>>& b, double t) {
  std::vector<exact_sum<double>> scratch(b.size(), exact_sum<double>{});
  const exact_value want = by_bernstein(b, t);
  const double n = static_cast<double>(b.size() - 1);
  const double bound = 0x1p-53 * std::abs(want.value.rounded()) + 5 * n * n * 0x1p-106 * want.size.rounded();
  const double error = test::distance(bezier_point_accurate(b, t, scratch)[0], want.value);
  return error == 0 ? 0 : error / bound;
}

}  // namespace

TEST_CASE("bezier accurate: random curves, and (1 - 2t)^n near its root, against rationals") {
  test::random r(64);
  double worst = 0, worst_at_root = 0;
  for (int trial = 0; trial < test::trials(25); ++trial) {
    const std::size_t n = static_cast<std::size_t>(r.integer(1, trial % 5 == 0 ? 50 : 20));
    std::vector<vec<double, 1>> any(n + 1, vec<double, 1>{}), root = any;
    for (std::size_t i = 0; i <= n; ++i) {
      any[i][0] = std::ldexp(2 * r.unit() - 1, static_cast<int>(r.integer(-20, 20)));
      root[i][0] = i % 2 == 0 ? 1 : -1;  // (1 - 2t)^n
    }
    const double t = trial % 9 == 0 ? 0x1p-1074 : trial % 9 == 1 ? 1 - 0x1p-53 : r.unit();
    worst = std::max(worst, share_of_bound(any, t));
    worst_at_root = std::max(worst_at_root, share_of_bound(root, 0.5 + std::ldexp(r.unit(), -6)));
  }
  MESSAGE("error over u + 5 n^2 u^2 c: ", worst, ", at roots of high order ", worst_at_root);
  CHECK(worst <= 1);
  CHECK(worst_at_root <= 1);
}
#endif
