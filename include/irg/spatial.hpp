// SPDX-License-Identifier: MIT
// spatial: bounding-volume hierarchy with its ray queries, BSP tree, grids of cells and walls.
#pragma once

#include <irg/spatial/cell3.hpp>
#include <irg/spatial/cell_grid.hpp>
#include <irg/spatial/grid_concept.hpp>
#include <irg/spatial/walled_grid.hpp>
