// SPDX-License-Identifier: MIT
// Walls sorted into the tiles that they may meet, and the tiles that a triangle may meet: too many of either, never too
// few. The tile of a point is a rounded number that never falls as a coordinate rises.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <irg/core/contraction.hpp>
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
    for (int i = 0; i < 2; ++i) {
      low_[i] = widened(greater(around.low[i], domain.low[i]));
      const double high = widened(lesser(around.high[i], domain.high[i]));
      width_[i] = high - low_[i];
      most_ = greater(most_, greater(low_[i] < 0 ? -low_[i] : low_[i], high < 0 ? -high : high));
    }
    // Else all walls are in one tile: where coordinates have few digits that tell tiles apart, or may overflow.
    const double least = lesser(width_[0], width_[1]);
    if (walls.size() > 8 && most_ < 0x1p500 && least > 0x1p-500 && least > most_ * 0x1p-20) choose_size(walls);
    sort_in(walls);
  }

  constexpr std::size_t count() const noexcept {
    return static_cast<std::size_t>(size_[0]) * static_cast<std::size_t>(size_[1]);
  }
  constexpr std::span<const std::uint32_t> walls_in(std::size_t tile) const noexcept {
    if (begin_.empty()) return {};
    return {list_.data() + begin_[tile], begin_[tile + 1] - begin_[tile]};
  }

  // Tiles by column and row, the last ones among them.
  struct tile_range {
    int low[2], high[2];
  };
  // The tiles at most so far from that of a point.
  constexpr tile_range around(const point<T, 2>& p, int reach) const noexcept {
    tile_range out{};
    for (int axis = 0; axis < 2; ++axis) {
      const int at = tile_of(axis, widened(p[axis])), last = size_[axis] - 1;
      out.low[axis] = at < reach ? 0 : at - reach;
      out.high[axis] = at < last - reach ? at + reach : last;
    }
    return out;
  }

  // Calls f(tile) for each tile of `near` that a triangle may meet, but for those of `nearer`; says whether it may meet
  // none that is not in `near`.
  template <class F>
  constexpr bool for_triangle(const std::array<point<T, 2>, 3>& t, const tile_range& near, const tile_range& nearer,
                              F&& f) const {
    const tile_range all = extent_of(t);
    bool is_within = true, is_known = true;
    for (int axis = 0; axis < 2; ++axis) {
      is_within = is_within && near.low[axis] <= all.low[axis] && all.high[axis] <= near.high[axis];
      is_known = is_known && nearer.low[axis] <= all.low[axis] && all.high[axis] <= nearer.high[axis];
    }
    if (is_known) return true;
    for_rows(t, near, [&](int row, int first, int last) {
      const bool has_known = nearer.low[1] <= row && row <= nearer.high[1];
      for (int i = first; i <= last; ++i)
        if (has_known && nearer.low[0] <= i && i <= nearer.high[0])
          i = nearer.high[0];
        else
          f(number_of(i, row));
    });
    return is_within;
  }

  // Whether a segment may meet a triangle whose corners are rounded, which runs counter-clockwise and less than half
  // round its first corner: no line through two corners has all of it on its outer side, by far more than rounding.
  constexpr bool may_meet(const std::array<point<T, 2>, 3>& t, const segment<T, 2>& w) const noexcept {
    if (count() == 1) return true;
    for (std::size_t i = 0; i < 3; ++i) {
      const point<T, 2>&from = t[i], &to = t[i < 2 ? i + 1 : 0];
      if (is_right_of(from, to, w.a) && is_right_of(from, to, w.b)) return false;
    }
    return true;
  }

