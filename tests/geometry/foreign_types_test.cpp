// SPDX-License-Identifier: MIT
// Every function of vectors, points, rings and planes is called with types that are not irg's: plain structs, std::array,
// GLM's, Eigen's and OpenCV's. What takes what is the table of docs/own-types.md, which is held against the calls; a row
// that says "no" there has its reason beside it.
#include <irg/curve/curve_frame.hpp>
#include <irg/geometry.hpp>
#include <irg/hidden/back_faces.hpp>
#include <irg/hidden/plane_depth.hpp>
#include <irg/math.hpp>
#include <irg/raster/draw_polyline.hpp>
#include <irg/raster/fill_convex.hpp>
#include <irg/raster/fill_convex_aa.hpp>
#include <irg/raster/fill_polygon.hpp>
#include <irg/raster/fill_polygon_aa.hpp>
#include <irg/raster/image.hpp>
#include <irg/raster/line_aa.hpp>
#include <irg/view/affine.hpp>
#include <irg/view/look_at.hpp>
#include <irg/view/plane_projection.hpp>

#include <algorithm>
#include <array>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#ifdef IRG_HAVE_GLM
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#endif
#ifdef IRG_HAVE_EIGEN
#include <Eigen/Core>
#endif
#ifdef IRG_HAVE_OPENCV
#include <opencv2/core.hpp>
#endif

#include <doctest/doctest.h>

