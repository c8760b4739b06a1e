// SPDX-License-Identifier: MIT
#include <irg/math/inverse.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include <irg/math/exact_matrix.hpp>

#include "support/big_rational.hpp"
#include "support/check_both.hpp"
#include "support/random.hpp"
#include "support/rational.hpp"

using irg::identity_matrix;
using irg::inverse;
using irg::inverse_accurate;
using irg::inverse_exact;
using irg::inverse_fast;
using irg::mat;
using test::rational;

namespace {

template <class T>
using mat3 = mat<T, 3, 3>;
using mat4 = mat<double, 4, 4>;

// An orthogonal matrix, up to rounding.
[[maybe_unused]] mat4 turned(test::random& r) {
  mat4 a = identity_matrix<double, 4>();
  for (int i = 0; i < 4; ++i)
    for (int j = i + 1; j < 4; ++j) {
      const double angle = 6.3 * r.unit(), c = std::cos(angle), s = std::sin(angle);
      mat4 turn = identity_matrix<double, 4>();
      turn(i, i) = turn(j, j) = c;
      turn(i, j) = -s;
      turn(j, i) = s;
      a = a * turn;
    }
  return a;
}

// A matrix of the condition number k, in one of three ways: steps between the singular values, one small one, one large.
[[maybe_unused]] mat4 of_condition(test::random& r, double k, int way) {
  mat4 s{};
  for (int i = 0; i < 4; ++i) s(i, i) = way == 0 ? std::pow(k, -i / 3.0) : (way == 1 ? i < 3 : i < 1) ? 1 : 1 / k;
  const mat4 first = turned(r);
  return first * s * turned(r);
}

#ifdef IRG_HAVE_MPFR

using test::big_rational;
using exact4 = mat<big_rational, 4, 4>;

template <class T>
exact4 exact_of(const mat<T, 4, 4>& a) {
  return irg::generate_mat<big_rational, 4, 4>(
      [&](int i, int j) { return big_rational(static_cast<double>(a(i, j))); });
}

// The largest error of an entry, over the largest entry; the largest error relative to the entry itself; in u.
struct errors {
  double of_norm = 0, of_entry = 0;
};
template <class T>
errors errors_of(const mat<T, 4, 4>& got, const exact4& exact) {
  constexpr double u = static_cast<double>(std::numeric_limits<T>::epsilon()) / 2;
  double worst = 0, largest = 0;
  errors e;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) {
      if (!std::isfinite(got(i, j))) return {HUGE_VAL, HUGE_VAL};
      const double error = test::distance(static_cast<double>(got(i, j)), exact(i, j));
      const double size = std::fabs(static_cast<double>(exact(i, j)));
      worst = std::max(worst, error);
      largest = std::max(largest, size);
      if (error > 0) e.of_entry = std::max(e.of_entry, error / size / u);
    }
  e.of_norm = worst / largest / u;
  return e;
}

double condition_of(const mat4& a, const exact4& x) {
  return irg::norm_1(a) *
         irg::norm_1(irg::generate_mat<double, 4, 4>([&](int i, int j) { return static_cast<double>(x(i, j)); }));
}

#endif

}  // namespace

TEST_CASE("inverse: the course's values") {
  using R = rational;
  constexpr mat3<R> A{{{1, 2, 3}, {2, 1, 3}, {4, 5, 1}}}, B{{{-1, 2, -3}, {5, -2, 7}, {-4, -1, 3}}};
  CHECK_BOTH(*inverse(A) ==
             mat3<R>{{{R(-7, 12), R(13, 24), R(1, 8)}, {R(5, 12), R(-11, 24), R(1, 8)}, {R(1, 4), R(1, 8), R(-1, 8)}}});
  CHECK_BOTH(
      *inverse(B) ==
      mat3<R>{{{R(-1, 48), R(1, 16), R(-1, 6)}, {R(43, 48), R(5, 16), R(1, 6)}, {R(13, 48), R(3, 16), R(1, 6)}}});
  CHECK_BOTH(A * *inverse(B) ==
             mat3<R>{{{R(31, 12), R(5, 4), R(2, 3)}, {R(5, 3), 1, R(1, 3)}, {R(14, 3), 2, R(1, 3)}}});
  // Correctly rounded in floats.
  constexpr mat3<double> a{{{1, 2, 3}, {2, 1, 3}, {4, 5, 1}}};
  constexpr mat3<double> x{{{-7. / 12, 13. / 24, 1. / 8}, {5. / 12, -11. / 24, 1. / 8}, {1. / 4, 1. / 8, -1. / 8}}};
  CHECK_BOTH((*inverse_accurate(a) == x && *inverse_exact(a) == x));
  constexpr mat3<float> f{{{1, 2, 3}, {2, 1, 3}, {4, 5, 1}}};
  constexpr mat3<float> y{
      {{-7.f / 12, 13.f / 24, 1.f / 8}, {5.f / 12, -11.f / 24, 1.f / 8}, {1.f / 4, 1.f / 8, -1.f / 8}}};
  CHECK_BOTH((*inverse_accurate(f) == y && *inverse_exact(f) == y));
}

