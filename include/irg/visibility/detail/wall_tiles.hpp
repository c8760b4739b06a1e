// SPDX-License-Identifier: MIT
// Walls sorted into the tiles that they may meet: too many of them, never too few. The tile of a point is a rounded
// number that never falls as a coordinate rises.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <irg/core/conversion.hpp>
#include <irg/geometry/box.hpp>
#include <irg/geometry/segment.hpp>

namespace irg::detail {
inline namespace IRG_ABI {

template <Floating T>
class wall_tiles {
public:
  constexpr wall_tiles() = default;
  constexpr wall_tiles(std::span<const segment<T, 2>> walls, const box<T, 2>& domain) {
    box<T, 2> around{};
    for (const auto& w : walls) around = enclosing_box(enclosing_box(around, w.a), w.b);
    double most = 0, farthest = 0;
    for (int i = 0; i < 2; ++i) {
      low_[i] = widened(greater(around.low[i], domain.low[i]));
      const double high = widened(lesser(around.high[i], domain.high[i]));
      width_[i] = high - low_[i];
      for (const double v : {widened(around.low[i]), widened(around.high[i])})
        farthest = greater(farthest, v < 0 ? -v : v);
      most = greater(most, greater(low_[i] < 0 ? -low_[i] : low_[i], high < 0 ? -high : high));
    }
    // Else all walls are in one tile: where coordinates have few digits that tell tiles apart, or may overflow.
    const double least = lesser(width_[0], width_[1]);
    if (walls.size() > 8 && farthest < 0x1p500 && most < 0x1p500 && least > 0x1p-500 && least > most * 0x1p-20)
      choose_size(walls);
    for (int i = 0; i < 2 && count() > 1; ++i) per_unit_[i] = size_[i] / width_[i];
    sort_in(walls);
  }

  constexpr std::size_t count() const noexcept {
    return static_cast<std::size_t>(size_[0]) * static_cast<std::size_t>(size_[1]);
  }
  constexpr int size(int axis) const noexcept { return size_[axis]; }
  constexpr std::span<const std::uint32_t> walls_in(int x, int y) const noexcept {
    const std::size_t tile = number_of(x, y);
    return {list_.data() + begin_[tile], begin_[tile + 1] - begin_[tile]};
  }
  // In the tile of a point, or what is nearest to it.
  constexpr std::span<const std::uint32_t> walls_at(const point<T, 2>& p) const noexcept {
    return walls_in(tile_of(0, widened(p.x)), tile_of(1, widened(p.y)));
  }
  // Coordinates counted in tiles, and how far two points are from one another.
  // needs   count() > 1
  constexpr double place_in_tiles(int axis, T v) const noexcept { return (widened(v) - low_[axis]) * per_unit_[axis]; }
  constexpr double distance_in_tiles(int axis, T from, T to) const noexcept {
    return (widened(to) - widened(from)) * per_unit_[axis];
  }

  // Numbers the walls anew, as tiles hold them first: what is near each other is so in memory, too. Gives the numbers
  // that they had.
  constexpr std::vector<std::uint32_t> renumber(std::size_t walls) {
    constexpr std::uint32_t none = 0xffffffffu;
    std::vector<std::uint32_t> now(walls, none), before;
    before.reserve(walls);
    for (std::uint32_t& w : list_) {
      if (now[w] == none) {
        now[w] = static_cast<std::uint32_t>(before.size());
        before.push_back(w);
      }
      w = now[w];
    }
    return before;
  }

private:
  double low_[2]{}, width_[2]{}, per_unit_[2]{};
  int size_[2]{1, 1};
  std::vector<std::size_t> begin_{};
  std::vector<std::uint32_t> list_{};

  constexpr std::size_t number_of(int x, int y) const noexcept {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(size_[0]) + static_cast<std::size_t>(x);
  }
  constexpr int tile_of(int axis, double v) const noexcept {
    if (size_[axis] == 1) return 0;
    const double at = (v - low_[axis]) / width_[axis] * size_[axis];
    return at < 1 ? 0 : at < size_[axis] - 1 ? static_cast<int>(at) : size_[axis] - 1;
  }

  // As many tiles as walls, if walls are short: fewer, until each wall is in some six of them at most.
  constexpr void choose_size(std::span<const segment<T, 2>> walls) {
    double tiles = static_cast<double>(walls.size());
    for (std::size_t places = ~std::size_t{0}; places > 6 * walls.size() + 64 && tiles >= 1; tiles /= 4) {
      double across = 1;
      while (across * across * width_[1] < tiles * width_[0] && across < 4096) across *= 2;
      const double high = tiles / across;
      size_[0] = static_cast<int>(across);
      size_[1] = high < 1 ? 1 : high > 4096 ? 4096 : static_cast<int>(high);
      places = 0;
      for (const auto& w : walls)
        for_rows(w, [&](int, int first, int last) { places += static_cast<std::size_t>(last - first + 1); });
    }
  }

  constexpr void sort_in(std::span<const segment<T, 2>> walls) {
    begin_.assign(count() + 1, std::size_t{0});
    for (const auto& w : walls)
      for_rows(w, [&](int row, int first, int last) {
        for (int i = first; i <= last; ++i) ++begin_[number_of(i, row) + 1];
      });
    for (std::size_t i = 0; i + 1 < begin_.size(); ++i) begin_[i + 1] += begin_[i];
    std::vector<std::size_t> next(begin_.begin(), begin_.end());
    list_.assign(begin_.back(), std::uint32_t{0});
    for (std::size_t k = 0; k < walls.size(); ++k)
      for_rows(walls[k], [&](int row, int first, int last) {
        for (int i = first; i <= last; ++i) list_[next[number_of(i, row)]++] = static_cast<std::uint32_t>(k);
      });
  }

  // Calls f(row, first, last) for the rows of tiles, and the tiles in each, that a wall may meet: it is cut at the
  // rows' borders, a sixteenth of a tile further out, which is more than rounding moves it.
  template <class F>
  constexpr void for_rows(const segment<T, 2>& w, const F& f) const {
    const double x[2]{widened(w.a.x), widened(w.b.x)}, y[2]{widened(w.a.y), widened(w.b.y)};
    const double low = lesser(y[0], y[1]), high = greater(y[0], y[1]);
    const int first_row = tile_of(1, low), last_row = tile_of(1, high);
    const int first = tile_of(0, lesser(x[0], x[1])), last = tile_of(0, greater(x[0], x[1]));
    const double tall = width_[1] / size_[1], wide = width_[0] / size_[0];
    for (int row = first_row; row <= last_row; ++row) {
      if (first_row == last_row || first == last) {
        f(row, first, last);
        continue;
      }
      const double below = row == 0 ? low : low_[1] + row * tall - tall / 16;
      const double above = row + 1 == size_[1] ? high : low_[1] + (row + 1) * tall + tall / 16;
      const auto at = [&](int i) {  // where the wall enters the row, or ends in it
        const double inner = y[i] < below ? below : above < y[i] ? above : y[i];
        if (inner == y[i]) return x[i];
        const double v = x[i] + (x[1 - i] - x[i]) * ((inner - y[i]) / (y[1 - i] - y[i]));
        return greater(lesser(x[0], x[1]), lesser(greater(x[0], x[1]), v));
      };
      if (high < below || above < low) continue;
      const double from = at(0), to = at(1);
      f(row, tile_of(0, lesser(from, to) - wide / 16), tile_of(0, greater(from, to) + wide / 16));
    }
  }
};

}  // namespace IRG_ABI
}  // namespace irg::detail
