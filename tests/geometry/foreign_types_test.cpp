// SPDX-License-Identifier: MIT
// Every function of vectors, points, rings and planes is called with types that are not irg's: plain structs, std::array,
// GLM's, Eigen's and OpenCV's. What takes what is the table of docs/own-types.md, which is held against the calls; a row
// that says "no" there has its reason beside it.
#include <irg/curve/bezier.hpp>
#include <irg/curve/curve_frame.hpp>
#include <irg/geometry.hpp>
#include <irg/geometry/textbook/clip_weiler_atherton.hpp>
#include <irg/hidden/back_faces.hpp>
#include <irg/hidden/plane_depth.hpp>
#include <irg/math.hpp>
#include <irg/mesh/face_normal.hpp>
#include <irg/mesh/shapes.hpp>
#include <irg/raster/draw_polyline.hpp>
#include <irg/raster/fill_convex.hpp>
#include <irg/raster/fill_convex_aa.hpp>
#include <irg/raster/fill_polygon.hpp>
#include <irg/raster/fill_polygon_aa.hpp>
#include <irg/raster/image.hpp>
#include <irg/raster/line_aa.hpp>
#include <irg/raster/line_styled.hpp>
#include <irg/raster/line_subpixel.hpp>
#include <irg/raster/line_thick.hpp>
#include <irg/raster/line_wu.hpp>
#include <irg/raster/projected_vertices.hpp>
#include <irg/raster/seed_fill.hpp>
#include <irg/shade/shading.hpp>
#include <irg/view/affine.hpp>
#include <irg/view/look_at.hpp>
#include <irg/view/plane_projection.hpp>
#include <irg/visibility/view_through_portals.hpp>

#include <algorithm>
#include <array>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "support/archetypes.hpp"
#include "support/own_types.hpp"
#include "support/random.hpp"

#include <doctest/doctest.h>

