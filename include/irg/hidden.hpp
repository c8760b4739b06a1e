// SPDX-License-Identifier: MIT
// hidden: back faces; ray casting, Warnock, painter, BSP of faces; hidden lines; the textbook z-buffer.
#pragma once

#include <irg/hidden/vocabulary.hpp>
#include <irg/hidden/back_faces.hpp>
#include <irg/hidden/textbook/back_faces.hpp>
#include <irg/hidden/ray_casting.hpp>
#include <irg/hidden/warnock.hpp>
#include <irg/hidden/painter_newell.hpp>
#include <irg/hidden/painter_once.hpp>
#include <irg/hidden/textbook/depth_sort.hpp>
#include <irg/hidden/textbook/newell_tests.hpp>
#include <irg/hidden/textbook/painter.hpp>
#include <irg/hidden/painter.hpp>
#include <irg/hidden/bsp_faces.hpp>
#include <irg/hidden/bsp_scene.hpp>
#include <irg/hidden/classical_methods.hpp>
#include <irg/hidden/order_in_window.hpp>
#include <irg/hidden/textbook/zbuffer.hpp>
#include <irg/hidden/plane_depth.hpp>
#include <irg/hidden/zbuffer_memory.hpp>
#include <irg/hidden/hidden_lines.hpp>
#include <irg/hidden/faces_around.hpp>
#include <irg/hidden/visible_polygons.hpp>
#include <irg/hidden/line_drawing.hpp>
#include <irg/hidden/floating_horizon.hpp>
#include <irg/hidden/horizon_surface.hpp>
#include <irg/hidden/textbook/floating_horizon.hpp>
#include <irg/hidden/horizon_lines.hpp>
#include <irg/hidden/horizon_curves.hpp>
#include <irg/hidden/height_grid.hpp>
#include <irg/hidden/grid_surface.hpp>
#include <irg/hidden/grid_covering_order.hpp>
#include <irg/hidden/textbook/grid_surface.hpp>
#include <irg/hidden/horizon_view.hpp>
#include <irg/hidden/surface_camera.hpp>
