// SPDX-License-Identifier: MIT
#include <irg/raster/draw_lines.hpp>

#include <cstdlib>
#include <span>
#include <vector>

#include <irg/colour/srgb.hpp>
#include <irg/raster/image.hpp>

#include "support/check_both.hpp"
#include "support/line_oracle.hpp"
#include "support/random.hpp"

namespace {

using irg::cell;
using irg::cell_line;
using irg::cell_window;
using irg::line_options;
using test::all_line_options;
using test::least;
using test::most;

// Lines in, across and outside a raster, level, upright and diagonal ones among them, each of another value.
template <class P>
std::vector<irg::painted_line<P>> random_lines(test::random& random, int count, int width, int height, bool far) {
  std::vector<irg::painted_line<P>> lines;
  for (int i = 0; i < count; ++i) {
    const auto end = [&]() -> cell {
      const std::int64_t reach = far && random.integer(0, 7) == 0 ? 2000000000 : random.integer(0, 2) * 300;
      const auto x = static_cast<int>(random.integer(-reach, width + reach - 1));
      return {x, static_cast<int>(random.integer(-reach, height + reach - 1))};
    };
    const cell a = end();
    cell b = end();
    switch (random.integer(0, 9)) {
      case 0: b.y = a.y; break;
      case 1: b.x = a.x; break;
      case 2: b = a; break;
      case 3:
        b = {static_cast<int>(irg::clamped<std::int64_t>(std::int64_t{a.x} + 90, least, most)),
             static_cast<int>(irg::clamped<std::int64_t>(std::int64_t{a.y} - 90, least, most))};
      default: break;
    }
    lines.push_back({a, b, static_cast<P>(i + 1)});
  }
  return lines;
}

template <class R, class Lines>
void one_by_one(R& raster, const Lines& lines, const cell_window& w, const line_options& options) {
  for (const auto& line : lines)
    irg::line_bresenham(
        line.from, line.to, intersect(w, irg::window_of(raster)),
        [&](cell c) { irg::set_pixel(raster, c.x, c.y, line.paint); }, options);
}

TEST_CASE("draw_lines: sorted by tile, the bytes are those of one by one, whatever pixel, window and options") {
  test::random random(21);
  irg::line_batch memory;
  const int rounds = std::getenv("IRG_RELEASE_TIER") ? 400 : 12;
  const auto compare = [&](auto pixel, int width, int height, int round) {
    using P = decltype(pixel);
    irg::image<P> sorted(width, height), reference(width, height);
    const auto lines = random_lines<P>(random, 700, width, height, round % 2 == 1);
    const cell_window window =
        round % 3 == 0 ? cell_window{0, 0, most, most}
                       : cell_window{static_cast<int>(random.integer(0, 90)), static_cast<int>(random.integer(0, 90)),
                                     width - static_cast<int>(random.integer(0, 90)), height};
    const line_options& options = all_line_options[round % 4];
    irg::detail::draw_lines_by_piece(sorted, lines, intersect(window, irg::window_of(sorted)), options, memory.pieces(),
                                     [&](std::size_t i) { return lines[i].paint; });
    one_by_one(reference, lines, window, options);
    REQUIRE(sorted == reference);

    irg::image<P> whole(width, height);
    irg::detail::draw_lines_by_middle(whole, lines, intersect(window, irg::window_of(whole)), options, memory.pieces(),
                                      P(7));
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) reference(x, y) = reference(x, y) == P(0) ? P(0) : P(7);
    REQUIRE(whole == reference);
  };
  for (int round = 0; round < rounds; ++round) {
    compare(std::uint32_t{}, 700, 400, round);
    compare(std::uint16_t{}, 1300, 200, round);
    compare(double{}, 300, 500, round);
  }
}

