// SPDX-License-Identifier: MIT
#include <irg/math/expansion.hpp>

#include <irg/math/exact_sum.hpp>

#include "math/mixed_cases.hpp"
#include "support/check_both.hpp"
#include "support/ulp.hpp"

using namespace irg;

namespace {

/// The turn of three points written as it stands in a textbook.
constexpr int turn(double ax, double ay, double bx, double by, double cx, double cy) {
  return sign(exact_difference_of(ax, cx) * exact_difference_of(by, cy) -
              exact_difference_of(ay, cy) * exact_difference_of(bx, cx));
}

/// Whether the parts are in order and do not overlap: each is less than a unit of the last set bit of the next.
template <int N>
bool is_proper(const expansion<double, N>& e) {
  for (int i = 0; i < e.size; ++i) {
    if (e.parts[i] == 0) return false;
    if (i == 0) continue;
    int exponent = 0;
    const double significand = std::frexp(e.parts[i], &exponent);
    const auto digits = static_cast<std::uint64_t>(std::fabs(significand) * 0x1p53);
    const double unit = std::ldexp(static_cast<double>(digits & (~digits + 1)), exponent - 53);
    if (std::fabs(e.parts[i - 1]) >= unit) return false;
  }
  return true;
}

template <int N>
bool same_number(const expansion<double, N>& e, exact_accumulator<4> exact) {
  for (int i = 0; i < e.size; ++i) exact.subtract(e.parts[i]);
  return exact.sign() == 0;
}

double any(test::random& r) { return test::either_sign(r, test::of_exponent(r, -60, 60)); }

}  // namespace

static_assert(noexcept(expansion_of(1.0) * expansion_of(2.0)));
static_assert(std::is_same_v<decltype(expansion_of(1.0) * exact_sum_of(1.0, 2.0)), expansion<double, 4>>);

TEST_CASE("expansion: by hand") {
  CHECK_BOTH(exact_sum_of(1.0, 0x1p-80).size == 2);
  CHECK_BOTH(exact_sum_of(1.0, 2.0).size == 1);
  CHECK_BOTH(expansion_of(0.0).size == 0);
  CHECK_BOTH(sign(exact_sum_of(1.0, 0x1p-80) - expansion_of(1.0)) == 1);
  CHECK_BOTH(estimate(exact_sum_of(1.0, 0x1p-80) - expansion_of(1.0)) == 0x1p-80);
  CHECK_BOTH(sign(-(exact_sum_of(1.0, 0x1p-80) + -1.0)) == -1);
  CHECK_BOTH(sign(exact_product_of(0.1, 0.3) - exact_product_of(0.3, 0.1)) == 0);
  CHECK_BOTH(estimate(exact_sum_of(1.0, 0x1p-80) * exact_sum_of(1.0, -0x1p-80) - expansion_of(1.0)) == -0x1p-160);
  CHECK_BOTH(estimate(exact_sum_of(1.0f, 0x1p-60f) * exact_sum_of(1.0f, -0x1p-60f) - expansion_of(1.0f)) == -0x1p-120f);
  CHECK_BOTH(compress(exact_sum_of(1.0, 0x1p-80) + expansion_of(1.0)).size == 2);
  CHECK_BOTH(sign(expansion_of(0.0) * exact_sum_of(1.0, 2.0)) == 0);
  CHECK_BOTH(compress(expansion_of(0.0)).size == 0);
}

TEST_CASE("expansion: a turn by one unit in the last place, far from the line's points") {
  CHECK_BOTH(turn(0.5, 0.5, 12, 12, 24, 24) == 0);
  CHECK_BOTH(turn(0.5 + 0x1p-53, 0.5, 12, 12, 24, 24) == -1);
  CHECK_BOTH(turn(0.5, 0.5 + 0x1p-53, 12, 12, 24, 24) == 1);
}

TEST_CASE("expansion: the stated ends of the range for products of two") {
  constexpr double low = 0x1p-484, high = 0x1p500;
  CHECK_BOTH(turn(low * 3, low * 5, low * 9, low * 15, low * 27, low * 45) == 0);
  CHECK_BOTH(turn(low * 3, low * 5, low * 9, low * 15, low * 27, low * 45 * (1 + 0x1p-52)) == 1);
  CHECK_BOTH(turn(high * 0.1, high * 0.3, high * 0.2, high * 0.6, high * 0.4, high * 1.2) == 0);
  CHECK_BOTH(sign(exact_product_of(low * (1 + 0x1p-52), low) - exact_product_of(low, low)) == 1);
}

