// SPDX-License-Identifier: MIT
// The studio's desk in a window of SDL 2.
#pragma once

#include <string>

#include "../support/picture_window.hpp"
#include "studio_desk.hpp"

namespace program {

class studio_window {
public:
  studio_window(const command_line& line, studio_session& session, int width, int height)
      : desk_(session), window_(line, "irg studio", width, height) {}

  void run() {
    window_.run(desk_, [&](const SDL_Event& e) { return take(e); });
  }

private:
  bool take(const SDL_Event& e) {
    if (e.type == SDL_KEYDOWN) return desk_.key(name_of(e.key.keysym));
    if (e.type == SDL_TEXTINPUT) desk_.type(e.text.text);
    if (e.type == SDL_MOUSEBUTTONDOWN && (e.button.button == SDL_BUTTON_LEFT || e.button.button == SDL_BUTTON_RIGHT))
      desk_.press(e.button.x, e.button.y, e.button.button == SDL_BUTTON_RIGHT);
    if (e.type == SDL_MOUSEMOTION && (e.motion.state & (SDL_BUTTON_LMASK | SDL_BUTTON_RMASK)) != 0)
      desk_.drag(e.motion.xrel, e.motion.yrel, (e.motion.state & SDL_BUTTON_RMASK) != 0);
    if (e.type == SDL_MOUSEWHEEL && e.wheel.y != 0) {
      int x = 0, y = 0;
      SDL_GetMouseState(&x, &y);
      desk_.wheel(x, y, e.wheel.y);
    }
    if (e.type == SDL_DROPFILE) {
      desk_.drop_file(e.drop.file);
      SDL_free(e.drop.file);
    }
    return true;
  }

  // The names of the desk's keys: the key pad's are those of the others, and plus may share its key with =.
  static std::string name_of(const SDL_Keysym& k) {
    std::string name = SDL_GetKeyName(k.sym);
    for (char& c : name) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    if (name.starts_with("keypad ")) name.erase(0, 7);
    if (name == "=") name = "+";
    if (name == "enter") name = "return";
    const bool has_two = name == "tab" || (name.size() == 1 && name[0] >= 'a' && name[0] <= 'z');
    return has_two && (k.mod & KMOD_SHIFT) != 0 ? "shift-" + name : name;
  }

  studio_desk desk_;
  picture_window window_;
};

}  // namespace program
