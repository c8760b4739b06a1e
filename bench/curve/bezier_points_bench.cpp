// SPDX-License-Identifier: MIT
// Points of Bezier curves of degrees 3, 10, 20, 30 and 50 at equal steps: run time against error, in 2^-53 for control
// points within 1. Families: random points, (1 - 2 t)^n, which nearly vanishes in the middle, and two nearly multiple
// roots beside it.
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include <irg/curve/bezier.hpp>
#include <irg/curve/bezier_accurate.hpp>
#include <irg/curve/bezier_forward.hpp>
#include <irg/curve/bezier_prepared.hpp>
#include <irg/curve/bspline_derivative.hpp>
#include <irg/math/double_double.hpp>

#include "../tests/support/random.hpp"
#include "support/measure.hpp"

#if defined(IRG_HAVE_OCCT)
#include <Geom_BezierCurve.hxx>
#include <TColgp_Array1OfPnt.hxx>
#endif

namespace {

using point = irg::point<double, 3>;
using wide = irg::vec<irg::double_double, 3>;
constexpr std::size_t most = 64;

struct work {
  std::vector<point> points{}, found{};
  std::vector<double> places{}, numbers{}, knots{};
  std::array<point, most> room{};
  std::array<irg::exact_sum<double>, most> sums{};
};

// Control points of a coordinate that is the product of lines which are zero at these places.
std::vector<double> with_roots(const std::vector<double>& roots) {
  std::vector<double> b{1};
  for (const double root : roots) {  // times (1 - t) * -root + t * (1 - root)
    std::vector<double> next(b.size() + 1, 0);
    const double n = static_cast<double>(b.size());
    for (std::size_t i = 0; i < next.size(); ++i) {
      const double at = static_cast<double>(i) / n;
      next[i] = (i < b.size() ? (1 - at) * -root * b[i] : 0) + (i > 0 ? at * (1 - root) * b[i - 1] : 0);
    }
    b = next;
  }
  double largest = 0;
  for (const double c : b) largest = std::fmax(largest, std::fabs(c));
  for (double& c : b) c /= largest;
  return b;
}

std::vector<point> control_points(std::size_t degree, const std::string& family) {
  test::random r(17);
  std::vector<point> points(degree + 1);
  std::vector<double> roots(degree, 0.5);
  if (family == "near roots")
    for (std::size_t i = 0; i < degree; ++i) roots[i] = (i % 2 == 0 ? 0.3 : 0.7) + 0x1p-20 * static_cast<double>(i);
  const auto along = with_roots(roots);
  for (std::size_t i = 0; i <= degree; ++i) {
    if (family == "random")
      points[i] = {2 * r.unit() - 1, 2 * r.unit() - 1, 2 * r.unit() - 1};
    else
      points[i] = {along[i], along[i], along[i]};
  }
  return points;
}

void enter_case(std::size_t degree, const std::string& family) {
  const int count = bench::smoke() ? 40 : 4096;
  work made;
  made.points = control_points(degree, family);
  made.found.resize(static_cast<std::size_t>(count));
  for (int k = 0; k < count; ++k) made.places.push_back(static_cast<double>(k) / (count - 1));
  made.numbers.resize(irg::prepared_bezier<point>::numbers_for(degree + 1));
  made.knots.assign(2 * (degree + 1), 0);
  for (std::size_t i = 0; i <= degree; ++i) made.knots[degree + 1 + i] = 1;
  work& w = bench::keep(std::move(made));
  auto& truth = bench::keep_lazy([&w] {
    std::vector<wide> exact, control, room(w.points.size());
    for (const point& p : w.points)
      control.push_back({irg::double_double(p.x), irg::double_double(p.y), irg::double_double(p.z)});
    for (const double t : w.places)
      exact.push_back(irg::bezier_point(control, irg::curve_parameter<irg::double_double>(irg::double_double(t)),
                                        std::span<wide>(room)));
    return std::make_unique<std::vector<wide>>(std::move(exact));
  });
  const bench::contest what{"Bezier points",
                            "degree " + std::to_string(degree) + " " + family + bench::build_suffix(),
                            "point",
                            count,
                            "u",
                            ""};
  const auto enter = [&](const std::string& who, auto run, bool same_work = true) {
    bench::contender c{who, [&w, run] { run(w); }};
    c.same_work = same_work;
    c.judge = [&w, &truth] {
      bench::errors e;
      e.max = e.mean = e.wrong = 0;
      for (std::size_t k = 0; k < w.found.size(); ++k)
        for (int i = 0; i < 3; ++i) {
          const double off = std::fabs((irg::double_double(w.found[k][i]) - (**truth)[k][i]).high) * 0x1p53;
          e.max = std::fmax(e.max, off);
          e.mean += off / static_cast<double>(3 * w.found.size());
        }
      return e;
    };
    bench::enter(what, std::move(c));
  };
  const auto each = [](auto one) {
    return [one](work& w_) {
      for (std::size_t k = 0; k < w_.places.size(); ++k) w_.found[k] = one(w_, w_.places[k]);
    };
  };
  const auto prepared = *irg::prepare_bezier(w.points, std::span<double>(w.numbers), w.sums);
  const auto knots = *irg::make_bspline_knots(std::span<const double>(w.knots), static_cast<int>(degree));
  enter("irg", each([prepared](work&, double t) { return irg::bezier_point(prepared, t); }));
  enter("irg:batch", [prepared](work& v) { irg::bezier_points(prepared, v.places, std::span<point>(v.found)); });
  enter("irg:with the preparation", [](work& v) {
    irg::bezier_points(*irg::prepare_bezier(v.points, std::span<double>(v.numbers), v.sums), v.places,
                       std::span<point>(v.found));
  });
  enter("irg:de Casteljau",
        each([](work& v, double t) { return irg::bezier_point(v.points, t, std::span<point>(v.room)); }));
  enter("irg:Wozny and Chudy", each([](work& v, double t) { return irg::bezier_point_wozny_chudy(v.points, t); }));
  enter("irg:accurate", each([](work& v, double t) {
          return irg::bezier_point_accurate(v.points, t, std::span<irg::exact_sum<double>>(v.sums));
        }));
  enter("irg:de Boor", each([knots](work& v, double t) {
          return *irg::bspline_point_de_boor(knots, v.points, t, std::span<point>(v.room));
        }));
  enter(
      "irg:forward differences",
      [](work& v) {
        std::size_t k = 0;
        irg::bezier_forward(v.points, static_cast<int>(v.found.size()) - 1, std::span<point>(v.room),
                            [&](const point& p) { v.found[k++] = p; });
      },
      false);  // its error grows along the curve
#if defined(IRG_HAVE_OCCT)
  if (degree > 25) return;  // Open CASCADE's largest
  TColgp_Array1OfPnt poles(1, static_cast<int>(degree) + 1);
  for (std::size_t i = 0; i <= degree; ++i)
    poles.SetValue(static_cast<int>(i) + 1, gp_Pnt(w.points[i].x, w.points[i].y, w.points[i].z));
  const Handle(Geom_BezierCurve) peer = new Geom_BezierCurve(poles);
  enter("Open CASCADE", each([peer](work&, double t) {
          gp_Pnt p;
          peer->D0(t, p);
          return point{p.X(), p.Y(), p.Z()};
        }));
#endif
}

}  // namespace

int main(int argc, char** argv) {
  for (const char* const family : {"random", "(1-2t)^n", "near roots"})
    for (const std::size_t degree :
         {std::size_t{3}, std::size_t{10}, std::size_t{20}, std::size_t{30}, std::size_t{50}})
      enter_case(degree, family);
  return bench::run_benchmarks(argc, argv);
}
