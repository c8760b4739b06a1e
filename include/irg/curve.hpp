// SPDX-License-Identifier: MIT
// curve: Bezier curves and surfaces, B-splines, NURBS; their zeros, meetings, joints.
#pragma once

#include <irg/curve/bezier.hpp>
#include <irg/curve/bezier_accurate.hpp>
#include <irg/curve/bezier_degree.hpp>
#include <irg/curve/bezier_edge_form.hpp>
#include <irg/curve/bezier_surface.hpp>
#include <irg/curve/bspline_surface.hpp>
#include <irg/curve/surface_nets.hpp>
#include <irg/curve/surface_tessellation.hpp>
#include <irg/curve/surface_trimming.hpp>
#include <irg/curve/bspline_fit.hpp>
#include <irg/curve/bezier_prepared.hpp>
#include <irg/curve/bezier_forward.hpp>
#include <irg/curve/bspline.hpp>
#include <irg/curve/bspline_derivative.hpp>
#include <irg/curve/rational.hpp>
#include <irg/curve/bezier_queries.hpp>
#include <irg/curve/bezier_zeros.hpp>
#include <irg/curve/curve_joint.hpp>
#include <irg/curve/bezier_crossings.hpp>
#include <irg/curve/bspline_knots.hpp>
#include <irg/curve/curve_frame.hpp>
#include <irg/curve/arc_length.hpp>
#include <irg/curve/constant_speed.hpp>
#include <irg/curve/keyframes.hpp>
#include <irg/curve/flatten.hpp>
