// SPDX-License-Identifier: MIT
// Run time against error of planes through polygons and of the point two lines have in common, on input whose
// difficulty is set. Errors are measured in rationals of any size.
#include <irg/geometry/intersect_lines.hpp>
#include <irg/geometry/textbook/planes.hpp>
#include <irg/geometry/plane_through_points.hpp>
#include <irg/math/constants.hpp>

#include <algorithm>
#include <array>
#include <cmath>

#include "../tests/support/exact.hpp"
#include "support/measure.hpp"

#ifdef IRG_HAVE_CGAL
#define CGAL_USE_GMP 1
#define CGAL_USE_MPFR 1
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/intersections.h>
#endif

namespace bench {
namespace {

using P3 = irg::point<double, 3>;
using P2 = irg::point<double, 2>;
using pentagon = std::array<P3, 5>;
using four_points = std::array<P2, 4>;
using triple = std::array<double, 3>;

template <class Input>
struct variant {
  std::string name;
  std::function<void(const std::vector<Input>&, std::vector<triple>&)> run;
};
template <class Input, class F>
variant<Input> variant_of(const char* name, F f) {
  return {name, [f](const std::vector<Input>& in, std::vector<triple>& out) {
            for (std::size_t i = 0; i < in.size(); ++i) out[i] = f(in[i]);
          }};
}

/// `error` tells how far off an answer is, and is NaN for one that is no answer.
template <class Input, class Error>
void compare(const char* kernel, const std::string& test_case, const char* unit, std::vector<Input> made,
             const Error& error, const std::vector<variant<Input>>& variants) {
  const auto& in = keep(std::move(made));
  const contest c{kernel, test_case, "call", static_cast<std::int64_t>(in.size()), unit};
  for (const auto& v : variants) {
    auto& out = keep(std::vector<triple>(in.size()));
    contender who{v.name, [&in, &out, run = v.run] { run(in, out); }};
#ifdef IRG_HAVE_MPFR
    who.judge = [&in, &out, error] {
      errors e{0, 0, 0};
      double sum = 0, right = 0;
      for (std::size_t i = 0; i < in.size(); ++i) {
        const double off = error(in[i], out[i]);
        if (!(off < 1e300)) {
          ++e.wrong;
          continue;
        }
        e.max = std::max(e.max, off), sum += off, ++right;
      }
      e.mean = right > 0 ? sum / right : 0;
      return e;
    };
#else
    static_cast<void>(error);
#endif
    enter(c, std::move(who));
  }
}

template <class Input, class Make>
std::vector<Input> inputs(std::uint64_t seed, Make make) {
  test::random r(seed);
  std::vector<Input> in;
  for (int i = 0; i < (smoke() ? 20 : 500); ++i) in.push_back(make(r));
  return in;
}

/// Corners of a pentagon of size 1 in the plane z = u x + v y, `away` from the origin; z alone is rounded.
struct sloped {
  pentagon at{};
  double u = 0, v = 0;
};
sloped some_pentagon(test::random& r, double away, double slenderness) {
  sloped s{{}, 2 * r.unit() - 1, 2 * r.unit() - 1};
  for (std::size_t k = 0; k < 5; ++k) {
    const double angle = 2 * irg::pi<double> * (static_cast<double>(k) + r.unit() * 0.8) / 5;
    const double x = away + std::cos(angle), y = away + slenderness * std::sin(angle);
    s.at[k] = {x, y, away + (s.u * (x - away) + s.v * (y - away))};
  }
  return s;
}

/// The angle between a plane's normal and the direction (-u, -v, 1).
double angle_off(const sloped& s, const triple& n) {
#ifdef IRG_HAVE_MPFR
  using test::exact;
  for (const double c : n)
    if (!std::isfinite(c)) return c - c;
  const exact a[3] = {exact(n[0]), exact(n[1]), exact(n[2])}, b[3] = {exact(-s.u), exact(-s.v), exact(1)};
  exact across = 0, square_a = 0, square_b = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
    const exact minor = a[i] * b[j] - a[j] * b[i];
    across = across + minor * minor, square_a = square_a + a[k] * a[k], square_b = square_b + b[k] * b[k];
  }
  if (square_a.sign() == 0) return std::numeric_limits<double>::quiet_NaN();
  return std::asin(std::fmin(1.0, std::sqrt((across / (square_a * square_b)).rounded())));
#else
  return 0 * (s.u + n[0]);
#endif
}
triple normal_of(const std::optional<irg::plane<double>>& p) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  return p ? triple{p->a, p->b, p->c} : triple{none, none, none};
}

