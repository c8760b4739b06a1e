// SPDX-License-Identifier: MIT
#include <irg/raster/line_aa.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <vector>

#include <irg/raster/image.hpp>

#include "support/area_oracle.hpp"
#include "support/check_both.hpp"
#include "support/random.hpp"

namespace {

using irg::cell, irg::subpixel, irg::cell_window, irg::line_aa_options, irg::line_aa_caps;
using real = long double;
constexpr int one = irg::one_pixel;

// How far a coverage may be from 255 * area: half for the rounding, and what the header allows for.
constexpr real allowed = 0.5L + 1 / 64.0L;
static_assert(allowed / 255 < 1 / 256.0L);

struct corner {
  real x, y;
};

// The line's rectangle, relative to the whole pixel (ox, oy).
std::vector<corner> rectangle(subpixel a, subpixel b, const line_aa_options& o, int ox, int oy) {
  const real dx = (real{1} * b.x - a.x) / one, dy = (real{1} * b.y - a.y) / one, length = std::sqrt(dx * dx + dy * dy),
             half = real{1} * o.width / (2 * one), ux = length > 0 ? dx / length : 1, uy = length > 0 ? dy / length : 0,
             e = o.caps == line_aa_caps::square ? half : 0;
  const corner p{(real{1} * a.x - real{256} * ox) / one - ux * e, (real{1} * a.y - real{256} * oy) / one - uy * e},
      q{p.x + dx + 2 * ux * e, p.y + dy + 2 * uy * e};
  return {{p.x - uy * half, p.y + ux * half},
          {p.x + uy * half, p.y - ux * half},
          {q.x + uy * half, q.y - ux * half},
          {q.x - uy * half, q.y + ux * half}};
}

// Sutherland and Hodgman: the polygon's part with a*x + b*y <= c.
std::vector<corner> cut(const std::vector<corner>& polygon, real a, real b, real c) {
  std::vector<corner> out;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const corner u = polygon[i], v = polygon[(i + 1) % polygon.size()];
    const real at_u = a * u.x + b * u.y - c, at_v = a * v.x + b * v.y - c;
    if (at_u <= 0) out.push_back(u);
    if ((at_u < 0 && at_v > 0) || (at_u > 0 && at_v < 0)) {
      const real t = at_u / (at_u - at_v);
      out.push_back({u.x + t * (v.x - u.x), u.y + t * (v.y - u.y)});
    }
  }
  return out;
}

real area_in_pixel(const std::vector<corner>& polygon, int x, int y) {
  const real fx = x, fy = y;
  const auto p = cut(cut(cut(cut(polygon, -1, 0, -fx), 1, 0, fx + 1), 0, -1, -fy), 0, 1, fy + 1);
  real twice = 0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const corner u = p[i], v = p[(i + 1) % p.size()];
    twice += (u.x - fx) * (v.y - fy) - (v.x - fx) * (u.y - fy);
  }
  return std::fabs(twice) / 2;
}

// The coverages in a window; -1 where no call came, -2 where two came.
struct coverages {
  cell_window window;
  std::vector<int> value;
  constexpr explicit coverages(const cell_window& w)
      : window(w),
        value(static_cast<std::size_t>(w.x_last - w.x_first) * static_cast<std::size_t>(w.y_last - w.y_first), -1) {}
  constexpr int& at(int x, int y) {
    return value[static_cast<std::size_t>(y - window.y_first) *
                     static_cast<std::size_t>(window.x_last - window.x_first) +
                 static_cast<std::size_t>(x - window.x_first)];
  }
  // A pixel that was not named is as good as one of coverage 0.
  constexpr int seen(int x, int y) { return at(x, y) == -1 ? 0 : at(x, y); }
  constexpr void operator()(const irg::coverage_span& s) {
    for (int x = s.x_first; x < s.x_last; ++x) at(x, s.y) = at(x, s.y) == -1 ? s.coverage[x - s.x_first] : -2;
  }
};