TEST_CASE("draw_lines: with enough long lines on a large raster it does sort, and the bytes stay the same") {
  constexpr int width = 1100, height = 700;
  test::random random(22);
  const auto lines = random_lines<std::uint32_t>(random, 5000, width, height, true);
  irg::image<std::uint32_t> sorted(width, height), reference(width, height);
  REQUIRE(irg::detail::order_that_pays(lines, irg::window_of(sorted), 4, false) == irg::detail::batch_order::by_piece);
  irg::draw_painted_lines(sorted, lines);
  one_by_one(reference, lines, {0, 0, width, height}, {});
  CHECK(sorted == reference);

  std::vector<cell_line> few_cells;  // short ones of one value are sorted whole
  for (int i = 0; i < 9000; ++i) {
    const auto x = static_cast<int>(random.integer(-9, width)), y = static_cast<int>(random.integer(-9, height));
    few_cells.push_back({{x, y}, {x + static_cast<int>(random.integer(-40, 40)), y + 30}});
  }
  irg::image<std::uint32_t> short_ones(width, height), short_reference(width, height);
  REQUIRE(irg::detail::order_that_pays(few_cells, irg::window_of(sorted), 4, true) ==
          irg::detail::batch_order::by_middle);
  irg::draw_lines(short_ones, few_cells, 9u);
  for (const cell_line& line : few_cells)
    irg::line_bresenham(line.from, line.to, {0, 0, width, height}, [&](cell c) { short_reference(c.x, c.y) = 9; });
  CHECK(short_ones == short_reference);

  irg::line_batch memory;
  for (const line_options& options : all_line_options) {  // the same memory again and again, a span, one paint
    irg::image<std::uint32_t> plain(width, height);
    std::vector<cell_line> plain_lines;
    for (const auto& line : lines) plain_lines.push_back({line.from, line.to});
    irg::draw_lines(irg::within(plain, {3, 4, 1000, 650}), std::span<const cell_line>(plain_lines), 5, options, memory);
    irg::image<std::uint32_t> expected(width, height);
    for (const auto& line : lines)
      irg::line_bresenham(line.from, line.to, {3, 4, 1000, 650}, [&](cell c) { expected(c.x, c.y) = 5; }, options);
    CHECK(plain == expected);
    CHECK(memory.pieces().count == 0);
  }
}

TEST_CASE("draw_lines: guard bytes, negative distance between rows") {
  constexpr int width = 600, height = 500;
  test::random random(23);
  const auto lines = random_lines<std::uint32_t>(random, 3000, width, height, false);
  irg::image<std::uint32_t> reference(width, height);
  one_by_one(reference, lines, {0, 0, width, height}, {});
  for (const std::ptrdiff_t stride : {4 * (width + 7), -4 * (width + 7)}) {
    std::vector<std::uint32_t> memory(static_cast<std::size_t>((width + 7) * (height + 2)), 0xdeadbeef);
    irg::image_view<std::uint32_t> view(memory.data() + (stride > 0 ? width + 7 : (width + 7) * height), width, height,
                                        stride);
    irg::clear(view, 0);
    REQUIRE(irg::detail::order_that_pays(lines, irg::window_of(view), 4, false) == irg::detail::batch_order::by_piece);
    irg::draw_painted_lines(view, lines);
    bool same = true;
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) same = same && view(x, y) == reference(x, y);
    CHECK(same);
    std::size_t guards = 0;
    for (const std::uint32_t v : memory) guards += v == 0xdeadbeef;
    CHECK(guards == memory.size() - std::size_t{width} * height);
  }
}

TEST_CASE("draw_lines: cut walks are the whole walk's cells, tile by tile") {
  using namespace irg::detail;
  test::random random(24);
  const tile_grid grid = tiles_of({-3, 5, 2000, 1500}, 4);
  CHECK(grid.width_bits == 8);
  CHECK(tiles_of({0, 0, most, most}, 1).count <= most_tiles);
  CHECK(tiles_of({0, 0, 1, 1}, 64).count == 1);
  for (int i = 0; i < 3000; ++i) {
    const auto end = [&] {
      const auto x = static_cast<int>(random.integer(-3, 1999));
      return cell{x, static_cast<int>(random.integer(5, 1499))};
    };
    const cell a = end(), b = end();
    const bresenham_frame f = frame_of(a, b);
    std::int64_t at = 0;
    bool right = true;
    cut_walk(walk_of_steps_32(f, {0, f.n + 1}), grid, 7, [&](const line_piece& piece, std::uint32_t tile) {
      right = right && piece.line == 7 && piece.cells > 0;
      for (std::uint32_t k = 0; k < piece.cells; ++k) {
        const cell c = f.at(at + k, f.aside_at(at + k));
        right = right && tile == static_cast<std::uint32_t>((c.y - 5) / 64 * 8 + (c.x + 3) / 256);
      }
      right = right && piece.start == f.at(at, f.aside_at(at));
      at += piece.cells;
    });
    REQUIRE(right);
    REQUIRE(at == f.n + 1);
  }
}

