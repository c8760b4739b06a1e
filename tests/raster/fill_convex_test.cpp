// SPDX-License-Identifier: MIT
#include <irg/raster/fill_convex.hpp>

#include <cstdlib>
#include <limits>
#include <vector>

#include <irg/colour/pixel.hpp>
#include <irg/raster/image.hpp>
#include <irg/raster/triangle_coverage.hpp>

#include "support/check_both.hpp"
#include "support/fill_oracle.hpp"

namespace {

using irg::cell_window;
using irg::span_of_cells;
using irg::subpixel;
using test::ring;
using point_d = irg::point<double, 2>;
using point_f = irg::point<float, 2>;

const bool release = std::getenv("IRG_RELEASE_TIER") != nullptr;

template <class P, std::size_t N>
constexpr int pixel_count(const P (&r)[N], cell_window w = {-100, -100, 100, 100}) {
  int n = 0;
  irg::convex_spans(r, w, [&](span_of_cells s) { n += s.x_last - s.x_first; });
  return n;
}

constexpr subpixel corner[3] = {{0, 0}, {1024, 0}, {0, 1024}};
constexpr subpixel far_corner[3] = {{1024, 0}, {1024, 1024}, {0, 1024}};
constexpr subpixel square[4] = {{0, 0}, {1024, 0}, {1024, 1024}, {0, 1024}};
constexpr point_d octagon[8] = {{3, 0}, {6, 0}, {9, 3}, {9, 6}, {6, 9}, {3, 9}, {0, 6}, {0, 3}};

TEST_CASE("convex_spans: triangles, squares and an octagon by hand") {
  CHECK_BOTH(pixel_count(corner) == 6);  // the hypotenuse is a right edge: its centres are not covered
  CHECK_BOTH(pixel_count(far_corner) == 10);  // here it is a left edge
  CHECK_BOTH(pixel_count(square) == 16);
  CHECK_BOTH(pixel_count(square, {1, 2, 3, 100}) == 4);
  CHECK_BOTH(pixel_count(octagon) == 63);
}

TEST_CASE("convex_spans: the empty ones: points, lines, rings of 0, 1 and 2 vertices, empty windows") {
  constexpr subpixel same[3] = {{128, 128}, {128, 128}, {128, 128}}, two_same[3] = {{128, 128}, {128, 128}, {900, 700}},
                     collinear[3] = {{0, 0}, {512, 512}, {1024, 1024}}, one[1] = {{128, 128}},
                     two[2] = {{0, 0}, {900, 900}}, upright[4] = {{128, 0}, {128, 500}, {128, 1000}, {128, 300}},
                     level[4] = {{0, 128}, {500, 128}, {900, 128}, {300, 128}};
  CHECK_BOTH(pixel_count(same) == 0);
  CHECK_BOTH(pixel_count(two_same) == 0);
  CHECK_BOTH(pixel_count(collinear) == 0);
  CHECK_BOTH(pixel_count(one) == 0);
  CHECK_BOTH(pixel_count(two) == 0);
  CHECK_BOTH(pixel_count(upright) == 0);
  CHECK_BOTH(pixel_count(level) == 0);
  CHECK_BOTH(pixel_count(square, {0, 0, 0, 9}) == 0);
  CHECK_BOTH(pixel_count(square, {3, 3, 1, 1}) == 0);
  CHECK_BOTH(pixel_count(square, {4, 0, 99, 99}) == 0);
  CHECK_BOTH(pixel_count(square, {-9, -9, 99, 0}) == 0);
  CHECK(irg::convex_spans(ring{}, {0, 0, 9, 9}, [](span_of_cells) { FAIL("no ring has no span"); }));
}

constexpr bool refused(point_d p) {
  const point_d r[4] = {{0, 0}, {9, 0}, p, {0, 9}};
  bool drawn = false;
  const bool ok = irg::convex_spans(r, {0, 0, 10, 10}, [&](span_of_cells) { drawn = true; });
  return !ok && !drawn;
}

TEST_CASE("convex_spans: coordinates that are no number or too far are refused, far ones are exact") {
  constexpr double inf = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();
  constexpr double limit = static_cast<double>(irg::far_limit);
  CHECK_BOTH(refused({nan, 1}));
  CHECK_BOTH(refused({1, nan}));
  CHECK_BOTH(refused({inf, 1}));
  CHECK_BOTH(refused({1, -inf}));
  CHECK_BOTH(refused({1e30, 1}));
  CHECK_BOTH(refused({1, -1e30}));
  CHECK_BOTH(refused({limit + 1, 1}));
  CHECK_BOTH(!refused({limit, limit}));
  constexpr point_f beyond[3] = {{0, 0}, {1e30f, 0}, {0, 9}};
  CHECK_BOTH(pixel_count(beyond) == 0);
  constexpr point_d half[3] = {{-limit, -limit}, {limit, -limit}, {-limit, limit}};
  CHECK_BOTH(pixel_count(half, {-8, -8, 8, 8}) == 120);  // the lower left half without its diagonal
  constexpr point_d all[4] = {{-limit, -limit}, {limit, -limit}, {limit, limit}, {-limit, limit}};
  CHECK_BOTH(pixel_count(all, {-8, -8, 8, 8}) == 256);
  constexpr int most = std::numeric_limits<int>::max(), least = std::numeric_limits<int>::min();
  constexpr subpixel whole[4] = {
      {least, least}, {most, least}, {most, most}, {least, most}};  // all of subpixel's range
  CHECK_BOTH(pixel_count(whole, {-8, -8, 8, 8}) == 256);
  CHECK_BOTH(pixel_count(all, {most - 4, least, most, least + 4}) == 16);
  constexpr int near_limit = irg::snap_limit * 256;
  constexpr subpixel near_half[3] = {{-near_limit, -near_limit}, {near_limit, -near_limit}, {-near_limit, near_limit}};
  CHECK_BOTH(pixel_count(near_half, {-8, -8, 8, 8}) == 120);
}

// All forms of a ring that must have the same pixels: every start vertex, both ways round, each vertex twice.
template <class F>
void for_each_form(const ring& r, F&& f) {
  const std::size_t n = r.size();
  for (std::size_t start = 0; start < n; ++start)
    for (const bool backwards : {false, true}) {
      ring form, doubled;
      for (std::size_t i = 0; i < n; ++i) {
        form.push_back(r[(start + (backwards ? n - i : i)) % n]);
        doubled.push_back(form.back());
        doubled.push_back(form.back());
      }
      f(form);
      f(doubled);
    }
}

std::vector<span_of_cells> spans_of(const ring& r, const cell_window& w) {
  std::vector<span_of_cells> spans;
  irg::convex_spans(r, w, [&](span_of_cells s) { spans.push_back(s); });
  return spans;
}

TEST_CASE("convex_spans: start, orientation, repeated vertices and spikes change nothing") {
  // Squares and diamonds whose sides and corners are centres.
  for (const ring& r :
       {ring{{128, 128}, {640, 128}, {640, 640}, {128, 640}}, ring{{384, 128}, {640, 384}, {384, 640}, {128, 384}},
        ring{{0, 0}, {1024, 0}, {1024, 1024}, {0, 1024}}, ring{{100, 50}, {900, 300}, {200, 1000}}}) {
    const cell_window w{-2, -2, 8, 8};
    test::canvas expected(w);
    for (const span_of_cells s : spans_of(r, w)) expected(s);
    CHECK(expected.wrong([&](int x, int y) { return test::winding_number(r, x, y) != 0; }) == 0);
    for_each_form(r, [&](const ring& form) { CHECK(spans_of(form, w) == spans_of(r, w)); });
    ring spiked = r;  // down from the lowest vertex and back: a spike that keeps the ring's two sides
    std::size_t lowest = 0;
    for (std::size_t i = 0; i < r.size(); ++i) lowest = r[i].y > r[lowest].y ? i : lowest;
    spiked.insert(spiked.begin() + static_cast<std::ptrdiff_t>(lowest) + 1,
                  {{r[lowest].x + 300, r[lowest].y + 700}, r[lowest]});
    CHECK(spans_of(spiked, w) == spans_of(r, w));
  }
  CHECK(spans_of({{128, 128}, {640, 128}, {640, 640}, {128, 640}}, {-2, -2, 8, 8}) ==
        std::vector<span_of_cells>{{0, 0, 2}, {1, 0, 2}});
}

TEST_CASE("convex_spans: a sliver of 1/256 pixel across 16k pixels") {
  const ring r{{0, 0}, {16384 * 256, 64 * 256}, {0, 1}};
  test::canvas c({0, 0, 16384, 64});
  irg::convex_spans(r, c.window, c);
  CHECK(c.painted() > 0);
  CHECK(c.wrong([&](int x, int y) { return test::winding_number(r, x, y) != 0; }) == 0);
}

TEST_CASE("convex_spans: the quad (44,27) (7,37) (7,19) (38,19)") {
  const std::vector<point_f> r{{44, 27}, {7, 37}, {7, 19}, {38, 19}};
  ring snapped;
  for (const point_f& p : r) snapped.push_back(irg::snap(p));
  test::canvas c({0, 0, 60, 50});
  CHECK(irg::convex_spans(r, c.window, c));
  CHECK(c.wrong([&](int x, int y) { return test::winding_number(snapped, x, y) != 0; }) == 0);
  long outside_the_box = 0;
  for (int y = 0; y < 50; ++y)
    for (int x = 0; x < 60; ++x) outside_the_box += c.at(x, y) && (x < 7 || x >= 44 || y < 19 || y >= 37);
  CHECK(outside_the_box == 0);
}

struct trial_counts {
  long rings = 0, covered = 0, wrong = 0;
};

trial_counts random_rings(int trials, int extent_in_pixels, std::uint64_t seed) {
  test::random random(seed);
  trial_counts t;
  const int e = extent_in_pixels;
  for (int i = 0; i < trials; ++i) {
    ring r = test::random_convex(random, test::random_int(random, 3, i % 4 == 0 ? 40 : 8), e * 128);
    if (i % 5 == 0)
      for (subpixel& v : r) v = {v.x & ~127, v.y & ~127};  // many centres on edges
    if (i % 7 == 0)
      for (subpixel& v : r) v.y = v.x / 2 + (v.y & 3);  // slivers
    if (i % 7 == 0) r.resize(3);
    test::canvas c(i % 2 == 0 ? test::random_window(random, -e, e) : cell_window{-e, -e, e, e});
    t.wrong += !irg::convex_spans(r, c.window, c);
    t.wrong += c.wrong([&](int x, int y) { return test::winding_number(r, x, y) != 0; });
    t.covered += c.painted();
    ++t.rings;
  }
  return t;
}

TEST_CASE("convex_spans: equals the rational oracle on random rings of 3 to 40 vertices and random windows") {
  const int factor = release ? 100 : 1;
  trial_counts all;
  for (const trial_counts t :
       {random_rings(4000 * factor, 8, 1), random_rings(400 * factor, 30, 2), random_rings(20 * factor, 150, 3)}) {
    all.rings += t.rings;
    all.covered += t.covered;
    all.wrong += t.wrong;
  }
  MESSAGE(all.rings, " rings, ", all.covered, " covered centres, ", all.wrong, " wrong");
  CHECK(all.covered > 5 * all.rings);
  CHECK(all.wrong == 0);
}

TEST_CASE("convex_spans: tall, wide and far rings equal the oracle in a small window") {
  test::random random(77);
  long wrong = 0, covered = 0, partly = 0;
  for (int i = 0; i < (release ? 200000 : 2000); ++i) {
    // At scales from 2^11 to 2^40 / 256 pixels, through the edge of the window.
    const std::int64_t reach = std::int64_t{1} << random.integer(11, 39);
    test::far_ring r;
    std::vector<point_d> pixels;
    const std::int64_t x = random.integer(-reach, reach), y = random.integer(-reach, reach);
    r = {{x, y},
         {-y / 2 + random.integer(-999, 999), x / 2 + random.integer(-999, 999)},
         {-x + random.integer(-1999, 1999), -y + random.integer(-1999, 1999)}};
    for (const auto& v : r) pixels.push_back({static_cast<double>(v.x) / 256, static_cast<double>(v.y) / 256});
    test::canvas c({-5, -5, 6, 6});
    wrong += !irg::convex_spans(pixels, c.window, c);
    wrong += c.wrong([&](int px, int py) { return test::winding_number(r, px, py) != 0; });
    covered += c.painted();
    partly += c.painted() > 0 && c.painted() < 121;
  }
  CHECK(wrong == 0);
  CHECK(covered > 1000);
  CHECK(partly > 500);
}

TEST_CASE("convex_spans: the walk in fixed point has the columns of walk_edge, at its limits too") {
  test::random random(78);
  constexpr int reach = irg::detail::fixed_edge_reach, height = irg::detail::fixed_edge_height;
  long wrong = 0, rows_walked = 0;
  for (int i = 0; i < (release ? 20000 : 200); ++i) {
    const auto at_end = [&](int low, int high) {  // at a limit, near it or anywhere
      const int way = test::random_int(random, 0, 5);
      return way == 0   ? low
             : way == 1 ? high
             : way == 2 ? high - test::random_int(random, 0, 300)
                        : test::random_int(random, low, high);
    };
    const int tall = i % 2 ? at_end(1, height) : test::random_int(random, 1, 2000);
    const int top = at_end(-reach, reach - tall);
    const subpixel a{at_end(-reach, reach), top}, b{at_end(-reach, reach), top + tall};
    const irg::row_range rows = irg::rows_of_edge(a, b);
    if (rows.first >= rows.last) continue;
    irg::detail::fixed_edge fixed(a, b, rows.first);
    auto exact = irg::walk_edge(a, b, rows.first);
    for (std::int64_t y = rows.first; y < rows.last; ++y, fixed.next(), exact.next()) {
      wrong += fixed.column() != exact.column;
      ++rows_walked;
    }
  }
  CHECK(rows_walked > 100000);
  CHECK(wrong == 0);
}

TEST_CASE("convex_spans: triangles have the spans of covered_spans") {
  test::random random(9);
  for (int i = 0; i < (release ? 1000000 : 20000); ++i) {
    const auto place = [&] { return test::random_int(random, -2000, 6000) & (i % 3 ? -1 : ~127); };
    const ring r{{place(), place()}, {place(), place()}, {place(), place()}};
    std::vector<span_of_cells> expected;
    irg::covered_spans(irg::cover_triangle(r[0], r[1], r[2]), {-3, -3, 20, 20},
                       [&](span_of_cells s) { expected.push_back(s); });
    REQUIRE(spans_of(r, {-3, -3, 20, 20}) == expected);
  }
}

TEST_CASE("convex_spans: floating vertices are snapped as snap() does, ties among them") {
  test::random random(10);
  for (int i = 0; i < 3000; ++i) {
    std::vector<point_d> d;
    std::vector<point_f> f;
    ring from_d, from_f;
    const int n = test::random_int(random, 3, 40);
    const ring base = test::random_convex(random, n, 2000);
    for (const subpixel& v : base) {
      const double half = 0.001953125;  // 1/512 pixel
      const point_d p{v.x / 256.0 + half * static_cast<double>(random.integer(-1, 1)),
                      v.y / 256.0 + (i % 2 ? half : random.unit() * 1e-3)};
      d.push_back(p);
      f.push_back({static_cast<float>(p.x), static_cast<float>(p.y)});
      from_d.push_back(irg::snap(d.back()));
      from_f.push_back(irg::snap(f.back()));
    }
    std::vector<span_of_cells> got_d, got_f;
    irg::convex_spans(d, {-9, -9, 20, 20}, [&](span_of_cells s) { got_d.push_back(s); });
    irg::convex_spans(f, {-9, -9, 20, 20}, [&](span_of_cells s) { got_f.push_back(s); });
    REQUIRE(got_d == spans_of(from_d, {-9, -9, 20, 20}));
    REQUIRE(got_f == spans_of(from_f, {-9, -9, 20, 20}));
  }
}

TEST_CASE("convex_spans: exactly once on every quad of the 9 x 9 half-pixel lattice cut along a diagonal") {
  constexpr int points = 9, step = 128, n = points * points;
  const auto at = [&](int i) { return subpixel{(i % points) * step, (i / points) * step}; };
  const auto mask = [](const subpixel(&t)[3]) {
    unsigned m = 0;
    irg::convex_spans(t, {0, 0, 4, 4}, [&](span_of_cells s) {
      for (int x = s.x_first; x < s.x_last; ++x) m |= 1u << (4 * s.y + x);
    });
    return m;
  };
  long long quads = 0, doubly = 0, holes = 0;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      if (i == j) continue;
      struct side {
        std::vector<unsigned> covered, wanted;
      } sides[2];
      for (int k = 0; k < n; ++k) {
        const subpixel t[3] = {at(i), at(j), at(k)};
        const std::int64_t area = irg::twice_signed_area(t[0], t[1], t[2]);
        if (area == 0) continue;
        unsigned wanted = 0;  // centres inside, or inside the diagonal
        for (int p = 0; p < 16; ++p) {
          const subpixel c{(p % 4) * 256 + 128, (p / 4) * 256 + 128};
          const std::int64_t s0 = irg::twice_signed_area(t[0], t[1], c), s1 = irg::twice_signed_area(t[1], t[2], c),
                             s2 = irg::twice_signed_area(t[2], t[0], c);
          if ((s0 >= 0 && s1 > 0 && s2 > 0) || (s0 <= 0 && s1 < 0 && s2 < 0)) wanted |= 1u << p;
        }
        side& s = sides[area > 0];
        s.covered.push_back(mask(t));
        s.wanted.push_back(wanted);
      }
      for (std::size_t a = 0; a < sides[0].covered.size(); ++a)
        for (std::size_t b = 0; b < sides[1].covered.size(); ++b) {
          ++quads;
          doubly += (sides[0].covered[a] & sides[1].covered[b]) != 0;
          holes += ((sides[0].wanted[a] | sides[1].wanted[b]) & ~(sides[0].covered[a] | sides[1].covered[b])) != 0;
        }
    }
  CHECK(quads == 7043824);
  CHECK(doubly == 0);
  CHECK(holes == 0);
}

