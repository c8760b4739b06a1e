// SPDX-License-Identifier: MIT
// render_rooms: a building becomes a picture, and the rooms that no portal shows are skipped whole.
//
// The portals' rectangles in the picture decide, as in Luebke and Georges, one pixel wider on each side, since corners
// in a picture are rounded. Each room keeps one rectangle, which grows until nothing changes: loops of portals end.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <irg/core/contract.hpp>
#include <irg/core/executor.hpp>
#include <irg/core/sinks.hpp>
#include <irg/render/prepared_scene.hpp>
#include <irg/render/render.hpp>
#include <irg/visibility/cell_plan.hpp>
#if IRG_BODIES
#include <limits>
#include <utility>

#include <irg/geometry/box.hpp>
#include <irg/geometry/clip_homogeneous.hpp>
#include <irg/math/trigonometry.hpp>
#include <irg/raster/window.hpp>
#include <irg/visibility/view_through_portals.hpp>
#endif

namespace irg {

/// A building made ready for pictures.
/// shape   object c of the scene is what is in the cell c of the plan; what comes after them is in no cell
template <Floating T>
struct prepared_rooms {
  cell_plan<T> plan;
  portal_graph<T> doors;
  prepared_scene<T> world;
};

inline namespace IRG_COMPILED_ABI {

/// For each cell the pixels of a picture in which something of it may be seen; an empty window where nothing can.
/// needs   a plan without defects, its graph, a size from 1 x 1 to 65536 x 65536
/// gives   too much, never too little, of what rays from the near plane's points in cells see: rectangles, one pixel
///         wider than what they hold, and the whole picture for each cell that is near enough to hold such a point, or
///         for all when none is, and in parallel projections, whose rays come from outside
/// exact   rounded; the pixel more covers it as long as near_distance is greater than the rounding of the coordinates
/// cost    the portals that are seen, each projected once; a room is looked at again where its rectangle grows
/// source  Luebke and Georges 1995
template <Floating T>
[[nodiscard]] IRG_API std::vector<cell_window> visible_rooms(const cell_plan<T>& plan, const portal_graph<T>& doors,
                                                             const camera<T>& view, const extent2& size);

}  // namespace IRG_COMPILED_ABI

inline namespace IRG_ABI {

template <Floating T>
[[nodiscard, deprecated("irg: visible_rooms(plan, doors, view, {width, height})")]] constexpr std::vector<cell_window>
visible_rooms(const cell_plan<T>& plan, const portal_graph<T>& doors, const camera<T>& view, int width, int height) {
  return visible_rooms(plan, doors, view, {width, height});
}

/// Renders a building into a picture and its depth buffer, both overwritten, and returns what it did.
/// needs   as render(); a plan without defects and its graph, an object for each of its cells. What is in a cell lies
///         in it, and faces close it but for its portals, as in a room_mesh. An eye so far from walls to the outside
///         that the near plane does not reach through them: what it would show of rooms from outside may be skipped
/// gives   the triangles of rooms that are skipped as skipped.rooms
/// exact   the same bytes with all skips on and off, for rooms made by room_mesh with walls that have a thickness, no
///         two doors ending at one point. Where rooms touch back to back, a triangle of a skipped one that is thinner
///         than a 256th of a pixel may have shown its back as front: about one pixel in 5 million
/// cost    as render(), for the rooms that are seen
template <Floating T, RowRaster Colour = image_view<rgba8>, RowRaster Depth = image_view<float>,
          Executor E = sequential>
  requires std::same_as<pixel_of<Colour>, rgba8> && std::same_as<pixel_of<Depth>, float>
constexpr render_counts render(prepared_rooms<T>& building, render_target<Colour, Depth> target,
                               const render_options& options = {}, const E& executor = {});

}  // namespace IRG_ABI
}  // namespace irg

namespace irg::detail::inline IRG_COMPILED_ABI {

template <Floating T, class Colour, class Depth>
IRG_API render_counts render_building(prepared_rooms<T>& building, const render_options& options,
                                      const picture_run<Colour, Depth>& run);

}  // namespace irg::detail::inline IRG_COMPILED_ABI

namespace irg::inline IRG_ABI {

template <Floating T, RowRaster Colour, RowRaster Depth, Executor E>
  requires std::same_as<pixel_of<Colour>, rgba8> && std::same_as<pixel_of<Depth>, float>
constexpr render_counts render(prepared_rooms<T>& building, render_target<Colour, Depth> target,
                               const render_options& options, const E& executor) {
  IRG_EXPECTS(building.world.objects.size() >= building.plan.cells.size());
  const no_observer observer;
  return detail::on_rows_of(target, [&](auto& colour, auto& depth) {
    return detail::render_building(
        building, options,
        detail::picture_run{colour, depth, as_executor(executor), as_function<void(render_stage)>(observer)});
  });
}

}  // namespace irg::inline IRG_ABI

#if IRG_BODIES
namespace irg::detail::inline IRG_ABI {

// Which pixels may show something of each room of a building, by the rectangles of its portals.

template <class T>
class room_windows {
public:
  constexpr room_windows(const cell_plan<T>& plan, const camera<T>& view, const cell_window& picture)
      : plan_(plan), view_(view), picture_(picture),
        to_clip_(view_projection(view, static_cast<T>(picture.x_last) / static_cast<T>(picture.y_last))),
        seen_(plan.cells.size(), cell_window{}) {}

