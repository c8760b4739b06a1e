// SPDX-License-Identifier: MIT
#include <irg/raster/line_subpixel.hpp>

#include <cstdlib>
#include <limits>
#include <utility>
#include <vector>

#include <irg/raster/image.hpp>
#include <irg/raster/line_bresenham.hpp>

#include "support/check_both.hpp"
#include "support/framed_raster.hpp"
#include "support/line_oracle.hpp"
#include "support/line_properties.hpp"
#include "support/random.hpp"

namespace {

using irg::cell;
using irg::cell_window;
using irg::subpixel;
__extension__ typedef __int128 wide;
constexpr cell_window everything{-(1 << 22), -(1 << 22), 1 << 22, 1 << 22};
constexpr irg::line_subpixel_options diamond{.rule = irg::line_rule::diamond_exit};

constexpr std::vector<cell> cells(subpixel a, subpixel b, irg::line_subpixel_options o = {},
                                  cell_window w = everything) {
  std::vector<cell> out;
  irg::line_subpixel(a, b, w, [&](cell c) { out.push_back(c); }, o);
  return out;
}

bool holds(const cell_window& w, cell c) {
  return c.x >= w.x_first && c.x < w.x_last && c.y >= w.y_first && c.y < w.y_last;
}

// The rule "nearest" cell by cell: is the centre's column (row) between the ends, and is the distance aside less than
// half a pixel, or exactly that and on the side that ties go to?
bool oracle_nearest(subpixel a, subpixel b, cell c, irg::line_subpixel_options o) {
  std::int64_t ax = a.x, ay = a.y, bx = b.x, by = b.y, x = c.x * 256 + 128, y = c.y * 256 + 128;
  const bool steep = std::abs(by - ay) >= std::abs(bx - ax);
  if (steep) std::swap(ax, ay), std::swap(bx, by), std::swap(x, y);
  if (ax == bx) return x == ax && o.ends == irg::line_ends::closed && y - ay <= 128 && y - ay > -128;
  if (x < std::min(ax, bx) || x > std::max(ax, bx)) return false;
  if (x == bx && o.ends == irg::line_ends::half_open) return false;
  const std::int64_t dx = std::abs(bx - ax), s = bx < ax ? -1 : 1;
  const wide off = wide{y - ay} * dx - wide{x - ax} * s * (by - ay);  // (centre - line) * dx, downwards
  if (off == wide{128} * dx || off == -wide{128} * dx) {
    const bool below = off > 0;  // the centre is half a pixel below the line
    if (by == ay) return below;
    const bool starts_above = o.ties == irg::line_ties::symmetric ? (by > ay) == (bx > ax) : by > ay;
    return below != starts_above;
  }
  return off < wide{128} * dx && off > -wide{128} * dx;
}

// The rule "diamond exit" word for word, with e = 2^-16: of all differences that decide at these sizes none is as
// small. Coordinates become multiples of 2^-32 / 256.
bool oracle_diamond(subpixel a, subpixel b, cell c) {
  struct place {
    wide x, y;
  };
  const auto moved = [&](subpixel p) {
    return place{(wide{p.x} - c.x * 256 - 128) * (wide{1} << 32) - (wide{1} << 16),
                 (wide{p.y} - c.y * 256 - 128) * (wide{1} << 32) - 1};
  };
  const place p = moved(a), q = moved(b);
  const wide half = wide{128} << 32;
  const auto size = [](wide v) { return v < 0 ? -v : v; };
  if (size(q.x) + size(q.y) < half) return false;  // the end is inside: the diamond is not left
  // The segment meets the open diamond when the stretches on which it is inside of the four sides have a common point.
  wide low_n = 0, low_d = 1, high_n = 1, high_d = 1;
  for (const int sx : {-1, 1})
    for (const int sy : {-1, 1}) {
      const wide f = sx * p.x + sy * p.y - half, g = sx * q.x + sy * q.y - half;  // negative inside
      if (f >= 0 && g >= 0) return false;
      if (f < 0 && g < 0) continue;
      // t = f / (f - g)
      wide n = f, d = f - g;
      if (d < 0) n = -n, d = -d;
      if (f < 0 ? n * high_d < high_n * d : n * low_d > low_n * d)
        (f < 0 ? high_n : low_n) = n, (f < 0 ? high_d : low_d) = d;
    }
  return low_n * high_d < high_n * low_d;
}

TEST_CASE("line_subpixel: by hand") {
  // From the middle of pixel (0, 0) to the middle of pixel (4, 2), the cells of the line between the cells
  CHECK_BOTH(cells({128, 128}, {4 * 256 + 128, 2 * 256 + 128}) ==
             std::vector<cell>{{0, 0}, {1, 0}, {2, 1}, {3, 1}, {4, 2}});
  CHECK_BOTH(cells({129, 128}, {4 * 256 + 127, 128}) == std::vector<cell>{{1, 0}, {2, 0}, {3, 0}});
  CHECK_BOTH(cells({0, 256}, {512, 256}) == std::vector<cell>{{0, 1}, {1, 1}});  // level, on the border of two rows
  CHECK_BOTH(cells({512, 256}, {0, 256}) == std::vector<cell>{{1, 1}, {0, 1}});
  CHECK_BOTH(cells({129, 0}, {383, 9}).empty());  // no centre between the ends
  CHECK_BOTH(cells({128, 128}, {128, 128}) == std::vector<cell>{{0, 0}});
  CHECK_BOTH(cells({128, 129}, {128, 129}).empty());
  CHECK_BOTH(cells({128, 128}, {128, 128}, {.ends = irg::line_ends::half_open}).empty());
}

TEST_CASE("line_subpixel: the diamond's borders, by hand") {
  CHECK_BOTH(cells({128, 128}, {4 * 256 + 128, 128}, diamond) == std::vector<cell>{{0, 0}, {1, 0}, {2, 0}, {3, 0}});
  CHECK_BOTH(cells({128, 128}, {128, 128}, diamond).empty());
  CHECK_BOTH(cells({128, 128}, {256, 128}, diamond).empty());  // the right corner belongs to the diamond
  CHECK_BOTH(cells({128, 128}, {257, 128}, diamond) == std::vector<cell>{{0, 0}});
  CHECK_BOTH(cells({128, 128}, {0, 128}, diamond) == std::vector<cell>{{0, 0}});  // the left one does not
  CHECK_BOTH(cells({128, 128}, {128, 256}, diamond) == std::vector<cell>{{0, 0}});  // nor do the lower
  CHECK_BOTH(cells({128, 128}, {128, 0}, diamond) == std::vector<cell>{{0, 0}});  // and the upper one
  CHECK_BOTH(cells({128, 128}, {192, 192}, diamond).empty());  // the right sides do, the left ones do not
  CHECK_BOTH(cells({128, 128}, {64, 64}, diamond) == std::vector<cell>{{0, 0}});
  CHECK_BOTH(cells({0, 256}, {512, 256}, diamond) == std::vector<cell>{{0, 0}, {1, 0}});  // through lower corners
  CHECK_BOTH(cells({256, 0}, {256, 512}, diamond) == std::vector<cell>{{0, 0}, {0, 1}});  // through right corners
}

TEST_CASE("line_subpixel: ends on centres give the cells of line_bresenham, all ends in 15 x 15, all options") {
  using irg::line_ends;
  using irg::line_ties;
  for (const line_ends ends : {line_ends::closed, line_ends::half_open})
    for (const line_ties ties : {line_ties::start_side, line_ties::symmetric})
      for (int x = -7; x <= 7; ++x)
        for (int y = -7; y <= 7; ++y) {
          std::vector<cell> expected;
          irg::line_bresenham({1, -2}, {x, y}, everything, [&](cell c) { expected.push_back(c); }, {ends, ties});
          REQUIRE(cells({256 + 128, -512 + 128}, {x * 256 + 128, y * 256 + 128}, {.ends = ends, .ties = ties}) ==
                  expected);
        }
}

// A coordinate that often lies on a centre, a border or a quarter.
std::int32_t coordinate(test::random& r, int low, int high) {
  constexpr int steps[] = {128, 64, 32, 1};
  const int step = steps[r.integer(0, 3)];
  return static_cast<std::int32_t>(r.integer(low * 256 / step, high * 256 / step)) * step;
}

// Lines from centre to centre; those that reach farther than subpixel does are left to line_bresenham.
template <class Emit>
bool centre_to_centre(cell a, cell b, const cell_window& w, const irg::line_options& options, Emit&& emit) {
  const auto near = [](cell c) {
    return c.x >= -irg::snap_limit && c.x < irg::snap_limit && c.y >= -irg::snap_limit && c.y < irg::snap_limit;
  };
  if (!near(a) || !near(b)) {
    irg::line_bresenham(a, b, w, emit, options);
    return false;
  }
  irg::line_subpixel(subpixel{a.x * 256 + 128, a.y * 256 + 128}, subpixel{b.x * 256 + 128, b.y * 256 + 128}, w, emit,
                     {.ends = options.ends, .ties = options.ties});
  return true;
}

TEST_CASE("line_subpixel: from centre to centre, as for whole cells: random lines and a lattice") {
  long drawn = 0;
  test::check_window_line([&](cell a, cell b, const cell_window& w, const irg::line_options& options, auto&& emit) {
    drawn += centre_to_centre(a, b, w, options, emit);
  });
  CHECK(drawn > 700000);
}

TEST_CASE("line_subpixel: the criteria of a good raster line, from centre to centre") {
  for (const irg::line_options& options : test::all_line_options)
    test::check_line_criteria(
        [&](cell a, cell b) {
          std::vector<cell> line;
          centre_to_centre(a, b, everything, options, [&](cell c) { line.push_back(c); });
          return line;
        },
        options.ends);
}

TEST_CASE("line_subpixel: against both definitions, every pixel of the box, random windows") {
  test::random r(41);
  const int trials = std::getenv("IRG_RELEASE_TIER") ? 1000000 : 6000;
  long drawn = 0;
  for (int i = 0; i < trials; ++i) {
    const subpixel a{coordinate(r, -2, 8), coordinate(r, -2, 8)}, b{coordinate(r, -2, 8), coordinate(r, -2, 8)};
    const auto edge = [&] { return static_cast<int>(r.integer(-4, 10)); };
    const int x0 = edge(), y0 = edge();
    const cell_window w = i % 2 ? cell_window{x0, y0, edge(), edge()} : cell_window{-5, -5, 11, 11};
    const irg::line_subpixel_options options[] = {
        {},
        {.ends = irg::line_ends::half_open},
        {.ties = irg::line_ties::symmetric},
        {.ends = irg::line_ends::half_open, .ties = irg::line_ties::symmetric},
        diamond};
    for (const auto& o : options) {
      int seen[16][16] = {};
      cell last{};
      bool first = true, in_order = true;
      const bool steep = std::abs(b.y - a.y) >= std::abs(b.x - a.x);
      for (const cell c : cells(a, b, o, w)) {
        REQUIRE(holds(w, c));
        ++seen[c.y + 5][c.x + 5];
        const int step = steep ? (c.y - last.y) * (b.y < a.y ? -1 : 1) : (c.x - last.x) * (b.x < a.x ? -1 : 1);
        in_order &= first || (step == 1 && std::abs(steep ? c.x - last.x : c.y - last.y) <= 1);
        last = c;
        first = false;
        ++drawn;
      }
      REQUIRE(in_order);  // one cell per step, 8-connected, from a to b
      bool same = true;
      for (int y = -5; y < 11; ++y)
        for (int x = -5; x < 11; ++x) {
          const bool expected =
              holds(w, {x, y}) &&
              (o.rule == irg::line_rule::diamond_exit ? oracle_diamond(a, b, {x, y}) : oracle_nearest(a, b, {x, y}, o));
          same &= seen[y + 5][x + 5] == (expected ? 1 : 0);
        }
      REQUIRE_MESSAGE(same, "(", a.x, ",", a.y, ")-(", b.x, ",", b.y, ") rule ", static_cast<int>(o.rule));
    }
  }
  CHECK(drawn > trials);
}

TEST_CASE("line_subpixel: a line cut at points of it draws the same pixels, each once, with diamond_exit") {
  test::random r(42);
  for (int i = 0; i < 3000; ++i) {
    // Pieces of one direction: b = a + n * d
    const subpixel a{coordinate(r, 0, 6), coordinate(r, 0, 6)};
    const int n = static_cast<int>(r.integer(2, 9)), dx = static_cast<int>(r.integer(-300, 300)),
              dy = static_cast<int>(r.integer(-300, 300));
    std::vector<cell> pieces, halves;
    for (int k = 0; k < n; ++k) {
      const subpixel p{a.x + k * dx, a.y + k * dy}, q{a.x + (k + 1) * dx, a.y + (k + 1) * dy};
      for (const cell c : cells(p, q, diamond)) pieces.push_back(c);
      for (const cell c : cells(p, q, {.ends = irg::line_ends::half_open, .ties = irg::line_ties::symmetric}))
        halves.push_back(c);
    }
    const subpixel b{a.x + n * dx, a.y + n * dy};
    REQUIRE(pieces == cells(a, b, diamond));
    REQUIRE(halves == cells(a, b, {.ends = irg::line_ends::half_open, .ties = irg::line_ties::symmetric}));
  }
}

TEST_CASE("line_subpixel: polylines that always go to the right draw each column once, joins included") {
  test::random r(43);
  for (int i = 0; i < 2000; ++i) {
    subpixel p{coordinate(r, 0, 2), coordinate(r, 0, 2)};
    std::vector<cell> drawn;
    for (int k = 0; k < 8; ++k) {
      const auto dx = static_cast<int>(r.integer(1, 500)), dy = static_cast<int>(r.integer(-dx + 1, dx - 1));
      const subpixel q{p.x + dx, p.y + dy};
      for (const cell c : cells(p, q, diamond)) drawn.push_back(c);
      p = q;
    }
    for (std::size_t k = 1; k < drawn.size(); ++k) {
      REQUIRE(drawn[k].x == drawn[k - 1].x + 1);
      REQUIRE(std::abs(drawn[k].y - drawn[k - 1].y) <= 1);
    }
  }
}

TEST_CASE("line_subpixel: symmetric lines have the same cells both ways") {
  test::random r(44);
  for (int i = 0; i < 2000; ++i) {
    const subpixel a{coordinate(r, -3, 9), coordinate(r, -3, 9)}, b{coordinate(r, -3, 9), coordinate(r, -3, 9)};
    const irg::line_subpixel_options o{.ties = irg::line_ties::symmetric};
    const auto there = cells(a, b, o), back = cells(b, a, o);
    REQUIRE(there == std::vector<cell>(back.rbegin(), back.rend()));
  }
}

TEST_CASE("line_subpixel: ends at the limit, clipped to a small window") {
  constexpr int far = irg::snap_limit * 256;
  constexpr cell_window w{0, 0, 64, 64};
  CHECK_BOTH(cells({-far, -far}, {far, far}, {}, w).size() == 64);
  CHECK_BOTH(cells({-far, -far}, {far, far}, diamond, w).size() == 64);
  CHECK_BOTH(cells({far, 128}, {-far, 128}, {}, w).size() == 64);
  CHECK_BOTH(cells({128, -far}, {128, far}, diamond, w).size() == 64);
  CHECK_BOTH(cells({-far, far}, {far, -far}, {}, w).empty());  // it passes the corner
  CHECK_BOTH(cells({-far, 0}, {far, 64 * 256}, {}, w).size() == 64);
  test::random r(45);
  long crossing = 0;
  for (int i = 0; i < 20000; ++i) {
    const auto any = [&] { return static_cast<std::int32_t>(r.integer(-far, far)); };
    const subpixel a{any(), any()}, b{any(), any()};
    // a window around the line's middle
    const int x = (a.x + b.x) / 512, y = (a.y + b.y) / 512;
    const cell_window near{x - 5, y - 5, x + 5, y + 5};
    std::vector<cell> expected;
    for (int cy = near.y_first; cy < near.y_last; ++cy)
      for (int cx = near.x_first; cx < near.x_last; ++cx)
        if (oracle_nearest(a, b, {cx, cy}, {})) expected.push_back({cx, cy});
    const auto line = cells(a, b, {}, near);
    REQUIRE(line.size() == expected.size());
    for (const cell c : line) REQUIRE(oracle_nearest(a, b, c, {}));
    crossing += line.size() > 3;
  }
  CHECK(crossing > 15000);
}

TEST_CASE("line_subpixel: empty and inverted windows") {
  CHECK_BOTH(cells({0, 0}, {2560, 2560}, {}, {3, 3, 3, 9}).empty());
  CHECK_BOTH(cells({0, 0}, {2560, 2560}, {}, {5, 5, 2, 2}).empty());
  CHECK_BOTH(cells({0, 0}, {2560, 2560}, diamond, {5, 5, 6, 6}) == std::vector<cell>{{5, 5}});
  CHECK_BOTH(cells({-1024, 640}, {640, -1024}, {}, {0, 0, 4, 4}).empty());  // the boxes overlap, the line misses
}

TEST_CASE("line_subpixel: ends in pixels, refused when they are no positions") {
  using point = irg::point<double, 2>;
  int calls = 0;
  const auto count = [&](cell) { ++calls; };
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  for (const double bad : {nan, inf, -inf, 2097152.5, -1e30}) {
    CHECK(!irg::line_subpixel(point{bad, 1}, point{2, 3}, everything, count));
    CHECK(!irg::line_subpixel(point{1, bad}, point{2, 3}, everything, count));
    CHECK(!irg::line_subpixel(point{1, 1}, point{bad, 3}, everything, count));
    CHECK(!irg::line_subpixel(point{1, 1}, point{2, bad}, everything, count));
  }
  CHECK(calls == 0);
  CHECK(irg::line_subpixel(irg::point<float, 2>{0.5f, 0.5f}, irg::point<float, 2>{9.5f, 0.5f}, everything, count));
  CHECK(calls == 10);
}

TEST_CASE("draw_line_subpixel: paints those pixels, by value or by function, and nothing else") {
  constexpr auto sum = [] {
    irg::image<int> image(5, 3);
    irg::draw_line_subpixel(image, subpixel{-512, 128}, {1152, 640}, 1);
    irg::draw_line_subpixel(irg::within(image, {0, -9, 1, 9}), subpixel{-512, 128}, {1152, 640},
                            [](int there) { return there + 2; });
    irg::draw_line_subpixel(image, irg::point<float, 2>{4.5f, 0.0f}, irg::point<float, 2>{4.5f, 1.0f}, 7);
    int n = 0;
    for (int y = 0; y < 3; ++y)
      for (int x = 0; x < 5; ++x) n = n * 8 % 1000003 + image(x, y);
    return n;
  };
  CHECK_BOTH(sum() == [] {
    const int rows[15] = {0, 0, 0, 0, 7, 3, 1, 1, 0, 0, 0, 0, 0, 1, 1};
    int n = 0;
    for (const int p : rows) n = n * 8 % 1000003 + p;
    return n;
  }());
  // a view whose rows have gaps
  test::framed_raster<std::uint8_t> framed;
  auto& view = framed.view;
  irg::draw_line_subpixel(view, subpixel{-9999, -7777}, {9999, 8888}, std::uint8_t{1});
  irg::draw_line_subpixel(irg::within(view, {-100, -100, 100, 100}), irg::point<double, 2>{-50, 40},
                          irg::point<double, 2>{50, -30}, std::uint8_t{1});
  CHECK(framed.frame_is_whole());
  CHECK(framed.painted() > 10);
}

}  // namespace
