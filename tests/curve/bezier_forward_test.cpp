// SPDX-License-Identifier: MIT
#include <irg/curve/bezier_forward.hpp>

#include <array>
#include <cmath>
#include <vector>

#include <irg/math/length.hpp>

#include "support/check_both.hpp"
#include "support/random.hpp"

namespace {

using P = irg::point<double, 2>;

constexpr std::array<P, 5> quarters() {
  constexpr std::array<P, 3> arch{P{0, 0}, {2, 4}, {4, 0}};
  std::array<P, 3> scratch{};
  std::array<P, 5> all{};
  std::size_t k = 0;
  irg::bezier_forward(arch, 4, std::span<P>(scratch), [&](const P& p) { all[k++] = p; });
  return all;
}

}  // namespace

TEST_CASE("bezier_forward: by hand") {
  CHECK_BOTH(quarters() == std::array<P, 5>{P{0, 0}, {1, 1.5}, {2, 2}, {3, 1.5}, {4, 0}});
}

TEST_CASE("bezier_forward: the documented error, degrees 0 to 8") {
  test::random r(81);
  for (std::size_t count = 1; count <= 9; ++count)
    for (const int n : {1, 2, 7, 100, 3000}) {
      double worst = 0;
      for (int trial = 0; trial < 10; ++trial) {
        std::vector<P> points(count), scratch(count);
        for (P& p : points) p = {2 * r.unit() - 1, 2 * r.unit() - 1};
        int k = 0;
        irg::bezier_forward(points, n, std::span<P>(scratch), [&](const P& p) {
          std::vector<P> room(count);
          const P want = irg::bezier_point(points, irg::curve_fraction<double>(k, n), room);
          if (k == 0) CHECK(p == points[0]);
          if (k == n) CHECK(p == points[count - 1]);
          worst = std::fmax(worst, std::fmax(std::abs(p.x - want.x), std::abs(p.y - want.y)));
          ++k;
        });
        CHECK(k == n + 1);
      }
      const double power = std::pow(2., static_cast<double>(count - 1));
      CHECK(worst <= power * (n + power) * 0x1p-53);
      if (n >= 100 && (count == 4 || count == 9))
        MESSAGE("degree ", count - 1, ", ", n, " steps: ", worst * 0x1p53, " u");
    }
}

TEST_CASE("bezier_forward: control points that are equal, one point") {
  const std::array<P, 4> one{P{3, 5}, {3, 5}, {3, 5}, {3, 5}};
  std::array<P, 4> scratch{};
  irg::bezier_forward(one, 50, std::span<P>(scratch), [&](const P& p) { CHECK(p == one[0]); });
}
