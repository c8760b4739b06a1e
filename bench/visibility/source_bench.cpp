// SPDX-License-Identifier: MIT
// Weak visibility from a segment among walls, and guards of a plan; no peer that is installed does either. Wrong are
// plans whose parts do not make up the window.
#include <cmath>
#include <string>
#include <vector>

#include <irg/visibility/guard_cover.hpp>
#include <irg/visibility/weak_visibility.hpp>

#include "support/measure.hpp"
#include "../tests/support/random.hpp"

namespace {

using namespace bench;
using place = irg::point<double, 2>;
using wall = irg::segment<double, 2>;
using rings = std::vector<std::vector<place>>;

double area_of(const rings& list) {
  double sum = 0;
  for (const auto& r : list)
    for (std::size_t i = 0; i < r.size(); ++i) {
      const place &a = r[i], &b = r[(i + 1) % r.size()];
      sum += (a.x * b.y - a.y * b.x) / 2;
    }
  return sum;
}

struct lamp_task {
  std::vector<wall> walls;
  irg::source_regions<double> parts;
};
struct guard_task {
  rings plan;
  irg::guard_cover<double> cover;
};

void enter_lamp(int n) {
  test::random r(static_cast<std::uint64_t>(n));
  std::vector<wall> walls;
  for (int i = 0; i < n; ++i) {
    const double x = 8 * r.unit() - 4, y = 6.5 * r.unit() - 4, dx = r.unit() - 0.5, dy = r.unit() - 0.5;
    walls.push_back({{x, y}, {x + dx, y + dy}});
  }
  lamp_task& t = keep(lamp_task{walls, {}});
  contender c{"irg", [&t] { t.parts = irg::weak_visibility(wall{{-1, 4.5}, {1, 4.5}}, t.walls, {{-5, -5}, {5, 5}}); }};
  c.judge = [&t] {
    errors e;
    e.wrong = std::fabs(area_of(t.parts.all) + area_of(t.parts.some) + area_of(t.parts.none) - 100) > 1e-9;
    e.note = std::to_string(t.parts.skipped) + " of " + std::to_string(t.parts.lines) + " sight lines skipped";
    if (e.wrong != 0) e.broken = "the parts do not make up the window";
    return e;
  };
  enter({"weak_visibility", std::to_string(n) + " walls" + build_suffix(), "plan", 1, "", ""}, std::move(c));
}

void enter_guards(int n) {
  test::random r(static_cast<std::uint64_t>(n));
  rings plan(1);
  for (int i = 0; i < n; ++i) {
    const double turn = 6.283185307179586 * i / n, far_off = 1 + 4 * r.unit();
    plan[0].push_back({far_off * std::cos(turn), far_off * std::sin(turn)});
  }
  guard_task& t = keep(guard_task{plan, {}});
  contender c{"irg", [&t] { t.cover = irg::cover_by_guards(std::span<const std::vector<place>>(t.plan)); }};
  c.judge = [&t] {
    double area = 0;
    for (const auto& part : t.cover.parts) area += area_of({part.ring});
    errors e;
    e.wrong = std::fabs(area - area_of(t.plan)) > 1e-9;
    e.note = std::to_string(t.cover.guards.size()) + " guards, at least " + std::to_string(t.cover.at_least) + ", " +
             std::to_string(t.cover.parts.size()) + " parts";
    if (e.wrong != 0) e.broken = "the parts do not make up the plan";
    return e;
  };
  enter({"cover_by_guards", std::to_string(n) + " corners" + build_suffix(), "plan", 1, "", ""}, std::move(c));
}

}  // namespace

int main(int argc, char** argv) {
  for (const int n : smoke() ? std::vector<int>{5} : std::vector<int>{10, 20, 40}) enter_lamp(n);
  for (const int n : smoke() ? std::vector<int>{8} : std::vector<int>{12, 25, 50}) enter_guards(n);
  return run_benchmarks(argc, argv);
}
