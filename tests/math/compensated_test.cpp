// SPDX-License-Identifier: MIT
#include <irg/math/compensated.hpp>

#include <array>
#include <vector>

#include <irg/math/vec.hpp>

#include "math/mixed_cases.hpp"
#include "support/check_both.hpp"
#include "support/exact.hpp"
#include "support/ulp.hpp"

using namespace irg;

namespace {

using v2 = vec<double, 2>;
using v3 = vec<double, 3>;
using v4 = vec<double, 4>;
using f3 = vec<float, 3>;
constexpr double largest = std::numeric_limits<double>::max();
constexpr double smallest = 0x1p-1074;
constexpr double inf = std::numeric_limits<double>::infinity();

constexpr std::array<double, 3> swallowed{1, 0x1p-60, -1};
constexpr std::array<double, 4> far{largest, largest, -largest, -largest};
constexpr std::array<float, 3> tie{16777216, 1, 0x1p-140f};

/// Vectors whose dot product is smaller than its terms by about 2^-cancelled: the last two coordinates undo the first
/// two.
void make_hard(test::random& r, int cancelled, v4& a, v4& b) {
  const auto any = [&] { return test::either_sign(r, test::of_exponent(r, -2, 2)); };
  a = {any(), any(), any(), 1}, b = {any(), any(), 0, 0};
  exact_accumulator<2> sum;
  sum.add(a.x, b.x), sum.add(a.y, b.y);
  b.z = -sum.rounded() / a.z * (1 + test::between(r, -1, 1) * std::ldexp(1.0, -cancelled));
  sum.add(a.z, b.z);
  b.w = cancelled < 40 ? 0 : -sum.rounded() + test::between(r, -1, 1) * std::ldexp(1.0, -cancelled);
}

}  // namespace

static_assert(std::is_same_v<decltype(dot_accurate(f3{}, f3{})), float> && noexcept(dot_exact(v3{}, v3{})));
static_assert(std::is_same_v<decltype(cross_accurate(std::array<double, 3>{}, v3{})), std::array<double, 3>>);

TEST_CASE("compensated: by hand") {
  CHECK_BOTH(dot_accurate(v3{1, 2, 3}, v3{4, -5, 6}) == 12);
  CHECK_BOTH(dot_exact(v3{1, 2, 3}, v3{4, -5, 6}) == 12);
  CHECK_BOTH(dot_accurate(v3{1, 0x1p-60, -1}, v3{1, 1, 1}) == 0x1p-60);
  CHECK_BOTH(dot_accurate(v2{1 + 0x1p-30, 1 + 0x1p-29}, v2{1 + 0x1p-30, -1}) == 0x1p-60);
  CHECK_BOTH(dot_accurate(f3{1 + 0x1p-20f, 1 + 0x1p-19f, 0}, f3{1 + 0x1p-20f, -1, 7}) == 0x1p-40f);
  CHECK_BOTH(sum_accurate(std::span<const double>(swallowed)) == 0x1p-60);
  CHECK_BOTH(sum_exact(std::span<const double>(swallowed)) == 0x1p-60);
  CHECK_BOTH(sum_accurate(std::span<const double>{}) == 0);
  CHECK_BOTH(cross_accurate(v3{1, 0, 0}, v3{0, 1, 0}) == v3{0, 0, 1});
  CHECK_BOTH(irg::detail::nearest_cross(f3{1, 2, 3}, f3{4, 5, 6}) == f3{-3, 6, -3});
}

