// SPDX-License-Identifier: MIT
#include <irg/math/hypot.hpp>

#include "support/check_both.hpp"
#include "support/random.hpp"
#include "support/ulp.hpp"

namespace {

using test::same;
constexpr double inf = std::numeric_limits<double>::infinity();
constexpr double no_number = std::numeric_limits<double>::quiet_NaN();
constexpr double largest = std::numeric_limits<double>::max();

}  // namespace

static_assert(noexcept(irg::hypot(1.0, 2.0)));
static_assert(std::is_same_v<decltype(irg::hypot(1.0f, 2.0f, 3.0f)), float>);

// Arguments of different types, and integers, as the standard library takes them.
static_assert(irg::hypot(3.0, 4.0f) == 5 && irg::hypot(3, 4) == 5 && irg::hypot(2, 3.0f, 6) == 7);
static_assert(std::is_same_v<decltype(irg::hypot(3.0f, 4.0f)), float>);

TEST_CASE("lengths by hand") {
  CHECK_BOTH(irg::hypot(3.0, -4.0) == 5);
  CHECK_BOTH(irg::hypot(2.0, 3.0, 6.0) == 7);
  CHECK_BOTH(irg::hypot(1.0, 1.0) == 1.4142135623730951);
  CHECK_BOTH(irg::hypot(1.0f, 1.0f, 1.0f) == 1.73205081f);
  CHECK_BOTH(irg::hypot(-7.0, 0.0) == 7);
}

TEST_CASE("a length just beyond the middle between two numbers") {
  // By 2^-108 of its size: less than a sum in twice the precision may drop.
  CHECK_BOTH(irg::hypot(0x1.1ffb15664fa6p+56, -0x1.7ffcb8eb4b067p+29, -0x1.7ffcb8eb4b067p+29) == 0x1.1ffb15664fa61p+56);
}

TEST_CASE("lengths near both ends of the range") {
  CHECK_BOTH(irg::hypot(3e300, 4e300) == 5e300);
  CHECK_BOTH(irg::hypot(3 * 0x1p-1074, 4 * 0x1p-1074) == 5 * 0x1p-1074);
  CHECK_BOTH(irg::hypot(2 * 0x1p-1074, 3 * 0x1p-1074, 6 * 0x1p-1074) == 7 * 0x1p-1074);
  CHECK_BOTH(irg::hypot(largest, 1.0) == largest);
  CHECK_BOTH(irg::hypot(largest, largest) == inf);
  CHECK_BOTH(irg::hypot(0x1p-1074, largest) == largest);
  CHECK_BOTH(irg::hypot(3e38f, 3e38f) == std::numeric_limits<float>::infinity());
  CHECK_BOTH(irg::hypot(1e38f, 1e38f, 1e38f) == 1.73205078e38f);
  CHECK_BOTH(irg::hypot(3 * 0x1p-149f, 4 * 0x1p-149f) == 5 * 0x1p-149f);
  CHECK_BOTH(same(irg::hypot(0.0, -0.0), 0.0));
}

TEST_CASE("infinity outweighs NaN") {
  CHECK_BOTH(irg::hypot(-inf, no_number) == inf);
  CHECK_BOTH(irg::hypot(1.0, no_number, inf) == inf);
  CHECK_BOTH(same(irg::hypot(no_number, 0.0), no_number));
  CHECK_BOTH(same(irg::hypot(1.0, 2.0, no_number), no_number));
}

TEST_CASE("constant evaluation and run time give the same bits") {
  CHECK_SAME_LIVES_2(irg::hypot, 0.1, 0.7);
  CHECK_SAME_LIVES_2(irg::hypot, 1.1e-310, 3.3e-309);
  CHECK_SAME_LIVES_2(irg::hypot, 1.3e-308, 1.9e-308);
  CHECK_SAME_LIVES_2(irg::hypot, 1.1e307, -3.3e305);
  CHECK_SAME_LIVES_2(irg::hypot, 0.1f, -3.3e5f);
}

TEST_CASE("order and signs of the coordinates do not matter") {
  test::random r(1);
  for (int i = 0; i < 20000; ++i) {
    const double x = test::between(r, -1, 1), y = test::between(r, -3, 3), z = test::of_exponent(r, -10, 3);
    const double length = irg::hypot(x, y, z);
    CHECK(same(length, irg::hypot(z, -x, y)));
    CHECK(same(length, irg::hypot(y, z, -x)));
    CHECK(same(irg::hypot(x, y), irg::hypot(-y, x)));
    CHECK(same(std::ldexp(length, 600), irg::hypot(std::ldexp(x, 600), std::ldexp(y, 600), std::ldexp(z, 600))));
  }
}

