// SPDX-License-Identifier: MIT
// Points against a closed body: irg's tree, irg's plain pass over all triangles, CGAL's Side_of_triangle_mesh, and what
// people write themselves, a ray against every triangle in rounded arithmetic. Half of the points have coordinates of
// the body's own corners, where such rays go through sides and corners. Wrong are answers that are not point_in_solid's.
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include <irg/mesh/merge_positions.hpp>
#include <irg/mesh/shapes.hpp>
#include <irg/mesh/triangulate.hpp>
#include <irg/solid/solid_locator.hpp>

#include "../tests/support/random.hpp"
#include "support/measure.hpp"

#ifdef IRG_HAVE_CGAL
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Side_of_triangle_mesh.h>
#include <CGAL/Surface_mesh.h>
#endif

namespace {

using namespace bench;
using body = irg::mesh<double>;
using place = irg::point<double, 3>;

#ifdef IRG_HAVE_CGAL
using kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using surface = CGAL::Surface_mesh<kernel::Point_3>;

surface to_surface(const body& m) {
  surface s;
  std::vector<surface::Vertex_index> v;
  for (const auto& p : m.positions) v.push_back(s.add_vertex(kernel::Point_3(p.x, p.y, p.z)));
  const auto at = [&](std::size_t f, std::size_t k) { return v[m.corner(f, k).position]; };
  for (std::size_t f = 0; f < m.face_count(); ++f) s.add_face(at(f, 0), at(f, 1), at(f, 2));
  return s;
}
#endif

// Moller and Trumbore's test against the ray upward, parity of what it meets.
bool plain_is_inside(const body& m, const place& p) {
  bool inside = false;
  for (std::size_t f = 0; f < m.face_count(); ++f) {
    const auto at = [&](std::size_t k) { return m.positions[m.corner(f, k).position]; };
    const auto a = at(0), u = irg::point<double, 3>{at(1).x - a.x, at(1).y - a.y, at(1).z - a.z},
               v = irg::point<double, 3>{at(2).x - a.x, at(2).y - a.y, at(2).z - a.z};
    const double determinant = u.x * v.y - u.y * v.x;
    if (determinant == 0) continue;
    const double x = p.x - a.x, y = p.y - a.y;
    const double s = (x * v.y - y * v.x) / determinant, t = (u.x * y - u.y * x) / determinant;
    if (s >= 0 && t >= 0 && s + t <= 1 && a.z + s * u.z + t * v.z > p.z) inside = !inside;
  }
  return inside;
}

void enter_case(const std::string& name, const body& shape) {
  const int count = smoke() ? 16 : 2048;
  auto& triangles = keep(irg::triangulated(shape));
  auto& points = keep(std::vector<place>{});
  test::random random(9);
  const auto corner = [&] {
    return triangles.positions[static_cast<std::size_t>(
        random.integer(0, static_cast<std::int64_t>(triangles.positions.size()) - 1))];
  };
  for (int i = 0; i < count; ++i) {
    const place a = corner(), b = corner(), c = corner();
    points.push_back(i % 2 ? place{a.x, b.y, c.z} : place{a.x * 0.9, (a.y + b.y) * 0.5, c.z});
    if (i % 4 == 1) points.back() = {a.x, a.y, c.z};  // under or over a corner
  }
  auto& truth = keep_lazy([&triangles, &points] {
    auto all = std::make_unique<std::vector<bool>>();
    for (const place& p : points) all->push_back(irg::point_in_solid(triangles, p) == irg::location::inside);
    return all;
  });
  auto& found = keep(std::vector<bool>(static_cast<std::size_t>(count)));
  const contest what{"point in solid", name + build_suffix(), "point", count, "", ""};
  const auto add = [&](const std::string& who, const auto& is_inside) {
    contender c{who, [&points, &found, is_inside] {
                  for (std::size_t i = 0; i < points.size(); ++i) found[i] = is_inside(points[i]);
                }};
    c.judge = [&found, &truth, &points, who] {
      errors e;
      e.wrong = 0;
      for (std::size_t i = 0; i < points.size(); ++i) e.wrong += found[i] != (**truth)[i];
      if (e.wrong != 0 && who.starts_with("irg")) e.broken = "an answer is not point_in_solid's";
      return e;
    };
    enter(what, std::move(c));
  };
  const auto& tree = keep(irg::solid_locator(triangles));
  add("irg", [&tree](const place& p) { return tree(p) == irg::location::inside; });
  add("irg:all triangles",
      [&triangles](const place& p) { return irg::point_in_solid(triangles, p) == irg::location::inside; });
#ifdef IRG_HAVE_CGAL
  auto& mesh = keep(to_surface(irg::with_merged_positions(triangles)));
  const auto& side = keep(CGAL::Side_of_triangle_mesh<surface, kernel>(mesh));
  add("CGAL", [&side](const place& p) { return side(kernel::Point_3(p.x, p.y, p.z)) == CGAL::ON_BOUNDED_SIDE; });
#endif
  add("plain ray", [&triangles](const place& p) { return plain_is_inside(triangles, p); });
}

}  // namespace

int main(int argc, char** argv) {
  enter_case("torus 2304", irg::shape_torus<double>({.major_segments = 48, .minor_segments = 24}));
  enter_case("sphere 16128", irg::shape_sphere<double>({.slices = 128, .stacks = 64}));
  return run_benchmarks(argc, argv);
}
