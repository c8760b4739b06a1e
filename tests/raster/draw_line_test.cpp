// SPDX-License-Identifier: MIT
#include <irg/raster/draw_line.hpp>

#include <cstdlib>
#include <cstring>
#include <vector>

#include <irg/colour/srgb.hpp>
#include <irg/raster/image.hpp>

#include "support/check_both.hpp"
#include "support/line_oracle.hpp"
#include "support/line_properties.hpp"
#include "support/random.hpp"

namespace {

using irg::cell;
using irg::cell_window;
using irg::line_ends;
using irg::line_options;
using irg::line_ties;
using test::all_line_options;
using test::least;
using test::most;

template <class R>
constexpr std::vector<cell> cells_in(const R& raster, cell a, cell b, cell_window w, line_options options) {
  std::vector<cell> out;
  irg::line_bresenham(a, b, intersect(w, irg::window_of(raster)), [&](cell c) { out.push_back(c); }, options);
  return out;
}

// Draws on a raster of zeros, and says whether exactly the cells of line_bresenham became one. Leaves zeros.
template <class R>
constexpr bool draws_the_cells(R& raster, cell a, cell b, cell_window w, line_options options = {}) {
  using pixel = irg::pixel_of<R>;
  const std::vector<cell> expected = cells_in(raster, a, b, w, options);
  irg::draw_line(irg::within(raster, w), a, b, pixel(1), options);
  bool right = true;
  for (const cell c : expected) {
    right = right && irg::get_pixel(raster, c.x, c.y) == pixel(1);
    irg::set_pixel(raster, c.x, c.y, pixel(0));
  }
  for (int y = 0; y < irg::height_of(raster); ++y)
    for (int x = 0; x < irg::width_of(raster); ++x)
      if (!(irg::get_pixel(raster, x, y) == pixel(0))) {
        right = false;
        irg::set_pixel(raster, x, y, pixel(0));
      }
  return right;
}

TEST_CASE("draw_line: writes the line's pixels and no others") {
  constexpr auto sum = [] {
    irg::image<int> image(5, 3);
    irg::draw_line(image, {-2, 0}, {4, 2}, 1);
    int n = 0;
    for (int y = 0; y < 3; ++y)
      for (int x = 0; x < 5; ++x) n += image(x, y) << (5 * y + x);
    return n;
  };
  CHECK_BOTH(sum() == (0b00111 << 5 | 0b11000 << 10));
}

TEST_CASE("draw_line: all ends on 8 x 8, all options, windows inside and across the raster") {
  irg::image<unsigned char> image(8, 8);
  long drawn = 0;
  for (int p = 0; p < 100; ++p)
    for (int q = 0; q < 100; ++q)
      for (const line_options& options : all_line_options)
        for (const cell_window w :
             {cell_window{-9, -9, 19, 19}, {0, 0, 8, 8}, {2, 1, 6, 5}, {3, 0, 4, 8}, {5, 5, 9, 9}}) {
          const cell a{p % 10 - 1, p / 10 - 1}, b{q % 10 - 1, q / 10 - 1};
          REQUIRE(draws_the_cells(image, a, b, w, options));
          ++drawn;
        }
  CHECK(drawn == 200000);
}

// Draws a line by value, and once more by a function, which tells the pixels in their order and clears them. The window
// lies inside a view that is little larger, upside down every other time. Calls emit with a cell that is in no window
// when the two do not agree or a pixel elsewhere is painted.
class both_ways {
public:
  template <class Emit>
  void operator()(cell a, cell b, const cell_window& w, const line_options& options, Emit&& emit) {
    const auto moved = [&](cell c, cell& to) {
      const std::int64_t x = std::int64_t{c.x} - w.x_first + 2, y = std::int64_t{c.y} - w.y_first + 2;
      to = {static_cast<int>(x), static_cast<int>(y)};
      return x == to.x && y == to.y;
    };
    cell from, to;
    if (!moved(a, from) || !moved(b, to)) return irg::line_bresenham(a, b, w, emit, options);
    ++drawn;
    const int width = w.x_last - w.x_first + 3, height = w.y_last - w.y_first + 3;
    const bool upwards = drawn % 2 == 0;
    unsigned char* const first = memory_.data() + (upwards ? (height - 1) * 64 : 0);
    irg::image_view<unsigned char> view(first, width, height, upwards ? -64 : 64);
    const cell_window inner{2, 2, width - 1, height - 1};
    irg::draw_line(irg::within(view, inner), from, to, 1, options);
    const auto clear = [&](const unsigned char& there) -> unsigned char {
      const auto at = static_cast<int>(&there - first), row = (at + 64 * height) / 64 - height, x = at - 64 * row;
      emit(there == 1 ? cell{x - 2 + w.x_first, (upwards ? -row : row) - 2 + w.y_first} : nowhere);
      return 0;
    };
    irg::draw_line(irg::within(view, inner), from, to, clear, options);
    for (int i = 0; i < 64 * height; i += 64)
      if (std::memcmp(memory_.data() + i, blank_.data(), 64) != 0) emit(nowhere);
  }
  long drawn = 0;

private:
  static constexpr cell nowhere{most, most};
  std::vector<unsigned char> memory_ = std::vector<unsigned char>(64 * 64, 0), blank_ = memory_;
};

TEST_CASE("draw_line: 10^5 random lines, 10^7 for a release, and a lattice, by value and by function") {
  both_ways draw;
  test::check_window_line([&](cell a, cell b, const cell_window& w, const line_options& options, auto&& emit) {
    draw(a, b, w, options, emit);
  });
  CHECK(draw.drawn > 700000);
}

TEST_CASE("draw_line: the criteria of a good raster line") {
  const auto draw = [](auto& raster, cell a, cell b) { irg::draw_line(raster, a, b, 1); };
  test::check_line_criteria_in<irg::image<unsigned char>>(draw);
  test::check_line_criteria_in<irg::image<float>>(draw);
  for (const line_ties ties : {line_ties::start_side, line_ties::symmetric})
    test::check_line_criteria_in<irg::image<unsigned char>>(
        [&](auto& raster, cell a, cell b) { irg::draw_line(raster, a, b, 1, {line_ends::half_open, ties}); },
        line_ends::half_open);
}

TEST_CASE("draw_line: random lines over the whole int range") {
  test::random random(11);
  irg::image<int> image(40, 30);
  const long trials = std::getenv("IRG_RELEASE_TIER") ? 1000000 : 100000;
  long crossing = 0;
  for (long i = 0; i < trials; ++i) {
    const auto end = [&] {
      const auto bits = random.integer(3, 32);
      const auto coordinate = [&] {
        const std::int64_t half = std::int64_t{1} << (bits - 1);
        return static_cast<int>(random.integer(-half, half - 1));
      };
      const int x = coordinate();
      return cell{x, coordinate()};
    };
    cell a = end();
    const cell b = end();
    if (i % 4 != 0) {  // through the picture: the end mirrored at one of its cells
      const std::int64_t x = 2 * random.integer(0, 39) - b.x, y = 2 * random.integer(0, 29) - b.y;
      if (x >= least && x <= most && y >= least && y <= most) a = {static_cast<int>(x), static_cast<int>(y)};
    }
    const auto side = [&](int low, int high) { return static_cast<int>(random.integer(low, high)); };
    const cell_window w{side(-3, 9), side(-3, 9), side(25, 43), side(18, 33)};
    const line_options& options = all_line_options[random.integer(0, 3)];
    crossing += cells_in(image, a, b, w, options).size() >= 2;
    REQUIRE(draws_the_cells(image, a, b, w, options));
  }
  CHECK(crossing > trials / 2);
}

// The number whose product with m is 1 modulo n, 0 when there is none.
std::int64_t inverse(std::int64_t m, std::int64_t n) {
  std::int64_t a = n, b = m % n, x = 0, y = 1;
  while (b != 0) {
    const std::int64_t q = a / b, c = a - q * b, z = x - q * y;
    a = b, b = c, x = y, y = z;
  }
  return a == 1 ? (x + n) % n : 0;
}

// The walk in fixed point against the exact quotient: at its first and last step, at some between, and at those where
// the line lies as close as it can to half-way between two cells, which one unit too much or too little would show.
template <class Walk>
bool walk_is_exact(const Walk& walk, const irg::detail::bresenham_frame& f, std::int64_t first, test::random& random) {
  using irg::int128;
  constexpr int bits = 8 * static_cast<int>(sizeof(walk.part));
  const std::int64_t aside = f.aside_at(first), last = first + walk.cells - 1, unit = inverse(f.m, f.n);
  bool right = walk.start == f.at(first, aside);
  const auto check = [&](std::int64_t step) {
    const auto sum = walk.part + static_cast<irg::uint128>(step - first) * walk.slope;
    right = right && static_cast<std::int64_t>(sum >> bits) + aside == f.aside_at(step);
  };
  check(first);
  check(last);
  for (int k = 0; k < 4; ++k) check(random.integer(first, last));
  for (std::int64_t rest = f.n / 2 - 1; rest <= f.n / 2 + 1; ++rest) {  // the step with step * m = rest modulo n
    const auto step = static_cast<std::int64_t>(int128{unit} * (rest < 0 ? 0 : rest) % f.n);
    if (step >= first && step <= last) check(step);
  }
  return right;
}

TEST_CASE("draw_line: the fixed-point walk is exact up to its bounds") {
  using namespace irg::detail;
  test::random random(12);
  const int rounds = std::getenv("IRG_RELEASE_TIER") ? 3000000 : 30000;
  for (int i = 0; i < rounds; ++i) {
    const bool longest = i % 3 == 0;
    const std::int64_t n = longest ? longest_walk_in_32_bits - random.integer(0, 2) : random.integer(1, 46340);
    const std::int64_t m = i % 5 == 0 ? n - random.integer(0, n < 3 ? n : 3) : random.integer(0, n);
    const bresenham_frame f{n, m, 1, 1, i % 2 == 0, {0, 0}, i / 2 % 2};
    const std::int64_t first = random.integer(0, n);
    REQUIRE(walk_is_exact(walk_of_steps_32(f, {0, n + 1}), f, 0, random));
    REQUIRE(walk_is_exact(walk_of_steps_32(f, {first, n + 1}), f, first, random));
  }
  for (int i = 0; i < rounds; ++i) {
    const std::int64_t far = 4294967295, n = i % 2 == 0 ? far - random.integer(0, 9) : random.integer(46341, far);
    const std::int64_t m = i % 5 == 0 ? n - random.integer(0, 3) : random.integer(0, n);
    const bresenham_frame f{n, m, 1, 1, i % 3 == 0, {least, least}, i / 2 % 2};
    const std::int64_t first = random.integer(0, n);
    const std::int64_t most_steps = 2147483646, last = n + 1 - first > most_steps ? first + most_steps : n + 1;
    REQUIRE(walk_is_exact(walk_of_steps_64(f, {first, last}), f, first, random));
  }
}

TEST_CASE("draw_line: the lines on which the start of the walk in 32 bits has least room") {
  using namespace irg::detail;
  // Of all n up to 46340, all m and all steps these are lost first when the start is `room` units lower or higher.
  struct tight {
    std::int64_t n, m, step;
    int tie, room;
  };
  for (const tight& t : {tight{46269, 6088, 46250, 0, -192},
                         {46340, 23170, 1, 0, 2},
                         {46340, 23170, 46339, 1, -2},
                         {46339, 7723, 3, 1, 4}}) {
    const bresenham_frame f{t.n, t.m, 1, 1, false, {0, 0}, t.tie};
    auto walk = walk_of_steps_32(f, {0, t.n + 1});
    const auto aside = [&] {
      return static_cast<std::int64_t>((walk.part + static_cast<std::uint64_t>(t.step) * walk.slope) >> 32);
    };
    const std::uint32_t start = walk.part;
    CHECK(aside() == f.aside_at(t.step));
    walk.part = start + static_cast<std::uint32_t>(t.room - (t.room > 0 ? 1 : -1));
    CHECK(aside() == f.aside_at(t.step));
    walk.part = start + static_cast<std::uint32_t>(t.room);
    CHECK(aside() != f.aside_at(t.step));
  }
}

TEST_CASE("draw_line: the walk in 64 bits on the lines that need its last units") {
  using namespace irg::detail;
  using wide_uint = irg::uint128;
  test::random random(18);
  constexpr std::int64_t cells = 2147483647;  // the widest window
  int lowest = 0;
  constexpr std::int64_t lengths[] = {4294967295, 4294967293, 4294967291, 4294967279,
                                      3000000001, 2147483647, 2147483649};
  for (const std::int64_t n : lengths) {
    // m such that the slope is short of the true one by nearly a unit, or by nearly nothing; the step where v is whole
    const auto power = static_cast<std::int64_t>((wide_uint{1} << 64) % static_cast<wide_uint>(n));
    const std::int64_t unit = inverse(power, n);
    if (unit == 0) continue;
    for (const std::int64_t m : {n - unit, unit}) {
      const auto step = static_cast<std::int64_t>(wide_uint(inverse(m, n)) * wide_uint((n + 1) / 2) % wide_uint(n));
      for (const std::int64_t first : {std::int64_t{0}, step - (cells - 1), step, n + 1 - cells}) {
        if (first < 0 || first > step || step - first >= cells) continue;
        const bresenham_frame f{n, m, 1, 1, false, {least, least}, 0};
        const auto walk = walk_of_steps_64(f, {first, irg::minimum(n + 1, first + cells)});
        CHECK(walk_is_exact(walk, f, first, random));
        lowest += first == step - (cells - 1);
      }
    }
  }
  CHECK(lowest > 0);
}

// Constants, for a compiler may keep equal ones in one register.
IRG_NOINLINE std::ptrdiff_t step_of_equal_numbers() {
  std::uint64_t part = 5;
  return irg::detail::step<std::uint64_t>(part, ~std::uint64_t{0}, 7, 5);
}

TEST_CASE("draw_line: a step whose operands are known to be equal") { CHECK(step_of_equal_numbers() == 5); }

TEST_CASE("draw_line: lines longer than 32 bits of fraction serve, inside the raster") {
  irg::image<unsigned char> wide(100000, 3), high(3, 100000);
  test::random random(13);
  for (int i = 0; i < 40; ++i) {
    const auto length = static_cast<int>(46338 + i % 8), from = static_cast<int>(random.integer(0, 50000));
    const auto row = [&] { return static_cast<int>(random.integer(0, 2)); };
    const cell a{i % 2 ? from : 99999, row()}, b{i % 2 ? from + length : from, row()};
    const line_options& options = all_line_options[i % 4];
    REQUIRE(draws_the_cells(wide, a, b, {0, 0, most, most}, options));
    REQUIRE(draws_the_cells(high, {a.y, a.x}, {b.y, b.x}, {0, 0, most, most}, options));
  }
}

TEST_CASE("draw_line: rasters larger than the caches, where steep lines are fetched ahead") {
  irg::image<std::uint32_t> large(600, 600), reference(600, 600);
  test::random random(14);
  for (std::uint32_t i = 1; i < 3000; ++i) {
    const auto end = [&] {
      const auto x = static_cast<int>(random.integer(-100, 700));
      return cell{x, static_cast<int>(random.integer(-100, 700))};
    };
    const cell a = end(), b = end();
    const line_options& options = all_line_options[i % 4];
    irg::draw_line(large, a, b, i, options);
    irg::line_bresenham(a, b, irg::window_of(large), [&](cell c) { reference(c.x, c.y) = i; }, options);
  }
  CHECK(large == reference);
}

TEST_CASE("draw_line: views with any distance between rows, guard bytes untouched") {
  struct rgb8 {
    unsigned char r, g, b;
    constexpr explicit rgb8(int v = 0)
        : r(static_cast<unsigned char>(v)), g(static_cast<unsigned char>(2 * v)), b(static_cast<unsigned char>(3 * v)) {
    }
    constexpr bool operator==(const rgb8&) const = default;
  };
  constexpr int width = 9, height = 7;
  test::random random(15);
  const auto end = [&] {
    const auto x = static_cast<int>(random.integer(-4, 12));
    return cell{x, static_cast<int>(random.integer(-4, 10))};
  };
  for (const std::ptrdiff_t stride : {36, 40, 128, -36, -40, -128}) {
    std::vector<int> memory(2000, 0);
    irg::image_view<int> view(memory.data() + 1000, width, height, stride);
    for (int i = 0; i < 500; ++i) REQUIRE(draws_the_cells(view, end(), end(), {0, 0, 99, 99}, all_line_options[i % 4]));
    irg::draw_line(view, {least, least}, {most, most}, 1);
    long sum = 0;
    for (const int v : memory) sum += v;
    CHECK(sum == 7);
  }
  for (const std::ptrdiff_t stride : {27, 28, 31, -28, -29}) {  // no multiple of the pixel's three bytes
    std::vector<unsigned char> memory(2000, 0);
    irg::image_view<rgb8> view(reinterpret_cast<rgb8*>(memory.data() + 1000), width, height, stride);
    for (int i = 0; i < 500; ++i) REQUIRE(draws_the_cells(view, end(), end(), {0, 0, 99, 99}, all_line_options[i % 4]));
    irg::draw_line(view, {0, -5}, {8, 13}, rgb8(1));
    long sum = 0;
    for (const unsigned char v : memory) sum += v;
    CHECK(sum == 6 * static_cast<long>(cells_in(view, {0, -5}, {8, 13}, {0, 0, 99, 99}, {}).size()));
  }
}

// Rows that lie anywhere: row(y) exists, a distance between rows does not.
struct loose_rows {
  std::vector<std::vector<float>> rows = std::vector<std::vector<float>>(9, std::vector<float>(11, 0.0f));
  int width() const { return 11; }
  int height() const { return 9; }
  float& operator()(int x, int y) { return rows[static_cast<std::size_t>(y)][static_cast<std::size_t>(x)]; }
  float operator()(int x, int y) const { return rows[static_cast<std::size_t>(y)][static_cast<std::size_t>(x)]; }
  float* row(int y) { return rows[static_cast<std::size_t>(y)].data(); }
};

// No rows at all.
struct bit_raster {
  std::uint64_t word = 0;
};

}  // namespace

