// SPDX-License-Identifier: MIT
#include <irg/hidden/textbook/depth_sort_parts.hpp>

#include "support/check_both.hpp"
#include "support/random.hpp"

namespace {

using depth_sort_list = irg::textbook::depth_sort_list<double>;
using depth_sort_part = irg::textbook::depth_sort_part<double>;
using ring = std::vector<irg::point<double, 3>>;

constexpr depth_sort_part part_of(const ring& corners, std::uint32_t number) {
  return irg::textbook::make_part(corners, number, irg::textbook::visible_plane_of(corners), number);
}

TEST_CASE("depth sort's parts: depths, what hides what, and what is let pass") {
  constexpr auto hides = [](const ring& p, const ring& q) {
    return !irg::textbook::does_not_hide(part_of(p, 0), part_of(q, 1));
  };
  const ring low{{0, 0, 0}, {4, 0, 1}, {0, 4, 2}}, high{{0, 0, 1}, {4, 0, 2}, {0, 4, 3}},
      far{{0, 0, -9}, {4, 0, -8}, {0, 4, -7}};
  CHECK(part_of(low, 7).farthest == 0);
  CHECK(part_of(low, 7).nearest == 2);
  CHECK(hides(high, low));
  CHECK(!hides(low, high));
  CHECK(!hides(far, low));  // by their depths
  CHECK_BOTH(hides({{0, 0, 1}, {4, 0, 2}, {0, 4, 3}}, {{0, 0, 0}, {4, 0, 1}, {0, 4, 2}}));
  depth_sort_part p = part_of(high, 0);
  p.let_pass.push_back(1);
  CHECK(irg::textbook::does_not_hide(p, part_of(low, 1)));
  CHECK(irg::textbook::does_not_hide(part_of(high, 1), part_of(low, 1)));  // parts of one polygon
}

TEST_CASE("depth sort's parts: halves stand by their depths and keep to their sides") {
  test::random r(1673);
  int splits = 0;
  for (int trial = 0; trial < 1000; ++trial) {
    depth_sort_list list;
    for (std::uint32_t i = 0; i < 3; ++i) {
      ring corners;
      for (int k = 0; k < 3; ++k)
        corners.push_back({static_cast<double>(r.integer(0, 20)), static_cast<double>(r.integer(0, 20)),
                           static_cast<double>(r.integer(0, 20))});
      list.parts.push_back(part_of(corners, i));
    }
    std::sort(list.parts.begin(), list.parts.end(),
              [](const depth_sort_part& p, const depth_sort_part& q) { return p.farthest > q.farthest; });
    list.made = 3;
    const depth_sort_part by = list.parts[2];
    const bool cuts = irg::textbook::has_corner_on(list.parts[0].polygon.corners, by.plane, 1) &&
                      irg::textbook::has_corner_on(list.parts[0].polygon.corners, by.plane, -1);
    CHECK(irg::textbook::split_part(list, 0, 2) == cuts);
    CHECK(list.parts.size() == (cuts ? 4 : 3));
    for (std::size_t i = 1; i < list.parts.size(); ++i) CHECK(list.parts[i - 1].farthest >= list.parts[i].farthest);
    for (const depth_sort_part& p : list.parts)
      for (const auto& [number, side] : p.cuts) {
        CHECK(number == by.polygon.number);
        CHECK(irg::textbook::reaches(p, by, side));
        CHECK(!irg::textbook::reaches(p, by, -side));
      }
    splits += cuts;
  }
  CHECK(splits > 200);
}

}  // namespace
