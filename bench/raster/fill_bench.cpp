// SPDX-License-Identifier: MIT
// Polygons filled with whole pixels.
#include <irg/raster/fill_convex.hpp>
#include <irg/raster/fill_polygon.hpp>
#include <irg/raster/fill_polygons.hpp>

#include "raster/polygons.hpp"
#include "raster/peers.hpp"

namespace {

using namespace bench;

using ring = std::span<const irg::subpixel>;

void add_own(std::vector<drawer>& d, const canvas& c, const polygon_set& set, bool convex) {
  const auto view = c.view();
  if (convex) d.push_back(own("irg", set, [view](ring r) mutable { (void)irg::fill_convex(view, r, white_rgba); }));
  d.push_back(own(convex ? "irg:polygon" : "irg", set,
                  [view, rule = set.rule, workspace = irg::fill_workspace{}](ring r) mutable {
                    (void)irg::fill_polygon(view, r, rule, white_rgba, irg::window_of(view), workspace);
                  }));
  std::vector<ring> rings;
  for (int k = 0; k < set.size(); ++k) rings.push_back(set.ring(k));
  drawer batch{"irg:batch", {}};
  batch.draw = [view, rings, rule = set.rule, workspace = irg::fill_workspace{}](int first, int last) mutable {
    const std::span<const ring> some(rings.data() + first, static_cast<std::size_t>(last - first));
    (void)irg::fill_polygons(view, some, rule, white_rgba, irg::window_of(view), workspace);
  };
  batch.promised = promise::nothing_wrong;
  batch.note = "fill_polygons";
  d.push_back(batch);
  if (convex)
    d.push_back(own(
        "irg:span sink", set,
        [&c, window = irg::window_of(view)](ring r) {
          (void)irg::convex_spans(r, window, [&c](const irg::span_of_cells& s) {
            std::fill_n(&c.at(s.x_first, s.y), s.x_last - s.x_first, white);
          });
        },
        "convex_spans and std::fill_n"));
}

void add_peers(std::vector<drawer>& d, const canvas& c, const polygon_set& set, bool convex) {
#ifdef IRG_HAVE_SDL2
  if (convex && set.corners < 32) {
    d.push_back(sdl::fill(c, set, sdl::calls::one_each));
    d.push_back(sdl::fill(c, set, sdl::calls::one_for_all));
  }
#endif
#ifdef IRG_HAVE_CAIRO
  d.push_back(cairo::fill(c, set, CAIRO_ANTIALIAS_NONE));
#endif
#ifdef IRG_HAVE_AGG
  d.push_back(antigrain::fill<agg::scanline_bin>(c, set, "AGG scanline_bin"));
#endif
#ifdef IRG_HAVE_PIXMAN
  if (convex) d.push_back(pixman::fill(c, set, PIXMAN_a1));
#endif
#ifdef IRG_HAVE_OPENCV_IMGPROC
  if (convex) d.push_back(opencv::fill(c, set, opencv::filler::convex, cv::LINE_8));
  d.push_back(opencv::fill(c, set, opencv::filler::general, cv::LINE_8));
#endif
  (void)c, (void)d, (void)set, (void)convex;
}

int run(const canvas& c, const std::string& name, double diameter, const polygon_set& set, bool convex) {
  contest one{"fill", name + " " + std::to_string(static_cast<int>(diameter)) + " px " + c.name(), "polygon",
              set.size()};
  if (!wanted(one.test_case)) return 0;
  one.cells = covered_pixels(c, set);
  one.on = &c;
  one.judge = [&](const drawer& d) { return judge_fill(c, set, diameter, d); };
  one.error_unit = "px";
  add_own(one.drawers, c, set, convex);
  if (convex) one.drawers.push_back(textbook_fill(c, set));
  add_peers(one.drawers, c, set, convex);
  if (one.cells > 0) {
    one.limit = "limit:span replay";
    one.drawers.push_back(limit_span_replay(c, set, replaying::plain));
    one.drawers.push_back(limit_span_replay(c, set, replaying::ahead));
    one.drawers.push_back(limit_memset(c, one.cells));
  }
  return hold(one);
}

}  // namespace

int main() {
  bench::stay_on_this_processor();
  return exit_status(run_fills({20000, 8000, 1500, 150}, 32, run));
}
