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

void add_own(std::vector<drawer>& d, const canvas& c, const std::vector<segment>& lines) {
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

void add_peers(std::vector<drawer>& d, const canvas& c, const std::vector<segment>& lines) {
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

int run(const canvas& c, const std::string& name, const std::vector<segment>& lines, heading) {
  contest one{"line_aa", name + " " + c.name(), "line", static_cast<int>(lines.size())};
  if (!wanted(one.test_case)) return 0;
  for (const segment& s : lines) one.cells += visible_cells(c, s);
  one.on = &c;
  const double box = lines.empty() ? 1 : std::hypot(lines[0].b.x - lines[0].a.x, lines[0].b.y - lines[0].a.y);
  const int sample =
      std::min(one.items, static_cast<int>(std::min(1000.0, 3 + (smoke() ? 1e5 : 6e6) / (box * box / 4))));
  const std::vector<areas> due = exact_areas(c, lines, sample);
  one.judge = [&](const drawer& d) { return judge_coverage(c, due, d); };
  one.error_unit = "1/256";
  add_own(one.drawers, c, lines);
  add_peers(one.drawers, c, lines);
  if (one.cells > 0) {
    one.limit = "limit:coverage replay";
    one.drawers.push_back(limit_coverage_replay(c, one.items, [&](int k, auto&& sink) {
      const segment& s = lines[static_cast<std::size_t>(k)];
      (void)irg::line_aa(centre(s.a), centre(s.b), irg::cell_window{0, 0, c.width(), c.height()}, sink);
    }));
    one.drawers.push_back(limit_store_per_step(c, lines));
  }
  return hold(one);
}

}  // namespace

int main() {
  bench::stay_on_this_processor();
  const canvas large(1920, 1080, "1080p"), small(640, 640, "640x640");
  return exit_status(run_lines(large, small, {{20000, 10000, 3000, 800, 300}, 2000, 10000, 128, 128}, run));
}
