// SPDX-License-Identifier: MIT
// Whole pictures: from a mesh through transform, light, clipping and the triangle kernel to bytes.
#include <irg/render/render.hpp>

#include <bit>
#include <initializer_list>

#include <irg/io/obj.hpp>
#include <irg/io/png.hpp>
#include <irg/mesh/shapes.hpp>
#include <irg/mesh/teapot.hpp>
#include <irg/raster/image.hpp>
#include <irg/render/textbook/pipeline.hpp>
#include <irg/view/projection.hpp>

#include "../../examples/studio/studio_picture.hpp"
#include "hashes.hpp"

namespace {

// One round is a cube in a small picture; more rounds take the teapot, seen from near and from inside as well.
template <class T>
constexpr std::uint64_t pictures(irg::picture_style style, int rounds) {
  const int width = rounds == 1 ? 14 : 320, height = rounds == 1 ? 9 : 180;
  determinism::hasher h;
  irg::scene<T> world;
  world.objects.resize(1);
  if (rounds == 1)
    world.objects[0].shape = irg::shape_cube<T>();
  else
    world.objects[0].shape = irg::shape_teapot<T>();
  world.objects[0].surface = {{T(0.2), T(0.1), T(0.1)}, {T(0.7), T(0.5), T(0.3)}, {T(0.3), T(0.3), T(0.3)}, T(9.5)};
  world.lights = {{{T(1), T(2), T(3), T(0)}, {T(1), T(1), T(1)}},
                  {{T(-3), T(4), T(1), T(1)}, {T(0.5), T(0.25), T(0.125)}}};
  world.ambient = {T(0.3), T(0.3), T(0.4)};
  const auto ball = irg::bounding_sphere_of(world.objects[0].shape);
  for (int i = 0; i < rounds; ++i) {
    world.view = irg::camera_around(ball.centre, ball.radius / T(1 << i), irg::vec<T, 3>{T(1), T(0.8), T(1.6)}, T(0.7),
                                    static_cast<T>(width) / static_cast<T>(height));
    irg::image<irg::rgba8> colour(width, height);
    irg::image<float> depth(width, height);
    const auto stats = irg::render(
        world, {colour, depth}, {.style = style, .culling = i % 2 ? irg::face_culling::none : irg::face_culling::back});
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) {
        const irg::rgba8 p = colour(x, y);
        h.add(p.r | p.g << 8 | p.b << 16);
        if (style != irg::picture_style::wire) h.add(depth(x, y));
      }
    h.add(stats.skipped.backface);
    h.add(stats.skipped.frustum);
    h.add(stats.skipped.tiny);
    h.add(stats.pixels.tested);
    h.add(stats.drawn);
  }
  return h.value();
}

constexpr std::uint64_t render_wire(int rounds) { return pictures<double>(irg::picture_style::wire, rounds); }
constexpr std::uint64_t render_flat(int rounds) { return pictures<double>(irg::picture_style::flat, rounds); }
constexpr std::uint64_t render_gouraud(int rounds) { return pictures<double>(irg::picture_style::gouraud, rounds); }
constexpr std::uint64_t render_gouraud_float(int rounds) {
  return pictures<float>(irg::picture_style::gouraud, rounds);
}
constexpr std::uint64_t render_phong(int rounds) { return pictures<double>(irg::picture_style::phong, rounds); }
HASHED(render_wire, 1, 5);
HASHED(render_flat, 1, 5);
HASHED(render_gouraud, 1, 5);
HASHED(render_gouraud_float, 1, 5);
HASHED(render_phong, 1, 5);

// Triangles in disorder by the pipeline on one screen.
constexpr std::uint64_t render_textbook(int rounds) {
  determinism::hasher h;
  test::random r(64);
  for (int i = 0; i < rounds; ++i) {
    const int size = rounds < 10 ? 6 : 40;
    std::vector<irg::point<double, 3>> corners;
    for (int k = 0; k < 12; ++k) {
      const double x = irg::product(r.unit() - 0.5, 8.0), y = irg::product(r.unit() - 0.5, 8.0);
      corners.push_back({x, y, -1 - irg::product(r.unit(), 5.0)});
    }
    irg::image<irg::rgba8> picture(size, size);
    irg::image<float> depth(size, size, 0.0f);
    irg::textbook::shade_triangles(corners, irg::perspective(1.25, 1.0, 0.5, 9.0), picture, depth,
                                   [](std::size_t n, const irg::pixel_weights<float>& at) {
                                     const auto channel = [](float v) { return static_cast<std::uint8_t>(v); };
                                     return irg::rgba8{channel(irg::product(at.weight1, 255.0f)),
                                                       channel(irg::product(at.weight2, 255.0f)),
                                                       static_cast<std::uint8_t>(n), 255};
                                   });
    for (int y = 0; y < size; ++y)
      for (int x = 0; x < size; ++x) {
        h.add(picture(x, y));
        h.add(depth(x, y));
      }
  }
  return h.value();
}
HASHED(render_textbook, 2, 300);

