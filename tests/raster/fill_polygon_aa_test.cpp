// SPDX-License-Identifier: MIT
#include <irg/raster/fill_polygon_aa.hpp>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <tuple>
#include <vector>

#include <irg/colour/pixel.hpp>
#include <irg/raster/image.hpp>

#include "support/area_oracle.hpp"
#include "support/check_both.hpp"
#include "support/random.hpp"

namespace {

using irg::cell_window;
using irg::fill_rule;
using irg::subpixel;
using ring = std::vector<subpixel>;
using rings = std::vector<ring>;
using coverages = irg::image<std::uint8_t>;

bool release_tier() { return std::getenv("IRG_RELEASE_TIER") != nullptr; }

template <class P>
constexpr coverages by_spans(const P& p, fill_rule rule, int width, int height, const cell_window& w) {
  coverages c(width, height, 0);
  irg::polygon_coverage(p, rule, w, [&](const irg::coverage_span& s) {
    for (int x = s.x_first; x < s.x_last; ++x)
      c(x, s.y) = static_cast<std::uint8_t>(c(x, s.y) + (s.coverage == nullptr ? 255 : s.coverage[x - s.x_first]));
  });
  return c;
}
template <class P>
constexpr coverages by_spans(const P& p, fill_rule rule, int width, int height) {
  return by_spans(p, rule, width, height, {0, 0, width, height});
}

bool same(const coverages& a, const coverages& b) {
  for (int y = 0; y < a.height(); ++y)
    for (int x = 0; x < a.width(); ++x)
      if (a(x, y) != b(x, y)) return false;
  return true;
}

double worst_error(const rings& p, fill_rule rule, const coverages& c) {
  double worst = 0;
  const auto inside = [&](int winding) { return rule == fill_rule::even_odd ? winding % 2 != 0 : winding != 0; };
  for (int y = 0; y < c.height(); ++y)
    for (int x = 0; x < c.width(); ++x)
      worst = std::fmax(worst,
                        std::fabs(static_cast<double>(test::enclosed_within_pixel(p, x, y, inside)) - c(x, y) / 255.0));
  return worst;
}

// step: the lattice the vertices stand on, in 1/256 pixel; coarse ones make vertices and edges meet.
rings random_rings(test::random& r, int size, int step) {
  rings p;
  const auto count = r.integer(1, 3);
  for (std::int64_t k = 0; k < count; ++k) {
    ring q;
    const auto n = r.integer(3, 7);
    for (std::int64_t i = 0; i < n; ++i) {
      const auto x = static_cast<std::int32_t>(r.integer(-256, 256 * size + 256) / step * step);
      q.push_back({x, static_cast<std::int32_t>(r.integer(-256, 256 * size + 256) / step * step)});
    }
    p.push_back(q);
  }
  return p;
}

TEST_CASE("polygon_coverage: the area of the inside within each pixel, by brute force (oracle)") {
  test::random r(1);
  double worst = 0;
  const int rounds = release_tier() ? 20000 : 300;
  for (int i = 0; i < rounds; ++i) {
    const int step = i % 4 == 0 ? 256 : i % 4 == 1 ? 64 : i % 4 == 2 ? 16 : 1;
    const int size = i % 3 == 0 ? 1 : i % 3 == 1 ? 3 : 8;
    const rings p = random_rings(r, size, step);
    for (const fill_rule rule : {fill_rule::even_odd, fill_rule::non_zero}) {
      const double error = worst_error(p, rule, by_spans(p, rule, size, size));
      worst = std::fmax(worst, error);
      REQUIRE(error < 0.00198);
    }
  }
  if (release_tier()) std::printf("polygon_coverage: greatest error %.6f (1/256 = %.6f)\n", worst, 1 / 256.0);
}

TEST_CASE("polygon_coverage: many edges through few pixels") {
  test::random r(2);
  for (int i = 0; i < 12; ++i) {
    ring q;
    for (int k = 0; k < 40; ++k) {
      const auto x = static_cast<std::int32_t>(r.integer(0, 512));
      q.push_back({x, static_cast<std::int32_t>(r.integer(0, 512))});
    }
    for (const fill_rule rule : {fill_rule::even_odd, fill_rule::non_zero})
      REQUIRE(worst_error({q}, rule, by_spans(q, rule, 2, 2)) < 0.00198);
  }
}

TEST_CASE("polygon_coverage: edges that reach far") {
  test::random r(3);
  for (int i = 0; i < 60; ++i) {
    const std::int32_t far = i % 2 == 0 ? 256 * 5000 : 256 * ((1 << 21) - 1);
    ring q;
    for (int k = 0; k < 5; ++k) {
      const auto x = static_cast<std::int32_t>(r.integer(-far, far));
      const auto y = static_cast<std::int32_t>(r.integer(-far, far));
      q.push_back(i % 3 == 0 ? subpixel{x / 4096, y} : i % 3 == 1 ? subpixel{x, y / 4096} : subpixel{x, y});
    }
    REQUIRE(worst_error({q}, fill_rule::even_odd, by_spans(q, fill_rule::even_odd, 5, 5)) < 0.00198);
  }
}

TEST_CASE("polygon_coverage: vertices at all distances up to the reach (oracle)") {
  test::random r(22);
  const int rounds = release_tier() ? 20000 : 500;
  for (int i = 0; i < rounds; ++i) {
    const double reach = std::exp2(21 * r.unit());
    ring q;
    for (auto n = r.integer(3, 6); n > 0; --n) q.push_back(test::place_within(r, reach));
    if (i % 2 == 0) std::tie(q[0], q[1]) = test::nearly_level(r, reach);
    for (const fill_rule rule : {fill_rule::even_odd, fill_rule::non_zero})
      REQUIRE(worst_error({q}, rule, by_spans(q, rule, 7, 5)) < 0.00198);
  }
}

TEST_CASE("polygon_coverage: no window changes a pixel within it") {
  test::random r(4);
  for (int i = 0; i < 60; ++i) {
    const rings p = random_rings(r, 9, i % 2 == 0 ? 1 : 64);
    const coverages whole = by_spans(p, fill_rule::non_zero, 9, 9);
    for (int k = 0; k < 40; ++k) {
      const int x = static_cast<int>(r.integer(0, 9)), y = static_cast<int>(r.integer(0, 9));
      const cell_window w{x, y, static_cast<int>(r.integer(0, 9)), static_cast<int>(r.integer(0, 9))};
      const coverages part = by_spans(p, fill_rule::non_zero, 9, 9, w);
      for (int v = 0; v < 9; ++v)
        for (int u = 0; u < 9; ++u) {
          const bool in = u >= w.x_first && u < w.x_last && v >= w.y_first && v < w.y_last;
          REQUIRE(part(u, v) == (in ? whole(u, v) : 0));
        }
    }
  }
}

TEST_CASE("polygon_coverage: reversed, renumbered, shifted and mirrored rings") {
  test::random r(5);
  for (int i = 0; i < 200; ++i) {
    const rings p = random_rings(r, 8, i % 2 == 0 ? 1 : 32);
    for (const fill_rule rule : {fill_rule::even_odd, fill_rule::non_zero}) {
      rings reversed = p, renumbered = p, shifted = p, mirrored = p, spiked = p;
      for (std::size_t k = 0; k < p.size(); ++k) {
        reversed[k].assign(p[k].rbegin(), p[k].rend());
        std::rotate(renumbered[k].begin(), renumbered[k].begin() + 1, renumbered[k].end());
        renumbered[k].push_back(renumbered[k].back());  // a repeated vertex, too
        for (subpixel& v : shifted[k]) v = {v.x + 2 * 256, v.y - 3 * 256};
        for (subpixel& v : mirrored[k]) v.x = 8 * 256 - v.x;
        spiked[k].insert(spiked[k].begin() + 1, {p[k][0], subpixel{999, 777}, p[k][0]});
      }
      std::swap(renumbered.front(), renumbered.back());
      const coverages c = by_spans(p, rule, 8, 8), m = by_spans(mirrored, rule, 8, 8);
      REQUIRE(same(c, by_spans(reversed, rule, 8, 8)));
      REQUIRE(same(c, by_spans(renumbered, rule, 8, 8)));
      const coverages s = by_spans(shifted, rule, 8, 8), t = by_spans(spiked, rule, 8, 8);
      for (int y = 0; y < 8; ++y)
        for (int x = 0; x < 8; ++x) {
          REQUIRE(c(x, y) == m(7 - x, y));
          REQUIRE(c(x, y) == t(x, y));
          if (x < 6 && y >= 3) REQUIRE(c(x, y) == s(x + 2, y - 3));
        }
    }
  }
}

constexpr int in_middle(const rings& p, fill_rule rule) { return by_spans(p, rule, 9, 9)(4, 4); }

constexpr ring square(int low, int high) {
  return {{low * 256, low * 256}, {high * 256, low * 256}, {high * 256, high * 256}, {low * 256, high * 256}};
}
constexpr ring reversed_square(int low, int high) {
  return {{low * 256, low * 256}, {low * 256, high * 256}, {high * 256, high * 256}, {high * 256, low * 256}};
}

TEST_CASE("polygon_coverage: holes and the two rules") {
  CHECK_BOTH(in_middle({square(1, 8)}, fill_rule::even_odd) == 255);
  CHECK_BOTH(in_middle({square(1, 8), square(3, 6)}, fill_rule::even_odd) == 0);
  CHECK_BOTH(in_middle({square(1, 8), square(3, 6)}, fill_rule::non_zero) == 255);
  CHECK_BOTH(in_middle({square(1, 8), reversed_square(3, 6)}, fill_rule::non_zero) == 0);
  CHECK_BOTH(in_middle({square(1, 8), square(4, 8)}, fill_rule::even_odd) == 0);  // shares two edges
  CHECK_BOTH(in_middle({square(1, 5), square(5, 8)}, fill_rule::even_odd) == 255);  // touches in a vertex
  CHECK_BOTH(in_middle({{{0, 0}, {9 * 256, 9 * 256}, {9 * 256, 0}, {0, 9 * 256}}}, fill_rule::non_zero) == 128);
  const double pi = 3.14159265358979323846;
  std::vector<irg::point<double, 2>> pentagram;
  for (int i = 0; i < 5; ++i)
    pentagram.push_back({4.5 + 4 * std::sin(i * 4 * pi / 5), 4.5 - 4 * std::cos(i * 4 * pi / 5)});
  CHECK(by_spans(pentagram, fill_rule::even_odd, 9, 9)(4, 4) == 0);
  CHECK(by_spans(pentagram, fill_rule::non_zero, 9, 9)(4, 4) == 255);
}

TEST_CASE("polygon_coverage: coverage is no sum of areas where edges cross within a pixel or rings overlap") {
  // Two squares of 3/4 x 1 pixel that overlap by one half: 1, not 1 1/2 cut off; the overlap alone is left out.
  const rings p = {{{0, 0}, {192, 0}, {192, 256}, {0, 256}}, {{64, 0}, {256, 0}, {256, 256}, {64, 256}}};
  CHECK(by_spans(p, fill_rule::non_zero, 1, 1)(0, 0) == 255);
  CHECK(by_spans(p, fill_rule::even_odd, 1, 1)(0, 0) == 128);
  // A bow-tie within one pixel: its two halves do not cancel.
  const ring bow = {{0, 0}, {256, 256}, {256, 0}, {0, 256}};
  CHECK(by_spans(bow, fill_rule::non_zero, 1, 1)(0, 0) == 128);
}

TEST_CASE("polygon_coverage: a convex ring goes as in convex_coverage; cut up, it differs by no more than a step") {
  test::random r(6);
  for (int i = 0; i < 200; ++i) {
    ring hull;
    for (int k = 0; k < 3 + i % 7; ++k) {
      const auto x = static_cast<std::int32_t>(r.integer(-500, 256 * 12));
      hull.push_back({x, static_cast<std::int32_t>(r.integer(-500, 256 * 12))});
    }
    hull = test::convex_hull(hull);
    const coverages a = by_spans(hull, fill_rule::even_odd, 12, 12);
    const coverages b = by_spans(rings{hull}, fill_rule::even_odd, 12, 12);
    coverages c(12, 12, 0);
    irg::fill_convex_aa(c, hull, std::uint8_t{255});
    REQUIRE(same(a, c));
    for (int y = 0; y < 12; ++y)
      for (int x = 0; x < 12; ++x) REQUIRE(std::abs(a(x, y) - b(x, y)) <= 1);
  }
}

TEST_CASE("polygon_coverage: a ring is as convex as it is, whichever vertex stands last, and stands there twice") {
  ring r{{3072, 5888}, {5632, 6144}, {3584, 0}, {1280, 2304}, {4608, 2304}};  // turns the other way at the last one
  const coverages plain = by_spans(r, fill_rule::non_zero, 24, 24);
  CHECK(worst_error({r}, fill_rule::non_zero, plain) < 0.00198);
  for (std::size_t first = 0; first < 5; ++first) {
    ring turned;
    for (std::size_t i = 0; i < 5; ++i) turned.push_back(r[(first + i) % 5]);
    for (int repeated = 0; repeated < 3; ++repeated) {
      turned.push_back(turned.back());
      CHECK(same(by_spans(turned, fill_rule::non_zero, 24, 24), plain));
    }
  }
}

TEST_CASE("polygon_coverage: degenerate rings and empty windows") {
  int calls = 0;
  const auto count = [&](const irg::coverage_span&) { ++calls; };
  const cell_window w{0, 0, 20, 20};
  CHECK(irg::polygon_coverage(rings{}, fill_rule::even_odd, w, count));
  CHECK(irg::polygon_coverage(rings{{}, {{0, 0}}, {{0, 0}, {900, 900}}}, fill_rule::even_odd, w, count));
  CHECK(irg::polygon_coverage(rings{{{0, 0}, {900, 900}, {1800, 1800}, {300, 300}}}, fill_rule::non_zero, w,
                              [&](const irg::coverage_span& s) {
                                for (int x = s.x_first; x < s.x_last; ++x) calls += s.coverage[x - s.x_first];
                              }));
  CHECK(irg::polygon_coverage(rings{{{0, 300}, {900, 300}, {500, 300}, {200, 300}}}, fill_rule::non_zero, w, count));
  const rings p = {square(0, 19), square(2, 5)};
  CHECK(irg::polygon_coverage(p, fill_rule::even_odd, {5, 5, 5, 9}, count));
  CHECK(irg::polygon_coverage(p, fill_rule::even_odd, {9, 9, 5, 5}, count));
  CHECK(irg::polygon_coverage(p, fill_rule::even_odd, {30, 0, 50, 20}, count));
  CHECK(calls == 0);
  irg::image<irg::rgba8> nothing(0, 0);
  CHECK(irg::fill_polygon_aa(nothing, p, fill_rule::even_odd, {1, 2, 3, 4}));
}

TEST_CASE("polygon_coverage: NaN, infinity and far vertices are refused") {
  constexpr float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();
  for (const float bad : {nan, inf, -inf, 1e30f, -2147483648.0f, 2097153.0f}) {
    std::vector<std::vector<irg::point<float, 2>>> p = {{{0, 0}, {9, 0}, {9, 9}, {4, 2}}, {{1, 1}, {2, 1}, {2, bad}}};
    coverages c(9, 9, 0);
    CHECK(!irg::fill_polygon_aa(c, p, fill_rule::even_odd, std::uint8_t{255}));
    CHECK(same(c, coverages(9, 9, 0)));
    CHECK(!irg::fill_polygon_aa(c, p[1], fill_rule::even_odd, std::uint8_t{255}));
  }
}

TEST_CASE("fill_polygon_aa: any pixel type, a function once for each pixel, and nothing outside of the image") {
  test::random r(7);
  irg::coverage_workspace workspace;
  for (int i = 0; i < 60; ++i) {
    const rings p = random_rings(r, 12, 1);
    const coverages c = by_spans(p, fill_rule::even_odd, 10, 8);
    constexpr int stride = 14, rows = 10;
    std::vector<irg::rgba8> memory(stride * rows, {7, 7, 7, 7});
    irg::image_view<irg::rgba8> view(memory.data() + stride + 2, 10, 8,
                                     stride * static_cast<std::ptrdiff_t>(sizeof(irg::rgba8)));
    irg::fill_polygon_aa(irg::within(view, {-5, -5, 99, 99}), p, fill_rule::even_odd, {250, 0, 9, 255}, workspace);
    irg::image<int> calls(10, 8, 0);
    irg::image<double> depth(10, 8, 1.0);
    irg::fill_polygon_aa(calls, p, fill_rule::even_odd, [](int there, std::uint8_t k) { return there + 1000 + k; });
    irg::fill_polygon_aa(irg::within(depth, {0, 0, 10, 8}), p, fill_rule::even_odd, 3.0, workspace);
    for (int y = 0; y < rows; ++y)
      for (int x = 0; x < stride; ++x) {
        const bool in = x >= 2 && x < 12 && y >= 1 && y < 9;
        const irg::rgba8 there{7, 7, 7, 7}, expected = in ? irg::mix(there, {250, 0, 9, 255}, c(x - 2, y - 1)) : there;
        REQUIRE(memory[static_cast<std::size_t>(y * stride + x)] == expected);
        if (!in) continue;
        REQUIRE(calls(x - 2, y - 1) == (c(x - 2, y - 1) == 0 ? 0 : 1000 + c(x - 2, y - 1)));
        REQUIRE(depth(x - 2, y - 1) == irg::mix(1.0, 3.0, c(x - 2, y - 1)));
      }
  }
}

constexpr std::uint64_t hash_of(int rounds) {
  test::random r(8, test::in_every_round{});
  std::uint64_t h = 1;
  for (int i = 0; i < rounds; ++i) {
    ring q;
    for (int k = 0; k < 5; ++k) {
      const auto x = static_cast<std::int32_t>(r.integer(-100, 1100));
      q.push_back({x, static_cast<std::int32_t>(r.integer(-100, 1100))});
    }
    const coverages c = by_spans(rings{q}, fill_rule::even_odd, 4, 4);
    for (int y = 0; y < 4; ++y)
      for (int x = 0; x < 4; ++x) h = (h ^ c(x, y)) * 1099511628211u;
  }
  return h;
}

TEST_CASE("polygon_coverage: the same in constant evaluation") {
  constexpr std::uint64_t expected = hash_of(3);
  CHECK(hash_of(3) == expected);
}

TEST_CASE("polygon_coverage: very many vertices, and very many edges in one row") {
  const int n = release_tier() ? 1000000 : 40000;
  ring comb;  // teeth of 1/4 pixel and more, side by side
  for (int i = 0; i < n; ++i) comb.push_back({(i * 3) % (1 << 28), i % 2 == 0 ? 10 : 250});
  comb.push_back({n * 3, 300});
  comb.push_back({0, 300});
  double sum = 0;
  CHECK(irg::polygon_coverage(comb, fill_rule::even_odd, {0, 0, n, 4}, [&](const irg::coverage_span& s) {
    for (int x = s.x_first; x < s.x_last; ++x) sum += s.coverage == nullptr ? 1.0 : s.coverage[x - s.x_first] / 255.0;
  }));
  CHECK(sum == doctest::Approx(static_cast<double>(test::area_of(comb))).epsilon(0.004));
  ring spiral;  // a circle's worth of vertices, gone round with a slight wobble
  for (int i = 0; i < n; ++i) {
    const double a = i * 6.283185307179586 / n, radius = 100 + 20 * std::sin(40 * a);
    spiral.push_back({irg::snap(130 + radius * std::cos(a)), irg::snap(130 + radius * std::sin(a))});
  }
  sum = 0;
  CHECK(irg::polygon_coverage(spiral, fill_rule::non_zero, {0, 0, 260, 260}, [&](const irg::coverage_span& s) {
    for (int x = s.x_first; x < s.x_last; ++x) sum += s.coverage == nullptr ? 1.0 : s.coverage[x - s.x_first] / 255.0;
  }));
  CHECK(sum == doctest::Approx(static_cast<double>(test::area_of(spiral))).epsilon(0.001));
}

TEST_CASE("fill_polygon_aa: a ring in braces") {
  irg::image<irg::rgba8> image(4, 3, {0, 0, 0, 255});
  CHECK(irg::fill_polygon_aa(image, {{1, 0}, {3, 0}, {3, 2.5}, {1, 2.5}}, fill_rule::non_zero,
                             irg::rgba8{200, 200, 200, 255}));
  CHECK(image(1, 1).r == 200);
  CHECK(image(0, 0).r == 0);
  CHECK(image(2, 2).r > 0);
  CHECK(image(2, 2).r < 200);
}

}  // namespace