TEST_CASE("convex_spans: fans of 3 to 12 triangles own the pixels around their hub once") {
  for (int spokes = 3; spokes <= 12; ++spokes)
    for (const subpixel hub : {subpixel{640, 640}, subpixel{512, 512}, subpixel{600, 700}}) {
      const int x[12] = {900, 800, 450, 0, -450, -800, -900, -800, -450, 0, 450, 800};
      ring rim;
      for (int s = 0; s < spokes; ++s) {
        const int k = s * 12 / spokes;
        rim.push_back({hub.x + x[k], hub.y + x[(k + 9) % 12]});
      }
      test::canvas c({-2, -2, 8, 8});
      for (std::size_t s = 0; s < rim.size(); ++s)
        irg::convex_spans(ring{hub, rim[s], rim[(s + 1) % rim.size()]}, c.window, c.again());
      CHECK(c.at(2, 2) == 1);
      CHECK(c.wrong([&](int px, int py) { return test::winding_number(rim, px, py) != 0; }) == 0);
    }
}

TEST_CASE("convex_spans: a random triangulation of a rectangle into 10,000 triangles paints each pixel once") {
  test::random random(11);
  struct triangle {
    subpixel v[3];
  };
  const subpixel a{-37, -85}, b{300 * 256 + 9, -85}, c{300 * 256 + 9, 200 * 256 + 77}, d{-37, 200 * 256 + 77};
  std::vector<triangle> all{{{a, b, c}}, {{a, c, d}}};
  while (all.size() < 10000) {  // cut a triangle into three at a point inside
    triangle& t = all[static_cast<std::size_t>(random.integer(0, static_cast<std::int64_t>(all.size()) - 1))];
    const std::int64_t u = random.integer(1, 1022), v = random.integer(1, 1023 - u), w = 1024 - u - v;
    const auto mix = [&](int p, int q, int r) { return static_cast<std::int32_t>((u * p + v * q + w * r) / 1024); };
    const subpixel p{mix(t.v[0].x, t.v[1].x, t.v[2].x), mix(t.v[0].y, t.v[1].y, t.v[2].y)};
    const triangle t0{{t.v[0], t.v[1], p}}, t1{{t.v[1], t.v[2], p}}, t2{{t.v[2], t.v[0], p}};
    const auto area = [](const triangle& s) { return irg::twice_signed_area(s.v[0], s.v[1], s.v[2]); };
    if (area(t0) <= 0 || area(t1) <= 0 || area(t2) <= 0) continue;
    t = t0;
    all.push_back(t1);
    all.push_back(t2);
  }
  test::canvas canvas({-3, -3, 304, 204});
  for (const triangle& t : all) irg::convex_spans(t.v, canvas.window, canvas.again());
  CHECK(canvas.bad_spans == 0);
  const ring outline{a, b, c, d};
  CHECK(canvas.wrong([&](int x, int y) { return test::winding_number(outline, x, y) != 0; }) == 0);
  CHECK(canvas.painted() == 300 * 200);
}

