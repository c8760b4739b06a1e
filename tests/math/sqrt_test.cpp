// SPDX-License-Identifier: MIT
#include <irg/math/sqrt.hpp>

#include <cmath>

#include "support/check_both.hpp"
#include "support/ulp.hpp"

namespace {

using test::same;
constexpr double inf = std::numeric_limits<double>::infinity();
constexpr double no_number = std::numeric_limits<double>::quiet_NaN();

/// Whether y is the square root of x, correctly rounded, by integers alone: x * 4^k lies between the squares of the
/// middles beside y. For x of 53 bits scaled to an integer of 107 or 108 bits and y to one of 54.
bool is_correct_root(double x, double y) {
  __extension__ using wide = unsigned __int128;
  int exponent = 0;
  double significand = std::frexp(x, &exponent);
  if (exponent % 2 != 0) significand *= 2, --exponent;                              // in [1/2, 2)
  const wide radicand = static_cast<wide>(std::ldexp(significand, 53)) << 53;       // significand * 2^106
  const auto root = static_cast<wide>(std::ldexp(y, 53 - exponent / 2));            // near sqrt(significand) * 2^53
  if (std::ldexp(static_cast<double>(root), exponent / 2 - 53) != y) return false;  // y has more bits than that
  const int bits = std::ilogb(static_cast<double>(root));                           // 52 or 53
  const wide twice_half_place = bits == 52 ? 1 : 2;                                 // twice half of y's last place
  const wide low = 2 * root - twice_half_place, high = 2 * root + twice_half_place;
  return low * low <= 4 * radicand && 4 * radicand <= high * high;
}

}  // namespace

static_assert(noexcept(irg::sqrt(2.0)));
static_assert(std::is_same_v<decltype(irg::sqrt(2.0f)), float>);

TEST_CASE("square roots by hand") {
  CHECK_BOTH(irg::sqrt(2.0) == 1.4142135623730951);
  CHECK_BOTH(irg::sqrt(2.0f) == 1.41421354f);
  CHECK_BOTH(irg::sqrt(144.0) == 12);
  CHECK_BOTH(irg::sqrt(4 - 0x1p-51) == 2 - 0x1p-52);
  CHECK_BOTH(irg::sqrt(1 - 0x1p-53) == 1 - 0x1p-53);
  CHECK_BOTH(irg::sqrt(1 + 0x1p-52) == 1);
}

TEST_CASE("square roots of zeros, subnormal numbers, infinity, NaN and negative numbers") {
  CHECK_BOTH(same(irg::sqrt(0.0), 0.0));
  CHECK_BOTH(same(irg::sqrt(-0.0), -0.0));
  CHECK_BOTH(same(irg::sqrt(-0.0f), -0.0f));
  CHECK_BOTH(irg::sqrt(0x1p-1074) == 0x1p-537);
  CHECK_BOTH(irg::sqrt(0x1p-149f) == 0x1.6a09e6p-75f);
  CHECK_BOTH(irg::sqrt(std::numeric_limits<double>::max()) == 0x1.fffffffffffffp511);
  CHECK_BOTH(irg::sqrt(inf) == inf);
  CHECK_BOTH(same(irg::sqrt(-1.0), no_number));
  CHECK_BOTH(same(irg::sqrt(-inf), no_number));
  CHECK_BOTH(same(irg::sqrt(no_number), no_number));
  CHECK_BOTH(same(irg::sqrt(-0x1p-1074), no_number));
}

TEST_CASE("the algorithm of constant evaluation is correctly rounded and agrees with the instruction") {
  test::random r(1);
  const auto check = [](double x) {
    const double root = irg::detail::sqrt_of_positive(x);
    CHECK(same(root, irg::sqrt(x)));
    CHECK(same(root, std::sqrt(x)));
    if (x >= 0x1p-900 && x <= 0x1p900) CHECK(is_correct_root(x, root));
  };
  for (int i = 0; i < test::count_of(50000); ++i) {
    const double x = std::fabs(test::any_double(r));
    if (x > 0) check(x);
    // Squares of numbers of 26 bits and their neighbours; middles of two roots are squares of 27 bits and more.
    const double root = static_cast<double>((r.next() >> 37) | (1u << 26)) * 0x1p-26;
    const double square = root * root;
    check(square);
    check(std::nextafter(square, 0.0));
    check(std::nextafter(square, 9.0));
    check(std::ldexp(1.0 + static_cast<double>(r.integer(-64, 64)) * 0x1p-52, static_cast<int>(r.integer(-500, 500))));
  }
}

TEST_CASE("floats: every one, in steps") {
  const test::float_range range = test::floats_to_test(4099);
  for (std::uint64_t bits = range.first; bits < range.last; bits += range.step) {
    if (bits == 0 || bits >= 0x7f800000u) continue;  // what is not positive and finite has a test of its own
    const float x = std::bit_cast<float>(static_cast<std::uint32_t>(bits));
    const auto root = static_cast<float>(irg::detail::sqrt_of_positive(static_cast<double>(x)));
    if (!same(root, irg::sqrt(x)) || !same(root, std::sqrt(x))) FAIL_CHECK("sqrt of ", x, " is ", root);
  }
}
