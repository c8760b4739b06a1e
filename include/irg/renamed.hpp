// SPDX-License-Identifier: MIT
// Types under the names that they had in 0.2, for programs that move to new ones step by step. No umbrella includes it.
// Old names of functions and enumerators stand beside the new ones, without this.
#pragma once

#include <irg/hidden/plot_surface.hpp>
#include <irg/irg.hpp>

#define IRG_RENAMED_TYPE(old_name, ...) \
  using old_name [[deprecated("irg: " #old_name " is now " #__VA_ARGS__)]] = __VA_ARGS__

namespace irg {

IRG_RENAMED_TYPE(bsp_choice, bsp_options);
IRG_RENAMED_TYPE(bvh_config, bvh_options);
IRG_RENAMED_TYPE(curve_joint, curve_continuity);
IRG_RENAMED_TYPE(deep_escape_stats, deep_escape_counts);
IRG_RENAMED_TYPE(depth_settings, draw_depth_options);
template <class P>
IRG_RENAMED_TYPE(draw_settings, draw_options<P>);
IRG_RENAMED_TYPE(escape_skips, escape_options);
IRG_RENAMED_TYPE(escape_stats, escape_counts);
template <int Degree>
IRG_RENAMED_TYPE(exact_number, big_float<Degree>);
IRG_RENAMED_TYPE(inversion_outcome, inversion_status);
IRG_RENAMED_TYPE(known_number, scaled_double_double);
IRG_RENAMED_TYPE(knots_error, knots_status);
template <Floating T>
IRG_RENAMED_TYPE(meeting_search, bezier_intersection_options<T>);
IRG_RENAMED_TYPE(meetings_found, bezier_intersection_status);
template <Floating T>
IRG_RENAMED_TYPE(orbit_limits, orbit_options<T>);
IRG_RENAMED_TYPE(picture_format, image_format);
IRG_RENAMED_TYPE(precise_escape_stats, precise_escape_counts);
IRG_RENAMED_TYPE(render_stats, render_counts);
IRG_RENAMED_TYPE(sight_rules, line_of_sight_options);
IRG_RENAMED_TYPE(sight_sampling, sight_sampling_options);
IRG_RENAMED_TYPE(solvability, system_status);
template <Floating T>
IRG_RENAMED_TYPE(trace_limits, trace_options<T>);
template <class Blend = over_in_light>
IRG_RENAMED_TYPE(transparent_settings, transparent_options<Blend>);
IRG_RENAMED_TYPE(triangulation_state, triangulation_status);
IRG_RENAMED_TYPE(wall_rules, wall_options);
template <Floating T>
IRG_RENAMED_TYPE(zero_stretch, root_interval<T>);

}  // namespace irg

#undef IRG_RENAMED_TYPE
