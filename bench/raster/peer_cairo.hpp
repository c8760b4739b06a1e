// SPDX-License-Identifier: MIT
// Cairo, on an image surface on the canvas.
#pragma once

#include <memory>

#include <cairo.h>

#include "raster/lines.hpp"
#include "raster/polygons.hpp"

namespace bench::cairo {

inline std::shared_ptr<cairo_t> context(const canvas& c, cairo_antialias_t antialias) {
  cairo_surface_t* surface = cairo_image_surface_create_for_data(reinterpret_cast<unsigned char*>(c.pixels()),
                                                                 CAIRO_FORMAT_RGB24, c.width(), c.height(), c.stride());
  cairo_t* to = cairo_create(surface);
  cairo_surface_destroy(surface);  // the context keeps it
  if (cairo_status(to) != CAIRO_STATUS_SUCCESS) std::abort();
  cairo_set_source_rgb(to, 1, 1, 1);
  cairo_set_antialias(to, antialias);
  cairo_set_line_width(to, 1);
  // Without antialiasing, the pixels of both ends are wanted.
  cairo_set_line_cap(to, antialias == CAIRO_ANTIALIAS_NONE ? CAIRO_LINE_CAP_SQUARE : CAIRO_LINE_CAP_BUTT);
  return {to, cairo_destroy};
}

inline drawer lines(const canvas& c, line_list& lines, cairo_antialias_t antialias) {
  return {antialias == CAIRO_ANTIALIAS_NONE ? "Cairo stroke aliased" : "Cairo stroke",
          [to = context(c, antialias), &lines](int first, int last) {
            for (int k = first; k < last; ++k) {
              const segment& s = (*lines)[static_cast<std::size_t>(k)];
              cairo_move_to(to.get(), s.a.x + 0.5, s.a.y + 0.5);
              cairo_line_to(to.get(), s.b.x + 0.5, s.b.y + 0.5);
              cairo_stroke(to.get());
            }
          }};
}

inline drawer fill(const canvas& c, const polygon_set& set, cairo_antialias_t antialias) {
  auto to = context(c, antialias);
  cairo_set_fill_rule(to.get(),
                      set.rule() == irg::fill_rule::even_odd ? CAIRO_FILL_RULE_EVEN_ODD : CAIRO_FILL_RULE_WINDING);
  return {antialias == CAIRO_ANTIALIAS_NONE ? "Cairo fill aliased" : "Cairo fill", [to, &set](int first, int last) {
            for (int k = first; k < last; ++k) {
              const auto ring = set.ring(k);
              cairo_move_to(to.get(), ring[0].x / 256.0, ring[0].y / 256.0);
              for (std::size_t i = 1; i < ring.size(); ++i)
                cairo_line_to(to.get(), ring[i].x / 256.0, ring[i].y / 256.0);
              cairo_close_path(to.get());
              cairo_fill(to.get());
            }
          }};
}

}  // namespace bench::cairo
