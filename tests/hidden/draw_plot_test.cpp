// SPDX-License-Identifier: MIT
#include <irg/hidden/draw_plot.hpp>

#include <irg/hidden/height_grid.hpp>
#include <irg/raster/image.hpp>

#include "support/check_both.hpp"

TEST_CASE("draw_plot: something where lines, facets and texts are, the paper elsewhere") {
  const auto g = irg::sample_heights([](double x, double z) { return x * z; }, irg::sample_range{0, 1, 5},
                                     irg::sample_range{0, 1, 5});
  constexpr irg::rgba8 paper = irg::plot_colours{}.paper;
  for (const auto style : {irg::surface_style::lines, irg::surface_style::facets}) {
    const auto plot =
        irg::plot_surface(g.surface(), irg::surface_plot_options{.width = 240, .height = 180, .style = style});
    REQUIRE(plot.is_ordinary());
    irg::image<irg::rgba8> picture(240, 180, paper);
    irg::draw_plot(picture, plot.value);
    const auto is_inked = [&](const irg::point<double, 2>& at) {
      for (int y = static_cast<int>(at.y) - 1; y <= static_cast<int>(at.y) + 1; ++y)
        for (int x = static_cast<int>(at.x) - 1; x <= static_cast<int>(at.x) + 1; ++x)
          if (x >= 0 && y >= 0 && x < 240 && y < 180 && !(picture(x, y) == paper)) return true;
      return false;
    };
    for (const irg::plot_line& l : plot.value.lines)
      CHECK(is_inked({(l.from.x + l.to.x) / 2, (l.from.y + l.to.y) / 2}));
    for (const irg::plot_line& l : plot.value.axes) CHECK(is_inked({(l.from.x + l.to.x) / 2, (l.from.y + l.to.y) / 2}));
    int inked = 0;
    for (const irg::plot_label& l : plot.value.labels) {
      const double width = irg::measure_text(l.text, l.style.size).width;
      for (double x = l.at.x; x < l.at.x + width; x += 2) inked += is_inked({x, l.at.y}) ? 1 : 0;
    }
    CHECK(inked > static_cast<int>(plot.value.labels.size()));
    CHECK(picture(0, 179) == paper);
  }
}
