// SPDX-License-Identifier: MIT
// The pipeline: a whole frame, from vertices in world coordinates to a finished picture with its depth. Clear,
// transform, cull, rasterize with depth test and Gouraud interpolation in perspective. Everybody gets the same
// vertices, colours, indices and matrix.
#include "render/frames.hpp"

namespace {

using namespace bench;

void enter_scene(const scene_plan& plan) {
  const frame_contest c{"render", plan.name, "limit:depth tests", "1/255", 0.51};
  const stage_access on = stage_of(plan);
  enter_own(c, on, "irg", 1);
  enter_own(c, on, "irg", 2);
  enter_own(c, on, "irg:no skips", 1, irg::skip_nothing);
  enter_limit(
      c, "limit:clear", [on] { clear_both(on().to.picture, on().to.depth); }, [on] { return on().statistics(); });
  enter_limit(
      c, "limit:depth tests", [on] { stream_depth_tests(on().to.picture, on().to.depth, on().exact->tested); },
      [] { return "clears and tests as many pixels in tiles"; });
  enter_llvmpipe(c, on, 1, drawn::colours);
  enter_llvmpipe(c, on, 2, drawn::colours);
}

}  // namespace

int main(int argc, char** argv) {
  for (const scene_plan& plan : {scene_a(), scene_a0(), scene_a1(), scene_b(drawing::random_order),
                                 scene_b(drawing::front_to_back), scene_c(), scene_frustum()})
    enter_scene(plan);
  return run_benchmarks(argc, argv);
}
