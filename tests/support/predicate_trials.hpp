// SPDX-License-Identifier: MIT
// Geometric predicates against an oracle: each stage by itself and the whole, over all distributions, with subnormals
// as they are and flushed to zero, and all orders of the points.
//
// A predicate is a type with
//   static constexpr int points, size; static constexpr test::figure shape;
//   template <class P> static constexpr int whole(const std::array<P, points>&)
//   static constexpr int stages; static constexpr bool stage(int i, const table&, int& sign): whether stage i decides
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <initializer_list>

#include <irg/geometry/detail/predicate_kernel.hpp>
#include <irg/math/vec.hpp>

#ifdef IRG_HAVE_MPFR
#include <gmp.h>
#endif
#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

#include "support/flush_mode.hpp"
#include "support/predicate_points.hpp"

namespace test {

inline constexpr int most_stages = 6;

/// How many trials: the number in IRG_PREDICATE_TRIALS, or `release` in the release tier, or `few`.
inline long trial_count(long few, long release) {
  if (const char* text = std::getenv("IRG_PREDICATE_TRIALS")) return std::atol(text);
  return std::getenv("IRG_RELEASE_TIER") ? release : few;
}

// Sanitizers, and runs that repeat a test for other flags (IRG_FEWER_TRIALS), take a tenth of the trials.
#if defined(__SANITIZE_ADDRESS__)
inline constexpr bool is_sanitized = true;
#elif defined(__has_feature)
inline constexpr bool is_sanitized = __has_feature(address_sanitizer);
#else
inline constexpr bool is_sanitized = false;
#endif
inline long gmp_trial_count(long few, long release) {
  return trial_count(is_sanitized || std::getenv("IRG_FEWER_TRIALS") ? few / 10 : few, release);
}

template <int D, class T>
constexpr irg::point<T, D> to_point(const std::array<T, static_cast<std::size_t>(D)>& c) {
  if constexpr (D == 2)
    return {c[0], c[1]};
  else
    return {c[0], c[1], c[2]};
}
template <int D, class T, std::size_t M>
constexpr std::array<irg::point<T, D>, M> to_points(
    const std::array<std::array<T, static_cast<std::size_t>(D)>, M>& p) {
  std::array<irg::point<T, D>, M> q{};
  for (std::size_t i = 0; i < M; ++i) q[i] = to_point<D>(p[i]);
  return q;
}
template <int M, int D>
constexpr irg::detail::point_table<double, M, D> to_table(const points<double, M, D>& p) {
  irg::detail::point_table<double, M, D> t{};
  for (int i = 0; i < M * D; ++i) t.v[i] = p[static_cast<std::size_t>(i / D)][static_cast<std::size_t>(i % D)];
  return t;
}

/// What the stages say: 2 where one leaves it open; the last is the whole.
using verdicts = std::array<int, most_stages + 1>;

template <class Predicate>
[[gnu::noinline]] verdicts all_verdicts(const points<double, Predicate::points, Predicate::size>& p,
                                        bool the_slow_one) {
  verdicts v{};
  const auto t = to_table<Predicate::points, Predicate::size>(p);
  for (int i = 0; i < most_stages; ++i) {
    int sign = 2;
    const bool asked = i < Predicate::stages && (the_slow_one || i + 1 < Predicate::stages);
    v[static_cast<std::size_t>(i)] = asked && Predicate::stage(i, t, sign) ? sign : 2;
  }
  v[most_stages] = Predicate::whole(to_points<Predicate::size>(p));
  return v;
}

/// The same on a processor that takes subnormals for zero.
template <class Predicate>
[[gnu::noinline]] verdicts all_verdicts_flushed(const points<double, Predicate::points, Predicate::size>& p,
                                                bool the_slow_one) {
#if defined(__SSE2__)
  verdicts (*volatile function)(const points<double, Predicate::points, Predicate::size>&, bool) =
      all_verdicts<Predicate>;
  const unsigned before = _mm_getcsr();
  _mm_setcsr(before | 0x8040);
  const verdicts v = function(p, the_slow_one);
  _mm_setcsr(before);
  return v;
#else
  return all_verdicts<Predicate>(p, the_slow_one);
#endif
}

/// How often the rounded stages before `exact_stage` are wrong where they say something, on points that a bound of half
/// its size (in the plane; an eighth for circles, a sixteenth for spheres) would be too small for.
template <class Predicate>
long wrong_next_to_the_bound(int exact_stage, long trials) {
  random r(1);
  long wrong = 0;
  for (long i = 0; i < trials; ++i) {
    const auto t = to_table<Predicate::points, Predicate::size>(half_way_points<Predicate::points, Predicate::size>(r));
    int expected = 0, sign = 0;
    if (!Predicate::stage(exact_stage, t, expected)) ++wrong;
    for (int k = 0; k < exact_stage; ++k)
      if (Predicate::stage(k, t, sign)) wrong += sign != expected;
  }
  return wrong;
}

/// How the filter, stage 0, fares: what share of the points it decides, and how many of these wrongly.
struct filter_score {
  double decided = 0;
  long wrong = 0;
};

/// On uniform points; the stages from `exact_stage` on are the judges.
template <class Predicate>
filter_score score_of_filter(int exact_stage, long trials) {
  random r(2);
  long decided = 0, wrong = 0;
  for (long i = 0; i < trials; ++i) {
    const auto t = to_table<Predicate::points, Predicate::size>(
        hard_points<Predicate::points, Predicate::size>(distribution::uniform, Predicate::shape, r));
    int sign = 0, expected = 0, k = exact_stage;
    if (!Predicate::stage(0, t, sign)) continue;
    ++decided;
    while (!Predicate::stage(k, t, expected)) ++k;
    wrong += sign != expected;
  }
  return {static_cast<double>(decided) / static_cast<double>(trials), wrong};
}

/// How often points of floats have another sign than the same numbers as doubles, where the processor takes subnormals
/// for zero: lattices whose axes have scales of their own, with subnormals among the coordinates.
template <class Predicate>
long wrong_floats_while_flushing(long trials) {
  constexpr int m = Predicate::points, size = Predicate::size;
  constexpr int scales[] = {-149, -147, -135, -128, -110, -70, -20, 0};
  random r(7);
  long wrong = 0;
  for (long i = 0; i < trials; ++i) {
    points<float, m, size> floats{};
    points<double, m, size> doubles{};
    int scale[3]{};
    const int common = scales[r.integer(0, 7)];
    const bool same = r.integer(0, 1) == 0;
    for (int& s : scale) s = same ? common : scales[r.integer(0, 7)];
    const std::int64_t reach = r.integer(0, 1) == 0 ? 3 : 60;
    for (std::size_t k = 0; k < floats.size(); ++k)
      for (std::size_t j = 0; j < floats[k].size(); ++j) {
        const int exponent = r.integer(0, 3) == 0 ? -149 : scale[j];
        doubles[k][j] = scaled(static_cast<double>(r.integer(-reach, reach)), exponent);
        floats[k][j] = static_cast<float>(doubles[k][j]);
      }
    const auto narrow = to_points<size>(floats);
    wrong += while_flushing([&] { return Predicate::whole(narrow); }) != Predicate::whole(to_points<size>(doubles));
  }
  return wrong;
}

/// How often the sign is not 0 where two points are equal, though exponents lie far apart: what the last stage decides.
template <class Predicate>
long wrong_for_equal_points(long trials) {
  constexpr int m = Predicate::points, size = Predicate::size;
  random r(8);
  long wrong = 0;
  for (long i = 0; i < trials; ++i) {
    auto p = hard_points<m, size>(distribution::mixed_exponents, Predicate::shape, r);
    p[static_cast<std::size_t>(r.integer(1, m - 1))] = p[0];
    wrong += Predicate::whole(to_points<size>(p)) != 0;
  }
  return wrong;
}

#ifdef IRG_HAVE_MPFR

/// The sign of the determinant of the points' coordinates, the sums of their squares (for circles and spheres) and
/// ones, by expansion of whole numbers.
class determinant_oracle {
public:
  determinant_oracle() {
    for (auto& row : entry_)
      for (auto& e : row) mpz_init(e);
    for (auto& s : sum_) mpz_init(s);
  }
  ~determinant_oracle() {
    for (auto& row : entry_)
      for (auto& e : row) mpz_clear(e);
    for (auto& s : sum_) mpz_clear(s);
  }
  determinant_oracle(const determinant_oracle&) = delete;
  determinant_oracle& operator=(const determinant_oracle&) = delete;

