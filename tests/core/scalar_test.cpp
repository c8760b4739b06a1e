// SPDX-License-Identifier: MIT
#include <irg/core/scalar.hpp>

#include <algorithm>
#include <bit>
#include <complex>
#include <cstdint>
#include <functional>
#include <limits>
#include <string>

#include "support/archetypes.hpp"
#include "support/check_both.hpp"

namespace own {

struct no_division {
  friend bool operator==(const no_division&, const no_division&) = default;
  friend bool operator<(const no_division&, const no_division&);
  friend no_division operator+(const no_division&, const no_division&);
  friend no_division operator-(const no_division&, const no_division&);
  friend no_division operator*(const no_division&, const no_division&);
  friend no_division operator-(const no_division&);
  explicit no_division(int = 0);
};

// Sums and products that are computed when they are asked for, as GMP's and Boost.Multiprecision's.
struct late {
  struct expression {
    const late &a, &b;
    operator late() const { return {}; }
  };
  late() = default;
  explicit late(int) {}
  friend bool operator==(const late&, const late&) = default;
  friend bool operator<(const late&, const late&);
  friend expression operator+(const late& a, const late& b) { return {a, b}; }
  friend expression operator-(const late& a, const late& b) { return {a, b}; }
  friend expression operator*(const late& a, const late& b) { return {a, b}; }
  friend expression operator/(const late& a, const late& b) { return {a, b}; }
  friend late operator-(const late& a) { return a; }
};

// An integer of another library.
struct big_integer : archetype::scalar {
  using archetype::scalar::scalar;
  explicit big_integer(const archetype::scalar& x) : archetype::scalar(x) {}
  friend big_integer operator+(const big_integer&, const big_integer&);
  friend big_integer operator-(const big_integer&, const big_integer&);
  friend big_integer operator*(const big_integer&, const big_integer&);
  friend big_integer operator/(const big_integer&, const big_integer&);
  friend big_integer operator-(const big_integer&);
};

}  // namespace own

template <>
struct std::numeric_limits<own::big_integer> : std::numeric_limits<int> {};

namespace {

enum class colour { red };
static_assert(irg::Scalar<int> && irg::Scalar<std::uint8_t> && irg::Scalar<std::int64_t>);
static_assert(irg::Scalar<float> && irg::Scalar<double> && irg::Scalar<long double>);
static_assert(irg::Scalar<archetype::scalar>);
static_assert(!irg::Scalar<bool> && !irg::Scalar<void> && !irg::Scalar<colour> && !irg::Scalar<const char*>);
static_assert(!irg::Scalar<std::string> && !irg::Scalar<std::complex<float>>);  // no /, no <
static_assert(!irg::Scalar<own::no_division> && !irg::Scalar<const int> && !irg::Scalar<int&> && !irg::Scalar<int[2]>);

static_assert(irg::Real<float> && irg::Real<double> && irg::Real<archetype::scalar>);
static_assert(!irg::Real<int> && !irg::Real<std::uint64_t> && !irg::Real<bool>);
static_assert(irg::Scalar<own::big_integer> && !irg::Real<own::big_integer>);
static_assert(!irg::Number<own::late> && !irg::Scalar<own::late>);
#ifdef __SIZEOF_INT128__
__extension__ typedef __int128 int128;
static_assert(irg::Scalar<int128> && !irg::Real<int128>);  // although it is no std::integral without extensions
#endif

static_assert(irg::Floating<float> && irg::Floating<double>);
static_assert(!irg::Floating<long double> && !irg::Floating<int> && !irg::Floating<const float>);

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

constexpr bool negative(double x) { return std::bit_cast<std::int64_t>(x) < 0; }

}  // namespace

TEST_CASE("scalar: minimum and maximum") {
  CHECK_BOTH((irg::minimum(2, 3) == 2 && irg::minimum(3, 2) == 2));
  CHECK_BOTH((irg::maximum(2, 3) == 3 && irg::maximum(3, 2) == 3));
  CHECK_BOTH(irg::minimum(archetype::scalar(2), archetype::scalar(3)) == archetype::scalar(2));
  CHECK_BOTH(irg::maximum(archetype::scalar(2), archetype::scalar(3)) == archetype::scalar(3));
}

TEST_CASE("scalar: the second number wins when they cannot be ordered or are equal") {
  CHECK_BOTH((irg::minimum(not_a_number, 1.0) == 1.0 && irg::maximum(not_a_number, 1.0) == 1.0));
  CHECK_BOTH(irg::minimum(1.0, not_a_number) != irg::minimum(1.0, not_a_number));
  CHECK_BOTH(irg::maximum(1.0, not_a_number) != irg::maximum(1.0, not_a_number));
  CHECK_BOTH((negative(irg::minimum(0.0, -0.0)) && !negative(irg::minimum(-0.0, 0.0))));
  CHECK_BOTH((negative(irg::maximum(0.0, -0.0)) && !negative(irg::maximum(-0.0, 0.0))));
}

TEST_CASE("scalar: clamped keeps within the range, whatever comes") {
  CHECK_BOTH((irg::clamped(5, 0, 3) == 3 && irg::clamped(-5, 0, 3) == 0 && irg::clamped(2, 0, 3) == 2));
  CHECK_BOTH((irg::clamped(0, 0, 3) == 0 && irg::clamped(3, 0, 3) == 3 && irg::clamped(7, 4, 4) == 4));
  CHECK_BOTH(irg::clamped(not_a_number, -1.0, 1.0) == -1.0);
  CHECK_BOTH((irg::clamped(infinity, -1.0, 1.0) == 1.0 && irg::clamped(-infinity, -1.0, 1.0) == -1.0));
  CHECK_BOTH(irg::clamped(archetype::scalar(9), archetype::scalar(1), archetype::scalar(4)) == archetype::scalar(4));
}

TEST_CASE("scalar: std's names are free under both directives") {
  using namespace std;
  using namespace irg;
  CHECK((clamp(5, 0, 3) == clamped(5, 0, 3) && greater<>{}(2, 1) && identity{}(maximum(2, 1)) == 2));
}