TEST_CASE("compensated: both ends of the range") {
  CHECK_BOTH(sum_accurate(std::span<const double>(far)) == 0);
  CHECK_BOTH(sum_exact(std::span<const double>(far)) == 0);
  CHECK_BOTH(sum_exact(std::span<const double>(far).first(2)) == inf);
  CHECK_BOTH(dot_accurate(v3{largest, largest, 1}, v3{largest, -largest, 5}) == 5);
  CHECK_BOTH(dot_accurate(v3{largest, 0, 0}, v3{2, 0, 0}) == inf);
  CHECK_BOTH(dot_accurate(v3{smallest, smallest, 0}, v3{0.5, 0.5, 0}) == smallest);
  CHECK_BOTH(dot_accurate(v2{smallest, smallest}, v2{0.25, 0.25}) == 0);  // half of it: the tie goes to even
  CHECK_BOTH(dot_accurate(v2{0x1p1023, 1}, v2{smallest, 0}) == 0x1p-51);
  CHECK_BOTH(dot_exact(f3{3e38f, -3e38f, 1e-45f}, f3{3e38f, 3e38f, 1}) == 1e-45f);
  CHECK_BOTH(cross_accurate(v3{largest, largest, 0}, v3{largest, largest, 0}) == v3{});
  CHECK_BOTH(cross_accurate(v3{smallest, 0, 0}, v3{0, 1, 0}) == v3{0, 0, smallest});
  CHECK_BOTH(cross_accurate(v3{smallest, smallest, 0}, v3{-0.5, 0.5, 0}) == v3{0, 0, smallest});
}

TEST_CASE("compensated: NaN and infinity are answered as plain sums are") {
  const double nan_ = test::at_run_time(std::nan(""));
  CHECK(std::isnan(dot_accurate(v3{nan_, 1, 1}, v3{0, 1, 1})));
  CHECK(std::isnan(dot_exact(v3{1, 1, 1}, v3{0, nan_, 1})));
  CHECK(dot_accurate(v3{inf, 1, 1}, v3{1, 1, 1}) == inf);
  CHECK(std::isnan(cross_accurate(v3{nan_, 1, 1}, v3{1, 2, 3}).y));
  const std::vector<double> opposite{inf, 1, -inf};
  CHECK(std::isnan(sum_accurate(std::span<const double>(opposite))));
  CHECK(sum_exact(std::span<const double>(opposite).first(2)) == inf);
}

TEST_CASE("compensated: a float is rounded once, not by way of double") {
  // 2^24 + 1 + a little: to double it is a tie between two floats, and only the little tells.
  CHECK_BOTH(sum_exact(std::span<const float>(tie)) == 16777218.0f);
  CHECK_BOTH(dot_exact(f3{16777216, 1, 0x1p-140f}, f3{1, 1, 1}) == 16777218.0f);
  CHECK_BOTH(dot_exact(f3{16777216, 1, 0x1p-140f}, f3{1, 1, -1}) == 16777216.0f);
}

TEST_CASE("compensated: the cross product of parallel vectors is exactly zero") {
  test::random r(1);
  for (int i = 0; i < 20000; ++i) {
    const v3 a{test::any_double(r), test::any_double(r), test::any_double(r)};
    CHECK(cross_accurate(a, a) == v3{});
    CHECK(irg::detail::nearest_cross(a, a) == v3{});
    const v3 b{std::ldexp(a.x, -3), std::ldexp(a.y, -3), std::ldexp(a.z, -3)};
    const bool exact = std::ldexp(b.x, 3) == a.x && std::ldexp(b.y, 3) == a.y && std::ldexp(b.z, 3) == a.z;
    if (exact) CHECK(cross_accurate(a, b) == v3{});
    const f3 c{static_cast<float>(r.unit()), static_cast<float>(r.unit()), static_cast<float>(r.unit())};
    CHECK(cross_accurate(c, c) == f3{});
  }
}

