// SPDX-License-Identifier: MIT
// Hidden lines in vectors: the parts of edges that faces hide, and those that are seen. A point of an edge is hidden
// when a face covers it, sides and corners included, and the plane of the face is strictly nearer there. So a face
// hides none of its own edges, nor an edge that lies in its plane, and nothing shows between two faces that meet.
//
// Edges and faces are what snapping left of them: corners on 1/256 of a pixel and depths as floats, both taken as exact
// numbers. Where an edge appears or disappears is then a ratio of integers, and all decisions are made by these.
#pragma once

#include <algorithm>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include <irg/core/contraction.hpp>
#include <irg/core/function_ref.hpp>
#include <irg/hidden/detail/with_items.hpp>
#include <irg/hidden/vocabulary.hpp>
#include <irg/math/vec.hpp>
#include <irg/raster/face_order.hpp>
#if IRG_BODIES
#include <irg/hidden/detail/edge_crossing.hpp>
#endif

namespace irg {

/// An edge on the screen, between two vertices.
struct screen_edge {
  screen_vertex v[2];
  bool operator==(const screen_edge&) const = default;
};

/// Which faces are tried for an edge: those near it that may be nearer than it, or every one.
enum class face_search { nearby, every };

/// What was done to find the hidden parts.
struct hidden_line_counts {
  std::int64_t edges = 0;  // with a length
  std::int64_t faces = 0;  // with an area
  std::int64_t tried = 0;  // pairs of an edge and a face whose boxes meet and whose depths do not part them
  std::int64_t hiding = 0;  // pairs where the face hides something
  std::int64_t visible = 0, hidden = 0;  // parts
  bool operator==(const hidden_line_counts&) const = default;
};

inline namespace IRG_ABI {

/// Finds which parts of edges are seen and which are hidden behind faces, and calls sink(part) for each edge_part: the
/// edges in their order, the parts of each from its first end to the second. Returns what was done.
/// shape   edges and faces are ranges with size() and [i], of screen_edge and screen_face
/// needs   positions within snap_limit pixels of the origin, finite depths
/// gives   parts of visible and hidden in turn, which make up the edge; parts without a length are left out, as are
///         edges whose ends have one position. Faces without area hide nothing
/// exact   the parts by integers, `from` and `to` then rounded once: the same bytes for every order of the faces and
///         for either search. Depths may be of any sign and size
/// cost    linear in the faces, of which only the cells that edges meet are sorted; an edge is tried with the faces of
///         the cells that it meets, the nearest first, until all of it is hidden; edges with the same ends are tried
///         once. Allocates about 150 bytes a face, 30 an edge
/// source  Roberts 1963; Appel 1967, for intervals along the edge
template <DepthOrder Order = nearer_is_greater, class Faces, class Edges, class Emit>
  requires(depth_sense<Order> != 0)
constexpr hidden_line_counts hidden_lines(const Faces& faces, const Edges& edges, Emit&& sink,
                                          face_search search = face_search::nearby);

/// The point of an edge a share t of the way from its first end to the second, in pixels.
/// exact   each coordinate rounded three times; the ends as they are
template <class Edge>
  requires std::same_as<Edge, screen_edge>
[[nodiscard]] constexpr point<double, 2> point_on(const Edge& edge, double t) noexcept {
  const auto between = [t](std::int32_t a, std::int32_t b) {
    const double from = static_cast<double>(a), to = static_cast<double>(b);
    return (t == 1.0 ? to : from + product(to - from, t)) / one_pixel;
  };
  const subpixel &a = edge.v[0].position, &b = edge.v[1].position;
  return {between(a.x, b.x), between(a.y, b.y)};
}

}  // namespace IRG_ABI

namespace detail::inline IRG_COMPILED_ABI {

template <class Counts, int Sense, class Faces, class Edges>
IRG_API Counts send_edge_parts(const Faces& faces, const Edges& edges, const function_ref<void(edge_part)>& sink,
                               face_search search);

}  // namespace detail::inline IRG_COMPILED_ABI

inline namespace IRG_ABI {

template <DepthOrder Order, class Faces, class Edges, class Emit>
  requires(depth_sense<Order> != 0)
constexpr hidden_line_counts hidden_lines(const Faces& faces, const Edges& edges, Emit&& sink, face_search search) {
  return detail::with_items<screen_face>(faces, [&](const auto& of_faces) {
    return detail::with_items<screen_edge>(edges, [&](const auto& of_edges) {
      return detail::send_edge_parts<hidden_line_counts, depth_sense<Order>>(
          of_faces, of_edges, as_function<void(edge_part)>(sink), search);
    });
  });
}

}  // namespace IRG_ABI
}  // namespace irg

