// SPDX-License-Identifier: MIT
#include <irg/hidden/plot_ticks.hpp>

#include <cmath>
#include <limits>
#include <string>

#include "support/check_both.hpp"
#include "support/random.hpp"

namespace {

std::string texts(double low, double high, int most) {
  std::string all;
  for (const irg::axis_tick& t : irg::axis_ticks(low, high, most))
    all.append(all.empty() ? "" : " ").append(std::string_view(t.text));
  return all;
}

}  // namespace

TEST_CASE("axis_ticks: round numbers, as a person writes them") {
  CHECK(texts(0, 1, 5) == "0 0.2 0.4 0.6 0.8 1");
  CHECK(texts(-1, 3, 5) == "-1 0 1 2 3");
  CHECK(texts(0.13, 0.19, 4) == "0.14 0.16 0.18");
  CHECK(texts(-3.14159, 3.14159, 5) == "-2 0 2");
  CHECK(texts(1850, 2020, 4) == "1850 1900 1950 2000");
  CHECK(texts(0, 1e9, 5) == "0 2e+08 4e+08 6e+08 8e+08 1e+09");
  CHECK(texts(0, 3e-7, 3) == "0 1e-07 2e-07 3e-07");
  CHECK(texts(0, 0.3, 3) == "0 0.1 0.2 0.3");  // 3 * 0.1 is another double
  CHECK(texts(0, 5e-6, 5) == "0 1e-06 2e-06 3e-06 4e-06 5e-06");  // 5 * 1e-6 is less
  CHECK(texts(-1e-3, 1e-3, 2) == "-0.001 0 0.001");
}

TEST_CASE("axis_ticks: within the range, evenly, neither too many nor too few") {
  test::random r(6);
  for (int i = 0; i < 3000; ++i) {
    const double low = std::ldexp(2 * r.unit() - 1, static_cast<int>(r.integer(-900, 900)));
    const double high = low + std::fabs(low) * std::ldexp(r.unit(), static_cast<int>(r.integer(-30, 4)));
    const int most = static_cast<int>(r.integer(1, 12));
    const auto ticks = irg::axis_ticks(low, high, most);
    if (!(low < high)) continue;
    REQUIRE(ticks.size() <= static_cast<std::size_t>(most) + 1);
    CHECK(2 * ticks.size() + 3 > static_cast<std::size_t>(most) * 2 / 5);
    for (std::size_t k = 0; k < ticks.size(); ++k) {
      CHECK(ticks[k].value >= low);
      CHECK(ticks[k].value <= high);
      CHECK(std::stod(std::string(std::string_view(ticks[k].text))) == ticks[k].value);
      CHECK(std::string_view(ticks[k].text).size() < 24);
      if (k > 0) CHECK(ticks[k - 1].value < ticks[k].value);
    }
  }
}

TEST_CASE("axis_ticks: one number, no numbers, the ends of the doubles") {
  constexpr double inf = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();
  constexpr double most = std::numeric_limits<double>::max(), least = std::numeric_limits<double>::denorm_min();
  CHECK_BOTH(irg::axis_tick{}.value == 0);
  CHECK(texts(2.5, 2.5, 5) == "2.5");
  CHECK(texts(-0.0, 0.0, 5) == "0");
  CHECK(texts(1, 0, 5).empty());
  CHECK(texts(nan, 1, 5).empty());
  CHECK(texts(0, inf, 5).empty());
  CHECK(irg::axis_ticks(-most, most, 5).size() == 2);
  CHECK(irg::axis_ticks(0, least, 5).size() == 2);
  CHECK(irg::axis_ticks(1e15, 1e15 + 1, 5).size() == 2);  // too close to be told apart in a few digits
  CHECK(irg::axis_ticks(0, most, 5).size() >= 2);
  CHECK(irg::axis_ticks(1e15, 1e15 + 40, 30).size() == 21);
  CHECK(irg::axis_ticks(1e15, 1e15 + 40, 1000000).size() == 2);  // more than there are doubles
  CHECK(irg::axis_ticks(-1e15 - 40, -1e15, 1000).size() == 2);
}
