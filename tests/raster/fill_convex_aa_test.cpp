// SPDX-License-Identifier: MIT
#include <irg/raster/fill_convex_aa.hpp>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <tuple>
#include <utility>
#include <vector>

#include <irg/colour/pixel.hpp>
#include <irg/raster/image.hpp>

#include "support/area_oracle.hpp"
#include "support/check_both.hpp"
#include "support/random.hpp"

namespace {

using irg::cell_window;
using irg::subpixel;
using ring = std::vector<subpixel>;
using coverages = irg::image<std::uint8_t>;

bool release_tier() { return std::getenv("IRG_RELEASE_TIER") != nullptr; }

// What the sink form says, each pixel at most once.
template <class Ring>
constexpr coverages by_spans(const Ring& r, int width, int height, const cell_window& w) {
  coverages c(width, height, 0);
  irg::convex_coverage(r, w, [&](const irg::coverage_span& s) {
    for (int x = s.x_first; x < s.x_last; ++x) {
      c(x, s.y) = static_cast<std::uint8_t>(
          c(x, s.y) + (s.coverage == nullptr ? 255 : s.coverage[x - s.x_first]));  // twice would overflow or show
    }
  });
  return c;
}
template <class Ring>
constexpr coverages by_spans(const Ring& r, int width, int height) {
  return by_spans(r, width, height, {0, 0, width, height});
}

bool same(const coverages& a, const coverages& b) {
  for (int y = 0; y < a.height(); ++y)
    for (int x = 0; x < a.width(); ++x)
      if (a(x, y) != b(x, y)) return false;
  return true;
}

// The same through the fills: white over transparent black leaves the coverage in each channel.
bool fills_agree(const ring& r, const coverages& expected) {
  irg::image<irg::rgba8> four(expected.width(), expected.height(), {0, 0, 0, 0});
  coverages one(expected.width(), expected.height(), 0);
  irg::fill_convex_aa(four, r, {255, 255, 255, 255});
  irg::fill_convex_aa(one, r, std::uint8_t{255});
  for (int y = 0; y < one.height(); ++y)
    for (int x = 0; x < one.width(); ++x) {
      const std::uint8_t c = expected(x, y);
      if (four(x, y) != irg::rgba8{c, c, c, c} || one(x, y) != c) return false;
    }
  return true;
}

subpixel random_point(test::random& r, int low, int high) {
  const auto x = static_cast<std::int32_t>(r.integer(low, high));
  return {x, static_cast<std::int32_t>(r.integer(low, high))};
}

// The hull of random points within a square; from a triangle to some ten corners.
ring random_convex(test::random& r, int low, int high, int points) {
  ring p;
  for (int i = 0; i < points; ++i) p.push_back(random_point(r, low, high));
  return test::convex_hull(p);
}

double worst_error(const ring& r, const coverages& c) {
  double worst = 0;
  for (int y = 0; y < c.height(); ++y)
    for (int x = 0; x < c.width(); ++x) {
      const double exact = static_cast<double>(test::area_within_pixel(r, x, y));
      worst = std::fmax(worst, std::fabs(exact - c(x, y) / 255.0));
    }
  return worst;
}

TEST_CASE("convex_coverage: the area within each pixel, within 1/256, by clipping each pixel (oracle)") {
  test::random r(1);
  const int rounds = release_tier() ? 20000 : 500;
  for (int i = 0; i < rounds; ++i) {
    const int size = i % 4 == 0 ? 6 : i % 4 == 1 ? 12 : i % 4 == 2 ? 20 : 40;  // pixels
    const int low = static_cast<int>(r.integer(-256, 1024)) - (i % 5 == 0 ? 3000 : 0);
    const ring p = random_convex(r, low, low + 256 * size, 3 + i % 9);
    const coverages c = by_spans(p, 40, 24);
    REQUIRE(worst_error(p, c) < 0.00198);
    REQUIRE(fills_agree(p, c));
  }
}

TEST_CASE("convex_coverage: random triangles of a few pixels (oracle)") {
  test::random r(9);
  double worst = 0;
  const int rounds = release_tier() ? 1000000 : 2000;
  for (int i = 0; i < rounds; ++i) {
    const ring p = {random_point(r, -256, 1900), random_point(r, -256, 1900), random_point(r, -256, 1900)};
    const coverages c = by_spans(p, 7, 7);
    worst = std::fmax(worst, worst_error(p, c));
    REQUIRE(worst < 0.00198);
    REQUIRE(fills_agree(p, c));
  }
  if (release_tier()) std::printf("convex_coverage: greatest error %.6f (1/256 = %.6f)\n", worst, 1 / 256.0);
}

TEST_CASE("convex_coverage: flat and steep edges that reach far") {
  test::random r(2);
  for (int i = 0; i < 300; ++i) {
    const bool flat = i % 2 == 0;
    const std::int32_t far = 256 * (i % 3 == 0 ? 100 : i % 3 == 1 ? 4000 : (1 << 21) - 300);
    ring p;
    for (int k = 0; k < 3; ++k) {
      const auto along = static_cast<std::int32_t>(r.integer(-far, far));
      const auto aside = static_cast<std::int32_t>(r.integer(-600, 3600));
      p.push_back(flat ? subpixel{along, aside} : subpixel{aside, along});
    }
    const coverages c = by_spans(p, 24, 12);
    REQUIRE(worst_error(p, c) < 0.00198);
    REQUIRE(fills_agree(p, c));
  }
}

TEST_CASE("convex_coverage: vertices at all distances up to the reach (oracle)") {
  test::random r(21);
  const int rounds = release_tier() ? 100000 : 2000;
  for (int i = 0; i < rounds; ++i) {
    const double reach = std::exp2(21 * r.unit());
    ring places;
    for (auto n = r.integer(3, 6); n > 0; --n) places.push_back(test::place_within(r, reach));
    if (i % 2 == 0) std::tie(places[0], places[1]) = test::nearly_level(r, reach);
    const ring p = test::convex_hull(places);
    const coverages c = by_spans(p, 24, 12);
    REQUIRE(worst_error(p, c) < 0.00198);
    REQUIRE(fills_agree(p, c));
  }
}

TEST_CASE("convex_coverage: a sliver of 1/256 pixel across 16384 pixels") {
  const ring p = {{0, 300}, {16384 * 256, 40 * 256}, {16384 * 256, 40 * 256 + 1}, {0, 301}};
  double sum = 0, worst = 0;
  irg::convex_coverage(p, {0, 0, 16384, 64}, [&](const irg::coverage_span& s) {
    for (int x = s.x_first; x < s.x_last; ++x) {
      const double c = s.coverage[x - s.x_first] / 255.0;
      sum += c;
      if (x % 97 == 0) worst = std::fmax(worst, std::fabs(c - static_cast<double>(test::area_within_pixel(p, x, s.y))));
    }
  });
  CHECK(worst < 0.00198);
  CHECK(sum == doctest::Approx(64).epsilon(0.01));  // 16384 / 256
}

TEST_CASE("convex_coverage: no window changes a pixel within it") {
  test::random r(3);
  for (int i = 0; i < 60; ++i) {
    const ring p = random_convex(r, -700, 256 * 20, 3 + i % 5);
    const coverages whole = by_spans(p, 18, 14);
    for (int k = 0; k < 60; ++k) {
      const int x = static_cast<int>(r.integer(0, 18)), y = static_cast<int>(r.integer(0, 14));
      const cell_window w{x, y, static_cast<int>(r.integer(0, 18)), static_cast<int>(r.integer(0, 14))};
      const coverages part = by_spans(p, 18, 14, w);
      irg::image<irg::rgba8> four(18, 14, {0, 0, 0, 0});
      irg::fill_convex_aa(irg::within(four, w), p, {255, 255, 255, 255});
      for (int v = 0; v < 14; ++v)
        for (int u = 0; u < 18; ++u) {
          const bool in = u >= w.x_first && u < w.x_last && v >= w.y_first && v < w.y_last;
          REQUIRE(part(u, v) == (in ? whole(u, v) : 0));
          REQUIRE(four(u, v).g == part(u, v));
        }
    }
  }
}

TEST_CASE("convex_coverage: mirrored, shifted, turned and renumbered polygons") {
  test::random r(4);
  int turned_differ = 0;
  for (int i = 0; i < 400; ++i) {
    constexpr int n = 20;
    const ring p = random_convex(r, 0, 256 * n, 3 + i % 6);
    const coverages c = by_spans(p, n, n);
    ring mirrored, shifted, turned, reversed(p.rbegin(), p.rend()), renumbered(p);
    for (const subpixel& v : p) {
      mirrored.push_back({n * 256 - v.x, v.y});
      shifted.push_back({v.x - 3 * 256, v.y + 2 * 256});
      turned.push_back({n * 256 - v.y, v.x});
    }
    if (!p.empty()) renumbered.push_back(renumbered.front());  // a repeated vertex, too
    const coverages m = by_spans(mirrored, n, n), s = by_spans(shifted, n, n), t = by_spans(turned, n, n);
    REQUIRE(same(c, by_spans(reversed, n, n)));
    REQUIRE(same(c, by_spans(renumbered, n, n)));
    for (int y = 0; y < n; ++y)
      for (int x = 0; x < n; ++x) {
        REQUIRE(c(x, y) == m(n - 1 - x, y));
        if (x >= 3 && y < n - 2) REQUIRE(c(x, y) == s(x - 3, y + 2));
        const int difference = c(x, y) - t(n - 1 - y, x);
        REQUIRE(std::abs(difference) <= 1);
        turned_differ += difference != 0 ? 1 : 0;
      }
  }
  CHECK(turned_differ < 20);  // computed in another way: where the area is within 2^-18 of half a step
}

TEST_CASE("convex_coverage: turned polygons on a lattice have turned coverages") {
  test::random r(5);
  for (int i = 0; i < 300; ++i) {
    constexpr int n = 8;
    ring p, t;
    for (int k = 0; k < 3; ++k) {
      const subpixel v = random_point(r, 0, 4 * n);
      p.push_back({v.x * 64, v.y * 64});
      t.push_back({n * 256 - v.y * 64, v.x * 64});
    }
    const coverages a = by_spans(p, n, n), b = by_spans(t, n, n);
    for (int y = 0; y < n; ++y)
      for (int x = 0; x < n; ++x) REQUIRE(a(x, y) == b(n - 1 - y, x));
  }
}

TEST_CASE("convex_coverage: coverages add up to the area") {
  test::random r(6);
  for (int i = 0; i < 100; ++i) {
    const ring p = random_convex(r, 0, 256 * 60, 3 + i % 20);
    const coverages c = by_spans(p, 60, 60);
    double sum = 0;
    int partial = 0;
    for (int y = 0; y < 60; ++y)
      for (int x = 0; x < 60; ++x) {
        sum += c(x, y) / 255.0;
        partial += c(x, y) > 0 && c(x, y) < 255 ? 1 : 0;
      }
    CHECK(std::fabs(sum - static_cast<double>(test::area_of(p))) <= 0.002 * partial + 1e-9);
  }
}

template <class T>
using triangle = irg::point<T, 2>[3];

constexpr bool square_is_exact() {
  const irg::point<double, 2> square[4] = {{1.25, 1.5}, {4.75, 1.5}, {4.75, 3}, {1.25, 3}};
  const coverages c = by_spans(square, 6, 4);
  const std::uint8_t rows[4][6] = {
      {0, 0, 0, 0, 0, 0}, {0, 96, 128, 128, 96, 0}, {0, 191, 255, 255, 191, 0}, {0, 0, 0, 0, 0, 0}};
  for (int y = 0; y < 4; ++y)
    for (int x = 0; x < 6; ++x)
      if (c(x, y) != rows[y][x]) return false;
  return true;
}

constexpr bool half_square() {
  const irg::point<float, 2> t[3] = {{0, 0}, {2, 0}, {0, 2}};
  const coverages c = by_spans(t, 3, 2);
  return c(0, 0) == 255 && c(1, 0) == 128 && c(0, 1) == 128 && c(1, 1) == 0 && c(2, 0) == 0;
}

// Small and large, so that run time takes each of its ways.
constexpr bool colours_by_coverage(int size) {
  const irg::point<float, 2> t[3] = {{0.25f, 0.5f}, {static_cast<float>(size) - 0.5f, 1}, {2, 6.75f}};
  irg::image<irg::rgba8> picture(size, 8, {0, 0, 0, 255});
  irg::fill_convex_aa(picture, t, {255, 255, 0, 255});
  const coverages c = by_spans(t, size, 8);
  for (int y = 0; y < 8; ++y)
    for (int x = 0; x < size; ++x)
      if (picture(x, y) != irg::rgba8{c(x, y), c(x, y), 0, 255}) return false;
  return true;
}

TEST_CASE("convex_coverage: by hand") {
  CHECK_BOTH(colours_by_coverage(5));
  CHECK_BOTH(colours_by_coverage(22));
  CHECK_BOTH(square_is_exact());
  CHECK_BOTH(half_square());
}

template <class T>
constexpr int touched(const irg::point<T, 2> (&corners)[3]) {
  const coverages c = by_spans(corners, 5, 5);
  int n = 0;
  for (int y = 0; y < 5; ++y)
    for (int x = 0; x < 5; ++x) n += c(x, y) != 0 ? 1 : 0;
  return n;
}

TEST_CASE("convex_coverage: degenerate polygons cover nothing") {
  CHECK_BOTH(touched<float>({{1, 1}, {1, 1}, {1, 1}}) == 0);
  CHECK_BOTH(touched<float>({{1, 1}, {4, 3}, {1, 1}}) == 0);
  CHECK_BOTH(touched<float>({{0, 0}, {2, 2}, {4, 4}}) == 0);
  CHECK_BOTH(touched<float>({{0, 2.5f}, {2, 2.5f}, {4, 2.5f}}) == 0);
  CHECK_BOTH(touched<float>({{2.5f, 0}, {2.5f, 2}, {2.5f, 4}}) == 0);
  CHECK_BOTH([] {
    const ring none, two = {{0, 0}, {900, 900}};
    int calls = 0;
    const auto count = [&](const irg::coverage_span&) { ++calls; };
    return irg::convex_coverage(none, {0, 0, 9, 9}, count) && irg::convex_coverage(two, {0, 0, 9, 9}, count) &&
           calls == 0;
  }());
}

TEST_CASE("convex_coverage: empty and inverted windows, and images of no size") {
  const ring p = {{0, 0}, {5000, 100}, {900, 5000}};
  int calls = 0;
  const auto count = [&](const irg::coverage_span&) { ++calls; };
  CHECK(irg::convex_coverage(p, {3, 3, 3, 9}, count));
  CHECK(irg::convex_coverage(p, {9, 9, 3, 3}, count));
  CHECK(irg::convex_coverage(p, {3, -5, 9, -2}, count));
  CHECK(irg::convex_coverage(p, {40, 0, 60, 20}, count));
  CHECK(calls == 0);
  irg::image<irg::rgba8> nothing(0, 0);
  CHECK(irg::fill_convex_aa(nothing, p, {1, 2, 3, 4}));
  irg::image<irg::rgba8> dot(1, 1, {0, 0, 0, 0});
  CHECK(irg::fill_convex_aa(dot, p, {255, 255, 255, 255}));
  CHECK(dot(0, 0).r == by_spans(p, 1, 1)(0, 0));
}

TEST_CASE("convex_coverage: NaN, infinity and far vertices are refused, near ones serve") {
  constexpr float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();
  for (const float bad : {nan, inf, -inf, 1e30f, -2147483648.0f, 2097153.0f}) {
    for (int at = 0; at < 6; ++at) {
      triangle<float> t = {{0, 0}, {9, 1}, {2, 9}};
      (at % 2 == 0 ? t[at / 2].x : t[at / 2].y) = bad;
      coverages c(9, 9, 0);
      CHECK(!irg::fill_convex_aa(c, t, std::uint8_t{255}));
      for (int y = 0; y < 9; ++y)
        for (int x = 0; x < 9; ++x) CHECK(c(x, y) == 0);
    }
  }
  constexpr float most = 2097152;
  const triangle<float> t = {{-most, -most}, {most, -most}, {0, most}};
  coverages c(9, 9, 0);
  CHECK(irg::fill_convex_aa(c, t, std::uint8_t{255}));
  for (int y = 0; y < 9; ++y)
    for (int x = 0; x < 9; ++x) CHECK(c(x, y) == 255);
  const ring too_far = {{0, 0}, {0, 2097152 * 256 + 1}, {300, 0}};
  CHECK(!irg::fill_convex_aa(c, too_far, std::uint8_t{1}));
}

TEST_CASE("fill_convex_aa: nothing outside of the image is written") {
  test::random r(7);
  for (int i = 0; i < 300; ++i) {
    constexpr int stride = 23, rows = 17;
    std::vector<irg::rgba8> memory(stride * rows, {7, 7, 7, 7});
    const int width = static_cast<int>(r.integer(1, 20)), height = static_cast<int>(r.integer(1, 15));
    irg::image_view<irg::rgba8> view(memory.data() + stride + 1, width, height,
                                     stride * static_cast<std::ptrdiff_t>(sizeof(irg::rgba8)));
    ring p;
    for (int k = 0; k < 3 + i % 4; ++k) p.push_back(random_point(r, -2000, 256 * 24));  // convex or not
    irg::fill_convex_aa(view, p, {255, 0, 255, 0});
    for (int y = 0; y < rows; ++y)
      for (int x = 0; x < stride; ++x)
        if (x < 1 || x > width || y < 1 || y > height)
          REQUIRE(memory[static_cast<std::size_t>(y * stride + x)] == irg::rgba8{7, 7, 7, 7});
  }
}

TEST_CASE("fill_convex_aa: any pixel type, and a function called once for each pixel that is touched") {
  const triangle<double> t = {{0.5, 0.25}, {17.5, 3}, {4, 11.75}};
  const coverages c = by_spans(t, 20, 13);
  irg::image<int> calls(20, 13, 0);
  irg::image<float> depth(20, 13, 1.0f);
  irg::image<irg::bgr8> three(20, 13, {0, 100, 200});
  irg::fill_convex_aa(calls, t, [](int there, std::uint8_t coverage) { return there + 1000 + coverage; });
  irg::fill_convex_aa(depth, t, 3.0f);
  irg::fill_convex_aa(three, t, {9, 8, 7});
  for (int y = 0; y < 13; ++y)
    for (int x = 0; x < 20; ++x) {
      CHECK(calls(x, y) == (c(x, y) == 0 ? 0 : 1000 + c(x, y)));
      CHECK(depth(x, y) == irg::mix(1.0f, 3.0f, c(x, y)));
      CHECK(three(x, y) == irg::mix(irg::bgr8{0, 100, 200}, irg::bgr8{9, 8, 7}, c(x, y)));
    }
}

constexpr std::uint64_t hash_of(int rounds) {
  test::random r(8, test::in_every_round{});
  std::uint64_t h = 1;
  for (int i = 0; i < rounds; ++i) {
    subpixel t[3];
    for (subpixel& v : t) {
      v.x = static_cast<std::int32_t>(r.integer(-500, 2500));
      v.y = static_cast<std::int32_t>(r.integer(-300, 1500));
    }
    const coverages c = by_spans(t, 8, 4);
    for (int y = 0; y < 4; ++y)
      for (int x = 0; x < 8; ++x) h = (h ^ c(x, y)) * 1099511628211u;
  }
  return h;
}

TEST_CASE("convex_coverage: lanes give the bits of constant evaluation") {
  constexpr std::uint64_t expected = hash_of(12);
  CHECK(hash_of(12) == expected);
}

TEST_CASE("convex_coverage: a disc of many vertices, and all of a ring's corners in one row") {
  ring disc;
  for (int i = 0; i < 20000; ++i) {
    const double a = i * 6.283185307179586 / 20000;
    disc.push_back({irg::snap(300 + 280 * std::cos(a)), irg::snap(300 + 280 * std::sin(a))});
  }
  const ring p = test::convex_hull(disc);
  CHECK(p.size() > 1000);
  const coverages c = by_spans(p, 600, 600);
  for (int y = 20; y < 60; ++y)
    for (int x = 0; x < 600; ++x)
      REQUIRE(std::fabs(static_cast<double>(test::area_within_pixel(p, x, y)) - c(x, y) / 255.0) < 0.00198);
  ring lens;
  for (int i = -100; i <= 100; ++i) lens.push_back({i * 40 + 5000, 256 * 3 + 10 + i * i / 50});
  const ring q = test::convex_hull(lens);
  CHECK(worst_error(q, by_spans(q, 40, 6)) < 0.00198);
}

}  // namespace
