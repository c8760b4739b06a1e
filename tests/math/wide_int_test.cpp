// SPDX-License-Identifier: MIT
#include <irg/math/wide_int.hpp>

#include <cstdint>
#include <limits>
#include <type_traits>

#ifdef IRG_HAVE_MPFR
#include <gmp.h>
#endif

#include "support/check_both.hpp"
#include "support/random.hpp"

using irg::wide_int;

namespace {

__extension__ typedef __int128 int128;
constexpr std::int64_t low = std::numeric_limits<std::int64_t>::min(), high = std::numeric_limits<std::int64_t>::max();

constexpr int128 to_int128(const wide_int<2>& v) {
  __extension__ typedef unsigned __int128 uint128;
  return static_cast<int128>((uint128{v.word[1]} << 64) | v.word[0]);
}

// Words that are often all zeros, all ones, or near a sign bit.
template <int N>
constexpr wide_int<N> hard_number(test::random& r) {
  wide_int<N> v;
  for (std::uint64_t& w : v.word) {
    const std::uint64_t some[] = {0, ~std::uint64_t{0}, std::uint64_t{1} << 63, (std::uint64_t{1} << 63) - 1,
                                  1, r.next()};
    w = some[r.integer(0, 5)];
  }
  return v;
}

}  // namespace

TEST_CASE("wide_int: values of built-in integers") {
  static_assert(std::is_trivially_copyable_v<wide_int<3>> && sizeof(wide_int<3>) == 24);
  CHECK_BOTH(wide_int<3>().sign() == 0);
  CHECK_BOTH(wide_int<3>(-1).sign() == -1);
  CHECK_BOTH(wide_int<1>(high).sign() == 1);
  CHECK_BOTH(wide_int<3>(-1) == wide_int<3>(wide_int<1>(-1)));
  CHECK_BOTH(wide_int<2>(~std::uint64_t{0}).sign() == 1);
  CHECK_BOTH(wide_int<3>(int128{low} * 2) == wide_int<3>(wide_int<1>(low)) + wide_int<3>(low));
  CHECK_BOTH(wide_int<2>(int128{-5}) < wide_int<2>(3));
  CHECK_BOTH(wide_int<4>(-5) < wide_int<4>(-4));
  CHECK_BOTH(wide_int<4>(7) > wide_int<4>(6));
  CHECK_BOTH((wide_int<4>(7) <=> wide_int<4>(7)) == 0);
  CHECK_BOTH(-wide_int<2>(low) == wide_int<2>(int128{1} << 63));
}

TEST_CASE("wide_int: products in full, and sums that carry through all words") {
  constexpr wide_int<1> a(low), b(high);
  CHECK_BOTH(a * a == wide_int<2>(int128{1} << 126));
  CHECK_BOTH(a * b == wide_int<2>(int128{low} * high));
  constexpr wide_int<4> square = (a * a) * (a * a);  // 2^252
  CHECK_BOTH(square.word[3] == std::uint64_t{1} << 60);
  CHECK_BOTH((square - wide_int<4>(1)).word[0] == ~std::uint64_t{0});
  CHECK_BOTH((square - wide_int<4>(1)) + wide_int<4>(1) == square);
  CHECK_BOTH((square * a).sign() == -1);
  CHECK_BOTH(square * a == a * square);
  CHECK_BOTH((wide_int<5>(-1) * wide_int<5>(-1)) == wide_int<10>(1));
}

TEST_CASE("wide_int: two words as 128 bits") {
  test::random r(1);
  for (int i = 0; i < 100'000; ++i) {
    const wide_int<2> a = hard_number<2>(r), b = hard_number<2>(r);
    const int128 x = to_int128(a), y = to_int128(b);
    __extension__ typedef unsigned __int128 uint128;
    REQUIRE(to_int128(a + b) == static_cast<int128>(static_cast<uint128>(x) + static_cast<uint128>(y)));
    REQUIRE(to_int128(a - b) == static_cast<int128>(static_cast<uint128>(x) - static_cast<uint128>(y)));
    REQUIRE((a < b) == (x < y));
    REQUIRE((a == b) == (x == y));
    REQUIRE(a.sign() == (x < 0 ? -1 : x > 0 ? 1 : 0));
  }
}

#ifdef IRG_HAVE_MPFR

namespace {

template <int N>
void to_mpz(mpz_t out, const wide_int<N>& v) {
  const wide_int<N> size = v.is_negative() ? -v : v;  // as an unsigned number right for the least one, too
  mpz_import(out, N, -1, 8, 0, 0, size.word);
  if (v.is_negative()) mpz_neg(out, out);
}
// Whether v is x, reduced to N words.
template <int N>
bool is_reduced(const wide_int<N>& v, mpz_t x, mpz_t scratch) {
  to_mpz(scratch, v);
  mpz_sub(scratch, scratch, x);
  return mpz_divisible_2exp_p(scratch, 64 * N) != 0;
}

template <int N, int M>
void compare(int trials) {
  test::random r(N * 10 + M);
  mpz_t x, y, z, scratch;
  mpz_inits(x, y, z, scratch, nullptr);
  for (int i = 0; i < trials; ++i) {
    const auto a = hard_number<N>(r), c = hard_number<N>(r);
    const auto b = hard_number<M>(r);
    to_mpz(x, a), to_mpz(y, b);
    mpz_mul(z, x, y);
    const auto product = a * b;
    to_mpz(scratch, product);
    REQUIRE(mpz_cmp(scratch, z) == 0);
    REQUIRE(product.sign() == mpz_sgn(z));
    to_mpz(y, c);
    mpz_add(z, x, y);
    REQUIRE(is_reduced(a + c, z, scratch));
    mpz_sub(z, x, y);
    REQUIRE(is_reduced(a - c, z, scratch));
    REQUIRE((a < c) == (mpz_cmp(x, y) < 0));
    REQUIRE((a == c) == (mpz_cmp(x, y) == 0));
    REQUIRE(a.sign() == mpz_sgn(x));
    const wide_int<N + 1> more = a;
    to_mpz(scratch, more);
    REQUIRE(mpz_cmp(scratch, x) == 0);
  }
  mpz_clears(x, y, z, scratch, nullptr);
}

}  // namespace

TEST_CASE("wide_int: against GMP") {
  compare<1, 1>(5'000), compare<2, 1>(10'000), compare<1, 2>(5'000), compare<2, 2>(10'000);
  compare<3, 1>(5'000), compare<3, 2>(5'000), compare<2, 3>(5'000), compare<4, 2>(5'000), compare<4, 4>(5'000);
  compare<5, 3>(5'000), compare<6, 4>(5'000);
}

#endif
