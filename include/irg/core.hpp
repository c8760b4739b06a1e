// SPDX-License-Identifier: MIT
// core: concepts and customisation points, config, contracts, result, contraction guard, lanes, executors.
#pragma once

#include <irg/core/vocabulary.hpp>
#include <irg/core/coordinates.hpp>
#include <irg/core/raster_concept.hpp>
#include <irg/core/mesh_concept.hpp>
#include <irg/core/plane_concept.hpp>
#include <irg/core/ring.hpp>
#include <irg/core/result.hpp>
#include <irg/core/contract.hpp>
#include <irg/core/scalar.hpp>
#include <irg/core/sinks.hpp>
#include <irg/core/executor.hpp>
#include <irg/core/function_ref.hpp>
#include <irg/core/lanes.hpp>
#include <irg/core/contraction.hpp>
#include <irg/core/conversion.hpp>
#include <irg/core/config.hpp>
#include <irg/core/instructions.hpp>
#include <irg/core/interleaved_lanes.hpp>
#include <irg/core/is_finite.hpp>
#include <irg/core/lane_integers.hpp>
#include <irg/core/lane_masks.hpp>
#include <irg/core/lane_memory.hpp>
#include <irg/core/lane_shuffles.hpp>
#include <irg/core/memory_access.hpp>
#include <irg/core/pack.hpp>
#include <irg/core/wide_lanes.hpp>