TEST_CASE("convex_spans: a vertex on a neighbour's edge leaves cracks, because snapping moves it off the edge") {
  test::random random(12);
  long junctions = 0, cracked = 0, missing = 0, doubled = 0;
  for (int i = 0; i < 10000; ++i) {
    const auto place = [&] { return test::random_int(random, 0, 100 * 256); };
    const subpixel p{place(), 0}, q{place(), 100 * 256};
    const std::int64_t t = random.integer(1, 4095);  // the middle vertex lies on pq before it is snapped
    const auto between = [&](std::int64_t u, std::int64_t v) {
      return static_cast<std::int32_t>((u * 4096 + (v - u) * t + 2048) >> 12);
    };
    const subpixel m{between(p.x, q.x), between(p.y, q.y)};
    test::canvas c({0, 0, 100, 100});
    irg::convex_spans(ring{{0, 0}, p, q, {0, 100 * 256}}, c.window, c.again());
    irg::convex_spans(ring{p, {100 * 256, 0}, m}, c.window, c.again());
    irg::convex_spans(ring{m, {100 * 256, 0}, {100 * 256, 100 * 256}}, c.window, c.again());
    irg::convex_spans(ring{m, {100 * 256, 100 * 256}, q}, c.window, c.again());
    long none = 0, twice = 0;
    for (const int n : c.count) none += n == 0, twice += n == 2;
    ++junctions;
    cracked += none > 0;
    missing += none;
    doubled += twice;
  }
  MESSAGE(junctions, " T-junctions of 100 rows: ", cracked, " with a crack, ", missing, " pixels missing, ", doubled,
          " pixels painted twice");
  CHECK(missing + doubled > 0);
  CHECK(missing < junctions);  // less than a pixel in 100 rows
  CHECK(doubled < junctions);
}

