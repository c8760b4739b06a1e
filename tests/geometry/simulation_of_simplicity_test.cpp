// SPDX-License-Identifier: MIT
#include <irg/geometry/simulation_of_simplicity.hpp>

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <numeric>
#include <vector>

#ifdef IRG_HAVE_MPFR
#include <gmp.h>
#endif

#include "support/check_both.hpp"
#include "support/random.hpp"
#include "support/rational.hpp"

using irg::in_circle_sos;
using irg::in_sphere_sos;
using irg::numbered_point;
using irg::orient2d_sos;
using irg::orient3d_sos;

namespace {

using P2 = irg::point<double, 2>;
using P3 = irg::point<double, 3>;
__extension__ typedef __int128 wide;

// A polynomial in infinitely small numbers e0 >> e1 >> ..., each smaller than every product of earlier ones: the term
// whose factors are the bits of the key.
using polynomial = std::map<std::uint64_t, wide>;

int sign_of(const polynomial& p) {
  for (const auto& [factors, coefficient] : p)
    if (coefficient != 0) return coefficient < 0 ? -1 : 1;
  return 0;
}

int parity(const std::vector<int>& permutation) {
  int sign = 1;
  for (std::size_t i = 0; i < permutation.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) sign = permutation[j] > permutation[i] ? -sign : sign;
  return sign;
}

// What the predicate of N points of D dimensions gives for moved points, whose moves belong to `places` in one order of
// all points: the determinant is written out as a polynomial. Bit (place, coordinate) is the same for simplices and for
// lifted points.
template <std::size_t N, int D>
int moved_sign(const std::array<irg::point<double, D>, N>& points, const std::array<int, N>& places) {
  constexpr std::size_t columns = N - 1;
  const auto entry = [&](std::size_t row, std::size_t column) -> wide {
    wide squares = 0;
    for (int j = 0; j < D; ++j) {
      const auto c = static_cast<wide>(points[row][j]);
      squares += c * c;
      if (column == static_cast<std::size_t>(j)) return c;
    }
    return column < columns ? squares : 1;
  };
  std::vector<int> order(N);
  std::iota(order.begin(), order.end(), 0);
  polynomial sum;
  do {
    polynomial term{{0, parity(order)}};
    for (std::size_t column = 0; column < N; ++column) {
      const auto row = static_cast<std::size_t>(order[column]);
      polynomial next;
      for (const auto& [factors, coefficient] : term) {
        next[factors] += coefficient * entry(row, column);
        if (column < columns)
          next[factors | std::uint64_t{1} << (places[row] * (D + 1) + D - static_cast<int>(column))] += coefficient;
      }
      term = std::move(next);
    }
    for (const auto& [factors, coefficient] : term) sum[factors] += coefficient;
  } while (std::next_permutation(order.begin(), order.end()));
  return sign_of(sum) * (D == 3 ? -1 : 1);
}

template <class... Q>
constexpr int sos(const Q&... q) {
  constexpr bool flat = requires { orient2d_sos(q...); };
  if constexpr (flat)
    return orient2d_sos(q...);
  else if constexpr (requires { orient3d_sos(q...); })
    return orient3d_sos(q...);
  else if constexpr (requires { in_circle_sos(q...); })
    return in_circle_sos(q...);
  else
    return in_sphere_sos(q...);
}

// The answers for all orders of the points are the due one times the order's sign; how many are not.
template <class Q, std::size_t N>
int wrong_orders(const std::array<Q, N>& points, int due) {
  std::vector<int> order(N);
  std::iota(order.begin(), order.end(), 0);
  int wrong = 0;
  do {
    std::array<Q, N> p = points;
    for (std::size_t i = 0; i < N; ++i) p[i] = points[static_cast<std::size_t>(order[i])];
    wrong += std::apply([](const auto&... q) { return sos(q...); }, p) != due * parity(order);
  } while (std::next_permutation(order.begin(), order.end()));
  return wrong;
}

// All subsets of N points of a lattice: without numbers and with random ones, against the moved points.
template <std::size_t N, int D>
void check_lattice(const std::vector<irg::point<double, D>>& lattice, std::size_t numbered_too) {
  const int n = static_cast<int>(lattice.size());
  std::vector<int> number(lattice.size());
  std::iota(number.begin(), number.end(), 0);
  test::random r(1);
  for (std::size_t i = number.size(); i > 1; --i)
    std::swap(number[i - 1], number[static_cast<std::size_t>(r.integer(0, static_cast<std::int64_t>(i) - 1))]);
  std::vector<bool> chosen(lattice.size());
  std::fill_n(chosen.begin(), N, true);
  std::size_t sets = 0;
  do {
    std::array<irg::point<double, D>, N> p{};
    std::array<numbered_point<irg::point<double, D>>, N> q{};
    std::array<int, N> places{}, numbers{};
    std::size_t k = 0;
    for (int i = 0; i < n; ++i) {
      if (!chosen[static_cast<std::size_t>(i)]) continue;
      places[k] = i;
      numbers[k] = number[static_cast<std::size_t>(i)];
      p[k] = lattice[static_cast<std::size_t>(i)];
      q[k] = {p[k], numbers[k]};
      ++k;
    }
    const int due = moved_sign<N, D>(p, places);
    CHECK(due != 0);
    CHECK(wrong_orders(p, due) == 0);
    for (const double scale : {0x1p-1074, 0x1p-300, 0x1p1000}) {
      auto scaled = p;
      for (auto& point : scaled)
        for (int j = 0; j < D; ++j) point[j] *= scale;
      CHECK(std::apply([](const auto&... s) { return sos(s...); }, scaled) == due);
    }
    if (sets++ < numbered_too) CHECK(wrong_orders(q, moved_sign<N, D>(p, numbers)) == 0);
  } while (std::prev_permutation(chosen.begin(), chosen.end()));
}

// The lattice's points in lexicographic order.
std::vector<P2> lattice(int columns, int rows) {
  std::vector<P2> all;
  for (int x = 0; x < columns; ++x)
    for (int y = 0; y < rows; ++y) all.push_back({static_cast<double>(x), static_cast<double>(y)});
  return all;
}
std::vector<P3> lattice(int columns, int rows, int layers) {
  std::vector<P3> all;
  for (const P2& p : lattice(columns, rows))
    for (int z = 0; z < layers; ++z) all.push_back({p.x, p.y, static_cast<double>(z)});
  return all;
}

}  // namespace

