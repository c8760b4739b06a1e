// SPDX-License-Identifier: MIT
// Where the time of a frame goes: the stages of the pipeline one by one, on one thread, beside the counters. The stages
// are told apart from outside, by an executor that looks at the clock: each of them hands its work to the executor once.
// Within a tile colours begin when the shading is first asked for attributes.
#include <array>
#include <cstdint>
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

enum stage_of_frame { project, cull, sort_lists, visibility, shading, whole, stage_count };
constexpr const char* names[] = {"irg:vertices to the screen",
                                 "irg:cull and clip and bin by tiles",
                                 "irg:fill the bins",
                                 "irg:which triangle each pixel shows",
                                 "irg:clear and colour what is visible",
                                 "irg"};  // a whole frame without a clock in it
using seconds_of_stages = std::array<double, stage_count>;

struct measured {
  irg::render_counts stats{};
  bool agree = true;
};

class frame {
public:
  explicit frame(const scene& s)
      : scene_(s), mapping_(irg::map_to_screen<float>({s.width, s.height})), picture_(s.width, s.height),
        depth_(s.width, s.height) {}

  seconds_of_stages draw(measured& out) {
    timeline times;
    draw_with(clock_colours{{scene_}, &times}, clock_executor{&times}, out);
    const double start = processor_seconds();
    draw_with(own::vertex_colours{scene_}, irg::sequential{}, out);
    const double end = processor_seconds();
    out.agree = out.agree && times.laps.size() == 4 && out.stats.pixels.shaded == out.stats.drawn;
    if (!out.agree) return {};
    const double tiles = times.laps[3], colours = tiles * times.colours / times.tiles;
    return {times.laps[0], times.laps[1], times.laps[2], tiles - colours, colours, end - start};
  }

private:
  template <class Shading, class E>
  void draw_with(const Shading& shading, const E& executor, measured& out) {
    irg::project_vertices<float>(scene_.positions, scene_.to_clip, mapping_, vertices_, executor);
    const irg::triangle_batch<float> batch[1] = {{&vertices_, scene_.triangles, 0, 0}};
    out.stats = irg::shade_batches<irg::nearer_is_greater, float>(
        irg::render_target{picture_, depth_}, {batch, mapping_}, shading,
        {.culling = scene_.culling, .clear = irg::clearing::before_drawing, .workspace = &workspace_}, executor);
  }

  const scene& scene_;
  irg::screen_mapping<float> mapping_;
  irg::image<irg::rgba8> picture_;
  irg::image<float> depth_;
  irg::projected_vertices<float> vertices_{};
  irg::draw_workspace workspace_{};
};

class frames {
public:
  explicit frames(scene s) : scene_(std::move(s)), frame_(scene_) {}
  frames(const frames&) = delete;
  frames& operator=(const frames&) = delete;

  double draw(stage_of_frame s) { return frame_.draw(last_)[s]; }
  errors found() const {
    errors e;
    if (!last_.agree) e.broken = "the pipeline hands out its work in other portions than this program expects";
    const irg::render_counts& s = last_.stats;
    const auto count = [&](const char* name, std::int64_t n) { e.more.push_back({name, static_cast<double>(n)}); };
    count("triangles", s.triangles);
    count("skipped_frustum", s.skipped.frustum);
    count("skipped_backface", s.skipped.backface);
    count("skipped_tiny", s.skipped.tiny);
    count("skipped_occluded", s.skipped.occluded);
    count("pixels_tested", s.pixels.tested);
    count("pixels_ties", s.pixels.ties);
    count("pixels_shaded", s.pixels.shaded);
    count("drawn", s.drawn);
    return e;
  }

private:
  scene scene_;
  frame frame_;
  measured last_{};
};

}  // namespace

int main(int argc, char** argv) {
  for (const scene_plan& plan : {scene_a(), scene_b(drawing::random_order), scene_c()}) {
    auto& of_scene = keep_lazy([plan] { return std::make_unique<frames>(plan.make()); });
    for (int i = 0; i < stage_count; ++i) {
      const auto s = static_cast<stage_of_frame>(i);
      contender who{names[i], {}, [&of_scene] { return (*of_scene)->found(); }};
      who.seconds = [&of_scene, s] { return (*of_scene)->draw(s); };
      enter({"stages", plan.name, "frame"}, who);
    }
  }
  return run_benchmarks(argc, argv);
}
