// SPDX-License-Identifier: MIT
// line_aa: the exact area that a line of a given width covers of each pixel.
#pragma once

#include <irg/core/conversion.hpp>
#include <irg/core/coordinates.hpp>
#include <irg/core/sinks.hpp>
#include <irg/raster/detail/line_aa_shape.hpp>
#include <irg/raster/detail/line_aa_writers.hpp>
#include <irg/raster/detail/snapped_line.hpp>

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
/// gives   false and nothing drawn when a coordinate is NaN or infinite or the width is out of range
/// exact   the coverages of line_aa; pixels as by paint_pixel, those of coverage 0 keep their value. A line that ends
///         beyond snap_limit is cut there first, which moves it by at most 1/512 pixel on each axis
template <WritableRaster R, ScreenPosition P, CoveragePaintFor<R> Paint = pixel_of<R>>
constexpr bool draw_line_aa(R& raster, const P& a, const P& b, const Paint& paint, const line_aa_options& options = {});

}  // namespace IRG_ABI

namespace detail::inline IRG_ABI {

// The indices along an axis that fall in [first, last) of the raster.
IRG_INLINE constexpr aa_columns aa_visible(const aa_axis& axis, int first, int last) noexcept {
  return axis.mirrored ? aa_columns{-axis.base - last, -axis.base - first}
                       : aa_columns{first - axis.base, last - axis.base};
}

// A line on its way to a writer. Inside: the window holds all its columns, and so many more that whole chunks fit.
template <bool Inside, class Writer>
struct aa_drawing {
  using number = typename Writer::number;
  using four = typename Writer::four;
  const aa_frame& f;
  const aa_shape& s;
  const cell_window& w;
  Writer& writer;

  // Columns [first, last) of row r of the frame, as far as the window holds them.
  template <class F, class Row>
  IRG_INLINE constexpr void write(int r, const aa_columns& c, const Row& row) const {
    const int origin = f.x.at(c.first);
    if constexpr (Inside) {
      writer.template run_inside<F>(f.y.at(r), c.last - c.first, origin, f.x.sign(), row);
    } else {
      const int end = f.x.at(c.last - 1);
      const int first = greater(f.x.mirrored ? end : origin, w.x_first);
      const int last = lesser((f.x.mirrored ? origin : end) + 1, w.x_last);
      if (first < last) writer.template run<F>(f.y.at(r), first, last, origin, f.x.sign(), row);
    }
  }

  // Rows [first, last) that caps reach into.
  IRG_INLINE constexpr void cap_rows(int first, int last) const {
    if (first >= last) return;
    if (s.small_numbers) {
      aa_cap_row<four> row;
      const aa_near_edges<four> edges(s);
      for (int r = first; r < last; ++r) write<four>(r, edges.enter(row, r), row);
    } else {
      aa_cap_row<four, true> row;
      for (int r = first; r < last; ++r) write<four>(r, aa_enter_far(row, s, r), row);
    }
  }

  // The row in the middle of a line that is its own image under a half turn.
  constexpr void middle_row(int r) const {
    if (f.y.at(r) < w.y_first || f.y.at(r) >= w.y_last) return;
    aa_cap_row<four, true> row;
    const aa_columns columns = aa_enter_far(row, s, r);
    row.fold = static_cast<float>(s.turned_x - 2 * columns.first);
    write<four>(r, columns, row);
  }

  // Rows [first, last) between the caps.
  template <class Row>
  constexpr void band_rows(int first, int last, Row row) const {
    aa_walk walk = aa_walk_at(s, first);
    for (int r = first; r < last; ++r, walk.x += walk.step) {
      row.enter(walk.fraction());
      write<number>(r, {walk.column(), walk.end_column(s.reach)}, row);
    }
  }

  // Rows [first, last) between the caps of a line about one pixel wide.
  constexpr void thin_rows(int first, int last) const {
    const auto slope = converted<float>(s.slope), width = converted<float>(s.width),
               change = s.slant <= 1.0 ? 1.0f : slope, left = converted<float>(0.5 - 0.5 * (s.slant + s.across));
    if constexpr (Inside) {
      const aa_walk walk = aa_walk_at(s, first);
      const int y = f.y.at(first), sign_y = f.y.sign(), rows = last - first, base = f.x.at(0), sign = f.x.sign();
      if (s.slant + s.across <= 3.0)
        writer.template thin_rows_inside<true>(y, sign_y, rows, base, sign, walk, s.reach,
                                               aa_thin_row<four>(slope, width, change, left));
      else
        writer.template thin_rows_inside<false>(y, sign_y, rows, base, sign, walk, s.reach,
                                                aa_thin_row<number>(slope, width, change, left));
    } else {
      band_rows(first, last, aa_thin_row<number>(slope, width, change, left));
    }
  }

