// SPDX-License-Identifier: MIT
// Lines of whole pixels: one call per line, and all lines in one call.
#include <span>

#include <irg/raster/draw_line.hpp>
#include <irg/raster/draw_lines.hpp>
#include <irg/raster/line_dda.hpp>
#include <irg/raster/line_run_slice.hpp>
#include <irg/raster/textbook/line_bresenham.hpp>

#include "raster/lines.hpp"
#include "raster/peers.hpp"

namespace {

using namespace bench;

// Cells given one by one to a function that writes them if they are on the canvas; for the algorithms without a window.
auto plotter(const canvas& c) {
  return [&c](irg::cell p) {
    if (c.holds(p.x, p.y)) c.at(p.x, p.y) = white;
  };
}

void add_own(std::vector<drawer>& d, const canvas& c, line_list& lines) {
  const irg::cell_window window{0, 0, c.width(), c.height()};
  d.push_back(own(
      "irg", lines, [view = c.view()](irg::cell a, irg::cell b) mutable { irg::draw_line(view, a, b, white_rgba); },
      promise::nothing_wrong));
  const auto write = [&c](irg::cell p) { c.at(p.x, p.y) = white; };
  d.push_back(own(
      "irg:bresenham sink", lines, [=](irg::cell a, irg::cell b) { irg::line_bresenham(a, b, window, write); },
      promise::nothing_wrong));
  const auto write_run = [&c](const irg::line_run& r) {
    const int dx = (r.last.x > r.first.x) - (r.last.x < r.first.x),
              dy = (r.last.y > r.first.y) - (r.last.y < r.first.y);
    const int count = std::max(std::abs(r.last.x - r.first.x), std::abs(r.last.y - r.first.y)) + 1;
    std::uint32_t* p = &c.at(r.first.x, r.first.y);
    for (int i = 0; i < count; ++i, p += dx + std::ptrdiff_t{dy} * c.width()) *p = white;
  };
  d.push_back(own(
      "irg:run slice", lines, [=](irg::cell a, irg::cell b) { irg::line_run_slice(a, b, window, write_run); },
      promise::nothing_wrong));
  d.push_back(own(
      "irg:dda exact", lines, [=](irg::cell a, irg::cell b) { irg::line_dda_exact(a, b, window, write); },
      promise::nothing_wrong));
}

// Algorithms that know no window and have a longest line.
void add_unclipped(std::vector<drawer>& d, const canvas& c, line_list& lines, int steps) {
  if (steps <= irg::line_dda_steps<float>)
    d.push_back(own(
        "irg:dda float", lines,
        [plot = plotter(c)](irg::cell a, irg::cell b) { (void)irg::line_dda<float>(a, b, plot); }, promise::none));
  if (steps <= irg::textbook::line_bresenham_steps<float>)
    d.push_back(own(
        "irg:textbook float", lines,
        [plot = plotter(c)](irg::cell a, irg::cell b) { (void)irg::textbook::line_bresenham<float>(a, b, plot); },
        promise::none, "real-valued error variable"));
  d.push_back(own(
      "irg:textbook double", lines,
      [plot = plotter(c)](irg::cell a, irg::cell b) { (void)irg::textbook::line_bresenham<double>(a, b, plot); },
      promise::nothing_wrong, "real-valued error variable"));
  d.push_back(textbook_lines(c, lines));
}

void add_peers(std::vector<drawer>& d, const canvas& c, line_list& lines) {
#ifdef IRG_HAVE_AGG
  d.push_back(antigrain::lines(c, lines));
#endif
#ifdef IRG_HAVE_SDL2
  d.push_back(sdl::lines(c, lines));
#endif
#ifdef IRG_HAVE_OPENCV_IMGPROC
  d.push_back(opencv::lines(c, lines, cv::LINE_8));
#endif
#ifdef IRG_HAVE_CAIRO
  d.push_back(cairo::lines(c, lines, CAIRO_ANTIALIAS_NONE));
#endif
  (void)c, (void)d, (void)lines;
}

void enter_case(const line_case& one, int steps) {
  const canvas& c = one.on;
  line_list& lines = one.lines;
  std::vector<drawer> d;
  add_own(d, c, lines);
  if (one.name.starts_with("random")) add_unclipped(d, c, lines, steps);
  add_peers(d, c, lines);
  if (one.any_visible) {
    d.push_back(limit_store_per_step(c, lines));
    d.push_back(limit_replay(c, lines, fetching::not_ahead));
    d.push_back(limit_replay(c, lines, fetching::ahead));
    d.push_back(limit_memset(c, one.cells));
  }
  enter_drawers(one.with("line", "px", "limit:store per step"), c, d,
                [&c, &lines](const drawer& who) { return judge_lines(c, *lines, who); });
}

// All lines in one call, for whoever has such a call.

drawer own_batch(const canvas& c, line_list& lines) {
  auto& all = keep_lazy([&lines] {
    std::vector<irg::cell_line> ends;
    for (const segment& s : *lines) ends.push_back({s.a, s.b});
    return ends;
  });
  drawer d{"irg", {}};
  d.draw = [view = c.view(), &all, memory = irg::line_batch{}](int first, int last) mutable {
    const std::span<const irg::cell_line> some(all->data() + first, static_cast<std::size_t>(last - first));
    irg::draw_lines(view, some, white_rgba, irg::line_options{}, memory);
  };
  d.promised = promise::nothing_wrong;
  d.note = "sorting timed";
  return d;
}

/// The cells known beforehand and sorted by tiles of 256 x 64 pixels.
drawer limit_replay_by_tile(const canvas& c, line_list& lines) {
  auto& offsets = keep_lazy([&c, &lines] {
    const auto tile = [width = c.width() / 256 + 1](irg::cell p) { return p.y / 64 * width + p.x / 256; };
    std::vector<std::vector<std::uint32_t>> tiles(static_cast<std::size_t>(tile({c.width() - 1, c.height() - 1})) + 1);
    for (const segment& s : *lines)
      walk(s).cells(c, [&](irg::cell p) {
        tiles[static_cast<std::size_t>(tile(p))].push_back(static_cast<std::uint32_t>(p.y * c.width() + p.x));
      });
    std::vector<std::uint32_t> all;
    for (const auto& t : tiles) all.insert(all.end(), t.begin(), t.end());
    return all;
  });
  return {"limit:replay by tile", [&offsets, pixels = c.pixels()](int, int) {
            for (const std::uint32_t offset : *offsets) pixels[offset] = white;
          }};
}

// One by one as elsewhere; whoever promises exactness has to draw all lines at once without a wrong pixel, too.
errors judge_batch(const canvas& c, const std::vector<segment>& lines, const drawer& d) {
  errors e = judge_lines(c, lines, d);
  if (d.promised == promise::none) return e;
  d.draw(0, static_cast<int>(lines.size()));
  std::vector<bool> due(c.pixel_count());
  for (const segment& s : lines)
    walk(s).cells(c, [&](irg::cell p) { due[static_cast<std::size_t>(p.y * c.width() + p.x)] = true; });
  for (std::size_t i = 0; i < c.pixel_count(); ++i) e.wrong += (c.pixels()[i] != 0) != due[i];
  c.clear();
  return e;
}

void enter_batch(const line_case& one) {
  const canvas& c = one.on;
  line_list& lines = one.lines;
  std::vector<drawer> d;
  d.push_back(own_batch(c, lines));
  d.push_back(own(
      "irg:one by one", lines,
      [view = c.view()](irg::cell a, irg::cell b) mutable { irg::draw_line(view, a, b, white_rgba); },
      promise::nothing_wrong));
#ifdef IRG_HAVE_OPENCV_IMGPROC
  d.push_back(opencv::line_batch(c, lines));
#endif
  add_peers(d, c, lines);
  if (one.any_visible) {
    d.push_back(limit_replay_by_tile(c, lines));
    d.push_back(limit_replay(c, lines, fetching::not_ahead));
    d.push_back(limit_replay(c, lines, fetching::ahead));
    d.push_back(limit_store_per_step(c, lines));
  }
  enter_drawers(one.with("line_batch", "px", "limit:replay by tile"), c, d,
                [&c, &lines](const drawer& who) { return judge_batch(c, *lines, who); });
}

}  // namespace

int main(int argc, char** argv) {
  const canvas large(1920, 1080, "1080p"), small(640, 640, "640x640");
  const line_cases cases{{50000, 30000, 10000, 4000, 2000}, 4000, 20000, 32, 512};
  enter_lines(large, small, cases, [](const line_case& one, heading h, int length) {
    enter_case(one, length);
    if (h == heading::random) enter_batch(one);
  });
  const int count = smoke() ? 202 : 20000;
  enter_case(make_line_case(large, "outside by a corner", count,
                            [&large, count] { return lines_outside(large, count, passing::by_a_corner); }),
             0);
  return run_benchmarks(argc, argv);
}
