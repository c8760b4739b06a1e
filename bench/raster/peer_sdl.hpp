// SPDX-License-Identifier: MIT
// SDL's software renderer. The one that a window gets queues its commands, which more than halves the price of short
// lines; so there is a window of SDL's own "dummy" kind, and its surface is led to the canvas. The queue is emptied every
// 512 items, so that it stays small, and behind the last one.
#pragma once

#include <map>
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

/// The one that draws on this canvas, made when it is first asked for.
inline const target& target_on(const canvas& c) {
  static std::map<const canvas*, std::unique_ptr<target>> all;
  auto& t = all[&c];
  if (!t) t = std::make_unique<target>(c);
  return *t;
}

inline drawer lines(const canvas& c, line_list& lines) {
  return {"SDL2 RenderDrawLine", [&c, &lines](int first, int last) {
            const target& t = target_on(c);
            for (int k = first; k < last; ++k) {
              const segment& s = (*lines)[static_cast<std::size_t>(k)];
              SDL_RenderDrawLine(t.renderer(), s.a.x, s.a.y, s.b.x, s.b.y);
              t.flush_after(k);
            }
            t.flush();
          }};
}

/// Fans of triangles: one call per polygon, or one for all.
enum class calls { one_each, one_for_all };

inline drawer fill(const canvas& c, const polygon_set& set, calls how) {
  struct data {
    std::vector<SDL_Vertex> vertices{};
    std::vector<int> fan{}, all{};
  };
  auto& p = keep_lazy([&set] {
    data d;
    for (const irg::subpixel& v : *set.vertices) {
      const SDL_FPoint at{static_cast<float>(v.x) / 256, static_cast<float>(v.y) / 256};
      d.vertices.push_back({at, {255, 255, 255, 255}, {0, 0}});
    }
    for (int i = 2; i < set.corners; ++i) d.fan.insert(d.fan.end(), {0, i - 1, i});
    for (int k = 0; k < set.size(); ++k)
      for (const int i : d.fan) d.all.push_back(k * set.corners + i);
    return d;
  });
  drawer d{how == calls::one_each ? "SDL2 RenderGeometry" : "SDL2 RenderGeometry batch", {}};
  d.note = "whole-pixel vertices";
  const int n = set.corners, indices = 3 * (n - 2);
  if (how == calls::one_each)
    d.draw = [&c, &p, n, indices](int first, int last) {
      const target& t = target_on(c);
      for (int k = first; k < last; ++k) {
        SDL_RenderGeometry(t.renderer(), nullptr, p->vertices.data() + k * n, n, p->fan.data(), indices);
        t.flush_after(k);
      }
      t.flush();
    };
  else
    d.draw = [&c, &p, indices](int first, int last) {
      const target& t = target_on(c);
      SDL_RenderGeometry(t.renderer(), nullptr, p->vertices.data(), static_cast<int>(p->vertices.size()),
                         p->all.data() + first * indices, (last - first) * indices);
      t.flush();
    };
  return d;
}

}  // namespace bench::sdl