  template <class T, std::size_t M, std::size_t D>
  int sign(const std::array<std::array<T, D>, M>& p) {
    int least = 4096;  // the place of the lowest bit of all
    if constexpr (std::is_same_v<T, double>)
      for (const auto& point : p)
        for (const double c : point)
          if (c != 0) least = std::min(least, place(c));
    for (std::size_t i = 0; i < M; ++i) {
      for (std::size_t k = 0; k < D; ++k) set(entry_[i][k], p[i][k], least);
      if (M == D + 2) {
        mpz_set_ui(entry_[i][D], 0);
        for (std::size_t k = 0; k < D; ++k) mpz_addmul(entry_[i][D], entry_[i][k], entry_[i][k]);
      }
      mpz_set_ui(entry_[i][M - 1], 1);
    }
    expand(0, 0, static_cast<int>(M));
    return mpz_sgn(sum_[0]);
  }

private:
  mpz_t entry_[5][5], sum_[6];

  static int place(double x) {
    const int field = static_cast<int>(std::bit_cast<std::uint64_t>(x) >> 52) & 0x7ff;
    return field == 0 ? 0 : field - 1;
  }
  static void set(mpz_t& out, double x, int least) {
    const auto bits = std::bit_cast<std::uint64_t>(x);
    const std::uint64_t fraction = bits & ((std::uint64_t{1} << 52) - 1);
    mpz_set_ui(out, (bits >> 52 & 0x7ff) == 0 ? fraction : fraction | (std::uint64_t{1} << 52));
    if (mpz_sgn(out) != 0) mpz_mul_2exp(out, out, static_cast<mp_bitcnt_t>(place(x) - least));
    if (bits >> 63 != 0) mpz_neg(out, out);
  }
  static void set(mpz_t& out, std::int64_t x, int) { mpz_set_si(out, x); }

