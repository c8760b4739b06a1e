// SPDX-License-Identifier: MIT
#include <irg/raster/stroke.hpp>

#include <cmath>
#include <cstdlib>
#include <limits>
#include <random>
#include <vector>

#include <irg/raster/image.hpp>

#include <doctest/doctest.h>

namespace {

using position = irg::point<double, 2>;
using path = std::vector<position>;
using irg::line_caps, irg::stroke_joins, irg::polyline_shape;

constexpr double area_of(std::span<const position> ring) {
  double twice = 0;
  for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++)
    twice += (ring[j].x - ring[0].x) * (ring[i].y - ring[0].y) - (ring[j].y - ring[0].y) * (ring[i].x - ring[0].x);
  return 0.5 * twice;
}

struct outline_facts {
  bool accepted = false, all_positive = true, all_finite = true;
  int rings = 0;
  double area = 0;
};

constexpr outline_facts facts(const path& p, const irg::stroke_style& style) {
  outline_facts f;
  f.accepted = irg::stroke_outline(p, style, [&](std::span<const position> ring) {
    const double a = area_of(ring);
    f.all_positive = f.all_positive && a > 0;
    for (const auto& v : ring) f.all_finite = f.all_finite && v.x - v.x == 0 && v.y - v.y == 0;
    f.area += a;
    ++f.rings;
  });
  return f;
}

constexpr double infinite = std::numeric_limits<double>::infinity(), none = std::numeric_limits<double>::quiet_NaN();

// A mitre at a right angle: two rectangles of 8 and the square of the corner, 1 of its 4 quarters outside both.
static_assert(facts({{0, 0}, {4, 0}, {4, 4}}, {.width = 2, .joins = stroke_joins::mitre}).area == 17);
static_assert(facts({{0, 0}, {4, 0}, {4, 4}}, {.width = 2, .joins = stroke_joins::bevel}).area == 16.5);
// The limit is that of SVG: the right angle's tip is the root of 2 widths away.
static_assert(facts({{0, 0}, {4, 0}, {4, 4}}, {2, stroke_joins::mitre, line_caps::butt, 1.4143}).area == 17);
static_assert(facts({{0, 0}, {4, 0}, {4, 4}}, {2, stroke_joins::mitre, line_caps::butt, 1.4142}).area == 16.5);
static_assert(facts({{0, 0}, {4, 0}, {4, 4}}, {2, stroke_joins::mitre, line_caps::butt, -4}).area == 16.5);
static_assert(facts({{0, 0}, {4, 0}}, {.width = 2, .caps = line_caps::square}).area == 12);
static_assert(facts({{1, 1}, {1, 1}}, {.width = 2, .caps = line_caps::square}).area == 4);
static_assert(facts({{1, 1}, {1, 1}}, {.width = 2}).rings == 0);
static_assert(facts({}, {.width = 2}).accepted && facts({{0, 0}, {4, 0}}, {.width = 0}).rings == 0);
static_assert(!facts({{0, none}}, {}).accepted && !facts({{0, 0}, {infinite, 0}}, {}).accepted);
static_assert(!facts({{0, 0}, {1, 0}}, {.width = none}).accepted);
static_assert(facts({{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0}},
                    {2, stroke_joins::mitre, line_caps::round, 4, polyline_shape::closed})
                  .area == 36);

TEST_CASE("outlines are positive and finite for points and widths of every size, repeated points and turns back") {
  std::mt19937_64 random(20261123);
  const auto number = [&](int decades) {
    const double mantissa = static_cast<double>(random() >> 11) * 0x1p-52 - 1;
    return std::ldexp(mantissa, static_cast<int>(random() % static_cast<unsigned>(2 * decades + 1)) - decades);
  };
  for (int trial = 0; trial < 3000; ++trial) {
    path p;
    for (int i = 0; i < 6; ++i) {
      const double x = number(490);
      const double y = number(490);
      p.push_back({x, y});
      if (random() % 3 == 0) p.push_back(p.back());
      if (random() % 3 == 0 && p.size() > 2) p.push_back(p[p.size() - 2]);
    }
    const irg::stroke_style style{1 + std::fabs(number(30)), static_cast<stroke_joins>(random() % 3),
                                  static_cast<line_caps>(random() % 3), 4, static_cast<polyline_shape>(random() % 2)};
    const outline_facts f = facts(p, style);
    REQUIRE(f.accepted);
    REQUIRE(f.all_finite);
  }
  for (int trial = 0; trial < 3000; ++trial) {  // orientation, where the area is not lost in rounding
    path p;
    for (int i = 0; i < 6; ++i) {
      const double x = static_cast<double>(random() % 8);
      const double y = static_cast<double>(random() % 8);
      p.push_back({x, y});
    }
    const irg::stroke_style style{1, static_cast<stroke_joins>(random() % 3), static_cast<line_caps>(random() % 3), 4,
                                  static_cast<polyline_shape>(random() % 2)};
    double least = 0;
    irg::stroke_outline(p, style, [&](std::span<const position> ring) { least = std::fmin(least, area_of(ring)); });
    REQUIRE(least > -1e-12);
  }
}

