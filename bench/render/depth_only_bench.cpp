// SPDX-License-Identifier: MIT
// Depth without colour, as for shadows and occlusion: clear, transform, cull, rasterize, depth test. Coverage is exact;
// the errors are those of the depths.
#include "render/frames.hpp"

namespace {

using namespace bench;

void enter_depth(const frame_contest& c, const stage_access& on, int threads) {
  contender who{"irg", {}};
  who.seconds = timed(threads, [on, threads] { on().renderer.draw_depth(on().to.depth, threads); });
  c.enter_judged(threads, who, [on, draw = who.seconds] {
    draw();
    return judge_depth(on().what, *on().exact, on().to.depth.data());
  });
}

// Drawn into an empty mask, with the farthest depths of blocks and tiles.
void enter_mask(const frame_contest& c, const stage_access& on, int threads) {
  auto& mask = keep_lazy([on] { return irg::occlusion_mask<>(on().what.width, on().what.height); });
  contender who{"irg:occlusion_mask", {}};
  who.seconds = timed(threads, [on, &mask, threads] { on().renderer.draw_mask(*mask, threads); });
  c.enter_judged(threads, who, [on, &mask, draw = who.seconds] {
    draw();
    irg::image<float>& depth = on().to.depth;
    for (int y = 0; y < depth.height(); ++y)
      for (int x = 0; x < depth.width(); ++x) depth(x, y) = mask->depth(x, y);
    return judge_depth(on().what, *on().exact, depth.data());
  });
}

void enter_scene(const scene_plan& plan) {
  const frame_contest c{"depth", plan.name, "limit:clear", "2^-24", 4};
  const stage_access on = stage_of(plan);
  for (const int threads : {1, 2}) {
    enter_mask(c, on, threads);
    enter_depth(c, on, threads);
    enter_llvmpipe(c, on, threads, drawn::depths);
  }
  const auto clear = [on] {
    std::memset(on().to.depth.data(), 0, 4 * on().what.pixel_count());
    asm volatile("" : : "r"(on().to.depth.data()) : "memory");
  };
  enter_limit(c, "limit:clear", clear, [on] { return on().statistics(); });
}

}  // namespace

int main(int argc, char** argv) {
  for (const scene_plan& plan : {scene_a0(), scene_a(), scene_b(drawing::random_order), scene_c()}) enter_scene(plan);
  return run_benchmarks(argc, argv);
}
