// SPDX-License-Identifier: MIT
// Polygons: area, point in polygon, hull and triangles, run time against error. CGAL beside, where it
// is installed.
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <string>
#include <vector>

#if __has_include(<CGAL/Exact_predicates_inexact_constructions_kernel.h>)
#define HAVE_CGAL 1
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_2_algorithms.h>
#include <CGAL/convex_hull_2.h>
#endif

#include <irg/geometry/convex_hull.hpp>
#include <irg/geometry/point_in_convex_polygon.hpp>
#include <irg/geometry/point_in_polygon.hpp>
#include <irg/geometry/polygon_area.hpp>
#include <irg/geometry/triangulate_ear_clipping.hpp>
#include <irg/geometry/triangulate_monotone.hpp>
#include <irg/math/vec.hpp>

#include "support/measure.hpp"
#include "../tests/support/random.hpp"

namespace {

using P = irg::point<double, 2>;
using ring = std::vector<P>;

volatile double sink;

struct candidate {
  std::string name;
  std::function<double()> run;  // something that depends on all results
  std::string max_error{}, wrong{}, same_work = "yes", note{};
};

void contest(const std::string& kernel, const std::string& test_case, std::vector<candidate> list, std::int64_t items,
             const std::string& item, const std::string& unit = {}) {
  std::vector<bench::contender> contenders;
  for (const candidate& c : list) contenders.push_back({c.name, [&c] { sink = c.run(); }});
  bench::race(contenders, 15, 2e-3);
  for (std::size_t i = 0; i < list.size(); ++i) {
    const double ns = contenders[i].median() * 1e9 / static_cast<double>(items);
    std::printf("%-18s %-22s %-22s %10.2f ns  max error %-10s wrong %s\n", kernel.c_str(), test_case.c_str(),
                list[i].name.c_str(), ns, list[i].max_error.c_str(), list[i].wrong.c_str());
    bench::report({kernel, test_case, list[i].name, list[i].same_work, ns, items, item, "", list[i].max_error, "",
                   list[i].max_error.empty() ? "" : unit, list[i].wrong, list[i].note});
  }
}

ring jagged(test::random& random, int n, double offset) {
  ring r;
  for (int i = 0; i < n; ++i) {
    const double t = 6.283185307179586 * i / n, radius = 1 + random.unit();
    r.push_back({offset + radius * std::cos(t), offset + radius * std::sin(t)});
  }
  return r;
}

#ifdef HAVE_CGAL
using kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
std::vector<kernel::Point_2> cgal_points(const ring& r) {
  std::vector<kernel::Point_2> out;
  for (const P& p : r) out.emplace_back(p.x, p.y);
  return out;
}
#endif

void areas() {
  test::random random(1);
  for (const double offset : {0.0, 1e4, 1e8, 1e12, 1e15}) {
    std::vector<ring> rings;
    for (int i = 0; i < (bench::smoke() ? 3 : 200); ++i) rings.push_back(jagged(random, 64, offset));
    const auto add = [&](const std::string& name, const auto& area) {
      double worst = 0;
      for (const ring& r : rings) {
        const double exact = irg::polygon_area_exact(r), got = area(r);
        const double ulp = std::nextafter(std::fabs(exact), 1e300) - std::fabs(exact);
        worst = std::max(worst, std::fabs(got - exact) / ulp);
      }
      return candidate{name,
                       [&rings, area] {
                         double sum = 0;
                         for (const ring& r : rings) sum += area(r);
                         return sum;
                       },
                       bench::number(worst)};
    };
    std::vector<candidate> list;
    list.push_back(add("irg", [](const ring& r) { return irg::polygon_area(r); }));
    list.push_back(add("irg:fast", [](const ring& r) { return irg::polygon_area_fast(r); }));
    list.push_back(add("irg:exact", [](const ring& r) { return irg::polygon_area_exact(r); }));
    list.push_back(add("irg:textbook", [](const ring& r) { return irg::polygon_area_textbook(r); }));
#ifdef HAVE_CGAL
    list.push_back(add("CGAL", [](const ring& r) {
      double area = 0;
      const auto points = cgal_points(r);
      CGAL::area_2(points.begin(), points.end(), area, kernel());
      return area;
    }));
    list.back().note = "with the copy into its points";
#endif
    char name[32];
    std::snprintf(name, sizeof name, "offset %.0e", offset);
    contest("polygon_area", name, list, static_cast<std::int64_t>(rings.size()) * 64, "vertex", "ulp");
  }
}

// Random points, and points that lie on edges exactly (coordinates are multiples of 2^-40, and middles of edges).
void locations() {
  test::random random(2);
  ring r = jagged(random, 64, 0);
  for (P& p : r) p = {std::floor(p.x * 0x1p30) * 0x1p-30, std::floor(p.y * 0x1p30) * 0x1p-30};
  for (const bool on_edges : {false, true}) {
    ring points;
    for (int i = 0; i < (bench::smoke() ? 10 : 2000); ++i) {
      const auto k = static_cast<std::size_t>(random.integer(0, 63));
      const P &a = r[k], &b = r[(k + 1) % r.size()];
      const double x = random.unit() * 4 - 2;
      points.push_back(on_edges ? P{(a.x + b.x) / 2, (a.y + b.y) / 2} : P{x, random.unit() * 4 - 2});
    }
    const auto add = [&](const std::string& name, const auto& locate) {
      long wrong = 0;
      for (const P& p : points)
        if (on_edges) wrong += locate(p) != 0;
      return candidate{name,
                       [&points, locate] {
                         double sum = 0;
                         for (const P& p : points) sum += locate(p);
                         return sum;
                       },
                       "", on_edges ? std::to_string(wrong) : ""};
    };
    std::vector<candidate> list;
    list.push_back(add("irg", [&](const P& p) { return static_cast<int>(irg::point_in_polygon(r, p)); }));
#ifdef HAVE_CGAL
    const auto cgal = cgal_points(r);
    list.push_back(add("CGAL", [&](const P& p) {
      return static_cast<int>(CGAL::bounded_side_2(cgal.begin(), cgal.end(), kernel::Point_2(p.x, p.y), kernel()));
    }));
#endif
    contest("point_in_polygon", on_edges ? "64 edges, on them" : "64 edges, random", list,
            static_cast<std::int64_t>(points.size()), "point");
  }
  ring circle;
  for (int i = 0; i < 1000; ++i)
    circle.push_back({std::cos(i * 0.006283185307179586), std::sin(i * 0.006283185307179586)});
  ring points;
  for (int i = 0; i < (bench::smoke() ? 10 : 2000); ++i) {
    const double x = random.unit() * 2 - 1;
    points.push_back({x, random.unit() * 2 - 1});
  }
  const auto add = [&](const std::string& name, const auto& locate) {
    return candidate{name, [&points, locate] {
                       double sum = 0;
                       for (const P& p : points) sum += static_cast<int>(locate(p));
                       return sum;
                     }};
  };
  contest("point_in_convex", "1000 edges",
          {add("irg", [&](const P& p) { return irg::point_in_convex_polygon_log(circle, p); }),
           add("irg:by_edges", [&](const P& p) { return irg::point_in_convex_polygon(circle, p); }),
           add("irg:any_polygon", [&](const P& p) { return irg::point_in_polygon(circle, p); })},
          static_cast<std::int64_t>(points.size()), "point");
}

void hulls() {
  test::random random(3);
  ring points;
  for (int i = 0; i < (bench::smoke() ? 100 : 100'000); ++i) {
    const double x = random.unit();
    points.push_back({x, random.unit()});
  }
  std::vector<std::uint32_t> hull(points.size());
  std::vector<candidate> list;
  list.push_back(
      {"irg", [&] { return static_cast<double>(irg::convex_hull(points, std::span<std::uint32_t>(hull))); }});
#ifdef HAVE_CGAL
  const auto cgal = cgal_points(points);
  list.push_back({"CGAL", [&] {
                    std::vector<kernel::Point_2> out;
                    CGAL::convex_hull_2(cgal.begin(), cgal.end(), std::back_inserter(out));
                    return static_cast<double>(out.size());
                  }});
#endif
  contest("convex_hull", "uniform in a square", list, static_cast<std::int64_t>(points.size()), "point");
}

void triangles() {
  test::random random(4);
  for (const int n : {10, 100, 10'000, 100'000}) {
    if (bench::smoke() && n > 100) break;
    const ring r = jagged(random, n, 0);
    std::vector<candidate> list;
    list.push_back(
        {"irg:monotone", [&] { return static_cast<double>(irg::triangulate_monotone(r).triangles.size()); }});
    if (n < 100'000) {
      list.push_back(
          {"irg:ear_clipping", [&] { return static_cast<double>(irg::triangulate_ear_clipping(r).size()); }});
    }
    contest("triangulate", "jagged " + std::to_string(n), list, n, "vertex");
  }
}

}  // namespace

int main() {
  bench::stay_on_this_processor();
  areas();
  locations();
  hulls();
  triangles();
}
