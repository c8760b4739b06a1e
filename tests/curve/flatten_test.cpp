// SPDX-License-Identifier: MIT
#include <irg/curve/flatten.hpp>

#include <cmath>
#include <vector>

#include "support/check_both.hpp"
#include "support/exact.hpp"

using namespace irg;

namespace {

using flat_point = point<double, 2>;
using flat_points = std::vector<flat_point>;

double from_segment(const flat_point& p, const flat_point& a, const flat_point& b) {
  const auto ab = b - a, ap = p - a;
  const double t = clamped(dot(ab, ab) > 0 ? dot(ap, ab) / dot(ab, ab) : 0.0, 0.0, 1.0);
  return std::hypot(ap.x - t * ab.x, ap.y - t * ab.y);
}

flat_point flat_at(const flat_points& c, double t) {
  flat_points scratch(c.size(), flat_point{});
  return bezier_point(c, t, scratch);
}

/// How far the curve is from the chord between two parameters, seen at 33 places.
double chord_error(const flat_points& c, double from, double to) {
  double worst = 0;
  const flat_point a = flat_at(c, from), b = flat_at(c, to);
  for (int k = 1; k < 33; ++k) worst = std::max(worst, from_segment(flat_at(c, from + (to - from) * k / 33), a, b));
  return worst;
}

/// The fewest chords, each as long as the tolerance lets it be.
int fewest(const flat_points& c, double tolerance) {
  int pieces = 0;
  for (double at = 0; at < 1; ++pieces) {
    double step = 1 - at;
    while (chord_error(c, at, at + step) > tolerance) step *= 0.97;
    at = step < 1 - at ? at + step : 1;
  }
  return pieces;
}

flattening flat(const flat_points& c, double tolerance, flat_points& line) {
  flat_points scratch(3 * c.size(), flat_point{});
  line.clear();
  return flatten(c, tolerance, scratch, [&](const flat_point& p) { line.push_back(p); });
}

}  // namespace

TEST_CASE("flatten: keeps its tolerance on random curves, with few pieces") {
  test::random r(81);
  double ours = 0, best = 0, worst = 0;
  const bool all = test::trials(1) > 1;  // the release tier's 10^5 curves
  const int count = all ? 100000 : 30;
  for (int trial = 0; trial < count; ++trial) {
    flat_points c(static_cast<std::size_t>(r.integer(2, 7)), flat_point{}), line;
    for (flat_point& p : c) p = {2 * r.unit() - 1, 2 * r.unit() - 1};
    const double tolerance = std::exp2(-4 - 6 * r.unit());
    const flattening done = flat(c, tolerance, line);
    const bool whole =
        done.within_tolerance && line.size() == done.pieces + 1 && line.front() == c.front() && line.back() == c.back();
    CHECK(whole);
    for (int k = 0; k <= 300; ++k) {
      double nearest = 1e9;
      for (std::size_t i = 1; i < line.size(); ++i)
        nearest = std::min(nearest, from_segment(flat_at(c, k / 300.0), line[i - 1], line[i]));
      worst = std::max(worst, nearest / tolerance);
    }
    if (all ? trial % 100 == 0 : trial < 12) ours += static_cast<double>(done.pieces), best += fewest(c, tolerance);
  }
  MESSAGE("error over tolerance ", worst, ", pieces over the fewest ", ours / best);
  CHECK(worst <= 1 + 1e-12);
  CHECK(ours <= 1.2 * best);
}

TEST_CASE("flatten: lines, points, coincident points, a fold, a cusp, no tolerance") {
  flat_points line;
  CHECK(flat({{7, 8}}, 0.1, line) == flattening{0, true});
  CHECK(line == flat_points{{7, 8}});
  CHECK(flat({{0, 0}, {2, 4}}, 0, line) == flattening{1, true});
  // A parabola is as far from its chord as the bound says: half of 1.
  CHECK(flat({{0, 0}, {1, 1}, {2, 0}}, 0.5, line) == flattening{1, true});
  CHECK(flat({{0, 0}, {1, 1}, {2, 0}}, 0.4999, line) == flattening{2, true});
  CHECK(flat({{1, 1}, {1, 1}, {1, 1}, {1, 1}}, 0, line).within_tolerance);
  flat({{0, 0}, {3, 0}, {-2, 0}, {1, 0}}, 0.01, line);  // leaves its chord at both ends and comes back
  double right = 0, left = 0;
  for (const flat_point& p : line) right = std::max(right, p.x), left = std::min(left, p.x);
  double reach = 0;
  for (int k = 0; k <= 100; ++k) reach = std::max(reach, flat_at({{0, 0}, {3, 0}, {-2, 0}, {1, 0}}, k / 100.0).x);
  CHECK(right >= reach - 0.01);
  CHECK(!flat({{0, 0}, {std::nan(""), 1}, {1, 1}, {2, 0}, {3, 0}}, 0.1, line).within_tolerance);
  const flat_points cusp{{0, 0}, {1, 1}, {0, 1}, {1, 0}};
  CHECK(flat(cusp, 1e-3, line).within_tolerance);
  for (const double tolerance : {0.0, 1e-300}) {
    const flattening done = flat({{0, 0}, {1e-3, 2}, {3, 1}}, tolerance, line);
    CHECK(done.pieces <= 65536);
    CHECK(!done.within_tolerance);
  }
}
