// SPDX-License-Identifier: MIT
#include <irg/hidden/textbook/split_by_plane.hpp>

#include <irg/geometry/clip_sutherland_hodgman.hpp>

#include "support/check_both.hpp"
#include "support/exact.hpp"
#include "support/random.hpp"

namespace {

using ring = std::vector<irg::point<double, 3>>;

TEST_CASE("textbook::part_on_side: both halves by hand, and what lies on one side") {
  constexpr auto halves = [](int side) {
    const auto plane = irg::textbook::visible_plane_of(ring{{0, 0, 4}, {8, 0, 0}, {0, 8, 4}});  // z = 4 - x/2
    return irg::textbook::part_on_side(ring{{0, 0, 0}, {8, 0, 8}, {0, 8, 0}}, plane, side);     // z = x
  };
  CHECK(halves(1).size() == 3);
  CHECK_BOTH(halves(1)[1] == irg::point<double, 3>{8, 0, 8});
  CHECK(halves(-1).size() == 4);
  CHECK(halves(1)[0] == halves(-1)[1]);
  CHECK(halves(1)[2] == halves(-1)[2]);
  const auto level = irg::textbook::visible_plane_of(ring{{0, 0, 5}, {1, 0, 5}, {0, 1, 5}});
  const ring below{{0, 0, 0}, {1, 0, 5}, {0, 1, 5}};
  CHECK(irg::textbook::part_on_side(below, level, -1) == below);
  CHECK(irg::textbook::part_on_side(below, level, 1) == ring{{1, 0, 5}, {0, 1, 5}});
}

TEST_CASE("textbook::area_in_common: that of Sutherland and Hodgman's clipping, whichever way corners run") {
  test::random rnd(61);
  int common = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    ring p, q;
    for (ring* r : {&p, &q})
      for (int i = 0; i < 3; ++i)
        r->push_back({double(rnd.integer(-9, 9)), double(rnd.integer(-9, 9)), double(rnd.integer(-99, 99))});
    const auto flat_q = irg::textbook::without_depth(q);
    if (irg::polygon_area(flat_q) == 0) continue;
    const double area = irg::textbook::area_in_common(p, q);
    const double expected = irg::polygon_area(irg::clip_sutherland_hodgman(irg::textbook::without_depth(p), flat_q));
    const double off = area - (expected < 0 ? -expected : expected);
    CHECK((off < 1e-12 && -1e-12 < off));
    common += area > 0 ? 1 : 0;
  }
  CHECK(test::enough(common > 800));
}

}  // namespace
