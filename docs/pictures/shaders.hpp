// SPDX-License-Identifier: MIT
// Pictures of textures, shaders of one's own, transparent faces and the range of light. Included by pictures.cpp.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <irg/math/trigonometry.hpp>
#include <irg/render/draw_transparent.hpp>
#include <irg/render/mip_textured_shading.hpp>
#include <irg/render/textured_shading.hpp>
#include <irg/scene/camera.hpp>
#include <irg/shade/mip_pyramid.hpp>
#include <irg/view/projection.hpp>

#include "enlarged.hpp"

namespace shaders {

using namespace enlarging;
using batch = irg::triangle_batch<double>;
using point3 = irg::point<double, 3>;

// Points over two parameters from 0 to 1, as triangles.
struct patch {
  std::vector<point3> positions;
  std::vector<std::array<float, 2>> parameters;
  std::vector<irg::triangle_indices> triangles;
};

template <class Place>
patch make_patch(int columns, int rows, const Place& place) {
  patch p;
  for (int i = 0; i <= columns; ++i)
    for (int k = 0; k <= rows; ++k) {
      const double s = 1.0 * i / columns, t = 1.0 * k / rows;
      p.positions.push_back(place(s, t));
      p.parameters.push_back({static_cast<float>(s), static_cast<float>(t)});
      const auto v = static_cast<std::uint32_t>(i * (rows + 1) + k), next = v + static_cast<std::uint32_t>(rows + 1);
      if (i == columns || k == rows) continue;
      p.triangles.push_back({{v, v + 1, next}});
      p.triangles.push_back({{v + 1, next + 1, next}});
    }
  return p;
}

inline irg::vec<double, 3> torus_normal(double s, double t) {
  const double a = s * 2 * irg::pi<double>, b = t * 2 * irg::pi<double>;
  return {irg::cos(a) * irg::cos(b), irg::sin(b), irg::sin(a) * irg::cos(b)};
}
inline point3 torus_point(double s, double t) {
  const double a = s * 2 * irg::pi<double>;
  return point3{irg::cos(a), 0, irg::sin(a)} + torus_normal(s, t) * 0.45;
}

struct chequers {
  static constexpr int attribute_count = 3;
  const std::vector<std::array<float, 3>>& vertices;
  const float* attributes(const batch&, std::uint32_t vertex, irg::facing) const { return vertices[vertex].data(); }
  irg::rgba8 pixel(const std::array<float, 3>& at) const {
    const bool dark = (static_cast<int>(at[0] * 24) + static_cast<int>(at[1] * 8)) % 2 != 0;
    const float light = irg::clamped(at[2], 0.05f, 1.0f);
    return dark ? irg::encode({0.05f * light, 0.1f * light, 0.25f * light})
                : irg::encode({0.9f * light, 0.8f * light, 0.6f * light});
  }
};

// A batch's vertices on a picture.
inline irg::projected_vertices<double> seen_from(const patch& p, point3 eye, point3 target, const picture& onto) {
  irg::camera<double> camera;
  camera.eye = eye;
  camera.target = target;
  camera.near_distance = 0.05;
  const double aspect = 1.0 * onto.width() / onto.height();
  return irg::project_vertices<double>(p.positions, irg::view_projection(camera, aspect),
                                       irg::map_to_screen<double>({onto.width(), onto.height()}));
}

inline picture torus() {
  picture p(480, 330, paper);
  irg::image<float> depth(480, 330, 0.0f);
  const patch t = make_patch(96, 32, torus_point);
  std::vector<std::array<float, 3>> vertices;
  for (const auto& [s, u] : t.parameters) {
    const irg::vec<double, 3> n = torus_normal(static_cast<double>(s), static_cast<double>(u));
    vertices.push_back({s, u, static_cast<float>(0.15 + 0.85 * (0.3 * n.x + 0.8 * n.y + 0.5 * n.z))});
  }
  const auto projected = seen_from(t, {0, 2.5, 3.2}, {0, -0.1, 0}, p);
  const batch one[1] = {{&projected, t.triangles}};
  irg::shade_batches({p, depth}, {one, irg::map_to_screen<double>({480, 330})}, chequers{vertices});
  return p;
}

// An arrow in a corner of 8 x 8 texels: which way it runs is seen in every copy.
inline picture arrow() {
  const char* const rows[8] = {"........", ".####...", ".##.....", ".#.#....",
                               ".#..#...", ".....#..", "......o.", "........"};
  picture t(8, 8, {236, 214, 160, 255});
  for (int y = 0; y < 8; ++y)
    for (int x = 0; x < 8; ++x)
      if (rows[y][x] != '.') t(x, y) = rows[y][x] == '#' ? irg::rgba8{48, 90, 140, 255} : irg::rgba8{204, 96, 72, 255};
  return t;
}

// Above nearest, below bilinear; repeat, mirrored, clamp, border from the left; -1/2 to 3/2 in both directions.
inline picture wraps() {
  constexpr int size = 150, gap = 12;
  picture p(4 * size + 3 * gap, 2 * size + gap, {255, 255, 255, 255});
  const picture t = arrow();
  const irg::texture_wrap kinds[] = {irg::texture_wrap::repeat, irg::texture_wrap::mirrored, irg::texture_wrap::clamp,
                                     irg::texture_wrap::border};
  for (int row = 0; row < 2; ++row)
    for (int k = 0; k < 4; ++k)
      for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) {
          const float u = (static_cast<float>(x) + 0.5f) / size * 2 - 0.5f,
                      v = (static_cast<float>(y) + 0.5f) / size * 2 - 0.5f;
          const irg::texture_sampler s{row == 0 ? irg::texture_filter::nearest : irg::texture_filter::bilinear,
                                       kinds[k], kinds[k]};
          p(k * (size + gap) + x, row * (size + gap) + y) =
              irg::encode(irg::sample_texture(t, u, v, s, {0.5f, 0.5f, 0.5f}));
        }
  return p;
}

