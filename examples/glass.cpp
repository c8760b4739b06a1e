// SPDX-License-Identifier: MIT
// glass - balls of glass and of silver over a chequered floor.
#include <string>

#include "support/ray_pictures.hpp"

namespace {

const std::string help =
    R"(glass - a ball of glass, one of silver and a red one over a chequered floor, by reflected and refracted rays

usage: glass -o OUT [options]

)";

} // namespace

int main(int argc, char** argv) {
  program::run_or_fail({argc, argv, "glass", help + std::string(program::ray_options_help)}, "this size",
                       [](program::command_line& line) { program::draw_rays(line, program::glass_scene); });
}