TEST_CASE("simulation_of_simplicity: where the points decide, they do") {
  CHECK_BOTH(orient2d_sos(P2{0, 0}, P2{1, 0}, P2{0, 1}) == 1);
  CHECK_BOTH(orient2d_sos(P2{0, 0}, P2{0, 1}, P2{1, 0}) == -1);
  CHECK_BOTH(orient3d_sos(P3{0, 0, 0}, P3{1, 0, 0}, P3{0, 1, 0}, P3{0, 0, 1}) == 1);
  CHECK_BOTH(in_circle_sos(P2{0, 0}, P2{2, 0}, P2{0, 2}, P2{1, 1}) == 1);
  CHECK_BOTH(in_circle_sos(P2{0, 0}, P2{2, 0}, P2{0, 2}, P2{3, 1}) == -1);
  CHECK_BOTH(in_sphere_sos(P3{0, 0, 0}, P3{2, 0, 0}, P3{0, 2, 0}, P3{0, 0, 2}, P3{1, 1, 1}) == 1);
}

TEST_CASE("simulation_of_simplicity: where they do not, one sign or the other") {
  // Three points from left to right: the first one's y is raised most, then its x, then the second one's y.
  CHECK_BOTH(orient2d_sos(P2{0, 0}, P2{1, 1}, P2{2, 2}) == 1);
  CHECK_BOTH(orient2d_sos(P2{0, 0}, P2{2, 2}, P2{1, 1}) == -1);
  CHECK_BOTH(orient2d_sos(P2{0, 0}, P2{0, 1}, P2{0, 2}) == -1);
  CHECK_BOTH(orient3d_sos(P3{0, 0, 0}, P3{1, 0, 0}, P3{0, 1, 0}, P3{1, 1, 0}) != 0);
  CHECK_BOTH(in_circle_sos(P2{0, 0}, P2{1, 0}, P2{1, 1}, P2{0, 1}) != 0);
  CHECK_BOTH(in_sphere_sos(P3{0, 0, 0}, P3{1, 0, 0}, P3{0, 1, 0}, P3{0, 0, 1}, P3{1, 1, 1}) != 0);
  // Equal points.
  CHECK_BOTH(orient2d_sos(P2{0, 0}, P2{1, 1}, P2{0, -0.0}) == 0);
  CHECK_BOTH(in_circle_sos(P2{0, 0}, P2{1, 1}, P2{0, 0}, P2{5, 1}) == 0);
  constexpr numbered_point a{P2{1, 1}, 7}, b{P2{1, 1}, -3}, c{P2{1, 1}, 5}, d{P2{4, 4}, 0};
  CHECK_BOTH(orient2d_sos(a, b, c) != 0);
  CHECK_BOTH(orient2d_sos(a, b, c) == -orient2d_sos(b, a, c));
  CHECK_BOTH(in_circle_sos(a, b, c, d) != 0);
  volatile double two = 2;
  CHECK(orient2d_sos(P2{0, 0}, P2{1, 1}, P2{two, two}) == 1);
}

