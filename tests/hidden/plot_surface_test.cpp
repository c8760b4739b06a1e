// SPDX-License-Identifier: MIT
#include <irg/hidden/plot_surface.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <string>
#include <tuple>
#include <vector>

#include <irg/hidden/height_grid.hpp>
#include <irg/hidden/horizon_curves.hpp>
#include <irg/raster/image.hpp>

#include "support/check_both.hpp"
#include "support/random.hpp"

using irg::grid_surface_status;
using irg::plot_surface;
using irg::sample_range;
using irg::surface_method;
using irg::surface_plot_options;
using irg::surface_style;

namespace {

constexpr double gap = std::numeric_limits<double>::quiet_NaN();

irg::height_grid ripples(int n) {
  return irg::sample_heights([](double x, double z) { return std::cos(2 * std::hypot(x, z)); }, sample_range{-4, 4, n},
                             sample_range{-4, 4, n});
}

// How many of a plot's labels lie outside of it, or on each other, or so near in a row that they read as one.
int unreadable(const irg::surface_plot& p) {
  int wrong = 0;
  const auto box = [](const irg::plot_label& l) {
    const auto e = irg::measure_text(l.text, l.style.size);
    return std::array{l.at.x, l.at.y - 0.4 * l.style.size, l.at.x + e.width, l.at.y + 0.4 * l.style.size};
  };
  for (std::size_t i = 0; i < p.labels.size(); ++i) {
    const auto a = box(p.labels[i]);
    wrong += a[0] < 0 || a[1] < 0 || a[2] > p.width || a[3] > p.height;
    for (std::size_t k = 0; k < i; ++k) {
      const auto b = box(p.labels[k]);
      const double space = 0.25 * p.labels[i].style.size;
      wrong += a[0] < b[2] + space && b[0] < a[2] + space && a[1] < b[3] && b[1] < a[3];
    }
  }
  return wrong;
}

}  // namespace

TEST_CASE("plot_surface: which method, and why") {
  irg::height_grid g = ripples(21);
  const auto method = [&](const surface_plot_options& o) {
    const auto p = plot_surface(g.surface(), o);
    CHECK(p.ok());
    CHECK(std::string(p.value.why).size() > 20);
    return p.value.method;
  };
  CHECK(method({}) == surface_method::perimeter);
  CHECK(method({.elevation_degrees = 85}) == surface_method::perimeter);
  CHECK(method({.style = surface_style::facets}) == surface_method::facets_far_to_near);
  g.heights[100] = gap;
  CHECK(method({}) == surface_method::floating_horizon);
  CHECK(method({.elevation_degrees = 89}) == surface_method::facets_far_to_near);
}

TEST_CASE("plot_surface: labels in the picture, none on another, from everywhere, in small pictures too") {
  const irg::height_grid g = ripples(9);
  for (int azimuth = -180; azimuth <= 180; azimuth += 20)
    for (const int elevation : {-70, -25, 0, 10, 30, 60, 88}) {
      const auto p = plot_surface(g.surface(), {.azimuth_degrees = azimuth + 0.0,
                                                .elevation_degrees = elevation + 0.0,
                                                .x = "length of it",
                                                .y = "height",
                                                .z = "width"});
      REQUIRE(p.ok());
      CHECK(unreadable(p.value) == 0);
      CHECK(p.value.labels.size() >= 9);
      for (const irg::plot_line& l : p.value.lines)
        REQUIRE((l.from.x > 0 && l.from.x < 640 && l.from.y > 0 && l.from.y < 480));
    }
  CHECK(unreadable(plot_surface(g.surface(), {.width = 200, .height = 150, .text_size = 10}).value) == 0);
}

TEST_CASE("plot_surface: gaps leave out what touches them, filled facets are as many as the grid's") {
  irg::height_grid g = ripples(11);
  const auto full = plot_surface(g.surface(), {.style = surface_style::facets});
  CHECK(full.value.facets.size() == 100);
  g.heights[5 * 11 + 5] = gap;
  CHECK(plot_surface(g.surface(), {.style = surface_style::facets}).value.facets.size() == 96);
  const auto lines = plot_surface(g.surface());
  CHECK(lines.value.method == surface_method::floating_horizon);
  CHECK(lines.value.lines.size() > 60);
}

TEST_CASE("plot_surface: what is no surface, options out of range") {
  irg::height_grid g = ripples(3);
  const auto refused = [&](const surface_plot_options& o) { return plot_surface(g.surface(), o).status; };
  CHECK(refused({.width = 0}) == grid_surface_status::not_a_grid);
  CHECK(refused({.azimuth_degrees = gap}) == grid_surface_status::not_a_grid);
  CHECK(refused({.distance = 0}) == grid_surface_status::not_a_grid);
  CHECK(refused({.tallness = -1}) == grid_surface_status::not_a_grid);
  CHECK(plot_surface(irg::grid_surface{}).status == grid_surface_status::not_a_grid);
  for (double& h : g.heights) h = gap;
  CHECK(refused({}) == grid_surface_status::not_a_grid);
  for (double& h : g.heights) h = 7;  // level: one tick on its axis
  CHECK(plot_surface(g.surface()).ok());
  for (std::size_t k = 0; k < g.heights.size(); ++k) g.heights[k] = k % 2 == 0 ? 1e307 : -1e307;
  CHECK(plot_surface(g.surface()).ok());
  g.z[1] = g.z[0];
  CHECK(refused({}) == grid_surface_status::not_a_grid);
}