TEST_CASE("convex_spans: a polygon moved by whole pixels has its pixels moved") {
  test::random random(16);
  for (int i = 0; i < 500; ++i) {
    const ring r = test::random_convex(random, test::random_int(random, 3, 12), 3000);
    const int dx = test::random_int(random, -2000000, 2000000), dy = test::random_int(random, -2000000, 2000000);
    ring moved;
    for (const subpixel& v : r) moved.push_back({v.x + 256 * dx, v.y + 256 * dy});
    std::vector<span_of_cells> expected = spans_of(r, {-30, -30, 30, 30});
    for (span_of_cells& s : expected) s = {s.y + dy, s.x_first + dx, s.x_last + dx};
    CHECK(spans_of(moved, {-30 + dx, -30 + dy, 30 + dx, 30 + dy}) == expected);
  }
}

TEST_CASE("convex_spans: a quarter turn maps every pixel but those whose centre is on an edge") {
  test::random random(17);
  long on_edges = 0, others = 0, wrong = 0;
  for (int i = 0; i < 500; ++i) {
    ring r = test::random_convex(random, 3, 3000), turned;  // snapping keeps a triangle convex
    for (subpixel& v : r) v = {v.x & ~63, v.y & ~63};
    for (const subpixel& v : r) turned.push_back({-v.y, v.x});  // pixel (x, y) becomes (-1 - y, x)
    test::canvas before({-26, -26, 26, 26}), after({-26, -26, 26, 26});
    irg::convex_spans(r, before.window, before);
    irg::convex_spans(turned, after.window, after);
    for (int y = -26; y < 26; ++y)
      for (int x = -26; x < 26; ++x) {
        bool on_edge = false;
        const subpixel c{x * 256 + 128, y * 256 + 128};
        for (std::size_t k = 0; k < r.size(); ++k) {
          const subpixel p = r[k], q = r[(k + 1) % r.size()];
          on_edge |=
              irg::twice_signed_area(p, q, c) == 0 && (c.x - p.x) * (c.x - q.x) <= 0 && (c.y - p.y) * (c.y - q.y) <= 0;
        }
        on_edges += on_edge;
        others += !on_edge;
        wrong += !on_edge && before.at(x, y) != after.at(-1 - y, x);
      }
  }
  CHECK(on_edges > 100);
  CHECK(others > 1000);
  CHECK(wrong == 0);
}

