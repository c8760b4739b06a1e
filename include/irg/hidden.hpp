// SPDX-License-Identifier: MIT
// hidden: back faces, painter, Warnock, BSP order, the textbook z-buffer, hidden lines, floating horizon, grid surfaces.
#pragma once

#include <irg/hidden/back_faces.hpp>
#include <irg/hidden/plane_depth.hpp>
#include <irg/hidden/zbuffer_memory.hpp>
#include <irg/hidden/zbuffer_textbook.hpp>
