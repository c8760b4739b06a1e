// SPDX-License-Identifier: MIT
// Types under the names that they had in 0.2, for programs that move to new ones step by step. No umbrella includes it. Old
// names of functions and enumerators stand beside the new ones, without this.
#pragma once

#include <irg/irg.hpp>

#define IRG_RENAMED_TYPE(old_name, new_name) \
  using old_name [[deprecated("irg: " #old_name " is now " #new_name)]] = new_name

namespace irg {

template <int Degree>
IRG_RENAMED_TYPE(exact_number, big_float<Degree>);
IRG_RENAMED_TYPE(inversion_outcome, inversion_status);
IRG_RENAMED_TYPE(known_number, scaled_double_double);
IRG_RENAMED_TYPE(knots_error, knots_status);
IRG_RENAMED_TYPE(meetings_found, bezier_intersection_status);
IRG_RENAMED_TYPE(picture_format, image_format);
IRG_RENAMED_TYPE(solvability, system_status);
IRG_RENAMED_TYPE(triangulation_state, triangulation_status);

}  // namespace irg

#undef IRG_RENAMED_TYPE
