// SPDX-License-Identifier: MIT
// barycentric - the barycentric coordinates of a point in a triangle in space, by the course's matrix and robustly.
#include <cmath>
#include <cstdio>
#include <optional>
#include <string>

#include <irg/geometry/barycentric.hpp>
#include <irg/geometry/textbook/barycentric.hpp>

#include "support/command_line.hpp"
#include "support/number_input.hpp"
#include "support/number_output.hpp"
#include "support/picture_options.hpp"
#include "support/run_or_fail.hpp"
#include "support/sketch.hpp"

namespace {

constexpr std::string_view help =
    R"(barycentric - the weights of a triangle's corners that give a point

usage: barycentric [options] <NUMBERS

Reads the corners A, B, C and the point T, 3 numbers each, from standard input, and prints
  direct: t1 t2 t3     the solution of t1 A + t2 B + t3 C = T, or singular (the triangle's plane contains
                       the origin, or the triangle has no area)
  robust: t1 t2 t3     the same with t1 + t2 + t3 = 1, T moved into the triangle's plane along the axis of
                       the largest component of its normal; or degenerate, and no more lines
  in_plane: yes or no  whether T is in the plane of the triangle
  where: inside, edge, vertex or outside, of the moved T
All decisions are exact for the numbers as they are read.

  --input FILE         read the numbers from FILE
  --list               print the robust coordinates alone, or degenerate
  -o OUT               draw the triangle and T (red) as seen along that axis: .png, .ppm or .svg
  --size WxH           pixels of the picture (640x480)
)";

using point = irg::point<double, 3>;
using coordinates = std::optional<irg::vec<double, 3>>;

struct problem {
  point a, b, c, t;
};

program::drawing_options read_settings(program::command_line& line) {
  program::drawing_options s;
  while (!line.done()) s.read(line, line.take());
  s.finish(line);
  return s;
}

problem read_problem(const program::command_line& line, const std::string& input) {
  problem p;
  program::number_input in(line, input);
  for (auto [name, corner] : {std::pair{"A", &p.a}, std::pair{"B", &p.b}, std::pair{"C", &p.c}, std::pair{"T", &p.t}}) {
    program::number_input::prompt_if_terminal(std::string("x y z of ") + name + ": ", input);
    for (int i = 0; i < 3; ++i) (*corner)[i] = in.number(std::string(1, "xyz"[i]) + " of " + name);
  }
  in.expect_end();
  return p;
}

std::string numbers_of(const program::command_line& line, const coordinates& t, const char* without) {
  if (!t) return std::string(without) + "\n";
  std::string text;
  for (int i = 0; i < 3; ++i) {
    if (!std::isfinite((*t)[i])) line.fail("a coordinate is too large");
    text += program::shortest((*t)[i]) + (i < 2 ? " " : "\n");
  }
  return text;
}

std::string report_of(const program::command_line& line, const problem& p, bool list) {
  std::string robust = numbers_of(line, irg::barycentric(p.a, p.b, p.c, p.t), "degenerate");
  if (list) return robust;
  const coordinates direct = irg::textbook::barycentric_direct(p.a, p.b, p.c, p.t);
  if (!direct && irg::orient3d(p.a, p.b, p.c, point{}) != 0) line.fail("a coordinate is too large");
  std::string text = "direct: " + numbers_of(line, direct, "singular") + "robust: " + robust;
  const auto place = irg::locate_in_triangle(p.a, p.b, p.c, p.t);
  if (!place) return text;
  const char* const parts[] = {"outside", "inside", "edge", "vertex"};
  text += std::string("in_plane: ") + (place->in_plane ? "yes" : "no");
  return text + "\nwhere: " + parts[static_cast<int>(place->where)] + "\n";
}

irg::image<irg::rgba8> picture_of(const problem& p, const program::picture_size& size) {
  using program::sketch;
  sketch drawing;
  const int axis = irg::dropped_axis(p.a, p.b, p.c).value_or(2);
  const int u = axis == 0 ? 1 : 0, v = axis == 2 ? 1 : 2;
  const auto seen = [&](const point& q) { return sketch::place{q[u], q[v]}; };
  for (const point* corner : {&p.a, &p.b, &p.c}) drawing.line(seen(p.t), seen(*corner), sketch::grey);
  drawing.line(seen(p.a), seen(p.b), sketch::ink);
  drawing.line(seen(p.b), seen(p.c), sketch::ink);
  drawing.line(seen(p.c), seen(p.a), sketch::ink);
  for (const point* corner : {&p.a, &p.b, &p.c}) drawing.dot(seen(*corner), sketch::ink);
  drawing.dot(seen(p.t), sketch::red);
  return drawing.picture(size);
}

void run(program::command_line& line) {
  const program::drawing_options s = read_settings(line);
  const problem p = read_problem(line, s.input);
  const std::string report = report_of(line, p, s.list);
  if (!s.out.empty()) program::write_picture(line, s.out, picture_of(p, s.size));
  std::fwrite(report.data(), 1, report.size(), stdout);
  program::finish_output(line, s.out);
}

}  // namespace

int main(int argc, char** argv) { program::run_or_fail({argc, argv, "barycentric", help}, "this size", run); }
