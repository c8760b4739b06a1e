// SPDX-License-Identifier: MIT
// What it costs not to see something: a hundred bodies of which 100, 50, 10, 1 or 0 % are visible, the others behind a
// wall that is drawn first, or outside of the picture. What is seen, drawn alone, says how much is for the wall.
#include <algorithm>

#include "raster/contest.hpp"
#include "render/race.hpp"

namespace {

using namespace bench;

// Milliseconds at each share, to be compared with those at 100 %.
struct series {
  std::string name;
  std::vector<double> milliseconds{};
};

// The objects that show a pixel, alone: what is left to do where the others cost nothing.
scene seen_alone(stage& on) {
  const scene& s = on.what;
  on.renderer.draw_ids(on.ids, on.depth);
  std::vector<bool> seen(s.triangles.size(), false);
  for (std::size_t i = 0; i < s.pixel_count(); ++i)
    if (on.ids.data()[i] != 0) seen[on.ids.data()[i] - 1] = true;
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

int run(const scene& s, std::vector<series>& times) {
  stage on(s);
  print_statistics(on);
  const scene alone = seen_alone(on);
  own::renderer draw_alone(alone);
  std::vector<frame_contender> all{own_contender(on, "irg", 1, irg::skip_options{}),
                                   own_contender(on, "irg:no skips", 1, irg::skip_nothing)};
  all.push_back({"limit:seen alone", 1, timed(1, [&] { draw_alone.draw(on.picture, on.depth); })});
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
  std::printf("\n%-24s", "irg for what is hidden");
  for (std::size_t i = 0; i < std::size(shares); ++i) {
    const double ms = times[0].milliseconds[i] - times[2].milliseconds[i];
    std::printf(" %9.3f %5.1f %%", ms, 100 * ms / times[0].milliseconds[0]);
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
