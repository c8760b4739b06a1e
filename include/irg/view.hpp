// SPDX-License-Identifier: MIT
// view: affine maps, look-at, projections, viewport.
#pragma once

#include <irg/view/affine.hpp>
#include <irg/view/look_at.hpp>
#include <irg/view/projection.hpp>
#include <irg/view/viewport.hpp>
