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

void add_own(std::vector<drawer>& d, const canvas& c, const polygon_set& set) {
  const auto view = c.view();
  if (set.convex())
    d.push_back(own("irg", set, [view](ring r) mutable { (void)irg::fill_convex(view, r, white_rgba); }));
  d.push_back(own(set.convex() ? "irg:polygon" : "irg", set,
                  [view, rule = set.rule(), workspace = irg::fill_workspace{}](ring r) mutable {
                    (void)irg::fill_polygon(view, r, rule, white_rgba, workspace);
                  }));
  auto& rings = keep_lazy([&set] {
    std::vector<ring> all;
    for (int k = 0; k < set.size(); ++k) all.push_back(set.ring(k));
    return all;
  });
  drawer batch{"irg:batch", {}};
  batch.draw = [view, &rings, rule = set.rule(), workspace = irg::fill_workspace{}](int first, int last) mutable {
    const std::span<const ring> some(rings->data() + first, static_cast<std::size_t>(last - first));
    (void)irg::fill_polygons(view, some, rule, white_rgba, workspace);
  };
  batch.promised = promise::nothing_wrong;
  batch.note = "fill_polygons";
  d.push_back(batch);
  if (set.convex())
    d.push_back(own(
        "irg:span sink", set,
        [&c, window = irg::window_of(view)](ring r) {
          (void)irg::convex_spans(r, window, [&c](const irg::span_of_cells& s) {
            std::fill_n(&c.at(s.x_first, s.y), s.x_last - s.x_first, white);
          });
        },
        "convex_spans and std::fill_n"));
}

void add_peers(std::vector<drawer>& d, const canvas& c, const polygon_set& set) {
#ifdef IRG_HAVE_SDL2
  if (set.convex() && set.corners < 32) {
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
  if (set.convex()) d.push_back(pixman::fill(c, set, PIXMAN_a1));
#endif
#ifdef IRG_HAVE_OPENCV_IMGPROC
  if (set.convex()) d.push_back(opencv::fill(c, set, opencv::filler::convex, cv::LINE_8));
  d.push_back(opencv::fill(c, set, opencv::filler::general, cv::LINE_8));
#endif
  (void)c, (void)d, (void)set;
}

void enter_case(const polygon_set& set) {
  const canvas& c = set.on;
  std::vector<drawer> d;
  add_own(d, c, set);
  if (set.convex()) d.push_back(textbook_fill(c, set));
  add_peers(d, c, set);
  if (set.where != placing::outside) {
    d.push_back(limit_span_replay(c, set, replaying::plain));
    d.push_back(limit_span_replay(c, set, replaying::ahead));
    d.push_back(limit_memset(c, covered_pixels(c, set)));
  }
  enter_drawers(set.with("fill", "px", "limit:span replay"), c, d,
                [&c, &set](const drawer& who) { return judge_fill(c, set, who); });
}

}  // namespace

int main(int argc, char** argv) {
  const canvas large(1920, 1080, "1080p"), small(640, 640, "640x640");
  enter_fills(large, small, {20000, 8000, 1500, 150}, 32, enter_case);
  return run_benchmarks(argc, argv);
}
