// SPDX-License-Identifier: MIT
// Contests of drawing: everybody draws the same items on the same canvas, and is judged by the pixels.
#pragma once

#include <cstdio>
#include <cstdlib>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <irg/io/image_file.hpp>

#include "raster/canvas.hpp"
#include "support/measure.hpp"

namespace bench {

/// What has to be so for the benchmark to end well.
enum class promise { none, nothing_wrong };

/// One contender. A limit writes to memory what a perfect algorithm would have to, and is not judged.
struct drawer {
  std::string name;  // as in results.csv
  std::function<void(int first, int last)> draw;  // draws the items [first, last)
  bool same_work = true;
  std::string note{};
  promise promised = promise::none;

  bool is_limit() const { return name.starts_with("limit:"); }
};

/// How far a drawer's pixels are from the exact ones, over a sample of the items.
using judging = std::function<errors(const drawer&)>;

/// As many bytes in one piece.
inline drawer limit_memset(const canvas& c, lazy<std::int64_t>& pixels) {
  return {"limit:memset", [&c, &pixels](int, int) {
            for (std::int64_t left = *pixels * 4; left > 0; left -= static_cast<std::int64_t>(c.bytes())) {
              std::memset(c.pixels(), 255, std::min(static_cast<std::size_t>(left), c.bytes()));
              asm volatile("" : : "r"(c.pixels()) : "memory");
            }
          }};
}

// IRG_BENCH_PICTURES names a folder that gets a picture of what each contender draws.
inline void save_picture(const contest& c, const canvas& on, const drawer& d) {
  const char* folder = std::getenv("IRG_BENCH_PICTURES");
  if (!folder) return;
  std::string name = c.kernel + "-" + c.test_case + "-" + d.name;
  for (char& letter : name)
    if (letter == ' ' || letter == ':' || letter == '/' || letter == '%') letter = '_';
  irg::image<irg::rgb8> picture(on.width(), on.height());
  for (int y = 0; y < picture.height(); ++y)
    for (int x = 0; x < picture.width(); ++x) {
      const irg::rgba8 p = on.view()(x, y);
      picture(x, y) = {p.r, p.g, p.b};
    }
  const std::string path = std::string(folder) + "/" + name + ".png";
  if (const auto saved = irg::save_image(path, picture); !saved)
    std::fprintf(stderr, "%s: %s\n", saved.error().message, path.c_str());
}

/// Draws all items on an empty canvas and gives a sum over the values of its pixels.
inline std::uint32_t checksum_of_all(const contest& c, const canvas& on, const drawer& d) {
  on.clear();
  d.draw(0, static_cast<int>(c.items));
  std::uint32_t checksum = 2166136261u;
  for (std::size_t i = 0; i < on.pixel_count(); ++i) checksum = (checksum ^ (on.pixels()[i] & 0x00ffffff)) * 16777619u;
  save_picture(c, on, d);
  on.clear();
  return checksum;
}

/// Enters the drawers; all that promise exactness have to draw the same picture.
inline void enter_drawers(const contest& what, const canvas& on, std::vector<drawer> drawers, const judging& judge) {
  auto promised = std::make_shared<std::optional<std::uint32_t>>();
  for (drawer& one : drawers) {
    const drawer& d = keep(std::move(one));
    contender c{d.name, [&d, items = static_cast<int>(what.items)] { d.draw(0, items); }};
    c.note = d.note;
    c.same_work = d.same_work;
    if (!d.is_limit())
      c.judge = [what, &on, &d, judge, promised] {
        const std::uint32_t checksum = checksum_of_all(what, on, d);
        errors e = judge(d);
        if (d.promised == promise::none) return e;
        if (!*promised) *promised = checksum;
        if (e.wrong != 0)
          e.broken = "nothing may be wrong";
        else if (checksum != **promised)
          e.broken = "the pictures differ";
        return e;
      };
    enter(what, std::move(c));
  }
}

}  // namespace bench
