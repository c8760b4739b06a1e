// SPDX-License-Identifier: MIT
// A polygon drawn in a window of SDL 2.
#pragma once

#include <string>

#include "picture_window.hpp"
#include "polygon_desk.hpp"

namespace program {

/// Shows the desk until Escape.
template <class Answers>
void show_polygon_window(const command_line& line, polygon_desk<Answers>& desk, int width, int height) {
  picture_window window(line, "irg convex polygon", width, height);
  window.run(desk, [&](const SDL_Event& e) {
    if (e.type == SDL_KEYDOWN) {
      std::string name = SDL_GetKeyName(e.key.keysym.sym);
      for (char& c : name) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
      return desk.key(name == "keypad enter" ? "return" : name);
    }
    if (e.type == SDL_MOUSEBUTTONDOWN && e.button.button == SDL_BUTTON_LEFT) desk.add_vertex(e.button.x, e.button.y);
    if (e.type == SDL_MOUSEBUTTONDOWN && e.button.button == SDL_BUTTON_RIGHT) desk.ask(e.button.x, e.button.y);
    return true;
  });
}

}  // namespace program
