// SPDX-License-Identifier: MIT
// linear_system - three linear equations for x, y and z: their solution, or why there is none.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string>

#include <irg/math/solve_exact.hpp>

#include "support/command_line.hpp"
#include "support/number_input.hpp"
#include "support/number_output.hpp"
#include "support/picture_options.hpp"
#include "support/run_or_fail.hpp"
#include "support/sketch.hpp"

namespace {

constexpr std::string_view help =
    R"(linear_system - solves a x + b y + c z = d, three times

usage: linear_system [options] <NUMBERS

Reads three rows of four numbers a b c d from standard input, and prints the solution, each number correctly rounded; or
  singular: dependent       infinitely many solutions
  singular: inconsistent    none
which is decided exactly for the numbers as they are read.

  --input FILE         read the numbers from FILE
  --list               print the three numbers alone, or the one word
  -o OUT               draw the planes of the three equations (blue, green, grey) in a box around the
                       solution (red), seen from x, y, z > 0 with z up: .png, .ppm or .svg
  --size WxH           pixels of the picture (640x480)
)";

using equations = irg::mat<double, 3, 4>;
using solution = irg::system_solution<double, 3>;
using point = irg::point<double, 3>;

program::drawing_options read_settings(program::command_line& line) {
  program::drawing_options s;
  while (!line.done()) s.read(line, line.take());
  s.finish(line);
  return s;
}

equations read_equations(const program::command_line& line, const std::string& input) {
  equations e;
  program::number_input in(line, input);
  for (int r = 0; r < 3; ++r) {
    const std::string row = std::to_string(r + 1);
    program::number_input::prompt_if_terminal("a b c d of row " + row + ": ", input);
    for (int c = 0; c < 4; ++c) e(r, c) = in.number(std::string(1, "abcd"[c]) + " of row " + row);
  }
  in.expect_end();
  return e;
}

std::string report_of(const solution& s, bool list) {
  if (!s) {
    const char* const why = s.status == irg::system_status::dependent ? "dependent" : "inconsistent";
    return std::string(list ? "" : "singular: ") + why + "\n";
  }
  return std::string(list ? "" : "solution: ") + program::shortest(s.x[0]) + " " + program::shortest(s.x[1]) + " " +
         program::shortest(s.x[2]) + "\n";
}

// The edges of a cube of half side h around the origin, as pairs of corners.
std::array<std::array<point, 2>, 12> cube_edges(double h) {
  std::array<std::array<point, 2>, 12> edges;
  for (std::size_t i = 0; i < 12; ++i) {
    const int axis = static_cast<int>(i / 4), u = (axis + 1) % 3, v = (axis + 2) % 3;
    point from;
    from[axis] = -h;
    from[u] = i % 2 == 0 ? -h : h;
    from[v] = i % 4 < 2 ? -h : h;
    point to = from;
    to[axis] = h;
    edges[i] = {from, to};
  }
  return edges;
}

// The part of the plane n . p = d within the cube, as chords of its sides.
void draw_plane(program::sketch& drawing, const irg::vec<double, 3>& n, double d, double h, irg::rgba8 colour) {
  for (int axis = 0; axis < 3; ++axis)
    for (const double side : {-h, h}) {  // on the cube's side p[axis] = side, a line
      const int u = (axis + 1) % 3, v = (axis + 2) % 3;
      const double rest = d - n[axis] * side;
      std::array<point, 4> ends{};
      std::size_t count = 0;
      const auto add = [&](double pu, double pv) {
        if (!(std::abs(pu) <= h && std::abs(pv) <= h) || count == ends.size()) return;
        point& p = ends[count++];
        p[axis] = side, p[u] = pu, p[v] = pv;
      };
      for (const double border : {-h, h}) {
        if (n[v] != 0) add(border, (rest - n[u] * border) / n[v]);
        if (n[u] != 0) add((rest - n[v] * border) / n[u], border);
      }
      for (std::size_t i = 1; i < count; ++i)
        if (!(ends[0] == ends[i])) drawing.line(ends[0], ends[i], colour);
    }
}

irg::image<irg::rgba8> picture_of(const equations& e, const solution& s, const program::picture_size& size) {
  using program::sketch;
  constexpr irg::rgba8 colours[] = {sketch::blue, sketch::green, {120, 122, 128, 255}};
  sketch drawing;
  constexpr double h = 1;
  for (const auto& [from, to] : cube_edges(h)) drawing.line(from, to, {224, 224, 222, 255});
  // The cube is as large as what is to be seen: twice the farthest plane's distance from a centre that is no solution.
  double reach = s ? 1 : 0;
  struct {
    irg::vec<double, 3> n;
    double d;
  } planes[3];
  for (int r = 0; r < 3; ++r) {
    const double scale = std::max({std::abs(e(r, 0)), std::abs(e(r, 1)), std::abs(e(r, 2))});
    planes[r] = {};
    if (scale == 0) continue;
    for (int c = 0; c < 3; ++c) planes[r].n[c] = e(r, c) / scale;
    if (!s) planes[r].d = e(r, 3) / scale;
    if (std::isfinite(planes[r].d)) reach = std::max(reach, 2 * std::abs(planes[r].d));
  }
  if (reach == 0) reach = 1;
  for (int r = 0; r < 3; ++r) draw_plane(drawing, planes[r].n, planes[r].d / reach, h, colours[r]);
  if (s) drawing.dot(point{}, sketch::red);
  return drawing.picture(size);
}

void run(program::command_line& line) {
  const program::drawing_options s = read_settings(line);
  const equations e = read_equations(line, s.input);
  const solution answer = irg::solve_exact(e);
  if (answer.status == irg::system_status::not_finite) line.fail("a number of the solution is too large");
  const std::string report = report_of(answer, s.list);
  if (!s.out.empty()) program::write_picture(line, s.out, picture_of(e, answer, s.size));
  std::fwrite(report.data(), 1, report.size(), stdout);
  program::finish_output(line, s.out);
}

}  // namespace

int main(int argc, char** argv) { program::run_or_fail({argc, argv, "linear_system", help}, "this size", run); }
