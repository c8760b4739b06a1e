// SPDX-License-Identifier: MIT
// The faces near an edge. Grids over the screen, each of cells twice as wide as the one before; a face lies in the
// finest grid of which it meets at most 2 x 2 cells, so that all grids together hold at most four entries a face. In
// every cell that an edge comes to the faces are sorted by how near they come, the nearest first.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include <irg/hidden/detail/edge_crossing.hpp>

namespace irg {
namespace detail {

// The box of something on the screen, and the depth of its nearest point.
struct screen_box {
  std::int32_t left, top, right, bottom;
  constexpr bool operator==(const screen_box&) const = default;
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

inline namespace IRG_ABI {

// A face with its corners clockwise, the first one the first by its coordinates.
template <int Sense>
constexpr hiding_face hiding_face_of(const screen_face& f) noexcept {
  hiding_face h{};
  int first = 0;
  const auto before = [&](int i, int j) {
    const subpixel &p = f.v[i].position, &q = f.v[j].position;
    return p.x != q.x ? p.x < q.x : p.y < q.y;
  };
  for (int i = 1; i < 3; ++i)
    if (before(i, first)) first = i;
  for (int i = 0; i < 3; ++i) {
    const screen_vertex& v = f.v[(first + (f.coverage.flipped ? 3 - i : i)) % 3];
    h.p[i] = v.position;
    h.depth[i] = Sense > 0 ? v.depth : -v.depth;
  }
  return h;
}

}  // namespace IRG_ABI

// An entry of a cell: what is asked of a face before the face itself.
struct listed_face {
  screen_box box;
  float nearest;
  std::uint32_t face;
};

// The faces of a picture by their numbers, with their grids.
template <int Sense, class Faces>
class IRG_APART face_grids {
public:
  // Without grids yet: for `face` alone.
  constexpr explicit face_grids(const Faces& faces) : faces_(faces), place_(faces.size(), no_face) {
    converted_.reserve(faces.size());  // references to faces last
    nearest_.reserve(faces.size());
    for (std::size_t i = 0; i < faces.size(); ++i) {
      const screen_face& f = faces[i];
      nearest_.push_back(f.coverage.double_area == 0 ? -std::numeric_limits<float>::infinity()
                         : Sense > 0                 ? f.depth_high
                                                     : -f.depth_low);
    }
  }
  // Makes the grids for the edges of a container: faces are left out where they are not nearer than any edge that may
  // meet their cell.
  template <class Edges>
  constexpr void prepare_for(const Edges& edges) {
    std::vector<screen_box> boxes;
    boxes.reserve(nearest_.size());
    for (std::size_t i = 0; i < nearest_.size(); ++i) {
      const screen_face& f = faces_[i];
      boxes.push_back(box_of({f.v[0].position, f.v[1].position, f.v[2].position}));
    }
    if (boxes.empty()) return;
    make_grids(boxes);
    // Worth a walk of its own where edges are few.
    if (edges.size() < boxes.size() / 2)
      for (std::size_t i = 0; i < edges.size(); ++i) note_depth(edges[i]);
    else
      for (grid& g : grids_) g.farthest.assign(g.farthest.size(), -std::numeric_limits<float>::infinity());
    list_faces(boxes);
  }

  constexpr float nearest(std::uint32_t face) const noexcept { return nearest_[face]; }
  // A face as the crossings need it. Those once asked for stay where they are.
  constexpr const hiding_face& face(std::uint32_t i) {
    if (place_[i] == no_face) {
      place_[i] = static_cast<std::uint32_t>(converted_.size());
      converted_.push_back(hiding_face_of<Sense>(faces_[i]));
    }
    return converted_[place_[i]];
  }

