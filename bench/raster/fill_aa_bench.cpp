// SPDX-License-Identifier: MIT
// Antialiased polygons: one call per polygon.
#include <irg/raster/blend_span.hpp>
#include <irg/raster/fill_convex_aa.hpp>
#include <irg/raster/fill_polygon_aa.hpp>

#include "raster/coverage.hpp"
#include "raster/peers.hpp"

namespace {

using namespace bench;
using ring = std::span<const irg::subpixel>;

void add_own(std::vector<drawer>& d, const canvas& c, const polygon_set& set, bool convex) {
  const auto view = c.view();
  if (convex) d.push_back(own("irg", set, [view](ring r) mutable { (void)irg::fill_convex_aa(view, r, white_rgba); }));
  d.push_back(own(convex ? "irg:polygon" : "irg", set,
                  [view, rule = set.rule, workspace = irg::coverage_workspace{}](ring r) mutable {
                    (void)irg::fill_polygon_aa(view, r, rule, white_rgba, irg::window_of(view), workspace);
                  }));
  if (!convex) return;
  d.push_back(own(
      "irg:span sink", set,
      [view](ring r) mutable {
        (void)irg::convex_coverage(r, irg::window_of(view),
                                   [&](const irg::coverage_span& s) { irg::blend_span(view, s, white_rgba); });
      },
      "convex_coverage and blend_span"));
}

void add_peers(std::vector<drawer>& d, const canvas& c, const polygon_set& set, bool convex) {
#ifdef IRG_HAVE_AGG
  d.push_back(antigrain::fill<agg::scanline_u8>(c, set, "AGG scanline_u8"));
  d.push_back(antigrain::fill<agg::scanline_p8>(c, set, "AGG scanline_p8"));
#endif
#ifdef IRG_HAVE_CAIRO
  d.push_back(cairo::fill(c, set, CAIRO_ANTIALIAS_DEFAULT));
#endif
#ifdef IRG_HAVE_PIXMAN
  if (convex) d.push_back(pixman::fill(c, set, PIXMAN_a8));
#endif
#ifdef IRG_HAVE_OPENCV_IMGPROC
  d.push_back(opencv::fill(c, set, convex ? opencv::filler::convex : opencv::filler::general, cv::LINE_AA));
#endif
  (void)c, (void)d, (void)set, (void)convex;
}

int run(const canvas& c, const std::string& name, double diameter, const polygon_set& set, bool convex) {
  contest one{"fill_aa", name + " " + std::to_string(static_cast<int>(diameter)) + " px " + c.name(), "polygon",
              set.size()};
  if (!wanted(one.test_case)) return 0;
  one.cells = covered_pixels(c, set);
  one.on = &c;
  const std::vector<areas> due = exact_areas(c, set, sample_size(set, diameter));
  one.judge = [&](const drawer& d) { return judge_coverage(c, due, d); };
  one.error_unit = "1/256";
  add_own(one.drawers, c, set, convex);
  add_peers(one.drawers, c, set, convex);
  if (one.cells > 0) {
    one.limit = "limit:coverage replay";
    one.drawers.push_back(limit_coverage_replay(c, one.items, [&](int k, auto&& sink) {
      (void)irg::polygon_coverage(set.ring(k), set.rule, irg::cell_window{0, 0, c.width(), c.height()}, sink);
    }));
    one.drawers.push_back(limit_span_replay(c, set, replaying::ahead));
  }
  return hold(one);
}

}  // namespace

int main() {
  bench::stay_on_this_processor();
  return exit_status(run_fills({20000, 6000, 1000, 100}, 3, run));
}