namespace {

using plain2 = own::plain2<double>;
using plain3 = own::plain3<double>;
using plain4 = own::plain4<double>;
using own::plain_cell;
using own::plain_plane;

struct no_sink {
  template <class T>
  constexpr void operator()(const T&) const noexcept {}
};

// Points in general position, a ring, planes: of one origin's types.
template <class P2, class P3, class P4, class Plane, class Cell>
struct values {
  P2 a{0, 0}, b{4, 0}, c{4, 3}, d{0, 3}, e{1, 1};
  P3 a3{0, 0, 1}, b3{4, 0, 1}, c3{4, 3, 2}, d3{0, 3, 1}, e3{1, 1, 1}, g3{1, 2, 5};
  P4 h{1, 2, 3, 1}, h2{3, 2, 2, 1}, h3{0, 1, 5, 1};
  Plane plane{0, 0, 1, -1}, plane2{0, 1, 0, -2}, plane3{1, 0, 0, -3};
  Cell from{1, 2}, to{6, 4};
  std::vector<Cell> path{from, to, Cell{0, 7}};
  std::vector<P2> ring{a, b, c, d};
  std::vector<P3> ring3{a3, b3, P3{4, 3, 1}, d3};
  irg::box<double, 2> window{{1, 1}, {3, 5}};
  irg::screen_mapping<float> mapping = irg::map_to_screen<float>({8, 8});
  irg::line_dashes<irg::dash_mask> dashes{irg::dash_mask{0x0f0f, 1}};
  irg::rgba8 colour{1, 2, 3, 255};
  no_sink cells{};
  irg::box<double, 3> window3{{1, 1, 0}, {3, 5, 5}};
  mutable std::vector<P2> changed{a, b, c, d};
  mutable std::vector<P3> space{a3, a3, a3, a3};
  mutable std::array<double, 4> numbers{};
  mutable irg::image<irg::rgba8> picture{8, 8};
};

// One call: whether it compiles with the types of `v`, in which case it is made.
#define FOREIGN_CALL(...)                                \
  [](const auto& v) {                                    \
    constexpr bool takes = requires { __VA_ARGS__; };    \
    if constexpr (takes) static_cast<void>(__VA_ARGS__); \
    return takes;                                        \
  }

template <class V>
std::map<std::string, bool> calls(const V& values) {
  std::map<std::string, bool> taken;
  const auto call = [&](const char* name, const auto& function) { taken[name] = function(values); };
  // vectors
  call("dot", FOREIGN_CALL(irg::dot(v.a3, v.b3)));
  call("dot_fast", FOREIGN_CALL(irg::dot_fast(v.a3, v.b3)));
  call("dot_accurate", FOREIGN_CALL(irg::dot_accurate(v.a3, v.b3)));
  call("dot_exact", FOREIGN_CALL(irg::dot_exact(v.a3, v.b3)));
  call("dot_sign", FOREIGN_CALL(irg::dot_sign(v.a3, v.b3)));
  call("cross", FOREIGN_CALL(irg::cross(v.a3, v.b3)));
  call("cross_fast", FOREIGN_CALL(irg::cross_fast(v.a3, v.b3)));
  call("cross_accurate", FOREIGN_CALL(irg::cross_accurate(v.a3, v.b3)));
  call("length", FOREIGN_CALL(irg::length(v.b3)));
  call("length_fast", FOREIGN_CALL(irg::length_fast(v.b3)));
  call("length_squared", FOREIGN_CALL(irg::length_squared(v.b3)));
  call("scaled_near_one", FOREIGN_CALL(irg::scaled_near_one(v.b3)));
  call("normalized", FOREIGN_CALL(irg::normalized(v.b3)));
  call("normalized_fast", FOREIGN_CALL(irg::normalized_fast(v.b3)));
  call("try_normalized", FOREIGN_CALL(irg::try_normalized(v.b3)));
  call("angle_between", FOREIGN_CALL(irg::angle_between(v.b3, v.c3)));
  call("scalar_projection", FOREIGN_CALL(irg::scalar_projection(v.b3, v.c3)));
  call("vector_projection", FOREIGN_CALL(irg::vector_projection(v.b3, v.c3)));
  call("cosine_between", FOREIGN_CALL(irg::cosine_between(v.b3, v.c3)));
  call("dot_products", FOREIGN_CALL(irg::dot_products(v.ring3, v.ring3, std::span(v.numbers))));
  call("cross_products", FOREIGN_CALL(irg::cross_products(v.ring3, v.ring3, std::span(v.space))));
  call("normalize_vectors", FOREIGN_CALL(irg::normalize_vectors(v.ring3, std::span(v.space))));
  call("normalize_vectors_fast", FOREIGN_CALL(irg::normalize_vectors_fast(v.ring3, std::span(v.space))));
  call("transform_points", FOREIGN_CALL(irg::transform_points(irg::identity_matrix<double, 4>(), v.ring3, v.space)));
  call("transform_vectors", FOREIGN_CALL(irg::transform_vectors(irg::identity_matrix<double, 4>(), v.ring3, v.space)));
  call("to_vec", FOREIGN_CALL(irg::to_vec(v.b3)));
  call("to_point", FOREIGN_CALL(irg::to_point(v.b3)));
  call("transform_point", FOREIGN_CALL(irg::transform_point(irg::identity_matrix<double, 4>(), v.b3)));
  call("transform_vector", FOREIGN_CALL(irg::transform_vector(irg::identity_matrix<double, 4>(), v.b3)));
  call("translation", FOREIGN_CALL(irg::translation(v.b3)));
  call("scaling", FOREIGN_CALL(irg::scaling(v.c3)));
  call("rotation", FOREIGN_CALL(irg::rotation(v.c3, 0.5)));
  call("look_at", FOREIGN_CALL(irg::look_at(v.a3, v.b3, v.g3)));
  call("look_at_checked", FOREIGN_CALL(irg::look_at_checked(v.a3, v.b3, v.g3)));
  call("curvature", FOREIGN_CALL(irg::curvature(v.b3, v.c3)));
  call("torsion", FOREIGN_CALL(irg::torsion(v.b3, v.c3, v.d3)));
  call("frenet_frame", FOREIGN_CALL(irg::frenet_frame(v.b3, v.c3)));
  call("frame_with_up", FOREIGN_CALL(irg::frame_with_up(v.b3, v.c3)));
  // points
  call("orient2d", FOREIGN_CALL(irg::orient2d(v.a, v.b, v.c)));
  call("orient2d_sos", FOREIGN_CALL(irg::orient2d_sos(v.a, v.b, v.c)));
  call("is_between_ends", FOREIGN_CALL(irg::is_between_ends(v.a3, v.b3, v.c3)));
  call("seen_along", FOREIGN_CALL(irg::seen_along(2, v.b3)));
  call("orientation_along", FOREIGN_CALL(irg::orientation_along(2, v.a3, v.b3, v.c3)));
  call("orient3d", FOREIGN_CALL(irg::orient3d(v.a3, v.b3, v.c3, v.d3)));
  call("orient3d_sos", FOREIGN_CALL(irg::orient3d_sos(v.a3, v.b3, v.c3, v.d3)));
  call("in_circle", FOREIGN_CALL(irg::in_circle(v.a, v.b, v.c, v.e)));
  call("in_circle_sos", FOREIGN_CALL(irg::in_circle_sos(v.a, v.b, v.c, v.e)));
  call("in_sphere", FOREIGN_CALL(irg::in_sphere(v.a3, v.b3, v.c3, v.d3, v.e3)));
  call("in_sphere_sos", FOREIGN_CALL(irg::in_sphere_sos(v.a3, v.b3, v.c3, v.d3, v.e3)));
  call("compare_lexicographic", FOREIGN_CALL(irg::compare_lexicographic(v.a3, v.b3)));
  call("compare_distance", FOREIGN_CALL(irg::compare_distance(v.a3, v.b3, v.c3)));
  call("compare_distance_to_line", FOREIGN_CALL(irg::compare_distance_to_line(v.a, v.b, v.c, v.d)));
  call("order_along_line", FOREIGN_CALL(irg::order_along_line(v.a3, v.b3, v.c3, v.d3)));
  call("is_finite", FOREIGN_CALL(irg::is_finite(v.a3, v.b3)));
  call("can_snap", FOREIGN_CALL(irg::can_snap(v.a)));
  call("snap", FOREIGN_CALL(irg::snap(v.a)));
  call("dropped_axis", FOREIGN_CALL(irg::dropped_axis(v.a3, v.b3, v.c3) == irg::dropped_axis(v.ring3)));
  call("barycentric", FOREIGN_CALL(irg::barycentric(v.a3, v.b3, v.c3, v.e3)));
  call("barycentric_fast", FOREIGN_CALL(irg::barycentric_fast(v.a, v.b, v.c, v.e)));
  call("barycentric_orthogonal", FOREIGN_CALL(irg::barycentric_orthogonal(v.a3, v.b3, v.c3, v.e3)));
  call("locate_in_triangle", FOREIGN_CALL(irg::locate_in_triangle(v.a3, v.b3, v.c3, v.e3)));
  call("closest_point_on_line", FOREIGN_CALL(irg::closest_point_on_line(v.a3, v.b3, v.c3)));
  call("closest_point_on_segment", FOREIGN_CALL(irg::closest_point_on_segment(v.a3, v.b3, v.c3)));
  call("closest_point_on_triangle", FOREIGN_CALL(irg::closest_point_on_triangle(v.a3, v.b3, v.c3, v.g3)));
  call("closest_points_of_lines", FOREIGN_CALL(irg::closest_points_of_lines(v.a3, v.b3, v.c3, v.g3)));
  call("closest_points_of_segments", FOREIGN_CALL(irg::closest_points_of_segments(v.a3, v.b3, v.c3, v.g3)));
  call("distance", FOREIGN_CALL(irg::distance(v.a3, v.b3)));
  call("distance_to_line", FOREIGN_CALL(irg::distance_to_line(v.a3, v.b3, v.c3)));
  call("distance_to_segment", FOREIGN_CALL(irg::distance_to_segment(v.a3, v.b3, v.c3)));
  call("distance_to_triangle", FOREIGN_CALL(irg::distance_to_triangle(v.a3, v.b3, v.c3, v.g3)));
  call("distance_of_lines", FOREIGN_CALL(irg::distance_of_lines(v.a3, v.b3, v.c3, v.g3)));
  call("distance_of_segments", FOREIGN_CALL(irg::distance_of_segments(v.a3, v.b3, v.c3, v.g3)));
  call("edge_through", FOREIGN_CALL(irg::edge_through(v.a, v.b)));
  call("line_through", FOREIGN_CALL(irg::line_through(v.a, v.b)));
  call("line_value", FOREIGN_CALL(irg::line_value(irg::line<double>{1, 2, 3}, v.b)));
  call("vertical_side_of", FOREIGN_CALL(irg::vertical_side_of(irg::line<double>{1, 2, 3}, v.b)));
  call("intersect_lines", FOREIGN_CALL(irg::intersect_lines(v.a, v.c, v.b, v.d)));
  call("intersect_segments", FOREIGN_CALL(irg::intersect_segments(v.a, v.c, v.b, v.d)));
  call("parametric_line_through", FOREIGN_CALL(irg::parametric_line_through(v.a3, v.b3)));
  call("point_between", FOREIGN_CALL(irg::point_between(v.a3, v.b3, 0.5)));
  call("parametric_plane_through", FOREIGN_CALL(irg::parametric_plane_through(v.a3, v.b3, v.c3)));
  call("are_collinear", FOREIGN_CALL(irg::are_collinear(v.a3, v.b3, v.c3)));
  call("is_on_segment", FOREIGN_CALL(irg::is_on_segment(v.a3, v.b3, v.c3)));
  call("is_on_triangle", FOREIGN_CALL(irg::is_on_triangle(v.a3, v.b3, v.c3, v.g3)));
  call("signed_triangle_area", FOREIGN_CALL(irg::signed_triangle_area(v.a, v.b, v.c)));
  call("signed_triangle_area_fast", FOREIGN_CALL(irg::signed_triangle_area_fast(v.a, v.b, v.c)));
  call("triangle_area", FOREIGN_CALL(irg::triangle_area(v.a3, v.b3, v.c3)));
  call("sphere_through", FOREIGN_CALL(irg::sphere_through(v.a3, v.b3, v.c3)));
  call("plane_through", FOREIGN_CALL(irg::plane_through(v.a3, v.b3, v.c3)));
  call("plane_through_accurate", FOREIGN_CALL(irg::plane_through_accurate(v.a3, v.b3, v.c3)));
  call("plane_at", FOREIGN_CALL(irg::plane_at(v.a3, v.g3)));
  call("clip_line_cohen_sutherland", FOREIGN_CALL(irg::clip_line_cohen_sutherland(v.a, v.c, v.window)));
  call("clip_line_liang_barsky", FOREIGN_CALL(irg::clip_line_liang_barsky(v.a, v.c, v.window)));
  call("clip_line_nicholl_lee_nicholl", FOREIGN_CALL(irg::clip_line_nicholl_lee_nicholl(v.a, v.c, v.window)));
  call("clip_line_cyrus_beck", FOREIGN_CALL(irg::clip_line_cyrus_beck(v.a, v.e, v.ring)));
  // rings
  call("bounding_box", FOREIGN_CALL(irg::bounding_box(v.ring3)));
  call("smallest_sphere", FOREIGN_CALL(irg::smallest_sphere(v.ring3)));
  call("convex_hull", FOREIGN_CALL(irg::convex_hull(v.ring)));
  call("is_convex", FOREIGN_CALL(irg::is_convex(v.ring)));
  call("orientation_of", FOREIGN_CALL(irg::orientation_of(v.ring)));
  call("reversed_ring", FOREIGN_CALL(irg::reversed_ring(v.ring)));
  call("counter_clockwise_ring", FOREIGN_CALL(irg::counter_clockwise_ring(v.ring)));
  call("reverse_ring", FOREIGN_CALL(irg::reverse_ring(v.changed)));
  call("make_counter_clockwise", FOREIGN_CALL(irg::make_counter_clockwise(v.changed)));
  call("polygon_area", FOREIGN_CALL(irg::polygon_area(v.ring)));
  call("polygon_area_exact", FOREIGN_CALL(irg::polygon_area_exact(v.ring)));
  call("polygon_area_fast", FOREIGN_CALL(irg::polygon_area_fast(v.ring)));
  call("twice_signed_area", FOREIGN_CALL(irg::twice_signed_area(v.path)));
  call("polygon_perimeter", FOREIGN_CALL(irg::polygon_perimeter(v.ring)));
  call("polygon_centroid", FOREIGN_CALL(irg::polygon_centroid(v.ring)));
  call("polygon_centroid_fast", FOREIGN_CALL(irg::polygon_centroid_fast(v.ring)));
  call("point_in_convex_polygon", FOREIGN_CALL(irg::point_in_convex_polygon(v.ring, v.e)));
  call("locate_point", FOREIGN_CALL(irg::locate_point(v.ring, v.e)));
  call("point_in_polygon", FOREIGN_CALL(irg::point_in_polygon(v.ring, v.e)));
  call("winding_number", FOREIGN_CALL(irg::winding_number(v.ring, v.e)));
  call("ring_size", FOREIGN_CALL(irg::ring_size(v.ring)));
  call("ring_vertex", FOREIGN_CALL(irg::ring_vertex(v.ring, 5)));
  call("vertex_mean", FOREIGN_CALL(irg::vertex_mean(v.ring3)));
  call("newell_normal", FOREIGN_CALL(irg::newell_normal(v.ring3)));
  call("shape_extrusion", FOREIGN_CALL(irg::shape_extrusion(v.ring, 2)));
  call("seen_through_both", FOREIGN_CALL(irg::seen_through_both(v.g3, v.ring3, v.ring3)));
  call("project_vertices", FOREIGN_CALL(irg::project_vertices(v.ring3, irg::identity_matrix<float, 4>(), v.mapping)));
  call("polygons_overlap", FOREIGN_CALL(irg::polygons_overlap(v.ring, v.ring)));
  call("convex_polygons_overlap", FOREIGN_CALL(irg::convex_polygons_overlap(v.ring, v.ring)));
  call("triangulate_ear_clipping", FOREIGN_CALL(irg::triangulate_ear_clipping(v.ring)));
  call("newell_plane", FOREIGN_CALL(irg::newell_plane(v.ring3)));
  call("newell_plane_through_centroid", FOREIGN_CALL(irg::newell_plane_through_centroid(v.ring3)));
  call("plane_at_corner", FOREIGN_CALL(irg::plane_at_corner(v.ring3)));
  call("facing_by_order", FOREIGN_CALL(irg::facing_by_order(v.ring)));
  call("fill_convex", FOREIGN_CALL(irg::fill_convex(v.picture, v.ring, irg::rgba8{1, 2, 3, 255})));
  call("fill_convex_aa", FOREIGN_CALL(irg::fill_convex_aa(v.picture, v.ring, irg::rgba8{1, 2, 3, 255})));
  call("fill_polygon",
       FOREIGN_CALL(irg::fill_polygon(v.picture, v.ring, irg::fill_rule::non_zero, irg::rgba8{1, 2, 3, 255})));
  call("fill_polygon_aa",
       FOREIGN_CALL(irg::fill_polygon_aa(v.picture, v.ring, irg::fill_rule::non_zero, irg::rgba8{1, 2, 3, 255})));
  call("polygon_boolean", FOREIGN_CALL(irg::polygon_boolean(v.ring, v.ring)));
  call("triangulate_monotone", FOREIGN_CALL(irg::triangulate_monotone(v.ring)));
  call("textbook::clip_weiler_atherton", FOREIGN_CALL(irg::textbook::clip_weiler_atherton(v.path, v.path)));
  call("clip_sutherland_hodgman", FOREIGN_CALL(irg::clip_sutherland_hodgman(v.ring, v.window)));
  call("draw_line", FOREIGN_CALL(irg::draw_line(v.picture, v.from, v.to, irg::rgba8{1, 2, 3, 255})));
  call("draw_line_aa", FOREIGN_CALL(irg::draw_line_aa(v.picture, v.from, v.to, v.colour) &&
                                    irg::draw_line_aa(v.picture, v.a, v.c, v.colour)));
  call("draw_line_styled", FOREIGN_CALL(irg::draw_line_styled(v.picture, v.from, v.to, v.dashes, v.colour)));
  call("draw_line_subpixel", FOREIGN_CALL(irg::draw_line_subpixel(v.picture, v.from, v.to, v.colour) &&
                                          irg::draw_line_subpixel(v.picture, v.a, v.c, v.colour)));
  call("draw_line_thick", FOREIGN_CALL(irg::draw_line_thick(v.picture, v.from, v.to, irg::line_pen{}, v.colour) &&
                                       irg::draw_line_thick(v.picture, v.a, v.c, irg::line_pen{}, v.colour)));
  call("as_cell", FOREIGN_CALL(irg::as_cell(v.from)));
  call("line_subpixel", FOREIGN_CALL(irg::line_subpixel(v.a, v.c, irg::window_of(v.picture), v.cells)));
  call("line_thick", FOREIGN_CALL(irg::line_thick(v.a, v.c, irg::line_pen{}, irg::window_of(v.picture), v.cells)));
  call("draw_line_wu", FOREIGN_CALL(irg::draw_line_wu(v.picture, v.from, v.to, v.colour) &&
                                    irg::draw_line_wu(v.picture, v.a, v.c, v.colour)));
  call("flood_fill", FOREIGN_CALL(irg::flood_fill(v.picture, v.from, v.colour)));
  call("boundary_fill", FOREIGN_CALL(irg::boundary_fill(v.picture, v.from, v.colour, v.colour)));
  call("draw_polygon", FOREIGN_CALL(irg::draw_polygon(v.picture, v.path, irg::rgba8{1, 2, 3, 255})));
  call("draw_polyline", FOREIGN_CALL(irg::draw_polyline(v.picture, v.path, irg::rgba8{1, 2, 3, 255})));
  // planes and homogeneous points
  call("normal_of", FOREIGN_CALL(irg::normal_of(v.plane)));
  call("plane_coefficient", FOREIGN_CALL(irg::plane_coefficient(v.plane, 3)));
  call("plane_value", FOREIGN_CALL(irg::plane_value(v.plane, v.e3)));
  call("side_of", FOREIGN_CALL(irg::side_of(v.plane, v.e3)));
  call("signed_distance", FOREIGN_CALL(irg::signed_distance(v.plane, v.e3)));
  call("facing_by_plane", FOREIGN_CALL(irg::facing_by_plane(v.plane, v.e3)));
  call("closest_point_on_plane", FOREIGN_CALL(irg::closest_point_on_plane(v.plane, v.e3)));
  call("compare_distance_to_plane", FOREIGN_CALL(irg::compare_distance_to_plane(v.plane, v.e3, v.g3)));
  call("intersect_plane_line", FOREIGN_CALL(irg::intersect_plane_line(v.plane, v.a3, v.g3)));
  call("intersect_planes", FOREIGN_CALL(irg::intersect_planes(v.plane, v.plane2, v.plane3)));
  call("parametric_plane_of", FOREIGN_CALL(irg::parametric_plane_of(v.plane)));
  call("parameters_of",
       FOREIGN_CALL(irg::parameters_of(irg::parametric_plane<double>{{1, 0, 0}, {0, 1, 0}, {0, 0, 0}}, v.e3)));
  call("plane_depth", FOREIGN_CALL(irg::plane_depth(v.plane, 1.0, 2.0)));
  call("plane_depth_perspective", FOREIGN_CALL(irg::plane_depth_perspective(v.plane, 5.0, 1.0, 2.0)));
  call("plane_depth_steps", FOREIGN_CALL(irg::plane_depth_steps(v.plane)));
  call("inverse_depth_steps", FOREIGN_CALL(irg::inverse_depth_steps(v.plane, 5.0)));
  call("central_projection_onto_checked",
       FOREIGN_CALL(irg::central_projection_onto_checked(v.plane, irg::point<double, 3>{1, 2, 9})));
  call("central_projection_onto", FOREIGN_CALL(irg::central_projection_onto(v.plane, irg::point<double, 3>{1, 2, 9})));
  call("parallel_projection_onto", FOREIGN_CALL(irg::parallel_projection_onto(v.plane, irg::vec<double, 3>{1, 2, 9})));
  call("parallel_projection_onto_checked",
       FOREIGN_CALL(irg::parallel_projection_onto_checked(v.plane, irg::vec<double, 3>{1, 2, 9})));
  call("plane_by_inversion", FOREIGN_CALL(irg::plane_by_inversion(v.h, v.h2, v.h3)));
  call("projection_onto_plane_checked",
       FOREIGN_CALL(irg::projection_onto_plane_checked(v.plane, irg::hpoint<double, 3>{1, 2, 9, 1})));
  call("projection_onto_plane", FOREIGN_CALL(irg::projection_onto_plane(v.plane, irg::hpoint<double, 3>{1, 2, 9, 1})));
  call("shadow_matrix", FOREIGN_CALL(irg::shadow_matrix(v.plane, irg::hpoint<double, 3>{1, 2, 9, 1})));
  call("shadow_matrix_checked", FOREIGN_CALL(irg::shadow_matrix_checked(v.plane, irg::hpoint<double, 3>{1, 2, 9, 1})));
  return taken;
}

using column = std::map<std::string, bool>;

std::vector<std::pair<std::string, column>> columns() {
  std::vector<std::pair<std::string, column>> all;
  all.emplace_back("plain struct", calls(values<plain2, plain3, plain4, plain_plane, plain_cell>{}));
  all.emplace_back("std::array", calls(values<std::array<double, 2>, std::array<double, 3>, std::array<double, 4>,
                                              std::array<double, 4>, std::array<int, 2>>{}));
#ifdef IRG_HAVE_GLM
  all.emplace_back("GLM", calls(values<glm::dvec2, glm::dvec3, glm::dvec4, glm::dvec4, glm::ivec2>{}));
#endif
#ifdef IRG_HAVE_EIGEN
  all.emplace_back(
      "Eigen", calls(values<Eigen::Vector2d, Eigen::Vector3d, Eigen::Vector4d, Eigen::Vector4d, Eigen::Vector2i>{}));
#endif
#ifdef IRG_HAVE_OPENCV
  all.emplace_back("OpenCV", calls(values<cv::Point2d, cv::Point3d, plain4, plain_plane, cv::Point>{}));
#endif
  return all;
}

// The rows of the page's table: a function, then "yes" or "no" under each origin.
std::map<std::string, std::vector<std::string>> rows_of_page(std::vector<std::string>& heads) {
  std::ifstream page(IRG_CONFORMANCE_DIR "/../../docs/own-types.md");
  std::map<std::string, std::vector<std::string>> rows;
  bool within = false;
  for (std::string line; std::getline(page, line);) {
    if (line.rfind("| function |", 0) == 0) within = true;
    if (!within || line.rfind("| ", 0) != 0) {
      if (line.empty()) within = false;
      continue;
    }
    std::vector<std::string> cells;
    std::istringstream text(line.substr(2));
    for (std::string cell; std::getline(text, cell, '|');) {
      const auto end = cell.find_last_not_of(' '), begin = cell.find_first_not_of(' ');
      if (end != std::string::npos) cells.push_back(cell.substr(begin, end - begin + 1));
    }
    std::vector<std::string> rest(cells.begin() + 1, cells.end());
    std::istringstream names(cells[0]);
    if (cells[0] == "function")
      heads = rest;
    else
      for (std::string name; names >> name;)
        if (name.size() > 2 && name[0] == '`') rows[name.substr(1, name.find_last_of('`') - 1)] = rest;
  }
  return rows;
}

}  // namespace