  // Of the rows [first, last) between the caps, only those whose run may reach into the window's columns.
  constexpr aa_columns reaching(int first, int last) const noexcept {
    const aa_columns columns = aa_visible(f.x, w.x_first, w.x_last);
    const double rise = -s.x_per_row[0], before = product(columns.first - s.x[2] - s.slant, rise) + s.y[2],
                 after = product(columns.last - s.x[1], rise) + s.y[1];
    return {static_cast<int>(clamp<double>(before, first, last)),
            static_cast<int>(clamp<double>(after + 1.0, first, last))};
  }

  // Rows [first, last) of the shape.
  IRG_INLINE constexpr void rows(int first, int last) const {
    const aa_columns visible = aa_visible(f.y, w.y_first, w.y_last);
    first = greater(first, visible.first), last = lesser(last, visible.last);
    const int band_first = greater(first, s.band_first), band_last = lesser(last, s.band_last);
    if (band_first >= band_last) return cap_rows(first, last);
    cap_rows(first, band_first);
    const aa_columns band = Inside ? aa_columns{band_first, band_last} : reaching(band_first, band_last);
    if (band.first < band.last) {
      if (s.thin)
        thin_rows(band.first, band.last);
      else
        band_rows(band.first, band.last,
                  aa_band_row<number>(static_cast<float>(s.slant), static_cast<float>(s.across)));
    }
    cap_rows(band_last, last);
  }
};

// A line along an axis: whole numbers decide. Bounds in 1/512 pixel; so a half width is whole, too.
struct aa_overlap {
  std::int64_t low, high;
  IRG_INLINE constexpr int first() const noexcept { return static_cast<int>(low >> 9); }
  IRG_INLINE constexpr int last() const noexcept { return static_cast<int>((high + 511) >> 9); }
  // How much of pixel i lies between the bounds, 0 to 512.
  IRG_INLINE constexpr std::int64_t of(int i) const noexcept {
    const std::int64_t from = greater(low, std::int64_t{i} * 512), to = lesser(high, std::int64_t{i} * 512 + 512);
    return greater(to - from, std::int64_t{0});
  }
};

IRG_INLINE constexpr aa_overlap aa_extent(std::int32_t a, std::int32_t b, std::int32_t beyond) noexcept {
  return {std::int64_t{2} * lesser(a, b) - beyond, std::int64_t{2} * greater(a, b) + beyond};
}

template <class Writer>
constexpr void aa_box(const aa_overlap& x, const aa_overlap& y, const cell_window& w, Writer& writer) {
  const int origin = x.first(), first = greater(origin, w.x_first), last = lesser(x.last(), w.x_last);
  if (x.low >= x.high || y.low >= y.high || first >= last) return;
  const int end = x.last() - 1;
  std::int64_t height = 0;
  aa_box_row row;
  for (int r = greater(y.first(), w.y_first); r < lesser(y.last(), w.y_last); ++r) {
    if (y.of(r) != height) {  // of all but the first and the last row it is the same
      height = y.of(r);
      const auto part = [&](int column) {
        return static_cast<float>((255 * x.of(column) * height + (std::int64_t{1} << 17)) >> 18);
      };
      row = {part(origin), end > origin + 1 ? part(origin + 1) : 0.0f, part(end), static_cast<float>(end - origin)};
    }
    writer.template run<typename Writer::number>(r, first, last, origin, 1, row);
  }
}

IRG_INLINE constexpr bool aa_can_draw(const subpixel& a, const subpixel& b, std::int32_t width) noexcept {
  return can_snap(a) && can_snap(b) && width > 0 && width <= max_line_aa_width;
}

template <bool Inside, class Writer>
constexpr void aa_draw(const aa_frame& f, const aa_frame* from_other_end, const aa_shape& s, const cell_window& w,
                       Writer& writer) {
  const aa_drawing<Inside, Writer> d{f, s, w, writer};
  if (from_other_end == nullptr) return d.rows(s.first, s.last);
  const int half = (s.turned_y + 1) / 2;
  d.rows(s.first, half);
  aa_drawing<Inside, Writer>{*from_other_end, s, w, writer}.rows(s.first, half);
  if (2 * half == s.turned_y) d.middle_row(half);
}

template <class Writer>
constexpr void aa_slanted(const subpixel& a, const subpixel& b, const line_aa_options& options, const cell_window& w,
                          Writer& writer) {
  const std::int32_t margin = (options.width >> subpixel_bits) + 2;
  const aa_frame from_a = aa_frame_of(a, b, margin), from_b = aa_frame_of(b, a, margin);
  const std::int32_t at_a = aa_fraction(from_a), at_b = aa_fraction(from_b);
  const aa_frame& f = at_b < at_a ? from_b : from_a;
  const std::int32_t dx = a.x < b.x ? b.x - a.x : a.x - b.x, dy = a.y < b.y ? b.y - a.y : a.y - b.y;
  const aa_shape s = aa_shape_of(f, dx, dy, options.width, options.caps);
  const aa_frame* const other = at_a == at_b ? &from_b : nullptr;
  if constexpr (Writer::writes_whole_chunks) {
    // Beyond the rectangle's columns a chunk may reach, and the column that ends on a whole number.
    const int beyond = margin + 1 + lanes<typename Writer::number>::count;
    const int least = lesser(a.x, b.x) >> subpixel_bits, greatest = greater(a.x, b.x) >> subpixel_bits;
    if (least - beyond >= w.x_first && greatest + beyond < w.x_last) return aa_draw<true>(f, other, s, w, writer);
  }
  aa_draw<false>(f, other, s, w, writer);
}

template <class Writer>
constexpr void aa_line(const subpixel& a, const subpixel& b, const line_aa_options& options, const cell_window& window,
                       Writer& writer) {
  constexpr int reach = 2 * snap_limit;  // no line gets there, and no number overflows on the way
  const cell_window w = intersect(window, {-reach, -reach, reach, reach});
  if (w.empty()) return;
  if (a.x != b.x && a.y != b.y) return aa_slanted(a, b, options, w, writer);
  const std::int32_t cap = options.caps == line_aa_caps::square ? options.width : 0;
  const bool level = a.y == b.y;
  const std::int32_t beyond_x = level ? cap : options.width, beyond_y = level ? options.width : cap;
  aa_box(aa_extent(a.x, b.x, beyond_x), aa_extent(a.y, b.y, beyond_y), w, writer);
}

// At run time only: lanes.
template <class R>
void aa_mix_line(R& raster, const subpixel& a, const subpixel& b, const pixel_of<R>& value,
                 const line_aa_options& options, const cell_window& w) noexcept {
  if (aa_slender_writer<R> slender(raster, value); aa_draw_slender(a, b, options, w, slender)) return;
  aa_mixing_writer<R> writer(raster, value, w);
  aa_line(a, b, options, w, writer);
}

}  // namespace detail::inline IRG_ABI