TEST_CASE("convex_spans: rings that level lines cross more than twice stay within their box, a span a row at most") {
  test::random random(18);
  for (int i = 0; i < 20000; ++i) {
    ring r;
    const int n = test::random_int(random, 3, 60), size = i % 3 ? 3000 : 60000;
    for (int k = 0; k < n; ++k)
      r.push_back({test::random_int(random, -size, size), test::random_int(random, -size, size)});
    test::canvas c({-20, -20, 20, 20});
    REQUIRE(irg::convex_spans(r, c.window, c));
    REQUIRE(c.bad_spans == 0);
  }
  const int most = std::numeric_limits<int>::max();
  const ring wild{{most, 0}, {-most, -most}, {5, most}, {most, -most}, {-most, most}};
  test::canvas c({-20, -20, 20, 20});
  CHECK(irg::convex_spans(wild, c.window, c));
  CHECK(c.bad_spans == 0);
}

// A raster whose rows stand apart, with guards between them.
template <class P>
struct guarded {
  guarded()
      : memory(40 * 14, P(1)), view(memory.data() + 40 * 2 + 3, 20, 10, 40 * static_cast<std::ptrdiff_t>(sizeof(P))) {}
  long guards_touched() const {
    long n = 0;
    for (int i = 0; i < 40 * 14; ++i) {
      const int x = i % 40 - 3, y = i / 40 - 2;
      n += !(x >= 0 && x < 20 && y >= 0 && y < 10) && memory[static_cast<std::size_t>(i)] != P(1);
    }
    return n;
  }
  std::vector<P> memory;
  irg::image_view<P> view;
};

