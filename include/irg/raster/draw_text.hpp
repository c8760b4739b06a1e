// SPDX-License-Identifier: MIT
// Text in irg's own stroke font: measured, as lines for any sink, and drawn with smooth edges into any raster.
//
// The text is UTF-8 on one line. Code points that the font lacks, control characters too, are boxes; so is each byte
// that belongs to no well-formed code point.
#pragma once

#include <array>
#include <span>
#include <string_view>
#include <vector>

#include <irg/math/trigonometry.hpp>
#include <irg/raster/detail/glyph_strokes.hpp>
#include <irg/raster/stroke.hpp>
#include <irg/raster/text_style.hpp>

namespace irg {
inline namespace IRG_ABI {

/// How much room a text takes: its advance along the baseline, what is above that and below.
/// units   those of the size
/// gives   no width for no text; 0 everywhere for a size that is not in (0, 2^20]
/// exact   multiples of the size over 20, each rounded once
[[nodiscard]] constexpr text_extent measure_text(std::string_view text, double size) noexcept {
  if (!detail::is_text_size(size)) return {};
  std::int64_t units = 0;
  for (std::size_t at = 0; at < text.size();)
    units += stroke_glyph_of(detail::next_code_point(text, at)).width + 2 * stroke_font_units::gap;
  const auto scaled = [&](std::int64_t n) { return size * static_cast<double>(n) / stroke_font_units::size; };
  return {scaled(units), scaled(stroke_font_units::ascent), scaled(stroke_font_units::descent)};
}

/// Hands the strokes of a text to sink(points), polyline by polyline.
/// units   pixels, y down; curves within 1/16 pixel
/// gives   false and no call when the position is NaN or infinite or beyond snap_limit, the turn NaN or infinite, the
///         size not in (0, 2^20]
template <class Sink>
  requires requires(Sink& sink, std::span<const point<double, 2>> points) { sink(points); }
constexpr bool text_strokes(std::string_view text, const point<double, 2>& at, const text_style& style, Sink&& sink) {
  const auto turn = sin_cos_degrees(style.turn);
  if (!detail::is_text_size(style.size) || !can_snap(at) || !(turn.sine == turn.sine)) return false;
  const text_extent e = measure_text(text, style.size);
  const double back = style.along == text_along::left ? 0 : style.along == text_along::centre ? 0.5 * e.width : e.width;
  const double capital = style.size * stroke_font_units::capital / stroke_font_units::size;
  const double down = style.across == text_across::baseline ? 0
                      : style.across == text_across::middle ? 0.5 * capital
                      : style.across == text_across::top    ? e.ascent
                                                            : -e.descent;
  detail::glyph_pen<double> pen{at, {turn.cosine, turn.sine}, {-back, down}, style.size / stroke_font_units::size, {}};
  for (std::size_t i = 0; i < text.size();) {
    const stroke_glyph g = stroke_glyph_of(detail::next_code_point(text, i));
    pen.from.x += pen.unit * stroke_font_units::gap;
    pen.draw(g.strokes, sink);
    pen.from.x += pen.unit * (g.width + stroke_font_units::gap);
  }
  return true;
}

/// Hands the strokes of a text to sink(from, to), segment by segment: for SVG, and for other drawings of lines.
/// gives   as text_strokes
template <SegmentSink<point<double, 2>> Sink>
constexpr bool text_segments(std::string_view text, const point<double, 2>& at, const text_style& style, Sink&& sink) {
  return text_strokes(text, at, style, [&](std::span<const point<double, 2>> p) {
    for (std::size_t i = 1; i < p.size(); ++i) sink(p[i - 1], p[i]);
  });
}

/// Paints a text with smooth edges, each pixel once, as far as its strokes cover it; round joins and caps.
/// units   pixels, y down
/// gives   false and nothing painted when text_strokes or draw_stroke give false
/// exact   the pixels of the union of the strokes; clipping changes none within the raster
/// cost    allocates the strokes' outlines; the raster is visited where the text is
template <WritableRaster R, CoveragePaintFor<R> Paint = pixel_of<R>>
constexpr bool draw_text(R& raster, std::string_view text, const point<double, 2>& at, const text_style& style,
                         const Paint& paint) {
  std::vector<std::vector<point<double, 2>>> rings;
  const auto keep = [&](std::span<const point<double, 2>> ring) { rings.emplace_back(ring.begin(), ring.end()); };
  const stroke_style line{.width = style.weight > 0 ? style.weight : detail::usual_weight(style.size),
                          .caps = line_caps::round};
  bool all = true;
  const bool done = text_strokes(
      text, at, style, [&](std::span<const point<double, 2>> p) { all = stroke_outline(p, line, keep) && all; });
  return done && all && fill_polygon_aa(raster, rings, fill_rule::non_zero, paint);
}

}  // namespace IRG_ABI
}  // namespace irg
