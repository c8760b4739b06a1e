// SPDX-License-Identifier: MIT
// Depth without colour, as for shadows and occlusion: clear, transform, cull, rasterize, depth test. Coverage is exact;
// the errors are those of the depths. A mask's are not nearer than they should be, and may be a little farther.
#include "raster/contest.hpp"
#include "render/race.hpp"

namespace {

using namespace bench;

frame_contender own_depth(stage& on, int threads) {
  frame_contender c{"irg", threads};
  c.draw = timed(threads, [&on, threads] { on.draw_depth(threads); });
  c.judge = [&on, draw = c.draw] {
    draw();
    return judge_depth(on.what, on.exact, on.depth.data());
  };
  return c;
}

// Slivers are as far as their farthest vertex.
constexpr double mask_error = 0x1p12;

frame_contender own_mask(stage& on, irg::occlusion_mask<>& mask, int threads) {
  frame_contender c{"irg:occlusion_mask", threads};
  c.draw = timed(threads, [&on, &mask, threads] {
    if (threads == 1)
      on.renderer.draw_mask(mask);
    else
      on.renderer.draw_mask(mask, irg::parallel{threads});
  });
  c.allowed = mask_error;
  c.judge = [&on, &mask, draw = c.draw] {
    draw();
    on.renderer.draw_depth(on.depth);
    std::int64_t nearer = 0;
    for (int y = 0; y < on.what.height; ++y)
      for (int x = 0; x < on.what.width; ++x) {
        const float there = mask.depth(x, y);
        nearer += there > on.depth(x, y);
        on.depth(x, y) = there;
      }
    verdict v = judge_depth(on.what, on.exact, on.depth.data());
    v.wrong += nearer;
    return v;
  };
  c.note = "wrong counts pixels that are nearer than drawn, too";
  return c;
}

int run(const scene& s) {
  if (!wanted(s.name)) return 0;
  stage on(s);
  print_statistics(on);
  irg::occlusion_mask<> mask(s.width, s.height);
  std::vector<frame_contender> all{own_mask(on, mask, 1), own_mask(on, mask, 2), own_depth(on, 1), own_depth(on, 2)};
  all.push_back({"limit:clear", 1, timed(1, [&on] {
                   std::memset(on.depth.data(), 0, 4 * on.what.pixel_count());
                   asm volatile("" : : "r"(on.depth.data()) : "memory");
                 })});
#ifdef IRG_HAVE_OSMESA
  llvmpipe_process one(s, 1), two(s, 2);
  if (one.ok() && two.ok()) {
    all.push_back(llvmpipe_contender(on, one, 1, peer_task::draw_depth));
    all.push_back(llvmpipe_contender(on, two, 2, peer_task::draw_depth));
  }
#endif
  race(all, frame_rounds());
  return publish({"depth", s.name, "limit:clear", "2^-24", 4}, all);
}

}  // namespace

int main() {
  print_conditions();
  int broken = run(scene_a0());
  broken += run(scene_a());
  broken += run(scene_b(drawing::random_order));
  broken += run(scene_c());
  if (broken) std::printf("irg was wrong in %d cases\n", broken);
  return broken != 0;
}
