// SPDX-License-Identifier: MIT
// grid_surface - a surface over a grid without the lines that it hides, decided exactly.
#include <algorithm>
#include <array>
#include <cstdio>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include <irg/hidden/grid_surface.hpp>
#include <irg/hidden/surface_camera.hpp>
#include <irg/io/file.hpp>
#include <irg/io/svg_drawing.hpp>
#include <irg/raster/line_aa.hpp>

#include "support/command_line.hpp"
#include "support/number_input.hpp"
#include "support/number_output.hpp"
#include "support/picture_options.hpp"
#include "support/run_or_fail.hpp"

namespace {

constexpr std::string_view help =
    R"(grid_surface - a surface over a grid without the lines that it hides

usage: grid_surface [options] <NUMBERS

Reads n and m, both at least 1, then (n+1)(m+1) heights y[i][j] at x = i, z = j with i outer and j inner, then the eye:
x y z. Numbers are separated by white space; # begins a comment. Prints how the surface is seen (front, side, corner or
horizontal) and how many facets it has.

  --order        print the facets in covering order instead, those that can hide first: i j, from 1
  --list         print the parts of grid edges that are seen instead: i1 j1 i2 j2 t0 t1, points from 0, t along the edge
  --input FILE   read the numbers from FILE instead of standard input
  -o OUT         draw what is seen: .png, .ppm or .svg; as far as 63 degrees beside the view's middle, or all of it
                 where the eye is beside the grid and nothing is 85 degrees off
  --size WxH     pixels of the picture (640x480)
)";

struct settings : program::drawing_options {
  bool order = false;
};

settings read_settings(program::command_line& line) {
  settings s;
  while (!line.done()) {
    const std::string_view word = line.take();
    if (word == "--order")
      s.order = true;
    else
      s.read(line, word);
  }
  if (s.list && s.order) line.fail("only one of --list and --order can be printed");
  s.finish(line);
  return s;
}

struct scene {
  std::vector<double> x{}, z{}, heights{};
  irg::point<double, 3> eye{};
  irg::grid_surface surface() const { return {x, z, heights}; }
};

irg::grid_view kind_of(const scene& s) { return irg::grid_view_from(s.x, s.z, s.eye.x, s.eye.y, s.eye.z); }

bool part_comes_before(const irg::grid_edge_part& a, const irg::grid_edge_part& b) {
  return std::tie(a.i1, a.j1, a.i2, a.j2, a.from) < std::tie(b.i1, b.j1, b.i2, b.j2, b.from);
}

// Reads the scene and draws it, so that an eye on the surface can be refused at its place.
scene read_scene(const program::command_line& line, const std::string& file, std::vector<irg::grid_edge_part>& parts) {
  scene s;
  constexpr int most = 1 << 26;
  program::number_input::prompt_if_terminal("n m, the heights, the eye: ", file);
  program::number_input input(line, file);
  const int n = input.integer("n", 1, most);
  const int m = input.integer("m", 1, most);
  if ((static_cast<long long>(n) + 1) * (static_cast<long long>(m) + 1) > most)
    input.fail_at_word("the grid has more than " + std::to_string(most) + " points");
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j <= m; ++j) s.heights.push_back(input.number("height"));
  s.eye.x = input.number("eye x");
  s.eye.y = input.number("eye y");
  s.eye.z = input.number("eye z");
  for (int i = 0; i <= n; ++i) s.x.push_back(i);
  for (int j = 0; j <= m; ++j) s.z.push_back(j);
  const auto done =
      irg::visible_grid_edges(s.surface(), s.eye, [&](const irg::grid_edge_part& p) { parts.push_back(p); });
  if (done.status == irg::grid_surface_status::eye_on_surface) input.fail_at_word("the eye lies on the surface");
  input.expect_end();
  return s;
}

using segment_in_space = std::array<irg::point<double, 3>, 2>;
using line_in_picture = std::array<irg::point<double, 2>, 2>;

// The part of a segment that is before the eye and no more than `widest` times its depth to any side; 0 to 1 is all.
std::optional<std::array<double, 2>> part_within(const irg::surface_camera& view, const segment_in_space& s,
                                                 double widest) {
  const irg::vec<double, 3> to_a = s[0] - view.eye, to_b = s[1] - view.eye;
  std::array<double, 2> part{0, 1};
  for (const irg::vec<double, 3>& axis : {view.right, view.up})
    for (const double side : {-1.0, 1.0}) {
      const irg::vec<double, 3> inwards = view.forward * widest + axis * side;
      const double at_a = dot(inwards, to_a), at_b = dot(inwards, to_b);
      if (!(at_a > 0 || at_b > 0)) return std::nullopt;
      if (!(at_a > 0)) part[0] = std::max(part[0], at_a / (at_a - at_b));
      if (!(at_b > 0)) part[1] = std::min(part[1], at_a / (at_a - at_b));
    }
  return part[0] < part[1] ? std::optional(part) : std::nullopt;
}

