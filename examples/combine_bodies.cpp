// SPDX-License-Identifier: MIT
// combine_bodies - a body of two: together, in common, the first less the second, or what only one of them has.
#include <cstdio>
#include <string>

#include <irg/solid/boolean.hpp>
#include <irg/solid/measures.hpp>
#include <irg/view/affine.hpp>

#include "support/command_line.hpp"
#include "support/model_input.hpp"
#include "support/number_output.hpp"
#include "support/picture_options.hpp"
#include "support/run_or_fail.hpp"

namespace {

constexpr std::string_view help =
    R"(combine_bodies - two closed bodies become one; every decision exact, what comes out closed and turned outward

usage: combine_bodies FIRST OPERATION SECOND [options]
FIRST and SECOND are files of any format that irg reads, or teapot, cube, sphere, torus; OPERATION is union,
intersection, difference or symmetric-difference. Prints
  triangles: N, positions: N
  volume: V            of the result
  volumes: V1 V2       of the two
  from: N1 N2          triangles of the result that come from the first and from the second

  --move x,y,z         moves the second body first
  -o FILE              writes the result: .obj, .stl, .ply, .off or .xml
A body that is open, cuts itself or is not turned outward is refused; mend_body mends some.
)";

const char* sentence_of(irg::solid_boolean_status s) {
  switch (s) {
    case irg::solid_boolean_status::ok: return "";
    case irg::solid_boolean_status::not_finite: return "body has a position that is not finite";
    case irg::solid_boolean_status::open_edge: return "body is not closed: an edge has one face";
    case irg::solid_boolean_status::edge_of_many_faces: return "faces of the body do not fit at an edge";
    case irg::solid_boolean_status::not_a_body: break;
  }
  return "a body cuts itself, has faces without area where it meets the other, or is turned inside out";
}

void run(program::command_line& line) {
  std::string words[3], out;
  irg::vec<double, 3> move{};
  std::size_t given = 0;
  while (!line.done()) {
    const std::string_view word = line.take();
    if (word == "-o")
      out = line.file_of(word);
    else if (word == "--move") {
      const auto n = line.numbers(word, 3);
      move = {n[0], n[1], n[2]};
    } else if (given < 3 && !word.starts_with('-'))
      words[given++] = word;
    else
      line.refuse(word);
  }
  if (given < 3) line.fail("two bodies and an operation are needed; --help tells how");
  constexpr std::string_view names[] = {"intersection", "union", "difference", "symmetric-difference"};
  std::size_t which = 0;
  while (which < 4 && names[which] != words[1]) ++which;
  if (which == 4) line.fail("the operation is none of union, intersection, difference, symmetric-difference");
  if (!out.empty() && !irg::mesh_format_of_name(out))
    line.fail(std::string("the body's name must end in ") + irg::mesh_endings + ", not: " + out);
  if (program::one_file(out, words[0]) || program::one_file(out, words[2])) line.fail("a body would be overwritten");

  const auto first = program::read_model(line, words[0]);
  const auto second = irg::transformed(program::read_model(line, words[2]), irg::translation(move));
  const auto made = irg::solid_boolean(first, second, static_cast<irg::boolean_operation>(which));
  if (made.status != irg::solid_boolean_status::ok)
    line.fail(sentence_of(made.status) + (made.body > 1 ? std::string() : ": " + words[made.body == 0 ? 0 : 2]));
  std::size_t from[2] = {0, 0};
  for (const irg::solid_face_origin& f : made.faces) ++from[f.body];
  if (!out.empty())
    if (const auto saved = irg::save_mesh(out, made.value); !saved)
      line.fail(std::string(saved.error().message) + ": " + out);
  std::printf("triangles: %zu\npositions: %zu\nvolume: %s\nvolumes: %s %s\nfrom: %zu %zu\n", made.value.face_count(),
              made.value.positions.size(), program::shortest(irg::solid_volume(made.value)).c_str(),
              program::shortest(irg::solid_volume(first)).c_str(), program::shortest(irg::solid_volume(second)).c_str(),
              from[0], from[1]);
  program::finish_output(line, out);
}

}  // namespace

int main(int argc, char** argv) { program::run_or_fail({argc, argv, "combine_bodies", help}, "these bodies", run); }