#ifdef IRG_HAVE_MPFR
namespace {

/// Sums of products without an error: 9000 bits hold every sum of two products of doubles.
struct oracle {
  mpfr_t sum, term;
  oracle() { mpfr_inits2(9000, sum, term, static_cast<mpfr_ptr>(nullptr)), mpfr_set_zero(sum, 1); }
  oracle(const oracle&) = delete;
  oracle& operator=(const oracle&) = delete;
  ~oracle() { mpfr_clears(sum, term, static_cast<mpfr_ptr>(nullptr)); }
  void add(double x, double y) {
    mpfr_set_d(term, x, MPFR_RNDN);
    mpfr_mul_d(term, term, y, MPFR_RNDN);
    mpfr_add(sum, sum, term, MPFR_RNDN);
  }
};
double nearest(const oracle& o, double) { return mpfr_get_d(o.sum, MPFR_RNDN); }
float nearest(const oracle& o, float) { return mpfr_get_flt(o.sum, MPFR_RNDN); }

/// How far a number is from the exact one, as part of what n of them in twice the precision are promised: u of the
/// result and n^2 u^2 of the sum of the sizes.
double part_of_bound(double got, const oracle& exact, double sizes, double n) {
  oracle off;
  mpfr_sub_d(off.sum, exact.sum, got, MPFR_RNDN);
  const double bound = std::fabs(mpfr_get_d(exact.sum, MPFR_RNDN)) * 0x1p-53 + n * n * sizes * 0x1p-106;
  return bound == 0 ? 0 : std::fabs(mpfr_get_d(off.sum, MPFR_RNDN)) / bound;
}

/// The worst error counts dot products of doubles up to a condition of 10^14, and all others.
template <class V>
void compare(const V& a, const V& b, double& worst) {
  oracle exact;
  double sizes = 0;
  for (int i = 0; i < size_of<V>; ++i) {
    exact.add(static_cast<double>(a[i]), static_cast<double>(b[i]));
    sizes += std::fabs(static_cast<double>(a[i])) * std::fabs(static_cast<double>(b[i]));
  }
  // The sign of a zero is not promised.
  CHECK(dot_exact(a, b) + 0 == nearest(exact, scalar_of<V>()) + 0);
  const bool well_conditioned = 2 * sizes <= 1e14 * std::fabs(mpfr_get_d(exact.sum, MPFR_RNDN));
  if (sizeof(a[0]) == sizeof(double) && sizes < 0x1p900 && sizes > 0x1p-900)
    CHECK(part_of_bound(static_cast<double>(dot_accurate(a, b)), exact, sizes, size_of<V>) <= 1);
  if (well_conditioned || std::isinf(sizes) || sizeof(a[0]) == sizeof(float))
    worst = std::max(worst, test::ulp_error(dot_accurate(a, b), exact.sum));
}

}  // namespace

TEST_CASE("compensated: dot products against MPFR, condition 1 to 2^150") {
  test::random r(2);
  double worst = 0, worst_float = 0, worst_anywhere = 0;
  for (int i = 0, n = test::count_of(20000); i < n; ++i) {
    const int cancelled = static_cast<int>(r.integer(0, 150));
    v4 a, b;
    make_hard(r, cancelled, a, b);
    compare(a, b, worst);
    const auto single = [](const v4& v) {
      return generate_coordinates<vec<float, 4>>([&](int k) { return static_cast<float>(v[k]); });
    };
    compare(single(a), single(b), worst_float);
    const auto any = [&] { return v4{test::any_double(r), test::any_double(r), test::any_double(r), 0}; };
    const v4 c = any(), d = any();
    compare(c, d, worst_anywhere);
  }
  CHECK(worst <= 1);
  CHECK(worst_float <= 1);
  CHECK(worst_anywhere <= 1);
  MESSAGE("dot_accurate ", worst, " ulp, float ", worst_float, ", all doubles ", worst_anywhere);
}

