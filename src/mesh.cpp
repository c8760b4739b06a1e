// SPDX-License-Identifier: MIT
// The doors of mesh, for float and double.
#include <irg/mesh/teapot.hpp>

namespace irg {

template mesh<float> shape_teapot(const teapot_options&);
template mesh<double> shape_teapot(const teapot_options&);

}  // namespace irg