template <class P>
void fills_between_guards(P paint) {
  guarded<P> g;
  test::random random(19);
  for (int i = 0; i < 200; ++i) {
    const ring r = test::random_convex(random, test::random_int(random, 3, 9), 4000);
    test::canvas c({0, 0, 20, 10});
    irg::convex_spans(r, c.window, c);
    g.view = {g.memory.data() + 40 * 2 + 3, 20, 10, 40 * static_cast<std::ptrdiff_t>(sizeof(P))};
    irg::fill_span(g.view, {0, 0, 0}, paint);
    for (int y = 0; y < 10; ++y) irg::fill_span(g.view, {y, 0, 20}, P(1));
    REQUIRE(irg::fill_convex(g.view, r, paint));
    for (int y = 0; y < 10; ++y)
      for (int x = 0; x < 20; ++x) REQUIRE((g.view(x, y) == paint) == (c.at(x, y) == 1));
    REQUIRE(g.guards_touched() == 0);
  }
}

TEST_CASE("fill_convex: ids, floats, doubles, bytes; nothing outside the view is written") {
  fills_between_guards<std::uint8_t>(200);
  fills_between_guards<std::uint16_t>(60000);
  fills_between_guards<std::uint32_t>(0xdeadbeef);
  fills_between_guards<float>(2.5f);
  fills_between_guards<double>(-1.25);
}

