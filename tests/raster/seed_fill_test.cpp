// SPDX-License-Identifier: MIT
#include <irg/raster/seed_fill.hpp>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <limits>
#include <string_view>
#include <vector>

#include <irg/colour/pixel.hpp>
#include <irg/raster/image.hpp>

#include "support/check_both.hpp"
#include "support/random.hpp"

namespace {

using irg::cell;
using irg::neighbours;
constexpr int least = std::numeric_limits<int>::min(), most = std::numeric_limits<int>::max();

// Rows of text as an image of characters.
template <std::size_t N>
constexpr irg::image<char> drawing(const std::string_view (&rows)[N]) {
  irg::image<char> out(static_cast<int>(rows[0].size()), static_cast<int>(N));
  for (int y = 0; y < out.height(); ++y)
    for (int x = 0; x < out.width(); ++x) out(x, y) = rows[y][static_cast<std::size_t>(x)];
  return out;
}
constexpr bool equal(const irg::image<char>& a, const irg::image<char>& b) {
  for (int y = 0; y < a.height(); ++y)
    for (int x = 0; x < a.width(); ++x)
      if (a(x, y) != b(x, y)) return false;
  return a.width() == b.width() && a.height() == b.height();
}

constexpr std::string_view room[] = {"..#....", ".#.#...", "#...#..", ".#.#...", "..#...x"};

TEST_CASE("flood_fill: by hand, four and eight neighbours") {
  CHECK_BOTH([] {
    auto i = drawing(room);
    return irg::flood_fill(i, {2, 2}, 'o') == 5 &&
           equal(i, drawing({"..#....", ".#o#...", "#ooo#..", ".#o#...", "..#...x"}));
  }());
  CHECK_BOTH([] {
    auto i = drawing(room);
    return irg::flood_fill(i, {2, 2}, 'o', neighbours::eight) == 26;  // out through the corners of the ring of #
  }());
  CHECK_BOTH([] {
    auto i = drawing(room);
    return irg::flood_fill(i, {1, 1}, 'o', neighbours::four) == 1 &&
           irg::flood_fill(i, {0, 2}, 'o', neighbours::eight) == 7 &&  // the rest of the ring, by corners
           equal(i, drawing({"..o....", ".o.o...", "o...o..", ".o.o...", "..o...x"}));
  }());
}

TEST_CASE("boundary_fill: by hand, everything but the boundary is region") {
  CHECK_BOTH([] {
    auto i = drawing(room);
    return irg::boundary_fill(i, {6, 0}, '#', 'o') == 16 &&
           equal(i, drawing({"..#oooo", ".#.#ooo", "#...#oo", ".#.#ooo", "..#oooo"}));
  }());
  CHECK_BOTH([] {
    auto i = drawing(room);
    return irg::boundary_fill(i, {0, 0}, 'x', 'o', neighbours::eight) == 34 && i(6, 4) == 'x' && i(2, 0) == 'o';
  }());
  CHECK_BOTH([] {
    auto i = drawing(room);
    return irg::boundary_fill(i, {2, 0}, '#', 'o') == 0 && equal(i, drawing(room));  // the seed on the boundary
  }());
}

TEST_CASE("seed fill: seeds outside, empty windows, the colour that is there") {
  for (const cell seed : {cell{-1, 0}, cell{7, 0}, cell{0, -1}, cell{0, 5}, cell{least, least}, cell{most, most}}) {
    auto i = drawing(room);
    CHECK(irg::flood_fill(i, seed, 'o') == 0);
    CHECK(irg::boundary_fill(i, seed, '#', 'o') == 0);
    CHECK(equal(i, drawing(room)));
  }
  auto i = drawing(room);
  CHECK(irg::flood_fill(irg::within(i, {6, 0, 6, 5}), {6, 0}, 'o') == 0);
  CHECK(irg::flood_fill(irg::within(i, {9, 9, -9, -9}), {6, 0}, 'o') == 0);
  CHECK(irg::flood_fill(irg::within(i, {0, 0, 2, 5}), {2, 2}, 'o') == 0);  // in the raster, not in the window
  CHECK(equal(i, drawing(room)));
  CHECK(irg::flood_fill(i, {2, 2}, '.') == 5);  // ends, changes nothing, and still counts
  CHECK(irg::boundary_fill(i, {2, 2}, '#', '#') == 5);
  irg::image<char> none(0, 0);
  CHECK(irg::flood_fill(none, {0, 0}, 'o') == 0);
  irg::image<char> one(1, 1, '.');
  CHECK(irg::flood_fill(one, {0, 0}, 'o', neighbours::eight) == 1);
  CHECK(one(0, 0) == 'o');
}

TEST_CASE("seed fill: a clip window bounds the region") {
  CHECK_BOTH([] {
    auto i = drawing({".......", ".......", ".......", "......."});
    return irg::flood_fill(irg::within(i, {2, 1, 40, 3}), {3, 1}, 'o', neighbours::eight) == 10 &&
           equal(i, drawing({".......", "..ooooo", "..ooooo", "......."}));
  }());
  CHECK_BOTH([] {  // the way round lies outside of the window
    auto i = drawing({".......", ".####..", "......."});
    return irg::flood_fill(irg::within(i, {0, 0, 4, 3}), {0, 2}, 'o') == 9 && i(4, 2) == '.' && i(3, 0) == 'o' &&
           irg::flood_fill(irg::within(i, {1, 0, 7, 1}), {4, 0}, 'o') == 3;
  }());
}

TEST_CASE("seed_fill_spans: windows at the ends of int; each cell is asked about once at most") {
  long asked = 0;
  const auto inside = [&](const cell& c) { return ++asked, c.x >= most - 100; };
  CHECK(irg::seed_fill_spans({most - 1000, most - 3, most, most}, inside, {most - 1, most - 1}, neighbours::eight,
                             [](irg::span_of_cells) {}) == 300);
  CHECK(asked == 303);
  CHECK(irg::seed_fill_spans(
            {least, least, least + 5, least + 5}, [](cell) { return true; }, {least, least}, neighbours::eight,
            [](irg::span_of_cells) {}) == 25);
  // A row as wide as int: one bit per cell.
  long spans = 0;
  CHECK(irg::seed_fill_spans(
            {least, 7, most, 8}, [](const cell& c) { return c.x < least + 5000; }, {least + 77, 7}, neighbours::eight,
            [&](irg::span_of_cells) { ++spans; }) == 5000);
  CHECK(spans == 1);
  // A predicate that never gives the same answer twice still comes to an end.
  test::random random(5);
  long cells = 0;
  const auto n = irg::seed_fill_spans(
      {0, 0, 90, 90}, [&](cell) { return random.next() % 16 != 0; }, {45, 45}, neighbours::eight,
      [&](irg::span_of_cells s) { cells += s.x_last - s.x_first; });
  CHECK(n == cells);
  CHECK(n <= 90 * 90);
}

// ---- the oracle: breadth first, cell by cell

std::vector<char> reachable(const irg::image<int>& i, cell seed, neighbours next_to, const irg::cell_window& w,
                            bool (*belongs)(int there, int value), int value) {
  std::vector<char> found(static_cast<std::size_t>(i.width() * i.height()), 0);
  const auto at = [&](int x, int y) -> char& { return found[static_cast<std::size_t>(y * i.width() + x)]; };
  const auto legal = [&](int x, int y) {
    return x >= 0 && y >= 0 && x < i.width() && y < i.height() && x >= w.x_first && x < w.x_last && y >= w.y_first &&
           y < w.y_last && belongs(i(x, y), value);
  };
  std::vector<cell> queue;
  if (legal(seed.x, seed.y)) {
    queue.push_back(seed);
    at(seed.x, seed.y) = 1;
  }
  for (std::size_t k = 0; k < queue.size(); ++k)
    for (int dy = -1; dy <= 1; ++dy)
      for (int dx = -1; dx <= 1; ++dx) {
        if (next_to == neighbours::four && dx != 0 && dy != 0) continue;
        const cell c{queue[k].x + dx, queue[k].y + dy};
        if (!legal(c.x, c.y) || at(c.x, c.y) != 0) continue;
        at(c.x, c.y) = 1;
        queue.push_back(c);
      }
  return found;
}

irg::image<int> random_image(test::random& r, int width, int height) {
  irg::image<int> i(width, height, 0);
  const auto walls = r.integer(5, 75);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) i(x, y) = r.integer(0, 99) < walls ? static_cast<int>(r.integer(1, 2)) : 0;
  return i;
}

