// SPDX-License-Identifier: MIT
#include <irg/spatial/bsp_order.hpp>

#include <array>
#include <cmath>
#include <random>
#include <vector>

#include "support/check_both.hpp"
#ifdef IRG_HAVE_MPFR
#include "support/big_rational.hpp"
#endif

namespace {

TEST_CASE("bsp_order: a place is nowhere until it is found") {
  CHECK_BOTH(irg::bsp_place{} == irg::bsp_place{irg::no_index, 0});
  CHECK_BOTH(irg::bsp_place{1, 0} != irg::bsp_place{1, -1});
  CHECK_BOTH(irg::bsp_options{}.candidates > 0);
}

using V = irg::vec<double, 2>;
using P = irg::point<double, 2>;

constexpr int side_of_wall(const V& normal, const irg::linear_form<2>& f) {
  const irg::bsp_bounds<2> wall = irg::bounds_of<2>(std::array{P{1, 0}, P{0, 1}}, normal);
  return irg::rounded_side_of(wall, f);
}

TEST_CASE("rounded_side_of: a slab tells where a box does not") {
  constexpr irg::linear_form<2> beside{{1, 1}, {1, 1}, {0.375, 0.5}}, on{{1, 1}, {1, 1}, {0.5, 0.5}},
      behind{{-1, -1}, {1, 1}, {0.375, 0.5}};
  CHECK_BOTH(side_of_wall({1, 1}, beside) == 1);
  CHECK_BOTH(side_of_wall({-3, -3}, beside) == 1);
  CHECK_BOTH(side_of_wall({-3, -3}, behind) == -1);
  CHECK_BOTH(side_of_wall({0, 0}, beside) == 0);  // the box's corner (0, 0) lies behind
  CHECK_BOTH(side_of_wall({1, 1}, on) == 0);
  CHECK_BOTH(side_of_wall({0x1p-1074, 0}, beside) == 0);
}

#ifdef IRG_HAVE_MPFR
using Q = test::big_rational;

template <int N, class Number>
void try_bounds(std::mt19937_64& random, const Number& number, int& sure, int& wrong) {
  const auto numbers = [&](auto& v) {
    for (int k = 0; k < N; ++k) v[k] = number();
  };
  std::vector<irg::point<double, N>> all;
  irg::bsp_bounds<N> bounds;
  for (std::uint64_t items = 1 + random() % 5, i = 0; i < items; ++i) {
    std::array<irg::point<double, N>, 3> corners;
    irg::vec<double, N> normal;
    for (auto& c : corners) numbers(c);
    numbers(normal);
    const auto here = irg::bounds_of<N>(corners, normal);
    bounds = i == 0 ? here : irg::bounds_of_both(bounds, here);
    all.insert(all.end(), corners.begin(), corners.end());
  }
  irg::linear_form<N> f;
  numbers(f.slope);
  numbers(f.origin);
  for (int k = 0; k < N; ++k) f.size[k] = std::abs(f.slope[k]);
  const int side = irg::rounded_side_of(bounds, f);
  sure += side != 0;
  for (const auto& p : all) {
    Q value(0.0);
    for (int k = 0; k < N; ++k) value = value + Q(f.slope[k]) * (Q(p[k]) - Q(f.origin[k]));
    wrong += side != 0 && value.sign() != side;
  }
}

TEST_CASE("rounded_side_of: never a side that one of the points is not on, against rationals") {
  std::mt19937_64 random(20261129);
  int sure = 0, wrong = 0;
  for (int trial = 0; trial < 6000; ++trial) {
    const int spread = trial % 3 == 0 ? 0 : trial % 3 == 1 ? 8 : 399;  // powers of two
    const auto number = [&] {
      const double whole = static_cast<double>(static_cast<int>(random() % 65) - 32);
      return std::ldexp(whole,
                        spread == 0 ? 0 : static_cast<int>(random() % static_cast<unsigned>(spread)) - spread / 2);
    };
    trial % 2 == 0 ? try_bounds<2>(random, number, sure, wrong) : try_bounds<3>(random, number, sure, wrong);
  }
  CHECK(wrong == 0);
  CHECK(sure > 300);
}
#endif

}  // namespace
