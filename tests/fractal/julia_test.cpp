// SPDX-License-Identifier: MIT
#include <irg/fractal/julia.hpp>

#include <cstddef>
#include <limits>
#include <map>
#include <utility>

#include "support/check_both.hpp"
#include "support/random.hpp"

using irg::connectedness;
using irg::julia_count;
using irg::julia_is_connected;
using irg::make_escape_limit;

namespace {

using C = irg::point<double, 2>;

}  // namespace

TEST_CASE("julia_count: z and -z alike, and the orbit of 0 is Mandelbrot's") {
  constexpr auto limit = make_escape_limit(100.0, 40);
  constexpr C c{0.32, 0.043};
  test::random r(3);
  for (int i = 0; i < 2000; ++i) {
    const C z{3 * r.unit() - 1.5, 3 * r.unit() - 1.5};
    REQUIRE(julia_count(z, c, limit) == julia_count(C{-z.x, -z.y}, c, limit));
    REQUIRE(julia_count(C{0, 0}, z, limit) == mandelbrot_count(z, limit));
  }
  CHECK_BOTH(julia_count(C{0, 0}, C{0, 0}, limit) == 40);
  CHECK_BOTH(julia_count(C{200, 0}, C{0, 0}, limit) == 0);
  CHECK_BOTH(julia_count(C{10, 0}, C{0, 0}, limit) == 0);
  CHECK_BOTH(julia_count(C{3, 0}, C{0, 0}, limit) == 2);  // 9, 81, 6561
}

TEST_CASE("julia_is_connected: yes, no, and what so many steps cannot tell") {
  CHECK_BOTH(julia_is_connected(C{0, 0}, 0) == connectedness::yes);
  CHECK_BOTH(julia_is_connected(C{-1, 0}, 0) == connectedness::yes);
  CHECK_BOTH(julia_is_connected(C{-2, 0}, 10) == connectedness::yes);   // 0, -2, 2, 2, ...
  CHECK_BOTH(julia_is_connected(C{0, 1}, 10) == connectedness::yes);    // a cycle of two
  CHECK_BOTH(julia_is_connected(C{-1.3, 0}, 1000) == connectedness::yes);  // a cycle of four attracts
  CHECK_BOTH(julia_is_connected(C{1, 0}, 100) == connectedness::no);
  CHECK_BOTH(julia_is_connected(C{0.3, 0}, 100) == connectedness::no);
  CHECK_BOTH(julia_is_connected(C{2.5, 0}, 1) == connectedness::no);
  CHECK_BOTH(julia_is_connected(C{0, 2 + 0x1p-18}, 1) == connectedness::no);  // outside of the disc of radius 2 at once
  CHECK_BOTH(julia_is_connected(C{0.3, 0}, 5) == connectedness::undecided);
  CHECK_BOTH(julia_is_connected(C{0.25, 0}, 100) == connectedness::undecided);  // parabolic: for ever on its way
  CHECK(julia_is_connected(C{std::numeric_limits<double>::quiet_NaN(), 0}, 100) == connectedness::undecided);
  CHECK_BOTH(julia_is_connected(C{0.32, 0.043}, 1000) == connectedness::undecided);
  CHECK(julia_is_connected(C{0.32, 0.043}, 10000) == connectedness::yes);
}

// The point `first` is the first that comes again, `period` steps later. Of the points 2, 3, 5, 9, ... one after the
// other is kept, until one that is not before `first` has been kept for a period.
TEST_CASE("julia_is_connected: orbits that come back are told as soon as the point kept says so") {
  test::random r(17);
  int told = 0;
  for (const C& about : {C{-1.31, 0}, {-1.38, 0}, {-1.7549, 0}, {-0.1226, 0.7449}, {0.2823, 0.53}, {-0.504, 0.563}}) {
    for (int trial = 0; trial < 60; ++trial) {
      const C c{about.x + 0.02 * (r.unit() - 0.5), about.y == 0 ? 0 : about.y + 0.02 * (r.unit() - 0.5)};
      std::map<std::pair<double, double>, int> met;
      C z{0, 0};
      int number = 0, first = 0;
      for (; number < 4000; ++number) {
        const auto [place, is_new] = met.emplace(std::pair{z.x, z.y}, number);
        first = place->second;
        if (!is_new) break;
        z = irg::square_plus<double>{c}(z);
      }
      if (number == 4000 || irg::mandelbrot_part_of(c) != irg::mandelbrot_part::elsewhere) continue;
      const int period = number - first;
      int kept = 1;
      while (kept + 1 < first || kept < period) kept *= 2;
      ++told;
      CHECK(julia_is_connected(c, kept + 1 + period) == connectedness::yes);
      CHECK(julia_is_connected(c, number - 1) == connectedness::undecided);
    }
  }
  CHECK(told > 100);
}