TEST_CASE("seed fill: equals breadth-first search on random images, by both rules, with and without windows") {
  test::random random(19);
  const int trials = std::getenv("IRG_RELEASE_TIER") ? 300000 : 4000;
  long long filled = 0;
  for (int t = 0; t < trials; ++t) {
    const int width = static_cast<int>(random.integer(1, t % 50 == 0 ? 200 : 20)),
              height = static_cast<int>(random.integer(1, 20));
    const irg::image<int> original = random_image(random, width, height);
    const auto within = [&](int n) { return static_cast<int>(random.integer(0, n - 1)); };
    const cell seed{within(width), within(height)};
    const neighbours next_to = random.next() % 2 ? neighbours::four : neighbours::eight;
    irg::cell_window w = irg::window_of(original);
    if (t % 3 == 0)
      w = {static_cast<int>(random.integer(-2, 3)), static_cast<int>(random.integer(-2, 3)), width - within(5),
           height - within(5)};
    for (const bool flood : {true, false}) {
      irg::image<int> i = original;
      const auto part = irg::within(i, w);
      const auto n = flood ? irg::flood_fill(part, seed, 9, next_to) : irg::boundary_fill(part, seed, 2, 9, next_to);
      const auto expected =
          flood ? reachable(
                      original, seed, next_to, w, [](int there, int value) { return there == value; },
                      original(seed.x, seed.y))
                : reachable(original, seed, next_to, w, [](int there, int value) { return there != value; }, 2);
      long count = 0;
      bool same = true;
      for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
          const bool in = expected[static_cast<std::size_t>(y * width + x)] != 0;
          count += in;
          same = same && i(x, y) == (in ? 9 : original(x, y));
        }
      REQUIRE(same);
      REQUIRE(n == count);
      filled += n;
    }
    // spans: longest runs, none twice, blending once per cell
    irg::image<int> i = original;
    irg::flood_fill(irg::within(i, w), seed, [](int there) { return there + 100; }, next_to);
    bool once = true;
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) once = once && i(x, y) < 200;
    REQUIRE(once);
  }
  MESSAGE(trials, " images, ", filled, " cells filled");
  CHECK(filled > trials * 20);
}

