// SPDX-License-Identifier: MIT
// Text in irg's own stroke font: measured, as lines for any sink, and drawn with smooth edges into any raster.
//
// The text is UTF-8 on one line. Code points that the font lacks, control characters too, are boxes; so is each byte
// that belongs to no well-formed code point.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include <irg/core/function_ref.hpp>
#include <irg/raster/line_style.hpp>
#include <irg/raster/stroke.hpp>
#include <irg/raster/stroke_font.hpp>
#if IRG_BODIES
#include <array>

#include <irg/curve/flatten.hpp>
#include <irg/math/trigonometry.hpp>
#endif

namespace irg::inline IRG_ABI {

/// How much room a text takes: its advance along the baseline, what is above that and below.
/// units   those of the size
/// gives   no width for no text; 0 everywhere for a size that is not in (0, 2^20]
/// exact   multiples of the size over 20, each rounded once
[[nodiscard]] constexpr text_extent measure_text(std::string_view text, double size) noexcept;

/// Hands the strokes of a text to sink(points), polyline by polyline.
/// units   pixels, y down; curves within 1/16 pixel
/// gives   false and no call when the position is NaN or infinite or beyond snap_limit, the turn NaN or infinite, the
///         size not in (0, 2^20]
template <class Sink>
  requires requires(Sink& sink, std::span<const point<double, 2>> points) { sink(points); }
constexpr bool text_strokes(std::string_view text, const point<double, 2>& at, const text_style& style, Sink&& sink);

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
                         const Paint& paint);

}  // namespace irg::inline IRG_ABI

namespace irg::detail::inline IRG_COMPILED_ABI {

template <class T>
IRG_API bool strokes_of_text(std::string_view text, const point<T, 2>& at, const text_style& style,
                             const function_ref<void(std::span<const point<T, 2>>)>& sink);

}  // namespace irg::detail::inline IRG_COMPILED_ABI

namespace irg::detail::inline IRG_ABI {

// From bytes to code points, and from a glyph's text to polylines in pixels.

constexpr bool is_text_size(double size) noexcept { return size > 0 && size <= 0x1p20; }

// The code point at text[at], which moves behind it; U+FFFD, one byte on, where there is no well-formed one.
constexpr char32_t next_code_point(std::string_view text, std::size_t& at) noexcept {
  const auto byte = [&](std::size_t i) { return static_cast<char32_t>(static_cast<unsigned char>(text[i])); };
  constexpr char32_t bad = 0xfffd;
  const char32_t lead = byte(at++);
  if (lead < 0x80) return lead;
  const std::size_t more = lead >= 0xf0 ? 3 : lead >= 0xe0 ? 2 : 1;
  if (lead < 0xc2 || lead > 0xf4 || text.size() - at < more) return bad;
  char32_t c = lead & (0x3fu >> more);
  for (std::size_t i = 0; i < more; ++i) {
    if ((byte(at + i) & 0xc0) != 0x80) return bad;
    c = (c << 6) | (byte(at + i) & 0x3f);
  }
  const char32_t least = more == 1 ? 0x80 : more == 2 ? 0x800 : 0x10000;
  if (c < least || c > 0x10ffff || (c >= 0xd800 && c < 0xe000)) return bad;
  at += more;
  return c;
}

}  // namespace irg::detail::inline IRG_ABI

namespace irg::inline IRG_ABI {

[[nodiscard]] constexpr text_extent measure_text(std::string_view text, double size) noexcept {
  if (!detail::is_text_size(size)) return {};
  std::int64_t units = 0;
  for (std::size_t at = 0; at < text.size();)
    units += stroke_glyph_of(detail::next_code_point(text, at)).width + 2 * stroke_font_units::gap;
  const auto scaled = [&](std::int64_t n) { return size * static_cast<double>(n) / stroke_font_units::size; };
  return {scaled(units), scaled(stroke_font_units::ascent), scaled(stroke_font_units::descent)};
}

template <class Sink>
  requires requires(Sink& sink, std::span<const point<double, 2>> points) { sink(points); }
constexpr bool text_strokes(std::string_view text, const point<double, 2>& at, const text_style& style, Sink&& sink) {
  return detail::strokes_of_text<double>(text, at, style, as_function<void(std::span<const point<double, 2>>)>(sink));
}

template <WritableRaster R, CoveragePaintFor<R> Paint>
constexpr bool draw_text(R& raster, std::string_view text, const point<double, 2>& at, const text_style& style,
                         const Paint& paint) {
  std::vector<std::vector<point<double, 2>>> rings;
  const auto keep = [&](std::span<const point<double, 2>> ring) { rings.emplace_back(ring.begin(), ring.end()); };
  const stroke_style line{.width = style.weight > 0  ? style.weight
                                   : style.size > 12 ? style.size / 12
                                                     : 1,
                          .caps = line_caps::round};
  bool all = true;
  const bool done = text_strokes(
      text, at, style, [&](std::span<const point<double, 2>> p) { all = stroke_outline(p, line, keep) && all; });
  return done && all && fill_polygon_aa(raster, rings, fill_rule::non_zero, paint);
}

}  // namespace irg::inline IRG_ABI

