// SPDX-License-Identifier: MIT
// orient2d, orient3d, in_circle, in_sphere and point in polygon: run time against wrong signs, from easy points to
// degenerate ones of all sizes.
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include <irg/geometry/point_in_polygon.hpp>
#include <irg/math/double_double.hpp>
#include <irg/math/error_free.hpp>
#include <irg/math/exact_sum.hpp>
#include <irg/math/vec.hpp>

#include "accuracy/vector_sets.hpp"
#include "geometry/decisions.hpp"
#include "geometry/gmp_signs.hpp"
#include "geometry/peer_cgal.hpp"
#include "geometry/predicate_sets.hpp"

#ifdef IRG_HAVE_CGAL
#include <CGAL/Polygon_2_algorithms.h>
#endif
#ifdef IRG_HAVE_OPENCV_IMGPROC
#include <opencv2/imgproc.hpp>
#endif

#ifdef IRG_HAVE_MPFR

namespace {

using namespace bench;
using point2 = irg::point<double, 2>;

template <int N, int D>
void decide(study& s, const point_set<double, N, D>& made) {
  const auto& set = keep(point_set<double, N, D>(made));
  const auto exact = [](const auto& call, exact_results& out) {
    out.push_back({static_cast<double>(true_sign<double, N, D>(call)), 0});
  };
  const distribution d{set.name, set.calls.size(), 1, exact_for(set.calls, exact)};
  const auto& points = keep(own_points(set));
  std::vector<implementation> who{
      for_each_item("irg", points, [](const auto& p) { return irg_sign<N, D>(p); }),
      for_each_item("determinant in double", set.calls,
                    [](const auto& p) { return textbook_determinant<double, double, N, D>(p); }),
      for_each_item("determinant in float", set.calls,
                    [](const auto& p) { return static_cast<double>(textbook_determinant<float, double, N, D>(p)); }),
      for_each_item("determinant in double_double", set.calls,
                    [](const auto& p) { return textbook_determinant<irg::double_double, double, N, D>(p).high; })};
  if constexpr (N == 3) {
    who.push_back(for_each_item("difference of products", set.calls, [](const auto& p) {
      return irg::difference_of_products(p[0][0] - p[2][0], p[1][1] - p[2][1], p[1][0] - p[2][0], p[0][1] - p[2][1]);
    }));
    who.push_back(for_each_item("exact sum alone", set.calls, [](const auto& p) {
      irg::exact_accumulator<2> sum;
      for (std::size_t i = 0; i < 3; ++i) {
        const auto &a = p[i], &b = p[(i + 1) % 3];
        sum.add(a[0], b[1]);
        sum.subtract(a[1], b[0]);
      }
      return sum.sign();
    }));
  }
#ifdef IRG_HAVE_CGAL
  const auto& cgal_points = keep(cgal::points_of(set));
  who.push_back(for_each_item("CGAL EPICK", cgal_points, [](const auto& p) { return cgal::sign<N, D>(p); }));
#endif
  s.panel(d, who, text_of_items(set.calls));
}

template <int N, int D>
void decide_all(const char* kernel, const point_set<double, N, D>& grid) {
  study s(kernel, "call", error_unit::sign);
  for (const auto& set : common_sets<N, D>()) decide<N, D>(s, set);
  decide<N, D>(s, grid);
}

// ---- point in polygon

struct query {
  std::string name;
  std::vector<point2> ring, points;
};

// A star of 32 corners on a grid of 2^-20, so that its numbers are floats, too.
query queries(const std::string& name, int difficulty) {
  random_numbers r(12);
  query q{name, {}, {}};
  const auto on_grid = [](double x) { return std::floor(x * 0x1p20) * 0x1p-20; };
  for (int i = 0; i < 32; ++i) {
    const double angle = 0.19634954084936207 * i, radius = i % 2 == 0 ? 1 : 0.5;
    q.ring.push_back({on_grid(radius * std::cos(angle)), on_grid(radius * std::sin(angle))});
  }
  for (std::size_t i = 0; i < (smoke() ? 16 : 2048); ++i) {
    const point2 a = q.ring[i % 32], b = q.ring[(i + 1) % 32];
    const double t = r.unit();
    point2 p{r.between(-1, 1), r.between(-1, 1)};
    if (difficulty == 1) p = {on_grid(a.x + t * (b.x - a.x)), on_grid(a.y + t * (b.y - a.y))};
    if (difficulty == 2) p = {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)};
    if (difficulty == 3) p = i % 3 == 0 ? a : point2{a.x * 0.5 + b.x * 0.5, a.y * 0.5 + b.y * 0.5};
    if (difficulty == 3 && i % 3 == 2) p.x = std::nextafter(p.x, r.integer(0, 1) == 0 ? -9.0 : 9.0);
    q.points.push_back(p);
  }
  return q;
}

