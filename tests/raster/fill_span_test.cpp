// SPDX-License-Identifier: MIT
#include <irg/raster/fill_span.hpp>

#include <cstring>
#include <limits>
#include <memory>
#include <vector>

#include <irg/colour/pixel.hpp>
#include <irg/raster/image.hpp>

#include "support/check_both.hpp"

namespace {

constexpr int least = std::numeric_limits<int>::min(), most = std::numeric_limits<int>::max();

constexpr irg::image<int> filled(irg::span_of_cells span) {
  irg::image<int> i(4, 2, 0);
  irg::fill_span(i, span, 7);
  return i;
}

constexpr int sum(const irg::image<int>& i) {
  int n = 0;
  for (int y = 0; y < 2; ++y)
    for (int x = 0; x < 4; ++x) n += i(x, y);
  return n;
}

TEST_CASE("fill_span: writes the span, cut to the raster") {
  CHECK_BOTH(filled({1, 1, 3})(1, 1) == 7);
  CHECK_BOTH(sum(filled({1, 1, 3})) == 14);
  CHECK_BOTH(sum(filled({0, least, most})) == 28);
  CHECK_BOTH(sum(filled({0, 3, 1})) == 0);  // empty
  CHECK_BOTH(sum(filled({-1, 0, 4})) == 0);
  CHECK_BOTH(sum(filled({2, 0, 4})) == 0);
  CHECK_BOTH(sum(filled({most, least, most})) == 0);
}

// Runs at every distance of whole pixels from a cache line, between bytes that must stay; pixels that may stand at any
// address, at every distance of bytes, too.
template <class P>
void same_bytes_as_a_loop(P value) {
  constexpr std::size_t longest = 200, line = 64, size = 3 * line + longest * sizeof(P);
  struct alignas(line) memory {
    unsigned char byte[size];
  };
  const auto lanes = std::make_unique<memory>(), loop = std::make_unique<memory>();
  for (std::size_t count = 0; count <= longest; ++count)
    for (std::size_t offset = line; offset < 2 * line; offset += alignof(P)) {
      std::memset(lanes->byte, 0x5a, size);
      std::memset(loop->byte, 0x5a, size);
      irg::fill_pixels(reinterpret_cast<P*>(lanes->byte + offset), count, value);
      for (std::size_t i = 0; i < count; ++i) std::memcpy(loop->byte + offset + i * sizeof(P), &value, sizeof(P));
      REQUIRE(std::memcmp(lanes->byte, loop->byte, size) == 0);
    }
}

TEST_CASE("fill_pixels: lanes write what a loop writes, for every pixel size, length and start") {
  same_bytes_as_a_loop<std::uint8_t>(0xab);
  same_bytes_as_a_loop<std::uint16_t>(0xabcd);
  same_bytes_as_a_loop(irg::rgba8{1, 2, 3, 4});
  same_bytes_as_a_loop(irg::rgb8{1, 2, 3});  // three bytes: the plain loop
  same_bytes_as_a_loop(1.5);
  struct wide {
    float v[4];
  };
  same_bytes_as_a_loop(wide{{1, 2, 3, 4}});
}

TEST_CASE("fill_pixels: throws what copying a pixel throws") {
  static_assert(noexcept(irg::fill_pixels(static_cast<int*>(nullptr), 1, 2)));
  struct may_throw {
    may_throw() = default;
    may_throw(const may_throw&) = default;
    may_throw& operator=(const may_throw&) { throw 1; }
  };
  may_throw pixels[2];
  CHECK_THROWS_AS(irg::fill_pixels(pixels, 2, may_throw{}), int);
}

TEST_CASE("clear: every pixel, through strides and without touching the gaps") {
  std::vector<int> memory(5 * 8, -1);
  irg::image_view<int> upside_down(memory.data() + 4 * 8, 6, 5, -8 * static_cast<std::ptrdiff_t>(sizeof(int)));
  irg::clear(upside_down, 3);
  for (int y = 0; y < 5; ++y)
    for (int x = 0; x < 8; ++x) CHECK(memory[static_cast<std::size_t>(8 * y + x)] == (x < 6 ? 3 : -1));
}

}  // namespace
