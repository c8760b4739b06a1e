// SPDX-License-Identifier: MIT
// 11_own_method - a hidden-surface method of one's own in the renderer: own_method.png, or the file that is named.
// previous: 10_renderer, next: 12_depth_sort
#include <irg/io/image_file.hpp>
#include <irg/mesh/teapot.hpp>
#include <irg/render/render.hpp>

#include "support/step.hpp"

// Faces and a window in, ids out: at each pixel the nearest of the faces that cover its centre, of equals the first.
struct look_at_all {
  void operator()(const auto& faces, const irg::cell_window& window, irg::image<std::uint32_t>& ids,
                  irg::draw_counts& counts) const {
    irg::image<float> nearest(window.x_last, window.y_last, irg::nearer_is_greater::farthest);
    for (std::size_t i = 0; i < faces.size(); ++i) {
      const irg::screen_face face = faces[i];
      const irg::triangle_setup setup = irg::set_up_face(face);
      irg::covered_spans(face.coverage, window, [&](const irg::span_of_cells& s) {
        for (int x = s.x_first; x < s.x_last; ++x, ++counts.tested)
          if (const float z = irg::depth_at(setup, x, s.y); nearest(x, s.y) < z)
            nearest(x, s.y) = z, ids(x, s.y) = face.number;
      });
    }
  }
};

int main(int argc, char** argv) {
  const auto file = program::step(argc, argv, "11_own_method", "a method of one's own", "own_method.png");
  irg::scene<double> scene;
  scene.objects.push_back({irg::shape_teapot<double>()});
  scene.lights = {{{-0.4, 1.0, 0.7, 0.0}, {1.0, 1.0, 1.0}}};
  scene.view.eye = {3, 3, 7};
  irg::image<irg::rgba8> own(640, 480), zbuffer(640, 480);
  irg::image<float> depth(640, 480);
  irg::render(scene, {zbuffer, depth});
  const auto stats = irg::render_with(look_at_all{}, scene, {own, depth});
  if (const auto saved = irg::save_image(file, own); !saved)
    program::fail("11_own_method", saved.error().message + (": " + file));
  std::printf("the z-buffer gives %s; %s\n", own == zbuffer ? "the same" : "another picture", file.c_str());
  return own == zbuffer && stats.drawn > 10000 ? 0 : 1;
}
