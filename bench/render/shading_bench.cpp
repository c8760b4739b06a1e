// SPDX-License-Identifier: MIT
// What a pixel costs whose colour is worked out for it alone: a ball of 18,240 triangles that fills the picture's
// height, in Phong shading with one light, and with a texture sampled between two levels of its pyramid. Whole frames of
// one thread, by pixel that is seen. Beside irg llvmpipe, with the same light and the same levels in its fragment
// shader: it keeps bytes of light, where irg writes sRGB.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include <irg/render/mip_textured_shading.hpp>
#include <irg/render/prepared_scene.hpp>
#include <irg/render/render.hpp>

#include "render/frames.hpp"

#ifdef IRG_HAVE_OSMESA
#include "support/llvmpipe.hpp"
#endif

namespace {

using namespace bench;

// A ball of radius 1 about the origin: a net of vertices, the first and the last of each row at the same place.
struct ball {
  std::vector<irg::point<double, 3>> positions{};
  std::vector<irg::textured_vertex> textured{};
  std::vector<irg::triangle_indices> triangles{};

  ball() {
    constexpr int rows = 96, columns = 2 * rows;
    for (int i = 0; i <= rows; ++i)
      for (int j = 0; j <= columns; ++j) {
        const double down = turn / 2 * i / rows, round = turn * j / columns, radius = std::sin(down);
        positions.push_back({radius * std::cos(round), std::cos(down), radius * std::sin(round)});
        const float light = 0.6f + 0.4f * static_cast<float>(std::cos(down));
        textured.push_back(irg::make_textured_vertex(8.0f * static_cast<float>(j) / columns,
                                                     4.0f * static_cast<float>(i) / rows, {light, light, light}));
      }
    const auto at = [](int i, int j) { return static_cast<std::uint32_t>(i * (columns + 1) + j); };
    for (int i = 0; i < rows; ++i)
      for (int j = 0; j < columns; ++j) {
        if (i + 1 < rows) triangles.push_back({{at(i, j), at(i + 1, j + 1), at(i + 1, j)}});
        if (i > 0) triangles.push_back({{at(i, j), at(i, j + 1), at(i + 1, j + 1)}});
      }
  }
};

// Squares of 32 texels, and noise.
irg::image<irg::rgba8> make_texture() {
  irg::image<irg::rgba8> texture(512, 512);
  std::uint32_t state = 5;
  for (int y = 0; y < 512; ++y)
    for (int x = 0; x < 512; ++x) {
      state = state * 1664525u + 1013904223u;
      texture(x, y) = {static_cast<std::uint8_t>(state >> 24), static_cast<std::uint8_t>(x / 2),
                       static_cast<std::uint8_t>((x / 32 + y / 32) % 2 * 255), 255};
    }
  return texture;
}

struct subject {
  ball body{};
  scene size = empty_scene("ball", irg::face_culling::back);
  frame_memory& to = frame_memory::of(size);
  irg::scene<double> world{};
  irg::prepared_scene<double> ready{};
  irg::image<irg::rgba8> texture = make_texture();
  irg::mip_pyramid<irg::rgb<float>> levels = irg::make_mip_pyramid(texture);
  irg::screen_mapping<double> mapping = irg::map_to_screen<double>({size.width, size.height});
  irg::mat<double, 4, 4> to_clip{};
  irg::projected_vertices<double> projected{};
  irg::draw_workspace workspace{};

  subject() {
    irg::object<double>& all = world.objects.emplace_back();
    all.shape.positions = body.positions;
    for (const auto& p : body.positions) all.shape.normals.push_back({p.x, p.y, p.z});
    for (const irg::triangle_indices& t : body.triangles) {
      for (const std::uint32_t v : t.v) all.shape.corners.push_back({v, v});
      all.shape.face_starts.push_back(static_cast<std::uint32_t>(all.shape.corners.size()));
    }
    all.surface = {{0.2, 0.2, 0.2}, {0.7, 0.5, 0.3}, {0.4, 0.4, 0.4}, 20};
    world.ambient = {0.3, 0.3, 0.3};
    world.lights = {{{-0.5, 0.7, 1, 0}, {1, 1, 1}}};
    world.view.eye = {0, 0.3, 2.2};
    world.view.target = {0, 0, 0};
    to_clip = irg::view_projection(world.view, static_cast<double>(aspect_of(size)));
    ready = irg::prepare_scene(world);
  }

