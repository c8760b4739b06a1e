// SPDX-License-Identifier: MIT
#include <irg/raster/line_styled.hpp>

#include <cstdlib>
#include <limits>
#include <vector>

#include <irg/raster/image.hpp>

#include "support/check_both.hpp"
#include "support/framed_raster.hpp"
#include "support/random.hpp"

namespace {

using irg::cell;
using irg::cell_window;
using irg::dash_mask;
using irg::dash_runs;
constexpr int least = std::numeric_limits<int>::min(), most = std::numeric_limits<int>::max();
constexpr cell_window everything{least, least, most, most};
constexpr std::uint32_t two_one[] = {2, 1}, three[] = {3}, holes[] = {0, 2, 0, 0, 1, 0, 3}, nothing[] = {0, 0, 0},
                        long_runs[] = {4000000000u, 4000000000u};

template <class Pattern>
constexpr std::vector<cell> cells(cell a, cell b, Pattern p, std::uint64_t phase = 0, cell_window w = everything,
                                  irg::line_options o = {}) {
  std::vector<cell> out;
  irg::line_styled(a, b, irg::line_dashes{p, phase, o}, w, [&](cell c) { out.push_back(c); });
  return out;
}

// Whether position i is drawn: the runs laid out one after the other.
bool oracle(const dash_runs& p, std::uint64_t i) {
  std::vector<bool> line;
  bool drawn = true;
  for (int twice = 0; twice < 2; ++twice)
    for (const std::uint32_t run : p.runs) {
      line.insert(line.end(), run, drawn);
      drawn = !drawn;
    }
  return line.empty() || line[i % (p.runs.size() % 2 ? line.size() : line.size() / 2)];
}

bool oracle(const dash_mask& p, std::uint64_t i) {
  const std::uint64_t repeat = p.repeat == 0 ? 1 : p.repeat;
  return (p.mask >> (i / repeat % 16)) % 2 == 1;
}

TEST_CASE("line_styled: by hand") {
  CHECK_BOTH(cells({0, 0}, {6, 0}, dash_runs{two_one}) == std::vector<cell>{{0, 0}, {1, 0}, {3, 0}, {4, 0}, {6, 0}});
  CHECK_BOTH(cells({0, 0}, {6, 0}, dash_runs{two_one}, 1) == std::vector<cell>{{0, 0}, {2, 0}, {3, 0}, {5, 0}, {6, 0}});
  CHECK_BOTH(cells({6, 0}, {0, 0}, dash_runs{two_one}, 2) == std::vector<cell>{{5, 0}, {4, 0}, {2, 0}, {1, 0}});
  CHECK_BOTH(cells({0, 0}, {0, 6}, dash_runs{three}) == std::vector<cell>{{0, 0}, {0, 1}, {0, 2}, {0, 6}});
  CHECK_BOTH(cells({0, 0}, {7, 0}, dash_mask{0x000d}) == std::vector<cell>{{0, 0}, {2, 0}, {3, 0}});
  CHECK_BOTH(cells({0, 0}, {7, 0}, dash_mask{0x0005, 2}) == std::vector<cell>{{0, 0}, {1, 0}, {4, 0}, {5, 0}});
  CHECK_BOTH(cells({0, 0}, {9, 4}, dash_mask{0xffff, 0}).size() == 10);
  CHECK_BOTH(cells({0, 0}, {9, 4}, dash_runs{}).size() == 10);
  CHECK_BOTH(cells({0, 0}, {9, 4}, dash_runs{nothing}).size() == 10);
  CHECK_BOTH(cells({3, 3}, {3, 3}, dash_runs{two_one}, 2).empty());
}

template <class Pattern>
void check_against_oracle(const Pattern& p, test::random& r) {
  const auto at = [&] { return static_cast<int>(r.integer(-30, 30)); };
  const cell a{at(), at()}, b{at(), at()};
  const std::uint64_t phase = r.next() >> r.integer(0, 63);
  const irg::line_options o{r.integer(0, 1) ? irg::line_ends::closed : irg::line_ends::half_open,
                            r.integer(0, 1) ? irg::line_ties::symmetric : irg::line_ties::start_side};
  const cell_window w = r.integer(0, 3) ? cell_window{at(), at(), at(), at()} : everything;
  std::vector<cell> expected;
  std::uint64_t n = 0;
  const std::uint64_t first = phase % 960;  // a multiple of the lengths used here
  irg::line_bresenham(
      a, b, everything,
      [&](cell c) {
        if (oracle(p, first + n) && c.x >= w.x_first && c.x < w.x_last && c.y >= w.y_first && c.y < w.y_last)
          expected.push_back(c);
        ++n;
      },
      o);
  REQUIRE(cells(a, b, p, phase, w, o) == expected);
  const std::uint64_t steps = o.ends == irg::line_ends::closed ? n - 1 : n;
  const std::uint64_t after = irg::line_styled(a, b, irg::line_dashes{p, phase, o}, w, [](cell) {});
  for (std::uint64_t i = 0; i < 40; ++i) REQUIRE(oracle(p, after + i) == oracle(p, first + steps + i));
}

TEST_CASE("line_styled: every position as the pattern says, whatever the window") {
  test::random r(71);
  const int trials = std::getenv("IRG_RELEASE_TIER") ? 100000 : 2000;
  for (int i = 0; i < trials; ++i) {
    for (const auto& runs : {dash_runs{two_one}, dash_runs{three}, dash_runs{holes}, dash_runs{nothing}, dash_runs{}})
      check_against_oracle(runs, r);
    check_against_oracle(dash_mask{static_cast<std::uint16_t>(r.next()), static_cast<std::uint32_t>(r.integer(0, 6))},
                         r);
  }
}

TEST_CASE("line_styled: the pattern carries on over a polyline") {
  // A straight line cut in pieces shows the same dashes
  for (int from = 1; from < 20; ++from) {
    std::vector<cell> pieces;
    const auto keep = [&](cell c) { pieces.push_back(c); };
    const irg::line_options half{.ends = irg::line_ends::half_open};
    std::uint64_t phase =
        irg::line_styled({0, 0}, {from, 0}, irg::line_dashes{dash_runs{holes}, 4, half}, everything, keep);
    phase = irg::line_styled({from, 0}, {25, 0}, irg::line_dashes{dash_runs{holes}, phase, half}, {3, -5, 99, 5}, keep);
    irg::line_styled({25, 0}, {40, 0}, irg::line_dashes{dash_runs{holes}, phase}, everything, keep);
    std::vector<cell> expected;
    for (const cell c : cells({0, 0}, {40, 0}, dash_runs{holes}, 4))
      if (c.x < from || c.x >= 3) expected.push_back(c);
    REQUIRE(pieces == expected);
  }
}

TEST_CASE("line_styled: lines and runs as long as int allows") {
  static constexpr cell_window w{0, 0, 64, 64};
  // Position 2^31 at column 0: 2^31 = 3 * 715827882 + 2
  CHECK_BOTH(cells({least, 5}, {most, 5}, dash_runs{two_one}, 0, w).front() == cell{1, 5});
  CHECK_BOTH(cells({least, 5}, {most, 5}, dash_runs{two_one}, 0, w).size() == 42);
  CHECK_BOTH(cells({least, 5}, {most, 5}, dash_runs{long_runs}, 0, w).size() == 64);
  CHECK_BOTH(cells({least, 5}, {most, 5}, dash_runs{long_runs}, 4000000000u - (1u << 31) - 10u + 0u, w).size() == 10);
  CHECK_BOTH(cells({least, least}, {most, most}, dash_mask{0x5555, 4294967295u}, ~std::uint64_t{0}, w).size() <= 64);
  CHECK_BOTH(irg::line_styled({least, 5}, {most, 5}, irg::line_dashes{dash_runs{two_one}}, {}, [](cell) {}) ==
             4294967295u % 3);
  CHECK_BOTH(cells({0, 0}, {9, 9}, dash_runs{two_one}, 0, {5, 5, 5, 9}).empty());
  CHECK_BOTH(cells({0, 0}, {9, 9}, dash_runs{two_one}, 0, {5, 5, 1, 1}).empty());
}

TEST_CASE("draw_line_styled: paints those pixels, by value or by function, and nothing else") {
  constexpr auto bits = [] {
    irg::image<int> image(8, 2);
    const std::uint64_t phase = irg::draw_line_styled(image, {-3, 0}, {7, 0}, irg::line_dashes{dash_runs{two_one}}, 1);
    irg::draw_line_styled(irg::within(image, {-5, -5, 6, 9}), {0, 1}, {7, 1}, irg::line_dashes{dash_mask{0x00f3}},
                          [](int there) { return there + 1; });
    int n = 0;
    for (int i = 0; i < 16; ++i) n |= image(i % 8, i / 8) << i;
    return phase == 1 ? n : -1;
  };
  CHECK_BOTH(bits() == (0b11011011 | 0b00110011 << 8));
  test::framed_raster<std::uint16_t> framed;
  auto& view = framed.view;
  irg::draw_line_styled(irg::within(view, {-100, -100, 100, 100}), {-99, -77}, {99, 88},
                        irg::line_dashes{dash_runs{three}}, std::uint16_t{1});
  irg::draw_line_styled(view, {-99, 3}, {99, 3}, irg::line_dashes{dash_mask{0x7777}}, std::uint16_t{1});
  CHECK(framed.frame_is_whole());
  CHECK(framed.painted() > 5);
}

}  // namespace
