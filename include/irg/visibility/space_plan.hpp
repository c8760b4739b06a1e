// SPDX-License-Identifier: MIT
// space_plan: a building as convex cells of space, and the flat convex openings between them through which one sees.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <irg/core/scalar.hpp>
#include <irg/geometry/orient3d.hpp>
#include <irg/math/vec.hpp>
#if IRG_BODIES
#include <irg/core/is_finite.hpp>
#include <irg/geometry/orient2d.hpp>
#include <irg/geometry/point_in_convex_polygon.hpp>
#include <irg/geometry/polygon_convexity.hpp>
#endif

namespace irg {

/// An opening between two cells, counter-clockwise as one sees it who passes from the first to the second.
template <Floating T>
struct space_portal {
  std::uint32_t first = 0, second = 0;
  std::vector<point<T, 3>> ring;
  bool operator==(const space_portal&) const = default;
};

/// A face of a cell: numbers of its corners, counter-clockwise as seen from outside.
using space_face = std::vector<std::uint32_t>;

/// Convex cells, each the hull of its corners, and portals between them.
template <Floating T>
struct space_plan {
  std::vector<std::vector<point<T, 3>>> cells;
  std::vector<space_portal<T>> portals;
  std::vector<std::vector<space_face>> faces{};  ///< of each cell; where there are none, its hull is not looked at
  bool operator==(const space_plan&) const = default;
};

/// What is wrong with a plan in space.
enum class space_plan_defect {
  none,
  corner_not_finite,  ///< a coordinate of a cell's corner is infinite or NaN
  face_without_area,  ///< a face has fewer than three corners of the cell, or the first three are on a line
  face_not_flat,  ///< its corners are not in one plane
  face_not_convex,  ///< a corner turns inwards, or the face goes round more than once
  cell_not_convex,  ///< a corner of the cell is before one of its faces
  cell_without_volume,  ///< all corners are in one plane
  cell_not_closed,  ///< an edge of a face has no other face, or more than one, on its other side
  portal_to_no_cell,  ///< it names a cell that the plan does not have
  portal_to_itself,  ///< both of its cells are the same: mirrors are no portals
  portal_without_area,  ///< fewer than three corners, or the first three are on a line
  portal_not_flat,  ///< its corners are not in one plane, or are not finite
  portal_not_convex,  ///< a corner turns inwards, or the ring goes round more than once
  cell_on_both_sides,  ///< the first cell is not before the portal's plane, or the second not behind it
  portal_off_the_wall,  ///< no face of one of its cells holds it whole
};

/// The first defect of a plan: of the portal number `portal`, or of a cell, or its face number `face`.
struct space_plan_finding {
  space_plan_defect defect = space_plan_defect::none;
  std::size_t portal = 0, cell = 0, face = 0;
  bool operator==(const space_plan_finding&) const = default;
};

inline namespace IRG_ABI {

/// Whether all points lie on one side of the plane of a ring, or in it.
/// shape   side is 1 for where the ring is seen counter-clockwise, -1 for the other side
/// needs   three corners that are not on a line at the beginning of the ring; finite points
/// exact   as orient3d
template <Floating T>
[[nodiscard]] constexpr bool are_on_side(std::span<const point<T, 3>> ring, std::span<const point<T, 3>> points,
                                         int side) noexcept {
  for (const auto& p : points)
    if (orient3d(ring[0], ring[1], ring[2], p) == -side) return false;
  return true;
}

}  // namespace IRG_ABI

inline namespace IRG_COMPILED_ABI {

/// The first thing that is wrong with a plan in space, cells first.
/// exact   for all coordinates, infinities and NaN included
/// cost    the faces times the corners of each cell, the corners of both cells for each portal, and the corners of
///         their faces times its own
template <Floating T>
[[nodiscard]] IRG_API space_plan_finding validate(const space_plan<T>& plan);

}  // namespace IRG_COMPILED_ABI
}  // namespace irg

#if IRG_BODIES
namespace irg::detail::inline IRG_ABI {

// A ring in two of its coordinates, in which its first three corners are not on a line; empty where there are none.
template <Floating T>
constexpr std::vector<point<T, 2>> flattened(const std::vector<point<T, 3>>& ring, int& dropped) {
  std::vector<point<T, 2>> flat(ring.size(), point<T, 2>{});
  for (dropped = 0; dropped < 3; ++dropped) {
    for (std::size_t i = 0; i < ring.size(); ++i) flat[i] = {ring[i][(dropped + 1) % 3], ring[i][(dropped + 2) % 3]};
    if (flat.size() > 2 && orient2d(flat[0], flat[1], flat[2]) != 0) return flat;
  }
  return {};
}

// What is wrong with a ring, of the names for that: without an area, not flat, not convex.
template <Floating T>
constexpr space_plan_defect defect_of_ring(const std::vector<point<T, 3>>& ring,
                                           const std::array<space_plan_defect, 3>& names) {
  if (ring.size() < 3) return names[0];
  for (const auto& v : ring)
    if (!is_finite(v)) return names[1];
  for (const auto& v : ring)
    if (orient3d(ring[0], ring[1], ring[2], v) != 0) return names[1];
  int dropped = 0;
  const auto flat = flattened(ring, dropped);
  if (flat.empty()) return names[0];
  return is_convex(flat) ? space_plan_defect::none : names[2];
}

template <Floating T>
class space_plan_check {
public:
  constexpr explicit space_plan_check(const space_plan<T>& plan) noexcept : plan_(plan) {}