private:
  double most_ = 0;
  double low_[2]{}, width_[2]{};
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

  // Whether p is right of a line by more than 2^-45 of the greatest coordinate.
  constexpr bool is_right_of(const point<T, 2>& from, const point<T, 2>& to, const point<T, 2>& p) const noexcept {
    const double x = widened(to.x) - widened(from.x), y = widened(to.y) - widened(from.y);
    const double u = widened(p.x) - widened(from.x), v = widened(p.y) - widened(from.y);
    const auto size = [](double d) { return d < 0 ? -d : d; };
    return product(x, v) - product(y, u) < -0x1p-45 * most_ * (size(x) + size(y) + size(u) + size(v));
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

  // The tiles from the least to the greatest coordinates of a triangle.
  constexpr tile_range extent_of(const std::array<point<T, 2>, 3>& t) const noexcept {
    tile_range out{};
    for (int axis = 0; axis < 2; ++axis) {
      const T low = lesser(t[0][axis], lesser(t[1][axis], t[2][axis]));
      const T high = greater(t[0][axis], greater(t[1][axis], t[2][axis]));
      out.low[axis] = tile_of(axis, widened(low));
      out.high[axis] = tile_of(axis, widened(high));
    }
    return out;
  }

  // Calls f(row, first, last) for the rows of tiles within a range, and the tiles in each, that a triangle may meet: it
  // is cut at the rows' borders, a sixteenth of a tile further out, which is more than rounding moves it.
  template <class F>
  constexpr void for_rows(const std::array<point<T, 2>, 3>& t, const tile_range& range, const F& f) const {
    const tile_range all = extent_of(t);
    const auto give = [&](int row, int first, int last) {
      first = greater(first, range.low[0]);
      last = lesser(last, range.high[0]);
      if (first <= last) f(row, first, last);
    };
    const bool is_simple = all.low[0] == all.high[0] || all.low[1] == all.high[1];
    double x[3]{}, y[3]{};
    for (std::size_t i = 0; i < 3; ++i) x[i] = widened(t[i].x), y[i] = widened(t[i].y);
    const auto least = [](const double(&v)[3]) { return lesser(v[0], lesser(v[1], v[2])); };
    const auto most = [](const double(&v)[3]) { return greater(v[0], greater(v[1], v[2])); };
    const double tall = width_[1] / size_[1], wide = width_[0] / size_[0];
    for (int row = greater(all.low[1], range.low[1]); row <= lesser(all.high[1], range.high[1]); ++row) {
      if (is_simple) {
        give(row, all.low[0], all.high[0]);
        continue;
      }
      const double below = row == 0 ? least(y) : low_[1] + row * tall - tall / 16;
      const double above = row + 1 == size_[1] ? most(y) : low_[1] + (row + 1) * tall + tall / 16;
      double left = most(x), right = least(x);
      for (int i = 0; i < 3; ++i) {
        const int k = (i + 1) % 3;
        add_part(x[i], y[i], x[k], y[k], below, above, left, right);
      }
      if (left <= right) give(row, tile_of(0, left - wide / 16), tile_of(0, right + wide / 16));
    }
  }
  template <class F>
  constexpr void for_rows(const segment<T, 2>& w, const F& f) const {
    for_rows({w.a, w.b, w.b}, {{0, 0}, {size_[0] - 1, size_[1] - 1}}, f);
  }

  // Widens left to right by what of a line lies between two heights.
  static constexpr void add_part(double x0, double y0, double x1, double y1, double below, double above, double& left,
                                 double& right) noexcept {
    if ((y0 < below && y1 < below) || (above < y0 && above < y1)) return;
    const auto at = [&](double y) {
      const double v = x0 + (x1 - x0) * ((y - y0) / (y1 - y0)), low = lesser(x0, x1), high = greater(x0, x1);
      return v < low ? low : high < v ? high : v;
    };
    for (const double v : {y0 < below   ? at(below)
                           : above < y0 ? at(above)
                                        : x0,
                           y1 < below   ? at(below)
                           : above < y1 ? at(above)
                                        : x1}) {
      left = lesser(left, v);
      right = greater(right, v);
    }
  }
};

}  // namespace IRG_ABI
}  // namespace irg::detail
