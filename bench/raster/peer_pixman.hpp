// SPDX-License-Identifier: MIT
// Pixman: polygons as fans of triangles that are rasterized into a mask of one bit or one byte per pixel.
#pragma once

#include <memory>

#include <pixman.h>

#include "raster/polygons.hpp"

namespace bench::pixman {

inline drawer fill(const canvas& c, const polygon_set& set, pixman_format_code_t mask) {
  struct state {
    pixman_image_t *to, *colour;
    state(pixman_image_t* image, pixman_image_t* source) : to(image), colour(source) {
      if (!to || !colour) std::abort();
    }
    state(const state&) = delete;
    state& operator=(const state&) = delete;
    ~state() {
      pixman_image_unref(to);
      pixman_image_unref(colour);
    }
  };
  const pixman_color_t opaque{0xffff, 0xffff, 0xffff, 0xffff};
  auto p =
      std::make_shared<state>(pixman_image_create_bits(PIXMAN_a8r8g8b8, c.width(), c.height(), c.pixels(), c.stride()),
                              pixman_image_create_solid_fill(&opaque));
  auto& triangles = keep_lazy([&set] {
    const auto fixed = [](const irg::subpixel& v) { return pixman_point_fixed_t{v.x * 256, v.y * 256}; };
    std::vector<pixman_triangle_t> all;
    for (int k = 0; k < set.size(); ++k) {
      const auto ring = set.ring(k);
      for (std::size_t i = 2; i < ring.size(); ++i) all.push_back({fixed(ring[0]), fixed(ring[i - 1]), fixed(ring[i])});
    }
    return all;
  });
  const int each = set.corners - 2;
  drawer d{mask == PIXMAN_a1 ? "Pixman triangles a1" : "Pixman triangles", {}};
  d.draw = [p, &triangles, mask, each](int first, int last) {
    for (int k = first; k < last; ++k)
      pixman_composite_triangles(PIXMAN_OP_OVER, p->colour, p->to, mask, 0, 0, 0, 0, each,
                                 triangles->data() + k * each);
  };
  return d;
}

}  // namespace bench::pixman
