// SPDX-License-Identifier: MIT
// plot_surface: a grid surface as a labelled picture, in one call: it chooses how hidden parts are found, and says why.
// The drawing is made of facets, lines and texts, for a raster (draw_plot.hpp) or a file (io/svg_plot.hpp).
#pragma once

#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include <irg/core/vocabulary.hpp>
#include <irg/hidden/grid_surface.hpp>
#include <irg/hidden/horizon_lines.hpp>
#include <irg/hidden/plot_ticks.hpp>
#include <irg/hidden/surface_camera.hpp>
#include <irg/hidden/surface_plot.hpp>
#include <irg/math/trigonometry.hpp>
#include <irg/raster/draw_text.hpp>
#include <irg/raster/fill_convex_aa.hpp>
#include <irg/raster/fill_polygon_aa.hpp>
#include <irg/raster/line_aa.hpp>

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

}  // namespace IRG_ABI

namespace detail {

// A point of the data in the box that the camera sees: x and z from 0 to 1, heights from 0 to the tallness.
struct plot_scale {
  surface_box data;
  double tallness;
};

inline namespace IRG_ABI {

constexpr point<double, 3> boxed(const plot_scale& s, const point<double, 3>& p) noexcept {
  const auto share = [](double v, double low, double high) {
    const double half = high / 2 - low / 2;
    return half > 0 ? (v / 2 - low / 2) / half : 0.5;
  };
  return {share(p.x, s.data.low.x, s.data.high.x), share(p.y, s.data.low.y, s.data.high.y) * s.tallness,
          share(p.z, s.data.low.z, s.data.high.z)};
}
constexpr point<double, 3> unboxed(const plot_scale& s, const point<double, 3>& p) noexcept {
  const auto number = [](double t, double low, double high) {
    if (low == high) return low + product(t - 0.5, 1 + magnitude(low) * 0x1p-20);  // level: above or below, as seen
    const double v = product(low, 1 - t) + product(high, t);
    return is_number(v) ? v : 2 * (low / 2 + product(high / 2 - low / 2, t));  // where the products alone overflow
  };
  return {number(p.x, s.data.low.x, s.data.high.x), number(p.y / s.tallness, s.data.low.y, s.data.high.y),
          number(p.z, s.data.low.z, s.data.high.z)};
}

// Makes a plot: the camera, then the parts of the surface, then the axes.
template <class Plot, class Options>
class plot_maker {
public:
  constexpr plot_maker(const grid_surface& surface, const Options& options)
      : surface_(surface), options_(options), scale_{box_of_surface(surface), options.tallness} {
    out_.width = options.width, out_.height = options.height;
    const auto turn = sin_cos_degrees(options.azimuth_degrees), lift = sin_cos_degrees(options.elevation_degrees);
    const double diagonal = sqrt(2 + product(options.tallness, options.tallness));
    const double away = product(options.distance, diagonal), level = product(away, lift.cosine);
    const point<double, 3> eye{0.5 - product(level, turn.sine), options.tallness / 2 + product(away, lift.sine),
                               0.5 - product(level, turn.cosine)};
    camera_ = camera_on(surface_box{{0, 0, 0}, {1, options.tallness, 1}}, eye);
    eye_ = unboxed(scale_, eye);
    fit();
  }

  constexpr grid_surface_status make(Plot& plot) {
    if (!is_number(eye_.x) || !is_number(eye_.y) || !is_number(eye_.z)) return grid_surface_status::not_a_grid;
    choose();
    const grid_surface_status status = out_.method == surface_method::facets_far_to_near ? draw_facets()
                                       : out_.method == surface_method::perimeter        ? draw_perimeter()
                                                                                         : draw_horizon();
    if (status != grid_surface_status::ok) return status;
    draw_axes();
    plot = static_cast<Plot&&>(out_);
    return status;
  }

private:
  constexpr int columns() const noexcept { return static_cast<int>(surface_.x.size()); }
  constexpr int rows() const noexcept { return static_cast<int>(surface_.z.size()); }
  constexpr double height_at(int i, int j) const noexcept {
    return surface_.heights[static_cast<std::size_t>(i) * surface_.z.size() + static_cast<std::size_t>(j)];
  }
  constexpr point<double, 3> point_at(int i, int j) const noexcept {
    return {surface_.x[static_cast<std::size_t>(i)], height_at(i, j), surface_.z[static_cast<std::size_t>(j)]};
  }
  constexpr bool over_grid() const noexcept {
    return surface_.x.front() <= eye_.x && eye_.x <= surface_.x.back() && surface_.z.front() <= eye_.z &&
           eye_.z <= surface_.z.back();
  }

  constexpr void choose() noexcept {
    bool whole = true;
    for (const double h : surface_.heights) whole = whole && is_number(h);
    if (options_.style == surface_style::facets) {
      out_.method = surface_method::facets_far_to_near;
      out_.why = "facets are filled, so nearby ones cover distant ones";
    } else if (whole) {
      out_.method = surface_method::perimeter;
      out_.why = over_grid() ? "the eye is over the grid, where horizons would not do"
                             : "every point has a height, and the perimeter decides exactly what is seen";
    } else if (over_grid()) {
      out_.method = surface_method::facets_far_to_near;
      out_.why = "some points have no height and the eye is over the grid: facets cover each other";
    } else {
      out_.method = surface_method::floating_horizon;
      out_.why = "some points have no height, and the floating horizon leaves gaps";
    }
  }

  // How the box fits between the margins.
  constexpr void fit() noexcept {
    const double text = options_.text_size;
    point<double, 2> low{0, 0}, high{0, 0};
    for (int k = 0; k < 8; ++k) {
      const auto at = camera_({k & 1 ? 1.0 : 0.0, k & 2 ? options_.tallness : 0.0, k & 4 ? 1.0 : 0.0});
      if (!at) continue;
      low = k == 0 ? *at : point<double, 2>{lesser(low.x, at->x), lesser(low.y, at->y)};
      high = k == 0 ? *at : point<double, 2>{greater(high.x, at->x), greater(high.y, at->y)};
    }
    const double room_x = greater(out_.width - 11 * text, 0.3 * out_.width);
    const double room_y = greater(out_.height - 7 * text, 0.3 * out_.height);
    const double wide = (high.x - low.x) / room_x, tall = (high.y - low.y) / room_y;
    unit_ = greater(wide, tall) > 0 ? greater(wide, tall) : 1;
    middle_ = {(low.x + high.x) / 2, (low.y + high.y) / 2};
  }
  constexpr std::optional<point<double, 2>> place_in_box(const point<double, 3>& p) const noexcept {
    const auto at = camera_(p);
    if (!at) return std::nullopt;
    return point<double, 2>{out_.width / 2.0 + (at->x - middle_.x) / unit_,
                            out_.height / 2.0 - options_.text_size - (at->y - middle_.y) / unit_};
  }
  constexpr std::optional<point<double, 2>> place(const point<double, 3>& data) const noexcept {
    return place_in_box(boxed(scale_, data));
  }
  constexpr double share_of(double height) const noexcept {
    return boxed(scale_, {0, height, 0}).y / options_.tallness;
  }

  constexpr void add_part(const grid_edge_part& p) {
    const auto a = point_at(p.i1, p.j1), b = point_at(p.i2, p.j2);
    const auto at = [&](double t) {
      return point<double, 3>{product(a.x, 1 - t) + product(b.x, t), product(a.y, 1 - t) + product(b.y, t),
                              product(a.z, 1 - t) + product(b.z, t)};
    };
    const auto from = at(p.from), to = at(p.to);
    const auto u = place(from), v = place(to);
    if (u && v) out_.lines.push_back({*u, *v, height_colour((share_of(from.y) + share_of(to.y)) / 2)});
  }

  constexpr grid_surface_status draw_perimeter() {
    const auto done = visible_grid_edges(surface_, eye_, [&](const grid_edge_part& p) { add_part(p); });
    return done.status;
  }

  // The facets' edges from near to far, each once, before an upright picture plane.
  constexpr grid_surface_status draw_horizon() {
    struct edge {
      int i, j;
      bool along_z;
      double depth[2];
    };
    constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
    const point<double, 3> eye = boxed(scale_, eye_);
    const double dx = 0.5 - eye.x, dz = 0.5 - eye.z;
    std::vector<edge> edges;
    std::vector<point<double, 2>> points;
    const auto upright = [&](const point<double, 3>& data, double& depth) {
      const point<double, 3> p = boxed(scale_, data);
      depth = product(p.x - eye.x, dx) + product(p.z - eye.z, dz);
      if (!(depth > 0) || !is_number(p.y)) return point<double, 2>{nothing, nothing};
      return point<double, 2>{(product(p.x - eye.x, dz) - product(p.z - eye.z, dx)) / depth, (p.y - eye.y) / depth};
    };
    each_edge([&](int i, int j, bool along_z) {
      edge e{i, j, along_z, {0, 0}};
      points.push_back(upright(point_at(i, j), e.depth[0]));
      points.push_back(upright(point_at(i + (along_z ? 0 : 1), j + (along_z ? 1 : 0)), e.depth[1]));
      points.push_back({nothing, nothing});
      edges.push_back(e);
    });
    visible_curves(points, [&](const edge_part& p) {
      const edge& e = edges[p.edge / 3];
      const auto in_space = [&](double t) {
        return product(t, e.depth[0]) / (product(1 - t, e.depth[1]) + product(t, e.depth[0]));
      };
      add_part({e.i, e.j, e.i + (e.along_z ? 0 : 1), e.j + (e.along_z ? 1 : 0), in_space(p.from), in_space(p.to)});
    });
    return grid_surface_status::ok;
  }

  // Every edge once, near ones first: the border that turns to the eye, then those that facets add.
  template <class Visit>
  constexpr void each_edge(const Visit& visit) const {
    const grid_covering loops = covering_loops(surface_.x, surface_.z, eye_.x, eye_.z);
    const auto x_at = [&](int i) { return surface_.x[static_cast<std::size_t>(i)]; };
    const auto z_at = [&](int j) { return surface_.z[static_cast<std::size_t>(j)]; };
    for (int j = 0; j < loops.m; ++j) {
      if (x_at(0) >= eye_.x) visit(0, j, true);
      if (x_at(loops.n) < eye_.x) visit(loops.n, j, true);
    }
    for (int i = 0; i < loops.n; ++i) {
      if (z_at(0) >= eye_.z) visit(i, 0, false);
      if (z_at(loops.m) < eye_.z) visit(i, loops.m, false);
    }
    visit_in_covering_order(loops, [&](const grid_facet& f) {
      if (z_at(f.j - 1) < eye_.z) visit(f.i - 1, f.j - 1, false);
      if (x_at(f.i) >= eye_.x) visit(f.i, f.j - 1, true);
      if (z_at(f.j) >= eye_.z) visit(f.i - 1, f.j, false);
      if (x_at(f.i - 1) < eye_.x) visit(f.i - 1, f.j - 1, true);
    });
  }

  constexpr grid_surface_status draw_facets() {
    const grid_covering loops = covering_loops(surface_.x, surface_.z, eye_.x, eye_.z);
    visit_in_covering_order(loops, [&](const grid_facet& f) {
      constexpr int corners[4][2] = {{1, 1}, {0, 1}, {0, 0}, {1, 0}};
      plot_facet out{};
      double sum = 0;
      for (std::size_t k = 0; k < 4; ++k) {
        const auto p = point_at(f.i - corners[k][0], f.j - corners[k][1]);
        const auto at = is_number(p.y) ? place(p) : std::nullopt;
        if (!at) return;
        out.corners[k] = *at;
        sum += share_of(p.y) / 4;
      }
      out.colour = height_colour(sum);
      out_.facets.push_back(out);
    });
    for (std::size_t a = 0, b = out_.facets.size(); a + 1 < b; ++a) std::swap(out_.facets[a], out_.facets[--b]);
    return grid_surface_status::ok;
  }

  // Along the box's edges nearest to the eye, which nothing covers: x and z at the bottom (seen from below: at the
  // top), the heights at the left end.
  constexpr void draw_axes() {
    const point<double, 3> eye = camera_.eye;
    const double t = options_.tallness, near_x = eye.x < 0.5 ? 0 : 1, near_z = eye.z < 0.5 ? 0 : 1;
    const double floor = eye.y < t / 2 ? t : 0;
    for (int k = 0; k < 4; ++k) {  // the box's other edges on the floor, and the upright ones
      const double x = k & 1 ? 1 : 0, z = k & 2 ? 1 : 0;
      if (x != near_x || z != near_z) add_axis_line({x, 0, z}, {x, t, z});
    }
    add_axis_line({0, floor, near_z}, {1, floor, near_z});
    add_axis_line({near_x, floor, 0}, {near_x, floor, 1});
    const double out_x = near_x == 0 ? -1 : 1, out_z = near_z == 0 ? -1 : 1;
    const auto& low = scale_.data.low;
    const auto& high = scale_.data.high;
    const int most = out_.width < 400 ? 3 : 5;
    add_ticks({{low.x, high.x, most}, {0, floor, near_z}, {1, 0, 0}, {0, 0, out_z}, &options_.x});
    add_ticks({{low.z, high.z, most}, {near_x, floor, 0}, {0, 0, 1}, {out_x, 0, 0}, &options_.z});
    // Of the two upright edges at the picture's sides the left one.
    const point<double, 3> one{1 - near_x, 0, near_z}, two{near_x, 0, 1 - near_z};
    const auto a = place_in_box(one), b = place_in_box(two);
    const bool first = a && b && a->x < b->x;
    const auto at = first ? one : two;
    const vec<double, 3> away = first ? vec<double, 3>{-out_x, 0, 0} : vec<double, 3>{0, 0, -out_z};
    add_ticks({{low.y, high.y, most}, at, {0, t, 0}, away, &options_.y});
  }
  constexpr void add_axis_line(const point<double, 3>& a, const point<double, 3>& b) {
    const auto u = place_in_box(a), v = place_in_box(b);
    if (u && v) out_.axes.push_back({*u, *v, rgba8{196, 192, 182, 255}});
  }

  struct axis {
    struct {
      double low, high;
      int most;
    } range;
    point<double, 3> from;
    vec<double, 3> along, away;
    const plot_text* name;
  };
  // Ticks that point away from the box, their texts beyond, the axis's name beyond them.
  constexpr void add_ticks(const axis& a) {
    constexpr plot_colours colours;
    const auto ticks = axis_ticks(a.range.low, a.range.high, a.range.most);
    const auto spot = [&](double share) {
      return point<double, 3>{a.from.x + product(share, a.along.x), a.from.y + product(share, a.along.y),
                              a.from.z + product(share, a.along.z)};
    };
    const auto end = place_in_box(spot(0)), other = place_in_box(spot(1));
    const auto middle = place_in_box(spot(0.5));
    const auto beside = place_in_box({spot(0.5).x + 0.05 * a.away.x, spot(0.5).y, spot(0.5).z + 0.05 * a.away.z});
    if (!end || !other || !middle || !beside) return;
    out_.axes.push_back({*end, *other, colours.ink});
    vec<double, 2> d{beside->x - middle->x, beside->y - middle->y};
    const double size = sqrt(product(d.x, d.x) + product(d.y, d.y));
    if (!(size > 0)) return;
    d = {d.x / size, d.y / size};
    const double text = options_.text_size;
    double widest = 0;
    for (const axis_tick& tick : ticks) {
      const double share =
          a.range.high > a.range.low ? (tick.value / 2 - a.range.low / 2) / (a.range.high / 2 - a.range.low / 2) : 0.5;
      const auto at = place_in_box(spot(share));
      if (!at) continue;
      out_.axes.push_back({*at, {at->x + 6 * d.x, at->y + 6 * d.y}, colours.ink});
      widest = greater(widest, measure_text(tick.text, text).width);
      add_label(tick.text, {at->x + 10 * d.x, at->y + 10 * d.y}, d, text);
    }
    const double distant = 16 + product(magnitude(d.x), widest) + product(magnitude(d.y), text);
    for (int tries = 0; tries < 8; ++tries) {  // farther out until it stands alone
      const double away = distant + tries * text;
      if (add_label(*a.name, {middle->x + away * d.x, middle->y + away * d.y}, d, text * 1.1)) break;
    }
  }
  // A text that begins at a place and lies beyond it in a direction; none where it would lie on another or touch it.
  constexpr bool add_label(const plot_text& text, const point<double, 2>& at, const vec<double, 2>& d, double size) {
    const double width = measure_text(text, size).width;
    const double x = at.x + product(d.x - 1, width / 2), y = at.y + product(d.y, size / 2);
    const double left = clamp(x, 1.0, greater(1.0, out_.width - width - 1));
    const double middle = clamp(y, size / 2 + 1, greater(size, out_.height - size / 2 - 1));
    for (const auto& l : out_.labels) {
      const double other = measure_text(l.text, l.style.size).width, apart = (size + l.style.size) * 0.45;
      const double gap = size * 0.3, right = left + width;
      if (left < l.at.x + other + gap && l.at.x < right + gap && magnitude(middle - l.at.y) < apart) return false;
    }
    out_.labels.push_back({text, {left, middle}, {.size = size, .across = text_across::middle}});
    return true;
  }

  const grid_surface& surface_;
  const Options& options_;
  plot_scale scale_;
  surface_camera camera_{};
  point<double, 3> eye_{};
  double unit_ = 1;
  point<double, 2> middle_{0, 0};
  Plot out_{};
};

// A grid of which heights may be missing.
template <class Surface>
constexpr bool is_grid_with_gaps(const Surface& s) {
  std::vector<double> zeros(s.heights.size(), 0.0);
  bool any = false;
  for (const double h : s.heights) any = any || is_number(h);
  return any && is_grid(grid_surface{s.x, s.z, zeros});
}

}  // namespace IRG_ABI
}  // namespace detail

inline namespace IRG_ABI {

template <class Options, class Plot>
[[nodiscard]] constexpr checked<Plot, grid_surface_status> plot_surface(const grid_surface& surface,
                                                                        const Options& options) {
  checked<Plot, grid_surface_status> plot{{}, grid_surface_status::not_a_grid};
  const auto is_positive = [](double v) { return v > 0x1p-20 && v < 0x1p20; };
  const bool usable = options.width > 0 && options.height > 0 && is_positive(options.distance) &&
                      is_positive(options.tallness) && is_positive(options.text_size) &&
                      magnitude(options.azimuth_degrees) < 0x1p20 && magnitude(options.elevation_degrees) < 0x1p20;
  if (!usable || !detail::is_grid_with_gaps(surface)) return plot;
  plot.status = detail::plot_maker<Plot, Options>(surface, options).make(plot.value);
  return plot;
}

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
