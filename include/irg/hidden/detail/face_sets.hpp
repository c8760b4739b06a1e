// SPDX-License-Identifier: MIT
// For each pixel of a small window the set of the faces that cover it, as bits: what touches or surrounds a part of the
// window is then the union or the common part of a few numbers.
#pragma once

#include <cstddef>
#include <cstdint>

#include <irg/raster/triangle_coverage.hpp>

namespace irg::detail {

class IRG_APART face_sets {
public:
  static constexpr int side = 16;
  static constexpr std::size_t most = 64;  // faces

  static constexpr bool holds(const cell_window& w) noexcept {
    return w.x_last - w.x_first <= side && w.y_last - w.y_first <= side;
  }

  // Empty sets for the pixels of a window.
  constexpr void start(const cell_window& w) noexcept {
    window_ = w;
    for (int y = w.y_first; y < w.y_last; ++y)
      for (int x = w.x_first; x < w.x_last; ++x) place(x, y) = 0;
  }
  // Puts the face that has this bit into the sets of the pixels that it covers.
  constexpr void add(const triangle_coverage& t, std::uint64_t bit) noexcept {
    const cell_window both = intersect(t.bounds, window_);
    std::int64_t row[3];
    for (int i = 0; i < 3; ++i) row[i] = t.edge[i](both.x_first, both.y_first);
    for (int y = both.y_first; y < both.y_last; ++y) {
      std::int64_t e[3] = {row[0], row[1], row[2]};
      for (int x = both.x_first; x < both.x_last; ++x) {
        place(x, y) |= (e[0] | e[1] | e[2]) < 0 ? 0 : bit;  // no branch: nobody can foretell it
        for (int i = 0; i < 3; ++i) e[i] += t.edge[i].right;
      }
      for (int i = 0; i < 3; ++i) row[i] += t.edge[i].down;
    }
  }

  constexpr std::uint64_t operator()(int x, int y) const noexcept {
    return sets_[(y - window_.y_first) * side + (x - window_.x_first)];
  }

  // The faces that cover some pixel of a part of the window, and those that cover them all.
  struct touching_window {
    std::uint64_t somewhere, everywhere;
  };
  constexpr touching_window touching(const cell_window& w) const noexcept {
    touching_window t{0, ~std::uint64_t{0}};
    for (int y = w.y_first; y < w.y_last; ++y)
      for (int x = w.x_first; x < w.x_last; ++x) {
        t.somewhere |= (*this)(x, y);
        t.everywhere &= (*this)(x, y);
      }
    return t;
  }

private:
  constexpr std::uint64_t& place(int x, int y) noexcept {
    return sets_[(y - window_.y_first) * side + (x - window_.x_first)];
  }

  std::uint64_t sets_[side * side] = {};
  cell_window window_{};
};

}  // namespace irg::detail
