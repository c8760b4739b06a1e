// SPDX-License-Identifier: MIT
// Visible polygons: a window of the picture cut into regions, each with the number of the face that is seen there, as
// rings of corners. A face is seen where its corners, sides and plane say so, at every point and not only at centres
// of pixels: of faces over a point the nearest, of equally near ones that of the lowest number.
//
// Which regions there are and how they meet is decided exactly, on corners snapped to 1/256 of a pixel and depths as
// floats. Corners of rings are corners of faces, meetings of two sides, of a side with the line where two planes are
// equally deep, or of two such lines; they are rounded once, and shared by all regions that meet there.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include <irg/core/vocabulary.hpp>
#include <irg/hidden/detail/with_items.hpp>
#include <irg/math/vec.hpp>
#include <irg/raster/face_order.hpp>
#if IRG_BODIES
#include <irg/hidden/detail/window_cells.hpp>
#include <irg/hidden/hidden_lines.hpp>
#endif

namespace irg {

/// A ring of a visible region: `count` corners from corners[first] on.
/// shape   the region lies on one side of it: outer rings have a positive signed area (clockwise as seen, y being
///         down), rings of holes a negative one. no_index is the background
struct visible_ring {
  std::uint32_t number = no_index;
  std::size_t first = 0, count = 0;
  bool operator==(const visible_ring&) const = default;
};

/// A window cut into visible regions.
/// shape   rings by their numbers; corners: indices into `places`, which are in pixels, sorted by x, then y, as they
///         were before they were rounded
struct visible_polygon_map {
  std::vector<point<double, 2>> places{};
  std::vector<std::uint32_t> corners{};
  std::vector<visible_ring> rings{};
  std::size_t cells = 0;  // convex ones, of which the regions were put together
  bool operator==(const visible_polygon_map&) const = default;
};

inline namespace IRG_ABI {

/// The window cut into regions by the faces that are seen in it.
/// shape   faces is a range with size() and [i], of screen_face
/// units   pixels
/// needs   the window and positions within snap_limit pixels of the origin, finite depths
/// gives   regions that fill the window without gaps or overlap: where two of them meet, both have the same corners,
///         bit for bit, in opposite order. A corner stands only where a boundary turns or another one ends. A ring may
///         touch itself or others of its number in a corner. Pieces of one number are one region. Faces without area
///         are not seen; an empty window has no rings
/// exact   everything but the places, which are rounded to the nearest 2^-30 of a pixel: one map for every order of the
///         faces. Places closer than that may fall together, and rings become thinner than nothing by as much
/// cost    about n log n cells for faces of like sizes, each allocated; grows with the visible crossings of sides
template <DepthOrder Order = nearer_is_greater, class Faces>
  requires(depth_sense<Order> != 0)
[[nodiscard]] constexpr visible_polygon_map visible_polygons(const Faces& faces, const cell_window& window);

/// The corner i of a ring, in pixels.
/// needs   i < ring.count
[[nodiscard]] constexpr point<double, 2> corner_of(const visible_polygon_map& map, const visible_ring& ring,
                                                   std::size_t i) noexcept {
  return map.places[map.corners[ring.first + i]];
}

}  // namespace IRG_ABI

namespace detail::inline IRG_COMPILED_ABI {

template <class Map, int Sense, class Faces>
IRG_API Map map_of_window(const Faces& faces, const cell_window& window);

}  // namespace detail::inline IRG_COMPILED_ABI

inline namespace IRG_ABI {

template <DepthOrder Order, class Faces>
  requires(depth_sense<Order> != 0)
[[nodiscard]] constexpr visible_polygon_map visible_polygons(const Faces& faces, const cell_window& window) {
  return detail::with_items<screen_face>(faces, [&](const auto& of_faces) {
    return detail::map_of_window<visible_polygon_map, depth_sense<Order>>(of_faces, window);
  });
}

}  // namespace IRG_ABI
}  // namespace irg

