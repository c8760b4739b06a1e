// SPDX-License-Identifier: MIT
#include <irg/io/svg.hpp>

#include <algorithm>
#include <cstdio>
#include <string>
#include <string_view>

#include <irg/raster/image.hpp>

#include "support/check_both.hpp"
#include "support/random.hpp"

namespace {

using irg::rgba8;

std::string text_of(const irg::image<rgba8>& picture) {
  const auto bytes = irg::encode_svg(picture);
  REQUIRE(static_cast<bool>(bytes));
  return std::string(bytes->begin(), bytes->end());
}

// The oracle: the rectangles of the text, painted again.
irg::image<rgba8> painted(const std::string& text, int width, int height) {
  irg::image<rgba8> picture(width, height, {0, 0, 0, 0});
  for (std::size_t at = text.find("<rect"); at != std::string::npos; at = text.find("<rect", at + 1)) {
    int x = -1, y = -1, run = -1, rows = -1, read = 0;
    unsigned r = 0, g = 0, b = 0, thousandths = 1000;
    REQUIRE(std::sscanf(text.c_str() + at, "<rect x=\"%d\" y=\"%d\" width=\"%d\" height=\"%d\" fill=\"#%2x%2x%2x\"%n",
                        &x, &y, &run, &rows, &r, &g, &b, &read) == 7);
    std::sscanf(text.c_str() + at + read, " fill-opacity=\"0.%3u\"", &thousandths);
    for (int i = 0; i < run * rows; ++i)
      picture(x + i % run, y + i / run) = {static_cast<std::uint8_t>(r), static_cast<std::uint8_t>(g),
                                           static_cast<std::uint8_t>(b),
                                           static_cast<std::uint8_t>((thousandths * 255 + 999) / 1000)};
  }
  return picture;
}

TEST_CASE("svg: by hand") {
  irg::image<rgba8> picture(3, 2, {255, 0, 10, 255});
  picture(2, 0) = {0, 0, 0, 128};
  picture(0, 1) = {0, 0, 0, 0};
  CHECK(text_of(picture) ==
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"3\" height=\"2\" viewBox=\"0 0 3 2\" "
        "shape-rendering=\"crispEdges\">\n"
        "<rect x=\"0\" y=\"0\" width=\"2\" height=\"1\" fill=\"#ff000a\"/>\n"
        "<rect x=\"2\" y=\"0\" width=\"1\" height=\"1\" fill=\"#000000\" fill-opacity=\"0.501\"/>\n"
        "<rect x=\"1\" y=\"1\" width=\"2\" height=\"1\" fill=\"#ff000a\"/>\n"
        "</svg>\n");
}

TEST_CASE("svg: the rectangles are the picture") {
  test::random random(41);
  for (int trial = 0; trial < 200; ++trial) {
    const int width = static_cast<int>(random.integer(1, 9)), height = static_cast<int>(random.integer(1, 30));
    irg::image<rgba8> picture(width, height);
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) {
        const auto level = [&] {
          return static_cast<std::uint8_t>(random.integer(0, 9) == 0 ? random.integer(0, 255) : 5);
        };
        picture(x, y) = {level(), 7, 9, 255};
        if (random.integer(0, 30) == 0) picture(x, y).a = static_cast<std::uint8_t>(random.integer(1, 254));
      }
    REQUIRE(painted(text_of(picture), width, height) == picture);
  }
}

TEST_CASE("svg: pictures without pixels are refused, and it is written while compiling, too") {
  CHECK_BOTH(!irg::encode_svg(irg::image<rgba8>(0, 3)));
  CHECK_BOTH(!irg::encode_svg(irg::image<std::uint8_t>(3, 0)));
  CHECK_BOTH([] {
    constexpr std::string_view expected =
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"2\" height=\"1\" viewBox=\"0 0 2 1\" "
        "shape-rendering=\"crispEdges\">\n"
        "<rect x=\"0\" y=\"0\" width=\"2\" height=\"1\" fill=\"#c8c8c8\"/>\n</svg>\n";
    const auto bytes = irg::encode_svg(irg::image<std::uint8_t>(2, 1, 200));
    return bytes && std::equal(bytes->begin(), bytes->end(), expected.begin(), expected.end());
  }());
}

}  // namespace