void planes() {
  struct difficulty {
    const char* name;
    double away, slenderness;
  };
  for (const difficulty& d :
       {difficulty{"at the origin", 0, 1}, {"1e6 away", 1e6, 1}, {"1e6 away and slender", 1e6, 1e-4}})
    compare<sloped>(
        "plane", d.name, "rad", inputs<sloped>(1, [&](auto& r) { return some_pentagon(r, d.away, d.slenderness); }),
        angle_off,
        {variant_of<sloped>("irg", [](const sloped& s) { return normal_of(irg::newell_plane(s.at)); }),
         variant_of<sloped>("irg:textbook",
                            [](const sloped& s) { return normal_of(irg::textbook::newell_plane(s.at)); }),
         variant_of<sloped>("irg:three_points",
                            [](const sloped& s) { return normal_of(irg::plane_through(s.at[0], s.at[1], s.at[2])); }),
         variant_of<sloped>("irg:three_points_accurate", [](const sloped& s) {
           return normal_of(irg::plane_through_accurate(s.at[0], s.at[1], s.at[2]));
         })});
}

/// Two lines, the second turned by about `angle` against the first, `away` from the origin.
four_points some_lines(test::random& r, double away, double angle) {
  const auto unit = [&] { return 2 * r.unit() - 1; };
  const double x = unit(), y = unit(), u = unit(), v = unit();
  four_points p{};
  p[0] = {away + x, away + y};
  p[1] = {away + x + u, away + y + v};
  p[2] = {away + x + unit() * angle, away + y + unit() * angle};
  p[3] = {p[2].x + u + unit() * angle, p[2].y + v + unit() * angle};
  return p;
}
double point_off(const four_points& p, const triple& at) {
#ifdef IRG_HAVE_MPFR
  using test::exact;
  exact e[4][2];
  for (std::size_t k = 0; k < 4; ++k) e[k][0] = exact(p[k].x), e[k][1] = exact(p[k].y);
  const auto turn = [&](int a, int b, int c) {
    return (e[b][0] - e[a][0]) * (e[c][1] - e[a][1]) - (e[b][1] - e[a][1]) * (e[c][0] - e[a][0]);
  };
  const exact n = turn(2, 3, 0) - turn(2, 3, 1);
  if (n.sign() == 0) return 0;
  const exact t = turn(2, 3, 0) / n;
  double worst = 0;
  for (std::size_t k = 0; k < 2; ++k) {
    const double off = test::error_in_ulp(at[k], e[0][k] + t * (e[1][k] - e[0][k]));
    worst = off == 1e9 && !std::isfinite(at[k]) ? std::numeric_limits<double>::infinity() : std::fmax(worst, off);
  }
  return worst;
#else
  return 0 * (p[0].x + at[0]);
#endif
}
triple plain_crossing(const four_points& p) {
  const double ux = p[1].x - p[0].x, uy = p[1].y - p[0].y, vx = p[3].x - p[2].x, vy = p[3].y - p[2].y;
  const double t = ((p[2].x - p[0].x) * vy - (p[2].y - p[0].y) * vx) / (ux * vy - uy * vx);
  return {p[0].x + t * ux, p[0].y + t * uy, 0};
}

void lines() {
  struct difficulty {
    const char* name;
    double away, angle;
  };
  for (const difficulty& d :
       {difficulty{"any", 0, 1}, {"1e6 away", 1e6, 1}, {"angle 1e-8", 0, 1e-8}, {"angle 1e-15", 0, 1e-15}}) {
    std::vector<variant<four_points>> variants{variant_of<four_points>("irg",
                                                                       [](const four_points& p) {
                                                                         const auto m = irg::intersect_lines(
                                                                             p[0], p[1], p[2], p[3]);
                                                                         return triple{m.at.x, m.at.y, 0};
                                                                       }),
                                               variant_of<four_points>("plain formula", plain_crossing)};
#ifdef IRG_HAVE_CGAL
    variants.push_back(variant_of<four_points>("CGAL EPICK", [](const four_points& p) {
      using kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
      const auto at = [&](std::size_t k) { return kernel::Point_2(p[k].x, p[k].y); };
      const auto common = CGAL::intersection(kernel::Line_2(at(0), at(1)), kernel::Line_2(at(2), at(3)));
      constexpr double none = std::numeric_limits<double>::quiet_NaN();
      if (common)
        if (const auto* q = boost::get<kernel::Point_2>(&*common)) return triple{q->x(), q->y(), 0};
      return triple{none, none, 0};
    }));
#endif
    compare<four_points>("line intersection", d.name, "ulp",
                         inputs<four_points>(2, [&](auto& r) { return some_lines(r, d.away, d.angle); }), point_off,
                         variants);
  }
}

}  // namespace
}  // namespace bench

int main(int argc, char** argv) {
  bench::planes();
  bench::lines();
  return bench::run_benchmarks(argc, argv);
}