coverages covered(subpixel a, subpixel b, const cell_window& w, const line_aa_options& o = {}) {
  coverages c(w);
  REQUIRE(irg::line_aa(a, b, w, c, o));
  return c;
}

struct random_lines {
  test::random random;
  std::int64_t integer(std::int64_t low, std::int64_t high) { return random.integer(low, high); }
  int size() { return 1 << integer(0, 8); }
  // A line near (0, 0): any direction, now and then nearly level, nearly upright, on whole numbers, at 45 degrees.
  std::pair<subpixel, subpixel> line() {
    const int reach = size() * one;
    const auto c = [&] { return static_cast<std::int32_t>(integer(-reach, reach)); };
    subpixel a{c(), c()}, b{c(), c()};
    switch (integer(0, 9)) {
      case 0: b.y = a.y + static_cast<std::int32_t>(integer(-3, 3)); break;
      case 1: b.x = a.x + static_cast<std::int32_t>(integer(-3, 3)); break;
      case 2: b.x = a.x + (b.y - a.y); break;
      case 3: a.x |= 255, a.y |= 255, b.x |= 255, b.y |= 255, a.x -= 127, a.y -= 127, b.x -= 127, b.y -= 127; break;
      case 4:
        b = {a.x + static_cast<std::int32_t>(integer(-300, 300)), a.y + static_cast<std::int32_t>(integer(-300, 300))};
        break;
      default: break;
    }
    return {a, b};
  }
  line_aa_options options() {
    const int width =
        integer(0, 1) == 0 ? one : static_cast<int>(integer(1, integer(0, 3) == 0 ? irg::max_line_aa_width : 900));
    return {width, integer(0, 1) == 0 ? line_aa_caps::butt : line_aa_caps::square};
  }
};

TEST_CASE("line_aa: every pixel's coverage is its area, for random lines, widths and caps") {
  random_lines random{test::random(31)};
  const int trials = std::getenv("IRG_RELEASE_TIER") ? 1000000 : 700;
  real worst = 0;
  for (int i = 0; i < trials; ++i) {
    const auto [a, b] = random.line();
    const line_aa_options o = random.options();
    // a window around a point of the line, the whole line when it is short
    const int t = static_cast<int>(random.integer(0, 16)), x = (a.x + (b.x - a.x) / 16 * t) >> 8,
              y = (a.y + (b.y - a.y) / 16 * t) >> 8, r = i % 8 == 0 ? 30 : 9;
    auto got = covered(a, b, {x - r, y - r, x + r, y + r}, o);
    const auto shape = rectangle(a, b, o, 0, 0);
    int least = 0;
    for (int v = y - r; v < y + r; ++v)
      for (int u = x - r; u < x + r; ++u) {
        least = std::min(least, got.at(u, v));
        worst = std::max(worst, std::fabs(got.seen(u, v) - 255 * area_in_pixel(shape, u, v)));
      }
    REQUIRE(least >= -1);
    REQUIRE(worst <= allowed);
  }
  CHECK(worst > 0.49L);
  MESSAGE("greatest distance from 255 * area: " << static_cast<double>(worst));
}

TEST_CASE("line_aa: lines across the whole domain, seen through a small window") {
  random_lines random{test::random(32)};
  const int trials = std::getenv("IRG_RELEASE_TIER") ? 100000 : 500, limit = irg::snap_limit * one;
  for (int i = 0; i < trials; ++i) {
    const auto c = [&] {
      const std::int64_t bits = random.integer(10, 29), reach = std::int64_t{1} << bits;
      return static_cast<std::int32_t>(random.integer(-reach, reach));
    };
    subpixel a{c(), c()}, b{c(), c()};
    if (i % 7 == 0) b.y = a.y + static_cast<std::int32_t>(random.integer(-9, 9));
    if (i % 11 == 0) b.x = a.x + static_cast<std::int32_t>(random.integer(-9, 9));
    a.x = irg::clamped(a.x, -limit, limit), b.x = irg::clamped(b.x, -limit, limit);
    a.y = irg::clamped(a.y, -limit, limit), b.y = irg::clamped(b.y, -limit, limit);
    const line_aa_options o = random.options();
    const std::int64_t t = random.integer(0, 1 << 20);
    const int x = static_cast<int>((a.x + ((std::int64_t{b.x} - a.x) * t >> 20)) >> 8),
              y = static_cast<int>((a.y + ((std::int64_t{b.y} - a.y) * t >> 20)) >> 8);
    auto got = covered(a, b, {x - 5, y - 5, x + 5, y + 5}, o);
    const auto shape = rectangle(a, b, o, x, y);
    real worst = 0;
    for (int v = -5; v < 5; ++v)
      for (int u = -5; u < 5; ++u)
        worst = std::max(worst, std::fabs(got.seen(x + u, y + v) - 255 * area_in_pixel(shape, u, v)));
    REQUIRE(worst <= allowed);
  }
}

