// SPDX-License-Identifier: MIT
// Where the time of a frame goes: the stages of the pipeline one by one, on one thread, beside the counters. The stages
// are told apart by an executor that looks at the clock: each of them hands its work to the executor once.
#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <span>
#include <string>
#include <vector>

#include <irg/raster/image.hpp>
#include <irg/render/render.hpp>
#include <irg/render/visibility_buffer.hpp>

#include "render/clocks.hpp"
#include "render/irg_draw.hpp"
#include "render/scenes.hpp"

namespace {

using namespace bench;

// Runs the tasks one after the other, and notes how long all of them took.
struct clock_executor {
  std::vector<double>* laps;
  template <class Task>
  void operator()(std::size_t count, Task&& task) const {
    const double start = processor_seconds();
    for (std::size_t i = 0; i < count; ++i) task(i);
    laps->push_back(processor_seconds() - start);
  }
};

enum stage { project, cull, sort_lists, visibility, shading, whole, stage_count };
constexpr const char* names[] = {"vertices to the screen",           "cull, clip, list by tiles",
                                 "lay the lists together",           "which triangle each pixel shows",
                                 "clear and colour what is visible", "whole frame"};
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
        ids_(s.width, s.height), depth_(s.width, s.height) {}

  // One frame with colours, one into a visibility buffer, which is the same work but for the colours.
  milliseconds draw(measured& out) {
    std::vector<double> laps, without_colours;
    const double start = processor_seconds();
    irg::project_vertices<float>(vertices_, scene_.positions, scene_.to_clip, mapping_, clock_executor{&laps});
    const irg::triangle_batch<float> batch[1] = {{&vertices_, scene_.triangles, 0, 0}};
    const irg::draw_settings<irg::rgba8> settings{scene_.culling, {}, irg::clearing::before_drawing, {}};
    out.stats = irg::draw_batches<irg::nearer_is_greater, float>(
        picture_, depth_, batch, mapping_, own::vertex_colours{scene_}, settings, workspace_, clock_executor{&laps});
    const double end = processor_seconds();
    irg::draw_visibility<irg::nearer_is_greater, float>(ids_, depth_, batch, mapping_,
                                                        {scene_.culling, {}, irg::clearing::before_drawing}, workspace_,
                                                        clock_executor{&without_colours});
    std::int64_t seen = 0;
    for (int y = 0; y < scene_.height; ++y)
      for (int x = 0; x < scene_.width; ++x) seen += ids_(x, y) != irg::no_triangle;
    out.agree = out.agree && laps.size() == 4 && without_colours.size() == 3 && seen == out.stats.drawn;
    if (!out.agree) return {};
    milliseconds ms{laps[0], laps[1], laps[2], without_colours[2], laps[3] - without_colours[2], end - start};
    for (double& t : ms) t *= 1e3;
    return ms;
  }

private:
  const scene& scene_;
  irg::screen_mapping<float> mapping_;
  irg::image<irg::rgba8> picture_;
  irg::image<std::uint32_t> ids_;
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