#if IRG_BODIES
namespace irg::detail {

// What faces hide of an edge: the interval of each, and their union.

struct hidden_interval {
  edge_crossing from, to;
};

inline namespace IRG_ABI {

// What a face hides of an edge, if that has a length: where all its edge functions are 0 or more (its sides belong to
// it, so that nothing shows between two faces) and its plane is nearer.
template <class Face, class Edge>
constexpr std::optional<hidden_interval> interval_hidden_by(const Face& f, const Edge& e) noexcept {
  hidden_interval hidden{edge_start, edge_finish};
  const auto begin_at = [&](const edge_crossing& c) {
    if (compare_places(hidden.from, c, e) < 0) hidden.from = c;
  };
  const auto end_at = [&](const edge_crossing& c) {
    if (compare_places(c, hidden.to, e) < 0) hidden.to = c;
  };
  std::int64_t at_start[3], at_end[3];
  for (int i = 0; i < 3; ++i) {
    at_start[i] = side_at(f, i, e.p[0]);
    at_end[i] = side_at(f, i, e.p[1]);
    if (minimum(at_start[i], at_end[i]) < 0 && maximum(at_start[i], at_end[i]) <= 0) return std::nullopt;
  }
  for (int i = 0; i < 3; ++i)
    if (at_start[i] < 0)
      begin_at(side_crossing(f, i, at_start[i], at_end[i]));
    else if (at_end[i] < 0)
      end_at(side_crossing(f, i, at_start[i], at_end[i]));
  if (compare_places(hidden.from, hidden.to, e) >= 0) return std::nullopt;
  const int start = nearness_sign(f, e, 0), end = nearness_sign(f, e, 1);
  if (start <= 0 && end <= 0) return std::nullopt;
  if (start < 0) begin_at(plane_crossing(f, e));
  if (end < 0) end_at(plane_crossing(f, e));
  if (compare_places(hidden.from, hidden.to, e) >= 0) return std::nullopt;
  return hidden;
}

}  // namespace IRG_ABI

// Intervals of one edge, apart from each other and in order: those that touch are one.
template <class Interval>
class IRG_APART interval_union {
public:
  constexpr void clear() noexcept { list_.clear(); }

  constexpr void add(const Interval& added, const hidden_edge& e) {
    const auto first = std::partition_point(list_.begin(), list_.end(),
                                            [&](const Interval& i) { return compare_places(i.to, added.from, e) < 0; });
    Interval whole = added;
    auto last = first;
    for (; last != list_.end() && compare_places(last->from, whole.to, e) <= 0; ++last) {
      if (compare_places(last->from, whole.from, e) < 0) whole.from = last->from;
      if (compare_places(whole.to, last->to, e) < 0) whole.to = last->to;
    }
    if (first == last) {
      list_.insert(first, whole);
    } else {
      *first = whole;
      list_.erase(first + 1, last);
    }
  }