namespace {

struct plain2 {
  double x, y;
};
struct plain3 {
  double x, y, z;
};
struct plain4 {
  double x, y, z, w;
};
struct plain_cell {
  int x, y;
};
struct plain_plane {
  double a, b, c, d;
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
  call("normalized", FOREIGN_CALL(irg::normalized(v.b3)));
  call("normalized_fast", FOREIGN_CALL(irg::normalized_fast(v.b3)));
  call("try_normalize", FOREIGN_CALL(irg::try_normalize(v.b3)));
  call("angle_between", FOREIGN_CALL(irg::angle_between(v.b3, v.c3)));
  call("scalar_projection", FOREIGN_CALL(irg::scalar_projection(v.b3, v.c3)));
  call("vector_projection", FOREIGN_CALL(irg::vector_projection(v.b3, v.c3)));
  call("cosine_between", FOREIGN_CALL(irg::cosine_between(v.b3, v.c3)));
  call("dot_products", FOREIGN_CALL(irg::dot_products(v.ring3, v.ring3, std::span(v.numbers))));
  call("cross_products", FOREIGN_CALL(irg::cross_products(v.ring3, v.ring3, std::span(v.space))));
  call("normalize_vectors", FOREIGN_CALL(irg::normalize_vectors(v.ring3, std::span(v.space))));
  call("normalize_vectors_fast", FOREIGN_CALL(irg::normalize_vectors_fast(v.ring3, std::span(v.space))));
  call("transform_points", FOREIGN_CALL(irg::transform_points(irg::identity<double, 4>(), v.ring3, v.space)));
  call("transform_vectors", FOREIGN_CALL(irg::transform_vectors(irg::identity<double, 4>(), v.ring3, v.space)));
  call("transform_point", FOREIGN_CALL(irg::transform_point(irg::identity<double, 4>(), v.b3)));
  call("transform_vector", FOREIGN_CALL(irg::transform_vector(irg::identity<double, 4>(), v.b3)));
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
  call("can_snap", FOREIGN_CALL(irg::can_snap(v.a)));
  call("snap", FOREIGN_CALL(irg::snap(v.a)));
  call("widest_view", FOREIGN_CALL(irg::widest_view(v.a3, v.b3, v.c3)));
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
  call("height_of", FOREIGN_CALL(irg::height_of(irg::line<double>{1, 2, 3}, v.b)));
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
  call("enclosing_box", FOREIGN_CALL(irg::enclosing_box(v.ring3)));
  call("smallest_sphere", FOREIGN_CALL(irg::smallest_sphere(v.ring3)));
  call("convex_hull", FOREIGN_CALL(irg::convex_hull(v.ring)));
  call("is_convex", FOREIGN_CALL(irg::is_convex(v.ring)));
  call("orientation_of", FOREIGN_CALL(irg::orientation_of(v.ring)));
  call("reversed_ring", FOREIGN_CALL(irg::reversed_ring(v.ring)));
  call("counter_clockwise_ring", FOREIGN_CALL(irg::counter_clockwise_ring(v.ring)));
  call("reverse_ring", FOREIGN_CALL(irg::reverse_ring(v.changed)));
  call("make_counter_clockwise", FOREIGN_CALL(irg::make_counter_clockwise(v.changed)));
  call("polygon_area", FOREIGN_CALL(irg::polygon_area(v.ring)));
  call("polygon_centroid", FOREIGN_CALL(irg::polygon_centroid(v.ring)));
  call("polygon_centroid_fast", FOREIGN_CALL(irg::polygon_centroid_fast(v.ring)));
  call("point_in_convex_polygon", FOREIGN_CALL(irg::point_in_convex_polygon(v.ring, v.e)));
  call("point_in_convex_polygon_log", FOREIGN_CALL(irg::point_in_convex_polygon_log(v.ring, v.e)));
  call("locate_point", FOREIGN_CALL(irg::locate_point(v.ring, v.e)));
  call("polygons_overlap", FOREIGN_CALL(irg::polygons_overlap(v.ring, v.ring)));
  call("convex_polygons_overlap", FOREIGN_CALL(irg::convex_polygons_overlap(v.ring, v.ring)));
  call("triangulate_ear_clipping", FOREIGN_CALL(irg::triangulate_ear_clipping(v.ring)));
  call("flattening_axis", FOREIGN_CALL(irg::flattening_axis(v.ring3)));
  call("newell_plane", FOREIGN_CALL(irg::newell_plane(v.ring3)));
  call("newell_plane_through_centroid", FOREIGN_CALL(irg::newell_plane_through_centroid(v.ring3)));
  call("plane_at_corner", FOREIGN_CALL(irg::plane_at_corner(v.ring3)));
  call("side_by_order", FOREIGN_CALL(irg::side_by_order(v.ring)));
  call("fill_convex", FOREIGN_CALL(irg::fill_convex(v.picture, v.ring, irg::rgba8{1, 2, 3, 255})));
  call("fill_convex_aa", FOREIGN_CALL(irg::fill_convex_aa(v.picture, v.ring, irg::rgba8{1, 2, 3, 255})));
  call("fill_polygon",
       FOREIGN_CALL(irg::fill_polygon(v.picture, v.ring, irg::fill_rule::non_zero, irg::rgba8{1, 2, 3, 255})));
  call("fill_polygon_aa",
       FOREIGN_CALL(irg::fill_polygon_aa(v.picture, v.ring, irg::fill_rule::non_zero, irg::rgba8{1, 2, 3, 255})));
  call("polygon_overlay", FOREIGN_CALL(irg::polygon_overlay(v.ring, v.ring)));
  call("triangulate_monotone", FOREIGN_CALL(irg::triangulate_monotone(v.ring)));
  call("clip_sutherland_hodgman", FOREIGN_CALL(irg::clip_sutherland_hodgman(v.ring, v.window)));
  call("draw_line", FOREIGN_CALL(irg::draw_line(v.picture, v.from, v.to, irg::rgba8{1, 2, 3, 255})));
  call("draw_line_aa", FOREIGN_CALL(irg::draw_line_aa(v.picture, v.a, v.c, irg::rgba8{1, 2, 3, 255})));
  call("draw_polyline", FOREIGN_CALL(irg::draw_polyline(v.picture, v.path, irg::rgba8{1, 2, 3, 255})));
  // planes and homogeneous points
  call("normal_of", FOREIGN_CALL(irg::normal_of(v.plane)));
  call("plane_value", FOREIGN_CALL(irg::plane_value(v.plane, v.e3)));
  call("side_of", FOREIGN_CALL(irg::side_of(v.plane, v.e3)));
  call("signed_distance", FOREIGN_CALL(irg::signed_distance(v.plane, v.e3)));
  call("side_by_plane", FOREIGN_CALL(irg::side_by_plane(v.plane, v.e3)));
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
  call("parallel_projection_onto_checked",
       FOREIGN_CALL(irg::parallel_projection_onto_checked(v.plane, irg::vec<double, 3>{1, 2, 9})));
  call("plane_by_inversion", FOREIGN_CALL(irg::plane_by_inversion(v.h, v.h2, v.h3)));
  call("projection_onto_plane_checked",
       FOREIGN_CALL(irg::projection_onto_plane_checked(v.plane, irg::hpoint<double, 3>{1, 2, 9, 1})));
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
