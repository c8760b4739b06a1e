// SPDX-License-Identifier: MIT
// The one picture that all contenders draw on, each through its own view, so that all meet the same memory and caches.
#pragma once

#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <string>

#include <irg/colour/pixel.hpp>
#include <irg/raster/image.hpp>

#include "support/random_numbers.hpp"

namespace bench {

/// Pixels of 32 bits, rows without gaps, starting on a page.
class canvas {
public:
  canvas(int width, int height, std::string name) : width_(width), height_(height), name_(std::move(name)) {
    const std::size_t pages = bytes() / 4096 + 1;  // a few bytes behind the last pixel, too
    pixels_.reset(static_cast<std::uint32_t*>(std::aligned_alloc(4096, pages * 4096)));
    if (!pixels_) std::abort();
    clear();
  }

  int width() const { return width_; }
  int height() const { return height_; }
  int stride() const { return 4 * width_; }
  std::size_t pixel_count() const { return static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_); }
  std::size_t bytes() const { return 4 * pixel_count(); }
  /// How the cases on this canvas are called.
  const std::string& name() const { return name_; }
  std::uint32_t* pixels() const { return pixels_.get(); }
  std::uint32_t& at(int x, int y) const {
    return pixels_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x)];
  }
  bool holds(std::int64_t x, std::int64_t y) const { return 0 <= x && x < width_ && 0 <= y && y < height_; }
  void clear() const { std::memset(pixels(), 0, bytes()); }

  irg::image_view<irg::rgba8> view() const {
    return {reinterpret_cast<irg::rgba8*>(pixels()), width_, height_, static_cast<std::ptrdiff_t>(stride())};
  }

private:
  struct release {
    void operator()(std::uint32_t* p) const { std::free(p); }
  };
  int width_, height_;
  std::string name_;
  std::unique_ptr<std::uint32_t[], release> pixels_;
};

/// White, whatever the order of the channels; the canvas is cleared to 0.
inline constexpr std::uint32_t white = 0xffffffff;
inline constexpr irg::rgba8 white_rgba{255, 255, 255, 255};

}  // namespace bench
