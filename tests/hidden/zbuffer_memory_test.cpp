// SPDX-License-Identifier: MIT
#include <irg/hidden/zbuffer_memory.hpp>

#include <limits>

#include "support/check_both.hpp"

namespace {

using irg::bits_for_levels;
using irg::buffer_memory;
using irg::zbuffer_memory;
constexpr std::uint64_t most = std::numeric_limits<std::uint64_t>::max();
constexpr int most_pixels = std::numeric_limits<int>::max();

TEST_CASE("zbuffer_memory: the slides' values, 2048 x 1024 with 256 depths and 2^24 colours") {
  constexpr auto table = zbuffer_memory({2048, 1024}, {.depth = 256, .colours = 1 << 24});
  CHECK_BOTH(table.depth == buffer_memory{8, 2097152});
  CHECK_BOTH(table.colours == buffer_memory{24, 6291456});
  CHECK_BOTH(table.colours.bytes == 3 * table.depth.bytes);
  CHECK_BOTH(table.objects == buffer_memory{0, 0});
  CHECK_BOTH(table.bytes == 8388608);
}

TEST_CASE("zbuffer_memory: the slides' values, bits for levels") {
  constexpr std::uint64_t levels[] = {1, 2, 200, 256, 257, 65536};
  constexpr int bits[] = {0, 1, 8, 8, 9, 16};
  for (int i = 0; i < 6; ++i) CHECK(bits_for_levels(levels[i]) == bits[i]);
  CHECK_BOTH(bits_for_levels(0) == 0);
  CHECK_BOTH(bits_for_levels(257) == 9);
  CHECK_BOTH(bits_for_levels(most) == 64);
  for (int k = 1; k < 63; ++k) {
    const std::uint64_t n = std::uint64_t{1} << k;
    CHECK(bits_for_levels(n) == k);
    CHECK(bits_for_levels(n + 1) == k + 1);
  }
}

TEST_CASE("zbuffer_memory: object references and 32-bit depths, 1024 x 768; parts of bytes count whole") {
  constexpr auto table = zbuffer_memory({1024, 768}, {.depth = std::uint64_t{1} << 32, .objects = 1000});
  CHECK_BOTH(table.depth == buffer_memory{32, 786432 * 4});
  CHECK_BOTH(table.objects == buffer_memory{10, 983040});
  CHECK_BOTH(zbuffer_memory({3, 1}, {.depth = 8}).depth == buffer_memory{3, 2});
  CHECK_BOTH(zbuffer_memory({3, 3}, {.depth = 2}).depth == buffer_memory{1, 2});
}

TEST_CASE("zbuffer_memory: no pixels, no levels, and more than can be counted") {
  CHECK_BOTH(zbuffer_memory({0, 1024}, {256, 256, 256}).bytes == 0);
  CHECK_BOTH(zbuffer_memory({640, 480}, {}).bytes == 0);
  CHECK_BOTH(zbuffer_memory({most_pixels, most_pixels}, {.depth = 256}).bytes ==
             std::uint64_t{most_pixels} * std::uint64_t{most_pixels});
  CHECK_BOTH(zbuffer_memory({most_pixels, most_pixels}, {.depth = most}).bytes == most);
  CHECK_BOTH(zbuffer_memory({most_pixels, most_pixels}, {most, most, most}).bytes == most);
}

}  // namespace