TEST_CASE("line_aa: ends at all distances up to the reach, seen beside (0, 0) and beside both ends") {
  random_lines random{test::random(33)};
  const int trials = std::getenv("IRG_RELEASE_TIER") ? 100000 : 1500;
  for (int i = 0; i < trials; ++i) {
    const double reach = std::exp2(21 * random.random.unit());
    auto [a, b] = test::nearly_level(random.random, reach);
    if (i % 2 == 0) a = test::place_within(random.random, reach), b = test::place_within(random.random, reach);
    if (i % 4 == 1) std::swap(a.x, a.y), std::swap(b.x, b.y);
    const line_aa_options o = random.options();
    for (const subpixel& at : {subpixel{0, 0}, a, b}) {
      const int x = at.x >> 8, y = at.y >> 8;
      auto got = covered(a, b, {x - 5, y - 4, x + 5, y + 4}, o);
      const auto shape = rectangle(a, b, o, x, y);
      real worst = 0;
      for (int v = -4; v < 4; ++v)
        for (int u = -5; u < 5; ++u)
          worst = std::max(worst, std::fabs(got.seen(x + u, y + v) - 255 * area_in_pixel(shape, u, v)));
      REQUIRE(worst <= allowed);
    }
  }
}

TEST_CASE("line_aa: coverages sum to length * width") {
  random_lines random{test::random(33)};
  for (int i = 0; i < 400; ++i) {
    const double t = random.random.unit() * 6.283185307179586, length = 20 + 60 * random.random.unit();
    const subpixel a{static_cast<int>(random.integer(-900, 900)), static_cast<int>(random.integer(-900, 900))},
        b{a.x + static_cast<int>(length * 256 * std::cos(t)), a.y + static_cast<int>(length * 256 * std::sin(t))};
    const line_aa_options o{static_cast<int>(random.integer(128, 2000)), line_aa_caps::butt};
    double sum = 0;
    for (const int c : covered(a, b, {-120, -120, 120, 120}, o).value) sum += c > 0 ? c : 0;
    const double exact = std::hypot(b.x - a.x, b.y - a.y) / 256 * o.width / 256;
    REQUIRE(std::fabs(sum / 255 - exact) < 0.01 * exact);
  }
}

// The same pixels after a transformation of the plane's whole pixels: m maps pixels, p points.
template <class Pixel, class Point>
bool maps(subpixel a, subpixel b, const line_aa_options& o, const cell_window& w, Pixel m, Point p, int tolerance = 0) {
  auto image = covered(a, b, w, o), mapped = covered(p(a), p(b), w, o);
  for (int y = w.y_first; y < w.y_last; ++y)
    for (int x = w.x_first; x < w.x_last; ++x) {
      const cell c = m(cell{x, y});
      if (std::abs(image.seen(x, y) - mapped.seen(c.x, c.y)) > tolerance) return false;
    }
  return true;
}

