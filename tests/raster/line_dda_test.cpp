// SPDX-License-Identifier: MIT
#include <irg/raster/line_dda.hpp>

#include <numeric>

#include <irg/raster/line_bresenham.hpp>
#include <irg/raster/line_cells.hpp>

#include "support/check_both.hpp"
#include "support/line_oracle.hpp"
#include "support/line_properties.hpp"
#include "support/random.hpp"
#include "support/rational.hpp"

namespace {

using irg::cell;
using test::cells;
constexpr irg::cell_window everything{test::least, test::least, test::most, test::most};

template <class Number = double>
constexpr cells dda(cell a, cell b) {
  cells out;
  irg::line_dda<Number>(a, b, [&](cell c) { out.push_back(c); });
  return out;
}
constexpr cells exact(cell a, cell b, irg::cell_window w = everything, irg::line_options options = {}) {
  cells out;
  irg::line_dda_exact(a, b, w, [&](cell c) { out.push_back(c); }, options);
  return out;
}

TEST_CASE("line_dda: straight, right ends, one cell per step, no gap") {
  test::check_line_criteria([](cell a, cell b) { return dda(a, b); });
  test::check_line_criteria([](cell a, cell b) { return dda<test::rational>(a, b); });
}

// Steps whose cell is not line_bresenham's; each must be a tie.
template <class Number>
void compare(int n, int m, std::int64_t& wrong, std::int64_t& wrong_off_ties) {
  std::int64_t i = 0;
  CHECK(irg::line_dda<Number>({0, 0}, {n, m}, [&](cell c) {
    if (c != irg::line_cells({0, 0}, {n, m})[i]) {
      ++wrong;
      wrong_off_ties += 2 * i * m % n != 0;
    }
    ++i;
  }));
}

TEST_CASE("line_dda: only ties are wrong, and none where the slope is a fraction of a power of 2 or exact") {
  std::int64_t wrong = 0, off_ties = 0, binary = 0;
  for (int n = 1; n <= 128; ++n)
    for (int m = 0; m <= n; ++m) {
      compare<double>(n, m, wrong, off_ties);
      compare<float>(n, m, wrong, off_ties);
      const int period = n / std::gcd(n, m);
      if ((period & (period - 1)) == 0) compare<double>(n, m, binary, off_ties);
      if (n < 40) compare<test::rational>(n, m, binary, off_ties);
    }
  CHECK(wrong > 0);
  CHECK(off_ties == 0);
  CHECK(binary == 0);
  CHECK_BOTH(dda({0, 0}, {12, 7})[6] == cell{6, 4});  // six times 7/12 is more than 3.5
  CHECK_BOTH(exact({0, 0}, {12, 7})[6] == cell{6, 3});
  test::random r(11);
  const int trials = test::release_tier() ? 300 : 6;
  for (int k = 0; k < trials; ++k) {
    const auto n = static_cast<int>(k == 0 ? 1 << 17 : r.integer(1 << 16, 1 << 17));
    compare<double>(n, static_cast<int>(k % 2 ? r.integer(0, n) : n - r.integer(0, 50)), wrong, off_ties);
  }
  CHECK(off_ties == 0);
}

TEST_CASE("line_dda: beyond its steps nothing comes out; ends at the extremes of int") {
  CHECK_BOTH(irg::line_dda_steps<double> == 1 << 26);
  CHECK_BOTH(irg::line_dda_steps<float> == 1 << 11);
  CHECK_BOTH(!irg::line_dda<float>({0, 0}, {0, 2049}, [](cell) {}));
  CHECK_BOTH(!irg::line_dda({test::least, 0}, {test::most, 0}, [](cell) {}));
  CHECK_BOTH(dda({7, 7}, {7, 7}) == cells{{7, 7}});
  CHECK_BOTH(dda({test::most, test::least}, {test::most - 2, test::least + 1}).back() ==
             cell{test::most - 2, test::least + 1});
}

TEST_CASE("line_dda_exact: by hand, ties on the side of the start, symmetric ties, half-open") {
  CHECK_BOTH(exact({0, 0}, {4, 2}) == cells{{0, 0}, {1, 0}, {2, 1}, {3, 1}, {4, 2}});
  CHECK_BOTH(exact({4, 2}, {0, 0}) == cells{{4, 2}, {3, 2}, {2, 1}, {1, 1}, {0, 0}});
  CHECK_BOTH(exact({4, 2}, {0, 0}, everything, {irg::line_ends::half_open, irg::line_ties::symmetric}) ==
             cells{{4, 2}, {3, 1}, {2, 1}, {1, 0}});
  CHECK_BOTH(exact({3, 3}, {3, 3}) == cells{{3, 3}});
  CHECK_BOTH(exact({3, 3}, {3, 3}, everything, {.ends = irg::line_ends::half_open}).empty());
  CHECK_BOTH(exact({0, 0}, {-1, -1}) == cells{{0, 0}, {-1, -1}});
  CHECK_BOTH(exact({0, 0}, {3, 3}, {3, 3, 1, 1}).empty());
  CHECK_BOTH(exact({test::least, test::least}, {test::most, test::most}, {0, 0, 9, 9}).size() == 9);
  constexpr auto last_without_window = [] {
    cell last;
    irg::line_dda_exact({test::most - 2, test::most}, {test::most, test::most - 1}, [&](cell c) { last = c; });
    return last;
  };
  CHECK_BOTH(last_without_window() == cell{test::most, test::most - 1});
}

TEST_CASE("line_dda_exact: the four criteria") {
  test::check_line_criteria([](cell a, cell b) { return exact(a, b); });
}

TEST_CASE("line_dda_exact: every line of a lattice and the whole int range against the oracle, all options") {
  test::check_window_line([](cell a, cell b, const irg::cell_window& w, const irg::line_options& options, auto&& emit) {
    irg::line_dda_exact(a, b, w, emit, options);
  });
}

// The walk is as exact at its last step as it claims, and starts anew where it must.
TEST_CASE("line_dda_exact: cells far into the longest walks") {
  test::random r(12);
  std::int64_t wrong = 0;
  for (int k = 0; k < 20000; ++k) {
    const std::int64_t n = k % 3 == 0 ? (std::int64_t{1} << 32) - 1 : r.integer(1, (std::int64_t{1} << 32) - 1);
    const std::int64_t m = k % 2 ? r.integer(0, n) : (k % 4 == 0 ? n - r.integer(0, n < 9 ? 0 : 9) : n / 2);
    const irg::detail::bresenham_frame f{n, m, 1, 1, false, {0, 0}, static_cast<int>(r.integer(0, 1))};
    const std::int64_t from = r.integer(0, n);
    const irg::detail::dda_walk walk = irg::detail::dda_walk_from(f, from);
    const std::int64_t room = n - from < walk.room ? n - from : walk.room;
    for (const std::int64_t j : {std::int64_t{0}, room / 2, room - (room > 0), room}) {
      __extension__ using wide = unsigned __int128;
      const wide sum = wide{walk.fraction} + static_cast<wide>(j) * walk.slope;
      wrong += walk.aside + static_cast<std::int64_t>(sum >> 64) != f.aside_at(from + j);
    }
    wrong += walk.room < (std::int64_t{1} << 31) - 2;
  }
  CHECK(wrong == 0);
}

TEST_CASE("line_dda_exact: the lengths for which 32.32 and 16.16 suffice, as the header says") {
  const auto room = [](int bits, std::int64_t n) { return (std::int64_t{1} << bits) / (2 * n) - 2; };
  CHECK(room(32, 46339) >= 46339);
  CHECK(room(32, 46340) < 46340);
  CHECK(room(16, 180) >= 180);
  CHECK(room(16, 181) < 181);
}

}  // namespace
