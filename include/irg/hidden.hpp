// SPDX-License-Identifier: MIT
// hidden: back faces; hidden lines in vectors; the textbook z-buffer, its depths and its memory.
#pragma once

#include <irg/hidden/back_faces.hpp>
#include <irg/hidden/hidden_lines.hpp>
#include <irg/hidden/line_drawing.hpp>
#include <irg/hidden/plane_depth.hpp>
#include <irg/hidden/zbuffer_memory.hpp>
#include <irg/hidden/zbuffer_textbook.hpp>
