// SPDX-License-Identifier: MIT
#include <irg/raster/textbook/fill_convex.hpp>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <limits>
#include <vector>

#include <irg/colour/pixel.hpp>
#include <irg/raster/image.hpp>

#include "support/check_both.hpp"
#include "support/random.hpp"
#include "support/rational.hpp"

namespace {

using irg::cell;
using irg::subpixel;
using test::rational;
constexpr int least = std::numeric_limits<int>::min(), most = std::numeric_limits<int>::max();
constexpr irg::cell_window everything{least, least, most, most};
constexpr std::array rules{irg::textbook::sample_rule::course, irg::textbook::sample_rule::closed,
                           irg::textbook::sample_rule::rounded, irg::textbook::sample_rule::half_open};

constexpr std::array<cell, 4> course{cell{50, 200}, cell{150, 350}, cell{300, 150}, cell{100, 50}};

template <class Ring>
constexpr std::vector<irg::span_of_cells> spans(const Ring& ring, irg::textbook::sample_rule rule,
                                                const irg::cell_window& w = everything) {
  std::vector<irg::span_of_cells> out;
  irg::textbook::convex_spans(ring, rule, w, [&](irg::span_of_cells s) { out.push_back(s); });
  return out;
}

struct totals {
  long long count = 0, x = 0, y = 0;
};
template <class Ring>
constexpr totals totals_of(const Ring& ring, irg::textbook::sample_rule rule, const irg::cell_window& w = everything) {
  totals t;
  irg::textbook::convex_spans(ring, rule, w, [&](irg::span_of_cells s) {
    const long long n = static_cast<long long>(s.x_last) - s.x_first;
    t.count += n;
    t.x += n * (static_cast<long long>(s.x_first) + s.x_last - 1) / 2;
    t.y += n * s.y;
  });
  return t;
}
template <class Ring>
constexpr long long count(const Ring& ring, irg::textbook::sample_rule rule) {
  return totals_of(ring, rule).count;
}

TEST_CASE("textbook::fill_convex: the course's polygon by the four rules, either way round") {
  auto reversed = course;
  std::reverse(reversed.begin(), reversed.end());
  for (const auto& ring : {course, reversed}) {
    const totals t = totals_of(ring, irg::textbook::sample_rule::course);
    CHECK(t.count == 38874);
    CHECK(t.x == 6186600);
    CHECK(t.y == 7312675);
    CHECK(count(ring, irg::textbook::sample_rule::closed) == 38876);
    CHECK(count(ring, irg::textbook::sample_rule::rounded) == 39074);
    CHECK(count(ring, irg::textbook::sample_rule::half_open) == 38725);
    CHECK(spans(ring, irg::textbook::sample_rule::course).size() == 299);
    CHECK(spans(ring, irg::textbook::sample_rule::closed).size() == 301);
  }
  std::array<subpixel, 4> fine;
  for (std::size_t i = 0; i < 4; ++i) fine[i] = {course[i].x * 256, course[i].y * 256};
  for (const irg::textbook::sample_rule rule : rules) CHECK(spans(fine, rule) == spans(course, rule));
}

TEST_CASE("textbook::fill_convex: the course's values, rows by hand") {
  constexpr auto row = [](int y, irg::textbook::sample_rule rule) {
    const auto s = spans(course, rule, {least, y, most, y + 1});
    return s.empty() ? irg::span_of_cells{y, 0, 0} : s[0];
  };
  using S = irg::span_of_cells;
  CHECK_BOTH(row(50, irg::textbook::sample_rule::course) == S{50, 0, 0});
  CHECK_BOTH(row(50, irg::textbook::sample_rule::closed) == S{50, 100, 101});
  CHECK_BOTH(row(51, irg::textbook::sample_rule::course) == S{51, 100, 103});     // 299/3 to 102
  CHECK_BOTH(row(51, irg::textbook::sample_rule::half_open) == S{51, 100, 102});
  CHECK_BOTH(row(100, irg::textbook::sample_rule::rounded) == S{100, 83, 201});   // 250/3 to 200
  CHECK_BOTH(row(150, irg::textbook::sample_rule::course) == S{150, 67, 301});    // 200/3 to 300
  CHECK_BOTH(row(151, irg::textbook::sample_rule::course) == S{151, 67, 300});    // 199/3 to 1197/4
  CHECK_BOTH(row(200, irg::textbook::sample_rule::rounded) == S{200, 50, 264});   // 50 to 525/2: halves up
  CHECK_BOTH(row(349, irg::textbook::sample_rule::course) == S{349, 150, 151});   // 448/3 to 603/4
  CHECK_BOTH(row(349, irg::textbook::sample_rule::rounded) == S{349, 149, 152});
  CHECK_BOTH(row(349, irg::textbook::sample_rule::half_open) == S{349, 150, 151});
  CHECK_BOTH(row(350, irg::textbook::sample_rule::closed) == S{350, 150, 151});
  CHECK_BOTH(row(350, irg::textbook::sample_rule::half_open) == S{350, 0, 0});
  CHECK_BOTH(row(351, irg::textbook::sample_rule::closed) == S{351, 0, 0});
}

TEST_CASE("textbook::fill_convex: the course's square with level edges") {
  constexpr std::array<cell, 4> square{cell{2, 1}, cell{2, 5}, cell{7, 5}, cell{7, 1}};
  CHECK_BOTH(count(square, irg::textbook::sample_rule::course) == 30);
  CHECK_BOTH(count(square, irg::textbook::sample_rule::closed) == 30);
  CHECK_BOTH(count(square, irg::textbook::sample_rule::rounded) == 30);
  CHECK_BOTH(count(square, irg::textbook::sample_rule::half_open) == 20);
}

TEST_CASE("textbook::fill_convex: rings without area, and hardly any vertices") {
  using V = std::vector<cell>;
  for (const irg::textbook::sample_rule rule : rules) CHECK(count(V{}, rule) == 0);
  CHECK_BOTH(count(V{{3, 4}}, irg::textbook::sample_rule::closed) == 1);
  CHECK_BOTH(count(V{{3, 4}}, irg::textbook::sample_rule::course) == 0);
  CHECK_BOTH(count(V{{3, 4}, {3, 4}, {3, 4}}, irg::textbook::sample_rule::half_open) == 0);
  CHECK_BOTH(count(V{{0, 0}, {2, 4}}, irg::textbook::sample_rule::closed) == 3);
  CHECK_BOTH(count(V{{2, 4}, {0, 0}, {1, 2}}, irg::textbook::sample_rule::closed) == 3);
  CHECK_BOTH(count(V{{0, 0}, {2, 4}}, irg::textbook::sample_rule::course) == 0);
  CHECK_BOTH(count(V{{0, 0}, {2, 4}}, irg::textbook::sample_rule::rounded) == 0);
  CHECK_BOTH(count(V{{0, 0}, {2, 4}}, irg::textbook::sample_rule::half_open) == 0);
  CHECK_BOTH(count(V{{0, 7}, {5, 7}, {2, 7}}, irg::textbook::sample_rule::course) ==
             6);  // a level segment: no edge narrows the row
  CHECK_BOTH(count(V{{0, 7}, {5, 7}, {2, 7}}, irg::textbook::sample_rule::closed) == 6);
  CHECK_BOTH(count(V{{0, 7}, {5, 7}, {2, 7}}, irg::textbook::sample_rule::half_open) == 0);
  // repeated vertices change nothing
  for (const irg::textbook::sample_rule rule : rules) {
    const V twice{course[0], course[0], course[1], course[2], course[2], course[2], course[3], course[0]};
    CHECK(spans(twice, rule) == spans(course, rule));
  }
}

TEST_CASE("textbook::fill_convex: vertices at the ends of int, through a small window") {
  constexpr std::array<cell, 4> all{cell{least, least}, cell{most, least}, cell{most, most}, cell{least, most}};
  CHECK_BOTH(totals_of(all, irg::textbook::sample_rule::course, {-4, -4, 4, 4}).count == 64);
  CHECK_BOTH(totals_of(all, irg::textbook::sample_rule::rounded, {most - 4, most - 4, most, most}).count == 16);
  CHECK_BOTH(totals_of(all, irg::textbook::sample_rule::half_open, {least, least, least + 4, least + 4}).count == 16);
  constexpr std::array<cell, 3> half{cell{least, least}, cell{most, most}, cell{least, most}};
  CHECK_BOTH(totals_of(half, irg::textbook::sample_rule::closed, {0, 0, 8, 8}).count == 36);
  CHECK_BOTH(totals_of(half, irg::textbook::sample_rule::half_open, {0, 0, 8, 8}).count == 28);
  constexpr std::array<subpixel, 3> fine{subpixel{least, least}, subpixel{most, most}, subpixel{least, most}};
  CHECK_BOTH(totals_of(fine, irg::textbook::sample_rule::closed, {0, 0, 8, 8}).count == 36);
  CHECK_BOTH(totals_of(half, irg::textbook::sample_rule::closed, {0, 0, 0, 8}).count == 0);
  CHECK_BOTH(totals_of(half, irg::textbook::sample_rule::closed, {5, 5, 1, 1}).count == 0);
}

// ---- an oracle that knows no left and right edges: the slice of the closed polygon at a row, from its segments

struct slice {
  bool empty = true;
  rational low, high;
};
template <class V>
slice slice_at(const std::vector<V>& ring, int y, int unit) {
  slice s;
  const auto add = [&](const rational& x) {
    if (s.empty || x < s.low) s.low = x;
    if (s.empty || s.high < x) s.high = x;
    s.empty = false;
  };
  const std::int64_t row = std::int64_t{y} * 256;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const V p = ring[i], q = ring[(i + 1) % ring.size()];
    const std::int64_t px = std::int64_t{p.x} * unit, py = std::int64_t{p.y} * unit, qx = std::int64_t{q.x} * unit,
                       qy = std::int64_t{q.y} * unit;
    if (py == row) add(rational(px, 256));
    const std::int64_t rise = qy < py ? py - qy : qy - py, run = qy < py ? px - qx : qx - px;
    if ((py < row && row < qy) || (qy < row && row < py))
      add(rational(px, 256) + rational((row - py) * run, 256 * rise));
  }
  return s;
}

