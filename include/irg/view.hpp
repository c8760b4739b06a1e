// SPDX-License-Identifier: MIT
// view: affine and projective maps, the textbook view transform, cameras, projections, window to viewport.
#pragma once

#include <irg/view/affine.hpp>
#include <irg/view/look_at.hpp>
#include <irg/view/projection.hpp>
#include <irg/view/viewport.hpp>
