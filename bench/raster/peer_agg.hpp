// SPDX-License-Identifier: MIT
// Anti-Grain Geometry. Header-only but for a few tables, so it is built with the benchmark's own flags.
#pragma once

#include <memory>

#include <agg_conv_stroke.h>
#include <agg_path_storage.h>
#include <agg_pixfmt_rgba.h>
#include <agg_rasterizer_outline_aa.h>
#include <agg_rasterizer_scanline_aa.h>
#include <agg_renderer_outline_aa.h>
#include <agg_renderer_primitives.h>
#include <agg_renderer_scanline.h>
#include <agg_scanline_bin.h>
#include <agg_scanline_p.h>
#include <agg_scanline_u.h>

#include "raster/lines.hpp"
#include "raster/polygons.hpp"

namespace bench::antigrain {

using format = agg::pixfmt_bgra32;
using base = agg::renderer_base<format>;

struct target {
  explicit target(const canvas& c)
      : memory(reinterpret_cast<agg::int8u*>(c.pixels()), static_cast<unsigned>(c.width()),
               static_cast<unsigned>(c.height()), c.stride()),
        pixels(memory), renderer(pixels) {}
  target(const target&) = delete;
  target& operator=(const target&) = delete;
  agg::rendering_buffer memory;
  format pixels;
  base renderer;
  const agg::rgba8 colour{255, 255, 255, 255};
};

inline drawer lines(const canvas& c, line_list& lines) {
  struct state : target {
    explicit state(const canvas& on) : target(on), pen(renderer) { pen.line_color(colour); }
    agg::renderer_primitives<base> pen;
  };
  return {"AGG renderer_primitives", [p = std::make_shared<state>(c), &lines](int first, int last) {
            for (int k = first; k < last; ++k) {
              const segment& s = (*lines)[static_cast<std::size_t>(k)];
              // From centre to centre, in 1/256 pixel.
              p->pen.line(s.a.x * 256 + 128, s.a.y * 256 + 128, s.b.x * 256 + 128, s.b.y * 256 + 128, true);
            }
          }};
}

inline drawer lines_outline_aa(const canvas& c, line_list& lines) {
  struct state : target {
    explicit state(const canvas& on)
        : target(on), profile(1.0, agg::gamma_none()), outline(renderer, profile), pen(outline) {
      outline.color(colour);
    }
    agg::line_profile_aa profile;
    agg::renderer_outline_aa<base> outline;
    agg::rasterizer_outline_aa<agg::renderer_outline_aa<base>> pen;
  };
  drawer d{"AGG outline_aa", {}};
  d.draw = [p = std::make_shared<state>(c), &lines](int first, int last) {
    for (int k = first; k < last; ++k) {
      const segment& s = (*lines)[static_cast<std::size_t>(k)];
      p->pen.move_to_d(s.a.x + 0.5, s.a.y + 0.5);
      p->pen.line_to_d(s.b.x + 0.5, s.b.y + 0.5);
      p->pen.render(false);
    }
  };
  d.note = "its own profile across the line";
  return d;
}

inline drawer lines_stroke_aa(const canvas& c, line_list& lines) {
  struct state : target {
    using target::target;
    agg::rasterizer_scanline_aa<> rasterizer{};
    agg::scanline_p8 scanline{};
    agg::path_storage path{};
  };
  return {"AGG stroke", [p = std::make_shared<state>(c), &lines](int first, int last) {
            agg::conv_stroke<agg::path_storage> stroke(p->path);
            stroke.width(1);
            stroke.line_cap(agg::butt_cap);
            for (int k = first; k < last; ++k) {
              const segment& s = (*lines)[static_cast<std::size_t>(k)];
              p->path.remove_all();
              p->path.move_to(s.a.x + 0.5, s.a.y + 0.5);
              p->path.line_to(s.b.x + 0.5, s.b.y + 0.5);
              p->rasterizer.reset();
              p->rasterizer.add_path(stroke);
              agg::render_scanlines_aa_solid(p->rasterizer, p->scanline, p->renderer, p->colour);
            }
          }};
}

/// Scanline says what is drawn: scanline_bin fills whole pixels, scanline_u8 and scanline_p8 mix.
template <class Scanline>
drawer fill(const canvas& c, const polygon_set& set, std::string name) {
  struct state : target {
    using target::target;
    agg::rasterizer_scanline_aa<> rasterizer{};
    Scanline scanline{};
  };
  auto p = std::make_shared<state>(c);
  p->rasterizer.filling_rule(set.rule() == irg::fill_rule::even_odd ? agg::fill_even_odd : agg::fill_non_zero);
  if (set.where != placing::inside) p->rasterizer.clip_box(0, 0, c.width(), c.height());
  drawer d{std::move(name), {}};
  d.draw = [p, &set](int first, int last) {
    agg::renderer_scanline_bin_solid<base> solid(p->renderer);
    solid.color(p->colour);
    for (int k = first; k < last; ++k) {
      const auto ring = set.ring(k);
      p->rasterizer.reset();
      p->rasterizer.move_to(ring[0].x, ring[0].y);
      for (std::size_t i = 1; i < ring.size(); ++i) p->rasterizer.line_to(ring[i].x, ring[i].y);
      if constexpr (std::is_same_v<Scanline, agg::scanline_bin>)
        agg::render_scanlines(p->rasterizer, p->scanline, solid);
      else
        agg::render_scanlines_aa_solid(p->rasterizer, p->scanline, p->renderer, p->colour);
    }
  };
  if constexpr (std::is_same_v<Scanline, agg::scanline_bin>) {
    d.same_work = false;
    d.note = "draws every pixel that is touched";
  }
  return d;
}

}  // namespace bench::antigrain
