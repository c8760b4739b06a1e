// SPDX-License-Identifier: MIT
// Textures, textured and transparent triangles.
#include <irg/render/draw_transparent.hpp>
#include <irg/render/textured_shading.hpp>
#include <irg/shade/mip_pyramid.hpp>

#include <array>
#include <vector>

#include "hashes.hpp"
#include "support/visible_scenes.hpp"

namespace {

constexpr float any_float(test::random& r, double low, double high) {
  return static_cast<float>(low + (high - low) * r.unit());
}

constexpr irg::image<irg::rgba8> any_texture(test::random& r, int width, int height) {
  irg::image<irg::rgba8> t(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const auto word = static_cast<std::uint32_t>(r.next());
      const auto byte = [word](int i) { return static_cast<std::uint8_t>(word >> (8 * i)); };
      t(x, y) = {byte(0), byte(1), byte(2), byte(3)};
    }
  return t;
}

constexpr irg::texture_sampler any_sampler(test::random& r) {
  const auto filter = static_cast<irg::texture_filter>(r.integer(0, 1));
  const auto u = static_cast<irg::texture_wrap>(r.integer(0, 3)), v = static_cast<irg::texture_wrap>(r.integer(0, 3));
  return {filter, u, v};
}

constexpr std::uint64_t shade_textures(int rounds) {
  test::random r(91);
  determinism::hasher h;
  const auto t = any_texture(r, 5, 3);
  const auto pyramid = irg::make_mip_pyramid(t);
  for (int i = 0; i < rounds; ++i) {
    const float u = any_float(r, -3, 3), v = any_float(r, -3, 3), level = any_float(r, -1, 3);
    const irg::rgb<float> border{1, 0.5f, 2};
    for (const irg::rgb<float>& c : {irg::sample_texture(t, u, v, any_sampler(r), border),
                                     irg::sample_mip_pyramid(pyramid, {u, v, level}, any_sampler(r), border)}) {
      h.add(c.r);
      h.add(c.g);
      h.add(c.b);
    }
    h.add(irg::mip_level({u, v, level, u}, {64, 32}));
  }
  return h.value();
}
HASHED(shade_textures, 12, 20'000);

constexpr void add(determinism::hasher& h, const irg::image<irg::rgba8>& p) {
  for (int y = 0; y < p.height(); ++y)
    for (int x = 0; x < p.width(); ++x) h.add(p(x, y));
}

// Random scenes with a texture; some of their triangles once more as glass.
constexpr std::uint64_t render_textures_and_glass(int rounds) {
  test::random r(92);
  determinism::hasher h;
  const bool small = rounds == 1;
  const auto texture = any_texture(r, 4, 4);
  for (int i = 0; i < rounds; ++i) {
    const int width = small ? 5 : 40 + 5 * i, height = small ? 4 : 100 - i;
    const auto kind = static_cast<test::scene_kind>(small ? 0 : i % test::scene_kinds);
    const test::triangle_scene s = test::scene_maker(r, kind, width, height)(small ? 3 : 40);
    std::vector<irg::textured_vertex> vertices;
    for (std::size_t k = 0; k < s.positions.size(); ++k) {
      const float u = any_float(r, -2, 2), v = any_float(r, -2, 2), light = any_float(r, 0, 1.25);
      vertices.push_back(irg::make_textured_vertex(u, v, {light, light, 0.5f}));
    }
    const irg::textured_vertices objects[1] = {{vertices}};
    const irg::texture_image textures[1] = {{texture.view(), any_sampler(r)}};
    const auto mapping = irg::map_to_screen<double>({width, height});
    const auto projected = irg::project_vertices<double>(s.positions, s.to_clip, mapping);
    irg::image<irg::rgba8> colour(width, height);
    irg::image<float> depth(width, height);
    const irg::draw_options<irg::rgba8> settings{irg::face_culling::none, {}, irg::clearing::before_drawing, {}};
    const std::span<const irg::triangle_indices> all(s.triangles);
    const irg::triangle_batch<double> opaque[1] = {{&projected, all.first(all.size() / 2)}},
                                      glass[1] = {{&projected, all.subspan(all.size() / 2)}};
    irg::shade_batches(irg::render_target{colour, depth}, {opaque, mapping}, irg::textured_shading{objects, textures},
                       settings);
    irg::draw_transparent(
        irg::render_target{colour, depth}, {glass, mapping},
        [](const irg::triangle_batch<double>&, std::uint32_t t, irg::facing side) {
          const auto level = static_cast<std::uint8_t>(t * 67);
          return irg::solid_shader<irg::rgba8>{{level, side == irg::facing::front ? level : std::uint8_t{40}, 99, 120}};
        });
    add(h, colour);
  }
  return h.value();
}
HASHED(render_textures_and_glass, 1, 48);

}  // namespace
