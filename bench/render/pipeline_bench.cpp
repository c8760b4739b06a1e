// SPDX-License-Identifier: MIT
// The pipeline: a whole frame, from vertices in world coordinates to a finished picture with its depth. Clear,
// transform, cull, rasterize with depth test and Gouraud interpolation in perspective. Everybody gets the same
// vertices, colours, indices and matrix.
#include "raster/contest.hpp"
#include "render/race.hpp"

namespace {

using namespace bench;

void add_limits(std::vector<frame_contender>& all, stage& on) {
  all.push_back({"limit:clear", 1, timed(1, [&on] { clear_both(on.picture, on.depth); })});
  all.push_back({"limit:depth tests", 1, timed(1, [&on] { stream_depth_tests(on.picture, on.depth, on.exact.tested); }),
                 nullptr, "clears and tests as many pixels in tiles"});
}

int run(const scene& s) {
  if (!wanted(s.name)) return 0;
  stage on(s);
  print_statistics(on);
  std::vector<frame_contender> all;
  all.push_back(own_contender(on, "irg", 1, irg::skip_options{}));
  all.push_back(own_contender(on, "irg", 2, irg::skip_options{}));
  all.push_back(own_contender(on, "irg:no skips", 1, irg::skip_nothing));
  add_limits(all, on);
#ifdef IRG_HAVE_OSMESA
  llvmpipe_process one(s, 1), two(s, 2);
  if (one.ok() && two.ok()) {
    all.push_back(llvmpipe_contender(on, one, 1, peer_task::draw));
    all.push_back(llvmpipe_contender(on, two, 2, peer_task::draw));
    all.push_back({"limit:llvmpipe clear", 1, [&one] { return one(peer_task::clear); }, nullptr,
                   "part of llvmpipe's time: clear and copy out"});
  }
#endif
  race(all, frame_rounds());
  const int broken = publish({"render", s.name, "limit:depth tests", "1/255", 0.51}, all);
  on.draw(1);
  own::print_skips(on.stats);
  save_picture(s, "irg", on.picture.data());
#ifdef IRG_HAVE_OSMESA
  if (one.ok()) {
    one(peer_task::show_picture);
    save_picture(s, "llvmpipe", one.picture());
  }
#endif
  return broken;
}

}  // namespace

int main() {
  print_conditions();
  int broken = run(scene_a());
  broken += run(scene_a0());
  broken += run(scene_a1());
  broken += run(scene_b(drawing::random_order));
  broken += run(scene_b(drawing::front_to_back));
  broken += run(scene_c());
  broken += run(scene_frustum());
  if (broken) std::printf("irg was wrong in %d cases\n", broken);
  return broken != 0;
}