TEST_CASE("line_aa: mirrored and reversed lines have mirrored and the same pixels, to the last bit") {
  random_lines random{test::random(34)};
  const cell_window w{-60, -60, 60, 60};
  for (int i = 0; i < 400; ++i) {
    auto [a, b] = random.line();
    const auto shrunk = [](int v) { return v % (45 * one); };
    a = {shrunk(a.x), shrunk(a.y)}, b = {shrunk(b.x), shrunk(b.y)};
    const line_aa_options o = random.options();
    REQUIRE(
        maps(a, b, o, w, [](cell c) { return cell{-1 - c.x, c.y}; }, [](subpixel s) { return subpixel{-s.x, s.y}; }));
    REQUIRE(
        maps(a, b, o, w, [](cell c) { return cell{c.x, -1 - c.y}; }, [](subpixel s) { return subpixel{s.x, -s.y}; }));
    auto there = covered(a, b, w, o), back = covered(b, a, w, o);
    int different = 0;
    for (int y = w.y_first; y < w.y_last; ++y)
      for (int x = w.x_first; x < w.x_last; ++x) different += there.seen(x, y) != back.seen(x, y);
    REQUIRE(different == 0);
    // a change of the axes goes through other roundings
    REQUIRE(maps(a, b, o, w, [](cell c) { return cell{c.y, c.x}; }, [](subpixel s) { return subpixel{s.y, s.x}; }, 1));
  }
}

TEST_CASE("line_aa: lines that are their own half turn, where the row in the middle must be folded") {
  struct half_turn {
    subpixel a, b;
    line_aa_options options;
  };
  for (const half_turn& l : {half_turn{{5371, 5291}, {3333, 5717}, {256, line_aa_caps::square}},
                             half_turn{{5147, 5146}, {7141, 5350}, {615, line_aa_caps::butt}},
                             half_turn{{5276, 5303}, {4964, 5705}, {784, line_aa_caps::square}},
                             half_turn{{5151, 5135}, {6369, 5873}, {256, line_aa_caps::butt}}}) {
    const cell_window w{0, 0, 40, 40};
    auto there = covered(l.a, l.b, w, l.options), back = covered(l.b, l.a, w, l.options);
    for (int y = 0; y < 40; ++y)
      for (int x = 0; x < 40; ++x) CHECK(there.seen(x, y) == back.seen(x, y));
  }
}

TEST_CASE("line_aa: whole-pixel moves and windows change no coverage") {
  random_lines random{test::random(35)};
  const cell_window w{-40, -40, 40, 40};
  for (int i = 0; i < 600; ++i) {
    const auto [a, b] = random.line();
    const line_aa_options o = random.options();
    auto whole = covered(a, b, w, o);
    const int mx = static_cast<int>(random.integer(-900000, 900000)), my = static_cast<int>(random.integer(-999, 999));
    const auto moved = [&](subpixel s) { return subpixel{s.x + mx * one, s.y + my * one}; };
    auto there = covered(moved(a), moved(b), {w.x_first + mx, w.y_first + my, w.x_last + mx, w.y_last + my}, o);
    int different = 0;
    for (int y = -40; y < 40; ++y)
      for (int x = -40; x < 40; ++x) different += whole.seen(x, y) != there.seen(x + mx, y + my);
    REQUIRE(different == 0);
    const auto side = [&] { return static_cast<int>(random.integer(-40, 40)); };
    const cell_window small{side(), side(), side(), side()};
    coverages part(w);
    REQUIRE(irg::line_aa(a, b, small, part, o));
    for (int y = -40; y < 40; ++y)
      for (int x = -40; x < 40; ++x) {
        const bool in = x >= small.x_first && x < small.x_last && y >= small.y_first && y < small.y_last;
        different += part.at(x, y) != (in ? whole.at(x, y) : -1);
      }
    REQUIRE(different == 0);
  }
}

TEST_CASE("line_aa: the plain kernel and the lanes give the same coverages") {
  random_lines random{test::random(36)};
  const cell_window w{-70, -70, 70, 70};
  for (int i = 0; i < 800; ++i) {
    const auto [a, b] = random.line();
    const line_aa_options o = random.options();
    coverages plain(w);
    irg::detail::area_span_target<coverages> target{plain};
    irg::detail::aa_line<float>(a, b, o, w, target);
    REQUIRE(plain.value == covered(a, b, w, o).value);
  }
}

