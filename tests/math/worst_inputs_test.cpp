// SPDX-License-Identifier: MIT
// The worst inputs that bench/accuracy found, by function: what is beside is the error it measured, in ulp.
#include <array>
#include <cmath>

#include <irg/math/compensated.hpp>
#include <irg/math/exponential.hpp>
#include <irg/math/inverse.hpp>
#include <irg/math/exact_matrix.hpp>
#include <irg/math/length.hpp>
#include <irg/math/lu.hpp>
#include <irg/math/trigonometry.hpp>

#include "support/big_rational.hpp"
#include "support/check_both.hpp"
#include "support/ulp.hpp"

#ifdef IRG_HAVE_MPFR

namespace {

using test::big_rational;
using vec3 = irg::vec<double, 3>;
using vec4 = irg::vec<double, 4>;
using mat4 = irg::mat<double, 4, 4>;

constexpr double bound_of(double) { return 0.55; }
constexpr double bound_of(float) { return 0.5001; }

#define IRG_WORST_1(function, x)                                                       \
  do {                                                                                 \
    test::real exact(static_cast<double>(x));                                          \
    mpfr_##function(exact, exact, MPFR_RNDN);                                          \
    CHECK(test::ulp_error(irg::function(test::at_run_time(x)), exact) <= bound_of(x)); \
  } while (false)
#define IRG_WORST_2(function, x, y)                                                                          \
  do {                                                                                                       \
    test::real exact(static_cast<double>(x)), other(static_cast<double>(y));                                 \
    mpfr_##function(exact, exact, other, MPFR_RNDN);                                                         \
    CHECK(test::ulp_error(irg::function(test::at_run_time(x), test::at_run_time(y)), exact) <= bound_of(x)); \
  } while (false)

/// The square root of the sum of the squares, rounded to 300 bits.
void exact_length(mpfr_ptr out, const vec3& v) {
  mpfr_set_zero(out, 1);
  for (int i = 0; i < 3; ++i) {
    test::real square(v[i]);
    mpfr_sqr(square, square, MPFR_RNDN);
    mpfr_add(out, out, square, MPFR_RNDN);
  }
  mpfr_sqrt(out, out, MPFR_RNDN);
}

}  // namespace

