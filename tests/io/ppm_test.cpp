// SPDX-License-Identifier: MIT
#include <irg/io/ppm.hpp>

#include <cstring>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "support/check_both.hpp"
#include "support/random.hpp"

using irg::image;
using irg::rgb8;
using irg::rgba8;
using file_bytes = std::vector<std::uint8_t>;
using namespace std::string_view_literals;

namespace {

constexpr bool is(const file_bytes& file, std::string_view expected) {
  if (file.size() != expected.size()) return false;
  for (std::size_t i = 0; i < file.size(); ++i)
    if (file[i] != static_cast<std::uint8_t>(expected[i])) return false;
  return true;
}

// Whether the text holds exactly these pixels, row after row.
constexpr bool reads(std::string_view text, int width, int height, std::initializer_list<rgb8> pixels) {
  const auto r = irg::read_ppm(text);
  if (!r || r->width() != width || r->height() != height) return false;
  int i = 0;
  for (const rgb8& p : pixels) {
    if (!((*r)(i % width, i / width) == p)) return false;
    ++i;
  }
  return i == width * height;
}

constexpr bool fails_at(std::string_view text, std::size_t line, std::size_t column) {
  const auto r = irg::read_ppm(text);
  return !r && r.error().line == line && r.error().column == column && r.error().message[0] != '\0';
}

// Pixels made when they are read.
template <class F>
struct virtual_raster {
  int columns, rows;
  F pixel;
  constexpr int width() const { return columns; }
  constexpr int height() const { return rows; }
  constexpr auto operator()(int x, int y) const { return pixel(x, y); }
};
template <class F>
virtual_raster(int, int, F) -> virtual_raster<F>;

constexpr rgb8 k{0, 0, 0}, w{255, 255, 255};

}  // namespace

TEST_CASE("two pixels, byte by byte") {
  constexpr auto two = [] {
    image<rgba8> p(2, 1);
    p(0, 0) = {1, 2, 3, 4};
    p(1, 0) = {'x', 'y', 'z', 0};
    return p;
  };
  CHECK_BOTH(is(*irg::encode_ppm(two()), "P6\n2 1\n255\n\1\2\3xyz"));
  CHECK_BOTH(is(*irg::encode_pgm(image<std::uint8_t>(1, 3, 'q')), "P5\n1 3\n255\nqqq"));
  CHECK_BOTH(is(*irg::encode_ppm(image<irg::bgra8>(1, 1, irg::bgra8{'b', 'g', 'r', 9})), "P6\n1 1\n255\nrgb"));
  CHECK_BOTH(is(*irg::encode_ppm(image<std::uint8_t>(10, 1, 'a')), "P6\n10 1\n255\naaaaaaaaaaaaaaaaaaaaaaaaaaaaaa"));
}

TEST_CASE("gray levels: gray stays, colours are weighed and rounded") {
  int wrong = 0;
  for (int level = 0; level < 256; ++level) {
    const auto v = static_cast<std::uint8_t>(level);
    wrong += irg::encode_pgm(image<rgb8>(1, 1, rgb8{v, v, v}))->back() != v;
  }
  CHECK(wrong == 0);
  CHECK_BOTH(irg::encode_pgm(image<rgb8>(1, 1, rgb8{255, 0, 0}))->back() == 76);   // 76.245
  CHECK_BOTH(irg::encode_pgm(image<rgb8>(1, 1, rgb8{0, 255, 0}))->back() == 150);  // 149.685
  CHECK_BOTH(irg::encode_pgm(image<rgb8>(1, 1, rgb8{0, 0, 255}))->back() == 29);   // 29.07
}

TEST_CASE("the four kinds are read") {
  CHECK_BOTH(reads("P3 2 1 255 0 0 0 255 255 255", 2, 1, {k, w}));
  CHECK_BOTH(reads("P2\n1\n2\n1\n0\n1\n", 1, 2, {k, w}));
  CHECK_BOTH(reads("P6 1 1 255 abc", 1, 1, {{'a', 'b', 'c'}}));
  CHECK_BOTH(reads("P5 1 1 255\na", 1, 1, {{'a', 'a', 'a'}}));
  CHECK_BOTH(reads("P6 1 1 65535\n\0\0\xff\xff\x80\x80"sv, 1, 1, {{0, 255, 128}}));  // the high byte first
  CHECK_BOTH(reads("P5 2 1 256\n\x01\0\0\x80"sv, 2, 1, {w, {128, 128, 128}}));       // 127.5 rounds up
  CHECK_BOTH(reads("P6 1 1 65535\n\0\xc8\0\x80\0\x81"sv, 1, 1, {{1, 0, 1}}));       // the nearest, not the high byte
  CHECK_BOTH(reads("P5 1 1 255\n\n", 1, 1, {{'\n', '\n', '\n'}}));  // one blank only ends the header
  CHECK_BOTH(!reads("P5 1 1 255\r\na", 1, 1, {{'a', 'a', 'a'}}));    // nor do CR and LF
  CHECK_BOTH(reads("P2 1 1 255\r\n255", 1, 1, {w}));
  CHECK_BOTH(reads("P6 1 1 255 # # ", 1, 1, {{'#', ' ', '#'}}) == false);
  CHECK_BOTH(reads("P6 1 1 255 # #", 1, 1, {{'#', ' ', '#'}}));
}