#ifdef IRG_HAVE_MPFR
TEST_CASE("lengths stay within 0.50001 ulp") {
  using test::random;
  using result = test::pair_of_doubles;
  const auto two = [](double x, double y) { return irg::hypot(x, y); };
  const auto exact_two = [](mpfr_ptr out, mpfr_ptr x, mpfr_ptr y) { mpfr_hypot(out, x, y, MPFR_RNDN); };
  // Of three: the third coordinate is half of the second.
  const auto three = [](double x, double y) { return irg::hypot(0.5 * y, x, y); };
  const auto exact_three = [](mpfr_ptr out, mpfr_ptr x, mpfr_ptr y) {
    test::real square;
    mpfr_sqr(square, y, MPFR_RNDN);
    mpfr_mul_d(square, square, 1.25, MPFR_RNDN);
    mpfr_sqr(out, x, MPFR_RNDN);
    mpfr_add(out, out, square, MPFR_RNDN);
    mpfr_sqrt(out, out, MPFR_RNDN);
  };
  const auto any = [](random& r) { return result{test::any_double(r), test::any_double(r)}; };
  const auto unit = [](random& r) { return result{test::between(r, -1, 1), test::between(r, -1, 1)}; };
  const auto mixed = [](random& r) { return result{test::of_exponent(r, -30, 30), test::of_exponent(r, -30, 30)}; };
  const auto at = [](double scale) {
    return [scale](random& r) { return result{scale * test::between(r, -1, 1), 2 * scale * test::between(r, -1, 1)}; };
  };
  const int n = test::count_of(20000);
  const auto both = [&](const char* range, auto generate) {
    test::check_ulp((std::string("hypot of two") + range).c_str(), 0.50001, two, exact_two, generate, n);
    test::check_ulp((std::string("hypot of three") + range).c_str(), 0.50001, three, exact_three, generate, n);
  };
  both(", all doubles", any);
  both(", unit", unit);
  both(", mixed", mixed);
  both(", largest", at(0x1p1022));
  both(", near 2^-400", at(0x1p-400));
  // Even multiples of the smallest double, whose halves are exact.
  both(", subnormal", [](random& r) {
    const auto even = [&] { return static_cast<double>(r.integer(-999999, 999999)) * 0x1p-1073; };
    const double x = even();
    return result{x, even()};
  });
  for (const float y : {0.7f, 1e-40f, 3e38f})
    test::check_floats(
        "hypot with a fixed y", 0.5001, [y](float x) { return irg::hypot(x, y); },
        [y](double x) { return std::hypot(x, static_cast<double>(y)); },
        [y](mpfr_ptr out, mpfr_ptr x) { mpfr_hypot(out, x, test::real(static_cast<double>(y)), MPFR_RNDN); });
}

TEST_CASE("float pairs: lengths") {
  test::check_float_pairs(
      "hypot", 0.5001, [](float x, float y) { return irg::hypot(x, y); },
      [](double x, double y) { return std::hypot(x, y); },
      [](mpfr_ptr out, mpfr_ptr x, mpfr_ptr y) { mpfr_hypot(out, x, y, MPFR_RNDN); }, 10, 10);
}

TEST_CASE_TEMPLATE("lengths stay within their bound where they are subnormal, and for mixed magnitudes", T, double,
                   float) {
  constexpr int lowest = std::numeric_limits<T>::min_exponent - std::numeric_limits<T>::digits;  // of the smallest
  constexpr int normal = std::numeric_limits<T>::min_exponent - 1, highest = std::numeric_limits<T>::max_exponent - 1;
  test::random r(21);
  // A number of random bits whose exponent is anything from `low` to `high`.
  const auto number = [&](int low, int high) {
    const auto k = static_cast<int>(r.integer(low, high));
    return test::either_sign(r, static_cast<double>(std::ldexp(static_cast<T>(1 + r.unit()), k)));
  };
  test::real exact, square;
  double worst = 0;
  const int n = test::count_of(100'000);
  for (int i = 0; i < n; ++i) {
    const int low = i % 4 == 0 ? lowest : i % 4 == 1 ? normal - 3 : lowest - 1;
    const int high = i % 4 == 0 ? highest : i % 4 == 1 ? normal + 1 : normal;
    double c[3] = {number(low, high), number(low, high), i % 3 == 0 ? 0 : number(low, high)};
    mpfr_set_zero(exact, 1);
    for (const double x : c) {
      mpfr_set_d(square, x, MPFR_RNDN);
      mpfr_sqr(square, square, MPFR_RNDN);
      mpfr_add(exact, exact, square, MPFR_RNDN);
    }
    mpfr_sqrt(exact, exact, MPFR_RNDN);
    const T got = irg::hypot(static_cast<T>(c[0]), static_cast<T>(c[1]), static_cast<T>(c[2]));
    worst = std::fmax(worst, test::ulp_error(got, exact));
  }
  MESSAGE("hypot, subnormal and mixed: ", worst, " ulp on ", n, " vectors");
  CHECK(worst <= (sizeof(T) == 4 ? 0.5001 : 0.50001));
}
#else
TEST_CASE("error bounds") { MESSAGE("skipped: MPFR was not found"); }
#endif

TEST_CASE("hypot_from_root: the bits of hypot, one by one and in registers") {
  CHECK_BOTH(irg::sum_of_squares(2.0, -3.0, 6.0) == 49);
  CHECK_BOTH(irg::sum_of_squares(0x1p-30 + 1, 0x1p-60) == 1 + 0x1p-29 + 0x1p-60);
  CHECK_BOTH(irg::hypot_from_root(49.0, 7.0, 2.0, 3.0, 6.0) == 7);
  test::random r(67);
  using F = irg::pack<double, 4>;
  int differ = 0;
  for (int i = 0; i < 20'000; ++i) {
    const double size = std::ldexp(1.0, static_cast<int>(r.integer(-390, 390)));
    const double x = size * r.unit(), y = size * r.unit(), z = size * r.unit();
    const double square = irg::sum_of_squares(x, y, z);
    const double due = irg::hypot(x, y, z);
    differ += irg::hypot_from_root(square, irg::sqrt(square), x, y, z) != due;
    const auto all = [](double v) { return irg::lanes<F>::broadcast(v); };
    const F squares = irg::sum_of_squares(all(x), all(y), all(z));
    const F lengths = irg::hypot_from_root(squares, irg::square_root_instruction(squares), all(x), all(y), all(z));
    differ += lengths[0] != due || lengths[3] != due;
  }
  CHECK(differ == 0);
}
