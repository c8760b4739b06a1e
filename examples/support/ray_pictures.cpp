// SPDX-License-Identifier: MIT
#include "ray_pictures.hpp"

#include <string>

#include <irg/core/threads.hpp>
#include <irg/render/render_traced.hpp>

#include "picture_options.hpp"

namespace program {

void draw_rays(command_line& line, ray_scene (*make)()) {
  std::string out;
  picture_size size{640, 480};
  int threads = 1;
  irg::traced_options<double> options;
  options.samples = 2;
  while (!line.done()) {
    const std::string_view word = line.take();
    if (word == "-o")
      out = line.file_of(word);
    else if (word == "--size")
      size = read_size(line);
    else if (word == "--samples")
      options.samples = line.integer(word, 1, 16);
    else if (word == "--bounces")
      options.limits.bounces = line.integer(word, 0, 32);
    else if (word == "--threads")
      threads = line.integer(word, 1, 256);
    else
      line.refuse(word);
  }
  if (out.empty()) line.fail("no picture given; -o OUT.png names it");
  expect_picture_name(line, out);
  const ray_scene s = make();
  irg::image<irg::rgba8> picture(size.width, size.height);
  options.optics = s.optics;
  irg::render_traced(s.world, picture, options, irg::parallel{threads});
  write_picture(line, out, picture);
}

}  // namespace program
