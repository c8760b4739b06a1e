// SPDX-License-Identifier: MIT
#include <irg/geometry/textbook/clip_weiler_atherton.hpp>

#include <cmath>
#include <cstdlib>
#include <limits>
#include <vector>

#include <irg/geometry/polygon_area.hpp>
#include <irg/geometry/polygon_overlay.hpp>

#include "support/check_both.hpp"
#include "support/random.hpp"

using irg::textbook::clip_weiler_atherton;
using irg::textbook::weiler_atherton_status;

namespace {

using P = irg::point<double, 2>;
using Ring = std::vector<P>;

constexpr Ring comb() {
  return {{0, 0}, {5, 0}, {5, 3}, {4, 3}, {4, 1}, {3, 1}, {3, 3}, {2, 3}, {2, 1}, {1, 1}, {1, 3}, {0, 3}};
}
constexpr Ring square(double low, double high) { return {{low, low}, {high, low}, {high, high}, {low, high}}; }
constexpr auto status(const Ring& a, const Ring& b) { return clip_weiler_atherton(a, b).status; }
constexpr std::size_t parts(const Ring& a, const Ring& b) { return clip_weiler_atherton(a, b).rings.size(); }

// A star-shaped ring with random corners, counter-clockwise.
Ring star(test::random& random, P centre, double size) {
  const int corners = static_cast<int>(random.integer(6, 24));
  Ring ring;
  for (int i = 0; i < corners; ++i) {
    const double angle = (i + 0.8 * random.unit()) * 6.283185307179586 / corners;
    const double radius = size * (0.2 + 0.8 * random.unit());
    ring.push_back({centre.x + radius * std::cos(angle), centre.y + radius * std::sin(angle)});
  }
  return ring;
}

}  // namespace

TEST_CASE("textbook::clip_weiler_atherton: a comb and a bar, their entering and leaving points") {
  constexpr auto teeth = [] {
    const auto r = clip_weiler_atherton(comb(), Ring{{-1, 2}, {9, 2}, {9, 9}, {-1, 9}});
    return r.status == weiler_atherton_status::ok && r.rings.size() == 3 && r.entering.size() == 3 &&
           r.leaving == Ring{{4, 2}, {2, 2}, {0, 2}} && r.rings[0] == Ring{{5, 2}, {5, 3}, {4, 3}, {4, 2}};
  };
  CHECK_BOTH(teeth());
}

TEST_CASE("textbook::clip_weiler_atherton: no crossings, touching, no numbers") {
  CHECK_BOTH(parts(square(0, 9), square(3, 4)) == 1);
  CHECK_BOTH(parts(square(3, 4), square(0, 9)) == 1);
  CHECK_BOTH(parts(square(0, 1), square(3, 4)) == 0);
  CHECK_BOTH(status(square(0, 1), square(3, 4)) == weiler_atherton_status::ok);
  CHECK_BOTH(status(square(0, 2), square(0, 2)) == weiler_atherton_status::touching);
  CHECK_BOTH(status(square(0, 2), square(1, 2)) == weiler_atherton_status::touching);
  CHECK_BOTH(status(square(0, 2), square(2, 3)) == weiler_atherton_status::touching);
  CHECK_BOTH(status(square(0, 2), Ring{{2, 0.5}, {3, 0.5}, {3, 1}}) == weiler_atherton_status::touching);
  CHECK_BOTH(parts({}, square(0, 1)) == 0);
  CHECK_BOTH(status(square(0, std::numeric_limits<double>::quiet_NaN()), square(0, 1)) ==
             weiler_atherton_status::not_finite);
}

TEST_CASE("textbook::clip_weiler_atherton: holes") {
  // A frame against a square across its side, and one within its hole.
  const std::vector<Ring> frame{square(0, 9), {{3, 3}, {3, 6}, {6, 6}, {6, 3}}};
  const auto across = clip_weiler_atherton(frame, Ring{{-1, 1}, {5, 1}, {5, 8}, {-1, 8}});
  CHECK(across.rings.size() == 1);
  CHECK(irg::polygon_area(across.rings) == 35 - 6);
  CHECK(clip_weiler_atherton(frame, square(4, 5)).rings.empty());
  const auto around = clip_weiler_atherton(square(-1, 10), frame);
  CHECK(around.rings.size() == 2);
  CHECK(irg::polygon_area(around.rings) == 72);
}

TEST_CASE("textbook::clip_weiler_atherton: what polygon_boolean finds, for random stars") {
  test::random random(1977);
  const int trials = std::getenv("IRG_RELEASE_TIER") ? 100000 : 1500;
  int several = 0, done = 0;
  for (int trial = 0; trial < trials; ++trial) {
    const double size = std::ldexp(1.0, static_cast<int>(random.integer(-300, 300)));
    const Ring a = star(random, {0, 0}, size),
               b = star(random, {size * (1.4 * random.unit() - 0.7), size * (1.4 * random.unit() - 0.7)}, size);
    const auto walked = clip_weiler_atherton(a, b);
    if (walked.status != weiler_atherton_status::ok) continue;
    ++done;
    CHECK(walked.entering.size() == walked.leaving.size());
    const auto overlay = irg::polygon_boolean(a, b);
    several += overlay.rings.size() > 1;
    const double want = irg::polygon_area(overlay.rings), got = irg::polygon_area(walked.rings);
    CHECK(walked.rings.size() == overlay.rings.size());
    CHECK(std::abs(want - got) <= 1e-13 * size * size);
  }
  CHECK(done == trials);
  CHECK(several > trials / 20);
}
