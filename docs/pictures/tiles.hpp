// SPDX-License-Identifier: MIT
// A picture of executors: in which order two of them run the tiles of a picture, and the picture. Included by
// pictures.cpp.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <irg/core/executor.hpp>
#include <irg/math/sqrt.hpp>

#include "sketch.hpp"

namespace tile_pictures {

using namespace sketching;

struct backwards {
  template <class Task>
  void operator()(std::size_t count, Task&& task) const {
    for (std::size_t i = count; i > 0; --i) task(i - 1);
  }
};
static_assert(irg::Executor<backwards>);

constexpr int tile = 24, columns = 8, rows = 8, side = tile * columns;

// Rings of light around two places; each tile is a task of its own.
template <class Executor>
picture rings(const Executor& run, std::vector<std::size_t>& order) {
  picture p(side, side);
  run(static_cast<std::size_t>(columns * rows), [&](std::size_t task) {
    order.push_back(task);
    const int left = static_cast<int>(task) % columns * tile, top = static_cast<int>(task) / columns * tile;
    for (int y = top; y < top + tile; ++y)
      for (int x = left; x < left + tile; ++x) {
        const auto wave = [&](double cx, double cy) {
          return irg::cos(irg::sqrt((x - cx) * (x - cx) + (y - cy) * (y - cy)) / 6);
        };
        const auto light = static_cast<std::uint8_t>(150 + 25 * (wave(60, 50) + wave(130, 140)));
        p(x, y) = {static_cast<std::uint8_t>(light - 40), light, static_cast<std::uint8_t>(light + 40), 255};
      }
  });
  return p;
}

inline picture orders() {
  constexpr int gap = 20;
  picture p(3 * side + 4 * gap, side + 2 * gap, paper);
  std::vector<std::size_t> forward, backward;
  const picture first = rings(irg::sequential{}, forward), second = rings(backwards{}, backward);
  int left = gap;
  for (const auto& order : {forward, backward}) {
    picture shades(side, side);
    for (std::size_t i = 0; i < order.size(); ++i) {
      const int x = static_cast<int>(order[i]) % columns * tile, y = static_cast<int>(order[i]) / columns * tile;
      const auto grey = static_cast<std::uint8_t>(240 - 2 * i);
      for (int row = y; row < y + tile - 1; ++row)
        irg::fill_span(shades, {row, x, x + tile - 1}, {grey, grey, static_cast<std::uint8_t>(grey - 10), 255});
    }
    paste(p, shades, left, gap);
    left += side + gap;
  }
  bool same = true;
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) same = same && first(x, y) == second(x, y);
  if (same) paste(p, first, left, gap);
  return p;
}

}  // namespace tile_pictures