#if IRG_BODIES
namespace irg::detail::inline IRG_ABI {

// From cells to the outlines of what they show: points that are one are found exactly, boundaries between cells of one
// number vanish, and what is left is cut where outlines meet and nowhere else, and linked to rings.

inline constexpr std::uint64_t beside_window = std::uint64_t{1} << 32;

// A part of a line between two points, by their order, and the numbers on both sides of it.
struct outline_part {
  std::uint32_t line = 0, from = 0, to = 0;
  std::uint64_t number[2] = {beside_window, beside_window};  // of which it is part of a ring from `from` to `to`; back
};
struct outline_step {
  std::uint32_t number, from, to;
  friend constexpr bool operator<(const outline_step& a, const outline_step& b) noexcept {
    return a.number != b.number ? a.number < b.number : a.from != b.from ? a.from < b.from : a.to < b.to;
  }
};

template <class Cells>
struct cell_outlines {
  const Cells& cells;
  std::vector<std::uint32_t> points{};  // one of each place, by x, then y
  std::vector<std::uint32_t> rank{};  // of each point of the cells its place
  std::vector<outline_part> parts{};
  std::vector<outline_step> steps{};  // of all rings
  std::vector<std::uint32_t> places{};  // on one line
};

template <class Outlines>
constexpr void order_points(Outlines& o) {
  const auto& all = o.cells.points;
  std::vector<std::uint32_t> sorted(all.size(), 0u);
  for (std::size_t i = 0; i < all.size(); ++i) sorted[i] = static_cast<std::uint32_t>(i);
  const auto order = [&](std::uint32_t i, std::uint32_t j) {
    const int by_x = compare_coordinate(o.cells, 0, all[i], all[j]);
    return by_x != 0 ? by_x : compare_coordinate(o.cells, 1, all[i], all[j]);
  };
  std::sort(sorted.begin(), sorted.end(), [&](std::uint32_t i, std::uint32_t j) { return order(i, j) < 0; });
  o.rank.assign(all.size(), 0u);
  for (const std::uint32_t i : sorted) {
    if (o.points.empty() || order(o.points.back(), i) != 0) o.points.push_back(i);
    o.rank[i] = static_cast<std::uint32_t>(o.points.size() - 1);
  }
}

// The parts of either side of a line lie apart from each other and come in order.
template <class Outlines>
constexpr void collect_line(Outlines& o, std::span<const outline_part> sides) {
  o.places.clear();
  for (const outline_part& s : sides) {
    o.places.push_back(s.from);
    o.places.push_back(s.to);
  }
  std::sort(o.places.begin(), o.places.end());
  o.places.erase(std::unique(o.places.begin(), o.places.end()), o.places.end());
  std::size_t next = 0;
  outline_part on[2];
  for (std::size_t k = 0; k + 1 < o.places.size(); ++k) {
    for (; next < sides.size() && sides[next].from == o.places[k]; ++next)
      on[sides[next].number[0] == beside_window ? 1 : 0] = sides[next];
    outline_part part{sides[0].line, o.places[k], o.places[k + 1]};
    for (int s = 0; s < 2; ++s)
      if (on[s].to > o.places[k]) part.number[s] = on[s].number[s];
    if (part.number[0] != part.number[1]) o.parts.push_back(part);
  }
}

// Along each line by which cells were parted, the numbers on both sides: places on a line have the order of points.
template <class Outlines>
constexpr void collect_parts(Outlines& o) {
  std::vector<outline_part> sides;
  for (const finished_cell& cell : o.cells.cells)
    for (std::size_t i = 0; i < cell.corners.size(); ++i) {
      const cell_corner& c = cell.corners[i];
      const cell_corner& next = cell.corners[i + 1 == cell.corners.size() ? 0 : i + 1];
      outline_part part{c.line, o.rank[c.point], o.rank[next.point]};
      const bool back = part.from > part.to;
      if (back) std::swap(part.from, part.to);
      part.number[back ? 1 : 0] = cell.number;
      sides.push_back(part);
    }
  std::sort(sides.begin(), sides.end(), [](const outline_part& a, const outline_part& b) {
    return a.line != b.line ? a.line < b.line : a.from != b.from ? a.from < b.from : a.number[0] < b.number[0];
  });
  for (std::size_t i = 0, end = 0; i < sides.size(); i = end) {
    while (end < sides.size() && sides[end].line == sides[i].line) ++end;
    collect_line(o, {sides.data() + i, end - i});
  }
}

// Parts that only continue each other become one.
template <class Outlines>
constexpr void join_outlines(Outlines& o) {
  struct ends {
    std::uint32_t count = 0, to = 0, from = 0;
  };
  std::vector<ends> at(o.points.size(), ends{});
  for (std::size_t i = 0; i < o.parts.size(); ++i) {
    ends &start = at[o.parts[i].from], &end = at[o.parts[i].to];
    ++start.count;
    ++end.count;
    start.from = static_cast<std::uint32_t>(i + 1);
    end.to = static_cast<std::uint32_t>(i + 1);
  }
  const auto goes_on = [&](std::uint32_t place) {
    const ends& e = at[place];
    return e.count == 2 && e.to != 0 && e.from != 0 &&
           have_one_direction(o.cells, o.cells.lines[o.parts[e.to - 1].line], o.cells.lines[o.parts[e.from - 1].line]);
  };
  std::vector<std::uint8_t> passed(o.points.size(), std::uint8_t{0});
  for (std::size_t i = 0; i < passed.size(); ++i)
    passed[i] = goes_on(static_cast<std::uint32_t>(i)) ? std::uint8_t{1} : std::uint8_t{0};
  for (const outline_part& p : o.parts) {
    if (passed[p.from] != 0) continue;
    std::uint32_t to = p.to;
    while (passed[to] != 0) to = o.parts[at[to].from - 1].to;
    if (p.number[0] != beside_window) o.steps.push_back({static_cast<std::uint32_t>(p.number[0]), p.from, to});
    if (p.number[1] != beside_window) o.steps.push_back({static_cast<std::uint32_t>(p.number[1]), to, p.from});
  }
  std::sort(o.steps.begin(), o.steps.end());
}

// Links steps, sorted by number and start, to rings.
template <class Step>
constexpr void link_outlines(const std::vector<Step>& steps, visible_polygon_map& map) {
  std::vector<std::uint8_t> used(steps.size(), std::uint8_t{0});
  std::vector<std::size_t> next_free(steps.size(), std::size_t{0});  // of the steps that start where this one does
  const auto step_from = [&](std::uint32_t number, std::uint32_t from) {
    const auto first =
        static_cast<std::size_t>(std::lower_bound(steps.begin(), steps.end(), Step{number, from, 0}) - steps.begin());
    std::size_t& skip = next_free[first];
    while (used[first + skip] != 0) ++skip;
    return first + skip;
  };
  for (std::size_t i = 0; i < steps.size(); ++i) {
    if (used[i] != 0) continue;
    visible_ring ring{steps[i].number, map.corners.size(), 0};
    for (std::size_t k = i;;) {
      used[k] = 1;
      map.corners.push_back(steps[k].from);
      ++ring.count;
      if (steps[k].to == steps[i].from) break;
      k = step_from(ring.number, steps[k].to);
    }
    map.rings.push_back(ring);
  }
}

}  // namespace irg::detail::inline IRG_ABI