template <>
struct irg::raster_traits<bit_raster> {
  using pixel = int;
  static constexpr int width(const bit_raster&) { return 8; }
  static constexpr int height(const bit_raster&) { return 8; }
  static constexpr int get(const bit_raster& r, int x, int y) { return static_cast<int>(r.word >> (8 * y + x) & 1); }
  static constexpr void set(bit_raster& r, int x, int y, int v) {
    const std::uint64_t bit = std::uint64_t{1} << (8 * y + x);
    r.word = v ? r.word | bit : r.word & ~bit;
  }
};

namespace {

TEST_CASE("draw_line: any raster and any pixel") {
  static_assert(irg::RowRaster<loose_rows> && !irg::EvenRowRaster<loose_rows>);
  static_assert(irg::EvenRowRaster<irg::image<int>> && irg::EvenRowRaster<irg::image_view<int>>);
  static_assert(irg::EvenRowRaster<const irg::image_view<int>>);
  static_assert(!irg::RowRaster<bit_raster>);
  loose_rows loose;
  bit_raster few;
  irg::image<double> real(11, 9);
  irg::image<std::uint16_t> ids(11, 9);
  test::random random(16);
  for (int i = 0; i < 2000; ++i) {
    const auto end = [&] {
      const auto x = static_cast<int>(random.integer(-4, 14));
      return cell{x, static_cast<int>(random.integer(-4, 12))};
    };
    const cell a = end(), b = end();
    const line_options& options = all_line_options[i % 4];
    REQUIRE(draws_the_cells(loose, a, b, {1, 1, 99, 8}, options));
    REQUIRE(draws_the_cells(few, a, b, {1, 1, 99, 8}, options));
    REQUIRE(draws_the_cells(real, a, b, {1, 1, 99, 8}, options));
    REQUIRE(draws_the_cells(ids, a, b, {1, 1, 99, 8}, options));
  }
  irg::image<irg::rgba8> colour(4, 4);
  irg::draw_line(colour, {0, 0}, {3, 3}, {1, 2, 3, 4});
  CHECK(colour(2, 2) == irg::rgba8{1, 2, 3, 4});
  const irg::image_view<irg::rgba8> constant = colour.view();
  irg::draw_line(constant, {0, 1}, {3, 2}, irg::rgba8{9, 9, 9, 9});
  CHECK(colour(0, 1) == irg::rgba8{9, 9, 9, 9});
}

TEST_CASE("draw_line: a function paint is called once per cell, in the order from a to b") {
  constexpr auto in_order = [](cell a, cell b, line_options options) {
    irg::image<int> image(12, 9, 0);
    int calls = 0;
    irg::draw_line(image, a, b, [&calls](int there) { return there * 1000 + ++calls; }, options);
    const auto expected = cells_in(image, a, b, irg::window_of(image), options);
    bool right = calls == static_cast<int>(expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i)
      right = right && image(expected[i].x, expected[i].y) == static_cast<int>(i) + 1;
    return right;
  };
  CHECK_BOTH(in_order({-3, -2}, {11, 8}, {}));
  test::random random(17);
  for (int i = 0; i < 2000; ++i) {
    const auto end = [&] {
      const auto x = static_cast<int>(random.integer(-3, 14));
      return cell{x, static_cast<int>(i % 3 == 0 ? 4 : random.integer(-3, 11))};
    };
    const cell a = end();
    REQUIRE(in_order(a, end(), all_line_options[i % 4]));
  }
}

TEST_CASE("draw_line: hostile lines and windows") {
  constexpr auto count = [](cell a, cell b, int width, int height, cell_window w, line_options options = {}) {
    irg::image<int> image(width, height);
    irg::draw_line(irg::within(image, w), a, b, 1, options);
    int n = 0;
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) n += image(x, y);
    return n;
  };
  constexpr cell_window all{least, least, most, most};
  CHECK_BOTH(count({least, least}, {most, most}, 64, 64, all) == 64);
  CHECK_BOTH(count({least, 5}, {most, 5}, 64, 64, all) == 64);
  CHECK_BOTH(count({most, 5}, {least, 5}, 64, 64, all, all_line_options[2]) == 64);
  CHECK_BOTH(count({5, most}, {5, least}, 64, 64, all) == 64);
  CHECK_BOTH(count({most, 0}, {most, 0}, 64, 64, all) == 0);
  CHECK_BOTH(count({3, 3}, {3, 3}, 4, 4, all) == 1);
  CHECK_BOTH(count({3, 3}, {3, 3}, 4, 4, all, all_line_options[2]) == 0);
  CHECK_BOTH(count({9, 9}, {9, 9}, 4, 4, all) == 0);
  CHECK_BOTH(count({-3, 2}, {2, -3}, 4, 4, all) == 0);
  CHECK_BOTH(count({-3, 3}, {3, -3}, 4, 4, all) == 1);
  CHECK_BOTH(count({0, 0}, {3, 3}, 4, 4, {2, 2, 2, 9}) == 0);
  CHECK_BOTH(count({0, 0}, {3, 3}, 4, 4, {3, 3, 1, 1}) == 0);
  CHECK_BOTH(count({0, 1}, {3, 1}, 4, 4, {3, 3, 1, 1}) == 0);
  CHECK_BOTH(count({0, 0}, {3, 3}, 0, 4, all) == 0);
  CHECK_BOTH(count({0, 0}, {3, 0}, 4, 0, all) == 0);
  CHECK_BOTH(count({-7, -7}, {5, 5}, 1, 1, all) == 1);
  irg::image<unsigned char> image(640, 480);
  const cell ends[][2] = {{{262, 23}, {91618510, -54756195}},
                          {{263, 214}, {80120779, 11846827}},
                          {{34, 204}, {-46400, 47400}},
                          {{least, 0}, {63, 63}},
                          {{most, least}, {0, 0}},
                          {{least, most}, {most, least}},
                          {{most, most}, {least, least}},
                          {{least, 0}, {most, 1}},
                          {{0, least}, {1, most}}};
  for (const auto& [a, b] : ends)
    for (const line_options& options : all_line_options) {
      REQUIRE(draws_the_cells(image, a, b, all, options));
      REQUIRE(draws_the_cells(image, b, a, all, options));
    }
  irg::image_view<int> nothing;
  irg::draw_line(nothing, {0, 0}, {5, 5}, 1);
  irg::draw_line(nothing, {0, 0}, {5, 0}, 1);
}

}  // namespace
