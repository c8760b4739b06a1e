// SPDX-License-Identifier: MIT
// The lanes of matrix products and inverses against their plain bodies, bit for bit.
#include <irg/math/inverse.hpp>

#include <cstdlib>

#include "support/check_both.hpp"
#include "support/random.hpp"
#include "support/same_bits.hpp"

using irg::hpoint;
using irg::mat;
using irg::point;
using irg::vec;
using test::same_bits;

namespace {

// Ordinary, tiny, huge and special numbers.
template <class T>
constexpr T number(test::random& r, bool hostile) {
  if (hostile && r.integer(0, 7) == 0) {
    constexpr T special[] = {T(0),
                             -T(0),
                             std::numeric_limits<T>::infinity(),
                             -std::numeric_limits<T>::infinity(),
                             std::numeric_limits<T>::quiet_NaN(),
                             std::numeric_limits<T>::denorm_min(),
                             std::numeric_limits<T>::min(),
                             std::numeric_limits<T>::max()};
    return special[r.integer(0, 7)];
  }
  const auto scale = static_cast<double>(std::int64_t{1} << r.integer(0, 40));
  return static_cast<T>((2 * r.unit() - 1) * (r.integer(0, 1) ? scale : 1 / scale));
}

template <class T>
constexpr mat<T, 4, 4> matrix(test::random& r, bool hostile = false) {
  mat<T, 4, 4> a;
  for (auto& row : a.m)
    for (T& entry : row) entry = number<T>(r, hostile);
  return a;
}

// The sums as the contract writes them.
template <class T>
constexpr mat<T, 4, 4> plain_product(const mat<T, 4, 4>& a, const mat<T, 4, 4>& b) {
  return irg::generate_mat<T, 4, 4>([&](int r, int c) {
    T sum = irg::product(a(r, 0), b(0, c));
    for (int k = 1; k < 4; ++k) sum = sum + irg::product(a(r, k), b(k, c));
    return sum;
  });
}
template <class T>
constexpr T plain_row(const mat<T, 4, 4>& a, int r, const vec<T, 4>& v) {
  T sum = irg::product(a(r, 0), v[0]);
  for (int k = 1; k < 4; ++k) sum = sum + irg::product(a(r, k), v[k]);
  return sum;
}

template <class T>
int differences(int rounds, bool hostile) {
  test::random r(hostile ? 7 : 8);
  int wrong = 0;
  for (int i = 0; i < rounds; ++i) {
    const auto a = matrix<T>(r, hostile), b = matrix<T>(r, hostile);
    const vec<T, 4> v{number<T>(r, hostile), number<T>(r, hostile), number<T>(r, hostile), number<T>(r, hostile)};
    wrong += !same_bits(a * b, plain_product(a, b));
    mat<T, 4, 4> square = a;
    square = square * square;
    wrong += !same_bits(square, plain_product(a, a));
    const auto image = a * v;
    const auto position = a * hpoint<T, 3>{v.x, v.y, v.z, v.w};
    const auto at = transform_point(a, point<T, 3>{v.x, v.y, v.z});
    const auto along = transform_vector(a, vec<T, 3>{v.x, v.y, v.z});
    for (int k = 0; k < 4; ++k) {
      wrong += !same_bits(image[k], plain_row(a, k, v)) || !same_bits(position[k], image[k]);
      if (k == 3) continue;
      const T sum = (irg::product(a(k, 0), v.x) + irg::product(a(k, 1), v.y)) + irg::product(a(k, 2), v.z);
      wrong += !same_bits(at[k], sum + a(k, 3)) || !same_bits(along[k], sum);
    }
    mat<T, 4, 4> plain{};
    irg::detail::inverse4_plain(a.m, plain.m, T(0));
    mat<T, 4, 4> in_lanes{};
    irg::detail::inverse4(a.m, in_lanes.m, T(0));
    wrong += !same_bits(in_lanes, plain);
    if constexpr (irg::Floating<T>) {
      mat<T, 4, 4> by_fours{};
      irg::detail::inverse4_by_fours(a.m, by_fours.m, T(0));
      wrong += !same_bits(by_fours, plain);
    }
  }
  return wrong;
}

template <class T>
constexpr auto computed(std::uint64_t seed) {
  test::random r(seed, test::in_every_round{});
  const auto a = matrix<T>(r), b = matrix<T>(r);
  const vec<T, 4> v{number<T>(r, false), number<T>(r, false), number<T>(r, false), number<T>(r, false)};
  struct {
    mat<T, 4, 4> product, inverse;
    vec<T, 4> image;
    point<T, 3> at;
  } all{a * b, inverse_fast(a), a * v, transform_point(a, point<T, 3>{v.x, v.y, v.z})};
  return all;
}
template <class T, std::uint64_t seed>
bool same_in_constant_evaluation() {
  constexpr auto early = computed<T>(seed);
  const volatile std::uint64_t hidden = seed;
  const auto late = computed<T>(hidden);
  return same_bits(early.product, late.product) && same_bits(early.inverse, late.inverse) &&
         early.image == late.image && early.at == late.at;
}

// One row of four, and sizes that take the plain body.
template <int R, int K, int C>
bool product_of_sizes(test::random& r) {
  mat<float, R, K> a;
  mat<float, K, C> b;
  for (auto& row : a.m)
    for (float& entry : row) entry = number<float>(r, false);
  for (auto& row : b.m)
    for (float& entry : row) entry = number<float>(r, false);
  const auto p = a * b;
  for (int i = 0; i < R; ++i)
    for (int j = 0; j < C; ++j) {
      float sum = irg::product(a(i, 0), b(0, j));
      for (int k = 1; k < K; ++k) sum = sum + irg::product(a(i, k), b(k, j));
      if (!same_bits(p(i, j), sum)) return false;
    }
  return true;
}

}  // namespace

TEST_CASE("matrix lanes: the bits of the plain bodies") {
  const int rounds = std::getenv("IRG_RELEASE_TIER") ? 2'000'000 : 20'000;
  CHECK(differences<float>(rounds, false) == 0);
  CHECK(differences<double>(rounds, false) == 0);
  CHECK(differences<float>(rounds, true) == 0);
  CHECK(differences<double>(rounds, true) == 0);
}

TEST_CASE("matrix lanes: one result in every life") {
  CHECK(same_in_constant_evaluation<float, 1>());
  CHECK(same_in_constant_evaluation<float, 2>());
  CHECK(same_in_constant_evaluation<double, 3>());
  CHECK(same_in_constant_evaluation<double, 4>());
}

TEST_CASE("matrix lanes: other sizes") {
  test::random r(5);
  CHECK(product_of_sizes<3, 4, 4>(r));
  CHECK(product_of_sizes<4, 3, 4>(r));
  CHECK(product_of_sizes<4, 4, 3>(r));
  CHECK(product_of_sizes<2, 2, 2>(r));
  CHECK(product_of_sizes<1, 4, 4>(r));
  CHECK(product_of_sizes<8, 4, 4>(r));
}

TEST_CASE("matrix lanes: by hand") {
  constexpr mat<float, 4, 4> m{{{0, 2, 0, 1}, {1, 0, 0, 2}, {0, 0, 4, 3}, {0, 0, 0, 1}}};
  constexpr mat<float, 4, 4> undo{{{0, 1, 0, -2}, {.5f, 0, 0, -.5f}, {0, 0, .25f, -.75f}, {0, 0, 0, 1}}};
  CHECK_BOTH(inverse_fast(m) == undo);
  CHECK_BOTH(m * undo == irg::identity_matrix<float, 4>());
}
