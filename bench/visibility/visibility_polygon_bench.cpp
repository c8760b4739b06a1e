// SPDX-License-Identifier: MIT
// Visibility polygons among many segments: irg, and CGAL's triangular expansion where it is installed. CGAL's
// segments must not cross, and it needs an arrangement and a triangulation, which serve for many sources: it is measured
// with them and without. Wrong are segments seen through: ways from the source to the middle of an edge that has_line_of_sight()
// finds stopped.
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include <irg/visibility/prepared_walls.hpp>
#include <irg/visibility/sight_line.hpp>
#include <irg/visibility/visibility_polygon.hpp>

#include "support/measure.hpp"
#include "../tests/support/random.hpp"

#if defined(IRG_HAVE_CGAL)
#include <CGAL/Arr_naive_point_location.h>
#include <CGAL/Arr_segment_traits_2.h>
#include <CGAL/Arrangement_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangular_expansion_visibility_2.h>
#endif

namespace {

using namespace bench;
using place = irg::point<double, 2>;
using wall = irg::segment<double, 2>;

enum class layout { apart, crossing, all_seen };

struct task {
  std::vector<wall> walls;
  irg::visible_region<double> seen;
  std::size_t vertices = 0;
};

constexpr place source{0.50013, 0.49987};
constexpr irg::box<double, 2> window{{-1, -1}, {2, 2}};

std::vector<wall> walls_of(layout how, int n) {
  test::random r(3);
  std::vector<wall> out;
  const int side = static_cast<int>(std::sqrt(n));
  for (int i = 0; i < n; ++i) {
    const double a = r.unit(), b = r.unit(), c = r.unit() - 0.5, d = r.unit() - 0.5;
    if (how == layout::crossing) {
      out.push_back({{a, b}, {a + c / 2, b + d / 2}});
    } else if (how == layout::apart) {
      const double x = (i % side + 0.5) / side, y = (i / side + 0.5) / side;
      out.push_back({{x - c * 0.9 / side, y - d * 0.9 / side}, {x + c * 0.9 / side, y + d * 0.9 / side}});
    } else {
      const double turn = 6.283185307179586 * i / n, next = turn + 5.5 / n, far_off = 0.3 + a;
      out.push_back({{source.x + far_off * std::cos(turn), source.y + far_off * std::sin(turn)},
                     {source.x + far_off * std::cos(next), source.y + far_off * std::sin(next)}});
    }
  }
  for (std::size_t i = out.size(); i > 1; --i)
    std::swap(out[i - 1], out[static_cast<std::size_t>(r.integer(0, static_cast<std::int64_t>(i) - 1))]);
  return out;
}

errors judged(const task& t) {
  errors e;
  e.wrong = 0;
  const std::size_t n = t.seen.ring.size(), step = n / 50 + 1;
  for (std::size_t i = 0; i < n; i += step) {
    const auto &v = t.seen.ring[i], &w = t.seen.ring[(i + 1) % n];
    if (v.stop == irg::sight_stop::nothing) continue;
    const place middle{(v.at.x + w.at.x) / 2, (v.at.y + w.at.y) / 2};
    const place before{middle.x + (source.x - middle.x) * 1e-6, middle.y + (source.y - middle.y) * 1e-6};
    e.wrong += !irg::has_line_of_sight(source, before, t.walls);
  }
  e.note = std::to_string(n) + " vertices";
  if (e.wrong != 0) e.broken = "an edge of the polygon is not seen";
  return e;
}

#if defined(IRG_HAVE_CGAL)
template <class Kernel>
struct cgal_task {
  using arrangement = CGAL::Arrangement_2<CGAL::Arr_segment_traits_2<Kernel>>;
  arrangement scene, seen;
  CGAL::Triangular_expansion_visibility_2<arrangement> query;
  typename arrangement::Face_const_handle face;
};

template <class Kernel>
std::unique_ptr<cgal_task<Kernel>> prepared(const task& t) {
  auto c = std::make_unique<cgal_task<Kernel>>();
  std::vector<typename Kernel::Segment_2> segments;
  const auto at = [](const place& p) { return typename Kernel::Point_2(p.x, p.y); };
  for (const wall& w : t.walls) segments.emplace_back(at(w.a), at(w.b));
  const place corners[] = {window.low, {window.high.x, window.low.y}, window.high, {window.low.x, window.high.y}};
  for (int i = 0; i < 4; ++i) segments.emplace_back(at(corners[i]), at(corners[(i + 1) % 4]));
  CGAL::insert_non_intersecting_curves(c->scene, segments.begin(), segments.end());
  for (auto f = c->scene.faces_begin(); f != c->scene.faces_end(); ++f)
    if (!f->is_unbounded()) c->face = f;
  c->query.attach(c->scene);
  return c;
}

template <class Kernel>
void ask(cgal_task<Kernel>& of) {
  of.query.compute_visibility(typename Kernel::Point_2(source.x, source.y), of.face, of.seen);
}

template <class Kernel>
void add_cgal(const contest& what, const task& t, const std::string& name, const std::string& note) {
  const auto made = std::make_shared<lazy<std::unique_ptr<cgal_task<Kernel>>>>([&t] { return prepared<Kernel>(t); });
  contender query{name + ", prepared", [made] { ask(***made); }};
  query.note = "arrangement and triangulation made before" + note;
  query.judge = [made] {
    errors e;
    e.note = std::to_string((***made).seen.number_of_vertices()) + " vertices";
    return e;
  };
  query.same_work = false;
  enter(what, std::move(query));
  enter(what, {name, [&t] { ask(*prepared<Kernel>(t)); }});
}
#endif

void enter_scene(const std::string& name, layout how, int n) {
  task& t = keep(task{walls_of(how, n), {}, 0});
  const contest what{"visibility_polygon", name + build_suffix(), "segment", n, "", ""};
  contender c{"irg", [&t] { t.seen = irg::visibility_polygon(source, window, t.walls); }};
  c.judge = [&t] { return judged(t); };
  enter(what, std::move(c));
  const auto made = std::make_shared<lazy<irg::prepared_walls<double>>>(
      [&t] { return irg::prepared_walls<double>(t.walls, window); });
  contender p{"irg:prepared", [made, &t] { t.seen = (**made).seen_from(source); }};
  p.judge = [&t] { return judged(t); };
  p.note = "tiles made before";
  p.same_work = false;
  enter(what, std::move(p));
  enter(what, {"irg:prepared, with preparation",
               [&t] { t.seen = irg::prepared_walls<double>(t.walls, window).seen_from(source); }});
#if defined(IRG_HAVE_CGAL)
  if (how == layout::crossing) return;
  add_cgal<CGAL::Exact_predicates_exact_constructions_kernel>(what, t, "CGAL triangular expansion", "");
  add_cgal<CGAL::Exact_predicates_inexact_constructions_kernel>(what, t, "CGAL triangular expansion, rounded",
                                                                "; vertices rounded, and the edges bent by them");
#endif
}

}  // namespace

int main(int argc, char** argv) {
  for (const int n : smoke() ? std::vector<int>{400} : std::vector<int>{1600, 102400}) {
    const std::string count = std::to_string(n);
    enter_scene(count + " apart", layout::apart, n);
    enter_scene(count + " crossing", layout::crossing, n);
    enter_scene(count + " all seen", layout::all_seen, n);
  }
  return run_benchmarks(argc, argv);
}