// Light scaled into the display's range.
constexpr std::uint64_t render_rescaled(int rounds) {
  determinism::hasher h;
  for (int i = 0; i < rounds; ++i) {
    const int size = rounds == 1 ? 6 : 90;
    irg::scene<double> s;
    irg::mesh<double> m;
    m.positions = {{-1, -1, 0.1 * i}, {1, -1, -1}, {0, 1, 0}, {1.5, 1.5, -0.5}};
    m.corners = {{0}, {1}, {2}, {1}, {3}, {2}};
    m.face_starts = {0, 3, 6};
    s.objects.push_back({m});
    s.objects[0].surface = {{0.5, 1, 2}, {1, 0.7, 0.5}, {0.3, 0.3, 0.3}, 8};
    s.lights = {{{1, 2, 3, 1}, {2, 2, 2}}, {{-1, 0.5, 1, 0}, {1, 0.5, 0.25}}};
    s.ambient = {0.3, 0.3, 0.3};
    s.view.eye = {0, 0, 3};
    s.view.target = {0, 0, 0};
    irg::render_options o;
    o.style = static_cast<irg::picture_style>(1 + i % 3);
    o.culling = irg::face_culling::none;
    o.intensities = irg::intensity_range::rescale;
    irg::image<irg::rgba8> colour(size, size);
    irg::image<float> depth(size, size);
    irg::render(s, {colour, depth}, o);
    for (int y = 0; y < size; ++y)
      for (int x = 0; x < size; ++x) h.add(colour(x, y));
  }
  return h.value();
}
HASHED(render_rescaled, 1, 9);

constexpr std::uint64_t io_obj_and_png(int rounds) {
  determinism::hasher h;
  const auto mesh =
      irg::read_obj<double>("v 0.1 1e-3 3.25\nv 12.5 -.5 7\nv 1 2.000000000000000001 3\nvn 0 0 1\nf 1//1 2//1 -1//1\n");
  if (mesh)
    for (const auto& p : mesh->positions)
      for (int i = 0; i < 3; ++i) h.add(p[i]);
  irg::image<irg::rgba8> picture(9 * rounds, 5 * rounds);
  for (int y = 0; y < picture.height(); ++y)
    for (int x = 0; x < picture.width(); ++x)
      picture(x, y) = {static_cast<std::uint8_t>(x * y / 7), static_cast<std::uint8_t>(x), static_cast<std::uint8_t>(y),
                       255};
  if (const auto png = irg::encode_png(picture))
    for (const std::uint8_t byte : *png) h.add(byte);
  return h.value();
}
HASHED(io_obj_and_png, 1, 60);

constexpr std::uint64_t studio_views(int rounds) {
  determinism::hasher h;
  irg::studio<double> s;
  irg::mesh<double> m;
  m.positions = {{-2, -2, 0}, {3, -1, 0}, {0, 3, 1}, {1, 1, 2}};
  irg::add_face(m, std::initializer_list<int>{0, 1, 2});
  irg::add_face(m, std::initializer_list<int>{0, 2, 3});
  (void)irg::apply_event(s, irg::load_body<double>{irg::store_body("a", m)});
  (void)irg::apply_event(s, irg::load_body<double>{irg::store_body("a", m)});
  (void)irg::apply_event(s, irg::show_part{{}, irg::studio_part::edges, irg::display::shown});
  (void)irg::apply_event(s, irg::set_opacity<double>{"a(2)", 0.5});
  for (int i = 0; i < rounds; ++i) {
    const auto shading = static_cast<irg::studio_shading>(i % 4);
    const auto kind = static_cast<irg::projection_kind>(i % 3);
    (void)irg::apply_event(s, irg::shade_body{{}, shading});
    (void)irg::apply_event(s, irg::add_transformation<double>{
                                  "a(2)", static_cast<irg::studio_stage>(i % 2), {irg::studio_map::rotate_z, {17}}});
    (void)irg::apply_event(s, irg::orbit_camera<double>{irg::studio_view::main, 10.0 * i, 3, 0.98});
    (void)irg::apply_event(s, irg::set_projection<double>{irg::studio_view::main, kind, 30, 0.5});
    const int size = rounds < 3 ? 8 : 48;
    irg::image<irg::rgba8> colour(2 * size, size);
    irg::studio_memory<double> memory;
    irg::draw_studio_view(colour.view(), s, irg::studio_view::main, memory);
    for (int y = 0; y < size; ++y)
      for (int x = 0; x < 2 * size; ++x) h.add(colour(x, y));
  }
  return h.value();
}
HASHED(studio_views, 1, 12);

}  // namespace
