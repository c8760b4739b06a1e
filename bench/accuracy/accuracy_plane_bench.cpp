// SPDX-License-Identifier: MIT
// Planes through three points and of polygons, far from the origin, slender and not quite flat: run time against error
// of the unit normal.
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include <irg/geometry/textbook/planes.hpp>
#include <irg/geometry/plane.hpp>
#include <irg/geometry/plane_through_points.hpp>
#include <irg/math/length.hpp>

#include "accuracy/matrix_peers.hpp"
#include "accuracy/vector_sets.hpp"

#ifdef IRG_HAVE_CGAL
#include <CGAL/Simple_cartesian.h>
#endif

#ifdef BENCH_HAS_MPFR

namespace {

using bench::real;
using point3 = irg::point<double, 3>;
using vec3 = irg::vec<double, 3>;
template <std::size_t N>
using corners = std::array<point3, N>;
template <std::size_t N>
struct set {
  std::string name;
  std::vector<corners<N>> polygons;
};

// Corners of a polygon of size 1 on a sloping plane, `away` from the origin and `width` wide; off the plane by up to
// `bump`. The first three corners have an edge between them that is `first` wide.
template <std::size_t N>
corners<N> polygon(bench::random_numbers& r, double away, double width, double bump, double first) {
  const double u = r.between(-1, 1), v = r.between(-1, 1);
  corners<N> p;
  for (std::size_t k = 0; k < N; ++k) {
    const double t = (static_cast<double>(k) + 0.8 * r.unit()) * 6.283185307179586 / static_cast<double>(N);
    p[k] = {std::cos(t), width * std::sin(t), 0};
  }
  const double t = r.unit();
  if (first < 1) {
    p[1].x = p[0].x + t * (p[2].x - p[0].x);
    p[1].y = p[0].y + t * (p[2].y - p[0].y) + first;
  }
  for (point3& q : p) q = {away + q.x, away + q.y, away + u * q.x + v * q.y + bump * r.between(-1, 1)};
  return p;
}

template <std::size_t N>
std::vector<set<N>> sets() {
  struct kind {
    const char* name;
    double away, width, bump, first;
  };
  std::vector<kind> kinds{{"at the origin", 0, 1, 0, 1},
                          {"10^3 away", 1e3, 1, 0, 1},
                          {"10^6 away", 1e6, 1, 0, 1},
                          {"10^8 away", 1e8, 1, 0, 1},
                          {"10^-4 wide and 10^3 away", 1e3, 1e-4, 0, 1}};
  if (N == 3)
    kinds.push_back({"collinear to 10^-12", 0, 1, 0, 1e-12});
  else
    for (const kind& k : {kind{"first three collinear to 10^-12", 0, 1, 0, 1e-12}, {"flat to 10^-3", 1e3, 1, 1e-3, 1}})
      kinds.push_back(k);
  std::vector<set<N>> all;
  for (const kind& k : kinds) {
    bench::random_numbers r(13);
    set<N> s{k.name, {}};
    for (int i = 0; i < (bench::smoke() ? 16 : 1024); ++i)
      s.polygons.push_back(polygon<N>(r, k.away, k.width, k.bump, k.first));
    all.push_back(s);
  }
  return all;
}

// Newell's sum; for three points it is their cross product.
template <std::size_t N>
void add_true_normal(const corners<N>& p, bench::exact_results& exact) {
  std::array<real, 3> n;
  for (std::size_t i = 0; i < N; ++i) {
    const point3 &a = p[i], &b = p[(i + 1) % N];
    for (int k = 0; k < 3; ++k) {
      const int x = (k + 1) % 3, y = (k + 2) % 3;
      real& sum = n[static_cast<std::size_t>(k)];
      sum = sum + (real(a[x]) * b[y] - real(a[y]) * b[x]);
    }
  }
  const real length = sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
  for (const real& c : n) exact.push_back((c / length).result());
}

vec3 unit_normal(const std::optional<irg::plane<double>>& p) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  return p ? irg::normalized_fast(irg::normal_of(*p)) : vec3{nan, nan, nan};
}

