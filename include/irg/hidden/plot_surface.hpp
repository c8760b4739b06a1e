// SPDX-License-Identifier: MIT
// plot_surface: a grid surface as a labelled picture, in one call: it chooses how hidden parts are found, and says why.
// The drawing is made of facets, lines and texts, for a raster (draw_plot.hpp) or a file (io/svg_plot.hpp).
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

#include <irg/core/vocabulary.hpp>
#include <irg/hidden/grid_surface.hpp>
#include <irg/hidden/surface_plot.hpp>
#include <irg/raster/draw_text.hpp>
#include <irg/raster/fill_convex_aa.hpp>
#include <irg/raster/fill_polygon_aa.hpp>
#include <irg/raster/line_aa.hpp>
#if IRG_BODIES
#include <irg/core/is_finite.hpp>
#include <irg/hidden/horizon_lines.hpp>
#include <irg/hidden/plot_ticks.hpp>
#include <irg/hidden/surface_camera.hpp>
#include <irg/math/trigonometry.hpp>
#endif

namespace irg {
inline namespace IRG_ABI {

/// A grid surface as a labelled picture: what is seen of it, coloured by height, with axes, ticks and texts.
/// shape   heights that are NaN or infinite are gaps: their edges and facets are left out
/// needs   a width and height of 1 or more
/// gives   nothing but the status for what is no grid, has no height at all, has the eye on it or beyond the largest
///         number, and for options that are not finite, with a distance or tallness that is not positive
/// exact   with perimeter and lines what is seen is decided exactly, for the eye that the options give, rounded; places
///         are rounded
/// cost    that of the method: visible_grid_edges, visible_curves, or a list of all facets
/// source  Special-cases chapter, 3 for the view
template <class Options = surface_plot_options, class Plot = surface_plot>
[[nodiscard]] constexpr checked<Plot, grid_surface_status> plot_surface(const grid_surface& surface,
                                                                        const Options& options = {});

/// Draws a plot: axes, facets with their edges, lines, texts. The paper is the raster's.
/// cost    that of the lines and texts
template <WritableRaster R>
  requires CoveragePaintFor<rgba8, R>
constexpr void draw_plot(R& raster, const surface_plot& plot, const plot_colours& colours = {}) {
  for (const plot_line& l : plot.axes) draw_line_aa(raster, l.from, l.to, l.colour);
  for (const plot_facet& f : plot.facets) {
    const std::array<std::array<point<double, 2>, 4>, 1> rings{f.corners};
    static_cast<void>(fill_polygon_aa(raster, rings, fill_rule::non_zero, f.colour));
    for (std::size_t k = 0; k < 4; ++k) draw_line_aa(raster, f.corners[k], f.corners[(k + 1) % 4], colours.edge);
  }
  for (const plot_line& l : plot.lines) draw_line_aa(raster, l.from, l.to, l.colour);
  for (const plot_label& l : plot.labels) draw_text(raster, l.text, l.at, l.style, colours.ink);
}

}  // namespace IRG_ABI
}  // namespace irg

namespace irg::detail::inline IRG_COMPILED_ABI {

template <class Plot, class Options>
IRG_API checked<Plot, grid_surface_status> plot_of(const grid_surface& surface, const Options& options);

}  // namespace irg::detail::inline IRG_COMPILED_ABI

namespace irg::inline IRG_ABI {

template <class Options, class Plot>
[[nodiscard]] constexpr checked<Plot, grid_surface_status> plot_surface(const grid_surface& surface,
                                                                        const Options& options) {
  static_assert(IRG_BODIES || (std::is_same_v<Options, surface_plot_options> && std::is_same_v<Plot, surface_plot>),
                "irg: define IRG_HEADER_ONLY before the first header of irg to plot with other types");
  return detail::plot_of<Plot>(surface, options);
}

}  // namespace irg::inline IRG_ABI

