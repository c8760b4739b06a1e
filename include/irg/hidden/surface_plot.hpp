// SPDX-License-Identifier: MIT
// What a labelled picture of a surface consists of, and how it may look: plot_surface.hpp makes it, draw_plot.hpp and
// io/svg_plot.hpp draw it.
#pragma once

#include <array>
#include <vector>

#include <irg/colour/mix.hpp>
#include <irg/core/scalar.hpp>
#include <irg/hidden/plot_ticks.hpp>
#include <irg/math/vec.hpp>
#include <irg/raster/line_style.hpp>

namespace irg {

/// How a surface is drawn: the edges that are seen, or facets with their edges.
enum class surface_style { lines, facets };

/// How the parts that are seen are found.
enum class surface_method {
  perimeter,  // of the facets drawn so far: exact, every view
  floating_horizon,  // of the edges drawn so far: exact, with gaps, from beside the grid
  facets_far_to_near  // the covering order reversed: near facets cover far ones
};

/// How a plot looks.
/// shape   where the eye stands: azimuth_degrees at 0 before the least z, turning towards the least x
///         (positive), above (positive); distance in diagonals of the box, in which x and z are as long as each other
///         and heights `tallness` of that
struct surface_plot_options {
  int width = 640, height = 480;
  double azimuth_degrees = 35, elevation_degrees = 25, distance = 2.5, tallness = 0.6;
  surface_style style = surface_style::lines;
  plot_text x{"x"}, y{"y"}, z{"z"};  // beside the axes; y is the height
  double text_size = 14;
  bool operator==(const surface_plot_options&) const = default;
};

/// What a plot consists of, in the order in which it is drawn: pixels, y down.
struct plot_line {
  point<double, 2> from, to;
  rgba8 colour;
  bool operator==(const plot_line&) const = default;
};
struct plot_facet {
  std::array<point<double, 2>, 4> corners;
  rgba8 colour;
  bool operator==(const plot_facet&) const = default;
};
struct plot_label {
  plot_text text;
  point<double, 2> at;
  text_style style;
  bool operator==(const plot_label&) const = default;
};
struct surface_plot {
  int width = 0, height = 0;
  surface_method method = surface_method::perimeter;
  const char* why = "";  // in a sentence
  std::vector<plot_line> axes{};
  std::vector<plot_facet> facets{};  // far to near, each with its edges
  std::vector<plot_line> lines{};
  std::vector<plot_label> labels{};
};

/// The colours of a plot: of its paper, its axes and texts, the edges of facets.
struct plot_colours {
  rgba8 paper{250, 249, 246, 255}, ink{32, 44, 66, 255}, edge{46, 52, 64, 255};
  bool operator==(const plot_colours&) const = default;
};

inline namespace IRG_ABI {

/// The colour of a height, from 0 to 1: blue, sand, red.
template <class T>
[[nodiscard]] constexpr rgba8 height_colour(T share) noexcept {
  constexpr rgba8 stops[] = {
      {38, 66, 128, 255}, {62, 130, 180, 255}, {196, 178, 128, 255}, {206, 116, 58, 255}, {140, 36, 52, 255}};
  const T place = clamped(share, T(0), T(1)) * 4;
  const int k = minimum(static_cast<int>(place), 3);
  return mix(stops[k], stops[k + 1], static_cast<std::uint8_t>((place - static_cast<T>(k)) * 255));
}

}  // namespace IRG_ABI

}  // namespace irg
