// SPDX-License-Identifier: MIT
// SDL's software renderer. The one that a window gets queues its commands, which more than halves the price of short
// lines; so there is a window of SDL's own "dummy" kind, and its surface is led to the canvas. The queue is emptied every
// 512 items, so that it stays small, and behind the last one.
#pragma once

#include <memory>

#include <SDL2/SDL.h>

#include "raster/lines.hpp"
#include "raster/polygons.hpp"

namespace bench::sdl {

class target {
public:
  explicit target(const canvas& c) {
    SDL_SetHint(SDL_HINT_VIDEODRIVER, "dummy");
    SDL_SetHint(SDL_HINT_RENDER_BATCHING, "1");
    SDL_SetHint(SDL_HINT_RENDER_LINE_METHOD, "2");  // lines are drawn as lines
    if (SDL_InitSubSystem(SDL_INIT_VIDEO) != 0) stop();
    window_ = SDL_CreateWindow("", 0, 0, c.width(), c.height(), SDL_WINDOW_HIDDEN);
    renderer_ = window_ ? SDL_CreateRenderer(window_, -1, SDL_RENDERER_SOFTWARE) : nullptr;
    surface_ = renderer_ ? SDL_GetWindowSurface(window_) : nullptr;
    if (!surface_ || surface_->format->BytesPerPixel != 4 || surface_->pitch != c.stride()) stop();
    own_pixels_ = surface_->pixels;
    surface_->pixels = c.pixels();
    SDL_SetRenderDrawColor(renderer_, 255, 255, 255, 255);
  }
  target(const target&) = delete;
  target& operator=(const target&) = delete;
  ~target() {
    surface_->pixels = own_pixels_;
    SDL_DestroyRenderer(renderer_);
    SDL_DestroyWindow(window_);
    SDL_QuitSubSystem(SDL_INIT_VIDEO);
  }
  SDL_Renderer* renderer() const { return renderer_; }
  void flush_after(int item) const {
    if (item % 512 == 511) SDL_RenderFlush(renderer_);
  }
  void flush() const { SDL_RenderFlush(renderer_); }

private:
  [[noreturn]] static void stop() {
    std::printf("SDL: %s\n", SDL_GetError());
    std::abort();
  }
  SDL_Window* window_ = nullptr;
  SDL_Renderer* renderer_ = nullptr;
  SDL_Surface* surface_ = nullptr;
  void* own_pixels_ = nullptr;
};

inline drawer lines(const canvas& c, const std::vector<segment>& lines) {
  return {"SDL2 RenderDrawLine", [t = std::make_shared<target>(c), &lines](int first, int last) {
            for (int k = first; k < last; ++k) {
              const segment& s = lines[static_cast<std::size_t>(k)];
              SDL_RenderDrawLine(t->renderer(), s.a.x, s.a.y, s.b.x, s.b.y);
              t->flush_after(k);
            }
            t->flush();
          }};
}

/// Fans of triangles: one call per polygon, or one for all.
enum class calls { one_each, one_for_all };

inline drawer fill(const canvas& c, const polygon_set& set, calls how) {
  struct data {
    explicit data(const canvas& on) : to(on) {}
    target to;
    std::vector<SDL_Vertex> vertices{};
    std::vector<int> fan{}, all{};
  };
  auto p = std::make_shared<data>(c);
  const int n = set.corners;
  for (const irg::subpixel& v : set.vertices) {
    const SDL_FPoint at{static_cast<float>(v.x) / 256, static_cast<float>(v.y) / 256};
    p->vertices.push_back({at, {255, 255, 255, 255}, {0, 0}});
  }
  for (int i = 2; i < n; ++i) p->fan.insert(p->fan.end(), {0, i - 1, i});
  for (int k = 0; k < set.size(); ++k)
    for (const int i : p->fan) p->all.push_back(k * n + i);
  drawer d{how == calls::one_each ? "SDL2 RenderGeometry" : "SDL2 RenderGeometry batch", {}};
  d.note = "whole-pixel vertices";
  const int indices = static_cast<int>(p->fan.size());
  if (how == calls::one_each)
    d.draw = [p, n, indices](int first, int last) {
      for (int k = first; k < last; ++k) {
        SDL_RenderGeometry(p->to.renderer(), nullptr, p->vertices.data() + k * n, n, p->fan.data(), indices);
        p->to.flush_after(k);
      }
      p->to.flush();
    };
  else
    d.draw = [p, indices](int first, int last) {
      SDL_RenderGeometry(p->to.renderer(), nullptr, p->vertices.data(), static_cast<int>(p->vertices.size()),
                         p->all.data() + first * indices, (last - first) * indices);
      p->to.flush();
    };
  return d;
}

}  // namespace bench::sdl