namespace irg::detail::inline IRG_COMPILED_ABI {

template <class Map, int Sense, class Faces>
IRG_API Map map_of_window(const Faces& faces, const cell_window& window) {
  Map map;
  if (window.empty()) return map;
  std::vector<hiding_face> hiding;
  std::vector<std::uint32_t> numbers;
  for (std::size_t i = 0; i < faces.size(); ++i) {
    const screen_face& f = faces[i];
    if (f.coverage.double_area == 0) continue;
    hiding.push_back(hiding_face_of<Sense>(f));
    numbers.push_back(f.number);
  }
  window_cutting<hiding_face> cells{hiding, numbers};
  cut_into_cells(cells, window);
  cell_outlines<decltype(cells)> outlines{cells};
  order_points(outlines);
  collect_parts(outlines);
  join_outlines(outlines);
  std::vector<std::uint32_t> place_of_point(outlines.points.size(), 0u);
  for (const outline_step& s : outlines.steps) place_of_point[s.from] = 1;
  for (std::size_t i = 0; i < place_of_point.size(); ++i) {
    if (place_of_point[i] == 0) continue;
    const picture_point& p = cells.points[outlines.points[i]];
    place_of_point[i] = static_cast<std::uint32_t>(map.places.size());
    map.places.push_back({p.x / one_pixel, p.y / one_pixel});
  }
  link_outlines(outlines.steps, map);
  for (std::uint32_t& c : map.corners) c = place_of_point[c];
  map.cells = cells.cells.size();
  return map;
}

}  // namespace irg::detail::inline IRG_COMPILED_ABI
#endif
