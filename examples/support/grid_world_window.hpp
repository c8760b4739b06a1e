// SPDX-License-Identifier: MIT
// The world of cubes in a window of SDL 2: keys and the mouse become lines of the script, and nothing else happens.
#pragma once

#include <cstdio>
#include <string>

#include "grid_world.hpp"
#include "picture_window.hpp"

namespace program {

class grid_world_window {
public:
  grid_world_window(const command_line& line, grid_world& world, int width, int height)
      : world_(world), window_(line, "irg grid world", width, height) {}

  void run() {
    window_.run(world_, [&](const SDL_Event& e) { return take(e); });
  }

private:
  bool take(const SDL_Event& e) {
    if (e.type == SDL_KEYDOWN) return key(e.key.keysym.sym);
    if (e.type == SDL_MOUSEBUTTONDOWN && e.button.button == SDL_BUTTON_LEFT)
      say("click " + std::to_string(e.button.x) + " " + std::to_string(e.button.y));
    if (e.type == SDL_MOUSEMOTION && (e.motion.state & SDL_BUTTON_RMASK) != 0)
      say("turn " + std::to_string(e.motion.xrel) + " " + std::to_string(-e.motion.yrel));
    return true;
  }
  bool key(SDL_Keycode k) {
    if (k == SDLK_ESCAPE) return false;
    if (k == SDLK_w) say("walk 1 0");
    if (k == SDLK_s) say("walk -1 0");
    if (k == SDLK_a) say("walk 0 -1");
    if (k == SDLK_d) say("walk 0 1");
    if (k == SDLK_2) say("test 2");
    if (k == SDLK_3) say("test 3");
    if (k == SDLK_t) say("method thesis");
    if (k == SDLK_e) say("method exact");
    if (k == SDLK_F6) say("picture grid_world.png");
    return true;
  }
  void say(const std::string& text) {
    const std::string why = world_.run(text);
    std::printf("%s%s%s\n", text.c_str(), why.empty() ? "" : "  # refused: ", why.c_str());
    std::fflush(stdout);
  }

  grid_world& world_;
  picture_window window_;
};

}  // namespace program