  /// sum_[row] = the determinant of the rows from `row` on and of the columns that are not used.
  void expand(int row, unsigned used, int n) {
    if (row == n) return mpz_set_ui(sum_[row], 1);
    mpz_set_ui(sum_[row], 0);
    bool minus = false;
    for (int k = 0; k < n; ++k) {
      if ((used >> k & 1) != 0) continue;
      const auto& e = entry_[row][k];
      if (mpz_sgn(e) != 0) {
        expand(row + 1, used | 1u << k, n);
        minus ? mpz_submul(sum_[row], e, sum_[row + 1]) : mpz_addmul(sum_[row], e, sum_[row + 1]);
      }
      minus = !minus;
    }
  }
};

struct trial_result {
  long wrong = 0, wrong_flushed = 0, wrong_order = 0, zeros = 0;
  std::array<long, most_stages> decided{};  // by the first stage that did, subnormals as they are
};

/// How many of the trials go wrong. `orientation` is the predicate's sign for a positive determinant.
template <class Predicate>
trial_result run_trials(distribution d, long trials, std::uint64_t seed, int orientation) {
  constexpr int m = Predicate::points, size = Predicate::size;
  random r(seed);
  determinant_oracle oracle;
  trial_result result;
  for (long i = 0; i < trials; ++i) {
    auto p = hard_points<m, size>(d, Predicate::shape, r);
    for (std::int64_t k = r.integer(0, 3); k > 0; --k)
      std::swap(p[static_cast<std::size_t>(r.integer(0, m - 1))], p[static_cast<std::size_t>(r.integer(0, m - 1))]);
    const int expected = orientation * oracle.sign(p);
    result.zeros += expected == 0;
    const auto is_wrong = [&](const verdicts& v) {
      bool wrong = v[most_stages] != expected;
      for (int k = 0; k < Predicate::stages; ++k)
        wrong = wrong || (v[static_cast<std::size_t>(k)] != 2 && v[static_cast<std::size_t>(k)] != expected);
      return wrong;
    };
    const verdicts v = all_verdicts<Predicate>(p, i % 16 == 0);
    result.wrong += is_wrong(v);
    for (int k = 0; k < Predicate::stages; ++k)
      if (v[static_cast<std::size_t>(k)] != 2) {
        ++result.decided[static_cast<std::size_t>(k)];
        break;
      }
    result.wrong_flushed += is_wrong(all_verdicts_flushed<Predicate>(p, i % 16 == 0));
    if (i % 8 == 0) {  // all orders of the points
      std::array<int, static_cast<std::size_t>(m)> order{};
      for (int k = 0; k < m; ++k) order[static_cast<std::size_t>(k)] = k;
      do {
        auto q = p;
        int inversions = 0;
        for (std::size_t a = 0; a < order.size(); ++a) {
          q[a] = p[static_cast<std::size_t>(order[a])];
          for (std::size_t b = a + 1; b < order.size(); ++b) inversions += order[b] < order[a];
        }
        const int sign = Predicate::whole(to_points<size>(q));
        result.wrong_order += sign != (inversions % 2 == 0 ? expected : -expected);
      } while (std::next_permutation(order.begin(), order.begin() + (m == 5 && i % 128 != 0 ? 3 : m)));
    }
  }
  return result;
}

/// The same for whole numbers of 64 bits, which have no stages.
template <class Predicate>
trial_result run_integer_trials(long trials, std::uint64_t seed, int orientation) {
  random r(seed);
  determinant_oracle oracle;
  trial_result result;
  for (long i = 0; i < trials; ++i) {
    const auto p = extreme_integers<Predicate::points, Predicate::size>(r);
    const int expected = orientation * oracle.sign(p);
    result.zeros += expected == 0;
    result.wrong += Predicate::whole(to_points<Predicate::size>(p)) != expected;
  }
  return result;
}

/// Runs all distributions, prints what stage decided how many when asked to by IRG_PREDICATE_TRIALS, and returns what
/// went wrong; `decided` and `zeros` are sums.
template <class Predicate>
trial_result run_all_trials(long trials, std::uint64_t seed, int orientation) {
  trial_result all;
  for (int k = 0; k < distribution_count; ++k) {
    const auto d = static_cast<distribution>(k);
    const trial_result one = run_trials<Predicate>(d, trials, seed + static_cast<std::uint64_t>(k), orientation);
    if (std::getenv("IRG_PREDICATE_TRIALS")) {
      std::printf("%-18s of %ld: wrong %ld, flushed %ld, in other orders %ld; zeros %ld; decided by stage", name_of(d),
                  trials, one.wrong, one.wrong_flushed, one.wrong_order, one.zeros);
      for (int s = 0; s < Predicate::stages; ++s) std::printf(" %ld", one.decided[static_cast<std::size_t>(s)]);
      std::printf("\n");
    }
    all.wrong += one.wrong;
    all.wrong_flushed += one.wrong_flushed;
    all.wrong_order += one.wrong_order;
    all.zeros += one.zeros;
    for (std::size_t s = 0; s < all.decided.size(); ++s) all.decided[s] += one.decided[s];
  }
  return all;
}

#endif

}  // namespace test