TEST_CASE("seed fill: spans are as long as they can be, and disjoint; no cell is asked about twice, or when found") {
  test::random random(20);
  for (int t = 0; t < 300; ++t) {
    const irg::image<int> i = random_image(random, 30, 15);
    std::vector<int> seen(30 * 15, 0), asked(30 * 15, 0);
    const auto inside = [&](const cell& c) {
      const auto at = static_cast<std::size_t>(c.y * 30 + c.x);
      asked[at] += 1 + seen[at];
      return i(c.x, c.y) == 0;
    };
    irg::seed_fill_spans({2, 1, 28, 14}, inside, {15, 7}, t % 2 == 0 ? neighbours::eight : neighbours::four,
                         [&](irg::span_of_cells s) {
                           for (int x = s.x_first; x < s.x_last; ++x) ++seen[static_cast<std::size_t>(s.y * 30 + x)];
                           REQUIRE(s.x_first < s.x_last);
                           REQUIRE((s.x_first == 2 || i(s.x_first - 1, s.y) != 0));
                           REQUIRE((s.x_last == 28 || i(s.x_last, s.y) != 0));
                         });
    REQUIRE(*std::max_element(seen.begin(), seen.end()) <= 1);
    REQUIRE(*std::max_element(asked.begin(), asked.end()) == 1);
  }
}

// ---- what breaks recursion