// 1 inside, 0 on the outline, -1 outside.
int true_location(const std::vector<point2>& ring, const point2& p) {
  bool inside = false;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const point2 a = ring[i], b = ring[(i + 1) % ring.size()];
    const real turn = (real(b.x) - a.x) * (real(p.y) - a.y) - (real(b.y) - a.y) * (real(p.x) - a.x);
    const bool between = std::fmin(a.x, b.x) <= p.x && p.x <= std::fmax(a.x, b.x) && std::fmin(a.y, b.y) <= p.y &&
                         p.y <= std::fmax(a.y, b.y);
    if (turn == real(0) && between) return 0;
    if ((a.y > p.y) != (b.y > p.y) && (real(0) < turn) == (a.y < b.y)) inside = !inside;
  }
  return inside ? 1 : -1;
}

// The crossings of a ray, as in Franklin's PNPOLY.
int crossings(const std::vector<point2>& ring, const point2& p) {
  bool inside = false;
  for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
    const point2 &a = ring[i], &b = ring[j];
    if ((a.y > p.y) != (b.y > p.y) && p.x < (b.x - a.x) * (p.y - a.y) / (b.y - a.y) + a.x) inside = !inside;
  }
  return inside ? 1 : -1;
}

void locate(study& s, query made) {
  const query& q = keep(std::move(made));
  const auto exact = [&q](const point2& p, exact_results& out) {
    out.push_back({static_cast<double>(true_location(q.ring, p)), 0});
  };
  const distribution d{q.name, q.points.size(), 1, exact_for(q.points, exact)};
  std::vector<implementation> who{
      for_each_item("irg", q.points,
                    [&q](const point2& p) {
                      const auto where = irg::point_in_polygon(q.ring, p);
                      return where == irg::location::inside ? 1 : where == irg::location::outside ? -1 : 0;
                    }),
      for_each_item("crossings in double", q.points, [&q](const point2& p) { return crossings(q.ring, p); })};
#ifdef IRG_HAVE_CGAL
  auto& ring = keep(std::vector<cgal::epick::Point_2>());
  for (const point2& v : q.ring) ring.emplace_back(v.x, v.y);
  who.push_back(for_each_item("CGAL EPICK", q.points, [&ring](const point2& p) {
    return CGAL::bounded_side_2(ring.begin(), ring.end(), cgal::epick::Point_2(p.x, p.y), cgal::epick());
  }));
#endif
#ifdef IRG_HAVE_OPENCV_IMGPROC
  auto& contour = keep(std::vector<cv::Point2f>());
  const auto in_float = [](const point2& p) { return cv::Point2f(static_cast<float>(p.x), static_cast<float>(p.y)); };
  for (const point2& v : q.ring) contour.push_back(in_float(v));
  who.push_back(for_each_item(
      "OpenCV (points in float)", q.points,
      [&contour, in_float](const point2& p) { return cv::pointPolygonTest(contour, in_float(p), false); }, false));
#endif
  s.panel(d, who, text_of_items(q.points));
}

}  // namespace

int main(int argc, char** argv) {
  decide_all<3, 2>("orient2d", ulp_grid<3, 2>("grid of ulps", {{{0.5, 0.5}, {12, 12}, {24, 24}}}, 0, 64));
  decide_all<4, 3>(
      "orient3d", ulp_grid<4, 3>("grid of ulps", {{{0.5, 0.5, 0.5}, {12, 12, 12}, {24, 24, 24}, {12, 24, 18}}}, 0, 16));
  decide_all<4, 2>("in circle", ulp_grid<4, 2>("grid of ulps", {{{24, 0.5}, {24, 12}, {0.5, 12}, {0.5, 0.5}}}, 3, 64));
  decide_all<5, 3>(
      "in sphere",
      ulp_grid<5, 3>("grid of ulps", {{{24, 0.5, 0.5}, {24, 12, 0.5}, {0.5, 12, 0.5}, {0.5, 0.5, 12}, {0.5, 0.5, 0.5}}},
                     4, 16));
  study s("point in polygon", "point", error_unit::sign);
  locate(s, queries("anywhere", 0));
  locate(s, queries("beside edges to 2^-20", 1));
  locate(s, queries("beside edges to an ulp", 2));
  locate(s, queries("on edges and corners or an ulp off", 3));
  return run_benchmarks(argc, argv);
}

#else
#include <cstdio>
int main() { std::puts("accuracy_predicates: skipped, GMP was not found"); }
#endif