#if IRG_BODIES
namespace irg::detail::inline IRG_ABI {

// Draws glyphs: the position of the text, its direction, where on the line the glyph begins, pixels per unit.
template <class T>
struct glyph_pen {
  point<T, 2> at;
  vec<T, 2> direction;
  vec<T, 2> from;
  T unit;
  std::vector<point<T, 2>> line;

  constexpr point<T, 2> placed(const vec<T, 2>& p) const noexcept {
    const T x = from.x + product(p.x, unit), y = from.y - product(p.y, unit);
    return {at.x + (product(x, direction.x) - product(y, direction.y)),
            at.y + (product(x, direction.y) + product(y, direction.x))};
  }

  static constexpr int number(std::string_view text, std::size_t& i) noexcept {
    const bool negative = text[i] == '-';
    if (negative) ++i;
    int n = 0;
    for (; i < text.size() && text[i] >= '0' && text[i] <= '9'; ++i) n = 10 * n + (text[i] - '0');
    return negative ? -n : n;
  }

  // The parabola from the line's last point to the next.
  constexpr void bend(const vec<T, 2>& control, const vec<T, 2>& end) {
    const std::array<point<T, 2>, 3> c{line.back(), placed(control), placed(end)};
    std::array<point<T, 2>, 9> scratch{};
    flatten(c, T(0x1p-4), std::span<point<T, 2>>(scratch), [&](const point<T, 2>& p) {
      if (!(p == line.back())) line.push_back(p);
    });
  }

  template <class Sink>
  constexpr void draw(std::string_view text, Sink& sink) {
    line.clear();
    vec<T, 2> control{};
    bool bends = false;
    for (std::size_t i = 0; i < text.size();) {
      const bool is_control = text[i] == '~';
      if (is_control) ++i;
      const int x = number(text, i);
      const int y = number(text, ++i);
      const vec<T, 2> p{static_cast<T>(x), static_cast<T>(y)};
      if (bends)
        bend(control, is_control ? (control + p) * T(0.5) : p);
      else if (!is_control)
        line.push_back(placed(p));
      bends = is_control;
      control = p;
      if (i == text.size() || text[i] == ';') {
        sink(std::span<const point<T, 2>>(line.data(), line.size()));
        line.clear();
      }
      if (i < text.size()) ++i;
    }
  }
};

}  // namespace irg::detail::inline IRG_ABI

namespace irg::detail::inline IRG_COMPILED_ABI {

template <class T>
IRG_API bool strokes_of_text(std::string_view text, const point<T, 2>& at, const text_style& style,
                             const function_ref<void(std::span<const point<T, 2>>)>& sink) {
  const auto turn = sin_cos_degrees(style.clockwise_degrees);
  if (!is_text_size(style.size) || !can_snap(at) || !(turn.sine == turn.sine)) return false;
  const text_extent e = measure_text(text, style.size);
  const double back = style.along == text_along::left ? 0 : style.along == text_along::centre ? 0.5 * e.width : e.width;
  const double capital = style.size * stroke_font_units::capital / stroke_font_units::size;
  const double down = style.across == text_across::baseline ? 0
                      : style.across == text_across::middle ? 0.5 * capital
                      : style.across == text_across::top    ? e.ascent
                                                            : -e.descent;
  glyph_pen<T> pen{at, {turn.cosine, turn.sine}, {-back, down}, style.size / stroke_font_units::size, {}};
  for (std::size_t i = 0; i < text.size();) {
    const stroke_glyph g = stroke_glyph_of(next_code_point(text, i));
    pen.from.x += pen.unit * stroke_font_units::gap;
    pen.draw(g.strokes, sink);
    pen.from.x += pen.unit * (g.width + stroke_font_units::gap);
  }
  return true;
}

}  // namespace irg::detail::inline IRG_COMPILED_ABI
#endif