#if IRG_BODIES
namespace irg::detail {
inline namespace IRG_ABI {

// How a surface is seen: in a box of x and z from 0 to 1 and heights from 0 to the tallness, `middle` in the picture's
// middle and `unit` of the picture plane on a pixel.
template <class Options>
struct plot_view {
  const grid_surface& surface;
  const Options& options;
  surface_box data{};
  surface_camera camera{};
  point<double, 3> eye{};  // in the data's space
  point<double, 2> middle{0, 0};
  double unit = 1;

  constexpr point<double, 3> boxed(const point<double, 3>& p) const noexcept {
    const auto share = [](double v, double low, double high) {
      const double half = high / 2 - low / 2;
      return half > 0 ? (v / 2 - low / 2) / half : 0.5;
    };
    return {share(p.x, data.low.x, data.high.x), share(p.y, data.low.y, data.high.y) * options.tallness,
            share(p.z, data.low.z, data.high.z)};
  }
  constexpr point<double, 3> unboxed(const point<double, 3>& p) const noexcept {
    const auto number = [](double t, double low, double high) {
      if (low == high) return low + product(t - 0.5, 1 + magnitude(low) * 0x1p-20);  // level: above or below, as seen
      const double v = product(low, 1 - t) + product(high, t);
      return is_number(v) ? v : 2 * (low / 2 + product(high / 2 - low / 2, t));  // where the products alone overflow
    };
    return {number(p.x, data.low.x, data.high.x), number(p.y / options.tallness, data.low.y, data.high.y),
            number(p.z, data.low.z, data.high.z)};
  }
  constexpr double share_of(double height) const noexcept { return boxed({0, height, 0}).y / options.tallness; }

  constexpr double x_at(int i) const noexcept { return surface.x[static_cast<std::size_t>(i)]; }
  constexpr double z_at(int j) const noexcept { return surface.z[static_cast<std::size_t>(j)]; }
  constexpr point<double, 3> point_at(int i, int j) const noexcept {
    const auto k = static_cast<std::size_t>(i) * surface.z.size() + static_cast<std::size_t>(j);
    return {x_at(i), surface.heights[k], z_at(j)};
  }
  constexpr bool is_over_grid() const noexcept {
    return surface.x.front() <= eye.x && eye.x <= surface.x.back() && surface.z.front() <= eye.z &&
           eye.z <= surface.z.back();
  }

  constexpr std::optional<point<double, 2>> place_in_box(const point<double, 3>& p) const noexcept {
    const auto at = camera(p);
    if (!at) return std::nullopt;
    return point<double, 2>{options.width / 2.0 + (at->x - middle.x) / unit,
                            options.height / 2.0 - options.text_size - (at->y - middle.y) / unit};
  }
  constexpr std::optional<point<double, 2>> place(const point<double, 3>& p) const noexcept {
    return place_in_box(boxed(p));
  }
};

template <class Options>
constexpr plot_view<Options> place_camera(const grid_surface& surface, const Options& options) noexcept {
  plot_view<Options> view{surface, options, box_of_surface(surface)};
  const auto turn = sin_cos_degrees(options.azimuth_degrees), lift = sin_cos_degrees(options.elevation_degrees);
  const double diagonal = sqrt(2 + product(options.tallness, options.tallness));
  const double away = product(options.distance, diagonal), level = product(away, lift.cosine);
  const point<double, 3> eye{0.5 - product(level, turn.sine), options.tallness / 2 + product(away, lift.sine),
                             0.5 - product(level, turn.cosine)};
  view.camera = camera_on(surface_box{{0, 0, 0}, {1, options.tallness, 1}}, eye);
  view.eye = view.unboxed(eye);
  return view;
}

// Makes the box fit between the margins.
template <class View>
constexpr void fit_box(View& view) noexcept {
  const auto& options = view.options;
  const double text = options.text_size;
  point<double, 2> low{0, 0}, high{0, 0};
  for (int k = 0; k < 8; ++k) {
    const auto at = view.camera({k & 1 ? 1.0 : 0.0, k & 2 ? options.tallness : 0.0, k & 4 ? 1.0 : 0.0});
    if (!at) continue;
    low = k == 0 ? *at : point<double, 2>{minimum(low.x, at->x), minimum(low.y, at->y)};
    high = k == 0 ? *at : point<double, 2>{maximum(high.x, at->x), maximum(high.y, at->y)};
  }
  const double room_x = maximum(options.width - 11 * text, 0.3 * options.width);
  const double room_y = maximum(options.height - 7 * text, 0.3 * options.height);
  const double wide = (high.x - low.x) / room_x, tall = (high.y - low.y) / room_y;
  view.unit = maximum(wide, tall) > 0 ? maximum(wide, tall) : 1;
  view.middle = {(low.x + high.x) / 2, (low.y + high.y) / 2};
}

template <class View, class Plot>
constexpr void choose_method(const View& view, Plot& out) noexcept {
  bool whole = true;
  for (const double h : view.surface.heights) whole = whole && is_number(h);
  if (view.options.style == surface_style::facets) {
    out.method = surface_method::facets_far_to_near;
    out.why = "facets are filled, so nearby ones cover distant ones";
  } else if (whole) {
    out.method = surface_method::perimeter;
    out.why = view.is_over_grid() ? "the eye is over the grid, where horizons would not do"
                                  : "every point has a height, and the perimeter decides exactly what is seen";
  } else if (view.is_over_grid()) {
    out.method = surface_method::facets_far_to_near;
    out.why = "some points have no height and the eye is over the grid: facets cover each other";
  } else {
    out.method = surface_method::floating_horizon;
    out.why = "some points have no height, and the floating horizon leaves gaps";
  }
}

template <class View, class Plot>
constexpr void add_edge_part(const View& view, const grid_edge_part& p, Plot& out) {
  const auto a = view.point_at(p.i1, p.j1), b = view.point_at(p.i2, p.j2);
  const auto at = [&](double t) {
    return point<double, 3>{product(a.x, 1 - t) + product(b.x, t), product(a.y, 1 - t) + product(b.y, t),
                            product(a.z, 1 - t) + product(b.z, t)};
  };
  const auto from = at(p.from), to = at(p.to);
  const auto u = view.place(from), v = view.place(to);
  if (u && v) out.lines.push_back({*u, *v, height_colour((view.share_of(from.y) + view.share_of(to.y)) / 2)});
}

// Every edge once, near ones first: the border that turns to the eye, then those that facets add.
template <class View, class Visit>
constexpr void each_grid_edge(const View& view, const Visit& visit) {
  const point<double, 3>& eye = view.eye;
  const grid_covering loops = covering_loops(view.surface.x, view.surface.z, eye.x, eye.z);
  for (int j = 0; j < loops.m; ++j) {
    if (view.x_at(0) >= eye.x) visit(0, j, true);
    if (view.x_at(loops.n) < eye.x) visit(loops.n, j, true);
  }
  for (int i = 0; i < loops.n; ++i) {
    if (view.z_at(0) >= eye.z) visit(i, 0, false);
    if (view.z_at(loops.m) < eye.z) visit(i, loops.m, false);
  }
  visit_in_covering_order(loops, [&](const grid_facet& f) {
    if (view.z_at(f.j - 1) < eye.z) visit(f.i - 1, f.j - 1, false);
    if (view.x_at(f.i) >= eye.x) visit(f.i, f.j - 1, true);
    if (view.z_at(f.j) >= eye.z) visit(f.i - 1, f.j, false);
    if (view.x_at(f.i - 1) < eye.x) visit(f.i - 1, f.j - 1, true);
  });
}

// The facets' edges from near to far, each once, before an upright picture plane.
template <class View, class Plot>
constexpr void add_horizon(const View& view, Plot& out) {
  struct edge {
    grid_edge_part whole;
    double depth[2];
  };
  constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
  const point<double, 3> eye = view.boxed(view.eye);
  const double dx = 0.5 - eye.x, dz = 0.5 - eye.z;
  std::vector<edge> edges;
  std::vector<point<double, 2>> points;
  const auto upright = [&](const point<double, 3>& data, double& depth) {
    const point<double, 3> p = view.boxed(data);
    depth = product(p.x - eye.x, dx) + product(p.z - eye.z, dz);
    if (!(depth > 0) || !is_number(p.y)) return point<double, 2>{nothing, nothing};
    return point<double, 2>{(product(p.x - eye.x, dz) - product(p.z - eye.z, dx)) / depth, (p.y - eye.y) / depth};
  };
  each_grid_edge(view, [&](int i, int j, bool along_z) {
    edge e{{i, j, i + (along_z ? 0 : 1), j + (along_z ? 1 : 0), 0, 1}, {0, 0}};
    points.push_back(upright(view.point_at(i, j), e.depth[0]));
    points.push_back(upright(view.point_at(e.whole.i2, e.whole.j2), e.depth[1]));
    points.push_back({nothing, nothing});
    edges.push_back(e);
  });
  visible_curves(points, [&](const edge_part& p) {
    edge e = edges[p.edge / 3];
    const auto in_space = [&](double t) {
      return product(t, e.depth[0]) / (product(1 - t, e.depth[1]) + product(t, e.depth[0]));
    };
    e.whole.from = in_space(p.from);
    e.whole.to = in_space(p.to);
    add_edge_part(view, e.whole, out);
  });
}

template <class View, class Plot>
constexpr void add_facets(const View& view, Plot& out) {
  const grid_covering loops = covering_loops(view.surface.x, view.surface.z, view.eye.x, view.eye.z);
  visit_in_covering_order(loops, [&](const grid_facet& f) {
    constexpr int corners[4][2] = {{1, 1}, {0, 1}, {0, 0}, {1, 0}};
    plot_facet facet{};
    double sum = 0;
    for (std::size_t k = 0; k < 4; ++k) {
      const auto p = view.point_at(f.i - corners[k][0], f.j - corners[k][1]);
      const auto at = is_number(p.y) ? view.place(p) : std::nullopt;
      if (!at) return;
      facet.corners[k] = *at;
      sum += view.share_of(p.y) / 4;
    }
    facet.colour = height_colour(sum);
    out.facets.push_back(facet);
  });
  std::reverse(out.facets.begin(), out.facets.end());
}

// A text that begins at a place and lies beyond it in a direction; none where it would lie on another or touch it.
template <class Plot>
constexpr bool add_label(Plot& out, const plot_text& text, const point<double, 2>& at, const vec<double, 2>& d,
                         double size) {
  const double width = measure_text(text, size).width;
  const double x = at.x + product(d.x - 1, width / 2), y = at.y + product(d.y, size / 2);
  const double left = clamped(x, 1.0, maximum(1.0, out.width - width - 1));
  const double middle = clamped(y, size / 2 + 1, maximum(size, out.height - size / 2 - 1));
  for (const auto& l : out.labels) {
    const double other = measure_text(l.text, l.style.size).width, apart = (size + l.style.size) * 0.45;
    const double gap = size * 0.3, right = left + width;
    if (left < l.at.x + other + gap && l.at.x < right + gap && magnitude(middle - l.at.y) < apart) return false;
  }
  out.labels.push_back({text, {left, middle}, {.size = size, .across = text_across::middle}});
  return true;
}

struct plot_axis {
  double low, high;
  point<double, 3> from;
  vec<double, 3> along, away;
  const plot_text& name;
};

// Ticks that point away from the box, their texts beyond, the axis's name beyond them.
template <class View, class Plot>
constexpr void add_axis(const View& view, const plot_axis& a, Plot& out) {
  constexpr plot_colours colours;
  const auto spot = [&](double share) {
    return point<double, 3>{a.from.x + product(share, a.along.x), a.from.y + product(share, a.along.y),
                            a.from.z + product(share, a.along.z)};
  };
  const auto end = view.place_in_box(spot(0)), other = view.place_in_box(spot(1));
  const auto middle = view.place_in_box(spot(0.5));
  const auto beside = view.place_in_box({spot(0.5).x + 0.05 * a.away.x, spot(0.5).y, spot(0.5).z + 0.05 * a.away.z});
  if (!end || !other || !middle || !beside) return;
  out.axes.push_back({*end, *other, colours.ink});
  vec<double, 2> d{beside->x - middle->x, beside->y - middle->y};
  const double size = sqrt(product(d.x, d.x) + product(d.y, d.y));
  if (!(size > 0)) return;
  d = {d.x / size, d.y / size};
  const double text = view.options.text_size;
  double widest = 0;
  for (const axis_tick& tick : axis_ticks(a.low, a.high, out.width < 400 ? 3 : 5)) {
    const double share = a.high > a.low ? (tick.value / 2 - a.low / 2) / (a.high / 2 - a.low / 2) : 0.5;
    const auto at = view.place_in_box(spot(share));
    if (!at) continue;
    out.axes.push_back({*at, {at->x + 6 * d.x, at->y + 6 * d.y}, colours.ink});
    widest = maximum(widest, measure_text(tick.text, text).width);
    add_label(out, tick.text, {at->x + 10 * d.x, at->y + 10 * d.y}, d, text);
  }
  const double distant = 16 + product(magnitude(d.x), widest) + product(magnitude(d.y), text);
  for (int tries = 0; tries < 8; ++tries) {  // farther out until it stands alone
    const double away = distant + tries * text;
    if (add_label(out, a.name, {middle->x + away * d.x, middle->y + away * d.y}, d, text * 1.1)) break;
  }
}

// Along the box's edges nearest to the eye, which nothing covers: x and z at the bottom (seen from below: at the
// top), the heights at the left end.
template <class View, class Plot>
constexpr void add_axes(const View& view, Plot& out) {
  const point<double, 3>&eye = view.camera.eye, &low = view.data.low, &high = view.data.high;
  const double t = view.options.tallness, near_x = eye.x < 0.5 ? 0 : 1, near_z = eye.z < 0.5 ? 0 : 1;
  const double floor = eye.y < t / 2 ? t : 0;
  const auto add_line = [&](const point<double, 3>& a, const point<double, 3>& b) {
    const auto u = view.place_in_box(a), v = view.place_in_box(b);
    if (u && v) out.axes.push_back({*u, *v, rgba8{196, 192, 182, 255}});
  };
  for (int k = 0; k < 4; ++k) {  // the box's other edges on the floor, and the upright ones
    const double x = k & 1 ? 1 : 0, z = k & 2 ? 1 : 0;
    if (x != near_x || z != near_z) add_line({x, 0, z}, {x, t, z});
  }
  add_line({0, floor, near_z}, {1, floor, near_z});
  add_line({near_x, floor, 0}, {near_x, floor, 1});
  const double out_x = near_x == 0 ? -1 : 1, out_z = near_z == 0 ? -1 : 1;
  add_axis(view, {low.x, high.x, {0, floor, near_z}, {1, 0, 0}, {0, 0, out_z}, view.options.x}, out);
  add_axis(view, {low.z, high.z, {near_x, floor, 0}, {0, 0, 1}, {out_x, 0, 0}, view.options.z}, out);
  // Of the two upright edges at the picture's sides the left one.
  const point<double, 3> one{1 - near_x, 0, near_z}, two{near_x, 0, 1 - near_z};
  const auto a = view.place_in_box(one), b = view.place_in_box(two);
  const bool first = a && b && a->x < b->x;
  const vec<double, 3> away = first ? vec<double, 3>{-out_x, 0, 0} : vec<double, 3>{0, 0, -out_z};
  add_axis(view, {low.y, high.y, first ? one : two, {0, t, 0}, away, view.options.y}, out);
}

// A grid of which heights may be missing.
template <class Surface>
constexpr bool is_grid_with_gaps(const Surface& s) {
  std::vector<double> zeros(s.heights.size(), 0.0);
  bool any = false;
  for (const double h : s.heights) any = any || is_number(h);
  return any && is_grid(grid_surface{s.x, s.z, zeros});
}

}  // namespace IRG_ABI
}  // namespace irg::detail

