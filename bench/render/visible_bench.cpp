// SPDX-License-Identifier: MIT
// What it costs not to see something: a hundred bodies of which 100, 50, 10, 1 or 0 % are visible, the others behind a
// wall that is drawn first, or outside of the picture.
#include "raster/contest.hpp"
#include "render/race.hpp"

namespace {

using namespace bench;

// Milliseconds at each share, to be compared with those at 100 %.
struct series {
  std::string name;
  std::vector<double> milliseconds{};
};

int run(const scene& s, std::vector<series>& times) {
  stage on(s);
  print_statistics(on);
  std::vector<frame_contender> all{own_contender(on, "irg", 1, irg::skip_options{}),
                                   own_contender(on, "irg:no skips", 1, irg::skip_nothing)};
  all.push_back({"limit:clear", 1, timed(1, [&on] { clear_both(on.picture, on.depth); })});
#ifdef IRG_HAVE_OSMESA
  llvmpipe_process one(s, 1);
  if (one.ok()) {
    all.push_back(llvmpipe_contender(on, one, 1, peer_task::draw));
    all.push_back({"limit:llvmpipe clear", 1, [&one] { return one(peer_task::clear); }, nullptr,
                   "part of llvmpipe's time: clear and copy out"});
  }
#endif
  race(all, frame_rounds());
  const int broken = publish({"visible", s.name, "limit:clear", "1/255", 0.51}, all);
  on.draw(1);
  own::print_skips(on.stats);
  save_picture(s, "irg", on.picture.data());
  times.resize(all.size());
  for (std::size_t i = 0; i < all.size(); ++i) {
    times[i].name = all[i].name;
    times[i].milliseconds.push_back(all[i].median() * 1e3);
  }
  return broken;
}

int run_all(hidden_by what) {
  constexpr int shares[] = {100, 50, 10, 1, 0};
  std::vector<series> times;
  int broken = 0;
  for (const int percent : shares) broken += run(scene_visible(percent, what), times);
  std::printf("\nHidden by %s: ms at each visible share, and %% of the time at 100 %%\n%-24s",
              what == hidden_by::wall ? "a wall" : "the picture's border", "");
  for (const int percent : shares) std::printf(" %15d %%", percent);
  for (const series& of : times) {
    std::printf("\n%-24s", of.name.c_str());
    for (const double ms : of.milliseconds) std::printf(" %9.3f %5.1f %%", ms, 100 * ms / of.milliseconds[0]);
  }
  std::puts("");
  return broken;
}

}  // namespace

int main() {
  print_conditions();
  const int broken = run_all(hidden_by::wall) + run_all(hidden_by::picture_border);
  if (broken) std::printf("irg was wrong in %d cases\n", broken);
  return broken != 0;
}
