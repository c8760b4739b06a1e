// SPDX-License-Identifier: MIT
// Antialiased lines, one pixel wide, between the centres of pixels: one call per line.
#include <irg/raster/blend_span.hpp>
#include <irg/raster/line_aa.hpp>
#include <irg/raster/line_wu.hpp>

#include "raster/coverage.hpp"
#include "raster/peers.hpp"

namespace {

using namespace bench;

irg::subpixel centre(irg::cell c) { return {c.x * 256 + 128, c.y * 256 + 128}; }

void add_own(std::vector<drawer>& d, const canvas& c, line_list& lines) {
  d.push_back(own(
      "irg", lines,
      [view = c.view()](irg::cell a, irg::cell b) mutable { (void)irg::draw_line_aa(view, a, b, white_rgba); },
      promise::nothing_wrong));
  d.push_back(own(
      "irg:span sink", lines,
      [view = c.view()](irg::cell a, irg::cell b) mutable {
        (void)irg::line_aa(centre(a), centre(b), irg::window_of(view),
                           [&](const irg::coverage_span& span) { irg::blend_span(view, span, white_rgba); });
      },
      promise::nothing_wrong, "line_aa and blend_span"));
  d.push_back(own(
      "irg:wu", lines,
      [view = c.view()](irg::cell a, irg::cell b) mutable { irg::draw_line_wu(view, a, b, white_rgba); }, promise::none,
      "two cells per step whose coverages add up to 1"));
}

void add_peers(std::vector<drawer>& d, const canvas& c, line_list& lines) {
#ifdef IRG_HAVE_OPENCV_IMGPROC
  d.push_back(opencv::lines(c, lines, cv::LINE_AA));
#endif
#ifdef IRG_HAVE_AGG
  d.push_back(antigrain::lines_outline_aa(c, lines));
  d.push_back(antigrain::lines_stroke_aa(c, lines));
#endif
#ifdef IRG_HAVE_CAIRO
  d.push_back(cairo::lines(c, lines, CAIRO_ANTIALIAS_DEFAULT));
#endif
  (void)c, (void)d, (void)lines;
}

// How many lines to judge, so that it takes no longer than the race.
int sample_size(const std::vector<segment>& lines) {
  const double box = std::hypot(lines[0].b.x - lines[0].a.x, lines[0].b.y - lines[0].a.y);
  return std::min(static_cast<int>(lines.size()),
                  static_cast<int>(std::min(1000.0, 3 + (smoke() ? 1e5 : 6e6) / (box * box / 4))));
}

void enter_case(const line_case& one, heading, int) {
  const canvas& c = one.on;
  line_list& lines = one.lines;
  std::vector<drawer> d;
  add_own(d, c, lines);
  add_peers(d, c, lines);
  if (one.any_visible) {
    d.push_back(limit_coverage_replay(c, one.count, [&c, &lines](int k, auto&& sink) {
      const segment& s = (*lines)[static_cast<std::size_t>(k)];
      (void)irg::line_aa(centre(s.a), centre(s.b), irg::cell_window{0, 0, c.width(), c.height()}, sink);
    }));
    d.push_back(limit_store_per_step(c, lines));
  }
  auto& due = keep_lazy([&c, &lines] { return exact_areas(c, *lines, sample_size(*lines)); });
  enter_drawers(one.with("line_aa", "1/256", "limit:coverage replay"), c, d,
                [&c, &due](const drawer& who) { return judge_coverage(c, *due, who); });
}

}  // namespace

int main(int argc, char** argv) {
  const canvas large(1920, 1080, "1080p"), small(640, 640, "640x640");
  enter_lines(large, small, {{20000, 10000, 3000, 800, 300}, 2000, 10000, 128, 128}, enter_case);
  return run_benchmarks(argc, argv);
}