  constexpr space_plan_finding run() {
    for (std::size_t c = 0; c < plan_.cells.size(); ++c)
      if (const auto d = defect_of_cell(c); d != space_plan_defect::none) return {d, 0, c, face_};
    for (std::size_t i = 0; i < plan_.portals.size(); ++i)
      if (const auto d = defect_of_portal(plan_.portals[i]); d != space_plan_defect::none) return {d, i, 0, 0};
    return {};
  }

private:
  const space_plan<T>& plan_;
  std::size_t face_ = 0;

  constexpr std::span<const space_face> faces_of(std::size_t cell) const noexcept {
    return cell < plan_.faces.size() ? std::span<const space_face>(plan_.faces[cell]) : std::span<const space_face>{};
  }
  constexpr std::vector<point<T, 3>> ring_of(std::size_t cell, const space_face& face) const {
    std::vector<point<T, 3>> ring;
    for (const std::uint32_t v : face)
      if (v < plan_.cells[cell].size()) ring.push_back(plan_.cells[cell][v]);
    return ring;
  }

  constexpr space_plan_defect defect_of_cell(std::size_t cell) {
    using enum space_plan_defect;
    face_ = 0;
    const std::span<const point<T, 3>> corners = plan_.cells[cell];
    for (const auto& p : corners)
      if (!is_finite(p)) return corner_not_finite;
    std::vector<std::array<std::uint32_t, 2>> edges;
    for (const space_face& face : faces_of(cell)) {
      const auto ring = ring_of(cell, face);
      if (ring.size() != face.size()) return face_without_area;
      if (const auto d = defect_of_ring<T>(ring, {face_without_area, face_not_flat, face_not_convex}); d != none)
        return d;
      if (!are_on_side<T>(ring, corners, -1)) return cell_not_convex;
      if (are_on_side<T>(ring, corners, 1)) return cell_without_volume;
      for (std::size_t i = 0; i < face.size(); ++i) edges.push_back({face[i], face[i + 1 < face.size() ? i + 1 : 0]});
      ++face_;
    }
    face_ = 0;
    std::sort(edges.begin(), edges.end());
    for (std::size_t i = 0; i < edges.size(); ++i) {
      const std::array<std::uint32_t, 2> back{edges[i][1], edges[i][0]};
      if ((i > 0 && edges[i] == edges[i - 1]) || !std::binary_search(edges.begin(), edges.end(), back))
        return cell_not_closed;
    }
    return none;
  }

  constexpr space_plan_defect defect_of_portal(const space_portal<T>& p) const {
    using enum space_plan_defect;
    if (p.first >= plan_.cells.size() || p.second >= plan_.cells.size()) return portal_to_no_cell;
    if (p.first == p.second) return portal_to_itself;
    if (const auto d = defect_of_ring<T>(p.ring, {portal_without_area, portal_not_flat, portal_not_convex}); d != none)
      return d;
    if (!are_on_side<T>(p.ring, plan_.cells[p.first], 1) || !are_on_side<T>(p.ring, plan_.cells[p.second], -1))
      return cell_on_both_sides;
    return is_in_wall(p.first, p.ring) && is_in_wall(p.second, p.ring) ? none : portal_off_the_wall;
  }

  constexpr bool is_in_wall(std::size_t cell, const std::vector<point<T, 3>>& portal) const {
    for (const space_face& face : faces_of(cell)) {
      const auto ring = ring_of(cell, face);
      int dropped = 0;
      const auto flat = flattened(ring, dropped);
      bool is_within = true;
      for (const auto& v : portal) {
        const point<T, 2> p{v[(dropped + 1) % 3], v[(dropped + 2) % 3]};
        is_within = is_within && orient3d(ring[0], ring[1], ring[2], v) == 0 &&
                    point_in_convex_polygon(flat, p) != location::outside;
      }
      if (is_within) return true;
    }
    return faces_of(cell).empty();
  }
};

}  // namespace irg::detail::inline IRG_ABI

namespace irg::inline IRG_COMPILED_ABI {

template <Floating T>
[[nodiscard]] IRG_API space_plan_finding validate(const space_plan<T>& plan) {
  return detail::space_plan_check<T>(plan).run();
}

}  // namespace irg::inline IRG_COMPILED_ABI
#endif