TEST_CASE("worst inputs: elementary functions") {
  IRG_WORST_1(sin, 0x1.7ca8c45c06887p+1);  // 0.5139
  IRG_WORST_1(sin, 0x1.930b1aa8459f2p+466);  // 0.511
  IRG_WORST_1(sin, 0x1.3ae1bcp+18f);  // 0.5
  IRG_WORST_1(cos, 0x1.f265a4f33c0d7p+79);  // 0.5137
  IRG_WORST_1(cos, -0x1.555324c09a536p+0);  // 0.5098
  IRG_WORST_1(cos, 0x1.9261aep+17f);  // 0.5
  IRG_WORST_1(tan, 0x1.59e18a1fc250ap+18);  // 0.5044
  IRG_WORST_1(tan, 0x1.73e877a2b9edbp-1);  // 0.5022
  IRG_WORST_1(tan, 0x1.d766f6p+19f);  // 0.4999
  IRG_WORST_1(asin, 0x1.260156849ac2ap-1);  // 0.5018
  IRG_WORST_1(asin, 0x1.2105643049da3p-19);  // 0.4997
  IRG_WORST_1(asin, 0x1.1bce04p-1f);  // 0.4999
  IRG_WORST_1(acos, -0x1.62d0ad0884988p-2);  // 0.5
  IRG_WORST_1(acos, -0x1.ce6d4e0518b8ap-19);  // 0.4996
  IRG_WORST_1(acos, -0x1.8ca59ep-1f);  // 0.5
  IRG_WORST_1(atan, 0x1.49db32979674p+39);  // 0.5
  IRG_WORST_1(atan, -0x1.1597032271964p-12);  // 0.4992
  IRG_WORST_1(atan, -0x1.c412eep+22f);  // 0.4992
  IRG_WORST_1(exp, 0x1.c94e2b3de05b6p+8);  // 0.5014
  IRG_WORST_1(exp, 0x1.c42d29fa04e74p+5);  // 0.5004
  IRG_WORST_1(exp, -0x1.74789p+4f);  // 0.4999
  IRG_WORST_1(exp2, -0x1.2513125676fe3p+6);  // 0.5014
  IRG_WORST_1(exp2, -0x1.ba7a62p+5f);  // 0.5
  IRG_WORST_1(log, 0x1.0000000000006p+0);  // 0.5
  IRG_WORST_1(log, 0x1.69b3ca35b2f62p+1);  // 0.4999
  IRG_WORST_1(log, 0x1.fffffcp-1f);  // 0.5
  IRG_WORST_1(log2, 0x1.00003609bc047p+0);  // 0.4999
  IRG_WORST_1(log2, 0x1.57a15c660ec5dp-2);  // 0.4975
  IRG_WORST_1(log2, 0x1.3273aep+22f);  // 0.4999
  IRG_WORST_1(log10, 0x1.000000000002dp+0);  // 0.4998
  IRG_WORST_1(log10, 0x1.084ed7dee610ap-21);  // 0.4998
  IRG_WORST_1(log10, 0x1.445acp+56f);  // 0.4999
  IRG_WORST_1(cbrt, 0x1.0ed27ce2b2766p+40);  // 0.4998
  IRG_WORST_1(cbrt, 0x1.e4b44c5bd6138p+707);  // 0.4998
  IRG_WORST_1(cbrt, -0x1.a657fep-21f);  // 0.4999
  IRG_WORST_1(sqrt, 0x1.557e7148a4f7p+449);  // 0.4999
  IRG_WORST_1(sqrt, 0x1.038450cee5dbdp-8);  // 0.4999
  IRG_WORST_1(sqrt, 0x1.92bb3p-4f);  // 0.4998
  IRG_WORST_2(atan2, 0x1.87fa543afb617p-4, 0x1.285b139e01835p+317);  // 0.4999
  IRG_WORST_2(atan2, 0x1.a4095afa62509p+49, -0x1.41b0d78200778p+40);  // 0.4999
  IRG_WORST_2(atan2, -0x1.f1813cp-22f, -0x1.b6f9ap-8f);  // 0.4998
  IRG_WORST_2(pow, 0x1.ff848780cfa1bp-1, 0x1.861f10b4f4cdap+11);  // 0.5009
  IRG_WORST_2(pow, 0x1.0a57a5b5c3da4p+3, 0x1.a4f0bdac2c92ep+3);  // 0.5008
  IRG_WORST_2(pow, 0x1.6dff98p+2f, -0x1.e4b1ccp+0f);  // 0.5
  IRG_WORST_2(hypot, 0x1.adf6642ee1e7p+0, 0x1.451198facf9c6p+0);  // 0.4999
  IRG_WORST_2(hypot, -0x1.ce0b55be86d4ep-23, -0x1.bb678d45cf575p-13);  // 0.4999
  IRG_WORST_2(hypot, 0x1.dfda08p+0f, 0x1.029bb8p+0f);  // 0.5
}

TEST_CASE("worst inputs: lengths and directions") {
  constexpr vec3 lengths[] = {{0x1.17c4853e2caa9p-1, 0x1.17c4853e2caa9p-1, -0x1.17c4853e2caa9p-1},
                              {0x1.cee81bc4ea348p-1, -0x1.6c650185680a1p-15, -0x1.c7e1023bbe06dp-9},
                              {0x1.6fe4d34ef35b8p-1, 0x0p+0, 0x1.e686d82d71af8p-2}};
  constexpr vec3 directions[] = {{-0x0.0000000fba862p-1022, -0x0.0000000350e4dp-1022, -0x0.000000027b4ddp-1022},
                                 {0x1.46996010bf844p-2, -0x1.1e02fd9b55e3p-4, -0x1.e6563c5a9dc76p-1},
                                 {0x1.46996010bf844p+1018, -0x1.1e02fd9b55e3p+1016, -0x1.e6563c5a9dc76p+1019}};
  test::real exact, part;
  for (const vec3& v : lengths) {
    exact_length(exact, v);
    CHECK(test::ulp_error(irg::length(v), exact) <= 0.501);
  }
  for (const vec3& v : directions) {
    exact_length(exact, v);
    const vec3 unit = irg::normalized(v);
    for (int i = 0; i < 3; ++i) {
      mpfr_d_div(part, v[i], exact, MPFR_RNDN);
      CHECK(test::ulp_error(unit[i], part) <= 1.51);
    }
  }
}

