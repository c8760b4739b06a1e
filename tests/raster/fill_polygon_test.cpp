// SPDX-License-Identifier: MIT
#include <irg/raster/fill_polygon.hpp>

#include <array>
#include <chrono>
#include <cstdlib>
#include <limits>
#include <vector>

#include <irg/colour/pixel.hpp>
#include <irg/raster/fill_convex.hpp>
#include <irg/raster/image.hpp>
#include <irg/raster/triangle_coverage.hpp>

#include "support/check_both.hpp"
#include "support/fill_oracle.hpp"

namespace {

using irg::cell_window;
using irg::fill_rule;
using irg::span_of_cells;
using irg::subpixel;
using test::ring;
using rings = std::vector<ring>;
using point_d = irg::point<double, 2>;

const bool release = std::getenv("IRG_RELEASE_TIER") != nullptr;

template <class P>
constexpr int pixel_count(const P& polygon, fill_rule rule, cell_window w = {-100, -100, 100, 100}) {
  int n = 0;
  irg::polygon_spans(polygon, rule, w, [&](span_of_cells s) { n += s.x_last - s.x_first; });
  return n;
}

using quad = std::array<subpixel, 4>;
constexpr quad outer{{{0, 0}, {2048, 0}, {2048, 2048}, {0, 2048}}},
    inner{{{512, 512}, {1536, 512}, {1536, 1536}, {512, 1536}}},
    inner_other_way{{{512, 512}, {512, 1536}, {1536, 1536}, {1536, 512}}};
constexpr std::array<quad, 2> same_way{outer, inner}, other_way{outer, inner_other_way};

TEST_CASE("polygon_spans: a hole under both rules") {
  CHECK_BOTH(pixel_count(same_way, fill_rule::even_odd) == 64 - 16);
  CHECK_BOTH(pixel_count(same_way, fill_rule::non_zero) == 64);
  CHECK_BOTH(pixel_count(other_way, fill_rule::even_odd) == 64 - 16);
  CHECK_BOTH(pixel_count(other_way, fill_rule::non_zero) == 64 - 16);
  CHECK_BOTH(pixel_count(outer, fill_rule::even_odd) == 64);
  CHECK_BOTH(pixel_count(other_way, fill_rule::even_odd, {1, 1, 4, 4}) == 9 - 4);
  CHECK_BOTH(pixel_count(other_way, fill_rule::even_odd, {3, 3, 4, 4}) == 0);
}

constexpr quad bow_tie{{{0, 0}, {2048, 2048}, {2048, 0}, {0, 2048}}};
constexpr std::array<point_d, 5> pentagram{{{10, 0}, {16, 18}, {0, 7}, {20, 7}, {4, 18}}};

TEST_CASE("polygon_spans: bow-ties have two lobes under both rules; a pentagram's core winds twice") {
  CHECK_BOTH(pixel_count(bow_tie, fill_rule::even_odd) == pixel_count(bow_tie, fill_rule::non_zero));
  CHECK_BOTH(pixel_count(bow_tie, fill_rule::even_odd, {0, 0, 8, 1}) ==
             1);  // left of (0,0)-(8,8) at y = 1/2, and its mirror without its right edge
  CHECK_BOTH(pixel_count(pentagram, fill_rule::non_zero) > pixel_count(pentagram, fill_rule::even_odd) + 30);
  CHECK_BOTH(pixel_count(pentagram, fill_rule::non_zero, {9, 9, 11, 11}) == 4);
  CHECK_BOTH(pixel_count(pentagram, fill_rule::even_odd, {9, 9, 11, 11}) == 0);
}

TEST_CASE("polygon_spans: what has no inside: 0, 1 and 2 vertices, collinear ones, no ring, empty windows") {
  constexpr fill_rule rule = fill_rule::non_zero;
  constexpr std::array<subpixel, 2> two{{{0, 0}, {900, 900}}};
  constexpr std::array<subpixel, 5> collinear{{{0, 0}, {900, 900}, {300, 300}, {1200, 1200}, {600, 600}}};
  constexpr std::array<subpixel, 0> none{};
  constexpr std::array<quad, 0> no_ring{};
  CHECK_BOTH(pixel_count(none, rule) == 0);
  CHECK_BOTH(pixel_count(two, rule) == 0);
  CHECK_BOTH(pixel_count(collinear, rule) == 0);
  CHECK_BOTH(pixel_count(no_ring, rule) == 0);
  CHECK_BOTH(pixel_count(same_way, rule, {0, 0, 0, 5}) == 0);
  CHECK_BOTH(pixel_count(same_way, rule, {5, 5, 2, 2}) == 0);
  CHECK_BOTH(pixel_count(same_way, rule, {8, 0, 99, 99}) == 0);
  CHECK_BOTH(pixel_count(same_way, rule, {-9, 8, 99, 99}) == 0);
}

long wrong_pixels(const rings& polygon, fill_rule rule, const cell_window& w, irg::fill_workspace& workspace) {
  test::canvas c(w);
  const bool ok = irg::polygon_spans(polygon, rule, w, c, workspace);
  return !ok + c.wrong([&](int x, int y) { return test::oracle_inside(polygon, rule, x, y); });
}

TEST_CASE("polygon_spans: spikes, rings that touch themselves, holes on the outer ring, collinear runs") {
  const std::vector<rings> shapes{
      {{{0, 0}, {2048, 0}, {2048, 2048}, {4000, 2048}, {2048, 2048}, {0, 2048}}},  // a level spike
      {{{0, 0}, {2048, 0}, {2048, 1024}, {4000, 1300}, {2048, 1024}, {2048, 2048}, {0, 2048}}},  // a sloped one
      {{{0, 0}, {1024, 1024}, {2048, 0}, {2048, 2048}, {1024, 1024}, {0, 2048}}},  // touches itself in a vertex
      {{{0, 0}, {2048, 0}, {2048, 2048}, {0, 2048}},
       {{0, 512}, {1024, 512}, {1024, 1024}, {0, 1024}}},  // a hole on an edge
      {{{0, 0}, {2048, 0}, {2048, 2048}, {0, 2048}}, {{0, 0}, {1024, 300}, {300, 1024}}},  // a hole on a vertex
      {{{0, 0}, {512, 0}, {1024, 0}, {2048, 0}, {2048, 700}, {2048, 2048}, {1024, 1024}, {512, 1536}, {0, 2048}}},
      {{{128, 128}, {1152, 128}, {1152, 640}, {640, 640}, {640, 1152}, {128, 1152}}},  // an L on centres
      {{{128, 128}, {129, 1000}, {130, 128}, {131, 1000}, {132, 128}, {133, 2000}, {127, 2000}}},  // ears of 1/256
      {{{0, 0}, {2048, 0}, {2048, 2048}, {0, 2048}}, {{0, 0}, {2048, 0}, {2048, 2048}, {0, 2048}}},  // twice the same
  };
  irg::fill_workspace workspace;
  for (const rings& s : shapes)
    for (const fill_rule rule : {fill_rule::even_odd, fill_rule::non_zero}) {
      CHECK(wrong_pixels(s, rule, {-2, -2, 18, 10}, workspace) == 0);
      for (std::size_t start = 0; start < s[0].size(); ++start) {
        rings turned = s, backwards = s;
        for (std::size_t i = 0; i < s[0].size(); ++i) {
          turned[0][i] = s[0][(start + i) % s[0].size()];
          backwards[0][s[0].size() - 1 - i] = turned[0][i];
        }
        CHECK(wrong_pixels(turned, rule, {-2, -2, 18, 10}, workspace) == 0);
        CHECK(wrong_pixels(backwards, rule, {1, -2, 7, 5}, workspace) == 0);
      }
    }
}

ring random_ring(test::random& random, int n, int size, int grid) {
  ring r;
  for (int i = 0; i < n; ++i) {
    const int x = test::random_int(random, -size, size), y = test::random_int(random, -size, size);
    r.push_back({x - x % grid, y - y % grid});
  }
  return r;
}

TEST_CASE("polygon_spans: equals the rational oracle on random rings that cross themselves and each other") {
  test::random random(20261122);
  irg::fill_workspace workspace;
  long wrong = 0, polygons = 0;
  for (int i = 0; i < (release ? 300000 : 3000); ++i, ++polygons) {
    rings polygon;
    const int count = test::random_int(random, 1, 4);
    for (int k = 0; k < count; ++k)
      polygon.push_back(random_ring(random, test::random_int(random, 0, 12), 3000, i % 2 ? 1 : 128));
    const cell_window w = i % 3 ? test::random_window(random, -14, 14) : cell_window{-14, -14, 14, 14};
    wrong += wrong_pixels(polygon, i % 5 < 3 ? fill_rule::even_odd : fill_rule::non_zero, w, workspace);
  }
  for (int i = 0; i < 20; ++i, ++polygons)  // so many crossings that edges are counted by column
    wrong += wrong_pixels({random_ring(random, 300, 3000, 1)}, i % 2 ? fill_rule::even_odd : fill_rule::non_zero,
                          {-14, -14, 14, 14}, workspace);
  MESSAGE(polygons, " polygons, ", wrong, " wrong");
  CHECK(wrong == 0);
}

TEST_CASE("polygon_spans: many crossings in a wide window are sorted, and equal the oracle") {
  test::random random(21);
  const rings polygon{random_ring(random, 90, 256 * 3000, 1)};
  irg::fill_workspace workspace;
  for (const fill_rule rule : {fill_rule::even_odd, fill_rule::non_zero})
    CHECK(wrong_pixels(polygon, rule, {-3000, 17, 3000, 27}, workspace) == 0);
  // Edges that meet in one point and reverse their order in the row below it.
  rings fan;
  for (int i = 0; i < 40; ++i) {
    const int x = 256 * 80 * (i - 20);
    fan.push_back({{x, -20 * 256}, {x + 300, -20 * 256}, {-x + 200, 21 * 256}});
  }
  for (const fill_rule rule : {fill_rule::even_odd, fill_rule::non_zero})
    CHECK(wrong_pixels(fan, rule, {-2000, -21, 2000, 22}, workspace) == 0);
}

TEST_CASE("polygon_spans: far vertices, exact to 2^31 pixels") {
  test::random random(22);
  long wrong = 0, partly = 0;
  for (int i = 0; i < (release ? 100000 : 1000); ++i) {
    const std::int64_t reach = std::int64_t{1} << random.integer(20, 39);
    std::vector<test::far_ring> polygon(1);
    std::vector<std::vector<point_d>> pixels(1);
    for (int k = 0; k < 3; ++k) {  // pairs of vertices on either side of the window
      const std::int64_t x = random.integer(-reach, reach), y = random.integer(-reach, reach);
      polygon[0].push_back({x, y});
      polygon[0].push_back({-x + random.integer(-1500, 1500), -y + random.integer(-1500, 1500)});
    }
    for (auto& v : polygon[0]) {
      v.x = irg::clamped(v.x, -irg::far_limit * 256, irg::far_limit * 256);
      v.y = irg::clamped(v.y, -irg::far_limit * 256, irg::far_limit * 256);
      pixels[0].push_back({static_cast<double>(v.x) / 256, static_cast<double>(v.y) / 256});
    }
    const fill_rule rule = i % 2 ? fill_rule::even_odd : fill_rule::non_zero;
    test::canvas c({-5, -5, 6, 6});
    wrong += !irg::polygon_spans(pixels, rule, c.window, c);
    wrong += c.wrong([&](int x, int y) { return test::oracle_inside(polygon, rule, x, y); });
    partly += c.painted() > 0 && c.painted() < 121;
  }
  CHECK(wrong == 0);
  CHECK(partly > 500);
}

constexpr bool refused(double x, double y) {
  const std::array<point_d, 5> r{{{0, 0}, {9, 9}, {x, y}, {9, 0}, {0, 9}}};
  bool drawn = false;
  const bool ok = irg::polygon_spans(r, fill_rule::even_odd, {0, 0, 9, 9}, [&](span_of_cells) { drawn = true; });
  return !ok && !drawn;
}

TEST_CASE("polygon_spans: NaN, infinite and too far vertices are refused") {
  constexpr double inf = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();
  CHECK_BOTH(refused(nan, 0));
  CHECK_BOTH(refused(0, nan));
  CHECK_BOTH(refused(inf, 0));
  CHECK_BOTH(refused(0, -inf));
  CHECK_BOTH(refused(1e30, 0));
  CHECK_BOTH(refused(0, -2147483648.5));
  CHECK_BOTH(!refused(-2147483648.0, 2147483648.0));
  irg::image<int> image(9, 9, 0);
  const std::vector<std::vector<irg::point<float, 2>>> one_bad{{{0, 0}, {9, 0}, {9, 9}}, {{0, 0}, {-1e30f, 1}, {5, 5}}};
  CHECK(!irg::fill_polygon(image, one_bad, fill_rule::non_zero, 1));
  CHECK(image == irg::image<int>(9, 9, 0));
}

TEST_CASE("polygon_spans: a convex ring has the spans of convex_spans") {
  test::random random(23);
  for (int i = 0; i < 2000; ++i) {
    const ring r = test::random_convex(random, test::random_int(random, 3, 20), 4000);
    std::vector<span_of_cells> as_convex, as_ring, as_rings;
    const cell_window w{-20, -20, 20, 20};
    irg::convex_spans(r, w, [&](span_of_cells s) { as_convex.push_back(s); });
    irg::polygon_spans(r, fill_rule::even_odd, w, [&](span_of_cells s) { as_ring.push_back(s); });
    irg::polygon_spans(rings{r}, fill_rule::non_zero, w, [&](span_of_cells s) { as_rings.push_back(s); });
    REQUIRE(as_convex == as_ring);
    REQUIRE(as_convex == as_rings);
  }
}

TEST_CASE("polygon_spans: the fan triangles of a ring, counted with their sign, are its winding number") {
  test::random random(24);
  for (int i = 0; i < 300; ++i) {
    const ring r = random_ring(random, test::random_int(random, 3, 15), 2500, i % 2 ? 1 : 64);
    const cell_window w{-11, -11, 11, 11};
    std::vector<int> winding(22 * 22, 0);
    for (std::size_t k = 1; k + 1 < r.size(); ++k) {
      const int sign = irg::orientation_of(r[0], r[k], r[k + 1]) == irg::orientation::clockwise ? 1 : -1;
      irg::convex_spans(ring{r[0], r[k], r[k + 1]}, w, [&](span_of_cells s) {
        for (int x = s.x_first; x < s.x_last; ++x) winding[static_cast<std::size_t>((s.y + 11) * 22 + x + 11)] += sign;
      });
    }
    for (const fill_rule rule : {fill_rule::even_odd, fill_rule::non_zero}) {
      test::canvas c(w);
      irg::polygon_spans(r, rule, w, c);
      REQUIRE(c.wrong([&](int x, int y) {
        const int n = winding[static_cast<std::size_t>((y + 11) * 22 + x + 11)];
        return rule == fill_rule::even_odd ? n % 2 != 0 : n != 0;
      }) == 0);
    }
  }
}

TEST_CASE("polygon_spans: 10^6 vertices, 10^6 edges on one scan line, and 10^5 edges that all cross") {
  const auto start = std::chrono::steady_clock::now();
  const auto seconds = [&] { return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(); };
  irg::fill_workspace workspace;
  // A comb of 5 * 10^5 teeth: each is 1 pixel wide at y = 0.5, and there are as many gaps.
  constexpr int teeth = 500000;
  ring comb;
  for (int i = 0; i < teeth; ++i) {
    comb.push_back({512 * i, 0});
    comb.push_back({512 * i + 256, 256});
  }
  comb.push_back({512 * teeth, 0});
  comb.push_back({512 * teeth, -256});
  comb.push_back({0, -256});
  long spans = 0, pixels = 0;
  CHECK(irg::polygon_spans(
      comb, fill_rule::even_odd, {0, 0, 2 * teeth, 2},
      [&](span_of_cells s) {
        ++spans;
        pixels += s.x_last - s.x_first;
      },
      workspace));
  // In row 0 the comb is left out between 2i + 1/2 and 2i + 3/2: centre 2i + 1/2 is on its right edge, 2i + 3/2 on a
  // left one.
  CHECK(spans == teeth);
  CHECK(pixels == teeth);
  const double comb_time = seconds();

  ring star;  // every edge crosses the middle
  test::random random(18);
  for (int i = 0; i < 100000; ++i) {
    const int side = i % 2 ? 1 : -1;
    star.push_back(
        {side * test::random_int(random, 0, 256 * 900), side * test::random_int(random, 256 * 100, 256 * 500)});
  }
  test::canvas c({-900, -3, 900, 3});
  CHECK(irg::polygon_spans(star, fill_rule::non_zero, c.window, c, workspace));
  long wrong = c.bad_spans;
  for (int x = -900; x < 900; x += 97) wrong += (c.at(x, 1) != 0) != (test::winding_number(star, x, 1) != 0);
  CHECK(wrong == 0);
  MESSAGE("comb ", comb_time, " s, star ", seconds() - comb_time, " s");
}

TEST_CASE("fill_polygon: guard bytes, any pixel type, a blend function called once for each pixel") {
  std::vector<std::uint16_t> memory(16 * 14, 7);
  irg::image_view<std::uint16_t> view(memory.data() + 16 * 2 + 2, 10, 10, 32);
  const std::array<std::array<point_d, 3>, 2> wide_rings{
      {{{{-50, -50}, {60, 5}, {-50, 60}}}, {{{1, 3}, {8, 5}, {1, 7}}}}};
  CHECK(irg::fill_polygon(view, wide_rings, fill_rule::even_odd, 9));
  long touched = 0, nines = 0;
  for (int i = 0; i < 16 * 14; ++i) {
    const int x = i % 16 - 2, y = i / 16 - 2;
    const bool in_view = x >= 0 && x < 10 && y >= 0 && y < 10;
    touched += !in_view && memory[static_cast<std::size_t>(i)] != 7;
    nines += in_view && memory[static_cast<std::size_t>(i)] == 9;
  }
  CHECK(touched == 0);
  CHECK(nines == pixel_count(wide_rings, fill_rule::even_odd, {0, 0, 10, 10}));

  irg::image<float> image(20, 20, 0.0f);
  int calls = 0;
  irg::fill_workspace workspace;
  const auto blend = [&](float there) {
    ++calls;
    return there + 0.5f;
  };
  CHECK(irg::fill_polygon(irg::within(image, {0, 0, 20, 12}), pentagram, fill_rule::non_zero, blend, workspace));
  CHECK(calls == pixel_count(pentagram, fill_rule::non_zero, {0, 0, 20, 12}));
  for (int y = 0; y < 20; ++y)
    for (int x = 0; x < 20; ++x) CHECK((image(x, y) == 0.0f || (image(x, y) == 0.5f && y < 12)));

  irg::image<irg::rgba8> none(0, 0);
  CHECK(irg::fill_polygon(none, pentagram, fill_rule::even_odd, {1, 2, 3, 4}));
}

constexpr int sum_of_filled() {
  irg::image<int> image(9, 9, 0);
  irg::fill_polygon(image, other_way, fill_rule::non_zero, 3);
  const subpixel pair[2][3] = {{{0, 0}, {512, 0}, {0, 512}}, {{1024, 1024}, {1536, 1024}, {1024, 1536}}};
  irg::fill_polygon(irg::within(image, {0, 0, 9, 9}), pair, fill_rule::even_odd, 100);
  int n = 0;
  for (int y = 0; y < 9; ++y)
    for (int x = 0; x < 9; ++x) n += image(x, y);
  return n;
}

TEST_CASE("fill_polygon: in constant evaluation as at run time") {
  CHECK_BOTH(sum_of_filled() == 3 * (64 - 16) - 3 + 200);
}

TEST_CASE("fill_polygon: a ring in braces") {
  constexpr auto filled = [] {
    irg::image<int> image(6, 5, 0);
    irg::fill_polygon(image, {{1, 1}, {4, 1}, {4, 3.5}, {1, 3}}, fill_rule::even_odd, 7);
    return std::array{image(1, 1), image(3, 2), image(4, 1), image(0, 0)};
  };
  CHECK_BOTH(filled() == std::array{7, 7, 0, 0});
}

}  // namespace
