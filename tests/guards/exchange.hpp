// SPDX-License-Identifier: MIT
// What two translation units, built for different instruction sets, hand each other.
#pragma once

#include <irg/colour/pixel.hpp>
#include <irg/core/result.hpp>
#include <irg/math/vec.hpp>
#include <irg/mesh/mesh.hpp>
#include <irg/raster/image.hpp>

/// The instruction set and the functions' namespace that the other unit was built with.
const char* other_namespace();

irg::mesh<float> make_mesh();
irg::image<irg::rgba8> make_image();
irg::result<irg::mesh<float>> fail_to_make_mesh();

/// Sums computed by the other unit from objects it was given.
float sum_of_dots(const irg::mesh<float>& m);
int sum_of_greens(const irg::image_view<const irg::rgba8>& picture);
