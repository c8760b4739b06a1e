// SPDX-License-Identifier: MIT
// view: affine maps, look-at, projections, viewport.
#pragma once

#include <irg/view/affine.hpp>
#include <irg/view/look_at.hpp>
#include <irg/view/camera_frame.hpp>
#include <irg/view/handedness.hpp>
#include <irg/view/polar_camera.hpp>
#include <irg/view/textbook/polar_camera.hpp>
#include <irg/view/projection.hpp>
#include <irg/view/viewport.hpp>
#include <irg/view/axonometry.hpp>
#include <irg/view/oblique.hpp>
#include <irg/view/central_projection.hpp>
#include <irg/view/view_pyramid.hpp>
#include <irg/view/textbook/view_pyramid.hpp>
#include <irg/view/plane_projection.hpp>
#include <irg/view/frustum.hpp>
#include <irg/view/window_to_viewport.hpp>
#include <irg/view/textbook/window_to_viewport.hpp>
#include <irg/view/textbook/view_steps.hpp>
#include <irg/view/textbook/view_transform.hpp>
#include <irg/view/textbook/project_perspective.hpp>
#include <irg/view/view_window.hpp>
