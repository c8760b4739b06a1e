// SPDX-License-Identifier: MIT
// Types whose functions are too large to be forced inline, all functions of them: in an object for a newer instruction set
// each of their names has to say so. scripts/checks/exchange looks.
#include <irg/geometry/exact_point.hpp>
#include <irg/hidden/bsp_scene.hpp>
#include <irg/math/fixed_point.hpp>
#include <irg/math/matrix.hpp>
#include <irg/render/detail/visible/tile_driver.hpp>
#include <irg/solid/solid_locator.hpp>
#include <irg/spatial/bsp_tree_2d.hpp>
#include <irg/spatial/bsp_tree_3d.hpp>
#include <irg/spatial/triangle_bvh.hpp>
#include <irg/view/frustum.hpp>

template class irg::basic_exact_point<>;
template class irg::bsp_scene_painter<double>;
template class irg::bsp_tree_2d<double>;
template class irg::bsp_tree_3d<double>;
template class irg::big_float<3>;
template struct irg::fixed_point<4>;
template struct irg::frustum<double>;
template class irg::matrix<double>;
template class irg::projected_triangles<double>;
template class irg::solid_locator<double>;
template class irg::triangle_bvh<double>;
