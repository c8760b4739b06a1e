// SPDX-License-Identifier: MIT
// What the programs share that draw a scene of their own by rays: options, threads, the picture. The drawing stands in
// a file of its own so that it is compiled once for all of them.
#pragma once

#include <string_view>

#include "command_line.hpp"
#include "ray_scenes.hpp"
#include "run_or_fail.hpp"

namespace program {

inline constexpr std::string_view ray_options_help =
    R"(  -o OUT               the picture: .png, .ppm or .svg
  --size WxH           pixels (640x480)
  --samples N          1 to 16 (2): N x N rays a pixel
  --bounces N          0 to 32 (6): how often rays are followed on
  --threads N          1 to 256 (1)
)";

/// The body of a program that draws the scene that make() gives, as the command line says.
void draw_rays(command_line& line, ray_scene (*make)());

}  // namespace program
