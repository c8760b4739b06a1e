// SPDX-License-Identifier: MIT
// A word about an eye that is inside of the body it looks at.
#pragma once

#include <irg/mesh/convex_body.hpp>
#include <irg/solid/point_in_solid.hpp>

#include "command_line.hpp"

namespace program {

/// Says so on standard error where the eye is inside of a closed body: views are meant from outside, and what is behind
/// the eye is not in them.
inline void hint_if_inside(const command_line& line, const irg::mesh<double>& body, const irg::point<double, 3>& eye) {
  if (irg::is_closed(body) && irg::point_in_solid(body, eye) == irg::location::inside)
    line.hint("the eye is inside the body, which is meant to be seen from outside");
}

}  // namespace program
