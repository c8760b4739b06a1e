// SPDX-License-Identifier: MIT
// visibility: line of sight and fields of view on grids; visibility polygons, weak visibility, cells and portals.
#pragma once

#include <irg/visibility/see.hpp>
#include <irg/visibility/corner_rule.hpp>
#include <irg/visibility/field_of_view.hpp>
#include <irg/visibility/visible_part.hpp>
#include <irg/visibility/sight_tracker.hpp>
#include <irg/visibility/unit_sight.hpp>
#include <irg/visibility/viewshed.hpp>
#include <irg/visibility/visibility_polygon.hpp>
#include <irg/visibility/sight_result.hpp>
#include <irg/visibility/prepared_walls.hpp>
#include <irg/visibility/sight_line.hpp>
#include <irg/visibility/visible_points.hpp>
#include <irg/visibility/weak_visibility.hpp>
#include <irg/visibility/cut_source.hpp>
#include <irg/visibility/sight_in_space.hpp>
#include <irg/visibility/guard_cover.hpp>
#include <irg/visibility/potentially_visible.hpp>
#include <irg/visibility/view_through_portals.hpp>
#include <irg/visibility/cell_plan.hpp>
#include <irg/visibility/space_plan.hpp>
#include <irg/visibility/space_portals.hpp>
#include <irg/visibility/cells_from_bsp.hpp>
#include <irg/visibility/textbook/sight_steps.hpp>
#include <irg/visibility/textbook/sight_2d.hpp>
#include <irg/visibility/textbook/sight_cells.hpp>
#include <irg/visibility/textbook/sight_3d.hpp>
#include <irg/visibility/textbook/sight_search.hpp>