// A chequered floor to the horizon: nearest, bilinear, and between the levels of a pyramid.
inline picture floors() {
  constexpr int width = 200, height = 150, gap = 12;
  picture p(3 * width + 2 * gap, height, {255, 255, 255, 255});
  picture t(32, 32, {232, 224, 204, 255});
  for (int y = 0; y < 32; ++y)
    for (int x = 0; x < 32; ++x)
      if ((x / 16 + y / 16) % 2 != 0) t(x, y) = {48, 90, 140, 255};
  const auto pyramid = irg::make_mip_pyramid(t);
  for (int k = 0; k < 3; ++k)
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) {
        // The place on the floor, 1 below the eye, that is seen at (x, y) of a picture 90 degrees wide.
        const auto u = [&](float px, float py) { return (px - width / 2.0f) / (py + 12); };
        const auto v = [&](float py) { return -100.0f / (py + 12); };
        const float px = static_cast<float>(x) + 0.5f, py = static_cast<float>(y) + 0.5f;
        const irg::texture_derivatives d{u(px + 1, py) - u(px, py), 0, u(px, py + 1) - u(px, py), v(py + 1) - v(py)};
        const irg::texture_sampler s{k == 0 ? irg::texture_filter::nearest : irg::texture_filter::bilinear};
        p(k * (width + gap) + x, y) =
            irg::encode(k < 2 ? irg::sample_texture(t, u(px, py), v(py), s)
                              : irg::sample_mip_pyramid(pyramid, {u(px, py), v(py), irg::mip_level(d, {32, 32})}, s));
      }
  return p;
}

// The torus, its colours from a texture.
inline picture textured_torus() {
  picture p(480, 330, paper);
  irg::image<float> depth(480, 330, 0.0f);
  const patch t = make_patch(96, 32, torus_point);
  std::vector<irg::textured_vertex> vertices;
  for (const auto& [s, u] : t.parameters) {
    const irg::vec<double, 3> n = torus_normal(static_cast<double>(s), static_cast<double>(u));
    const auto light = static_cast<float>(irg::maximum(0.15 + 0.85 * (0.3 * n.x + 0.8 * n.y + 0.5 * n.z), 0.08));
    vertices.push_back(irg::make_textured_vertex(s * 12, u * 4, {light, light, light}));
  }
  const picture texels = arrow();
  const irg::textured_vertices objects[1] = {{vertices}};
  const irg::texture_image textures[1] = {{texels.view(), {}}};
  const auto projected = seen_from(t, {0, 2.5, 3.2}, {0, -0.1, 0}, p);
  const batch one[1] = {{&projected, t.triangles}};
  irg::shade_batches({p, depth}, {one, irg::map_to_screen<double>({480, 330})},
                     irg::textured_shading{objects, textures});
  return p;
}