// The minors of the points' coordinates as they are, as formula 4.4 of the course has them.
vec3 by_determinants(const point3& p, const point3& q, const point3& r) {
  const auto minor = [&](int i, int j) { return p[i] * (q[j] - r[j]) + q[i] * (r[j] - p[j]) + r[i] * (p[j] - q[j]); };
  return irg::normalized_fast(vec3{minor(1, 2), minor(2, 0), minor(0, 1)});
}

void three_points() {
  bench::study s("plane through three points", "unit normal", bench::error_unit::relative_u);
  for (const auto& one : bench::keep(sets<3>())) {
    const auto& items = one.polygons;
    const auto exact = [](const auto& p, bench::exact_results& out) { add_true_normal(p, out); };
    const bench::distribution d{one.name, items.size(), 3, bench::exact_for(items, exact)};
    std::vector<bench::implementation> who{
        bench::for_each_vector<3>("irg", items,
                                  [](const auto& p) { return unit_normal(irg::plane_through(p[0], p[1], p[2])); }),
        bench::for_each_vector<3>(
            "irg: plane_through_accurate", items,
            [](const auto& p) { return unit_normal(irg::plane_through_accurate(p[0], p[1], p[2])); }),
        bench::for_each_vector<3>("determinants in double", items,
                                  [](const auto& p) { return by_determinants(p[0], p[1], p[2]); })};
#ifdef IRG_HAVE_GLM
    who.push_back(bench::for_each_vector<3>("GLM cross and normalize", items, [](const auto& p) {
      const auto of = [](const point3& q) { return glm::dvec3(q.x, q.y, q.z); };
      return glm::normalize(glm::cross(of(p[1]) - of(p[0]), of(p[2]) - of(p[0])));
    }));
#endif
#ifdef IRG_HAVE_EIGEN
    who.push_back(bench::for_each_vector<3>("Eigen Hyperplane::Through", items, [](const auto& p) {
      const auto of = [](const point3& q) { return Eigen::Vector3d(q.x, q.y, q.z); };
      const Eigen::Vector3d n = Eigen::Hyperplane<double, 3>::Through(of(p[0]), of(p[2]), of(p[1])).normal();
      return std::array<double, 3>{n[0], n[1], n[2]};
    }));
#endif
#ifdef IRG_HAVE_CGAL
    who.push_back(bench::for_each_vector<3>("CGAL Plane_3", items, [](const auto& p) {
      using kernel = CGAL::Simple_cartesian<double>;
      const auto of = [](const point3& q) { return kernel::Point_3(q.x, q.y, q.z); };
      const kernel::Plane_3 h(of(p[0]), of(p[1]), of(p[2]));
      return irg::normalized_fast(vec3{h.a(), h.b(), h.c()});
    }));
#endif
    s.panel(d, who, bench::text_of_items(items));
  }
}

void polygons() {
  bench::study s("plane of a polygon", "unit normal of 6 corners", bench::error_unit::relative_u);
  for (const auto& one : bench::keep(sets<6>())) {
    const auto& items = one.polygons;
    const auto exact = [](const auto& p, bench::exact_results& out) { add_true_normal(p, out); };
    const bench::distribution d{one.name, items.size(), 3, bench::exact_for(items, exact)};
    s.panel(d,
            {bench::for_each_vector<3>("irg", items, [](const auto& p) { return unit_normal(irg::newell_plane(p)); }),
             bench::for_each_vector<3>("textbook", items,
                                       [](const auto& p) { return unit_normal(irg::textbook::newell_plane(p)); }),
             bench::for_each_vector<3>(
                 "first three corners", items,
                 [](const auto& p) { return unit_normal(irg::plane_through(p[0], p[1], p[2])); }, false)},
            bench::text_of_items(items));
  }
}

}  // namespace

int main(int argc, char** argv) {
  three_points();
  polygons();
  return bench::run_benchmarks(argc, argv);
}

#else
#include <cstdio>
int main() { std::puts("accuracy_plane: skipped, MPFR was not found"); }
#endif
