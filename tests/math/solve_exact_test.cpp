// SPDX-License-Identifier: MIT
#include <irg/math/solve_exact.hpp>

#include <cmath>
#include <limits>

#include "support/big_rational.hpp"
#include "support/check_both.hpp"
#include "support/random.hpp"

using irg::mat;
using irg::solvability;
using irg::solve_exact;
using irg::vec;

namespace {

using rows3 = mat<double, 3, 4>;
constexpr double huge = std::numeric_limits<double>::max(), tiny = 0x1p-1074;

}  // namespace

TEST_CASE("solve_exact: GOLDEN 1, exercise 2, and GOLDEN 12") {
  CHECK_BOTH(solve_exact(rows3{{{1, 1, 1, 6}, {-1, -2, 1, -2}, {2, 1, 3, 13}}}).x == vec<double, 3>{1, 2, 3});
  constexpr auto dependent = solve_exact(rows3{{{1, 1, 1, 6}, {2, 2, 2, 12}, {1, -1, 0, 0}}});
  CHECK_BOTH((dependent.kind == solvability::dependent && dependent.rank == 2 && !dependent));
  CHECK_BOTH(solve_exact(rows3{{{1, 1, 1, 6}, {2, 2, 2, 13}, {1, -1, 0, 0}}}).kind == solvability::inconsistent);
  CHECK_BOTH(solve_exact(rows3{{{2, 1, -1, 8}, {-3, -1, 2, -11}, {-2, 1, 2, -3}}}).x == vec<double, 3>{2, 3, -1});
  CHECK_BOTH(solve_exact(rows3{{{0, 2, 1, 7}, {1, 1, 1, 6}, {2, 0, -1, -1}}}).x == vec<double, 3>{1, 2, 3});
  CHECK_BOTH(solve_exact(mat<float, 3, 3>{{{4, -2, 1}, {-2, 4, -2}, {1, -2, 4}}}, vec<float, 3>{11, -16, 17}).x ==
             vec<float, 3>{1, -2, 3});
  CHECK_BOTH(solve_exact(mat<double, 2, 3>{{{1e-7, 0, 1e-7}, {0, 1e-7, 1e-7}}}).x == vec<double, 2>{1, 1});
}

TEST_CASE("solve_exact: decided for the numbers as they are") {
  // 0.1 + 0.2 is not 0.3 in doubles: the third row is not the sum of the other two.
  constexpr rows3 sum{{{0.1, 1, 2, 1}, {0.2, 3, 4, 2}, {0.3, 4, 6, 3}}};
  CHECK_BOTH(solve_exact(sum).kind == solvability::unique);
  CHECK_BOTH(solve_gauss(sum).kind == solvability::dependent);  // which rounding makes of it
  // 0.5 + 0.25 is 0.75.
  CHECK_BOTH(solve_exact(rows3{{{0.5, 1, 2, 1}, {0.25, 3, 4, 2}, {0.75, 4, 6, 3}}}).kind == solvability::dependent);
  CHECK_BOTH(solve_exact(rows3{{{0.5, 1, 2, 1}, {0.25, 3, 4, 2}, {0.75, 4, 6, 3 + 0x1p-51}}}).kind ==
             solvability::inconsistent);
  // Every rank.
  CHECK_BOTH((solve_exact(rows3{}).kind == solvability::dependent && solve_exact(rows3{}).rank == 0));
  CHECK_BOTH(solve_exact(rows3{{{0, 0, 0, 0}, {0, 0, 0, tiny}, {}}}).kind == solvability::inconsistent);
  constexpr auto one_plane = solve_exact(rows3{{{1, 2, 3, 4}, {2, 4, 6, 8}, {-3, -6, -9, -12}}});
  CHECK_BOTH((one_plane.kind == solvability::dependent && one_plane.rank == 1));
  CHECK_BOTH(solve_exact(rows3{{{1, 2, 3, 4}, {2, 4, 6, 8}, {-3, -6, -9, 12}}}).kind == solvability::inconsistent);
  CHECK_BOTH(solve_exact(rows3{{{1, 2, 3, 4}, {2, 4, 6, 9}, {1, 0, 0, 1}}}).kind == solvability::inconsistent);
}

