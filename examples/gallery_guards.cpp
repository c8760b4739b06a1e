// SPDX-License-Identifier: MIT
// gallery_guards - guards on the corners of a plan who see all of it, with the proof.
#include <cstdio>
#include <string>
#include <vector>

#include <irg/visibility/guard_cover.hpp>

#include "support/command_line.hpp"
#include "support/number_input.hpp"
#include "support/number_output.hpp"
#include "support/run_or_fail.hpp"
#include "support/sketch.hpp"

namespace {

constexpr std::string_view help =
    R"(gallery_guards - guards on the corners of a plan who together see all of it

usage: gallery_guards [options] <PLAN

Reads the number of rings, then for each the number of its corners and x y of each corner, from standard input. A ring
inside another one is a hole. There may be up to 100 corners. Prints how many guards were chosen, how many are needed at
least, into how many parts the plan falls, and x y of each guard.

  --input FILE         read the numbers from FILE
  --list               print the proof instead: per part x y of the guard who sees it, then x y of each of its corners
  -o OUT               draw plan, parts and guards: .png, .ppm or .svg
  --size WxH           pixels of the picture (640x480)
)";

using point = irg::point<double, 2>;
using plan = std::vector<std::vector<point>>;

plan read_plan(const program::command_line& line, const program::drawing_options& s) {
  using program::number_input;
  number_input::prompt_if_terminal("number of rings, then for each n and n times x y: ", s.input);
  number_input in(line, s.input);
  constexpr int most = 100;
  plan out;
  int corners = 0;
  for (int rings = in.integer("the number of rings", 0, most); rings > 0; --rings) {
    const int n = in.integer("the number of corners", 0, most);
    corners += n;
    if (corners > most) in.fail_at_word("there are more than 100 corners");
    out.emplace_back();
    for (int i = 0; i < n; ++i) {
      const double x = in.number("x of corner " + std::to_string(i + 1));
      out.back().push_back({x, in.number("y of corner " + std::to_string(i + 1))});
    }
  }
  in.expect_end();
  return out;
}

void draw(const program::command_line& line, const program::drawing_options& s, const plan& rings,
          const irg::guard_cover<double>& cover, const std::vector<point>& corners) {
  program::sketch drawing;
  const auto outline = [&](const std::vector<point>& ring, irg::rgba8 colour) {
    for (std::size_t i = 0; i < ring.size(); ++i) drawing.line(ring[i], ring[(i + 1) % ring.size()], colour);
  };
  for (const auto& part : cover.parts) outline(part.ring, program::sketch::grey);
  for (const auto& ring : rings) outline(ring, program::sketch::ink);
  for (const std::size_t g : cover.guards) drawing.dot(corners[g], program::sketch::red);
  program::write_picture(line, s.out, drawing.picture(s.size));
}

std::string place_text(const point& p) { return program::shortest(p.x) + " " + program::shortest(p.y); }

void run(program::command_line& line) {
  program::drawing_options s;
  while (!line.done()) s.read(line, line.take());
  s.finish(line);
  const plan rings = read_plan(line, s);
  std::vector<point> corners;
  for (const auto& ring : rings) corners.insert(corners.end(), ring.begin(), ring.end());
  const auto cover = irg::cover_by_guards(std::span<const std::vector<point>>(rings));
  if (cover.status != irg::guard_status::ok) line.fail("the rings cross, or run along each other");
  std::string text;
  if (s.list) {
    for (const auto& part : cover.parts) {
      text += place_text(corners[part.guard]);
      for (const point& p : part.ring) text += " " + place_text(p);
      text += "\n";
    }
  } else {
    text = "guards: " + std::to_string(cover.guards.size()) + "\nat_least: " + std::to_string(cover.at_least) +
           "\nparts: " + std::to_string(cover.parts.size()) + "\n";
    for (const std::size_t g : cover.guards) text += "guard: " + place_text(corners[g]) + "\n";
  }
  if (!s.out.empty()) draw(line, s, rings, cover, corners);
  std::fwrite(text.data(), 1, text.size(), stdout);
  program::finish_output(line, s.out);
}

}  // namespace

int main(int argc, char** argv) {
  program::run_or_fail(program::command_line(argc, argv, "gallery_guards", help), "the plan", run);
}
