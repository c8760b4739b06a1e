// The old names of types are the new types.
#include <type_traits>

#include <irg/renamed.hpp>

static_assert(std::is_same_v<irg::bsp_choice, irg::bsp_options>);
static_assert(std::is_same_v<irg::bvh_config, irg::bvh_options>);
static_assert(std::is_same_v<irg::curve_joint, irg::curve_continuity>);
static_assert(std::is_same_v<irg::deep_escape_stats, irg::deep_escape_counts>);
static_assert(std::is_same_v<irg::depth_settings, irg::draw_depth_options>);
static_assert(std::is_same_v<irg::draw_settings<irg::rgba8>, irg::draw_options<irg::rgba8>>);
static_assert(std::is_same_v<irg::escape_skips, irg::escape_options>);
static_assert(std::is_same_v<irg::escape_stats, irg::escape_counts>);
static_assert(std::is_same_v<irg::exact_number<3>, irg::big_float<3>>);
static_assert(std::is_same_v<irg::inversion_outcome, irg::inversion_status>);
static_assert(std::is_same_v<irg::known_number, irg::scaled_double_double>);
static_assert(std::is_same_v<irg::knots_error, irg::knots_status>);
static_assert(std::is_same_v<irg::meeting_search<double>, irg::bezier_intersection_options<double>>);
static_assert(std::is_same_v<irg::meetings_found, irg::bezier_intersection_status>);
static_assert(std::is_same_v<irg::orbit_limits<double>, irg::orbit_options<double>>);
static_assert(std::is_same_v<irg::picture_format, irg::image_format>);
static_assert(std::is_same_v<irg::precise_escape_stats, irg::precise_escape_counts>);
static_assert(std::is_same_v<irg::render_stats, irg::render_counts>);
static_assert(std::is_same_v<irg::sight_rules, irg::line_of_sight_options>);
static_assert(std::is_same_v<irg::sight_sampling, irg::sight_sampling_options>);
static_assert(std::is_same_v<irg::solvability, irg::system_status>);
static_assert(std::is_same_v<irg::trace_limits<double>, irg::trace_options<double>>);
static_assert(
    std::is_same_v<irg::transparent_settings<irg::over_in_light>, irg::transparent_options<irg::over_in_light>>);
static_assert(std::is_same_v<irg::triangulation_state, irg::triangulation_status>);
static_assert(std::is_same_v<irg::wall_rules, irg::wall_options>);
static_assert(std::is_same_v<irg::zero_stretch<double>, irg::root_interval<double>>);
