// SPDX-License-Identifier: MIT
// Antialiased polygons: one call per polygon.
#include <irg/raster/blend_span.hpp>
#include <irg/raster/fill_convex_aa.hpp>
#include <irg/raster/fill_polygon_aa.hpp>

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
#ifdef IRG_HAVE_PIXMAN
#include "raster/peer_pixman.hpp"
#endif

namespace {

using namespace bench;
using ring = std::span<const irg::subpixel>;

// A contender of irg: draw(ring) for each polygon.
template <class Draw>
drawer own(std::string name, const polygon_set& set, Draw draw, std::string note = {}) {
  return {std::move(name),
          [&set, draw](int first, int last) mutable {
            for (int k = first; k < last; ++k) draw(set.ring(k));
          },
          true, std::move(note), promise::nothing_wrong};
}

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
  const canvas large(1920, 1080, "1080p"), small(640, 640, "640x640");
  int broken = 0;
  struct sizes {
    double diameter;
    int count;
  };
  struct shapes {
    int corners;
    const char* name;
  };
  const auto items = [](int n) { return smoke() ? n / 200 + 2 : n; };
  for (const auto [diameter, count] : {sizes{8, 20000}, {32, 6000}, {128, 1000}, {512, 100}}) {
    for (const auto [corners, name] :
         {shapes{3, "triangle"}, {4, "4 vertices"}, {8, "8 vertices"}, {32, "32 vertices"}}) {
      broken += run(large, name, diameter, round_polygons(large, items(count), corners, diameter), true);
      if (corners == 3)
        broken += run(small, name, diameter, round_polygons(small, items(count), corners, diameter), true);
    }
    if (diameter >= 32)
      broken += run(large, "star", diameter, round_polygons(large, items(count), 7, diameter, 3), false);
  }
  const auto placed = [&](const char* name, placing where) {
    broken += run(large, name, 128, round_polygons(large, items(1000), 3, 128, 1, where), true);
  };
  placed("triangle clipped 90 %", placing::clipped);
  placed("triangle outside", placing::outside);
  if (broken) std::printf("%d promises broken\n", broken);
  return broken != 0;
}