TEST_CASE("fill_convex: a blend function is called once for each pixel, and sees what is there") {
  irg::image<int> image(12, 12, 5);
  int calls = 0;
  CHECK(irg::fill_convex(image, octagon, [&](int there) {
    ++calls;
    return there + 1;
  }));
  CHECK(calls == 63);
  int sum = 0;
  for (int y = 0; y < 12; ++y)
    for (int x = 0; x < 12; ++x) sum += image(x, y);
  CHECK(sum == 12 * 12 * 5 + 63);
}

constexpr int sum_of_filled() {
  irg::image<irg::rgba8> image(9, 9, {0, 0, 0, 0});
  irg::fill_convex(irg::within(image, {0, 0, 9, 5}), octagon, {3, 1, 4, 1});
  irg::fill_triangle(image, subpixel{0, 0}, subpixel{512, 0}, subpixel{0, 512}, {100, 0, 0, 0});
  int n = 0;
  for (int y = 0; y < 9; ++y)
    for (int x = 0; x < 9; ++x) n += image(x, y).r;
  return n;
}

TEST_CASE("fill_convex, fill_triangle: in constant evaluation as at run time") {
  CHECK_BOTH(sum_of_filled() == 3 * 36 + 100);
  irg::image<int> image(9, 9, 0);
  CHECK(
      !irg::fill_triangle(image, point_f{0, 0}, point_f{9, std::numeric_limits<float>::quiet_NaN()}, point_f{0, 9}, 1));
  CHECK(image == irg::image<int>(9, 9, 0));
  CHECK(irg::fill_triangle(irg::within(image, {0, 0, 1, 9}), point_d{0, 0}, point_d{9, 0}, point_d{0, 9}, 1));
  CHECK(image(0, 0) == 1);
  CHECK(image(1, 0) == 0);
}

