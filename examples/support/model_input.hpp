// SPDX-License-Identifier: MIT
// The model that a program is given by name.
#pragma once

#include <string>
#include <utility>

#include <irg/io/mesh_file.hpp>
#include <irg/mesh/fit.hpp>
#include <irg/mesh/shapes.hpp>
#include <irg/mesh/teapot.hpp>

#include "command_line.hpp"

namespace program {

/// The model of that name, from a file of any format that irg reads if it is no built-in one; ends the program where
/// there is none.
inline irg::mesh<double> read_model(const command_line& line, const std::string& model) {
  if (model == "teapot") return irg::shape_teapot<double>();
  if (model == "cube") return irg::shape_cube<double>();
  if (model == "sphere") return irg::shape_sphere<double>();
  if (model == "torus") return irg::shape_torus<double>();
  auto mesh = irg::load_mesh<double>(model);
  if (!mesh) line.fail(with_place(mesh.error(), model));
  return *std::move(mesh);
}

/// Moves and scales a model into [-1, 1], what --fit asks for; ends the program where a vertex is not finite.
inline void fit_model(const command_line& line, irg::mesh<double>& m, const std::string& name) {
  if (irg::fit_mesh(m) == irg::fit_status::not_finite) line.fail("the model has a vertex that is not finite: " + name);
}

}  // namespace program