namespace irg::detail::inline IRG_COMPILED_ABI {

template <class Plot, class Options>
IRG_API checked<Plot, grid_surface_status> plot_of(const grid_surface& surface, const Options& options) {
  checked<Plot, grid_surface_status> plot{{}, grid_surface_status::not_a_grid};
  const auto is_positive = [](double v) { return v > 0x1p-20 && v < 0x1p20; };
  const bool usable = options.width > 0 && options.height > 0 && is_positive(options.distance) &&
                      is_positive(options.tallness) && is_positive(options.text_size) &&
                      magnitude(options.azimuth_degrees) < 0x1p20 && magnitude(options.elevation_degrees) < 0x1p20;
  if (!usable || !is_grid_with_gaps(surface)) return plot;
  auto view = place_camera(surface, options);
  if (!is_number(view.eye.x) || !is_number(view.eye.y) || !is_number(view.eye.z)) return plot;
  fit_box(view);
  Plot out{options.width, options.height};
  choose_method(view, out);
  plot.status = grid_surface_status::ok;
  if (out.method == surface_method::perimeter)
    plot.status =
        visible_grid_edges(surface, view.eye, [&](const grid_edge_part& p) { add_edge_part(view, p, out); }).status;
  else if (out.method == surface_method::floating_horizon)
    add_horizon(view, out);
  else
    add_facets(view, out);
  if (plot.status != grid_surface_status::ok) return plot;
  add_axes(view, out);
  plot.value = std::move(out);
  return plot;
}

}  // namespace irg::detail::inline IRG_COMPILED_ABI
#endif
