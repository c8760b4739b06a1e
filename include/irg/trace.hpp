// SPDX-License-Identifier: MIT
// trace: ray tracing.
#pragma once

#include <irg/trace/ray_tracing.hpp>
#include <irg/trace/ray_world.hpp>
#include <irg/trace/trace_ray.hpp>
#include <irg/trace/along_ray.hpp>
#include <irg/trace/soft_light.hpp>
#include <irg/trace/path_tracer.hpp>