  // Whether nothing of the edge is left.
  constexpr bool is_whole() const noexcept {
    return list_.size() == 1 && list_[0].from.kind == crossing_kind::start && list_[0].to.kind == crossing_kind::end;
  }
  constexpr const std::vector<Interval>& intervals() const noexcept { return list_; }

private:
  std::vector<Interval> list_;
};

// The faces near an edge. Grids over the screen, each of cells twice as wide as the one before; a face lies in the
// finest grid of which it meets at most 2 x 2 cells, so that all grids together hold at most four entries a face. In
// every cell that an edge comes to the faces are sorted by how near they come, the nearest first.

// The box of something on the screen, and the depth of its nearest point.
struct screen_box {
  std::int32_t left, top, right, bottom;
  bool operator==(const screen_box&) const = default;
};

inline namespace IRG_ABI {

template <std::size_t N>
constexpr screen_box box_of(const subpixel (&p)[N]) noexcept {
  screen_box b{p[0].x, p[0].y, p[0].x, p[0].y};
  for (std::size_t i = 1; i < N; ++i)
    b = {minimum(b.left, p[i].x), minimum(b.top, p[i].y), maximum(b.right, p[i].x), maximum(b.bottom, p[i].y)};
  return b;
}
IRG_INLINE constexpr bool boxes_meet(const screen_box& a, const screen_box& b) noexcept {
  return a.left <= b.right && b.left <= a.right && a.top <= b.bottom && b.top <= a.bottom;
}

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
  constexpr explicit face_grids(const Faces& faces) : faces_(faces), place_(faces.size(), no_index) {
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
    if (place_[i] == no_index) {
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
      whole_ = {minimum(whole_.left, b.left), minimum(whole_.top, b.top), maximum(whole_.right, b.right),
                maximum(whole_.bottom, b.bottom)};
      extent += static_cast<double>(maximum(std::int64_t{b.right} - b.left, std::int64_t{b.bottom} - b.top));
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
    const float depth = minimum(e.depth[0], e.depth[1]);
    walk_cells(e, [&](grid& g, std::size_t cell) {
      g.farthest[cell] = minimum(g.farthest[cell], depth);
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
    const std::int64_t p = at(maximum(y0, std::int64_t{b.top})), q = at(minimum(y1, std::int64_t{b.bottom}));
    return {minimum(p, q) - 1, maximum(p, q) + 1};
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
    const std::int64_t last_row = row(minimum(b.bottom, whole_.bottom), g.shift);
    for (std::int64_t y = row(maximum(b.top, whole_.top), g.shift); y <= last_row; ++y) {
      const std::int64_t above = whole_.top + (y << g.shift);
      const x_range x = between(e, above, above + (std::int64_t{1} << g.shift));
      const std::int64_t first = column(maximum(x.first, std::int64_t{whole_.left}), g.shift);
      const std::int64_t last = column(minimum(x.last, std::int64_t{whole_.right}), g.shift);
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

inline namespace IRG_ABI {

// Of each edge the first one in the range that has the same ends.
template <class Index = std::size_t, class Edges>
constexpr std::vector<Index> first_alike(const Edges& edges) {
  const auto order = [&](std::size_t i, std::size_t j) {
    const screen_edge &e = edges[i], &f = edges[j];
    for (int k = 0; k < 2; ++k) {
      const screen_vertex &a = e.v[k], &b = f.v[k];
      if (a.position.x != b.position.x) return a.position.x <=> b.position.x;
      if (a.position.y != b.position.y) return a.position.y <=> b.position.y;
      if (a.depth != b.depth) return a.depth < b.depth ? std::strong_ordering::less : std::strong_ordering::greater;
    }
    return std::strong_ordering::equal;
  };
  std::vector<Index> sorted(edges.size(), Index{0}), first(edges.size(), Index{0});
  for (std::size_t i = 0; i < sorted.size(); ++i) sorted[i] = i;
  std::sort(sorted.begin(), sorted.end(), [&](std::size_t i, std::size_t j) {
    const auto o = order(i, j);
    return o != 0 ? o < 0 : i < j;
  });
  for (std::size_t k = 0; k < sorted.size(); ++k)
    first[sorted[k]] = k > 0 && order(sorted[k - 1], sorted[k]) == 0 ? first[sorted[k - 1]] : sorted[k];
  return first;
}

// Finds what is hidden of one edge after another.
template <int Sense, class Faces>
class hidden_part_finder {
public:
  template <class Edges>
  constexpr hidden_part_finder(const Faces& faces, const Edges& edges, face_search search)
      : faces_(faces), last_tried_by_(faces.size(), std::uint32_t{0}), search_(search) {
    if (search == face_search::nearby) faces_.prepare_for(edges);
  }

  // Faces with an area.
  constexpr std::int64_t count() const {
    std::int64_t n = 0;
    for (std::uint32_t i = 0; i < last_tried_by_.size(); ++i)
      n += faces_.nearest(i) > -std::numeric_limits<float>::infinity() ? 1 : 0;
    return n;
  }

  // The hidden parts of an edge, in order and apart from each other.
  constexpr const std::vector<hidden_interval>& find(const hidden_edge& e, hidden_line_counts& counts) {
    hidden_.clear();
    ++edges_;
    if (search_ == face_search::nearby) {
      find_nearby(e, counts);
    } else {
      for (std::uint32_t i = 0; i < last_tried_by_.size(); ++i)
        if (faces_.nearest(i) > -std::numeric_limits<float>::infinity()) try_face(i, e, counts);
    }
    return hidden_.intervals();
  }

private:
  constexpr void find_nearby(const hidden_edge& e, hidden_line_counts& counts) {
    const screen_box box = box_of(e.p);
    const float farthest = minimum(e.depth[0], e.depth[1]);
    // The face that hid all that was left of an edge before may well hide all of this one.
    for (std::uint32_t& face : finishers_) {
      if (face == no_index || !(faces_.nearest(face) > farthest)) continue;
      try_face(face, e, counts);
      if (!hidden_.is_whole()) continue;
      const std::uint32_t first = finishers_[0];
      finishers_[0] = face;
      face = first;
      return;
    }
    faces_.visit_cells(e, [&](const listed_face* i, const listed_face* end) {
      for (; i != end && i->nearest > farthest; ++i) {
        if (!boxes_meet(i->box, box) || last_tried_by_[i->face] == edges_) continue;
        try_face(i->face, e, counts);
        if (!hidden_.is_whole()) continue;
        for (std::size_t k = 3; k > 0; --k) finishers_[k] = finishers_[k - 1];
        finishers_[0] = i->face;
        return true;
      }
      return false;
    });
  }
  constexpr void try_face(std::uint32_t face, const hidden_edge& e, hidden_line_counts& counts) {
    last_tried_by_[face] = edges_;
    ++counts.tried;
    if (const auto interval = interval_hidden_by(faces_.face(face), e)) {
      ++counts.hiding;
      hidden_.add(*interval, e);
    }
  }

  face_grids<Sense, Faces> faces_;
  std::vector<std::uint32_t> last_tried_by_;
  interval_union<hidden_interval> hidden_{};
  std::uint32_t finishers_[4] = {no_index, no_index, no_index, no_index};
  std::uint32_t edges_ = 0;
  face_search search_;
};

}  // namespace IRG_ABI
}  // namespace irg::detail

namespace irg::detail::inline IRG_COMPILED_ABI {

template <class Counts, int Sense, class Faces, class Edges>
IRG_API Counts send_edge_parts(const Faces& faces, const Edges& edges, const function_ref<void(edge_part)>& sink,
                               face_search search) {
  hidden_part_finder<Sense, Faces> finder(faces, edges, search);
  Counts counts;
  counts.faces = finder.count();
  const auto give = [&](std::size_t edge, line_visibility visibility, double from, double to) {
    if (!(from < to)) return;
    ++(visibility == line_visibility::visible ? counts.visible : counts.hidden);
    sink(edge_part{edge, visibility, from, to});
  };
  // What is hidden of edge i stands from starts[i] to starts[i + 1]; of one met before, it stands with the first one.
  struct hidden_places {
    double from, to;
  };
  std::vector<hidden_places> hidden;
  std::vector<std::size_t> starts(edges.size() + 1, std::size_t{0});
  const auto first = first_alike(edges);
  for (std::size_t i = 0; i < edges.size(); ++i) {
    starts[i + 1] = starts[i] = hidden.size();
    const screen_edge& line = edges[i];
    const screen_vertex &a = line.v[0], &b = line.v[1];
    if (a.position == b.position) continue;
    ++counts.edges;
    const auto nearness = [](float depth) { return Sense > 0 ? depth : -depth; };
    const hidden_edge e{{a.position, b.position}, {nearness(a.depth), nearness(b.depth)}};
    if (first[i] == i || search == face_search::every)
      for (const hidden_interval& h : finder.find(e, counts))
        hidden.push_back({place_of(h.from, e), place_of(h.to, e)});
    starts[i + 1] = hidden.size();
    const std::size_t source = starts[i] == starts[i + 1] ? first[i] : i;
    double seen_from = 0;
    for (std::size_t k = starts[source]; k < starts[source + 1]; ++k) {
      give(i, line_visibility::visible, seen_from, hidden[k].from);
      give(i, line_visibility::hidden, hidden[k].from, hidden[k].to);
      seen_from = hidden[k].to;
    }
    give(i, line_visibility::visible, seen_from, 1.0);
  }
  return counts;
}

}  // namespace irg::detail::inline IRG_COMPILED_ABI
#endif