  constexpr std::vector<cell_window> find(const portal_graph<T>& doors) {
    std::vector<std::uint32_t> changed;
    for (std::uint32_t c = 0; c < seen_.size(); ++c) {
      if (!is_in_reach(plan_.cells[c])) continue;
      seen_[c] = picture_;
      changed.push_back(c);
    }
    if (changed.empty() || view_.projection != projection_kind::perspective)
      seen_.assign(seen_.size(), picture_);
    else
      follow(doors, changed);
    return std::move(seen_);
  }

private:
  static constexpr cell_window not_known{-1, -1, -2, -2};

  constexpr void follow(const portal_graph<T>& doors, std::vector<std::uint32_t>& changed) {
    std::vector<cell_window> portals(plan_.portals.size(), not_known);
    while (!changed.empty()) {
      const std::uint32_t c = changed.back();
      changed.pop_back();
      for (const doorway<T>& d : doors.doors(c)) {
        if (portals[d.portal] == not_known) portals[d.portal] = window_of_door(d);
        const cell_window shown = intersect(seen_[c], portals[d.portal]);
        const cell_window grown = around(seen_[d.to], shown);
        if (grown == seen_[d.to]) continue;
        seen_[d.to] = grown;
        changed.push_back(d.to);
      }
    }
  }

  static constexpr cell_window around(const cell_window& a, const cell_window& b) noexcept {
    if (a.empty() || b.empty()) return a.empty() && !b.empty() ? b : a;
    return {minimum(a.x_first, b.x_first), minimum(a.y_first, b.y_first), maximum(a.x_last, b.x_last),
            maximum(a.y_last, b.y_last)};
  }

  // Whether a point of the near plane may lie in a cell, so that rays begin in it.
  constexpr bool is_in_reach(const plan_cell<T>& c) const noexcept {
    const T t = tan(view_.vertical_angle / T(2)),
            wide = static_cast<T>(picture_.x_last) / static_cast<T>(picture_.y_last);
    const T reach = view_.near_distance * (T(1) + t + t * wide);  // more than to the corners of the picture
    box<T, 3> b{};
    for (const point<T, 2>& p : c.corners)
      for (const T& z : {c.floor, c.ceiling}) b = bounding_box(b, point<T, 3>{p.x, p.y, z});
    bool is_near = true;
    for (int i = 0; i < 3; ++i)
      is_near = is_near && b.low[i] - reach <= view_.eye[i] && view_.eye[i] <= b.high[i] + reach;
    return is_near;
  }

  // The pixels in which an opening may show something, and one more on each side.
  constexpr cell_window window_of_door(const doorway<T>& d) const {
    const auto opening = opening_of(plan_, d);
    if (!(opening[0].z < opening[2].z)) return {};
    clip_vertex<T, 0> corners[4]{};
    for (std::size_t i = 0; i < 4; ++i) {
      corners[i].position = to_clip_ * hpoint<T, 3>{opening[i].x, opening[i].y, opening[i].z, T(1)};
      for (int k = 0; k < 4; ++k)
        if (!(magnitude(corners[i].position[k]) < (std::numeric_limits<T>::max)() / T(64))) return picture_;
    }
    const auto kept = clip_homogeneous(corners, clip_volume<T>{clip_planes::sides, T(2), T(2)});
    cell_window out{};
    for (const auto& v : kept) {
      if (!(T(0) < v.position.w)) return picture_;
      const auto pixel = [](T x, T w, int size) {
        return static_cast<int>((x / w + T(1)) * (static_cast<T>(size) / T(2)) + T(size)) - size;  // rounded down
      };
      const int x = pixel(v.position.x, v.position.w, picture_.x_last);
      const int y = pixel(-v.position.y, v.position.w, picture_.y_last);
      out = around(out, {x - 1, y - 1, x + 2, y + 2});
    }
    return intersect(out, picture_);
  }

  const cell_plan<T>& plan_;
  const camera<T>& view_;
  cell_window picture_;
  mat<T, 4, 4> to_clip_;
  std::vector<cell_window> seen_;
};

}  // namespace irg::detail::inline IRG_ABI

namespace irg::inline IRG_COMPILED_ABI {

template <Floating T>
[[nodiscard]] IRG_API std::vector<cell_window> visible_rooms(const cell_plan<T>& plan, const portal_graph<T>& doors,
                                                             const camera<T>& view, const extent2& size) {
  IRG_EXPECTS(size.width >= 1 && size.height >= 1);
  return detail::room_windows<T>(plan, view, {0, 0, size.width, size.height}).find(doors);
}

}  // namespace irg::inline IRG_COMPILED_ABI

namespace irg::detail::inline IRG_COMPILED_ABI {

template <Floating T, class Colour, class Depth>
IRG_API render_counts render_building(prepared_rooms<T>& building, const render_options& options,
                                      const picture_run<Colour, Depth>& run) {
  const int width = width_of(run.colour), height = height_of(run.colour);
  if (width == 0 || height == 0) return {};
  std::vector<std::uint32_t> candidates;
  std::vector<cell_window> windows(building.plan.cells.size(), cell_window{0, 0, width, height});
  if (options.skip.rooms == skipping::on)
    windows = visible_rooms(building.plan, building.doors, building.world.view, {width, height});
  std::int64_t skipped = 0;
  for (std::uint32_t i = 0; i < building.world.objects.size(); ++i)
    if (i < windows.size() && windows[i].empty())
      skipped += static_cast<std::int64_t>(building.world.objects[i].body.triangles.size());
    else
      candidates.push_back(i);
  render_counts stats = draw_picture<T>({building.world, width, height, options}, {building.world.objects}, candidates,
                                        lists_of(building.world.workspace), run);
  stats.triangles += skipped;
  stats.skipped.rooms += skipped;
  return stats;
}

}  // namespace irg::detail::inline IRG_COMPILED_ABI
#endif
