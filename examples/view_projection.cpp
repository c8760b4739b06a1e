// SPDX-License-Identifier: MIT
// view_projection - the course's view transform and perspective projection of points or of a model's vertices.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <irg/geometry/compare.hpp>
#include <irg/math/error_free.hpp>
#include <irg/raster/draw_line.hpp>
#include <irg/raster/fill_span.hpp>
#include <irg/raster/image.hpp>
#include <irg/view/textbook/project_perspective.hpp>
#include <irg/view/textbook/view_transform.hpp>

#include "support/command_line.hpp"
#include "support/eye_inside.hpp"
#include "support/model_edges.hpp"
#include "support/model_input.hpp"
#include "support/number_input.hpp"
#include "support/number_output.hpp"
#include "support/picture_options.hpp"
#include "support/run_or_fail.hpp"

namespace {

constexpr std::string_view help =
    R"(view_projection - points in the eye's system and in the picture plane

usage: view_projection [MODEL] [options] <NUMBERS

Reads the eye x y z and the target x y z, then n and x y z of each of the n points, from standard input; with MODEL only
the eye and the target, the points are the model's vertices. z is up in the scene. The picture plane passes through the
target. Prints the view transform T and the projection P, 16 numbers by rows, for row vectors; H, the distance from eye
to target; then for every point its place in the eye's system (x right, y up, z ahead) and in the picture plane, or none
at and behind the eye and where a coordinate is beyond the largest number. Where the eye is inside a closed model, which
is meant to be seen from outside, a line on standard error says so.

  MODEL                a body as OBJ, STL, PLY, OFF or XML, or one of teapot, cube, sphere, torus
  --fit                move the model's centre to the origin and scale it until its longest side goes from -1 to 1
  --input FILE         read the numbers from FILE
  --list               print the places in the picture plane instead: x y, or none
  -o OUT               draw the points, joined in their order, or the model's wire frame: .png, .ppm or .svg
  --size WxH           pixels of the picture (640x480)
)";

using point = irg::point<double, 3>;
using place = std::optional<irg::point<double, 2>>;

struct settings : program::drawing_options {
  std::string model;
  bool fit = false;
};

settings read_settings(program::command_line& line) {
  settings s;
  while (!line.done()) {
    const std::string_view word = line.take();
    if (word.empty())
      line.fail("a model's name is empty");
    else if (word == "--fit")
      s.fit = true;
    else if (word[0] == '-')
      s.read(line, word);
    else if (s.model.empty())
      s.model = word;
    else
      line.fail("one model at a time, not also '" + std::string(word) + "'");
  }
  s.finish(line);
  if (s.fit && s.model.empty()) line.fail("option --fit needs a model");
  if (program::one_file(s.out, s.model)) line.fail("the model would be overwritten: " + s.model);
  return s;
}

using program::edge;

struct problem {
  point from, at;  // the eye and the target
  irg::mat<double, 4, 4> t, p;
  double h = 0;
  std::vector<point> eye;     // the points in the eye's system
  std::vector<place> screen;  // and in the picture plane
  std::vector<edge> edges;
};

point read_point(program::number_input& in, const std::string& of) {
  point p;
  for (int i = 0; i < 3; ++i) p[i] = in.number(std::string(1, "xyz"[i]) + " of " + of);
  return p;
}

// (p - eye) . (target - eye) / H with twice the digits of the sum.
double careful_depth(const problem& p, const point& scene) {
  double sum = 0, error = 0;
  for (int i = 0; i < 3; ++i) {
    const auto term = irg::two_product(scene[i] - p.from[i], p.at[i] - p.from[i]);
    const auto next = irg::two_sum(sum, term.value);
    sum = next.value;
    error += next.error + term.error;
  }
  return (sum + error) / p.h;
}

// Where the eye has a point. Rounding leaves the depth of a point beside the eye open; its sign is found exactly.
point seen_by_eye(const problem& p, const point& scene) {
  point seen = irg::textbook::transform_row(scene, p.t);
  double size = 0;
  for (int i = 0; i < 3; ++i) size += std::abs(scene[i]) / 8 + std::abs(p.from[i]) / 8;
  if (!(std::abs(seen.z) <= size * 0x1p-44)) return seen;
  const double careful = careful_depth(p, scene);
  if (std::isfinite(careful)) seen.z = careful;
  const int sign = irg::order_along_line(p.from, p.at, scene, p.from);
  if (sign == 0)
    seen.z = 0;
  else if (!(sign * seen.z > 0))  // too small for all that
    seen.z = sign * std::max(size * 0x1p-60, std::numeric_limits<double>::denorm_min());
  return seen;
}

