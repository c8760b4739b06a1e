// SPDX-License-Identifier: MIT
// Open CASCADE's polygonal hidden lines, and its bodies as meshes, so that both draw the same triangles.
#pragma once

#include <cstdint>
#include <vector>

#include <irg/mesh/mesh.hpp>

namespace bench {

/// Whether Open CASCADE was found.
bool has_occt();

/// side * side bodies that stand tilted and overlap, spheres, tori, cylinders and boxes in turn, cut into triangles that
/// are off by at most `deflection`. Made once for each side.
const std::vector<irg::mesh<double>>& occt_bodies(int side, double deflection);

/// HLRBRep_PolyAlgo on these bodies, seen in parallel from (1, 0.7, 0.9); returns how many edges it shows.
/// needs   occt_bodies(side, ...) was called
std::int64_t occt_hidden_lines(int side);

}  // namespace bench
