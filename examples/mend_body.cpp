// SPDX-License-Identifier: MIT
// mend_body - a body is loaded, its faults are told, what can be mended is, and it is written in any format.
#include <cstdio>
#include <string>
#include <string_view>

#include <irg/mesh/merge_positions.hpp>
#include <irg/mesh/mesh_faults.hpp>
#include <irg/solid/measures.hpp>
#include <irg/solid/orient_outward.hpp>

#include "support/command_line.hpp"
#include "support/model_input.hpp"
#include "support/number_output.hpp"
#include "support/picture_options.hpp"
#include "support/run_or_fail.hpp"

namespace {

constexpr std::string_view help =
    R"(mend_body - loads a body, tells its faults, mends what can be mended, writes it

usage: mend_body MODEL [options]
MODEL is a file of any format that irg reads, or teapot, cube, sphere, torus. Equal positions become one, faces are
turned to run alike and, where the surface is closed, to look outward. Prints
  before: N            faults of the body as it was
  after: N             faults that are left
  turned: done         or open (faces run alike, but there is no inside), or no-surface (faces cannot run alike)
  volume: V            of a closed body without faults

  --list               prints the faults that are left instead, a sentence on a line
  -o FILE              writes the body: .obj, .stl, .ply, .off or .xml
)";

void run(program::command_line& line) {
  std::string model, out;
  bool list = false;
  while (!line.done()) {
    const std::string_view word = line.take();
    if (word == "-o")
      out = line.file_of(word);
    else if (word == "--list")
      list = true;
    else if (model.empty() && !word.starts_with('-'))
      model = word;
    else
      line.refuse(word);
  }
  if (model.empty()) line.fail("no model given; --help tells how");
  if (!out.empty() && !irg::mesh_format_of_name(out))
    line.fail(std::string("the body's name must end in ") + irg::mesh_endings + ", not: " + out);
  if (program::one_file(out, model)) line.fail("the model would be overwritten: " + model);

  auto body = program::read_model(line, model);
  const std::size_t before = irg::list_faults(body).size();
  body = irg::with_merged_positions(std::move(body));
  const irg::outward_status turned = irg::orient_outward(body);
  const auto left = irg::list_faults(body);
  if (!out.empty())
    if (const auto saved = irg::save_mesh(out, body); !saved)
      line.fail(std::string(saved.error().message) + ": " + out);
  if (list) {
    for (const irg::mesh_fault& f : left) std::printf("%s\n", std::string(irg::sentence_of(f)).c_str());
  } else {
    const char* const how = turned == irg::outward_status::ok     ? "done"
                            : turned == irg::outward_status::open ? "open"
                                                                  : "no-surface";
    std::printf("before: %zu\nafter: %zu\nturned: %s\n", before, left.size(), how);
    if (left.empty() && turned == irg::outward_status::ok)
      std::printf("volume: %s\n", program::shortest(irg::solid_volume(body)).c_str());
  }
  program::finish_output(line, out);
}

}  // namespace

int main(int argc, char** argv) { program::run_or_fail({argc, argv, "mend_body", help}, "this model", run); }
