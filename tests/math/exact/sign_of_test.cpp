// SPDX-License-Identifier: MIT
#include <irg/math/exact/quotients_of.hpp>
#include <irg/math/exact/sign_of.hpp>

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

#include "support/big_rational.hpp"
#include "support/check_both.hpp"
#include "support/flush_mode.hpp"
#include "support/random.hpp"

namespace {

// (x0 - x1)(x2 - x3) - (x4 - x5)(x6 - x7), and the product of six differences less that of six others.
constexpr auto area = [](const auto& x) { return (x[0] - x[1]) * (x[2] - x[3]) - (x[4] - x[5]) * (x[6] - x[7]); };
constexpr auto deep = [](const auto& x) {
  const auto half = [&](std::size_t k) {
    return ((x[k] - x[k + 1]) * (x[k + 1] - x[k + 2])) * ((x[k + 2] - x[k]) * (x[k] - x[k + 2])) *
           ((x[k + 1] - x[k]) * (x[k + 2] - x[k + 1]));
  };
  return half(0) - half(3);
};
constexpr auto share = [](const auto& x) {
  return std::array{(x[0] - x[1]) * (x[2] - x[3]) * (x[4] - x[5]), (x[6] - x[7]) * (x[0] - x[3]) * (x[4] - x[1])};
};
constexpr double infinite = std::numeric_limits<double>::infinity();

}  // namespace

TEST_CASE("sign_of: plain, tied, of all sizes, none") {
  CHECK_BOTH(irg::sign_of<2>(area, std::array<double, 8>{3, 1, 3, 1, 1, 0, 1, 0}) == 1);
  CHECK_BOTH(irg::sign_of<2>(area, std::array<double, 8>{3, 1, 3, 1, 5, 1, 1, 0}) == 0);
  CHECK_BOTH(irg::sign_of<2>(area, std::array<double, 8>{0.1, 0, 0.1, 0, 0.01, 0, 1, 0}) == 1);
  CHECK_BOTH(irg::sign_of<2>(area, std::array<double, 8>{1e300, -1e300, 5e-324, 0, 1e-20, 0, 1, 0}) == -1);
  CHECK_BOTH(irg::sign_of<6>(deep, std::array<double, 6>{1e-300, 0, -1e-300, 5e-324, 0, -5e-324}) == -1);
  CHECK_BOTH(irg::sign_of<2>(area, std::array<double, 8>{infinite, 1, 3, 1, 1, 0, 1, 0}) == 0);
  constexpr float infinite_float = std::numeric_limits<float>::infinity(), largest = std::numeric_limits<float>::max();
  CHECK_BOTH(irg::sign_of<2>(area, std::array<float, 8>{infinite_float, 1, 3, 1, 1, 0, 1, 0}) == 0);
  CHECK_BOTH(irg::sign_of<2>(area, std::array<float, 8>{3, 1, 3, 1, 1, 0, 1, -infinite_float}) == 0);
  CHECK_BOTH(irg::sign_of<2>(area, std::array<float, 8>{largest, -largest, largest, 0, largest, -1, largest, 0}) == 1);
}

TEST_CASE("quotient_of: the nearest double, none where the divisor is zero") {
  CHECK_BOTH(irg::quotient_of<3>(share, std::array<double, 8>{3, 0, 1, 0, 1, 0, 1, 0}) == 1.0);
  CHECK_BOTH(irg::quotient_of<3>(share, std::array<double, 8>{1, 1, 1, 0, 1, 0, 1, 0}) == std::nullopt);
}

