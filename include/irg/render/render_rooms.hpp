// SPDX-License-Identifier: MIT
// render_rooms: a building becomes a picture, and the rooms that no portal shows are skipped whole.
//
// The portals' rectangles in the picture decide, as in Luebke and Georges, one pixel wider on each side, since corners
// in a picture are rounded. Each room keeps one rectangle, which grows until nothing changes: loops of portals end.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <irg/raster/window.hpp>
#include <irg/render/detail/project/room_windows.hpp>
#include <irg/render/render.hpp>
#include <irg/visibility/view_through_portals.hpp>

namespace irg {

/// A building made ready for pictures.
/// shape   object c of the scene is what is in the cell c of the plan; what comes after them is in no cell
template <Floating T>
struct prepared_rooms {
  cell_plan<T> plan;
  portal_graph<T> doors;
  prepared_scene<T> world;
};

inline namespace IRG_ABI {

/// For each cell the pixels of a picture in which something of it may be seen; an empty window where nothing can.
/// needs   a plan without defects, its graph, 1 <= width, height <= 65536
/// gives   too much, never too little, of what rays from the near plane's points in cells see: rectangles, one pixel
///         wider than what they hold, and the whole picture for each cell that is near enough to hold such a point, or
///         for all when none is, and in parallel projections, whose rays come from outside
/// exact   rounded; the pixel more covers it as long as near_distance is greater than the rounding of the coordinates
/// cost    the portals that are seen, each projected once; a room is looked at again where its rectangle grows
/// source  Luebke and Georges 1995
template <Floating T>
[[nodiscard]] constexpr std::vector<cell_window> visible_rooms(const cell_plan<T>& plan, const portal_graph<T>& doors,
                                                               const camera<T>& view, int width, int height) {
  IRG_EXPECTS(width >= 1 && height >= 1);
  return detail::room_windows<T>(plan, view, {0, 0, width, height}).find(doors);
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
template <Floating T, RowRaster Colour = image<rgba8>, RowRaster Depth = image<float>, Executor E = sequential>
  requires std::same_as<pixel_of<Colour>, rgba8> && std::same_as<pixel_of<Depth>, float>
constexpr render_stats render(prepared_rooms<T>& building, render_target<Colour, Depth> target,
                              const render_options& options = {}, const E& executor = {}) {
  const int width = width_of(target.colour), height = height_of(target.colour);
  if (width == 0 || height == 0) return {};
  IRG_EXPECTS(building.world.objects.size() >= building.plan.cells.size());
  detail::chosen_objects<T> chosen{building.world.objects};
  std::vector<cell_window> windows(building.plan.cells.size(), cell_window{0, 0, width, height});
  if (options.skip.rooms == skipping::on)
    windows = visible_rooms(building.plan, building.doors, building.world.view, width, height);
  std::int64_t skipped = 0;
  for (std::uint32_t i = 0; i < building.world.objects.size(); ++i)
    if (i < windows.size() && windows[i].empty())
      skipped += static_cast<std::int64_t>(building.world.objects[i].body.triangles.size());
    else
      chosen.numbers.push_back(i);
  no_observer observer;
  render_stats stats =
      detail::draw_picture<T>({building.world, width, height, options}, chosen, building.world.workspace,
                              detail::picture_run{target.colour, target.depth, executor, observer});
  stats.triangles += skipped;
  stats.skipped.rooms += skipped;
  return stats;
}

}  // namespace IRG_ABI
}  // namespace irg