TEST_CASE("foreign types: every function takes what the table of docs/own-types.md says") {
  std::vector<std::string> heads;
  const auto rows = rows_of_page(heads);
  REQUIRE(heads.size() >= 5);
  std::set<std::string> tried;
  for (const auto& [origin, taken] : columns()) {
    const auto head = std::find(heads.begin(), heads.end(), origin);
    REQUIRE_MESSAGE(head != heads.end(), origin);
    const auto column = static_cast<std::size_t>(head - heads.begin());
    for (const auto& [function, yes] : taken) {
      INFO(function << " with " << origin);
      tried.insert(function);
      const auto row = rows.find(function);
      REQUIRE(row != rows.end());
      CHECK(row->second.at(column) == (yes ? "yes" : "no"));
    }
  }
  for (const auto& [function, cells] : rows) {
    INFO(function);
    CHECK(tried.count(function) == 1);
  }
}

TEST_CASE("foreign types: points of ints are drawn as the cells that they name, far ones too") {
  static_assert(irg::CellPosition<plain_cell> && !irg::CellPosition<irg::cell> && !irg::CellPosition<irg::subpixel>);
  constexpr int far_away = 2'000'000'000;
  const irg::rgba8 colour{1, 2, 3, 255};
  const irg::line_dashes<irg::dash_mask> dashes{irg::dash_mask{0x0f0f, 1}};
  const std::pair<irg::cell, irg::cell> lines[] = {{{1, 2}, {17, 9}},
                                                   {{3, 3}, {3, 3}},
                                                   {{-5, 4}, {far_away, 19}},
                                                   {{-far_away, -far_away}, {far_away, far_away - 7}}};
  for (const auto& [a, b] : lines) {
    const auto drawn = [&]<class P>(const P& from, const P& to) {
      std::array<irg::image<irg::rgba8>, 6> pictures;
      pictures.fill(irg::image<irg::rgba8>(20, 20));
      irg::draw_line(pictures[0], from, to, colour);
      CHECK(irg::draw_line_aa(pictures[1], from, to, colour));
      CHECK(irg::draw_line_wu(pictures[2], from, to, colour));
      CHECK(irg::draw_line_thick(pictures[3], from, to, irg::line_pen{.width = 3 * irg::one_pixel}, colour));
      irg::draw_line_styled(pictures[4], from, to, dashes, colour);
      static_cast<void>(irg::draw_line_subpixel(pictures[5], from, to, colour));
      return pictures;
    };
    CHECK(drawn(a, b) == drawn(plain_cell{a.x, a.y}, plain_cell{b.x, b.y}));
  }
  irg::image<irg::rgba8> one(20, 20), other(20, 20);
  irg::draw_line(one, irg::cell{0, 5}, irg::cell{19, 9}, colour);
  irg::draw_line(other, irg::cell{0, 5}, irg::cell{19, 9}, colour);
  const irg::rgba8 paint{9, 9, 9, 255};
  CHECK(irg::flood_fill(one, irg::cell{0, 0}, paint) == irg::flood_fill(other, plain_cell{0, 0}, paint));
  CHECK(irg::boundary_fill(one, irg::cell{0, 19}, colour, paint) ==
        irg::boundary_fill(other, plain_cell{0, 19}, colour, paint));
  CHECK(one == other);
}