// Whether x is drawn, from the definition of the rule.
bool oracle_has(const slice& s, bool top_row, irg::textbook::sample_rule rule, int x) {
  if (s.empty) return false;
  switch (rule) {
    case irg::textbook::sample_rule::course: return s.low < s.high && !(rational(x) < s.low) && !(s.high < rational(x));
    case irg::textbook::sample_rule::closed: return !(rational(x) < s.low) && !(s.high < rational(x));
    case irg::textbook::sample_rule::
        rounded:  // x is the nearest integer to some point of the slice that is not its end: low - 1/2 < x
      // or equal to it, x <= high + 1/2
      return s.low < s.high && s.low < rational(2 * x + 1, 2) && !(s.high < rational(2 * x - 1, 2));
    default: return !top_row && !(rational(x) < s.low) && rational(x) < s.high;
  }
}

template <class V>
std::vector<V> convex_hull(std::vector<V> points) {
  std::sort(points.begin(), points.end(),
            [](const V& a, const V& b) { return a.x < b.x || (a.x == b.x && a.y < b.y); });
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 3) return points;
  std::vector<V> hull;
  for (int pass = 0; pass < 2; ++pass) {
    const std::size_t base = hull.size();
    for (const V& p : points) {
      const auto turns = [&] {
        const V a = hull[hull.size() - 2], b = hull.back();
        return std::int64_t{b.x - a.x} * (p.y - a.y) - std::int64_t{b.y - a.y} * (p.x - a.x) > 0;
      };
      while (hull.size() >= base + 2 && !turns()) hull.pop_back();
      hull.push_back(p);
    }
    hull.pop_back();
    std::reverse(points.begin(), points.end());
  }
  return hull;
}

