// SPDX-License-Identifier: MIT
#include <irg/raster/draw_triangle.hpp>
#include <irg/raster/fill_span.hpp>
#include <irg/raster/image.hpp>
#include <irg/raster/line_bresenham.hpp>

#include <irg/colour/srgb.hpp>

#include "hashes.hpp"

namespace {

struct encode_srgb {
  constexpr irg::rgba8 operator()(const irg::rgb<float>& light) const { return irg::encode(light); }
};

constexpr irg::screen_vertex random_vertex(test::random& r, int width, int height) {
  return {{static_cast<std::int32_t>(r.integer(-width * 64, width * 320)),
           static_cast<std::int32_t>(r.integer(-height * 64, height * 320))},
          static_cast<float>(r.unit()),
          static_cast<float>(0.01 + r.unit())};
}

constexpr void add(determinism::hasher& h, const irg::image<irg::rgba8>& colour, const irg::image<float>& depth) {
  for (int y = 0; y < colour.height(); ++y)
    for (int x = 0; x < colour.width(); ++x) {
      const irg::rgba8 p = colour(x, y);
      h.add(p.r | p.g << 8 | p.b << 16);
      h.add(depth(x, y));
    }
}

// Constant evaluation takes the plain kernel, run time the lanes: one hash says that they agree.
template <class Order>
constexpr std::uint64_t triangles(int rounds) {
  const int width = rounds < 10 ? 19 : 203, height = rounds < 10 ? 7 : 61;
  test::random r(7);
  determinism::hasher h;
  irg::image<irg::rgba8> colour(width, height);
  irg::image<float> depth(width, height, Order::farthest);
  irg::draw_counts counts;
  for (int i = 0; i < rounds; ++i) {
    const auto light = [&] {
      const auto red = static_cast<float>(r.unit()), green = static_cast<float>(r.unit());
      return irg::rgb<float>{red, green, static_cast<float>(r.unit())};
    };
    const auto a = random_vertex(r, width, height), b = random_vertex(r, width, height),
               c = random_vertex(r, width, height);
    const auto at0 = light(), at1 = light(), at2 = light();
    counts += irg::draw_triangle<Order>(colour, depth, a, b, c,
                                        irg::vertex_colour_shader<irg::rgba8, encode_srgb>{at0, at1, at2, {}});
  }
  add(h, colour, depth);
  h.add(counts.tested);
  h.add(counts.shaded);
  h.add(counts.ties);
  return h.value();
}

constexpr std::uint64_t raster_triangle_tile_reversed(int rounds) { return triangles<irg::nearer_is_greater>(rounds); }
constexpr std::uint64_t raster_triangle_tile_standard(int rounds) { return triangles<irg::nearer_is_less>(rounds); }
HASHED(raster_triangle_tile_reversed, 3, 3000);
HASHED(raster_triangle_tile_standard, 3, 3000);

constexpr std::uint64_t raster_fill_span(int rounds) {
  test::random r(8);
  determinism::hasher h;
  irg::image<irg::rgba8> colour(97, 5);
  const irg::image<float> depth(97, 5, 0.0f);
  for (int i = 0; i < rounds; ++i) {
    const int y = static_cast<int>(r.integer(-1, 5)), first = static_cast<int>(r.integer(-9, 97)),
              last = static_cast<int>(r.integer(-9, 120));
    const auto shade = static_cast<std::uint8_t>(r.integer(0, 255));
    irg::fill_span(colour, {y, first, last}, {shade, 1, 2, 3});
  }
  add(h, colour, depth);
  return h.value();
}
HASHED(raster_fill_span, 9, 10000);

constexpr std::uint64_t raster_lines(int rounds) {
  test::random r(9);
  determinism::hasher h;
  for (int i = 0; i < rounds; ++i) {
    const auto end = [&] {
      const int x = static_cast<int>(r.integer(-90, 90));
      return irg::cell{x, static_cast<int>(r.integer(-90, 90))};
    };
    const irg::cell a = end(), b = end();
    irg::line_bresenham(a, b, {-30, -30, 30, 30}, [&](irg::cell c) { h.add(c.x * 1000 + c.y); });
  }
  return h.value();
}
HASHED(raster_lines, 9, 10000);

}  // namespace
