// SPDX-License-Identifier: MIT
// spatial: grids of cells and walls in two and three dimensions, trees of segments, of boxes and of triangles for rays.
#pragma once

#include <irg/spatial/grid_concept.hpp>
#include <irg/spatial/cell_grid.hpp>
#include <irg/spatial/walled_grid.hpp>
#include <irg/spatial/bsp_tree_2d.hpp>
#include <irg/spatial/bsp_tree_3d.hpp>
#include <irg/spatial/bsp_data_3d.hpp>
#include <irg/spatial/bsp_order.hpp>
#include <irg/spatial/bvh.hpp>
#include <irg/spatial/bvh_hits.hpp>
#include <irg/spatial/bvh_node.hpp>
#include <irg/spatial/triangle_bvh.hpp>
#include <irg/spatial/cross_triangle.hpp>