TEST_CASE("inverse: one result in every life") {
  constexpr mat3<double> ordinary{{{0.1, 0.7, -0.3}, {1.3, 0.2, 0.9}, {-0.4, 0.6, 1.1}}};
  volatile double one = 1;
  constexpr auto plain = *inverse(ordinary), accurate = *inverse_accurate(ordinary), exact = *inverse_exact(ordinary);
  CHECK(*inverse(ordinary * one) == plain);
  CHECK(*inverse_accurate(ordinary * one) == accurate);
  CHECK(*inverse_exact(ordinary * one) == exact);
  CHECK(accurate == exact);
  // In lanes and without, by cofactors and by elimination.
  constexpr mat4 motion{{{0.6, -0.8, 0, 12.3}, {0.8, 0.6, 0, -4.5}, {0, 0, 1, 100}, {0, 0, 0, 1}}};
  constexpr mat4 skew{{{1, 2, 3, 4}, {1, 2, 3, 4.001}, {0.1, 0.7, -0.3, 0}, {1.3, 0.2, 0.9, 1}}};
  constexpr mat<float, 4, 4> single{{{1, 2, 3, 4}, {1, 2, 3, 5}, {0.1f, 0.7f, -0.3f, 0}, {1.3f, 0.2f, 0.9f, 1}}};
  constexpr auto back = *inverse(motion), straight = *inverse(skew);
  constexpr auto narrow = *inverse(single);
  CHECK((*inverse(motion * one) == back && *inverse(skew * one) == straight));
  CHECK(*inverse(single * static_cast<float>(one)) == narrow);
  constexpr auto fast = inverse_fast(motion);
  CHECK(inverse_fast(motion * one) == fast);
  constexpr mat4 tiny = irg::identity_matrix<double, 4>() * 1e-80;  // a determinant that 1 is not divided by
  CHECK_BOTH(*inverse(tiny) == irg::identity_matrix<double, 4>() * (1 / 1e-80));
}

TEST_CASE("inverse: affine stays affine, for points as columns and as rows") {
  test::random r(8);
  for (int i = 0; i < 300; ++i) {
    mat4 a = irg::identity_matrix<double, 4>();
    for (int y = 0; y < 3; ++y)
      for (int x = 0; x < 4; ++x) a(y, x) = r.unit() - 0.5;
    const auto column = inverse(a), row = inverse(transpose(a));
    CHECK((column && row));
    if (!column || !row) continue;
    for (int k = 0; k < 4; ++k) CHECK(((*column)(3, k) == (k == 3 ? 1 : 0) && (*row)(k, 3) == (k == 3 ? 1 : 0)));
  }
}

TEST_CASE("inverse: rationals and floats agree on small integers") {
  test::random r(3);
  int singular = 0;
  for (int i = 0; i < 1000; ++i) {
    mat<rational, 4, 4> a{};
    for (auto& row : a.m)
      for (rational& entry : row) entry = r.integer(-2, 2);
    const auto undo = inverse(a);
    CHECK(undo.has_value() == (determinant(a) != rational(0)));
    singular += undo ? 0 : 1;
    if (undo) CHECK((*undo * a == identity_matrix<rational, 4>() && a * *undo == identity_matrix<rational, 4>()));
    // The same matrix in floats: absent exactly when singular.
    const auto b =
        irg::generate_mat<float, 4, 4>([&](int y, int x) { return static_cast<float>(static_cast<double>(a(y, x))); });
    CHECK(inverse(b).has_value() == undo.has_value());
    CHECK(inverse_accurate(b).has_value() == undo.has_value());
    CHECK(inverse_exact(b).has_value() == undo.has_value());
    if (!undo) continue;
    const auto nearest = irg::generate_mat<float, 4, 4>(
        [&](int y, int x) { return static_cast<float>(static_cast<double>((*undo)(y, x))); });
    CHECK(*inverse_exact(b) == nearest);
    const mat<float, 4, 4> difference = *inverse_accurate(b) - nearest;
    for (const auto& row : difference.m)
      for (const float entry : row) CHECK(std::fabs(entry) <= 1e-20f);  // an exact 0 may come out tiny
  }
  CHECK(singular > 20);
}

