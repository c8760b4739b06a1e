// SPDX-License-Identifier: MIT
// A sphere less a moved one: irg, exact, and CGAL's corefinement with exact predicates and rounded constructions. The
// error is the difference of volumes; wrong are results that are not closed.
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <irg/mesh/convex_body.hpp>
#include <irg/solid/boolean.hpp>
#include <irg/solid/measures.hpp>

#include "support/measure.hpp"

#ifdef IRG_HAVE_CGAL
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/corefinement.h>
#include <CGAL/Surface_mesh.h>
#endif

namespace {

using namespace bench;
using body = irg::mesh<double>;

// An octahedron whose faces are cut into n * n triangles and blown up.
body sphere(int n, double x, double y, double z) {
  body m;
  std::map<std::array<int, 3>, std::uint32_t> known;
  const auto vertex = [&](int a, int b, int c) {
    const auto [at, is_new] = known.try_emplace({a, b, c}, static_cast<std::uint32_t>(m.positions.size()));
    const double length = std::sqrt(static_cast<double>(a * a + b * b + c * c));
    if (is_new) m.positions.push_back({x + a / length, y + b / length, z + c / length});
    return at->second;
  };
  for (int octant = 0; octant < 8; ++octant) {
    const int sx = octant & 1 ? -1 : 1, sy = octant & 2 ? -1 : 1, sz = octant & 4 ? -1 : 1;
    const auto add = [&](std::array<std::uint32_t, 3> t) {
      if (sx * sy * sz < 0) std::swap(t[1], t[2]);
      irg::add_face(m, t);
    };
    const auto at = [&](int i, int k) { return vertex(sx * i, sy * k, sz * (n - i - k)); };
    for (int i = 0; i < n; ++i)
      for (int k = 0; k < n - i; ++k) {
        add({at(i, k), at(i + 1, k), at(i, k + 1)});
        if (i + k + 1 < n) add({at(i + 1, k), at(i + 1, k + 1), at(i, k + 1)});
      }
  }
  return m;
}

struct outcome {
  double volume = 0;
  bool is_closed = false;
};

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
body from_surface(const surface& s) {
  body m;
  for (const auto v : s.vertices()) m.positions.push_back({s.point(v).x(), s.point(v).y(), s.point(v).z()});
  for (const auto f : s.faces()) {
    std::vector<std::uint32_t> corners;
    for (const auto v : s.vertices_around_face(s.halfedge(f))) corners.push_back(static_cast<std::uint32_t>(v));
    irg::add_face(m, corners);
  }
  return m;
}
#endif

void enter_case(int n) {
  auto& first = keep_lazy([n] { return sphere(n, 0, 0, 0); });
  auto& second = keep_lazy([n] { return sphere(n, 0.5, 0.3, 0.2); });
  auto& made = keep(body{});
  auto& volume = keep(0.0);
  const contest what{
      "sphere less sphere", std::to_string(8 * n * n) + " triangles", "triangle", 16 * n * n, "relative volume", ""};
  const auto judge = [&made, &volume](bool is_irg) {
    errors e;
    const double found = irg::solid_volume(made);
    if (is_irg) volume = found;
    e.max = volume == 0 ? not_said : std::abs(found - volume) / volume;
    e.wrong = irg::is_closed(made) ? 0 : 1;
    if (is_irg && e.wrong != 0) e.broken = "the result is not closed";
    return e;
  };
  contender c{"irg", [&first, &second, &made] {
                made = irg::solid_boolean(*first, *second, irg::boolean_operation::difference).value;
              }};
  c.judge = [judge] { return judge(true); };
  enter(what, std::move(c));
#ifdef IRG_HAVE_CGAL
  auto& surfaces = keep_lazy([&first, &second] { return std::pair{to_surface(*first), to_surface(*second)}; });
  auto& out = keep(surface{});
  contender peer{"CGAL", [&surfaces, &out] {
                   surface s = surfaces->first, t = surfaces->second;  // which it changes
                   out.clear();
                   CGAL::Polygon_mesh_processing::corefine_and_compute_difference(s, t, out);
                 }};
  peer.judge = [judge, &made, &out] {
    surface compact = out;
    compact.collect_garbage();
    made = from_surface(compact);
    return judge(false);
  };
  enter(what, std::move(peer));
#endif
}

}  // namespace

int main(int argc, char** argv) {
  for (const int n : {11, 36, 112})
    if (n == 11 || !smoke()) enter_case(n);
  return run_benchmarks(argc, argv);
}
