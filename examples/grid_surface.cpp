// SPDX-License-Identifier: MIT
// grid_surface - a surface over a grid without the lines that it hides, decided exactly.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string>
#include <tuple>
#include <vector>

#include <irg/hidden/grid_surface.hpp>
#include <irg/raster/line_aa.hpp>

#include "support/command_line.hpp"
#include "support/number_input.hpp"
#include "support/number_output.hpp"
#include "support/picture_options.hpp"
#include "support/run_or_fail.hpp"

namespace {

constexpr std::string_view help =
    R"(grid_surface - a surface over a grid without the lines that it hides

Reads n and m, both at least 1, then (n+1)(m+1) heights y[i][j] at x = i, z = j with i outer and j inner, then the eye:
x y z. Numbers are separated by white space; # begins a comment. Prints how the surface is seen (front, side, corner or
horizontal) and how many facets it has.

  --order        print the facets in covering order instead, those that can hide first: i j, from 1
  --list         print the parts of grid edges that are seen instead: i1 j1 i2 j2 t0 t1, points from 0, t along the edge
  --input FILE   read the numbers from FILE instead of standard input
  -o OUT         draw what is seen: .png, .ppm or .svg
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

// What the eye sees, turned to the middle of the surface, upright edges upright.
class camera {
public:
  explicit camera(const scene& s) : eye_(s.eye) {
    const auto [low, high] = std::minmax_element(s.heights.begin(), s.heights.end());
    const irg::vec<double, 3> to{s.x.back() / 2 - eye_.x, *low / 2 + *high / 2 - eye_.y, s.z.back() / 2 - eye_.z};
    forward_ = scaled(to);
    right_ = scaled({forward_.z, 0, -forward_.x});
    if (!(std::abs(right_.x) + std::abs(right_.z) > 0)) right_ = {1, 0, 0};
    up_ = {forward_.y * right_.z, forward_.z * right_.x - forward_.x * right_.z, -forward_.y * right_.x};
  }
  // Right and up in the plane at distance 1; `ahead` is false for points that are not before the eye.
  irg::point<double, 2> seen(const irg::point<double, 3>& p, bool& ahead) const {
    const irg::vec<double, 3> d{p.x - eye_.x, p.y - eye_.y, p.z - eye_.z};
    const double depth = along(d, forward_);
    ahead = depth > 0;
    return {along(d, right_) / depth, along(d, up_) / depth};
  }

private:
  static double along(const irg::vec<double, 3>& a, const irg::vec<double, 3>& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
  }
  static irg::vec<double, 3> scaled(const irg::vec<double, 3>& v) {
    const double size = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
    if (!(size > 0)) return {0, 0, 0};
    const double length = std::hypot(v.x / size, v.y / size, v.z / size);
    return {v.x / size / length, v.y / size / length, v.z / size / length};
  }
  irg::point<double, 3> eye_;
  irg::vec<double, 3> forward_{}, right_{}, up_{};
};

void draw(const program::command_line& line, const settings& s, const scene& of,
          const std::vector<irg::grid_edge_part>& parts) {
  const camera view(of);
  const auto point_at = [&](const irg::grid_edge_part& p, double t) {
    const auto height = [&](int i, int j) {
      return of.heights[static_cast<std::size_t>(i) * of.z.size() + static_cast<std::size_t>(j)];
    };
    const double y = height(p.i1, p.j1) * (1 - t) + height(p.i2, p.j2) * t;
    return irg::point<double, 3>{p.i1 + (p.i2 - p.i1) * t, y, p.j1 + (p.j2 - p.j1) * t};
  };
  std::vector<std::array<irg::point<double, 2>, 2>> lines;
  irg::point<double, 2> low{0, 0}, high{0, 0};
  for (const irg::grid_edge_part& p : parts) {
    bool ahead[2];
    const std::array ends{view.seen(point_at(p, p.from), ahead[0]), view.seen(point_at(p, p.to), ahead[1])};
    if (!ahead[0] || !ahead[1]) continue;
    bool usable = true;
    for (const auto& e : ends) usable = usable && std::abs(e.x) < 1e100 && std::abs(e.y) < 1e100;
    if (!usable) continue;
    for (const auto& e : ends) {
      const bool first = lines.empty() && &e == ends.data();
      low = first ? e : irg::point<double, 2>{std::min(low.x, e.x), std::min(low.y, e.y)};
      high = first ? e : irg::point<double, 2>{std::max(high.x, e.x), std::max(high.y, e.y)};
    }
    lines.push_back(ends);
  }
  const double wide = (high.x - low.x) / (0.9 * s.size.width), tall = (high.y - low.y) / (0.9 * s.size.height);
  const double unit = std::max(wide, tall) > 0 ? std::max(wide, tall) : 1;
  const auto place = [&](const irg::point<double, 2>& p) {
    return irg::point<double, 2>{s.size.width / 2.0 + (p.x - (low.x / 2 + high.x / 2)) / unit,
                                 s.size.height / 2.0 - (p.y - (low.y / 2 + high.y / 2)) / unit};
  };
  irg::image<irg::rgba8> picture(s.size.width, s.size.height, irg::rgba8{250, 249, 246, 255});
  for (const auto& l : lines) irg::draw_line_aa(picture, place(l[0]), place(l[1]), irg::rgba8{32, 44, 66, 255});
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
    const auto kind = irg::grid_view_from(of.x, of.z, of.eye.x, of.eye.y, of.eye.z);
    std::printf("view: %s\nfacets: %zu\n", names[static_cast<std::size_t>(kind)],
                (of.x.size() - 1) * (of.z.size() - 1));
  }
  program::finish_output(line, s.out);
}

}  // namespace

int main(int argc, char** argv) { program::run_or_fail({argc, argv, "grid_surface", help}, "this many heights", run); }
