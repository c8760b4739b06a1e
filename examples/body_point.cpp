// SPDX-License-Identifier: MIT
// body_point - where points lie against a body, and the planes of its faces.
#include <cstdint>
#include <cstdio>
#include <optional>
#include <string>
#include <vector>

#include <irg/geometry/plane_through_points.hpp>
#include <irg/geometry/point_on_triangle.hpp>
#include <irg/mesh/convex_body.hpp>
#include <irg/mesh/triangulate.hpp>
#include <irg/solid/solid_locator.hpp>

#include "support/command_line.hpp"
#include "support/model_edges.hpp"
#include "support/model_input.hpp"
#include "support/number_input.hpp"
#include "support/number_output.hpp"
#include "support/picture_options.hpp"
#include "support/run_or_fail.hpp"
#include "support/sketch.hpp"

namespace {

constexpr std::string_view help =
    R"(body_point - where points lie against a body

usage: body_point MODEL [options] <POINTS

Reads points, x y z each, from standard input until its end; there may be none. Prints for each whether it is inside of
the body, on its boundary or outside, decided exactly for closed bodies whose faces run counter-clockwise seen from
outside; then whether the body is convex and whether it is closed. Faces that are not plane are the triangles they are
cut into.

  MODEL                a body as OBJ, STL, PLY, OFF or XML, or one of teapot, cube, sphere, torus
  --input FILE         read the points from FILE
  --list               print the planes of the faces instead, A B C D of A x + B y + C z + D = 0 in the order of the file:
                       through the first three corners that are not on a line (0 0 0 0 where there are none), not
                       normalised; multiplied by one power of two where they are beyond the range of numbers
  -o OUT               draw the body's wire frame with z = 0, and the points: green inside, blue on the boundary, red
                       outside: .png, .ppm or .svg
  --size WxH           pixels of the picture (640x480)
)";

using point = irg::point<double, 3>;

struct settings : program::drawing_options {
  std::string model;
};

settings read_settings(program::command_line& line) {
  settings s;
  while (!line.done()) {
    const std::string_view word = line.take();
    if (word.empty())
      line.fail("a model's name is empty");
    else if (word[0] == '-')
      s.read(line, word);
    else if (s.model.empty())
      s.model = word;
    else
      line.fail("one model at a time, not also '" + std::string(word) + "'");
  }
  if (s.model.empty()) line.fail("no model given; --help tells how");
  s.finish(line);
  if (program::one_file(s.out, s.model)) line.fail("the model would be overwritten: " + s.model);
  return s;
}

std::vector<point> read_points(const program::command_line& line, const settings& s) {
  using program::number_input;
  number_input::prompt_if_terminal("x y z of each point: ", s.input);
  number_input in(line, s.input);
  std::vector<point> points;
  while (!in.at_end()) {
    const std::string of = " of point " + std::to_string(points.size() + 1);
    point p;
    for (int i = 0; i < 3; ++i) p[i] = in.number(std::string(1, "xyz"[i]) + of);
    points.push_back(p);
  }
  return points;
}

// The plane through the first three corners that are not on a line, first by the first, then by the second.
std::optional<irg::plane<double>> plane_of_face(const irg::mesh<double>& m, std::size_t f) {
  const std::size_t n = m.face_size(f);
  const auto at = [&](std::size_t k) { return m.positions[m.corner(f, k).position]; };
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = i + 1; j < n; ++j) {
      if (at(i) == at(j)) continue;
      for (std::size_t k = j + 1; k < n; ++k)
        if (!irg::are_collinear(at(i), at(j), at(k))) return irg::plane_through_accurate(at(i), at(j), at(k));
      return std::nullopt;  // all further corners are on the line through these two, and those between equal the first
    }
  return std::nullopt;
}

std::string planes_of(const irg::mesh<double>& m) {
  std::string text;
  for (std::size_t f = 0; f < m.face_count(); ++f) {
    const auto found = plane_of_face(m, f).value_or(irg::plane<double>{0, 0, 0, 0});
    text += program::shortest(found.a) + " " + program::shortest(found.b) + " " + program::shortest(found.c) + " " +
            program::shortest(found.d) + "\n";
  }
  return text;
}

const char* name_of(irg::location where) {
  switch (where) {
    case irg::location::inside: return "inside";
    case irg::location::boundary: return "boundary";
    default: return "outside";
  }
}

program::sketch sketch_of(const irg::mesh<double>& m, const std::vector<point>& points,
                          const std::vector<irg::location>& where) {
  using program::sketch;
  sketch s;
  const auto flat = [](const point& p) { return sketch::place{p.x, p.y}; };
  for (const auto& [a, b] : program::edges_of(m))
    if (flat(m.positions[a]) != flat(m.positions[b])) s.line(flat(m.positions[a]), flat(m.positions[b]), sketch::ink);
  for (std::size_t i = 0; i < points.size(); ++i)
    s.dot(flat(points[i]), where[i] == irg::location::inside     ? sketch::green
                           : where[i] == irg::location::boundary ? sketch::blue
                                                                 : sketch::red);
  return s;
}

void run(program::command_line& line) {
  const settings s = read_settings(line);
  const irg::mesh<double> model = program::read_model(line, s.model);
  if (model.face_count() == 0) line.fail("the model has no faces: " + s.model);
  const std::vector<point> points = read_points(line, s);
  const irg::solid_locator locate(model);
  std::vector<irg::location> where;
  where.reserve(points.size());
  for (const point& p : points) where.push_back(locate(p));
  std::string report;
  if (s.list) {
    report = planes_of(model);
  } else {
    for (const irg::location w : where) report += std::string("point: ") + name_of(w) + "\n";
    const bool convex = irg::is_convex_body(model) || irg::is_convex_body(irg::triangulated(model));
    report += std::string("convex: ") + (convex ? "yes\n" : "no\n");
    report += std::string("closed: ") + (irg::is_closed(model) ? "yes\n" : "no\n");
  }
  if (!s.out.empty()) program::write_picture(line, s.out, sketch_of(model, points, where).picture(s.size));
  std::fwrite(report.data(), 1, report.size(), stdout);
  program::finish_output(line, s.out);
}

}  // namespace

int main(int argc, char** argv) {
  program::run_or_fail({argc, argv, "body_point", help}, "this model and these points", run);
}
