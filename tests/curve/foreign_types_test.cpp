// SPDX-License-Identifier: MIT
// Curves and patches of points that are not irg's: plain structs, std::array, GLM's, Eigen's and OpenCV's. Each result is,
// bit for bit, what points of irg give.
#include <irg/curve/bezier.hpp>
#include <irg/curve/bezier_accurate.hpp>
#include <irg/curve/bezier_degree.hpp>
#include <irg/curve/bezier_edge_form.hpp>
#include <irg/curve/bezier_forward.hpp>
#include <irg/curve/bezier_prepared.hpp>
#include <irg/curve/bezier_queries.hpp>
#include <irg/curve/bezier_surface.hpp>
#include <irg/curve/bspline.hpp>
#include <irg/curve/bspline_derivative.hpp>
#include <irg/curve/bspline_fit.hpp>
#include <irg/curve/curve_joint.hpp>
#include <irg/curve/flatten.hpp>
#include <irg/curve/keyframes.hpp>

#include <array>
#include <span>
#include <vector>

#include "support/own_types.hpp"

#include <doctest/doctest.h>

namespace {

using plain2 = own::plain2<double>;
using plain3 = own::plain3<double>;

template <class P>
std::array<P, 4> control_points() {
  constexpr double x[4][3] = {{0, 0.1, 1}, {1, 2.3, 0.7}, {3.1, -4, 2}, {5, 0.25, -3}};
  std::array<P, 4> points{};
  for (std::size_t k = 0; k < 4; ++k) points[k] = irg::generate_coordinates<P>([&](int i) { return x[k][i]; });
  return points;
}

// The coordinates of every result, one after the other.
template <class P>
std::vector<double> curves_of() {
  std::vector<double> out;
  const auto put = [&](const auto& p) {
    for (int i = 0; i < irg::size_of<P>; ++i) out.push_back(irg::coordinate(p, i));
  };
  const auto points = control_points<P>();
  const std::vector<P> list(points.begin(), points.end());
  std::vector<P> work(12), left(4), right(5);
  using vector = typename irg::curve_sample<P>::vector;
  std::vector<vector> vectors(12);
  constexpr double t = 0.3;

  put(irg::bezier_point(points, t));
  put(irg::bezier_point(list, t, std::span<P>(work)));
  put(irg::bezier_point(std::span<const P>(list), t, std::span<P>(work)));
  put(irg::bezier_point_wozny_chudy(points, t));
  put(irg::bezier_point_accurate(points, t));
  const irg::curve_sample<P> sample = irg::bezier_sample(points, t);
  put(sample.point);
  put(sample.derivative);
  irg::bezier_split(points, t, std::span<P>(left), std::span<P>(right));
  for (const P& p : left) put(p);
  irg::bezier_derivative(points, std::span<vector>(vectors));
  put(vectors[2]);
  irg::bezier_elevate(points, std::span<P>(right));
  for (const P& p : right) put(p);
  out.push_back(irg::bezier_reduce(points, std::span<P>(left)));
  put(left[1]);
  irg::bezier_forward(points, 5, std::span<P>(work), [&](const P& p) { put(p); });
  irg::flatten(points, 0.01, std::span<P>(work), [&](const P& p) { put(p); });
  irg::curve_workspace<P> workspace;
  put(irg::bezier_sample(list, t, workspace).derivative);
  irg::flatten(list, 0.01, [&](const P& p) { put(p); }, workspace);
  put(irg::bezier_nearest(list, points[2]).point);
  std::vector<irg::vec<double, 1>> numbers(64);
  put(irg::bezier_nearest(points, points[2], std::span(numbers), std::span<P>(work)).point);
  const auto box = irg::bezier_box(points, std::span(numbers));
  put(box.low);
  put(box.high);
  std::vector<double> space(irg::prepared_bezier<P>::numbers_for(4));
  std::vector<irg::exact_sum<double>> sums(4);
  const auto prepared = irg::prepare_bezier(points, std::span<double>(space), std::span<irg::exact_sum<double>>(sums));
  REQUIRE(prepared);
  put(irg::bezier_point(*prepared, t));

  constexpr std::array<double, 8> knots{0, 0, 0, 0, 1, 1, 1, 1};
  const auto cubic = irg::make_bspline_knots<3>(std::span<const double>(knots));
  REQUIRE(cubic);
  put(*irg::bspline_point(*cubic, points, t));
  put(irg::bspline_sample(*cubic, points, t, std::span<vector>(vectors))->derivative);
  out.push_back(static_cast<double>(irg::continuity_of(points, points)));

  // What is zero is set to zero: vectors of Eigen have any numbers when they are made.
  const std::array<P, 1> alone{points[1]};
  put(irg::bezier_sample(alone, t).derivative);
  irg::bezier_derivative(alone, std::span<vector>(vectors));
  put(vectors[0]);
  std::vector<vector> high(5);
  irg::bspline_derivatives(*cubic, points, t, std::span<vector>(high), std::span<vector>(vectors));
  for (const vector& d : high) put(d);
  constexpr std::array<double, 4> places{0, 0.25, 0.7, 1};
  for (P& p : left) p = points[0];
  CHECK(irg::bspline_interpolate(*cubic, std::span<const double>(places), std::span<const P>(points),
                                 std::span<P>(left)));
  for (const P& p : left) put(p);

  std::array<irg::keyframe<P>, 4> frames{};
  for (std::size_t k = 0; k < 4; ++k) frames[k] = {static_cast<double>(k), points[k]};
  put(irg::place_at(std::span<const irg::keyframe<P>>(frames), 1.7));
  if constexpr (irg::size_of<P> == 3) {
    irg::bezier_patch<P> patch{};
    for (auto& row : patch.points) row = points;
    for (std::size_t i = 0; i < 4; ++i) patch.points[i][0] = points[3 - i];
    put(irg::patch_point(patch, 0.25, t));
    put(irg::patch_sample(patch, 0.25, t).duv);
    put(irg::patch_normal(patch, 0.25, t).value());
  }
  return out;
}

template <class P>
void check_as_own() {
  const auto found = curves_of<P>();
  REQUIRE(found.size() > 50);
  CHECK(found == curves_of<irg::point<double, static_cast<int>(irg::size_of<P>)>>());
}

}  // namespace

TEST_CASE("curves: points of other libraries give the same bits as irg's") {
  check_as_own<plain2>();
  check_as_own<plain3>();
  check_as_own<std::array<double, 2>>();
  check_as_own<std::array<double, 3>>();
#ifdef IRG_HAVE_GLM
  check_as_own<glm::dvec2>();
  check_as_own<glm::dvec3>();
#endif
#ifdef IRG_HAVE_EIGEN
  check_as_own<Eigen::Vector2d>();
  check_as_own<Eigen::Vector3d>();
#endif
#ifdef IRG_HAVE_OPENCV
  check_as_own<cv::Point2d>();
  check_as_own<cv::Point3d>();
#endif
}
