// SPDX-License-Identifier: MIT
// The studio in a window of SDL 2: keys and the mouse become lines of the script, and nothing else happens there.
#pragma once

#include <cstdio>
#include <string>

#include "picture_window.hpp"
#include "studio_session.hpp"

namespace program {

inline constexpr const char* studio_keys =
    R"(keys, which are about the chosen body, the first one at first:
  Tab choose the next body   Delete drop it             1 2 3 4 points, edges, faces, backs
  s shading                  t transparent or not       arrows, Page Up, Page Down move it
  r turn it                  a turn it after the camera b last transformation first  Backspace remove it
  p projection of the main view       h axes and pyramid in it
  F5 save studio.xml         F6 picture studio.png      Escape end
mouse: drag to go round the target, wheel to go nearer or away, in the view where it is
)";

class studio_window {
public:
  studio_window(const command_line& line, studio_session& session, int width, int height)
      : session_(session), window_(line, "irg studio", width, height) {}

  void run() {
    window_.run(session_, [&](const SDL_Event& e) { return take(e); });
  }

private:
  bool take(const SDL_Event& e) {
    if (e.type == SDL_KEYDOWN) return key(e.key.keysym.sym);
    if (e.type == SDL_MOUSEMOTION && (e.motion.state & SDL_BUTTON_LMASK) != 0)
      say("orbit " + view_at(e.motion.x) + " " + std::to_string(-e.motion.xrel) + " " + std::to_string(e.motion.yrel));
    if (e.type == SDL_MOUSEWHEEL && e.wheel.y != 0) {
      int x = 0, y = 0;
      SDL_GetMouseState(&x, &y);
      say("orbit " + view_at(x) + " 0 0 " + (e.wheel.y > 0 ? "0.9" : "1.1"));
    }
    return true;
  }

  bool key(SDL_Keycode k) {
    const auto& bodies = session_.state().bodies;
    if (k == SDLK_ESCAPE) return false;
    if (k == SDLK_F5) say("save studio.xml");
    if (k == SDLK_F6) say("picture studio.png");
    if (k == SDLK_p) {
      constexpr const char* kinds[] = {"perspective", "orthographic", "cavalier", "cabinet",
                                       "isometric",   "dimetric",     "trimetric"};
      say(std::string("project main ") + kinds[kind_ = (kind_ + 1) % 7]);
    }
    if (k == SDLK_h) {
      const bool on = session_.state().of(irg::studio_view::main).shows(irg::studio_helper::world_axes);
      for (const char* what : {"axes", "pyramid"}) say(std::string("helper main ") + what + (on ? " off" : " on"));
    }
    if (bodies.empty()) return true;
    if (k == SDLK_TAB) ++chosen_;
    chosen_ %= bodies.size();
    about(k, bodies[chosen_]);
    return true;
  }

  void about(SDL_Keycode k, const irg::studio_body<double>& b) {
    const std::string name = " \"" + std::string(b.body.name) + "\" ";
    constexpr const char* parts[] = {"points", "edges", "faces", "backs"};
    constexpr const char* shadings[] = {"none", "flat", "gouraud", "phong"};
    const auto move = [&](const char* by) { say("add" + name + "before translate " + by); };
    const std::size_t count = b.transformations[0].size();
    if (k >= SDLK_1 && k <= SDLK_4) {
      const auto i = static_cast<std::size_t>(k - SDLK_1);
      say("show" + name + parts[i] + (b.parts[i] == irg::display::shown ? " off" : " on"));
    }
    if (k == SDLK_s) say("shade" + name + shadings[(static_cast<std::size_t>(b.shading) + 1) % 4]);
    if (k == SDLK_t) say("opacity" + name + (b.opacity < 1 ? "1" : "0.5"));
    if (k == SDLK_LEFT) move("-0.25 0 0");
    if (k == SDLK_RIGHT) move("0.25 0 0");
    if (k == SDLK_UP) move("0 0.25 0");
    if (k == SDLK_DOWN) move("0 -0.25 0");
    if (k == SDLK_PAGEUP) move("0 0 -0.25");
    if (k == SDLK_PAGEDOWN) move("0 0 0.25");
    if (k == SDLK_r) say("add" + name + "before rotate-y 15");
    if (k == SDLK_a) say("add" + name + "after rotate-z 15");
    if (k == SDLK_b) say("move" + name + "before " + std::to_string(count) + " 1");
    if (k == SDLK_BACKSPACE) say("remove" + name + "before " + std::to_string(count));
    if (k == SDLK_DELETE) say("drop" + name);
  }

  // Everything the window does is said as a line of the script, and done by it.
  void say(const std::string& text) {
    std::string why;
    const auto commands = irg::read_studio_script<double>(text);
    if (!commands) {
      why = commands.error().message;
    } else {
      for (const auto& c : *commands) why = session_.run(c);
    }
    std::printf("%s%s%s\n", text.c_str(), why.empty() ? "" : "  # refused: ", why.c_str());
    std::fflush(stdout);
  }

  std::string view_at(int x) const { return x < window_.width() / 2 ? "main" : "outer"; }

  studio_session& session_;
  picture_window window_;
  std::size_t chosen_ = 0, kind_ = 0;
};

}  // namespace program