  irg::render_counts draw_phong() {
    return irg::render(ready, {to.picture, to.depth},
                       {.style = irg::picture_style::phong, .colours = {.background = {}}});
  }
  irg::render_counts draw_textured() {
    irg::project_vertices<double>(body.positions, to_clip, mapping, projected);
    const irg::triangle_batch<double> batch[] = {{&projected, body.triangles}};
    const irg::textured_vertices vertices[] = {{body.textured}};
    const irg::texture_pyramid textures[] = {{&levels}};
    return irg::shade_batches<irg::nearer_is_greater, double>(
        irg::render_target{to.picture, to.depth}, {batch, mapping},
        irg::mip_textured_shading<double>{vertices, textures, mapping},
        {.culling = irg::face_culling::back, .clear = irg::clearing::before_drawing, .workspace = &workspace});
  }
};

using draw_function = irg::render_counts (subject::*)();

#ifdef IRG_HAVE_OSMESA

constexpr const char* phong_light =
    "#version 120\nvarying vec3 v, p; uniform vec3 eye, light;\n"
    "void main() {\n"
    "  vec3 n = normalize(v);\n"
    "  float cosine = dot(light, n);\n"
    "  vec3 sum = vec3(0.06);\n"
    "  if (cosine > 0.0) {\n"
    "    float mirrored = max(dot(2.0 * cosine * n - light, normalize(eye - p)), 0.0);\n"
    "    sum += cosine * vec3(0.7, 0.5, 0.3) + pow(mirrored, 20.0) * vec3(0.4);\n"
    "  }\n"
    "  gl_FragColor = vec4(sum, 1.0);\n"
    "}\n";
constexpr const char* texture_and_light =
    "#version 120\nvarying vec3 v; uniform sampler2D texels;\n"
    "void main() { gl_FragColor = vec4(texture2D(texels, v.xy).rgb * v.z, 1.0); }\n";

std::uint8_t linear_byte(std::uint8_t code) {
  return static_cast<std::uint8_t>(irg::srgb_to_linear(code) * 255 + 0.5f);
}

struct peer {
  llvmpipe draws;

  peer(const subject& s, const char* fragment) : draws(s.size.width, s.size.height, 0, fragment) {
    if (!draws.ok()) return;
    const bool textured = fragment == texture_and_light;
    std::vector<irg::point<float, 3>> positions;
    std::vector<irg::rgb<float>> numbers;
    for (std::size_t i = 0; i < s.body.positions.size(); ++i) {
      const auto& p = s.body.positions[i];
      positions.push_back({static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)});
      const irg::textured_vertex& t = s.body.textured[i];
      numbers.push_back(textured ? irg::rgb<float>{t[0], t[1], t[2]}
                                 : irg::rgb<float>{positions[i].x, positions[i].y, positions[i].z});
    }
    irg::mat<float, 4, 4> to_clip;
    for (int r = 0; r < 4; ++r)
      for (int c = 0; c < 4; ++c) to_clip(r, c) = static_cast<float>(s.to_clip(r, c));
    draws.load(positions, numbers, s.body.triangles, to_clip);
    const float length = std::sqrt(0.25f + 0.49f + 1);
    draws.set("light", {-0.5f / length, 0.7f / length, 1 / length});
    draws.set("eye", {0, 0.3f, 2.2f});
    if (!textured) return;
    irg::image<irg::rgba8> linear = s.texture;
    for (int y = 0; y < linear.height(); ++y)
      for (int x = 0; x < linear.width(); ++x) {
        irg::rgba8& t = linear(x, y);
        t = {linear_byte(t.r), linear_byte(t.g), linear_byte(t.b), 255};
      }
    draws.load_texture(linear);
  }
};

void enter_peer(const contest& c, lazy<std::unique_ptr<subject>>& all, draw_function draw, const char* fragment) {
  auto& with = keep_lazy([&all, fragment] { return std::make_unique<peer>(**all, fragment); });
  contender who{"llvmpipe", {}};
  who.note = "transforms by itself; bytes of light, not of sRGB";
  who.seconds = [&with, time = timed(1, [&with] { (*with)->draws.draw(true, {}); })] {
    return (*with)->draws.ok() && (*with)->draws.make_current() ? time() : not_said;
  };
  // How far its light is from irg's: that it does the like.
  who.judge = [&all, &with, draw] {
    subject& s = **all;
    (s.*draw)();
    errors e{0, 0, not_said, "difference from irg's picture"};
    for (std::size_t i = 0; i < s.size.pixel_count(); ++i) {
      const irg::rgba8 own = s.to.picture.data()[i], other = (*with)->draws.picture().data()[i];
      const auto channel = [&](std::uint8_t a, std::uint8_t b) {
        const double away = std::abs(static_cast<double>(irg::srgb_to_linear(a)) * 255 - b);
        e.max = std::max(e.max, away);
        e.mean += away / (3 * static_cast<double>(s.size.pixel_count()));
      };
      channel(own.r, other.r), channel(own.g, other.g), channel(own.b, other.b);
    }
    return e;
  };
  enter(c, who);
}

#endif

void enter_case(lazy<std::unique_ptr<subject>>& all, const char* name, draw_function draw,
                [[maybe_unused]] const char* fragment) {
  const contest c{"shading", name, "pixel", ((**all).*draw)().pixels.shaded, "1/255"};
  contender who{"irg", {}};
  who.seconds = timed(1, [&all, draw] { ((**all).*draw)(); });
  enter(c, who);
#ifdef IRG_HAVE_OSMESA
  enter_peer(c, all, draw, fragment);
#endif
}

}  // namespace

int main(int argc, char** argv) {
  auto& all = keep_lazy([] { return std::make_unique<subject>(); });
#ifndef IRG_HAVE_OSMESA
  constexpr const char *phong_light = "", *texture_and_light = "";
#endif
  enter_case(all, "Phong and one light", &subject::draw_phong, phong_light);
  enter_case(all, "texture between two levels", &subject::draw_textured, texture_and_light);
  return run_benchmarks(argc, argv);
}
