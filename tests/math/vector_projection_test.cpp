// SPDX-License-Identifier: MIT
#include <irg/math/vector_projection.hpp>

#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "math/mixed_cases.hpp"
#include "support/check_both.hpp"
#include "support/random.hpp"
#include "support/rational.hpp"

using irg::cosine_between;
using irg::dot_sign;
using irg::scalar_projection;
using irg::vec;
using irg::vector_projection;
using test::rational;

namespace {

using vec3 = vec<double, 3>;
constexpr double none = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();

}  // namespace

TEST_CASE("projection: the course's values") {
  using R = rational;
  constexpr vec3 v{1, 7, -5}, b{-1, 4, -1};
  CHECK_BOTH(*scalar_projection(v, b) == 7.542472332656507);
  CHECK_BOTH(*cosine_between(v, b) == 0.8709296863229078);
  CHECK_BOTH(*vector_projection(v, b) == vec3{-16. / 9, 64. / 9, -16. / 9});
  CHECK_BOTH(*vector_projection(vec<R, 3>{1, 7, -5}, vec<R, 3>{-1, 4, -1}) ==
             vec<R, 3>{R(-16, 9), R(64, 9), R(-16, 9)});
  CHECK_BOTH((dot_sign(v, b) == 1 && dot_sign(v, -b) == -1 && dot_sign(v, vec3{7, -1, 0}) == 0));
}

TEST_CASE("projection: degenerate and hostile") {
  constexpr vec3 zero{}, v{1, 2, 3};
  CHECK_BOTH((!scalar_projection(v, zero) && !vector_projection(v, zero) && !cosine_between(v, zero)));
  CHECK_BOTH((*scalar_projection(zero, v) == 0 && *vector_projection(zero, v) == zero && !cosine_between(zero, v)));
  CHECK_BOTH(!vector_projection(vec<rational, 2>{1, 2}, vec<rational, 2>{}));
  for (const double bad : {none, inf, -inf}) {
    CHECK((!scalar_projection(vec3{bad, 0, 0}, v) && !vector_projection(v, vec3{0, bad, 0})));
    CHECK(!cosine_between(vec3{1, bad, 0}, v));
  }
  // The ends of the range.
  CHECK_BOTH(*scalar_projection(vec3{0x1p1023, 0, 0}, vec3{0x1p-1074, 0, 0}) == 0x1p1023);
  CHECK_BOTH(*vector_projection(vec3{0x1p-1074, 0x1p-1074, 0}, vec3{0x1p1023, 0, 0}) == vec3{0x1p-1074, 0, 0});
  CHECK_BOTH(irg::magnitude(*cosine_between(vec3{0x1p1023, 0x1p1023, 0}, vec3{0x1p-1074, 0, 0}) -
                            std::numbers::sqrt2 / 2) <= 0x1p-53);
  CHECK_BOTH(*scalar_projection(vec<float, 2>{3e38f, 0}, vec<float, 2>{1e-45f, 0}) == 3e38f);
  CHECK_BOTH(dot_sign(vec3{0x1p-1074, 0x1p1023, 0}, vec3{0x1p-1074, 0, 0}) == 1);
  CHECK_BOTH(dot_sign(vec3{0x1p1023, 0x1p1023, 0x1p-1074}, vec3{0x1p1023, -0x1p1023, -1}) == -1);
  // Never beyond 1, and 1 for vectors of the same direction.
  test::random r(1);
  for (int i = 0; i < 10000; ++i) {
    const vec3 a{r.unit() - 0.5, r.unit() - 0.5, r.unit() - 0.5};
    const double c = *cosine_between(a, a * 0.1);
    CHECK((c <= 1 && c >= 1 - 0x1p-52));
  }
  CHECK_BOTH(*vector_projection(std::array<double, 2>{3, 4}, std::array<double, 2>{2, 0}) ==
             std::array<double, 2>{3, 0});
}

