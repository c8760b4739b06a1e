// SPDX-License-Identifier: MIT
// studio - bodies, their transformations and a camera, as the camera sees them and as one sees the camera.
#include <cstdio>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "studio/desk_replay.hpp"
#include "support/picture_options.hpp"
#include "support/run_or_fail.hpp"
#include "studio/studio_desk.hpp"
#include "studio/studio_keys.hpp"
#include "studio/studio_session.hpp"
#include "support/text_input.hpp"
#ifdef IRG_HAVE_SDL2
#include "studio/studio_window.hpp"
#endif

namespace {

const std::string help =
    R"(studio - bodies, lists of transformations and a camera: the main view, and an outer view of bodies and camera

usage: studio [options] <SCRIPT
Reads events from standard input, one on a line; # begins a comment. NAME is the name of a body, in double quotes if
there are blanks in it, or * for all; VIEW is main or outer; STAGE is before or after the camera.
  load FILE [NAME]     a file of any format that irg reads, or teapot, cube, sphere, torus; behind one of the same name
                       it is called NAME(2), NAME(3), ...
  drop NAME
  show NAME points|edges|faces|backs on|off
  shade NAME none|flat|gouraud|phong
  opacity NAME SHARE   0 to 1
  colour NAME R G B    0 to 255
  add NAME STAGE TRANSFORMATION
      translate x y z, scale x y z, rotate-x|rotate-y|rotate-z DEG, rotate x y z DEG (an axis),
      shear xy xz yx yz zx zy, mirror a b c d (a plane), parallel a b c d x y z (onto a plane along a direction),
      central a b c d x y z (onto a plane from an eye), matrix (16 numbers by rows, for columns)
  change NAME STAGE N TRANSFORMATION               puts another in the place of number N, counted from 1
  move NAME STAGE FROM TO, remove NAME STAGE N     in its list
  aim VIEW EYE TARGET [UP]                         three numbers each
  orbit VIEW AZIMUTH ELEVATION [FACTOR]            degrees; then FACTOR times as far away
  project VIEW perspective|orthographic|isometric|dimetric|trimetric|cavalier [DEG]|cabinet [DEG]|oblique DEG FACTOR
  pyramid VIEW D WIDTH HEIGHT NEAR FAR             the screen at distance D, and what is seen
  helper VIEW axes|camera-axes|camera|pyramid on|off
  lamp N X Y Z W [R G B]                           lamp N, or a new one behind the last: its place, a direction with
                                                   W 0, and its light, parts from 0 to 1 (1 1 1)
  drop-lamp N
  ambient SHARE                                    light from everywhere, 0 to 1; the rest is the lamps'
  light X Y Z W AMBIENT                            one lamp alone, and light from everywhere
  picture FILE [VIEW]  one view, or both side by side
  save FILE.xml, restore FILE.xml                  the whole state
and prints
  refused: LINE: why   for each line that cannot be; the studio is as it was before it
  pictures: N, events: N
  body: NAME           for each at the end

  --input FILE         read the script from FILE
  --size WxH           pixels of a picture (1280x480), of the window (1280x720)
  --window             shows the studio: on the left its panels, transformations above and the properties of a view
                       below, then what the main camera sees, and the outer one. Keys and mouse become lines of the
                       script, which are printed. Reads a script only from --input
  --replay FILE        the same without a window, keys and mouse from FILE: key NAME ..., type TEXT, press X Y,
                       drag DX DY, slide DX DY (with the right button), wheel X Y STEPS, drop FILE

In the window each event has a key or a move of the mouse, or is typed as a line:
)" + program::studio_keys_text();

struct settings {
  std::string input, replay;
  std::optional<program::picture_size> size;
  bool window = false;

  bool has_desk() const { return window || !replay.empty(); }
  program::picture_size size_or_default() const {
    return size.value_or(program::picture_size{1280, has_desk() ? 720 : 480});
  }
};

settings read_settings(program::command_line& line) {
  settings s;
  while (!line.done()) {
    const std::string_view word = line.take();
    if (word == "--input")
      s.input = line.file_of(word);
    else if (word == "--size")
      s.size = program::read_size(line);
    else if (word == "--window")
      s.window = program::can_show(line);
    else if (word == "--replay")
      s.replay = line.file_of(word);
    else
      line.refuse(word);
  }
  return s;
}

void run(program::command_line& line) {
  const settings s = read_settings(line);
  const program::picture_size size = s.size_or_default();
  program::studio_session session(size.width, size.height);
  std::string out;
  std::size_t pictures = 0, events = 0;
  if (!s.has_desk() || !s.input.empty()) {
    const std::string text = program::read_text(line, s.input, "script");
    const auto commands = irg::read_studio_script<double>(text);
    if (!commands) line.fail(program::with_place(commands.error(), s.input.empty() ? "stdin" : s.input));
    for (const auto& c : *commands) {
      const std::string why = session.run(c);
      if (!session.failed_to_write().empty()) {
        session.remove_files();
        line.fail(session.failed_to_write());
      }
      if (!why.empty()) out += "refused: " + std::to_string(c.line) + ": " + why + "\n";
      if (why.empty() && c.action == irg::studio_action::picture) ++pictures;
      if (why.empty() && c.action != irg::studio_action::picture) ++events;
    }
  }
  if (!s.replay.empty()) {
    const std::string moves = program::read_text(line, s.replay, "replay");
    std::fputs(out.c_str(), stdout);
    program::studio_desk desk(session);
    desk.resize(size.width, size.height);
    program::replay(line, desk, moves, s.replay);
    return program::finish_output(line, "");
  }
  if (s.window) {
#ifdef IRG_HAVE_SDL2
    std::fputs(out.c_str(), stdout);
    program::studio_window(line, session, size.width, size.height).run();
    return program::finish_output(line, "");
#endif
  }
  out += "pictures: " + std::to_string(pictures) + "\nevents: " + std::to_string(events) + "\n";
  for (const auto& b : session.state().bodies) out += "body: " + std::string(b.body.name) + "\n";
  std::fputs(out.c_str(), stdout);
  if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) session.remove_files();
  program::finish_output(line, "");
}

}  // namespace

int main(int argc, char** argv) {
  program::run_or_fail({argc, argv, "studio", help}, "these bodies and this size", run);
}