TEST_CASE("simulation_of_simplicity: every subset of a lattice in every order agrees with the moved points") {
  check_lattice<3, 2>(lattice(4, 3), 1000);
  check_lattice<4, 2>(lattice(3, 4), 1000);
  check_lattice<4, 3>(lattice(2, 3, 2), 200);
  check_lattice<5, 3>(lattice(2, 2, 2), 20);
}

TEST_CASE("simulation_of_simplicity: equal points with numbers") {
  test::random r(2);
  for (int i = 0; i < 300; ++i) {
    std::array<numbered_point<P2>, 4> q{};
    std::array<numbered_point<P3>, 5> s{};
    std::array<P2, 4> flat{};
    std::array<P3, 5> solid{};
    std::array<int, 4> places{2, 0, 3, 1};
    std::array<int, 5> solid_places{4, 1, 0, 2, 3};
    const auto coordinate = [&] { return static_cast<double>(r.integer(0, 1)); };
    for (std::size_t k = 0; k < 5; ++k) {
      if (k < 4) flat[k] = {coordinate(), coordinate()}, q[k] = {flat[k], places[k]};
      solid[k] = {coordinate(), coordinate(), coordinate()}, s[k] = {solid[k], solid_places[k]};
    }
    CHECK(wrong_orders(q, moved_sign<4, 2>(flat, places)) == 0);
    if (i < 30) CHECK(wrong_orders(s, moved_sign<5, 3>(solid, solid_places)) == 0);
    const std::array<numbered_point<P2>, 3> three{q[0], q[1], q[2]};
    CHECK(wrong_orders(three, moved_sign<3, 2>({flat[0], flat[1], flat[2]}, {2, 0, 3})) == 0);
  }
}