TEST_CASE("foreign types: clip_weiler_atherton of rings of integers gives what it gives for doubles") {
  const auto as_doubles = [](const std::vector<plain_cell>& ring) {
    std::vector<irg::point<double, 2>> out;
    for (const plain_cell& c : ring) out.push_back({static_cast<double>(c.x), static_cast<double>(c.y)});
    return out;
  };
  constexpr int end = 2'147'483'647;
  const std::vector<plain_cell> square{{0, 0}, {10, 0}, {10, 10}, {0, 10}}, slanted{{3, -2}, {14, 5}, {4, 13}},
      within{{2, 2}, {4, 2}, {3, 4}}, apart{{20, 20}, {22, 20}, {21, 23}}, touching{{0, 0}, {5, 5}, {-3, 9}},
      huge{{-end, -end}, {end, -end}, {end, end}, {-end, end}}, across{{-end - 1, -3}, {end - 1, 5}, {7, end - 1}};
  const std::vector<plain_cell>* const pairs[][2] = {{&square, &slanted}, {&slanted, &square}, {&square, &within},
                                                     {&within, &square},  {&square, &apart},   {&square, &touching},
                                                     {&huge, &across},    {&huge, &square}};
  std::size_t rings = 0;
  for (const auto& [subject, clip] : pairs) {
    const auto integers = irg::textbook::clip_weiler_atherton(*subject, *clip);
    const auto doubles = irg::textbook::clip_weiler_atherton(as_doubles(*subject), as_doubles(*clip));
    CHECK(integers.status == doubles.status);
    CHECK(integers.rings == doubles.rings);
    CHECK(integers.entering == doubles.entering);
    CHECK(integers.leaving == doubles.leaving);
    rings += integers.rings.size();
  }
  CHECK(rings >= 6);
}

