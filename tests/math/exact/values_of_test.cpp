// SPDX-License-Identifier: MIT
#include <irg/math/exact/sign_of.hpp>
#include <irg/math/exact/values_of.hpp>

#include <array>
#include <cmath>
#include <limits>
#include <tuple>

#include "support/big_rational.hpp"
#include "support/check_both.hpp"
#include "support/random.hpp"
#include "support/rational.hpp"

namespace {

using P = irg::point<double, 3>;
// A volume, a normal and a product, from points, a vector and a number.
constexpr auto shape = [](const auto& a, const auto& b, const auto& u, const auto& s) {
  const auto n = cross(b - a, u);
  return std::tuple{dot(n, b - a) + s * s, n, to_vec(a) * s};
};
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

// Numbers that are templates of another number and a size, and become that number where nobody asks: 1/256 each.
template <class T, int Bits>
struct fixed {
  T raw{};
  constexpr fixed() = default;
  constexpr explicit fixed(int whole) : raw(static_cast<T>(whole << Bits)) {}
  constexpr operator T() const { return raw >> Bits; }
  static constexpr fixed of(T raw) {
    fixed x;
    x.raw = raw;
    return x;
  }
  constexpr bool operator==(const fixed&) const = default;
  friend constexpr bool operator<(fixed a, fixed b) { return a.raw < b.raw; }
  friend constexpr fixed operator+(fixed a, fixed b) { return of(a.raw + b.raw); }
  friend constexpr fixed operator-(fixed a, fixed b) { return of(a.raw - b.raw); }
  friend constexpr fixed operator*(fixed a, fixed b) { return of(a.raw * b.raw >> Bits); }
  friend constexpr fixed operator/(fixed a, fixed b) { return of((a.raw << Bits) / b.raw); }
  friend constexpr fixed operator-(fixed a) { return of(-a.raw); }
};
using fixed8 = fixed<long long, 8>;
static_assert(irg::Scalar<fixed8>);

}  // namespace

TEST_CASE("values_of: numbers, points, vectors; zero is zero, NaN gives nothing") {
  constexpr auto v = irg::values_of<3>(shape, P{1, 2, 3}, P{2, 2, 3}, irg::vec<double, 3>{0, 1, 0}, 0.0);
  static_assert(v.has_value() && irg::sign_of(std::get<0>(*v)) == 0);
  static_assert(irg::rounded_coordinates<irg::vec<double, 3>>(std::get<1>(*v)) == irg::vec<double, 3>{0, 0, 1});
  CHECK_BOTH(!irg::values_of<3>(shape, P{1, 2, not_a_number}, P{2, 2, 3}, irg::vec<double, 3>{0, 1, 0}, 0.0));
  const auto exact = irg::values_of<1>([](const auto& a, const auto& b) { return (b - a) * a; }, test::rational(1, 3),
                                       test::rational(1, 2));
  CHECK(*exact == test::rational(1, 18));
}

TEST_CASE("values_of: a number that is a template of another number counts as itself") {
  constexpr auto product = [](const auto& a, const auto& b) { return a * b; };
  constexpr fixed8 half = fixed8::of(128);
  constexpr auto value = irg::values_of<2>(product, half, fixed8(3));
  static_assert(value->raw == 384);
  static_assert(irg::sign_of<2>(product, half, -half) == -1);
}

#ifdef IRG_HAVE_MPFR
TEST_CASE("values_of: within 2^-60 of rationals, near cancellation and at mixed magnitudes") {
  test::random r(15);
  constexpr auto area = [](const auto& x) { return (x[0] - x[1]) * (x[2] - x[3]) - (x[4] - x[5]) * (x[6] - x[7]); };
  for (int trial = 0; trial < 3000; ++trial) {
    std::array<double, 8> in{};
    std::array<test::big_rational, 8> exact{};
    for (std::size_t k = 0; k < 8; ++k) {
      in[k] = trial % 2 == 0 ? static_cast<double>(r.integer(-2, 2)) + r.unit() * 0x1p-50
                             : std::ldexp(r.unit() - 0.5, static_cast<int>(r.integer(-1000, 1000)));
      exact[k] = test::big_rational(in[k]);
    }
    const auto value = irg::values_of<2>(area, in);
    const test::big_rational expected = area(exact);
    REQUIRE(irg::sign_of(*value) == expected.sign());
    if (expected.sign() == 0) continue;
    const test::big_rational back =
        (test::big_rational(value->high) + test::big_rational(value->low)).times_power_of_two(value->exponent);
    const test::big_rational off = (back - expected) / expected;
    REQUIRE(off < test::big_rational(0x1p-60));
    REQUIRE(-off < test::big_rational(0x1p-60));
  }
}
#endif