TEST_CASE("fill_convex: rasters of no size, one pixel, and a window beyond the raster") {
  irg::image<int> none(0, 0), flat(7, 0), pixel(1, 1, 0);
  CHECK(irg::fill_convex(none, square, 1));
  CHECK(irg::fill_convex(flat, square, 1));
  CHECK(irg::fill_convex(irg::within(pixel, {-1000, -1000, 1000, 1000}), square, 1));
  CHECK(pixel(0, 0) == 1);
}

constexpr std::uint64_t hash_of_rings(int rings) {
  test::random random(31, test::in_every_round{});
  std::uint64_t h = 1;
  for (int i = 0; i < rings; ++i) {
    const auto place = [&] { return static_cast<std::int32_t>(random.integer(-400, 1400)); };
    const subpixel r[4] = {{place(), -300}, {1200 + place(), place()}, {place(), 1500}, {-1200 + place(), place()}};
    irg::convex_spans(r, {-2, -2, 7, 6}, [&](span_of_cells s) {
      h = (h ^ static_cast<std::uint64_t>(1000 * s.y + 30 * s.x_first + s.x_last)) * 0x100000001b3u;
    });
  }
  return h;
}

TEST_CASE("convex_spans: random rings in constant evaluation as at run time") {
  constexpr std::uint64_t constant = hash_of_rings(30);
  CHECK(hash_of_rings(30) == constant);
}

TEST_CASE("fill_triangle: corners in braces are in pixels") {
  irg::image<int> image(5, 5, 0);
  irg::fill_triangle(image, {0, 0}, {0, 4}, {4, 0}, 3);
  CHECK(image(0, 0) == 3);
  CHECK(image(4, 4) == 0);
}

}  // namespace