TEST_CASE("seed fill: a maze of passages one cell wide is filled to its end") {
  // A serpentine of rows, and one of columns: the longest ways there are.
  const int n = 1023;
  for (const bool columns : {false, true}) {
    irg::image<unsigned char> i(n, n, 0);
    for (int k = 1; k < n; k += 2)
      for (int j = 0; j < n; ++j)
        if (j != ((k & 2) != 0 ? 0 : n - 1)) (columns ? i(k, j) : i(j, k)) = 1;
    const std::int64_t expected = std::int64_t{n} * (n + 1) / 2 + n / 2;
    CHECK(irg::flood_fill(i, {0, 0}, 7, neighbours::four) == expected);
    CHECK(irg::flood_fill(i, {n - 1, n - 1}, 8, neighbours::eight) == expected);
  }
  // A perfect maze: a random spanning tree of passages.
  test::random random(21);
  irg::image<unsigned char> maze(501, 501, 1);
  std::vector<cell> way{{1, 1}};
  maze(1, 1) = 0;
  std::int64_t carved = 1;
  while (!way.empty()) {
    const cell c = way.back();
    const auto turn = static_cast<int>(random.integer(0, 3));
    bool moved = false;
    for (int k = 0; k < 4 && !moved; ++k) {
      const int d = (turn + k) % 4, dx = d == 0 ? 1 : d == 1 ? -1 : 0, dy = d == 2 ? 1 : d == 3 ? -1 : 0;
      const int x = c.x + 2 * dx, y = c.y + 2 * dy;
      if (x < 1 || y < 1 || x > 499 || y > 499 || maze(x, y) == 0) continue;
      maze(x, y) = maze(c.x + dx, c.y + dy) = 0;
      carved += 2;
      way.push_back({x, y});
      moved = true;
    }
    if (!moved) way.pop_back();
  }
  CHECK(carved == 250 * 250 * 2 - 1);
  CHECK(irg::flood_fill(maze, {499, 1}, 2, neighbours::four) == carved);
  CHECK(irg::flood_fill(maze, {0, 0}, 3, neighbours::eight) == 501 * 501 - carved);
}

TEST_CASE("seed fill: a checkerboard of 4096 x 4096 is half filled over corners, and one cell without") {
  const int n = 4096;
  irg::image<unsigned char> board(n, n, 0);
  for (int y = 0; y < n; ++y)
    for (int x = 0; x < n; ++x) board(x, y) = (x + y) % 2 != 0;
  CHECK(irg::flood_fill(board, {n / 2, n / 2}, 7, neighbours::four) == 1);
  board(n / 2, n / 2) = 0;
  const auto start = std::chrono::steady_clock::now();
  CHECK(irg::flood_fill(board, {n / 2, n / 2}, 7, neighbours::eight) == std::int64_t{n} * n / 2);
  const auto spent = std::chrono::steady_clock::now() - start;
  MESSAGE("8388608 runs of one cell: ",
          static_cast<long>(std::chrono::duration_cast<std::chrono::milliseconds>(spent).count()), " ms");
  bool right = true;
  for (int y = 0; y < n; ++y)
    for (int x = 0; x < n; ++x) right = right && board(x, y) == ((x + y) % 2 != 0 ? 1 : 7);
  CHECK(right);
}

// ---- any pixel type

TEST_CASE("seed fill: any pixel that compares, blend functions, gaps between rows") {
  irg::image<irg::rgba8> picture(20, 10, {1, 2, 3, 255});
  for (int y = 0; y < 10; ++y) picture(9, y) = {255, 255, 255, 255};
  CHECK(irg::flood_fill(picture, {3, 3}, {9, 9, 9, 255}) == 90);
  CHECK(irg::boundary_fill(picture, {15, 3}, {255, 255, 255, 255},
                           [](irg::rgba8 p) { return irg::rgba8{p.b, p.g, p.r, p.a}; }) == 100);
  CHECK(picture(8, 9) == irg::rgba8{9, 9, 9, 255});
  CHECK(picture(19, 0) == irg::rgba8{3, 2, 1, 255});
  // the boundary named by one of its own pixels, the paint by a pixel of the region
  CHECK(irg::boundary_fill(picture, {0, 0}, picture(9, 0), picture(8, 0)) == 90);

  irg::image<float> numbers(8, 8, std::numeric_limits<float>::quiet_NaN());
  CHECK(irg::flood_fill(numbers, {3, 3}, 1.0f) == 0);  // NaN does not equal itself
  CHECK(irg::boundary_fill(numbers, {3, 3}, 1.0f, 1.0f) == 64);

  std::vector<int> memory(20 * 12, -1);
  irg::image_view<int> view(memory.data() + 20 * 10 + 4, 12, 10, -20 * static_cast<std::ptrdiff_t>(sizeof(int)));
  CHECK(irg::flood_fill(view, {11, 9}, 5, neighbours::eight) == 120);
  for (int i = 0; i < 20 * 12; ++i) {
    const int x = i % 20 - 4, y = i / 20;
    CHECK(memory[static_cast<std::size_t>(i)] == (x >= 0 && x < 12 && y >= 1 && y <= 10 ? 5 : -1));
  }
}

}  // namespace
