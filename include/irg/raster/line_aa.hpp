// SPDX-License-Identifier: MIT
// line_aa: the exact area that a line of a given width covers of each pixel.
#pragma once

#include <irg/core/conversion.hpp>
#include <irg/core/coordinates.hpp>
#include <irg/core/function_ref.hpp>
#include <irg/core/sinks.hpp>
#include <irg/raster/detail/area_targets.hpp>
#include <irg/raster/detail/compiled_rasters.hpp>
#include <irg/raster/detail/line_aa_shape.hpp>
#include <irg/raster/detail/line_aa_slender.hpp>
#include <irg/raster/detail/snapped_line.hpp>
#include <irg/raster/paint.hpp>
#include <irg/raster/window.hpp>

namespace irg {
inline namespace IRG_ABI {

/// Calls sink(coverage_span) for runs of pixels of the line's rectangle that lie in the window.
/// shape   the rectangle from a to b, half the width to either side, with the caps that the options say; each pixel in
///         at most one run, runs of at most 256 pixels, row by row; pixels at a run's ends may have coverage 0
/// needs   coordinates within snap_limit pixels, 0 < width <= max_line_aa_width
/// gives   false and no call otherwise; no call for a zero-length line with butt caps, a square with square ones
/// exact   coverage is 255 times the area of pixel and rectangle, rounded to an integer; it is at most 1/2 + 1/64 from
///         that, so each pixel is within 1/256 of its area. A clipped line has the unclipped line's coverages; mirrored
///         lines and lines moved by whole pixels have mirrored and moved ones; a to b has those of b to a
/// cost    a square root and a few divisions; then rows and pixels in the window only
/// source  Catmull 1978 for coverage as area; Green's theorem for the sum over edges
template <CoverageSink Sink>
constexpr bool line_aa(const subpixel& a, const subpixel& b, const cell_window& window, Sink&& sink,
                       const line_aa_options& options = {});

/// Mixes the paint into the pixels of the line from a to b, as far as each is covered.
/// shape   in bare braces positions in pixels, as doubles
/// gives   false and nothing drawn when a coordinate is NaN or infinite or the width is out of range
/// exact   the coverages of line_aa; pixels as by paint_pixel, those of coverage 0 keep their value. A line that ends
///         beyond snap_limit is cut there first, which moves it by at most 1/512 pixel on each axis
template <WritableRaster R, ScreenPosition P = point<double, 2>, CoveragePaintFor<R> Paint = pixel_of<R>>
constexpr bool draw_line_aa(R& raster, const P& a, const P& b, const Paint& paint, const line_aa_options& options = {});

}  // namespace IRG_ABI

namespace detail::inline IRG_COMPILED_ABI {

template <class Options>
IRG_API void send_line_areas(const subpixel& a, const subpixel& b, const Options& options, const cell_window& w,
                             const function_ref<void(const coverage_span&)>& sink);
template <CompiledPixel P>
IRG_API void mix_line_areas(const image_view<P>& raster, const subpixel& a, const subpixel& b, const P& value,
                            const line_aa_options& options, const cell_window& w);

}  // namespace detail::inline IRG_COMPILED_ABI

namespace detail::inline IRG_ABI {

// A line on its way to a target.
template <class F, bool Inside, class Target>
struct aa_drawing {
  using four = aa_four<F>;
  const aa_frame& f;
  const aa_shape& s;
  const cell_window& w;
  Target& target;

  // Columns `c` of row y of the raster: row(k) gives 1/2 + 255 * the area of pixel k from the first of them on, `solid`
  // which of them are covered whole, if not 0.
  template <class G, bool Fills = false, class Row>
  IRG_INLINE constexpr void send(const aa_axis& axis, int y, const area_range& c, const Row& row,
                                 const area_range& solid = {}) const {
    const int origin = axis.at(c.first), sign = axis.sign();
    if constexpr (Inside) {
      target.template columns_inside<G, Fills>(y, origin, sign, c.last - c.first, solid, row);
    } else {
      const area_range all = axis.pixels(c);
      target.template columns<G>(y, maximum(all.first, w.x_first), minimum(all.last, w.x_last), w.x_last,
                                 [&](int x) { return row(area_indices<G>(x, origin, sign)); });
    }
  }

