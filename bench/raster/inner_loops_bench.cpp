// SPDX-License-Identifier: MIT
// The rasterizer's inner loops one by one, each beside its limit, on memory that stays in the first cache: runs of
// pixels, steps along lines, clearing.
#include <irg/raster/draw_line.hpp>
#include <irg/raster/draw_triangle.hpp>
#include <irg/raster/fill_span.hpp>
#include <irg/raster/line_dda.hpp>
#include <irg/raster/line_run_slice.hpp>

#include "raster/lines.hpp"

namespace {

using namespace bench;

// Wrong: bytes that are not what they have to be.
std::function<errors()> judging_pixels(const canvas& c, std::function<void()> draw, std::vector<std::uint32_t> due) {
  return [&c, draw = std::move(draw), due = std::move(due)] {
    c.clear();
    draw();
    errors e;
    e.wrong = 0;
    for (std::size_t i = 0; i < due.size(); ++i) e.wrong += c.pixels()[i] != due[i];
    if (e.wrong != 0) e.broken = "a pixel is wrong";
    return e;
  };
}

void enter_spans(const canvas& c, int length) {
  random_numbers r(static_cast<std::uint64_t>(length));
  auto& offsets = keep(std::vector<std::uint32_t>());
  for (int i = 0; i < 256; ++i)
    offsets.push_back(
        static_cast<std::uint32_t>(r.integer(0, c.height() - 1) * c.width() + r.integer(0, c.width() - length)));
  const contest what{"span_fill", std::to_string(length) + " px" + build_suffix(), "span", 256, "", "limit:memset"};
  std::vector<std::uint32_t> due(c.pixel_count());
  for (const std::uint32_t o : offsets) std::fill_n(due.begin() + o, length, white);
  const auto add = [&](const char* name, auto fill) {
    const auto run = [&c, &offsets, fill] {
      for (const std::uint32_t o : offsets) fill(c.pixels() + o);
      asm volatile("" : : "r"(c.pixels()) : "memory");
    };
    contender who{name, run};
    if (what.limit != name) who.judge = judging_pixels(c, run, due);
    enter(what, std::move(who));
  };
  const auto n = static_cast<std::size_t>(length);
  add("irg", [n](std::uint32_t* p) { irg::fill_pixels(reinterpret_cast<irg::rgba8*>(p), n, white_rgba); });
  add("std::fill_n", [n](std::uint32_t* p) { std::fill_n(p, n, white); });
  add("limit:memset", [n](std::uint32_t* p) { std::memset(p, 255, 4 * n); });
}

void enter_walks(const canvas& c, int length) {
  const int count = 128;
  const line_case one = make_line_case(c, std::to_string(length) + " steps", count,
                                       [&c, length] { return lines_inside(c, count, length, heading::random); });
  line_list& lines = one.lines;
  const irg::cell_window window{0, 0, c.width(), c.height()};
  const auto write = [&c](irg::cell p) { c.at(p.x, p.y) = white; };
  std::vector<drawer> d;
  d.push_back(own(
      "irg", lines, [view = c.view()](irg::cell a, irg::cell b) mutable { irg::draw_line(view, a, b, white_rgba); },
      promise::nothing_wrong));
  d.push_back(own(
      "irg:bresenham sink", lines, [=](irg::cell a, irg::cell b) { irg::line_bresenham(a, b, window, write); },
      promise::nothing_wrong));
  d.push_back(own(
      "irg:dda exact", lines, [=](irg::cell a, irg::cell b) { irg::line_dda_exact(a, b, window, write); },
      promise::nothing_wrong));
  d.push_back(textbook_lines(c, lines));
  d.push_back(limit_store_per_step(c, lines));
  d.push_back(limit_replay(c, lines, fetching::not_ahead));
  enter_drawers(one.with("line_walk", "px", "limit:store per step"), c, d,
                [&c, &lines](const drawer& who) { return judge_lines(c, *lines, who); });
}

void enter_clears(const canvas& c) {
  const contest what{"clear",       c.name() + build_suffix(), "pixel", static_cast<std::int64_t>(c.pixel_count()), "",
                     "limit:memset"};
  const auto add = [&](const char* name, auto clear) {
    const auto run = [&c, clear]() mutable {
      clear();
      asm volatile("" : : "r"(c.pixels()) : "memory");
    };
    contender who{name, run};
    if (what.limit != name) who.judge = judging_pixels(c, run, std::vector<std::uint32_t>(c.pixel_count(), 0xff030201));
    enter(what, std::move(who));
  };
  add("irg", [view = c.view()]() mutable { irg::clear(view, irg::rgba8{1, 2, 3, 255}); });
  add("std::fill", [&c] { std::fill_n(c.pixels(), c.pixel_count(), 0xff030201); });
  add("limit:memset", [&c] { std::memset(c.pixels(), 1, c.bytes()); });
}

}  // namespace

int main(int argc, char** argv) {
  const canvas in_cache(80, 80, "80x80"), large(1920, 1080, "1080p");
  for (const int length : {3, 16, 64}) enter_spans(in_cache, length);
  for (const int length : {8, 32, 70}) enter_walks(in_cache, length);
  enter_clears(in_cache);
  enter_clears(large);
  return run_benchmarks(argc, argv);
}
