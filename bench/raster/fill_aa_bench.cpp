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

void add_own(std::vector<drawer>& d, const canvas& c, const polygon_set& set) {
  const auto view = c.view();
  if (set.convex())
    d.push_back(own("irg", set, [view](ring r) mutable { (void)irg::fill_convex_aa(view, r, white_rgba); }));
  d.push_back(own(set.convex() ? "irg:polygon" : "irg", set,
                  [view, rule = set.rule(), workspace = irg::coverage_workspace{}](ring r) mutable {
                    (void)irg::fill_polygon_aa(view, r, rule, white_rgba, workspace);
                  }));
  if (!set.convex()) return;
  d.push_back(own(
      "irg:span sink", set,
      [view](ring r) mutable {
        (void)irg::convex_coverage(r, irg::window_of(view),
                                   [&](const irg::coverage_span& s) { irg::blend_span(view, s, white_rgba); });
      },
      "convex_coverage and blend_span"));
}

void add_peers(std::vector<drawer>& d, const canvas& c, const polygon_set& set) {
#ifdef IRG_HAVE_AGG
  d.push_back(antigrain::fill<agg::scanline_u8>(c, set, "AGG scanline_u8"));
  d.push_back(antigrain::fill<agg::scanline_p8>(c, set, "AGG scanline_p8"));
#endif
#ifdef IRG_HAVE_CAIRO
  d.push_back(cairo::fill(c, set, CAIRO_ANTIALIAS_DEFAULT));
#endif
#ifdef IRG_HAVE_PIXMAN
  if (set.convex()) d.push_back(pixman::fill(c, set, PIXMAN_a8));
#endif
#ifdef IRG_HAVE_OPENCV_IMGPROC
  d.push_back(opencv::fill(c, set, set.convex() ? opencv::filler::convex : opencv::filler::general, cv::LINE_AA));
#endif
  (void)c, (void)d, (void)set;
}

void enter_case(const polygon_set& set) {
  const canvas& c = set.on;
  std::vector<drawer> d;
  add_own(d, c, set);
  add_peers(d, c, set);
  if (set.where != placing::outside) {
    d.push_back(limit_coverage_replay(c, set.size(), [&c, &set](int k, auto&& sink) {
      (void)irg::polygon_coverage(set.ring(k), set.rule(), irg::cell_window{0, 0, c.width(), c.height()}, sink);
    }));
    d.push_back(limit_span_replay(c, set, replaying::ahead));
  }
  auto& due = keep_lazy([&c, &set] { return exact_areas(c, set, sample_size(set)); });
  enter_drawers(set.with("fill_aa", "1/256", "limit:coverage replay"), c, d,
                [&c, &due](const drawer& who) { return judge_coverage(c, *due, who); });
}

}  // namespace

int main(int argc, char** argv) {
  const canvas large(1920, 1080, "1080p"), small(640, 640, "640x640");
  enter_fills(large, small, {20000, 6000, 1000, 100}, 3, enter_case);
  return run_benchmarks(argc, argv);
}