// Adds a point; false when it leaves the range of numbers in the eye's system.
bool add(problem& p, const point& scene) {
  const point seen = seen_by_eye(p, scene);
  for (int i = 0; i < 3; ++i)
    if (!std::isfinite(seen[i])) return false;
  p.eye.push_back(seen);
  p.screen.push_back(irg::textbook::project_perspective(seen, p.h));
  return true;
}

void set_view(problem& p, const program::number_input& in, const point& eye, const point& target) {
  const auto steps = irg::textbook::view_transform_steps(eye, target);
  if (steps.status == irg::textbook::view_status::not_finite)
    in.fail_at_word("the eye or the target is too far out; coordinates may go up to a quarter of the largest number");
  if (steps.status == irg::textbook::view_status::eye_at_view_point)
    in.fail_at_word("the eye is at the target, so that there is no direction to look in");
  const auto projection = irg::textbook::perspective_matrix(steps.h);
  if (!projection) in.fail_at_word("the eye is too near the target, 1/H is beyond the largest number");
  p.from = eye;
  p.at = target;
  p.t = irg::textbook::view_transform(eye, target);
  p.p = *projection;
  p.h = steps.h;
}

problem read_problem(program::command_line& line, const settings& s) {
  using program::number_input;
  problem p;
  irg::mesh<double> model = s.model.empty() ? irg::mesh<double>{} : program::read_model(line, s.model);
  if (!s.model.empty() && model.positions.empty()) line.fail("the model has no vertices: " + s.model);
  if (s.fit) program::fit_model(line, model, s.model);
  number_input::prompt_if_terminal("x y z of the eye: ", s.input);
  number_input in(line, s.input);
  const point eye = read_point(in, "the eye");
  number_input::prompt_if_terminal("x y z of the target: ", s.input);
  const point target = read_point(in, "the target");
  set_view(p, in, eye, target);
  if (!s.model.empty()) {
    in.expect_end();
    for (const point& v : model.positions)
      if (!add(p, v))
        line.fail("vertex " + std::to_string(p.eye.size() + 1) + " is too far out to be seen: " + s.model);
    program::hint_if_inside(line, model, eye);
    if (!s.out.empty()) p.edges = program::edges_of(model);
    return p;
  }
  number_input::prompt_if_terminal("number of points: ", s.input);
  const int n = in.integer("n", 0);
  number_input::prompt_if_terminal("x y z of each point: ", s.input);
  for (int i = 0; i < n; ++i) {
    const std::string name = "point " + std::to_string(i + 1);
    if (!add(p, read_point(in, name))) in.fail_at_word(name + " is too far out to be seen");
  }
  in.expect_end();
  const auto count = static_cast<std::uint32_t>(n);
  for (std::uint32_t i = 0; i + 1 < count || (i < count && count > 2); ++i) p.edges.push_back({i, (i + 1) % count});
  return p;
}

// Where the picture shows a place of the picture plane: the places that there are fill it, but for a margin. Points next
// to the eye are seen far aside; where there are others, within 2 H of the target, the picture is theirs.
class canvas {
public:
  canvas(const problem& p, const program::picture_size& size) : size_(size) {
    const bool bounded = std::any_of(p.screen.begin(), p.screen.end(), [&](const place& q) { return is_near(q, p.h); });
    bool any = false;
    double low[2] = {}, high[2] = {};
    for (const place& q : p.screen) {
      if (!q || (bounded && !is_near(q, p.h))) continue;
      for (int i = 0; i < 2; ++i) {
        low[i] = any ? std::min(low[i], (*q)[i]) : (*q)[i];
        high[i] = any ? std::max(high[i], (*q)[i]) : (*q)[i];
      }
      any = true;
    }
    const double room[2] = {0.45 * size.width, 0.45 * size.height};
    for (int i = 0; i < 2; ++i) {
      middle_[i] = low[i] / 2 + high[i] / 2;
      half_ = std::max(half_, (high[i] / 2 - low[i] / 2) / room[i]);
    }
    if (!(half_ > 0)) half_ = 1;
  }