TEST_CASE("comments and blanks stand wherever the format allows them") {
  CHECK_BOTH(reads("P3#x\n#y\n1 # 7 7\n 1\t#z\r\n1\v\f1 0#\n1 # end", 1, 1, {{255, 0, 255}}));
  CHECK_BOTH(reads("P6 # made by hand\r\n1\r\n#\n1 255#behind the number\nabc", 1, 1, {{'a', 'b', 'c'}}));
  CHECK_BOTH(reads("P2 1 1 9 9\n\n\n", 1, 1, {w}));
  CHECK_BOTH(reads("P2 1 1 9 #\xff\xfe\0\n9"sv, 1, 1, {w}));
}

TEST_CASE("levels are scaled exactly, with rounding to nearest") {
  int wrong = 0;
  for (const int most : {1, 2, 3, 7, 15, 100, 254, 255, 256, 1000, 65535}) {
    for (int v = 0; v <= most; v += most > 1000 ? 13 : 1) {
      const std::string text = "P2 1 1 " + std::to_string(most) + " " + std::to_string(v);
      const auto r = irg::read_ppm(text);
      // |255 v / most - level| <= 1/2, in integers; the upper one on a tie.
      const int level = r ? (*r)(0, 0).g : -1000, error2 = 2 * (255 * v - level * most);
      wrong += !(error2 < most && error2 >= -most);
    }
  }
  CHECK(wrong == 0);
}

TEST_CASE("I3: what is written is read") {
  test::random random(4);
  for (int width = 1; width <= 17; ++width) {
    for (int height = 1; height <= 17; ++height) {
      image<rgb8> p(width, height);
      for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
          const std::uint64_t n = random.next();
          p(x, y) = {static_cast<std::uint8_t>(n), static_cast<std::uint8_t>(n >> 8),
                     static_cast<std::uint8_t>(n >> 16)};
        }
      CHECK(*irg::read_ppm(*irg::encode_ppm(p)) == p);
      // Upside down, and through a window with gaps between its rows.
      const irg::image_view<const rgb8> flipped(p.row(height - 1), width, height, -3 * width);
      const auto back = irg::read_ppm(*irg::encode_ppm(flipped));
      REQUIRE(back.has_value());
      CHECK((*back)(width - 1, 0) == p(width - 1, height - 1));
      const irg::image_view<const rgb8> window(p.row(0), (width + 1) / 2, height, 3 * width);
      CHECK((*irg::read_ppm(*irg::encode_ppm(window)))(width / 2 - (width % 2 == 0), height - 1) ==
            p(width / 2 - (width % 2 == 0), height - 1));
    }
  }
}

TEST_CASE("I1: sizes that are no picture or too much of one") {
  constexpr int most = std::numeric_limits<int>::max();
  const int sizes[][2] = {{0, 0},       {0, 9},    {9, 0},           {-1, 1},        {1, -1},
                          {most, most}, {most, 1}, {100000, 100000}, {50000, 85899}, {65536, 65536}};
  for (const auto& [width, height] : sizes) {
    int read = 0;
    const virtual_raster r{width, height, [&](int, int) { return ++read, rgba8{}; }};
    CHECK(!irg::encode_ppm(r).has_value());
    CHECK(!irg::encode_pgm(r).has_value());
    CHECK(read == 0);
  }
  CHECK_BOTH(!irg::encode_ppm(image<rgba8>()).has_value());
  CHECK_BOTH(fails_at("P6 0 1 255 ", 1, 7));
  CHECK_BOTH(fails_at("P6 1 0 255 ", 1, 7));
  CHECK_BOTH(fails_at("P6 2147483647 2147483647 255 abc", 1, 25));
  CHECK_BOTH(fails_at("P6 2147483648 1 255 abc", 1, 4));
  CHECK_BOTH(fails_at("P6 18446744073709551617 1 255 abc", 1, 4));
  CHECK_BOTH(fails_at("P6 99999999999999999999999999999999999999999 1 255 abc", 1, 4));
  // Within the limit, yet the file is shorter: refused before anything of that size is allocated.
  CHECK_BOTH(fails_at("P6 32768 16384 65535\nabc", 2, 1));
  CHECK_BOTH(fails_at("P3 32768 16384 65535\n1 2 3", 1, 21));
  CHECK_BOTH(fails_at("P5 32768 32768 1\n", 2, 1));
}