TEST_CASE("foreign types: project_vertices takes positions of other types, converts them and leaves irg's in place") {
  const std::vector<irg::point<float, 3>> own{{0, 0, 0.5f}, {0.25f, -0.5f, 0.125f}, {7, 0, 0.1f}};
  const std::vector<plain3> others{{0, 0, 0.5}, {0.25, -0.5, 0.125}, {7, 0, static_cast<double>(0.1f)}};
  const auto mapping = irg::map_to_screen<float>({640, 480});
  const auto to_clip = irg::identity_matrix<float, 4>();
  const auto expected = irg::project_vertices<float>(std::span<const irg::point<float, 3>>(own), to_clip, mapping);
  const auto in_place = irg::project_vertices(own, to_clip, mapping);
  irg::projected_vertices<float> converted;
  irg::project_vertices(others, to_clip, mapping, converted);
  const irg::projected_vertices<float> moved = std::move(converted);
  CHECK(in_place.positions.data() == own.data());
  CHECK(in_place.converted.empty());
  for (const auto* v : {&in_place, &moved}) {
    REQUIRE(v->screen.size() == own.size());
    CHECK(v->any.cut == expected.any.cut);
    for (std::size_t i = 0; i < own.size(); ++i) {
      CHECK(v->codes[i].cut == expected.codes[i].cut);
      CHECK(v->screen[i].position == expected.screen[i].position);
      CHECK(irg::clip_position(*v, i) == irg::clip_position(expected, i));
    }
  }
}

