// SPDX-License-Identifier: MIT
// The scene of docs/hidden/one_scene.md by every method: time, pixels that do not show the nearest face, what was
// tested, memory asked for, and blocks of it that could hold a depth for every pixel.
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include <irg/hidden/bsp_faces.hpp>
#include <irg/hidden/bsp_scene.hpp>
#include <irg/hidden/painter.hpp>
#include <irg/hidden/painter_newell.hpp>
#include <irg/hidden/ray_casting.hpp>
#include <irg/hidden/warnock.hpp>

#include "../tests/hidden/large_blocks.cpp"
#include "../tests/hidden/one_scene.hpp"
#include "support/measure.hpp"

namespace {

using namespace bench;
using id_image = irg::image<std::uint32_t>;

struct everything {
  one_scene::bodies bodies = one_scene::make();
  std::vector<irg::screen_face> faces = one_scene::faces_of(bodies);
  irg::bsp_tree_3d<double> tree{bodies.corners, bodies.triangles};
  id_image exact{one_scene::width, one_scene::height, irg::no_index}, drawn = exact;
  irg::draw_counts counts{};
  std::size_t depth_buffers = 0, bytes = 0;

  everything() { irg::ray_casting<>{}(faces, window(), exact, counts); }
  static irg::cell_window window() { return {0, 0, one_scene::width, one_scene::height}; }
};

// The z-buffer as textbooks have it, on the same faces.
struct plain_zbuffer {
  void operator()(const std::vector<irg::screen_face>& faces, const irg::cell_window& w, id_image& ids,
                  irg::draw_counts& counts) const {
    irg::image<float> nearest(w.x_last, w.y_last, 0.0f);
    for (const irg::screen_face& f : faces) {
      const irg::triangle_setup setup = irg::set_up_face(f);
      irg::covered_spans(f.coverage, w, [&](const irg::span_of_cells& s) {
        for (int x = s.x_first; x < s.x_last; ++x, ++counts.tested)
          if (const float z = irg::depth_at(setup, x, s.y); nearest(x, s.y) < z)
            nearest(x, s.y) = z, ids(x, s.y) = f.number;
      });
    }
  }
};

template <class Make>
void add(const std::string& who, lazy<everything>& all, const Make& make) {
  const contest what{"one scene", "ball, ring, cube, sheets, rods", "picture"};
  contender c{who, [&all, make] {
                everything& e = *all;
                e.drawn = id_image(one_scene::width, one_scene::height, irg::no_index);
                e.counts = {};
                test::large_block = std::size_t{4} * one_scene::width * one_scene::height;
                test::large_blocks = test::bytes_asked_for = 0;
                make(e)(e.faces, everything::window(), e.drawn, e.counts);
                e.depth_buffers = test::large_blocks;
                e.bytes = test::bytes_asked_for;
                test::large_block = ~std::size_t{0};
              }};
  c.judge = [&all] {
    const everything& e = *all;
    errors r;
    r.wrong = 0;
    for (int y = 0; y < one_scene::height; ++y)
      for (int x = 0; x < one_scene::width; ++x) r.wrong += e.drawn(x, y) != e.exact(x, y);
    r.more = {{"tested", static_cast<double>(e.counts.tested)},
              {"kilobytes", static_cast<double>(e.bytes) / 1024},
              {"blocks", static_cast<double>(e.depth_buffers)}};
    return r;
  };
  enter(what, std::move(c));
}

}  // namespace

int main(int argc, char** argv) {
  auto& all = keep_lazy([] { return everything(); });
  add("zbuffer", all, [](const everything&) { return plain_zbuffer{}; });
  add("ray casting", all, [](const everything&) { return irg::ray_casting<>{}; });
  add("warnock", all, [](const everything&) { return irg::warnock<>{}; });
  add("painter newell", all, [](const everything&) { return irg::painter_newell<>{}; });
  add("painter by centroid", all, [](const everything&) { return irg::painter_by_centroid_rounded<>{}; });
  add("bsp of faces", all, [](const everything&) { return irg::bsp_painter<>{}; });
  add("bsp of the scene", all, [](const everything& e) {
    return irg::bsp_scene_painter<double>(e.tree, one_scene::eye, one_scene::to_clip(), one_scene::mapping());
  });
  return run_benchmarks(argc, argv);
}
