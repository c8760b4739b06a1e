// SPDX-License-Identifier: MIT
// Polygons: area, point in polygon, hull and triangles, run time against error. CGAL beside, where it
// is installed.
#include <array>
#include <cmath>
#include <cstdio>
#include <functional>
#include <string>
#include <vector>

#ifdef IRG_HAVE_CGAL
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_2_algorithms.h>
#include <CGAL/convex_hull_2.h>
#endif

#include <irg/geometry/textbook/polygon.hpp>
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
  std::function<bench::errors()> judge{};
  std::string note{};
};

void contest(const std::string& kernel, const std::string& test_case, const std::vector<candidate>& list,
             std::size_t items, const std::string& item, const std::string& unit = {}) {
  for (const candidate& one : list) {
    bench::contender who{one.name, [run = one.run] { sink = run(); }, one.judge, one.note};
    bench::enter({kernel, test_case, item, static_cast<std::int64_t>(items), unit}, std::move(who));
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

#ifdef IRG_HAVE_CGAL
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
    auto& rings = bench::keep(std::vector<ring>());
    for (int i = 0; i < (bench::smoke() ? 3 : 200); ++i) rings.push_back(jagged(random, 64, offset));
    const auto add = [&rings](const std::string& name, const auto& area) {
      const auto judge = [&rings, area] {
        bench::errors e{0};
        for (const ring& r : rings) {
          const double exact = irg::polygon_area_exact(r), got = area(r);
          const double ulp = std::nextafter(std::fabs(exact), 1e300) - std::fabs(exact);
          e.max = std::max(e.max, std::fabs(got - exact) / ulp);
        }
        return e;
      };
      const auto run = [&rings, area] {
        double sum = 0;
        for (const ring& r : rings) sum += area(r);
        return sum;
      };
      return candidate{name, run, judge};
    };
    std::vector<candidate> list;
    list.push_back(add("irg", [](const ring& r) { return irg::polygon_area(r); }));
    list.push_back(add("irg:fast", [](const ring& r) { return irg::polygon_area_fast(r); }));
    list.push_back(add("irg:exact", [](const ring& r) { return irg::polygon_area_exact(r); }));
    list.push_back(add("irg:textbook", [](const ring& r) { return irg::textbook::polygon_area(r); }));
#ifdef IRG_HAVE_CGAL
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
    contest("polygon_area", name, list, rings.size() * 64, "vertex", "ulp");
  }
}

// Random points, and points that lie on edges exactly (coordinates are multiples of 2^-40, and middles of edges).
void locations() {
  test::random random(2);
  ring& r = bench::keep(jagged(random, 64, 0));
  for (P& p : r) p = {std::floor(p.x * 0x1p30) * 0x1p-30, std::floor(p.y * 0x1p30) * 0x1p-30};
  const auto add = [](const std::string& name, const ring& points, const auto& locate, bool on_edges = false) {
    candidate c{name, [&points, locate] {
                  double sum = 0;
                  for (const P& p : points) sum += static_cast<double>(locate(p));
                  return sum;
                }};
    if (on_edges)
      c.judge = [&points, locate] {
        bench::errors e;
        e.wrong = 0;
        for (const P& p : points) e.wrong += locate(p) != 0;
        return e;
      };
    return c;
  };
  for (const bool on_edges : {false, true}) {
    ring& points = bench::keep(ring());
    for (int i = 0; i < (bench::smoke() ? 10 : 2000); ++i) {
      const auto k = static_cast<std::size_t>(random.integer(0, 63));
      const P &a = r[k], &b = r[(k + 1) % r.size()];
      const double x = random.unit() * 4 - 2;
      points.push_back(on_edges ? P{(a.x + b.x) / 2, (a.y + b.y) / 2} : P{x, random.unit() * 4 - 2});
    }
    std::vector<candidate> list;
    list.push_back(
        add("irg", points, [&r](const P& p) { return static_cast<int>(irg::point_in_polygon(r, p)); }, on_edges));
#ifdef IRG_HAVE_CGAL
    const auto on_side = [cgal = cgal_points(r)](const P& p) {
      return static_cast<int>(CGAL::bounded_side_2(cgal.begin(), cgal.end(), kernel::Point_2(p.x, p.y), kernel()));
    };
    list.push_back(add("CGAL", points, on_side, on_edges));
#endif
    contest("point_in_polygon", on_edges ? "64 edges on them" : "64 edges random", list, points.size(), "point");
  }
  ring &circle = bench::keep(ring()), &points = bench::keep(ring());
  for (int i = 0; i < 1000; ++i)
    circle.push_back({std::cos(i * 0.006283185307179586), std::sin(i * 0.006283185307179586)});
  for (int i = 0; i < (bench::smoke() ? 10 : 2000); ++i) {
    const double x = random.unit() * 2 - 1;
    points.push_back({x, random.unit() * 2 - 1});
  }
  const auto number = [](irg::location l) { return static_cast<int>(l); };
  contest(
      "point_in_convex", "1000 edges",
      {add("irg", points, [=, &circle](const P& p) { return number(irg::point_in_convex_polygon(circle, p)); }),
       add("irg:by_edges", points,
           [=, &circle](const P& p) { return number(irg::detail::locate_by_edges(circle, p)); }),
       add("irg:any_polygon", points, [=, &circle](const P& p) { return number(irg::point_in_polygon(circle, p)); })},
      points.size(), "point");
}

void hulls() {
  test::random random(3);
  ring& points = bench::keep(ring());
  for (int i = 0; i < (bench::smoke() ? 100 : 100'000); ++i) {
    const double x = random.unit();
    points.push_back({x, random.unit()});
  }
  auto& hull = bench::keep(std::vector<std::uint32_t>(points.size()));
  std::vector<candidate> list;
  list.push_back({"irg", [&points, &hull] {
                    return static_cast<double>(irg::convex_hull(points, std::span<std::uint32_t>(hull)));
                  }});
#ifdef IRG_HAVE_CGAL
  list.push_back({"CGAL", [cgal = cgal_points(points)] {
                    std::vector<kernel::Point_2> out;
                    CGAL::convex_hull_2(cgal.begin(), cgal.end(), std::back_inserter(out));
                    return static_cast<double>(out.size());
                  }});
#endif
  contest("convex_hull", "uniform in a square", list, points.size(), "point");
}

void triangles() {
  test::random random(4);
  for (const int n : {10, 100, 10'000, 100'000}) {
    if (bench::smoke() && n > 100) break;
    const ring& r = bench::keep(jagged(random, n, 0));
    std::vector<candidate> list;
    list.push_back(
        {"irg:monotone", [&r] { return static_cast<double>(irg::triangulate_monotone(r).triangles.size()); }});
    if (n < 100'000) {
      list.push_back(
          {"irg:ear_clipping", [&r] { return static_cast<double>(irg::triangulate_ear_clipping(r).size()); }});
    }
    contest("triangulate", "jagged " + std::to_string(n), list, static_cast<std::size_t>(n), "vertex");
  }
}

}  // namespace

int main(int argc, char** argv) {
  areas();
  locations();
  hulls();
  triangles();
  return bench::run_benchmarks(argc, argv);
}
