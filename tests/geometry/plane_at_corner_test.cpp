// SPDX-License-Identifier: MIT
#include <irg/geometry/plane_at_corner.hpp>

#include <array>
#include <limits>
#include <vector>

#include "support/check_both.hpp"
#include "support/random.hpp"
#include "support/rational.hpp"

using irg::newell_plane;
using irg::plane;
using irg::plane_at_corner;
using irg::point;
using irg::vec;

namespace {

using I = point<std::int64_t, 3>;
using D = point<double, 3>;
using Ring = std::vector<I>;

// Same direction, not only parallel.
bool agree(const plane<std::int64_t>& p, const plane<std::int64_t>& q) {
  const vec<std::int64_t, 3> n = irg::normal_of(p), m = irg::normal_of(q);
  return irg::cross(n, m) == vec<std::int64_t, 3>{} && irg::dot(n, m) > 0;
}

// The course's L: its vertex (1, 1) is reflex.
constexpr std::array<I, 6> bracket{I{0, 0, 0}, I{3, 0, 0}, I{3, 1, 0}, I{1, 1, 0}, I{1, 3, 0}, I{0, 3, 0}};

}  // namespace

TEST_CASE("plane_at_corner: by hand, in every life") {
  CHECK_BOTH(plane_at_corner(std::array<D, 3>{D{1, 0, 0}, D{0, 2, 0}, D{0, 0, 3}}) == plane<double>{6, 3, 2, -6});
  CHECK_BOTH(plane_at_corner(std::array<D, 4>{D{0, 0, 0}, D{1, 0, 0}, D{1, 1, 0}, D{0, 1, 0}}) ==
             plane<double>{0, 0, 1, 0});
  CHECK_BOTH(plane_at_corner(bracket)->c > 0);
  // Three vertices in a row at the reflex corner give the other side.
  CHECK_BOTH(irg::plane_through(bracket[2], bracket[3], bracket[4])->c < 0);
  volatile double one = 1;
  CHECK(plane_at_corner(std::array<D, 3>{D{one, 0, 0}, D{0, 2, 0}, D{0, 0, 3}}) == plane<double>{6, 3, 2, -6});
}

TEST_CASE("plane_at_corner: nothing to stand on") {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  CHECK_BOTH(!plane_at_corner(std::array<I, 2>{I{0, 0, 0}, I{1, 0, 0}}));
  CHECK_BOTH(!plane_at_corner(std::array<I, 3>{I{0, 0, 0}, I{1, 1, 1}, I{2, 2, 2}}));
  CHECK_BOTH(!plane_at_corner(std::array<I, 4>{I{5, 5, 5}, I{5, 5, 5}, I{5, 5, 5}, I{5, 5, 5}}));
  CHECK_BOTH(
      !plane_at_corner(std::array<I, 4>{I{0, 0, 0}, I{4, 0, 0}, I{4, 4, 0}, I{4, 0, 0}}));  // a spike at the corner
  CHECK_BOTH(!plane_at_corner(std::array<D, 3>{D{none, none, none}, D{none, none, none}, D{none, none, none}}));
  CHECK(!plane_at_corner(Ring{}));
  // Repeated vertices are passed over.
  CHECK_BOTH(plane_at_corner(std::array<I, 6>{I{0, 0, 0}, I{0, 0, 0}, I{2, 0, 0}, I{0, 3, 0}, I{0, 3, 0},
                                              I{0, 0, 0}}) == plane<std::int64_t>{0, 0, 6, 0});
}

TEST_CASE("plane_at_corner: Newell's side, whatever the shape, the direction and the first vertex") {
  test::random r(1);
  int reflex = 0;
  for (int i = 0; i < 2000; ++i) {
    // A star about (0, 0) by angle, so simple; then into a random plane through integer directions.
    static constexpr int by_angle[8][2] = {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}};
    const vec<std::int64_t, 3> u{r.integer(-9, 9), r.integer(-9, 9), r.integer(-9, 9)},
        v{r.integer(-9, 9), r.integer(-9, 9), r.integer(-9, 9)};
    if (irg::cross(u, v) == vec<std::int64_t, 3>{}) continue;
    Ring ring;
    for (const auto& d : by_angle) {
      const std::int64_t far = r.integer(1, 9);
      ring.push_back(I{5, -7, 3} + (u * (d[0] * far) + v * (d[1] * far)));
    }
    if (i % 2 == 0) ring = Ring(ring.rbegin(), ring.rend());
    const auto newell = newell_plane(ring);
    REQUIRE(newell);
    for (std::size_t start = 0; start < ring.size(); ++start) {
      Ring turned;
      for (std::size_t k = 0; k < ring.size(); ++k) turned.push_back(ring[(start + k) % ring.size()]);
      const auto p = plane_at_corner(turned);
      REQUIRE(p);
      CHECK(agree(*p, *newell));
      for (const I& q : ring) CHECK(irg::side_of(*p, q) == irg::side::on);
      const auto any = irg::plane_through(turned[0], turned[1], turned[2]);
      reflex += any && !agree(*any, *newell) ? 1 : 0;
    }
  }
  CHECK(reflex > 1000);  // three vertices in a row do not do
}
