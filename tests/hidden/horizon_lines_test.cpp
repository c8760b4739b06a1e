// SPDX-License-Identifier: MIT
#include <irg/hidden/horizon_lines.hpp>

#include <cmath>
#include <cstdlib>
#include <limits>
#include <vector>

#include "hidden/horizon_lines_oracle.hpp"
#include "support/check_both.hpp"
#include "support/random.hpp"

using irg::drawn_parts;
using irg::edge_part;
using irg::line_visibility;
using irg::visible_curves;

namespace {

using P = irg::point<double, 2>;
constexpr double gap = std::numeric_limits<double>::quiet_NaN();

std::vector<edge_part> parts_of(const std::vector<P>& points, drawn_parts which = drawn_parts::visible) {
  std::vector<edge_part> out;
  visible_curves(points, [&](const edge_part& p) { out.push_back(p); }, which);
  return out;
}

bool same(const std::vector<edge_part>& a, const std::vector<edge_part>& b) {
  if (a.size() != b.size()) return false;
  for (std::size_t i = 0; i < a.size(); ++i)
    if (a[i].edge != b[i].edge || a[i].from != b[i].from || a[i].to != b[i].to) return false;
  return true;
}

#ifdef IRG_HAVE_MPFR
// Curves of a few steps to the right or to the left: coordinates of few values, so that curves touch and share points,
// or of any.
std::vector<P> any_curves(test::random& r, int kind) {
  std::vector<P> points;
  const int curves = static_cast<int>(r.integer(1, 12));
  for (int c = 0; c < curves; ++c) {
    const int steps = static_cast<int>(r.integer(1, 6));
    double x = static_cast<double>(r.integer(-3, 3));
    const double way = r.integer(0, 3) == 0 ? -1 : 1;
    for (int i = 0; i <= steps; ++i) {
      double y = kind == 0 ? static_cast<double>(r.integer(-2, 2)) : 4 * r.unit() - 2;
      if (kind == 2) y = std::ldexp(y, static_cast<int>(r.integer(-300, 300)));
      if (kind == 3) y = 1 + std::ldexp(static_cast<double>(r.integer(-3, 3)), -52);
      points.push_back({x, r.integer(0, 15) == 0 ? gap : y});
      const auto ahead = static_cast<double>(r.integer(kind == 0 ? 0 : 1, 2));
      x += way * (kind == 2 ? std::ldexp(1 + r.unit(), static_cast<int>(r.integer(-60, 0))) : ahead);
    }
    points.push_back({gap, gap});
  }
  return points;
}
#endif

}  // namespace

TEST_CASE("visible_curves: a peak before a line, and before a lower one") {
  const std::vector<P> peak{{0, 0},   {2, 4},   {4, 0},  {gap, 0}, {0, 1}, {4, 1},
                            {gap, 0}, {-1, -1}, {5, -1}, {gap, 0}, {1, 0}, {3, 0}};
  const auto seen = parts_of(peak);
  REQUIRE(seen.size() == 4);
  CHECK(seen[0].edge == 0);
  CHECK(seen[1].edge == 1);
  CHECK((seen[2].edge == 4 && seen[2].from == 0 && seen[2].to == 1));  // nothing is below it yet
  CHECK((seen[3].edge == 7 && seen[3].from == 0 && seen[3].to == 1));
}

TEST_CASE("visible_curves: hidden parts fill what is not seen") {
  const std::vector<P> curves{{0, 0},  {4, 0}, {gap, 0}, {0, 2},  {4, 2}, {gap, 0},
                              {-1, 1}, {5, 1}, {gap, 0}, {1, -1}, {3, 3}};
  const auto all = parts_of(curves, drawn_parts::all);
  std::vector<edge_part> of_line, of_steep;
  for (const edge_part& p : all) {
    if (p.edge == 6) of_line.push_back(p);
    if (p.edge == 9) of_steep.push_back(p);
  }
  REQUIRE(of_line.size() == 3);  // beside both curves, between them, beside them
  CHECK((of_line[0].from == 0 && of_line[0].to == 1.0 / 6 && of_line[0].visibility == line_visibility::visible));
  CHECK((of_line[1].to == 5.0 / 6 && of_line[1].visibility == line_visibility::hidden));
  CHECK((of_line[2].to == 1 && of_line[2].visibility == line_visibility::visible));
  REQUIRE(of_steep.size() == 3);
  CHECK((of_steep[1].from == 0.25 && of_steep[1].to == 0.75 && of_steep[1].visibility == line_visibility::hidden));
}

TEST_CASE("visible_curves: upright steps, touching, no points") {
  CHECK(parts_of({}).empty());
  CHECK(parts_of({{1, 1}}).empty());
  CHECK(parts_of({{1, 1}, {1, 1}}).empty());
  const auto level = parts_of({{0, 0}, {1, 0}, {2, 0}, {gap, 0}, {0, 0}, {2, 0}});  // on both horizons
  REQUIRE(level.size() == 3);
  CHECK((level[2].from == 0 && level[2].to == 1));
  const std::vector<P> upright{{0, 0}, {4, 0},  {gap, 0}, {0, 2},   {4, 2},  {gap, 0},
                               {1, 3}, {1, -1}, {gap, 0}, {1, 0.5}, {1, 1.5}};
  const auto parts = parts_of(upright);
  REQUIRE(parts.size() == 4);
  CHECK((parts[2].from == 0 && parts[2].to == 0.25));
  CHECK((parts[3].from == 0.75 && parts[3].to == 1));
  const double huge = 1e300, least = 1e-300;
  CHECK(parts_of({{-huge, 0}, {huge, least}, {gap, 0}, {-huge, huge}, {huge, -huge}}).size() == 2);
  CHECK(parts_of({{0, std::numeric_limits<double>::infinity()}, {1, 0}, {2, 0}}).size() == 1);
}

TEST_CASE("visible_curves: a curve that ends where two others cross leaves a jump there") {
  const std::vector<P> curves{{0, -6}, {2, 6},  {gap, 0}, {0, 4}, {2, -4}, {gap, 0},
                              {1, -2}, {0, -6}, {gap, 0}, {0, 4}, {2, -6}};
  const auto parts = parts_of(curves);
  REQUIRE(!parts.empty());
  CHECK((parts.back().edge == 9 && parts.back().from == 0.5 && parts.back().to == 1));
}

constexpr int parts_in_constants() {
  const P points[] = {{0, 0}, {2, 2}, {4, 0}, {gap, 0}, {0, 1}, {4, 1}, {gap, 0}, {0, 0.5}, {4, 0.5}};
  int parts = 0;
  visible_curves(points, [&](const edge_part& p) { parts += p.from < p.to ? 1 : 0; }, drawn_parts::all);
  return parts;
}

TEST_CASE("visible_curves: in constant evaluation") {
  static_assert(parts_in_constants() == 6);
  CHECK(parts_in_constants() == 6);
}

#ifdef IRG_HAVE_MPFR
TEST_CASE("visible_curves: against the definition") {
  const int trials = std::getenv("IRG_RELEASE_TIER") != nullptr ? 40000 : 500;
  test::random r(77);
  double hidden = 0, length = 0;
  for (int i = 0; i < trials; ++i) {
    const auto points = any_curves(r, i % 4);
    test::curve_oracle oracle;
    const auto expected = oracle.parts(points);
    REQUIRE(same(parts_of(points), expected));
    hidden += oracle.hidden_length, length += oracle.length;
  }
  CHECK(hidden > 0.1 * length);
}
#endif
