// SPDX-License-Identifier: MIT
// The faces near an edge. Grids over the screen, each of cells twice as wide as the one before; a face lies in the
// finest grid of which it meets at most 2 x 2 cells, so that all grids together hold at most four entries a face. In
// every cell the faces are sorted by how near they come, the nearest first.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <irg/hidden/detail/edge_crossing.hpp>

namespace irg {
namespace detail {

// The box of something on the screen, and the depth of its nearest point.
struct screen_box {
  std::int32_t left, top, right, bottom;
};

inline namespace IRG_ABI {

template <std::size_t N>
constexpr screen_box box_of(const subpixel (&p)[N]) noexcept {
  screen_box b{p[0].x, p[0].y, p[0].x, p[0].y};
  for (std::size_t i = 1; i < N; ++i)
    b = {lesser(b.left, p[i].x), lesser(b.top, p[i].y), greater(b.right, p[i].x), greater(b.bottom, p[i].y)};
  return b;
}
template <class Box>
IRG_INLINE constexpr bool boxes_meet(const Box& a, const Box& b) noexcept {
  return a.left <= b.right && b.left <= a.right && a.top <= b.bottom && b.top <= a.bottom;
}

}  // namespace IRG_ABI

// An entry of a cell: what is asked of a face before the face itself.
struct listed_face {
  screen_box box;
  float nearest;
  std::uint32_t face;
};

template <class Faces>
class face_grids {
public:
  face_grids() = default;
  // needs   sorted_faces: by `nearest`, the greatest first
  constexpr explicit face_grids(const Faces& sorted) {
    const std::size_t n = sorted.faces.size();
    if (n == 0) return;
    std::vector<screen_box> boxes;
    boxes.reserve(n);
    for (const auto& f : sorted.faces) boxes.push_back(box_of(f.p));
    make_grids(boxes);
    std::vector<std::uint8_t> level(n, std::uint8_t{0});
    for (std::size_t i = 0; i < n; ++i) {
      while (!fits(boxes[i], grids_[level[i]].shift)) ++level[i];
      grid& g = grids_[level[i]];
      for_cells(g, boxes[i], [&](std::size_t cell) { ++g.starts[cell + 1]; });
    }
    for (grid& g : grids_) {
      for (std::size_t c = 1; c < g.starts.size(); ++c) g.starts[c] += g.starts[c - 1];
      g.entries.resize(g.starts.back(), listed_face{});
    }
    for (std::size_t i = n; i-- > 0;) {  // from the back: each cell's start ends where it belongs
      grid& g = grids_[level[i]];
      for_cells(g, boxes[i], [&](std::size_t cell) {
        g.entries[--g.starts[cell + 1]] = {boxes[i], sorted.nearest[i], static_cast<std::uint32_t>(i)};
      });
    }
  }

  // Calls visit(entries) with the list of each cell that the edge may meet, until it returns true.
  template <class Visit>
  constexpr void visit_cells(const hidden_edge& e, const Visit& visit) const {
    const screen_box b = box_of(e.p);
    if (grids_.empty() || !boxes_meet(b, whole_)) return;
    for (std::size_t k = grids_.size(); k-- > 0;)
      if (!grids_[k].entries.empty() && visit_grid(grids_[k], e, b, visit)) return;
  }

private:
  struct grid {
    int shift = 0;
    std::int64_t columns = 0;
    std::vector<std::uint32_t> starts{};  // of cell c at c + 1: the list ends where that of the next cell starts
    std::vector<listed_face> entries{};
  };

