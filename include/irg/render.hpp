// SPDX-License-Identifier: MIT
// render: scene to picture: the pipeline with its skip counters.
#pragma once

#include <irg/render/render.hpp>
#include <irg/render/options.hpp>
#include <irg/render/prepared_scene.hpp>
#include <irg/render/render_traced.hpp>
#include <irg/render/draw_triangles.hpp>
#include <irg/render/attribute_shading.hpp>
#include <irg/render/textured_shading.hpp>
#include <irg/render/mip_textured_shading.hpp>
#include <irg/render/draw_transparent.hpp>
#include <irg/render/draw_depth.hpp>
#include <irg/render/visibility_buffer.hpp>
#include <irg/render/pick.hpp>
#include <irg/render/window_faces.hpp>
#include <irg/render/shade_visible.hpp>
#include <irg/render/occlusion_mask.hpp>
#include <irg/render/scene_bsp.hpp>
#include <irg/render/render_rooms.hpp>
#include <irg/render/occlusion_culling.hpp>
#include <irg/render/textbook/pipeline.hpp>
#include <irg/render/wireframe.hpp>
#include <irg/render/drawable.hpp>
#include <irg/render/weight_derivatives.hpp>
