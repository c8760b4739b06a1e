// SPDX-License-Identifier: MIT
#include <irg/io/terrain.hpp>

#include <cmath>
#include <string>
#include <vector>

#include "io/memory_in_use.hpp"
#include "support/check_both.hpp"
#include "support/random.hpp"

namespace {

constexpr std::string_view small =
    "ncols 3\nnrows 2\nxllcorner 100\nyllcorner 200\ncellsize 10\nNODATA_value -1\n"
    "1 2 3\r\n"
    "4 -1 6\n";

constexpr bool reads_small() {
  const auto g = irg::read_terrain(small);
  if (!g || g->x.size() != 3 || g->z.size() != 2) return false;
  const auto is = [&](std::size_t k, double v) { return g->heights[k] == v; };
  return g->x[0] == 105 && g->x[2] == 125 && g->z[0] == 205 && g->z[1] == 215 && is(0, 4) && is(1, 1) &&
         !(g->heights[2] == g->heights[2]) && is(3, 2) && is(4, 6) && is(5, 3);
}

std::string place_of(std::string_view text) {
  const auto g = irg::read_terrain(text);
  if (g) return "read";
  return std::to_string(g.error().line) + ":" + std::to_string(g.error().column) + " " + g.error().message;
}

}  // namespace

TEST_CASE("read_terrain: rows from the north, places of samples, gaps") {
  CHECK_BOTH(reads_small());
  const auto centred = irg::read_terrain("NCOLS 1 NROWS 1 XLLCENTER -5 YLLCENTER 7 CELLSIZE 0.5\n-9999");
  REQUIRE(centred);
  CHECK(centred->x[0] == -5);
  CHECK(centred->z[0] == 7);
  CHECK(std::isnan(centred->heights[0]));
}

TEST_CASE("read_terrain: errors with their place") {
  CHECK(place_of("\xEF\xBB\xBF" + std::string(small)) == "read");  // a byte order mark
  CHECK(place_of("\xEF\xBB\xBFncols x") == "1:7 expected a decimal number");
  CHECK(place_of("") == "1:1 the head lacks ncols, nrows or cellsize");
  CHECK(place_of("ncols 2\nrows 2\n") == "2:1 expected ncols, nrows, xllcorner, yllcorner, cellsize or nodata_value");
  CHECK(place_of("ncols 0\n") == "1:7 number is out of range");
  CHECK(place_of("ncols 2.5\n") == "1:7 number is out of range");
  CHECK(place_of("ncols         0\n") == "1:15 number is out of range");
  CHECK(place_of("ncols\n 0\n") == "2:2 number is out of range");
  CHECK(place_of("ncols 2 nrows 2 cellsize -1\n") == "1:26 number is out of range");
  CHECK(place_of("ncols 1 nrows 2 cellsize 1\n1 x") == "2:3 expected a decimal number");
  CHECK(place_of("ncols 1 nrows 2 cellsize 1\n1") == "2:2 text ends where a number is expected");
  CHECK(place_of("ncols 1 nrows 1 cellsize 1\n1 2") == "2:3 something follows the last height");
  CHECK(place_of("ncols 1000000000 nrows 1000000000 cellsize 1\n1") == "2:1 the grid is too large");
  CHECK(place_of("ncols 100000 nrows 1000 cellsize 1\n1") == "2:1 the file is too short for so many heights");
}

TEST_CASE("read_terrain: torn and changed files end with an error or a grid") {
  test::random r(4);
  for (int i = 0; i < 3000; ++i) {
    std::string text(small);
    for (int k = static_cast<int>(r.integer(0, 3)); k >= 0; --k)
      text[static_cast<std::size_t>(r.integer(0, static_cast<int>(text.size()) - 1))] =
          static_cast<char>(r.integer(0, 2) == 0 ? r.integer(0, 127) : r.integer('0', '9'));
    text.resize(static_cast<std::size_t>(r.integer(0, static_cast<int>(text.size()))));
    const auto g = irg::read_terrain(text);
    if (g)
      CHECK(g->heights.size() == g->x.size() * g->z.size());
    else
      CHECK(g.error().line >= 1);
  }
}

TEST_CASE("read_terrain: memory is bounded by the file, whatever its counts claim") {
  for (const std::string shape :
       {"ncols 1 nrows 500000", "ncols 1 nrows 999000", "ncols 999000 nrows 1", "ncols 700 nrows 700"}) {
    std::string text = shape + " cellsize 1\n";
    text.resize(1'000'000, ' ');
    test::bytes_most = test::bytes_now;
    const std::size_t before = test::bytes_now;
    CHECK(!irg::read_terrain(text));
    CHECK(test::bytes_most - before <= 8 * text.size() + (std::size_t{1} << 20));
  }
  CHECK(place_of("ncols 1 nrows 400000 cellsize 1\n1") == "2:1 the file is too short for so many heights");
}