  // Calls visit(entries) with the list of each cell that the edge may meet, until it returns true.
  template <class Visit>
  constexpr void visit_cells(const hidden_edge& e, const Visit& visit) {
    walk_cells(e, [&](grid& g, std::size_t cell) {
      const std::uint32_t from = g.starts[cell], to = g.starts[cell + 1];
      if (from == to) return false;
      if (g.is_sorted[cell] == 0) sort_cell(g, cell);
      return visit(g.entries.data() + from, g.entries.data() + to);
    });
  }

private:
  struct grid {
    int shift = 0;
    std::int64_t columns = 0;
    std::vector<std::uint32_t> starts{};  // of each cell, and the end
    std::vector<float> farthest{};  // of each cell: that of the edges that may meet it; infinity where none does
    std::vector<std::uint8_t> is_sorted{};
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
      const auto cells = static_cast<std::size_t>(cells_of(shift));
      grids_.push_back({shift, column(whole_.right, shift) + 1});
      grids_.back().starts.assign(cells + 1, std::uint32_t{0});
      grids_.back().farthest.assign(cells, std::numeric_limits<float>::infinity());
      grids_.back().is_sorted.assign(cells, std::uint8_t{0});
      one_cell = cells == 1;
    }
  }
  template <class Edge>
  constexpr void note_depth(const Edge& edge) {
    const auto nearness = [](float depth) { return Sense > 0 ? depth : -depth; };
    const hidden_edge e{{edge.v[0].position, edge.v[1].position},
                        {nearness(edge.v[0].depth), nearness(edge.v[1].depth)}};
    const float depth = lesser(e.depth[0], e.depth[1]);
    walk_cells(e, [&](grid& g, std::size_t cell) {
      g.farthest[cell] = lesser(g.farthest[cell], depth);
      return false;
    });
  }
  constexpr void list_faces(const std::vector<screen_box>& boxes) {
    std::vector<std::uint8_t> level(boxes.size(), std::uint8_t{0});
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      while (!fits(boxes[i], grids_[level[i]].shift)) ++level[i];
      grid& g = grids_[level[i]];
      for_cells(g, boxes[i], [&](std::size_t cell) {
        if (nearest_[i] > g.farthest[cell]) ++g.starts[cell];
      });
    }
    for (grid& g : grids_) {
      std::uint32_t sum = 0;
      for (std::uint32_t& start : g.starts) start = sum += start;  // ends, which become starts below
      g.entries.resize(sum, listed_face{});
    }
    for (std::size_t i = boxes.size(); i-- > 0;) {
      grid& g = grids_[level[i]];
      for_cells(g, boxes[i], [&](std::size_t cell) {
        if (nearest_[i] > g.farthest[cell])
          g.entries[--g.starts[cell]] = {boxes[i], nearest_[i], static_cast<std::uint32_t>(i)};
      });
    }
  }
  // The nearest first; of faces that are the same all but one become ones that hide nothing.
  constexpr void sort_cell(grid& g, std::size_t cell) {
    g.is_sorted[cell] = 1;
    const auto first = g.entries.begin() + g.starts[cell], last = g.entries.begin() + g.starts[cell + 1];
    std::sort(first, last, [](const listed_face& a, const listed_face& b) {
      if (a.nearest != b.nearest) return a.nearest > b.nearest;
      if (a.box.left != b.box.left) return a.box.left < b.box.left;
      if (a.box.top != b.box.top) return a.box.top < b.box.top;
      return a.face < b.face;
    });
    auto kept = first;
    for (auto i = first; i != last; ++i)
      if (i == first || kept[-1].nearest != i->nearest || !(kept[-1].box == i->box) ||
          !(face(kept[-1].face) == face(i->face)))
        *kept++ = *i;
    for (; kept != last; ++kept) kept->nearest = -std::numeric_limits<float>::infinity();
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

  // Calls visit(grid, cell) for the cells that an edge may meet, the largest first, until it returns true.
  template <class Visit>
  constexpr void walk_cells(const hidden_edge& e, const Visit& visit) {
    const screen_box b = box_of(e.p);
    if (grids_.empty() || !boxes_meet(b, whole_)) return;
    for (std::size_t k = grids_.size(); k-- > 0;)
      if (walk_grid(grids_[k], e, b, visit)) return;
  }
  template <class Visit>
  constexpr bool walk_grid(grid& g, const hidden_edge& e, const screen_box& b, const Visit& visit) {
    const std::int64_t last_row = row(lesser(b.bottom, whole_.bottom), g.shift);
    for (std::int64_t y = row(greater(b.top, whole_.top), g.shift); y <= last_row; ++y) {
      const std::int64_t above = whole_.top + (y << g.shift);
      const x_range x = between(e, above, above + (std::int64_t{1} << g.shift));
      const std::int64_t first = column(greater(x.first, std::int64_t{whole_.left}), g.shift);
      const std::int64_t last = column(lesser(x.last, std::int64_t{whole_.right}), g.shift);
      for (std::int64_t c = first; c <= last; ++c)
        if (visit(g, static_cast<std::size_t>(y * g.columns + c))) return true;
    }
    return false;
  }

  const Faces& faces_;
  std::vector<std::uint32_t> place_;
  std::vector<hiding_face> converted_{};
  std::vector<float> nearest_{};  // of each face
  screen_box whole_{};
  std::vector<grid> grids_{};
};

}  // namespace detail
}  // namespace irg
