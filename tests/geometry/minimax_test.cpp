// SPDX-License-Identifier: MIT
#include <irg/geometry/minimax.hpp>

#include <array>
#include <limits>

#include "support/check_both.hpp"

using irg::box;
using irg::box_boundary;
using irg::point;
using irg::rectangle_of;
using irg::rectangles_overlap;
using irg::segment;

namespace {

using P2 = point<double, 2>;
using P3 = point<double, 3>;
using edge = segment<double, 2>;

/// A body of one triangle, with a vertex that no face uses.
struct body {
  std::array<P3, 4> at;
};

constexpr edge of(double x1, double y1, double x2, double y2) { return {{x1, y1}, {x2, y2}}; }

}  // namespace

template <>
struct irg::mesh_traits<body> {
  using point = P3;
  static constexpr std::size_t vertex_count(const body& b) { return b.at.size(); }
  static constexpr P3 position(const body& b, std::size_t v) { return b.at[v]; }
  static constexpr std::size_t face_count(const body&) { return 1; }
  static constexpr std::size_t face_size(const body&, std::size_t) { return 3; }
  static constexpr std::size_t face_vertex(const body&, std::size_t, std::size_t k) { return k; }
};

TEST_CASE("minimax: the course's values") {
  CHECK_BOTH(!rectangles_overlap(of(0, 0, 2, 2), of(3, 0, 4, 1)));
  CHECK_BOTH(rectangles_overlap(of(0, 0, 2, 2), of(1, 1, 3, 3)));
  CHECK_BOTH(rectangles_overlap(of(0, 0, 2, 2), of(2, 0, 3, 1)));
  CHECK_BOTH(!rectangles_overlap(of(0, 0, 2, 2), of(2, 0, 3, 1), box_boundary::open));
  CHECK_BOTH(!rectangles_overlap(of(0, 0, 4, 1), of(0, 2, 4, 3)));
}

TEST_CASE("minimax: the six pairs") {
  constexpr body b{{P3{0, 0, 5}, P3{2, 0, 6}, P3{0, 2, 7}, P3{1, 1, 0}}},
      far{{P3{9, 0, 5}, P3{8, 0, 6}, P3{9, 2, 7}, P3{9, 1, 0}}};
  constexpr std::array near{P3{1, 1, -9}, P3{3, 1, -9}, P3{1, 3, -9}}, apart{P3{5, 1, 5}, P3{6, 1, 6}, P3{5, 3, 7}};
  constexpr segment<double, 3> e{{-1, -1, 0}, {0.5, 0.5, 0}};
  CHECK_BOTH(!rectangles_overlap(b, far));       // body, body
  CHECK_BOTH(rectangles_overlap(b, b));
  CHECK_BOTH(rectangles_overlap(near, b));       // polygon, body: z is not looked at
  CHECK_BOTH(!rectangles_overlap(apart, b));
  CHECK_BOTH(rectangles_overlap(e, b));          // edge, body
  CHECK_BOTH(!rectangles_overlap(near, apart));  // polygon, polygon
  CHECK_BOTH(!rectangles_overlap(e, near));      // edge, polygon
  CHECK_BOTH(rectangles_overlap(e, e));          // edge, edge
  CHECK_BOTH(rectangle_of(b) == box<double, 2>{{0, 0}, {2, 2}});
}

TEST_CASE("minimax: each test is counted by its kind, in either order") {
  using irg::minimax_test;
  using polygon = std::array<P3, 3>;
  CHECK_BOTH(irg::minimax_test_of<edge, edge> == minimax_test::edge_edge);
  CHECK_BOTH(irg::minimax_test_of<polygon, edge> == minimax_test::edge_polygon);
  CHECK_BOTH(irg::minimax_test_of<edge, polygon> == minimax_test::edge_polygon);
  CHECK_BOTH(irg::minimax_test_of<body, edge> == minimax_test::edge_body);
  CHECK_BOTH(irg::minimax_test_of<edge, body> == minimax_test::edge_body);
  CHECK_BOTH(irg::minimax_test_of<polygon, polygon> == minimax_test::polygon_polygon);
  CHECK_BOTH(irg::minimax_test_of<polygon, body> == minimax_test::polygon_body);
  CHECK_BOTH(irg::minimax_test_of<body, polygon> == minimax_test::polygon_body);
  CHECK_BOTH(irg::minimax_test_of<body, body> == minimax_test::body_body);
  constexpr irg::minimax_counts counts = [] {
    irg::minimax_counts c;
    rectangles_overlap(of(0, 0, 2, 2), of(2, 0, 3, 1), c);
    rectangles_overlap(of(0, 0, 2, 2), of(2, 0, 3, 1), c, box_boundary::open);
    rectangles_overlap(polygon{P3{5, 5, 0}, P3{6, 5, 0}, P3{5, 6, 0}}, of(0, 0, 1, 1), c);
    return c;
  }();
  CHECK_BOTH(counts.test[0] == irg::minimax_count{2, 1});
  CHECK_BOTH(counts.test[1] == irg::minimax_count{1, 1});
  CHECK_BOTH((counts.test[2] == irg::minimax_count{} && counts.test[5] == irg::minimax_count{}));
}

TEST_CASE("minimax: nothing overlaps what has no points") {
  CHECK_BOTH(!rectangles_overlap(std::array<P2, 0>{}, of(0, 0, 1, 1)));
  constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
  CHECK_BOTH(!rectangles_overlap(of(not_a_number, 0, not_a_number, 1), of(0, 0, 1, 1)));
}