TEST_CASE("inverse: degenerate and hostile") {
  constexpr double inf = std::numeric_limits<double>::infinity(), none = std::numeric_limits<double>::quiet_NaN();
  CHECK_BOTH((!inverse(mat3<double>{}) && !inverse_accurate(mat3<double>{}) && !inverse_exact(mat3<double>{})));
  CHECK_BOTH(!inverse(mat<double, 1, 1>{{{0.0}}}));
  CHECK_BOTH(*inverse(mat<double, 1, 1>{{{4.0}}}) == mat<double, 1, 1>{{{0.25}}});
  constexpr mat<double, 2, 2> broken[] = {{{{none, 1}, {1, 1}}},
                                          {{{1, 0}, {0, none}}},
                                          {{{inf, 1}, {1, 1}}},
                                          {{{1e-320, 0}, {0, 1}}},  // its inverse does not fit
                                          {{{1, 2}, {2, 4}}}};
  for (const auto& a : broken) CHECK((!inverse(a) && !inverse_accurate(a) && !inverse_exact(a)));
  static_assert(!inverse(broken[0]) && !inverse(broken[1]) && !inverse(broken[2]) && !inverse(broken[4]));
  CHECK_BOTH((!inverse(mat4{{{none, 1, 2, 3}, {inf, 1, 0, 0}, {0, 0, 1, inf}, {-inf, 0, 0, 1}}})));
  CHECK_BOTH(
      (!inverse(mat<float, 4, 4>{{{1, 1, 2, 3}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, static_cast<float>(inf)}}})));
  CHECK_BOTH((!inverse(mat<double, 5, 5>{{{none, inf}, {1}, {0, 1}, {0, 0, 1}, {0, 0, 0, 1}}})));
  CHECK_BOTH(!inverse(mat3<double>{{{1, 2, 3}, {4, 5, 6}, {7, 8, 9}}}));
  CHECK_BOTH(!inverse_accurate(mat3<double>{{{1, 2, 3}, {4, 5, 6}, {7, 8, 9}}}));
  CHECK_BOTH(!inverse_exact(mat3<double>{{{1, 2, 3}, {4, 5, 6}, {7, 8, 9}}}));
  // A zero on the diagonal needs the exchange of rows; permutations are their own transposes' inverses.
  CHECK_BOTH(*inverse(mat<double, 2, 2>{{{0, 1}, {1, 0}}}) == mat<double, 2, 2>{{{0, 1}, {1, 0}}});
  int order[] = {0, 1, 2, 3};
  do {
    mat4 p{};
    for (int i = 0; i < 4; ++i) p(i, order[i]) = 1;
    CHECK((*inverse(p) == transpose(p) && *inverse_accurate(p) == transpose(p) && *inverse_exact(p) == transpose(p)));
  } while (std::next_permutation(order, order + 4));
  // Small, or badly scaled, is not singular.
  CHECK(inverse(mat<double, 2, 2>{{{1e-7, 0}, {0, 1e-7}}}).has_value());  // Hank's values
  constexpr mat3<double> wide{{{0x1p-900, 0, 0}, {0, 0, 0x1p900}, {0, 1, 0}}};
  constexpr mat3<double> wide_inverse{{{0x1p900, 0, 0}, {0, 0, 1}, {0, 0x1p-900, 0}}};
  CHECK_BOTH((*inverse(wide) == wide_inverse && *inverse_accurate(wide) == wide_inverse));
  CHECK_BOTH(*inverse_exact(wide) == wide_inverse);
  // A tiny pivot must not be divided by while there is a larger one.
  CHECK_BOTH(*inverse(mat<double, 2, 2>{{{1e-20, 1}, {1, 1}}}) == mat<double, 2, 2>{{{-1, 1}, {1, -1e-20}}});
  // Equal rows up to rounding: no wild result, and the right one where it is asked for.
  constexpr mat3<double> near_singular{{{0.1, 0.2, 0.3}, {0.3, 0.6000000000000001, 0.9}, {1, 2, 4}}};
  CHECK_BOTH((!inverse(near_singular) && inverse_exact(near_singular)));
  // The largest and the smallest numbers there are.
  constexpr double huge = std::numeric_limits<double>::max(), tiny = 0x1p-1074;
  CHECK_BOTH((*inverse_exact(mat<double, 2, 2>{{{huge, 0}, {0, huge}}}))(0, 0) == 1 / huge);
  CHECK_BOTH((*inverse_exact(mat<double, 2, 2>{{{huge, huge}, {-huge, huge}}}))(0, 0) == 0.5 / huge);
  CHECK_BOTH(!inverse_exact(mat<double, 2, 2>{{{tiny, 0}, {0, tiny}}}));
  // Elimination overflows on the way, the inverse does not.
  for (const double size : {huge, -0x1p1023, 0x1p-1024}) {
    const auto x = inverse(mat<double, 2, 2>{{{size, size}, {-size, size}}});
    CHECK((x && *x == mat<double, 2, 2>{{{0.5 / size, -0.5 / size}, {0.5 / size, 0.5 / size}}}));
    mat<double, 5, 5> wider = identity_matrix<double, 5>();
    wider(0, 0) = wider(0, 4) = wider(4, 4) = size, wider(4, 0) = -size;
    const auto y = inverse(wider);
    CHECK((y && (*y)(0, 0) == 0.5 / size && (*y)(0, 4) == -0.5 / size && (*y)(4, 0) == 0.5 / size && (*y)(2, 2) == 1));
  }
  const auto single = inverse(mat<float, 3, 3>{{{3e38f, 3e38f, 0}, {-3e38f, 3e38f, 0}, {0, 0, 1}}});
  CHECK((single && (*single)(0, 0) == 0.5f / 3e38f && (*single)(1, 0) == (*single)(0, 0)));
  CHECK_BOTH(*inverse_exact(mat<double, 2, 2>{{{0, 0x1p-1022}, {0x1p1022, tiny}}}) ==
             mat<double, 2, 2>{{{-tiny, 0x1p-1022}, {0x1p1022, 0}}});
}