TEST_CASE("expansion: operations give the exact number in proper form") {
  test::random r(1);
  for (int i = 0, n = test::count_of(5000); i < n; ++i) {
    const double a = any(r), b = any(r), c = any(r), d = r.next() % 8 == 0 ? a : any(r);
    const auto e = exact_sum_of(a, b);
    const auto f = exact_difference_of(c, d);
    exact_accumulator<4> sum, difference, product, fourth;
    sum.add(a), sum.add(b), sum.add(c), sum.subtract(d);
    difference.add(a), difference.add(b), difference.subtract(c), difference.add(d);
    product.add(a, c), product.add(b, c), product.subtract(a, d), product.subtract(b, d);
    CHECK(same_number(e + f, sum));
    CHECK(same_number(e - f, difference));
    const auto p = e * f;
    CHECK(same_number(p, product));
    CHECK(is_proper(p));
    CHECK(is_proper(e + f));
    CHECK(sign(p) == product.sign());
    const auto small = compress(p);
    CHECK(same_number(small, product));
    CHECK(is_proper(small));
    CHECK(small.size <= p.size);
    if (sign(p) != 0) {
      CHECK(std::fabs(estimate(p) - product.rounded()) <= std::fabs(product.rounded()) * 0x1p-52);
      CHECK(std::fabs(small.parts[small.size - 1] - product.rounded()) <= std::fabs(product.rounded()) * 0x1p-52);
    }
    // Squares of squares cancel to zero.
    CHECK(sign(p * e - e * p) == 0);
    fourth.add(a, b, c, d);
    CHECK(same_number(exact_product_of(a, b) * exact_product_of(c, d), fourth));
    CHECK(same_number(exact_product_of(a, b) * c * d, fourth));
    exact_accumulator<4> grown = product;
    grown.add(d);
    CHECK(same_number(p + d, grown));
  }
}

#ifdef IRG_HAVE_MPFR

namespace {
namespace sweeps {

using namespace test::mixed;
using test::mixed::rational;

template <class T, int N>
big_rational rational(const irg::expansion<T, N>& e) {
  big_rational sum = 0;
  for (int i = 0; i < e.size; ++i) sum = sum + rational(e.parts[i]);
  return sum;
}
// A number of such a size that products of n of them are exact in expansions.
template <class T>
T number_for_products(test::random& r, sizes which, int n) {
  constexpr int low = std::numeric_limits<T>::min_exponent - std::numeric_limits<T>::digits;
  constexpr int high = sizeof(T) == 8 ? 1000 : 120;
  for (;;) {
    const T x = number<T>(r, which == sizes::subnormal ? sizes::all : which);
    if (x == 0 || (std::fabs(x) <= std::ldexp(T(1), high / n) &&
                   std::fabs(x) >= std::ldexp(T(1), std::numeric_limits<T>::digits + low / n)))
      return x;
    if (which == sizes::roots_of_largest) return std::ldexp(x, -std::ilogb(x));
  }
}

TEST_CASE_TEMPLATE("expansion: numbers of all sizes", T, double, float) {
  sweep("expansion, sums", 1, [](test::random& r, sizes which) {
    irg::expansion<T, 4> e{};
    big_rational want = 0;
    const T a = number<T>(r, which), b = number<T>(r, which), c = number<T>(r, which), d = number<T>(r, which);
    e = irg::exact_sum_of(a, b) + irg::exact_difference_of(c, d);
    want = rational(a) + rational(b) + rational(c) - rational(d);
    if (!(rational(e) == want) || sign(e) != want.sign() || !(rational(compress(e)) == want)) return 1e9;
    const auto small = compress(e);
    const T last = small.size == 0 ? T(0) : small.parts[small.size - 1];
    return std::fmax(test::error_in_ulp(estimate(e), want), test::error_in_ulp(last, want));
  });
  sweep("expansion, products", 1, [](test::random& r, sizes which) {
    const T a = number_for_products<T>(r, which, 4), b = number_for_products<T>(r, which, 4);
    const T c = number_for_products<T>(r, which, 4), d = number_for_products<T>(r, which, 4);
    const auto e = (irg::exact_product_of(a, b) + d * d) * (irg::exact_sum_of(c, d) * a);
    const big_rational want = (rational(a) * rational(b) + rational(d * d)) * (rational(c) + rational(d)) * rational(a);
    if (!(rational(e) == want) || sign(e) != want.sign()) return 1e9;
    return test::error_in_ulp(estimate(e), want);
  });
}

}  // namespace sweeps
}  // namespace

#endif