// One pixel wide, 2 to 40 pixels long: the lines that pictures are made of go a way of their own.
TEST_CASE("line_aa: short slender lines: areas, turned, reversed, x and y exchanged") {
  random_lines random{test::random(38)};
  const int trials = std::getenv("IRG_RELEASE_TIER") ? 200000 : 400;
  const cell_window w{-24, -24, 24, 24};
  real worst = 0;
  for (int i = 0; i < trials; ++i) {
    const auto c = [&] { return static_cast<std::int32_t>(random.integer(-(i % 20 + 1) * one, (i % 20 + 1) * one)); };
    subpixel a{c(), c()}, b{c(), c()};
    if (i % 3 == 0) a.x = (a.x | 255) - 127, a.y = (a.y | 255) - 127, b.x = (b.x | 255) - 127, b.y = (b.y | 255) - 127;
    const line_aa_options o{i % 4 == 0 ? static_cast<int>(random.integer(200, 400)) : one,
                            i % 5 == 0 ? line_aa_caps::square : line_aa_caps::butt};
    auto there = covered(a, b, w, o), back = covered(b, a, w, o);
    auto exchanged = covered({a.y, a.x}, {b.y, b.x}, w, o);
    const auto shape = rectangle(a, b, o, 0, 0);
    int different = 0, most = 0;
    for (int y = w.y_first; y < w.y_last; ++y)
      for (int x = w.x_first; x < w.x_last; ++x) {
        different += there.seen(x, y) != back.seen(x, y);
        most = std::max(most, std::abs(there.seen(x, y) - exchanged.seen(y, x)));
        if (there.seen(x, y) != 0 || (x + y + i) % 16 == 0)
          worst = std::max(worst, std::fabs(there.seen(x, y) - 255 * area_in_pixel(shape, x, y)));
      }
    REQUIRE(different == 0);
    REQUIRE(most <= 1);
    REQUIRE(worst <= allowed);
  }
}

constexpr std::uint64_t hash_of(subpixel a, subpixel b, line_aa_options o) {
  std::uint64_t h = 1469598103934665603u;
  irg::line_aa(
      a, b, {-6, -6, 14, 14},
      [&](const irg::coverage_span& s) {
        for (int x = s.x_first; x < s.x_last; ++x)
          h = (h ^ static_cast<std::uint64_t>((s.y * 64 + x) * 256 + s.coverage[x - s.x_first])) * 1099511628211u;
      },
      o);
  return h;
}

template <int Ax, int Ay, int Bx, int By, int Width, line_aa_caps Caps>
void same_when_compiled() {
  constexpr std::uint64_t in_advance = hash_of({Ax, Ay}, {Bx, By}, {Width, Caps});
  CHECK(hash_of({Ax, Ay}, {Bx, By}, {Width, Caps}) == in_advance);
}

TEST_CASE("line_aa: constant evaluation gives the same coverages") {
  same_when_compiled<0, 0, 300, 2100, 256, line_aa_caps::butt>();
  same_when_compiled<37, 2011, 1411, 100, 256, line_aa_caps::square>();
  same_when_compiled<128, 128, 128 + 2560, 128 + 768, 256, line_aa_caps::butt>();
  same_when_compiled<5, 9, 1900, 1200, 900, line_aa_caps::butt>();
  same_when_compiled<5, 9, 5, 1200, 300, line_aa_caps::butt>();
  same_when_compiled<-300000, 9, 500000, 1200, 256, line_aa_caps::butt>();
}

constexpr int at(subpixel a, subpixel b, cell pixel, line_aa_options o = {}) {
  int value = 0;
  irg::line_aa(
      a, b, {pixel.x, pixel.y, pixel.x + 1, pixel.y + 1}, [&](const irg::coverage_span& s) { value = s.coverage[0]; },
      o);
  return value;
}