TEST_CASE("plot_surface: a level surface from straight above and below") {
  for (const double height : {0.0, 7.0, -3.3, 1e16, 1e300, 1e-300})
    for (const double elevation : {90.0, -90.0, 60.0}) {
      const irg::height_grid level =
          irg::sample_heights([&](double, double) { return height; }, sample_range{0, 2, 3}, sample_range{0, 2, 3});
      const auto p = plot_surface(level.surface(), {.elevation_degrees = elevation, .distance = 0.9});
      CHECK(p.ok());
      CHECK(p.value.lines.size() == 12);
    }
}

TEST_CASE("plot_surface: an eye near the largest number is one, one beyond it has no picture by any method") {
  const auto plot = [](double from, double to, surface_style style, bool has_gap) {
    irg::height_grid g = irg::sample_heights([](double x, double z) { return std::fmod(x, 3) + z; },
                                             sample_range{0, 2, 3}, sample_range{0, 2, 3});
    g.x = {from, from / 2 + to / 2, to};
    if (has_gap) g.heights[0] = gap;
    return plot_surface(g.surface(), {.style = style});
  };
  for (const surface_style style : {surface_style::lines, surface_style::facets})
    for (const bool has_gap : {false, true}) {
      const auto far = plot(1e308, 1.1e308, style, has_gap), near = plot(10, 11, style, has_gap);
      CHECK(far.ok());
      CHECK(far.value.lines.size() == near.value.lines.size());
      REQUIRE(far.value.facets.size() == near.value.facets.size());
      for (std::size_t i = 0; i < far.value.facets.size(); ++i)
        CHECK(std::abs(far.value.facets[i].corners[0].x - near.value.facets[i].corners[0].x) < 0.01);
      CHECK(plot(-1.5e308, 1.5e308, style, has_gap).status == grid_surface_status::not_a_grid);
    }
}

// The perimeter in space and the floating horizon of the same edges, projected and rounded: their visible lengths.
TEST_CASE("perimeter and floating horizon: one picture, apart from roundings") {
  test::random r(18);
  double hidden = 0, all = 0;
  for (int i = 0; i < 200; ++i) {
    const int n = static_cast<int>(r.integer(2, 9));
    std::vector<double> heights;
    for (int k = 0; k < n * n; ++k) heights.push_back(r.unit() * (i % 3 == 0 ? 0.2 : 1));
    const auto height_at = [&](double x, double z) {
      const auto p = static_cast<std::size_t>(std::lround(x * (n - 1))),
                 q = static_cast<std::size_t>(std::lround(z * (n - 1)));
      return heights[p * static_cast<std::size_t>(n) + q];
    };
    const auto side = [&] { return r.integer(0, 1) == 0 ? -0.2 - 2 * r.unit() : 1.2 + 2 * r.unit(); };
    irg::point<double, 3> eye{side(), 3 * r.unit() - 1, side()};
    if (i % 3 == 1) eye.x = r.unit();
    if (i % 3 == 2) eye.z = r.unit();
    const auto places = irg::places_of(sample_range{0, 1, n});
    std::map<std::tuple<int, int, int, int>, double> seen;
    const irg::grid_surface surface{places, places, heights};
    const auto done = visible_grid_edges(
        surface, eye, [&](const irg::grid_edge_part& p) { seen[{p.i1, p.j1, p.i2, p.j2}] += p.to - p.from; });
    REQUIRE(done.ok());
    irg::horizon_view v{1, 1, 0, 0, n, n};
    const auto curves = irg::horizon_curves_from(height_at, v, eye);
    // Which edge of the grid each step is: visited in the same order.
    std::vector<irg::point<double, 2>> plan;
    irg::detail::visit_horizon_samples(
        irg::detail::turned_view{v, 1, 1, 1, 0, 0}, {eye.x, eye.z},
        [&] {
          if (!plan.empty()) plan.push_back({gap, gap});
        },
        [&](double x, double z) { plan.push_back({x, z}); });
    REQUIRE(plan.size() == curves.points.size());
    irg::visible_curves(curves.points, [&](const irg::edge_part& p) {
      const auto a = plan[p.edge], b = plan[p.edge + 1];
      const auto index = [&](double t) { return static_cast<int>(std::lround(t * (n - 1))); };
      const double ahead_x = 0.5 - eye.x, ahead_z = 0.5 - eye.z;
      const auto depth = [&](const auto& q) { return (q.x - eye.x) * ahead_x + (q.y - eye.z) * ahead_z; };
      const auto in_space = [&](double t) { return t * depth(a) / ((1 - t) * depth(b) + t * depth(a)); };
      const auto low = std::min(std::pair{index(a.x), index(a.y)}, std::pair{index(b.x), index(b.y)});
      const auto high = std::max(std::pair{index(a.x), index(a.y)}, std::pair{index(b.x), index(b.y)});
      seen[{low.first, low.second, high.first, high.second}] -= in_space(p.to) - in_space(p.from);
    });
    for (const auto& [edge, difference] : seen) CHECK(std::fabs(difference) < 1e-6);
    hidden += static_cast<double>(done.value.hidden), all += static_cast<double>(done.value.edges);
  }
  CHECK(hidden > 0.1 * all);
}

TEST_CASE("draw_plot: something where lines, facets and texts are, the paper elsewhere") {
  const auto g = irg::sample_heights([](double x, double z) { return x * z; }, irg::sample_range{0, 1, 5},
                                     irg::sample_range{0, 1, 5});
  constexpr irg::rgba8 paper = irg::plot_colours{}.paper;
  for (const auto style : {irg::surface_style::lines, irg::surface_style::facets}) {
    const auto plot =
        irg::plot_surface(g.surface(), irg::surface_plot_options{.width = 240, .height = 180, .style = style});
    REQUIRE(plot.ok());
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
