// SPDX-License-Identifier: MIT
#include <irg/geometry/textbook/clip_sutherland_hodgman.hpp>

#include <array>
#include <limits>
#include <vector>

#include <irg/geometry/clip_sutherland_hodgman.hpp>
#include <irg/geometry/polygon_area.hpp>

#include "support/check_both.hpp"
#include "support/random.hpp"
#include "support/rational.hpp"

using test::rational;

namespace {

using R = irg::point<rational, 2>;
using S = irg::point<rational, 3>;
using P = irg::point<double, 2>;
using L = irg::line<rational>;
using Ring = std::vector<R>;

// x >= 0, x <= 4, y >= 0, y <= 3.
constexpr std::array<L, 4> window{L{1, 0, 0}, L{-1, 0, 4}, L{0, 1, 0}, L{0, -1, 3}};

std::vector<std::size_t> sizes(Ring ring) {
  std::vector<std::size_t> all;
  for (const L& l : window) {
    ring = irg::textbook::clip_stage(ring, l);
    all.push_back(ring.size());
  }
  return all;
}

constexpr bool touches() {
  return irg::textbook::clip_sutherland_hodgman(std::array<P, 3>{P{4, 1}, P{6, 1}, P{4, 2}},
                                                std::array{irg::line<double>{-1, 0, 4}}) ==
         std::vector<P>{{4, 1}, {4, 2}, {4, 2}, {4, 1}};
}

}  // namespace

TEST_CASE("textbook::clip_sutherland_hodgman: Hank's values, vertex by vertex") {
  using V = std::vector<std::size_t>;
  const rational half{1, 2}, third{7, 3};
  const Ring tip{{-1, 1}, {5, 1}, {2, 5}};
  CHECK(irg::textbook::clip_sutherland_hodgman(tip, window) ==
        Ring{{half + 3, 3}, {half, 3}, {0, third}, {0, 1}, {4, 1}, {4, third}});
  CHECK(sizes(tip) == V{4, 5, 5, 6});
  const Ring inside{{1, 1}, {2, 1}, {2, 2}};
  CHECK(irg::textbook::clip_sutherland_hodgman(inside, window) == Ring{{2, 1}, {2, 2}, {1, 1}});
  CHECK(sizes(inside) == V{3, 3, 3, 3});
  const Ring outside{{5, 5}, {6, 5}, {6, 6}};
  CHECK(irg::textbook::clip_sutherland_hodgman(outside, window).empty());
  CHECK(sizes(outside) == V{3, 0, 0, 0});
  // Points on the boundary count as inside: what touches it comes out without area, its vertices twice.
  const Ring touching{{4, 1}, {6, 1}, {4, 2}};
  CHECK(irg::textbook::clip_sutherland_hodgman(touching, window) == Ring{{4, 1}, {4, 1}, {4, 2}, {4, 2}});
  CHECK(sizes(touching) == V{3, 4, 4, 4});
  const Ring around{{-10, -10}, {20, -10}, {20, 20}, {-10, 20}};
  CHECK(irg::textbook::clip_sutherland_hodgman(around, window) == Ring{{4, 3}, {0, 3}, {0, 0}, {4, 0}});
  CHECK(sizes(around) == V{4, 4, 4, 4});
}

TEST_CASE("textbook::clip_sutherland_hodgman: Hank's values, the view pyramid") {
  // 1 <= z <= 10, |x| <= 2z, |y| <= 3z/2; near, far, left, right, top, bottom.
  using F = irg::plane<rational>;
  const std::vector<F> pyramid{{0, 0, 1, -1}, {0, 0, -1, 10}, {1, 0, 2, 0}, {-1, 0, 2, 0}, {0, -2, 3, 0}, {0, 2, 3, 0}};
  CHECK(irg::textbook::clip_sutherland_hodgman(std::array<S, 3>{S{0, 0, -1}, S{0, 0, 5}, S{20, 0, 5}}, pyramid) ==
        std::vector<S>{{0, 0, 5}, {10, 0, 5}, {2, 0, 1}, {0, 0, 1}});
}

TEST_CASE("textbook::clip_sutherland_hodgman: degenerate and hostile") {
  CHECK_BOTH(touches());
  CHECK(irg::textbook::clip_sutherland_hodgman(Ring{}, window).empty());
  CHECK(irg::textbook::clip_sutherland_hodgman(Ring{{1, 1}}, window) == Ring{{1, 1}});
  CHECK(irg::textbook::clip_sutherland_hodgman(Ring{{9, 9}}, window).empty());
  CHECK(irg::textbook::clip_sutherland_hodgman(Ring{{1, 1}, {2, 2}, {3, 1}}, std::vector<L>{}).size() == 3);
  constexpr double none = std::numeric_limits<double>::quiet_NaN(), huge = std::numeric_limits<double>::max();
  const std::array side{irg::line<double>{1, 0, 0}};
  CHECK(irg::textbook::clip_sutherland_hodgman(std::array<P, 3>{P{none, 0}, P{1, 1}, P{1, 0}}, side).size() == 3);
  CHECK(irg::textbook::clip_sutherland_hodgman(std::array<P, 3>{P{-huge, 0}, P{huge, huge}, P{huge, -huge}}, side)
            .size() == 4);
}

TEST_CASE("textbook::clip_sutherland_hodgman: in rationals the area of what clip_sutherland_hodgman leaves") {
  test::random r(1);
  const irg::box<rational, 2> box{{0, 0}, {4, 3}};
  for (int i = 0; i < 1000; ++i) {
    Ring ring;
    for (int k = 0; k < 5; ++k) ring.push_back({r.integer(-6, 9), r.integer(-6, 9)});
    CHECK(irg::twice_signed_area(irg::textbook::clip_sutherland_hodgman(ring, window)) ==
          irg::twice_signed_area(clip_sutherland_hodgman(ring, box)));
  }
}
