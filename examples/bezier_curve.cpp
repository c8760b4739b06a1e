// SPDX-License-Identifier: MIT
// bezier_curve - points of a Bezier curve, by Bernstein polynomials or by edge vectors and Bezier's own weights.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <span>
#include <string>
#include <vector>

#include <irg/curve/bezier_edge_form.hpp>
#include <irg/math/double_double.hpp>

#include "support/command_line.hpp"
#include "support/number_input.hpp"
#include "support/number_output.hpp"
#include "support/picture_options.hpp"
#include "support/run_or_fail.hpp"
#include "support/sketch.hpp"

namespace {

constexpr std::string_view help =
    R"(bezier_curve - the points of a Bezier curve at equal steps of its parameter

usage: bezier_curve [options] <NUMBERS

Reads the degree n and the n + 1 control points, 3 numbers each, from standard input, and prints
  points: N            how many parameters t = k * step there are, from 0 on while t is at most 1

  --step S             the step, over 0 and at most 1 (0.01)
  --form bernstein     control points times Bernstein polynomials (default)
  --form bezier        edge vectors times Bezier's weights; the same curve
  --input FILE         read the numbers from FILE
  --list               print a line t x y z for each parameter instead
  -o OUT               draw the control polygon and the curve: .png, .ppm or .svg
  --size WxH           pixels of the picture (640x480)
)";

using point = irg::point<double, 3>;
using wide = irg::double_double;
using wide_vector = irg::vec<wide, 3>;

struct settings : program::drawing_options {
  double step = 0.01;
  bool by_edges = false;
};

settings read_settings(program::command_line& line) {
  settings s;
  while (!line.done()) {
    const std::string_view word = line.take();
    if (word == "--step") {
      s.step = line.numbers(word, 1)[0];
      if (!(s.step > 0 && s.step <= 1)) line.fail("option --step needs a number over 0 and at most 1");
      if (s.step < 0x1p-52) line.fail("option --step is so little that k * step has no place for k");
    } else if (word == "--form") {
      s.by_edges = line.choice(word, {"bernstein", "bezier"}) == 1;
    } else {
      s.read(line, word);
    }
  }
  s.finish(line);
  return s;
}

std::vector<point> read_points(const program::command_line& line, const std::string& input) {
  program::number_input in(line, input);
  program::number_input::prompt_if_terminal("degree n: ", input);
  const int n = in.integer("n", 0);
  std::vector<point> points;
  for (int k = 0; k <= n; ++k) {
    const std::string name = "point " + std::to_string(k);
    program::number_input::prompt_if_terminal("x y z of " + name + ": ", input);
    point p{};
    for (int i = 0; i < 3; ++i) p[i] = in.number(std::string(1, "xyz"[i]) + " of " + name);
    points.push_back(p);
  }
  in.expect_end();
  return points;
}

double parameter(std::int64_t k, double step) { return static_cast<double>(k) * step; }

// How many k from 0 on have k * step, in doubles, at most 1.
std::int64_t parameters_of(double step) {
  auto k = static_cast<std::int64_t>(1 / step);
  while (parameter(k, step) > 1) --k;
  while (parameter(k + 1, step) <= 1) ++k;
  return k + 1;
}

// The curve in one of its forms, in twice the precision, so that the result is as good as the numbers that were read.
class curve {
public:
  curve(const std::vector<point>& points, bool by_edges) : by_edges_(by_edges), weights_(points.size()) {
    double largest = 0;
    for (const point& p : points)
      for (int i = 0; i < 3; ++i) largest = std::max(largest, std::abs(p[i]));
    // Edges may be twice as long as the largest number, and sums of them longer still.
    scale_ = largest > 0x1p900 ? 0x1p-100 : 1;
    for (const point& p : points) vectors_.push_back({wide(p.x * scale_), wide(p.y * scale_), wide(p.z * scale_)});
    if (!by_edges_) return;
    const std::vector<wide_vector> positions = vectors_;
    irg::edges_of_control_polygon(positions, vectors_);
  }

  point at(double t) {
    const irg::curve_parameter<wide> where{wide(t)};
    const std::span<wide> weights(weights_);
    by_edges_ ? irg::bezier_weights(where, weights) : irg::bernstein_basis(where, weights);
    wide_vector sum{};
    for (std::size_t i = 0; i < vectors_.size(); ++i) sum = sum + vectors_[i] * weights_[i];
    return {sum.x.high / scale_, sum.y.high / scale_, sum.z.high / scale_};
  }

private:
  bool by_edges_;
  double scale_ = 1;
  std::vector<wide_vector> vectors_;
  std::vector<wide> weights_;
};

irg::image<irg::rgba8> picture_of(curve& c, const std::vector<point>& points, const settings& s) {
  using program::sketch;
  sketch drawing;
  const bool flat = std::all_of(points.begin(), points.end(), [](const point& p) { return p.z == 0; });
  const auto line = [&](const point& a, const point& b, irg::rgba8 colour) {
    flat ? drawing.line(sketch::place{a.x, a.y}, sketch::place{b.x, b.y}, colour) : drawing.line(a, b, colour);
  };
  for (std::size_t k = 1; k < points.size(); ++k) line(points[k - 1], points[k], sketch::grey);
  for (const point& p : points)
    flat ? drawing.dot(sketch::place{p.x, p.y}, sketch::blue) : drawing.dot(p, sketch::blue);
  // No picture shows more pieces than it has pixels in a row.
  const std::int64_t count = parameters_of(s.step), every = 1 + count / 65536;
  point last = c.at(0);
  for (std::int64_t k = every; k < count; k += every) {
    const point next = c.at(parameter(k, s.step));
    line(last, next, sketch::red);
    last = next;
  }
  return drawing.picture(s.size);
}

void print_list(curve& c, double step) {
  const std::int64_t count = parameters_of(step);
  for (std::int64_t k = 0; k < count; ++k) {
    const double t = parameter(k, step);
    const point p = c.at(t);
    std::string text = program::shortest(t);
    for (int i = 0; i < 3; ++i) text += " " + program::shortest(p[i]);
    std::puts(text.c_str());
    if (std::ferror(stdout) != 0) return;
  }
}

void run(program::command_line& line) {
  const settings s = read_settings(line);
  const std::vector<point> points = read_points(line, s.input);
  curve c(points, s.by_edges);
  if (!s.out.empty()) program::write_picture(line, s.out, picture_of(c, points, s));
  if (s.list)
    print_list(c, s.step);
  else
    std::printf("points: %lld\n", static_cast<long long>(parameters_of(s.step)));
  program::finish_output(line, s.out);
}

}  // namespace

int main(int argc, char** argv) {
  program::run_or_fail({argc, argv, "bezier_curve", help}, "so many control points or this size", run);
}