TEST_CASE("solve_exact: the ends of the range") {
  constexpr double inf = std::numeric_limits<double>::infinity(), none = std::numeric_limits<double>::quiet_NaN();
  CHECK_BOTH(solve_exact(mat<double, 1, 2>{{{3, 1}}}).x[0] == 1.0 / 3);
  CHECK_BOTH(solve_exact(mat<double, 2, 3>{{{huge, 0, huge}, {0, tiny, tiny}}}).x == vec<double, 2>{1, 1});
  CHECK_BOTH(solve_exact(mat<double, 2, 3>{{{huge, huge, huge}, {huge, -huge, huge}}}).x == vec<double, 2>{1, 0});
  CHECK_BOTH(solve_exact(mat<double, 2, 3>{{{tiny, tiny, 0}, {tiny, -tiny, tiny}}}).x == vec<double, 2>{0.5, -0.5});
  CHECK_BOTH(solve_exact(mat<double, 2, 3>{{{huge, tiny, huge}, {tiny, huge, tiny}}}).x == vec<double, 2>{1, 0});
  CHECK_BOTH(solve_exact(mat<double, 1, 2>{{{tiny, 1}}}).kind == solvability::not_finite);
  CHECK_BOTH(solve_exact(mat<double, 1, 2>{{{inf, 1}}}).kind == solvability::not_finite);
  CHECK_BOTH(solve_exact(mat<double, 2, 3>{{{1, 0, none}, {0, 1, 0}}}).kind == solvability::not_finite);
  CHECK_BOTH(solve_exact(mat<float, 1, 2>{{{0x1p-100f, 0x1p100f}}}).kind == solvability::not_finite);
}

#ifdef IRG_HAVE_MPFR

TEST_CASE("solve_exact: against rationals") {
  using test::big_rational;
  test::random r(6);
  const int count = std::getenv("IRG_RELEASE_TIER") != nullptr ? 300000 : 3000;
  int of_kind[4] = {};
  double worst = 0;
  for (int i = 0; i < count; ++i) {
    rows3 a{};
    for (auto& row : a.m)
      for (double& entry : row) {
        entry = static_cast<double>(r.integer(-2, 2));
        if (i % 3 == 1) entry = std::ldexp(r.unit() - 0.5, static_cast<int>(r.integer(-1070, 1020)));
      }
    if (i % 3 == 2) {  // the third row the sum of the others, by a lattice of doubles, sometimes an ulp off
      for (int c = 0; c < 4; ++c) {
        for (int k = 0; k < 2; ++k) a(k, c) = std::ldexp(static_cast<double>(r.integer(-(1 << 20), 1 << 20)), -700);
        a(2, c) = a(0, c) * 1024 + a(1, c);
      }
      if (i % 2 == 0) a(2, i % 4) = std::nextafter(a(2, i % 4), HUGE_VAL);
    }
    const auto got = solve_exact(a);
    const auto truth =
        solve_gauss(irg::detail::filled_mat<big_rational, 3, 4>([&](int y, int x) { return big_rational(a(y, x)); }));
    ++of_kind[static_cast<int>(got.kind)];
    if (got.kind == solvability::not_finite) {
      bool is_large = false;
      for (int k = 0; k < 3; ++k) is_large = is_large || std::fabs(static_cast<double>(truth.x[k])) > huge / 2;
      CHECK(is_large);
      continue;
    }
    CHECK((got.kind == truth.kind && got.rank == truth.rank));
    for (int k = 0; got && k < 3; ++k) {
      const double size = std::fabs(static_cast<double>(truth.x[k]));
      if (size == 0 || size < 0x1p-1021) continue;
      int exponent = 0;
      std::frexp(size, &exponent);
      worst = std::fmax(worst, test::distance(got.x[k], truth.x[k]) / std::ldexp(1.0, exponent - 53));
    }
  }
  MESSAGE("solve_exact: worst ", worst, " ulp; unique ", of_kind[0], ", dependent ", of_kind[1], ", inconsistent ",
          of_kind[2], ", too large ", of_kind[3]);
  CHECK(worst <= 0.5000001);
  CHECK((of_kind[1] > 10 && of_kind[2] > 10));
}

#endif