  // Rows [first, last) that caps reach into.
  template <class E>
  constexpr void cap_rows(const aa_edges<E>& edges, int first, int last) const {
    aa_cap_row<four, std::is_same_v<E, double>> row;
    for (int r = first; r < last; ++r) {
      const area_range columns = aa_enter(row, edges, r);
      send<four>(f.x, f.y.at(r), columns, row);
    }
  }
  IRG_INLINE constexpr void cap_rows(int first, int last) const {
    if (first >= last) return;
    if (s.small_numbers)
      cap_rows(aa_narrowed<four>(s.edges), first, last);
    else
      cap_rows(s.edges, first, last);
  }

  // The row in the middle of a line that is its own image under a half turn.
  constexpr void middle_row(int r) const {
    if (f.y.at(r) < w.y_first || f.y.at(r) >= w.y_last) return;
    aa_cap_row<four, true> row;
    const area_range columns = aa_enter(row, s.edges, r);
    row.fold = static_cast<float>(s.turned_x - 2 * columns.first);
    send<four>(f.x, f.y.at(r), columns, row);
  }

  // Rows [first, last) between the caps. Fills: the line is so wide that they have runs of columns covered whole. What
  // would be computed of such a column is within 1/64 of 255 + 1/2, and so 255, too.
  template <class G, bool Fills, class Row>
  constexpr void band_rows(int first, int last, Row row) const {
    const aa_axis axis = f.x;  // copies, which no pixel that is written may change
    const int sign_y = f.y.sign();
    const std::int64_t reach = s.reach;
    aa_walk walk = aa_walk_at(s, first);
    int y = f.y.at(first);
    for (int rows = last - first; rows > 0; --rows, y += sign_y, walk.x += walk.step) {
      row.enter(walk.fraction());
      const int column = walk.column();
      area_range solid;
      if constexpr (Fills) solid = {walk.end_column(s.whole_from) - column, walk.end_column(s.whole_to) - 1 - column};
      send<G, Fills>(axis, y, {column, walk.end_column(reach)}, row, solid);
    }
  }

  // The same for a line about one pixel wide that the window holds and whose runs are not longer than four pixels.
  constexpr void short_rows(int first, int last, aa_thin_row<four> row) const {
    constexpr int count = lanes<four>::count;
    const aa_axis axis = f.x;
    const int sign_y = f.y.sign(), aside = axis.mirrored ? 1 - count : 0;
    const four fixed = row.before_shift(area_indices<four>(aside, 0, axis.sign()));
    aa_walk walk = aa_walk_at(s, first);
    int y = f.y.at(first);
    for (int rows = last - first; rows > 0; --rows, y += sign_y, walk.x += walk.step) {
      row.enter(walk.fraction());
      target.begin(y);
      target.mix_all(axis.at(walk.column()) + aside, converted<std::int32_t>(row.shifted(fixed)));
    }
  }

  // Rows [first, last) between the caps, the fastest way.
  constexpr void rows_between(int first, int last) const {
    if (s.thin) {
      const auto slope = converted<float>(s.slope), width = converted<float>(s.width),
                 change = s.slant <= 1.0 ? 1.0f : slope, left = converted<float>(0.5 - 0.5 * (s.slant + s.across));
      if constexpr (Inside) {
        if (s.slant + s.across <= 3.0) return short_rows(first, last, aa_thin_row<four>(slope, width, change, left));
      }
      return band_rows<F, false>(first, last, aa_thin_row<F>(slope, width, change, left));
    }
    const aa_band_row<F> row(static_cast<float>(s.slant), static_cast<float>(s.across));
    if (Inside && s.across - s.slant >= 3 * mix_lanes)
      band_rows<F, true>(first, last, row);
    else
      band_rows<F, false>(first, last, row);
  }

  // Of the rows [first, last) between the caps, only those whose run may reach into the window's columns.
  constexpr area_range reaching(int first, int last) const noexcept {
    if constexpr (Inside) return {first, last};
    const area_range columns = f.x.indices({w.x_first, w.x_last});
    const double rise = -s.edges.x_per_row[0],
                 before = product(columns.first - s.edges.x[2] - s.slant, rise) + s.edges.y[2],
                 after = product(columns.last - s.edges.x[1], rise) + s.edges.y[1];
    return {static_cast<int>(clamped<double>(before, first, last)),
            static_cast<int>(clamped<double>(after + 1.0, first, last))};
  }