// A chequered floor and a wall along it, drawn with the texture at its full size and with its pyramid.
inline picture mip_floors() {
  constexpr int width = 300, height = 220, gap = 12;
  picture t(32, 32, {232, 224, 204, 255}), both(2 * width + gap, height, {255, 255, 255, 255});
  for (int y = 0; y < 32; ++y)
    for (int x = 0; x < 32; ++x)
      if ((x / 16 + y / 16) % 2 != 0) t(x, y) = {48, 90, 140, 255};
  const auto levels = irg::make_mip_pyramid(t);
  patch room;
  room.positions = {{-300, 0, 2}, {300, 0, 2},   {300, 0, -600},  {-300, 0, -600},
                    {-2, 0, 2},   {-2, 0, -600}, {-2, 1.6, -600}, {-2, 1.6, 2}};
  room.triangles = {{{0, 1, 2}}, {{0, 2, 3}}, {{4, 5, 6}}, {{4, 6, 7}}};
  std::vector<irg::textured_vertex> vertices;
  for (std::size_t i = 0; i < 8; ++i) {
    const auto& q = room.positions[i];
    vertices.push_back(
        irg::make_textured_vertex(static_cast<float>(i < 4 ? q.x : q.z), static_cast<float>(i < 4 ? q.z : q.y),
                                  i < 4 ? irg::rgb<float>{1, 1, 1} : irg::rgb<float>{0.75f, 0.7f, 0.7f}));
  }
  const irg::textured_vertices objects[1] = {{vertices}};
  const irg::texture_image textures[1] = {{t.view(), {}}};
  const irg::texture_pyramid pyramids[1] = {{&levels}};
  const auto mapping = irg::map_to_screen<double>({width, height});
  for (int k = 0; k < 2; ++k) {
    picture p(width, height, paper);
    irg::image<float> depth(width, height, 0.0f);
    const auto projected = seen_from(room, {0, 1, 1.8}, {-0.4, 0.7, -1}, p);
    const batch one[1] = {{&projected, room.triangles}};
    if (k == 0)
      irg::shade_batches({p, depth}, {one, mapping}, irg::textured_shading{objects, textures});
    else
      irg::shade_batches({p, depth}, {one, mapping}, irg::mip_textured_shading<double>{objects, pyramids, mapping});
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) both(k * (width + gap) + x, y) = p(x, y);
  }
  return both;
}

// Three coloured panes through the torus.
inline picture panes() {
  picture p = torus();
  irg::image<float> depth(480, 330, 0.0f);
  const patch t = make_patch(96, 32, torus_point);
  const auto mapping = irg::map_to_screen<double>({480, 330});
  const auto projected = seen_from(t, {0, 2.5, 3.2}, {0, -0.1, 0}, p);
  const batch opaque[1] = {{&projected, t.triangles}};
  irg::image<std::uint8_t> unused(480, 330);
  irg::shade_batches(irg::render_target{unused, depth}, {opaque, mapping},
                     [](const batch&, std::uint32_t, irg::facing) { return irg::solid_shader<std::uint8_t>{1}; });

  const irg::rgba8 glass[3] = {{204, 60, 40, 150}, {60, 160, 60, 130}, {40, 80, 200, 150}};
  std::vector<patch> pieces;
  std::vector<irg::projected_vertices<double>> vertices(3);
  std::vector<batch> batches;
  for (int k = 0; k < 3; ++k) {
    const double x = -0.9 + 0.55 * k, z = 0.9 - 0.7 * k;
    pieces.push_back(make_patch(6, 6, [&](double s, double u) { return point3{x + s, 1.1 - 1.7 * u, z}; }));
  }
  std::uint32_t number = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    vertices[k] = seen_from(pieces[k], {0, 2.5, 3.2}, {0, -0.1, 0}, p);
    batches.push_back({&vertices[k], pieces[k].triangles, number, static_cast<std::uint32_t>(k)});
    number += static_cast<std::uint32_t>(pieces[k].triangles.size());
  }
  irg::draw_transparent({p, depth}, {batches, mapping}, [&](const batch& b, std::uint32_t, irg::facing) {
    return irg::solid_shader<irg::rgba8>{glass[b.object]};
  });
  return p;
}

}  // namespace shaders
