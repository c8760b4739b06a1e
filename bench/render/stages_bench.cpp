// SPDX-License-Identifier: MIT
// Where the time of a frame goes: the stages of the pipeline one by one, on one thread, beside the counters. The stages
// are told apart from outside, by an executor that looks at the clock: each of them hands its work to the executor once.
// Within a tile colours begin when the shading is first asked for attributes.
#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <span>
#include <string>
#include <vector>

#include <irg/raster/image.hpp>
#include <irg/render/render.hpp>

#include "render/clocks.hpp"
#include "render/irg_draw.hpp"
#include "render/scenes.hpp"

namespace {

using namespace bench;

// What the clock said.
struct timeline {
  std::vector<double> laps{};  // processor time of each call of the executor
  double tiles = 0, colours = 0;  // of the last call, on the wall: all of it, and from the first attributes on
  bool in_colours = false;
  double since = 0;

  void begin_colours() {
    if (in_colours) return;
    in_colours = true;
    since = wall_seconds();
  }
};

// Runs the tasks one after the other, and notes how long all of them took.
struct clock_executor {
  timeline* times;
  template <class Task>
  void operator()(std::size_t count, Task&& task) const {
    const double start = processor_seconds();
    times->tiles = times->colours = 0;
    for (std::size_t i = 0; i < count; ++i) {
      times->in_colours = false;
      const double begin = wall_seconds();
      task(i);
      const double end = wall_seconds();
      times->tiles += end - begin;
      times->colours += end - (times->in_colours ? times->since : begin);  // nothing to draw: cleared only
    }
    times->laps.push_back(processor_seconds() - start);
  }
};

struct clock_colours : own::vertex_colours {
  timeline* times;
  const float* attributes(const irg::triangle_batch<float>& batch, std::uint32_t vertex, irg::facing side) const {
    times->begin_colours();
    return own::vertex_colours::attributes(batch, vertex, side);
  }
};

enum stage { project, cull, sort_lists, visibility, shading, whole, stage_count };
constexpr const char* names[] = {"vertices to the screen",           "cull, clip, list by tiles",
                                 "lay the lists together",           "which triangle each pixel shows",
                                 "clear and colour what is visible", "whole frame, nobody looking at the clock"};
using milliseconds = std::array<double, stage_count>;

struct measured {
  milliseconds ms{};
  irg::render_stats stats;
  bool agree = true;
};

class frame {
public:
  explicit frame(const scene& s)
      : scene_(s), mapping_(irg::map_to_screen<float>(s.width, s.height)), picture_(s.width, s.height),
        depth_(s.width, s.height) {}

  milliseconds draw(measured& out) {
    timeline times;
    draw_with(clock_colours{{scene_}, &times}, clock_executor{&times}, out);
    const double start = processor_seconds();
    draw_with(own::vertex_colours{scene_}, irg::sequential{}, out);
    const double end = processor_seconds();
    out.agree = out.agree && times.laps.size() == 4 && out.stats.pixels.shaded == out.stats.drawn;
    if (!out.agree) return {};
    const double tiles = times.laps[3], colours = tiles * times.colours / times.tiles;
    milliseconds ms{times.laps[0], times.laps[1], times.laps[2], tiles - colours, colours, end - start};
    for (double& t : ms) t *= 1e3;
    return ms;
  }

private:
  template <class Shading, class E>
  void draw_with(const Shading& shading, const E& executor, measured& out) {
    irg::project_vertices<float>(vertices_, scene_.positions, scene_.to_clip, mapping_, executor);
    const irg::triangle_batch<float> batch[1] = {{&vertices_, scene_.triangles, 0, 0}};
    const irg::draw_settings<irg::rgba8> settings{scene_.culling, {}, irg::clearing::before_drawing, {}};
    out.stats = irg::draw_batches<irg::nearer_is_greater, float>(picture_, depth_, batch, mapping_, shading, settings,
                                                                 workspace_, executor);
  }

  const scene& scene_;
  irg::screen_mapping<float> mapping_;
  irg::image<irg::rgba8> picture_;
  irg::image<float> depth_;
  irg::projected_vertices<float> vertices_{};
  irg::draw_workspace workspace_{};
};

measured measure(const scene& s) {
  frame f(s);
  measured out;
  std::array<std::vector<double>, stage_count> all;
  for (int round = smoke() ? 0 : -2; round < (smoke() ? 1 : 21); ++round) {
    const milliseconds ms = f.draw(out);
    for (std::size_t i = 0; i < stage_count && round >= 0; ++i) all[i].push_back(ms[i]);
  }
  for (std::size_t i = 0; i < stage_count; ++i) {
    std::sort(all[i].begin(), all[i].end());
    out.ms[i] = all[i][all[i].size() / 2];
  }
  return out;
}

void print_row(const char* name, std::span<const measured> all, const auto& value, const char* format) {
  std::printf("| %s |", name);
  for (const measured& m : all) std::printf(format, value(m));
  std::puts("");
}

}  // namespace

int main() {
  stay_on_this_processor();
  std::vector<scene> scenes;
  scenes.push_back(scene_a());
  scenes.push_back(scene_b(drawing::random_order));
  scenes.push_back(scene_c());
  std::vector<measured> all;
  for (const scene& s : scenes) all.push_back(measure(s));
  std::printf("Processor time of one thread, in milliseconds; %.2f programs wanted to run.\n\n| |", load());
  for (const scene& s : scenes) std::printf(" %s |", s.name.c_str());
  std::printf("\n|---|");
  for (std::size_t i = 0; i < scenes.size(); ++i) std::printf("---|");
  std::puts("");
  for (std::size_t i = 0; i < stage_count; ++i)
    print_row(names[i], all, [i](const measured& m) { return m.ms[i]; }, " %.2f |");
  const auto count = [&](const char* name, const auto& of) {
    print_row(name, all, [&](const measured& m) { return static_cast<long long>(of(m.stats)); }, " %lld |");
  };
  using stats = irg::render_stats;
  count("`triangles`", [](const stats& s) { return s.triangles; });
  count("`skipped.frustum`", [](const stats& s) { return s.skipped.frustum; });
  count("`skipped.backface`", [](const stats& s) { return s.skipped.backface; });
  count("`skipped.tiny`", [](const stats& s) { return s.skipped.tiny; });
  count("`skipped.occluded`", [](const stats& s) { return s.skipped.occluded; });
  count("`pixels.tested`", [](const stats& s) { return s.pixels.tested; });
  count("`pixels.ties`", [](const stats& s) { return s.pixels.ties; });
  count("`pixels.shaded`", [](const stats& s) { return s.pixels.shaded; });
  count("`drawn`", [](const stats& s) { return s.drawn; });
  if (std::all_of(all.begin(), all.end(), [](const measured& m) { return m.agree; })) return 0;
  std::puts("The stages do not add up: the pipeline hands out its work in other portions than this program expects.");
  return 1;
}
