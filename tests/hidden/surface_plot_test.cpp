// SPDX-License-Identifier: MIT
#include <irg/hidden/surface_plot.hpp>

#include <limits>

#include "support/check_both.hpp"

TEST_CASE("height_colour: blue below, red above, whatever is asked for") {
  constexpr irg::rgba8 low = irg::height_colour(0.0), high = irg::height_colour(1.0);
  CHECK_BOTH(low.b > low.r);
  CHECK_BOTH(high.r > high.b);
  CHECK_BOTH(irg::height_colour(-5.0) == low);
  CHECK_BOTH(irg::height_colour(1e300) == high);
  CHECK_BOTH(irg::height_colour(0.25).b == 180);  // a stop
  CHECK(irg::height_colour(std::numeric_limits<double>::quiet_NaN()) == low);
}

TEST_CASE("surface_plot: nothing in it, and the options that stand unless said otherwise") {
  const irg::surface_plot p;
  CHECK(p.lines.size() + p.facets.size() + p.axes.size() + p.labels.size() == 0);
  const irg::surface_plot_options o;
  CHECK(o.style == irg::surface_style::lines);
  CHECK(o.width == 640);
}