inline namespace IRG_ABI {

template <CoverageSink Sink>
constexpr bool line_aa(const subpixel& a, const subpixel& b, const cell_window& window, Sink&& sink,
                       const line_aa_options& options) {
  if (!detail::aa_can_draw(a, b, options.width)) return false;
  if (std::is_constant_evaluated()) {
    detail::aa_span_writer<float, std::remove_reference_t<Sink>> writer{sink};
    if (!detail::aa_draw_slender(a, b, options, window, writer)) detail::aa_line(a, b, options, window, writer);
  } else {
    detail::aa_span_writer<detail::aa_lanes, std::remove_reference_t<Sink>> writer{sink};
    if (!detail::aa_draw_slender(a, b, options, window, writer)) detail::aa_line(a, b, options, window, writer);
  }
  return true;
}

template <WritableRaster R, ScreenPosition P, CoveragePaintFor<R> Paint>
constexpr bool draw_line_aa(R& raster, const P& a, const P& b, const Paint& paint, const line_aa_options& options) {
  const auto [finite, in_reach, from, to] = detail::snap_line(a, b);
  if (!finite || !detail::aa_can_draw(from, to, options.width)) return false;
  if (!in_reach) return true;
  const cell_window w = window_of(raster);
  if constexpr (RowRaster<R> && detail::mixes_in_lanes<pixel_of<R>> && !CoverageBlendFunction<Paint, R>) {
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