TEST_CASE("I2: broken headers and data, each with its place") {
  CHECK_BOTH(fails_at("P3\r1 1\r255\r1 x 3", 4, 3));  // lines may end with CR
  CHECK_BOTH(fails_at("P3\r\n1 1\r\n255\r\n1 x 3", 4, 3));
  CHECK_BOTH(fails_at("", 1, 1));
  CHECK_BOTH(fails_at("P", 1, 1));
  CHECK_BOTH(fails_at("P6", 1, 3));
  CHECK_BOTH(fails_at("P1 1 1 1", 1, 1));
  CHECK_BOTH(fails_at("P4 1 1 1", 1, 1));
  CHECK_BOTH(fails_at("P7\nWIDTH 1\n", 1, 1));
  CHECK_BOTH(fails_at(" P6 1 1 255 abc", 1, 1));
  CHECK_BOTH(fails_at("p6 1 1 255 abc", 1, 1));
  CHECK_BOTH(fails_at("P61 1 255 abc", 1, 3));
  CHECK_BOTH(fails_at("P6 -1 1 255 abc", 1, 4));
  CHECK_BOTH(fails_at("P6 +1 1 255 abc", 1, 4));
  CHECK_BOTH(fails_at("P6\n1\n-1 255 abc", 3, 1));
  CHECK_BOTH(fails_at("P6 1.5 1 255 abc", 1, 5));
  CHECK_BOTH(fails_at("P6 0x1 1 255 abc", 1, 5));
  CHECK_BOTH(fails_at("P6 1 1 0 abc", 1, 9));
  CHECK_BOTH(fails_at("P6 1 1 65536 abc", 1, 8));
  CHECK_BOTH(fails_at("P6 1 1 -255 abc", 1, 8));
  CHECK_BOTH(fails_at("P6 1 1 255", 1, 11));
  CHECK_BOTH(fails_at("P6 1 1 255x abc", 1, 11));
  CHECK_BOTH(fails_at("P6 1 1 255 # comment\nabc", 1, 12));
  CHECK_BOTH(fails_at("P6 1 1 255\nab", 2, 1));
  CHECK_BOTH(fails_at("P6 1 1 255\nabcd", 2, 1));
  CHECK_BOTH(fails_at("P6 1 1 256\nabcde", 2, 1));
  CHECK_BOTH(fails_at("P6 1 1 99\n\x01\x64\x01", 2, 2));
  CHECK_BOTH(fails_at("P5 1 1 256\n\x01\x01", 2, 1));
  CHECK_BOTH(fails_at("P3 1 1 255\n1 2", 1, 11));
  CHECK_BOTH(fails_at("P3 1 1 255\n1 2    ", 2, 8));
  CHECK_BOTH(fails_at("P3 1 1 255\n1 2 3 4", 2, 7));
  CHECK_BOTH(fails_at("P3 1 1 255\n1 2 256", 2, 5));
  CHECK_BOTH(fails_at("P3 1 1 255\n1,2,3  ", 2, 2));
  CHECK_BOTH(fails_at("P3 1 1 255\n1 -2 3", 2, 3));
  CHECK_BOTH(fails_at("P3 1 1 255 1 2 #3", 1, 18));
}

TEST_CASE("a file cut off anywhere, or changed anywhere, is a picture or an error") {
  const image<rgb8> p(4, 3, rgb8{7, 8, 9});
  const file_bytes binary = *irg::encode_ppm(p);
  for (std::size_t n = 0; n < binary.size(); ++n) CHECK(!irg::read_ppm(std::span(binary).first(n)).has_value());
  const std::string text = "P3\n# a comment\n2 2\n255\n1 2 3 4 5 6\n7 8 9 10 11 12";
  for (std::size_t n = 0; n < text.size() - 1; ++n)
    CHECK(!irg::read_ppm(std::string_view(text).substr(0, n)).has_value());
  CHECK(irg::read_ppm(text).has_value());

  test::random random(12);
  static constexpr char alphabet[] = "P123456789 0\n\r#-+\t\xff";
  int unexplained = 0, pictures = 0;
  for (int trial = 0; trial < 100000; ++trial) {
    std::string changed = trial % 2 == 0 ? text : std::string(binary.begin(), binary.end());
    for (std::int64_t n = random.integer(1, 4); n > 0; --n) {
      const auto i = static_cast<std::size_t>(random.integer(0, static_cast<std::int64_t>(changed.size()) - 1));
      const char c = alphabet[static_cast<std::size_t>(random.integer(0, sizeof alphabet - 1))];
      if (random.integer(0, 3) == 0)
        changed.insert(i, 1, c);
      else
        changed[i] = c;
    }
    const auto r = irg::read_ppm(changed);
    pictures += r.has_value();
    if (r)
      unexplained += r->width() < 1 || r->height() < 1;
    else
      unexplained += r.error().line == 0 || r.error().column == 0 || std::strlen(r.error().message) < 10;
  }
  CHECK(unexplained == 0);
  CHECK(pictures > 1000);
}

TEST_CASE("bytes of either type are read alike") {
  const std::string text = "P6 1 1 255 \x80\xff\x7f";
  file_bytes same;
  for (const char c : text) same.push_back(static_cast<std::uint8_t>(c));
  CHECK(*irg::read_ppm(text) == *irg::read_ppm(same));
  CHECK((*irg::read_ppm(text))(0, 0) == rgb8{0x80, 0xff, 0x7f});
}
