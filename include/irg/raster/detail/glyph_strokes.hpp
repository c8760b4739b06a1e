// SPDX-License-Identifier: MIT
// From bytes to code points, and from a glyph's text to polylines in pixels.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include <irg/curve/flatten.hpp>
#include <irg/math/trigonometry.hpp>
#include <irg/raster/stroke_font.hpp>

namespace irg::detail {
inline namespace IRG_ABI {

constexpr bool is_text_size(double size) noexcept { return size > 0 && size <= 0x1p20; }

constexpr double usual_weight(double size) noexcept { return size > 12 ? size / 12 : 1; }

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

}  // namespace IRG_ABI
}  // namespace irg::detail
