// SPDX-License-Identifier: MIT
// Lanes: a kernel is written once, for a type F that is either a scalar or a pack; these headers give both the few
// operations whose spelling differs (lanes<F>, select, mask_bits, ...). Builtins, vector types and the choice between
// registers and arrays stand in core alone.
// Packs are run-time only: compilers cannot read vector lanes in constant evaluation, where the scalar form serves.
#pragma once

#include <irg/core/instructions.hpp>
#include <irg/core/lane_integers.hpp>
#include <irg/core/lane_masks.hpp>
#include <irg/core/lane_memory.hpp>
#include <irg/core/lane_shuffles.hpp>
#include <irg/core/memory_access.hpp>
#include <irg/core/pack.hpp>
#include <irg/core/wide_lanes.hpp>
