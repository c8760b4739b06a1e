// SPDX-License-Identifier: MIT
// Every kernel against the conformance vectors, which come from a generator that shares no code with the library.
#include <algorithm>
#include <filesystem>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <doctest/doctest.h>

#include <irg/geometry/polygon_convexity.hpp>
#include <irg/raster/draw_line.hpp>
#include <irg/raster/fill_convex.hpp>
#include <irg/raster/textbook/fill_convex.hpp>
#include <irg/raster/fill_polygon.hpp>
#include <irg/raster/image.hpp>
#include <irg/raster/line_bresenham.hpp>
#include <irg/raster/line_dda.hpp>
#include <irg/raster/line_run_slice.hpp>
#include <irg/raster/triangle_coverage.hpp>

#include "support/conformance.hpp"

namespace {

using items = std::vector<std::vector<std::int64_t>>;
using test::conformance_case;
using subpixel_ring = std::vector<irg::subpixel>;
using double_ring = std::vector<irg::point<double, 2>>;

std::string folder() {
#ifdef IRG_CONFORMANCE_DIR
  return IRG_CONFORMANCE_DIR;
#else
  return (std::filesystem::path(__FILE__).parent_path() / ".." / "conformance").string();
#endif
}

struct file_name {
  std::string name;
  std::size_t cases;
};
const std::vector<file_name> files = {
    {"lines_default", 98},    {"lines_symmetric", 91}, {"lines_half_open", 92},
    {"lines_clipped", 66},    {"lines_extreme", 92},   {"fills_course", 84},
    {"fills_triangles", 111}, {"fills_polygons", 104}, {"tilings", 116},
};

std::vector<conformance_case> cases_of(const std::string& name) {
  const test::conformance_reader reader(folder() + "/" + name + ".txt");
  REQUIRE_MESSAGE(reader.file().error.empty(), name, ".txt: ", reader.file().error);
  return reader.file().cases;
}

template <class F>
void for_each_case(const std::string& kind, F&& f) {
  std::size_t count = 0;
  for (const file_name& file : files)
    for (const conformance_case& c : cases_of(file.name))
      if (c.kind == kind) {
        INFO(file.name << ".txt, case " << c.name);
        f(c);
        ++count;
      }
  MESSAGE(count, " cases of kind ", kind);
  CHECK(count > 100);
}

TEST_CASE("conformance: every file is there, is read whole, and has its cases") {
  std::set<std::string> known;
  for (const file_name& file : files) {
    CHECK_MESSAGE(cases_of(file.name).size() == file.cases, file.name);
    known.insert(file.name + ".txt");
  }
  for (const auto& entry : std::filesystem::directory_iterator(folder()))
    if (entry.path().extension() == ".txt")
      CHECK_MESSAGE(known.count(entry.path().filename().string()) == 1, entry.path());
  CHECK(test::conformance_reader(folder() + "/missing.txt").file().error == "cannot be read");
  CHECK(!test::conformance_reader(folder() + "/generate.py").file().error.empty());
}

// ---- lines

items cells_in_image(const conformance_case& c, const irg::line_options& options) {
  // The window becomes an image of its own, if the ends stay within int.
  const auto moved = [&](irg::cell p, irg::cell& to) {
    const std::int64_t x = std::int64_t{p.x} - c.window.x_first, y = std::int64_t{p.y} - c.window.y_first;
    to = {static_cast<int>(x), static_cast<int>(y)};
    return x == to.x && y == to.y;
  };
  irg::cell a, b;
  items out;
  if (c.window.empty() || !moved(c.from, a) || !moved(c.to, b)) return c.items;
  irg::image<unsigned char> painted(c.window.x_last - c.window.x_first, c.window.y_last - c.window.y_first, 0);
  irg::image<unsigned char> counted = painted;
  irg::draw_line(painted, a, b, 1, options);
  irg::draw_line(counted, a, b, [](unsigned char n) { return static_cast<unsigned char>(n + 1); }, options);
  bool once = true;
  for (int y = 0; y < painted.height(); ++y)
    for (int x = 0; x < painted.width(); ++x) {
      once = once && counted(x, y) == painted(x, y);
      if (painted(x, y) != 0) out.push_back({std::int64_t{x} + c.window.x_first, std::int64_t{y} + c.window.y_first});
    }
  CHECK(once);
  items sorted = c.items;
  const auto by_row = [](const auto& p, const auto& q) { return p[1] != q[1] ? p[1] < q[1] : p[0] < q[0]; };
  std::sort(sorted.begin(), sorted.end(), by_row);
  return out == sorted ? c.items : out;
}

TEST_CASE("conformance: lines") {
  for_each_case("line", [](const conformance_case& c) {
    REQUIRE((c.ties == "start-side" || c.ties == "symmetric"));
    REQUIRE((c.ends == "closed" || c.ends == "half-open"));
    const irg::line_options options{c.ends == "closed" ? irg::line_ends::closed : irg::line_ends::half_open,
                                    c.ties == "symmetric" ? irg::line_ties::symmetric : irg::line_ties::start_side};
    items found;
    const auto sink = [&](irg::cell at) { found.push_back({at.x, at.y}); };
    const auto result = [&] { return std::exchange(found, {}); };
    irg::line_bresenham(c.from, c.to, c.window, sink, options);
    CHECK_MESSAGE(result() == c.items, "line_bresenham");
    irg::line_run_slice(
        c.from, c.to, c.window,
        [&](const irg::line_run& run) {
          const int dx = (run.first.x < run.last.x) - (run.last.x < run.first.x),
                    dy = (run.first.y < run.last.y) - (run.last.y < run.first.y);
          irg::cell at = run.first;
          for (sink(at); at != run.last; sink(at)) at = {at.x + dx, at.y + dy};
        },
        options);
    CHECK_MESSAGE(result() == c.items, "line_run_slice");
    irg::line_dda_exact(c.from, c.to, c.window, sink, options);
    CHECK_MESSAGE(result() == c.items, "line_dda_exact");
    CHECK_MESSAGE(cells_in_image(c, options) == c.items, "draw_line");
  });
}

// ---- fills

constexpr std::int64_t near_limit = std::int64_t{irg::snap_limit} * 256;

bool fits(const std::vector<test::conformance_vertex>& ring, std::int64_t limit) {
  return std::all_of(ring.begin(), ring.end(),
                     [&](const auto& v) { return v.x >= -limit && v.x <= limit && v.y >= -limit && v.y <= limit; });
}
subpixel_ring in_subpixels(const std::vector<test::conformance_vertex>& ring) {
  subpixel_ring out;
  for (const auto& v : ring) out.push_back({static_cast<std::int32_t>(v.x), static_cast<std::int32_t>(v.y)});
  return out;
}
double_ring in_doubles(const std::vector<test::conformance_vertex>& ring) {
  double_ring out;
  for (const auto& v : ring) out.push_back({static_cast<double>(v.x) / 256, static_cast<double>(v.y) / 256});
  return out;
}

bool is_sample_rule(const std::string& rule) {
  return rule == "course" || rule == "closed" || rule == "rounded" || rule == "half-open";
}
irg::textbook::sample_rule sample_rule_of(const std::string& rule) {
  return rule == "course"    ? irg::textbook::sample_rule::course
         : rule == "closed"  ? irg::textbook::sample_rule::closed
         : rule == "rounded" ? irg::textbook::sample_rule::rounded
                             : irg::textbook::sample_rule::half_open;
}

// Calls check(name of the kernel, its spans) for every kernel that can fill these rings by this rule.
template <class Check>
void fill_in_every_way(const std::vector<std::vector<test::conformance_vertex>>& rings, const std::string& rule,
                       const irg::cell_window& window, Check&& check) {
  items found;
  const auto sink = [&](const irg::span_of_cells& s) { found.push_back({s.y, s.x_first, s.x_last}); };
  const auto done = [&](const char* kernel) { check(kernel, std::exchange(found, {})); };
  const bool all_fit = std::all_of(rings.begin(), rings.end(), [](const auto& r) { return fits(r, 0x7fffffff); });
  if (is_sample_rule(rule)) {
    REQUIRE((rings.size() == 1 && all_fit));
    irg::textbook::convex_spans(in_subpixels(rings[0]), sample_rule_of(rule), window, sink);
    return done("textbook::convex_spans");
  }
  REQUIRE((rule == "even-odd" || rule == "non-zero"));
  const irg::fill_rule fill = rule == "even-odd" ? irg::fill_rule::even_odd : irg::fill_rule::non_zero;
  std::vector<subpixel_ring> fine;
  std::vector<double_ring> real;
  for (const auto& ring : rings) {
    real.push_back(in_doubles(ring));
    if (all_fit) fine.push_back(in_subpixels(ring));
  }
  CHECK(irg::polygon_spans(real, fill, window, sink));
  done("polygon_spans of doubles");
  if (all_fit) {
    CHECK(irg::polygon_spans(fine, fill, window, sink));
    done("polygon_spans");
  }
  if (rings.size() != 1) return;
  CHECK(irg::polygon_spans(real[0], fill, window, sink));
  done("polygon_spans of one ring");
  if (irg::is_convex(real[0])) {
    CHECK(irg::convex_spans(real[0], window, sink));
    done("convex_spans of doubles");
    if (all_fit) {
      CHECK(irg::convex_spans(fine[0], window, sink));
      done("convex_spans");
    }
  }
  if (rings[0].size() == 3 && fits(rings[0], near_limit)) {
    irg::covered_spans(irg::cover_triangle(fine[0][0], fine[0][1], fine[0][2]), window, sink);
    done("covered_spans");
  }
}

TEST_CASE("conformance: fills") {
  for_each_case("fill", [](const conformance_case& c) {
    fill_in_every_way(c.rings, c.rule, c.window,
                      [&](const char* kernel, const items& found) { CHECK_MESSAGE(found == c.items, kernel); });
  });
}

TEST_CASE("conformance: tilings, every cell once") {
  for_each_case("tiling", [](const conformance_case& c) {
    items whole;
    for (std::size_t tile = 0; tile < c.rings.size(); ++tile) {
      items expected;
      for (const auto& item : c.items)
        if (item[3] == static_cast<std::int64_t>(tile)) expected.push_back({item[0], item[1], item[2]});
      fill_in_every_way({c.rings[tile]}, c.rule, c.window,
                        [&](const char* kernel, const items& found) { CHECK_MESSAGE(found == expected, kernel); });
      whole.insert(whole.end(), expected.begin(), expected.end());
    }
    std::sort(whole.begin(), whole.end());
    REQUIRE(whole.size() == c.items.size());
    bool disjoint = true;
    for (std::size_t i = 1; i < whole.size(); ++i)
      disjoint = disjoint && (whole[i - 1][0] < whole[i][0] || whole[i - 1][2] <= whole[i][1]);
    CHECK(disjoint);
  });
}

}  // namespace