TEST_CASE("inverse: Hilbert matrices") {
  const auto hilbert = []<int N>(std::integral_constant<int, N>) {
    return irg::generate_mat<double, N, N>([](int y, int x) { return 1.0 / (y + x + 1); });
  };
  const auto h4 = inverse(hilbert(std::integral_constant<int, 4>{}));
  CHECK(h4.has_value());
  if (h4) CHECK((*h4)(3, 3) == doctest::Approx(2800).epsilon(1e-10));
  // Condition 1.5e10 at size 8, where 1/3 is rounded: the true inverse of the rounded matrix is not all integers.
  const auto rounded = hilbert(std::integral_constant<int, 8>{});
  const auto h8 = inverse(rounded), a8 = inverse_accurate(rounded);
  CHECK((h8 && a8));
  if (h8 && a8) CHECK((*h8)(7, 7) == doctest::Approx((*a8)(7, 7)).epsilon(1e-5));
  CHECK(!inverse(hilbert(std::integral_constant<int, 13>{})));
  CHECK(!inverse_accurate(hilbert(std::integral_constant<int, 14>{})));
}

#ifdef IRG_HAVE_MPFR

TEST_CASE("inverse: error against condition, against rationals") {
  test::random r(11);
  const int count = std::getenv("IRG_RELEASE_TIER") != nullptr ? 3000 : 12;
  double fast = 0, plain = 0, accurate = 0, exact = 0, tenfold = 1;
  for (int power = 0; power <= 18; ++power)
    for (int i = 0; i < count; ++i) {
      const mat4 a = of_condition(r, std::pow(10.0, power), i % 3);
      const auto truth = inverse(exact_of(a));
      const auto x = inverse(a), better = inverse_accurate(a), best = inverse_exact(a);
      CHECK(best.has_value() == truth.has_value());
      if (!truth || !best) continue;
      const double condition = condition_of(a, *truth);
      if (power <= 1) fast = std::max(fast, errors_of(inverse_fast(a), *truth).of_norm / condition);
      if (x) plain = std::max(plain, errors_of(*x, *truth).of_norm / condition);
      if (better) accurate = std::max(accurate, errors_of(*better, *truth).of_norm);
      exact = std::max(exact, errors_of(*best, *truth).of_entry);
      // Up to 1e14 every tier must answer; what is answered beyond has digits.
      if (condition < 1e14) CHECK((x && better));
      if (condition < 1e14) {
        const double ratio = irg::reciprocal_condition(a) * condition;
        tenfold = std::max({tenfold, ratio, 1 / ratio});
      }
    }
  MESSAGE("relative errors: fast ", fast, " and plain ", plain, " u*condition, accurate ", accurate, " u, exact ",
          exact, " u; condition found within a factor ", tenfold);
  CHECK(fast <= 8);
  CHECK(plain <= 8);
  CHECK(accurate <= 1.1);
  CHECK(exact <= 1.0000001);
  CHECK(tenfold <= 1.1);
}