// The cells of the pieces of a walk that goes right and down over tiles of 256 x 64; true when each tile holds its own.
constexpr bool cut_as_walked(std::uint32_t part, std::uint32_t slope, int cells) {
  using namespace irg::detail;
  const tile_grid grid = tiles_of({0, 0, 2000, 2000}, 4);
  const line_walk<std::uint32_t> walk{part, slope, cells, {0, 0}, {1, 1, 0}};
  std::uint64_t sum = part;
  int x = 0;
  bool right = true;
  cut_walk(walk, grid, 0, [&](const line_piece& piece, std::uint32_t tile) {
    for (int k = 0; k < piece.cells; ++k, ++x, sum += slope)
      right = right && tile == (sum >> 32) / 64 * grid.columns + static_cast<std::uint32_t>(x) / 256;
  });
  return right && x == cells;
}

TEST_CASE("draw_lines: a walk is cut where its fraction runs full, to the unit, though no line's does there") {
  CHECK_BOTH(cut_as_walked(0x80000000u, 0x80000000u, 700));  // full without a rest
  CHECK_BOTH(cut_as_walked(0, 0x40000000u, 700));
  CHECK_BOTH(cut_as_walked(0xffffffffu, 1, 3));
  CHECK_BOTH(cut_as_walked(0x7fffffffu, 0x80000000u, 700));
  CHECK_BOTH(cut_as_walked(0x80000001u, 0x80000000u, 700));
  CHECK_BOTH(cut_as_walked(0x7fffffffu, 0xffffffffu, 700));
  CHECK_BOTH(cut_as_walked(0x7fffffffu, 0, 700));
}

// Lines of one cell, very many in one tile, then as many in the next.
struct tile_after_tile {
  std::size_t tiles;
  std::size_t size() const { return tiles * irg::detail::pieces_at_once; }
  cell_line operator[](std::size_t i) const {
    const cell c{static_cast<int>(i / irg::detail::pieces_at_once) * 256 + static_cast<int>(i % 200), 3};
    return {c, c};
  }
};

TEST_CASE("draw_lines: lines that come tile by tile do not fill the memory of every tile") {
  irg::image<std::uint32_t> image(256 * 8, 64);
  irg::line_batch memory;
  irg::detail::draw_lines_by_piece(image, tile_after_tile{8}, irg::window_of(image), {}, memory.pieces(),
                                   [](std::size_t i) { return static_cast<std::uint32_t>(i); });
  std::size_t kept = 0;
  for (const auto& tile : memory.pieces().of_tile) kept += tile.capacity();
  CHECK(kept <= irg::detail::most_pieces_kept);
  CHECK(image(7 * 256 + 199, 3) > 7u * irg::detail::pieces_at_once);
}

TEST_CASE("draw_lines: few lines, no lines, empty windows, functions, constant evaluation") {
  constexpr auto drawn = [](cell_window w) {
    irg::image<int> image(8, 8, 0), expected(8, 8, 0);
    const std::vector<cell_line> lines{{{0, 0}, {7, 7}}, {{7, 0}, {0, 7}}, {{-5, 3}, {20, 4}}, {{2, 2}, {2, 2}}};
    irg::draw_lines(irg::within(image, w), lines, 3);
    for (const cell_line& line : lines) irg::draw_line(irg::within(expected, w), line.from, line.to, 3);
    return image == expected;
  };
  CHECK_BOTH(drawn({0, 0, 8, 8}));
  CHECK_BOTH(drawn({2, 1, 5, 8}));
  CHECK_BOTH(drawn({5, 5, 1, 1}));
  constexpr auto painted = [] {
    irg::image<int> image(4, 1, 0);
    irg::draw_painted_lines(image, std::vector<irg::painted_line<int>>{{{0, 0}, {2, 0}, 1}, {{3, 0}, {1, 0}, 2}});
    return image(0, 0) == 1 && image(1, 0) == 2 && image(2, 0) == 2 && image(3, 0) == 2;
  };
  CHECK_BOTH(painted());
  irg::image<irg::rgba8> colour(4, 4);
  const std::vector<cell_line> none;
  irg::draw_lines(colour, none, {1, 2, 3, 4});
  CHECK(colour == irg::image<irg::rgba8>(4, 4));

  constexpr int width = 900, height = 600;  // a function sees the lines in order, even where sorting would pay
  test::random random(25);
  const auto lines = random_lines<int>(random, 3000, width, height, false);
  irg::image<unsigned> blended(width, height, 0u), expected(width, height, 0u);
  unsigned calls = 0, expected_calls = 0;
  irg::draw_lines(blended, lines, [&](unsigned there) { return there * 3 + ++calls; });
  for (const auto& line : lines)
    irg::line_bresenham(line.from, line.to, {0, 0, width, height},
                        [&](cell c) { expected(c.x, c.y) = expected(c.x, c.y) * 3 + ++expected_calls; });
  CHECK(blended == expected);
}

}  // namespace