TEST_CASE("simulation_of_simplicity: other number types, the ends of their ranges") {
  constexpr std::int64_t least = std::numeric_limits<std::int64_t>::min(),
                         most = std::numeric_limits<std::int64_t>::max();
  using I2 = irg::point<std::int64_t, 2>;
  using I3 = irg::point<std::int64_t, 3>;
  using R2 = irg::point<test::rational, 2>;
  const std::array<I2, 3> diagonal{I2{least, least}, I2{-1, -1}, I2{most, most}};
  CHECK(wrong_orders(diagonal, 1) == 0);
  const std::array<I2, 4> corners{I2{least, least}, I2{most, least}, I2{most, most}, I2{least, most}};
  CHECK(wrong_orders(corners, in_circle_sos(P2{0, 0}, P2{1, 0}, P2{1, 1}, P2{0, 1})) == 0);
  const std::array<I2, 4> row{I2{least, 3}, I2{0, 3}, I2{1, 3}, I2{most, 3}};
  CHECK(wrong_orders(row, in_circle_sos(P2{0, 3}, P2{2, 3}, P2{3, 3}, P2{5, 3})) == 0);
  const std::array<I3, 4> flat{I3{least, least, most}, I3{most, least, most}, I3{most, most, most},
                               I3{least, most, most}};
  CHECK(wrong_orders(flat, orient3d_sos(P3{0, 0, 1}, P3{1, 0, 1}, P3{1, 1, 1}, P3{0, 1, 1})) == 0);
  CHECK(orient2d_sos(R2{0, 0}, R2{1, 1}, R2{2, 2}) == 1);
  using F2 = irg::point<float, 2>;
  CHECK_BOTH(orient2d_sos(F2{0, 0}, F2{1, 1}, F2{2, 2}) == 1);
  constexpr double huge = std::numeric_limits<double>::max(), tiny = std::numeric_limits<double>::denorm_min();
  CHECK_BOTH(orient2d_sos(P2{-huge, -huge}, P2{tiny, tiny}, P2{huge, huge}) == 1);
  CHECK_BOTH(in_circle_sos(P2{-huge, -huge}, P2{huge, -huge}, P2{huge, huge}, P2{-huge, huge}) ==
             in_circle_sos(P2{0, 0}, P2{1, 0}, P2{1, 1}, P2{0, 1}));
}

#ifdef IRG_HAVE_MPFR
namespace {

// The determinant for moves that are numbers: the k-th is 2^(-20 * 2^k); everything is multiplied by the last one's
// reciprocal to be an integer.
template <std::size_t N>
int sign_with_small_moves(const std::array<P2, N>& points) {
  constexpr std::size_t columns = N - 1;
  constexpr auto unit = static_cast<mp_bitcnt_t>(20) << (N * columns);
  mpz_t m[N][N], product, sum, one;
  mpz_inits(product, sum, one, nullptr);
  mpz_set_ui(one, 1);
  for (std::size_t i = 0; i < N; ++i)
    for (std::size_t j = 0; j < N; ++j) {
      mpz_init(m[i][j]);
      const double x = points[i].x, y = points[i].y;
      mpz_set_d(m[i][j], j == columns ? 1 : j == 0 ? x : j == 1 ? y : x * x + y * y);
      mpz_mul_2exp(m[i][j], m[i][j], unit);
      if (j == columns) continue;
      mpz_mul_2exp(product, one, unit - (static_cast<mp_bitcnt_t>(20) << (i * columns + columns - 1 - j)));
      mpz_add(m[i][j], m[i][j], product);
    }
  std::vector<int> order(N);
  std::iota(order.begin(), order.end(), 0);
  do {
    mpz_set_si(product, parity(order));
    for (std::size_t j = 0; j < N; ++j) mpz_mul(product, product, m[static_cast<std::size_t>(order[j])][j]);
    mpz_add(sum, sum, product);
  } while (std::next_permutation(order.begin(), order.end()));
  const int sign = mpz_sgn(sum);
  mpz_clears(product, sum, one, nullptr);
  for (auto& row : m)
    for (auto& entry : row) mpz_clear(entry);
  return sign;
}

}  // namespace

TEST_CASE("simulation_of_simplicity: points moved by small numbers give the same signs") {
  const std::vector<P2> all = lattice(3, 3);
  for (std::size_t a = 0; a < 9; ++a)
    for (std::size_t b = a + 1; b < 9; ++b)
      for (std::size_t c = b + 1; c < 9; ++c) {
        CHECK(orient2d_sos(all[a], all[b], all[c]) == sign_with_small_moves<3>({all[a], all[b], all[c]}));
        if ((a + b + c) % 4 == 0)
          for (std::size_t d = c + 1; d < 9; ++d)
            CHECK(in_circle_sos(all[a], all[b], all[c], all[d]) ==
                  sign_with_small_moves<4>({all[a], all[b], all[c], all[d]}));
      }
}
#endif