TEST_CASE("inverse: singular and nearly so, never garbage") {
  test::random r(12);
  const int count = std::getenv("IRG_RELEASE_TIER") != nullptr ? 100000 : 300;
  int refused = 0;
  for (int i = 0; i < count; ++i) {
    // Integer rows, one the sum of multiples of two others, scaled by powers of two: exactly singular; then one entry
    // moves by an ulp.
    mat4 a{};
    for (int c = 0; c < 4; ++c) {
      for (int row = 0; row < 3; ++row) a(row, c) = static_cast<double>(r.integer(-1000000, 1000000));
      a(3, c) = 3 * a(0, c) - 5 * a(i % 3, c);
    }
    CHECK((!inverse(a) && !inverse_accurate(a) && !inverse_exact(a)));
    a(3, 1) = std::nextafter(a(3, 1), HUGE_VAL);
    const auto truth = inverse(exact_of(a));
    const auto x = inverse_exact(a), y = inverse(a), z = inverse_accurate(a);
    CHECK(x.has_value() == truth.has_value());
    refused += y ? 0 : 1;
    if (truth && x) CHECK(errors_of(*x, *truth).of_entry <= 1.0000001);
    if (truth && y) CHECK(errors_of(*y, *truth).of_norm * 0x1p-53 < 1);
    if (truth && z) CHECK(errors_of(*z, *truth).of_norm <= 1.1);
  }
  CHECK(refused > count / 2);
}

TEST_CASE("inverse: mixed exponents, against rationals") {
  test::random r(13);
  double exact = 0, accurate = 0, single = 0;
  for (int i = 0; i < 200; ++i) {
    mat4 a{};
    for (auto& row : a.m)
      for (double& entry : row) entry = std::ldexp(r.unit() - 0.5, static_cast<int>(r.integer(-100, 100)));
    const auto truth = inverse(exact_of(a));
    const auto x = inverse_exact(a), y = inverse_accurate(a);
    CHECK((truth && x));
    if (truth && x) exact = std::max(exact, errors_of(*x, *truth).of_entry);
    if (truth && y) accurate = std::max(accurate, errors_of(*y, *truth).of_norm);
    const auto f = irg::generate_mat<float, 4, 4>(
        [&](int p, int q) { return static_cast<float>(std::ldexp(a(p, q), a(p, q) > 1 || a(p, q) < -1 ? -90 : 10)); });
    const auto f_truth = inverse(exact_of(f));
    const auto g = inverse_exact(f);
    if (f_truth && g) {
      const errors e = errors_of(*g, *f_truth);
      bool normal = true;
      for (const auto& row : g->m)
        for (const float entry : row) normal = normal && (entry == 0 || std::fabs(entry) >= 0x1p-126f);
      if (normal) single = std::max(single, e.of_entry);
    }
  }
  MESSAGE("relative errors: exact ", exact, " u, accurate ", accurate, " u, float exact ", single, " u");
  CHECK(exact <= 1.0000001);
  CHECK(accurate <= 1.1);
  CHECK(single <= 1.0000001);
}

#endif