template <class V>
void compare_with_slices(int trials, int extent, int unit, std::uint64_t seed) {
  test::random random(seed);
  long long drawn = 0;
  for (int t = 0; t < trials; ++t) {
    std::vector<V> points(static_cast<std::size_t>(random.integer(1, 9)), V{});
    for (V& p : points) {
      p.x = static_cast<int>(random.integer(-extent, extent));
      p.y = static_cast<int>(random.integer(-extent, extent));
    }
    auto ring = convex_hull(points);
    std::rotate(ring.begin(), ring.begin() + static_cast<std::ptrdiff_t>(random.next() % ring.size()), ring.end());
    if (random.next() % 2) std::reverse(ring.begin(), ring.end());
    int y_max = ring[0].y;
    for (const V& v : ring) y_max = v.y > y_max ? v.y : y_max;
    const int reach = extent * unit / 256 + 2;
    for (const irg::textbook::sample_rule rule : rules) {
      std::vector<irg::span_of_cells> expected;
      for (int y = -reach; y < reach; ++y) {
        const slice s = slice_at(ring, y, unit);
        irg::span_of_cells span{y, 0, 0};
        const bool top_row = std::int64_t{y} * 256 == std::int64_t{y_max} * unit;
        for (int x = -reach; x < reach; ++x)
          if (oracle_has(s, top_row, rule, x)) {
            if (span.x_last == span.x_first) span.x_first = x;
            span.x_last = x + 1;
            ++drawn;
          }
        if (span.x_first < span.x_last) expected.push_back(span);
      }
      REQUIRE(spans(ring, rule) == expected);
      const irg::cell_window w{-2, -1, 3, 4};
      std::vector<irg::span_of_cells> cut;
      for (irg::span_of_cells s : expected) {
        s.x_first = s.x_first < w.x_first ? w.x_first : s.x_first;
        s.x_last = s.x_last > w.x_last ? w.x_last : s.x_last;
        if (s.y >= w.y_first && s.y < w.y_last && s.x_first < s.x_last) cut.push_back(s);
      }
      REQUIRE(spans(ring, rule, w) == cut);
    }
  }
  MESSAGE(trials, " polygons, ", drawn, " cells drawn by the oracle");
  CHECK(drawn > trials);
}

