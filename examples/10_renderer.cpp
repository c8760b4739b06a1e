// SPDX-License-Identifier: MIT
// 10_renderer - from vertex to pixel by the public stages: a torus as renderer.png, or the file that is named.
// previous: 09_shader, next: 11_own_method
#include <irg/colour/srgb.hpp>
#include <irg/geometry/clip_homogeneous.hpp>
#include <irg/io/image_file.hpp>
#include <irg/mesh/shapes.hpp>
#include <irg/raster/depth.hpp>
#include <irg/raster/image.hpp>
#include <irg/raster/projected_vertices.hpp>
#include <irg/raster/triangle_coverage.hpp>
#include <irg/raster/triangle_setup.hpp>
#include <irg/render/draw_triangles.hpp>
#include <irg/render/drawable.hpp>
#include <irg/scene/camera.hpp>

#include "support/step.hpp"

int main(int argc, char** argv) {
  const auto file = program::step(argc, argv, "10_renderer", "from vertex to pixel by hand", "renderer.png");
  // World: triangles with a normal at each corner. Camera: one matrix to clip space, and on to 480 x 360 pixels.
  const irg::drawable<double> torus = irg::make_drawable(irg::shape_torus<double>());
  irg::camera<double> camera;
  camera.eye = {0.9, 2.2, 2.6};
  const auto to_clip = irg::view_projection(camera, 480.0 / 360);
  const auto mapping = irg::map_to_screen<double>({480, 360});
  const auto to_lamp = irg::normalized(irg::vec<double, 3>{-1, 2, 1});
  const auto light = [&](std::uint32_t v) { return static_cast<float>(irg::dot(torus.normals[v], to_lamp)); };
  const auto tone = [](float l) { return irg::encode({0.9f * l, 0.6f * l, 0.3f * l}); };
  irg::image<irg::rgba8> picture(480, 360, {250, 249, 246, 255}), other = picture;
  irg::image<float> depth(480, 360, irg::nearer_is_greater::farthest), other_depth = depth;
  for (const auto& [v] : torus.triangles) {
    // Clip: what is left of the triangle is a convex polygon; each corner brings its light along.
    irg::clip_vertex<double, 1> corner[3];
    for (int i = 0; i < 3; ++i) corner[i] = {to_clip * torus.positions[v[i]], {irg::widened(light(v[i]))}};
    const auto polygon = irg::clip_homogeneous(corner, mapping.guard);
    for (int i = 2; i < polygon.count; ++i) {
      // Project and snap, then set up: edge functions for coverage, depth and weights.
      const int fan[3] = {0, i - 1, i};
      irg::screen_vertex on_screen[3];
      for (int k = 0; k < 3; ++k) on_screen[k] = irg::to_screen(polygon.vertices[fan[k]].position, mapping);
      const irg::covered_triangle t = irg::cover_and_set_up(on_screen[0], on_screen[1], on_screen[2]);
      if (!t.coverage.flipped) continue;  // a back face
      const auto at = [&](int k) { return static_cast<float>(polygon.vertices[fan[k]].attributes[0]); };
      irg::covered_spans(t.coverage, irg::window_of(picture), [&](const irg::span_of_cells& s) {
        for (int x = s.x_first; x < s.x_last; ++x) {
          const irg::pixel_weights<float> w = irg::weights_at(t.setup, x, s.y);
          if (w.depth <= depth(x, s.y)) continue;  // reversed depth: nearer is greater
          depth(x, s.y) = w.depth;
          picture(x, s.y) = tone(w.interpolate(at(0), at(1), at(2)));
        }
      });
    }
  }
  const auto projected = irg::project_vertices<double>(torus.positions, to_clip, mapping);
  // The same by tiles and lanes.
  const auto shader = [&](std::uint32_t i, irg::facing) {
    const auto [a, b, c] = torus.triangles[i].v;
    return [=, &light](const auto& w) { return tone(w.interpolate(light(a), light(b), light(c))); };
  };
  const auto stats =
      irg::shade_triangles({other, other_depth}, irg::projected_triangles{projected, torus.triangles, mapping}, shader);
  if (const auto saved = irg::save_image(file, picture); !saved)
    program::fail("10_renderer", saved.error().message + (": " + file));
  std::printf("shade_triangles gives %s; %s\n", picture == other ? "the same" : "another picture", file.c_str());
  return picture == other && depth == other_depth && stats.drawn > 30000 ? 0 : 1;
}
