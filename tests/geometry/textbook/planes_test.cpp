// SPDX-License-Identifier: MIT
#include <irg/geometry/textbook/planes.hpp>

#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include <irg/math/length.hpp>

#include "support/check_both.hpp"
#include "support/random.hpp"
#include "support/rational.hpp"

using irg::newell_plane;
using irg::plane;
using irg::point;
using test::rational;

namespace {
using P = point<rational, 3>;
using L = plane<rational>;
using D = point<double, 3>;
}  // namespace

TEST_CASE("textbook::newell_plane: the course's values") {
  constexpr std::array<P, 4> square{P{0, 0, 0}, P{1, 0, 0}, P{1, 1, 0}, P{0, 1, 0}};
  constexpr std::array<P, 4> bent{P{0, 0, 0}, P{2, 0, 0}, P{2, 2, 1}, P{0, 2, 0}};
  CHECK_BOTH(irg::textbook::newell_plane(square) == L{0, 0, 2, 0});
  CHECK_BOTH(irg::textbook::newell_plane(bent) == L{-2, -2, 8, 0});
  CHECK_BOTH(irg::newell_plane_through_centroid(square) == L{0, 0, 2, 0});
  CHECK_BOTH(irg::newell_plane_through_centroid(bent) == L{-2, -2, 8, 2});  // centroid (1, 1, 1/4)
  CHECK_BOTH(!irg::textbook::newell_plane(std::array<P, 3>{P{0, 0, 0}, P{1, 1, 1}, P{2, 2, 2}}));
  CHECK_BOTH(!irg::textbook::newell_plane(std::array<P, 2>{P{0, 0, 0}, P{1, 1, 1}}));
  CHECK_BOTH(!irg::newell_plane_through_centroid(std::array<P, 3>{P{0, 0, 0}, P{1, 1, 1}, P{2, 2, 2}}));
}

TEST_CASE("newell_plane: 2e-10 rad at 1e6 from the origin; the printed sums are worse") {
  test::random r(13);
  double about_first = 0, printed = 0;
  for (int i = 0; i < 2000; ++i) {
    // A pentagon in the plane of slopes u and v; rounding 1e6 + z alone takes it out of that plane.
    std::vector<D> ring;
    const double u = 2 * r.unit() - 1, v = 2 * r.unit() - 1;
    for (int k = 0; k < 5; ++k) {
      const double angle = 2 * std::numbers::pi * (k + r.unit() * 0.8) / 5;
      const double x = 1e6 + std::cos(angle), y = 1e6 + std::sin(angle);
      ring.push_back({x, y, 1e6 + (u * (x - 1e6) + v * (y - 1e6))});
    }
    const auto off = [&](const plane<double>& p) {
      const irg::vec<double, 3> n = normal_of(p), want{-u, -v, 1};
      return std::sqrt(length_squared(cross(n, want)) / (length_squared(n) * length_squared(want)));
    };
    about_first = std::fmax(about_first, off(*newell_plane(ring)));
    printed = std::fmax(printed, off(*irg::textbook::newell_plane(ring)));
  }
  MESSAGE("about the first vertex ", about_first, " rad, as printed ", printed, " rad");
  CHECK(about_first <= 2e-10);
  CHECK(printed > about_first);
}

using irg::plane;
using test::rational;

namespace {

using Q = irg::hpoint<rational, 3>;
using H = irg::hpoint<double, 3>;

}  // namespace

TEST_CASE("textbook::plane_by_inversion: the course's values") {
  constexpr Q a{1, 0, 0, 1}, b{0, 2, 0, 1}, c{0, 0, 3, 1};
  // As printed, with D = 5 in the matrix: the last coefficient is 1/5.
  constexpr auto printed = irg::textbook::plane_by_inversion(a, b, c, 5);
  CHECK_BOTH(printed.value == plane<rational>{rational(-1, 5), rational(-1, 10), rational(-1, 15), rational(1, 5)});
}

TEST_CASE("textbook::plane_by_inversion: where there is none") {
  CHECK_BOTH(irg::textbook::plane_by_inversion(H{1, 0, 1, 1}, H{0, 1, 1, 1}, H{1, 1, 2, 1}, 1).status ==
             irg::inversion_status::through_origin);
  CHECK_BOTH(irg::textbook::plane_by_inversion(H{1, 0, 0, 1}, H{2, 0, 0, 1}, H{3, 0, 0, 1}, 1).status ==
             irg::inversion_status::collinear);
  // A divisor of subnormal size leaves no D: 1/D is beyond the range.
  CHECK_BOTH(irg::textbook::plane_by_inversion(H{1, 0, 0, 1}, H{0, 2, 0, 1}, H{0, 0, 3, 1}, 0x1p1023).status ==
             irg::inversion_status::ok);
}

using irg::mat;
using irg::parametric_plane;

namespace {

using Corner = irg::point<double, 3>;
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

}  // namespace

TEST_CASE("textbook::parametric_plane_at_middle: Hank's values, the middle point is the origin") {
  constexpr auto p = *irg::textbook::parametric_plane_at_middle(Corner{1, 0, 0}, Corner{0, 0, 0}, Corner{0, 1, 0});
  CHECK_BOTH(p == parametric_plane<double>{{1, 0, 0}, {0, 1, 0}, {0, 0, 0}});
  CHECK_BOTH(
      columns_of(*irg::textbook::parametric_plane_at_middle(Corner{1, 2, 3}, Corner{4, 0, 0}, Corner{7, 8, 9})) ==
      mat<double, 3, 3>{{{-3, 3, 4}, {2, 8, 0}, {3, 9, 0}}});
  // Collinear points are no plane; the source lets them pass.
  CHECK_BOTH(!irg::textbook::parametric_plane_at_middle(Corner{0, 0, 0}, Corner{1, 1, 1}, Corner{2, 2, 2}));
  CHECK_BOTH(irg::textbook::parametric_plane_as_printed(Corner{0, 0, 0}, Corner{1, 1, 1}, Corner{2, 2, 2}) ==
             parametric_plane<double>{{-1, -1, -1}, {1, 1, 1}, {1, 1, 1}});
  CHECK_BOTH(!irg::textbook::parametric_plane_as_printed(Corner{0, 0, 0}, Corner{1, 1, 1}, Corner{0, 0, 0}));
  CHECK_BOTH(!implicit_plane_of(
      *irg::textbook::parametric_plane_as_printed(Corner{0, 0, 0}, Corner{1, 1, 1}, Corner{2, 2, 2})));
  // Nearly collinear is not collinear.
  CHECK_BOTH(irg::textbook::parametric_plane_at_middle(Corner{0, 0, 0}, Corner{1, 1, 1}, Corner{2, 2, 2 + 0x1p-51})
                 .has_value());
  CHECK_BOTH(!irg::textbook::parametric_plane_at_middle(Corner{0, 0, not_a_number}, Corner{1, 1, 1}, Corner{2, 2, 5}));
}
