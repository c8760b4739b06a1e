// SPDX-License-Identifier: MIT
// Where a ray crosses a triangle: run time against error of t, for rays at any angle, grazing, from far away, and close to
// a side, where a formula that rounds may miss what is hit.
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include <irg/spatial/cross_triangle.hpp>

#include "accuracy/vector_sets.hpp"

#ifdef IRG_HAVE_CGAL
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/intersections.h>
#endif

#ifdef BENCH_HAS_MPFR

namespace {

using bench::real;
using point3 = irg::point<double, 3>;
using vec3 = irg::vec<double, 3>;
struct item {
  point3 origin;
  vec3 direction;
  point3 a, b, c;
};
struct set {
  std::string name;
  std::vector<item> items;
};
constexpr double none = std::numeric_limits<double>::quiet_NaN();

using triple = std::array<real, 3>;
triple difference(const point3& a, const point3& b) {
  return {real(a.x) - real(b.x), real(a.y) - real(b.y), real(a.z) - real(b.z)};
}
triple cross(const triple& a, const triple& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
real dot(const triple& a, const triple& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

// Whether the ray meets the triangle's inside, and where; sides are told by the signs of volumes.
std::optional<real> true_time(const item& i) {
  const triple d{real(i.direction.x), real(i.direction.y), real(i.direction.z)};
  const triple a = difference(i.a, i.origin), b = difference(i.b, i.origin), c = difference(i.c, i.origin);
  const real ab = dot(d, cross(a, b)), bc = dot(d, cross(b, c)), ca = dot(d, cross(c, a)), zero(0);
  const bool left = zero < ab && zero < bc && zero < ca, right = ab < zero && bc < zero && ca < zero;
  if (!left && !right) return std::nullopt;
  const triple n = cross(difference(i.b, i.a), difference(i.c, i.a));
  return dot(n, a) / dot(n, d);
}

// Towards the inside of a triangle of size 1, `share` of the way from a side to its middle.
item make_item(bench::random_numbers& r, double away, double grazing, double share) {
  const auto any = [&] { return vec3{r.between(-1, 1), r.between(-1, 1), r.between(-1, 1)}; };
  for (;;) {
    const vec3 u = any(), v = any(), n = irg::cross(u, v);
    const point3 a{r.between(-1, 1), r.between(-1, 1), r.between(-1, 1)};
    const double along = r.between(0.2, 0.8), inside = share * 0.3;
    const point3 aim = a + u * (along * (1 - inside)) + v * inside;
    const vec3 from = (u * r.between(-1, 1) + v * r.between(-1, 1) + n * grazing) * away;
    const item made{aim + from, from * -r.between(0.5, 2), a, a + u, a + v};
    const auto t = true_time(made);
    if (t && real(0) < *t) return made;
  }
}

std::vector<set> make_sets() {
  struct kind {
    const char* name;
    double away, grazing, share;
  };
  std::vector<set> all;
  for (const kind& k : {kind{"any ray", 3, 1, 1},
                        {"10^6 away", 1e6, 1, 1},
                        {"grazing to 10^-4", 3, 1e-4, 1},
                        {"grazing to 10^-8", 3, 1e-8, 1},
                        {"10^-15 from a side", 3, 1, 1e-15}}) {
    bench::random_numbers r(37);
    set s{k.name, {}};
    for (int i = 0; i < (bench::smoke() ? 16 : 1024); ++i) s.items.push_back(make_item(r, k.away, k.grazing, k.share));
    all.push_back(s);
  }
  return all;
}

double by_irg(const item& i) {
  const auto x = irg::cross_triangle(irg::ray<double, 3>{i.origin, i.direction}, i.a, i.b, i.c);
  return x ? x->t : none;
}

double by_moeller_trumbore(const item& i) {
  const auto product = [](const vec3& p, const vec3& q) {
    return vec3{p.y * q.z - p.z * q.y, p.z * q.x - p.x * q.z, p.x * q.y - p.y * q.x};
  };
  const auto along = [](const vec3& p, const vec3& q) { return p.x * q.x + p.y * q.y + p.z * q.z; };
  const vec3 u = i.b - i.a, v = i.c - i.a, p = product(i.direction, v);
  const double whole = along(u, p);
  if (whole == 0) return none;
  const vec3 from = i.origin - i.a, q = product(from, u);
  const double weight_b = along(from, p) / whole, weight_c = along(i.direction, q) / whole;
  if (weight_b < 0 || weight_c < 0 || weight_b + weight_c > 1) return none;
  return along(v, q) / whole;
}

#ifdef IRG_HAVE_CGAL
double by_cgal(const item& i) {
  using kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  const auto of = [](const point3& p) { return kernel::Point_3(p.x, p.y, p.z); };
  const kernel::Vector_3 d(i.direction.x, i.direction.y, i.direction.z);
  const auto met = CGAL::intersection(kernel::Ray_3(of(i.origin), d), kernel::Triangle_3(of(i.a), of(i.b), of(i.c)));
  if (!met) return none;
  const auto* p = boost::get<kernel::Point_3>(&*met);
  return p == nullptr ? none : ((*p - of(i.origin)) * d) / (d * d);
}
#endif

}  // namespace

int main(int argc, char** argv) {
  const bench::study s("ray and triangle", "ray", bench::error_unit::ulp);
  for (const auto& one : bench::keep(make_sets())) {
    const auto& items = one.items;
    const auto exact = [](const item& i, bench::exact_results& out) { out.push_back(true_time(i)->result()); };
    const bench::distribution d{one.name, items.size(), 1, bench::exact_for(items, exact)};
    std::vector<bench::implementation> who{
        bench::for_each_item("irg", items, by_irg),
        bench::for_each_item("Moeller-Trumbore in double", items, by_moeller_trumbore)};
#ifdef IRG_HAVE_CGAL
    who.push_back(bench::for_each_item("CGAL intersection", items, by_cgal));
#endif
    s.panel(d, who, bench::text_of_items(items));
  }
  return bench::run_benchmarks(argc, argv);
}

#else
#include <cstdio>
int main() { std::puts("accuracy_trace: skipped, MPFR was not found"); }
#endif
