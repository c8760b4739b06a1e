// SPDX-License-Identifier: MIT
// shade: lights, materials, the Phong model; flat, Gouraud and Phong shading as callables.
#pragma once

#include <irg/shade/phong_model.hpp>
#include <irg/shade/material.hpp>
#include <irg/shade/light.hpp>
#include <irg/shade/shading.hpp>
#include <irg/shade/phong_lanes.hpp>
#include <irg/shade/intensity_range.hpp>
#include <irg/shade/light_placement.hpp>
#include <irg/shade/texture.hpp>
#include <irg/shade/mip_pyramid.hpp>
#include <irg/shade/texture_lanes.hpp>
#include <irg/shade/per_channel.hpp>
