// SPDX-License-Identifier: MIT
#include <irg/io/svg_plot.hpp>

#include <string>

#include <irg/hidden/height_grid.hpp>

#include "support/check_both.hpp"

TEST_CASE("write_svg_plot: a line for each line, a region for each facet, strokes for texts") {
  const auto g = irg::sample_heights([](double x, double z) { return x - z; }, irg::sample_range{0, 1, 4},
                                     irg::sample_range{0, 1, 3});
  for (const auto style : {irg::surface_style::lines, irg::surface_style::facets}) {
    const auto plot = irg::plot_surface(g.surface(), irg::surface_plot_options{.style = style});
    REQUIRE(plot.ok());
    std::string text;
    auto sink = [&](std::string_view piece) { text += piece; };
    irg::write_svg_plot(sink, plot.value);
    const auto count = [&](std::string_view word) {
      std::size_t n = 0;
      for (std::size_t at = text.find(word); at != text.npos; at = text.find(word, at + 1)) ++n;
      return n;
    };
    CHECK(text.rfind("</svg>\n") == text.size() - 7);
    CHECK(count("<path") == plot.value.facets.size());
    CHECK(count("<g ") == count("</g>"));
    const std::size_t drawn = plot.value.axes.size() + plot.value.lines.size() + 4 * plot.value.facets.size();
    CHECK(count("<line") > drawn + 2 * plot.value.labels.size());
    CHECK(count("nan") + count("inf") == 0);
  }
}
