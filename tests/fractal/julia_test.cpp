// SPDX-License-Identifier: MIT
#include <irg/fractal/julia.hpp>

#include <limits>

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
  CHECK_BOTH(julia_is_connected(C{0.3, 0}, 5) == connectedness::undecided);
  CHECK_BOTH(julia_is_connected(C{0.25, 0}, 100) == connectedness::undecided);  // parabolic: for ever on its way
  CHECK(julia_is_connected(C{std::numeric_limits<double>::quiet_NaN(), 0}, 100) == connectedness::undecided);
  CHECK_BOTH(julia_is_connected(C{0.32, 0.043}, 1000) == connectedness::undecided);
  CHECK(julia_is_connected(C{0.32, 0.043}, 10000) == connectedness::yes);
}