// What is seen of segments, as lines, less than 63 degrees beside the middle: lines beside an eye over the surface would
// be as long as can be. From beside the surface all of them, where none is 85 degrees off.
std::vector<line_in_picture> lines_in_view(const irg::surface_camera& view, irg::grid_view kind,
                                           const std::vector<segment_in_space>& segments) {
  constexpr double wide = 12, usual = 2;
  const bool all = kind != irg::grid_view::front && std::ranges::all_of(segments, [&](const segment_in_space& s) {
                     return part_within(view, s, wide) == std::array{0.0, 1.0};
                   });
  std::vector<line_in_picture> lines;
  for (const segment_in_space& s : segments) {
    const auto part = part_within(view, s, all ? wide : usual);
    if (!part) continue;
    const auto at = [&](double t) { return view(t == 0 ? s[0] : t == 1 ? s[1] : s[0] + (s[1] - s[0]) * t); };
    const auto from = at((*part)[0]), to = at((*part)[1]);
    if (from && to) lines.push_back({*from, *to});
  }
  return lines;
}

void draw(const program::command_line& line, const settings& s, const scene& of,
          const std::vector<irg::grid_edge_part>& parts) {
  const irg::surface_camera view = irg::camera_on(irg::box_of_surface(of.surface()), of.eye);
  const auto point_at = [&](const irg::grid_edge_part& p, double t) {
    const auto height = [&](int i, int j) {
      return of.heights[static_cast<std::size_t>(i) * of.z.size() + static_cast<std::size_t>(j)];
    };
    const double y = height(p.i1, p.j1) * (1 - t) + height(p.i2, p.j2) * t;
    return irg::point<double, 3>{p.i1 + (p.i2 - p.i1) * t, y, p.j1 + (p.j2 - p.j1) * t};
  };
  std::vector<segment_in_space> segments;
  segments.reserve(parts.size());
  for (const irg::grid_edge_part& p : parts) segments.push_back({point_at(p, p.from), point_at(p, p.to)});
  const std::vector<line_in_picture> lines = lines_in_view(view, kind_of(of), segments);
  irg::point<double, 2> low{0, 0}, high{0, 0};
  for (const line_in_picture& l : lines)
    for (const auto& e : l) {
      const bool first = &e == lines.front().data();
      low = first ? e : irg::point<double, 2>{std::min(low.x, e.x), std::min(low.y, e.y)};
      high = first ? e : irg::point<double, 2>{std::max(high.x, e.x), std::max(high.y, e.y)};
    }
  const double wide = (high.x - low.x) / (0.9 * s.size.width), tall = (high.y - low.y) / (0.9 * s.size.height);
  const double unit = std::max(wide, tall) > 0 ? std::max(wide, tall) : 1;
  const auto place = [&](const irg::point<double, 2>& p) {
    return irg::point<double, 2>{s.size.width / 2.0 + (p.x - (low.x / 2 + high.x / 2)) / unit,
                                 s.size.height / 2.0 - (p.y - (low.y / 2 + high.y / 2)) / unit};
  };
  constexpr irg::rgba8 paper{250, 249, 246, 255}, ink{32, 44, 66, 255};
  if (irg::image_format_of_name(s.out) == irg::image_format::svg) {
    std::string text;
    auto sink = [&](std::string_view piece) { text += piece; };
    irg::svg_drawing drawing(sink, {s.size.width, s.size.height}, paper);
    drawing.begin_lines({ink, 1, 0});
    for (const auto& l : lines) drawing.add_line(place(l[0]), place(l[1]));
    drawing.finish();
    const auto* const bytes = reinterpret_cast<const std::uint8_t*>(text.data());
    if (const auto saved = irg::save_file(s.out, std::span<const std::uint8_t>(bytes, text.size())); !saved)
      line.fail(std::string(saved.error().message) + ": " + s.out);
    return;
  }
  irg::image<irg::rgba8> picture(s.size.width, s.size.height, paper);
  for (const auto& l : lines) irg::draw_line_aa(picture, place(l[0]), place(l[1]), ink);
  program::write_picture(line, s.out, picture);
}

void run(program::command_line& line) {
  const settings s = read_settings(line);
  std::vector<irg::grid_edge_part> parts;
  const scene of = read_scene(line, s.input, parts);
  std::sort(parts.begin(), parts.end(), part_comes_before);
  if (!s.out.empty()) draw(line, s, of, parts);
  if (s.list) {
    for (const irg::grid_edge_part& p : parts)
      std::printf("%d %d %d %d %s %s\n", p.i1, p.j1, p.i2, p.j2, program::shortest(p.from).c_str(),
                  program::shortest(p.to).c_str());
  } else if (s.order) {
    irg::visit_in_covering_order(irg::covering_loops(of.x, of.z, of.eye.x, of.eye.z),
                                 [](const irg::grid_facet& f) { std::printf("%d %d\n", f.i, f.j); });
  } else {
    static constexpr std::array names{"front", "side", "corner", "horizontal"};
    const auto kind = kind_of(of);
    std::printf("view: %s\nfacets: %zu\n", names[static_cast<std::size_t>(kind)],
                (of.x.size() - 1) * (of.z.size() - 1));
  }
  program::finish_output(line, s.out);
}

}  // namespace

int main(int argc, char** argv) { program::run_or_fail({argc, argv, "grid_surface", help}, "this many heights", run); }
