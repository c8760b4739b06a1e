// SPDX-License-Identifier: MIT
#include <irg/raster/line_run_slice.hpp>

#include <vector>

#include <irg/raster/line_bresenham.hpp>

#include "support/check_both.hpp"
#include "support/line_oracle.hpp"
#include "support/line_properties.hpp"

namespace {

using irg::cell;
using irg::line_run;
using test::cells;
using runs = std::vector<line_run>;
constexpr irg::cell_window everything{test::least, test::least, test::most, test::most};

constexpr runs slice(cell a, cell b, irg::cell_window w = everything, irg::line_options options = {}) {
  runs out;
  irg::line_run_slice(a, b, w, [&](const line_run& run) { out.push_back(run); }, options);
  return out;
}

// The cells of a run, one by one; a run that is neither row nor column has none.
template <class Emit>
constexpr void each_cell(const line_run& run, const Emit& emit) {
  if (run.first.x != run.last.x && run.first.y != run.last.y) return;
  const int dx = (run.last.x > run.first.x) - (run.last.x < run.first.x);
  const int dy = (run.last.y > run.first.y) - (run.last.y < run.first.y);
  cell c = run.first;
  emit(c);
  while (c != run.last) {
    c = {c.x + dx, c.y + dy};
    emit(c);
  }
}

TEST_CASE("line_run_slice: the course's values, (10,10)-(200,100): 91 runs, 82 of 2 cells, 9 of 3") {
  const runs line = slice({10, 10}, {200, 100});
  CHECK(line.size() == 91);
  int count[4] = {};
  for (const line_run& run : line) {
    CHECK(run.first.y == run.last.y);
    ++count[run.last.x - run.first.x + 1];
  }
  CHECK(count[2] == 82);
  CHECK(count[3] == 9);
  CHECK(line[9] == line_run{{28, 19}, {30, 19}});
}

TEST_CASE("line_run_slice: by hand") {
  CHECK_BOTH(slice({0, 0}, {4, 2}) == runs{{{0, 0}, {1, 0}}, {{2, 1}, {3, 1}}, {{4, 2}, {4, 2}}});
  CHECK_BOTH(slice({4, 2}, {0, 0}) == runs{{{4, 2}, {3, 2}}, {{2, 1}, {1, 1}}, {{0, 0}, {0, 0}}});
  CHECK_BOTH(slice({0, 0}, {2, -5}) == runs{{{0, 0}, {0, -1}}, {{1, -2}, {1, -3}}, {{2, -4}, {2, -5}}});
  CHECK_BOTH(slice({9, 4}, {-3, 4}) == runs{{{9, 4}, {-3, 4}}});
  CHECK_BOTH(slice({4, 9}, {4, -3}) == runs{{{4, 9}, {4, -3}}});
  CHECK_BOTH(slice({1, 1}, {3, 3}) == runs{{{1, 1}, {1, 1}}, {{2, 2}, {2, 2}}, {{3, 3}, {3, 3}}});
  CHECK_BOTH(slice({7, 7}, {7, 7}) == runs{{{7, 7}, {7, 7}}});
  CHECK_BOTH(slice({7, 7}, {7, 7}, everything, {.ends = irg::line_ends::half_open}).empty());
  CHECK_BOTH(slice({0, 0}, {4, 2}, {1, 0, 3, 9}) == runs{{{1, 0}, {1, 0}}, {{2, 1}, {2, 1}}});
  CHECK_BOTH(slice({0, 0}, {4, 2}, {3, 3, 1, 1}).empty());
}

TEST_CASE("line_run_slice: whole int: one run of 64 cells, and ends at the extremes") {
  CHECK_BOTH(slice({test::least, 5}, {test::most, 5}, {0, 0, 64, 64}) == runs{{{0, 5}, {63, 5}}});
  CHECK_BOTH(slice({test::most, 3}, {test::least, 4}, {-5, 0, 5, 9}) == runs{{{4, 3}, {0, 3}}, {{-1, 4}, {-5, 4}}});
  CHECK_BOTH(slice({test::least, test::least}, {test::most, test::most}, {0, 0, 9, 9}).size() == 9);
  constexpr auto whole = [] {
    runs out;
    irg::line_run_slice({test::least, 5}, {test::most, 6}, [&](const line_run& run) { out.push_back(run); });
    return out;
  };
  CHECK_BOTH(whole() == runs{{{test::least, 5}, {-1, 5}}, {{0, 6}, {test::most, 6}}});
}

TEST_CASE("line_run_slice: runs are maximal: each is in the next row or column") {
  for (int y = -9; y <= 9; ++y) {
    const runs line = slice({0, 0}, {20, y});
    CHECK(line.size() == static_cast<std::size_t>(y < 0 ? -y : y) + 1);
    for (std::size_t i = 1; i < line.size(); ++i) CHECK(line[i].first.y == line[i - 1].first.y + (y < 0 ? -1 : 1));
  }
}

constexpr auto draw = [](cell a, cell b, const irg::cell_window& w, const irg::line_options& options, auto&& emit) {
  irg::line_run_slice(a, b, w, [&](const line_run& run) { each_cell(run, emit); }, options);
};

TEST_CASE("line_run_slice: every line of a lattice and the whole int range against the oracle, all options") {
  test::check_window_line(draw);
}

TEST_CASE("line_run_slice: the four criteria") {
  test::check_line_criteria([](cell a, cell b) {
    cells line;
    draw(a, b, everything, {}, [&](cell c) { line.push_back(c); });
    return line;
  });
}

}  // namespace
