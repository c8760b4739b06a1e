// SPDX-License-Identifier: MIT
// Mixed colours, panes of some opacity, palettes. Included by pictures.cpp.
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include <irg/colour/mix.hpp>
#include <irg/colour/over.hpp>
#include <irg/colour/palette.hpp>
#include <irg/colour/srgb.hpp>
#include <irg/raster/draw_text.hpp>
#include <irg/raster/image.hpp>

#include "enlarged.hpp"

namespace colour_pictures {

using namespace enlarging;

inline void label(picture& p, const std::string& text, int x, int y) {
  irg::draw_text(p, text, irg::point<double, 2>(x, y), {.size = 16}, ink);
}

// From one colour to another, byte by byte as they are encoded, and as light.
inline picture mixes() {
  constexpr int steps = 256, wide = 3;
  constexpr std::array<irg::rgba8, 2> pairs[] = {{{{0, 0, 0, 255}, {255, 255, 255, 255}}},
                                                 {{{220, 30, 30, 255}, {30, 190, 60, 255}}}};
  picture p(steps * wide + 40, 290, paper);
  int top = 32;
  for (const auto& [a, b] : pairs)
    for (const bool as_light : {false, true}) {
      label(p, as_light ? "decoded, mixed as light and encoded" : "mix, as the codes are", 20, top - 6);
      for (int i = 0; i < steps; ++i) {
        const auto coverage = static_cast<std::uint8_t>(i);
        const irg::rgba8 c =
            as_light ? irg::encode(irg::mix(irg::decode(a), irg::decode(b), coverage)) : irg::mix(a, b, coverage);
        for (int y = top; y < top + 34; ++y) irg::fill_span(p, {y, 20 + i * wide, 20 + (i + 1) * wide}, c);
      }
      top += 66;
    }
  return p;
}

// Panes of a tenth to nine tenths over stripes, in light above and as encoded below.
inline picture overs() {
  constexpr int pane = 74, high = 110;
  picture p(20 + 9 * (pane + 10) + 10, 2 * high + 84, paper);
  const auto row = [&](int top, const auto& over) {
    for (int y = top; y < top + high; ++y)
      for (int x = 20; x < p.width() - 20; ++x) {
        const int i = (x - 20) / (pane + 10);
        const bool in_pane = (x - 20) % (pane + 10) < pane && y >= top + 14 && y < top + high - 14;
        const std::uint8_t code = (y - top) / 11 % 2 ? 255 : 0;
        const irg::rgba8 stripe{code, code, code, 255};
        const auto opacity = static_cast<std::uint8_t>((255 * (i + 1) + 5) / 10);
        p(x, y) = in_pane ? over(stripe, irg::rgba8{235, 120, 40, opacity}) : stripe;
      }
  };
  label(p, "over_in_light: opacity 0.1 to 0.9", 20, 26);
  row(32, irg::over_in_light{});
  label(p, "over_as_encoded", 20, high + 58);
  row(high + 64, irg::over_as_encoded{});
  return p;
}

// Three palettes, a colour for each of 0 to 255.
inline picture palettes() {
  constexpr irg::cyclic_palette<irg::rgba8, 3> seasons{{{{0, 90, 0, 255}, {200, 90, 0, 255}, {250, 250, 250, 255}}},
                                                       10};
  constexpr irg::cyclic_palette<irg::rgba8, 4> depths{
      {{{10, 20, 90, 255}, {60, 160, 220, 255}, {250, 240, 200, 255}, {190, 100, 30, 255}}}, 32};
  constexpr irg::cyclic_palette<irg::rgba8, 2> bands{{{{32, 44, 66, 255}, {250, 249, 246, 255}}}, 1};
  constexpr int wide = 3;
  picture p(256 * wide + 40, 220, paper);
  const auto strip = [&](int top, const std::string& text, const auto& palette) {
    label(p, text, 20, top - 6);
    for (int i = 0; i < 256; ++i)
      for (int y = top; y < top + 34; ++y) irg::fill_span(p, {y, 20 + i * wide, 20 + (i + 1) * wide}, palette(i));
  };
  strip(32, "3 colours, 10 steps from one to the next", seasons);
  strip(98, "4 colours, 32 steps", depths);
  strip(164, "2 colours, 1 step", bands);
  return p;
}

}  // namespace colour_pictures
