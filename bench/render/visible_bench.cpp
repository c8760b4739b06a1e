// SPDX-License-Identifier: MIT
// What it costs not to see something: a hundred bodies of which 100, 50, 10, 1 or 0 % are visible, the others behind a
// wall that is drawn first, or outside of the picture. What is seen, drawn alone, says how much is for the wall.
#include <algorithm>

#include "render/frames.hpp"

namespace {

using namespace bench;

// The objects that show a pixel, alone: what is left to do where the others cost nothing.
scene seen_alone(stage& on) {
  const scene& s = on.what;
  on.renderer.draw_ids(on.to.ids, on.to.depth);
  std::vector<bool> seen(s.triangles.size(), false);
  for (std::size_t i = 0; i < s.pixel_count(); ++i)
    if (on.to.ids.data()[i] != 0) seen[on.to.ids.data()[i] - 1] = true;
  scene alone = empty_scene(s.name + " seen alone", s.culling);
  alone.to_clip = s.to_clip;
  for (scene_object o : s.objects) {
    const auto first = seen.begin() + o.first_triangle;
    if (std::find(first, first + o.triangles, true) == first + o.triangles) continue;
    const auto vertex = static_cast<std::uint32_t>(alone.positions.size()) - o.first_vertex;  // wraps round, and back
    for (std::uint32_t i = o.first_triangle; i < o.first_triangle + o.triangles; ++i) {
      const auto [a, b, c] = s.triangles[i].v;
      alone.triangles.push_back({{a + vertex, b + vertex, c + vertex}});
    }
    for (std::uint32_t i = o.first_vertex; i < o.first_vertex + o.vertices; ++i) {
      alone.positions.push_back(s.positions[i]);
      alone.normals.push_back(s.normals[i]);
      alone.colours.push_back(s.colours[i]);
    }
    o.first_vertex += vertex;
    o.first_triangle = static_cast<std::uint32_t>(alone.triangles.size()) - o.triangles;
    alone.objects.push_back(o);
  }
  return alone;
}

struct seen {
  scene alone;
  own::renderer renderer;
  explicit seen(stage& on) : alone(seen_alone(on)), renderer(alone) {}
};

void enter_scene(const scene_plan& plan) {
  const frame_contest c{"visible", plan.name, "limit:clear", "1/255", 0.51};
  const stage_access on = stage_of(plan);
  auto& alone = keep_lazy([on] { return std::make_unique<seen>(on()); });
  enter_own(c, on, "irg", 1);
  enter_own(c, on, "irg:no skips", 1, irg::skip_nothing);
  enter_limit(c, "limit:seen alone", [on, &alone] { (*alone)->renderer.draw(on().to.picture, on().to.depth, {}, 1); });
  enter_limit(
      c, "limit:clear", [on] { clear_both(on().to.picture, on().to.depth); }, [on] { return on().statistics(); });
  enter_llvmpipe(c, on, 1, drawn::colours);
}

}  // namespace

int main(int argc, char** argv) {
  for (const hidden_by what : {hidden_by::wall, hidden_by::picture_border})
    for (const int percent : {100, 50, 10, 1, 0}) enter_scene(scene_visible(percent, what));
  return run_benchmarks(argc, argv);
}
