// SPDX-License-Identifier: MIT
// cornell_box - light between the walls of a room, by random paths.
#include <cstddef>
#include <cstdint>
#include <string>

#include <irg/colour/srgb.hpp>
#include <irg/core/threads.hpp>
#include <irg/raster/image.hpp>
#include <irg/trace/path_tracer.hpp>

#include "support/picture_options.hpp"
#include "support/ray_scenes.hpp"
#include "support/run_or_fail.hpp"

namespace {

const std::string help =
    R"(cornell_box - light between the walls of a room, by random paths: the more paths, the less noise

usage: cornell_box -o OUT [options]

  -o OUT               the picture: .png, .ppm or .svg
  --size WxH           pixels (256x256)
  --paths N            1 to 65536 (64): paths for each pixel
  --bounces N          0 to 64 (5): how often light is reflected
  --threads N          1 to 256 (1)
)";

void run(program::command_line& line) {
  std::string out;
  program::picture_size size{256, 256};
  irg::path_options options;
  int threads = 1;
  while (!line.done()) {
    const std::string_view word = line.take();
    if (word == "-o")
      out = line.file_of(word);
    else if (word == "--size")
      size = program::read_size(line);
    else if (word == "--paths")
      options.paths = line.integer(word, 1, 65536);
    else if (word == "--bounces")
      options.bounces = line.integer(word, 0, 64);
    else if (word == "--threads")
      threads = line.integer(word, 1, 256);
    else
      line.refuse(word);
  }
  if (out.empty()) line.fail("no picture given; -o OUT.png names it");
  program::expect_picture_name(line, out);
  const program::cornell_box room;
  const irg::ray_world<double> world(room.bodies(), {});
  const irg::path_tracer<double> trace(world);
  irg::image<irg::rgba8> picture(size.width, size.height);
  const irg::parallel all{threads};
  all(static_cast<std::size_t>(size.height), [&](std::size_t row) {
    for (int x = 0; x < size.width; ++x) {
      const auto ray =
          program::cornell_box::ray_at((x + 0.5) / size.width, (static_cast<double>(row) + 0.5) / size.height);
      const auto pixel =
          static_cast<std::uint64_t>(row) * static_cast<std::uint64_t>(size.width) + static_cast<std::uint64_t>(x);
      const irg::rgb<double> light = trace(ray, options, pixel);
      picture(x, static_cast<int>(row)) =
          irg::encode({static_cast<float>(light.r), static_cast<float>(light.g), static_cast<float>(light.b)});
    }
  });
  program::write_picture(line, out, picture);
}

} // namespace

int main(int argc, char** argv) { program::run_or_fail({argc, argv, "cornell_box", help}, "this size", run); }