  // Rows [first, last) of the shape.
  IRG_INLINE constexpr void rows(int first, int last) const {
    const area_range visible = f.y.indices({w.y_first, w.y_last});
    first = maximum(first, visible.first), last = minimum(last, visible.last);
    const int band_first = maximum(first, s.band_first), band_last = minimum(last, s.band_last);
    if (band_first >= band_last) return cap_rows(first, last);
    cap_rows(first, band_first);
    const area_range band = reaching(band_first, band_last);
    if (band.first < band.last) rows_between(band.first, band.last);
    cap_rows(band_last, last);
  }
};

// from_other_end: the frame of the other half of a line that is its own image under a half turn.
template <class F, bool Inside, class Target>
constexpr void aa_draw(const aa_frame& f, const aa_frame* from_other_end, const aa_shape& s, const cell_window& w,
                       Target& target) {
  const aa_drawing<F, Inside, Target> d{f, s, w, target};
  if (from_other_end == nullptr) return d.rows(s.first, s.last);
  const int half = (s.turned_y + 1) / 2;
  d.rows(s.first, half);
  aa_drawing<F, Inside, Target>{*from_other_end, s, w, target}.rows(s.first, half);
  if (2 * half == s.turned_y) d.middle_row(half);
}

template <class F, class Target>
constexpr void aa_slanted(const subpixel& a, const subpixel& b, const line_aa_options& options, const cell_window& w,
                          Target& target) {
  const std::int32_t margin = (options.width >> subpixel_bits) + 2;
  const aa_frame from_a = aa_frame_of(a, b, margin), from_b = aa_frame_of(b, a, margin);
  const std::int32_t at_a = aa_fraction(from_a), at_b = aa_fraction(from_b);
  const aa_frame& f = at_b < at_a ? from_b : from_a;
  const std::int32_t dx = a.x < b.x ? b.x - a.x : a.x - b.x, dy = a.y < b.y ? b.y - a.y : a.y - b.y;
  const aa_shape s = aa_shape_of(f, dx, dy, options.width, options.caps);
  const aa_frame* const other = at_a == at_b ? &from_b : nullptr;
  if constexpr (Target::takes_uncovered) {
    // Beyond the rectangle's columns a pack may reach, and the column that ends on a whole number.
    const int beyond = margin + 1 + lanes<F>::count;
    const int least = minimum(a.x, b.x) >> subpixel_bits, greatest = maximum(a.x, b.x) >> subpixel_bits;
    if (least - beyond >= w.x_first && greatest + beyond < w.x_last) return aa_draw<F, true>(f, other, s, w, target);
  }
  aa_draw<F, false>(f, other, s, w, target);
}

// A line along an axis: whole numbers decide. Bounds in 1/512 pixel; so a half width is whole, too.
struct aa_overlap {
  std::int64_t low, high;
  IRG_INLINE constexpr area_range pixels() const noexcept {
    return {static_cast<int>(low >> 9), static_cast<int>((high + 511) >> 9)};
  }
  // How much of pixel i lies between the bounds, 0 to 512.
  IRG_INLINE constexpr std::int64_t of(int i) const noexcept {
    const std::int64_t from = maximum(low, std::int64_t{i} * 512), to = minimum(high, std::int64_t{i} * 512 + 512);
    return maximum(to - from, std::int64_t{0});
  }
};

IRG_INLINE constexpr aa_overlap aa_extent(std::int32_t a, std::int32_t b, std::int32_t beyond) noexcept {
  return {std::int64_t{2} * minimum(a, b) - beyond, std::int64_t{2} * maximum(a, b) + beyond};
}

template <class F, class Target>
constexpr void aa_box(const aa_overlap& x, const aa_overlap& y, const cell_window& w, Target& target) {
  const area_range columns = x.pixels(), rows = y.pixels();
  const int origin = columns.first, end = columns.last - 1, first = maximum(origin, w.x_first),
            last = minimum(columns.last, w.x_last);
  if (x.low >= x.high || y.low >= y.high || first >= last) return;
  std::int64_t height = 0;
  aa_box_row row;
  for (int r = maximum(rows.first, w.y_first); r < minimum(rows.last, w.y_last); ++r) {
    if (y.of(r) != height) {  // of all but the first and the last row it is the same
      height = y.of(r);
      const auto part = [&](int column) {
        return static_cast<float>((255 * x.of(column) * height + (std::int64_t{1} << 17)) >> 18);
      };
      row = {part(origin), end > origin + 1 ? part(origin + 1) : 0.0f, part(end), static_cast<float>(end - origin)};
    }
    target.template columns<F>(r, first, last, w.x_last,
                               [&](int column) { return row(area_indices<F>(column, origin, 1)); });
  }
}

// F: the numbers of a row that are computed at once, float or a pack.
template <class F, class Target>
constexpr void aa_line(const subpixel& a, const subpixel& b, const line_aa_options& options, const cell_window& window,
                       Target& target) {
  if (aa_draw_slender<F>(a, b, options, window, target)) return;
  constexpr int reach = 2 * snap_limit;  // no line gets there, and no number overflows on the way
  const cell_window w = intersect(window, {-reach, -reach, reach, reach});
  if (w.empty()) return;
  if (a.x != b.x && a.y != b.y) return aa_slanted<F>(a, b, options, w, target);
  const std::int32_t cap = options.caps == line_aa_caps::square ? options.width : 0;
  const bool level = a.y == b.y;
  const std::int32_t beyond_x = level ? cap : options.width, beyond_y = level ? options.width : cap;
  aa_box<F>(aa_extent(a.x, b.x, beyond_x), aa_extent(a.y, b.y, beyond_y), w, target);
}

IRG_INLINE constexpr bool aa_can_draw(const subpixel& a, const subpixel& b, std::int32_t width) noexcept {
  return can_snap(a) && can_snap(b) && width > 0 && width <= max_line_aa_width;
}

template <class Sink>
constexpr void aa_send_line(const subpixel& a, const subpixel& b, const line_aa_options& options,
                            const cell_window& window, Sink& sink) {
  area_span_target<Sink> target{sink};
  if (std::is_constant_evaluated())
    aa_line<float>(a, b, options, window, target);
  else
    aa_line<pack<float, native_lanes<float>>>(a, b, options, window, target);
}

// At run time only: lanes.
template <class R>
void aa_mix_line(R& raster, const subpixel& a, const subpixel& b, const pixel_of<R>& value,
                 const line_aa_options& options, const cell_window& w) noexcept {
  area_mix_target<R> target(raster, value);
  aa_line<pack<float, mix_lanes>>(a, b, options, w, target);
}

}  // namespace detail::inline IRG_ABI

inline namespace IRG_ABI {

template <CoverageSink Sink>
constexpr bool line_aa(const subpixel& a, const subpixel& b, const cell_window& window, Sink&& sink,
                       const line_aa_options& options) {
  if (!detail::aa_can_draw(a, b, options.width)) return false;
  if constexpr (detail::draws_in_library)
    detail::send_line_areas(a, b, options, window, as_function<void(const coverage_span&)>(sink));
  else
    detail::aa_send_line(a, b, options, window, sink);
  return true;
}

template <WritableRaster R, ScreenPosition P, CoveragePaintFor<R> Paint>
constexpr bool draw_line_aa(R& raster, const P& a, const P& b, const Paint& paint, const line_aa_options& options) {
  const auto [finite, in_reach, from, to] = detail::snap_line(a, b);
  if (!finite || !detail::aa_can_draw(from, to, options.width)) return false;
  if (!in_reach) return true;
  const cell_window w = window_of(raster);
  if constexpr (detail::draws_in_library && detail::CompiledRaster<R> && !CoverageBlendFunction<Paint, R>) {
    detail::mix_line_areas(view_of(raster), from, to, static_cast<pixel_of<R>>(paint), options, w);
    return true;
  } else if constexpr (RowRaster<R> && detail::mixes_in_lanes<pixel_of<R>> && !CoverageBlendFunction<Paint, R>) {
    if (!std::is_constant_evaluated()) {
      detail::aa_mix_line(raster, from, to, static_cast<pixel_of<R>>(paint), options, w);
      return true;
    }
  }
  const auto blend = [&](const coverage_span& s) {
    for (int x = s.x_first; x < s.x_last; ++x) paint_pixel(raster, x, s.y, paint, s.coverage[x - s.x_first]);
  };
  return line_aa(from, to, w, blend, options);
}

}  // namespace IRG_ABI
}  // namespace irg

#if IRG_BODIES
namespace irg::detail::inline IRG_COMPILED_ABI {

template <class Options>
IRG_API void send_line_areas(const subpixel& a, const subpixel& b, const Options& options, const cell_window& w,
                             const function_ref<void(const coverage_span&)>& sink) {
  aa_send_line(a, b, options, w, sink);
}

template <CompiledPixel P>
IRG_API void mix_line_areas(const image_view<P>& raster, const subpixel& a, const subpixel& b, const P& value,
                            const line_aa_options& options, const cell_window& w) {
  image_view<P> target = raster;
  aa_mix_line(target, a, b, value, options, w);
}

}  // namespace irg::detail::inline IRG_COMPILED_ABI
#endif
