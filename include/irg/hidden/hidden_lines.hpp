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
#include <vector>

#include <irg/hidden/detail/face_grids.hpp>
#include <irg/hidden/detail/hidden_intervals.hpp>
#include <irg/hidden/edge_part.hpp>
#include <irg/raster/face_order.hpp>

namespace irg {

/// An edge on the screen, between two vertices.
struct screen_edge {
  screen_vertex v[2];
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
};

namespace detail {

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
template <int Sense, class Faces, class Interval = hidden_interval>
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
  constexpr const std::vector<Interval>& find(const hidden_edge& e, hidden_line_counts& counts) {
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
    const float farthest = lesser(e.depth[0], e.depth[1]);
    // The face that hid all that was left of an edge before may well hide all of this one.
    for (std::uint32_t& face : finishers_) {
      if (face == no_face || !(faces_.nearest(face) > farthest)) continue;
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
  interval_union<Interval> hidden_{};
  std::uint32_t finishers_[4] = {no_face, no_face, no_face, no_face};
  std::uint32_t edges_ = 0;
  face_search search_;
};

}  // namespace IRG_ABI
}  // namespace detail

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
  requires(detail::depth_sense<Order> != 0)
constexpr hidden_line_counts hidden_lines(const Faces& faces, const Edges& edges, Emit&& sink,
                                          face_search search = face_search::nearby) {
  constexpr int sense = detail::depth_sense<Order>;
  detail::hidden_part_finder<sense, Faces> finder(faces, edges, search);
  hidden_line_counts counts;
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
  const auto first = detail::first_alike(edges);
  for (std::size_t i = 0; i < edges.size(); ++i) {
    starts[i + 1] = starts[i] = hidden.size();
    const screen_edge& line = edges[i];
    const screen_vertex &a = line.v[0], &b = line.v[1];
    if (a.position == b.position) continue;
    ++counts.edges;
    const auto nearness = [](float depth) { return sense > 0 ? depth : -depth; };
    const detail::hidden_edge e{{a.position, b.position}, {nearness(a.depth), nearness(b.depth)}};
    if (first[i] == i || search == face_search::every)
      for (const detail::hidden_interval& h : finder.find(e, counts))
        hidden.push_back({detail::place_of(h.from, e), detail::place_of(h.to, e)});
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
}  // namespace irg
