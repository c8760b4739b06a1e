// SPDX-License-Identifier: MIT
#include <irg/geometry/textbook/intersect_lines.hpp>

#include <array>

#include "support/check_both.hpp"
#include "support/rational.hpp"

using irg::flat_relation;
using irg::point;
using test::rational;

namespace {

using P3 = point<double, 3>;
using Q3 = point<rational, 3>;
constexpr rational half(1, 2);

template <class P>
constexpr bool crosses(const irg::lines_meeting<P>& m, const P& at, const irg::scalar_of<P>& t,
                       const irg::scalar_of<P>& s) {
  return m.relation == flat_relation::crossing && m.at == at && m.t == t && m.s == s;
}

// Hank's six pairs of lines.
constexpr std::array<Q3, 4> pairs[6] = {
    {Q3{0, 0, 0}, Q3{2, 2, 2}, Q3{2, 0, 0}, Q3{0, 2, 2}}, {Q3{0, 0, 0}, Q3{1, 0, 0}, Q3{0, 1, 1}, Q3{0, 1, 2}},
    {Q3{0, 0, 0}, Q3{0, 1, 1}, Q3{0, 0, 1}, Q3{0, 1, 0}}, {Q3{0, 0, 0}, Q3{1, 1, 0}, Q3{0, 0, 1}, Q3{1, 1, 1}},
    {Q3{0, 0, 0}, Q3{1, 1, 1}, Q3{2, 2, 2}, Q3{3, 3, 3}}, {Q3{0, 0, 0}, Q3{1, 1, 1}, Q3{3, 0, 3}, Q3{0, 3, 3}}};
constexpr flat_relation relations[6] = {flat_relation::crossing, flat_relation::skew,       flat_relation::crossing,
                                        flat_relation::parallel, flat_relation::coincident, flat_relation::skew};

}  // namespace

TEST_CASE("textbook::intersect_lines: the course's form and its program's") {
  for (int i = 0; i < 6; ++i) {
    const auto& p = pairs[i];
    const auto m = irg::textbook::intersect_lines(p[0], p[1], p[2], p[3]);
    CHECK(m.has_value() == (relations[i] == flat_relation::crossing));
    if (m) CHECK(crosses(*m, irg::intersect_lines(p[0], p[1], p[2], p[3]).at, half, half));
    const auto seed = irg::textbook::intersect_lines_by_x_and_y(p[0], p[1], p[2], p[3]);
    CHECK(seed.has_value() == (i == 0));  // the third pair meets, but not by the equations of x and y
  }
  // Lines of some 1e-4 are none to the program's threshold.
  constexpr double e = 1e-4;
  CHECK_BOTH(!irg::textbook::intersect_lines_by_x_and_y(P3{0, 0, 0}, P3{e, e, 0}, P3{e, 0, 0}, P3{0, e, 0}));
  CHECK_BOTH(irg::intersect_lines(P3{0, 0, 0}, P3{e, e, 0}, P3{e, 0, 0}, P3{0, e, 0}).relation ==
             flat_relation::crossing);
  CHECK_BOTH(crosses(*irg::textbook::intersect_lines(P3{0, 0, 0}, P3{e, e, 0}, P3{e, 0, 0}, P3{0, e, 0}),
                     {e / 2, e / 2, 0}, 0.5, 0.5));
}
