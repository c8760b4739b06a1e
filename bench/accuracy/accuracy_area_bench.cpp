// SPDX-License-Identifier: MIT
// Areas of polygons far from the origin and of ones that nearly cancel, areas of thin triangles from corners and from
// sides, and barycentric coordinates in them: run time against error.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

#include <irg/geometry/textbook/triangle_area.hpp>
#include <irg/geometry/textbook/polygon.hpp>
#include <irg/geometry/barycentric.hpp>
#include <irg/geometry/polygon_area.hpp>
#include <irg/geometry/triangle_area.hpp>

#include "accuracy/vector_sets.hpp"

#ifdef IRG_HAVE_OPENCV_IMGPROC
#include <opencv2/imgproc.hpp>
#endif

#ifdef IRG_HAVE_CGAL
#include <CGAL/Polygon_2_algorithms.h>
#include <CGAL/Simple_cartesian.h>
#endif

#ifdef BENCH_HAS_MPFR

namespace {

using bench::real;
using point2 = irg::point<double, 2>;
constexpr double none = std::numeric_limits<double>::quiet_NaN();
using ring = std::array<point2, 16>;
int count() { return bench::smoke() ? 16 : 1024; }

real twice_area(const point2& a, const point2& b, const point2& c) {
  return (real(b.x) - a.x) * (real(c.y) - a.y) - (real(b.y) - a.y) * (real(c.x) - a.x);
}

// ---- polygons

void polygon(bench::study& s, const std::string& name, double offset, double left) {
  bench::random_numbers r(14);
  auto& items = bench::keep(std::vector<ring>(static_cast<std::size_t>(count())));
  for (ring& polygon : items) {
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const double t = 0.39269908169872414 * static_cast<double>(i), radius = 1 + r.unit();
      polygon[i] = {offset + radius * std::cos(t), offset + radius * std::sin(t)};
    }
    if (left < 1)  // the way back, at nearly the same places
      for (std::size_t i = 8; i < 16; ++i) polygon[i] = {polygon[15 - i].x * (1 + left * r.unit()), polygon[15 - i].y};
  }
  const auto exact = [](const ring& p, bench::exact_results& out) {
    real sum = 0;
    for (std::size_t i = 2; i < 16; ++i) sum = sum + twice_area(p[0], p[i - 1], p[i]);
    out.push_back((sum / real(2)).result());
  };
  const bench::distribution d{name, items.size(), 1, bench::exact_for(items, exact)};
  std::vector<bench::implementation> who{
      bench::for_each_item("irg", items, [](const ring& p) { return irg::polygon_area(p); }),
      bench::for_each_item("irg: polygon_area_fast", items, [](const ring& p) { return irg::polygon_area_fast(p); }),
      bench::for_each_item("irg: polygon_area_exact", items, [](const ring& p) { return irg::polygon_area_exact(p); }),
      bench::for_each_item("textbook", items, [](const ring& p) { return irg::textbook::polygon_area(p); })};
#ifdef IRG_HAVE_OPENCV_IMGPROC
  auto& in_float = bench::keep(std::vector<std::array<cv::Point2f, 16>>(items.size()));
  for (std::size_t k = 0; k < items.size(); ++k)
    for (std::size_t i = 0; i < 16; ++i)
      in_float[k][i] = {static_cast<float>(items[k][i].x), static_cast<float>(items[k][i].y)};
  const auto area = [](const std::array<cv::Point2f, 16>& p) { return cv::contourArea(p, true); };
  who.push_back(bench::for_each_item("OpenCV (points in float)", in_float, area, false));
#endif
#ifdef IRG_HAVE_CGAL
  using kernel = CGAL::Simple_cartesian<double>;
  auto& of_cgal = bench::keep(std::vector<std::array<kernel::Point_2, 16>>(items.size()));
  for (std::size_t k = 0; k < items.size(); ++k)
    for (std::size_t i = 0; i < 16; ++i) of_cgal[k][i] = {items[k][i].x, items[k][i].y};
  who.push_back(bench::for_each_item("CGAL", of_cgal,
                                     [](const auto& p) { return CGAL::polygon_area_2(p.begin(), p.end(), kernel()); }));
#endif
  s.panel(d, who, bench::text_of_items(items));
}

void polygons() {
  bench::study s("area of a polygon", "polygon of 16 corners", bench::error_unit::ulp);
  for (const int power : {0, 4, 8, 12, 15}) {
    const double offset = power == 0 ? 0 : std::pow(10.0, power);
    polygon(s, power == 0 ? "about the origin" : "10^" + std::to_string(power) + " away", offset, 1);
  }
  polygon(s, "there and back 10^-10 apart", 0, 1e-10);
}

// ---- triangles

struct triangle {
  std::array<point2, 3> p;
  point2 t;
};
struct triangle_set {
  std::string name;
  std::vector<triangle> items;
};

// `away` from the origin; the third corner beside the line of the others, 2^-bits of their distance away from it.
triangle_set triangles(const std::string& name, double away, int bits) {
  bench::random_numbers r(15);
  triangle_set s{name, {}};
  for (int i = 0; i < count(); ++i) {
    const auto any = [&] { return point2{r.between(-1, 1), r.between(-1, 1)}; };
    const auto moved = [&](const point2& q) { return point2{away + q.x, away + q.y}; };
    const point2 a = any(), b = any();
    point2 c = any();
    if (bits > 0) {
      const double t = r.unit(), h = std::ldexp(r.between(0.5, 1), -bits);
      c = {a.x + t * (b.x - a.x) - h * (b.y - a.y), a.y + t * (b.y - a.y) + h * (b.x - a.x)};
    }
    const double u = r.unit(), v = (1 - u) * r.unit(), w = 1 - u - v;
    s.items.push_back(
        {{moved(a), moved(b), moved(c)}, moved({u * a.x + v * b.x + w * c.x, u * a.y + v * b.y + w * c.y})});
  }
  return s;
}

