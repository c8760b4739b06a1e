// SPDX-License-Identifier: MIT
#include <irg/math/exact/quotients_of.hpp>

#include <array>
#include <optional>

#include "support/check_both.hpp"
#include "support/rational.hpp"

// quotient_of is tried against rationals with sign_of.
namespace {

// How far along ab the line meets that through c along v, times its coordinates.
constexpr auto share = [](const auto& a, const auto& b, const auto& c, const auto& v) {
  const auto whole = cross(b - a, v);
  return std::array{whole, cross(c - a, v), a.x * whole};
};
using P = irg::point<double, 2>;
using V = irg::vec<double, 2>;

}  // namespace

TEST_CASE("quotients_of: the nearest doubles, all over one divisor") {
  CHECK_BOTH(*irg::quotients_of<3>(share, P{0, 0}, P{3, 0}, P{1, 5}, V{0, 2}) == std::array{1.0 / 3, 0.0});
  CHECK_BOTH(*irg::quotients_of<3>(share, P{1e300, 0}, P{-1e300, 0}, P{0, 5}, V{0, 1e-300}) == std::array{0.5, 1e300});
  CHECK_BOTH(!irg::quotients_of<3>(share, P{0, 0}, P{3, 0}, P{1, 5}, V{1, 0}));
  const auto exact = irg::quotients_of<1>([](const auto& a, const auto& b) { return std::array{a, b}; },
                                          test::rational(3), test::rational(1));
  CHECK((*exact)[0] == test::rational(1, 3));
}