  // Empty grids, from one whose cells are about as wide as a box on average, but no more than four for each box, to one
  // of a single cell.
  constexpr void make_grids(const std::vector<screen_box>& boxes) {
    whole_ = boxes[0];
    double extent = 0;
    for (const screen_box& b : boxes) {
      whole_ = {lesser(whole_.left, b.left), lesser(whole_.top, b.top), greater(whole_.right, b.right),
                greater(whole_.bottom, b.bottom)};
      extent += static_cast<double>(greater(std::int64_t{b.right} - b.left, std::int64_t{b.bottom} - b.top));
    }
    const double mean = extent / static_cast<double>(boxes.size());
    const auto most = 4 * static_cast<std::int64_t>(boxes.size()) + 64;
    int shift = 0;
    while (static_cast<double>(std::int64_t{1} << shift) < mean || cells_of(shift) > most) ++shift;
    for (bool one_cell = false; !one_cell; ++shift) {
      grids_.push_back({shift, column(whole_.right, shift) + 1});
      grids_.back().starts.assign(static_cast<std::size_t>(cells_of(shift)) + 1, std::uint32_t{0});
      one_cell = cells_of(shift) == 1;
    }
  }

  constexpr std::int64_t column(std::int64_t x, int shift) const noexcept { return (x - whole_.left) >> shift; }
  constexpr std::int64_t row(std::int64_t y, int shift) const noexcept { return (y - whole_.top) >> shift; }
  constexpr std::int64_t cells_of(int shift) const noexcept {
    return (column(whole_.right, shift) + 1) * (row(whole_.bottom, shift) + 1);
  }
  constexpr bool fits(const screen_box& b, int shift) const noexcept {
    return column(b.right, shift) - column(b.left, shift) < 2 && row(b.bottom, shift) - row(b.top, shift) < 2;
  }
  template <class F>
  constexpr void for_cells(const grid& g, const screen_box& b, const F& f) const {
    for (std::int64_t y = row(b.top, g.shift); y <= row(b.bottom, g.shift); ++y)
      for (std::int64_t x = column(b.left, g.shift); x <= column(b.right, g.shift); ++x)
        f(static_cast<std::size_t>(y * g.columns + x));
  }

  // The columns of an edge between two heights, rounded outwards.
  struct x_range {
    std::int64_t first, last;
  };
  static constexpr x_range between(const hidden_edge& e, std::int64_t y0, std::int64_t y1) noexcept {
    const std::int64_t ax = e.p[0].x, ay = e.p[0].y, dx = e.p[1].x - ax, dy = e.p[1].y - ay;
    const screen_box b = box_of(e.p);
    if (dy == 0) return {b.left, b.right};
    const auto at = [&](std::int64_t y) { return ax + dx * (y - ay) / dy; };  // within 1
    const std::int64_t p = at(greater(y0, std::int64_t{b.top})), q = at(lesser(y1, std::int64_t{b.bottom}));
    return {lesser(p, q) - 1, greater(p, q) + 1};
  }

  template <class Visit>
  constexpr bool visit_grid(const grid& g, const hidden_edge& e, const screen_box& b, const Visit& visit) const {
    const std::int64_t last_row = row(lesser(b.bottom, whole_.bottom), g.shift);
    for (std::int64_t y = row(greater(b.top, whole_.top), g.shift); y <= last_row; ++y) {
      const std::int64_t above = whole_.top + (y << g.shift);
      const x_range x = between(e, above, above + (std::int64_t{1} << g.shift));
      const std::int64_t first = column(greater(x.first, std::int64_t{whole_.left}), g.shift);
      const std::int64_t last = column(lesser(x.last, std::int64_t{whole_.right}), g.shift);
      for (std::int64_t c = first; c <= last; ++c) {
        const auto cell = static_cast<std::size_t>(y * g.columns + c);
        const std::uint32_t from = g.starts[cell + 1];
        const std::uint32_t to =
            cell + 2 < g.starts.size() ? g.starts[cell + 2] : static_cast<std::uint32_t>(g.entries.size());
        if (from < to && visit(g.entries.data() + from, g.entries.data() + to)) return true;
      }
    }
    return false;
  }

  screen_box whole_{};
  std::vector<grid> grids_{};
};

}  // namespace detail
}  // namespace irg
