// SPDX-License-Identifier: MIT
#include <irg/raster/line_wu.hpp>

#include <cmath>
#include <cstdlib>
#include <limits>
#include <map>
#include <vector>

#include <irg/raster/image.hpp>

#include "support/check_both.hpp"
#include "support/random.hpp"

namespace {

using irg::cell, irg::subpixel;
__extension__ typedef __int128 wide;
constexpr int least = std::numeric_limits<int>::min(), most = std::numeric_limits<int>::max();
constexpr irg::cell_window everything{least, least, most, most};
constexpr irg::line_options symmetric{irg::line_ends::closed, irg::line_ties::symmetric};

struct covered {
  cell at;
  int coverage = 0;
  constexpr bool operator==(const covered&) const = default;
};

template <class P>
constexpr std::vector<covered> cells(P a, P b, irg::cell_window w = everything, irg::line_options o = {}) {
  std::vector<covered> out;
  irg::line_wu(a, b, w, [&](cell c, std::uint8_t coverage) { out.push_back({c, coverage}); }, o);
  return out;
}

constexpr bool inside(const irg::cell_window& w, const cell& c) {
  return c.x >= w.x_first && c.x < w.x_last && c.y >= w.y_first && c.y < w.y_last;
}

// From the definition, a division for every step: cell i of n along the longer axis, no mirroring, nothing carried.
std::vector<covered> oracle(cell a, cell b, std::int64_t from, std::int64_t to) {
  const std::int64_t dx = std::int64_t{b.x} - a.x, dy = std::int64_t{b.y} - a.y, w = std::llabs(dx), h = std::llabs(dy);
  const bool steep = h >= w && h > 0;
  const std::int64_t n = steep ? h : w, m = steep ? w : h, su = (steep ? dy : dx) < 0 ? -1 : 1,
                     sv = (steep ? dx : dy) < 0 ? -1 : 1;
  std::vector<covered> out;
  for (std::int64_t i = from; i <= to; ++i) {
    const wide whole = n == 0 ? 0 : wide{i} * m / n, rest = n == 0 ? 0 : wide{i} * m % n;
    int c = 0;
    if (n > 0) {
      c = static_cast<int>(wide{255} * rest / n);
      if (2 * (wide{255} * rest - wide{c} * n) > n) ++c;  // a half stays
    }
    const auto at = [&](std::int64_t k) {
      const auto u = static_cast<int>((steep ? a.y : a.x) + su * i), v = static_cast<int>((steep ? a.x : a.y) + sv * k);
      return steep ? cell{v, u} : cell{u, v};
    };
    if (c < 255) out.push_back({at(static_cast<std::int64_t>(whole)), 255 - c});
    if (c > 0) out.push_back({at(static_cast<std::int64_t>(whole) + 1), c});
  }
  return out;
}

TEST_CASE("line_wu: by hand") {
  // y = x / 2: 0, 1/2, 1; a half of 255 is 127.5 and stays with the start's side
  CHECK_BOTH(cells(cell{0, 0}, cell{2, 1}) ==
             std::vector<covered>{{{0, 0}, 255}, {{1, 0}, 128}, {{1, 1}, 127}, {{2, 1}, 255}});
  CHECK_BOTH(cells(cell{2, 1}, cell{0, 0}) ==
             std::vector<covered>{{{2, 1}, 255}, {{1, 1}, 128}, {{1, 0}, 127}, {{0, 0}, 255}});
  CHECK_BOTH(cells(cell{2, 1}, cell{0, 0}, everything, symmetric) ==
             std::vector<covered>{{{2, 1}, 255}, {{1, 1}, 127}, {{1, 0}, 128}, {{0, 0}, 255}});
  CHECK_BOTH(
      cells(cell{0, 0}, cell{1, 3}) ==
      std::vector<covered>{{{0, 0}, 255}, {{0, 1}, 170}, {{1, 1}, 85}, {{0, 2}, 85}, {{1, 2}, 170}, {{1, 3}, 255}});
  CHECK_BOTH(cells(cell{0, 0}, cell{-2, -2}) == std::vector<covered>{{{0, 0}, 255}, {{-1, -1}, 255}, {{-2, -2}, 255}});
  CHECK_BOTH(cells(cell{5, 5}, cell{5, 5}) == std::vector<covered>{{{5, 5}, 255}});
  CHECK_BOTH(cells(cell{5, 5}, cell{5, 5}, everything, {irg::line_ends::half_open}).empty());
  CHECK_BOTH(cells(cell{0, 0}, cell{2, 0}, everything, {irg::line_ends::half_open}) ==
             std::vector<covered>{{{0, 0}, 255}, {{1, 0}, 255}});
}

TEST_CASE("line_wu: every line of 23 x 23 is the oracle's, and the coverages of each column add up to 255") {
  for (int x = -11; x <= 11; ++x)
    for (int y = -11; y <= 11; ++y) {
      const cell a{3, -2}, b{3 + x, -2 + y};
      const auto line = cells(a, b);
      REQUIRE(line == oracle(a, b, 0, std::max(std::abs(x), std::abs(y))));
      std::map<int, int> sums;
      for (const covered& c : line) sums[std::abs(y) >= std::abs(x) ? c.at.y : c.at.x] += c.coverage;
      REQUIRE(sums.size() == static_cast<std::size_t>(std::max(std::abs(x), std::abs(y))) + 1);
      for (const auto& column : sums) REQUIRE(column.second == 255);
      // symmetric: the same both ways
      auto back = cells(b, a, everything, symmetric);
      std::map<std::pair<int, int>, int> there_image, back_image;
      for (const covered& c : cells(a, b, everything, symmetric)) there_image[{c.at.x, c.at.y}] = c.coverage;
      for (const covered& c : back) back_image[{c.at.x, c.at.y}] = c.coverage;
      REQUIRE(there_image == back_image);
    }
}

TEST_CASE("line_wu: random lines over the whole int range against the rational oracle, clipped") {
  test::random random(21);
  const int trials = std::getenv("IRG_RELEASE_TIER") ? 1000000 : 10000;
  long seen = 0;
  for (int i = 0; i < trials; ++i) {
    const auto coordinate = [&] {
      const int bits = static_cast<int>(random.integer(4, 32));
      return static_cast<int>(random.integer(-(std::int64_t{1} << (bits - 1)), (std::int64_t{1} << (bits - 1)) - 1));
    };
    const cell a{coordinate(), coordinate()}, b{coordinate(), coordinate()};
    const std::int64_t w = std::llabs(std::int64_t{b.x} - a.x), h = std::llabs(std::int64_t{b.y} - a.y),
                       n = w > h ? w : h;
    const std::int64_t step = random.integer(0, n), from = irg::maximum<std::int64_t>(0, step - 20),
                       to = irg::minimum(n, step + 20);
    const auto around = oracle(a, b, from, to);
    const cell middle = oracle(a, b, step, step).front().at;
    const auto near = [&](int c) {
      return static_cast<int>(irg::clamped<std::int64_t>(std::int64_t{c} + random.integer(-7, 2), least, most - 16));
    };
    const int x = near(middle.x), y = near(middle.y);
    const irg::cell_window window{x, y, x + 9, y + 9};
    std::vector<covered> expected;
    for (const covered& c : around)
      if (inside(window, c.at)) expected.push_back(c);
    seen += static_cast<long>(expected.size());
    REQUIRE(cells(a, b, window) == expected);
  }
  CHECK(seen > 3L * trials);
}

TEST_CASE("line_wu: clipped cells are the unclipped ones in the window, both kinds of ends") {
  test::random random(22);
  for (int i = 0; i < 4000; ++i) {
    const auto c = [&] { return static_cast<int>(random.integer(-6 * 256, 14 * 256)); };
    const subpixel a{c(), c()}, b{c(), c()};
    const cell p{a.x >> 8, a.y >> 8}, q{b.x >> 8, b.y >> 8};
    const auto w = [&] { return static_cast<int>(random.integer(0, 8)); };
    const irg::cell_window window{w(), w(), w(), w()};
    const auto both = [&](auto from, auto to) {
      std::vector<covered> expected;
      for (const covered& v : cells(from, to))
        if (inside(window, v.at)) expected.push_back(v);
      return cells(from, to, window) == expected;
    };
    REQUIRE(both(a, b));
    REQUIRE(both(p, q));
  }
}

TEST_CASE("line_wu: ends between pixels") {
  constexpr int one = irg::one_pixel;
  // from the middle of cell 0 to the middle of cell 2, level with the centres: half, whole, half
  CHECK_BOTH(cells(subpixel{128, 128}, subpixel{2 * one + 128, 128}) ==
             std::vector<covered>{{{0, 0}, 128}, {{1, 0}, 255}, {{2, 0}, 128}});
  // on the border of two rows: the line is shared, the odd unit goes to the lower row number
  CHECK_BOTH(cells(subpixel{0, one}, subpixel{one, one}) == std::vector<covered>{{{0, 0}, 128}, {{0, 1}, 127}});
  CHECK_BOTH(cells(subpixel{0, 128}, subpixel{one, 128}) == std::vector<covered>{{{0, 0}, 255}});
  CHECK_BOTH(cells(subpixel{10, 128}, subpixel{11, 128}) == std::vector<covered>{{{0, 0}, 1}});  // 1/256 of a column
  CHECK_BOTH(cells(subpixel{7, 9}, subpixel{7, 9}).empty());
  CHECK_BOTH(cells(subpixel{least, 128}, subpixel{most, 128}, {0, 0, 5, 5}).size() == 5);

  test::random random(23);
  for (int i = 0; i < 3000; ++i) {
    const auto c = [&] { return static_cast<int>(random.integer(-9 * one, 9 * one)); };
    const subpixel a{c(), c()}, b{c(), c()};
    const int dx = b.x - a.x, dy = b.y - a.y;
    const bool steep = std::abs(dy) >= std::abs(dx);
    if (dx == 0 && dy == 0) continue;
    const int u0 = steep ? std::min(a.y, b.y) : std::min(a.x, b.x),
              u1 = steep ? std::max(a.y, b.y) : std::max(a.x, b.x);
    std::map<int, int> sums;
    std::map<int, double> moment;
    for (const covered& v : cells(a, b)) {
      const int column = steep ? v.at.y : v.at.x, row = steep ? v.at.x : v.at.y;
      sums[column] += v.coverage;
      moment[column] += v.coverage * (row + 0.5);
    }
    for (int j = (u0 >> 8); j <= (u1 >> 8); ++j) {
      const int part = std::max(0, std::min(u1, (j + 1) * one) - std::max(u0, j * one));
      REQUIRE(sums[j] == (255 * part + 128) / 256);
      // the two cells' centre of mass is where the line passes the column's middle
      if (part < 256) continue;
      const double u = j * 256 + 128, y = steep ? a.x + (u - a.y) * dx / dy : a.y + (u - a.x) * dy / dx;
      REQUIRE(std::fabs(moment[j] / sums[j] - y / 256) < 0.5 / 255 + 1e-9);
    }
  }
}

TEST_CASE("line_wu: extremes of int, empty windows, lines that miss") {
  static constexpr irg::cell_window w{0, 0, 64, 64};
  constexpr auto diagonal = [] {
    int on = 0, n = 0;
    irg::line_wu(cell{least, least}, cell{most, most}, w,
                 [&](cell c, std::uint8_t coverage) { ++n, on += c.x == c.y && coverage == 255; });
    return on == 64 && n == 64;
  };
  CHECK_BOTH(diagonal());
  CHECK_BOTH(cells(cell{least, 5}, cell{most, 5}, w).size() == 64);
  CHECK_BOTH(cells(cell{5, most}, cell{5, least}, w).size() == 64);
  CHECK_BOTH(cells(cell{9, 9}, cell{9, 9}, {0, 0, 4, 4}).empty());
  CHECK_BOTH(cells(cell{-9, 2}, cell{2, -9}, {0, 0, 4, 4}).empty());
  CHECK_BOTH(cells(cell{0, 0}, cell{3, 3}, {2, 2, 2, 9}).empty());
  CHECK_BOTH(cells(cell{0, 0}, cell{3, 3}, {3, 3, 1, 1}).empty());
}

constexpr irg::image<irg::rgba8> drawn() {
  irg::image<irg::rgba8> picture(6, 4, {0, 0, 0, 255});
  irg::draw_line_wu(picture, cell{-2, -1}, cell{9, 3}, {255, 255, 255, 255});
  return picture;
}

TEST_CASE("draw_line_wu: pixels, functions, other pixel types, guard bytes, NaN") {
  static_assert(drawn()(1, 0).r == 255 - drawn()(1, 1).r && drawn()(1, 0).r > 0);
  CHECK(drawn() == [] {
    irg::image<irg::rgba8> picture(6, 4, {0, 0, 0, 255});
    for (const covered& c : cells(cell{-2, -1}, cell{9, 3}, {0, 0, 6, 4}))
      picture(c.at.x, c.at.y) =
          irg::mix({0, 0, 0, 255}, irg::rgba8{255, 255, 255, 255}, static_cast<std::uint8_t>(c.coverage));
    return picture;
  }());
  irg::image<int> counts(8, 8, 0);
  irg::draw_line_wu(counts, cell{0, 0}, cell{7, 3}, [](int there, std::uint8_t coverage) { return there + coverage; });
  int sum = 0;
  for (int y = 0; y < 8; ++y)
    for (int x = 0; x < 8; ++x) sum += counts(x, y);
  CHECK(sum == 8 * 255);
  irg::image<float> light(8, 8, 0.0f);
  irg::draw_line_wu(light, cell{0, 2}, cell{7, 2}, 2.0f);
  CHECK(light(3, 2) == 2.0f);

  std::vector<irg::rgba8> memory(12 * 9, {9, 9, 9, 9});
  const irg::image_view<irg::rgba8> view(memory.data() + 12 + 2, 7, 6, 48);
  irg::draw_line_wu(view, cell{-40, -31}, cell{50, 43}, {1, 2, 3, 4});
  for (int y = 0; y < 9; ++y)
    for (int x = 0; x < 12; ++x)
      if (y < 1 || y >= 7 || x < 2 || x >= 9)
        REQUIRE(memory[static_cast<std::size_t>(y * 12 + x)] == irg::rgba8{9, 9, 9, 9});

  const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  auto before = drawn();
  using point = irg::point<double, 2>;
  const irg::rgba8 red{255, 0, 0, 255};
  CHECK(!irg::draw_line_wu(before, point{nan, 0}, point{3, 3}, red));
  CHECK(!irg::draw_line_wu(before, point{0, 0}, point{3, -infinity}, red));
  CHECK(before == drawn());
  CHECK(irg::draw_line_wu(before, point{1e300, 1e300}, point{2e300, 1e299}, red));  // nowhere near
  CHECK(before == drawn());
  auto far = drawn(), within = drawn();
  CHECK(irg::draw_line_wu(far, point{0.5, 0.5}, point{1e9, 5e8}, red));
  CHECK(irg::draw_line_wu(within, point{0.5, 0.5}, point{1e6, 5e5}, red));
  CHECK(far == within);
  CHECK(irg::draw_line_wu(before, point{0, 0.5}, point{3, 0.5}, red));
  CHECK(before(1, 0) == red);
}

}  // namespace
