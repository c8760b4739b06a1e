// SPDX-License-Identifier: MIT
// A window of SDL 2 that shows a picture, anew after each event.
#pragma once

#include <cstdio>
#include <string>

#include <SDL2/SDL.h>

#include <irg/raster/image.hpp>

#include "command_line.hpp"

namespace program {

class picture_window {
public:
  picture_window(const command_line& line, const char* title, int width, int height) : line_(line) {
    if (SDL_Init(SDL_INIT_VIDEO) != 0) line.fail(std::string("no window can be opened: ") + SDL_GetError());
    window_ =
        SDL_CreateWindow(title, SDL_WINDOWPOS_CENTERED, SDL_WINDOWPOS_CENTERED, width, height, SDL_WINDOW_RESIZABLE);
    if (window_ == nullptr) line.fail(std::string("no window can be opened: ") + SDL_GetError());
  }
  ~picture_window() {
    SDL_DestroyWindow(window_);
    SDL_Quit();
  }
  picture_window(const picture_window&) = delete;
  picture_window& operator=(const picture_window&) = delete;

  int width() const {
    int width = 0, height = 0;
    SDL_GetWindowSize(window_, &width, &height);
    return width;
  }

  /// Shows what `state` draws in the window's size, and hands events to take(event), until that is false.
  template <class State, class Take>
  void run(State& state, const Take& take) {
    show(state);
    std::printf("window: ready\n");
    std::fflush(stdout);
    SDL_Event e;
    while (SDL_WaitEvent(&e) != 0) {
      bool go_on = true;
      do go_on = e.type != SDL_QUIT && take(e) && go_on;
      while (SDL_PollEvent(&e) != 0);
      if (!go_on) return;
      show(state);
    }
  }

private:
  template <class State>
  void show(State& state) {
    SDL_Surface* const surface = SDL_GetWindowSurface(window_);
    if (surface == nullptr || surface->w < 1 || surface->h < 1) return;
    state.resize(surface->w, surface->h);
    irg::image<irg::rgba8>& picture = state.draw();
    SDL_Surface* const drawn = SDL_CreateRGBSurfaceWithFormatFrom(
        picture.data(), surface->w, surface->h, 32, static_cast<int>(picture.bytes_per_row()), SDL_PIXELFORMAT_RGBA32);
    if (drawn == nullptr) line_.fail(std::string("the picture cannot be shown: ") + SDL_GetError());
    SDL_SetSurfaceBlendMode(drawn, SDL_BLENDMODE_NONE);
    SDL_BlitSurface(drawn, nullptr, surface, nullptr);
    SDL_FreeSurface(drawn);
    SDL_UpdateWindowSurface(window_);
  }

  const command_line& line_;
  SDL_Window* window_ = nullptr;
};

}  // namespace program
