// SPDX-License-Identifier: MIT
#include <irg/raster/line_thick.hpp>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <limits>
#include <vector>

#include <irg/raster/image.hpp>

#include "support/check_both.hpp"
#include "support/framed_raster.hpp"
#include "support/random.hpp"

namespace {

using irg::cell;
using irg::cell_window;
using irg::line_caps;
using irg::line_pen;
using irg::span_of_cells;
using irg::subpixel;
__extension__ typedef __int128 wide;
constexpr int least = std::numeric_limits<int>::min(), most = std::numeric_limits<int>::max();
constexpr line_caps all_caps[] = {line_caps::butt, line_caps::square, line_caps::round};

template <class P>
constexpr std::vector<span_of_cells> spans(P a, P b, line_pen pen, cell_window w = {-64, -64, 64, 64}) {
  std::vector<span_of_cells> out;
  irg::line_thick(a, b, pen, w, [&](span_of_cells s) { out.push_back(s); });
  return out;
}

template <class P>
constexpr long pixels(P a, P b, line_pen pen, cell_window w = {-64, -64, 64, 64}) {
  long n = 0;
  irg::line_thick(a, b, pen, w, [&](span_of_cells s) { n += s.x_last - s.x_first; });
  return n;
}

// On an edge with the outward normal (nx, ny).
bool owns(wide nx, wide ny) { return nx < 0 || (nx == 0 && ny < 0); }

// Whether v <= half of sqrt(square), equality counting if `closed`: by squares, not by roots.
bool at_most_half_root(wide v, wide square, bool closed) {
  return v < 0 || 4 * v * v < square || (4 * v * v == square && closed);
}

bool in_disc(subpixel c, wide w, wide x, wide y) {
  const wide s = 4 * ((x - c.x) * (x - c.x) + (y - c.y) * (y - c.y));
  return s < w * w || (s == w * w && x < c.x);
}

bool in_rectangle(subpixel a, subpixel b, wide w, bool square_start, bool square_end, wide x, wide y) {
  wide dx = b.x - a.x, dy = b.y - a.y, length = dx * dx + dy * dy;
  if (length == 0) dx = 1;
  const wide square = w * w * (dx * dx + dy * dy), across = (x - a.x) * dy - (y - a.y) * dx,
             along = (x - a.x) * dx + (y - a.y) * dy;
  return at_most_half_root(across, square, owns(dy, -dx)) && at_most_half_root(-across, square, owns(-dy, dx)) &&
         at_most_half_root(-along, square_start ? square : 0, owns(-dx, -dy)) &&
         at_most_half_root(along - length, square_end ? square : 0, owns(dx, dy));
}

// The definition at one pixel.
bool oracle(subpixel a, subpixel b, std::int32_t width, line_caps start, line_caps end, int px, int py) {
  const wide x = px * 256 + 128, y = py * 256 + 128, w = width;
  if (w <= 0) return false;
  if ((start == line_caps::round && in_disc(a, w, x, y)) || (end == line_caps::round && in_disc(b, w, x, y)))
    return true;
  if (a == b && start != line_caps::square) return false;
  return in_rectangle(a, b, w, start == line_caps::square, end == line_caps::square, x, y);
}

// A coordinate that often lies on a centre or a border.
std::int32_t coordinate(test::random& r, int low, int high) {
  constexpr int steps[] = {128, 64, 16, 1};
  const int step = steps[r.integer(0, 3)];
  return static_cast<std::int32_t>(r.integer(low * 256 / step, high * 256 / step)) * step;
}

TEST_CASE("floor_sqrt: both widths, at squares and beside them") {
  using irg::uint128;
  using irg::detail::floor_sqrt;
  using irg::detail::floor_sqrt_wide;
  test::random r(60);
  for (int i = 0; i < 20000; ++i) {
    const auto root = static_cast<std::uint64_t>(r.integer(0, (std::int64_t{1} << r.integer(1, 62)) - 1));
    const uint128 square = uint128{root} * root;
    REQUIRE(floor_sqrt_wide(square) == root);
    REQUIRE(floor_sqrt_wide(square + root) == root);
    REQUIRE(floor_sqrt_wide(square + 2 * uint128{root}) == root);
    if (root > 0) REQUIRE(floor_sqrt_wide(square - 1) == root - 1);
    if (root < (1u << 31)) {
      const auto narrow = static_cast<std::int64_t>(square);
      REQUIRE(floor_sqrt(narrow) == static_cast<std::int64_t>(root));
      REQUIRE((root == 0 || floor_sqrt(narrow - 1) == static_cast<std::int64_t>(root) - 1));
    }
  }
  CHECK_BOTH(floor_sqrt(0) == 0);
  CHECK_BOTH(floor_sqrt(3) == 1);
  CHECK_BOTH(floor_sqrt((std::int64_t{1} << 62) - 1) == (std::int64_t{1} << 31) - 1);
  CHECK_BOTH(floor_sqrt_wide((uint128{1} << 127) - 1) == 13043817825332782212u);
}

TEST_CASE("line_thick: by hand") {
  using span_list = std::vector<span_of_cells>;
  // One pixel wide, level, through centres: exactly one row; butt caps end at the centres, a left edge owning its own
  CHECK_BOTH(spans(cell{1, 3}, cell{5, 3}, {}) == span_list{{3, 1, 5}});
  CHECK_BOTH(spans(cell{5, 3}, cell{1, 3}, {}) == span_list{{3, 1, 5}});
  CHECK_BOTH(spans(cell{1, 3}, cell{5, 3}, {.caps = line_caps::square}) == span_list{{3, 1, 6}});
  CHECK_BOTH(spans(cell{1, 3}, cell{5, 3}, {.width = 3 * 256}) == span_list{{2, 1, 5}, {3, 1, 5}, {4, 1, 5}});
  CHECK_BOTH(spans(cell{1, 3}, cell{1, 5}, {}) == span_list{{3, 1, 2}, {4, 1, 2}});
  // On the border of two rows: the edge through the upper row's centres is a top edge and owns them
  CHECK_BOTH(spans(subpixel{256, 256}, subpixel{768, 256}, {}) == span_list{{0, 1, 3}});
  CHECK_BOTH(spans(subpixel{256, 256}, subpixel{768, 256}, {.width = 512}) == span_list{{0, 1, 3}, {1, 1, 3}});
  CHECK_BOTH(spans(cell{0, 0}, cell{3, 0}, {.width = 5 * 256, .caps = line_caps::round}) ==
             span_list{{-2, -1, 5}, {-1, -2, 6}, {0, -2, 6}, {1, -2, 6}, {2, -1, 5}});
}

TEST_CASE("line_thick: points and widths that draw nothing or little") {
  CHECK_BOTH(spans(cell{2, 2}, cell{2, 2}, {}).empty());
  CHECK_BOTH(pixels(cell{2, 2}, cell{2, 2}, {.width = 3 * 256, .caps = line_caps::square}) == 9);
  CHECK_BOTH(pixels(cell{2, 2}, cell{2, 2}, {.width = 3 * 256, .caps = line_caps::round}) == 9);
  CHECK_BOTH(pixels(cell{2, 2}, cell{2, 2}, {.width = 2 * 256, .caps = line_caps::round}) ==
             2);  // its left point is owned, the right one is not
  CHECK_BOTH(pixels(cell{2, 2}, cell{9, 5}, {.width = 0, .caps = line_caps::round}) == 0);
  CHECK_BOTH(pixels(cell{2, 2}, cell{9, 5}, {.width = -256, .caps = line_caps::round}) == 0);
  CHECK_BOTH(pixels(cell{2, 2}, cell{9, 5}, {.width = 1}) <= 1);
  CHECK_BOTH(pixels(cell{2, 2}, cell{9, 5}, {}, {0, 0, 0, 9}) == 0);
  CHECK_BOTH(pixels(cell{2, 2}, cell{9, 5}, {}, {9, 9, 1, 1}) == 0);
  CHECK_BOTH(pixels(cell{least, least}, cell{least, least}, {.width = most, .caps = line_caps::round}) == 0);
}

TEST_CASE("line_thick: against the definition at every pixel, all caps, random windows") {
  test::random r(61);
  const int trials = std::getenv("IRG_RELEASE_TIER") ? 300000 : 3000;
  long drawn = 0, ties = 0;
  for (int i = 0; i < trials; ++i) {
    subpixel a{coordinate(r, -2, 10), coordinate(r, -2, 10)}, b{coordinate(r, -2, 10), coordinate(r, -2, 10)};
    auto width = static_cast<std::int32_t>(r.integer(0, 6 * 256));
    if (i % 2) {  // 3, 4, 5: the edges have rational offsets and often pass through centres
      const auto k = static_cast<std::int32_t>(r.integer(-5, 5)) * 64;
      b = i % 4 == 1 ? subpixel{a.x + 3 * k, a.y + 4 * k} : subpixel{a.x - 4 * k, a.y + 3 * k};
      width = width / 128 * 128;
    }
    if (i % 16 == 0) b = a;
    const auto edge = [&] { return static_cast<int>(r.integer(-6, 16)); };
    const int x0 = edge(), y0 = edge();
    const cell_window w = i % 3 ? cell_window{x0, y0, edge(), edge()} : cell_window{-20, -20, 30, 30};
    for (const line_caps caps : all_caps) {
      std::array<std::array<int, 50>, 50> seen{};
      int last_y = least;
      for (const span_of_cells s : spans(a, b, {width, caps}, w)) {
        REQUIRE((s.y > last_y && s.x_first < s.x_last));
        REQUIRE((s.y >= w.y_first && s.y < w.y_last && s.x_first >= w.x_first && s.x_last <= w.x_last));
        last_y = s.y;
        for (int x = s.x_first; x < s.x_last; ++x)
          ++seen[static_cast<std::size_t>(s.y + 20)][static_cast<std::size_t>(x + 20)];
        drawn += s.x_last - s.x_first;
      }
      bool same = true;
      for (int y = w.y_first; y < w.y_last; ++y)
        for (int x = w.x_first; x < w.x_last; ++x) {
          const bool expected = oracle(a, b, width, caps, caps, x, y);
          same &= seen[static_cast<std::size_t>(y + 20)][static_cast<std::size_t>(x + 20)] == (expected ? 1 : 0);
          ties += expected != oracle(b, a, width + 1, caps, caps, x, y);
        }
      REQUIRE_MESSAGE(same, "(", a.x, ",", a.y, ")-(", b.x, ",", b.y, ") width ", width, " caps ",
                      static_cast<int>(caps));
    }
  }
  CHECK(drawn > trials);
  CHECK(ties > trials / 10);
}

TEST_CASE("line_thick: strokes side by side and end to end share no pixel and leave none out") {
  test::random r(62);
  const cell_window w{-40, -40, 60, 60};
  for (int i = 0; i < 1000; ++i) {
    const int k = static_cast<int>(r.integer(1, 12)) * 32;
    const bool turned = i % 2;
    const int dx = (turned ? 4 : 3) * k * (i % 4 < 2 ? 1 : -1), dy = (turned ? 3 : 4) * k;  // length 5k
    const subpixel a{coordinate(r, 0, 8), coordinate(r, 0, 8)};
    const int half = 5 * static_cast<int>(r.integer(1, 50)), nx = -dy / k * half / 5, ny = dx / k * half / 5;
    std::vector<int> count(100 * 100, 0);
    const auto add = [&](int n) {
      return [&count, n](span_of_cells s) {
        for (int x = s.x_first; x < s.x_last; ++x) count[static_cast<std::size_t>((s.y + 40) * 100 + x + 40)] += n;
      };
    };
    // Two rows of two, each `2 * half` wide, against one of twice the width and length
    for (const int side : {-1, 1})
      for (const int part : {0, 1}) {
        const subpixel p{a.x + side * nx + part * dx, a.y + side * ny + part * dy};
        irg::line_thick(p, subpixel{p.x + dx, p.y + dy}, {.width = 2 * half}, w, add(1));
      }
    irg::line_thick(a, subpixel{a.x + 2 * dx, a.y + 2 * dy}, {.width = 4 * half}, w, add(-1));
    REQUIRE(std::count(count.begin(), count.end(), 0) == static_cast<std::ptrdiff_t>(count.size()));
  }
}

TEST_CASE("line_thick: as many pixels as length times width; mirrored lines are mirrored") {
  test::random r(63, test::in_every_round{});
  const cell_window w{-1100, -1100, 1100, 1100};
  for (int i = 0; i < 100; ++i) {
    const double angle = r.unit();
    const auto dx = static_cast<int>(400 * angle * 256), dy = static_cast<int>((500 - 300 * angle) * 256);
    const auto width = static_cast<std::int32_t>(r.integer(5 * 256, 20 * 256));
    const subpixel a{coordinate(r, -9, 9) + 1, coordinate(r, -9, 9) + 1}, b{a.x + dx, a.y + dy};
    const double length = irg::sqrt(static_cast<double>(std::int64_t{dx} * dx + std::int64_t{dy} * dy)) / 256;
    const double expected = length * width / 256;
    const auto counted = static_cast<double>(pixels(a, b, {width}, w));
    REQUIRE(counted > 0.99 * expected);
    REQUIRE(counted < 1.01 * expected);
  }
  // Mirrored at x = 0: pixel x becomes -1 - x. Edges through centres apart, which these widths do not have.
  for (int i = 0; i < 500; ++i) {
    const subpixel a{coordinate(r, -9, 9), coordinate(r, -9, 9)},
        b{a.x + 2 * static_cast<int>(r.integer(0, 999)) + 1, a.y + 300};
    for (const line_caps caps : {line_caps::square, line_caps::round}) {
      const line_pen pen{static_cast<std::int32_t>(r.integer(0, 700)) * 2 + 1, caps};
      const auto here = spans(a, b, pen);
      auto there = spans(subpixel{-a.x, a.y}, subpixel{-b.x, b.y}, pen);
      auto upside_down = spans(subpixel{a.x, -a.y}, subpixel{b.x, -b.y}, pen);
      for (auto& s : there) s = {s.y, -s.x_last, -s.x_first};
      REQUIRE(here == there);
      std::vector<span_of_cells> turned;
      for (std::size_t k = upside_down.size(); k-- > 0;)
        turned.push_back({-1 - upside_down[k].y, upside_down[k].x_first, upside_down[k].x_last});
      REQUIRE(here == turned);
      REQUIRE(here == spans(b, a, pen));
    }
  }
}

TEST_CASE("line_thick: cells in 128 bits give what 64 bits give, in range") {
  test::random r(64);
  for (int i = 0; i < 3000; ++i) {
    const auto at = [&] { return static_cast<int>(r.integer(-20, 40)); };
    const cell a{at(), at()}, b{at(), at()};
    const auto width = static_cast<std::int32_t>(r.integer(1, 2000));
    for (const line_caps caps : all_caps) {
      std::vector<span_of_cells> far;
      irg::detail::stroke_spans(irg::detail::thick_stroke_of<irg::int128, 0>({a.x, a.y, b.x, b.y}, width, caps, caps),
                                {-64, -64, 64, 64}, [&](span_of_cells s) { far.push_back(s); });
      REQUIRE(far == spans(a, b, {width, caps}));
    }
  }
}

TEST_CASE("line_thick: lines far longer than the window, exact there") {
  constexpr cell_window w{0, 0, 64, 64};
  CHECK_BOTH(pixels(cell{least, 5}, cell{most, 5}, {.width = 3 * 256}, w) == 192);
  CHECK_BOTH(pixels(cell{5, most}, cell{5, least}, {.width = 256}, w) == 64);
  CHECK_BOTH(pixels(cell{least, least}, cell{most, most}, {.width = 256}, w) == 64);  // sqrt(1/2) to each side
  CHECK_BOTH(pixels(cell{least, least}, cell{most, most}, {.width = 512, .caps = line_caps::round}, w) == 64 + 2 * 63);
  CHECK_BOTH(pixels(cell{least, most}, cell{most, least}, {.width = most, .caps = line_caps::square}, w) == 64 * 64);
  constexpr int far = irg::snap_limit * 256;
  CHECK_BOTH(pixels(subpixel{-far, 128}, subpixel{far, 128}, {.width = 768}, w) == 128);
  CHECK_BOTH(pixels(subpixel{-far, -far}, subpixel{far, far}, {.width = most, .caps = line_caps::round}, w) == 64 * 64);
  // Directions 3:4 have rational edges, so the definition fits in 128 bits: through a cell of the window
  test::random r(65);
  for (int i = 0; i < 300; ++i) {
    const std::int64_t k = r.integer(1, 1 << 28), back = r.integer(0, k);
    const std::int64_t dx = 3 * k, dy = i % 2 ? 4 * k : -4 * k;
    const std::int64_t x = r.integer(0, 63), y = r.integer(0, 63);
    const cell a{static_cast<int>(x - 3 * back), static_cast<int>(y - dy / k * back)},
        b{static_cast<int>(a.x + dx), static_cast<int>(a.y + dy)};
    const auto width = static_cast<std::int32_t>(r.integer(1, 8 * 256));
    long expected = 0;
    for (int py = 0; py < 64; ++py)
      for (int px = 0; px < 64; ++px) {
        const wide across = wide{px - std::int64_t{a.x}} * dy - wide{py - std::int64_t{a.y}} * dx,
                   along = wide{px - std::int64_t{a.x}} * dx + wide{py - std::int64_t{a.y}} * dy;
        const wide limit = wide{width} * 5 * k;
        const bool right = 512 * across < limit || (512 * across == limit && dy < 0);
        const bool left = -512 * across < limit || (-512 * across == limit && dy > 0);
        expected += right && left && along >= 0 && along < wide{25} * k * k;
      }
    int calls = 0;
    irg::line_thick(a, b, {.width = width}, w, [&](span_of_cells) { ++calls; });
    REQUIRE(calls <= 64);
    REQUIRE(pixels(a, b, {.width = width}, w) == expected);
  }
}

TEST_CASE("polyline_thick: the union of its parts, each pixel once") {
  test::random r(66);
  for (int i = 0; i < 600; ++i) {
    std::vector<subpixel> points;
    const auto n = r.integer(0, 6);
    for (int k = 0; k < n; ++k) {
      points.push_back({coordinate(r, -2, 12), coordinate(r, -2, 12)});
      if (r.integer(0, 3) == 0) points.push_back(points.back());
    }
    std::vector<subpixel> distinct;
    for (const subpixel p : points)
      if (distinct.empty() || distinct.back() != p) distinct.push_back(p);
    const auto width = static_cast<std::int32_t>(r.integer(0, 5 * 256));
    for (const line_caps caps : all_caps) {
      std::vector<int> count(40 * 40, 0);
      span_of_cells last{least, 0, 0};
      irg::polyline_thick(points, {width, caps}, {-8, -8, 18, 18}, [&](span_of_cells s) {
        REQUIRE((s.y > last.y || (s.y == last.y && s.x_first > last.x_last)));
        last = s;
        for (int x = s.x_first; x < s.x_last; ++x) ++count[static_cast<std::size_t>((s.y + 8) * 40 + x + 8)];
      });
      bool same = true;
      for (int y = -8; y < 18; ++y)
        for (int x = -8; x < 18; ++x) {
          bool expected = distinct.size() == 1 && oracle(distinct[0], distinct[0], width, caps, caps, x, y);
          for (std::size_t k = 1; k < distinct.size(); ++k)
            expected |= oracle(distinct[k - 1], distinct[k], width, k == 1 ? caps : line_caps::round,
                               k + 1 == distinct.size() ? caps : line_caps::round, x, y);
          same &= count[static_cast<std::size_t>((y + 8) * 40 + x + 8)] == (expected ? 1 : 0);
        }
      REQUIRE(same);
    }
  }
}

TEST_CASE("line_thick: ends in pixels, refused when they are no positions") {
  using point = irg::point<double, 2>;
  int calls = 0;
  const auto count = [&](span_of_cells) { ++calls; };
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  for (const double bad : {nan, inf, -inf, 2097152.5, -1e30}) {
    CHECK(!irg::line_thick(point{bad, 1}, point{2, 3}, {}, {0, 0, 9, 9}, count));
    CHECK(!irg::line_thick(point{1, bad}, point{2, 3}, {}, {0, 0, 9, 9}, count));
    CHECK(!irg::line_thick(point{1, 1}, point{bad, 3}, {}, {0, 0, 9, 9}, count));
    CHECK(!irg::line_thick(point{1, 1}, point{2, bad}, {}, {0, 0, 9, 9}, count));
  }
  CHECK(calls == 0);
  CHECK(irg::line_thick(irg::point<float, 2>{0.5f, 0.5f}, irg::point<float, 2>{9.5f, 0.5f}, {}, {0, 0, 9, 9}, count));
  CHECK(calls == 1);
}

TEST_CASE("draw_line_thick: paints by value or function, each pixel once, and nothing outside") {
  constexpr auto painted = [] {
    irg::image<int> image(6, 4);
    const auto add = [](int there) { return there + 1; };
    irg::draw_line_thick(image, cell{-5, 1}, cell{9, 1}, {.width = 512}, add);
    const subpixel bend[] = {{128, 128}, {1152, 128}, {1152, 900}, {128, 128}};
    irg::draw_polyline_thick(image, bend, {.width = 300, .caps = line_caps::round}, add);
    irg::draw_line_thick(image, irg::point<float, 2>{0, 3.5f}, irg::point<float, 2>{3, 3.5f}, {}, 5);
    std::array<int, 24> out{};
    for (int i = 0; i < 24; ++i) out[static_cast<std::size_t>(i)] = image(i % 6, i / 6);
    return out;
  };
  // Rows 0 and 1 from the level line; the triangle's outline, its bends counted once
  CHECK_BOTH(painted() == std::array<int, 24>{2, 2, 2, 2, 2, 1, 1, 2, 2, 1, 2, 1, 0, 0, 1, 1, 1, 0, 5, 5, 5, 0, 1, 0});
  // a view whose rows have gaps
  test::framed_raster<float> framed;
  auto& view = framed.view;
  const cell_window beyond{-100, -100, 100, 100};
  irg::draw_line_thick(irg::within(view, beyond), subpixel{-9999, -7777}, subpixel{9999, 8888},
                       {.width = 700, .caps = line_caps::round}, 1.0f);
  irg::draw_line_thick(irg::within(view, beyond), cell{least, 3}, cell{most, 6}, {.width = 256}, 1.0f);
  CHECK(framed.frame_is_whole());
  CHECK(framed.painted() > 20);
}

}  // namespace
