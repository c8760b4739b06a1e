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
#include <vector>

#include <irg/hidden/detail/cell_outlines.hpp>
#include <irg/hidden/hidden_lines.hpp>
#include <irg/math/vec.hpp>

namespace irg {

/// A ring of a visible region: `count` corners from corners[first] on.
/// shape   the region lies on one side of it: outer rings have a positive signed area (clockwise as seen, y being
///         down), rings of holes a negative one. no_face is the background
struct visible_ring {
  std::uint32_t number = no_face;
  std::size_t first = 0, count = 0;
};

/// A window cut into visible regions.
/// shape   rings by their numbers; corners: indices into `places`, which are in pixels, sorted by x, then y, as they
///         were before they were rounded
struct visible_polygon_map {
  std::vector<point<double, 2>> places{};
  std::vector<std::uint32_t> corners{};
  std::vector<visible_ring> rings{};
  std::size_t cells = 0;  // convex ones, of which the regions were put together
};

namespace detail {
inline namespace IRG_ABI {

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

}  // namespace IRG_ABI
}  // namespace detail

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
  requires(detail::depth_sense<Order> != 0)
[[nodiscard]] constexpr visible_polygon_map visible_polygons(const Faces& faces, const cell_window& window) {
  visible_polygon_map map;
  if (window.empty()) return map;
  std::vector<detail::hiding_face> hiding;
  std::vector<std::uint32_t> numbers;
  for (std::size_t i = 0; i < faces.size(); ++i) {
    const screen_face& f = faces[i];
    if (f.coverage.double_area == 0) continue;
    hiding.push_back(detail::hiding_face_of<detail::depth_sense<Order>>(f));
    numbers.push_back(f.number);
  }
  using cutter_type = detail::window_cutter<detail::hiding_face>;
  cutter_type cutter(hiding, numbers);
  cutter.cut(window);
  const detail::cell_outlines<cutter_type> outlines(cutter);
  std::vector<std::uint32_t> place_of_point(outlines.points.size(), 0u);
  for (const detail::outline_step& s : outlines.steps) place_of_point[s.from] = 1;
  for (std::size_t i = 0; i < place_of_point.size(); ++i) {
    if (place_of_point[i] == 0) continue;
    const detail::picture_point& p = cutter.points[outlines.points[i]];
    place_of_point[i] = static_cast<std::uint32_t>(map.places.size());
    map.places.push_back({p.x / one_pixel, p.y / one_pixel});
  }
  detail::link_outlines(outlines.steps, map);
  for (std::uint32_t& c : map.corners) c = place_of_point[c];
  map.cells = cutter.cells.size();
  return map;
}

/// The corner i of a ring, in pixels.
/// needs   i < ring.count
[[nodiscard]] constexpr point<double, 2> corner_of(const visible_polygon_map& map, const visible_ring& ring,
                                                   std::size_t i) noexcept {
  return map.places[map.corners[ring.first + i]];
}

}  // namespace IRG_ABI
}  // namespace irg
