// SPDX-License-Identifier: MIT
// Drawings in vectors as SVG: lines, solid or dashed, and regions of any number of rings, streamed as text to a sink.
// Pictures of pixels are for encode_svg.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include <irg/colour/pixel.hpp>
#include <irg/core/vocabulary.hpp>
#include <irg/io/detail/svg_runs.hpp>
#include <irg/math/vec.hpp>

namespace irg {

/// How a line is drawn.
/// units   those of the drawing; with dash > 0 the line is dashes so long, with gaps as long
struct svg_stroke {
  rgba8 colour{0, 0, 0, 255};
  double width = 1, dash = 0;
  bool operator==(const svg_stroke&) const = default;
};

namespace detail::inline IRG_ABI {

// A number to the nearest millionth, of two the greater size, without trailing zeros; those beyond 2^40 as 2^40.
template <class Bytes>
constexpr void append_millionths(Bytes& out, double v) {
  constexpr double limit = 0x1p40;
  const double size = v < 0 ? -v : v, bounded = size < limit ? size : limit;
  const auto whole = static_cast<std::int64_t>(bounded);
  // What is behind the point, in 2^-64ths or, where those do not hold it, in 2^-75ths, times a million: all its bits,
  // but for what is nearer to 0 than 2^-22.
  const double behind = bounded - static_cast<double>(whole);
  const bool is_small = behind < 0x1p-11;
  const auto bits = static_cast<std::uint64_t>(behind * (is_small ? 0x1p75 : 0x1p64));
  const std::uint64_t millionths = (bits >> 32) * 1000000 + ((bits & 0xffffffff) * 1000000 >> 32);
  const int shift = is_small ? 43 : 32;
  const std::int64_t parts =
      whole * 1000000 + static_cast<std::int64_t>((millionths + (std::uint64_t{1} << (shift - 1))) >> shift);
  if (v < 0 && parts != 0) append_text(out, "-");
  char digits[20] = {};
  int count = 0;
  for (std::int64_t rest = parts / 1000000; rest > 0 || count == 0; rest /= 10)
    digits[count++] = static_cast<char>('0' + rest % 10);
  while (count > 0) out.push_back(static_cast<std::uint8_t>(digits[--count]));
  std::int64_t fraction = parts % 1000000;
  if (fraction != 0) append_text(out, ".");
  for (std::int64_t place = 100000; fraction != 0; fraction %= place, place /= 10)
    out.push_back(static_cast<std::uint8_t>('0' + fraction / place));
}

}  // namespace detail::inline IRG_ABI

inline namespace IRG_ABI {

/// A drawing whose text goes to a sink, piece by piece: sink(std::string_view).
/// shape   units are pixels, x to the right and y down; what is added later lies over what was added before. finish()
///         ends the text
/// needs   finite coordinates, a sink that outlives the drawing
/// exact   coordinates to the nearest millionth, those beyond 2^40 as 2^40
/// cost    about 60 bytes a line, 20 a corner; one buffer, of the longest element
template <class Sink>
class svg_drawing {
public:
  constexpr svg_drawing(Sink& sink, const extent2& size, const rgba8& background) : sink_(sink), size_(size) {
    const auto [width, height] = size;
    put("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"").put(width).put("\" height=\"").put(height);
    put("\" viewBox=\"0 0 ").put(width).put(" ").put(height).put("\">\n<rect width=\"100%\" height=\"100%\" ");
    detail::append_paint(text_, "fill", background);
    put("/>\n").flush();
  }
  [[deprecated("irg: svg_drawing(sink, {width, height}, background)")]] constexpr svg_drawing(Sink& sink, int width,
                                                                                              int height,
                                                                                              const rgba8& background)
      : svg_drawing(sink, extent2{width, height}, background) {}

  /// Lines added from here on are drawn so.
  constexpr void begin_lines(const svg_stroke& stroke) {
    end_lines();
    lines_ = true;
    reach_ = stroke.width / 2;
    put("<g ");
    detail::append_paint(text_, "stroke", stroke.colour);
    put(" stroke-linecap=\"round\"");
    if (stroke.width != 1) put(" stroke-width=\"").put(stroke.width).put("\"");
    if (stroke.dash > 0) put(" stroke-dasharray=\"").put(stroke.dash).put("\"");
    put(">\n").flush();
  }
  /// A line; nothing where it lies beside the picture, in all its width.
  constexpr void add_line(const point<double, 2>& a, const point<double, 2>& b) {
    const double left = -reach_, right = size_.width + reach_, bottom = size_.height + reach_;
    if ((a.x < left && b.x < left) || (a.y < left && b.y < left) || (a.x > right && b.x > right) ||
        (a.y > bottom && b.y > bottom))
      return;
    put("<line x1=\"").put(a.x).put("\" y1=\"").put(a.y).put("\" x2=\"").put(b.x).put("\" y2=\"").put(b.y);
    put("\"/>\n").flush();
  }
  /// A region of several rings, filled by the non-zero rule.
  /// shape   a range of ranges of points; rings without corners are left out
  template <class Rings>
  constexpr void add_region(const Rings& rings, const rgba8& colour) {
    end_lines();
    put("<path d=\"");
    for (const auto& ring : rings) {
      bool first = true;
      for (const auto& corner : ring) {
        put(first ? "M" : "L").put(corner.x).put(" ").put(corner.y);
        first = false;
      }
      if (!first) put("Z");
    }
    put("\" ");
    detail::append_paint(text_, "fill", colour);
    put("/>\n").flush();
  }
  constexpr void finish() {
    end_lines();
    put("</svg>\n").flush();
  }

private:
  constexpr void end_lines() {
    if (lines_) put("</g>\n").flush();
    lines_ = false;
  }
  constexpr svg_drawing& put(std::string_view text) {
    detail::append_text(text_, text);
    return *this;
  }
  constexpr svg_drawing& put(int n) {
    detail::append_number(text_, n);
    return *this;
  }
  constexpr svg_drawing& put(double v) {
    detail::append_millionths(text_, v);
    return *this;
  }
  constexpr void flush() {
    piece_.clear();
    for (const std::uint8_t byte : text_) piece_.push_back(static_cast<char>(byte));
    text_.clear();
    sink_(std::string_view(piece_.data(), piece_.size()));
  }

  Sink& sink_;
  extent2 size_;
  bool lines_ = false;
  double reach_ = 0;  // of a line to either side
  std::vector<std::uint8_t> text_{};
  std::vector<char> piece_{};
};

}  // namespace IRG_ABI
}  // namespace irg
