// SPDX-License-Identifier: MIT
// shadow - the shadows that a body throws onto the floor, from a lamp near by and one at infinity.
#include <string>

#include "support/ray_pictures.hpp"

namespace {

const std::string help =
    R"(shadow - the teapot on a floor, lit by a lamp near by and a dim one at infinity, with the shadows of both

usage: shadow -o OUT [options]

)";

} // namespace

int main(int argc, char** argv) {
  program::run_or_fail({argc, argv, "shadow", help + std::string(program::ray_options_help)}, "this size",
                       [](program::command_line& line) { program::draw_rays(line, program::shadow_scene); });
}