namespace {

// The poorest points, and rings and a mesh of them, with the coordinates of irg's own.
template <int N>
archetype::point<double, N> poorest(const irg::point<double, N>& p) {
  return irg::generate_coordinates<archetype::point<double, N>>([&](int i) { return p[i]; });
}
template <int N>
archetype::ring<archetype::point<double, N>, 4> poorest_ring(const std::array<irg::point<double, N>, 4>& r) {
  return archetype::ring<archetype::point<double, N>, 4>(poorest(r[0]), poorest(r[1]), poorest(r[2]), poorest(r[3]));
}
template <class P, class Q>
bool equal_coordinates(const P& p, const Q& q) {
  bool equal = irg::size_of<P> == irg::size_of<Q>;
  for (int i = 0; i < irg::size_of<P> && equal; ++i) equal = irg::coordinate(p, i) == irg::coordinate(q, i);
  return equal;
}
template <class A, class B>
bool equal_lines(const A& a, const B& b) {
  return a.has_value() == b.has_value() &&
         (!a || (equal_coordinates(a->first, b->first) && equal_coordinates(a->second, b->second) &&
                 a->t_first == b->t_first && a->t_second == b->t_second));
}

}  // namespace

TEST_CASE("foreign types: points that can only be copied get the results of irg's own") {
  test::random random(411);
  const auto any = [&]<int N>(std::integral_constant<int, N>) {
    return irg::generate_coordinates<irg::point<double, N>>([&](int) {
      return static_cast<double>(random.integer(-4, 4)) * (random.integer(0, 3) == 0 ? 0x1.999999999999ap-4 : 1);
    });
  };
  const auto plane = [&] { return any(std::integral_constant<int, 2>{}); };
  const auto space = [&] { return any(std::integral_constant<int, 3>{}); };
  const irg::box<double, 2> window{{-2, -1}, {2, 1}};
  const irg::box<double, 3> room{{-2, -1, -1}, {2, 1, 3}};
  const std::array<irg::point<double, 2>, 4> kite{{{0, -2}, {3, 0}, {0, 2}, {-1, 0}}};
  const irg::plane<double> planes[] = {{1, 0, 0, 2}, {-1, 1, 0, 2}, {0, -1, 1, 1}};
  int cut = 0, met = 0, convex = 0, overlapping = 0;
  for (int round = 0; round < 2000; ++round) {
    const auto a = plane(), b = plane(), c = plane(), d = plane();
    const auto e = space(), f = space(), g = space(), h = space();
    const auto pa = poorest(a), pb = poorest(b), pc = poorest(c), pd = poorest(d);
    const auto pe = poorest(e), pf = poorest(f), pg = poorest(g), ph = poorest(h);
    const auto clipped = irg::clip_line_cohen_sutherland(a, b, window);
    cut += clipped && (clipped->t_first > 0 || clipped->t_second < 1);
    CHECK(equal_lines(irg::clip_line_cohen_sutherland(pa, pb, window), clipped));
    CHECK(equal_lines(irg::clip_line_liang_barsky(pa, pb, window), clipped));
    CHECK(equal_lines(irg::clip_line_nicholl_lee_nicholl(pa, pb, window), clipped));
    CHECK(equal_lines(irg::clip_line_liang_barsky(pe, pf, room), irg::clip_line_liang_barsky(e, f, room)));
    CHECK(equal_lines(irg::clip_line_cyrus_beck(pa, pb, poorest_ring(kite)), irg::clip_line_cyrus_beck(a, b, kite)));
    CHECK(equal_lines(irg::clip_line_cyrus_beck(pe, pf, std::span<const irg::plane<double>>(planes)),
                      irg::clip_line_cyrus_beck(e, f, std::span<const irg::plane<double>>(planes))));

    const auto near = irg::closest_point_on_triangle(e, f, g, h);
    const auto poor_near = irg::closest_point_on_triangle(pe, pf, pg, ph);
    CHECK(equal_coordinates(poor_near->at, near->at));
    CHECK(poor_near->region == near->region);
    for (std::size_t i = 0; i < 3; ++i) CHECK(poor_near->weights[i] == near->weights[i]);
    const auto pair = irg::closest_points_of_segments(e, f, g, h);
    const auto poor_pair = irg::closest_points_of_segments(pe, pf, pg, ph);
    CHECK(equal_coordinates(poor_pair->first, pair->first));
    CHECK(equal_coordinates(poor_pair->second, pair->second));

    const auto lines = irg::intersect_lines(a, b, c, d);
    const auto poor_lines = irg::intersect_lines(pa, pb, pc, pd);
    CHECK(poor_lines.relation == lines.relation);
    CHECK(equal_coordinates(poor_lines.at, lines.at));
    const auto common = irg::intersect_segments(a, b, c, d);
    const auto poor_common = irg::intersect_segments(pa, pb, pc, pd);
    met += common.relation != irg::segment_relation::none;
    CHECK(poor_common.relation == common.relation);
    CHECK(equal_coordinates(poor_common.first, common.first));
    CHECK(equal_coordinates(poor_common.last, common.last));
    const auto crossing = irg::intersect_plane_line(planes[1], e, f);
    const auto poor_crossing =
        irg::intersect_plane_line(archetype::plane<double>(planes[1].a, planes[1].b, planes[1].c, planes[1].d), pe, pf);
    CHECK(poor_crossing.relation == crossing.relation);
    CHECK(equal_coordinates(poor_crossing.at, crossing.at));
    CHECK(equal_coordinates(irg::intersect_plane_line(pe, pf, pg, ph, poorest(irg::point<double, 3>{})).at,
                            irg::intersect_plane_line(e, f, g, h, irg::point<double, 3>{}).at));

    const std::array<irg::point<double, 2>, 4> ring{a, b, c, d};
    const std::array<irg::point<double, 3>, 4> corners{e, f, g, h};
    const auto poor_ring = poorest_ring(ring);
    convex += irg::is_convex(ring);
    CHECK(irg::is_convex(poor_ring) == irg::is_convex(ring));
    const irg::polygon_overlap overlap = irg::polygons_overlap(ring, kite);
    overlapping += overlap != irg::polygon_overlap::separate;
    CHECK(irg::polygons_overlap(poor_ring, poorest_ring(kite)) == overlap);
    if (irg::is_convex(ring))
      CHECK(irg::convex_polygons_overlap(poor_ring, poorest_ring(kite)) == irg::convex_polygons_overlap(ring, kite));
    const auto ball = irg::smallest_sphere(corners), poor_ball = irg::smallest_sphere(poorest_ring(corners));
    CHECK(poor_ball->centre == ball->centre);
    CHECK(poor_ball->radius == ball->radius);

    const auto v = irg::to_vec(e);
    const auto poor_v = irg::generate_coordinates<archetype::vector<double, 3>>([&](int i) { return v[i]; });
    CHECK(equal_coordinates(irg::normalized(poor_v), irg::normalized(v)));
    CHECK(irg::try_normalized(poor_v).has_value() == irg::try_normalized(v).has_value());
    CHECK(irg::rotation(poor_v, 0.5) == irg::rotation(v, 0.5));
    // curve samples of points that say that they are: the derivative is a vector
    std::array<archetype::kept_point<double, 2>, 3> control;
    for (std::size_t k = 0; k < 3; ++k)
      control[k] = irg::generate_coordinates<archetype::kept_point<double, 2>>([&](int i) { return ring[k][i]; });
    const std::array<irg::point<double, 2>, 3> own_control{a, b, c};
    CHECK(irg::bezier_sample(control, 0.25).derivative == irg::bezier_sample(own_control, 0.25).derivative);
  }
  CHECK(test::enough(cut > 200 && met > 100 && convex > 50 && overlapping > 200));
}
