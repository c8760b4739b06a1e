// SPDX-License-Identifier: MIT
// Where lines meet lines, planes and triangles, points of a triangle nearest to others, and centres of polygons: run
// time against error. From any input to nearly parallel lines, needles and what lies far from the origin.
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

#include <irg/geometry/closest_point.hpp>
#include <irg/geometry/intersect_lines.hpp>
#include <irg/geometry/intersect_plane_line.hpp>
#include <irg/geometry/intersect_segments.hpp>
#include <irg/geometry/polygon_centroid.hpp>
#include <irg/geometry/ray.hpp>
#include <irg/math/vec.hpp>
#include <irg/spatial/cross_triangle.hpp>

#include "accuracy/vector_sets.hpp"

#ifdef BENCH_HAS_MPFR

namespace {

using bench::real;
using point2 = irg::point<double, 2>;
using point3 = irg::point<double, 3>;
using vec2 = irg::vec<double, 2>;
using vec3 = irg::vec<double, 3>;
using real3 = std::array<real, 3>;
constexpr double none = std::numeric_limits<double>::quiet_NaN();
std::size_t count() { return bench::smoke() ? 16 : 1024; }

real3 difference(const point3& p, const point3& q) { return {real(p.x) - q.x, real(p.y) - q.y, real(p.z) - q.z}; }
real3 crossed(const real3& a, const real3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
real dotted(const real3& a, const real3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

point3 any_point(bench::random_numbers& r, double away) {
  const double x = r.between(-1, 1), y = r.between(-1, 1), z = r.between(-1, 1);
  return {away + x, away + y, away + z};
}

// ---- two lines of the plane

using lines = std::array<point2, 4>;

// Segments that cross, `away` from the origin; the second turned against the first by 2^-bits or so.
std::vector<lines> crossing_lines(double away, int bits) {
  bench::random_numbers r(31);
  std::vector<lines> all;
  while (all.size() < count()) {
    const double x = r.between(-1, 1), y = r.between(-1, 1), angle = r.between(0, 6), u = std::cos(angle),
                 v = std::sin(angle), turn = bits == 0 ? r.between(0.2, 3) : std::ldexp(r.between(0.5, 1), -bits);
    const double p = u - turn * v, q = v + turn * u, low = r.between(0.1, 1), high = r.between(0.1, 1);
    all.push_back({point2{away + x - low * u, away + y - low * v}, point2{away + x + high * u, away + y + high * v},
                   point2{away + x - high * p, away + y - high * q}, point2{away + x + low * p, away + y + low * q}});
  }
  return all;
}

void two_lines() {
  bench::study s("crossing of two lines", "pair of lines", bench::error_unit::ulp);
  const auto exact = [](const lines& l, bench::exact_results& out) {
    const auto& [a, b, c, d] = l;
    const real ux = real(b.x) - a.x, uy = real(b.y) - a.y, vx = real(d.x) - c.x, vy = real(d.y) - c.y;
    const real t = ((real(c.x) - a.x) * vy - (real(c.y) - a.y) * vx) / (ux * vy - uy * vx);
    out.push_back((real(a.x) + t * ux).result());
    out.push_back((real(a.y) + t * uy).result());
  };
  const auto of_panel = [&](const std::string& name, double away, int bits) {
    const auto& items = bench::keep(crossing_lines(away, bits));
    const bench::distribution d{name, items.size(), 2, bench::exact_for(items, exact)};
    s.panel(d,
            {bench::for_each_vector<2>("irg", items,
                                       [](const lines& l) { return irg::intersect_lines(l[0], l[1], l[2], l[3]).at; }),
             bench::for_each_vector<2>("irg: intersect_segments", items,
                                       [](const lines& l) {
                                         const auto m = irg::intersect_segments(l[0], l[1], l[2], l[3]);
                                         const bool is_point = m.relation == irg::segment_relation::point;
                                         return is_point ? m.first : point2{none, none};
                                       }),
             bench::for_each_vector<2>("determinants in double", items,
                                       [](const lines& l) {
                                         const vec2 u = l[1] - l[0], v = l[3] - l[2], w = l[2] - l[0];
                                         const double t = (w.x * v.y - w.y * v.x) / (u.x * v.y - u.y * v.x);
                                         return point2{l[0].x + t * u.x, l[0].y + t * u.y};
                                       }),
             bench::for_each_vector<2>("homogeneous in double", items,
                                       [](const lines& l) {
                                         const auto through = [](const point2& p, const point2& q) {
                                           return vec3{p.y - q.y, q.x - p.x, p.x * q.y - p.y * q.x};
                                         };
                                         const vec3 m = irg::cross_fast(through(l[0], l[1]), through(l[2], l[3]));
                                         return point2{m.x / m.z, m.y / m.z};
                                       })},
            bench::text_of_items(items));
  };
  of_panel("any lines", 0, 0);
  of_panel("10^6 away", 1e6, 0);
  of_panel("2^-20 apart in direction", 0, 20);
  of_panel("2^-40 apart in direction", 0, 40);
}

// ---- a line and a plane through three points

using plane_and_line = std::array<point3, 5>;

// The line runs from one side of the plane's triangle to the other, at an angle of 2^-bits or so.
std::vector<plane_and_line> planes_and_lines(double away, int bits) {
  bench::random_numbers r(32);
  std::vector<plane_and_line> all;
  for (std::size_t i = 0; i < count(); ++i) {
    const point3 a = any_point(r, away), b = any_point(r, away), c = any_point(r, away);
    const vec3 u = b - a, v = c - a, n = irg::cross(u, v);
    const double x = r.between(0.1, 0.4), y = r.between(0.1, 0.4), up = std::ldexp(r.between(0.5, 1), -bits);
    const point3 middle = a + u * x + v * y;
    all.push_back({a, b, c, middle - u * 0.1 - n * up, middle + v * 0.1 + n * up * r.between(0.5, 1)});
  }
  return all;
}

void plane_and_lines() {
  bench::study s("crossing of a plane and a line", "plane and line", bench::error_unit::ulp);
  const auto exact = [](const plane_and_line& i, bench::exact_results& out) {
    const real3 n = crossed(difference(i[1], i[0]), difference(i[2], i[0])), u = difference(i[4], i[3]);
    const real t = dotted(n, difference(i[0], i[3])) / dotted(n, u);
    for (std::size_t k = 0; k < 3; ++k) out.push_back((real(i[3][static_cast<int>(k)]) + t * u[k]).result());
  };
  const auto of_panel = [&](const std::string& name, double away, int bits) {
    const auto& items = bench::keep(planes_and_lines(away, bits));
    const bench::distribution d{name, items.size(), 3, bench::exact_for(items, exact)};
    s.panel(d,
            {bench::for_each_vector<3>(
                 "irg", items,
                 [](const plane_and_line& i) { return irg::intersect_plane_line(i[0], i[1], i[2], i[3], i[4]).at; }),
             bench::for_each_vector<3>("normal and quotient in double", items,
                                       [](const plane_and_line& i) {
                                         const vec3 n = irg::cross_fast(i[1] - i[0], i[2] - i[0]), u = i[4] - i[3];
                                         return i[3] + u * (irg::dot_fast(n, i[0] - i[3]) / irg::dot_fast(n, u));
                                       })},
            bench::text_of_items(items));
  };
  of_panel("any", 0, 0);
  of_panel("10^6 away", 1e6, 0);
  of_panel("2^-20 from parallel", 0, 20);
  of_panel("2^-40 from parallel", 0, 40);
}

// ---- a ray and a triangle: its parameter

// Moller and Trumbore 1997.
double time_by_moller_trumbore(const plane_and_line& i) {
  const vec3 u = i[1] - i[0], v = i[2] - i[0], d = i[4] - i[3], h = i[3] - i[0], p = irg::cross_fast(d, v);
  return irg::dot_fast(v, irg::cross_fast(h, u)) / irg::dot_fast(u, p);
}

void rays() {
  bench::study s("time of a ray at a triangle", "ray and triangle", bench::error_unit::relative_u);
  const auto exact = [](const plane_and_line& i, bench::exact_results& out) {
    const vec3 direction = i[4] - i[3];  // as rounded: what both get
    const real3 n = crossed(difference(i[1], i[0]), difference(i[2], i[0]));
    const real3 u{real(direction.x), real(direction.y), real(direction.z)};
    out.push_back((dotted(n, difference(i[0], i[3])) / dotted(n, u)).result());
  };
  const auto of_panel = [&](const std::string& name, double away, int bits) {
    const auto& items = bench::keep(planes_and_lines(away, bits));
    const bench::distribution d{name, items.size(), 1, bench::exact_for(items, exact)};
    s.panel(d,
            {bench::for_each_item("irg", items,
                                  [](const plane_and_line& i) {
                                    const auto m =
                                        irg::intersect_triangle(irg::ray_between(i[3], i[4]), i[0], i[1], i[2]);
                                    return m ? m->t : none;
                                  }),
             bench::for_each_item("Moller and Trumbore", items, time_by_moller_trumbore)},
            bench::text_of_items(items));
  };
  of_panel("any", 0, 0);
  of_panel("10^6 away", 1e6, 0);
  of_panel("grazing at 2^-12", 0, 12);
  of_panel("grazing at 2^-30", 0, 30);
}

// ---- the point of a triangle that is nearest to another

using triangle_and_point = std::array<point3, 4>;

// The foot of the point is within the triangle, whose height is 2^-bits of its side or so.
std::vector<triangle_and_point> triangles_and_points(double away, int bits) {
  bench::random_numbers r(33);
  std::vector<triangle_and_point> all;
  for (std::size_t i = 0; i < count(); ++i) {
    const point3 a = any_point(r, away), b = any_point(r, away), any = any_point(r, away);
    const double x = r.between(0.1, 0.4), y = r.between(0.1, 0.4), wide = std::ldexp(1.0, -bits);
    const vec3 u = b - a, v = u * r.between(0.2, 0.8) * (1 - wide) + (any - a) * wide, n = irg::cross(u, v);
    all.push_back({a, b, a + v, a + u * x + v * y + n * (r.between(0.5, 1) / wide)});
  }
  return all;
}

// The foot in the plane, for points above the triangle; Ericson 2004, 5.1.5, in double.
point3 nearest_by_ericson(const triangle_and_point& i) {
  const vec3 ab = i[1] - i[0], ac = i[2] - i[0], ap = i[3] - i[0], bp = i[3] - i[1], cp = i[3] - i[2];
  const double d1 = irg::dot_fast(ab, ap), d2 = irg::dot_fast(ac, ap), d3 = irg::dot_fast(ab, bp);
  const double d4 = irg::dot_fast(ac, bp), d5 = irg::dot_fast(ab, cp), d6 = irg::dot_fast(ac, cp);
  const double va = d3 * d6 - d5 * d4, vb = d5 * d2 - d1 * d6, vc = d1 * d4 - d3 * d2, all = 1 / (va + vb + vc);
  return i[0] + ab * (vb * all) + ac * (vc * all);
}

void nearest_points() {
  bench::study s("nearest point of a triangle", "point and triangle", bench::error_unit::relative_u);
  const auto exact = [](const triangle_and_point& i, bench::exact_results& out) {
    const real3 n = crossed(difference(i[1], i[0]), difference(i[2], i[0]));
    const real t = dotted(n, difference(i[0], i[3])) / dotted(n, n);
    for (std::size_t k = 0; k < 3; ++k) out.push_back((real(i[3][static_cast<int>(k)]) + t * n[k]).result());
  };
  const auto of_panel = [&](const std::string& name, double away, int bits) {
    const auto& items = bench::keep(triangles_and_points(away, bits));
    const bench::distribution d{name, items.size(), 3, bench::exact_for(items, exact)};
    s.panel(d,
            {bench::for_each_vector<3>("irg", items,
                                       [](const triangle_and_point& i) {
                                         const auto nearest = irg::closest_point_on_triangle(i[0], i[1], i[2], i[3]);
                                         return nearest ? nearest->at : point3{none, none, none};
                                       }),
             bench::for_each_vector<3>("Ericson's weights in double", items, nearest_by_ericson)},
            bench::text_of_items(items));
  };
  of_panel("any triangle", 0, 0);
  of_panel("10^6 away", 1e6, 0);
  of_panel("2^-12 wide", 0, 12);
  of_panel("2^-24 wide", 0, 24);
}

// ---- the centre of gravity of a polygon

using ring = std::array<point2, 16>;

void centroids() {
  bench::study s("centroid of a polygon", "polygon of 16 corners", bench::error_unit::ulp);
  const auto exact = [](const ring& p, bench::exact_results& out) {
    real x, y, area;
    for (std::size_t i = 0; i < p.size(); ++i) {
      const point2 &a = p[i], &b = p[(i + 1) % p.size()];
      const real part = real(a.x) * b.y - real(b.x) * a.y;
      x = x + (real(a.x) + b.x) * part, y = y + (real(a.y) + b.y) * part, area = area + real(3) * part;
    }
    out.push_back((x / area).result());
    out.push_back((y / area).result());
  };
  const auto of_panel = [&](const std::string& name, double away) {
    bench::random_numbers r(34);
    auto& items = bench::keep(std::vector<ring>(count()));
    for (ring& p : items)
      for (std::size_t i = 0; i < p.size(); ++i) {
        const double t = 0.39269908169872414 * static_cast<double>(i), radius = 1 + r.unit();
        p[i] = {away + 0.5 + radius * std::cos(t), away + 0.5 + radius * std::sin(t)};
      }
    const bench::distribution d{name, items.size(), 2, bench::exact_for(items, exact)};
    s.panel(d,
            {bench::for_each_vector<2>("irg", items, [](const ring& p) { return *irg::polygon_centroid(p); }),
             bench::for_each_vector<2>("irg: polygon_centroid_fast", items,
                                       [](const ring& p) { return *irg::polygon_centroid_fast(p); }),
             bench::for_each_vector<2>("moments about the origin in double", items,
                                       [](const ring& p) {
                                         double x = 0, y = 0, area = 0;
                                         for (std::size_t i = 0; i < p.size(); ++i) {
                                           const point2 &a = p[i], &b = p[(i + 1) % p.size()];
                                           const double part = a.x * b.y - b.x * a.y;
                                           x += (a.x + b.x) * part, y += (a.y + b.y) * part, area += part;
                                         }
                                         return point2{x / (3 * area), y / (3 * area)};
                                       })},
            bench::text_of_items(items));
  };
  of_panel("about the origin", 0);
  for (const int power : {3, 6, 9}) of_panel("10^" + std::to_string(power) + " away", std::pow(10.0, power));
}

}  // namespace

int main(int argc, char** argv) {
  two_lines();
  plane_and_lines();
  rays();
  nearest_points();
  centroids();
  return bench::run_benchmarks(argc, argv);
}

#else
#include <cstdio>
int main() { std::puts("accuracy_meetings: skipped, MPFR was not found"); }
#endif