TEST_CASE("worst inputs: products") {
  CHECK(test::error_in_ulp(irg::difference_of_products(0x1.06e679c4b5abcp+9, 0x1.2fd6bc0bbb3acp+8,
                                                       -0x1.24c7b1d5b140ep+2, -0x1.10d497c651a78p+15),
                           big_rational(0x1.06e679c4b5abcp+9) * big_rational(0x1.2fd6bc0bbb3acp+8) -
                               big_rational(-0x1.24c7b1d5b140ep+2) * big_rational(-0x1.10d497c651a78p+15)) <= 0.51);
  CHECK(test::error_in_ulp(irg::difference_of_products(-0x1.d52dbfac96da5p+1, -0x1.b085e35a180dbp+6,
                                                       0x1.470c057e1f899p-7, 0x1.363f31f809979p+15),
                           big_rational(-0x1.d52dbfac96da5p+1) * big_rational(-0x1.b085e35a180dbp+6) -
                               big_rational(0x1.470c057e1f899p-7) * big_rational(0x1.363f31f809979p+15)) <= 0.51);
  const auto dot = [](const vec4& a, const vec4& b) {
    big_rational sum = 0;
    for (int i = 0; i < 4; ++i) sum = sum + big_rational(a[i]) * big_rational(b[i]);
    return sum;
  };
  constexpr vec4 a0{0x1.73fadbce0a913p-2, 0x1.ed748b7eba497p+2, -0x1.8044b4757a88cp+1, -0x1.801e323a5ad3ap-3},
      b0{0x1.510d293c15923p+1, 0x1.6db121344dfddp+1, 0x1.e9fe1382f0119p+2, -0x1.044327bdfbf16p-38};
  CHECK(test::error_in_ulp(irg::dot_accurate(a0, b0), dot(a0, b0)) <= 0.51);
  constexpr vec4 a1{-0x1.5bc85c31c3747p-2, -0x1.85d3d77c0a5a8p+2, 0x1.4eb7f4764e2cap-3, -0x1.c3ea96a294fep-3},
      b1{-0x1.4fb355dffc288p-1, -0x1.c370c2eceed68p+2, -0x1.083ef4281912p+8, -0x1.5efa186abe85p-46};
  CHECK(test::error_in_ulp(irg::dot_exact(a1, b1), dot(a1, b1)) <= 0.5);
  constexpr vec3 c{-0x1.46f679a685c65p-1, -0x1.67d5cf30690aap-2, -0x1.d53489bf9a4b8p-1},
      d{0x1.e78f915ac0af6p+2, 0x1.0c4a2dae8b64dp+2, 0x1.5dd5c4e6d63bp+3};
  const vec3 across = irg::cross_accurate(c, d);
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    CHECK(test::error_in_ulp(
              across[i], big_rational(c[j]) * big_rational(d[k]) - big_rational(c[k]) * big_rational(d[j])) <= 0.51);
  }
}