TEST_CASE("line_aa: by hand") {
  CHECK_BOTH(at({0, 128}, {1024, 128}, {2, 0}) == 255);  // one pixel wide, on the centres
  CHECK_BOTH(at({0, 256}, {1024, 256}, {2, 0}) == 128);  // between two rows: half each, halves round up
  CHECK_BOTH(at({0, 256}, {1024, 256}, {2, 1}) == 128);
  CHECK_BOTH(at({64, 128}, {1024, 128}, {0, 0}) == 191);  // three quarters
  CHECK_BOTH(at({64, 128}, {1024, 128}, {0, 0}, {256, line_aa_caps::square}) == 255);
  CHECK_BOTH(at({0, 0}, {2560, 2560}, {4, 4}) == 233);  // 45 degrees: 1 - (1 - sqrt(1/2))^2 = 0.91421
  CHECK_BOTH(at({128, 128}, {128, 128}, {0, 0}) == 0);
  CHECK_BOTH(at({128, 128}, {128, 128}, {0, 0}, {256, line_aa_caps::square}) == 255);
  CHECK_BOTH(at({128, 128}, {128, 128}, {1, 0}, {512, line_aa_caps::square}) == 128);
}

TEST_CASE("line_aa: degenerate and hostile input") {
  constexpr auto calls = [](subpixel a, subpixel b, cell_window w, line_aa_options o = {}) {
    int n = 0;
    const bool drawn = irg::line_aa(a, b, w, [&](const irg::coverage_span&) { ++n; }, o);
    return drawn ? n : -1;
  };
  CHECK_BOTH(calls({5, 5}, {5, 5}, {0, 0, 4, 4}) == 0);
  CHECK_BOTH(calls({0, 0}, {900, 700}, {2, 2, 2, 9}) == 0);
  CHECK_BOTH(calls({0, 0}, {900, 700}, {3, 3, 1, 1}) == 0);
  CHECK_BOTH(calls({0, 0}, {900, 700}, {0, 0, 4, 4}, {0, line_aa_caps::butt}) == -1);
  CHECK_BOTH(calls({0, 0}, {900, 700}, {0, 0, 4, 4}, {-1, line_aa_caps::butt}) == -1);
  CHECK_BOTH(calls({0, 0}, {900, 700}, {0, 0, 4, 4}, {irg::max_line_aa_width + 1, line_aa_caps::butt}) == -1);
  constexpr int least = std::numeric_limits<int>::min(), most = std::numeric_limits<int>::max();
  CHECK_BOTH(calls({least, 0}, {900, 700}, {0, 0, 4, 4}) == -1);
  CHECK_BOTH(calls({0, 0}, {900, irg::snap_limit * one + 1}, {0, 0, 4, 4}) == -1);
  constexpr int far = irg::snap_limit * one;
  CHECK_BOTH(calls({-far, -far}, {far, far}, {0, 0, 4, 4}) >= 4);
  CHECK_BOTH(calls({-far, -far}, {far, far - 1}, {least, least, most, least + 4}) == 0);
  CHECK(calls({0, 0}, {900, 700}, {least, least, most, most}) > 0);
}