void corners(const std::vector<triangle_set>& all) {
  bench::study s("area of a triangle", "triangle", bench::error_unit::ulp);
  for (const auto& [name, items] : all) {
    const auto exact = [](const triangle& t, bench::exact_results& out) {
      out.push_back((twice_area(t.p[0], t.p[1], t.p[2]) / real(2)).result());
    };
    const bench::distribution d{name, items.size(), 1, bench::exact_for(items, exact)};
    const auto entry = [&](const char* who, auto area) {
      return bench::for_each_item(who, items, [area](const triangle& t) { return area(t.p[0], t.p[1], t.p[2]); });
    };
    using P = const point2&;
    s.panel(
        d,
        {entry("irg", [](P a, P b, P c) { return irg::signed_triangle_area(a, b, c); }),
         entry("irg: signed_triangle_area_fast", [](P a, P b, P c) { return irg::signed_triangle_area_fast(a, b, c); }),
         entry("determinant in double",
               [](P a, P b, P c) { return (a.x * (b.y - c.y) + b.x * (c.y - a.y) + c.x * (a.y - b.y)) / 2; })},
        bench::text_of_items(items));
  }
}

void barycentric(const std::vector<triangle_set>& all) {
  bench::study s("barycentric coordinates", "point", bench::error_unit::ulp);
  for (const auto& [name, items] : all) {
    const auto exact = [](const triangle& one, bench::exact_results& out) {
      const auto& [p, t] = one;
      const real whole = twice_area(p[0], p[1], p[2]);
      for (std::size_t k = 0; k < 3; ++k)
        out.push_back((twice_area(p[(k + 1) % 3], p[(k + 2) % 3], t) / whole).result());
    };
    const bench::distribution d{name, items.size(), 3, bench::exact_for(items, exact)};
    s.panel(d,
            {bench::for_each_vector<3>("irg", items,
                                       [](const triangle& t) {
                                         const auto w = irg::barycentric(t.p[0], t.p[1], t.p[2], t.t);
                                         return w ? *w : irg::vec<double, 3>{none, none, none};
                                       }),
             bench::for_each_vector<3>(
                 "irg: barycentric_fast", items,
                 [](const triangle& t) { return irg::barycentric_fast(t.p[0], t.p[1], t.p[2], t.t); }),
             bench::for_each_vector<3>("edge functions A*x + B*y + C", items,
                                       [](const triangle& t) {
                                         std::array<double, 3> w{};
                                         for (std::size_t k = 0; k < 3; ++k) {
                                           const point2 &b = t.p[(k + 1) % 3], &c = t.p[(k + 2) % 3];
                                           w[k] = (b.y - c.y) * t.t.x + (c.x - b.x) * t.t.y + (b.x * c.y - b.y * c.x);
                                         }
                                         const double sum = w[0] + w[1] + w[2];
                                         for (double& x : w) x /= sum;
                                         return irg::vec<double, 3>{w[0], w[1], w[2]};
                                       })},
            bench::text_of_items(items));
  }
}

// Sides of needles: two long ones and one of 10^-power of their size, or two that are hardly longer than the third.
void sides() {
  bench::study s("area from sides", "triangle", bench::error_unit::ulp);
  for (const int power : {0, 5, 10}) {
    bench::random_numbers r(16);
    auto& items = bench::keep(std::vector<std::array<double, 3>>());
    for (int i = 0; i < count(); ++i) {
      const double part = std::pow(10.0, -power), a = r.between(1, 2),
                   b = i % 2 == 0 ? a * (1 + part * r.unit() / 2) : r.between(1, 2);
      items.push_back({a, b, i % 2 == 0 ? a * part : (a + b) * (1 - part * r.between(0.1, 0.2))});
    }
    const auto exact = [](const std::array<double, 3>& side, bench::exact_results& out) {
      const real x = side[0], y = side[1], z = side[2];
      out.push_back((sqrt((x + y + z) * (x + y - z) * (x - y + z) * (y - x + z)) / real(4)).result());
    };
    const bench::distribution d{power == 0 ? "any triangle" : "needles of 10^-" + std::to_string(power), items.size(),
                                1, bench::exact_for(items, exact)};
    s.panel(d,
            {bench::for_each_item(
                 "irg", items,
                 [](const auto& t) { return irg::triangle_area_from_sides(t[0], t[1], t[2]).value_or(none); }),
             bench::for_each_item("textbook (Heron)", items,
                                  [](const auto& t) {
                                    return irg::textbook::triangle_area_from_sides(t[0], t[1], t[2]).value_or(none);
                                  })},
            bench::text_of_items(items));
  }
}

}  // namespace

int main(int argc, char** argv) {
  polygons();
  const auto& all =
      bench::keep(std::vector<triangle_set>{triangles("any triangle", 0, 0), triangles("10^6 away", 1e6, 0),
                                            triangles("2^-20 wide", 0, 20), triangles("2^-45 wide", 0, 45)});
  corners(all);
  sides();
  barycentric(all);
  return bench::run_benchmarks(argc, argv);
}

#else
#include <cstdio>
int main() { std::puts("accuracy_area: skipped, MPFR was not found"); }
#endif
