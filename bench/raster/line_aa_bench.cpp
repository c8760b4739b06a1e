// SPDX-License-Identifier: MIT
// Antialiased lines, one pixel wide, between the centres of pixels: one call per line.
#include <irg/raster/blend_span.hpp>
#include <irg/raster/line_aa.hpp>
#include <irg/raster/line_wu.hpp>

#include "raster/coverage.hpp"
#ifdef IRG_HAVE_OPENCV_IMGPROC
#include "raster/peer_opencv.hpp"
#endif
#ifdef IRG_HAVE_AGG
#include "raster/peer_agg.hpp"
#endif
#ifdef IRG_HAVE_CAIRO
#include "raster/peer_cairo.hpp"
#endif

namespace {

using namespace bench;

irg::subpixel centre(irg::cell c) { return {c.x * 256 + 128, c.y * 256 + 128}; }

void add_own(std::vector<drawer>& d, const canvas& c, const std::vector<segment>& lines) {
  drawer whole{"irg", {}};
  whole.draw = [view = c.view(), &lines](int first, int last) mutable {
    for (int k = first; k < last; ++k) {
      const segment& s = lines[static_cast<std::size_t>(k)];
      (void)irg::draw_line_aa(view, s.a, s.b, white_rgba);
    }
  };
  whole.promised = promise::nothing_wrong;
  d.push_back(whole);
  drawer sink{"irg:span sink", {}};
  sink.draw = [view = c.view(), &lines](int first, int last) mutable {
    for (int k = first; k < last; ++k) {
      const segment& s = lines[static_cast<std::size_t>(k)];
      (void)irg::line_aa(centre(s.a), centre(s.b), irg::window_of(view),
                         [&](const irg::coverage_span& span) { irg::blend_span(view, span, white_rgba); });
    }
  };
  sink.promised = promise::nothing_wrong;
  sink.note = "line_aa and blend_span";
  d.push_back(sink);
}

drawer wu(const canvas& c, const std::vector<segment>& lines) {
  drawer d{"irg:wu", {}};
  d.draw = [view = c.view(), &lines](int first, int last) mutable {
    for (int k = first; k < last; ++k) {
      const segment& s = lines[static_cast<std::size_t>(k)];
      irg::draw_line_wu(view, s.a, s.b, white_rgba);
    }
  };
  d.note = "two cells per step whose coverages add up to 1";
  return d;
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

int run(const canvas& c, const std::string& name, const std::vector<segment>& lines) {
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
  one.drawers.push_back(wu(c, lines));
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
  int broken = 0;
  struct sizes {
    int length, count;
  };
  const auto items = [](int n) { return smoke() ? n / 100 + 2 : n; };
  for (const auto [length, count] : {sizes{8, 20000}, {32, 10000}, {128, 3000}, {512, 800}, {1500, 300}}) {
    const std::string px = " " + std::to_string(length) + " px";
    const auto on = [&](const canvas& c, const char* name, heading h) {
      broken += run(c, name + px, lines_inside(c, items(count), length, h));
    };
    on(large, "random", heading::random);
    if (length <= 512) on(small, "random", heading::random);
    if (length != 128) continue;
    on(large, "horizontal", heading::horizontal);
    on(large, "vertical", heading::vertical);
    on(large, "diagonal", heading::diagonal);
  }
  broken += run(large, "clipped 90 % 1280 px", lines_clipped(large, items(2000), 1280));
  broken += run(large, "outside", lines_outside(large, items(10000), passing::far_away));
  if (broken) std::printf("%d promises broken\n", broken);
  return broken != 0;
}
