// SPDX-License-Identifier: MIT
#include <irg/raster/draw_text.hpp>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <irg/raster/image.hpp>

#include <doctest/doctest.h>

namespace {

using position = irg::point<double, 2>;

constexpr int glyphs_in(std::string_view text) {
  int n = 0;
  for (std::size_t i = 0; i < text.size(); ++n) irg::detail::next_code_point(text, i);
  return n;
}

constexpr double none = std::numeric_limits<double>::quiet_NaN();

static_assert(irg::measure_text("0", 20).width == 12 && irg::measure_text("10", 40).width == 48);
static_assert(irg::measure_text("", 20) == irg::text_extent{0, 16, 4});
static_assert(irg::measure_text("x", none) == irg::text_extent{} && irg::measure_text("x", 0x1p21).width == 0);
static_assert(irg::measure_text("x", -1).width == 0);
static_assert(glyphs_in("a\u00b0\u2192\U0001F600") == 4);
// Cut short, overlong, a surrogate, beyond the last code point, a lone continuation: a box for each byte.
static_assert(glyphs_in("\xe2\x86") == 2 && glyphs_in("\xc0\xaf") == 2 && glyphs_in("\xed\xa0\x80") == 3);
static_assert(glyphs_in("\xf4\x90\x80\x80") == 4 && glyphs_in("\x80") == 1 && glyphs_in("\xe0\x80\x80") == 3);
static_assert(irg::measure_text("\xff", 20).width == irg::measure_text("0", 20).width);

struct box_of {
  double left = 1e300, top = 1e300, right = -1e300, bottom = -1e300;
  int segments = 0;
};

constexpr box_of bounds(std::string_view text, position at, const irg::text_style& style) {
  box_of b;
  irg::text_segments(text, at, style, [&](const position& p, const position& q) {
    for (const position& v : {p, q}) {
      b.left = v.x < b.left ? v.x : b.left, b.right = v.x > b.right ? v.x : b.right;
      b.top = v.y < b.top ? v.y : b.top, b.bottom = v.y > b.bottom ? v.y : b.bottom;
    }
    ++b.segments;
  });
  return b;
}

// H is 9 wide and 14 tall, with a gap of 2 at either side.
static_assert([] {
  const box_of b = bounds("H", {100, 50}, {});
  return b.left == 102 && b.right == 111 && b.bottom == 50 && b.top == 36 && b.segments == 3;
}());
static_assert(bounds("H", {100, 50}, {.along = irg::text_along::right}).right == 98);
static_assert(bounds("H", {100, 50}, {.across = irg::text_across::middle}).top == 43);
static_assert(bounds("H", {100, 50}, {.clockwise_degrees = 90}).right ==
              114);  // clockwise: the top of the letter points right

TEST_CASE("every glyph stays within its measured box, at any size, and no two are the same") {
  std::vector<std::vector<double>> seen;
  std::vector<std::string> texts;
  for (char c = 33; c < 127; ++c) texts.push_back(std::string(1, c));
  for (const char* t : {"\u00b0", "\u00d7", "\u2190", "\u2191", "\u2192", "\u2193", "\u00e9"}) texts.push_back(t);
  for (const std::string& t : texts) {
    CAPTURE(t);
    for (double size : {0.25, 10.0, 20.0, 60.0, 5000.0}) {
      const irg::text_extent e = irg::measure_text(t, size);
      const box_of b = bounds(t, {1000, 1000}, {.size = size});
      const double unit = size / 20, slack = 1e-9;
      CHECK(b.segments > 0);
      CHECK(b.left >= 1000 + 2 * unit - slack);
      CHECK(b.right <= 1000 + e.width - 2 * unit + slack);
      CHECK(b.top >= 1000 - e.ascent - slack);
      CHECK(b.bottom <= 1000 + e.descent + slack);
    }
    std::vector<double> numbers;
    irg::text_segments(t, {0, 0}, {}, [&](const position& p, const position& q) {
      numbers.insert(numbers.end(), {p.x, p.y, q.x, q.y});
    });
    for (const auto& other : seen) CHECK(numbers != other);
    seen.push_back(numbers);
  }
}

TEST_CASE("clipped text has the pixels of the whole") {
  const std::string text = "Ag 3.5\u00d710\u2192@%";
  irg::image<std::uint8_t> whole(200, 80, 0), part(60, 30, 0);
  const irg::text_style style{.size = 24, .clockwise_degrees = 11};
  CHECK(irg::draw_text(whole, text, position{10, 30}, style, std::uint8_t{255}));
  CHECK(irg::draw_text(part, text, position{10 - 40, 30 - 20}, style, std::uint8_t{255}));
  int inked = 0;
  for (int y = 0; y < 30; ++y)
    for (int x = 0; x < 60; ++x) {
      REQUIRE(part(x, y) == whole(x + 40, y + 20));
      inked += part(x, y) != 0;
    }
  CHECK(inked > 100);
}

TEST_CASE("sizes, positions and turns that are no use paint nothing") {
  irg::image<std::uint8_t> picture(30, 30, 7);
  const auto draws = [&](position at, const irg::text_style& style) {
    return irg::draw_text(picture, "A", at, style, std::uint8_t{255});
  };
  const double infinite = std::numeric_limits<double>::infinity();
  for (double size : {none, infinite, -1.0, 0.0, 1e300}) CHECK_FALSE(draws({5, 20}, {.size = size}));
  for (double turn : {none, infinite}) CHECK_FALSE(draws({5, 20}, {.clockwise_degrees = turn}));
  CHECK_FALSE(draws({none, 0}, {}));
  CHECK_FALSE(draws({1e9, 0}, {}));
  CHECK_FALSE(draws({5, 20}, {.weight = infinite}));
  CHECK(irg::draw_text(picture, "", position{5, 20}, {}, std::uint8_t{255}));
  CHECK(irg::draw_text(picture, "A", position{500, 20}, {}, std::uint8_t{255}));
  CHECK(picture == irg::image<std::uint8_t>(30, 30, 7));
}

}  // namespace