// Any raster, any window: what draw_line_aa writes is what the sink form says, and nothing else is touched.
TEST_CASE("draw_line_aa: the sink form's coverages, mixed, and no byte outside the window") {
  random_lines random{test::random(37)};
  for (int i = 0; i < 2500; ++i) {
    auto [a, b] = random.line();
    const int mx = static_cast<int>(random.integer(0, 40)) * one, my = static_cast<int>(random.integer(0, 30)) * one;
    a.x += mx, b.x += mx, a.y += my, b.y += my;
    const line_aa_options o = random.options();
    const int width = static_cast<int>(random.integer(0, 40)), height = static_cast<int>(random.integer(0, 30));
    std::vector<irg::rgba8> memory(48 * 32, irg::rgba8{});
    for (irg::rgba8& p : memory) {
      const auto bits = static_cast<std::uint32_t>(random.integer(0, 0xffffffff));
      p = {static_cast<std::uint8_t>(bits), static_cast<std::uint8_t>(bits >> 8), static_cast<std::uint8_t>(bits >> 16),
           static_cast<std::uint8_t>(bits >> 24)};
    }
    std::vector<irg::rgba8> expected = memory;
    const irg::image_view<irg::rgba8> view(memory.data() + 48 + 3, width, height, 48 * 4),
        by_hand(expected.data() + 48 + 3, width, height, 48 * 4);
    const irg::rgba8 colour{static_cast<std::uint8_t>(random.integer(0, 255)), 200, 30, 255};
    const auto side = [&] { return static_cast<int>(random.integer(-2, 42)); };
    const cell_window w = i % 2 == 0 ? irg::window_of(view) : cell_window{side(), side(), side(), side()};
    REQUIRE(irg::draw_line_aa(irg::within(view, w), a, b, colour, o));
    REQUIRE(irg::line_aa(
        a, b, irg::intersect(w, irg::window_of(by_hand)),
        [&](const irg::coverage_span& s) {
          for (int x = s.x_first; x < s.x_last; ++x)
            irg::paint_pixel(by_hand, x, s.y, colour, s.coverage[x - s.x_first]);
        },
        o));
    REQUIRE(memory == expected);
  }
}

// Between the caps of a wide line that the raster holds, what is covered whole is filled.
TEST_CASE("draw_line_aa: wide lines, whose filled columns are those of coverage 255") {
  test::random random{39};
  const cell_window w{0, 0, 330, 300};
  int whole = 0;
  for (int i = 0; i < 150; ++i) {
    const auto c = [&](int most) { return static_cast<std::int32_t>(random.integer(80 * one, most * one)); };
    const subpixel a{c(250), c(220)}, b{c(250), c(220)};
    const line_aa_options o{static_cast<int>(random.integer(6 * one, i % 3 == 0 ? irg::max_line_aa_width : 30 * one)),
                            i % 5 == 0 ? line_aa_caps::square : line_aa_caps::butt};
    irg::image<irg::rgba8> drawn(330, 300, {0, 0, 0, 0});
    REQUIRE(irg::draw_line_aa(drawn, a, b, irg::rgba8{255, 255, 255, 255}, o));
    auto expected = covered(a, b, w, o);
    int different = 0;
    for (int y = 0; y < 300; ++y)
      for (int x = 0; x < 330; ++x) {
        different += drawn(x, y).g != expected.seen(x, y);
        whole += expected.seen(x, y) == 255;
      }
    REQUIRE(different == 0);
  }
  CHECK(whole > 100000);
}

constexpr irg::image<irg::rgba8> drawn() {
  irg::image<irg::rgba8> picture(6, 4, {0, 0, 0, 255});
  irg::draw_line_aa(picture, cell{0, 0}, cell{5, 3}, {255, 255, 255, 255});
  return picture;
}

