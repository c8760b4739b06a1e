// SPDX-License-Identifier: MIT
// Long products of rotations, as stacks of transformations and animations make them: run time against error. The exact
// ones are rational matrices; each number type starts from its own nearest ones.
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include <irg/math/double_double.hpp>
#include <irg/math/length.hpp>
#include <irg/math/mat.hpp>

#include "accuracy/matrix_peers.hpp"
#include "accuracy/vector_sets.hpp"

#ifdef BENCH_HAS_MPFR

namespace {

using bench::real;
using irg::double_double;
using mat3 = irg::mat<double, 3, 3>;
using exact3 = std::array<real, 9>;  // row by row
constexpr std::size_t steps = 64;    // rotations, which a longer chain repeats

template <class M>
struct chain {
  std::array<M, steps> turns;
  std::size_t length;
};

exact3 times(const exact3& a, const exact3& b) {
  exact3 c;
  for (std::size_t i = 0; i < 9; ++i) {
    const std::size_t row = i / 3 * 3, column = i % 3;
    c[i] = a[row] * b[column] + a[row + 1] * b[column + 3] + a[row + 2] * b[column + 6];
  }
  return c;
}

// The rotation of a quaternion of integers.
exact3 rotation(bench::random_numbers& r) {
  const auto any = [&] { return static_cast<double>(r.integer(1, 1999) - 1000); };
  const double w = any() + 0.5, x = any(), y = any(), z = any();
  const real n = w * w + x * x + y * y + z * z, two = 2;
  const auto of = [&](double v) { return two * real(v) / n; };  // sums of such products are exact in double
  return {real(1) - of(y * y + z * z), of(x * y - w * z),           of(x * z + w * y),
          of(x * y + w * z),           real(1) - of(x * x + z * z), of(y * z - w * x),
          of(x * z - w * y),           of(y * z + w * x),           real(1) - of(x * x + y * y)};
}

exact3 product_of(const std::array<exact3, steps>& turns, std::size_t length) {
  const real o = 0, i = 1;
  exact3 all{i, o, o, o, i, o, o, o, i}, left = all;
  for (std::size_t k = 0; k < steps; ++k) {
    if (k == length % steps) left = all;
    all = times(all, turns[k]);
  }
  exact3 power{i, o, o, o, i, o, o, o, i};
  for (std::size_t n = length / steps; n > 0; n /= 2, all = times(all, all))
    if (n % 2 == 1) power = times(power, all);
  return times(power, left);
}

double_double two_words(const real& x) {
  const auto [value, rest] = x.result();
  return {value, rest};
}

template <class M, class F>
const std::vector<chain<M>>& nearest(const std::vector<std::array<exact3, steps>>& all, std::size_t length, F entry) {
  auto& chains = bench::keep(std::vector<chain<M>>(all.size()));
  for (std::size_t i = 0; i < all.size(); ++i) {
    chains[i].length = length;
    for (std::size_t k = 0; k < steps; ++k)
      for (std::size_t e = 0; e < 9; ++e)
        entry(chains[i].turns[k], static_cast<int>(e / 3), static_cast<int>(e % 3), all[i][k][e]);
  }
  return chains;
}

// The rows of a rotation at right angles and of length 1 again.
void orthonormalize(mat3& a) {
  using vec3 = irg::vec<double, 3>;
  const vec3 x = irg::normalized(vec3{a(0, 0), a(0, 1), a(0, 2)});
  const vec3 z = irg::normalized(irg::cross(x, vec3{a(1, 0), a(1, 1), a(1, 2)})), y = irg::cross(z, x);
  for (int k = 0; k < 3; ++k) a(0, k) = x[k], a(1, k) = y[k], a(2, k) = z[k];
}

template <class M, class F, class G>
bench::implementation multiplying(const char* name, const std::vector<chain<M>>& chains, F entry, G every_64th) {
  return {name, [&chains, entry, every_64th](double* out) {
            for (const auto& c : chains) {
              M all = c.turns[0];
              for (std::size_t k = 1; k < c.length; ++k) {
                all = all * c.turns[k % steps];
                if (k % 64 == 63) every_64th(all);
              }
              for (int i = 0; i < 9; ++i) *out++ = static_cast<double>(entry(all, i / 3, i % 3));
            }
          }};
}
template <class M, class F>
bench::implementation multiplying(const char* name, const std::vector<chain<M>>& chains, F entry) {
  return multiplying(name, chains, entry, [](M&) {});
}

void chains_of(bench::study& s, int power) {
  const auto length = static_cast<std::size_t>(std::pow(10.0, power) + 0.5);
  bench::random_numbers r(length);
  auto& exact = bench::keep(std::vector<std::array<exact3, steps>>(bench::smoke() ? 2 : length < 10000 ? 32 : 4));
  for (auto& turns : exact)
    for (exact3& turn : turns) turn = rotation(r);
  const auto product = [length](const std::array<exact3, steps>& turns, bench::exact_results& out) {
    for (const real& x : product_of(turns, length)) out.push_back(x.result());
  };
  const bench::distribution d{"10^" + std::to_string(power) + " rotations", exact.size(), 9,
                              bench::exact_for(exact, product)};
  const auto read = [](const auto& a, int i, int j) { return a(i, j); };
  const auto& in_double = nearest<mat3>(exact, length, [](auto& a, int i, int j, auto& x) { a(i, j) = x.nearest(); });
  const auto& in_float = nearest<irg::mat<float, 3, 3>>(
      exact, length, [](auto& a, int i, int j, auto& x) { a(i, j) = static_cast<float>(x.nearest()); });
  const auto& in_words = nearest<irg::mat<double_double, 3, 3>>(
      exact, length, [](auto& a, int i, int j, auto& x) { a(i, j) = two_words(x); });
  std::vector<bench::implementation> who{
      multiplying("irg", in_double, read), multiplying("in float", in_float, read),
      multiplying("in double_double", in_words, [](const auto& a, int i, int j) { return a(i, j).high; }),
      multiplying("orthonormal every 64th", in_double, read, orthonormalize)};
#ifdef IRG_HAVE_GLM
  const auto& in_glm =
      nearest<glm::dmat3>(exact, length, [](auto& a, int i, int j, auto& x) { a[j][i] = x.nearest(); });
  who.push_back(multiplying("GLM", in_glm, [](const auto& a, int i, int j) { return a[j][i]; }));
#endif
#ifdef IRG_HAVE_EIGEN
  const auto& in_eigen =
      nearest<Eigen::Matrix3d>(exact, length, [](auto& a, int i, int j, auto& x) { a(i, j) = x.nearest(); });
  who.push_back(multiplying("Eigen", in_eigen, read));
#endif
  s.panel(d, who,
          [length](std::size_t i) { return "chain " + std::to_string(i) + " of seed " + std::to_string(length); });
}

}  // namespace

int main(int argc, char** argv) {
  bench::study s("chain of rotations", "chain", bench::error_unit::relative_u);
  for (int power = 1; power <= (bench::smoke() ? 3 : 6); ++power) chains_of(s, power);
  return bench::run_benchmarks(argc, argv);
}

#else
#include <cstdio>
int main() { std::puts("accuracy_matrix_chain: skipped, MPFR was not found"); }
#endif
