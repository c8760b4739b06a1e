// SPDX-License-Identifier: MIT
#include <irg/io/svg_drawing.hpp>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "support/check_both.hpp"
#include "support/random.hpp"

namespace {

using irg::point;

// Whether the text that `draw` makes is this one, but for the drawing's head.
template <class Draw>
constexpr bool gives(std::string_view expected, Draw draw) {
  std::vector<char> text;
  auto sink = [&](std::string_view piece) {
    for (const char c : piece) text.push_back(c);
  };
  irg::svg_drawing drawing(sink, {20, 10}, irg::rgba8{255, 255, 255, 255});
  const std::size_t head = text.size();
  draw(drawing);
  drawing.finish();
  return std::string_view(text.data(), head) ==
             "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"20\" height=\"10\" viewBox=\"0 0 20 10\">\n"
             "<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n" &&
         std::string_view(text.data() + head, text.size() - head) == expected;
}
constexpr bool is_written(double v, std::string_view expected) {
  std::vector<std::uint8_t> text;
  irg::detail::append_millionths(text, v);
  if (text.size() != expected.size()) return false;
  for (std::size_t i = 0; i < text.size(); ++i)
    if (static_cast<char>(text[i]) != expected[i]) return false;
  return true;
}

TEST_CASE("svg_drawing: lines, dashes, regions") {
  CHECK_BOTH(gives("</svg>\n", [](auto&) {}));
  CHECK_BOTH(
      gives("<g stroke=\"#102030\" stroke-linecap=\"round\">\n<line x1=\"1\" y1=\"2.5\" x2=\"-3\" y2=\"4\"/>\n"
            "</g>\n<g stroke=\"#000000\" stroke-linecap=\"round\" stroke-width=\"0.5\" stroke-dasharray=\"3\">\n"
            "</g>\n</svg>\n",
            [](auto& d) {
              d.begin_lines({.colour = irg::rgba8{16, 32, 48, 255}});
              d.add_line({1, 2.5}, {-3, 4});
              d.add_line({21, 0}, {30, 5});
              d.begin_lines({.width = 0.5, .dash = 3});
            }));
  CHECK_BOTH(gives("<path d=\"M0 0L4 0L0 4ZM1 1L1 2L2 1Z\" fill=\"#ff0000\"/>\n</svg>\n", [](auto& d) {
    using ring = std::vector<point<double, 2>>;
    d.add_region(std::vector<ring>{{{0, 0}, {4, 0}, {0, 4}}, {}, {{1, 1}, {1, 2}, {2, 1}}}, irg::rgba8{255, 0, 0, 255});
  }));
}

TEST_CASE("svg_drawing: lines have their opacity, and are left out where none of their width is in the picture") {
  CHECK_BOTH(
      gives("<g stroke=\"#102030\" stroke-opacity=\"0.501\" stroke-linecap=\"round\" stroke-width=\"6\">\n"
            "<line x1=\"-2\" y1=\"0\" x2=\"-3\" y2=\"9\"/>\n<line x1=\"0\" y1=\"13\" x2=\"9\" y2=\"14\"/>\n"
            "</g>\n</svg>\n",
            [](auto& d) {
              d.begin_lines({.colour = irg::rgba8{16, 32, 48, 128}, .width = 6});
              d.add_line({-2, 0}, {-3, 9});
              d.add_line({-3.5, 0}, {-4, 9});
              d.add_line({0, 13}, {9, 14});
              d.add_line({0, 13.5}, {9, 14});
            }));
}

TEST_CASE("svg_drawing: coordinates to the nearest millionth") {
  CHECK_BOTH(is_written(0, "0"));
  CHECK_BOTH(is_written(-0.0000001, "0"));
  CHECK_BOTH(is_written(-0.000001, "-0.000001"));
  CHECK_BOTH(is_written(0.9999999, "1"));
  CHECK_BOTH(is_written(-120.05, "-120.05"));
  CHECK_BOTH(is_written(1e300, "1099511627776"));
  CHECK_BOTH(is_written(5e-324, "0"));
  CHECK_BOTH(is_written(0x1p-7, "0.007813"));  // half-way
  CHECK_BOTH(is_written(-0x1p-7, "-0.007813"));
  CHECK_BOTH(is_written(0x1.cd9a0f0a5efe9p-3, "0.225391"));  // times a million, half-way but for less than an ulp
  CHECK_BOTH(is_written(0x1.cd9a0f0a5efeap-3, "0.225392"));
  CHECK_BOTH(is_written(0x1.ffb480a5accd9p-16, "0.000031"));
  CHECK_BOTH(is_written(0x1.ffb480a5accd5p-16, "0.00003"));
  CHECK_BOTH(is_written(0x1.fffffffffffffp-1, "1"));
  test::random r(3);
  for (int i = 0; i < 2000; ++i) {
    const double v =
        std::ldexp(static_cast<double>(r.integer(-(1 << 30), 1 << 30)), -static_cast<int>(r.integer(0, 40)));
    std::vector<std::uint8_t> text;
    irg::detail::append_millionths(text, v);
    CHECK(std::fabs(std::strtod(std::string(text.begin(), text.end()).c_str(), nullptr) - v) <=
          0.50001e-6 + std::fabs(v) * 0x1p-52);
  }
}

}  // namespace