double distance_to(const path& p, double x, double y) {
  double best = infinite;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const position a = p[i], b = p[i + 1 < p.size() ? i + 1 : i];
    const double dx = b.x - a.x, dy = b.y - a.y, square = dx * dx + dy * dy;
    const double t = square > 0 ? std::fmin(1, std::fmax(0, ((x - a.x) * dx + (y - a.y) * dy) / square)) : 0;
    best = std::fmin(best, std::hypot(x - a.x - t * dx, y - a.y - t * dy));
  }
  return best;
}

TEST_CASE("with round joins and caps a pixel is covered as far as it is within half the width of the path") {
  std::mt19937_64 random(7);
  const auto unit = [&] { return static_cast<double>(random() >> 11) * 0x1p-53; };
  const int trials = std::getenv("IRG_RELEASE_TIER") ? 2000 : 12;
  constexpr int size = 40, samples = 16;
  for (int trial = 0; trial < trials; ++trial) {
    path p;
    for (int i = 0, n = 1 + static_cast<int>(random() % 6); i < n; ++i) {
      const double x = 50 * unit() - 5;
      const double y = 50 * unit() - 5;
      p.push_back({x, y});
      if (random() % 4 == 0 && p.size() > 1) p.push_back(p[p.size() - 2]);  // straight back
    }
    const double width = trial % 3 == 0 ? 1 + unit() : 12 * unit() + 0.5;
    irg::image<std::uint8_t> picture(size, size, 0);
    REQUIRE(irg::draw_stroke(picture, p, {.width = width, .caps = line_caps::round}, std::uint8_t{255}));
    for (int y = 0; y < size; ++y)
      for (int x = 0; x < size; ++x) {
        int inside = 0, deep = 0;
        for (int j = 0; j < samples; ++j)
          for (int i = 0; i < samples; ++i) {
            const double d = distance_to(p, x + (i + 0.5) / samples, y + (j + 0.5) / samples);
            inside += d <= width / 2;
            deep += d <= width / 2 - 0.1;  // the samples' distance 1/16, and 1/64
          }
        const double covered = picture(x, y) / 255.0, expected = inside / double(samples * samples);
        REQUIRE(std::fabs(covered - expected) < 0.03);
        if (deep == samples * samples) REQUIRE(picture(x, y) == 255);
        if (distance_to(p, x + 0.5, y + 0.5) > width / 2 + 0.7072 + 1.0 / 64) REQUIRE(picture(x, y) == 0);
      }
  }
}

TEST_CASE("a turn straight back has half a disc with round joins, nothing otherwise, whichever way the line runs") {
  for (const position& way : {position{4, 0}, {-4, 0}, {0, 4}, {0, -4}, {3, 1}, {-2, -3}}) {
    const path back = {{0, 0}, way, {0.5 * way.x, 0.5 * way.y}};
    const double area = 2 * 1.5 * std::hypot(way.x, way.y);
    const outline_facts round = facts(back, {.width = 2}), bevel = facts(back, {2, stroke_joins::bevel});
    CHECK(round.rings == 3);
    CHECK(std::fabs(round.area - area - 1.5707963) < 0.02);
    CHECK(bevel.rings == 2);
    CHECK(std::fabs(bevel.area - area) < 1e-13);
    CHECK(facts(back, {2, stroke_joins::mitre, line_caps::butt, 1e100}).rings == 2);
  }
}

TEST_CASE("the tip of a mitre is where the edges meet, however far away that is") {
  for (const double slope : {0.5, 0x1p-4, 0x1p-10, 0x1p-17, 0x1p-26}) {
    const path turn = {{1, -slope}, {0, 0}, {1, slope}};
    irg::stroke_outline(turn, {2, stroke_joins::mitre, line_caps::butt, 0x1p40}, [&](std::span<const position> ring) {
      if (ring.size() != 4) return;
      const double distance = std::sqrt(1 + slope * slope) / slope;  // of the tip, on the axis
      CHECK(std::fabs(ring[2].x + distance) <= distance * distance * 0x1p-51);
      CHECK(std::fabs(ring[2].y) <= distance * distance * 0x1p-51);
    });
  }
}

TEST_CASE("crossings and bends are mixed once; what cannot be snapped paints nothing") {
  irg::image<std::uint8_t> picture(20, 20, 0);
  const path back{{10, 5}, {10, 15}, {10, 5}, {10, 15}};
  CHECK(irg::draw_stroke(picture, back, {.width = 1, .joins = stroke_joins::bevel}, std::uint8_t{255}));
  CHECK(picture(9, 10) == 128);
  CHECK(picture(10, 10) == 128);
  irg::image<std::uint8_t> untouched(20, 20, 7);
  CHECK_FALSE(irg::draw_stroke(untouched, path{{0, 0}, {1e9, 1}}, {.width = 2}, std::uint8_t{255}));
  CHECK_FALSE(irg::draw_stroke(untouched, path{{0, 0}, {none, 1}}, {.width = 2}, std::uint8_t{255}));
  CHECK(irg::draw_stroke(untouched, path{{0, 0}, {9, 9}}, {.width = 0}, std::uint8_t{255}));
  CHECK(untouched == irg::image<std::uint8_t>(20, 20, 7));
}

}  // namespace
