// SPDX-License-Identifier: MIT
#include <irg/raster/stroke_font.hpp>

namespace {

constexpr auto box = irg::stroke_glyph_of(0xfffd).strokes;

// Digits are of one width, so that columns of numbers stand in line; only what the font lacks is a box.
static_assert([] {
  for (char32_t c = U'0'; c <= U'9'; ++c)
    if (irg::stroke_glyph_of(c).width != irg::stroke_glyph_of(0xfffd).width) return false;
  for (char32_t c = 33; c < 127; ++c)
    if (irg::stroke_glyph_of(c).strokes == box || irg::stroke_glyph_of(c).strokes.empty()) return false;
  for (const char32_t c : {U'\u00b0', U'\u00d7', U'\u2190', U'\u2191', U'\u2192', U'\u2193'})
    if (irg::stroke_glyph_of(c).strokes == box) return false;
  return true;
}());
static_assert(irg::stroke_glyph_of(U' ').strokes.empty());
static_assert(irg::stroke_glyph_of(0).strokes == box && irg::stroke_glyph_of(127).strokes == box);
static_assert(irg::stroke_glyph_of(0xffffffff).strokes == box);

}  // namespace
