// SPDX-License-Identifier: MIT
// grid_world - a world of cubes in three dimensions: units are set down in it, and what they see is bright.
#include <algorithm>
#include <cstdio>
#include <string>
#include <string_view>

#include "support/grid_world.hpp"
#include "support/picture_options.hpp"
#include "support/run_or_fail.hpp"
#include "support/text_input.hpp"
#ifdef IRG_HAVE_SDL2
#include "support/grid_world_window.hpp"
#endif

namespace {

constexpr std::string_view help =
    R"(grid_world - a world of cubes, units in it, and what they see

usage: grid_world MAP [options] <SCRIPT
MAP is a map with units and walls as grid_visibility reads it. The script has one event on a line; # begins a comment:
  click X Y            a unit where pixel (X, Y) shows a floor or a cube: on it, or in the free cell beside it
  walk FORWARD RIGHT   the camera goes so many cells
  turn RIGHT UP        it turns by so many degrees
  test 3, test 2       units see in space (at first), or in their own layers only
  method exact         as grid_visibility says (at first)
  method thesis        by the modified Bresenham line, which in the lowest layer, or with test 2 in every one, tells full
                       sight from partial
  picture FILE         .png, .ppm or .svg: bright floors and cubes are seen, green ones in part; walls are blue, closed
                       doors brown; sight passes grey half walls, the ochre posts of open doors, red beams of lasers
and prints
  refused: LINE: why   for each line that cannot be; the world is as it was before it
  units: N, seen: N, test: N, and by the thesis in part: N

  --script FILE        read the script from FILE
  --size WxH           pixels of a picture (640x480)
  --window             shows the world; keys and mouse become lines, which are printed: a click, w a s d, dragging with
                       the right button, 2 and 3, t(hesis) and e(xact); F6 writes grid_world.png, Escape ends. A script only from --script
)";

struct settings {
  std::string map, script;
  program::picture_size size;
  bool window = false;
};

settings read_settings(program::command_line& line) {
  settings s;
  while (!line.done()) {
    const std::string_view word = line.take();
    if (word == "--script")
      s.script = line.file_of(word);
    else if (word == "--size")
      s.size = program::read_size(line);
    else if (word == "--window")
      s.window = program::can_show(line);
    else if (word.starts_with('-') || !s.map.empty())
      line.refuse(word);
    else
      s.map = word;
  }
  if (s.map.empty()) line.fail("no map is named; --help tells how");
  return s;
}

void run(program::command_line& line) {
  const settings s = read_settings(line);
  const std::string text = program::read_text(line, s.map, "map");
  auto map = irg::read_grid(text);
  if (!map) line.fail(program::with_place(map.error(), s.map));
  program::grid_world world(*std::move(map), s.size.width, s.size.height);
  world.keep_files(s.map, s.script);
  const std::string script = s.window && s.script.empty() ? "" : program::read_text(line, s.script, "script");
  std::string out;
  std::size_t number = 0;
  for (std::size_t at = 0; at < script.size(); ++number) {
    const std::size_t end = std::min(script.find('\n', at), script.size());
    const std::string why = world.run(std::string_view(script).substr(at, end - at));
    if (!world.failed_to_write().empty()) {
      world.remove_files();
      line.fail(world.failed_to_write());
    }
    if (!why.empty()) out += "refused: " + std::to_string(number + 1) + ": " + why + "\n";
    at = end + 1;
  }
  if (s.window) {
#ifdef IRG_HAVE_SDL2
    std::fputs(out.c_str(), stdout);
    out.clear();
    program::grid_world_window(line, world, s.size.width, s.size.height).run();
#endif
  }
  out += "units: " + std::to_string(world.units().size()) + "\nseen: " + std::to_string(world.seen()) +
         "\ntest: " + std::to_string(world.test()) + "\n";
  if (world.by_thesis()) out += "in part: " + std::to_string(world.seen_in_part()) + "\n";
  std::fputs(out.c_str(), stdout);
  if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) world.remove_files();
  program::finish_output(line, "");
}

}  // namespace

int main(int argc, char** argv) { program::run_or_fail({argc, argv, "grid_world", help}, "this world", run); }
