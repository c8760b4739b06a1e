// The old names of types are the new types.
#include <type_traits>

#include <irg/renamed.hpp>

static_assert(std::is_same_v<irg::exact_number<3>, irg::big_float<3>>);
static_assert(std::is_same_v<irg::inversion_outcome, irg::inversion_status>);
static_assert(std::is_same_v<irg::known_number, irg::scaled_double_double>);
static_assert(std::is_same_v<irg::knots_error, irg::knots_status>);
static_assert(std::is_same_v<irg::meetings_found, irg::bezier_intersection_status>);
static_assert(std::is_same_v<irg::picture_format, irg::image_format>);
static_assert(std::is_same_v<irg::solvability, irg::system_status>);
static_assert(std::is_same_v<irg::triangulation_state, irg::triangulation_status>);