TEST_CASE("textbook::fill_convex: equals the slices of random convex polygons, by all rules, whole and clipped") {
  const int trials = std::getenv("IRG_RELEASE_TIER") ? 20000 : 400;
  compare_with_slices<cell>(trials, 9, 256, 34);
  compare_with_slices<subpixel>(trials, 9 * 256, 1, 35);
  compare_with_slices<subpixel>(trials, 300, 1, 36);
}

TEST_CASE("textbook::fill_convex: half_open tiles a fan of triangles exactly once") {
  test::random random(37);
  for (int t = 0; t < 200; ++t) {
    // A square, cut into triangles about a point of it; some of the corners are cells.
    const int side = static_cast<int>(random.integer(2, 12));
    const auto edge_point = [&] { return static_cast<int>(random.integer(0, side * 256)); };
    const std::vector<subpixel> rim{{0, 0},
                                    {edge_point(), 0},
                                    {side * 256, 0},
                                    {side * 256, edge_point()},
                                    {side * 256, side * 256},
                                    {edge_point(), side * 256},
                                    {0, side * 256},
                                    {0, edge_point()}};
    auto around = rim;  // in order round the square
    const int grid = random.next() % 2 ? 256 : 1;
    const subpixel hub{edge_point() / grid * grid, edge_point() / grid * grid};
    std::vector<int> owners(static_cast<std::size_t>((side + 2) * (side + 2)), 0);
    for (std::size_t i = 0; i < around.size(); ++i) {
      const std::array<subpixel, 3> triangle{hub, around[i], around[(i + 1) % around.size()]};
      irg::textbook::convex_spans(triangle, irg::textbook::sample_rule::half_open, everything,
                                  [&](irg::span_of_cells s) {
                                    for (int x = s.x_first; x < s.x_last; ++x)
                                      ++owners[static_cast<std::size_t>((s.y + 1) * (side + 2) + x + 1)];
                                  });
    }
    for (int y = -1; y <= side; ++y)
      for (int x = -1; x <= side; ++x)
        REQUIRE(owners[static_cast<std::size_t>((y + 1) * (side + 2) + x + 1)] ==
                (x >= 0 && y >= 0 && x < side && y < side));
  }
}

TEST_CASE("textbook::fill_convex: paints rasters of any pixel type, keeps the gaps between rows, clips") {
  std::vector<int> memory(20 * 12, -1);
  irg::image_view<int> view(memory.data() + 4, 12, 10, 20 * static_cast<std::ptrdiff_t>(sizeof(int)));
  const std::array<cell, 4> large{cell{-40, 5}, cell{6, 60}, cell{60, 5}, cell{6, -60}};
  irg::textbook::fill_convex(view, large, irg::textbook::sample_rule::course, 7);
  irg::textbook::fill_convex(irg::within(view, {2, 3, 40, 5}), large, irg::textbook::sample_rule::course,
                             [](int there) { return there + 1; });
  for (int i = 0; i < 20 * 12; ++i) {
    const int x = i % 20 - 4, y = i / 20;
    const bool in = x >= 0 && x < 12 && y < 10, twice = in && x >= 2 && y >= 3 && y < 5;
    CHECK(memory[static_cast<std::size_t>(i)] == (twice ? 8 : in ? 7 : -1));
  }
  irg::image<irg::rgba8> picture(9, 9);
  irg::textbook::fill_convex(picture, std::array{cell{1, 1}, cell{1, 4}, cell{5, 4}},
                             irg::textbook::sample_rule::closed, {255, 0, 0, 255});
  CHECK(picture(1, 1) == irg::rgba8{255, 0, 0, 255});
  CHECK(picture(5, 4) == irg::rgba8{255, 0, 0, 255});
  CHECK(picture(5, 1) == irg::rgba8{});
  irg::image<float> none(0, 0);
  irg::textbook::fill_convex(none, large, irg::textbook::sample_rule::closed, 1.0f);
  CHECK_BOTH([] {
    irg::image<char> small(8, 8, '.');
    irg::textbook::fill_convex(small, std::array{cell{2, 1}, cell{2, 5}, cell{7, 5}, cell{7, 1}},
                               irg::textbook::sample_rule::half_open, '#');
    return small(2, 1) == '#' && small(6, 4) == '#' && small(7, 4) == '.' && small(6, 5) == '.';
  }());
}

}  // namespace
