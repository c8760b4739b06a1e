// SPDX-License-Identifier: MIT
#include <irg/curve/bezier_zeros.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <vector>

#include "support/check_both.hpp"
#include "support/random.hpp"

namespace {

using C = irg::vec<double, 1>;
using Z = irg::root_interval<double>;

constexpr Z only_zero(double a, double b, double c) {
  std::array<C, 3> coefficients{C{a}, C{b}, C{c}};
  std::array<C, 9> scratch{};
  Z found{};
  int count = 0;
  irg::bernstein_roots(std::span<const C>(coefficients), 0.0, scratch, [&](const Z& z) { found = z, ++count; });
  return count == 1 ? found : Z{-1, -1, count, 9};
}

std::vector<Z> zeros(const std::vector<C>& coefficients, double uncertainty) {
  std::vector<C> scratch(3 * coefficients.size());
  std::vector<Z> all;
  irg::bernstein_roots(std::span<const C>(coefficients), uncertainty, scratch, [&](const Z& z) { all.push_back(z); });
  return all;
}

double binomial(std::size_t n, std::size_t k) {
  double b = 1;
  for (std::size_t i = 0; i < k; ++i) b = b * static_cast<double>(n - i) / static_cast<double>(i + 1);
  return b;
}

/// The Bernstein coefficients of the product of all (t - root), and how far rounding moved them. The powers' own
/// coefficients are exact for six roots of few digits.
std::vector<C> with_roots(const std::vector<double>& roots, double& off) {
  std::vector<double> power{1};
  for (const double r : roots) {
    power.push_back(0);
    for (std::size_t i = power.size() - 1; i > 0; --i) power[i] = power[i - 1] - r * power[i];
    power[0] = -r * power[0];
  }
  std::vector<C> b;
  off = 0;
  for (std::size_t j = 0; j < power.size(); ++j) {
    double sum = 0, sizes = 0;
    for (std::size_t i = 0; i <= j; ++i) {
      const double term = power[i] * binomial(j, i) / binomial(roots.size(), i);
      sum += term;
      sizes += std::abs(term);
    }
    b.push_back({sum});
    off = std::fmax(off, sizes * 0x1p-49);
  }
  return b;
}

}  // namespace

TEST_CASE("bernstein_roots: reference values, no zero, touching, zero all along, what is not finite") {
  constexpr double inf = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();
  constexpr Z at_third = only_zero(-1, 0.5, 2);  // a straight line
  CHECK_BOTH(at_third.is_crossing());
  CHECK_BOTH(at_third.before == -1);
  CHECK(std::abs(at_third.middle() - 1. / 3) < 1e-14);
  CHECK(at_third.to - at_third.from < 1e-13);
  CHECK_BOTH(only_zero(1, 1, 1).behind == 9);       // none
  CHECK_BOTH(only_zero(1, -0.5, 1).from == -1);     // two
  CHECK_BOTH(only_zero(0, 0, 0) == Z{0, 1, 0, 0});
  constexpr Z touching = only_zero(1, -1, 1);  // (1 - 2 t)^2
  CHECK_BOTH((touching.before == 1 && touching.behind == 1 && touching.from < 0.5 && touching.to > 0.5));
  CHECK(touching.to - touching.from < 1e-6);
  constexpr Z at_begin = only_zero(0, 1, 2);
  CHECK_BOTH((at_begin.from == 0 && at_begin.before == 0 && at_begin.behind == 1));
  constexpr Z at_end = only_zero(-2, -1, 0);
  CHECK_BOTH((at_end.to == 1 && at_end.before == -1 && at_end.behind == 0));
  CHECK(only_zero(nan, 1, 1) == Z{0, 1, 0, 0});
  CHECK(only_zero(1, inf, 1) == Z{0, 1, 0, 0});
  CHECK(only_zero(-1e308, 1, 1e308).is_crossing());
  CHECK(only_zero(-1e-300, 0, 1e-300).is_crossing());
  CHECK(only_zero(-5e-324, 0, 5e-324) == Z{0, 1, 0, 0});  // nothing but rounding
  CHECK(zeros({C{0}}, 0) == std::vector<Z>{Z{0, 1, 0, 0}});
  CHECK(zeros({C{3}}, 0).empty());
}

TEST_CASE("bernstein_roots: no root is missed, simple ones are found apart") {
  test::random r(19);
  long simple = 0, multiple = 0, missed = 0, wide = 0, extra = 0;
  for (int round = 0; round < (std::getenv("IRG_RELEASE_TIER") ? 300'000 : 3000); ++round) {
    std::vector<double> roots;
    for (auto k = r.integer(1, 6); k > 0; --k) {
      const auto numerator = r.integer(-16, 48);
      roots.push_back(static_cast<double>(numerator) / 32);
    }
    std::sort(roots.begin(), roots.end());
    double off = 0;
    const auto found = zeros(with_roots(roots, off), off);
    const bool distinct = std::adjacent_find(roots.begin(), roots.end()) == roots.end();
    (distinct ? simple : multiple) += 1;
    for (const double root : roots)
      if (root >= 0 && root <= 1)
        missed += std::none_of(found.begin(), found.end(), [&](const Z& z) { return z.from <= root && root <= z.to; });
    for (std::size_t i = 0; i < found.size(); ++i) {
      const auto inside = std::count_if(roots.begin(), roots.end(),
                                        [&](double root) { return found[i].from <= root && root <= found[i].to; });
      if (distinct) {
        wide += found[i].to - found[i].from > 1e-6;
        extra += inside != 1;
      }
      if (found[i].before * found[i].behind != 0) extra += (inside % 2 != 0) != found[i].is_crossing();
      if (i > 0) extra += !(found[i - 1].to < found[i].from);
    }
  }
  MESSAGE(simple, " polynomials with simple roots, ", multiple, " with multiple ones");
  CHECK(missed == 0);
  CHECK(wide == 0);
  CHECK(extra == 0);
  CHECK(simple > 500);
}

TEST_CASE("bernstein_roots: the work is bounded, whatever the coefficients") {
  test::random r(20);
  for (int round = 0; round < 200; ++round) {
    std::vector<C> c;
    for (int i = 0; i < 21; ++i) {
      const double sign = r.integer(0, 1) == 0 ? -1 : 1;
      c.push_back({std::ldexp(sign, static_cast<int>(r.integer(-70, 0)))});
    }
    CHECK(zeros(c, 0).size() <= 21);
  }
  std::vector<C> power(21);  // (1 - 2 t)^20: within rounding of zero over a long stretch
  for (std::size_t i = 0; i < power.size(); ++i) power[i] = {i % 2 == 0 ? 1.0 : -1.0};
  const auto found = zeros(power, 0);
  REQUIRE(found.size() == 1);
  CHECK(found[0].from < 0.5);
  CHECK(found[0].to > 0.5);
  CHECK(found[0].before == 1);
  CHECK(found[0].behind == 1);
}
