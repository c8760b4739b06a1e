// SPDX-License-Identifier: MIT
// line_thick: the pixels whose centres lie in a line of a given width, row by row; polyline_thick: in a chain of them.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include <irg/raster/detail/thick_stroke.hpp>
#include <irg/raster/fill_span.hpp>
#include <irg/raster/line_pen.hpp>

namespace irg {
namespace detail {
inline namespace IRG_ABI {

constexpr thick_stroke<std::int64_t> thick_stroke_between(const subpixel& a, const subpixel& b, std::int32_t width,
                                                          line_caps start, line_caps end) noexcept {
  return thick_stroke_of<std::int64_t, subpixel_bits>({a.x, a.y, b.x, b.y}, width, start, end);
}

}  // namespace IRG_ABI
}  // namespace detail

inline namespace IRG_ABI {

/// Calls sink(span) for the pixels in the window whose centres lie in the thick line from a to b, from top to bottom.
/// shape   one span per row: butt caps give the rectangle of the pen's width around the line, square caps one longer by
///         half the width at both ends, round caps all points within half the width of the line
/// units   points in pixels, snapped to 1/256 pixel once; pixel (0, 0) has its centre at (128, 128) of these
/// gives   false, and no call, when a position that is no cell cannot be snapped; else true. No call for a width of 0
///         or less, nor for a == b with butt caps; a == b gives a disc with round caps and a square along the axes with
///         square caps
/// exact   for all cells; decided without rounding; a centre exactly on the outline belongs to the line when the
///         outline is a left or a level top edge there, so that lines which touch share no pixel and leave none out;
///         the highest and the lowest point of a round cap do not belong to it
/// cost    some twenty divisions per line, a dozen additions and, with round caps, two square roots per visible row;
///         divides in 128 bits when the end cells are out of reach of snap()
template <ScreenPosition P, SpanSink Sink>
constexpr bool line_thick(const P& a, const P& b, const line_pen& pen, const cell_window& window, Sink&& sink) {
  if (can_snap(a) && can_snap(b))
    detail::stroke_spans(detail::thick_stroke_between(snap(a), snap(b), pen.width, pen.caps, pen.caps), window, sink);
  else if constexpr (std::same_as<P, cell> || CellPosition<P>) {
    const cell from = as_cell(a), to = as_cell(b);
    detail::stroke_spans(
        detail::thick_stroke_of<int128, 0>({from.x, from.y, to.x, to.y}, pen.width, pen.caps, pen.caps), window, sink);
  } else
    return false;
  return true;
}

/// Calls sink(span) for the pixels in the window whose centres lie in the thick line through all points, each pixel
/// once, from top to bottom and from left to right.
/// shape   the union of the thick lines between successive points, with a disc at every point between; the caps are
///         those of the first and the last point. Repeat the first point, with round caps, for a closed line.
/// needs   coordinates within snap_limit pixels of the origin
/// gives   no call for no point or a width of 0 or less; points that are all equal give what line_thick gives for them
/// exact   each part as line_thick; spans of a row neither overlap nor touch
/// cost    allocates the visible spans of all parts and sorts them
template <SpanSink Sink>
constexpr void polyline_thick(std::span<const subpixel> points, const line_pen& pen, const cell_window& window,
                              Sink&& sink) {
  std::vector<span_of_cells> spans;
  const auto keep = [&](const span_of_cells& s) { spans.push_back(s); };
  std::size_t last = points.size();  // the end of the line's last part that is longer than a point
  while (last > 1 && points[last - 1] == points[last - 2]) --last;
  std::size_t from = 0;
  for (std::size_t to = 1; to < last; ++to) {
    if (points[to] == points[from]) continue;
    const line_caps start = from == 0 ? pen.caps : line_caps::round;
    const line_caps end = to + 1 == last ? pen.caps : line_caps::round;
    detail::stroke_spans(detail::thick_stroke_between(points[from], points[to], pen.width, start, end), window, keep);
    from = to;
  }
  if (from == 0 && !points.empty()) line_thick(points[0], points[0], pen, window, keep);
  std::sort(spans.begin(), spans.end(), [](const span_of_cells& p, const span_of_cells& q) {
    return p.y != q.y ? p.y < q.y : p.x_first < q.x_first;
  });
  for (std::size_t i = 0; i < spans.size();) {
    span_of_cells merged = spans[i++];
    for (; i < spans.size() && spans[i].y == merged.y && spans[i].x_first <= merged.x_last; ++i)
      merged.x_last = greater(merged.x_last, spans[i].x_last);
    sink(merged);
  }
}

/// Paints the pixels of the thick line from a to b, each once.
/// gives   false, and no pixel, when line_thick does
/// exact   the spans of line_thick
template <WritableRaster R, ScreenPosition P, PaintFor<R> Paint = pixel_of<R>>
constexpr bool draw_line_thick(R& raster, const P& a, const P& b, const line_pen& pen, const Paint& paint) {
  return line_thick(a, b, pen, window_of(raster), [&](const span_of_cells& s) { fill_span(raster, s, paint); });
}

/// Paints the pixels of the thick line through all points, each once.
/// exact   the spans of polyline_thick
template <WritableRaster R, PaintFor<R> Paint = pixel_of<R>>
constexpr void draw_polyline_thick(R& raster, std::span<const subpixel> points, const line_pen& pen,
                                   const Paint& paint) {
  polyline_thick(points, pen, window_of(raster), [&](const span_of_cells& s) { fill_span(raster, s, paint); });
}

}  // namespace IRG_ABI
}  // namespace irg
