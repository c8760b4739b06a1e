// SPDX-License-Identifier: MIT
// The built-in bodies, together.
#pragma once

#include <irg/mesh/shape_polyhedra.hpp>
#include <irg/mesh/shape_sphere.hpp>
#include <irg/mesh/shape_sweeps.hpp>
#include <irg/mesh/teapot.hpp>
