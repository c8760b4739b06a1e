// SPDX-License-Identifier: MIT
#include <irg/geometry/textbook/weiler_atherton_lists.hpp>

#include <vector>

#include "support/check_both.hpp"
#include "support/random.hpp"

namespace {

using irg::textbook::list_crossings;
using irg::textbook::listed_vertex;
using irg::textbook::weiler_atherton_status;
using list_point = irg::point<double, 2>;
using list_rings = std::vector<std::vector<list_point>>;

constexpr list_rings list_square(double low, double high) {
  return {{{low, low}, {high, low}, {high, high}, {low, high}}};
}

}  // namespace

TEST_CASE("textbook::list_crossings: two squares, both lists by hand") {
  constexpr auto as_by_hand = [] {
    const auto l = list_crossings(list_square(0, 2), list_square(1, 3));
    std::vector<list_point> subject, clip;
    for (const listed_vertex<double>& v : l.subject[0]) subject.push_back(v.at);
    for (const listed_vertex<double>& v : l.clip[0]) clip.push_back(v.at);
    return l.status == weiler_atherton_status::ok && l.crossings.size() == 2 && l.crossings[0].enters &&
           !l.crossings[1].enters && l.crossings[0].at == list_point{2, 1} && l.crossings[1].at == list_point{1, 2} &&
           subject == std::vector<list_point>{{0, 0}, {2, 0}, {2, 1}, {2, 2}, {1, 2}, {0, 2}} &&
           clip == std::vector<list_point>{{1, 1}, {2, 1}, {3, 1}, {3, 3}, {1, 3}, {1, 2}} &&
           l.subject[0][2].crossing == 0u && l.subject[0][2].along == 0.5 && l.crossings[1].place[1] == 5;
  };
  CHECK_BOTH(as_by_hand());
}

TEST_CASE("textbook::list_crossings: nothing, apart, touching") {
  constexpr auto status = [](const list_rings& a, const list_rings& b) { return list_crossings(a, b).status; };
  CHECK_BOTH(status({}, {}) == weiler_atherton_status::ok);
  CHECK_BOTH(status({{}}, list_square(0, 1)) == weiler_atherton_status::ok);
  CHECK_BOTH(status(list_square(0, 1), list_square(2, 3)) == weiler_atherton_status::ok);
  CHECK_BOTH(status(list_square(0, 1), list_square(1, 2)) == weiler_atherton_status::touching);
  CHECK_BOTH(status(list_square(0, 4), {{{1, 0}, {3, 0}, {2, 1}}}) == weiler_atherton_status::touching);
  // The ring crosses itself: along the clip polygon two entering points follow each other.
  CHECK_BOTH(status({{{0, 0}, {4, 4}, {4, 0}, {0, 4}}}, {{{-1, 1}, {5, 1}, {5, 3}, {-1, 3}}}) ==
             weiler_atherton_status::touching);
}

TEST_CASE("textbook::list_crossings: vertices in order, crossings between them, entering and leaving in turn") {
  test::random r(1978);
  int crossings = 0, touching = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    list_rings polygon[2];
    for (list_rings& p : polygon) {
      p.emplace_back();
      for (auto n = r.integer(3, 7); n > 0; --n)
        p[0].push_back({static_cast<double>(r.integer(0, 60)), static_cast<double>(r.integer(0, 60))});
    }
    const auto l = list_crossings(polygon[0], polygon[1]);
    touching += l.status == weiler_atherton_status::touching;
    if (l.status != weiler_atherton_status::ok) continue;
    crossings += static_cast<int>(l.crossings.size());
    for (const std::size_t which : {0u, 1u}) {
      const std::vector<listed_vertex<double>>& list = which == 0 ? l.subject[0] : l.clip[0];
      std::vector<list_point> vertices;
      std::vector<bool> enters;
      for (std::size_t i = 0; i < list.size(); ++i) {
        if (i > 0) CHECK((list[i - 1].edge < list[i].edge || list[i - 1].along < list[i].along));
        if (!list[i].crossing) {
          vertices.push_back(list[i].at);
          continue;
        }
        CHECK(l.crossings[*list[i].crossing].place[which] == i);
        CHECK(l.crossings[*list[i].crossing].at == list[i].at);
        enters.push_back(l.crossings[*list[i].crossing].enters);
      }
      CHECK(vertices == polygon[which][0]);
      CHECK(enters.size() == l.crossings.size());
      for (std::size_t k = 0; k < enters.size(); ++k) CHECK(enters[k] != enters[(k + 1) % enters.size()]);
    }
  }
  CHECK(crossings > 1000);
  CHECK(touching > 100);
}