TEST_CASE("worst inputs: inverses") {
  constexpr mat4 all[] = {
      {{{0x1.2f50fca13a50ap-2, 0x1.9965e410e8269p-3, -0x1.18184fb55119p-3, 0x1.a43a989b9f3fp-2},
        {-0x1.3af33f94c7a24p-2, -0x1.3ced3a65869d2p-2, 0x1.74282b482f79bp-3, -0x1.5eb6566a752c9p-1},
        {0x1.bef066feb08bap-4, 0x1.859de566e7a38p-2, -0x1.96b7a1014f804p-1, -0x1.d68127d6ba59cp-2},
        {0x1.cb614e8c34686p-1, -0x1.f1b08f48975c2p-3, 0x1.80e9aeb4f2f92p-3, -0x1.3a8d17a4fce21p-2}}},
      {{{-0x1.3a98b3d554916p-6, -0x1.d195184243273p-2, -0x1.dedf500ead3d9p-3, 0x1.f3942984cd13cp-3},
        {-0x1.590c93d361ffep-5, -0x1.1db8f74dd0afp-1, -0x1.577ef23c734cap-2, 0x1.076004554f08p-1},
        {0x1.503af4d104f6ap-4, -0x1.70b3460dd03f6p-3, -0x1.579ea2abe47b7p-1, -0x1.6ba154205a2b3p-1},
        {-0x1.f7978f2c98505p-7, 0x1.573a3cb011eefp-1, -0x1.3c4d68aee60b2p-1, 0x1.9d9bccb33ac39p-2}}},
      {{{0x1.711cd4fb50933p-5, 0x1.4e0f9c5c0a492p-4, 0x1.0e4aeeb637609p-2, 0x1.b4b5bae07e47ep-1},
        {-0x1.dd0a27f023e1bp-4, 0x1.5d047ed4f0153p-2, -0x1.bee5390252c0dp-3, 0x1.c1b8a77859921p-2},
        {-0x1.d945d8b99e8b9p-7, 0x1.8d88e05c05494p-5, -0x1.52c0229e9a5a6p-6, 0x1.61da3c4b90d32p-4},
        {-0x1.10d609e4459cap-2, 0x1.1829e86063e5ep-1, -0x1.539b41d4db72bp-1, -0x1.c6ae7d7dfa97ap-5}}},
      {{{0x1.0c9714fbcda3bp-6, 0x1.0842108421084p-6, 0x1.041041041041p-6, 0x1p-6},
        {0x1.0842108421084p-6, 0x1.041041041041p-6, 0x1p-6, 0x1.f81f81f81f82p-7},
        {0x1.041041041041p-6, 0x1p-6, 0x1.f81f81f81f82p-7, 0x1.f07c1f07c1f08p-7},
        {0x1p-6, 0x1.f81f81f81f82p-7, 0x1.f07c1f07c1f08p-7, 0x1.e9131abf0b767p-7}}},
      {{{0x1.0b741cd879314p-2, 0x0p+0, 0x1.7a224ac960a47p+0, 0x1.8b49d5b995b68p+16},
        {0x0p+0, 0x1p+1, 0x0p+0, 0x1.acdc9621aea1p+18},
        {0x1.f82db91d6bb7bp-1, 0x0p+0, -0x1.649ad12c98cd2p-3, 0x1.7450280f82b0ap+19},
        {0x1.f82db90c80db4p-1, 0x0p+0, -0x1.649ad120a197p-3, 0x1.74506803048a6p+19}}}};
  for (const mat4& a : all) {
    const auto truth =
        inverse(irg::generate_mat<big_rational, 4, 4>([&](int r, int c) { return big_rational(a(r, c)); }));
    const auto accurate = inverse_accurate(a), exact = inverse_exact(a);
    REQUIRE((truth && accurate && exact));
    big_rational largest = 0;
    for (int i = 0; i < 16; ++i)
      if (const big_rational size = abs((*truth)(i / 4, i % 4)); largest < size) largest = size;
    for (int i = 0; i < 16; ++i) {
      const big_rational& want = (*truth)(i / 4, i % 4);
      CHECK(test::error_in_ulp((*exact)(i / 4, i % 4), want) <= 0.5);
      CHECK(test::distance((*accurate)(i / 4, i % 4), want) <= 1.1 * 0x1p-53 * largest.rounded());
    }
  }
}

#endif