TEST_CASE("compensated: cross products against MPFR") {
  test::random r(3);
  double worst = 0, worst_float = 0;
  for (int i = 0, n = test::count_of(10000); i < n; ++i) {
    const bool anywhere = i % 4 == 0;
    const auto any = [&] { return anywhere ? test::any_double(r) : test::between(r, -1, 1); };
    const v3 a{any(), any(), any()};
    v3 b{any(), any(), any()};
    if (!anywhere && i % 2 == 0) {  // nearly parallel
      const double step = std::ldexp(1.0, static_cast<int>(r.integer(-60, 0)));
      b = a * 0.7 + b * step;
    }
    const v3 accurate = cross_accurate(a, b), exact = irg::detail::nearest_cross(a, b);
    const auto single = [](const v3& v) {
      return f3{static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
    };
    const f3 accurate_float = cross_accurate(single(a), single(b)),
             exact_float = irg::detail::nearest_cross(single(a), single(b));
    for (int k = 0; k < 3; ++k) {
      const int m = (k + 1) % 3, n2 = (k + 2) % 3;
      oracle of_doubles, of_floats;
      of_doubles.add(a[m], b[n2]), of_doubles.add(-a[n2], b[m]);
      worst = std::max(worst, test::ulp_error(accurate[k], of_doubles.sum));
      CHECK(exact[k] + 0 == nearest(of_doubles, 0.0) + 0);
      if (anywhere) continue;
      const f3 p = single(a), q = single(b);
      of_floats.add(static_cast<double>(p[m]), static_cast<double>(q[n2]));
      of_floats.add(-static_cast<double>(p[n2]), static_cast<double>(q[m]));
      worst_float = std::max(worst_float, test::ulp_error(accurate_float[k], of_floats.sum));
      CHECK(exact_float[k] + 0 == nearest(of_floats, 0.0f) + 0);
    }
  }
  CHECK(worst <= 1);
  CHECK(worst_float <= 1);
  MESSAGE("cross_accurate ", worst, " ulp, float ", worst_float);
}

TEST_CASE("compensated: sums against MPFR") {
  test::random r(4);
  double worst = 0;
  for (int i = 0; i < 200; ++i) {
    std::vector<double> x;
    for (int k = 0; k < 100; ++k) x.push_back(test::either_sign(r, test::of_exponent(r, -40, 0)));
    for (int k = 0; k < 100; ++k)
      x.push_back(-x[static_cast<std::size_t>(k)] * (1 + test::between(r, -1, 1) * 0x1p-30));
    if (i % 10 == 0)
      for (double& y : x) y *= 0x1p1010;
    oracle exact;
    for (const double y : x) exact.add(y, 1);
    CHECK(sum_exact(std::span<const double>(x)) == mpfr_get_d(exact.sum, MPFR_RNDN));
    worst = std::max(worst, test::ulp_error(sum_accurate(std::span<const double>(x)), exact.sum));
  }
  CHECK(worst <= 1);
  MESSAGE("sum_accurate ", worst, " ulp");
}

// Numbers of which each leaves the same rest, rounded the same way again and again: what n^2 stands for.
TEST_CASE("compensated: the bound of long and of cancelling sums") {
  test::random r(5);
  double worst = 0, worst_dot = 0, most_ulp = 0;
  for (int i = 0, count = test::trials(30); i < count; ++i) {
    std::vector<double> x{1};
    const double step = 0x1p-54 * (1 + r.unit());
    for (std::int64_t n = r.integer(1, i % 10 == 0 ? 30000 : 300); n > 0; --n)
      x.push_back(step * (i % 2 == 0 ? 1 : 1 + 0x1p-40 * r.unit()));
    x.push_back(-1);
    oracle exact;
    double sizes = 0;
    for (const double y : x) exact.add(y, 1), sizes += std::fabs(y);
    const double got = sum_accurate(std::span<const double>(x)), n = static_cast<double>(x.size());
    worst = std::max(worst, part_of_bound(got, exact, sizes, n));
    const double off = test::ulp_error(got, exact.sum);
    most_ulp = std::max(most_ulp, off);
    if (n * n * sizes <= 0x1p52 * std::fabs(mpfr_get_d(exact.sum, MPFR_RNDN))) CHECK(off <= 1);
  }
  for (int i = 0, count = test::trials(20000); i < count;
       ++i) {  // about the condition at which the two parts are alike
    v4 a, b;
    make_hard(r, static_cast<int>(r.integer(40, 60)), a, b);
    oracle exact;
    double sizes = 0;
    for (int k = 0; k < 4; ++k) exact.add(a[k], b[k]), sizes += std::fabs(a[k] * b[k]);
    worst_dot = std::max(worst_dot, part_of_bound(dot_accurate(a, b), exact, sizes, 4));
    if (16 * sizes <= 0x1p52 * std::fabs(mpfr_get_d(exact.sum, MPFR_RNDN)))
      CHECK(test::ulp_error(dot_accurate(a, b), exact.sum) <= 1);
  }
  MESSAGE("sum_accurate ", worst, " of its bound, up to ", most_ulp, " ulp; dot_accurate ", worst_dot, " of it");
  CHECK(worst <= 1);
  CHECK(worst_dot <= 1);
}

namespace {
namespace sweeps {

using namespace test::mixed;

template <class T>
void sweep_sums() {
  const auto within = [](T got, const big_rational& want, const big_rational& size) {
    const double ulp = test::error_in_ulp(got, want);
    if (ulp <= 1 || size < abs(want) * big_rational(1e14)) return ulp;
    return abs(rational(got) - want) < size * big_rational(0x1p-100) ? 1 : ulp;
  };
  sweep("sum_accurate", 1, [](test::random& r, sizes which) {
    std::array<T, 6> x{};
    big_rational sum = 0, size = 0;
    for (std::size_t i = 0; i < 6; ++i) {
      x[i] = i > 3 && r.integer(0, 1) == 0 ? -x[i - 3] * static_cast<T>(1 + r.unit() * 0x1p-20) : number<T>(r, which);
      sum = sum + rational(x[i]), size = size + abs(rational(x[i]));
    }
    return size < abs(sum) * big_rational(1e14) ? test::error_in_ulp(irg::sum_accurate(std::span<const T>(x)), sum) : 0;
  });
  sweep("dot_accurate", 1, [&](test::random& r, sizes which) {
    const auto a = vector<T, 3>(r, which), b = beside<T, 3>(r, a, all_sizes[r.integer(0, 3)]);
    big_rational dot = 0, size = 0;
    for (int i = 0; i < 3; ++i) {
      dot = dot + rational(a[i]) * rational(b[i]);
      size = size + abs(rational(a[i]) * rational(b[i])) * 2;
    }
    return within(dot_accurate(a, b), dot, size);
  });
  // The plain ones: the error in the stated units, where no product underflows.
  sweep("dot_fast, cross_fast", 1, [](test::random& r, sizes which) {
    const auto a = vector<T, 3>(r, which), b = vector<T, 3>(r, which);
    big_rational dot = 0, size = 0, product[3][3];
    const big_rational u = rational(std::numeric_limits<T>::epsilon() / 2);
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) {
        product[i][j] = rational(a[i]) * rational(b[j]);
        if (!is_inside<T>(product[i][j])) return 0.0;
        if (i == j) dot = dot + product[i][j], size = size + abs(product[i][j]);
      }
    // Coordinates that are zero leave nothing to be off by.
    const auto share = [](const big_rational& off, const big_rational& bound) {
      return off.sign() == 0 ? 0.0 : bound.sign() == 0 ? 1e9 : (off / bound).rounded();
    };
    double worst = share(abs(rational(dot_fast(a, b)) - dot), size * u * 3);
    const auto cross = cross_fast(a, b);
    for (int k = 0; k < 3; ++k) {
      const big_rational& left = product[(k + 1) % 3][(k + 2) % 3];
      const big_rational& right = product[(k + 2) % 3][(k + 1) % 3];
      const big_rational off = abs(rational(cross[k]) - (left - right));
      worst = std::fmax(worst, share(off, (abs(left) + abs(right)) * u * 2));
    }
    return worst;
  });
}

TEST_CASE_TEMPLATE("sums and products: numbers of all sizes", T, double, float) {
  const auto missed = [](T got, const big_rational& want) { return got == test::nearest<T>(want) ? 0.0 : 1.0; };
  sweep("sum_exact", 0, [&](test::random& r, sizes which) {
    std::array<T, 5> x{};
    big_rational sum = 0;
    for (T& v : x) {
      v = number<T>(r, which);
      sum = sum + rational(v);
    }
    return missed(irg::sum_exact(std::span<const T>(x)), sum);
  });
  sweep("dot_exact", 0, [&](test::random& r, sizes which) {
    const auto a = vector<T, 3>(r, which), b = vector<T, 3>(r, all_sizes[r.integer(0, 3)]);
    big_rational sum = 0;
    for (int i = 0; i < 3; ++i) sum = sum + rational(a[i]) * rational(b[i]);
    return missed(dot_exact(a, b), sum);
  });
  sweep("cross_accurate", 1, [&](test::random& r, sizes which) {
    const auto a = vector<T, 3>(r, which), b = vector<T, 3>(r, which);
    const auto c = cross_accurate(a, b);
    return test::error_in_ulp(c[0], rational(a[1]) * rational(b[2]) - rational(a[2]) * rational(b[1]));
  });
  sweep_sums<T>();
}

}  // namespace sweeps
}  // namespace

#else
TEST_CASE("error bounds") { MESSAGE("skipped: MPFR was not found"); }
#endif