#ifdef IRG_HAVE_MPFR
TEST_CASE("sign_of and quotient_of: against rationals, near ties and mixed magnitudes") {
  test::random r(66);
  int zeros = 0;
  for (int trial = 0; trial < 3000; ++trial) {
    std::array<double, 8> in{};
    std::array<test::big_rational, 8> exact{};
    const auto kind = r.integer(0, 2);
    for (std::size_t k = 0; k < 8; ++k) {
      const auto whole = static_cast<double>(r.integer(-2, 2));
      const double off = r.unit() * 0x1p-50;
      const double size = std::ldexp(r.unit() - 0.5, static_cast<int>(r.integer(-1000, 1000)));
      in[k] = kind == 0 ? whole : kind == 1 ? whole + off : size;
      exact[k] = test::big_rational(in[k]);
    }
    std::array<double, 6> six{};
    std::array<test::big_rational, 6> exact_six{};
    for (std::size_t k = 0; k < 6; ++k) six[k] = in[k], exact_six[k] = exact[k];
    const int sign = deep(exact_six).sign();
    zeros += sign == 0 ? 1 : 0;
    REQUIRE(irg::sign_of<6>(deep, six) == sign);
    REQUIRE(irg::sign_of<2>(area, in) == area(exact).sign());
    const auto parts = share(exact);
    const auto quotient = irg::quotient_of<3>(share, in);
    REQUIRE(quotient.has_value() == (parts[0].sign() != 0));
    if (quotient && std::fabs(*quotient) < std::numeric_limits<double>::max())
      REQUIRE(*quotient == test::nearest<double>(parts[1] / parts[0]));
  }
  CHECK(zeros > 100);
}
#endif

#ifdef IRG_HAVE_MPFR
TEST_CASE("sign_of: at both ends of the filter's range, also where subnormal numbers count as zero") {
  // 2^400 and 2^-400 bound it for degree 2; a value is told from zero in doubles from 2^-590 on.
  constexpr std::array<int, 14> ends{-1074, -1022, -700, -401, -400, -399, -296, -295, 0, 295, 398, 399, 400, 1000};
  test::random r(67);
  int signs[3] = {};
  for (int trial = 0; trial < 3000; ++trial) {
    std::array<double, 8> in{};
    std::array<test::big_rational, 8> exact{};
    for (std::size_t k = 0; k < 8; ++k) {
      const int end = ends[static_cast<std::size_t>(r.integer(0, 13))];
      in[k] = r.integer(0, 3) == 0 ? 0.0 : std::ldexp(static_cast<double>(r.integer(-5, 5)), end);
      if (k >= 4 && r.integer(0, 1) == 0) in[k] = in[k - 4];
      exact[k] = test::big_rational(in[k]);
    }
    const int sign = area(exact).sign();
    ++signs[sign + 1];
    REQUIRE(irg::sign_of<2>(area, in) == sign);
    REQUIRE(test::while_flushing([&] { return irg::sign_of<2>(area, in); }) == sign);
  }
  for (const int count : signs) CHECK(count > 300);
}
#endif

TEST_CASE("sign_of: NaN and infinity in a number that the polynomial leaves out") {
  const auto first = [](const auto& p) { return p.x * p.x; };
  CHECK_BOTH(irg::sign_of<2>(first, irg::point<double, 2>{3, infinite}) == 0);
  CHECK_BOTH(irg::sign_of<2>(first, irg::point<double, 2>{3, std::numeric_limits<double>::quiet_NaN()}) == 0);
  CHECK_BOTH(irg::sign_of<2>(first, irg::point<double, 2>{3, 0x1.fffffffffffffp1023}) == 1);
}

TEST_CASE("sign_of: points, vectors and integers; several signs at once") {
  using P = irg::point<double, 3>;
  constexpr auto volume = [](const auto& a, const auto& b, const auto& c, const auto& d) {
    return dot(cross(b - a, c - a), d - a);
  };
  CHECK_BOTH(irg::sign_of<3>(volume, P{0, 0, 0}, P{1, 0, 0}, P{0, 1, 0}, P{0, 0, 1e-300}) == 1);
  CHECK_BOTH(irg::sign_of<3>(volume, P{0, 0, 0}, P{1, 0, 0}, P{0, 1, 0}, P{7, 9, 0}) == 0);
  using I = irg::point<std::int64_t, 3>;
  constexpr std::int64_t big = std::int64_t{1} << 62;
  CHECK_BOTH(irg::sign_of<3>(volume, I{-big, 0, 0}, I{big, 0, 0}, I{0, big, 0}, I{0, 0, -1}) == -1);
  CHECK_BOTH(irg::sign_of<2>([](const auto& x, const auto& y) { return std::array{x * x - y * y, y - x, x * y}; }, 3,
                             -3) == std::array{0, -1, -1});
  CHECK_BOTH(irg::sign_of<2>([](const auto& x, const auto& y) { return x * x - y * y; }, big, big - 1) == 1);
  CHECK_BOTH(irg::sign_of<1>([](const auto& x, const auto& y) { return std::array{x - y, x + y}; },
                             std::numeric_limits<float>::denorm_min(), 0.0f) == std::array{1, 1});
}
