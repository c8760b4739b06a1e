// SPDX-License-Identifier: MIT
// vectors - the course's first exercise: sums, products and inverses of given vectors and matrices.
#include <cmath>
#include <cstdio>
#include <optional>
#include <string>

#include <irg/math/compensated.hpp>
#include <irg/math/length.hpp>
#include <irg/math/mat.hpp>
#include <irg/math/solve_exact.hpp>
#include <irg/math/vec.hpp>

#include "support/command_line.hpp"
#include "support/number_input.hpp"
#include "support/number_output.hpp"
#include "support/picture_options.hpp"
#include "support/run_or_fail.hpp"
#include "support/sketch.hpp"

namespace {

constexpr std::string_view help =
    R"(vectors - expressions of three vectors and two matrices

usage: vectors [options] <NUMBERS

Reads a, b, c, 3 numbers each, then A and B, 9 numbers each by rows, from standard input, and prints
  v1 = a + b,  s = v1 . b,  v2 = v1 x c,  v3 = v2 / |v2| (none when v2 is zero),  v4 = -v2,
  M1 = A + B,  M2 = A B^T,  M3 = A B^-1 (singular when B has no inverse, which is decided exactly).

  --example            take the course's values instead of reading any
  --input FILE         read the numbers from FILE
  --list               print the numbers alone, one result on a line
  -o OUT               draw a, b, c (grey), v1 (blue), v2 (red) and v4 (green) from the origin, seen from
                       x, y, z > 0 with z up: .png, .ppm or .svg
  --size WxH           pixels of the picture (640x480)
)";

using vec3 = irg::vec<double, 3>;
using mat3 = irg::mat<double, 3, 3>;

struct settings : program::drawing_options {
  bool example = false;
};

struct problem {
  vec3 a{2, 3, -4}, b{-1, 4, -1}, c{2, 2, 4};
  mat3 A{{{1, 2, 3}, {2, 1, 3}, {4, 5, 1}}}, B{{{-1, 2, -3}, {5, -2, 7}, {-4, -1, 3}}};
};

struct answers {
  vec3 v1, v2, v4;
  double s = 0;
  std::optional<vec3> v3;
  mat3 m1, m2;
  std::optional<mat3> m3;
};

settings read_settings(program::command_line& line) {
  settings s;
  while (!line.done()) {
    const std::string_view word = line.take();
    if (word == "--example")
      s.example = true;
    else
      s.read(line, word);
  }
  s.finish(line);
  if (s.example && !s.input.empty()) line.fail("either --example or --input, not both");
  return s;
}

problem read_problem(const program::command_line& line, const settings& s) {
  problem p;
  if (s.example) return p;
  program::number_input in(line, s.input);
  for (auto [name, v] : {std::pair{"a", &p.a}, std::pair{"b", &p.b}, std::pair{"c", &p.c}}) {
    program::number_input::prompt_if_terminal(std::string("x y z of ") + name + ": ", s.input);
    for (int i = 0; i < 3; ++i) (*v)[i] = in.number(std::string(1, "xyz"[i]) + " of " + name);
  }
  for (auto [name, m] : {std::pair{"A", &p.A}, std::pair{"B", &p.B}}) {
    program::number_input::prompt_if_terminal(std::string("9 numbers of ") + name + ", by rows: ", s.input);
    for (int i = 0; i < 9; ++i)
      (*m)(i / 3, i % 3) =
          in.number("row " + std::to_string(i / 3 + 1) + ", column " + std::to_string(i % 3 + 1) + " of " + name);
  }
  in.expect_end();
  return p;
}

vec3 row(const mat3& m, int r) { return {m(r, 0), m(r, 1), m(r, 2)}; }

// A B^-1 by rows: x B = (row of A), that is B^T x = (row of A).
std::optional<mat3> quotient(const program::command_line& line, const mat3& A, const mat3& B) {
  mat3 m;
  for (int r = 0; r < 3; ++r) {
    const auto x = irg::solve_exact(irg::transpose(B), row(A, r));
    if (x.status == irg::system_status::not_finite) line.fail("a number of M3 is too large");
    if (!x) return std::nullopt;
    for (int c = 0; c < 3; ++c) m(r, c) = x.x[c];
  }
  return m;
}

answers solve(const program::command_line& line, const problem& p) {
  answers r;
  const auto expect_finite = [&](const vec3& v, const char* name) {
    for (int i = 0; i < 3; ++i)
      if (!std::isfinite(v[i])) line.fail(std::string("a number of ") + name + " is too large");
  };
  r.v1 = p.a + p.b;
  expect_finite(r.v1, "v1");
  r.s = irg::dot_exact(r.v1, p.b);
  if (!std::isfinite(r.s)) line.fail("s is too large");
  r.v2 = irg::cross_accurate(r.v1, p.c);
  expect_finite(r.v2, "v2");
  r.v3 = irg::try_normalized(r.v2);
  r.v4 = -r.v2;
  r.m1 = p.A + p.B;
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k) r.m2(i, k) = irg::dot_exact(row(p.A, i), row(p.B, k));
  for (int i = 0; i < 3; ++i) expect_finite(row(r.m1, i), "M1"), expect_finite(row(r.m2, i), "M2");
  r.m3 = quotient(line, p.A, p.B);
  return r;
}

std::string report_of(const answers& r, bool list) {
  std::string text;
  const auto begin = [&](const char* name) { text += list ? std::string() : std::string(name) + ": "; };
  const auto number = [&](double v, bool last) { text += program::shortest(v) + (last ? "\n" : " "); };
  const auto vector = [&](const char* name, const std::optional<vec3>& v) {
    begin(name);
    if (!v) text += "none\n";
    for (int i = 0; v && i < 3; ++i) number((*v)[i], i == 2);
  };
  const auto matrix = [&](const char* name, const std::optional<mat3>& m) {
    begin(name);
    if (!m) text += "singular\n";
    for (int i = 0; m && i < 9; ++i) number((*m)(i / 3, i % 3), i == 8);
  };
  vector("v1", r.v1);
  begin("s");
  number(r.s, true);
  vector("v2", r.v2);
  vector("v3", r.v3);
  vector("v4", r.v4);
  matrix("M1", r.m1);
  matrix("M2", r.m2);
  matrix("M3", r.m3);
  return text;
}

irg::image<irg::rgba8> picture_of(const problem& p, const answers& r, const program::picture_size& size) {
  using program::sketch;
  sketch drawing;
  const sketch::point origin{};
  const auto arrow = [&](const vec3& v, irg::rgba8 colour) {
    drawing.line(origin, irg::to_point(v), colour);
    drawing.dot(irg::to_point(v), colour);
  };
  for (const vec3& v : {p.a, p.b, p.c}) arrow(v, sketch::grey);
  arrow(r.v4, sketch::green);
  arrow(r.v2, sketch::red);
  arrow(r.v1, sketch::blue);
  drawing.dot(origin, sketch::ink);
  return drawing.picture(size);
}

void run(program::command_line& line) {
  const settings s = read_settings(line);
  const problem p = read_problem(line, s);
  const answers r = solve(line, p);
  const std::string report = report_of(r, s.list);
  if (!s.out.empty()) program::write_picture(line, s.out, picture_of(p, r, s.size));
  std::fwrite(report.data(), 1, report.size(), stdout);
  program::finish_output(line, s.out);
}

}  // namespace

int main(int argc, char** argv) { program::run_or_fail({argc, argv, "vectors", help}, "this size", run); }