TEST_CASE("draw_line_aa: cells, functions, other pixel types, NaN") {
  static_assert(drawn()(3, 2).r > 100 && drawn()(5, 0).r == 0);
  constexpr int in_advance = drawn()(2, 1).r;
  CHECK(drawn()(2, 1).r == in_advance);
  auto turned = drawn();
  for (int y = 0; y < 4; ++y)
    for (int x = 0; x < 6; ++x) CHECK(turned(x, y) == turned(5 - x, 3 - y));  // centre to centre: its own half turn

  irg::image<int> counts(16, 16, 0);
  CHECK(irg::draw_line_aa(counts, cell{2, 3}, cell{12, 9}, [](int there, std::uint8_t c) { return there + c; }));
  int sum = 0;
  for (int y = 0; y < 16; ++y)
    for (int x = 0; x < 16; ++x) sum += counts(x, y);
  CHECK(std::fabs(sum / 255.0 - std::sqrt(136.0)) < 0.1);
  irg::image<float> light(8, 8, 0.0f);
  CHECK(irg::draw_line_aa(light, cell{0, 2}, cell{7, 2}, 2.0f));
  CHECK(light(3, 2) == 2.0f);
  irg::image<irg::bgra8> other(8, 8);
  CHECK(irg::draw_line_aa(other, cell{0, 2}, cell{7, 2}, irg::bgra8{1, 2, 3, 4}));
  CHECK(other(3, 2) == irg::bgra8{1, 2, 3, 4});

  const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  auto before = drawn();
  using point = irg::point<double, 2>;
  const irg::rgba8 red{255, 0, 0, 255};
  for (const double bad : {nan, infinity, -infinity}) {
    CHECK(!irg::draw_line_aa(before, point{bad, 0}, point{3, 3}, red));
    CHECK(!irg::draw_line_aa(before, point{0, bad}, point{3, 3}, red));
    CHECK(!irg::draw_line_aa(before, point{0, 0}, point{bad, 3}, red));
    CHECK(!irg::draw_line_aa(before, point{0, 0}, point{3, bad}, red));
  }
  CHECK(before == drawn());
  CHECK(irg::draw_line_aa(before, point{0, 0.5}, point{3, 0.5}, red));
  CHECK(before(1, 0) == red);
}

// The coverages of a line.
template <class P>
constexpr irg::image<int> coverages_between(const P& a, const P& b, const line_aa_options& options = {}) {
  irg::image<int> picture(24, 16, 0);
  if (!irg::draw_line_aa(picture, a, b, [](int, std::uint8_t c) -> int { return c; }, options)) picture(0, 0) = -1;
  return picture;
}

TEST_CASE("draw_line_aa: ends beyond the reach") {
  using point = irg::point<double, 2>;
  static_assert(coverages_between(cell{0, 2}, cell{1'000'000'000, 2})(23, 2) == 255);
  static_assert(coverages_between(point{-1e300, 3.5}, point{1e300, 3.5})(12, 3) == 255);
  static_assert(coverages_between(point{1e300, 1e300}, point{2e300, 1e299}) == irg::image<int>(24, 16, 0));
  constexpr int least = std::numeric_limits<int>::min(), greatest = std::numeric_limits<int>::max();
  const auto diagonal = coverages_between(cell{least, least}, cell{greatest, greatest});
  CHECK(diagonal == coverages_between(cell{-1000, -1000}, cell{1000, 1000}));

  // The same line drawn to an end within the reach: that one is not cut.
  test::random random{24};
  const auto whole = [&](int low, int high) { return static_cast<int>(random.integer(low, high)); };
  int far = 0;
  for (int i = 0; i < 2000; ++i) {
    const point a{whole(-512, 6656) / 256.0, whole(-512, 4608) / 256.0};
    const double dx = whole(-200, 200), dy = whole(-200, 200);
    const double near_scale = 1 << 12, far_scale = std::ldexp(1.0, whole(14, 1000));
    const auto end = [&](double scale) { return point{a[0] + dx * scale, a[1] + dy * scale}; };
    const line_aa_options options{.width = whole(64, 1024)};
    const auto expected = coverages_between(a, end(near_scale), options),
               got = coverages_between(a, end(far_scale), options);
    // Adding the start to so distant an end rounds: half an ulp of the end seen from the start is far less than 1/512.
    for (int y = 0; y < 16; ++y)
      for (int x = 0; x < 24; ++x) REQUIRE(std::abs(got(x, y) - expected(x, y)) <= 2);
    far += !irg::can_snap(end(far_scale));
  }
  CHECK(far > 1000);
}

TEST_CASE("draw_line_aa: ends in braces are in pixels") {
  irg::image<std::uint8_t> braces(9, 5, 0), points(9, 5, 0);
  CHECK(irg::draw_line_aa(braces, {1.5, 2}, {7, 3}, std::uint8_t{255}));
  CHECK(irg::draw_line_aa(points, irg::point<double, 2>{1.5, 2}, irg::point<double, 2>{7, 3}, std::uint8_t{255}));
  CHECK(braces == points);
}

}  // namespace