TEST_CASE("projection: against rationals, nearly at right angles too") {
  test::random r(2);
  double worst = 0;
  for (int i = 0; i < 5000; ++i) {
    const auto coordinate = [&] { return static_cast<double>(r.integer(-1000000, 1000000)); };
    const vec3 b{coordinate(), coordinate(), coordinate()};
    vec3 a{coordinate(), coordinate(), coordinate()};
    if (i % 2 == 0) a = irg::cross(b, vec3{1, 2, 3}) + vec3{1, 0, 0};  // almost orthogonal to b
    const auto exact = [](const vec3& v) {
      return vec<rational, 3>{rational::of(v.x), rational::of(v.y), rational::of(v.z)};
    };
    const auto truth = vector_projection(exact(a), exact(b));
    const auto got = vector_projection(a, b);
    CHECK((truth.has_value() && got.has_value()));
    if (!truth || !got) continue;
    for (int k = 0; k < 3; ++k) {
      const double t = static_cast<double>((*truth)[k]);
      if (t != 0) worst = std::fmax(worst, std::fabs((*got)[k] - t) / std::fabs(t) * 0x1p53);
    }
    const rational product = irg::dot(exact(a), exact(b));
    CHECK(dot_sign(a, b) == (rational(0) < product ? 1 : product < rational(0) ? -1 : 0));
  }
  MESSAGE("vector_projection: ", worst, " u relative");
  CHECK(worst <= 6);
}

#ifdef IRG_HAVE_MPFR

namespace {
namespace sweeps {

using namespace test::mixed;
using test::mixed::rational;

template <class T, int N>
void sweep_projections(const std::string& type) {
  test::real dot, a_length, b_length, exact, off;
  const auto judge = [&](T got, mpfr_ptr size) {
    mpfr_sub_d(off, exact, static_cast<double>(got), MPFR_RNDN);
    mpfr_mul_2si(off, off, 100, MPFR_RNDN);
    return mpfr_cmpabs(off, size) <= 0 ? 0 : test::ulp_error(got, exact);
  };
  const auto measure = [&](const vec<T, N>& a, const vec<T, N>& b) {
    set_dot(dot, a, b), set_length(a_length, a), set_length(b_length, b);
  };
  sweep("scalar_projection, " + type, 1.01, [&](test::random& r, sizes which) {
    const auto b = vector<T, N>(r, which), a = beside<T, N>(r, b, all_sizes[r.integer(0, 3)]);
    const auto got = scalar_projection(a, b);
    if (b == vec<T, N>{} || !got) return b == vec<T, N>{} && !got ? 0 : 1e9;
    measure(a, b);
    mpfr_div(exact, dot, b_length, MPFR_RNDN);
    return judge(*got, a_length);
  });
  sweep("vector_projection, " + type, 1.01, [&](test::random& r, sizes which) {
    const auto b = vector<T, N>(r, which), a = beside<T, N>(r, b, all_sizes[r.integer(0, 3)]);
    const auto got = vector_projection(a, b);
    if (b == vec<T, N>{} || !got) return b == vec<T, N>{} && !got ? 0 : 1e9;
    measure(a, b);
    double worst = 0;
    for (int i = 0; i < N; ++i) {
      mpfr_sqr(exact, b_length, MPFR_RNDN);
      mpfr_div(exact, dot, exact, MPFR_RNDN);
      mpfr_mul_d(exact, exact, static_cast<double>(b[i]), MPFR_RNDN);
      worst = std::fmax(worst, judge((*got)[i], a_length));
    }
    return worst;
  });
  test::real one(1);
  sweep("cosine_between, " + type, 0.51, [&](test::random& r, sizes which) {
    const auto b = vector<T, N>(r, which), a = beside<T, N>(r, b, all_sizes[r.integer(0, 3)]);
    const auto got = cosine_between(a, b);
    const bool none = a == vec<T, N>{} || b == vec<T, N>{};
    if (none || !got) return none && !got ? 0 : 1e9;
    measure(a, b);
    mpfr_div(exact, dot, a_length, MPFR_RNDN);
    mpfr_div(exact, exact, b_length, MPFR_RNDN);
    return *got >= -1 && *got <= 1 ? judge(*got, one) : 1e9;
  });
  sweep("dot_sign, " + type, 0, [&](test::random& r, sizes which) {
    const auto b = vector<T, N>(r, which), a = beside<T, N>(r, b, all_sizes[r.integer(0, 3)]);
    set_dot(dot, a, b);
    return dot_sign(a, b) == sign_of(dot) ? 0 : 1;
  });
}

TEST_CASE("projections: numbers of all sizes") {
  sweep_projections<double, 3>("3 doubles");
  sweep_projections<float, 3>("3 floats");
  sweep_projections<float, 4>("4 floats");
}

}  // namespace sweeps
}  // namespace

#endif
