// SPDX-License-Identifier: MIT
// All of irg but core/threads.hpp and plots. The order is the order of the chapters: each includes earlier ones only.
#pragma once

#include <irg/core.hpp>
#include <irg/math.hpp>
#include <irg/geometry.hpp>
#include <irg/colour.hpp>
#include <irg/spatial.hpp>
#include <irg/curve.hpp>
#include <irg/mesh.hpp>
#include <irg/view.hpp>
#include <irg/raster.hpp>
#include <irg/shade.hpp>
#include <irg/fractal.hpp>
#include <irg/solid.hpp>
#include <irg/hidden.hpp>
#include <irg/visibility.hpp>
#include <irg/trace.hpp>
#include <irg/scene.hpp>
#include <irg/render.hpp>
#include <irg/io.hpp>