  // The pixel of a place; nothing when it is out of reach.
  std::optional<irg::cell> pixel(const place& q) const {
    if (!q) return std::nullopt;
    const double x = size_.width / 2.0 + (q->x - middle_[0]) / half_;
    const double y = size_.height / 2.0 - (q->y - middle_[1]) / half_;
    if (!(std::abs(x) <= 1e9) || !(std::abs(y) <= 1e9)) return std::nullopt;
    return irg::cell{static_cast<int>(std::floor(x)), static_cast<int>(std::floor(y))};
  }

private:
  static bool is_near(const place& q, double h) { return q && std::abs(q->x) / 2 <= h && std::abs(q->y) / 2 <= h; }

  program::picture_size size_;
  double middle_[2] = {}, half_ = 0;  // units of the picture plane a pixel
};

irg::image<irg::rgba8> picture_of(const problem& p, const program::picture_size& size, bool is_model) {
  constexpr irg::rgba8 paper{250, 249, 246, 255}, ink{32, 44, 66, 255}, red{204, 96, 72, 255};
  irg::image<irg::rgba8> out(size.width, size.height, paper);
  const canvas view(p, size);
  // Edges that pass the eye are cut a little nearer than the nearest point that is seen.
  double nearest = 0;
  for (std::size_t i = 0; i < p.eye.size(); ++i)
    if (p.screen[i]) nearest = nearest > 0 ? std::min(nearest, p.eye[i].z) : p.eye[i].z;
  const double cut = nearest / 2;
  const auto end_of = [&](std::uint32_t seen, std::uint32_t other) {
    const point &a = p.eye[seen], &b = p.eye[other];
    if (p.screen[seen] && a.z >= cut) return view.pixel(p.screen[seen]);
    const double s = (cut / 2 - b.z / 2) / (a.z / 2 - b.z / 2);  // from b, where it is seen
    const point on{b.x + s * (a.x - b.x), b.y + s * (a.y - b.y), cut};
    return view.pixel(irg::textbook::project_perspective(on, p.h));
  };
  for (const auto& [a, b] : p.edges) {
    if (!p.screen[a] && !p.screen[b]) continue;
    const auto from = end_of(a, b), to = end_of(b, a);
    if (from && to) irg::draw_line(out, *from, *to, ink);
  }
  const int reach = is_model ? 0 : 3;
  for (const place& q : p.screen)
    if (const auto c = view.pixel(q))
      for (int y = c->y - reach; y <= c->y + reach; ++y)
        irg::fill_span(out, {y, c->x - reach, c->x + reach + 1}, is_model ? ink : red);
  return out;
}

void append(std::string& text, const char* name, std::initializer_list<double> numbers) {
  text += name;
  for (const double v : numbers) text += " " + program::shortest(v);
  text += "\n";
}

std::string report_of(const problem& p, bool list) {
  std::string text;
  const auto by_rows = [&](const char* name, const irg::mat<double, 4, 4>& m) {
    text += name;
    for (const auto& row : m.m)
      for (const double v : row) text += " " + program::shortest(v);
    text += "\n";
  };
  if (!list) {
    by_rows("T:", p.t);
    by_rows("P:", p.p);
    append(text, "H:", {p.h});
  }
  for (std::size_t i = 0; i < p.eye.size(); ++i) {
    const place& q = p.screen[i];
    if (list) {
      text += q ? program::shortest(q->x) + " " + program::shortest(q->y) + "\n" : "none\n";
      continue;
    }
    append(text, "eye:", {p.eye[i].x, p.eye[i].y, p.eye[i].z});
    if (q)
      append(text, "screen:", {q->x, q->y});
    else
      text += "screen: none\n";
  }
  return text;
}

void run(program::command_line& line) {
  const settings s = read_settings(line);
  const problem p = read_problem(line, s);
  const std::string report = report_of(p, s.list);  // whole before anything is written: memory may end
  if (!s.out.empty()) program::write_picture(line, s.out, picture_of(p, s.size, !s.model.empty()));
  std::fwrite(report.data(), 1, report.size(), stdout);
  program::finish_output(line, s.out);
}

}  // namespace

int main(int argc, char** argv) {
  program::run_or_fail({argc, argv, "view_projection", help}, "these points and this size", run);
}
