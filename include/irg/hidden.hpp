// SPDX-License-Identifier: MIT
// hidden: back faces; the textbook z-buffer, its depths and its memory.
#pragma once

#include <irg/hidden/back_faces.hpp>
#include <irg/hidden/plane_depth.hpp>
#include <irg/hidden/zbuffer_memory.hpp>
#include <irg/hidden/textbook/back_faces.hpp>
#include <irg/hidden/textbook/zbuffer.hpp>
